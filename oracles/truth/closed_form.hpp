// The exact answer of a linear cast where it is the root of a quadratic with rational coefficients.
//
// The pairs, in either order, with any rational poses and motions:
//   point, segment, sphere, capsule with each other        target distance allowed
//   point, sphere                 with a box               target distance allowed
//   point                         with an ellipsoid (radii > 0), a cylinder, a cone, but no target distance
// It uses no support functions, hulls or searches: it solves for the crossing of every piece of the
// boundary. So it checks the other judges. Cost and limits: see closed_form.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/case.hpp"
#include "oracles/arithmetic/rational.hpp"

namespace graze::oracle {

// (mid + side sqrt(square)), side -1, 0 or 1, square >= 0.
struct QuadraticRoot {
  Rational mid, square;
  int side = 0;
  // sign(alpha + beta root), exact.
  [[nodiscard]] int sign_of(const Rational& alpha, const Rational& beta) const;
};

class ClosedForm {
 public:
  // Nothing for a pair that has no closed form here, and for a start in contact under the policy pass_over, unless it is
  // of a point and a solid that is not flat.
  // Throws std::invalid_argument for bad input (as LinearTruth).
  [[nodiscard]] static std::optional<ClosedForm> of(const corpus::Case& problem);

  // initially_overlapping, hit or miss.
  [[nodiscard]] Outcome outcome() const { return outcome_; }
  // The largest double not above the TOI, and the least not below it. Both are infinity for a miss.
  [[nodiscard]] double toi_lower() const { return lower_; }
  [[nodiscard]] double toi_upper() const { return upper_; }
  // "n/d" or "n" where the TOI is rational, else "".
  [[nodiscard]] const std::string& toi_exact() const { return exact_; }
  // sign(t - TOI), exact. It is -1 for a miss.
  [[nodiscard]] int compare(const Rational& t) const;

 private:
  ClosedForm() = default;
  Outcome outcome_ = Outcome::miss;
  double lower_ = 0, upper_ = 0;
  std::string exact_;
  std::vector<QuadraticRoot> times_;  // times of contact (the TOI is the least)
};

}  // namespace graze::oracle
