// The checker of proofs against an independent decision in rationals (proof_reference.hpp): true proofs are
// accepted, and proofs that are false by one unit in the last place are refused under the name of the false
// claim.
#include "oracles/checker/check_proof.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iostream>
#include <limits>

#include "tests/oracles/arithmetic/environments.hpp"
#include "tests/oracles/checker/count_allocations.hpp"
#include "tests/oracles/checker/proof_cases.hpp"
#include "tests/oracles/checker/proof_reference.hpp"

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

// A portal of pairs (vertex of A, vertex of B).
Proof upper_proof(double toi, std::initializer_list<std::pair<std::uint32_t, std::uint32_t>> pairs) {
  Proof proof;
  proof.toi_upper = toi;
  for (const auto& [a, b] : pairs) {
    SupportPair& s = proof.portal[static_cast<std::size_t>(proof.portal_size++)];
    s.a.vertex = a;
    s.b.vertex = b;
  }
  return proof;
}

Refusal judge(const Case& c, const Proof& proof, CheckCost* cost = nullptr) {
  return check_proof(c, proof, cost).refusal;
}

std::string stages(const CheckCost& cost) {
  return "double " + std::to_string(cost.double_decisions) + ", extended " +
         std::to_string(cost.extended_decisions) + ", exact " + std::to_string(cost.exact_decisions);
}
void report(const std::string& what, const CheckCost& cost, long long refused, long long accepted) {
  std::cout << "[  counts  ] " << what << ": refused " << refused << ", accepted " << accepted
            << "; settled in " << stages(cost) << "\n";
}

// Cast of a point B from the origin's far side against a hull A at the origin: p_i = vertex_i - position_B.
Case point_against(std::span<const Vec3<double>> vertices, const Vec3<double>& v) {
  Case c;
  c.a.shape = Hull<double>(vertices);
  c.b.shape = Point<double>{};
  c.b.displacement = v;
  c.t_max = kInf;
  return c;
}

// ---- axes -------------------------------------------------------------------------------------------------

// Directions worth asking about: near the line of centres, random, and rounded facet normals of A.
Vec3<double> draw_axis(Draw& draw, const Case& c) {
  const Vec3<double> between = c.b.position - c.a.position;
  if (draw.random.once_in(2)) {
    const auto vertices = local_vertices(c.a.shape);
    const auto pick = [&] { return vertices[draw.random.below(vertices.size())]; };
    const Vec3<double> corner = pick(), second = pick(), third = pick();
    Vec3<double> normal = (second - corner).cross(third - corner);
    const Quaternion<double>& q = c.a.orientation;
    normal = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized() * normal;
    if (normal.dot(between) < 0) normal = -normal;
    if (normal.cwiseAbs().maxCoeff() > 0) return normal;
  }
  return between + draw.vector(Numbers::doubles, draw.random.once_in(2) ? 1 : 4);
}

void check_tight_lower_bounds(std::uint64_t seed, Pose pose, int cases, long long& refused,
                              long long& accepted, CheckCost& cost) {
  Draw draw(seed);
  for (int i = 0; i < cases; ++i) {
    const auto kind = static_cast<Numbers>(draw.random.below(3));
    Case c = approaching(draw, kind, pose);
    if (draw.random.once_in(4)) c.target_distance = draw.random.uniform(0, 1);
    const Vec3<double> axis = draw_axis(draw, c);
    const AxisReference truth(c, axis);
    const auto tight = truth.tightest();
    if (!tight) {
      const Refusal expected = truth.approach < 0 ? Refusal::lower_not_proved : Refusal::axis_not_approaching;
      ASSERT_EQ(judge(c, lower_proof(1e-200, axis), &cost), expected) << "case " << i;
      continue;
    }
    ++accepted;
    ASSERT_EQ(judge(c, lower_proof(*tight, axis), &cost), Refusal::none) << "case " << i;
    for (int units = 1; units <= 4; ++units) {
      const oracle::Verdict verdict = check_proof(c, lower_proof(up(*tight, units), axis), &cost);
      ASSERT_EQ(verdict.refusal, Refusal::lower_not_proved) << "case " << i << ", " << units << " units";
      ASSERT_FALSE(verdict.detail.empty());
      ++refused;
    }
  }
}

