// Bounds of rounding are bounds: of where the parts of shapes are, of how fast bodies turn, of points that
// are named and volumes that are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <graze/detail/proving/surround.hpp>
#include <graze/detail/rotating/moving_pair.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;
using V = Vec3<double>;

constexpr double kU = kUnitRoundoff<double>;

// A part that rotates with its parent is known no better than its place.
TEST(RoundingBounds, APartIsAsUncertainAsItsPlace) {
  const Shape<double> part = Box<double>{{0.5, 0.25, 0.125}};
  const auto point = [&](const V& place, const Quaternion<double>& turn) {
    const Shape<double> put = translated<double>(part, place);
    return detail::tree_rounding<double>(posed<double>(put, V(0, 0, 0), turn), detail::Turning::quick).point;
  };
  const Quaternion<double> none{1, 0, 0, 0}, turn{1, 2, 3, 4};
  EXPECT_EQ(point(V(8, -4, 2), none), point(V::Zero(), none));
  // At least 9 u of a rotated vector (tree.hpp), for a place of size 9.
  EXPECT_GE(point(V(8, -4, 2), turn), point(V::Zero(), turn) + 9);
}

// The bounds of a combinator far out in its own frame are about its middle, and as wide as it is.
TEST(RoundingBounds, ACombinatorFarOutHasItsOwnExtent) {
  const Shape<double> far =
      sum<double>(Box<double>{{1, 0.5, 0.25}}, translated<double>(Point<double>{}, V(64, 32, -16)));
  const detail::Bounds bounds = detail::bounds(far);
  EXPECT_EQ(bounds.half, V(1, 0.5, 0.25));
  EXPECT_EQ(bounds.center + bounds.middle, V(64, 32, -16));
}

// Per component 4 u M + kTurn u (|a| + |b|) + point_error (cso.hpp), and nothing for a rotation that permutes axes.
TEST(RoundingBounds, ATurnCountsForTheErrorOfPoints) {
  const auto error = [](const Quaternion<double>& q) {
    const Body<double> a{.shape = Box<double>{{1, 0.5, 0.25}}, .orientation = q};
    const Body<double> b{.shape = Point<double>{}, .position = {3, 0, 0}};
    return detail::Cso<double>(a, b).point_error();
  };
  const double plain = error({1, 0, 0, 0});
  EXPECT_EQ(error({1, 1, 0, 0}), plain);
  // |a| is 1.15 / 2 internal units at least.
  EXPECT_GE(error({1, 2, 3, 4}), plain + detail::kFastTurn * kU * 0.5);
}

// Points that cancel all but 2^-80 of where they were put are no better than sums of two doubles: 2^-98 of a
// turned centre (offset.hpp), and of the places inside of a combinator.
TEST(RoundingBounds, WhatCancelsIsNoBetterThanSumsOfTwoDoubles) {
  const V far(0x1p80, 0, 0);
  const Body<double> origin{.shape = Point<double>{}, .position = {1, 0, 0}};
  const auto error = [&](const Shape<double>& shape, const V& place, const Quaternion<double>& turn) {
    const detail::Cso<double> cso({.shape = shape, .position = place, .orientation = turn}, origin, 0.0,
                                  detail::Turning::accurate);
    return cso.to_length(cso.point_error());
  };
  const Quaternion<double> half_turn{0, 0, 0, 1};
  EXPECT_GE(error(Segment<double>{far, far}, far, half_turn), 0x1p-98 * far.norm());
  const Shape<double> there = translated<double>(Point<double>{}, far);
  const Shape<double> back = posed<double>(there, far, half_turn);
  EXPECT_GE(error(back, V::Zero(), {1, 0, 0, 0}), 0x1p-98 * far.norm());
  // Terms that do not cancel add their own rounding, and no more.
  EXPECT_LE(error(Box<double>{{1, 1, 1}}, V(4, 0, 0), {1, 2, 3, 4}), 0x1p-45);
}

TEST(RoundingBounds, ARateOfTurningIsNotBelowTheTrueOne) {
  Draw draw{211};
  for (int round = 0; round < 200; ++round) {
    const RotatingBody<double> body{.body = {.shape = Box<double>{{1, 1, 1}}},
                                    .rotation = draw.vector<double>(3)};
    const auto moving =
        detail::mobility(body, V::Zero(), detail::bounds(body.body.shape), 1.0,
                         detail::accurate_rotation_matrix(detail::as_double(body.body.orientation)));
    long double square = 0;  // of |w|, within 2^-63 of itself
    for (int i = 0; i < 3; ++i) square += static_cast<long double>(body.rotation[i]) * body.rotation[i];
    EXPECT_GE(static_cast<long double>(moving.rate) * moving.rate, square) << round;
  }
}

