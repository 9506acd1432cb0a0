// Contact of flat pairs by crossing: true claims are accepted, and false ones are refused. The truth is known
// in closed form or by volumes in long double whose errors are below 1e-15 here.
//
// Notation   c_i = a_i - b_i;   d = det(c_0, c_1, c_2): on which side of the triangle the origin is.
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <map>

#include "oracles/checker/check_rotating_proof.hpp"
#include "tests/shared/rotating_scenes.hpp"

namespace graze::test {
namespace {

using corpus::Case;
using oracle::check_rotating_proof;
using oracle::RotatingRefusal;
using oracle::RotatingVerdict;
using enum oracle::RotatingRefusal;
using V = Vec3<double>;

constexpr double kTurn = 2 * std::numbers::pi;

struct Names {
  std::uint32_t a, b;
};
using Three = std::array<Names, 3>;
constexpr Three kOfA = {{{0, 0}, {1, 0}, {2, 0}}};

RotatingProof crossing(double from, double to, const Three& pairs = kOfA) {
  RotatingProof proof;
  proof.crossing = true;
  proof.contact_from = from;
  proof.toi_upper = to;
  proof.contact_size = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    proof.contact[i].a.vertex = pairs[i].a;
    proof.contact[i].b.vertex = pairs[i].b;
  }
  return proof;
}

void expect_accepted(const Case& problem, const RotatingProof& proof) {
  const RotatingVerdict verdict = check_rotating_proof(problem, proof);
  EXPECT_TRUE(verdict.accepted()) << to_string(verdict.refusal) << ": " << verdict.detail;
}
void expect_refused(RotatingRefusal why, const Case& problem, const RotatingProof& proof) {
  const RotatingVerdict verdict = check_rotating_proof(problem, proof);
  EXPECT_STREQ(to_string(verdict.refusal), to_string(why)) << verdict.detail;
  EXPECT_FALSE(verdict.detail.empty());
  EXPECT_EQ(verdict.detail.find('\n'), std::string::npos);
}

// An equilateral triangle rotates in its plane, z = 0, with corners at distance 1, one of them on the x axis.
// A point is above it.
Case spinning_triangle(double rate) {
  Case problem;
  const double s = std::sqrt(3) / 2;
  problem.a.shape = Triangle<double>{V(1, 0, 0), V(-0.5, s, 0), V(-0.5, -s, 0)};
  problem.spin_a.rotation = V(0, 0, rate);
  problem.b.shape = Point<double>{};
  return problem;
}

TEST(CrossingProof, PointThatFallsThroughASpinningTriangle) {
  for (const double rate : {0.0, 3.0, -40.0, 513.0}) {
    Case problem = spinning_triangle(rate);
    problem.b.position = V(0.25, 0.125, 1);  // never as far from the axis as the edges, at 1/2
    problem.b.displacement = V(0, 0, -2);
    expect_accepted(problem, crossing(0.25, 0.75));
    expect_accepted(problem, crossing(0.5 - 1e-12, 0.5 + 1e-15));
    expect_refused(crossing_not_proved, problem, crossing(0.125, 0.5 - 1e-15));
    expect_refused(crossing_not_proved, problem, crossing(0.5 + 1e-15, 0.75));
    expect_refused(upper_beyond_end, problem, crossing(0.25, 1.5));
    problem.target_distance = 0.01;
    expect_accepted(problem, crossing(0.25, 0.75));
    problem.a.shape = rounded<double>(problem.a.shape, 0.01);
    expect_accepted(problem, crossing(0.25, 0.75));
    problem.b.position[0] = 2;  // far beside
    expect_refused(crossing_not_proved, problem, crossing(0.25, 0.75));
  }
}

TEST(CrossingProof, TouchingAtAnEndIsContactAndDecidedWhereNothingTurns) {
  Case problem;
  problem.a.shape = Triangle<double>{V(1, 0, 0), V(-1, 1, 0), V(-1, -1, 0)};
  problem.b.shape = Point<double>{};
  problem.b.position = V(0, 0, 1);
  problem.b.displacement = V(0, 0, -2);
  expect_accepted(problem, crossing(0, 0.5));
  expect_accepted(problem, crossing(0.5, 1));
  expect_refused(crossing_not_proved, problem, crossing(0, std::nextafter(0.5, 0)));
  expect_refused(crossing_not_proved, problem, crossing(std::nextafter(0.5, 1), 1));
  // Through a corner, and through an edge: the origin is not strictly inside.
  problem.b.position = V(1, 0, 1);
  expect_refused(crossing_not_proved, problem, crossing(0.25, 0.75));
  problem.b.position = V(-1, 0.25, 1);
  expect_refused(crossing_not_proved, problem, crossing(0.25, 0.75));
}

TEST(CrossingProof, NeedsThreePairsAndAnEarlierTime) {
  Case problem = spinning_triangle(3);
  problem.b.position = V(0.25, 0.125, 1);
  problem.b.displacement = V(0, 0, -2);
  const auto edited = [](auto edit) {
    RotatingProof proof = crossing(0.25, 0.75);
    edit(proof);
    return proof;
  };
  using P = RotatingProof;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(malformed, problem, edited([](P& p) { p.contact_from = kNan; }));
  expect_refused(malformed, problem, edited([](P& p) { p.contact_from = -0.25; }));
  expect_refused(malformed, problem, edited([](P& p) { p.contact_from = 0.75; }));
  expect_refused(malformed, problem, edited([](P& p) { p.contact_from = kInfinity<double>; }));
  expect_refused(malformed, problem, edited([](P& p) { p.toi_upper = kNan; }));
  for (const int size : {0, 1, 2, 4})
    expect_refused(malformed, problem, edited([&](P& p) { p.contact_size = size; }));
  expect_refused(malformed, problem, edited([](P& p) { p.contact[2].a.vertex = 3; }));
  expect_refused(malformed, problem, edited([](P& p) { p.contact[0].b.offset = V(0, 0, 1); }));
  // The weights are not read.
  expect_accepted(problem, edited([](P& p) { p.weight = {kNan, -1, 0, 0}; }));
  // It is not a crossing unless it says so.
  expect_refused(weights_missing, problem, edited([](P& p) { p.crossing = false; }));
  // A pair twice.
  EXPECT_FALSE(check_rotating_proof(problem, crossing(0.25, 0.75, {{{0, 0}, {1, 0}, {1, 0}}})).accepted());
}

TEST(CrossingProof, CurvedPointsMustLieInTheirShapes) {
  // Three points of a cylinder's upper rim.
  Case problem = spinning_triangle(7);
  problem.a.shape = Cylinder<double>{1, 0};
  problem.b.position = V(0.25, 0, 1);
  problem.b.displacement = V(0, 0, -2);
  RotatingProof proof = crossing(0.4375, 0.5625, {{{0, 0}, {0, 0}, {0, 0}}});
  proof.contact[0].a.curved[0] = V(1, 0, 0);
  proof.contact[1].a.curved[0] = V(-0.6, 0.8, 0);
  proof.contact[2].a.curved[0] = V(-0.6, -0.8, 0);
  const RotatingVerdict on_the_rim = check_rotating_proof(problem, proof);
  // 0.6 and 0.8 are rounded: inside or outside of the rim by 1e-17.
  EXPECT_TRUE(on_the_rim.accepted() || on_the_rim.refusal == point_outside) << on_the_rim.detail;
  for (std::size_t i = 0; i < 3; ++i) proof.contact[i].a.curved[0] *= 0.99;
  expect_accepted(problem, proof);
  proof.contact[1].a.curved[0] = V(-0.6, 0.9, 0);
  expect_refused(point_outside, problem, proof);
}

// A point goes round the edge x = 0 of a triangle that ends there: from above it, inside, to below it,
// inside, by the outside. Every end looks like that of a crossing, but there is no contact.
TEST(CrossingProof, AroundTheEdgeIsNotThroughTheTriangle) {
  Draw draw(11);
  for (int round = 0; round < 200; ++round) {
    Case problem;
    problem.a.shape = Triangle<double>{V(0, 1, 0), V(0, -1, 0), V(-2, 0, 0)};
    problem.b.shape = Point<double>{};
    const double radius = std::pow(10, draw.between(-9, -0.7));
    problem.b.position = V(-radius, 0, 0);  // in contact, and t counts from there
    problem.spin_b.pivot = V(radius, 0, 0);
    problem.spin_b.rotation = V(0, draw.below(2) == 0 ? kTurn : -kTurn, 0);
    const double from = draw.between(0.01, 0.24), to = draw.between(0.76, 0.99);
    expect_refused(crossing_not_proved, problem, crossing(from, to));
    // The same path, farther: through the triangle at t = 1.
    problem.t_max = 2;
    expect_accepted(problem, crossing(to, 1 + from));
    expect_refused(crossing_not_proved, problem, crossing(from, 1 + from));
    expect_refused(crossing_not_proved, problem, crossing(to - 1 + 0.25, 1 + from));
  }
}

// An equilateral triangle that spins several times while the point falls between its inner and outer circles:
// the point is inside while  r cos(60 degrees - |angle from the nearest corner|) < 1/2.
TEST(CrossingProof, InsideAtBothEndsAndBesideAtTheCrossing) {
  Draw draw(12);
  int through = 0, beside = 0, in_and_out = 0;
  while (through < 100 || beside < 100 || in_and_out < 100) {
    const double rate = draw.between(20, 200), r = draw.between(0.55, 0.95);
    const auto margin = [&](double t) {
      const double angle = std::remainder(-rate * t, kTurn / 3);
      return 0.5 - r * std::cos(kTurn / 6 - std::abs(angle));
    };
    Case problem = spinning_triangle(rate);
    problem.b.position = V(r, 0, 0.5);
    problem.b.displacement = V(0, 0, -1);
    const double from = 0.5 - draw.between(0, 0.1), to = 0.5 + draw.between(0, 0.1);
    if (margin(from) < 1e-6 || margin(to) < 1e-6) continue;
    if (margin(0.5) < -1e-6) {
      ++beside;
      expect_refused(crossing_not_proved, problem, crossing(from, to));
      continue;
    }
    // Inside all the time iff within one stay of it: then the ends are in the same third of a turn.
    const auto third = [&](double t) { return std::round(rate * t / (kTurn / 3)); };
    if (third(from) == third(to)) {
      ++through;
      expect_accepted(problem, crossing(from, to));
    } else {
      ++in_and_out;
      expect_refused(crossing_not_proved, problem, crossing(from, to));
    }
  }
}

// A point on an arm comes down to height h over a triangle that spins under it, at half a turn, and goes up.
TEST(CrossingProof, TurnsBackBeforeThePlane) {
  Draw draw(13);
  for (int round = 0; round < 200; ++round) {
    Case problem = spinning_triangle(draw.between(-9, 9));
    const double depth = std::pow(10, draw.between(-12, -2)), height = draw.below(2) == 0 ? depth : -depth;
    problem.spin_b.rotation = V(0, kTurn, 0);
    problem.spin_b.pivot = V(0, 0, -0.25);
    problem.b.position = V(0, 0, height + 0.5);  // its pivot is at height + 0.25
    const double way = draw.between(0.01, 0.2);
    if (height > 0) {
      expect_refused(crossing_not_proved, problem, crossing(0.5 - way, 0.5));
      expect_refused(crossing_not_proved, problem, crossing(0.5 - way, 0.5 + way));
    } else {
      // Through it, and back: a crossing each way, and none of both together.
      const double out = std::acos((0.25 + height) / 0.25) / kTurn;  // from the lowest point to the plane
      if (out >= way) continue;
      expect_accepted(problem, crossing(0.5 - way, 0.5));
      expect_accepted(problem, crossing(0.5, 0.5 + way));
      expect_refused(crossing_not_proved, problem, crossing(0.5 - way, 0.5 + way));
      expect_refused(crossing_not_proved, problem, crossing(0.5 - out / 2, 0.5 + out / 3));
    }
  }
}

// ---- drawn pairs, both turning ----------------------------------------------------------------------------

struct Drawn {
  Case problem;
  Three pairs;
  double at = 0;  // up to rounding, the triangle of the pairs holds the origin at the weights
  std::array<Long, 3> weight;

