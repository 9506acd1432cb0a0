// The exact tier of spheres, capsules, rounded polytopes and target distances against closed forms in rational numbers:
// equal verdicts, and times that are the correctly rounded ones on both sides.
#include <gtest/gtest.h>

#include <cmath>
#include <graze/cast.hpp>
#include <graze/distance.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/swept_overlap.hpp>

#include "tests/core/casts/round_truth.hpp"
#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::operator*;
using test::Draw;
using test::Rational;
using test::RoundTruth;

int below(Draw& draw, int n) { return static_cast<int>(draw.between(0, n)); }
int integer(Draw& draw, int size) { return below(draw, 2 * size + 1) - size; }

struct Tally {
  int casts = 0, starts = 0, hits = 0, misses = 0, exact_times = 0, at_end = 0, passed_over = 0;
};

template <class S>
struct Question {
  Body<S> a, b;
  S target = 0, t_max = 1;
};

template <class S>
S next_up(S x) {
  return std::nextafter(x, kInfinity<S>);
}
template <class S>
S next_down(S x) {
  return std::nextafter(x, -kInfinity<S>);
}

template <class S>
std::string text(const Question<S>& q) {
  std::string out;
  char number[64];
  const auto add = [&](double x) {
    std::snprintf(number, sizeof number, " %a", x);
    out += number;
  };
  for (const Body<S>* body : {&q.a, &q.b}) {
    out += "\nkind " + std::to_string(body->shape.index()) + " at";
    for (int i = 0; i < 3; ++i) add(double(body->position[i]));
    out += " turn";
    for (const S x : {body->orientation.w, body->orientation.x, body->orientation.y, body->orientation.z})
      add(double(x));
    out += " moves";
    for (int i = 0; i < 3; ++i) add(double(body->displacement[i]));
    if (const auto* sphere = std::get_if<Sphere<S>>(&body->shape)) add(double(sphere->radius));
    if (const auto* capsule = std::get_if<Capsule<S>>(&body->shape)) {
      add(double(capsule->radius));
      add(double(capsule->half_height));
    }
    if (const auto* box = std::get_if<Box<S>>(&body->shape)) {
      for (int i = 0; i < 3; ++i) add(double(box->half_extents[i]));
    }
  }
  out += "\ntarget, t_max";
  add(double(q.target));
  add(double(q.t_max));
  return out;
}

// The fault of the answer, or empty if the answer is right.
template <class S>
std::string fault(const Question<S>& q, const CastResult<S>& r, const RoundTruth& truth, Tally& tally) {
  if (r.invalid != Invalid::none) return "refused: " + std::string(to_text(r.invalid));
  const bool starts = truth.starts_in_contact();
  if (starts != (r.outcome == Outcome::initially_overlapping)) return "the start";
  if (starts) {
    ++tally.starts;
    return r.toi_lower == 0 && r.toi_upper == 0 ? "" : "the time of a start";
  }
  const auto end = q.t_max < kInfinity<S> ? std::optional(Rational(double(q.t_max))) : std::nullopt;
  const bool hit = truth.contact_until(end);
  if (hit != (r.outcome == Outcome::hit)) return hit ? "the hit" : "the miss";
  if (!hit) {
    ++tally.misses;
    return r.toi_lower == kInfinity<S> && r.toi_upper == kInfinity<S> ? "" : "the time of a miss";
  }
  ++tally.hits;
  tally.at_end += r.toi_upper == q.t_max;
  const Rational lower(double(r.toi_lower)), upper(double(r.toi_upper));
  if (!truth.contact_until(upper)) return "TOI is above the upper end";
  if (r.toi_lower == r.toi_upper) {
    ++tally.exact_times;
    if (truth.contact_until(upper, true)) return "TOI is below the time";
  } else {
    if (next_up(r.toi_lower) != r.toi_upper) return "no neighbours";
    if (truth.contact_until(lower)) return "TOI is not above the lower end";
    if (!truth.contact_until(upper, true)) return "TOI is the upper end";
  }
  if (!(std::abs(r.normal.template cast<double>().norm() - 1) < 8 * double(kUnitRoundoff<S>)))
    return "the normal's length";
  // n supports C where the path meets it: H(n) + R - TOI n.v is 0, and of second order in n's error except on
  // a face.
  const test::Point3 n = test::rational(r.normal);
  const Rational above = truth.reach(n) + truth.radius() - upper * test::dot(n, truth.motion());
  const Rational size = truth.radius() + abs(truth.reach(n)) + abs(truth.reach(Rational(-1) * n)) +
                        upper * (abs(truth.motion()[0]) + abs(truth.motion()[1]) + abs(truth.motion()[2]));
  if (abs(above) > 32 * double(kUnitRoundoff<S>) * size) return "the normal";
  // The balls' nearest points are the target distance apart, and what the bodies move in the bracket.
  const double between = (r.point_b - r.point_a).template cast<double>().norm() - double(q.target);
  const double reach = double(q.a.position.norm()) + double(q.b.position.norm()) + double(r.point_a.norm()) +
                       double(r.point_b.norm()) + size.get_d();
  if (!(std::abs(between) <= double(r.distance) + 64 * double(kUnitRoundoff<S>) * reach))
    return "the witnesses";
  return "";
}

