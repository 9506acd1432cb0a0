// The exact tier against the exact oracle where ties are the rule and where numbers are at the ends of their
// range: equal verdicts and equal brackets, to the last bit.
#include <gtest/gtest.h>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/swept_overlap.hpp>

#include <graze/cast.hpp>
#include <graze/invalid_text.hpp>
#include <map>

#include "corpus/format/case_io.hpp"
#include "corpus/random.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/truth/linear_truth.hpp"

namespace graze {
namespace {

using corpus::Case;
using corpus::Random;

template <Scalar S>
CastOptions<S> exact_options(const Case& problem, Request request = Request::everything) {
  CastOptions<S> options;
  options.tier = Tier::exact;
  options.request = request;
  options.t_max = static_cast<S>(problem.t_max);
  options.start_policy = problem.start_policy;
  return options;
}

CastResult<double> cast_exactly(const Case& problem, Request request = Request::everything) {
  return cast(problem.a, problem.b, exact_options<double>(problem, request));
}

std::string difference(const CastResult<double>& result, const oracle::LinearTruth& truth) {
  if (result.outcome != truth.outcome()) {
    return "outcome " + std::to_string(int(result.outcome)) + ", not " + std::to_string(int(truth.outcome()));
  }
  if (result.outcome != Outcome::hit ||
      (result.toi_lower == truth.toi_lower() && result.toi_upper == truth.toi_upper())) {
    return "";
  }
  char text[200];
  std::snprintf(text, sizeof text, "[%a, %a], not [%a, %a]", result.toi_lower, result.toi_upper,
                truth.toi_lower(), truth.toi_upper());
  return text;
}

// Cast, its proof, and the three other queries. The outcome, or invalid_input where something is wrong.
Outcome expect_exact(const Case& problem) {
  const oracle::LinearTruth truth(problem);
  const CastResult<double> result = cast_exactly(problem);
  const std::string fault = difference(result, truth);
  EXPECT_EQ(fault, "") << corpus::write_case(problem);
  if (!fault.empty()) return Outcome::invalid_input;
  Case question = problem;
  question.start_policy = StartPolicy::report;
  EXPECT_EQ(result.proof.has_value(), !result.passed_over);
  if (result.proof) {
    const oracle::Verdict verdict = oracle::check_proof(question, *result.proof);
    EXPECT_TRUE(verdict.accepted()) << to_string(verdict.refusal) << ": " << verdict.detail << "\n"
                                    << corpus::write_case(problem);
  }
  const oracle::LinearTruth reported(question);
  SweptOverlapOptions<double> swept;
  swept.t_max = problem.t_max;
  EXPECT_EQ(swept_overlap_exact(problem.a, problem.b, swept).outcome,
            reported.outcome() == Outcome::miss ? Outcome::miss : Outcome::hit)
      << corpus::write_case(problem);
  EXPECT_EQ(overlap_exact(problem.a, problem.b).outcome, reported.outcome() == Outcome::initially_overlapping
                                                             ? Outcome::initially_overlapping
                                                             : Outcome::miss)
      << corpus::write_case(problem);
  const LineResult<double> line = line_exact(problem.a, problem.b);
  const std::optional<oracle::ContactInterval> interval = reported.contact_interval();
  EXPECT_EQ(line.outcome, interval ? Outcome::hit : Outcome::miss) << corpus::write_case(problem);
  if (interval && line.outcome == Outcome::hit) {
    EXPECT_EQ(line.in_lower, interval->in.low) << corpus::write_case(problem);
    EXPECT_EQ(line.in_upper, interval->in.high) << corpus::write_case(problem);
    EXPECT_EQ(line.out_lower, interval->out.low) << corpus::write_case(problem);
    EXPECT_EQ(line.out_upper, interval->out.high) << corpus::write_case(problem);
  }
  return result.outcome;
}

// Integers from -2 to 2: nearly every decision is a tie.
class Lattice {
 public:
  explicit Lattice(std::uint64_t seed) : random(seed) {}
  Random random;

