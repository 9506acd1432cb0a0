// While it lives, and the test is built for that (GRAZE_TEST_FLUSH), subnormals are flushed and count as
// zero.
#pragma once

#if defined(GRAZE_TEST_FLUSH) && defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace graze::test {

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
