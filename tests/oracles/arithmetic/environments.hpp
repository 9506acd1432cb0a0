// The results of a function in each floating-point environment that a process may be in: every direction of
// rounding, and subnormals flushed, counted as zeros, or both (a library linked with -ffast-math sets these
// for the whole process).
#pragma once

#include <cfenv>
#include <string>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace graze::test {

template <class Result>
struct InEnvironment {
  std::string name;
  Result result;
  bool given_back;  // the environment, as the function found it
};

template <class Ask>
auto in_every_environment(const Ask& ask) {
  std::vector<InEnvironment<decltype(ask())>> all;
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    if (std::fesetround(mode) != 0) continue;
    auto result = ask();
    const bool kept = std::fegetround() == mode;
    std::fesetround(FE_TONEAREST);
    all.push_back({"rounding mode " + std::to_string(mode), std::move(result), kept});
  }
#if defined(__SSE2__)
  constexpr unsigned kFlags = 0x3f;
  const unsigned saved = _mm_getcsr();
  for (const unsigned bits : {0x8000u, 0x0040u, 0x8040u}) {  // flush to zero, denormals are zero, both
    _mm_setcsr(saved | bits);
    auto result = ask();
    const bool kept = (_mm_getcsr() & ~kFlags) == ((saved | bits) & ~kFlags);
    _mm_setcsr(saved);
    all.push_back({"flush bits " + std::to_string(bits), std::move(result), kept});
  }
#endif
  return all;
}

}  // namespace graze::test