// The same of the other questions: overlap without a target distance, the path, and both ends of the line.
template <class S>
std::string query_fault(const Question<S>& q, const RoundTruth& truth) {
  const RoundTruth at_start(q.a, q.b, S(0));
  if ((overlap_exact(q.a, q.b).outcome == Outcome::initially_overlapping) != at_start.starts_in_contact())
    return "the overlap";
  const auto is_within = [&](S distance) { return RoundTruth(q.a, q.b, distance).starts_in_contact(); };
  const DistanceResult<S> apart = distance_exact(q.a, q.b);
  if (apart.invalid != Invalid::none) return "the distance is refused";
  if (at_start.starts_in_contact() ? apart.lower != 0 || apart.upper != 0
                                   : !is_within(apart.upper) || is_within(next_down(apart.upper)) ||
                                         (apart.lower < apart.upper && is_within(apart.lower)))
    return "the distance";
  if (apart.lower != apart.upper && apart.lower != next_down(apart.upper))
    return "the bracket of the distance";
  SweptOverlapOptions<S> path;
  path.t_max = q.t_max;
  path.target_distance = q.target;
  const auto end = q.t_max < kInfinity<S> ? std::optional(Rational(double(q.t_max))) : std::nullopt;
  const bool meets = truth.starts_in_contact() || truth.contact_until(end);
  if ((swept_overlap_exact(q.a, q.b, path).outcome == Outcome::hit) != meets) return "the swept overlap";
  LineOptions<S> whole;
  whole.target_distance = q.target;
  const LineResult<S> line = line_exact(q.a, q.b, whole);
  const bool passes = truth.line_meets();
  if ((line.outcome == Outcome::hit) != passes) return "the line";
  if (!passes || !truth.moves()) return "";
  const auto is_bracket = [&](S lower, S upper, int toward) {
    const S near = toward < 0 ? upper : lower, far = toward < 0 ? lower : upper;
    if (!truth.line_until(Rational(double(near)), toward, false)) return false;
    if (lower == upper) return !truth.line_until(Rational(double(near)), toward, true);
    return next_up(lower) == upper && !truth.line_until(Rational(double(far)), toward, false) &&
           truth.line_until(Rational(double(near)), toward, true);
  };
  if (!is_bracket(line.in_lower, line.in_upper, -1)) return "t_in";
  return is_bracket(line.out_lower, line.out_upper, 1) ? "" : "t_out";
}

template <class S>
CastResult<S> ask(const Question<S>& q, StartPolicy policy = StartPolicy::report) {
  return cast(q.a, q.b,
              {.tier = Tier::exact, .t_max = q.t_max, .target_distance = q.target, .start_policy = policy});
}

