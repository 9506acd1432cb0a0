// The door of the checker: which numbers of a case it takes, and its view of the shapes that are a polytope
// plus a ball.
#pragma once

#include "oracles/checker/check_proof.hpp"
#include "oracles/checker/posed_exact.hpp"

namespace graze::oracle {

// The range of magnitudes of a case, any unit. The proof's own numbers may be any finite doubles: where the
// filters overflow, the exact stage decides.
inline constexpr double kLeastNumber = 1e-60, kLargestNumber = 1e60;

[[nodiscard]] inline bool all_finite(const Vec3<double>& x) {
  return x.cwiseAbs().maxCoeff() < kInfinity<double> && x == x;
}

struct Entry {
  Refusal refusal = Refusal::none;
  const char* reason = "";
};

// Collects the faults in the numbers of a body. Malformed comes before unsupported, and that before out of
// range, so the caller gets the gravest.
class Door {
 public:
  void number(double x) {
    const double magnitude = std::abs(x);
    finite_ &= magnitude <= std::numeric_limits<double>::max();  // NaN: not finite
    inside_ &= magnitude == 0 || (magnitude >= kLeastNumber && magnitude <= kLargestNumber);
  }
  void vector(const Vec3<double>& x) {
    for (int i = 0; i < 3; ++i) number(x[i]);
  }
  void extent(double x, const char* reason) {
    number(x);
    if (x < 0) malformed_ = reason;
  }
  void quaternion(const Quaternion<double>& q) {
    for (const double x : {q.w, q.x, q.y, q.z}) number(x);
    if (q.w == 0 && q.is_identity()) malformed_ = "a zero quaternion";
  }
  void malformed(const char* reason) { malformed_ = reason; }
  void unsupported(const char* reason) { unsupported_ = reason; }

  // Nothing but its range is against it.
  [[nodiscard]] bool well_formed() const {
    return malformed_ == nullptr && finite_ && unsupported_ == nullptr;
  }
  [[nodiscard]] Entry entry() const {
    if (malformed_ != nullptr) return {Refusal::malformed, malformed_};
    if (!finite_) return {Refusal::malformed, "a NaN or an infinite number in a body"};
    if (unsupported_ != nullptr) return {Refusal::unsupported, unsupported_};
    if (!inside_) return {Refusal::out_of_range, "a magnitude in a body outside 1e-60 .. 1e60"};
    return {};
  }

 private:
  bool finite_ = true, inside_ = true;
  const char* malformed_ = nullptr;
  const char* unsupported_ = nullptr;
};

namespace detail {

inline void read_list(Polytope& core, Door& door) {
  const auto list = core.list();
  bool inside = true;
  Vec3<double> reach = Vec3<double>::Zero();
  for (const Vec3<double>& x : list) {
    for (int i = 0; i < 3; ++i) {
      const double magnitude = std::abs(x[i]);
      inside &=
          (magnitude >= kLeastNumber || magnitude == 0) && magnitude <= kLargestNumber;  // NaN: not inside
      reach[i] = magnitude > reach[i] ? magnitude : reach[i];
    }
  }
  core.reach = reach;
  if (!inside)
    for (const Vec3<double>& x : list) door.vector(x);
}

inline void read_own(Polytope& core, std::initializer_list<Vec3<double>> vertices, Door& door) {
  for (const Vec3<double>& x : vertices) core.own[core.own_count++] = x;
  read_list(core, door);
}

}  // namespace detail

// Reads a polytope plus a ball. Returns false for any other shape.
[[nodiscard]] inline bool read_leaf(const Shape<double>& shape, Leaf& leaf, Door& door) {
  constexpr const char* kRadius = "a radius below zero";
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) {
    leaf.core.given = hull->vertices();
    if (leaf.core.given.empty()) door.malformed("a hull without a vertex");
    detail::read_list(leaf.core, door);
  } else if (const auto* box = std::get_if<Box<double>>(&shape)) {
    leaf.core.half_extents = &box->half_extents;
    for (int i = 0; i < 3; ++i) door.extent(box->half_extents[i], "a half extent below zero");
  } else if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) {
    leaf.radius = sphere->radius;
    leaf.has_ball = true;
    door.extent(sphere->radius, kRadius);
  } else if (const auto* capsule = std::get_if<Capsule<double>>(&shape)) {
    leaf.radius = capsule->radius;
    leaf.has_ball = true;
    door.extent(capsule->radius, kRadius);
    const double h = capsule->half_height;
    door.extent(h, "a half height below zero");
    detail::read_own(leaf.core, {{0, 0, -h}, {0, 0, h}}, door);
  } else if (const auto* segment = std::get_if<Segment<double>>(&shape)) {
    detail::read_own(leaf.core, {segment->a, segment->b}, door);
  } else if (const auto* triangle = std::get_if<Triangle<double>>(&shape)) {
    detail::read_own(leaf.core, {triangle->a, triangle->b, triangle->c}, door);
  } else {
    return std::holds_alternative<Point<double>>(shape);
  }
  return true;
}

}  // namespace graze::oracle
