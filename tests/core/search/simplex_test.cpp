#include <gtest/gtest.h>
#include <graze/detail/search/robust/simplex.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

// v is closest to the origin among the hull of y_i iff v.y_i >= v.v for all i (Wolfe 1976). Here n = -v / |v|
// is found from the feature and is accurate where v is small.
template <class S>
void expect_closest(const detail::Simplex<S>& simplex, const char* what, int round) {
  const detail::Closest<S> closest = detail::closest_to_origin(simplex, Vec3<S>(Vec3<S>::Zero()));
  Vec3<S> v = Vec3<S>::Zero();
  S sum = 0, longest = 0;
  for (int i = 0; i < closest.size; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    EXPECT_GE(closest.lambda[k], 0) << what << round;
    v += closest.lambda[k] * simplex.point[closest.index[k]].w;
    sum += closest.lambda[k];
  }
  for (int i = 0; i < simplex.size; ++i) {
    longest = std::max(longest, simplex.point[static_cast<std::size_t>(i)].w.norm());
  }
  const S slack = 32 * kUnitRoundoff<S> * longest;
  EXPECT_NEAR(sum, 1, 8 * kUnitRoundoff<S>) << what << round;
  EXPECT_NEAR(v.norm(), std::sqrt(closest.dist_sq), slack) << what << round;
  if (closest.size == 4 || v.norm() <= slack) return;
  EXPECT_NEAR(closest.n.norm(), 1, 4 * kUnitRoundoff<S>) << what << round;
  for (int i = 0; i < simplex.size; ++i) {
    const Vec3<S>& y = simplex.point[static_cast<std::size_t>(i)].w;
    EXPECT_GE(-closest.n.dot(y), v.norm() - slack) << what << round << " corner " << i;
  }
}

template <class S>
detail::Simplex<S> random_simplex(Draw& draw, int size, double spread, const Vec3<S>& at) {
  detail::Simplex<S> out;
  for (int i = 0; i < size; ++i) {
    detail::CsoPoint<S> p;
    p.w = at + draw.vector<S>(spread);
    p.vertex_a = static_cast<std::uint32_t>(i);
    out.add(p);
  }
  return out;
}

TEST(Simplex, ClosestPointIsOptimal) {
  Draw draw{11};
  std::array<int, 5> reached{};
  for (int round = 0; round < 4000; ++round) {
    const int size = 1 + round % 4;
    const auto simplex =
        random_simplex<double>(draw, size, 1, draw.vector<double>(round % 8 < 4 ? 0.7 : 0.2));
    expect_closest(simplex, "double ", round);
    ++reached[static_cast<std::size_t>(
        detail::closest_to_origin(simplex, Vec3<double>(Vec3<double>::Zero())).size)];
    expect_closest(random_simplex<float>(draw, size, 1, draw.vector<float>(0.7)), "float ", round);
  }
  for (std::size_t k = 1; k <= 4; ++k) EXPECT_GT(reached[k], 50) << "features of " << k << " points";
}

TEST(Simplex, FlatAndRepeatedCornersAreHarmless) {
  Draw draw{12};
  for (int round = 0; round < 400; ++round) {
    auto simplex = random_simplex<double>(draw, 4, 1, Vec3<double>(2, 0, 0));
    switch (round % 4) {
      case 0:
        simplex.point[3].w = simplex.point[1].w;
        break;
      case 1:
        simplex.point[3].w = (simplex.point[1].w + simplex.point[0].w) / 2;
        break;
      case 2:
        simplex.point[3].w = simplex.point[0].w + simplex.point[1].w - simplex.point[2].w;
        break;
      default:
        for (auto& p : simplex.point) p.w = simplex.point[0].w;
    }
    expect_closest(simplex, "degenerate ", round);
  }
}

// Two corners 1e-7 apart and a third far off: the normal by the two long edges would round along them.
TEST(Simplex, SliverNormalIsRelativeToItsArea) {
  const Vec3<double> a(0.3, 0.4, 1), b(0.3 + 1e-7, 0.4, 1), c(0.7, -0.9, 1);
  for (const auto& n :
       {detail::face_normal(a, b, c), detail::face_normal(b, c, a), detail::face_normal(c, a, b)}) {
    const Vec3<double> m = n / n.norm();
    EXPECT_LT(std::hypot(m[0], m[1]), 4 * kUnitRoundoff<double>);
  }
}

TEST(Simplex, NotANumberHasNoClosestPoint) {
  detail::Simplex<double> simplex;
  detail::CsoPoint<double> p;
  p.w = Vec3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
  simplex.add(p);
  EXPECT_FALSE(detail::closest_to_origin(simplex, Vec3<double>(Vec3<double>::Zero())).dist_sq <
               kInfinity<double>);
}

}  // namespace
}  // namespace graze