// A rotates about z, B is a point at rest: seen from A it runs a circle of radius c, and bends by w^2 c.
TEST(RoundingBounds, ABendInATurningFrameCountsTheWayToTheOther) {
  const RotatingBody<double> a{.body = {.shape = Box<double>{{1, 1, 1}}}, .rotation = {0, 0, 2}};
  const RotatingBody<double> b{.body = {.shape = Point<double>{}, .position = {3, 0, 0}}};
  const detail::MovingPair pair(a, b, 0.0);
  const double c = 3 * power_of_two(-pair.cso().length_exponent());
  EXPECT_GE(pair.bend(AxisFrame::a, V(1, 0, 0), 1.0), 4 * c);
  EXPECT_LE(pair.bend(AxisFrame::a, V(1, 0, 0), 1.0), 4 * c * (1 + 1e-12));
}

// The same with B flying by at v, and A rotating: the distance grows by v t, and 2 w v is Coriolis'.
TEST(RoundingBounds, ABendInATurningFrameCountsTheFlight) {
  const RotatingBody<double> a{.body = {.shape = Box<double>{{1, 1, 1}}}, .rotation = {0, 0, 2}};
  const RotatingBody<double> b{
      .body = {.shape = Point<double>{}, .position = {3, 0, 0}, .displacement = {1, 0, 0}}};
  const detail::MovingPair pair(a, b, 0.0);
  const double unit = power_of_two(-pair.cso().length_exponent());
  // x'' of a point at distance 3 + t along x in A's axes: (-4 (3 + t), -4) at t = 0 turned by nothing.
  EXPECT_GE(pair.bend(AxisFrame::a, V(1, 0, 0), 1.0), 4 * (3 + 1) * unit);
  EXPECT_GE(pair.bend(AxisFrame::a, V(0, 1, 0), 1.0), 4 * unit);
}

// --- points with a name

// Points of C = A - B, as tier certified names them.
struct Named {
  Named(Body<double> of_a, Body<double> of_b) : a(std::move(of_a)), b(std::move(of_b)) {}

  Body<double> a, b;
  detail::Cso<double> cso{a, b, 0.0, detail::Turning::accurate};
  detail::ProofContext<double> context = detail::proof_context(a, b, cso, 1.0, 0.0);
  Counters counters;
  detail::NamedPoints<double> points{context, counters};
};

TEST(RoundingBounds, ASumHasTheNodesOfItsParts) {
  const Shape<double> box = Box<double>{{1, 1, 1}};
  EXPECT_EQ(detail::nodes_of<double>(box), 1);
  EXPECT_EQ(detail::nodes_of<double>(sum<double>(box, box)), 3);
  EXPECT_EQ(detail::nodes_of<double>(sum<double>(box, translated<double>(box, V(1, 0, 0)))), 4);
}

// Points of a combinator round more often than those of a sphere.
TEST(RoundingBounds, PointsOfACombinatorAreDrawnInFarther) {
  const Body<double> plain{.shape = Sphere<double>{1}};
  const Body<double> tree{.shape = rounded<double>(sum<double>(Box<double>{{1, 1, 1}}, Point<double>{}), 1)};
  // A unit vector within 4 u, and one product. For a combinator, two sums besides, of the radius and the
  // excess.
  EXPECT_GE(detail::inside_slack(plain), 5 * kU);
  EXPECT_GE(detail::inside_slack(tree), detail::inside_slack(plain) + 2 * kU);
}

// The exact meaning of a name is the point that sums of two doubles made, for any rotation inside the shape.
TEST(RoundingBounds, ANamedPointIsWhereItsNameSays) {
  Draw draw{212};
  for (int round = 0; round < 100; ++round) {
    const Shape<double> part =
        posed<double>(Box<double>{{0.5, 0.25, 0.125}}, draw.vector<double>(1), draw.turn<double>());
    Named named{{.shape = sum<double>(part, Segment<double>{{0, 0, 0}, {1, 0.5, 0}}),
                 .orientation = draw.turn<double>()},
                {.shape = draw.hull<double>(8, 1), .position = draw.vector<double>(4)}};
    const detail::NamedPoint p = named.points.along(unit(draw.vector<double>(1)));
    ASSERT_TRUE(p.named);
    const detail::exact::Dyadic3 w = named.points.exactly(p);
    int order = -10000;
    for (const detail::exact::Dyadic& x : w) {
      ASSERT_TRUE(x.valid());
      if (x.sign() != 0) order = std::max(order, x.order());
    }
    V exactly = V::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      exactly[static_cast<int>(i)] = w[i].sign() == 0 ? 0 : std::ldexp(w[i].leading(), w[i].order() - order);
    // `exactly` is w times a positive weight: the same direction, rounded a few times.
    EXPECT_LE((unit(exactly) - unit(detail::rounded_once(p.w))).norm(), 8 * kU) << round;
  }
}

