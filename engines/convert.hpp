// A case in the scalar of a method: every number rounded to the nearest S. In double nothing changes.
//
// A magnitude beyond the range of float becomes infinite, and the method then refuses the case. A magnitude
// below it becomes a subnormal or 0, and the case changes accordingly.
#pragma once

#include <graze/rotating_body.hpp>
#include <vector>

#include "corpus/case.hpp"
#include "engines/own_hull.hpp"

namespace graze::engine {

template <Scalar To, Scalar From>
[[nodiscard]] Vec3<To> round_to(const Vec3<From>& v) {
  return v.template cast<To>();
}

template <Scalar To, Scalar From>
[[nodiscard]] Quaternion<To> round_to(const Quaternion<From>& q) {
  return {static_cast<To>(q.w), static_cast<To>(q.x), static_cast<To>(q.y), static_cast<To>(q.z)};
}

template <Scalar To, Scalar From>
[[nodiscard]] Shape<To> round_to(const Shape<From>& shape);

// A missing part stays one: it is the method that refuses it.
template <Scalar To, Scalar From>
[[nodiscard]] SharedShape<To> round_to(const SharedShape<From>& part) {
  return part ? share<To>(round_to<To>(part->shape)) : nullptr;
}

template <Scalar To, Scalar From>
[[nodiscard]] std::vector<SharedShape<To>> round_to(const std::vector<SharedShape<From>>& parts) {
  std::vector<SharedShape<To>> rounded;
  rounded.reserve(parts.size());
  for (const SharedShape<From>& part : parts) rounded.push_back(round_to<To>(part));
  return rounded;
}

template <Scalar To, Scalar From>
[[nodiscard]] Shape<To> round_to(const Shape<From>& shape) {
  struct Rounding {
    static To number(From x) { return static_cast<To>(x); }
    Shape<To> operator()(const Point<From>&) const { return Point<To>{}; }
    Shape<To> operator()(const Segment<From>& s) const {
      return Segment<To>{round_to<To>(s.a), round_to<To>(s.b)};
    }
    Shape<To> operator()(const Triangle<From>& t) const {
      return Triangle<To>{round_to<To>(t.a), round_to<To>(t.b), round_to<To>(t.c)};
    }
    Shape<To> operator()(const Sphere<From>& s) const { return Sphere<To>{number(s.radius)}; }
    Shape<To> operator()(const Capsule<From>& c) const {
      return Capsule<To>{number(c.radius), number(c.half_height)};
    }
    Shape<To> operator()(const Box<From>& b) const { return Box<To>{round_to<To>(b.half_extents)}; }
    Shape<To> operator()(const Ellipsoid<From>& e) const { return Ellipsoid<To>{round_to<To>(e.radii)}; }
    Shape<To> operator()(const Cylinder<From>& c) const {
      return Cylinder<To>{number(c.radius), number(c.half_height)};
    }
    Shape<To> operator()(const Cone<From>& c) const {
      return Cone<To>{number(c.radius), number(c.half_height)};
    }
    Shape<To> operator()(const Hull<From>& h) const { return own_hull<To>(h); }
    Shape<To> operator()(const Posed<From>& p) const {
      return Posed<To>{round_to<To>(p.shape), round_to<To>(p.position), round_to<To>(p.orientation)};
    }
    Shape<To> operator()(const Rounded<From>& r) const {
      return Rounded<To>{round_to<To>(r.shape), number(r.radius)};
    }
    Shape<To> operator()(const Sum<From>& s) const { return Sum<To>{round_to<To>(s.shapes)}; }
    Shape<To> operator()(const HullOf<From>& h) const { return HullOf<To>{round_to<To>(h.shapes)}; }
  };
  return std::visit(Rounding{}, shape);
}

template <Scalar To, Scalar From>
[[nodiscard]] Body<To> round_to(const Body<From>& body) {
  return {.shape = round_to<To>(body.shape),
          .position = round_to<To>(body.position),
          .orientation = round_to<To>(body.orientation),
          .displacement = round_to<To>(body.displacement)};
}

// A body of a case, and its rotation.
template <Scalar To>
[[nodiscard]] RotatingBody<To> round_to(const Body<double>& body, const corpus::Spin& spin) {
  return {
      .body = round_to<To>(body), .rotation = round_to<To>(spin.rotation), .pivot = round_to<To>(spin.pivot)};
}

// The case with every number of its question rounded to S and written as a double again. The expected answer
// of the given numbers need not hold for the rounded ones, so `expect` is kept only if no number changes.
template <Scalar S>
[[nodiscard]] corpus::Case rounded_case(const corpus::Case& problem) {
  if constexpr (std::same_as<S, double>) {
    return problem;
  } else {
    corpus::Case seen = problem;
    seen.a = round_to<double>(round_to<S>(problem.a));
    seen.b = round_to<double>(round_to<S>(problem.b));
    for (corpus::Spin* spin : {&seen.spin_a, &seen.spin_b}) {
      spin->rotation = round_to<double>(round_to<S>(spin->rotation));
      spin->pivot = round_to<double>(round_to<S>(spin->pivot));
    }
    seen.t_max = static_cast<S>(problem.t_max);
    seen.target_distance = static_cast<S>(problem.target_distance);
    seen.direction = round_to<double>(round_to<S>(problem.direction));
    seen.expect.reset();
    return seen;
  }
}

}  // namespace graze::engine
