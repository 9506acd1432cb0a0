// A point that is greatest along a direction, computed in floats, of points stored by axis: the scan of
// scan.hpp for few points, where calls, loops and buffers cost more than the sums. The first of those that tie.
//
// n counts whole blocks of 8 (hull.hpp). Up to 64 points the count is a constant of the code.
#pragma once

#include <graze/detail/shapes/scan.hpp>
#include <graze/detail/shapes/wide_scan.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The scan of 8 kBlocks points.
template <std::size_t kBlocks>
[[gnu::always_inline]] inline std::uint32_t approximate_scan_blocks(const float* x, float d_x, float d_y,
                                                                    float d_z) {
  using P = Pack<float>;
  constexpr std::size_t n = 8 * kBlocks;
  const P::Type dx = P::all(d_x), dy = P::all(d_y), dz = P::all(d_z);
  P::Type value[2 * kBlocks];
#pragma GCC unroll 16
  for (std::size_t i = 0; i < 2 * kBlocks; ++i) {
    const float* p = x + 4 * i;
    value[i] =
        P::add(P::add(P::mul(P::load(p), dx), P::mul(P::load(p + n), dy)), P::mul(P::load(p + 2 * n), dz));
  }
  P::Type most = P::max(value[0], value[1]);
#pragma GCC unroll 16
  for (std::size_t i = 2; i < 2 * kBlocks; i += 2) most = P::max(most, P::max(value[i], value[i + 1]));
  most = P::all(P::greatest(most));
  // A bit for each value that is equal. NaN, which finite coordinates and directions do not make, gives the last.
  std::uint64_t equal = std::uint64_t{1} << (n - 1);
#pragma GCC unroll 16
  for (std::size_t i = 0; i < 2 * kBlocks; i += 2) {
    const unsigned bits = P::bits(P::equal(value[i], most)) | P::bits(P::equal(value[i + 1], most)) << 4;
    equal |= std::uint64_t{bits} << (4 * i);
  }
  return static_cast<std::uint32_t>(std::countr_zero(equal));
}
template <std::size_t kBlocks>
[[gnu::noinline]] inline std::uint32_t called_approximate_scan(const float* x, float d_x, float d_y,
                                                               float d_z) {
  return approximate_scan_blocks<kBlocks>(x, d_x, d_y, d_z);
}

// Without wide instructions.
[[nodiscard, gnu::always_inline]] inline std::uint32_t narrow_approximate_scan(const float* x, std::size_t n,
                                                                               float d_x, float d_y,
                                                                               float d_z) {
  if (n == 8) return approximate_scan_blocks<1>(x, d_x, d_y, d_z);
  if (n == 16) return approximate_scan_blocks<2>(x, d_x, d_y, d_z);
  switch (n / 8) {
    case 3:
      return called_approximate_scan<3>(x, d_x, d_y, d_z);
    case 4:
      return called_approximate_scan<4>(x, d_x, d_y, d_z);
    case 5:
      return called_approximate_scan<5>(x, d_x, d_y, d_z);
    case 6:
      return called_approximate_scan<6>(x, d_x, d_y, d_z);
    case 7:
      return called_approximate_scan<7>(x, d_x, d_y, d_z);
    case 8:
      return called_approximate_scan<8>(x, d_x, d_y, d_z);
    default:
      return static_cast<std::uint32_t>(scan(x, x + n, x + 2 * n, n, Vec3<float>(d_x, d_y, d_z)));
  }
}

[[nodiscard, gnu::always_inline]] inline std::uint32_t approximate_scan(const float* x, std::size_t n,
                                                                        float d_x, float d_y, float d_z) {
#if GRAZE_WIDE
  if (n > 16 && n <= kScanChunk && is_wide()) return wide_scan(x, x + n, x + 2 * n, n, d_x, d_y, d_z);
#endif
  return narrow_approximate_scan(x, n, d_x, d_y, d_z);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