TEST(CheckProofLower, TightestDoubleAcceptedAndOneToFourUnitsBeyondRefused) {
  long long refused = 0;
  for (const Pose pose : {Pose::identity, Pose::quarter_turns, Pose::rotated}) {
    CheckCost cost;
    long long refused_here = 0, accepted = 0;
    check_tight_lower_bounds(11 + static_cast<std::uint64_t>(pose), pose, 1500, refused_here, accepted, cost);
    if (HasFatalFailure()) return;
    report("lower bounds, pose " + std::to_string(static_cast<int>(pose)), cost, refused_here, accepted);
    EXPECT_GT(accepted, 500);
    EXPECT_GT(cost.double_decisions, 0);
    EXPECT_GT(cost.extended_decisions, cost.exact_decisions);  // a tight claim needs GMP only at a tie
    refused += refused_here;
  }
  EXPECT_GE(refused, 10000);
}

TEST(CheckProofLower, ExactTieOfIntegersIsSettledWithoutGmp) {
  Case c;
  c.a.shape = Box<double>{{1, 1, 1}};
  c.b.shape = Box<double>{{1, 1, 1}};
  c.b.position = {5, 0, 0};
  c.b.displacement = {-4, 0, 0};
  CheckCost cost;
  EXPECT_EQ(judge(c, lower_proof(0.75, {1, 0, 0}), &cost), Refusal::none);
  EXPECT_EQ(cost.extended_decisions, 1);
  EXPECT_EQ(judge(c, lower_proof(up(0.75), {1, 0, 0}), &cost), Refusal::lower_not_proved);
  EXPECT_EQ(judge(c, lower_proof(0.5, {1, 0, 0}), &cost), Refusal::none);
  EXPECT_EQ(cost.double_decisions, 1);
  EXPECT_EQ(cost.exact_decisions, 0);
}

TEST(CheckProofLower, RadiusTimesNormOfAxisIsIrrationalAndStillDecided) {
  // Unit spheres 10 apart along (1, 1, 0), n = (1, 1, 0): h(n) = -20 + 2 sqrt 2, n.v = -20.
  Case c;
  c.a.shape = Sphere<double>{1};
  c.b.shape = Sphere<double>{1};
  c.b.position = {10, 10, 0};
  c.b.displacement = {-10, -10, 0};
  const AxisReference truth(c, Vec3<double>(1, 1, 0));
  const auto tight = truth.tightest();
  ASSERT_TRUE(tight);
  EXPECT_NEAR(*tight, 1 - std::sqrt(2) / 10, 1e-15);
  EXPECT_EQ(judge(c, lower_proof(*tight, {1, 1, 0})), Refusal::none);
  EXPECT_EQ(judge(c, lower_proof(up(*tight), {1, 1, 0})), Refusal::lower_not_proved);
  // A rational tie, |n| = 5: h(n) = -60 + 5 R - ..., decided as equality.
  c.b.position = {6, 8, 0};
  c.b.displacement = {-6, -8, 0};
  EXPECT_EQ(judge(c, lower_proof(0.8, {3, 4, 0})), AxisReference(c, Vec3<double>(3, 4, 0)).lower_holds(0.8)
                                                       ? Refusal::none
                                                       : Refusal::lower_not_proved);
  c.target_distance = 0.5;  // h = -50 + 2.5 * 5, bound exactly 3/4
  EXPECT_EQ(judge(c, lower_proof(0.75, {3, 4, 0})), Refusal::none);
  EXPECT_EQ(judge(c, lower_proof(up(0.75), {3, 4, 0})), Refusal::lower_not_proved);
}

