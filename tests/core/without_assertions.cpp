#include "tests/core/without_assertions.hpp"

#include <graze/detail/numeric/rounding.hpp>

#ifdef GRAZE_ASSERTIONS
#error "this file is compiled without assertions, whatever the build has"
#endif

float round_down_without_assertions(double x) { return graze::detail::exact::round_down<float>(x); }
