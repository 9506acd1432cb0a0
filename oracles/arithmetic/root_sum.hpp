// Numbers r + s sqrt(p) + t sqrt(q). Depths, reaches along a direction and their differences have this form.
#pragma once

#include "oracles/arithmetic/rational.hpp"

namespace graze::oracle {

// part + root_sign sqrt(root) + other_sign sqrt(other), root and other >= 0, signs -1, 0 or 1.
struct RootSum {
  Rational part;
  int root_sign = 0;
  Rational root;
  int other_sign = 0;
  Rational other;
};

[[nodiscard]] RootSum operator-(const RootSum& x);
// Neighbouring doubles, or one: exact also where the parts cancel.
[[nodiscard]] Enclosure enclose(RootSum x);
[[nodiscard]] Enclosure enclose_magnitude(const RootSum& x);
// -1, 0, 1.
[[nodiscard]] int sign(const RootSum& x);
[[nodiscard]] double nearest_double(const RootSum& x);

}  // namespace graze::oracle