TEST(CheckProofLower, ExtremeMagnitudesAreDecidedExactly) {
  CheckCost cost;
  for (const double scale : {1e-55, 1e55}) {
    for (const double axis_scale : {1e-300, 1e-150, 1e150, 1e300}) {
      Draw draw(5);
      const Hull<double> a = draw.hull(Numbers::doubles, 8, 8), b = draw.hull(Numbers::doubles, 8, 8);
      Case c = approaching(draw, Numbers::doubles, Pose::rotated, a, b);
      for (Body<double>* body : {&c.a, &c.b}) {
        std::vector<Vec3<double>> vertices = local_vertices(body->shape);
        for (auto& x : vertices) x *= scale;
        body->shape = Hull<double>(vertices);
        body->position *= scale;
        body->displacement /= scale;
        Quaternion<double>& q = body->orientation;
        q = {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
      }
      const Vec3<double> axis = (c.b.position - c.a.position) / scale * axis_scale / 32;
      const auto tight = AxisReference(c, axis).tightest();
      ASSERT_TRUE(tight) << scale << ' ' << axis_scale;
      EXPECT_EQ(judge(c, lower_proof(*tight, axis), &cost), Refusal::none);
      EXPECT_EQ(judge(c, lower_proof(up(*tight), axis), &cost), Refusal::lower_not_proved);
    }
  }
  EXPECT_GT(cost.exact_decisions, 0);  // where products underflow, GMP has to decide
}

TEST(CheckProofMiss, RandomClaimsAgreeWithTheReference) {
  CheckCost cost;
  long long refused = 0, accepted = 0;
  Draw draw(21);
  for (int i = 0; i < 3000; ++i) {
    const auto kind = static_cast<Numbers>(draw.random.below(3));
    const auto pose = static_cast<Pose>(draw.random.below(3));
    Case c = approaching(draw, kind, pose);
    if (draw.random.once_in(2)) c.b.displacement = c.a.displacement + draw.vector(kind, 8);
    if (draw.random.once_in(10)) c.b.displacement = c.a.displacement;
    if (draw.random.once_in(4)) c.target_distance = draw.random.uniform(0, 1);
    const Vec3<double> axis = draw_axis(draw, c);
    const AxisReference truth(c, axis);
    // Horizons at and around the time where the axis stops proving: h(n) = T n.v.
    if (const auto tight = truth.tightest(); tight && draw.random.once_in(2))
      c.t_max = draw.random.once_in(2) ? *tight : up(*tight);
    const bool holds = truth.miss_holds(c.t_max);
    ASSERT_EQ(judge(c, lower_proof(kInf, axis), &cost), holds ? Refusal::none : Refusal::miss_not_proved)
        << "case " << i;
    ++(holds ? accepted : refused);
  }
  report("misses", cost, refused, accepted);
  EXPECT_GT(accepted, 300);
  EXPECT_GT(refused, 300);
}

TEST(CheckProofMiss, ExactTiesAreContactAndRefused) {
  Case c;
  c.a.shape = Box<double>{{1, 1, 1}};
  c.b.shape = Box<double>{{1, 1, 1}};
  c.b.position = {5, 0, 0};
  c.b.displacement = {-4, 0, 0};
  c.t_max = 0.75;  // touches at the very end: h = -3 = T n.v
  EXPECT_EQ(judge(c, lower_proof(kInf, {1, 0, 0})), Refusal::miss_not_proved);
  c.t_max = down(0.75);
  EXPECT_EQ(judge(c, lower_proof(kInf, {1, 0, 0})), Refusal::none);
  c.b.position = {2, 0, 0};  // touches at the start and slides: h = 0
  c.b.displacement = {0, 1, 0};
  EXPECT_EQ(judge(c, lower_proof(kInf, {1, 0, 0})), Refusal::miss_not_proved);
  c.b.position = {up(2.0), 0, 0};
  EXPECT_EQ(judge(c, lower_proof(kInf, {1, 0, 0})), Refusal::none);
  c.target_distance = up(2.0) - 2;
  EXPECT_EQ(judge(c, lower_proof(kInf, {1, 0, 0})), Refusal::miss_not_proved);
}

TEST(CheckProofMiss, InfiniteHorizon) {
  Case c;
  c.a.shape = Sphere<double>{1};
  c.b.shape = Point<double>{};
  c.b.position = {0, 2, 0};
  c.t_max = kInf;
  c.b.displacement = {1, 0, 0};  // parallel: n.v = 0, T n.v = 0
  EXPECT_EQ(judge(c, lower_proof(kInf, {0, 1, 0})), Refusal::none);
  c.b.displacement = {1, 1, 0};  // leaving
  EXPECT_EQ(judge(c, lower_proof(kInf, {0, 1, 0})), Refusal::none);
  c.b.displacement = {1, -1e-50, 0};  // approaching, however slowly: never proved
  EXPECT_EQ(judge(c, lower_proof(kInf, {0, 1, 0})), Refusal::miss_not_proved);
  c.b.displacement = {0, 0, 0};
  EXPECT_EQ(judge(c, lower_proof(kInf, {0, 1, 0})), Refusal::none);
}

// ---- portals ----------------------------------------------------------------------------------------------

// s0 and s1 of the portal, rounded to the double below or above, or nothing if the portal is off the line.
struct PortalReference {
  std::optional<Rational> low, high;

  PortalReference(const Case& c, const Proof& proof) {
    const SpanOnLine span(portal_points(c, proof), rational(c.b.displacement) - rational(c.a.displacement));
    low = span.low;
    high = span.high;
  }
  [[nodiscard]] Refusal expected(double t_max, double toi_upper) const {
    if (!low) return Refusal::portal_off_path;
    const double end = std::min(t_max, toi_upper);
    return *low <= Rational(end) && *high >= 0 ? Refusal::none : Refusal::upper_not_proved;
  }
};

// The least double not below x > 0.
double rounded_up(const Rational& x) {
  double d = x.get_d();  // toward zero
  return Rational(d) < x ? up(d) : d;
}

void check_tight_upper_bounds(std::uint64_t seed, Pose pose, int cases, long long& refused,
                              long long& accepted, CheckCost& cost) {
  Draw draw(seed);
  for (int i = 0; i < cases; ++i) {
    const auto kind = static_cast<Numbers>(draw.random.below(3));
    Case c = approaching(draw, kind, pose, draw.hull(kind, 4, 16));
    c.t_max = kInf;
    Proof proof;
    proof.portal_size = 3;
    Vec3<double> aim = Vec3<double>::Zero();
    double weight_left = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      proof.portal[k].a.vertex =
          static_cast<std::uint32_t>(draw.random.below(local_vertices(c.a.shape).size()));
      proof.portal[k].b.vertex =
          static_cast<std::uint32_t>(draw.random.below(local_vertices(c.b.shape).size()));
      if (const auto* sphere = std::get_if<Sphere<double>>(&c.b.shape))
        proof.portal[k].b.offset = draw.vector(Numbers::doubles, sphere->radius / 2);
    }
    for (const RationalVec& p : portal_points(c, proof)) {
      const double weight = weight_left * draw.random.uniform(0.2, 0.6);
      weight_left -= weight;
      aim += weight * Vec3<double>(p[0].get_d(), p[1].get_d(), p[2].get_d());
    }
    aim /= 1 - weight_left;
    c.b.displacement = c.a.displacement + aim / draw.random.uniform(0.1, 3);
    const PortalReference truth(c, proof);
    if (!truth.low || *truth.low <= 0) {
      proof.toi_upper = 1e9;
      ASSERT_EQ(judge(c, proof, &cost), truth.expected(kInf, 1e9)) << "case " << i;
      continue;
    }
    const double tight = rounded_up(*truth.low);
    proof.toi_upper = tight;
    ASSERT_EQ(judge(c, proof, &cost), Refusal::none) << "case " << i;
    c.t_max = down(tight);
    ASSERT_EQ(judge(c, proof, &cost), Refusal::upper_not_proved) << "case " << i << ", s > T";
    c.t_max = kInf;
    ++accepted;
    for (int units = 1; units <= 4; ++units) {
      proof.toi_upper = down(tight, units);
      ASSERT_EQ(judge(c, proof, &cost), Refusal::upper_not_proved)
          << "case " << i << ", " << units << " units";
      ++refused;
    }
  }
}

