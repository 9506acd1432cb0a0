#include <gtest/gtest.h>
#include <graze/distance.hpp>
#include <graze/overlap.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

template <class S>
class DistanceQuery : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(DistanceQuery, Scalars);

TYPED_TEST(DistanceQuery, SpheresAndBoxesByTheirClosedForms) {
  using S = TypeParam;
  Draw draw{61};
  int apart = 0, together = 0;
  for (int round = 0; round < 500; ++round) {
    const Vec3<S> half = draw.vector<S>(1).cwiseAbs();
    const Body<S> box{.shape = Box<S>{half}, .position = draw.vector<S>(round % 2 ? 2 : 0.2)};
    const Body<S> ball{.shape = Sphere<S>{S(draw.between(0.1, 0.5))},
                       .position = draw.vector<S>(round % 2 ? 3 : 1)};
    const Vec3<double> p = ball.position.template cast<double>() - box.position.template cast<double>();
    const Vec3<double> nearest =
        p.cwiseMin(half.template cast<double>()).cwiseMax(-half.template cast<double>());
    const double expected = (p - nearest).norm() - double(std::get<Sphere<S>>(ball.shape).radius);
    const double slack = 64 * double(kUnitRoundoff<S>) * 6;
    if (std::abs(expected) < slack) continue;
    const DistanceResult<S> d = distance(box, ball);
    EXPECT_FALSE(d.stalled);
    if (expected < 0) {
      ++together;
      EXPECT_EQ(d.upper, 0) << round;
    } else {
      ++apart;
      EXPECT_NEAR(d.lower, expected, slack) << round;
      EXPECT_NEAR(d.upper, expected, slack) << round;
      EXPECT_NEAR((d.point_b - d.point_a).norm(), expected, 2 * slack) << round;
      EXPECT_NEAR(d.normal.dot(d.point_b - d.point_a), expected, 2 * slack) << round;
      EXPECT_NEAR((d.point_b - ball.position).norm(), std::get<Sphere<S>>(ball.shape).radius, slack) << round;
      EXPECT_LT((d.point_a.template cast<double>() - nearest - box.position.template cast<double>()).norm(),
                1e-2);
    }
    const Outcome outcome = expected < 0 ? Outcome::initially_overlapping : Outcome::miss;
    EXPECT_EQ(overlap_gjk(box, ball).outcome, outcome) << round;
    EXPECT_EQ(overlap_mpr(box, ball).outcome, outcome) << round;
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(together, 30);
}

TYPED_TEST(DistanceQuery, SwappedBodiesSwapTheAnswer) {
  using S = TypeParam;
  Draw draw{62};
  for (int round = 0; round < 200; ++round) {
    Body<S> a{.shape = draw.hull<S>(12, 1)}, b{.shape = draw.hull<S>(9, 1), .position = draw.vector<S>(3)};
    b.orientation = draw.turn<S>();
    const DistanceResult<S> ab = distance(a, b), ba = distance(b, a);
    const double slack = 64 * double(kUnitRoundoff<S>) * 6;
    EXPECT_NEAR(ab.upper, ba.upper, slack) << round;
    if (ab.lower < 0.1) continue;
    EXPECT_LT((ab.normal + ba.normal).norm(), 1e-2) << round;
    EXPECT_NEAR((ab.point_a - ab.point_b).norm(), ab.upper, slack);
  }
}

// The middle of a hull's bounds may lie outside it, and the line from there through the origin then enters C
// beyond the origin.
TYPED_TEST(DistanceQuery, PointBesideATetrahedronIsOutside) {
  using S = TypeParam;
  const Body<S> tetrahedron{.shape = Hull<S>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const S x : {S(0.34), S(0.4), S(0.45), S(0.5), S(0.75)}) {
    const Body<S> point{.position = {x, x, x}};
    EXPECT_EQ(overlap_mpr(tetrahedron, point).outcome, Outcome::miss) << x;
    EXPECT_EQ(overlap_mpr(point, tetrahedron).outcome, Outcome::miss) << x;
    EXPECT_EQ(overlap_gjk(tetrahedron, point).outcome, Outcome::miss) << x;
  }
  const Body<S> inside{.position = {S(0.33), S(0.33), S(0.33)}};
  EXPECT_EQ(overlap_mpr(tetrahedron, inside).outcome, Outcome::initially_overlapping);
}

// The foot on an edge or a face is as near to a corner or an edge as rounding resolves. |v| then decides
// nothing, so the axis must (reports fcl 408 and 493, parry's ray fuzzer, translated into distances).
TYPED_TEST(DistanceQuery, FootBesideACornerKeepsItsAxis) {
  using S = TypeParam;
  const S beside = std::sqrt(kUnitRoundoff<S>) / 4;
  const Body<S> square{.shape = Hull<S>{{2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}}};
  const Body<S> box{.shape = Box<S>{{1, 1, 1}}};
  for (const S off : {S(0), beside, 2 * beside, 8 * beside}) {
    const Body<S> point{.position = {3, 2 - off, 0}};
    const DistanceResult<S> flat = distance(square, point);
    EXPECT_FALSE(flat.stalled) << off;
    EXPECT_NEAR(flat.lower, S(1), 64 * kUnitRoundoff<S> * 2) << off;
    EXPECT_LE(flat.lower, flat.upper);
    const Body<S> over{.position = {1 - off, 1 - 2 * off, S(3.5)}};
    const DistanceResult<S> face = distance(box, over);
    EXPECT_FALSE(face.stalled) << off;
    EXPECT_NEAR(face.lower, S(2.5), 64 * kUnitRoundoff<S> * 4) << off;
    EXPECT_LE(face.lower, face.upper);
  }
}

// A vertex far out hides a nearer one: along the axis that GJK has they tie, and what turns the axis is less
// than |v| shows.
TYPED_TEST(DistanceQuery, AFarVertexDoesNotHideANearerOne) {
  using S = TypeParam;
  const S far = sizeof(S) == 8 ? S(0x1.8p27) : S(0x1.8p13);
  const Body<S> a{.shape = Segment<S>{{0, far, 0}, {0, 0, 0}}}, b{.shape = Segment<S>{{0, 0, 1}, {1, 0, 0}}};
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const DistanceResult<S> d = distance(*one, *other);
    EXPECT_FALSE(d.stalled);
    // 64 u of the scale.
    EXPECT_NEAR(d.lower, std::sqrt(S(0.5)), 64 * kUnitRoundoff<S> * far);
    EXPECT_NEAR(d.upper, std::sqrt(S(0.5)), 64 * kUnitRoundoff<S> * far);
    EXPECT_NEAR((d.point_a - d.point_b).norm(), std::sqrt(S(0.5)), 64 * kUnitRoundoff<S> * far);
  }
}