// The question, and those with the time of impact for T, and one number before and after.
template <class S>
void judge(Question<S> q, Tally& tally) {
  const RoundTruth truth(q.a, q.b, q.target);
  const CastResult<S> r = ask(q);
  ++tally.casts;
  ASSERT_EQ(fault(q, r, truth, tally), "") << text(q);
  if (tally.casts % 4 == 0) {
    ASSERT_EQ(query_fault(q, truth), "") << text(q);
  }
  if (r.outcome == Outcome::initially_overlapping && truth.balls() > 0) {
    const CastResult<S> passed = ask(q, StartPolicy::pass_over);
    ASSERT_EQ(passed.passed_over, truth.leaves_or_slides()) << text(q);
    tally.passed_over += passed.passed_over;
  }
  if (r.outcome != Outcome::hit) return;
  for (const S end : {r.toi_lower, r.toi_upper, next_down(r.toi_lower)}) {
    if (!(end > 0)) continue;
    q.t_max = end;
    ASSERT_EQ(fault(q, ask(q), truth, tally), "") << text(q);
  }
}

template <class S>
Shape<S> drawn_core(Draw& draw, int kind, double size) {
  switch (kind) {
    case 0:
      return Point<S>{};
    case 1:
      return Segment<S>{draw.vector<S>(size), draw.vector<S>(size)};
    case 2:
      return Triangle<S>{draw.vector<S>(size), draw.vector<S>(size), draw.vector<S>(size)};
    case 3:
      return Box<S>{{S(draw.between(0.1, size)), S(draw.between(0.1, size)), S(draw.between(0.1, size))}};
    default:
      return draw.hull<S>(5, size);
  }
}
template <class S>
Shape<S> drawn_shape(Draw& draw, double radius, bool small) {
  switch (below(draw, small ? 3 : 6)) {
    case 0:
      return Sphere<S>{S(radius)};
    case 1:
      return Capsule<S>{S(radius), S(draw.between(0.1, 2))};
    case 2:
      return Rounded<S>{share<S>(drawn_core<S>(draw, below(draw, 3), 1)), S(radius)};
    case 3:
      return Rounded<S>{share<S>(drawn_core<S>(draw, below(draw, 5), 1)), S(radius)};
    case 4:
      return drawn_core<S>(draw, below(draw, 5), 1);
    default:
      return Posed<S>{share<S>(Shape<S>(Capsule<S>{S(radius), S(1)})), draw.vector<S>(1), draw.turn<S>()};
  }
}

template <class S>
Tally judge_random(std::uint64_t seed, int rounds, int most_exponent) {
  Draw draw{seed};
  Tally tally;
  for (int round = 0; round < rounds; ++round) {
    Question<S> q;
    const auto radius = [&] {
      return std::ldexp(draw.between(1, 2), most_exponent > 0 ? integer(draw, most_exponent) : -2);
    };
    const double r_a = radius(), r_b = radius();
    q.a.shape = drawn_shape<S>(draw, r_a, false);
    q.b.shape = drawn_shape<S>(draw, r_b, true);
    q.a.orientation = draw.turn<S>();
    q.b.orientation = draw.turn<S>();
    if (below(draw, 3) == 0) q.target = S(radius());
    if (below(draw, 4) == 0) q.t_max = kInfinity<S>;
    const double away = 4 + (r_a + r_b + double(q.target)) * draw.between(1, 2);
    const Vec3<double> aim = Vec3<double>(draw.vector<double>(1)).normalized();
    q.a.position = draw.vector<S>(10);
    q.b.position = q.a.position + Vec3<S>((away * aim).template cast<S>());
    q.a.displacement = draw.vector<S>(1);
    q.b.displacement =
        q.a.displacement + Vec3<S>((-2 * away * (aim + 0.4 * draw.vector<double>(1))).template cast<S>());
    judge(q, tally);
    if (testing::Test::HasFatalFailure()) break;
  }
  return tally;
}