TEST(CheckProofUpper, LeastDoubleAcceptedAndOneToFourUnitsBelowRefused) {
  long long refused = 0;
  for (const Pose pose : {Pose::identity, Pose::quarter_turns, Pose::rotated}) {
    CheckCost cost;
    long long refused_here = 0, accepted = 0;
    check_tight_upper_bounds(31 + static_cast<std::uint64_t>(pose), pose, 1300, refused_here, accepted, cost);
    if (HasFatalFailure()) return;
    report("upper bounds, pose " + std::to_string(static_cast<int>(pose)), cost, refused_here, accepted);
    EXPECT_GT(accepted, 500);
    EXPECT_GT(cost.extended_decisions, cost.exact_decisions);
    refused += refused_here;
  }
  EXPECT_GE(refused, 10000);
}

// Vertices, horizon and claim from a handful of integers, so that every degeneracy is common.
TEST(CheckProofUpper, DegeneratePortalsAgreeWithTheReference) {
  long long accepted = 0, beyond = 0, off = 0;
  CheckCost cost;
  Draw draw(41);
  for (int i = 0; i < 6000; ++i) {
    std::vector<Vec3<double>> vertices(4);
    const bool flat = draw.random.once_in(4);
    for (auto& x : vertices) {
      for (int k = 0; k < 3; ++k) x[k] = draw.random.integer(-2, 3);
      if (flat) x.z() = 0;
    }
    Vec3<double> v;
    for (int k = 0; k < 3; ++k) v[k] = draw.random.integer(-1, 1);
    if (flat) v.z() = 0;
    Case c = point_against(vertices, v);
    if (draw.random.once_in(3)) c.a.orientation = {1, 2, -1, 3};  // |q|^2 = 15: thirds and fifths
    if (draw.random.once_in(3)) c.t_max = draw.random.integer(0, 2);
    Proof proof = upper_proof(draw.random.integer(0, 6) / 2.0, {});
    proof.portal_size = draw.random.integer(1, 4);
    for (std::uint32_t k = 0; k < 4; ++k) proof.portal[k].a.vertex = k;
    Refusal expected;
    if (v.isZero(0)) {
      expected = distance_sq(portal_points(c, proof)) == 0 ? Refusal::none : Refusal::portal_off_path;
    } else {
      expected = PortalReference(c, proof).expected(c.t_max, proof.toi_upper);
    }
    ASSERT_EQ(judge(c, proof, &cost), expected) << "case " << i;
    ++(expected == Refusal::none ? accepted : expected == Refusal::portal_off_path ? off : beyond);
  }
  report("degenerate portals", cost, beyond + off, accepted);
  EXPECT_GT(accepted, 300);
  EXPECT_GT(beyond, 100);
  EXPECT_GT(off, 1000);
}

