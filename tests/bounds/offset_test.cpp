// Sums of two doubles, posed points and offsets (offset.hpp, turn.hpp's root) against balls: each relative or
// absolute error that the headers state.
#include <gtest/gtest.h>

#include <graze/detail/rotating/turn.hpp>

#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"
#include "tests/bounds/describe.hpp"

namespace graze::test {
namespace {

using detail::TwoDoubles;
using detail::TwoDoubles3;
using oracle::WorkingPrecision;

constexpr double kU = kUnitRoundoff<double>;

Ball exactly(const TwoDoubles& x) { return Ball(x.hi) + Ball(x.lo); }
BallVec exactly(const TwoDoubles3& x) { return {exactly(x[0]), exactly(x[1]), exactly(x[2])}; }

class DrawTwo : public HostileDraw {
 public:
  using HostileDraw::HostileDraw;

  // |lo| <= u |hi|, often at the bound, sometimes 0 or far below.
  TwoDoubles two(double low, double high) {
    double hi = power(low, high);
    if (chance(0.2)) hi = std::exp2(std::floor(std::log2(hi)));
    if (chance(0.3)) hi = std::exp2(std::floor(std::log2(hi))) * (2 - power(-52, -40));
    if (chance(0.5)) hi = -hi;
    double lo =
        chance(0.2) ? 0.0 : hi * plain().between(-1, 1) * 0x1p-53 * (chance(0.3) ? power(-60, 0) : 1.0);
    if (chance(0.2)) lo = std::copysign(hi * 0x1p-54, plain().between(-1, 1));
    return detail::two_sum(hi, lo);
  }
  // Cancels x except in its last places, or cancels its lower part only.
  TwoDoubles against(const TwoDoubles& x) {
    switch (below(3)) {
      case 0:
        return detail::two_sum(-nudged(x.hi), -x.lo * plain().between(0, 2));
      case 1:
        return detail::two_sum(-x.hi, x.lo * plain().between(-1, 1));
      default:
        return detail::two_sum(-x.hi * (1 + power(-53, 0)), -x.lo);
    }
  }
};

std::string text(const TwoDoubles& x, const TwoDoubles& y) {
  std::ostringstream out;
  out << std::hexfloat << "  " << x.hi << " + " << x.lo << ", " << y.hi << " + " << y.lo << "\n";
  return out.str();
}

TEST(OffsetBounds, SumsAndProductsOfTwoDoublesAreExact) {
  const WorkingPrecision precision(4096);
  DrawTwo draw(41);
  for (int i = 0; i < rounds(4000); ++i) {
    const double a = draw.two(-400, 400).hi, b = draw.chance(0.5) ? draw.two(-400, 400).hi : -draw.nudged(a);
    EXPECT_TRUE((exactly(detail::two_sum(a, b)) - (Ball(a) + Ball(b))).is_zero()) << a << " " << b;
    EXPECT_TRUE((exactly(detail::two_product(a, b)) - Ball(a) * Ball(b)).is_zero()) << a << " " << b;
  }
}

TEST(OffsetBounds, OperatorsOfTwoDoubles) {
  const WorkingPrecision precision(2048);
  DrawTwo draw(42);
  Tally plus("x + y, two doubles, over 2^-100"), product("x y"), quotient("x / y"), root("root(x)"),
      times("times(x, t)");
  for (int i = 0; i < rounds(6000); ++i) {
    const TwoDoubles x = draw.two(-100, 100), y = draw.chance(0.5) ? draw.against(x) : draw.two(-100, 100);
    const auto with = [&] { return text(x, y); };
    const auto add = [&](Tally& tally, const TwoDoubles& seen, const Ball& truth) {
      if (truth.is_zero()) {
        tally.add(seen.hi == 0 && seen.lo == 0 ? 0.0 : -1.0, 0, with);
      } else {
        tally.add(0x1p-100, abs((exactly(seen) - truth) / truth), with);
      }
    };
    add(plus, x + y, exactly(x) + exactly(y));
    add(product, x * y, exactly(x) * exactly(y));
    if (y.hi != 0) add(quotient, x / y, exactly(x) / exactly(y));
    const TwoDoubles positive = x.hi > 0 ? x : -x;
    add(root, detail::root(positive), sqrt(exactly(positive)));
    const double t = draw.power(-200, 900);
    add(times, detail::times(x, t), exactly(x) * Ball(t));
  }
  for (Tally* one : {&plus, &product, &quotient, &root, &times}) one->finish(1000);
}

// Components of one size, of many, and at the ends of the range that validation accepts.
Quaternion<double> any_quaternion(HostileDraw& draw) {
  Quaternion<double> q = draw.plain().turn<double>();
  switch (draw.below(6)) {
    case 0:
      q = {1, draw.nudged(1.0), draw.chance(0.5) ? 0.0 : draw.power(-60, -50), 0};
      break;
    case 1:
      for (double* c : {&q.w, &q.x, &q.y, &q.z}) *c *= draw.power(-90, 90);
      break;
    case 2:
      q = {1, draw.power(-199, -20), 0, 0};
      break;
    case 3:
      q = {draw.power(-199, -20), 1, draw.nudged(1.0), 1};
      break;
    default:
      break;
  }
  if (draw.chance(0.3)) {
    const double power = std::exp2(std::floor(draw.power(0, 6.7)) * (draw.chance(0.5) ? 1 : -1));
    q = {q.w * power, q.x * power, q.y * power, q.z * power};
  }
  return q;
}
std::string text(const Quaternion<double>& q, const Vec3<double>& c) {
  std::ostringstream out;
  out << std::hexfloat << "  q " << q << " c ";
  write(out, c);
  out << "\n";
  return out.str();
}

TEST(OffsetBounds, RotatedPointsAndMatrices) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(43);
  Tally rotated("rotate_accurately, over 2^-98 |c|"), matrix("rotation_matrix, an entry over 9 u"),
      rows("rotation_rows, an entry over 2^-98"), accurate("accurate_rotation_matrix, an entry over 0.6 u");
  for (int i = 0; i < rounds(2500); ++i) {
    const Quaternion<double> q = any_quaternion(draw);
    Vec3<double> c = draw.plain().vector<double>(1) * draw.power(-150, 150);
    if (draw.chance(0.3)) c = draw.nudged(Vec3<double>(draw.power(-5, 40) * Vec3<double>(q.x, q.y, q.z)));
    if (!(c.cwiseAbs().maxCoeff() > 0)) continue;
    const auto with = [&] { return text(q, c); };
    const BallRotation truth(q);
    rotated.add(0x1p-98,
                norm(exactly(detail::rotate_accurately(q, c)) - truth.apply(BallVec(c))) / norm(BallVec(c)),
                with);
    const Mat3<double> quick = detail::rotation_matrix(q), fine = detail::accurate_rotation_matrix(q);
    const auto two = detail::rotation_rows(q);
    Ball of_fast, of_fine, of_rows;
    for (int k = 0; k < 3; ++k) {
      const BallVec column = truth.apply(BallVec(Vec3<double>(Vec3<double>::Unit(k))));
      const auto widen = [&](Ball& most, const BallVec& seen) {
        const BallVec off = seen - column;
        most = max(most, max(abs(off.x), max(abs(off.y), abs(off.z))));
      };
      const auto j = static_cast<std::size_t>(k);
      widen(of_fast, BallVec(Vec3<double>(quick.col(k))));
      widen(of_fine, BallVec(Vec3<double>(fine.col(k))));
      widen(of_rows, exactly(TwoDoubles3{two[0][j], two[1][j], two[2][j]}));
    }
    matrix.add(9 * kU, of_fast, with);
    accurate.add(0.6 * kU, of_fine, with);
    rows.add(0x1p-98, of_rows, with);
    if (detail::permutes_axes(q)) {
      EXPECT_TRUE(of_fast.is_zero() && of_fine.is_zero()) << with();
    }
  }
  for (Tally* one : {&rotated, &matrix, &rows, &accurate}) one->finish(500);
}

// The 24 rotations that permute axes are exact, whatever the components' size.
TEST(OffsetBounds, AMatrixThatPermutesAxesIsExact) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(44);
  for (int i = 0; i < rounds(1000); ++i) {
    const double m = draw.power(-190, 190);
    std::array<double, 4> c{};
    const std::uint64_t kind = draw.below(3);
    for (std::size_t k = 0; k < 4; ++k) {
      const bool here = kind == 0 ? k == static_cast<std::size_t>(i) % 4 : kind == 1 ? (k + i) % 4 < 2 : true;
      c[k] = here ? (draw.chance(0.5) ? m : -m) : 0.0;
    }
    const Quaternion<double> q{c[0], c[1], c[2], c[3]};
    ASSERT_TRUE(detail::permutes_axes(q));
    const BallRotation truth(q);
    for (int k = 0; k < 3; ++k) {
      const BallVec column = truth.apply(BallVec(Vec3<double>(Vec3<double>::Unit(k))));
      for (const Mat3<double>& seen : {detail::rotation_matrix(q), detail::accurate_rotation_matrix(q)}) {
        // An exact entry is an integer, and the ball that holds it holds no other.
        const BallVec off = BallVec(Vec3<double>(seen.col(k))) - column;
        EXPECT_EQ(seen.col(k), Vec3<double>(seen.col(k).array().round()));
        EXPECT_TRUE(certainly_less(norm(off), Ball(0x1p-900))) << m;
      }
    }
  }
}

