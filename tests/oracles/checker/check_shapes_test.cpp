// The checker of proofs on every kind of shape, against the references of shape_reference.hpp: true proofs
// are accepted, and proofs that are false by one unit in the last place are refused under the name of the
// false claim.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "oracles/checker/check_proof.hpp"
#include "tests/oracles/arithmetic/environments.hpp"
#include "tests/oracles/checker/shape_cases.hpp"

namespace graze::test {
namespace {

using corpus::Case;
using oracle::check_proof;
using oracle::CheckCost;
using oracle::Refusal;

constexpr double kInf = kInfinity<double>;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double up(double x, int units = 1) {
  for (; units > 0; --units) x = std::nextafter(x, kInf);
  return x;
}
double down(double x, int units = 1) {
  for (; units > 0; --units) x = std::nextafter(x, -kInf);
  return x;
}

Proof lower_proof(double toi, const Vec3<double>& axis) {
  Proof proof;
  proof.toi_lower = toi;
  proof.has_axis = true;
  proof.axis = axis;
  return proof;
}
Proof upper_proof(double toi, const Feature& a, const Feature& b) {
  Proof proof;
  proof.toi_upper = toi;
  proof.portal_size = 1;
  proof.portal[0] = {a, b};
  return proof;
}

Refusal judge(const Case& c, const Proof& proof, CheckCost* cost = nullptr) {
  return check_proof(c, proof, cost).refusal;
}

std::string stages(const CheckCost& cost) {
  return "double " + std::to_string(cost.double_decisions) + ", extended " +
         std::to_string(cost.extended_decisions) + ", balls " + std::to_string(cost.ball_decisions) +
         ", exact " + std::to_string(cost.exact_decisions);
}
void report(const char* what, const char* kind, const CheckCost& cost, long long refused,
            long long accepted) {
  std::cout << "[  counts  ] " << what << ", " << kind << ": refused " << refused << ", accepted " << accepted
            << "; settled in " << stages(cost) << "\n";
}

// B of any kind on its way to A of the kind asked for.
Case draw_case(Draw& draw, Kind kind, Pose pose) {
  const auto numbers = static_cast<Numbers>(draw.random.below(3));
  Shape<double> a = draw_kind(draw, kind, numbers, pose);
  Shape<double> b = draw_kind(draw, static_cast<Kind>(draw.random.below(kKinds)), numbers, pose);
  const bool swapped = draw.random.once_in(2);
  Case c = swapped ? approaching(draw, numbers, pose, std::move(b), std::move(a))
                   : approaching(draw, numbers, pose, std::move(a), std::move(b));
  if (draw.random.once_in(4)) c.target_distance = draw.random.uniform(0, 1);
  return c;
}
// Along the line of centres or near it, with small integers now and then, for ties.
Vec3<double> draw_axis(Draw& draw, const Case& c) {
  const Vec3<double> between = c.b.position - c.a.position;
  if (draw.random.once_in(4)) return Vec3<double>((between * (4 / between.norm())).array().rint());
  return between + draw.vector(Numbers::doubles, draw.random.once_in(2) ? 1 : 4);
}

constexpr Pose kPoses[] = {Pose::identity, Pose::quarter_turns, Pose::rotated};

// ---- axes -------------------------------------------------------------------------------------------------

TEST(CheckShapesLower, TightestDoubleAcceptedAndOneToFourUnitsBeyondRefused) {
  long long all_refused = 0;
  for (int kind = 0; kind < kKinds; ++kind) {
    CheckCost cost;
    long long refused = 0, accepted = 0;
    Draw draw(100 + static_cast<std::uint64_t>(kind));
    for (int i = 0; i < 330; ++i) {
      const Case c = draw_case(draw, static_cast<Kind>(kind), kPoses[i % 3]);
      const Vec3<double> axis = draw_axis(draw, c);
      const HighAxis truth(c, axis);
      const auto tight = truth.tightest();
      if (!tight) {
        const Refusal expected =
            truth.approach < 0 ? Refusal::lower_not_proved : Refusal::axis_not_approaching;
        ASSERT_EQ(judge(c, lower_proof(1e-200, axis), &cost),
                  axis.isZero(0) ? Refusal::axis_missing : expected)
            << kKindNames[kind] << ", case " << i;
        continue;
      }
      ++accepted;
      ASSERT_EQ(judge(c, lower_proof(*tight, axis), &cost), Refusal::none)
          << kKindNames[kind] << ", case " << i;
      for (int units = 1; units <= 4; ++units) {
        const oracle::Verdict verdict = check_proof(c, lower_proof(up(*tight, units), axis), &cost);
        ASSERT_EQ(verdict.refusal, Refusal::lower_not_proved)
            << kKindNames[kind] << ", case " << i << ", " << units << " units";
        ASSERT_FALSE(verdict.detail.empty());
        ++refused;
      }
    }
    report("lower bounds", kKindNames[kind], cost, refused, accepted);
    EXPECT_GT(accepted, 100) << kKindNames[kind];
    EXPECT_GT(cost.double_decisions, 0) << kKindNames[kind];
    EXPECT_GT(cost.ball_decisions, 0) << kKindNames[kind];
    all_refused += refused;
  }
  EXPECT_GE(all_refused, 10000);
}

TEST(CheckShapesMiss, ClaimsAtAndAroundTheLastHorizonAgreeWithTheReference) {
  for (int kind = 0; kind < kKinds; ++kind) {
    CheckCost cost;
    long long refused = 0, accepted = 0;
    Draw draw(200 + static_cast<std::uint64_t>(kind));
    for (int i = 0; i < 200; ++i) {
      Case c = draw_case(draw, static_cast<Kind>(kind), kPoses[i % 3]);
      if (draw.random.once_in(3)) c.b.displacement = c.a.displacement + draw.vector(Numbers::doubles, 8);
      if (draw.random.once_in(10)) c.b.displacement = c.a.displacement;
      const Vec3<double> axis = draw_axis(draw, c);
      if (axis.isZero(0)) continue;
      const HighAxis truth(c, axis);
      const auto tight = truth.tightest();
      const double t = tight.value_or(1);
      for (const double horizon : {down(t), t, up(t), c.t_max}) {
        c.t_max = horizon;
        const bool holds = truth.miss_holds(horizon);
        ASSERT_EQ(judge(c, lower_proof(kInf, axis), &cost), holds ? Refusal::none : Refusal::miss_not_proved)
            << kKindNames[kind] << ", case " << i << ", T = " << horizon;
        ++(holds ? accepted : refused);
      }
    }
    report("misses", kKindNames[kind], cost, refused, accepted);
    EXPECT_GT(accepted, 100) << kKindNames[kind];
    EXPECT_GT(refused, 100) << kKindNames[kind];
  }
}

// A cylinder and a cone rotated by integers. Along the cylinder's axis n = M (0, 0, 1), |n| = |q|^2 = 30,
// every root is a whole number, and h(n) = t n.v is met exactly.
TEST(CheckShapesLower, TiesBehindARotationAreEqualities) {
  Case c;
  const Quaternion<double> q{1, 2, 3, 4};
  const Vec3<double> n{22, 20, 4};  // 2 (xz + wy), 2 (yz - wx), ww - xx - yy + zz
  c.b.position = 2 * n;
  c.b.displacement = -n;
  c.t_max = kInf;
  c.b.shape = Point<double>{};
  c.a.orientation = q;
  const double gap = 1800 - 900;  // 2 n.n - what h has, over n.n = 900, is a t of 1
  for (const Shape<double>& shape : std::initializer_list<Shape<double>>{
           Cylinder<double>{7, gap / 30}, Cone<double>{7, gap / 30}, Ellipsoid<double>{{3, 5, gap / 30}},
           rounded<double>(Cylinder<double>{7, gap / 60}, gap / 60),
           sum<double>(Cone<double>{7, gap / 60}, Capsule<double>{gap / 120, gap / 120}),
           hull_of<double>(Cone<double>{7, gap / 30}, Sphere<double>{gap / 30}),
           sum<double>(Box<double>{{1, 1, gap / 60}}, Cylinder<double>{0, gap / 60})}) {
    c.a.shape = shape;
    CheckCost cost;
    EXPECT_EQ(judge(c, lower_proof(1, n), &cost), Refusal::none) << shape.index();
    EXPECT_EQ(judge(c, lower_proof(up(1.0), n), &cost), Refusal::lower_not_proved) << shape.index();
    c.t_max = 1;  // touches at the end: no miss
    EXPECT_EQ(judge(c, lower_proof(kInf, n), &cost), Refusal::miss_not_proved) << shape.index();
    c.t_max = down(1.0);
    EXPECT_EQ(judge(c, lower_proof(kInf, n), &cost), Refusal::none) << shape.index();
    c.t_max = kInf;
    EXPECT_EQ(cost.exact_decisions, 0) << shape.index();
    // The rotation inside the shape instead of the body, and undone outside.
    Case inner = c;
    inner.a.shape = posed<double>(posed<double>(shape, {0, 0, 0}, q), {0, 0, 0}, {1, -2, -3, -4});
    EXPECT_EQ(judge(inner, lower_proof(1, n)), Refusal::none) << shape.index();
    EXPECT_EQ(judge(inner, lower_proof(up(1.0), n)), Refusal::lower_not_proved) << shape.index();
  }
}

TEST(CheckShapesLower, ExtremeMagnitudesAreDecided) {
  for (const double scale : {1e-55, 1e55}) {
    for (const double axis_scale : {1e-300, 1e-150, 1e150, 1e290}) {
      for (const Shape<double>& shape : std::initializer_list<Shape<double>>{
               Ellipsoid<double>{{1 * scale, 2 * scale, 3 * scale}}, Cylinder<double>{1 * scale, 2 * scale},
               Cone<double>{1 * scale, 2 * scale},
               rounded<double>(Box<double>{{scale, scale, scale}}, scale)}) {
        Case c;
        c.a.shape = shape;
        c.a.orientation = {scale, 2 * scale, -scale, 3 * scale};
        c.b.position = Vec3<double>(5, 6, 7) * scale;
        c.b.displacement = Vec3<double>(-5, -6, -7.5) / scale;
        c.t_max = kInf;
        const Vec3<double> axis = Vec3<double>(5, 6, 7) * axis_scale;
        const HighAxis truth(c, axis);
        const double nearest = High(truth.support / truth.approach).get_d();
        EXPECT_EQ(judge(c, lower_proof(down(nearest), axis)), Refusal::none) << shape.index();
        EXPECT_EQ(judge(c, lower_proof(up(nearest), axis)), Refusal::lower_not_proved) << shape.index();
      }
    }
  }
}

// |n| = 2^1023 sqrt(1 + 2^-4194) exceeds 2^1023, and agrees with it in more than 4,096 bits. h(n) - n.v = |n|
// - 2^1023 > 0, so the claim TOI >= 1 is false. For a sphere the squares decide it.
TEST(CheckShapesLower, CloserThanTheBallsTellIsUndecided) {
  Case c;
  c.b.shape = Point<double>{};
  c.b.position = {2, 0, 0};
  c.b.displacement = {-1, 0, 0};
  const Vec3<double> n{0x1p1023, 0x1p-1074, 0};
  c.a.shape = Cylinder<double>{1, 1};
  CheckCost cost;
  const oracle::Verdict verdict = check_proof(c, lower_proof(1, n), &cost);
  EXPECT_EQ(verdict.refusal, Refusal::undecided);
  EXPECT_STREQ(oracle::to_string(verdict.refusal), "undecided");
  EXPECT_EQ(cost.exact_decisions, 1);
  EXPECT_EQ(judge(c, lower_proof(up(1.0), n)), Refusal::lower_not_proved);
  EXPECT_EQ(judge(c, lower_proof(down(1.0), n)), Refusal::none);
  c.a.shape = Sphere<double>{1};
  EXPECT_EQ(judge(c, lower_proof(1, n)), Refusal::lower_not_proved);
}

// ---- points -----------------------------------------------------------------------------------------------

TEST(CheckShapesUpper, LeastDoubleAcceptedAndOneToFourUnitsBelowRefused) {
  long long all_refused = 0, all_unnamed = 0;
  for (int kind = 0; kind < kKinds; ++kind) {
    CheckCost cost;
    long long refused = 0, accepted = 0, unnamed = 0;
    Draw draw(300 + static_cast<std::uint64_t>(kind));
    for (int i = 0; i < 240; ++i) {
      Case c = draw_case(draw, static_cast<Kind>(kind), kPoses[i % 3]);
      c.t_max = kInf;
      c.target_distance = 0;
      const auto of_a = named_vertices(c.a.shape), of_b = named_vertices(c.b.shape);
      Proof proof;
      proof.portal_size = draw.random.integer(1, 3);
      std::vector<RationalVec> points;
      bool nameable = true;
      Vec3<double> aim = Vec3<double>::Zero();
      for (int k = 0; k < proof.portal_size; ++k) {
        SupportPair& s = proof.portal[static_cast<std::size_t>(k)];
        s.a = draw_feature(draw, of_a);
        s.b = draw_feature(draw, of_b);
        nameable = nameable && of_a[s.a.vertex].slots.size() <= kCurvedParts &&
                   of_b[s.b.vertex].slots.size() <= kCurvedParts;
        if (!nameable) break;
        points.push_back(world_point(c.a, of_a, s.a) - world_point(c.b, of_b, s.b));
        aim += Vec3<double>(points[k][0].get_d(), points[k][1].get_d(), points[k][2].get_d()) /
               proof.portal_size;
      }
      proof.toi_upper = 1e9;
      if (!nameable) {
        ASSERT_EQ(judge(c, proof, &cost), Refusal::malformed) << kKindNames[kind] << ", case " << i;
        ++unnamed;
        continue;
      }
      c.b.displacement = c.a.displacement + aim / draw.random.uniform(0.1, 3);
      const RationalVec v = rational(c.b.displacement) - rational(c.a.displacement);
      if (inner(v, v) == 0) continue;
      const SpanOnLine span(points, v);
      if (!span.low || *span.low <= 0) {  // so are most of one point or two, whose aim is rounded
        const Refusal expected = !span.low        ? Refusal::portal_off_path
                                 : *span.high < 0 ? Refusal::upper_not_proved
                                                  : Refusal::none;
        ASSERT_EQ(judge(c, proof, &cost), expected) << kKindNames[kind] << ", case " << i;
        continue;
      }
      double tight = span.low->get_d();
      if (Rational(tight) < *span.low) tight = up(tight);
      proof.toi_upper = tight;
      ASSERT_EQ(judge(c, proof, &cost), Refusal::none) << kKindNames[kind] << ", case " << i;
      ++accepted;
      for (int units = 1; units <= 4; ++units) {
        proof.toi_upper = down(tight, units);
        ASSERT_EQ(judge(c, proof, &cost), Refusal::upper_not_proved) << kKindNames[kind] << ", case " << i;
        ++refused;
      }
    }
    report("upper bounds", kKindNames[kind], cost, refused, accepted);
    EXPECT_GT(accepted, 20) << kKindNames[kind];
    all_unnamed += unnamed;
    all_refused += refused;
  }
  EXPECT_GE(all_refused, 3000);
  EXPECT_GT(all_unnamed, 0);
}

// Feature of the only part, on the path or not: what is asked is whether it is there at all.
Refusal there(const Shape<double>& shape, const Feature& feature) {
  Case c;
  c.a.shape = shape;
  c.b.shape = Point<double>{};
  c.b.displacement = {1, 0, 0};
  c.b.position = {100, 100, 100};
  const Refusal refusal = judge(c, upper_proof(1, feature, {}));
  std::swap(c.a, c.b);
  EXPECT_EQ(judge(c, upper_proof(1, {}, feature)), refusal);
  return refusal;
}

TEST(CheckShapesPoint, CurvedPointsReachTheSurfaceAndNotOneUnitFurther) {
  Draw draw(401);
  const Shape<double> shapes[] = {Ellipsoid<double>{{1, 2, 3}},
                                  Ellipsoid<double>{{0.3, 0, 1.7}},
                                  Ellipsoid<double>{{5, 5, 5}},
                                  Cylinder<double>{1.25, 0.7},
                                  Cylinder<double>{0.1, 0},
                                  Cone<double>{1.1, 0.9},
                                  Cone<double>{2, 0},
                                  Cone<double>{0, 1.5},
                                  Ellipsoid<double>{{1e-40, 1e-20, 1e30}}};
  long long inside = 0, outside = 0;
  for (const Shape<double>& shape : shapes) {
    for (int i = 0; i < 120; ++i) {
      Feature feature;
      feature.curved[0] = draw_inside(draw, shape);
      ASSERT_TRUE(in_part(shape, feature.curved[0]));
      ASSERT_EQ(there(shape, feature), Refusal::portal_off_path) << shape.index();
      // The last double inside along an axis, by bisection over the doubles with the reference.
      double& x = feature.curved[0][i % 3];
      const double side = draw.random.once_in(2) ? -1 : 1;
      x = side * std::abs(x);
      if (!in_part(shape, feature.curved[0])) x = 0;
      if (!in_part(shape, feature.curved[0])) continue;
      double low = std::abs(x), high = 1e40;
      while (up(low) < high) {
        const double middle =
            high > 2 * low && low > 0 ? std::sqrt(low) * std::sqrt(high) : low + (high - low) / 2;
        x = side * middle;
        (in_part(shape, feature.curved[0]) ? low : high) = middle;
      }
      x = side * low;
      ASSERT_EQ(there(shape, feature), Refusal::portal_off_path) << shape.index() << ", case " << i;
      ++inside;
      x = side * up(low);
      ASSERT_EQ(there(shape, feature), Refusal::point_outside) << shape.index() << ", case " << i;
      ++outside;
      // The same point, as the second curved one of a sum and behind a pose.
      Feature second;
      second.curved[1] = feature.curved[0];
      const Shape<double> both =
          sum<double>(Cylinder<double>{1, 1}, posed<double>(shape, {1, 2, 3}, {1, 2, 3, 4}));
      ASSERT_EQ(there(both, second), Refusal::point_outside);
      second.curved[1][i % 3] = side * low;
      ASSERT_EQ(there(both, second), Refusal::portal_off_path);
    }
  }
  EXPECT_GT(inside, 900);
  EXPECT_GT(outside, 900);
}

TEST(CheckShapesPoint, PointsOnTheSurfaceExactlyAreInside) {
  const auto at = [](const Shape<double>& shape, const Vec3<double>& x) {
    Feature feature;
    feature.curved[0] = x;
    return there(shape, feature);
  };
  EXPECT_EQ(at(Ellipsoid<double>{{5, 10, 15}}, {3, 8, 0}), Refusal::portal_off_path);  // 9/25 + 16/25
  EXPECT_EQ(at(Ellipsoid<double>{{5, 10, 15}}, {up(3.0), 8, 0}), Refusal::point_outside);
  EXPECT_EQ(at(Ellipsoid<double>{{0, 0, 0}}, {0, 0, 0}), Refusal::portal_off_path);
  EXPECT_EQ(at(Ellipsoid<double>{{0, 1, 1}}, {1e-300, 0, 0}), Refusal::point_outside);
  EXPECT_EQ(at(Cylinder<double>{5, 1}, {3, -4, -1}), Refusal::portal_off_path);
  EXPECT_EQ(at(Cylinder<double>{5, 1}, {3, -4, down(-1.0)}), Refusal::point_outside);
  EXPECT_EQ(at(Cone<double>{10, 4}, {3, 4, 0}), Refusal::portal_off_path);  // half way up
  EXPECT_EQ(at(Cone<double>{10, 4}, {3, 4, 1e-300}), Refusal::point_outside);
  EXPECT_EQ(at(Cone<double>{10, 4}, {0, 0, 4}), Refusal::portal_off_path);
  EXPECT_EQ(at(Cone<double>{10, 4}, {0, 1e-300, 4}), Refusal::point_outside);
  EXPECT_EQ(at(Cone<double>{10, 4}, {6, -8, -4}), Refusal::portal_off_path);
  EXPECT_EQ(at(Cone<double>{10, 4}, {0, 0, up(4.0)}), Refusal::point_outside);
}

TEST(CheckShapesPoint, OffsetsReachTheSumOfTheRadiiAndNotOneUnitFurther) {
  Feature feature;
  // 1 + 2 + 2 through roundings, a sphere and a capsule. The hull's other part has its own radius.
  const Shape<double> ball = sum<double>(
      rounded<double>(posed<double>(Sphere<double>{1}, {1, 1, 1}, {1, 2, 3, 4}), 2), Capsule<double>{2, 1});
  const Shape<double> hull = hull_of<double>(ball, rounded<double>(Box<double>{{1, 1, 1}}, 0.5));
  for (const Vec3<double>& x : {Vec3<double>(3, 0, 4), Vec3<double>(0, -5, 0), Vec3<double>(-4, 3, 0)}) {
    feature.offset = x;
    feature.vertex = 1;
    EXPECT_EQ(there(ball, feature), Refusal::portal_off_path);
    EXPECT_EQ(there(hull, feature), Refusal::portal_off_path);
    feature.vertex = 2;  // of the box
    EXPECT_EQ(there(hull, feature), Refusal::offset_too_long);
    feature.vertex = 0;
    int k = 0;
    x.cwiseAbs().maxCoeff(&k);
    feature.offset[k] = x[k] > 0 ? up(x[k]) : down(x[k]);
    EXPECT_EQ(there(ball, feature), Refusal::offset_too_long);
    EXPECT_EQ(there(hull, feature), Refusal::offset_too_long);
  }
  // The sum of radii is not rounded: 1 + 2^-60 allows what 1 does not.
  const Shape<double> barely = rounded<double>(Sphere<double>{1}, 0x1p-60);
  feature = {};
  feature.offset = {1, 0x1p-40, 0};  // |offset|^2 = 1 + 2^-80
  EXPECT_EQ(there(barely, feature), Refusal::portal_off_path);
  EXPECT_EQ(there(Sphere<double>{1}, feature), Refusal::offset_too_long);
  // No ball, no offset.
  feature.offset = {0, 0, 1e-300};
  for (const Shape<double>& shape : std::initializer_list<Shape<double>>{
           Cylinder<double>{1, 1}, Ellipsoid<double>{{1, 1, 1}}, Cone<double>{1, 1}, Segment<double>{},
           Triangle<double>{}, rounded<double>(Point<double>{}, 0)})
    EXPECT_EQ(there(shape, feature), Refusal::offset_too_long) << shape.index();
}

TEST(CheckShapesPoint, IndicesEndWithTheVertices) {
  Draw draw(501);
  for (int kind = 0; kind < kKinds; ++kind) {
    for (int i = 0; i < 10; ++i) {
      const Shape<double> shape = draw_kind(draw, static_cast<Kind>(kind), Numbers::doubles, Pose::rotated);
      const auto vertices = named_vertices(shape);
      Feature feature;
      feature.vertex = static_cast<std::uint32_t>(vertices.size());
      EXPECT_EQ(there(shape, feature), Refusal::malformed) << kKindNames[kind];
      --feature.vertex;
      if (vertices.back().slots.size() > kCurvedParts) continue;
      EXPECT_EQ(there(shape, feature), Refusal::portal_off_path) << kKindNames[kind];
    }
  }
  // 8^11 vertices and more: every index there is has a place.
  Shape<double> many = Box<double>{{1, 1, 1}};
  for (int i = 0; i < 10; ++i) many = sum<double>(many, Box<double>{{1, 1, 1}});
  Feature last;
  last.vertex = ~std::uint32_t{0};
  EXPECT_EQ(there(many, last), Refusal::portal_off_path);
}

// Each vertex of a sum and a hull is where its index says, and no other.
TEST(CheckShapesPoint, EveryIndexNamesItsOwnVertex) {
  const Shape<double> tree =
      hull_of<double>(sum<double>(Triangle<double>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                  posed<double>(Box<double>{{0.5, 0.25, 0.125}}, {1, 2, 3}, {1, 2, 0, -1})),
                      rounded<double>(Segment<double>{{4, 4, 4}, {5, 6, 7}}, 1));
  Case c;
  c.a.shape = tree;
  c.a.orientation = {2, 0, 1, 1};
  c.a.position = {1, -1, 2};
  c.b.shape = Point<double>{};
  const auto vertices = named_vertices(tree);
  ASSERT_EQ(vertices.size(), 26u);
  c.target_distance = 0x1p-40;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Feature feature;
    feature.vertex = static_cast<std::uint32_t>(i);
    const RationalVec at = world_point(c.a, vertices, feature);
    c.b.position = {at[0].get_d(), at[1].get_d(), at[2].get_d()};
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      feature.vertex = static_cast<std::uint32_t>(k);
      EXPECT_EQ(judge(c, upper_proof(0, feature, {})), i == k ? Refusal::none : Refusal::portal_off_path)
          << i << ' ' << k;
    }
  }
}