TEST(CheckProofUpper, OnePointExactlyOnTheRayAndOneUnitOff) {
  const Vec3<double> p(5, 10, -15);
  Case c = point_against({{p}}, {3, 6, -9});  // s = 5/3
  EXPECT_EQ(judge(c, upper_proof(rounded_up(Rational(5, 3)), {{0, 0}})), Refusal::none);
  EXPECT_EQ(judge(c, upper_proof(down(rounded_up(Rational(5, 3))), {{0, 0}})), Refusal::upper_not_proved);
  for (int k = 0; k < 3; ++k) {
    Vec3<double> off = p;
    off[k] = up(off[k]);
    EXPECT_EQ(judge(point_against({{off}}, {3, 6, -9}), upper_proof(2, {{0, 0}})), Refusal::portal_off_path);
  }
  // Repeated points say no more than one of them.
  EXPECT_EQ(judge(c, upper_proof(2, {{0, 0}, {0, 0}, {0, 0}})), Refusal::none);
  EXPECT_EQ(judge(c, upper_proof(1.5, {{0, 0}, {0, 0}, {0, 0}})), Refusal::upper_not_proved);
}

TEST(CheckProofUpper, SegmentAcrossTheRayAndOneUnitOff) {
  // c = (5, 5, 5) on the ray of v = (3, 3, 3), between c + 2 e and c - 3 e, e = (1, -2, 3).
  const std::vector<Vec3<double>> ends = {{7, 1, 11}, {2, 11, -4}, {2, up(11.0), -4}};
  const Case c = point_against(ends, {3, 3, 3});
  const double tight = rounded_up(Rational(5, 3));
  for (const auto& proof :
       {upper_proof(tight, {{0, 0}, {1, 0}}), upper_proof(tight, {{1, 0}, {0, 0}, {1, 0}})})
    EXPECT_EQ(judge(c, proof), Refusal::none);
  EXPECT_EQ(judge(c, upper_proof(down(tight), {{0, 0}, {1, 0}})), Refusal::upper_not_proved);
  EXPECT_EQ(judge(c, upper_proof(2, {{0, 0}, {2, 0}})), Refusal::portal_off_path);
}

TEST(CheckProofUpper, PathThatOnlyMeetsTheLineBehindOrBesideIsRefused) {
  const std::vector<Vec3<double>> triangle = {{-2, 1, 1}, {-2, -1, 1}, {-2, 0, -1}};
  EXPECT_EQ(judge(point_against(triangle, {1, 0, 0}), upper_proof(9, {{0, 0}, {1, 0}, {2, 0}})),
            Refusal::upper_not_proved);  // s = -2
  EXPECT_EQ(judge(point_against(triangle, {-1, 2, 0}), upper_proof(9, {{0, 0}, {1, 0}, {2, 0}})),
            Refusal::portal_off_path);  // one weight would be negative
  EXPECT_EQ(judge(point_against(triangle, {-1, 0, 0}), upper_proof(2, {{0, 0}, {1, 0}, {2, 0}})),
            Refusal::none);
}