TEST(OffsetBounds, OffsetsOfPosedCentres) {
  const WorkingPrecision precision(kTruthBits);
  HostileDraw draw(45);
  Tally offset("accurate_offset"), placed("placed_center");
  for (int i = 0; i < rounds(2500); ++i) {
    const Quaternion<double> q_a = any_quaternion(draw), q_b = draw.chance(0.3) ? q_a : any_quaternion(draw);
    const double size = draw.chance(0.7) ? 1.0 : draw.power(-150, 110);
    const auto far = [&] { return Vec3<double>(draw.plain().vector<double>(size * draw.power(-10, 40))); };
    const Vec3<double> c_a = far(), c_b = draw.chance(0.3) ? draw.nudged(c_a) : far();
    const Vec3<double> p_a = far();
    const BallRotation turn_a(q_a), turn_b(q_b);
    const BallVec there = BallVec(p_a) + turn_a.apply(BallVec(c_a)), arm = turn_b.apply(BallVec(c_b));
    // Often the centres meet, except for the rounding of p_b.
    const Vec3<double> p_b = draw.chance(0.6) ? draw.nudged((there - arm).mid_double()) : far();
    const auto with = [&] {
      return text(q_a, c_a) + text(q_b, c_b) + "  p_a " + describe(p_a) + " p_b " + describe(p_b) + "\n";
    };
    const Vec3<double> seen = detail::accurate_offset(p_a, q_a, c_a, p_b, q_b, c_b);
    const BallVec truth = BallVec(p_b) + arm - there;
    const Ball lengths = norm(BallVec(c_a)) + norm(BallVec(c_b));
    // The bound as a ball, over the bounded quantity.
    const auto over = [](const Ball& bound, const Ball& error) {
      return bound.is_positive() ? error / bound : error;
    };
    offset.add(1, over(Ball(2 * kU) * norm(truth) + two_to(-97) * lengths, norm(BallVec(seen) - truth)),
               with);
    const Vec3<double> center = detail::placed_center(p_b, q_b, c_b);
    const BallVec stands = BallVec(p_b) + arm;
    placed.add(
        1,
        over(Ball(2 * kU) * norm(stands) + two_to(-97) * norm(BallVec(c_b)), norm(BallVec(center) - stands)),
        with);
  }
  offset.finish(1000);
  placed.finish(1000);
}

}  // namespace
}  // namespace graze::test
