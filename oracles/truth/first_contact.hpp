// When a point that moves uniformly first comes within R of a polytope, and the interval in which a line is.
//
// Notation   P the polytope, all lengths in its integer unit;   f(t) = distance of the point at time t from
// P. f is convex. Let s be the first t in R at which it is least (rational: a line and a polytope). Then f
// falls strictly on (-inf, s], so before s  "f(t) > R"  is  "t < the first contact", and nothing else is ever
// asked of a root.
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

// The t in (0, end] with f(t) = R, where f(0) > R >= f(end) and f falls strictly on [0, end]: exact if it is
// rational (as far as it was found to be: a square discriminant), else to kRootBits - 16 bits of it.
[[nodiscard]] Root first_contact(const HullDistance& polytope, const Integer& radius,
                                 const Approach& approach, Rational end);

// {t in R : t v within R of P}, v != 0; nothing if it is empty.
struct ContactTimes {
  Root in, out;
};
[[nodiscard]] std::optional<ContactTimes> contact_times(const HullDistance& polytope, const Integer& radius,
                                                        const IntVec& v);

// The doubles on either side of a root (or it, twice), and the one nearest to it. `compare` gives sign(t -
// root) exactly; it is asked only about t in the root's interval.
using CompareTime = std::function<int(const Rational& t)>;
[[nodiscard]] Enclosure enclose(const Root& root, const CompareTime& compare);
[[nodiscard]] double nearest_double(const Root& root, const CompareTime& compare);

}  // namespace graze::oracle
