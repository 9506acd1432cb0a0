// What is true of a linear case: the exact answer, and exact measures of any proposed one. No CGAL header here.
//
// Polytopes (point, box, hull; any dimension of the CSO, any rational pose): decided exactly, everything.
// Spheres, alone or against a polytope, and target distances: the CSO is a polytope rounded by R, and every
// question is a comparison of a squared rational distance with R^2, decided exactly.
// Cost and limits: see linear_truth.cpp.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "corpus/case.hpp"

namespace graze::oracle {

// An enclosure of a real number by doubles: low <= x <= high, at most a few units in the last place wide.
struct Enclosure {
  double low = 0, high = 0;
};

class LinearTruth {
 public:
  // Throws std::invalid_argument for a case it does not decide (rotation, unknown shape, non-finite input).
  explicit LinearTruth(const corpus::Case& problem);
  ~LinearTruth();
  LinearTruth(LinearTruth&&) noexcept;
  LinearTruth& operator=(LinearTruth&&) noexcept;

  [[nodiscard]] Outcome outcome() const;  // initially_overlapping, hit or miss
  // The largest double not above the TOI, and the least not below it; infinity for a miss.
  [[nodiscard]] double toi_lower() const;
  [[nodiscard]] double toi_upper() const;
  // "n/d" in lowest terms where the TOI is rational and known as such (polytopes without rounding), else "".
  [[nodiscard]] std::string toi_exact() const;
  // sign(t - TOI), exact; -1 for a miss.
  [[nodiscard]] int compare(double t) const;

  // DESIGN section 1, in units of length (not squared, not over scale).
  [[nodiscard]] Enclosure scale() const;
  [[nodiscard]] Enclosure clearance() const;  // of a miss: distance of the path from C; 0 otherwise
  [[nodiscard]] Enclosure depth() const;      // of a hit or a start in contact: least translation after which the path misses
  [[nodiscard]] Enclosure distance_at(double t) const;      // of t v from C; 0 inside
  [[nodiscard]] Enclosure depth_before(double t) const;     // depth of the path over [0, t); 0 if it makes no contact, and for t = 0
  [[nodiscard]] Enclosure backward_error(double t) const;   // max of the two above, for finite t >= 0
  [[nodiscard]] Enclosure forward_error(double t) const;    // |t - TOI| |v|; needs a hit
  // The lateness of a bracket's lower end: depth_before(t) if t > TOI, else 0.
  [[nodiscard]] Enclosure lateness(double t) const;
  // h(n) - n.(TOI v), over |n|: how far n is from being a supporting normal at the contact; needs a hit.
  [[nodiscard]] Enclosure normal_error(const Vec3<double>& n) const;
  // Distance of a world point from A (or B) as it stands at time t.
  [[nodiscard]] Enclosure distance_from_body(char body, double t, const Vec3<double>& world_point) const;
  // Distance between the bodies at t = 0 (target distance not counted); 0 in contact.
  [[nodiscard]] Enclosure distance() const;
  // The dimension of the hull of the CSO's vertices, 0..3 (before rounding).
  [[nodiscard]] int dimension() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graze::oracle
