// Proofs with symbolic axes against an independent decision in rationals, or in 2,048 bits: the tightest
// double is accepted, one unit beyond is refused, and so is every form that names no axis.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <iostream>

#include "oracles/checker/check_proof.hpp"
#include "tests/oracles/checker/count_allocations.hpp"
#include "tests/oracles/checker/symbolic_axes.hpp"

namespace graze::test {
namespace {

using corpus::Case;
using oracle::check_proof;
using oracle::CheckCost;
using oracle::Refusal;

constexpr double kInf = kInfinity<double>;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Pose kPoses[] = {Pose::identity, Pose::quarter_turns, Pose::rotated};
constexpr const char* kPoseNames[] = {"identity", "quarter turns", "rotated"};

double up(double x, int units = 1) {
  for (; units > 0; --units) x = std::nextafter(x, kInf);
  return x;
}

double down(double x) { return std::nextafter(x, -kInf); }

Refusal judge(const Case& c, const Proof& proof, CheckCost* cost = nullptr) {
  return check_proof(c, proof, cost).refusal;
}

void report(const std::string& what, const CheckCost& cost, long long refused, long long accepted) {
  std::cout << "[  counts  ] " << what << ": refused " << refused << ", accepted " << accepted
            << "; settled in double " << cost.double_decisions << ", extended " << cost.extended_decisions
            << ", balls " << cost.ball_decisions << ", exact " << cost.exact_decisions << "\n";
}

struct Counts {
  long long refused = 0, accepted = 0;
};

// The claims of one axis: the tightest double, one to four units more, and the axis turned about.
template <class Reference>
void check_axis(const Case& c, const Proof& proof, const Reference& truth, Counts& counts, CheckCost& cost) {
  const auto tight = truth.tightest();
  if (!tight) {
    const Refusal expected = truth.approach < 0 ? Refusal::lower_not_proved : Refusal::axis_not_approaching;
    ASSERT_EQ(judge(c, claiming(proof, 1e-200), &cost), expected);
    return;
  }
  ++counts.accepted;
  const oracle::Verdict verdict = check_proof(c, claiming(proof, *tight), &cost);
  ASSERT_EQ(verdict.refusal, Refusal::none) << verdict.detail;
  for (int units = 1; units <= 4; ++units) {
    const oracle::Verdict beyond = check_proof(c, claiming(proof, up(*tight, units)), &cost);
    ASSERT_EQ(beyond.refusal, Refusal::lower_not_proved) << units << " units";
    ASSERT_FALSE(beyond.detail.empty());
    ++counts.refused;
  }
  ASSERT_EQ(judge(c, flipped(claiming(proof, *tight))), Refusal::axis_not_approaching);
}

// For any shape. n.v is rounded once, so that its sign is right.
HighAxis high_reference(const Case& c, const RationalVec& n) {
  HighAxis truth(c, rounded_high(n));
  truth.approach = High(Rational(inner(n, rational(c.b.displacement) - rational(c.a.displacement))));
  return truth;
}

// The most curved parts on the way to a vertex.
std::size_t most_slots(const Shape<double>& shape) {
  std::size_t most = 0;
  for (const NamedVertex& v : named_vertices(shape)) most = std::max(most, v.slots.size());
  return most;
}

// ---- lower bounds -----------------------------------------------------------------------------------------

TEST(SymbolicLower, TightestDoubleOfTheEnteringFacetAcceptedAndOneUnitMoreRefused) {
  Counts all;
  for (const Pose pose : kPoses) {
    CheckCost cost;
    Counts counts;
    Draw draw(211 + static_cast<std::uint64_t>(pose));
    for (int i = 0; i < 1000; ++i) {
      const auto kind = static_cast<Numbers>(draw.random.below(3));
      Shape<double> a = draw.random.once_in(3) ? Shape<double>(Box<double>{draw.vector(kind, 4).cwiseAbs()})
                                               : Shape<double>(draw.hull(kind, 4, 10));
      const Case c = approaching(draw, kind, pose, std::move(a), draw.hull(kind, 4, 10));
      const auto proof = entering_facet(c);
      if (!proof) continue;
      const RationalVec n = axis_in_rationals(c, *proof);
      if (inner(n, n) == 0) continue;
      check_axis(c, *proof, AxisReference(c, n), counts, cost);
      if (HasFatalFailure()) FAIL() << kPoseNames[static_cast<int>(pose)] << ", case " << i;
    }
    report(std::string("facets, ") + kPoseNames[static_cast<int>(pose)], cost, counts.refused,
           counts.accepted);
    EXPECT_GT(counts.accepted, 600);
    EXPECT_GT(cost.extended_decisions, cost.exact_decisions);
    all.refused += counts.refused;
  }
  EXPECT_GE(all.refused, 10000);
}

TEST(SymbolicLower, AnyTwoFactorsBallsAndTargetDistances) {
  for (const Pose pose : kPoses) {
    CheckCost cost;
    Counts counts;
    Draw draw(221 + static_cast<std::uint64_t>(pose));
    for (int i = 0; i < 700; ++i) {
      const auto kind = static_cast<Numbers>(draw.random.below(3));
      Case c = approaching(draw, kind, pose);
      if (draw.random.once_in(4)) c.target_distance = draw.random.uniform(0, 1);
      const Proof proof = draw_symbolic(draw, c);
      const RationalVec n = axis_in_rationals(c, proof);
      if (inner(n, n) == 0) {
        ASSERT_EQ(judge(c, claiming(proof, 0.5), &cost), Refusal::axis_missing) << "case " << i;
        continue;
      }
      check_axis(c, proof, AxisReference(c, n), counts, cost);
      if (HasFatalFailure()) FAIL() << kPoseNames[static_cast<int>(pose)] << ", case " << i;
    }
    report(std::string("any factors, ") + kPoseNames[static_cast<int>(pose)], cost, counts.refused,
           counts.accepted);
    EXPECT_GT(counts.accepted, 100);
  }
}

TEST(SymbolicLower, EveryShapeAndFeature) {
  long long refused = 0;
  for (int k = 0; k < kKinds; ++k) {
    CheckCost cost;
    Counts counts;
    Draw draw(231 + static_cast<std::uint64_t>(k));
    for (int i = 0; i < 150; ++i) {
      const auto numbers = static_cast<Numbers>(draw.random.below(3));
      const Pose pose = kPoses[i % 3];
      Shape<double> a = draw_kind(draw, static_cast<Kind>(k), numbers, pose);
      Shape<double> b = draw_kind(draw, static_cast<Kind>(draw.random.below(kKinds)), numbers, pose);
      const Case c = approaching(draw, numbers, pose, std::move(a), std::move(b));
      if (most_slots(c.a.shape) > kCurvedParts || most_slots(c.b.shape) > kCurvedParts) continue;
      const Proof proof = draw_symbolic(draw, c);
      const RationalVec n = axis_in_rationals(c, proof);
      if (inner(n, n) == 0) {
        ASSERT_EQ(judge(c, claiming(proof, 0.5)), Refusal::axis_missing);
        continue;
      }
      check_axis(c, proof, high_reference(c, n), counts, cost);
      if (HasFatalFailure()) FAIL() << kKindNames[k] << ", case " << i;
    }
    report(std::string("any factors, ") + kKindNames[k], cost, counts.refused, counts.accepted);
    EXPECT_GT(counts.accepted, 10) << kKindNames[k];
    refused += counts.refused;
  }
  EXPECT_GT(refused, 2000);
}

TEST(SymbolicLower, SweptAndPosedPolytopesByTheirEnteringFacet) {
  CheckCost cost;
  Counts counts;
  Draw draw(241);
  for (int i = 0; i < 300; ++i) {
    const auto kind = static_cast<Numbers>(draw.random.below(3));
    const Pose pose = kPoses[i % 3];
    const Vec3<double> along = draw.vector(kind, 3), aside = draw.vector(kind, 3);
    Shape<double> a = swept<double>(draw.hull(kind, 4, 5), along);
    Shape<double> b = posed<double>(draw.hull(kind, 4, 6), aside, draw.orientation(pose));
    if (draw.random.once_in(2)) std::swap(a, b);
    const Case c = approaching(draw, kind, pose, std::move(a), std::move(b));
    const auto proof = entering_facet(c);
    if (!proof) continue;
    const RationalVec n = axis_in_rationals(c, *proof);
    if (inner(n, n) == 0) continue;
    check_axis(c, *proof, high_reference(c, n), counts, cost);
    if (HasFatalFailure()) FAIL() << "case " << i;
  }
  report("facets, swept and posed", cost, counts.refused, counts.accepted);
  EXPECT_GT(cost.extended_decisions, 10 * (cost.ball_decisions + cost.exact_decisions));
  EXPECT_GT(counts.accepted, 200);
}

// A box turned by (3/5, 4/5) about z: its corners (5, 5, z) and (5, -5, z) stand at (-1, 7, z) and (7, 1, z).
Body<double> turned_box() {
  Body<double> body;
  body.shape = Box<double>{{5, 5, 5}};
  body.orientation = {2, 0, 0, 1};
  return body;
}

TEST(SymbolicLower, AFacetThatNoTripleOfDoublesTouches) {
  // Onto the facet through corners 1 (+, -, -), 3 and 5, whose normal is (3/5, 4/5, 0).
  Case c;
  c.a = turned_box();
  c.b.shape = Point<double>{};
  c.b.position = {20, 4, 0};  // to the middle of the facet, (3, 4, 0): TOI = 17/3
  c.b.displacement = {-3, 0, 0};
  c.t_max = kInf;
  const Proof proof = lower_proof(0, edge_of_a(1, 3), edge_of_a(1, 5));
  const double nearest = 17.0 / 3, tight = Rational(nearest) < Rational(17, 3) ? nearest : down(nearest);
  EXPECT_EQ(judge(c, claiming(proof, tight)), Refusal::none);
  EXPECT_EQ(judge(c, claiming(proof, up(tight))), Refusal::lower_not_proved);
  EXPECT_EQ(judge(c, flipped(claiming(proof, tight))), Refusal::axis_not_approaching);
  c.b.displacement = {-4, 0, 0};  // 17/4 is a double: the bound itself
  EXPECT_EQ(judge(c, claiming(proof, 4.25)), Refusal::none);
  EXPECT_EQ(judge(c, claiming(proof, up(4.25))), Refusal::lower_not_proved);
}

TEST(SymbolicLower, ExtremeMagnitudesAreDecidedExactly) {
  CheckCost cost;
  Counts counts;
  for (const double scale : {0x1p-180, 0x1p180}) {
    for (const Pose pose : {Pose::identity, Pose::rotated}) {
      Draw draw(281);
      for (int i = 0; i < 20; ++i) {
        const Hull<double> a = draw.hull(Numbers::doubles, 6, 6), b = draw.hull(Numbers::doubles, 6, 6);
        Case c = approaching(draw, Numbers::doubles, pose, a, b);
        const auto proof = entering_facet(c);
        if (!proof) continue;
        for (Body<double>* body : {&c.a, &c.b}) {
          std::vector<Vec3<double>> vertices = local_vertices(body->shape);
          for (auto& x : vertices) x *= scale;
          body->shape = Hull<double>(vertices);
          body->position *= scale;
          body->displacement *= scale;
        }
        check_axis(c, *proof, AxisReference(c, axis_in_rationals(c, *proof)), counts, cost);
        if (HasFatalFailure()) FAIL() << scale << ", case " << i;
      }
    }
  }
  report("extreme magnitudes", cost, counts.refused, counts.accepted);
  EXPECT_GT(counts.accepted, 60);
}

// ---- misses -----------------------------------------------------------------------------------------------

TEST(SymbolicMiss, AcrossTheMotionAgreesWithTheReference) {
  CheckCost cost;
  Counts counts;
  long long zeros = 0;
  Draw draw(251);
  for (int i = 0; i < 1500; ++i) {
    const auto kind = static_cast<Numbers>(draw.random.below(3));
    Case c = approaching(draw, kind, kPoses[i % 3], draw.hull(kind, 4, 10));
    if (draw.random.once_in(2)) c.b.displacement = c.a.displacement + draw.vector(kind, 8);
    if (draw.random.once_in(2)) c.t_max = kInf;
    const auto of_a = named_vertices(c.a.shape), of_b = named_vertices(c.b.shape);
    const AxisFactor other = draw_factor(draw, of_a, of_b);
    Proof proof =
        draw.random.once_in(2) ? lower_proof(kInf, motion(), other) : lower_proof(kInf, other, motion());
    const RationalVec n = axis_in_rationals(c, proof);
    const double outward = Rational(inner(n, rational(c.b.position) - rational(c.a.position))).get_d();
    if (outward < 0) proof = flipped(proof);
    const AxisReference truth(c, axis_in_rationals(c, proof));
    const Refusal expected = truth.n_sq == 0             ? Refusal::axis_missing
                             : truth.miss_holds(c.t_max) ? Refusal::none
                                                         : Refusal::miss_not_proved;
    ASSERT_EQ(judge(c, proof, &cost), expected) << "case " << i;
    ++(expected == Refusal::none ? counts.accepted : counts.refused);
    zeros += expected == Refusal::axis_missing ? 1 : 0;
    ASSERT_NE(judge(c, claiming(proof, 0.5)), Refusal::none);  // n.v = 0 bounds no time
  }
  report("misses across the motion", cost, counts.refused, counts.accepted);
  EXPECT_GT(counts.accepted, 200);
  EXPECT_GT(counts.refused, 300);
  EXPECT_LE(cost.exact_decisions, zeros);  // that n.v = 0 costs no arithmetic
}

TEST(SymbolicMiss, AnyFactorsAgreeWithTheReferenceAtTheHorizonToo) {
  CheckCost cost;
  Counts counts;
  Draw draw(261);
  for (int i = 0; i < 1500; ++i) {
    const auto kind = static_cast<Numbers>(draw.random.below(3));
    Case c = approaching(draw, kind, kPoses[i % 3]);
    if (draw.random.once_in(4)) c.target_distance = draw.random.uniform(0, 1);
    const Proof proof = claiming(draw_symbolic(draw, c), kInf);
    const AxisReference truth(c, axis_in_rationals(c, proof));
    if (const auto tight = truth.tightest(); tight && draw.random.once_in(2))
      c.t_max = draw.random.once_in(2) ? *tight : up(*tight);
    const Refusal expected = truth.n_sq == 0             ? Refusal::axis_missing
                             : truth.miss_holds(c.t_max) ? Refusal::none
                                                         : Refusal::miss_not_proved;
    ASSERT_EQ(judge(c, proof, &cost), expected) << "case " << i;
    ++(expected == Refusal::none ? counts.accepted : counts.refused);
  }
  report("misses of any factors", cost, counts.refused, counts.accepted);
  EXPECT_GT(counts.accepted, 100);
  EXPECT_GT(counts.refused, 300);
}

TEST(SymbolicMiss, GrazingIsContactAndOneUnitAsideIsNot) {
  Case c;
  c.a = turned_box();
  c.b.shape = Point<double>{};
  c.b.position = {20, 7, 0};  // along the edge at (-1, 7, z)
  c.b.displacement = {-1, 0, 0};
  c.t_max = kInf;
  // v x z is (0, 1, 0) times a length.
  const Proof proof = lower_proof(kInf, motion(), edge_of_a(3, 7));
  EXPECT_EQ(judge(c, proof), Refusal::miss_not_proved);
  c.b.position.y() = up(7.0);
  EXPECT_EQ(judge(c, proof), Refusal::none);
  EXPECT_EQ(judge(c, flipped(proof)), Refusal::miss_not_proved);
}

TEST(SymbolicMiss, FacesThatTouchInAnyRotationAreContact) {
  // Two hulls of one pose on either side of a plane of their frame, sharing a vertex of it: h(n) = 0.
  Draw draw(271);
  CheckCost cost;
  for (int i = 0; i < 200; ++i) {
    Vec3<double> corner[3], other[3];
    for (Vec3<double>& x : corner) x = draw.vector(Numbers::doubles, 3);
    for (Vec3<double>& x : other) x = draw.vector(Numbers::doubles, 3);
    for (Vec3<double>& x : corner) x.z() = 0;
    for (Vec3<double>& x : other) x.z() = std::abs(x.z()) + 0.125;
    Case c;
    c.a.shape = Hull<double>{corner[0], corner[1], corner[2], {0, 0, -1}};
    c.b.shape = Hull<double>{other[0], other[1], other[2], corner[1]};
    c.a.orientation = c.b.orientation = draw.orientation(kPoses[i % 3]);
    c.a.position = c.b.position = draw.vector(Numbers::doubles, 100);
    const bool counterclockwise = (corner[1] - corner[0]).cross(corner[2] - corner[0]).z() > 0;
    const Proof proof = lower_proof(kInf, edge_of_a(0, 1), edge_of_a(0, 2), counterclockwise ? 1 : -1);
    ASSERT_EQ(judge(c, proof, &cost), Refusal::miss_not_proved) << "case " << i;
    Vec3<double> lifted = corner[1];
    lifted.z() = 0x1p-60;
    c.b.shape = Hull<double>{other[0], other[1], other[2], lifted};
    ASSERT_EQ(judge(c, proof, &cost), Refusal::none) << "case " << i;
    ASSERT_EQ(judge(c, flipped(proof), &cost), Refusal::miss_not_proved) << "case " << i;
    lifted.z() = -0x1p-60;
    c.b.shape = Hull<double>{other[0], other[1], other[2], lifted};
    ASSERT_EQ(judge(c, proof, &cost), Refusal::miss_not_proved) << "case " << i;
  }
  report("touching faces", cost, 600, 200);
}

// ---- validation -------------------------------------------------------------------------------------------

struct Good {
  Case c;
  Proof proof;
};
Good good() {
  Good g;
  g.c.a = turned_box();
  g.c.b.shape = Box<double>{{1, 1, 1}};
  g.c.b.orientation = {3, 1, 0, 0};
  g.c.b.position = {20, 4, 0};
  g.c.b.displacement = {-3, 0, 0};
  g.proof = lower_proof(0.5, edge_of_a(1, 3), edge_of_a(1, 5));
  return g;
}
// The same as a shape of parts.
Good good_of_parts() {
  Good g = good();
  g.c.a.shape = posed<double>(g.c.a.shape, Vec3<double>::Zero(), {});
  return g;
}

template <class Spoil>
void expect_refusal(Refusal expected, const char* what, const Spoil& spoil) {
  for (Good g : {good(), good_of_parts()}) {
    ASSERT_EQ(judge(g.c, g.proof), Refusal::none);
    spoil(g);
    EXPECT_EQ(judge(g.c, g.proof), expected) << what;
  }
}

TEST(SymbolicDoor, MalformedForms) {
  for (const int sign : {0, 2, -2, 1 << 30})
    expect_refusal(Refusal::malformed, "sign", [sign](Good& g) { g.proof.axis_sign = sign; });
  for (std::size_t i = 0; i < 2; ++i) {
    expect_refusal(Refusal::malformed, "kind",
                   [i](Good& g) { g.proof.factor[i].kind = static_cast<AxisFactor::Kind>(3); });
    for (const std::uint32_t k : {8u, ~0u}) {
      expect_refusal(Refusal::malformed, "from.a", [i, k](Good& g) { g.proof.factor[i].from.a.vertex = k; });
      expect_refusal(Refusal::malformed, "from.b", [i, k](Good& g) { g.proof.factor[i].from.b.vertex = k; });
      expect_refusal(Refusal::malformed, "to.a", [i, k](Good& g) { g.proof.factor[i].to.a.vertex = k; });
      expect_refusal(Refusal::malformed, "to.b", [i, k](Good& g) { g.proof.factor[i].to.b.vertex = k; });
    }
    for (const double bad : {kNan, kInf, -kInf}) {
      for (int k = 0; k < 3; ++k) {
        expect_refusal(Refusal::malformed, "given", [=](Good& g) {
          g.proof.factor[i] = given({1, 1, 1});
          g.proof.factor[i].given[k] = bad;
        });
        expect_refusal(Refusal::malformed, "offset",
                       [=](Good& g) { g.proof.factor[i].from.b.offset[k] = bad; });
        expect_refusal(Refusal::malformed, "offset",
                       [=](Good& g) { g.proof.factor[i].to.a.offset[k] = bad; });
        expect_refusal(Refusal::malformed, "curved",
                       [=](Good& g) { g.proof.factor[i].to.b.curved[1][k] = bad; });
      }
    }
  }
}

TEST(SymbolicDoor, AFactorOnMoreCurvedPartsThanAFeatureHoldsIsMalformed) {
  Good g = good();
  const SharedShape<double> cone = share<double>(Cone<double>{1, 1});
  g.c.a.shape = Sum<double>{{cone, cone}};
  Proof proof = lower_proof(0.5, difference(vertices(0, 0), vertices(0, 1)), given({0, 0, 1}));
  proof.factor[0].to.a.curved[1] = {0, 0, 1};
  EXPECT_NE(judge(g.c, proof), Refusal::malformed);
  g.c.a.shape = Sum<double>{{cone, cone, cone}};
  EXPECT_EQ(judge(g.c, proof), Refusal::malformed);
}

TEST(SymbolicDoor, WhatIsNotReadIsNotJudged) {
  expect_refusal(Refusal::none, "axis", [](Good& g) { g.proof.axis = {kNan, kInf, 0}; });
  expect_refusal(Refusal::none, "given of a difference", [](Good& g) { g.proof.factor[0].given.x() = kNan; });
  expect_refusal(Refusal::axis_missing, "no axis", [](Good& g) { g.proof.has_axis = false; });
  expect_refusal(Refusal::axis_missing, "the triple is asked for, and zero",
                 [](Good& g) { g.proof.symbolic = false; });
  expect_refusal(Refusal::none, "nothing is claimed", [](Good& g) {
    g.proof.has_axis = false;
    g.proof.axis_sign = 0;
    g.proof.toi_lower = 0;
  });
}

TEST(SymbolicDoor, ACrossProductThatIsZeroIsNoAxis) {
  const struct {
    const char* what;
    AxisFactor first, second;
  } zeros[] = {
      {"the same edge", edge_of_a(1, 3), edge_of_a(1, 3)},
      {"and backwards", edge_of_a(1, 3), edge_of_a(3, 1)},
      {"parallel edges", edge_of_a(1, 3), edge_of_a(4, 6)},
      {"a vertex", edge_of_a(1, 1), edge_of_a(1, 5)},
      {"parallel edges of B", edge_of_b(0, 2), edge_of_b(5, 7)},
      {"pairs that move alike", edge_of_a(1, 3), difference(vertices(1, 2), vertices(3, 2))},
      {"v and v", motion(), motion()},
      {"v and its triple", motion(), given({-6, 0, 0})},
      {"zero", given({0, 0, 0}), edge_of_a(1, 3)},
  };
  for (const Quaternion<double>& q :
       {Quaternion<double>{2, 0, 0, 1}, Quaternion<double>{0.1, 0.7, -0.3, 0.9}}) {
    for (const auto& zero : zeros) {
      for (const double toi : {0.5, 1e-200, kInf}) {
        for (const int sign : {1, -1}) {
          for (Good g : {good(), good_of_parts()}) {
            g.c.a.orientation = q;
            g.c.b.orientation = {0.3, 0.1, 0.2, q.z};
            const oracle::Verdict verdict = check_proof(g.c, lower_proof(toi, zero.first, zero.second, sign));
            EXPECT_EQ(verdict.refusal, Refusal::axis_missing) << zero.what << ": " << verdict.detail;
          }
        }
      }
    }
  }
  Good still = good();
  still.c.b.displacement.setZero();
  EXPECT_EQ(judge(still.c, lower_proof(kInf, motion(), edge_of_a(1, 3))), Refusal::axis_missing);
}

TEST(SymbolicCost, AcceptingWithoutGmpAllocatesNothing) {
  Good g = good();
  double accepted = 0.5, refused = 10;
  for (int i = 0; i < 200 && up(accepted) < refused; ++i) {
    const double middle = accepted + (refused - accepted) / 2;
    (judge(g.c, claiming(g.proof, middle)) == Refusal::none ? accepted : refused) = middle;
  }
  ASSERT_EQ(up(accepted), refused);
  g.proof.toi_lower = accepted;
  CheckCost cost;
  const long long before = allocations();
  const Refusal refusal = judge(g.c, g.proof, &cost);
  const long long made = allocations() - before;
  EXPECT_EQ(refusal, Refusal::none);
  EXPECT_EQ(cost.extended_decisions, 1);
  EXPECT_EQ(cost.exact_decisions, 0);
  EXPECT_EQ(made, 0);
}

}  // namespace
}  // namespace graze::test
