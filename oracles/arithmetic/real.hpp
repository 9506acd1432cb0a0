// A number of MPFR, with its memory.
#pragma once

#include <mpfr.h>

namespace graze::oracle {

struct Real {
  mpfr_t value;
  explicit Real(mpfr_prec_t bits) { mpfr_init2(value, bits); }
  ~Real() { mpfr_clear(value); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
};

}  // namespace graze::oracle