  [[nodiscard]] std::array<LongVec, 3> corners(Long t, const Three& named) const {
    const Mover a(problem.a, problem.spin_a), b(problem.b, problem.spin_b);
    std::array<LongVec, 3> c;
    for (std::size_t i = 0; i < 3; ++i) c[i] = a.place(named[i].a, t) - b.place(named[i].b, t);
    return c;
  }
  [[nodiscard]] Long side(Long t, const Three& named) const {
    const auto c = corners(t, named);
    return c[0].dot(c[1].cross(c[2]));
  }
  [[nodiscard]] Long side(Long t) const { return side(t, pairs); }
  // The least of n.(c_i x c_j) over |n|^2, the weights of the origin's foot: at sampled times, n the normal
  // in the middle.
  [[nodiscard]] Long least_weight(Long from, Long to) const {
    const auto normal = [&](Long t) {
      const auto c = corners(t, pairs);
      return LongVec((c[1] - c[0]).cross(c[2] - c[0]));
    };
    const LongVec n = normal((from + to) / 2);
    Long least = kNever;
    for (int k = 0; k <= 64; ++k) {
      const auto c = corners(from + (to - from) * k / 64, pairs);
      for (std::size_t i = 0; i < 3; ++i)
        least = std::min(least, n.dot(c[(i + 1) % 3].cross(c[(i + 2) % 3])) / n.squaredNorm());
    }
    return least;
  }
};

Shape<double> flat_or_not(Draw& draw, std::size_t kind) {
  switch (kind) {
    case 0:
      return Point<double>{};
    case 1:
      return Segment<double>{draw.vector(1), draw.vector(1)};
    case 2:
      return Triangle<double>{draw.vector(1), draw.vector(1), draw.vector(1)};
    case 3:
      return rounded<double>(Segment<double>{draw.vector(1), draw.vector(1)}, 1e-3);
    default:
      return Box<double>{V(draw.between(0.2, 1), draw.between(0.2, 1), draw.between(0.2, 1))};
  }
}

// Both bodies rotate and move. B is placed so that a point of the triangle of three drawn pairs is the origin
// at `at`.
Drawn draw_crossing(Draw& draw) {
  constexpr std::array<std::uint32_t, 5> kVertices = {1, 2, 3, 2, 8};
  for (;;) {
    Drawn out;
    Case& c = out.problem;
    const std::size_t kind_a = draw.below(5), kind_b = draw.below(5);
    if (kVertices[kind_a] * kVertices[kind_b] < 3) continue;
    c.a.shape = flat_or_not(draw, kind_a);
    c.b.shape = flat_or_not(draw, kind_b);
    for (Body<double>* body : {&c.a, &c.b}) {
      body->position = draw.vector(2);
      body->displacement = draw.vector(2);
    }
    for (corpus::Spin* spin : {&c.spin_a, &c.spin_b}) {
      spin->rotation = draw.vector(5);
      spin->pivot = draw.vector(0.5);
    }
    if (draw.below(3) == 0) c.target_distance = draw.between(0, 0.1);
    for (Names& pair : out.pairs)
      pair = {static_cast<std::uint32_t>(draw.below(kVertices[kind_a])),
              static_cast<std::uint32_t>(draw.below(kVertices[kind_b]))};
    const double p = draw.between(0.1, 0.8), q = draw.between(0.1, 0.9 - p);
    out.weight = {p, q, 1 - Long(p) - Long(q)};
    out.at = draw.between(0.1, 0.9);
    const auto corner = out.corners(out.at, out.pairs);
    const LongVec point = out.weight[0] * corner[0] + out.weight[1] * corner[1] + out.weight[2] * corner[2];
    c.b.position += point.cast<double>();
    if ((corner[1] - corner[0]).cross(corner[2] - corner[0]).norm() < 0.2L) continue;
    return out;
  }
}

constexpr Long kSure = 1e-12L;

bool one_side(Long first, Long last) {
  return std::min(first, last) > kSure || std::max(first, last) < -kSure;
}
bool two_sides(Long first, Long last) {
  return std::min(first, last) < -kSure && std::max(first, last) > kSure;
}

TEST(CrossingProof, DrawnPairsThatCross) {
  Draw draw(21);
  int accepted = 0;
  std::map<std::size_t, int> kinds;
  while (accepted < 1000) {
    const Drawn drawn = draw_crossing(draw);
    const double width = std::pow(10, draw.between(-10, -1));
    const double from = drawn.at - draw.between(0, width), to = drawn.at + draw.between(0, width);
    if (from < 0 || to > 1 || !two_sides(drawn.side(from), drawn.side(to)) ||
        drawn.least_weight(from, to) < 0.01L)
      continue;
    expect_accepted(drawn.problem, crossing(from, to, drawn.pairs));
    ++accepted;
    ++kinds[5 * drawn.problem.a.shape.index() + drawn.problem.b.shape.index()];
  }
  EXPECT_GT(kinds.size(), 15U);
}

TEST(CrossingProof, DrawnPairsWithATimeThatIsWrong) {
  Draw draw(22);
  int before = 0, after = 0;
  while (before < 300 || after < 300) {
    const Drawn drawn = draw_crossing(draw);
    const double near = std::pow(10, draw.between(-10, -2)), far = near + std::pow(10, draw.between(-10, -2));
    if (one_side(drawn.side(drawn.at - far), drawn.side(drawn.at - near))) {
      ++before;
      expect_refused(crossing_not_proved, drawn.problem,
                     crossing(drawn.at - far, drawn.at - near, drawn.pairs));
    }
    if (one_side(drawn.side(drawn.at + near), drawn.side(drawn.at + far))) {
      ++after;
      expect_refused(crossing_not_proved, drawn.problem,
                     crossing(drawn.at + near, drawn.at + far, drawn.pairs));
    }
  }
}

// B is moved within the triangle's plane at that time: the line that the origin then is off is its plane's.
TEST(CrossingProof, DrawnPairsThatPassBeside) {
  Draw draw(23);
  int beside = 0;
  while (beside < 600) {
    Drawn drawn = draw_crossing(draw);
    const auto c = drawn.corners(drawn.at, drawn.pairs);
    // From the corner of the least weight beyond the opposite edge: that weight becomes -out.
    const auto least = static_cast<std::size_t>(std::min_element(drawn.weight.begin(), drawn.weight.end()) -
                                                drawn.weight.begin());
    const Long out = std::pow(10.0L, Long(draw.between(-9, -0.5)));
    const LongVec edge = (c[(least + 1) % 3] + c[(least + 2) % 3]) / 2;
    const LongVec by = (drawn.weight[least] + out) * (edge - c[least]);
    drawn.problem.b.position += by.cast<double>();  // the point of C at the origin moves by -by
    const double away = static_cast<double>(out / 1e3L), from = drawn.at - away, to = drawn.at + away;
    if (!two_sides(drawn.side(from), drawn.side(to))) continue;
    ++beside;
    expect_refused(crossing_not_proved, drawn.problem, crossing(from, to, drawn.pairs));
  }
}

TEST(CrossingProof, DrawnPairsOfWhichOneIsAnother) {
  constexpr std::array<std::uint32_t, 5> kVertices = {1, 2, 3, 2, 8};
  const auto vertices = [&](const Shape<double>& shape) {
    return std::holds_alternative<Point<double>>(shape)      ? kVertices[0]
           : std::holds_alternative<Triangle<double>>(shape) ? kVertices[2]
           : std::holds_alternative<Box<double>>(shape)      ? kVertices[4]
                                                             : kVertices[1];
  };
  Draw draw(24);
  int others = 0;
  while (others < 600) {
    const Drawn drawn = draw_crossing(draw);
    Three pairs = drawn.pairs;
    Names& one = pairs[draw.below(3)];
    one = {static_cast<std::uint32_t>(draw.below(vertices(drawn.problem.a.shape))),
           static_cast<std::uint32_t>(draw.below(vertices(drawn.problem.b.shape)))};
    const double width = std::pow(10, draw.between(-9, -2));
    const double from = drawn.at - width, to = drawn.at + width;
    if (!two_sides(drawn.side(from), drawn.side(to)) ||
        !one_side(drawn.side(from, pairs), drawn.side(to, pairs)))
      continue;
    ++others;
    expect_refused(crossing_not_proved, drawn.problem, crossing(from, to, pairs));
  }
}

}  // namespace
}  // namespace graze::test
