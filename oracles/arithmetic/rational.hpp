// Integers, rationals and integer vectors for the oracles, and conversions back to doubles, rounded outward.
//
// The oracles multiply every length of a case by one common denominator and decide the geometry in integers,
// so no gcd is ever taken inside a predicate. A point that is not integral is homogeneous, x / w, w > 0. GMP
// does the arithmetic, and MPFR the directed roundings. Both are exact or correctly rounded.
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "oracles/arithmetic/enclosure.hpp"

namespace graze::oracle {

using Integer = mpz_class;
using Rational = mpq_class;
using RationalPoint = std::array<Rational, 3>;

struct IntVec {
  Integer x, y, z;
  friend bool operator==(const IntVec& l, const IntVec& r) { return l.x == r.x && l.y == r.y && l.z == r.z; }
  friend bool operator<(const IntVec& l, const IntVec& r) {
    if (const int c = cmp(l.x, r.x); c != 0) return c < 0;
    if (const int c = cmp(l.y, r.y); c != 0) return c < 0;
    return l.z < r.z;
  }
  [[nodiscard]] bool is_zero() const { return sgn(x) == 0 && sgn(y) == 0 && sgn(z) == 0; }
};

inline IntVec operator+(const IntVec& l, const IntVec& r) { return {l.x + r.x, l.y + r.y, l.z + r.z}; }
inline IntVec operator-(const IntVec& l, const IntVec& r) { return {l.x - r.x, l.y - r.y, l.z - r.z}; }
inline IntVec operator-(const IntVec& l) { return {-l.x, -l.y, -l.z}; }
inline IntVec operator*(const Integer& s, const IntVec& r) { return {s * r.x, s * r.y, s * r.z}; }
inline Integer dot(const IntVec& l, const IntVec& r) { return l.x * r.x + l.y * r.y + l.z * r.z; }
inline IntVec cross(const IntVec& l, const IntVec& r) {
  return {l.y * r.z - l.z * r.y, l.z * r.x - l.x * r.z, l.x * r.y - l.y * r.x};
}

// A point x / w, w > 0.
struct HomogeneousPoint {
  IntVec x;
  Integer w = 1;
};

[[nodiscard]] inline Rational fraction(const Integer& numerator, const Integer& denominator) {
  Rational q(numerator, denominator);
  q.canonicalize();
  return q;
}

// The largest double not above q (-infinity below the range), the least not below it, the nearest (ties to
// even).
[[nodiscard]] double floor_double(const Rational& q);
[[nodiscard]] double ceil_double(const Rational& q);
[[nodiscard]] double nearest_double(const Rational& q);

// Enclosures of q, of sqrt(q), q >= 0, and of r + sign sqrt(q) without cancellation, r >= 0, q >= 0. Each is
// at most neighbouring doubles wide.
[[nodiscard]] Enclosure enclose(const Rational& q);
[[nodiscard]] Enclosure enclose_sqrt(const Rational& q);
[[nodiscard]] Enclosure enclose_radius_and_sqrt(const Rational& r, int sign, const Rational& q);

// sqrt(q) - r to the nearest double (a tie decided wrongly needs 200 equal bits: it has not been seen).
[[nodiscard]] double nearest_sqrt_minus(const Rational& q, const Rational& r);

// A negative part counts as none: max(0, x).
[[nodiscard]] Enclosure not_below_zero(Enclosure x);

}  // namespace graze::oracle