TEST(ExactRounds, RandomPairs) {
  const Tally tally = judge_random<double>(1, 300, 0);
  EXPECT_GT(tally.hits, 100);
  EXPECT_GT(tally.misses, 50);
}
TEST(ExactRounds, RandomPairsOfFloats) {
  const Tally tally = judge_random<float>(2, 120, 0);
  EXPECT_GT(tally.hits, 40);
  EXPECT_GT(tally.misses, 20);
}
// Every number is near 1e-60 or near 1e60, those of the rotations as well: no exact number may have more bits.
TEST(ExactRounds, NumbersOfBothEndsOfTheRangeHaveRoom) {
  Draw draw{10};
  Tally tally;
  for (int round = 0; round < 30 && !HasFatalFailure(); ++round) {
    const auto number = [&] {
      const double size = draw.between(1, 9.9) * (below(draw, 2) == 0 ? 1e-60 : 1e59);
      return below(draw, 2) == 0 ? size : -size;
    };
    const auto vector = [&] {
      const double x = number(), y = number();
      return Vec3<double>(x, y, number());
    };
    const auto body = [&](const Shape<double>& core) {
      const double w = number(), x = number(), y = number();
      return Body<double>{.shape = rounded<double>(core, std::abs(number())),
                          .position = vector(),
                          .orientation = {w, x, y, number()},
                          .displacement = vector()};
    };
    Question<double> q;
    q.a = body(Triangle<double>{vector(), vector(), vector()});
    q.b = body(Segment<double>{vector(), vector()});
    if (below(draw, 2) == 0) q.t_max = kInfinity<double>;
    judge(q, tally);
  }
  EXPECT_GT(tally.hits, 5);
  EXPECT_GT(tally.misses, 10);
}

TEST(ExactRounds, RadiiFarFromTheSizes) {
  const Tally tally = judge_random<double>(3, 60, 100);
  EXPECT_GT(tally.hits, 15);
}

// Small integers: Voronoi boundaries, touching starts, grazes, contact at T, slides along faces and edges.
template <class S>
Tally judge_lattice(std::uint64_t seed, int rounds) {
  Draw draw{seed};
  Tally tally;
  const auto lattice = [&](int size) {
    return Vec3<S>(S(integer(draw, size)), S(integer(draw, size)), S(integer(draw, size)));
  };
  const auto shape = [&]() -> Shape<S> {
    const S radius = S(below(draw, 5));
    switch (below(draw, 7)) {
      case 0:
        return Sphere<S>{radius};
      case 1:
        return Capsule<S>{radius, S(below(draw, 3))};
      case 2:
        return Box<S>{{S(below(draw, 3)), S(below(draw, 3)), S(below(draw, 3))}};
      case 3:
        return Rounded<S>{share<S>(Shape<S>(Triangle<S>{lattice(2), lattice(2), lattice(2)})), radius};
      case 4:
        return Posed<S>{share<S>(Shape<S>(Segment<S>{lattice(2), lattice(2)})), lattice(2)};
      case 5:
        return Sum<S>{
            {share<S>(Shape<S>(Segment<S>{lattice(1), lattice(1)})), share<S>(Shape<S>(Sphere<S>{radius}))}};
      default:
        return Segment<S>{lattice(2), lattice(2)};
    }
  };
  // A quarter turn about an axis, or a third of a turn about a diagonal: lattices stay lattices.
  const auto turn = [&]() -> Quaternion<S> {
    switch (below(draw, 4)) {
      case 0:
        return {1, 1, 0, 0};
      case 1:
        return {1, 1, 1, 1};
      case 2:
        return {S(3), 0, 0, S(1)};  // 3-4-5
      default:
        return {};
    }
  };
  for (int round = 0; round < rounds; ++round) {
    Question<S> q;
    q.a.shape = shape();
    q.b.shape = below(draw, 2) == 0 ? Shape<S>(Sphere<S>{S(below(draw, 5))})
                                    : Shape<S>(Capsule<S>{S(below(draw, 5)), S(1)});
    q.a.orientation = turn();
    q.b.orientation = turn();
    q.b.position = lattice(7);
    q.b.displacement = below(draw, 2) == 0 ? lattice(8) : Vec3<S>(8 * lattice(1));
    if (below(draw, 3) == 0) q.target = S(below(draw, 5));
    if (below(draw, 4) == 0) q.t_max = kInfinity<S>;
    judge(q, tally);
    if (testing::Test::HasFatalFailure()) break;
  }
  return tally;
}
TEST(ExactRounds, LatticesTie) {
  const Tally tally = judge_lattice<double>(5, 1500);
  EXPECT_GT(tally.starts, 100);
  EXPECT_GT(tally.hits, 200);
  EXPECT_GT(tally.exact_times, 20);
  EXPECT_GT(tally.at_end, 50);
  EXPECT_GT(tally.passed_over, 20);
}
TEST(ExactRounds, LatticesOfFloatsTie) {
  const Tally tally = judge_lattice<float>(6, 400);
  EXPECT_GT(tally.exact_times, 3);
}

