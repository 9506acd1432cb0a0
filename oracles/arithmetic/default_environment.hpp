// While this object lives, its thread computes in the default floating-point environment, whatever the
// caller's: to nearest, with subnormals, without traps. Its destructor restores the caller's environment.
//
// Every error bound of the oracles' filters assumes this environment. The unfiltered code assumes it too:
//   - A comparison of two given doubles is exact. But where subnormals count as zeros, 5e-324 > 0 is false. A
//     library linked with -ffast-math turns that on for a whole process.
//   - GMP, MPFR and Arb read doubles.
//   - CGAL changes the direction of rounding and restores the direction that it found.
// So every function that the oracles offer begins with one of these objects.
//
// On x86-64, MXCSR alone governs floating point (no x87 code runs where long double is not used). Reading it
// takes a nanosecond and shows when nothing needs to be done. Elsewhere the environment is always set.
// FE_DFL_ENV is the environment of a program start without such a library: glibc's clears the bits that
// flush, in MXCSR as in FPCR. If a C library's does not, the constructor throws and no answer is given.
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
  // All bits of MXCSR except the exception flags: the six masks, and nothing else, are set.
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