TEST(CheckProofUpper, TargetDistanceAgreesWithTheReference) {
  long long accepted = 0, beyond = 0, off = 0;
  CheckCost cost;
  Draw draw(51);
  for (int i = 0; i < 700; ++i) {
    const bool integers = draw.random.once_in(2);
    std::vector<Vec3<double>> vertices(4);
    for (auto& x : vertices)
      x = draw.vector(integers ? Numbers::integers : Numbers::doubles, 3) + Vec3<double>(1, 0, 0);
    Vec3<double> v = draw.vector(integers ? Numbers::integers : Numbers::doubles, 2);
    if (draw.random.once_in(20)) v.setZero();
    Case c = point_against(vertices, v);
    if (draw.random.once_in(3))
      c.a.orientation = draw.orientation(integers ? Pose::quarter_turns : Pose::rotated);
    Proof proof = upper_proof(draw.random.integer(0, 3), {});
    proof.portal_size = draw.random.integer(1, 4);
    for (std::uint32_t k = 0; k < 4; ++k) proof.portal[k].a.vertex = k;
    const auto points = portal_points(c, proof);
    const RationalVec velocity = rational(v);
    std::vector<RationalVec> from_path = points, from_line = points;
    for (const RationalVec& p : points) from_path.push_back(p - Rational(proof.toi_upper) * velocity);
    if (!v.isZero(0))
      for (RationalVec& p : from_line) p = p - (inner(p, velocity) / inner(velocity, velocity)) * velocity;
    const Rational near_sq = distance_sq(from_path), line_sq = distance_sq(from_line);
    // m at the exact distance's double neighbours as well as away from it.
    const double near = std::sqrt(near_sq.get_d()), line = std::sqrt(line_sq.get_d());
    for (const double m : {near, up(near), down(near), line, 0.25, 1.0}) {
      if (!(m >= 1e-60)) continue;
      c.target_distance = m;
      const Rational m_sq = Rational(m) * Rational(m);
      const Refusal expected = near_sq <= m_sq   ? Refusal::none
                               : line_sq <= m_sq ? Refusal::upper_not_proved
                                                 : Refusal::portal_off_path;
      ASSERT_EQ(judge(c, proof, &cost), expected) << "case " << i << ", m = " << m;
      ++(expected == Refusal::none ? accepted : expected == Refusal::portal_off_path ? off : beyond);
    }
  }
  report("target distances", cost, beyond + off, accepted);
  EXPECT_GT(accepted, 300);
  EXPECT_GT(beyond, 100);
  EXPECT_GT(off, 100);
}

TEST(CheckProofUpper, OffsetsReachTheSphereAndNotOneUnitFurther) {
  Case c;
  c.a.shape = Sphere<double>{5};
  c.b.shape = Point<double>{};
  c.b.position = {0, 0, 10};
  c.b.displacement = {0, 0, -1};
  c.t_max = kInf;
  Proof proof = upper_proof(5, {{0, 0}});
  proof.portal[0].a.offset = {0, 0, 5};
  EXPECT_EQ(judge(c, proof), Refusal::none);
  proof.portal[0].a.offset = {0, 0, up(5.0)};
  EXPECT_EQ(judge(c, proof), Refusal::offset_too_long);
  proof.portal[0].a.offset = {3, 4, 0};  // |offset| = 5, off the path
  EXPECT_EQ(judge(c, proof), Refusal::portal_off_path);
  proof.portal[0].a.offset = {3, up(4.0), 0};
  EXPECT_EQ(judge(c, proof), Refusal::offset_too_long);
  proof.portal[0].a.offset = {0, 0, 5};
  proof.portal[0].b.offset = {0, 0, 1e-300};  // a point has no offset
  EXPECT_EQ(judge(c, proof), Refusal::offset_too_long);

  Draw draw(61);
  int fits = 0, too_long = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3<double> offset = draw.vector(Numbers::doubles, 1);
    const double norm = offset.norm();
    for (const double r : {down(norm), norm, up(norm)}) {
      c.a.shape = Sphere<double>{r};
      Proof claim = upper_proof(100, {{0, 0}});
      claim.portal[0].a.offset = offset;
      const RationalVec x = rational(offset);
      const bool fit = inner(x, x) <= Rational(r) * Rational(r);
      ASSERT_EQ(judge(c, claim), fit ? Refusal::portal_off_path : Refusal::offset_too_long);
      ++(fit ? fits : too_long);
    }
  }
  EXPECT_GT(fits, 1000);
  EXPECT_GT(too_long, 1000);
}

// ---- validation -------------------------------------------------------------------------------------------