// Prisms of six corners about z whose ends are level and whose edges lean by about the root of u.
//
// Report: 205 of 24,000 distances of such prisms did not converge, with an upper end and witnesses up to 2e7
// u scale off. Mechanism: the foot was on a vertex. The next support point, the other end of its leaning
// edge, brought v nearer by less than u |v| (refine_axis.hpp), and the search ended. The axis that this edge
// rotates by the root of u finds the vertex that is nearer by the root of u. Threshold: 64 u scale, as
// guaranteed.
TYPED_TEST(DistanceQuery, EdgesThatHardlyLeanHideNoNearerOne) {
  using S = TypeParam;
  Draw draw{63};
  const double root = std::sqrt(double(kUnitRoundoff<S>));
  const auto prism = [&](double lean) {
    std::vector<Vec3<S>> corners;
    for (int i = 0; i < 3; ++i) {
      const double x = draw.between(-1, 1), y = draw.between(-1, 1);
      corners.emplace_back(S(x), S(y), S(-0.5));
      corners.emplace_back(S(x + draw.between(-lean, lean)), S(y + draw.between(-lean, lean)), S(0.5));
    }
    return Hull<S>(std::span<const Vec3<S>>(corners));
  };
  int apart = 0, stalled = 0;
  for (int round = 0; round < 20000; ++round) {
    const double lean = root * std::exp(draw.between(-3, 3));
    const Body<S> a{.shape = prism(lean)},
        b{.shape = prism(lean), .position = {S(draw.between(-3, 3)), S(draw.between(-3, 3)), 0}};
    const DistanceResult<S> d = distance(a, b);
    stalled += d.stalled;
    if (!(d.lower > 0)) continue;
    ++apart;
    const S slack = 64 * kUnitRoundoff<S> * 5;  // boxes' centres at most 5 apart
    EXPECT_LE(d.upper - d.lower, slack) << round;
    EXPECT_NEAR((d.point_b - d.point_a).norm(), d.upper, slack) << round;
  }
  EXPECT_EQ(stalled, 0);
  EXPECT_GT(apart, 12000);
}

TEST(DistanceDoor, BadInputIsRefused) {
  EXPECT_EQ(distance<double>({.shape = Sphere<double>{-1}}, {}).invalid, Invalid::negative_extent);
  EXPECT_EQ(overlap_mpr<double>({.shape = Hull<double>()}, {}).invalid, Invalid::empty_hull);
  EXPECT_EQ(overlap_gjk<double>({.shape = Hull<double>()}, {}).outcome, Outcome::invalid_input);
}

}  // namespace
}  // namespace graze
