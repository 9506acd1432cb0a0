// A point that is greatest along a direction, computed in floats, of points stored by axis: the scan of
// scan.hpp for few points, where calls, loops and buffers cost more than the sums. The first of those that tie.
//
// n counts whole blocks of 8 (hull.hpp). Up to 64 points the count is a constant of the code.
#pragma once

#include <graze/detail/shapes/scan.hpp>
#include <graze/detail/shapes/wide_scan.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

#if defined(__SSE2__)
// The scan of 8 kBlocks points.
template <std::size_t kBlocks>
[[gnu::always_inline]] inline std::uint32_t approximate_scan_blocks(const float* x, __m128 dx, __m128 dy,
                                                                    __m128 dz) {
  constexpr std::size_t n = 8 * kBlocks;
  __m128 value[2 * kBlocks];
#pragma GCC unroll 16
  for (std::size_t i = 0; i < 2 * kBlocks; ++i) {
    const float* p = x + 4 * i;
    using P = Pack<float>;
    value[i] = _mm_add_ps(_mm_add_ps(P::mul(_mm_loadu_ps(p), dx), P::mul(_mm_loadu_ps(p + n), dy)),
                          P::mul(_mm_loadu_ps(p + 2 * n), dz));
  }
  __m128 most = _mm_max_ps(value[0], value[1]);
#pragma GCC unroll 16
  for (std::size_t i = 2; i < 2 * kBlocks; i += 2)
    most = _mm_max_ps(most, _mm_max_ps(value[i], value[i + 1]));
  most = _mm_max_ps(most, _mm_shuffle_ps(most, most, _MM_SHUFFLE(1, 0, 3, 2)));
  most = _mm_max_ps(most, _mm_shuffle_ps(most, most, _MM_SHUFFLE(2, 3, 0, 1)));
  // A bit for each value that is equal. NaN, which finite coordinates and directions do not make, gives the last.
  std::uint64_t equal = std::uint64_t{1} << (n - 1);
#pragma GCC unroll 16
  for (std::size_t i = 0; i < 2 * kBlocks; i += 2) {
    const __m128i both = _mm_packs_epi32(_mm_castps_si128(_mm_cmpeq_ps(value[i], most)),
                                         _mm_castps_si128(_mm_cmpeq_ps(value[i + 1], most)));
    const auto bits = static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(both, _mm_setzero_si128())));
    equal |= std::uint64_t{bits} << (4 * i);
  }
  return static_cast<std::uint32_t>(std::countr_zero(equal));
}
template <std::size_t kBlocks>
[[gnu::noinline]] inline std::uint32_t called_approximate_scan(const float* x, __m128 dx, __m128 dy,
                                                               __m128 dz) {
  return approximate_scan_blocks<kBlocks>(x, dx, dy, dz);
}

// Without wide instructions.
[[nodiscard, gnu::always_inline]] inline std::uint32_t narrow_approximate_scan(const float* x, std::size_t n,
                                                                               float d_x, float d_y,
                                                                               float d_z) {
  const __m128 dx = _mm_set1_ps(d_x), dy = _mm_set1_ps(d_y), dz = _mm_set1_ps(d_z);
  if (n == 8) return approximate_scan_blocks<1>(x, dx, dy, dz);
  if (n == 16) return approximate_scan_blocks<2>(x, dx, dy, dz);
  switch (n / 8) {
    case 3:
      return called_approximate_scan<3>(x, dx, dy, dz);
    case 4:
      return called_approximate_scan<4>(x, dx, dy, dz);
    case 5:
      return called_approximate_scan<5>(x, dx, dy, dz);
    case 6:
      return called_approximate_scan<6>(x, dx, dy, dz);
    case 7:
      return called_approximate_scan<7>(x, dx, dy, dz);
    case 8:
      return called_approximate_scan<8>(x, dx, dy, dz);
    default:
      return static_cast<std::uint32_t>(scan(x, x + n, x + 2 * n, n, Vec3<float>(d_x, d_y, d_z)));
  }
}
#else
inline std::uint32_t narrow_approximate_scan(const float* x, std::size_t n, float d_x, float d_y, float d_z) {
  return static_cast<std::uint32_t>(scan(x, x + n, x + 2 * n, n, Vec3<float>(d_x, d_y, d_z)));
}
#endif

[[nodiscard, gnu::always_inline]] inline std::uint32_t approximate_scan(const float* x, std::size_t n,
                                                                        float d_x, float d_y, float d_z) {
#if GRAZE_WIDE
  if (n > 16 && n <= kScanChunk && is_wide()) return wide_scan(x, x + n, x + 2 * n, n, d_x, d_y, d_z);
#endif
  return narrow_approximate_scan(x, n, d_x, d_y, d_z);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
