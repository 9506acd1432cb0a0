// The first time when a uniformly moving point comes within R of a polytope, and the interval in which a line
// is.
//
// Notation   P the polytope, all lengths in its integer unit,   f(t) = distance of the point at time t from
// P. f is convex. Let s be the first t in R at which it is least (rational: a line and a polytope). Then f
// falls strictly on (-inf, s], so before s  "f(t) > R"  is  "t < the first contact". No other question about
// a root is needed.
#pragma once

#include <functional>

#include "oracles/polytope/exact_distance.hpp"

namespace graze::oracle {

// An irrational time is enclosed to this many bits before doubles are read off.
inline constexpr unsigned kRootBits = 256;

// A rational interval around a root, or the root itself.
struct Root {
  Rational low, high;
  bool exact = false;
};

// The point (base + t v) / weight at time t.
struct Approach {
  Integer weight = 1;
  IntVec base;
  IntVec v;
  [[nodiscard]] HomogeneousPoint at(const Rational& t) const;
};

// The t in (0, end] with f(t) = R, for f(0) > R >= f(end) and f strictly falling on [0, end]. It is exact if
// it was found to be rational (a square discriminant), otherwise it has kRootBits - 16 bits.
[[nodiscard]] Root first_contact(const HullDistance& polytope, const Integer& radius,
                                 const Approach& approach, Rational end);

// {t in R : t v within R of P}, v != 0. Nothing if it is empty.
struct ContactTimes {
  Root in, out;
};
[[nodiscard]] std::optional<ContactTimes> contact_times(const HullDistance& polytope, const Integer& radius,
                                                        const IntVec& v);

// The doubles on either side of a root (or it, twice), and the one nearest to it. `compare` gives sign(t -
// root) exactly. It is called only for t in the root's interval.
using CompareTime = std::function<int(const Rational& t)>;
[[nodiscard]] Enclosure enclose(const Root& root, const CompareTime& compare);
[[nodiscard]] double nearest_double(const Root& root, const CompareTime& compare);

}  // namespace graze::oracle
