// While it lives, and the test is built for that (GRAZE_TEST_FLUSH), subnormals are flushed and count as
// zero.
#pragma once

#if defined(GRAZE_TEST_FLUSH) && defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif
#include <optional>

namespace graze::test {

// True if this file's multiply-adds are fused, or nullopt if the machine has none.
inline std::optional<bool> fuses() {
#if defined(__FMA__)
  const volatile double given = 1 + 0x1p-30;
  const double x = given, y = given;  // two products for the compiler, else it makes one, for the rounded sum
  const volatile double rounded = x * x;
  return y * y - rounded != 0;
#else
  return std::nullopt;
#endif
}

struct Flushed {
#if defined(GRAZE_TEST_FLUSH) && defined(__SSE2__)
  unsigned before = _mm_getcsr();
  Flushed() {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~Flushed() { _mm_setcsr(before); }
#else
  Flushed() {}  // NOLINT: not trivial, so that an unused guard is no warning
#endif
  Flushed(const Flushed&) = delete;
  Flushed& operator=(const Flushed&) = delete;
};

}  // namespace graze::test