// A name belongs to the point that was found, even along a direction in which two points of a part tie: the
// rims of a cylinder seen from its side, the apex of a cone and its rim.
TEST(RoundingBounds, ANameIsOfThePointThatWasFound) {
  const Shape<double> cylinder = Cylinder<double>{1, 2}, cone = Cone<double>{3, 2};
  const V from_side(0.6, 0.8, 0), over_slant = V(0.36, 0.48, 0.45) / 0.75;
  const auto at = [](const V& place, const Quaternion<double>& turn, const V& x) -> V {
    return place + detail::rotation_matrix(turn) * x;
  };
  Draw draw{213};
  for (int round = 0; round < 2000; ++round) {
    const bool lone = round % 2 == 0, is_cone = round % 4 < 2;
    const Quaternion<double> turn = draw.turn<double>(), inner = draw.turn<double>();
    const V place = draw.vector<double>(4), within = draw.vector<double>(4);
    const Shape<double> part = is_cone ? cone : cylinder;
    const Body<double> a{
        .shape = lone ? part : posed<double>(part, within, inner), .position = place, .orientation = turn};
    const Named named{a, {.shape = Point<double>{}}};
    const V own = is_cone ? over_slant : from_side;
    const V n = at(V::Zero(), turn, lone ? own : at(V::Zero(), inner, own));
    SupportPair pair;
    const detail::CsoPoint<double> found = named.cso.rounded_support(unit(n));
    ASSERT_TRUE(detail::name_pair(named.context, found, pair));
    const V x = pair.a.curved[0], said = at(place, turn, lone ? x : at(within, inner, x));
    EXPECT_LE((said - named.cso.to_length(1) * found.w).norm(), 1e-12) << round;
  }
}

// --- four points around the origin

// A tetrahedron around the origin, one volume of which is what is asked for.
class Surrounded : public testing::Test {
 protected:
  bool surrounds(const std::array<V, 4>& w) {
    Named named{{.shape = Box<double>{{1, 1, 1}}}, {.shape = Box<double>{{1, 1, 1}}, .position = {1, 0, 0}}};
    std::array<detail::NamedPoint, 4> p;
    std::array<const detail::NamedPoint*, 4> four;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k) p[i].w[k] = {w[i][static_cast<int>(k)], 0};
      p[i].named = false;  // no exact sign is to be had
      four[i] = &p[i];
    }
    return detail::surrounds(named.points, four, false);
  }
};

TEST_F(Surrounded, PointsWithoutANameSurroundBeyondDoubtOrNot) {
  const std::array<V, 4> around = {V(1, 1, 1), V(1, -1, -1), V(-1, 1, -1), V(-1, -1, 1)};
  EXPECT_TRUE(surrounds(around));
  // The origin in the plane of three of them: of points without a name nothing more is known.
  for (std::size_t apex = 0; apex < 4; ++apex) {
    std::array<V, 4> w;
    w[apex] = V(0, 0, 1);
    w[(apex + 1) % 4] = V(1, 0, 0);
    w[(apex + 2) % 4] = V(-1, 1, 0);
    w[(apex + 3) % 4] = V(-1, -1, 0);
    EXPECT_FALSE(surrounds(w)) << apex;
  }
}

// Volumes of points of size m are rounded by 2^-94 m^3 and more, so what is below that has no sign.
TEST_F(Surrounded, AVolumeBelowItsRoundingHasNoSign) {
  const double m = 0x1p40, little = 0x1p-60;
  // The volume of the first three is m^2 little = 2^20, of the others m^3: 2^26 may be rounding.
  const std::array<V, 4> w = {V(m, 0, -little), V(-m, m, -little), V(-m, -m, -little), V(0, 0, m)};
  EXPECT_FALSE(surrounds(w));
  const std::array<V, 4> sure = {V(m, 0, -1), V(-m, m, -1), V(-m, -m, -1), V(0, 0, m)};
  EXPECT_TRUE(surrounds(sure));
}

// --- points around a line

// A point on the top of a box, moving along it: all of C is on one side of the path, whichever corners are
// given first, and however far out.
TEST(RoundingBounds, CornersOnOneSideDoNotSurroundALine) {
  const Named named{{.shape = Box<double>{{1, 1, 1}}}, {.shape = Point<double>{}, .position = {0, 0, 1}}};
  const detail::TwoDoubles3 r = {detail::TwoDoubles{1, 0}, detail::TwoDoubles{0, 0},
                                 detail::TwoDoubles{0, 0}};
  const detail::ProvedView<double> view(named.points, r, V(0, 0, 0), V(1, 0, 0));
  const auto surrounded = [&](const std::array<double, 6>& angles) {
    std::array<detail::ProvedPortal, 2> portal;
    for (std::size_t i = 0; i < 6; ++i) {
      detail::ProvedPoint& p = portal[i / 3].p[i % 3];
      p.x = {std::cos(angles[i]), 0};
      p.y = {std::sin(angles[i]), 0};
    }
    return view.is_surrounded(portal[0], portal[1]);
  };
  // Between 3.2 and 6.2 the sine is below zero.
  std::array<double, 6> below = {6.2, 3.2, 3.8, 4.4, 5.0, 5.6}, around = {6.2, 1.2, 2.2, 3.2, 4.2, 5.2};
  for (std::size_t turn = 0; turn < 6; ++turn) {
    EXPECT_FALSE(surrounded(below)) << turn;
    EXPECT_TRUE(surrounded(around)) << turn;
    std::rotate(below.begin(), below.begin() + 1, below.end());
    std::rotate(around.begin(), around.begin() + 1, around.end());
  }
}

}  // namespace
}  // namespace graze
