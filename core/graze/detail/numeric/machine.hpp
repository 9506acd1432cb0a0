// Detects at run time the processor features that the compiler may not assume.
//
// Code for every x86-64 processor may not contain fused multiply-adds. If fused multiply-adds compute the same bits
// sooner, there are two copies of the performance-critical code and one test before it: a load and a branch. On other
// processors, and where the compiler may use it anyway, there is one copy.
//
// The fused instruction is written explicitly and not left to the compiler. In a function compiled for such
// processors, g++ and clang may fuse every sum, and so round it differently from the next machine. Code that runs
// only with fused multiply-adds is compiled for AVX, though (GRAZE_FUSED), which every processor with fused
// multiply-adds has. AVX fuses nothing and rounds nothing differently. It avoids most of the instructions that only
// copy registers, a quarter of all.
#pragma once

#include <graze/linkage.hpp>

#include <cmath>
#include <cstddef>
#include <type_traits>

// g++ and clang, with their vector types and asm. 0: only what the standard has, as for MSVC.
#ifndef GRAZE_GNU
#if defined(__GNUC__)
#define GRAZE_GNU 1
#else
#define GRAZE_GNU 0
#endif
#endif

#if defined(__x86_64__) && GRAZE_GNU && !defined(__FMA__)
#define GRAZE_FUSES_IF_THERE 1
// Marks a function that runs only if fuses() is true. Its callees are inlined into it.
#define GRAZE_FUSED [[gnu::target("avx"), gnu::flatten, gnu::noinline]]
#else
#define GRAZE_FUSES_IF_THERE 0
#define GRAZE_FUSED [[gnu::flatten, gnu::noinline]]
#endif

#if defined(_MSC_VER) && !defined(__clang__)
#pragma fp_contract(off)
#endif

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The bits of x as a T. As std::bit_cast, which libraries before 2022 lack.
template <class T, class U>
[[nodiscard]] constexpr T bit_cast(const U& x) {
  static_assert(sizeof(T) == sizeof(U));
  return __builtin_bit_cast(T, x);
}

// Two doubles side by side, of what is done to two bodies alike: one instruction does for both where there is one (SSE2,
// which every x86-64 processor has), with the bits of two.
#if GRAZE_GNU
using TwoLanes = double __attribute__((vector_size(16)));
#else
struct TwoLanes {
  double lane[2];

  double operator[](std::size_t i) const { return lane[i]; }
  friend TwoLanes operator-(const TwoLanes& x) { return {-x[0], -x[1]}; }
  friend TwoLanes operator+(const TwoLanes& x, const TwoLanes& y) { return {x[0] + y[0], x[1] + y[1]}; }
  friend TwoLanes operator-(const TwoLanes& x, const TwoLanes& y) { return {x[0] - y[0], x[1] - y[1]}; }
  friend TwoLanes operator*(const TwoLanes& x, const TwoLanes& y) { return {x[0] * y[0], x[1] * y[1]}; }
  friend TwoLanes operator*(double s, const TwoLanes& x) { return {s * x[0], s * x[1]}; }
  friend TwoLanes operator/(double s, const TwoLanes& x) { return {s / x[0], s / x[1]}; }
};
#endif

// fl(x) is the product x as it is rounded, in the notation of error analysis. Where a compiler may use fused
// multiply-adds, it may fuse a product with the sum that it goes into: g++ does by default, and clang does not keep to
// the pragma that forbids it under -ffp-contract=fast. So core marks each product that goes into a sum. An exact one,
// with a power of two, needs no mark. The asm is empty: nothing is done, and compilers do not look through it. Without
// fused multiply-adds to use there is nothing to forbid.
template <class T>
requires(!std::is_class_v<T> && !std::is_integral_v<T>) [[nodiscard, gnu::always_inline]] inline T fl(T x) {
#if GRAZE_GNU && \
    (defined(__FMA__) || defined(__FMA4__) || defined(__FP_FAST_FMA) || defined(__ARM_FEATURE_FMA))
#if defined(__x86_64__)
  asm("" : "+x"(x));
#elif defined(__aarch64__)
  asm("" : "+w"(x));
#elif defined(__riscv) || defined(__s390x__)
  if constexpr (std::is_arithmetic_v<T>) {
    asm("" : "+f"(x));
  } else {
    asm("" : "+m"(x));
  }
#else
  asm("" : "+m"(x));
#endif
#endif
  return x;
}
#if !GRAZE_GNU
[[nodiscard]] inline TwoLanes fl(const TwoLanes& x) { return {fl(x[0]), fl(x[1])}; }
#endif

// Rounded once. In code that g++ takes for rare it calls the C library, and MinGW's rounds to 64 bits first.
[[nodiscard]] inline double square_root(double x) {
#if defined(__MINGW32__) && defined(__SSE2__) && GRAZE_GNU
  return __builtin_ia32_sqrtsd(TwoLanes{x, 0})[0];
#else
  return std::sqrt(x);
#endif
}
[[nodiscard]] inline float square_root(float x) { return std::sqrt(x); }

// A fused multiply-add that the compiler may not use?
[[nodiscard]] inline bool fuses() {
#if GRAZE_FUSES_IF_THERE
  return __builtin_cpu_supports("fma") != 0;
#else
  return false;
#endif
}

#if GRAZE_FUSES_IF_THERE
// a b - c, rounded once, only where fuses(). It is volatile, as the compiler might otherwise move it before that
// test.
inline double fused_difference(double a, double b, double c) {
  asm volatile("vfmsub231sd {%2, %1, %0|%0, %1, %2}" : "+x"(c) : "x"(a), "x"(b));
  return c;
}
inline TwoLanes fused_difference(TwoLanes a, TwoLanes b, TwoLanes c) {
  asm volatile("vfmsub231pd {%2, %1, %0|%0, %1, %2}" : "+x"(c) : "x"(a), "x"(b));
  return c;
}
#endif

}}}  // namespace graze::GRAZE_LINKAGE::detail
