// Computes where a line meets a supporting plane of C, to the last bit.
//
//   n = f_1 x f_2, n.v > 0;   t = n.c_0 / n.v,  exact;   returned as the largest double not above and the
//   least not below it.
//
// The quotient is first computed in pairs of doubles: t_0 = the quotient rounded, r = n.c_0 - t_0 n.v. If the sign of
// r is beyond its rounding, and r less than a unit in the last place, t lies between t_0 and its neighbour on that
// side. Otherwise it is computed exactly. Times are in the caller's unit, and 2^(k - j) of them is one of the
// scene's.
#pragma once

#include <graze/detail/search/exact/exact_scene.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

struct Facet {
  Vertex c0;
  Term f1, f2;
  // Vertices of C in the plane. o is in their hull, seen along v.
  std::array<Vertex, 3> corner;
  int size = 0;
};

struct TimeBracket {
  double lower = 0, upper = 0;
};

// Doubles as their neighbours in order, by their bits: no mode of the machine matters.
inline double next_up(double x) {
  auto bits = detail::bit_cast<std::int64_t>(x);
  if (bits == std::numeric_limits<std::int64_t>::min()) bits = 0;  // -0
  return detail::bit_cast<double>(bits >= 0 ? bits + 1 : bits - 1);
}
inline double next_down(double x) { return -next_up(-x); }
// Either, of x != 0: without a branch, as nothing foretells which.
inline double next(double x, bool up) {
  const auto bits = detail::bit_cast<std::int64_t>(x);
  return detail::bit_cast<double>(bits + 1 - 2 * std::int64_t{up != (bits >= 0)});
}

// The exact quotient n.c_0 / n.v in the caller's unit of time, to be compared with doubles.
struct ExactTime {
  Dyadic numerator, denominator;  // > 0

  // The sign of the quotient minus t.
  [[nodiscard]] int compare(double t) const { return (numerator - Dyadic(t) * denominator).sign(); }
};

template <Scalar S>
ExactTime exact_time(const Scene<S>& scene, const Facet& facet, const Term& v) {
  scene.count_exact_decision();
  const Exact c = scene.exact(Term::point(facet.c0)), f1 = scene.exact(facet.f1), f2 = scene.exact(facet.f2),
              motion = scene.exact(v);
  const Dyadic3 n = cross(f1.x, f2.x);
  ExactTime out{dot(n, c.x), dot(n, motion.x)};
  if (c.weighted) out.denominator = out.denominator * c.weight;
  out.numerator = out.numerator.times_power_of_two(scene.length_exponent() - scene.speed_exponent());
  if (!out.numerator.valid() || !out.denominator.valid() || out.denominator.sign() <= 0) scene.invalidate();
  return out;
}

// A double near numerator / denominator, within a few units in the last place, also of the subnormal numbers.
inline double near_quotient(const Dyadic& numerator, const Dyadic& denominator) {
  if (numerator.sign() == 0) return 0;
  const double q = numerator.leading() / denominator.leading();  // in +-(1/2, 2)
  const int exponent = std::clamp(numerator.order() - denominator.order(), -1200, 1200);
  const double magnitude = std::abs(q);
  double out;
  if (exponent > -1020) {
    out = std::ldexp(magnitude, exponent);
    if (!(out <= std::numeric_limits<double>::max())) out = std::numeric_limits<double>::max();
  } else {
    // 2^-1074 is the unit: an integer of them.
    const int shift = 1074 + exponent;
    out = detail::bit_cast<double>(
        shift < 0 ? std::int64_t{0} : static_cast<std::int64_t>(std::ldexp(magnitude, std::min(shift, 60))));
  }
  return numerator.sign() < 0 ? -out : out;
}

