// The truth about a linear case: the exact answer, and exact measures of any proposed one. No CGAL header
// here.
//
// The bodies are those that exact_body.hpp represents: hulls of rational points, each with one radius, in any
// pose and of any dimension. Without radii and target distance everything is decided exactly. With them the
// CSO is a polytope P rounded by R = r_A + r_B + m, and every question is a comparison of a squared rational
// distance with R^2, decided exactly. Cost and limits: see linear_truth.cpp. One object is for one thread:
// answers are computed at the first query.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "corpus/case.hpp"
#include "oracles/arithmetic/enclosure.hpp"

namespace graze::oracle {

// {t in R : t v in C}. Without motion and in contact it is everything, and its ends are infinite.
struct ContactInterval {
  double t_in = 0, t_out = 0;       // the nearest doubles
  Enclosure in, out;                // the doubles on either side
  std::string in_exact, out_exact;  // "n/d" or "n" where found to be rational (as toi_exact), else ""
};

// Enclosures are two neighbouring doubles, or one, unless the function says otherwise.
class LinearTruth {
 public:
  // Throws std::invalid_argument for a case that it does not decide (rotation, a shape that is_exact_body
  // rejects, more differences than kMostDifferences of integer_scene.hpp). It throws the same for bad input:
  // a number that is not finite, a negative extent, an empty hull, a zero quaternion, t_max or target below
  // 0.
  explicit LinearTruth(const corpus::Case& problem);
  ~LinearTruth();
  LinearTruth(LinearTruth&&) noexcept;
  LinearTruth& operator=(LinearTruth&&) noexcept;

  // initially_overlapping, hit or miss. Under the policy pass_over a start in contact that leaves or slides
  // is a miss.
  [[nodiscard]] Outcome outcome() const;
  // n.v >= 0 for some n != 0 with h(n) <= 0, h of the shapes' C, without the target distance. Also said of a
  // start that is not in contact.
  [[nodiscard]] bool leaves_or_slides() const;
  // The largest double not above the TOI, and the least not below it. Both are infinity for a miss. (A hit
  // beyond the largest double, possible for T = infinity, lies between that and infinity.)
  [[nodiscard]] double toi_lower() const;
  [[nodiscard]] double toi_upper() const;
  // "n/d" or "n" in lowest terms if the TOI is rational, else "". It is always rational without rounding.
  // With rounding it is rational if the discriminant of its quadratic is a square (a ball on a slab).
  [[nodiscard]] std::string toi_exact() const;
  // sign(t - TOI), exact. It is -1 for a miss. t is not NaN.
  [[nodiscard]] int compare(double t) const;

  // Units of length (not squared, not over scale). Bounding boxes are the posed shapes', in world axes.
  [[nodiscard]] Enclosure scale() const;
  // For a miss, the distance of the path from C, and 0 otherwise. For a start that is passed over, a lower
  // bound on the change of C that would make it a contact. This is the lesser of two lengths: the distance of
  // its ray from C without the target distance (nearer, it does not leave) and its depth in C (less, it is
  // not a start in contact).
  [[nodiscard]] Enclosure clearance() const;
  // For a hit or a start in contact, the least translation after which the path over [0, T] misses. It is 0
  // for a miss. Under the policy pass_over, a start in contact that leaves or slides is a miss, too. For
  // that, C must change at least by the distance of the start from C, and by the depth of the whole ray in C
  // without the target distance. The result is the larger of these two, if that is less.
  [[nodiscard]] Enclosure depth() const;
  // For finite t: the distance of t v from C, 0 inside.
  [[nodiscard]] Enclosure distance_at(double t) const;
  // Depth of the path over [0, t). It is 0 if the path makes no contact, and for t <= 0. T does not cut it,
  // and t may be infinite. It is infinity for NaN.
  [[nodiscard]] Enclosure depth_before(double t) const;
  // The larger of the two above. For a time that is not finite and >= 0: infinity.
  [[nodiscard]] Enclosure backward_error(double t) const;
  // |t - TOI| |v|, infinity for a miss. With R > 0 and an irrational TOI also within 2^-230 TOI |v|.
  [[nodiscard]] Enclosure forward_error(double t) const;
  // The lateness of a bracket's lower end: depth_before(t) if t > TOI, else 0. For a time beyond T, and for
  // infinity, which claims a miss, it is at most the whole path's. It is infinity for NaN.
  [[nodiscard]] Enclosure lateness(double t) const;
  // (h(n) - n.(TOI v)) / |n|, h of C: how far n is from being a supporting normal at the contact. It needs a
  // contact in the path (for a start in contact, TOI = 0). It is infinity for a miss and for a zero or
  // non-finite n. With an irrational TOI also within 2^-230 TOI |v|.
  [[nodiscard]] Enclosure normal_error(const Vec3<double>& n) const;
  // Distance of a world point from A ('a') or B ('b') at time t. It is infinity for an argument that is not
  // finite.
  [[nodiscard]] Enclosure distance_from_body(char body, double t, const Vec3<double>& world_point) const;
  // Distance between the bodies at t = 0 (target distance not counted), 0 in contact.
  [[nodiscard]] Enclosure distance() const;
  [[nodiscard]] double nearest_distance() const;  // the same, as the nearest double
  // The dimension of the hull of the CSO's vertices, 0..3 (before rounding).
  [[nodiscard]] int dimension() const;
  // True if the CSO is a polytope: no radius, no target distance.
  [[nodiscard]] bool is_polytope() const;
  // The signed answer, or nothing if the line misses.
  [[nodiscard]] std::optional<ContactInterval> contact_interval() const;
  // Backward errors of proposed ends: the larger of the distance of t v from C and the depth of the line's
  // part before t_in (after t_out). t_in = -inf and t_out = inf are right for bodies at rest and in contact
  // and infinitely wrong for any that move. t_in = inf and t_out = -inf claim that the line misses, and err
  // by the line's depth. The error is infinity for NaN.
  [[nodiscard]] Enclosure entry_error(double t_in) const;
  [[nodiscard]] Enclosure exit_error(double t_out) const;
  // The least translation after which the whole line misses (0 if it does), and the line's distance from C.
  [[nodiscard]] Enclosure line_depth() const;
  [[nodiscard]] Enclosure line_clearance() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graze::oracle