TEST(CheckShapesPoint, MoreCurvedPartsThanAFeatureHoldsIsMalformed) {
  const Shape<double> two = sum<double>(Cylinder<double>{1, 1}, Cone<double>{1, 1});
  EXPECT_EQ(there(two, {}), Refusal::portal_off_path);
  EXPECT_EQ(there(sum<double>(two, Ellipsoid<double>{{1, 1, 1}}), {}), Refusal::malformed);
  EXPECT_EQ(there(sum<double>(two, Sphere<double>{1}), {}), Refusal::portal_off_path);
  EXPECT_EQ(there(hull_of<double>(two, Ellipsoid<double>{{1, 1, 1}}), {}), Refusal::portal_off_path);
}

// ---- validation -------------------------------------------------------------------------------------------

TEST(CheckShapesDoor, WhatIsNoShapeIsMalformed) {
  const SharedShape<double> none, point = share<double>(Point<double>{});
  const Shape<double> shapes[] = {
      Posed<double>{none, {0, 0, 0}, {}},
      Rounded<double>{none, 1},
      Sum<double>{},
      HullOf<double>{},
      Sum<double>{{point, none}},
      HullOf<double>{{none}},
      Sum<double>{{point, share<double>(Sum<double>{})}},
      HullOf<double>{{share<double>(Hull<double>())}},
      Capsule<double>{-1, 1},
      Capsule<double>{1, -1},
      Cylinder<double>{-1, 1},
      Cylinder<double>{1, -1},
      Cone<double>{-1, 1},
      Cone<double>{1, -1},
      Ellipsoid<double>{{1, 1, -1}},
      Rounded<double>{point, -1},
      Rounded<double>{share<double>(Sphere<double>{-1}), 1},
      Posed<double>{point, {0, 0, 0}, {0, 0, 0, 0}},
      Posed<double>{point, {0, kNan, 0}, {}},
      Posed<double>{point, {0, 0, 0}, {1, 0, kInf, 0}},
      Segment<double>{{0, 0, 0}, {0, 0, kInf}},
      Triangle<double>{{0, 0, 0}, {0, 0, 1}, {kNan, 0, 0}},
      Cylinder<double>{kNan, 1},
      Ellipsoid<double>{{kInf, 1, 1}},
      Sum<double>{{point, share<double>(Cone<double>{1, kNan})}},
  };
  for (const Shape<double>& shape : shapes) {
    EXPECT_EQ(there(shape, {}), Refusal::malformed) << shape.index();
    EXPECT_EQ(there(rounded<double>(shape, 1), {}), Refusal::malformed) << shape.index();
  }
  Feature feature;
  feature.curved[1].y() = kNan;
  EXPECT_EQ(there(Cylinder<double>{1, 1}, feature), Refusal::malformed);
  EXPECT_EQ(there(Point<double>{}, feature), Refusal::malformed);
  EXPECT_EQ(there(Cylinder<double>{1e61, 1}, {}), Refusal::out_of_range);
  EXPECT_EQ(there(rounded<double>(Segment<double>{{0, 0, 1e-61}, {0, 0, 0}}, 1), {}), Refusal::out_of_range);
  EXPECT_EQ(there(posed<double>(Point<double>{}, {1e61, 0, 0}, {}), {}), Refusal::out_of_range);
}

