// The guess scans, narrow and wide, against a plain loop: the first of the points that are greatest as floats round.
#include <gtest/gtest.h>

#include <graze/detail/shapes/approximate_scan.hpp>
#include <vector>

#include "tests/shared/large_hulls.hpp"

namespace graze {
namespace {

using test::Draw;

// Kept from the compiler, so that no product is fused with its sum.
float rounded(float x) {
  volatile float out = x;
  return out;
}

std::size_t first_of_greatest(const std::vector<float>& xyz, const Vec3<float>& d) {
  const std::size_t n = xyz.size() / 3;
  std::size_t best = 0;
  float top = -kInfinity<float>;
  for (std::size_t k = 0; k < n; ++k) {
    const float xy = rounded(rounded(xyz[k] * d[0]) + rounded(xyz[n + k] * d[1])),
                height = rounded(xy + rounded(xyz[2 * n + k] * d[2]));
    if (!(height > top)) continue;
    top = height;
    best = k;
  }
  return best;
}

// Vertices apart, vertices on a lattice, where many tie, or a few ulps about one point, where rounding
// decides.
enum class Kind { apart, lattice, near };

// Whole blocks, of which the last points are copies of the first, as hulls pad them.
std::vector<float> points(Draw& draw, std::size_t n, Kind kind) {
  std::vector<float> out(3 * n);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto x = static_cast<float>(draw.between(-1, 1));
    out[i] = x;
    if (kind == Kind::lattice) out[i] = std::round(2 * x) / 2;
    if (kind == Kind::near) out[i] = (0.3F + 0.2F * float(i / n)) * (1 + 0x1p-21F * x);
  }
  for (std::size_t k = n - draw.bits() % 8; k < n; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) out[axis * n + k] = out[axis * n];
  }
  return out;
}

template <class Scan>
void expect_first_of_greatest(std::size_t most, const Scan& scan) {
  Draw draw{71};
  for (std::size_t n = 8; n <= most; n += 8) {
    for (int round = 0; round < 400; ++round) {
      const auto kind = static_cast<Kind>(round % 3);
      const std::vector<float> xyz = points(draw, n, kind);
      Vec3<float> d = draw.vector<float>(1);
      if (kind == Kind::lattice) d = (4 * d).array().round();
      ASSERT_EQ(scan(xyz.data(), n, d), first_of_greatest(xyz, d)) << n << ": " << d.transpose();
    }
  }
}

TEST(GuessScan, TheFirstOfTheGreatest) {
  expect_first_of_greatest(160, [](const float* x, std::size_t n, const Vec3<float>& d) {
    return detail::approximate_scan(x, n, d[0], d[1], d[2]);
  });
}

TEST(GuessScan, TheSameWithoutWideInstructions) {
  expect_first_of_greatest(160, [](const float* x, std::size_t n, const Vec3<float>& d) {
    return detail::narrow_approximate_scan(x, n, d[0], d[1], d[2]);
  });
}

#if GRAZE_WIDE
TEST(GuessScan, TheSameByWideInstructions) {
  if (!detail::is_wide()) GTEST_SKIP() << "this processor has none";
  expect_first_of_greatest(64, [](const float* x, std::size_t n, const Vec3<float>& d) {
    return detail::wide_scan(x, x + n, x + 2 * n, n, d[0], d[1], d[2]);
  });
}
#endif

}  // namespace
}  // namespace graze
