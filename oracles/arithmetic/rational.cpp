// Decides: the rounding of rationals and of roots of rationals to doubles, exactly, subnormals included.
// Brackets: nothing that is not a root. Costs: about a microsecond. Cannot be trusted: beyond 2^(2^30).
#include "oracles/arithmetic/rational.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "oracles/arithmetic/real.hpp"

namespace graze::oracle {
namespace {

// Enough bits that a root rounded down here and down again to 53 bits equals one rounding down. The exception
// is a root with 200 consecutive zero or one bits. There the enclosure is still valid.
constexpr mpfr_prec_t kRootBits = 256;

double rounded(const Rational& q, mpfr_rnd_t mode) {
  Real x(kRootBits);
  mpfr_set_q(x.value, q.get_mpq_t(), mode);
  return mpfr_get_d(x.value, mode);
}

double rounded_sqrt(const Rational& q, mpfr_rnd_t mode) {
  Real x(kRootBits);
  mpfr_set_q(x.value, q.get_mpq_t(), mode);
  mpfr_sqrt(x.value, x.value, mode);
  return mpfr_get_d(x.value, mode);
}

// r + sqrt(q), or, for sign < 0, (r^2 - q) / (r + sqrt(q)): one exact numerator over a sum of like signs.
double rounded_sum(const Rational& r, int sign, const Rational& q, mpfr_rnd_t mode) {
  Real root(kRootBits), radius(kRootBits);
  const Rational numerator = r * r - q;
  const bool divides = sign < 0;
  mpfr_rnd_t inner = mode;
  if (divides) {
    if (sgn(numerator) == 0) return 0;
    // A larger denominator makes a positive quotient smaller and a negative one larger.
    const bool want_larger = (mode == MPFR_RNDD) == (sgn(numerator) > 0);
    inner = want_larger ? MPFR_RNDU : MPFR_RNDD;
  }
  mpfr_set_q(root.value, q.get_mpq_t(), inner);
  mpfr_sqrt(root.value, root.value, inner);
  mpfr_set_q(radius.value, r.get_mpq_t(), inner);
  mpfr_add(root.value, root.value, radius.value, inner);
  if (divides) {
    mpfr_set_q(radius.value, numerator.get_mpq_t(), mode);
    mpfr_div(root.value, radius.value, root.value, mode);
  }
  return mpfr_get_d(root.value, mode);
}

}  // namespace

double floor_double(const Rational& q) { return rounded(q, MPFR_RNDD); }
double ceil_double(const Rational& q) { return rounded(q, MPFR_RNDU); }

double nearest_double(const Rational& q) {
  const double low = floor_double(q), high = ceil_double(q);
  if (low == high) return low;
  if (std::isinf(low) || std::isinf(high)) {
    // Beyond the largest double: half a unit above it rounds to infinity.
    const double big = std::numeric_limits<double>::max();
    const Rational half_unit = Rational(big) - Rational(std::nextafter(big, 0.0));
    const Rational limit = Rational(big) + half_unit / 2;
    return abs(q) < limit ? std::copysign(big, low) : (std::isinf(low) ? low : high);
  }
  const int side = cmp(Rational(2 * q), Rational(Rational(low) + Rational(high)));
  if (side != 0) return side < 0 ? low : high;
  return (std::bit_cast<std::uint64_t>(low) & 1U) == 0 ? low : high;  // a tie: the even one
}

Enclosure enclose(const Rational& q) { return {floor_double(q), ceil_double(q)}; }

Enclosure enclose_sqrt(const Rational& q) { return {rounded_sqrt(q, MPFR_RNDD), rounded_sqrt(q, MPFR_RNDU)}; }

Enclosure enclose_radius_and_sqrt(const Rational& r, int sign, const Rational& q) {
  return {rounded_sum(r, sign, q, MPFR_RNDD), rounded_sum(r, sign, q, MPFR_RNDU)};
}

double nearest_sqrt_minus(const Rational& q, const Rational& r) {
  return 0 - rounded_sum(r, -1, q, MPFR_RNDN);
}

Enclosure not_below_zero(Enclosure x) { return {x.low > 0 ? x.low : 0.0, x.high > 0 ? x.high : 0.0}; }

}  // namespace graze::oracle
