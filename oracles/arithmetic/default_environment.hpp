// While it lives, this thread computes in the default floating-point environment, whatever its caller's:
// to nearest, with subnormals, without traps. Its end gives the caller's back.
//
// Every bound of the oracles' filters supposes that, and so does what is not filtered: a comparison of two
// given doubles is exact, but where subnormals count as zeros (a library linked with -ffast-math turns that
// on for a whole process) 5e-324 > 0 is false; GMP, MPFR and Arb read doubles, and CGAL changes the direction
// of rounding and gives back what it found. So every function that the oracles offer begins with one of
// these.
//
// On x86-64 MXCSR is all that governs floating point (no x87 code runs where long double is not used), so a
// look at it tells, for a nanosecond, that nothing need be done. Elsewhere the environment is always set.
// FE_DFL_ENV is that of the program's start without such a library: glibc's clears the bits that flush, in
// MXCSR as in FPCR. Where a C library's does not, no answer is given: the constructor throws.
#pragma once

#include <cfenv>
#include <limits>
#include <stdexcept>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace graze::oracle {

class DefaultEnvironment {
 public:
  DefaultEnvironment() : set_(!is_default()) {
    if (!set_) return;
    if (std::fegetenv(&before_) == 0) {
      if (std::fesetenv(FE_DFL_ENV) == 0 && rounds_to_nearest_and_keeps_subnormals()) return;
      std::fesetenv(&before_);
    }
    throw std::runtime_error(
        "the floating-point environment cannot be set to its default; the oracles compute in no other");
  }
  ~DefaultEnvironment() {
    if (set_) std::fesetenv(&before_);
  }
  DefaultEnvironment(const DefaultEnvironment&) = delete;
  DefaultEnvironment& operator=(const DefaultEnvironment&) = delete;

 private:
  // Of MXCSR all but the flags of what has happened: the six masks, and nothing else, are set.
  [[nodiscard]] static bool is_default() {
#if defined(__x86_64__)
    constexpr unsigned kFlags = 0x3f, kMasks = 0x1f80;
    return (_mm_getcsr() & ~kFlags) == kMasks;
#else
    return false;
#endif
  }
  [[nodiscard]] static bool rounds_to_nearest_and_keeps_subnormals() {
    volatile double least = std::numeric_limits<double>::min(), half_unit = 0x1p-53, one = 1;
    const double subnormal = least / 2;
    volatile double kept = subnormal;
    return kept * 2 == least && one + half_unit == one && -one - half_unit == -one &&
           (one + 0x1p-52) + half_unit == one + 0x1p-51;
  }

  bool set_;
  std::fenv_t before_{};
};

}  // namespace graze::oracle
