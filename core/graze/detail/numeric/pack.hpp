// Four floats or two doubles side by side, for the scans of points: one instruction does for all lanes on processors
// with SSE2, NEON or the SIMD of WebAssembly, with the bits of a lane alone.
//
// The compilers' vector types do everything but one thing, the bits of a comparison, which has an instruction of its own
// on each processor. A compiler without vector types loops over the lanes.
#pragma once

#include <cstdint>
#include <cstring>
#include <graze/detail/numeric/machine.hpp>
#include <graze/scalar.hpp>

#if !GRAZE_GNU
#elif defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
struct Pack {
  static constexpr std::size_t kSize = 16 / sizeof(S);
  using Lane = std::conditional_t<sizeof(S) == 8, std::int64_t, std::int32_t>;

#if GRAZE_GNU
  // In an alias g++ 12 ignores the attribute of a type that depends on S.
  typedef S Type __attribute__((vector_size(16)));     // NOLINT(modernize-use-using)
  typedef Lane Mask __attribute__((vector_size(16)));  // NOLINT(modernize-use-using)
  static Type add(Type a, Type b) { return a + b; }
  static Type mul(Type a, Type b) { return fl<Type>(a * b); }
  // b where a is NaN.
  static Type max(Type a, Type b) { return a > b ? a : b; }
  static Mask equal(Type a, Type b) { return a == b; }
  static Mask below(Type a, Type b) { return a < b; }
#else
  struct Type {
    S lane[kSize];
    S& operator[](std::size_t i) { return lane[i]; }
    S operator[](std::size_t i) const { return lane[i]; }
  };
  struct Mask {
    Lane lane[kSize];
    Lane operator[](std::size_t i) const { return lane[i]; }
  };
  template <class Out, class Op>
  static Out each(const Type& a, const Type& b, const Op& op) {
    Out out;
    for (std::size_t i = 0; i < kSize; ++i) out.lane[i] = op(a[i], b[i]);
    return out;
  }
  static Type add(Type a, Type b) {
    return each<Type>(a, b, [](S x, S y) { return x + y; });
  }
  static Type mul(Type a, Type b) {
    return each<Type>(a, b, [](S x, S y) { return fl(x * y); });
  }
  static Type max(Type a, Type b) {
    return each<Type>(a, b, [](S x, S y) { return x > y ? x : y; });
  }
  static Mask equal(Type a, Type b) {
    return each<Mask>(a, b, [](S x, S y) { return Lane{-(x == y)}; });
  }
  static Mask below(Type a, Type b) {
    return each<Mask>(a, b, [](S x, S y) { return Lane{-(x < y)}; });
  }
#endif

  static Type all(S x) {
    if constexpr (kSize == 4)
      return Type{x, x, x, x};
    else
      return Type{x, x};
  }
  static Type load(const S* p) {
    Type out;
    std::memcpy(&out, p, sizeof out);
    return out;
  }
  static void store(S* p, Type v) { std::memcpy(p, &v, sizeof v); }
  // A bit for each lane of a comparison that is true.
  static unsigned bits(Mask mask) {
#if defined(__SSE2__) && GRAZE_GNU
    if constexpr (sizeof(S) == 8)
      return unsigned(_mm_movemask_pd((__m128d)mask));
    else
      return unsigned(_mm_movemask_ps((__m128)mask));
#elif defined(__wasm_simd128__) && GRAZE_GNU
    if constexpr (sizeof(S) == 8)
      return unsigned(wasm_i64x2_bitmask((v128_t)mask));
    else
      return unsigned(wasm_i32x4_bitmask((v128_t)mask));
#else
#if defined(__aarch64__) && GRAZE_GNU
    if constexpr (sizeof(S) == 4) return vaddvq_u32((uint32x4_t)(mask & Mask{1, 2, 4, 8}));
#endif
    unsigned out = 0;
    for (std::size_t i = 0; i < kSize; ++i) out |= unsigned(mask[i] & 1) << i;
    return out;
#endif
  }
  static S greatest(Type v) {
    S out = v[0];
    for (std::size_t i = 1; i < kSize; ++i) out = v[i] > out ? v[i] : out;
    return out;
  }
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