  Vec3<double> point(int reach = 2) {
    const double x = random.integer(-reach, reach), y = random.integer(-reach, reach);
    return {x, y, static_cast<double>(random.integer(-reach, reach))};
  }
  Shape<double> shape() {
    switch (random.below(8)) {
      case 0:
        return Point<double>{};
      case 1: {
        const Vec3<double> a = point();
        return Segment<double>{a, random.once_in(6) ? a : point()};
      }
      case 2: {
        const Vec3<double> a = point(), b = point();
        return Triangle<double>{a, b, random.once_in(4) ? Vec3<double>(2 * b - a) : point()};
      }
      case 3:
      case 4:
        return Box<double>{point().cwiseAbs()};
      default:
        break;
    }
    // Flat and collinear sets, and duplicates, occur by themselves. The plane adds more of them.
    std::vector<Vec3<double>> vertices(1 + random.below(9));
    for (Vec3<double>& v : vertices) v = point();
    const int flat = random.integer(0, 5);
    for (Vec3<double>& v : vertices) {
      if (flat < 3) v[flat] = 1;
      if (random.once_in(8)) v = vertices.front();
    }
    return Hull<double>(std::span<const Vec3<double>>(vertices));
  }
  Case pair() {
    Case problem;
    problem.a.shape = shape();
    problem.b.shape = shape();
    problem.a.position = point(1);
    problem.b.position = point(3);
    problem.a.displacement = random.once_in(2) ? Vec3<double>(Vec3<double>::Zero()) : point();
    problem.b.displacement = point(4);
    if (random.once_in(3)) {
      // A quarter turn or another symmetry of the lattice, or a turn off it.
      problem.b.orientation = {double(random.integer(0, 1)), double(random.integer(0, 1)),
                               double(random.integer(0, 1)), 1.0};
    }
    constexpr double kEnds[] = {0, 0.25, 0.5, 1, 1, 2, 3};
    problem.t_max = random.once_in(8) ? kInfinity<double> : kEnds[random.below(std::size(kEnds))];
    if (random.once_in(3)) problem.start_policy = StartPolicy::pass_over;
    return problem;
  }
};

TEST(ExactTier, LatticesAreAllTies) {
  Lattice lattice(20260401);
  std::map<Outcome, int> seen;
  int decisions = 0, passed = 0;
  for (int i = 0; i < 20000 && !HasFailure(); ++i) {
    const Case problem = lattice.pair();
    ++seen[expect_exact(problem)];
    const CastResult<double> result = cast_exactly(problem, Request::verdict);
    decisions += result.counters.exact_decisions;
    passed += result.passed_over;
  }
  for (const Outcome outcome : {Outcome::hit, Outcome::miss, Outcome::initially_overlapping})
    EXPECT_GT(seen[outcome], 1000);
  EXPECT_GT(passed, 300);
  EXPECT_GT(decisions, 0);  // ties that no filter decides
}

// Every pair of vectors with components -1, 0, 1 for the place and the motion of B: 729 paths of a pair.
TEST(ExactTier, EveryPathOfTheSmallestLattice) {
  const Shape<double> shapes[] = {Point<double>{}, Segment<double>{{-1, 0, 0}, {1, 0, 0}},
                                  Triangle<double>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                  Box<double>{{0.5, 0.5, 0.5}}, Box<double>{{1, 0, 0.5}}};
  const auto unit = [](int code) { return Vec3<double>(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1); };
  for (const Shape<double>& a : shapes) {
    for (const Shape<double>& b : shapes) {
      for (int place = 0; place < 27; ++place) {
        for (int motion = 0; motion < 27 && !HasFailure(); ++motion) {
          Case problem;
          problem.a.shape = a;
          problem.b.shape = b;
          problem.b.position = 2 * unit(place);
          problem.b.displacement = unit(motion);
          problem.t_max = motion % 2 == 0 ? 2 : 1;
          problem.start_policy = place % 2 == 0 ? StartPolicy::pass_over : StartPolicy::report;
          expect_exact(problem);
        }
      }
    }
  }
}

// The end of the path at the TOI's own double, at its neighbours, at 0 and at infinity.
TEST(ExactTier, TheHorizonIsExact) {
  Lattice lattice(20260402);
  int hits = 0, equal = 0;
  while (hits < 1500 && !HasFailure()) {
    Case problem = lattice.pair();
    problem.start_policy = StartPolicy::report;
    problem.t_max = kInfinity<double>;
    if (hits % 2 == 1) problem.b.position += Vec3<double>(0.1, 0.2, 0.3);
    const oracle::LinearTruth truth(problem);
    if (truth.outcome() != Outcome::hit) continue;
    ++hits;
    const double lower = truth.toi_lower(), upper = truth.toi_upper();
    equal += lower == upper;
    for (const double end : {upper, lower, std::nextafter(lower, 0.0), std::nextafter(upper, 1e300), 0.0}) {
      problem.t_max = end;
      const Outcome expected = end >= upper ? Outcome::hit : Outcome::miss;
      const CastResult<double> result = cast_exactly(problem);
      EXPECT_EQ(result.outcome, expected) << corpus::write_case(problem);
      expect_exact(problem);
    }
  }
  EXPECT_GT(equal, 100);
}

Case cube_on_cube() {
  Case problem;
  problem.a.shape = Box<double>{{1, 1, 1}};
  problem.b.shape = Box<double>{{1, 1, 1}};
  return problem;
}

TEST(ExactTier, StartsInContactUnderBothPolicies) {
  struct Start {
    Vec3<double> place, motion;
    bool leaves_or_slides;
  };
  const Start starts[] = {
      {{2, 0, 0}, {1, 0, 0}, true},        // leaves
      {{2, 0, 0}, {0, 1, 0}, true},        // slides along a face
      {{2, 0, 0}, {-1, 0, 0}, false},      // enters
      {{2, 0, 0}, {-1e-60, 1, 0}, false},  // enters by next to nothing
      {{2, 2, 0}, {-1, 1, 0}, true},       // at an edge: leaves in y
      {{2, 2, 0}, {-1, 0, 0}, true},       // at an edge: slides in y
      {{2, 2, 0}, {-1, -1, 0}, false},     // at an edge: enters
      {{2, 2, 2}, {-1, -1, 1}, true},      // at a vertex
      {{2, 2, 2}, {-1, -1, -1}, false},    // at a vertex: enters
      {{1, 0, 0}, {1, 0, 0}, false},       // deep
      {{2, 0, 0}, {0, 0, 0}, true},        // at rest on the border
      {{1, 0, 0}, {0, 0, 0}, false},       // at rest inside
  };
  for (const Start& start : starts) {
    Case problem = cube_on_cube();
    problem.b.position = start.place;
    problem.b.displacement = start.motion;
    for (const double t_max : {0.0, 1.0}) {
      problem.t_max = t_max;
      problem.start_policy = StartPolicy::report;
      EXPECT_EQ(expect_exact(problem), Outcome::initially_overlapping);
      problem.start_policy = StartPolicy::pass_over;
      EXPECT_EQ(expect_exact(problem),
                start.leaves_or_slides ? Outcome::miss : Outcome::initially_overlapping)
          << corpus::write_case(problem);
    }
  }
}

TEST(ExactTier, BodiesAtRestTouchOrDoNot) {
  Case problem = cube_on_cube();
  problem.a.displacement = problem.b.displacement = {3, -1, 0.5};
  for (const double x : {0.0, 1.0, 2.0, std::nextafter(2.0, 3.0), std::nextafter(2.0, 0.0), 5.0}) {
    problem.b.position = {x, 2, 0};
    for (const double t_max : {0.0, 1.0, kInfinity<double>}) {
      problem.t_max = t_max;
      EXPECT_EQ(expect_exact(problem), x <= 2 ? Outcome::initially_overlapping : Outcome::miss);
    }
  }
}

// Lengths of 10^k and motions of 10^-k and so on, to both ends of the range.
TEST(ExactTier, EveryMagnitude) {
  Lattice lattice(20260403);
  std::map<Outcome, int> seen;
  for (int i = 0; i < 6000 && !HasFailure(); ++i) {
    Case problem = lattice.pair();
    const double length = std::pow(10.0, lattice.random.integer(-59, 59));
    const double speed = std::pow(10.0, lattice.random.integer(-59, 59));
    const auto scale_points = [&](Shape<double>& shape) {
      if (auto* box = std::get_if<Box<double>>(&shape)) box->half_extents *= length;
      if (auto* segment = std::get_if<Segment<double>>(&shape)) {
        segment->a *= length;
        segment->b *= length;
      }
      if (auto* triangle = std::get_if<Triangle<double>>(&shape)) {
        for (Vec3<double>* x : {&triangle->a, &triangle->b, &triangle->c}) *x *= length;
      }
      if (auto* hull = std::get_if<Hull<double>>(&shape)) {
        std::vector<Vec3<double>> vertices;
        for (const Vec3<double>& x : hull->vertices()) vertices.push_back(length * x);
        shape = Hull<double>(std::span<const Vec3<double>>(vertices));
      }
    };
    // Now and then the bodies are of unequal sizes: one vanishes beside the other.
    scale_points(problem.a.shape);
    if (!lattice.random.once_in(4)) scale_points(problem.b.shape);
    problem.a.position *= length;
    problem.b.position *= length;
    problem.a.displacement *= speed;
    problem.b.displacement *= speed;
    problem.t_max = lattice.random.once_in(2) ? kInfinity<double> : problem.t_max * length / speed;
    ++seen[expect_exact(problem)];
  }
  for (const Outcome outcome : {Outcome::hit, Outcome::miss, Outcome::initially_overlapping})
    EXPECT_GT(seen[outcome], 300);
}

// A turn by 4 arctan z is a turn by 2 arctan z done twice, and nearly one by 2 arctan 2z: at radius x the two
// differ in x by about 16 z^4 x. A wall stands at one, a point comes from the other.
Case nearly_in_contact(double z, double x, double speed) {
  const Shape<double> arm = Segment<double>{{x, 0, 0}, {x, 0, 0}};
  const Quaternion<double> once{1, 0, 0, z}, at_once{1, 0, 0, 2 * z};
  const Vec3<double> origin = Vec3<double>::Zero();
  Case problem;
  problem.a.shape =
      sum<double>(posed<double>(posed<double>(arm, origin, once), origin, once), Box<double>{{0, 1, 1}});
  problem.b.shape = posed<double>(arm, origin, at_once);
  problem.b.displacement = {speed, 0, 0};
  return problem;
}

TEST(ExactTier, TimesBelowTheLeastNormalDouble) {
  struct Expected {
    double z, least, most;
  };
  const Expected all[] = {{1e-3, 1e-140, 1e-120},
                          {1e-46, 1e-310, 1e-290},
                          {1e-48, 1e-315, 0x1p-1022},
                          {1e-51, 0, 1e-322},                                      // a few units of 2^-1074
                          {1e-60, 0, std::numeric_limits<double>::denorm_min()}};  // far below the least
  for (const Expected& expected : all) {
    for (const double side : {1.0, -1.0}) {
      Case problem = nearly_in_contact(expected.z, 1e-60, side * 1e60);
      problem.t_max = kInfinity<double>;
      const oracle::LinearTruth truth(problem);
      if (truth.outcome() == Outcome::hit) {
        EXPECT_GE(truth.toi_lower(), expected.least);
        EXPECT_LE(truth.toi_upper(), expected.most);
        EXPECT_GT(truth.toi_upper(), 0);
      }
      expect_exact(problem);
      for (const double end : {0.0, std::numeric_limits<double>::denorm_min(), 1e-310}) {
        problem.t_max = end;
        expect_exact(problem);
      }
    }
    // One of the two sides approaches.
    Case problem = nearly_in_contact(expected.z, 1e-60, 1e60),
         other = nearly_in_contact(expected.z, 1e-60, -1e60);
    EXPECT_NE(cast_exactly(problem).outcome, cast_exactly(other).outcome);
  }
}

// For rotations nested as deep as validation admits, answers are right or refused as too complex. Shallow
// ones are right.
TEST(ExactTier, NestedRotationsAreRightOrRefused) {
  Lattice lattice(20260404);
  int refused = 0, right = 0;
  for (int depth = 1; depth <= 15; ++depth) {
    for (int i = 0; i < 12; ++i) {
      Case problem = lattice.pair();
      const auto wrap = [&](Shape<double> shape) {
        for (int level = 0; level < depth; ++level) {
          Quaternion<double> q{lattice.random.uniform(-1, 1), lattice.random.uniform(-1, 1),
                               lattice.random.uniform(-1, 1), lattice.random.uniform(-1, 1)};
          shape = posed<double>(std::move(shape), lattice.point(1) / 4, q);
        }
        return shape;
      };
      problem.a.shape = wrap(problem.a.shape);
      if (i % 2 == 0)
        problem.b.shape = sum<double>(wrap(Segment<double>{{0, 0, 0}, {1, 1, 0}}), Box<double>{{1, 0, 1}});
      const CastResult<double> result = cast_exactly(problem);
      if (result.outcome == Outcome::invalid_input) {
        EXPECT_EQ(result.invalid, Invalid::too_complex);
        EXPECT_EQ(to_text(result.invalid_at), "the shapes nest too many rotations for tier exact");
        EXPECT_GT(depth, 4) << corpus::write_case(problem);
        EXPECT_TRUE(std::isnan(result.toi_lower) && std::isnan(result.toi_upper) && !result.proof);
        ++refused;
        continue;
      }
      ++right;
      EXPECT_EQ(difference(result, oracle::LinearTruth(problem)), "") << corpus::write_case(problem);
    }
  }
  EXPECT_GT(right, 48);
  RecordProperty("refused", refused);
}

// The same path of the same bodies, said in other shapes.
TEST(ExactTier, SumsAndPosesSayTheSame) {
  Lattice lattice(20260405);
  for (int i = 0; i < 1500 && !HasFailure(); ++i) {
    Case problem = lattice.pair();
    const Vec3<double> by = lattice.point(), sweep = lattice.point();
    problem.a.shape =
        posed<double>(swept<double>(problem.a.shape, sweep), by,
                      {double(lattice.random.integer(1, 2)), 1, 0, double(lattice.random.integer(-1, 1))});
    if (i % 2 == 0) problem.b.shape = sum<double>(problem.b.shape, translated<double>(lattice.shape(), by));
    expect_exact(problem);
  }
}

TEST(ExactTier, WhatItIsNotForIsRefused) {
  const Body<double> cube{.shape = Box<double>{{1, 1, 1}}};
  const auto refusal = [&](Shape<double> shape, double target) {
    const Body<double> other{.shape = std::move(shape), .position = {5, 0, 0}, .displacement = {-9, 0, 0}};
    CastOptions<double> options;
    options.tier = Tier::exact;
    options.request = Request::everything;
    options.target_distance = target;
    const CastResult<double> one = cast(cube, other, options), two = cast(other, cube, options);
    EXPECT_EQ(one.invalid, two.invalid);
    EXPECT_TRUE(
        one.outcome != Outcome::invalid_input ||
        (std::isnan(one.toi_lower) && std::isnan(one.toi_upper) && !one.proof && one.counters.supports == 0));
    return one.invalid;
  };
  const Segment<double> rod{{0, 0, 0}, {1, 0, 0}};
  for (const Shape<double>& curved :
       {Shape<double>(Ellipsoid<double>{{1, 1, 1}}), Shape<double>(Cylinder<double>{1, 1}),
        Shape<double>(Cone<double>{1, 1}), hull_of<double>(rod, rod),
        sum<double>(rod, hull_of<double>(rod, rod)),
        posed<double>(Cylinder<double>{1, 1}, Vec3<double>::Zero(), {})}) {
    EXPECT_EQ(refusal(curved, 0), Invalid::not_exact);
  }
  EXPECT_EQ(refusal(rod, 0), Invalid::none);
  EXPECT_EQ(refusal(rod, 0.5), Invalid::none);
  for (const Shape<double>& round : {Shape<double>(Sphere<double>{1}), Shape<double>(Sphere<double>{0}),
                                     Shape<double>(Capsule<double>{0, 1}), rounded<double>(rod, 0)})
    EXPECT_EQ(refusal(round, 0), Invalid::none);
  // The door comes first.
  EXPECT_EQ(refusal(Sphere<double>{-1}, 0), Invalid::negative_extent);
  EXPECT_EQ(refusal(rod, -1), Invalid::bad_target);
}

TEST(ExactTier, NothingIsComputedUnasked) {
  Lattice lattice(20260406);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Case problem = lattice.pair();
    const CastResult<double> least = cast_exactly(problem, Request::verdict), all = cast_exactly(problem);
    EXPECT_EQ(least.outcome, all.outcome);
    EXPECT_TRUE(least.toi_lower == all.toi_lower && least.toi_upper == all.toi_upper);
    EXPECT_FALSE(least.proof);
    EXPECT_TRUE(least.normal.isZero(0) && least.point_a.isZero(0) && least.point_b.isZero(0));
    EXPECT_LE(least.counters.supports, all.counters.supports);
    EXPECT_LE(least.counters.exact_decisions, all.counters.exact_decisions);
    const CastResult<double> normal = cast_exactly(problem, Request::normal);
    EXPECT_FALSE(normal.proof);
    EXPECT_TRUE(normal.point_a.isZero(0) && normal.point_b.isZero(0));
    EXPECT_EQ(normal.normal, all.normal);
    hits += all.outcome == Outcome::hit;
    EXPECT_EQ(all.normal.isZero(0), all.outcome != Outcome::hit);
  }
  EXPECT_GT(hits, 100);
}

// The same numbers as floats: the same verdict, and the bracket of floats.
TEST(ExactTier, FloatsAreRoundedOutward) {
  Lattice lattice(20260407);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    Case problem = lattice.pair();
    const auto* box_a = std::get_if<Box<double>>(&problem.a.shape);
    const auto* box_b = std::get_if<Box<double>>(&problem.b.shape);
    if (box_a == nullptr || box_b == nullptr) continue;
    const auto as_float = [](const Body<double>& body, const Box<double>& box) {
      const Quaternion<double>& q = body.orientation;
      return Body<float>{.shape = Box<float>{box.half_extents.cast<float>()},
                         .position = body.position.cast<float>(),
                         .orientation = {float(q.w), float(q.x), float(q.y), float(q.z)},
                         .displacement = body.displacement.cast<float>()};
    };
    const CastResult<float> result =
        cast(as_float(problem.a, *box_a), as_float(problem.b, *box_b), exact_options<float>(problem));
    const oracle::LinearTruth truth(problem);
    ASSERT_EQ(result.outcome, truth.outcome()) << corpus::write_case(problem);
    if (result.outcome != Outcome::hit) continue;
    ++hits;
    EXPECT_GE(truth.compare(double(result.toi_upper)), 0);
    EXPECT_LE(truth.compare(double(result.toi_lower)), 0);
    EXPECT_TRUE(result.toi_lower == result.toi_upper ||
                std::nextafter(result.toi_lower, kInfinity<float>) == result.toi_upper);
    if (result.toi_lower < result.toi_upper) {
      EXPECT_LT(truth.compare(double(result.toi_lower)), 0);
      EXPECT_GT(truth.compare(double(result.toi_upper)), 0);
    }
  }
  EXPECT_GT(hits, 20);
}

}  // namespace
}  // namespace graze
