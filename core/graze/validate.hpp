// The door: what a query accepts. Everything behind it may assume finite numbers in range.
//
// Range of a magnitude: 0, or kLeastMagnitude to kGreatestMagnitude. It holds every finite float, and leaves
// the products of three lengths, two quaternion components and a time that the solvers and the proofs form
// far from both ends of double's exponent range.
#pragma once

#include <graze/combinator.hpp>
#include <graze/result.hpp>

namespace graze {

inline constexpr double kLeastMagnitude = 1e-60;
inline constexpr double kGreatestMagnitude = 1e60;

namespace detail {

// Written so that NaN fails.
template <Scalar S>
Invalid check_magnitude(S x) {
  const double magnitude = std::abs(static_cast<double>(x));
  if (!(magnitude <= std::numeric_limits<double>::max())) return Invalid::not_finite;
  if (is_flushed(x)) return Invalid::out_of_range;
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

template <Scalar S>
Invalid check_extent(S x) {
  if (x < 0) return Invalid::negative_extent;
  return check_magnitude(x);
}

// Does the machine round to nearest? The operands are volatile, so that no compiler answers for it.
inline bool rounds_to_nearest() {
  const volatile double one = 1, little = 0x1p-54;
  return one + little == 1 && one - little / 2 == 1;
}

template <Scalar S>
Invalid check_quaternion(const Quaternion<S>& q) {
  if (const Invalid one = check_vector(Vec3<S>(q.x, q.y, q.z)); one != Invalid::none) return one;
  if (const Invalid one = check_magnitude(q.w); one != Invalid::none) return one;
  return q.w == 0 && q.is_identity() ? Invalid::zero_quaternion : Invalid::none;
}

// The first reason of several, in their order.
inline Invalid first_of(std::initializer_list<Invalid> reasons) {
  for (const Invalid one : reasons) {
    if (one != Invalid::none) return one;
  }
  return Invalid::none;
}

template <Scalar S>
Invalid check_extents(const Vec3<S>& extents) {
  return first_of(
      {check_vector(extents), check_extent(extents[0]), check_extent(extents[1]), check_extent(extents[2])});
}

template <Scalar S>
Invalid check_shape(const Shape<S>& shape, int nesting, int& parts_seen);

template <Scalar S>
Invalid check_parts(std::span<const SharedShape<S>> parts, int nesting, int& parts_seen) {
  if (parts.empty()) return Invalid::missing_part;
  if (nesting >= kMaxNesting) return Invalid::too_complex;
  for (const SharedShape<S>& part : parts) {
    if (!part) return Invalid::missing_part;
    if (++parts_seen > kMaxParts) return Invalid::too_complex;
    if (const Invalid one = check_shape<S>(part->shape, nesting + 1, parts_seen); one != Invalid::none)
      return one;
  }
  return Invalid::none;
}

template <Scalar S>
Invalid check_shape(const Shape<S>& shape, int nesting, int& parts_seen) {
  const auto parts = [&](std::span<const SharedShape<S>> list) {
    const Invalid one = check_parts<S>(list, nesting, parts_seen);
    if (one != Invalid::none) return one;
    return nesting == 0 && vertex_count(shape) > kMaxVertices ? Invalid::too_complex : Invalid::none;
  };
  return std::visit(
      Overloaded{
          [](const Point<S>&) { return Invalid::none; },
          [](const Segment<S>& s) {
            return first_of({check_vector(s.a), check_vector(s.b)});
          },
          [](const Triangle<S>& s) {
            return first_of({check_vector(s.a), check_vector(s.b), check_vector(s.c)});
          },
          [](const Sphere<S>& s) { return check_extent(s.radius); },
          [](const Box<S>& s) { return check_extents(s.half_extents); },
          [](const Ellipsoid<S>& s) { return check_extents(s.radii); },
          [](const Hull<S>& hull) {
            if (hull.size() == 0) return Invalid::empty_hull;
            if (!hull.finite()) return Invalid::not_finite;
            if (hull.flushed()) return Invalid::out_of_range;
            return first_of({check_magnitude(hull.largest()), check_magnitude(hull.smallest_nonzero())});
          },
          [&](const Posed<S>& s) {
            return first_of(
                {check_vector(s.position), check_quaternion(s.orientation), parts(std::span(&s.shape, 1))});
          },
          [&](const Rounded<S>& s) {
            return first_of({check_extent(s.radius), parts(std::span(&s.shape, 1))});
          },
          [&](const Sum<S>& s) { return parts(s.shapes); },
          [&](const HullOf<S>& s) { return parts(s.shapes); },
          // Capsule, cylinder, cone.
          [](const auto& s) {
            return first_of({check_extent(s.radius), check_extent(s.half_height)});
          }},
      shape);
}

}  // namespace detail

template <Scalar S>
Invalid validate(const Body<S>& body) {
  int parts_seen = 0;
  return detail::first_of({detail::check_shape(body.shape, 0, parts_seen),
                           detail::check_vector(body.position), detail::check_vector(body.displacement),
                           detail::check_quaternion(body.orientation)});
}

template <Scalar S>
Invalid validate(const CastOptions<S>& options) {
  if (!(options.t_max >= 0) || is_flushed(options.t_max)) return Invalid::bad_horizon;
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
  if (!detail::rounds_to_nearest()) return Invalid::rounding_mode;
  return detail::first_of({validate(a), validate(b), validate(options)});
}

}  // namespace graze