struct Good {
  Case c;
  Proof proof;
};
// Two hulls and a full, tight proof: axis and three-point portal in the touched face.
Good good() {
  Good g;
  g.c.a.shape = Hull<double>{{1, 1, 1}, {1, -1, 1}, {1, 0, -1}, {-1, 0, 0}};
  g.c.b.shape = Sphere<double>{1};
  g.c.b.position = {4, 0, 0};
  g.c.b.displacement = {-4, 0, 0};
  g.proof = upper_proof(0.5, {{0, 0}, {1, 0}, {2, 0}});
  for (SupportPair& s : g.proof.portal) s.b.offset = {-1, 0, 0};
  g.proof.toi_lower = 0.5;
  g.proof.has_axis = true;
  g.proof.axis = {1, 0, 0};
  return g;
}

TEST(CheckProofDoor, TheGoodProofIsAccepted) {
  const Good g = good();
  const oracle::Verdict verdict = check_proof(g.c, g.proof);
  EXPECT_TRUE(verdict.accepted()) << verdict.detail;
  EXPECT_TRUE(verdict.detail.empty());
}

TEST(CheckProofDoor, NanOrInfinityAnywhereIsMalformed) {
  for (const double bad : {kNan, kInf, -kInf}) {
    const auto spoilt = [bad](auto&& spoil) {
      Good g = good();
      spoil(g, bad);
      return judge(g.c, g.proof);
    };
    const auto expect = [&](const char* what, auto&& spoil) {
      EXPECT_EQ(spoilt(spoil), Refusal::malformed) << what << " = " << bad;
    };
    for (int k = 0; k < 3; ++k) {
      expect("vertex", [k](Good& g, double x) {
        std::vector<Vec3<double>> vertices = local_vertices(g.c.a.shape);
        vertices[2][k] = x;
        g.c.a.shape = Hull<double>(vertices);
      });
      expect("half extent", [k](Good& g, double x) {
        Box<double> box{{1, 1, 1}};
        box.half_extents[k] = x;
        g.c.a.shape = box;
      });
      expect("position", [k](Good& g, double x) { g.c.a.position[k] = x; });
      expect("displacement", [k](Good& g, double x) { g.c.b.displacement[k] = x; });
      expect("axis", [k](Good& g, double x) { g.proof.axis[k] = x; });
      expect("offset", [k](Good& g, double x) { g.proof.portal[1].b.offset[k] = x; });
      expect("rotation", [k](Good& g, double x) { g.c.spin_a.rotation[k] = x; });
    }
    expect("radius", [](Good& g, double x) { g.c.b.shape = Sphere<double>{x}; });
    expect("target distance", [](Good& g, double x) { g.c.target_distance = x; });
    expect("w", [](Good& g, double x) { g.c.a.orientation.w = x; });
    expect("x", [](Good& g, double x) { g.c.a.orientation.x = x; });
    expect("y", [](Good& g, double x) { g.c.b.orientation.y = x; });
    expect("z", [](Good& g, double x) { g.c.b.orientation.z = x; });
    if (bad == kInf) continue;  // infinite times mean something
    expect("t_max", [](Good& g, double x) { g.c.t_max = x; });
    expect("toi_lower", [](Good& g, double x) { g.proof.toi_lower = x; });
    expect("toi_upper", [](Good& g, double x) { g.proof.toi_upper = x; });
  }
}

