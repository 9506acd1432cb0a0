// The door: what a query accepts. Everything behind it may assume finite numbers in range.
//
// Range of a magnitude: 0, or kLeastMagnitude to kGreatestMagnitude. It holds every finite float, and leaves
// the products of three lengths, two quaternion components and a time that the solvers and the proofs form
// far from both ends of double's exponent range.
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze {

inline constexpr double kLeastMagnitude = 1e-60;
inline constexpr double kGreatestMagnitude = 1e60;

namespace detail {

// Written so that NaN fails.
inline Invalid check_magnitude(double x) {
  const double magnitude = x < 0 ? -x : x;
  if (!(magnitude <= std::numeric_limits<double>::max())) return Invalid::not_finite;
  if (magnitude == 0 || (magnitude >= kLeastMagnitude && magnitude <= kGreatestMagnitude))
    return Invalid::none;
  return Invalid::out_of_range;
}

template <Scalar S>
Invalid check_vector(const Vec3<S>& v) {
  Invalid worst = Invalid::none;
  for (int i = 0; i < 3 && worst != Invalid::not_finite; ++i) {
    if (const Invalid one = check_magnitude(v[i]); one != Invalid::none) worst = one;
  }
  return worst;
}

inline Invalid check_extent(double x) {
  if (x < 0) return Invalid::negative_extent;
  return check_magnitude(x);
}

template <Scalar S>
Invalid check_shape(const Point<S>&) {
  return Invalid::none;
}
template <Scalar S>
Invalid check_shape(const Sphere<S>& sphere) {
  return check_extent(sphere.radius);
}
template <Scalar S>
Invalid check_shape(const Box<S>& box) {
  Invalid first = check_vector(box.half_extents);
  for (int i = 0; i < 3 && first == Invalid::none; ++i) first = check_extent(box.half_extents[i]);
  return first;
}
template <Scalar S>
Invalid check_shape(const Hull<S>& hull) {
  if (hull.size() == 0) return Invalid::empty_hull;
  if (!hull.finite()) return Invalid::not_finite;
  if (const Invalid most = check_magnitude(hull.largest()); most != Invalid::none) return most;
  return check_magnitude(hull.smallest_nonzero());
}

}  // namespace detail

template <Scalar S>
Invalid validate(const Body<S>& body) {
  const Quaternion<S>& q = body.orientation;
  const Invalid first[] = {
      std::visit([](const auto& shape) { return detail::check_shape(shape); }, body.shape),
      detail::check_vector(body.position), detail::check_vector(body.displacement),
      detail::check_vector(Vec3<S>(q.x, q.y, q.z)), detail::check_magnitude(q.w)};
  for (const Invalid one : first) {
    if (one != Invalid::none) return one;
  }
  if (q.w == 0 && q.is_identity()) return Invalid::zero_quaternion;
  return Invalid::none;
}

template <Scalar S>
Invalid validate(const CastOptions<S>& options) {
  if (!(options.t_max >= 0)) return Invalid::bad_horizon;
  if (!(options.target_distance >= 0) || detail::check_magnitude(options.target_distance) != Invalid::none) {
    return Invalid::bad_target;
  }
  if (!(options.tolerance >= 0 && options.tolerance < kInfinity<S>) || options.max_iterations < 1) {
    return Invalid::bad_tolerance;
  }
  return Invalid::none;
}

template <Scalar S>
Invalid validate(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  for (const Invalid one : {validate(a), validate(b), validate(options)}) {
    if (one != Invalid::none) return one;
  }
  return Invalid::none;
}

}  // namespace graze
