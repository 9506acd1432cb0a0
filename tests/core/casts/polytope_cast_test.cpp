#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <graze/cast.hpp>
#include <graze/detail/casts/ladder.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

// A quick search, and the robust one that it spares.
template <class S>
struct ByWalk {
  using Number = S;
  static constexpr Method kMethod = Method::mpr_sweep;
  static bool quick(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
    return detail::fast_cast(a, b, options, out);
  }
  static void robust(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
    detail::robust_mpr_sweep(a, b, options, out);
  }
};
template <class S>
struct ByRay {
  using Number = S;
  static constexpr Method kMethod = Method::gjk_ray_cast;
  static bool quick(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
    return detail::fast_ray_cast(a, b, options, out);
  }
  static void robust(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
    detail::robust_gjk_ray(a, b, options, out);
  }
};

template <class Search>
class FastCast : public ::testing::Test {};
using Searches = ::testing::Types<ByWalk<float>, ByWalk<double>, ByRay<float>, ByRay<double>>;
TYPED_TEST_SUITE(FastCast, Searches);

// How often the search answered what.
struct Tally {
  int hits = 0, misses = 0, contacts = 0, gave_up = 0;
};

template <class S>
double scale_of(const Body<S>& a, const Body<S>& b) {
  const detail::Cso<S> cso(a, b);
  return std::ldexp(double(cso.scale()), cso.length_exponent());
}

// Compares the claims of the search with the exact tier and with the robust search. `thin`: the verdict may
// be that of shapes that are moved by the noise of contact.
template <class Search, class S = typename Search::Number>
void expect_right(const Body<S>& a, const Body<S>& b, S t_max, bool thin, Tally& tally) {
  CastOptions<S> options;
  options.method = Search::kMethod;
  options.t_max = t_max;
  CastResult<S> quick;
  if (!Search::quick(a, b, options, quick)) {
    ++tally.gave_up;
    return;
  }
  CastResult<S> robust;
  Search::robust(a, b, options, robust);
  const CastResult<S> exact = cast_exact(a, b, options);
  ASSERT_EQ(exact.invalid, Invalid::none);
  const double speed =
      (b.displacement.template cast<double>() - a.displacement.template cast<double>()).norm();
  const double noise = 2 * detail::kContact * double(kUnitRoundoff<S>) * scale_of(a, b);
  switch (quick.outcome) {
    case Outcome::miss:
      ++tally.misses;
      // Shown in doubles, beyond their rounding.
      EXPECT_EQ(exact.outcome, Outcome::miss);
      if (!thin) {
        EXPECT_EQ(robust.outcome, Outcome::miss);
      }
      return;
    case Outcome::initially_overlapping:
      ++tally.contacts;
      if (!thin) {
        EXPECT_EQ(exact.outcome, Outcome::initially_overlapping);
        EXPECT_EQ(robust.outcome, Outcome::initially_overlapping);
      }
      EXPECT_EQ(quick.toi_lower, 0);
      EXPECT_EQ(quick.toi_upper, 0);
      return;
    default:
      break;
  }
  ASSERT_EQ(quick.outcome, Outcome::hit);
  ++tally.hits;
  EXPECT_GT(quick.toi_lower, 0);
  EXPECT_LE(quick.toi_lower, quick.toi_upper);
  EXPECT_LE(quick.toi_upper, t_max);
  EXPECT_NEAR(quick.normal.norm(), 1, 4 * double(kUnitRoundoff<S>));
  if (exact.outcome != Outcome::hit) {
    EXPECT_TRUE(thin) << "exact: " << int(exact.outcome);
    return;
  }
  // A plane that is moved by the noise is met that much earlier or later.
  const Vec3<double> v = b.displacement.template cast<double>() - a.displacement.template cast<double>();
  const double closing = -quick.normal.template cast<double>().dot(v);
  // At a contact that the path grazes, the unit normal rounds.
  EXPECT_GT(closing, -8 * double(kUnitRoundoff<S>) * speed);
  const double slack = noise / std::max(closing, 1e-300) + 4 * double(kUnitRoundoff<S>) * double(t_max);
  EXPECT_LE(quick.toi_lower, double(exact.toi_upper) + slack);
  if (!thin) {
    EXPECT_GE(quick.toi_upper, double(exact.toi_lower) - slack);
    EXPECT_EQ(robust.outcome, Outcome::hit);
    EXPECT_LE(quick.toi_lower, double(robust.toi_upper) + slack);
    EXPECT_GE(quick.toi_upper, double(robust.toi_lower) - slack);
  }
  // Witnesses: within the noise of each other, and of the path's length that the bracket leaves open.
  const double open = (double(quick.toi_upper) - double(quick.toi_lower)) * speed;
  const double world = (a.position.norm() + b.position.norm() + v.norm()) * 8 * double(kUnitRoundoff<S>);
  EXPECT_LE((quick.point_a - quick.point_b).norm(), noise + open + world);
}

