// The guess scan of up to 64 points by 16 floats to an instruction (AVX-512), on processors that have it: asked while the
// program runs, as in machine.hpp. The same products and sums, so the same bits.
//
// Only where there is VBMI2, too (Intel's processors from 2019 on, AMD's from 2022 on): those before lower their clock
// for such instructions. Every number of points takes the same way, with a mask for its tail: of hulls of many sizes
// nothing foretells the next.
#pragma once

#include <bit>
#include <cstdint>
#include <graze/detail/numeric/machine.hpp>
#include <graze/scalar.hpp>

#if defined(__x86_64__) && GRAZE_GNU
#include <immintrin.h>
#define GRAZE_WIDE 1
#else
#define GRAZE_WIDE 0
#endif

#if GRAZE_WIDE
// g++ 12 warns about its own header, for the operand that a mask of all ones never takes.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

[[nodiscard]] inline bool is_wide() { return __builtin_cpu_supports("avx512vbmi2") != 0; }

// A coordinate of 16 points times d, for as many of them as `there` has bits. It is 0 for the others. The asm is
// empty: it keeps compilers from fusing the product with the sum that it goes into, which would round otherwise.
[[nodiscard, gnu::target("avx512f"), gnu::always_inline]] inline __m512 wide_product(const float* from,
                                                                                     __mmask16 there,
                                                                                     __m512 d) {
  __m512 out = _mm512_mul_ps(_mm512_maskz_loadu_ps(there, from), d);
  asm("" : "+v"(out));
  return out;
}

// For n = 8, 16, ... 64 points by axis, each n long: the least k of the greatest height along d, as rounded. If it is
// NaN, the last.
[[nodiscard, gnu::target("avx512f"), gnu::noinline]] inline std::uint32_t wide_scan(
    const float* x, const float* y, const float* z, std::size_t n, float d_x, float d_y, float d_z) {
  const __m512 dx = _mm512_set1_ps(d_x), dy = _mm512_set1_ps(d_y), dz = _mm512_set1_ps(d_z),
               none = _mm512_set1_ps(-kInfinity<float>);
  const std::uint64_t all = ~std::uint64_t{0} >> (64 - n);
  __m512 height[4];
#pragma GCC unroll 4
  for (std::size_t i = 0; i < 4; ++i) {
    const auto there = static_cast<__mmask16>(all >> (16 * i));
    const __m512 xy = _mm512_add_ps(wide_product(x + 16 * i, there, dx), wide_product(y + 16 * i, there, dy));
    height[i] = _mm512_mask_add_ps(none, there, xy, wide_product(z + 16 * i, there, dz));
  }
  const __m512 of_16 =
      _mm512_max_ps(_mm512_max_ps(height[0], height[1]), _mm512_max_ps(height[2], height[3]));
  const __m256 of_8 = _mm256_max_ps(_mm512_castps512_ps256(of_16),
                                    _mm256_castpd_ps(_mm512_extractf64x4_pd(_mm512_castps_pd(of_16), 1)));
  __m128 top = _mm_max_ps(_mm256_castps256_ps128(of_8), _mm256_extractf128_ps(of_8, 1));
  top = _mm_max_ps(top, _mm_shuffle_ps(top, top, _MM_SHUFFLE(1, 0, 3, 2)));
  top = _mm_max_ps(top, _mm_shuffle_ps(top, top, _MM_SHUFFLE(2, 3, 0, 1)));
  const __m512 greatest = _mm512_broadcastss_ps(top);
  std::uint64_t equal = std::uint64_t{1} << (n - 1);
#pragma GCC unroll 4
  for (unsigned i = 0; i < 4; ++i)
    equal |= std::uint64_t{_mm512_cmp_ps_mask(height[i], greatest, _CMP_EQ_OQ)} << (16 * i);
  return static_cast<std::uint32_t>(std::countr_zero(equal));
}

}}}  // namespace graze::GRAZE_LINKAGE::detail

#pragma GCC diagnostic pop
#endif
