// The truth about a linear case of any shapes: a proved bracket of the answer, and proved brackets of the
// errors of any proposed one. The interface is LinearTruth's (linear_truth.hpp), with brackets instead of
// exact numbers. No header of Arb here.
//
// Every returned number is proved in ball arithmetic: outside by half-spaces (support values), inside by
// hulls of points of the shapes. A claim that is proved at the requested width is decided. All others are
// reported as undecided. Cost and limits: see bracket_truth.cpp. One object is for one thread.
#pragma once

#include <memory>
#include <string>

#include "corpus/case.hpp"
#include "oracles/arithmetic/enclosure.hpp"
#include "oracles/arithmetic/rational.hpp"

namespace graze::oracle {

struct RationalBracket {
  Rational low, high;
};

struct ClosestPoints {
  Enclosure distance;
  Vec3<double> point_a = Vec3<double>::Zero(), point_b = Vec3<double>::Zero();  // rounded to nearest
  Vec3<double> axis = Vec3<double>::Zero();  // unit up to rounding, from A to B (zero if none was found)
};

// {t in R : t v in C}, rounded outward. For a hit, t_in and t_out are valid (infinite for v = 0). For a miss,
// the set is empty. not_converged means undecided.
struct LineContact {
  Outcome outcome = Outcome::not_converged;
  Enclosure t_in, t_out;
};

class BracketTruth {
 public:
  // Over scale: how wide a bracket of the TOI may be (its ends' backward errors), and below which clearance
  // or depth a verdict may stay open.
  static constexpr double kDefaultWidth = 1e-20;
  static constexpr double kLeastWidth = 1e-60, kGreatestWidth = 1e-3;

  // Throws std::invalid_argument as LinearTruth does, and for a width outside kLeastWidth .. kGreatestWidth.
  explicit BracketTruth(const corpus::Case& problem, double width = kDefaultWidth);
  ~BracketTruth();
  BracketTruth(BracketTruth&&) noexcept;
  BracketTruth& operator=(BracketTruth&&) noexcept;

  // initially_overlapping, hit and miss are proved. not_converged means undecided, in one of two cases.
  // Either contact in the path is proved, and only its presence at t = 0 is open (contact_proved, TOI in [0,
  // toi_upper]). Or clearance and depth are below the width (or flat shapes meet: depth 0).
  [[nodiscard]] Outcome outcome() const;
  [[nodiscard]] bool contact_proved() const;
  // toi_lower <= TOI <= toi_upper, rounded outward to doubles. Both are infinite for a miss. They are 0 and
  // infinity if contact is open.
  [[nodiscard]] double toi_lower() const;
  [[nodiscard]] double toi_upper() const;
  // The same before rounding. For a proved contact (std::logic_error otherwise).
  [[nodiscard]] RationalBracket toi_bracket() const;
  // "": a bracket does not know. (LinearTruth's interface.)
  [[nodiscard]] std::string toi_exact() const { return {}; }
  // Not below the width of that bracket, a length: the larger backward error of its two ends.
  [[nodiscard]] double width() const;
  // sign(t - TOI) if it is proved. It is 0 for a t inside the bracket, or if contact is open, and -1 for a
  // miss.
  [[nodiscard]] int compare(double t) const;

  // As in LinearTruth, as brackets. Depths (finite t, or infinite) are refined until upper <= (1 +
  // kDepthSlack) lower or both are below width times scale. Distances are refined until they differ by less
  // than that or by 2^-45 of themselves. Each refinement stops at the end of its budget.
  static constexpr double kDepthSlack = 1.0 / 16;
  [[nodiscard]] Enclosure scale() const;
  [[nodiscard]] Enclosure clearance() const;
  [[nodiscard]] Enclosure depth() const;
  [[nodiscard]] Enclosure distance_at(double t) const;
  [[nodiscard]] Enclosure depth_before(double t) const;
  [[nodiscard]] Enclosure backward_error(double t) const;
  [[nodiscard]] Enclosure forward_error(double t) const;
  [[nodiscard]] Enclosure lateness(double t) const;
  [[nodiscard]] Enclosure normal_error(const Vec3<double>& n) const;
  [[nodiscard]] Enclosure distance_from_body(char body, double t, const Vec3<double>& world_point) const;
  [[nodiscard]] Enclosure distance() const;
  [[nodiscard]] double nearest_distance() const;  // the middle of distance()
  // The signed answer: the whole line, whatever t_max.
  [[nodiscard]] LineContact contact_interval() const;
  // Closest points at t = 0 (target distance not counted).
  [[nodiscard]] ClosestPoints closest_points() const;
  // Least penetration at t = 0 (target distance not counted): the depth of the origin in A - B, 0 outside.
  // The depth along the returned axis is at most `distance.high`. No points.
  [[nodiscard]] ClosestPoints penetration(double slack = kDepthSlack) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graze::oracle
