// The truth about the penetration of two bodies at t = 0: the exact answer, and exact measures of a proposed
// one. No CGAL header here.
//
// Notation   C = A - B = P + ball(r), P a polytope, r = r_A + r_B (the target distance is not counted);
//   h(n) = max over C of n.c.   B moved by x makes C - x, so the bodies overlap after it iff x lies in C.
// Least penetration, of bodies in contact: the least |x| with x on the boundary of C = min h(n) over unit n.
//   A and B moved by depth n touch only. Touching: 0. The direction n is from A to B.
// Penetration along d: the greatest s with s d in C, d not normalised. B moved by s d leaves A there. (For a
//   start that overlaps it is the least s > 0 at which they touch only.)
// The bodies are those that exact_body.hpp represents. Every answer is r + a root of a rational, so
// everything is decided exactly, and all lengths are enclosed by neighbouring doubles. Cost and limits: see
// penetration_truth.cpp. One object is for one thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "corpus/case.hpp"
#include "oracles/arithmetic/enclosure.hpp"

namespace graze::oracle {

// The penetration along d, s in units of |d|.
struct DepthAlong {
  double factor = 0;         // s, the nearest double
  Enclosure factor_bounds;   // the doubles on either side of it: they compare any double with s
  std::string factor_exact;  // "n/d" or "n" if s was found to be rational (always without radii), else ""
  double length = 0;         // s |d|, the nearest double (a tie to 2^-230 of it may be decided wrongly)
};

class PenetrationTruth {
 public:
  // Motion, t_max and target distance of the case are not looked at. Throws std::invalid_argument for shapes
  // that is_exact_body says no to and for bad input (see LinearTruth).
  explicit PenetrationTruth(const corpus::Case& problem);
  ~PenetrationTruth();
  PenetrationTruth(PenetrationTruth&&) noexcept;
  PenetrationTruth& operator=(PenetrationTruth&&) noexcept;

  // Touching included. The functions below need contact unless they say otherwise, and throw
  // std::logic_error.
  [[nodiscard]] bool in_contact() const;
  // The dimension of P, 0..3, and whether r = 0. No contact needed.
  [[nodiscard]] int dimension() const;
  [[nodiscard]] bool is_polytope() const;

  [[nodiscard]] Enclosure depth() const;
  [[nodiscard]] double nearest_depth() const;
  // The squared depth, "n/d" or "n", if it is rational (always without radii), else "".
  [[nodiscard]] std::string depth_sq_exact() const;
  // The unit normals n with h(n) = depth, components to the nearest double, if they are finitely many. This
  // is so for an origin inside a solid P, in the plane of a flat one, or outside P but within r of it. The
  // list is empty if they are a continuum (an origin on an edge of a solid P, within a segment, ...).
  [[nodiscard]] const std::vector<Vec3<double>>& normals() const;

  // |proposed - depth|, infinity for a value that is not finite.
  [[nodiscard]] Enclosure depth_error(double proposed) const;
  // h(n) / |n| - depth: by how much a translation along n must exceed the least. Infinity for a zero or
  // non-finite n.
  [[nodiscard]] Enclosure normal_error(const Vec3<double>& n) const;
  // h(n) / |n|. No contact needed. Infinity for a zero or non-finite n.
  [[nodiscard]] Enclosure reach(const Vec3<double>& n) const;
  // Distance of a world point from A ('a') or B ('b'), no contact needed. Infinity for a point that is not
  // finite.
  [[nodiscard]] Enclosure distance_from_body(char body, const Vec3<double>& world_point) const;
  // Penetration that is left after B is moved by x, 0 outside of C, and the bodies' distance after it, 0 in
  // C. No contact needed. Infinity for an x that is not finite.
  [[nodiscard]] Enclosure depth_after(const Vec3<double>& x) const;
  [[nodiscard]] Enclosure distance_after(const Vec3<double>& x) const;
  // The error of a pair of world points that is claimed to realise the least penetration. The difference x =
  // point_a - point_b (exact) should be on the boundary of C at the distance `depth` from the origin. The
  // error is the largest of | |x| - depth |, depth_after(x) and distance_after(x). Another function checks
  // that the points lie on their bodies.
  [[nodiscard]] Enclosure pair_error(const Vec3<double>& point_a, const Vec3<double>& point_b) const;

  // d is finite and not zero, otherwise it throws std::invalid_argument. Nothing if the ray {s d : s >= 0}
  // misses C. No contact needed.
  [[nodiscard]] std::optional<DepthAlong> along(const Vec3<double>& d) const;
  // Backward error of a proposed s: the larger of the distance of s d from C and the least translation after
  // which {t d : t > s} misses C. Infinity for a negative or non-finite s.
  [[nodiscard]] Enclosure along_error(const Vec3<double>& d, double s) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graze::oracle
