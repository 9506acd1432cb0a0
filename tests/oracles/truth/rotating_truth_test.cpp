// The oracle of casts of rotating bodies against closed answers in 50 digits, computed here, against sampled
// separating axes, and against the linear oracles. Tests which cases it may leave undecided, and wrong times
// that it must tell from right ones.
#include "oracles/truth/rotating_truth.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "oracles/truth/case_truth.hpp"
#include "oracles/truth/derive.hpp"
#include "tests/oracles/truth/curved_pairs.hpp"
#include "tests/oracles/truth/small_pairs.hpp"

namespace graze::oracle {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using Point3 = std::array<Real, 3>;

constexpr double kInf = kInfinity<double>;
constexpr double kWidth = 1e-12;  // over scale: what the bracket must be within

Real pi() { return acos(Real(-1)); }

// The root of f in [low, high], f(low) > 0 >= f(high).
template <class F>
Real root_of(const F& f, Real low, Real high) {
  for (int i = 0; i < 180; ++i) {
    const Real middle = (low + high) / 2;
    (f(middle) > 0 ? low : high) = middle;
  }
  return low;
}

// A hit at `toi`, where the gap closes at `rate` (length over time): the bracket holds it and is narrow, and
// times that are off by little are told from it.
void expect_hit(const corpus::Case& problem, const Real& toi, double rate) {
  const RotatingTruth truth(problem);
  ASSERT_EQ(truth.outcome(), Outcome::hit) << truth.reason();
  EXPECT_TRUE(truth.contact_proved());
  EXPECT_LE(Real(truth.toi_lower()), toi);
  EXPECT_GE(Real(truth.toi_upper()), toi);
  const double limit = kWidth * truth.scale().low;
  EXPECT_LE(truth.distance_at(truth.toi_lower()).high, limit);
  EXPECT_LE(truth.depth_before(truth.toi_upper()).high, limit);
  const double nearby = limit / rate + 0x1p-52;
  EXPECT_EQ(truth.compare(static_cast<double>(toi) - nearby), -1);
  EXPECT_EQ(truth.compare(static_cast<double>(toi) + nearby), 1);
  EXPECT_EQ(truth.lateness(static_cast<double>(toi) - nearby).high, 0);
  EXPECT_GT(truth.lateness(static_cast<double>(toi) + 16 * nearby).low, 0);
}

// Box [-1, 1]^3 at height `height` over the top face z = 0 of a slab, turning about x.
corpus::Case corner_over_plane(double height, double rate) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(8, 8, 1)};
  problem.a.position = Vec(0, 0, -1);
  problem.b.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.position = Vec(0, 0, height);
  problem.spin_b.rotation = Vec(rate, 0, 0);
  return problem;
}

// An edge's lowest height is height - sqrt(2) sin(pi/4 + |rate| t).
Real corner_contact(double height, double rate) {
  return (asin(Real(height) / sqrt(Real(2))) - pi() / 4) / abs(Real(rate));
}

TEST(RotatingTruth, SpinningCornerMeetsAPlane) {
  for (const double rate : {1.0, -0.7, 0.5, 3.0, 100.0, -5000.0}) {
    for (const double height : {1.0001, 1.3, 1.4, 1.4142}) {
      const Real toi = corner_contact(height, rate);
      if (toi > 1) continue;
      const double speed = std::abs(rate) * std::sqrt(2 - height * height);
      SCOPED_TRACE(testing::Message() << "rate " << rate << " height " << height);
      expect_hit(corner_over_plane(height, rate), toi, speed);
    }
  }
}