TEST(CheckShapesDoor, DepthAndPartsAreBounded) {
  Shape<double> deep = Sphere<double>{1};
  for (int i = 0; i < 60; ++i) deep = posed<double>(deep, {1, 0, 0}, {1, 2, 3, 4});
  EXPECT_EQ(there(deep, {}), Refusal::portal_off_path);
  Case c;
  c.a.shape = deep;
  c.b.shape = Point<double>{};
  c.b.position = {200, 0, 0};
  c.b.displacement = {-1, 0, 0};
  const auto tight = HighAxis(c, Vec3<double>(1, 0.5, 0.25)).tightest();
  ASSERT_TRUE(tight);
  EXPECT_EQ(judge(c, lower_proof(*tight, {1, 0.5, 0.25})), Refusal::none);
  EXPECT_EQ(judge(c, lower_proof(up(*tight), {1, 0.5, 0.25})), Refusal::lower_not_proved);
  for (int i = 0; i < 2000; ++i) deep = posed<double>(deep, {1, 0, 0}, {1, 2, 3, 4});
  EXPECT_EQ(there(deep, {}), Refusal::unsupported);
  Shape<double> shared = Point<double>{};  // 2^40 ways through 40 nodes
  for (int i = 0; i < 40; ++i) {
    const SharedShape<double> part = share<double>(shared);
    shared = Sum<double>{{part, part}};
  }
  EXPECT_EQ(there(shared, {}), Refusal::unsupported);
  HullOf<double> wide;
  for (int i = 0; i < 3000; ++i)
    wide.shapes.push_back(share<double>(i == 0 ? Shape<double>(Cone<double>{1, 1}) : Sphere<double>{1}));
  EXPECT_EQ(there(wide, {}), Refusal::portal_off_path);
}

