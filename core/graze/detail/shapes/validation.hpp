// How a query's input is checked: declared, with the range, in graze/validate.hpp.
#pragma once

#include <graze/detail/shapes/shape_tree.hpp>
#include <graze/validate.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

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

// Was this compiled with flags, unnamed by any macro (scalar.hpp), that reorder sums, multiply by reciprocals
// or take no number for a NaN or for infinity? Each changes one of these lines, which are short enough for
// any compiler to change. (1 + x) - 1 would be x. Two quotients by 49 would be products with 1/49 as rounded.
// A NaN would equal itself, or pass an inverted comparison. A sum with infinity would be no number
// at all, known before the program runs. Inlined, so that the flags are the query's own.
[[gnu::always_inline]] inline bool keeps_arithmetic() {
  const volatile double given[] = {1, 0x1p-60, 49, 98, 49, std::numeric_limits<double>::quiet_NaN()};
  const double one = given[0], little = given[1], nan = given[5];
  const double divisor = given[4], first = given[2] / divisor, second = given[3] / divisor;
  const bool sums = (one + little) - one == 0, quotients = first == 1 && second == 2;
  const bool nans = nan != nan && !(nan <= one) && !(nan > one);
  double endless = one + kInfinity<double>;
#if defined(__GNUC__)
  // Asked of a variable: of a constant the compiler answers before it has read what comes before.
  if (__builtin_constant_p(endless)) endless = 0;
#endif
  return sums && quotients && nans && endless > std::numeric_limits<double>::max();
}

