#include "tests/core/without_assertions.hpp"

#include <graze/numeric/rounding.hpp>

#ifdef GRAZE_ASSERTIONS
#error "this file is compiled without assertions, whatever the build has"
#endif

float round_down_without_assertions(double x) { return graze::exact::round_down<float>(x); }
