// Decides: the sign of r + s sqrt(p) + t sqrt(q), and the doubles on either side of it. Costs: a microsecond
// or two. Cannot be trusted: beyond 2^(2^30).
//
// Roots of squares are taken first, and roots in a rational ratio are added. The remaining part is irrational
// (1, sqrt p, sqrt q are linearly independent over the rationals). So it never equals a double or the middle
// of two, and more bits always decide (Ziv's loop ends).
#include "oracles/arithmetic/root_sum.hpp"

#include <optional>
#include <utility>

#include "oracles/arithmetic/real.hpp"

namespace graze::oracle {
namespace {

std::optional<Rational> rational_root(const Rational& q) {
  if (mpz_perfect_square_p(q.get_num_mpz_t()) == 0 || mpz_perfect_square_p(q.get_den_mpz_t()) == 0) return {};
  return fraction(sqrt(q.get_num()), sqrt(q.get_den()));
}

void take_root(Rational& part, int& sign, Rational& root) {
  if (sign == 0 || sgn(root) == 0) {
    sign = 0;
    return;
  }
  if (const auto whole = rational_root(root)) {
    part += sign * *whole;
    sign = 0;
  }
}

// Irrational roots, independent of each other, the first before the second.
void simplify(RootSum& x) {
  take_root(x.part, x.root_sign, x.root);
  take_root(x.part, x.other_sign, x.other);
  if (x.root_sign == 0) {
    std::swap(x.root_sign, x.other_sign);
    std::swap(x.root, x.other);
  }
  if (x.other_sign == 0) return;
  const auto ratio = rational_root(x.root / x.other);
  if (!ratio) return;
  const Rational factor = x.root_sign * *ratio + x.other_sign;
  x.root = factor * factor * x.other;
  x.root_sign = sgn(factor);
  x.other_sign = 0;
}

// One bound of x: every step rounds towards `mode`.
void bound(const RootSum& x, mpfr_prec_t bits, mpfr_rnd_t mode, Real& total) {
  const mpfr_rnd_t against = mode == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD;
  mpfr_set_q(total.value, x.part.get_mpq_t(), mode);
  const auto add = [&](int sign, const Rational& q) {
    if (sign == 0) return;
    Real root(bits);
    const mpfr_rnd_t towards = sign > 0 ? mode : against;
    mpfr_set_q(root.value, q.get_mpq_t(), towards);
    mpfr_sqrt(root.value, root.value, towards);
    (sign > 0 ? mpfr_add : mpfr_sub)(total.value, total.value, root.value, mode);
  };
  add(x.root_sign, x.root);
  add(x.other_sign, x.other);
}

// The first answer that both bounds of an irrational x give.
template <class Read>
auto settled(const RootSum& x, Read read) {
  for (mpfr_prec_t bits = 256;; bits *= 2) {
    Real low(bits), high(bits);
    bound(x, bits, MPFR_RNDD, low);
    bound(x, bits, MPFR_RNDU, high);
    const auto from_low = read(low), from_high = read(high);
    if (from_low == from_high) return from_low;
  }
}

}  // namespace

RootSum operator-(const RootSum& x) { return {-x.part, -x.root_sign, x.root, -x.other_sign, x.other}; }

Enclosure enclose(RootSum x) {
  simplify(x);
  if (x.root_sign == 0) return enclose(x.part);
  const auto [low, high] = settled(x, [](const Real& y) {
    return std::pair{mpfr_get_d(y.value, MPFR_RNDD), mpfr_get_d(y.value, MPFR_RNDU)};
  });
  return {low, high};
}

int sign(const RootSum& given) {
  RootSum x = given;
  simplify(x);
  if (x.root_sign == 0) return sgn(x.part);
  return settled(x, [](const Real& y) { return mpfr_sgn(y.value) < 0 ? -1 : mpfr_sgn(y.value) > 0 ? 1 : 0; });
}

Enclosure enclose_magnitude(const RootSum& x) { return enclose(sign(x) < 0 ? -x : x); }

double nearest_double(const RootSum& given) {
  RootSum x = given;
  simplify(x);
  if (x.root_sign == 0) return nearest_double(x.part);
  return settled(x, [](const Real& y) { return mpfr_get_d(y.value, MPFR_RNDN); });
}

}  // namespace graze::oracle