// A path that grazes by a Pythagorean placement: columns of an integer rotation, all lengths times |q|^2. One radius
// changes by a unit in the last place, and so does the path's distance.
template <class S>
void judge_grazes(std::uint64_t seed, int rounds) {
  Draw draw{seed};
  Tally tally;
  int grazes = 0;
  for (int round = 0; round < rounds; ++round) {
    const int w = integer(draw, 4), x = integer(draw, 4), y = integer(draw, 4), z = integer(draw, 4);
    const int all = w * w + x * x + y * y + z * z;
    if (all == 0) continue;
    const Vec3<double> up(w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y));
    const Vec3<double> along(2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x));
    const int r_a = 1 + below(draw, 6), r_b = 1 + below(draw, 6), m = below(draw, 4), k = 1 + below(draw, 9);
    Question<S> q;
    const bool posed = below(draw, 2) == 0;
    const double scale = std::ldexp(1.0, integer(draw, 20));
    const Vec3<S> shift = draw.vector<S>(0.5);
    const Quaternion<S> turn = draw.turn<S>();
    const auto ball = [&](double radius) -> Shape<S> {
      const Shape<S> plain = Sphere<S>{S(scale * radius)};
      return posed ? Shape<S>(Posed<S>{share<S>(plain), shift}) : plain;
    };
    // With one quaternion and one shift for both, no posed centre is a double, and their difference is one.
    q.a.orientation = q.b.orientation = turn;
    q.b.position = (scale * ((r_a + r_b + m) * up - k * along)).template cast<S>();
    q.b.displacement = (2 * scale * k * along).template cast<S>();
    q.target = S(scale * m * all);
    for (const int change : {-1, 0, 1}) {
      double radius = r_b * all;
      q.a.shape = ball(r_a * all);
      q.b.shape = ball(radius);
      if (change != 0) {
        S moved = S(scale * radius);
        moved = change < 0 ? next_down(moved) : next_up(moved);
        q.b.shape = posed ? Shape<S>(Posed<S>{share<S>(Shape<S>(Sphere<S>{moved})), shift})
                          : Shape<S>(Sphere<S>{moved});
      }
      const CastResult<S> r = ask(q);
      ASSERT_EQ(r.outcome, change < 0 ? Outcome::miss : Outcome::hit) << text(q);
      if (change == 0) {
        ASSERT_EQ(r.toi_lower, S(0.5)) << text(q);
        ASSERT_EQ(r.toi_upper, S(0.5)) << text(q);
        ++grazes;
      }
      judge(q, tally);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_GT(grazes, rounds / 2);
}
TEST(ExactRounds, PythagoreanGrazes) { judge_grazes<double>(7, 120); }
TEST(ExactRounds, PythagoreanGrazesOfFloats) { judge_grazes<float>(8, 60); }

