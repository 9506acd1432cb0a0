// Decides: which of two times is the earlier, of a rational and the root of a rounded contact. Brackets: the
// root, to 2^-240 of it. Costs: one to four rounds of a point's distance (exact_distance.cpp).
// Cannot be trusted: nowhere known.
#include "oracles/truth/first_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace graze::oracle {
namespace {

// a t^2 - 2 b t + c = 0, its smaller root c / (b + sqrt(b^2 - a c)) for b, c > 0.
struct Quadratic {
  Integer a, b, c;
};

std::optional<Root> smaller_root(const Quadratic& q) {
  const Integer discriminant = q.b * q.b - q.a * q.c;
  if (sgn(q.b) <= 0 || sgn(q.c) <= 0 || sgn(discriminant) < 0) return {};
  if (mpz_perfect_square_p(discriminant.get_mpz_t()) != 0) {
    const Rational root = fraction(q.c, q.b + sqrt(discriminant));
    return Root{root, root, true};
  }
  // sqrt(4^k discriminant) to one unit, with kRootBits and more to spare. Then k cancels. The quotient is cut
  // to kRootBits, and two units on each side cover both roundings.
  const unsigned k = 2 * kRootBits;
  const Integer root = sqrt(Integer(discriminant << (2 * k)));
  Integer numerator = q.c << k, denominator = (q.b << k) + root;
  const long shift = static_cast<long>(kRootBits) +
                     static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2)) -
                     static_cast<long>(mpz_sizeinbase(numerator.get_mpz_t(), 2));
  Integer scale = 1;
  scale <<= static_cast<unsigned long>(std::abs(shift));
  (shift >= 0 ? numerator : denominator) *= scale;
  const Integer quotient = numerator / denominator;
  const auto unscaled = [&](const Integer& i) {
    return shift >= 0 ? fraction(i, scale) : Rational(i * scale);
  };
  return Root{unscaled(quotient - 2), unscaled(quotient + 2), false};
}

// weight^2 (f^2 - R^2) for the affine hull of the nearest feature, times a positive factor k.
Quadratic quadratic(const ConvexHull& hull, const Integer& radius, const Approach& p,
                    const PointDistance& nearest) {
  const Integer reach = radius * p.weight, rr = reach * reach;
  const auto from_base = [&](const IntVec& c) { return p.weight * c - p.base; };
  switch (nearest.feature) {
    case Nearest::vertex: {  // |c - t v|^2 - R^2
      const IntVec c = from_base(hull.vertices[nearest.index]);
      return {dot(p.v, p.v), dot(p.v, c), dot(c, c) - rr};
    }
    case Nearest::edge: {  // |(c - t v) x e|^2 - R^2 |e|^2
      const HullEdge& e = hull.edges[nearest.index];
      const IntVec vs = cross(p.v, e.direction), cs = cross(from_base(hull.vertices[e.from]), e.direction);
      return {dot(vs, vs), dot(vs, cs), dot(cs, cs) - rr * dot(e.direction, e.direction)};
    }
    case Nearest::facet: {  // (n.c - t n.v)^2 - R^2 |n|^2
      const HalfSpace& h = hull.half_spaces[hull.facets[nearest.index].half_space];
      const Integer rate = dot(h.normal, p.v), offset = p.weight * h.offset - dot(h.normal, p.base);
      return {rate * rate, rate * offset, offset * offset - rr * dot(h.normal, h.normal)};
    }
    case Nearest::inside:
      break;
  }
  return {0, 0, 0};
}

// 256^k, k of any sign.
Rational power_of_256(long k) {
  Integer power = 1;
  power <<= static_cast<unsigned long>(8 * std::abs(k));
  return k >= 0 ? Rational(power) : fraction(1, power);
}

// The first t with f(t) <= R on the line {t v}, whose least distance is at most R.
Root entry(const HullDistance& polytope, const Integer& radius, const IntVec& v) {
  const Rational radius_sq(radius * radius), s = polytope.from_line(v).first;
  const Approach from_zero{1, {0, 0, 0}, v};
  const auto excess = [&](const Rational& t) {
    return cmp(polytope.from_point(from_zero.at(t)).distance_sq, radius_sq);
  };
  const auto exactly = [](const Rational& t) { return Root{t, t, true}; };
  if (excess(s) == 0) return exactly(s);
  if (sgn(s) > 0) {
    const int at_zero = excess(0);
    if (at_zero == 0) return exactly(0);
    if (at_zero > 0) return first_contact(polytope, radius, from_zero, s);
  }
  // It is below 0. Seen from a start -256^k before it, with -256^(k-1) no longer before it, the search is for
  // a time of its own magnitude, to the bits that Root promises but 8.
  const auto starts = [&](long k) {
    const Rational t = -power_of_256(k);
    return t < s && excess(t) > 0;
  };
  long k = 0;
  while (!starts(k)) ++k;
  while (starts(k - 1)) --k;
  const Rational start = -power_of_256(k), end = std::min(s, Rational(-power_of_256(k - 1)));
  const Integer& weight = start.get_den();
  Root root = first_contact(polytope, radius, {weight, start.get_num() * v, weight * v}, end - start);
  root.low += start;
  root.high += start;
  return root;
}

