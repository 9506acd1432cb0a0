#include <gtest/gtest.h>
#include <graze/detail/pairs/cso.hpp>

#include "tests/shared/generate.hpp"

namespace graze {
namespace {

using test::Draw;

// The world coordinates of a body's vertices, the plain way.
std::vector<Vec3<double>> posed(const Body<double>& body) {
  std::vector<Vec3<double>> out;
  const auto add = [&](const Vec3<double>& x) {
    out.push_back(body.position + detail::rotation_matrix(body.orientation) * x);
  };
  if (const auto* hull = std::get_if<Hull<double>>(&body.shape)) {
    for (const auto& v : hull->vertices()) add(v);
  } else if (const auto* box = std::get_if<Box<double>>(&body.shape)) {
    for (int k = 0; k < 8; ++k) {
      add(Vec3<double>((k & 1 ? 1 : -1) * box->half_extents[0], (k & 2 ? 1 : -1) * box->half_extents[1],
                       (k & 4 ? 1 : -1) * box->half_extents[2]));
    }
  } else {
    add(Vec3<double>::Zero());
  }
  return out;
}

TEST(Cso, SupportIsTheGreatestVertexDifference) {
  Draw draw{1};
  for (int round = 0; round < 300; ++round) {
    Body<double> a, b;
    a.shape = draw.hull<double>(3 + round % 30, 1);
    if (round % 3 == 0) a.shape = Box<double>{draw.vector<double>(1).cwiseAbs()};
    b.shape = draw.hull<double>(1 + round % 7, 2);
    a.position = draw.vector<double>(5);
    b.position = draw.vector<double>(5);
    a.orientation = draw.turn<double>();
    if (round % 2) b.orientation = draw.turn<double>();
    const detail::Cso<double> cso(a, b);
    const Vec3<double> n = draw.vector<double>(1);
    double brute = -kInfinity<double>;
    for (const auto& x : posed(a)) {
      for (const auto& y : posed(b)) brute = std::max(brute, n.dot(x - y));
    }
    const detail::CsoPoint<double> p = cso.support(n);
    // reach_error() bounds the support's error, and the brute force has as much of its own.
    const double slack = 2 * cso.to_length(cso.reach_error()) * n.norm();
    EXPECT_NEAR(cso.to_length(n.dot(p.w)), brute, slack) << round;
    EXPECT_LT(slack, 1e-11);
    const auto va = posed(a), vb = posed(b);
    EXPECT_NEAR(n.dot(va[p.vertex_a] - vb[p.vertex_b]), brute, slack)
        << "the named vertices, round " << round;
  }
}

TEST(Cso, CommonOffsetOfVerticesCostsNothing) {
  Draw draw{2};
  for (const double offset : {0x1p20, 0x1p40, 0x1p50}) {
    Body<double> a, b, far_a, far_b;
    std::vector<Vec3<double>> va, vb;
    // Integers: exact at every offset tried.
    for (int i = 0; i < 8; ++i) {
      va.push_back(draw.vector<double>(9).array().round());
      vb.push_back(draw.vector<double>(9).array().round());
    }
    a.shape = Hull<double>(std::span<const Vec3<double>>(va));
    b.shape = Hull<double>(std::span<const Vec3<double>>(vb));
    for (auto* list : {&va, &vb}) {
      for (auto& v : *list) v += Vec3<double>(offset, -offset, offset);
    }
    far_a.shape = Hull<double>(std::span<const Vec3<double>>(va));
    far_b.shape = Hull<double>(std::span<const Vec3<double>>(vb));
    const detail::Cso<double> near(a, b), far(far_a, far_b);
    for (int round = 0; round < 20; ++round) {
      const Vec3<double> n = draw.vector<double>(1);
      const double h_near = near.to_length(n.dot(near.support(n).w)),
                   h_far = far.to_length(n.dot(far.support(n).w));
      EXPECT_NEAR(h_near, h_far, 64 * kUnitRoundoff<double> * 40) << offset;
    }
  }
}

TEST(Cso, RotatedLargeOffsetIsRemovedInDoubledPrecision) {
  // Both bodies turned by the same half turn about z, (0, 0, 0, 1): x and y change sign, exactly.
  Body<double> a, b;
  a.shape = Hull<double>{{0x1p40, 0, 0}, {0x1p40 + 1, 0, 0}, {0x1p40, 1, 0}, {0x1p40, 0, 1}};
  b.shape = Hull<double>{{0x1p40 + 3, 0, 0}, {0x1p40 + 4, 0, 0}, {0x1p40 + 3, 1, 0}, {0x1p40 + 3, 0, 1}};
  a.orientation = b.orientation = {3, 1, 2, 5};  // no exact matrix: 39 is no square of a double
  const detail::Cso<double> cso(a, b);
  const Vec3<double> n = detail::rotation_matrix(a.orientation) * Vec3<double>(1, 0, 0);
  // max over A of x minus min over B of x, in the common body frame: 1 - 3.
  EXPECT_NEAR(cso.to_length(n.dot(cso.support(n).w)), -2, 64 * kUnitRoundoff<double> * 4);
}

TEST(Cso, PowersOfTwoChangeNoBit) {
  Draw draw{3};
  Body<double> a, b;
  const Hull<double> shape = draw.hull<double>(9, 1);
  a.shape = shape;
  b.shape = Sphere<double>{0.3};
  b.position = draw.vector<double>(3);
  b.displacement = draw.vector<double>(3);
  const double factor = 0x1p-77;
  Body<double> small_a = a, small_b = b;
  std::vector<Vec3<double>> v(shape.vertices().begin(), shape.vertices().end());
  for (auto& x : v) x *= factor;
  small_a.shape = Hull<double>(std::span<const Vec3<double>>(v));
  small_b.shape = Sphere<double>{0.3 * factor};
  small_b.position *= factor;
  small_b.displacement *= factor;
  const detail::Cso<double> big(a, b), small(small_a, small_b);
  EXPECT_EQ(big.scale(), small.scale());
  EXPECT_EQ(big.direction(), small.direction());
  EXPECT_EQ(big.radius(), small.radius());
  for (int round = 0; round < 20; ++round) {
    const Vec3<double> n = draw.vector<double>(1);
    EXPECT_EQ(big.support(n).w, small.support(n).w);
  }
  EXPECT_EQ(big.to_time(0.7), small.to_time(0.7));
}

}  // namespace
}  // namespace graze