// Radii that no double can add: their sum decides, not its rounding.
TEST(ExactRounds, RadiiAreAddedExactly) {
  for (const double little : {0.0, 0x1p-105, 1e-30, 1e-60}) {
    for (const double change : {-1.0, 0.0, 1.0}) {
      Question<double> q;
      q.a.shape = Sphere<double>{1};
      q.b.shape = Sphere<double>{little};
      q.b.position = {-3, 1 + (change > 0 ? 0x1p-52 : 0.0), 0};
      q.b.displacement = {6, 0, 0};
      q.target = change < 0 ? 1e-50 : 0.0;
      const bool meets = change <= 0 || little > 0x1p-52;
      EXPECT_EQ(ask(q).outcome, meets ? Outcome::hit : Outcome::miss) << little << ' ' << change;
      Tally tally;
      judge(q, tally);
    }
  }
}

// A start in contact by the target distance alone: whether it leaves is asked of the shapes.
TEST(ExactRounds, TheTargetDistanceDoesNotCountForLeaving) {
  const auto passes = [](const Shape<double>& shape, const Vec3<double>& motion) {
    Body<double> a{Box<double>{{1, 1, 1}}}, b{shape};
    b.position = {0, 0, 2};
    b.displacement = motion;
    const auto r =
        cast(a, b, {.tier = Tier::exact, .target_distance = 2.0, .start_policy = StartPolicy::pass_over});
    return r.passed_over ? 1 : r.outcome == Outcome::initially_overlapping ? 0 : -1;
  };
  for (const Shape<double>& shape : {Shape<double>(Sphere<double>{0.5}), Shape<double>(Sphere<double>{1.0}),
                                     Shape<double>(Point<double>{}), Shape<double>(Sphere<double>{0})}) {
    EXPECT_EQ(passes(shape, {0, 0, 1}), 1);
    EXPECT_EQ(passes(shape, {1, 0, 0}), 1);
    EXPECT_EQ(passes(shape, {0, 0, -1}), 0);
    EXPECT_EQ(passes(shape, {0, 0, 0}), 1);
  }
  // Past the box's edge the ray touches a ball of radius 1 that slides, and not one that goes lower.
  EXPECT_EQ(passes(Point<double>{}, {1, 0, -1}), 1);
  EXPECT_EQ(passes(Point<double>{}, {1, 0, -1.5}), 0);
  EXPECT_EQ(passes(Sphere<double>{0.25}, {1, 0, -1}), 0);
}

// A sphere of radius 3 passes an end of a segment at (2, -2, 1), across its motion: the time is 3. The search begins at
// that double.
TEST(ExactRounds, AGrazeAtTheDoubleThatTheSearchBeginsAtIsThatDouble) {
  const Body<double> a{.shape = Segment<double>{{2, 3, 0}, {-118, 15, 264}}};
  const Body<double> b{.shape = Rounded<double>{share<double>(Point<double>{}), 3},
                       .position = {184, 217, 73},
                       .displacement = {-60, -72, -24}};
  const CastResult<double> result = cast(a, b, {.tier = Tier::exact, .t_max = 3});
  ASSERT_EQ(result.outcome, Outcome::hit);
  EXPECT_EQ(result.toi_lower, 3);
  EXPECT_EQ(result.toi_upper, 3);
}

// Of a normal, each component is within 2 u, and of the expected one within u / 2: less than 4 u together. A witness 2 n away
// is within 4 u, and its sum and the expected number round by 2 u each.
constexpr double kNormal = 4 * kUnitRoundoff<double>, kWitness = 8 * kUnitRoundoff<double>;

