// The common part of the checker's three arithmetics: signs that may be unknown, and vectors over any of
// them.
//
// A predicate of the checker is one template, free of division and of square roots, over a number type N:
//   Filtered   a double and a bound on its error            nanoseconds, leaves the close calls open
//   Extended   a double-double and a bound on its error     settles all but ties between long numbers
//   Dyadic     an exact m 2^e, GMP                          settles everything
// sign(N) is unknown only where the bound does not exclude zero; Dyadic never says so.
#pragma once

#include <graze/scalar.hpp>

namespace graze::oracle {

enum class Sign { negative = -1, zero = 0, positive = 1, unknown = 2 };

// A truth value that the arithmetic at hand may be too coarse to tell.
enum class Answer { no, yes, unknown };

[[nodiscard]] constexpr Answer both(Answer l, Answer r) {
  if (l == Answer::no || r == Answer::no) return Answer::no;
  return l == Answer::yes && r == Answer::yes ? Answer::yes : Answer::unknown;
}
[[nodiscard]] constexpr Answer either(Answer l, Answer r) {
  if (l == Answer::yes || r == Answer::yes) return Answer::yes;
  return l == Answer::no && r == Answer::no ? Answer::no : Answer::unknown;
}
[[nodiscard]] constexpr Answer is_positive(Sign s) {
  return s == Sign::unknown ? Answer::unknown : s == Sign::positive ? Answer::yes : Answer::no;
}
[[nodiscard]] constexpr Answer is_negative(Sign s) {
  return s == Sign::unknown ? Answer::unknown : s == Sign::negative ? Answer::yes : Answer::no;
}
[[nodiscard]] constexpr Answer at_most_zero(Sign s) {
  return s == Sign::unknown ? Answer::unknown : s == Sign::positive ? Answer::no : Answer::yes;
}
[[nodiscard]] constexpr Answer at_least_zero(Sign s) {
  return s == Sign::unknown ? Answer::unknown : s == Sign::negative ? Answer::no : Answer::yes;
}

template <class N>
struct Triple {
  N x, y, z;

  [[nodiscard]] const N& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};

template <class N>
[[nodiscard]] Triple<N> triple(const Vec3<double>& a) {
  return {N(a.x()), N(a.y()), N(a.z())};
}
// a - b. Each component is one operation on exact doubles.
template <class N>
[[nodiscard]] Triple<N> difference(const Vec3<double>& a, const Vec3<double>& b) {
  return {N(a.x()) - N(b.x()), N(a.y()) - N(b.y()), N(a.z()) - N(b.z())};
}
template <class N>
[[nodiscard]] Triple<N> operator+(const Triple<N>& a, const Triple<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
[[nodiscard]] Triple<N> operator-(const Triple<N>& a, const Triple<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
[[nodiscard]] Triple<N> operator-(const Triple<N>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class N>
[[nodiscard]] Triple<N> scaled(const N& s, const Triple<N>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class N>
[[nodiscard]] N dot(const Triple<N>& a, const Triple<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
[[nodiscard]] N dot(const Triple<N>& a, const Vec3<double>& b) {
  return a.x * b.x() + a.y * b.y() + a.z * b.z();
}
template <class N>
[[nodiscard]] Triple<N> cross(const Triple<N>& a, const Triple<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace graze::oracle
