// The truth about a case whose bodies may rotate: a proved bracket of the first contact, and proved brackets
// of the errors of any proposed time. The interface is BracketTruth's (bracket_truth.hpp) wherever the
// meanings are the same. No header of Arb here.
//
// Every returned number is proved in ball arithmetic. A chain of axes, each with its slice of time, proves no
// contact before toi_lower. Points of the bodies that hold the origin between them prove contact at
// toi_upper. Slices again prove depths between the two. It covers any shape, any angle, rotation of both
// bodies, and linear motion too. Cost and limits: see rotating_truth.cpp. One object is for one thread.
#pragma once

#include <memory>
#include <string>

#include "corpus/case.hpp"
#include "oracles/arithmetic/enclosure.hpp"

namespace graze::oracle {

class RotatingTruth {
 public:
  // Over scale: how wide the bracket may be (the larger of the distance at toi_lower and the greatest depth
  // over [0, toi_upper]), and below which clearance or depth a verdict may stay open.
  static constexpr double kDefaultWidth = 1e-13;
  static constexpr double kLeastWidth = 1e-16, kGreatestWidth = 1e-3;
  // Slices of time that may be tried until a verdict is due.
  static constexpr int kDefaultBudget = 1 << 16;

  // Throws std::invalid_argument for an invalid case: numbers that are not finite, t_max among them, a
  // negative extent, radius, t_max or target distance, an empty hull or combinator, a zero quaternion, the
  // policy pass_over, a width outside kLeastWidth .. kGreatestWidth.
  explicit RotatingTruth(const corpus::Case& problem, double width = kDefaultWidth,
                         int budget = kDefaultBudget);
  // With a bracket that an accepted proof has shown: no contact before `lower`, contact by `upper` (finite).
  // No search runs. Measures of times work as usual, at a tenth of the cost.
  [[nodiscard]] static RotatingTruth of_proved(const corpus::Case& problem, double lower, double upper,
                                               double width = kDefaultWidth);
  ~RotatingTruth();
  RotatingTruth(RotatingTruth&&) noexcept;
  RotatingTruth& operator=(RotatingTruth&&) noexcept;

  // initially_overlapping, hit and miss are proved. not_converged means undecided, and reason() says why.
  // Either contact is proved and only its presence at t = 0 is open (contact_proved, TOI in [0, toi_upper]).
  // Or clearance and depth are below the width (or flat shapes meet: depth 0), or the budget ended.
  [[nodiscard]] Outcome outcome() const;
  [[nodiscard]] bool contact_proved() const;
  [[nodiscard]] bool budget_ended() const;
  [[nodiscard]] const std::string& reason() const;  // empty if the outcome is proved
  // toi_lower <= TOI <= toi_upper, rounded outward to doubles. Both are infinite for a miss. If undecided, it
  // is still proved that there is no contact before toi_lower.
  [[nodiscard]] double toi_lower() const;
  [[nodiscard]] double toi_upper() const;
  // sign(t - TOI) if it is proved. It is 0 for a t inside the bracket, and -1 for a miss.
  [[nodiscard]] int compare(double t) const;
  // Slices that the verdict took.
  [[nodiscard]] int slices() const;

  [[nodiscard]] Enclosure scale() const;
  // Least distance, and greatest penetration depth, over [0, t_max], with the target distance counted.
  // Subdivision refines them until upper <= (1 + kSlack) lower or upper is below width times scale, or until
  // the budget ends.
  static constexpr double kSlack = 1.0 / 16;
  [[nodiscard]] Enclosure clearance() const;
  [[nodiscard]] Enclosure depth() const;
  // The distance and the penetration depth at a time (any finite t), and the greatest depth over [0, t].
  [[nodiscard]] Enclosure distance_at(double t) const;
  [[nodiscard]] Enclosure depth_at(double t) const;
  [[nodiscard]] Enclosure depth_before(double t) const;
  // The larger of the two.
  [[nodiscard]] Enclosure backward_error(double t) const;
  // 0 for a t that is not beyond the TOI, else the greatest depth over [0, t].
  [[nodiscard]] Enclosure lateness(double t) const;
  // h(n) / |n| of A - B + ball(m) at the TOI: the amount by which n fails to separate the bodies there, 0 for
  // a correct normal. It is for a proved contact. Otherwise it is from 0 to infinity, and infinite for a
  // miss.
  [[nodiscard]] Enclosure normal_error(const Vec3<double>& n) const;
  // Distance of a world point from body 'a' or 'b' at a time.
  [[nodiscard]] Enclosure distance_from_body(char body, double t, const Vec3<double>& world_point) const;

 private:
  struct Impl;
  explicit RotatingTruth(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace graze::oracle