Case turned_pair() {
  Case c;
  c.a.shape = rounded<double>(Cylinder<double>{1, 2}, 0.5);
  c.a.orientation = {1, 2, 3, 4};
  c.b.shape = sum<double>(Cone<double>{1, 1}, Box<double>{{1, 2, 3}});
  c.b.orientation = {1, -1, 0, 3};
  c.b.position = {20, 1, 2};
  c.b.displacement = {-20, 0, 0};
  return c;
}

TEST(CheckShapesDoor, WithoutDoublesEverythingIsLeftToBallsAndGmp) {
  const Case c = turned_pair();
  const Vec3<double> n{1, 0.25, 0x1p-1070};
  const auto tight = HighAxis(c, n).tightest();
  ASSERT_TRUE(tight);
  CheckCost cost;
  const auto refusal = [&](double lower) {
    return check_proof(c, lower_proof(lower, n), &cost, oracle::Stages::without_doubles).refusal;
  };
  EXPECT_EQ(refusal(*tight), Refusal::none);
  EXPECT_EQ(refusal(up(*tight)), Refusal::lower_not_proved);
  EXPECT_EQ(cost.double_decisions + cost.extended_decisions, 0);
}

TEST(CheckShapesDoor, AnotherRoundingModeOrFlushedSubnormalsChangeNothing) {
  const Case c = turned_pair();
  const Vec3<double> n{1, 0.25, 0x1p-1070};
  const auto tight = HighAxis(c, n).tightest();
  ASSERT_TRUE(tight);
  const auto found = in_every_environment(
      [&] { return std::pair(judge(c, lower_proof(*tight, n)), judge(c, lower_proof(up(*tight), n))); });
  for (const auto& [name, result, given_back] : found) {
    EXPECT_EQ(result, std::pair(Refusal::none, Refusal::lower_not_proved)) << name;
    EXPECT_TRUE(given_back) << name;
  }
}

}  // namespace
}  // namespace graze::test