// Tests how machine and compiler compute. Every bound depends on it.
[[gnu::always_inline]] inline Invalid check_arithmetic() {
  if (!rounds_to_nearest()) return Invalid::rounding_mode;
  return keeps_arithmetic() ? Invalid::none : Invalid::unsafe_math;
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

// The common case, without a branch: 0, or a normal number within the range. All other numbers (subnormal
// numbers, which may be flushed, and all that is refused) go the long way. By the bits, without the sign:
// they order as magnitudes do.
template <Scalar S>
bool is_common(S x) {
  using Bits = std::conditional_t<sizeof(S) == 8, std::uint64_t, std::uint32_t>;
  constexpr S kLeast = sizeof(S) == 8 ? S(kLeastMagnitude) : std::numeric_limits<S>::min();
  constexpr S kGreatest = sizeof(S) == 8 ? S(kGreatestMagnitude) : std::numeric_limits<S>::max();
  constexpr Bits kLow = detail::bit_cast<Bits>(kLeast), kHigh = detail::bit_cast<Bits>(kGreatest);
  const Bits bits = detail::bit_cast<Bits>(x) & (~Bits{0} >> 1);
  return bool(unsigned(bits == 0) | unsigned(bits - kLow <= kHigh - kLow));
}
template <Scalar S>
bool is_common(const Vec3<S>& v) {
  return bool(unsigned(is_common(v[0])) & unsigned(is_common(v[1])) & unsigned(is_common(v[2])));
}
template <Scalar S>
bool is_common_extent(S x) {
  return bool(unsigned(is_common(x)) & unsigned(x >= 0));
}
template <Scalar S>
bool is_common_extent(const Vec3<S>& x) {
  return is_common(x) && x.minCoeff() >= 0;
}
// Capsule, cylinder, cone.
template <class Shape>
bool has_common_extents(const Shape& shape) {
  return bool(unsigned(is_common_extent(shape.radius)) & unsigned(is_common_extent(shape.half_height)));
}
template <Scalar S>
bool is_common(const Body<S>& body) {
  const Quaternion<S>& q = body.orientation;
  const unsigned motion = unsigned(is_common(body.position)) & unsigned(is_common(body.displacement));
  const unsigned turn = unsigned(is_common(q.w)) & unsigned(is_common(q.x)) & unsigned(is_common(q.y)) &
                        unsigned(is_common(q.z)) & (unsigned(q.w != 0) | unsigned(!q.is_identity()));
  if (!(motion & turn)) return false;
  if (const auto* hull = std::get_if<Hull<S>>(&body.shape)) {
    return hull->size() > 0 && hull->finite() && !hull->flushed() && is_common(hull->largest()) &&
           is_common(hull->smallest_nonzero());
  }
  if (const auto* box = std::get_if<Box<S>>(&body.shape)) return is_common_extent(box->half_extents);
  if (const auto* triangle = std::get_if<Triangle<S>>(&body.shape))
    return unsigned(is_common(triangle->a)) & unsigned(is_common(triangle->b)) &
           unsigned(is_common(triangle->c));
  if (const auto* segment = std::get_if<Segment<S>>(&body.shape))
    return unsigned(is_common(segment->a)) & unsigned(is_common(segment->b));
  if (const auto* sphere = std::get_if<Sphere<S>>(&body.shape)) return is_common_extent(sphere->radius);
  if (const auto* capsule = std::get_if<Capsule<S>>(&body.shape)) return has_common_extents(*capsule);
  if (const auto* cylinder = std::get_if<Cylinder<S>>(&body.shape)) return has_common_extents(*cylinder);
  if (const auto* cone = std::get_if<Cone<S>>(&body.shape)) return has_common_extents(*cone);
  if (const auto* ellipsoid = std::get_if<Ellipsoid<S>>(&body.shape))
    return is_common_extent(ellipsoid->radii);
  return std::holds_alternative<Point<S>>(body.shape);
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
  if (detail::is_common(body)) [[likely]]
    return Invalid::none;
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
  if (const Invalid one = detail::check_arithmetic(); one != Invalid::none) return one;
  if (const Invalid one = validate(a); one != Invalid::none) return one;
  if (const Invalid one = validate(b); one != Invalid::none) return one;
  return validate(options);
}

namespace detail {

// Finds the field that validate() refuses. It walks the same numbers in the same order, and stops at the
// first that is refused. A walk of its own, so that what is valid pays nothing for it. Each step says whether
// it stopped.
template <Scalar S>
class InvalidFinder {
 public:
  [[nodiscard]] const InvalidAt& at() const { return at_; }

  bool arithmetic() { return stop(check_arithmetic(), InvalidField::none); }

  bool body(const Body<S>& body, InvalidBody which) {
    at_.body = which;
    at_.part = 0;
    int parts_seen = 0;
    if (shape(body.shape, 0, parts_seen)) return true;
    at_.part = -1;
    return vector(InvalidField::position, body.position) ||
           vector(InvalidField::displacement, body.displacement) || quaternion(body.orientation);
  }

  bool options(const CastOptions<S>& options) {
    at_.body = InvalidBody::none;
    if (const Invalid why = validate(options); why == Invalid::bad_horizon || why == Invalid::bad_target)
      return stop(why, why == Invalid::bad_horizon ? InvalidField::t_max : InvalidField::target_distance);
    return limits(options.tolerance, options.max_iterations);
  }
  bool limits(S tolerance, int max_iterations) {
    if (!(tolerance >= 0 && tolerance < kInfinity<S>))
      return stop(Invalid::bad_tolerance, InvalidField::tolerance);
    return stop(max_iterations < 1 ? Invalid::bad_tolerance : Invalid::none, InvalidField::max_iterations);
  }

  bool vector(InvalidField field, const Vec3<S>& v) {
    const Invalid why = check_vector(v);
    int i = 0;
    while (i < 2 && check_magnitude(v[i]) != why) ++i;
    return stop(why, field, i);
  }

 private:
  bool stop(Invalid why, InvalidField field, int index = -1) {
    if (why == Invalid::none) return false;
    at_.why = why;
    at_.field = field;
    at_.index = index;
    return true;
  }

  bool extent(InvalidField field, S x, int index = -1) { return stop(check_extent(x), field, index); }
  bool extents(InvalidField field, const Vec3<S>& x) {
    return vector(field, x) || extent(field, x[0], 0) || extent(field, x[1], 1) || extent(field, x[2], 2);
  }
  bool quaternion(const Quaternion<S>& q) { return stop(check_quaternion(q), InvalidField::orientation); }

  bool vertices(std::span<const Vec3<S>> list) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      if (stop(check_vector(list[k]), InvalidField::vertex, static_cast<int>(k))) return true;
    }
    return false;
  }
  // A NaN in any vertex comes before a magnitude out of range in another.
  bool hull(const Hull<S>& hull) {
    if (hull.size() == 0) return stop(Invalid::empty_hull, InvalidField::shape);
    const std::span<const Vec3<S>> all = hull.vertices();
    for (std::size_t k = 0; !hull.finite() && k < all.size(); ++k) {
      if (check_vector(all[k]) == Invalid::not_finite)
        return stop(Invalid::not_finite, InvalidField::vertex, static_cast<int>(k));
    }
    return vertices(all);
  }

  bool parts(std::span<const SharedShape<S>> list, const Shape<S>& whole, int nesting, int& parts_seen) {
    if (list.empty()) return stop(Invalid::missing_part, InvalidField::part);
    if (nesting >= kMaxNesting) return stop(Invalid::too_complex, InvalidField::shape);
    const int self = at_.part;
    for (const SharedShape<S>& part : list) {
      at_.part = parts_seen + 1;
      if (!part) return stop(Invalid::missing_part, InvalidField::shape);
      if (++parts_seen > kMaxParts) return stop(Invalid::too_complex, InvalidField::shape);
      if (shape(part->shape, nesting + 1, parts_seen)) return true;
    }
    at_.part = self;
    const bool many = nesting == 0 && vertex_count(whole) > kMaxVertices;
    return stop(many ? Invalid::too_complex : Invalid::none, InvalidField::shape);
  }

  bool shape(const Shape<S>& whole, int nesting, int& parts_seen) {
    const auto parts_of = [&](std::span<const SharedShape<S>> list) {
      return parts(list, whole, nesting, parts_seen);
    };
    return std::visit(
        Overloaded{[](const Point<S>&) { return false; },
                   [&](const Segment<S>& s) {
                     return vertices(std::array{s.a, s.b});
                   },
                   [&](const Triangle<S>& s) {
                     return vertices(std::array{s.a, s.b, s.c});
                   },
                   [&](const Sphere<S>& s) { return extent(InvalidField::radius, s.radius); },
                   [&](const Box<S>& s) { return extents(InvalidField::half_extents, s.half_extents); },
                   [&](const Ellipsoid<S>& s) { return extents(InvalidField::radii, s.radii); },
                   [&](const Hull<S>& s) { return hull(s); },
                   [&](const Posed<S>& s) {
                     return vector(InvalidField::position, s.position) || quaternion(s.orientation) ||
                            parts_of(std::span(&s.shape, 1));
                   },
                   [&](const Rounded<S>& s) {
                     return extent(InvalidField::radius, s.radius) || parts_of(std::span(&s.shape, 1));
                   },
                   [&](const Sum<S>& s) { return parts_of(s.shapes); },
                   [&](const HullOf<S>& s) { return parts_of(s.shapes); },
                   // Capsule, cylinder, cone.
                   [&](const auto& s) {
                     return extent(InvalidField::radius, s.radius) ||
                            extent(InvalidField::half_height, s.half_height);
                   }},
        whole);
  }

  InvalidAt at_;
};

template <Scalar S>
[[gnu::noinline]] InvalidAt find_invalid(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                         const Vec3<S>* direction) {
  InvalidFinder<S> find;
  if (find.arithmetic() || find.body(a, InvalidBody::a) || find.body(b, InvalidBody::b) ||
      find.options(options))
    return find.at();
  if (direction != nullptr && !find.vector(InvalidField::direction, *direction))
    return {.why = Invalid::out_of_range, .field = InvalidField::direction};  // zero
  return find.at();
}

// Was the input refused? Then result.invalid_at says where.
template <class Result, Scalar S>
bool refused(Result& result, const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
             const Vec3<S>* direction = nullptr) {
  if (result.invalid == Invalid::none) [[likely]]
    return false;
  result.invalid_at = find_invalid(a, b, options, direction);
  GRAZE_ASSERT(result.invalid_at.why == result.invalid);
  return true;
}

}  // namespace detail

}}  // namespace graze::GRAZE_LINKAGE
