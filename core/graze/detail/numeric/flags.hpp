// Refuses to be compiled where arithmetic is not kept as written: every rounding bound depends on it.
//
// Under these flags the compiler may reorder sums, multiply by reciprocals, drop NaN checks or keep excess
// precision. The compiler g++ defines a macro for each of them, and a further one (0: no IEC 559) if any of
// them was given. The compiler clang names few of them. But under each flag that reorders or approximates,
// clang refuses to keep exceptions exact for the lines between push and pop (there are no such lines). Some
// cases cannot be detected here: clang for processors on which it ignores that pragma, and -fno-honor-nans
// alone. For these every query tests the machine at its entry: shapes/validation.hpp.
#pragma once

#include <cfloat>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(_M_FP_FAST) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) ||      \
    (defined(__GCC_IEC_559) && __GCC_IEC_559 == 0)
#error "graze: -ffast-math voids every rounding bound in these headers, as do its parts; compile without it"
#endif
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wignored-pragmas"
#pragma float_control(push)
// An error here: a part of -ffast-math is on. graze must be compiled without it.
#pragma float_control(except, on)
#pragma float_control(pop)
#pragma clang diagnostic pop
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "graze: float and double must be computed as such (FLT_EVAL_METHOD 0); on x86 use -mfpmath=sse"
#endif