TEST(RotatingTruth, DepthsOfACornerInAPlane) {
  const RotatingTruth truth(corner_over_plane(1.3, 2));
  const Real deepest = sqrt(Real(2)) - Real(1.3);
  const Enclosure depth = truth.depth();
  EXPECT_LE(Real(depth.low), deepest);
  EXPECT_GE(Real(depth.high), deepest);
  EXPECT_LE(depth.high, (1 + RotatingTruth::kSlack) * depth.low);
  const double t = 0.25;  // before the edge is lowest, at pi/8
  const Real before = sqrt(Real(2)) * sin(pi() / 4 + 2 * Real(t)) - Real(1.3);
  const Enclosure late = truth.depth_before(t);
  EXPECT_LE(Real(late.low), before);
  EXPECT_GE(Real(late.high), before);
  EXPECT_LE(late.high, (1 + RotatingTruth::kSlack) * late.low);
  EXPECT_EQ(truth.backward_error(t).low, late.low);
  EXPECT_EQ(truth.depth_before(0.1).high, 0);
  const Real apart = Real(1.3) - sqrt(Real(2)) * sin(pi() / 4 + 2 * Real(0.1));
  const Enclosure early = truth.backward_error(0.1);
  EXPECT_LE(Real(early.low), apart);
  EXPECT_GE(Real(early.high), apart);
  EXPECT_LE(early.high - early.low, 1e-12);
  EXPECT_EQ(truth.normal_error(Vec(0, 0, 1)).low, 0);
  EXPECT_LE(truth.normal_error(Vec(0, 0, 1)).high, 1e-11);
  EXPECT_GT(truth.normal_error(Vec(0, 1e-3, 1)).low, 1e-4);
}

// A vertical edge of a box that turns about z, and a ball whose centre lies in the corner's cone then.
TEST(RotatingTruth, SpinningCornerMeetsASphere) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.spin_a.rotation = Vec(0, 0, 1);
  problem.b.shape = Sphere<double>{1.7};
  problem.b.position = Vec(3, 0, 0.25);
  const Real cosine = (2 + 9 - Real(1.7) * Real(1.7)) / (6 * sqrt(Real(2)));
  expect_hit(problem, pi() / 4 - acos(cosine), 0.5);
}

TEST(RotatingTruth, RodAboutItsEndMeetsASphere) {
  for (const double length : {3.0, 1.8}) {  // by its side, and by its end
    corpus::Case problem;
    problem.a.shape = Segment<double>{Vec(0, 0, 0), Vec(length, 0, 0)};
    problem.a.position = Vec(-1, 2, 5);
    problem.spin_a.rotation = Vec(0, 0, 2);
    problem.b.shape = Sphere<double>{0.5};
    problem.b.position = Vec(-1, 4, 5);
    const Real side = pi() / 2 - asin(Real(0.5) / 2);
    const Real end = pi() / 2 - acos((4 + Real(length) * length - Real(0.25)) / (4 * Real(length)));
    expect_hit(problem, (length == 3.0 ? side : end) / 2, 0.5);
  }
}

// The same with the rod's end far from the body's origin: the pivot tells where.
TEST(RotatingTruth, PivotAHundredSizesAway) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(0.5, 0.5, 0.5)};
  problem.a.position = Vec(100, 0, 0);
  problem.spin_a.pivot = Vec(-100, 0, 0);
  problem.spin_a.rotation = Vec(0, 0, 1.5);
  problem.b.shape = Box<double>{Vec(200, 1, 200)};
  problem.b.position = Vec(0, 81, 0);  // its lower face at y = 80
  // Among the edges at (100 +- 1/2, 1/2) the inner one is higher late, the outer one first at small angles.
  const auto gap = [](const Real& t) {
    const Real angle = Real(1.5) * t;
    const Real outer = Real(100.5) * sin(angle) + cos(angle) / 2;
    const Real inner = Real(99.5) * sin(angle) + cos(angle) / 2;
    return 80 - (outer > inner ? outer : inner);
  };
  expect_hit(problem, root_of(gap, 0, 1), 80);
}

// Positions around 1e8 change nothing: they are subtracted exactly.
TEST(RotatingTruth, LargeCommonOffset) {
  corpus::Case problem = corner_over_plane(1.3, 1);
  const Vec offset(0x1p27, -0x1p26, 0x1p28);
  problem.a.position += offset;
  problem.b.position = Vec(0, 0, 1.25) + offset;
  expect_hit(problem, corner_contact(1.25, 1), 0.6);
}

// A ball off its pivot on a helix, and a ball at rest.
TEST(RotatingTruth, ScrewMotion) {
  corpus::Case problem;
  problem.a.shape = Sphere<double>{0.5};
  problem.a.position = Vec(0, -2, 1.5);
  problem.b.shape = Sphere<double>{0.25};
  problem.b.position = Vec(2, 0, 0);
  problem.b.displacement = Vec(0, 0, 3);
  problem.spin_b.pivot = Vec(-2, 0, 0);
  problem.spin_b.rotation = Vec(0, 0, 9.5);
  const auto gap = [](const Real& t) {
    const Real angle = Real(9.5) * t;
    const Real x = 2 * cos(angle), y = 2 * sin(angle) + 2, z = 3 * t - Real(1.5);
    return sqrt(x * x + y * y + z * z) - Real(0.75);
  };
  ASSERT_GT(gap(Real(0.4)), 0);
  ASSERT_LT(gap(Real(0.496)), 0);
  const Real toi = root_of(gap, Real(0.4), Real(0.496));
  expect_hit(problem, toi, 10);
  problem.target_distance = 0.125;
  expect_hit(problem, root_of([&](const Real& t) { return gap(t) - Real(0.125); }, Real(0.4), Real(0.496)),
             10);
}