// The doubles next to a time, from a guess. sign_of_rest(t): of the time minus t.
template <class SignOfRest>
TimeBracket bracket_by(double lower, const SignOfRest& sign_of_rest) {
  while (sign_of_rest(lower) < 0) lower = next_down(lower);
  while (true) {
    if (sign_of_rest(lower) == 0) return {lower, lower};
    const double up = next_up(lower);
    if (sign_of_rest(up) < 0) return {lower, up};
    lower = up;
  }
}
inline TimeBracket bracket_of(const ExactTime& time) {
  return bracket_by(near_quotient(time.numerator, time.denominator),
                    [&](double t) { return time.compare(t); });
}

// The quotient in pairs of doubles, if they are accurate enough.
struct FineTime {
  Pair numerator{0, 0}, denominator{1, 0};
  double error_n = 0, error_d = 0;
  bool known = false;  // the denominator is beyond its error, and all is in the range of exact_scene.hpp

  // numerator - s denominator, s >= 0 in size, and its error bound.
  [[nodiscard]] double rest(double s, double& error) const {
    error = error_n + fl(std::abs(s) * error_d);
    return rounded(numerator - denominator * Pair{s, 0});
  }
};

template <Scalar S>
FineTime fine_time(const Scene<S>& scene, const Facet& facet, const Term& v) {
  FineTime out;
  if (!scene.has_fine()) return out;
  const Fine c = scene.fine(Term::point(facet.c0)), f1 = scene.fine(facet.f1), f2 = scene.fine(facet.f2),
             motion = scene.fine(v);
  const double plane = f1.size * f2.size;
  const double size_n = plane * c.size, size_d = plane * motion.size * c.weight.hi;
  if (!(std::min(size_n, size_d) > Scene<S>::kLeastSize && std::max(size_n, size_d) < Scene<S>::kMostSize))
    return out;
  const Pair3 n = cross(f1.x, f2.x);
  out.numerator = dot(n, c.x);
  out.denominator = dot(n, motion.x);
  if (c.weighted) out.denominator = out.denominator * c.weight;
  out.error_n = Scene<S>::kFineError * size_n;
  out.error_d = Scene<S>::kFineError * size_d;
  out.known = rounded(out.denominator) > 2 * out.error_d;
  return out;
}

template <Scalar S>
int sign_of_time(const Scene<S>& scene, const Facet& facet, const Term& v) {
  const FineTime f = fine_time(scene, facet, v);
  if (f.known) {
    double error = 0;
    const double rest = f.rest(0, error);
    if (rest > error) return 1;
    if (rest < -error) return -1;
  }
  return exact_time(scene, facet, v).compare(0);
}

template <Scalar S>
TimeBracket round_time(const Scene<S>& scene, const Facet& facet, const Term& v) {
  const FineTime f = fine_time(scene, facet, v);
  const int exponent = scene.length_exponent() - scene.speed_exponent();
  if (f.known && std::abs(exponent) < 500) {
    constexpr double u = kUnitRoundoff<double>;
    const double below = (fl(rounded(f.denominator) * (1 - 2 * u)) - f.error_d) * (1 - 4 * u);
    double s = rounded(f.numerator) / rounded(f.denominator);
    // The quotient of two rounded numbers may be off by more than a unit. A second round then starts from the
    // corrected value.
    for (int round = 0; round < 2; ++round) {
      // Scaling by a power of two is exact here.
      if (!(std::abs(s) > 0x1p-500 && std::abs(s) < 0x1p500)) break;
      double error = 0;
      const double rest = f.rest(s, error);
      const bool up = rest > 0;
      const double other = up ? next_up(s) : next_down(s);
      if (std::abs(rest) > error && (std::abs(rest) + error) * (1 + 4 * u) < std::abs(other - s) * below) {
        const double t = s * power_of_two(exponent), t_other = other * power_of_two(exponent);
        return up ? TimeBracket{t, t_other} : TimeBracket{t_other, t};
      }
      const double moved = s + rest / rounded(f.denominator);
      if (moved == s) break;
      s = moved;
    }
  }
  return bracket_of(exact_time(scene, facet, v));
}

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