// Between two doubles the ball passes over an edge, and then touches the face. The way between them dwarfs its radius.
TEST(ExactRounds, TheNormalIsThatOfTheFeatureAtContact) {
  const Body<double> box{.shape = Box<double>{{1, 1, 1}}, .position = {-1, 0, -1}};
  const Body<double> ball{
      .shape = Sphere<double>{1e-25}, .position = {next_down(16.0), 0, 16}, .displacement = {-13, 0, -13}};
  const CastResult<double> r = cast(box, ball, {.tier = Tier::exact, .t_max = 2});
  ASSERT_EQ(r.outcome, Outcome::hit);
  // 16/13 is 9/13 of the way from a double to the next, and the edge is passed at 1/13 of it.
  EXPECT_EQ(r.toi_upper, next_up(r.toi_lower));
  EXPECT_GT(std::fma(-13, r.toi_lower, ball.position[0]), 0);
  EXPECT_NEAR((r.normal - Vec3<double>(0, 0, 1)).norm(), 0, kNormal);
}

// Newton's step from the start passes the contact by rounding. From there it once went back to the start, 32 times over.
TEST(ExactRounds, AStepBeyondTheContactIsTakenOnce) {
  const Shape<double> hull =
      Hull<double>{{-1e38, -10, 1e55}, {-2e7, 1e20, 1e-14}, {0, 0, 1e-57}, {-1e-25, 0, 0}};
  const Body<double> a{.shape = rounded(hull, 2e-10), .position = {0, -2e-6, -1e37}};
  const Body<double> b{.shape = Segment<double>{{0, -1.5e29, 0}, {0, 0, 0}},
                       .position = {-1e32, -1e30, -2e-57},
                       .displacement = {1e32, 1e30, -1e37}};
  const CastResult<double> r = cast(a, b, {.tier = Tier::exact});
  ASSERT_EQ(r.outcome, Outcome::hit);
  EXPECT_EQ(r.toi_upper, 1);
  EXPECT_LT(r.counters.supports, 64);
}

TEST(ExactDistance, OfKnownBodies) {
  const Body<double> box{.shape = Box<double>{{1, 1, 1}}};
  Body<double> ball{.shape = Sphere<double>{2}, .position = {4, 5, 1}};
  const DistanceResult<double> three = distance_exact(box, ball);
  EXPECT_EQ(three.lower, 3);
  EXPECT_EQ(three.upper, 3);
  EXPECT_NEAR((three.normal - Vec3<double>(0.6, 0.8, 0)).norm(), 0, kNormal);
  EXPECT_EQ(three.point_a, Vec3<double>(1, 1, 1));
  EXPECT_NEAR(three.point_b[0], 2.8, kWitness);
  EXPECT_NEAR(three.point_b[1], 3.4, kWitness);
  EXPECT_EQ(three.point_b[2], 1);
  // One unit in the last place of the radius from touching, and touching.
  ball.shape = Sphere<double>{next_down(5.0)};
  EXPECT_EQ(distance_exact(box, ball).lower, 5 - next_down(5.0));
  EXPECT_EQ(distance_exact(box, ball).upper, 5 - next_down(5.0));
  ball.shape = Sphere<double>{5};
  EXPECT_EQ(distance_exact(box, ball).upper, 0);
  // The target distance of a cast at which it starts in contact.
  const Body<double> turned{
      .shape = Capsule<double>{0.1, 0.7}, .position = {3, 2, 1}, .orientation = {3, 1, 2, 1}};
  const DistanceResult<double> gap = distance_exact(box, turned);
  EXPECT_EQ(gap.upper, next_up(gap.lower));
  const auto starts = [&](double target) {
    return cast(box, turned, {.tier = Tier::exact, .target_distance = target}).outcome ==
           Outcome::initially_overlapping;
  };
  EXPECT_TRUE(starts(gap.upper));
  EXPECT_FALSE(starts(gap.lower));
  const Body<double> cone{.shape = Cone<double>{1, 1}, .position = {5, 0, 0}};
  EXPECT_EQ(distance_exact(box, cone).invalid, Invalid::not_exact);
}

}  // namespace
}  // namespace graze
