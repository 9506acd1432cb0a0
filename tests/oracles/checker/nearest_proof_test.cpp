// Nearest axes and portals of cores, by meaning. Pythagorean placements keep every tie exact: the claim at the tie is
// accepted, and refused for the neighbouring double, a radius an ulp away, another foot and another flag.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "oracles/checker/check_proof.hpp"

namespace graze::test {
namespace {

using corpus::Case;
using oracle::Refusal;

constexpr double kInf = kInfinity<double>;

double up(double x) { return std::nextafter(x, kInf); }
double down(double x) { return std::nextafter(x, -kInf); }

Refusal judge(const Case& c, const Proof& proof) { return oracle::check_proof(c, proof).refusal; }

SupportPair pair(std::uint32_t vertex) {
  SupportPair out;
  out.a.vertex = vertex;
  return out;
}

// B, a ball of radius 5, comes to a box of A or to A's point: at t = 1 its centre is at `there`.
Case ball_at(const Vec3<double>& there, const Vec3<double>& v, Shape<double> a = Point<double>{}) {
  Case c;
  c.a.shape = std::move(a);
  c.b.shape = Sphere<double>{5};
  c.b.position = there - v;
  c.b.displacement = v;
  c.t_max = 4;
  return c;
}

const Box<double> kBox{Vec3<double>(1, 1, 1)};

// TOI = 1, from both sides, by the vertices of A.
Proof proof_at_one(std::initializer_list<std::uint32_t> vertices) {
  Proof proof;
  proof.toi_lower = proof.toi_upper = 1;
  proof.has_axis = proof.symbolic = proof.of_cores = true;
  proof.nearest.time = 1;
  for (const std::uint32_t k : vertices) {
    proof.nearest.pair[static_cast<std::size_t>(proof.nearest.size++)] = pair(k);
    proof.portal[static_cast<std::size_t>(proof.portal_size++)] = pair(k);
  }
  return proof;
}

Proof only_lower(Proof proof) {
  proof.toi_upper = kInf;
  proof.portal_size = 0;
  return proof;
}

// The same, A's box as a rounded one, with its share of the radius: shapes that the checker reads as trees.
Case as_tree(Case c) {
  c.a.shape = Rounded<double>{share<double>(Posed<double>{.shape = share<double>(c.a.shape)}), 2};
  c.b.shape = Sphere<double>{2};
  c.target_distance = 1;
  return c;
}

void set_radius(Case& c, double radius) {
  if (c.target_distance > 0) {
    // R = 2 + 2 + m is a double's neighbour only by a step of the last bit of R.
    c.target_distance = 1 + (radius - 5);
  } else {
    std::get<Sphere<double>>(c.b.shape).radius = radius;
  }
}

void expect_tight(const Case& c, const Proof& proof, Refusal raised = Refusal::lower_not_proved) {
  for (const Case& one : {c, as_tree(c)}) {
    const oracle::Verdict verdict = oracle::check_proof(one, proof);
    EXPECT_TRUE(verdict.accepted()) << oracle::to_string(verdict.refusal) << ": " << verdict.detail;
    Proof later = proof, sooner = proof;
    later.toi_lower = up(1);
    sooner.toi_upper = down(1);
    EXPECT_EQ(judge(one, later), raised);
    EXPECT_EQ(judge(one, sooner), Refusal::upper_not_proved);
    Case larger = one, smaller = one;
    set_radius(larger, up(5));
    set_radius(smaller, down(5));
    EXPECT_EQ(judge(larger, proof), Refusal::lower_not_proved);
    EXPECT_EQ(judge(smaller, only_lower(proof)), Refusal::none);
    const Refusal beyond = judge(smaller, proof);
    EXPECT_TRUE(beyond == Refusal::upper_not_proved || beyond == Refusal::portal_off_path)
        << oracle::to_string(beyond);
  }
}

TEST(NearestProof, ContactAtADoubleByAVertexAnEdgeAndAFace) {
  expect_tight(ball_at({3, 4, 0}, {-1, 0, 0}), proof_at_one({0}));
  expect_tight(ball_at({4, 5, 0}, {0, -1, 0}, kBox), proof_at_one({3, 7}));
  expect_tight(ball_at({-0.25, 6, -0.25}, {1, -1, 0.5}, kBox), proof_at_one({2, 3, 6}));
}

TEST(NearestProof, RotatedByAnIntegerQuaternionWithLengthsTimesItsNorm) {
  // |q|^2 = 30. Every length is multiplied by it, so that the rotated placements are integers.
  const Quaternion<double> q{1, 2, 3, 4};
  const Eigen::Quaterniond turn(q.w, q.x, q.y, q.z);
  const Eigen::Matrix3d matrix = (30 * turn.normalized().toRotationMatrix()).array().round();
  Case c = ball_at({4, 5, 0}, {0, -1, 0}, Box<double>{Vec3<double>(30, 30, 30)});
  c.a.orientation = q;
  c.b.position = matrix * c.b.position;
  c.b.displacement = matrix * c.b.displacement;
  std::get<Sphere<double>>(c.b.shape).radius = 150;
  const Proof proof = proof_at_one({3, 7});
  EXPECT_EQ(judge(c, proof), Refusal::none);
  for (const double radius : {up(150), down(150)}) {
    std::get<Sphere<double>>(c.b.shape).radius = radius;
    EXPECT_NE(judge(c, proof), Refusal::none);
  }
}

TEST(NearestProof, AnotherFootAnotherFlagAndAnotherTimeProveLess) {
  const Case c = ball_at({4, 5, 0}, {0, -1, 0}, kBox);
  const Proof good = proof_at_one({3, 7});
  Proof wrong = good;
  wrong.nearest.pair[1] = pair(6);  // a line across the top
  EXPECT_NE(judge(c, wrong), Refusal::none);
  wrong = good;
  wrong.nearest.pair[0] = wrong.portal[0] = pair(1);
  EXPECT_NE(judge(c, only_lower(wrong)), Refusal::none);
  wrong = good;
  wrong.nearest.motion = true;
  EXPECT_EQ(judge(c, wrong), Refusal::axis_not_approaching);
  for (const double time : {up(1), down(1), 0.0, 3.0}) {
    wrong = good;
    wrong.nearest.time = time;
    EXPECT_EQ(judge(c, wrong), Refusal::lower_not_proved) << time;
  }
}

// w = (3, 4, 0) across v: no plane proves a time, until it is tilted.
TEST(NearestProof, AGrazeOfAVertexNeedsATilt) {
  const Case c = ball_at({3, 4, 0}, {4, -3, 0});
  Proof proof = proof_at_one({0});
  proof.nearest.motion = true;
  EXPECT_EQ(judge(c, proof), Refusal::axis_not_approaching);
  proof.then = true;
  proof.factor[0].kind = AxisFactor::Kind::motion;
  expect_tight(c, proof);
  // At the foot's own time, the plane is the same.
  proof.nearest.motion = false;
  expect_tight(c, proof);
}

TEST(NearestProof, AGrazeOfAFaceIsTiltedAcrossTheEdgeThatIsMetFirst) {
  // Over the top along x: it is met at x = -1, between the vertices 2 and 6.
  Case c = ball_at({-1, 6, 0}, {2, 0, 0}, kBox);
  Proof proof = proof_at_one({2, 6});
  proof.nearest.motion = proof.then = true;
  AxisFactor& edge = proof.factor[0];
  edge.kind = AxisFactor::Kind::difference;
  edge.from = pair(6);
  edge.to = pair(2);
  expect_tight(c, proof);
  Proof turned = proof;
  std::swap(turned.factor[0].from, turned.factor[0].to);
  EXPECT_EQ(judge(c, turned), Refusal::axis_not_approaching);
  // Aslant, the corner 2 is met first. -v is then no longer across an edge of the face, and the edge is.
  c = ball_at({-1, 6, -1}, {2, 0, 2}, kBox);
  EXPECT_EQ(judge(c, proof), Refusal::none);
  c = ball_at({-1, 6, 0}, {2, 0, 2}, kBox);
  EXPECT_EQ(judge(c, proof), Refusal::none);
  Proof back = proof;
  back.factor[0].kind = AxisFactor::Kind::motion;
  EXPECT_EQ(judge(c, back), Refusal::lower_not_proved);
}

TEST(NearestProof, AMissByAnUlpOfTheRadius) {
  for (const double t_max : {4.0, kInf}) {
    Case c = ball_at({3, 4, 0}, {4, -3, 0});
    c.t_max = t_max;
    Proof proof = only_lower(proof_at_one({0}));
    proof.toi_lower = kInf;
    proof.nearest.motion = true;
    EXPECT_EQ(judge(c, proof), Refusal::miss_not_proved);
    set_radius(c, down(5));
    EXPECT_EQ(judge(c, proof), Refusal::none);
    // An axis that approaches proves no miss without an end.
    proof.nearest.motion = false;
    proof.nearest.time = 0.5;
    EXPECT_EQ(judge(c, proof), Refusal::miss_not_proved);
  }
}

TEST(NearestProof, StartInContactByUpToFourPairsOfCores) {
  Case c = ball_at({3, 4, 0}, {0, 0, 0});
  Proof proof = proof_at_one({0});
  proof.toi_lower = proof.toi_upper = 0;
  EXPECT_EQ(judge(c, proof), Refusal::none);
  set_radius(c, down(5));
  EXPECT_EQ(judge(c, proof), Refusal::portal_off_path);
  // The origin is inside of the box: no three of its vertices are near enough to a small ball, four are.
  c = ball_at({0, 0, 0}, {0, 0, 0}, Box<double>{Vec3<double>(10, 10, 10)});
  set_radius(c, 0.25);
  proof.portal_size = 4;
  for (std::size_t i = 0; i < 4; ++i) proof.portal[i] = pair(std::array{0u, 3u, 5u, 6u}[i]);
  EXPECT_EQ(judge(c, proof), Refusal::none);
  proof.portal_size = 3;
  EXPECT_EQ(judge(c, proof), Refusal::portal_off_path);
}

TEST(NearestProof, WhatNamesNoAxisOrNoPointOfTheCoresIsRefused) {
  const Case c = ball_at({4, 5, 0}, {0, -1, 0}, kBox);
  const Proof good = proof_at_one({3, 7});
  const auto expect = [&](Refusal refusal, const auto& change) {
    Proof proof = good;
    change(proof);
    EXPECT_EQ(judge(c, proof), refusal);
    EXPECT_EQ(judge(as_tree(c), proof), refusal);
  };
  expect(Refusal::none, [](Proof&) {});
  // n = 0: a line of one point, and a foot at t v itself.
  expect(Refusal::axis_missing, [](Proof& p) { p.nearest.pair[1] = p.nearest.pair[0]; });
  expect(Refusal::axis_missing, [](Proof& p) {
    p.nearest.pair[2] = p.nearest.pair[1];
    p.nearest.size = 3;
  });
  expect(Refusal::malformed, [](Proof& p) { p.nearest.pair[1].a.offset[0] = 1; });
  expect(Refusal::malformed, [](Proof& p) { p.portal[0].b.offset[2] = 0x1p-1000; });
  expect(Refusal::malformed, [](Proof& p) { p.portal[0].b.curved[0][1] = 1; });
  expect(Refusal::malformed, [](Proof& p) { p.nearest.pair[0].a.vertex = 8; });
  expect(Refusal::malformed, [](Proof& p) { p.nearest.size = 4; });
  expect(Refusal::malformed, [](Proof& p) { p.nearest.size = -1; });
  expect(Refusal::malformed, [](Proof& p) { p.nearest.time = kInf; });
  expect(Refusal::malformed, [](Proof& p) {
    p.nearest.size = 3;
    p.nearest.motion = true;
  });
  expect(Refusal::malformed, [](Proof& p) {
    p.then = true;
    p.factor[0].kind = static_cast<AxisFactor::Kind>(7);
  });
  Case curved = c;
  curved.b.shape = Ellipsoid<double>{Vec3<double>(5, 5, 5)};
  EXPECT_EQ(judge(curved, good), Refusal::unsupported);
  curved.b.shape = HullOf<double>{{share<double>(Sphere<double>{5})}};
  EXPECT_EQ(judge(curved, good), Refusal::unsupported);
  // Without the flag the pairs are points of a portal, and those are 5 away from the path.
  expect(Refusal::portal_off_path, [](Proof& p) { p.of_cores = false; });
}

}  // namespace
}  // namespace graze::test