template <class S>
Shape<S> some_shape(Draw& draw, int kind) {
  switch (kind % 6) {
    case 0:
      return Point<S>{};
    case 1:
      return Segment<S>{draw.vector<S>(1), draw.vector<S>(1)};
    case 2:
      return Triangle<S>{draw.vector<S>(1), draw.vector<S>(1), draw.vector<S>(1)};
    case 3:
      return Box<S>{draw.vector<S>(1).cwiseAbs()};
    case 4:
      return draw.hull<S>(8, 1);
    default:
      return draw.hull<S>(40, 1);
  }
}

TYPED_TEST(FastCast, RandomPairsAreAnsweredAndRight) {
  using S = typename TypeParam::Number;
  Draw draw{71};
  Tally tally;
  for (int round = 0; round < 4000; ++round) {
    Body<S> a{.shape = some_shape<S>(draw, round), .position = draw.vector<S>(2)};
    Body<S> b{.shape = some_shape<S>(draw, int(draw.bits() % 6)), .position = draw.vector<S>(2)};
    a.displacement = draw.vector<S>(1);
    b.displacement = a.displacement + S(1.5) * (a.position - b.position) + draw.vector<S>(1);
    if (round % 2 == 0) a.orientation = draw.turn<S>();
    if (round % 3 == 0) b.orientation = draw.turn<S>();
    expect_right<TypeParam>(a, b, round % 5 == 0 ? kInfinity<S> : S(1), false, tally);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(tally.hits, 500);
  EXPECT_GT(tally.misses, 500);
  EXPECT_GT(tally.contacts, 100);
  // Flat pairs seen edge on, points on points: the robust search's.
  EXPECT_LT(tally.gave_up, 400);
}

// Paths up to a thousand times as long as the bodies are large: the weights of the portal round by the square of that,
// and are corrected.
TYPED_TEST(FastCast, LongPathsAreAnsweredAndRight) {
  using S = typename TypeParam::Number;
  Draw draw{74};
  Tally tally;
  for (int round = 0; round < 2000; ++round) {
    Body<S> a{.shape = draw.hull<S>(16, 1)}, b{.shape = draw.hull<S>(16, 1)};
    if (round % 2 == 0) a.orientation = draw.turn<S>();
    const S away = static_cast<S>(std::pow(2.0, draw.between(5, 10)));
    Vec3<S> out = draw.vector<S>(1);
    if (out.norm() < S(0.1)) continue;
    out *= away / out.norm();
    b.position = out + draw.vector<S>(S(0.3));
    b.displacement = S(-1.25) * out;
    expect_right<TypeParam>(a, b, S(1), false, tally);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(tally.hits, 1500);
  // In one of a hundred the last step is within the noise that is asked for of how far away C is.
  EXPECT_LT(tally.gave_up, 20);
}

// Nearly every sign is zero: what is claimed all the same is the exact verdict, since on a lattice two things
// are apart or touch.
TYPED_TEST(FastCast, LatticesAreRightOrGivenUp) {
  using S = typename TypeParam::Number;
  Draw draw{72};
  Tally tally;
  const auto small = [&] { return S(int(draw.bits() % 7) - 3); };
  const auto lattice = [&] { return Vec3<S>(small(), small(), small()); };
  for (int round = 0; round < 20000; ++round) {
    const auto shape = [&]() -> Shape<S> {
      if (draw.bits() % 3 == 0) return Box<S>{lattice().cwiseAbs()};
      std::vector<Vec3<S>> list;
      for (std::uint64_t n = 2 + draw.bits() % 9; n > 0; --n) list.push_back(lattice());
      return Hull<S>(std::span<const Vec3<S>>(list));
    };
    const Body<S> a{.shape = shape(), .position = lattice()};
    const Body<S> b{.shape = shape(), .position = 2 * lattice(), .displacement = 3 * lattice()};
    CastResult<S> quick;
    CastOptions<S> options;
    options.method = TypeParam::kMethod;
    if (TypeParam::quick(a, b, options, quick)) {
      const Outcome exact = cast_exact(a, b, options).outcome;
      EXPECT_EQ(quick.outcome, exact) << "round " << round;
    }
    expect_right<TypeParam>(a, b, S(1), true, tally);
    if (this->HasFailure()) return;
  }
  EXPECT_GT(tally.hits, 200);
  EXPECT_GT(tally.misses, 2000);
  EXPECT_GT(tally.contacts, 2000);
}

// The path passes C's silhouette at a distance from a thousandth of the scale down to a thousandth of u
// scale, on either side. A claimed miss is a true miss, and a hit may be a hit of shapes that are moved by
// the noise.
TYPED_TEST(FastCast, GrazesAreRightOrGivenUp) {
  using S = typename TypeParam::Number;
  Draw draw{73};
  Tally tally;
  for (int round = 0; round < 4000; ++round) {
    Body<S> a{.shape = some_shape<S>(draw, 2 + round % 4)};
    Body<S> b{.shape = some_shape<S>(draw, 2 + int(draw.bits() % 4))};
    if (round % 2 == 0) a.orientation = draw.turn<S>();
    b.displacement = draw.vector<S>(3);
    if (b.displacement.norm() < 1) continue;
    const Vec3<double> v = b.displacement.template cast<double>();
    Vec3<double> n = v.cross(draw.vector<double>(1));
    n /= n.norm();
    const double by = std::pow(2.0, -draw.between(10, 63)) * (draw.bits() % 2 ? 1 : -1);
    // Halfway, B's vertex farthest against n is beside A's farthest along n.
    const detail::Cso<double> cso(a, b);
    const Vec3<double> w = std::ldexp(1.0, cso.length_exponent()) * cso.support(n).w;
    b.position = (w + by * n - 0.5 * v).template cast<S>();
    expect_right<TypeParam>(a, b, S(1), true, tally);
    if (this->HasFatalFailure()) return;
  }
  EXPECT_GT(tally.hits, 300);
  EXPECT_GT(tally.misses, 300);
}

TYPED_TEST(FastCast, WhatItDoesNotAnswerChangesOnlyCounters) {
  using S = typename TypeParam::Number;
  const Body<S> a{.shape = Box<S>{{1, 1, 1}}};
  Body<S> b{.shape = Box<S>{{1, 1, 1}}, .position = {S(0.5), 0, 0}, .displacement = {0, -1, 0}};
  CastOptions<S> options;
  CastResult<S> out;
  EXPECT_EQ(detail::kind_of(a, b, S(0)), detail::PairKind::polytopes);
  EXPECT_EQ(detail::kind_of(a, b, S(0.5)), detail::PairKind::round) << "a target distance";
  b.shape = Sphere<S>{1};
  EXPECT_EQ(detail::kind_of(a, b, S(0)), detail::PairKind::round) << "a sphere";
  b.shape = Cone<S>{1, 1};
  EXPECT_EQ(detail::kind_of(a, b, S(0)), detail::PairKind::curved) << "a cone";
  b.shape = Box<S>{{1, 1, 1}};
  options.start_policy = StartPolicy::pass_over;
  EXPECT_FALSE(TypeParam::quick(a, b, options, out)) << "a start in contact that may be passed over";
  EXPECT_EQ(out.outcome, Outcome::invalid_input);
  EXPECT_FALSE(out.proof.has_value());
}

// Lengths and times of any power of two: the same walk, the same bits.
TYPED_TEST(FastCast, PowersOfTwoChangeNoBit) {
  using S = typename TypeParam::Number;
  Draw draw{74};
  int answered = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<Vec3<S>> list_a, list_b;
    for (int i = 0; i < 12; ++i) {
      list_a.push_back(draw.vector<S>(1));
      list_b.push_back(draw.vector<S>(1));
    }
    const Vec3<S> start = draw.vector<S>(3), v = -S(1.5) * start + draw.vector<S>(1);
    const auto ask = [&](int e) {
      const auto scaled = [&](std::vector<Vec3<S>> list) {
        for (Vec3<S>& x : list) x *= S(std::ldexp(1.0, e));
        return Hull<S>(std::span<const Vec3<S>>(list));
      };
      const S unit = S(std::ldexp(1.0, e));
      const Body<S> a{.shape = scaled(list_a)};
      const Body<S> b{.shape = scaled(list_b), .position = unit * start, .displacement = unit * v};
      CastResult<S> out;
      answered += TypeParam::quick(a, b, CastOptions<S>{}, out);
      return out;
    };
    const CastResult<S> one = ask(0);
    for (const int e : {-60, 60}) {
      const CastResult<S> other = ask(e);
      EXPECT_EQ(one.outcome, other.outcome);
      if (one.outcome != Outcome::hit) continue;
      EXPECT_EQ(one.toi_lower, other.toi_lower);
      EXPECT_EQ(one.toi_upper, other.toi_upper);
      EXPECT_EQ(one.normal, other.normal);
    }
  }
  EXPECT_GT(answered, 800);
}

// Report: mpr/double missed a needle that crosses a bar of 5e-12 by 5e-12, 2.3e-13 of scale deep. Mechanism:
// the first portal lay behind the start, and the exit of the line was searched. An axis that rounding had
// tilted towards the path by 1e-5 was tested at the start alone, as if it faced the path. This occurred in
// one of 500,000 such pairs.
TEST(FastWalk, NeedlesThatCrossAreNotMissed) {
  const Quaternion<double> turn{2, 2, -3, 0};
  const Body<double> a{.shape = Segment<double>{{1.14007115829736, 2.5e-12, 2.5e-12},
                                                {-3.4976208060979843, -2.5e-12, -2.5e-12}},
                       .position = {-0.9910950850257102, -11.893141020308523, 11.893141020308523},
                       .orientation = turn,
                       .displacement = {1.255441550822819, 15.065298609873828, -15.065298609873828}};
  const Body<double> b{.shape = Box<double>{{3.3432041062042117, 2.5e-12, 2.5e-12}}, .orientation = turn};
  EXPECT_EQ(cast_exact(a, b).outcome, Outcome::hit);
  CastResult<double> quick;
  const bool answers = detail::fast_cast(a, b, CastOptions<double>{}, quick);
  EXPECT_FALSE(answers && quick.outcome == Outcome::miss);
  EXPECT_EQ(cast_mpr_sweep(a, b).outcome, Outcome::hit);
}

template <class S>
class SweptPolytopes : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(SweptPolytopes, Scalars);

// Report: the standard tier's only wrong verdicts of linear casts were starts that touch, 2 to 8 of 840, and it took longer
// there than the exact tier. Mechanism: the quick walk gave up, and the portal search began anew and called what lies
// within its noise contact. On a lattice bodies touch or are well apart: every verdict is the exact one.
TYPED_TEST(SweptPolytopes, StartsThatTouchAreRight) {
  using S = TypeParam;
  Draw draw{75};
  const auto number = [&](int reach) { return S(int(draw.bits() % unsigned(2 * reach + 1)) - reach) / 64; };
  const auto vector = [&](int reach) { return Vec3<S>(number(reach), number(reach), number(reach)); };
  int touching = 0, apart = 0;
  long supports = 0, exact_supports = 0;
  for (int round = 0; round < 8000; ++round) {
    const auto shape = [&]() -> Shape<S> {
      if (draw.bits() % 3 == 0) return Box<S>{vector(40).cwiseAbs()};
      std::vector<Vec3<S>> list;
      for (std::uint64_t n = 4 + draw.bits() % 30; n > 0; --n) list.push_back(vector(60));
      return Hull<S>(std::span<const Vec3<S>>(list));
    };
    Body<S> a{.shape = shape()}, b{.shape = shape()};
    // Vertex on vertex, along the axes or askew, or one unit of the lattice apart.
    const detail::Cso<double> cso(a, b);
    const Vec3<double> n =
        round % 2 == 0 ? Vec3<double>(Vec3<double>::Unit(round / 2 % 3)) : draw.vector<double>(1);
    const Vec3<double> w = std::ldexp(1.0, cso.length_exponent()) * cso.support(n).w;
    b.position = w.cast<S>();
    if (round % 5 == 0) b.position += vector(1);
    if (round % 7 != 0) b.displacement = vector(100);
    const CastResult<S> standard = cast_mpr_sweep(a, b), exact = cast_exact(a, b);
    EXPECT_EQ(standard.method, Method::mpr_sweep);
    EXPECT_EQ(standard.outcome, exact.outcome) << "round " << round;
    if (this->HasFailure()) return;
    ++(exact.outcome == Outcome::initially_overlapping ? touching : apart);
    supports += standard.counters.supports;
    exact_supports += exact.counters.supports;
  }
  EXPECT_GT(touching, 4000);
  EXPECT_GT(apart, 200);
  EXPECT_LT(supports, 2 * exact_supports);
}

}  // namespace
}  // namespace graze