TEST(CheckProofDoor, EveryRefusalHasItsCause) {
  const auto spoilt = [](auto&& spoil) {
    Good g = good();
    spoil(g);
    return judge(g.c, g.proof);
  };
  EXPECT_EQ(spoilt([](Good& g) { g.proof.portal_size = 5; }), Refusal::malformed);
  EXPECT_EQ(spoilt([](Good& g) { g.proof.portal_size = -1; }), Refusal::malformed);
  EXPECT_EQ(spoilt([](Good& g) { g.proof.portal[2].a.vertex = 4; }), Refusal::malformed);
  EXPECT_EQ(spoilt([](Good& g) { g.proof.portal[2].b.vertex = 1; }), Refusal::malformed);
  EXPECT_EQ(spoilt([](Good& g) { g.proof.toi_lower = -1; }), Refusal::malformed);
  EXPECT_EQ(spoilt([](Good& g) { g.c.t_max = -1; }), Refusal::malformed);
  EXPECT_EQ(spoilt([](Good& g) { g.c.target_distance = -1; }), Refusal::malformed);
  EXPECT_EQ(spoilt([](Good& g) { g.c.a.shape = Hull<double>(); }), Refusal::malformed);
  EXPECT_EQ(spoilt([](Good& g) { g.c.b.shape = Sphere<double>{-1}; }), Refusal::malformed);
  EXPECT_EQ(spoilt([](Good& g) { g.c.a.orientation = {0, 0, 0, 0}; }), Refusal::malformed);
  EXPECT_EQ(spoilt([](Good& g) { g.c.spin_b.rotation.x() = 1; }), Refusal::unsupported);
  EXPECT_EQ(spoilt([](Good& g) {
              g.c.start_policy = corpus::StartPolicy::pass_over;
              g.proof.toi_lower = 0;
            }),
            Refusal::unsupported);
  // Apart at the start, as the lower bound says: no policy applies.
  EXPECT_EQ(spoilt([](Good& g) { g.c.start_policy = corpus::StartPolicy::pass_over; }), Refusal::none);
  EXPECT_EQ(spoilt([](Good& g) { g.c.a.position.x() = 1e61; }), Refusal::out_of_range);
  EXPECT_EQ(spoilt([](Good& g) { g.c.b.displacement.y() = 1e-61; }), Refusal::out_of_range);
  EXPECT_EQ(spoilt([](Good& g) { g.c.target_distance = 1e-61; }), Refusal::out_of_range);
  EXPECT_EQ(spoilt([](Good& g) { g.proof.has_axis = false; }), Refusal::axis_missing);
  EXPECT_EQ(spoilt([](Good& g) { g.proof.axis.setZero(); }), Refusal::axis_missing);
  EXPECT_EQ(spoilt([](Good& g) { g.proof.axis = {-1, 0, 0}; }), Refusal::axis_not_approaching);
  EXPECT_EQ(spoilt([](Good& g) { g.proof.axis = {0, 1, 0}; }), Refusal::axis_not_approaching);
  EXPECT_EQ(spoilt([](Good& g) { g.proof.portal_size = 0; }), Refusal::portal_missing);
  EXPECT_EQ(spoilt([](Good& g) { g.proof.portal[0].a.vertex = 1; }), Refusal::portal_off_path);
  // Claims nothing, and needs nothing.
  EXPECT_EQ(judge(good().c, Proof{}), Refusal::none);
  // A true bound later than the end of the path is a true bound. Contact at T itself counts.
  EXPECT_EQ(spoilt([](Good& g) { g.c.t_max = 0.5; }), Refusal::none);
  EXPECT_EQ(spoilt([](Good& g) { g.c.t_max = down(0.5); }), Refusal::upper_not_proved);
}

TEST(CheckProofDoor, WithoutDoublesEverythingIsLeftToGmp) {
  const Good g = good();
  CheckCost cost;
  EXPECT_TRUE(check_proof(g.c, g.proof, &cost, oracle::Stages::without_doubles).accepted());
  EXPECT_EQ(cost.double_decisions + cost.extended_decisions, 0);
  EXPECT_GT(cost.exact_decisions, 0);
}

TEST(CheckProofDoor, TheCallersEnvironmentChangesNothingAndIsGivenBack) {
  const Good g = good();
  // In overlap at the start, with a lower bound that is above 0 by a bit and has no axis.
  Good forged = good();
  forged.c.b.position = forged.c.a.position;
  forged.proof = {};
  forged.proof.toi_lower = 1e-323;
  const auto found = in_every_environment([&] {
    CheckCost cost;
    const Refusal sound = judge(g.c, g.proof, &cost);
    return std::tuple(sound, judge(forged.c, forged.proof), cost.double_decisions, cost.extended_decisions,
                      cost.exact_decisions);
  });
  for (const auto& [name, result, given_back] : found) {
    EXPECT_EQ(result, found[0].result) << name;
    EXPECT_EQ(std::get<0>(result), Refusal::none) << name;
    EXPECT_EQ(std::get<1>(result), Refusal::axis_missing) << name;
    EXPECT_TRUE(given_back) << name;
  }
}

TEST(CheckProofCost, AcceptingWithoutGmpAllocatesNothing) {
  const Good g = good();
  CheckCost cost;
  const long long before = allocations();
  const Refusal refusal = judge(g.c, g.proof, &cost);
  const long long made = allocations() - before;
  EXPECT_EQ(refusal, Refusal::none);
  EXPECT_EQ(cost.exact_decisions, 0);
  EXPECT_EQ(made, 0);
  EXPECT_GT(allocations(), 0);  // the counter counts
}

}  // namespace
}  // namespace graze::test