// The order of t and the root. Outside of the root's interval it needs no comparison, and a double that is beyond the whole
// contact would have none that tells.
int order_of(const Rational& t, const Root& root, const CompareTime& compare) {
  if (t <= root.low) return -1;
  return t >= root.high ? 1 : compare(t);
}

}  // namespace

HomogeneousPoint Approach::at(const Rational& t) const {
  return {t.get_den() * base + t.get_num() * v, t.get_den() * weight};
}

// The nearest feature at a probe proposes a root of its quadratic. The signs of f - R decide. Bisection takes
// every second step, so the loop always narrows.
Root first_contact(const HullDistance& polytope, const Integer& radius, const Approach& approach,
                   Rational end) {
  const Rational radius_sq(radius * radius);
  const auto excess = [&](const Rational& t) {
    return cmp(polytope.from_point(approach.at(t)).distance_sq, radius_sq);
  };
  Rational low = 0, high = std::move(end), probe = 0;
  std::optional<Rational> found;
  const auto narrow = [&](const Rational& t) {  // true if t is the root
    if (t <= low || t >= high) return false;
    const int sign = excess(t);
    if (sign == 0) found = t;
    (sign > 0 ? low : high) = t;
    return sign == 0;
  };
  if (excess(high) == 0) return {high, high, true};
  constexpr int kBudget = 4000;  // beyond every exponent of a double (typically 1 to 4 rounds are used)
  Integer precision = 1;
  precision <<= kRootBits - 16;
  for (int round = 0; round < kBudget && (high - low) * precision > high; ++round) {
    const PointDistance nearest = polytope.from_point(approach.at(probe));
    if (const auto root = smaller_root(quadratic(polytope.hull(), radius, approach, nearest))) {
      if (narrow(root->low) || (!root->exact && narrow(root->high))) return {*found, *found, true};
      probe = low;
    }
    if (round % 2 == 1) {
      probe = (low + high) / 2;
      if (narrow(probe)) return {*found, *found, true};
    }
  }
  return {low, high, false};
}

std::optional<ContactTimes> contact_times(const HullDistance& polytope, const Integer& radius,
                                          const IntVec& v) {
  if (sgn(radius) == 0) {
    const auto interval = polytope.clip_line({{0, 0, 0}, 1}, v);
    if (!interval) return {};
    return ContactTimes{{interval->in, interval->in, true}, {interval->out, interval->out, true}};
  }
  if (polytope.from_line(v).distance_sq > Rational(radius * radius)) return {};
  const Root mirrored = entry(polytope, radius, -v);
  return ContactTimes{entry(polytope, radius, v),
                      {Rational(-mirrored.high), Rational(-mirrored.low), mirrored.exact}};
}

Enclosure enclose(const Root& root, const CompareTime& compare) {
  if (root.exact) return enclose(root.low);
  Enclosure around{floor_double(root.low), 0};
  around.high = std::nextafter(around.low, std::numeric_limits<double>::infinity());
  // The interval is far narrower than the spacing of doubles, so at most one of them lies inside it.
  if (std::isinf(around.high)) return around;
  const int order = order_of(Rational(around.high), root, compare);
  if (order <= 0) around.low = around.high;
  if (order < 0) around.high = std::nextafter(around.high, std::numeric_limits<double>::infinity());
  return around;
}

double nearest_double(const Root& root, const CompareTime& compare) {
  if (root.exact) return nearest_double(root.low);
  const Enclosure around = enclose(root, compare);
  if (around.low == around.high) return around.low;
  if (std::isinf(around.low) || std::isinf(around.high)) return nearest_double(root.low);
  const Rational middle = (Rational(around.low) + Rational(around.high)) / 2;
  return order_of(middle, root, compare) > 0 ? around.low : around.high;
}

}  // namespace graze::oracle