// Both turn, differently: two balls on circles.
TEST(RotatingTruth, BothBodiesTurn) {
  corpus::Case problem;
  problem.a.shape = Sphere<double>{0.5};
  problem.a.position = Vec(1, 0, 0);
  problem.spin_a.pivot = Vec(-1, 0, 0);
  problem.spin_a.rotation = Vec(0, 0, 6);
  problem.b.shape = Sphere<double>{0.5};
  problem.b.position = Vec(4, 0, 0);
  problem.spin_b.pivot = Vec(-1.5, 0, 0);
  problem.spin_b.rotation = Vec(0, 0, -3.2);
  const auto gap = [](const Real& t) {
    const Real slow = Real(3.2) * t, fast = 6 * t;
    const Real x = Real(2.5) + Real(1.5) * cos(slow) - cos(fast), y = -Real(1.5) * sin(slow) - sin(fast);
    return sqrt(x * x + y * y) - 1;
  };
  Real first = 0;
  while (gap(first) > 0) first += Real(1) / 1024;
  ASSERT_LT(first, 1);
  expect_hit(problem, root_of(gap, first - Real(1) / 1024, first), 4);
}

// Equal angular velocities: in the world the one translates along a circle about the other.
TEST(RotatingTruth, EqualAngularVelocities) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.position = Vec(3.5, 0, 0);
  problem.b.displacement = Vec(-2, 0, 0);
  problem.spin_a.rotation = problem.spin_b.rotation = Vec(0, 0, 0.25);
  // In A's axes B's centre is at R(-w t) (3.5 - 2 t, 0): both are aligned, so the x distance is 2.
  const auto gap = [](const Real& t) { return (Real(3.5) - 2 * t) * cos(t / 4) - 2; };
  expect_hit(problem, root_of(gap, 0, 1), 2);
}

TEST(RotatingTruth, MovingAsOneForAThousandTurns) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.shape = Box<double>{Vec(1, 1, 1)};
  problem.b.position = Vec(2 + 0x1p-30, 0.5, 0);
  problem.spin_b.pivot = -problem.b.position;
  problem.spin_a.rotation = problem.spin_b.rotation = Vec(3000, -4000, 2000);
  problem.a.displacement = problem.b.displacement = Vec(1, 2, 3);
  const RotatingTruth apart(problem);
  EXPECT_EQ(apart.outcome(), Outcome::miss) << apart.reason();
  EXPECT_LE(apart.slices(), 16);
  EXPECT_LE(apart.clearance().low, 0x1p-30);
  EXPECT_GE(apart.clearance().high, 0x1p-30);
  problem.b.position = Vec(2, 0.5, 0);
  problem.spin_b.pivot = -problem.b.position;
  EXPECT_EQ(RotatingTruth(problem).outcome(), Outcome::initially_overlapping);
}

// A turn that cannot be seen: a cylinder about its own axis, a ball about its centre.
TEST(RotatingTruth, UnseenTurnsTakeNoSlices) {
  corpus::Case problem;
  problem.a.shape = Cylinder<double>{1, 1};
  problem.spin_a.rotation = Vec(0, 0, 10000);
  problem.b.shape = Sphere<double>{0.5};
  problem.b.position = Vec(3, 0.25, 0);
  problem.b.displacement = Vec(-4, 0, 0);
  problem.spin_b.rotation = Vec(300, 200, 100);
  const RotatingTruth truth(problem);
  ASSERT_EQ(truth.outcome(), Outcome::hit) << truth.reason();
  EXPECT_LE(truth.slices(), 64);
  expect_hit(problem, (3 - sqrt(Real(2.25) - Real(0.0625))) / 4, 4);
}

// --- An independent judge of two boxes: the greatest gap over the 15 axes, in 50 digits or in double.

