#include <gtest/gtest.h>
#include <graze/detail/search/robust/gjk.hpp>
#include <graze/distance.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

struct Measured {
  detail::Distance<double> d;
  Counters counters;
};

Measured distance(const Body<double>& a, const Body<double>& b, int budget = 256) {
  const detail::Cso<double> cso(a, b);
  detail::Simplex<double> simplex;
  Measured out;
  out.d = detail::gjk_distance(cso, Vec3<double>(Vec3<double>::Zero()), simplex, 1e-15, 1e-15, budget,
                               out.counters);
  out.d.lower = cso.to_length(out.d.lower);
  out.d.upper = cso.to_length(out.d.upper);
  return out;
}

TEST(GjkDistance, AlignedBoxesHaveAClosedForm) {
  Draw draw{21};
  for (int round = 0; round < 500; ++round) {
    const Vec3<double> ha = draw.vector<double>(1).cwiseAbs(), hb = draw.vector<double>(1).cwiseAbs();
    Body<double> a{.shape = Box<double>{ha}}, b{.shape = Box<double>{hb}};
    b.position = draw.vector<double>(4);
    const Vec3<double> gap = (b.position.cwiseAbs() - ha - hb).cwiseMax(0.0);
    const Measured m = distance(a, b);
    EXPECT_NEAR(m.d.upper, gap.norm(), 16 * kUnitRoundoff<double> * 8) << round;
    EXPECT_LE(m.d.lower, gap.norm() + 16 * kUnitRoundoff<double> * 8) << round;
    if (gap.norm() > 0) {
      EXPECT_NEAR(m.d.lower, m.d.upper, 64 * kUnitRoundoff<double> * 8) << round;
      EXPECT_LT((m.d.n - gap.cwiseProduct(b.position.cwiseSign()) / gap.norm()).norm(), 1e-9) << round;
    }
  }
}

TEST(GjkDistance, AxisProvesTheLowerBound) {
  Draw draw{22};
  for (int round = 0; round < 300; ++round) {
    Body<double> a{.shape = draw.hull<double>(12, 1)}, b{.shape = draw.hull<double>(20, 1)};
    b.position = draw.vector<double>(3);
    a.orientation = draw.turn<double>();
    const detail::Cso<double> cso(a, b);
    const Measured m = distance(a, b);
    if (m.d.n == Vec3<double>::Zero()) continue;
    EXPECT_NEAR(m.d.n.norm(), 1, 4 * kUnitRoundoff<double>);
    EXPECT_NEAR(cso.to_length(-m.d.n.dot(cso.support(m.d.n).w)), m.d.lower, 16 * kUnitRoundoff<double> * 8);
  }
}

TEST(GjkDistance, SpentBudgetIsAStallWithAnHonestBracket) {
  Draw draw{23};
  int stalls = 0;
  for (int round = 0; round < 100; ++round) {
    Body<double> a{.shape = draw.hull<double>(30, 1)}, b{.shape = draw.hull<double>(30, 1)};
    b.position = Vec3<double>(3, 2, 1) + draw.vector<double>(0.2);
    const double true_distance = distance(a, b).d.upper;
    const Measured m = distance(a, b, 1);
    stalls += m.d.stalled;
    EXPECT_LE(m.d.lower, true_distance + 1e-14);
    EXPECT_GE(m.d.upper, true_distance - 1e-14);
  }
  EXPECT_GT(stalls, 50);
}

TEST(GjkDistance, NotANumberEndsTheSearch) {
  Body<double> a{.shape = Box<double>{{1, 1, 1}}}, b{.shape = Box<double>{{1, 1, 1}}};
  const detail::Cso<double> cso(a, b);
  detail::Simplex<double> simplex;
  Counters counters;
  const Vec3<double> x = Vec3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
  const detail::Distance<double> d = detail::gjk_distance(cso, x, simplex, 0.0, 0.0, 256, counters);
  EXPECT_FALSE(d.lower > 0);
  EXPECT_TRUE(d.stalled);
  EXPECT_LT(counters.supports, 5);
}

}  // namespace
}  // namespace graze