template <class N>
struct BoxAt {
  std::array<std::array<N, 3>, 3> axis;  // unit
  std::array<N, 3> center, half;
};

template <class N>
std::array<N, 3> cross_of(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class N>
N dot_of(const std::array<N, 3>& a, const std::array<N, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// x turned by |w| about w.
template <class N>
std::array<N, 3> turned_by(const std::array<N, 3>& w, const std::array<N, 3>& x) {
  using std::cos, std::sin, std::sqrt;
  const N angle = sqrt(dot_of(w, w));
  if (angle == 0) return x;
  const std::array<N, 3> k = {w[0] / angle, w[1] / angle, w[2] / angle}, kx = cross_of(k, x);
  const N c = cos(angle), s = sin(angle), along = dot_of(k, x) * (1 - c);
  return {c * x[0] + s * kx[0] + along * k[0], c * x[1] + s * kx[1] + along * k[1],
          c * x[2] + s * kx[2] + along * k[2]};
}

template <class N>
BoxAt<N> box_at(const Body<double>& body, const corpus::Spin& spin, const N& t) {
  const Vec& half = std::get<Box<double>>(body.shape).half_extents;
  const Quaternion<double>& q = body.orientation;
  const N w = q.w, x = q.x, y = q.y, z = q.z, norm = w * w + x * x + y * y + z * z;
  BoxAt<N> box;
  box.axis = {
      {{(w * w + x * x - y * y - z * z) / norm, 2 * (x * y + w * z) / norm, 2 * (x * z - w * y) / norm},
       {2 * (x * y - w * z) / norm, (w * w - x * x + y * y - z * z) / norm, 2 * (y * z + w * x) / norm},
       {2 * (x * z + w * y) / norm, 2 * (y * z - w * x) / norm, (w * w - x * x - y * y + z * z) / norm}}};
  std::array<N, 3> arm, turn;
  for (std::size_t i = 0; i < 3; ++i) {
    const int k = static_cast<int>(i);
    arm[i] = 0;
    for (std::size_t j = 0; j < 3; ++j) arm[i] += box.axis[j][i] * N(spin.pivot[static_cast<int>(j)]);
    turn[i] = t * N(spin.rotation[k]);
    box.half[i] = half[k];
  }
  const std::array<N, 3> back = turned_by(turn, arm);
  for (std::size_t i = 0; i < 3; ++i) {
    const int k = static_cast<int>(i);
    box.center[i] = N(body.position[k]) + arm[i] + t * N(body.displacement[k]) - back[i];
    box.axis[i] = turned_by(turn, box.axis[i]);
  }
  return box;
}

template <class N>
N gap_of(const corpus::Case& problem, const N& t) {
  using std::abs, std::sqrt;
  const BoxAt<N> a = box_at(problem.a, problem.spin_a, t), b = box_at(problem.b, problem.spin_b, t);
  const std::array<N, 3> between = {b.center[0] - a.center[0], b.center[1] - a.center[1],
                                    b.center[2] - a.center[2]};
  N most = -std::numeric_limits<double>::max();
  const auto consider = [&](const std::array<N, 3>& n) {
    const N length = sqrt(dot_of(n, n));
    if (length < 1e-9) return;
    N gap = abs(dot_of(n, between));
    for (std::size_t i = 0; i < 3; ++i) {
      gap -= a.half[i] * abs(dot_of(n, a.axis[i])) + b.half[i] * abs(dot_of(n, b.axis[i]));
    }
    gap /= length;
    if (gap > most) most = gap;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    consider(a.axis[i]);
    consider(b.axis[i]);
    for (std::size_t j = 0; j < 3; ++j) consider(cross_of(a.axis[i], b.axis[j]));
  }
  return most;
}

// parry #317: apart at both ends, in contact in between. The numbers are floats there.
TEST(RotatingTruth, ContactWithinTheStepOnly) {
  const auto real32 = [](float x) { return static_cast<double>(x); };
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(235, 105, 110)};
  problem.a.position = Vec(real32(6458.7905F), real32(-209.1331F), real32(1014.52124F));
  problem.a.orientation = {real32(-0.542044F), real32(5.3359954e-20F), real32(9.459897e-20F),
                           real32(-0.84035015F)};
  problem.a.displacement = Vec(real32(588.2583F), real32(-553.06335F), real32(471.54688F));
  problem.spin_a.rotation = Vec(0, 0, real32(-1.770823F));
  problem.spin_a.pivot = Vec(real32(99.97085F), real32(-2.2888184e-05F), -35);
  problem.b.shape = Box<double>{Vec(650, 330, 275)};
  problem.b.position = Vec(real32(6079.4917F), real32(-849.3108F), real32(853.8756F));
  problem.b.orientation = {real32(0.99999607F), real32(0.002524775F), real32(-0.00026210435F),
                           real32(-0.0012064485F)};
  const auto gap = [&](const Real& t) { return gap_of<Real>(problem, t); };
  const Real toi = root_of(gap, Real(0.05), Real(0.2));
  EXPECT_NEAR(static_cast<double>(toi), 0.0939335586, 1e-7);
  expect_hit(problem, toi, 500);
  const RotatingTruth truth(problem);
  EXPECT_NEAR(truth.distance_at(0).low, 53.96, 0.01);
  EXPECT_NEAR(truth.distance_at(1).low, 245.7, 0.1);
  EXPECT_LE(truth.depth().low, 92.9);
  EXPECT_GE(truth.depth().high, 92.7);
  // The contact ends: just before it is a depth, just after a distance.
  EXPECT_EQ(truth.distance_at(0.48).low, 0);
  EXPECT_GT(truth.distance_at(0.48004).low, 0);
}

// box2d #115: a rotation by 513 radians, or by a quarter of a radian from 513 on. Never in contact.
TEST(RotatingTruth, FiveHundredRadians) {
  corpus::Case problem;
  problem.a.shape = Box<double>{Vec(25, 5, 1)};
  problem.a.position = Vec(24, -60, 0);
  problem.a.orientation = {std::cos(2.95 / 2), 0, 0, std::sin(2.95 / 2)};
  problem.b.shape = Box<double>{Vec(2.5, 2.5, 1)};
  problem.b.position = Vec(53.474274, -50.252514, 0);
  problem.b.displacement = Vec(54.595478 - 53.474274, -51.083473 + 50.252514, 0);
  problem.b.orientation = {std::cos(513.36676 / 2), 0, 0, std::sin(513.36676 / 2)};
  problem.spin_b.rotation = Vec(0, 0, 513.62781 - 513.36676);
  const RotatingTruth report(problem);
  EXPECT_EQ(report.outcome(), Outcome::miss) << report.reason();
  EXPECT_NEAR(report.distance_at(0).low, 7.829673165, 1e-8);
  EXPECT_NEAR(report.distance_at(1).low, 6.818448788, 1e-8);
  problem.b.orientation = {};
  problem.spin_b.rotation = Vec(0, 0, 513.62781);
  const RotatingTruth whole(problem);
  EXPECT_EQ(whole.outcome(), Outcome::miss) << whole.reason();
  const Enclosure clearance = whole.clearance();
  double least_gap = kInf;  // along the best of the 15 axes: no more than the distance
  for (int i = 0; i <= 20000; ++i) least_gap = std::min(least_gap, gap_of<double>(problem, i / 20000.0));
  EXPECT_GE(clearance.high, least_gap - 1e-9);
  double least_distance = kInf;
  for (int i = 0; i <= 200; ++i) least_distance = std::min(least_distance, whole.distance_at(i / 200.0).high);
  EXPECT_LE(clearance.low, least_distance);
  EXPECT_LE(clearance.high, 1.1 * clearance.low);
}

// An edge of a box rotates over a plane and stays `margin` above it at its lowest, or dips into it. The
// outcome is decided down to the width.
TEST(RotatingTruth, GrazesAreDecidedDownToTheWidth) {
  int hits = 0, misses = 0, open = 0;
  for (int exponent = 1; exponent <= 17; ++exponent) {
    for (const double sign : {1.0, -1.0}) {
      const double height = std::sqrt(2.0) + sign * std::pow(10.0, -exponent);
      const Real margin = Real(height) - sqrt(Real(2));
      const RotatingTruth truth(corner_over_plane(height, 1.5));
      const double limit = kWidth * truth.scale().low;
      if (truth.outcome() == Outcome::not_converged) {
        ++open;
        EXPECT_LT(abs(margin), limit) << truth.reason();
        EXPECT_FALSE(truth.budget_ended());
        EXPECT_LE(truth.clearance().high, limit);
        EXPECT_LE(truth.depth().low, limit);
        continue;
      }
      EXPECT_EQ(truth.outcome(), margin > 0 ? Outcome::miss : Outcome::hit);
      if (margin > 0) {
        ++misses;
        EXPECT_LE(Real(truth.clearance().low), margin);
        EXPECT_GE(Real(truth.clearance().high), margin);
        EXPECT_LE(truth.clearance().high, 1.1 * truth.clearance().low + limit);
      } else {
        ++hits;
        EXPECT_LE(Real(truth.depth().low), -margin);
        EXPECT_GE(Real(truth.depth().high), -margin);
        EXPECT_LE(Real(truth.toi_lower()), corner_contact(height, 1.5));
        EXPECT_GE(Real(truth.toi_upper()), corner_contact(height, 1.5));
      }
    }
  }
  EXPECT_GE(hits, 11);
  EXPECT_GE(misses, 11);
  EXPECT_GE(open, 1);
}

TEST(RotatingTruth, FarFromContactForTenThousandRadians) {
  corpus::Case problem = corner_over_plane(1.75, 1e4);
  const RotatingTruth miss(problem);
  EXPECT_EQ(miss.outcome(), Outcome::miss);
  EXPECT_LE(miss.slices(), 64);  // whole turns at once
  problem.b.position = Vec(0, 0, 2.5);
  problem.b.displacement = Vec(0, 0, -2);  // meets the plane while it spins
  const RotatingTruth hit(problem);
  ASSERT_EQ(hit.outcome(), Outcome::hit) << hit.reason();
  EXPECT_GT(hit.toi_lower(), (2.5 - std::sqrt(2.0)) / 2);
  EXPECT_LT(hit.toi_upper(), (2.5 - std::sqrt(2.0)) / 2 + 1e-3);
}

// Two propellers that turn in step, at right angles, within each other's circles.
TEST(RotatingTruth, PropellersInStep) {
  corpus::Case problem;
  problem.a.shape = problem.b.shape = Box<double>{Vec(1, 0.1, 0.1)};
  problem.b.position = Vec(1.5, 0, 0);
  problem.b.orientation = {1, 0, 0, 1};
  problem.spin_a.rotation = Vec(0, 0, 200);
  problem.spin_b.rotation = Vec(0, 0, -200);
  const RotatingTruth truth(problem);
  double least = kInf;
  for (int i = 0; i <= 20000; ++i) least = std::min(least, gap_of<double>(problem, i / 20000.0));
  ASSERT_GT(least, 0.01);
  EXPECT_EQ(truth.outcome(), Outcome::miss) << truth.reason();
  problem.spin_b.rotation = Vec(0, 0, -190);
  const RotatingTruth out_of_step(problem);
  EXPECT_EQ(out_of_step.outcome(), Outcome::hit) << out_of_step.reason();
}

// Boxes at random: no sampled overlap before toi_lower, contact at toi_upper by the 15 axes.
TEST(RotatingTruth, RandomBoxesAgreeWithSampledAxes) {
  CurvedPairs make(11);
  std::array<int, 5> count = {};
  for (int i = 0; i < 200; ++i) {
    corpus::Case problem = make.pair(Kind::box, Kind::box);
    problem.t_max = 1;
    problem.spin_a.rotation = make.vector(6);
    problem.spin_b.rotation = make.vector(6);
    problem.spin_a.pivot = make.vector(2);
    problem.spin_b.pivot = make.vector(2);
    const RotatingTruth truth(problem);
    ++count[static_cast<std::size_t>(truth.outcome())];
    SCOPED_TRACE(testing::Message() << "pair " << i);
    constexpr double kRounding = 1e-12;
    constexpr int kSamples = 256;
    const double until = std::min(truth.toi_lower(), 1.0);
    for (int k = 0; k < kSamples && truth.toi_upper() > 0; ++k) {
      EXPECT_GT(gap_of<double>(problem, until * k / kSamples), -kRounding);
    }
    if (truth.outcome() == Outcome::initially_overlapping) {
      EXPECT_LE(gap_of<Real>(problem, 0), kRounding);
    } else if (truth.contact_proved()) {
      EXPECT_LE(gap_of<Real>(problem, truth.toi_upper()), kRounding);
      EXPECT_GE(gap_of<Real>(problem, truth.toi_lower()), -kRounding);
    }
    if (truth.outcome() == Outcome::not_converged) {
      EXPECT_LE(truth.depth().low, kWidth * truth.scale().high) << truth.reason();
    }
  }
  EXPECT_GE(count[static_cast<std::size_t>(Outcome::hit)], 30);
  EXPECT_GE(count[static_cast<std::size_t>(Outcome::miss)], 30);
  EXPECT_GE(count[static_cast<std::size_t>(Outcome::initially_overlapping)], 5);
}

// Without a rotation: the same answers as the linear oracles, for every pair of kinds.
void expect_as_linear(const corpus::Case& problem, std::array<int, 5>& count) {
  const RotatingTruth truth(problem);
  const CaseTruth linear(problem);
  ++count[static_cast<std::size_t>(truth.outcome())];
  if (truth.outcome() == Outcome::not_converged) {
    EXPECT_FALSE(truth.budget_ended()) << truth.reason();
    if (truth.contact_proved()) return;
    EXPECT_LE(linear.clearance().low, kWidth * truth.scale().high);
    EXPECT_LE(truth.depth().low, kWidth * truth.scale().high);
    return;
  }
  if (linear.outcome() == Outcome::not_converged) return;
  ASSERT_EQ(truth.outcome(), linear.outcome());
  if (truth.outcome() == Outcome::miss) {
    EXPECT_LE(truth.clearance().low, linear.clearance().high);
    EXPECT_GE(truth.clearance().high, linear.clearance().low);
    return;
  }
  EXPECT_LE(truth.toi_lower(), linear.toi_upper());
  EXPECT_GE(truth.toi_upper(), linear.toi_lower());
}

TEST(RotatingTruth, LinearMotionAgreesWithTheLinearOracles) {
  std::array<int, 5> count = {};
  CurvedPairs make(3);
  for (int a = 0; a < kKinds; ++a) {
    for (int b = 0; b < kKinds; ++b) {
      corpus::Case problem = make.pair(static_cast<Kind>(a), static_cast<Kind>(b));
      if (std::isinf(problem.t_max)) problem.t_max = 1;
      SCOPED_TRACE(testing::Message() << "kinds " << a << ", " << b);
      expect_as_linear(problem, count);
    }
  }
  SmallPairs composed(4);
  for (int i = 0; i < 60; ++i) {
    corpus::Case problem = composed.composed_pair();
    if (std::isinf(problem.t_max)) problem.t_max = 1;
    SCOPED_TRACE(testing::Message() << "composed " << i);
    expect_as_linear(problem, count);
  }
  EXPECT_GE(count[static_cast<std::size_t>(Outcome::hit)], 40);
  EXPECT_GE(count[static_cast<std::size_t>(Outcome::miss)], 40);
  EXPECT_GE(count[static_cast<std::size_t>(Outcome::initially_overlapping)], 10);
}

// Any two shapes at random: where the oracle decides, the width is kept. A body that only slides past is
// undecided.
TEST(RotatingTruth, EveryPairOfShapesKeepsTheWidth) {
  CurvedPairs make(29);
  int hits = 0;
  for (int a = 0; a < kKinds; ++a) {
    for (int b = 0; b < kKinds; ++b) {
      corpus::Case problem = make.pair(static_cast<Kind>(a), static_cast<Kind>(b));
      problem.t_max = 1;
      problem.spin_a.rotation = make.vector(4);
      problem.spin_b.rotation = make.vector(4);
      problem.spin_b.pivot = make.vector(1);
      const RotatingTruth truth(problem);
      SCOPED_TRACE(testing::Message() << "kinds " << a << ", " << b);
      const double limit = kWidth * truth.scale().high;
      if (truth.outcome() == Outcome::not_converged) {
        EXPECT_LE(truth.depth().low, limit) << truth.reason();
        EXPECT_LE(truth.clearance().low, limit);
      }
      if (truth.outcome() != Outcome::hit) continue;
      ++hits;
      EXPECT_LE(truth.distance_at(truth.toi_lower()).low, limit);
      EXPECT_LE(truth.depth_before(truth.toi_upper()).low, limit);
    }
  }
  EXPECT_GE(hits, 25);
}

TEST(RotatingTruth, TheEndOfTheBudgetIsSaid) {
  const RotatingTruth truth(corner_over_plane(1.3, 1), RotatingTruth::kDefaultWidth, 4);
  EXPECT_EQ(truth.outcome(), Outcome::not_converged);
  EXPECT_TRUE(truth.budget_ended());
  EXPECT_FALSE(truth.reason().empty());
  EXPECT_LE(Real(truth.toi_lower()), corner_contact(1.3, 1));
  EXPECT_EQ(truth.toi_upper(), kInf);
  EXPECT_EQ(truth.compare(0.9), 0);
}

TEST(RotatingTruth, WhatIsNoCaseIsRefused) {
  const corpus::Case sound = corner_over_plane(1.3, 1);
  corpus::Case problem = sound;
  problem.t_max = kInf;
  EXPECT_THROW(RotatingTruth{problem}, std::invalid_argument);
  problem = sound;
  problem.start_policy = corpus::StartPolicy::pass_over;
  EXPECT_THROW(RotatingTruth{problem}, std::invalid_argument);
  problem = sound;
  problem.spin_b.rotation[1] = std::nan("");
  EXPECT_THROW(RotatingTruth{problem}, std::invalid_argument);
  problem = sound;
  problem.spin_a.pivot[2] = kInf;
  EXPECT_THROW(RotatingTruth{problem}, std::invalid_argument);
  problem = sound;
  problem.target_distance = -1;
  EXPECT_THROW(RotatingTruth{problem}, std::invalid_argument);
  EXPECT_THROW(RotatingTruth(sound, 1e-17), std::invalid_argument);
}

TEST(RotatingTruth, ExpectationsOfCasesThatTurn) {
  corpus::Case problem = corner_over_plane(1.3, 2);
  const Real toi = corner_contact(1.3, 2);
  const corpus::Expect hit = derive_expectation(problem);
  EXPECT_EQ(hit.by, "time subdivision in balls");
  EXPECT_EQ(hit.outcome, Outcome::hit);
  EXPECT_LE(Real(hit.toi_lower.value()), toi);
  EXPECT_GE(Real(hit.toi_upper.value()), toi);
  EXPECT_LE(hit.toi_upper.value() - hit.toi_lower.value(), 1e-12);
  problem.query = corpus::Query::swept_overlap;
  EXPECT_EQ(derive_expectation(problem).outcome, Outcome::hit);
  problem.query = corpus::Query::distance;
  EXPECT_NEAR(derive_expectation(problem).distance.value(), 0.3, 1e-15);
  problem.query = corpus::Query::line;
  EXPECT_THROW(static_cast<void>(derive_expectation(problem)), Undecided);
  problem.query = corpus::Query::cast;
  problem.t_max = kInf;
  EXPECT_THROW(static_cast<void>(derive_expectation(problem)), Undecided);
  // Two needles that sweep through each other have no depth.
  problem = {};
  problem.a.shape = problem.b.shape = Segment<double>{Vec(-1, 0, 0), Vec(1, 0, 0)};
  problem.b.position = Vec(0, 0.5, 0.25);
  problem.b.displacement = Vec(0, 0, -0.5);
  problem.spin_a.rotation = Vec(0, 0, 3);
  EXPECT_THROW(static_cast<void>(derive_expectation(problem)), Undecided);
}

// A start in contact, a start that touches, and one that only just does not.
TEST(RotatingTruth, Starts) {
  EXPECT_EQ(RotatingTruth(corner_over_plane(0.5, 1)).outcome(), Outcome::initially_overlapping);
  EXPECT_EQ(RotatingTruth(corner_over_plane(1, 1)).outcome(), Outcome::initially_overlapping);
  const RotatingTruth just(corner_over_plane(1 + 0x1p-50, 1));
  EXPECT_EQ(just.outcome(), Outcome::hit);
  EXPECT_EQ(just.toi_lower(), 0);
  EXPECT_EQ(just.compare(1e-6), 1);
  // For curved shapes that touch at t = 0, balls cannot decide. Contact later on is proved.
  corpus::Case curved;
  curved.a.shape = Ellipsoid<double>{Vec(1, 2, 3)};
  curved.spin_a.rotation = Vec(0, 0, 1);
  curved.b.shape = Sphere<double>{1};
  curved.b.position = Vec(2, 0, 0);
  const RotatingTruth open(curved);
  EXPECT_EQ(open.outcome(), Outcome::not_converged);
  EXPECT_TRUE(open.contact_proved());
  EXPECT_EQ(open.toi_lower(), 0);
  EXPECT_LT(open.toi_upper(), 1e-5);
}

}  // namespace
}  // namespace graze::oracle
