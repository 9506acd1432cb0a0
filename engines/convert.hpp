// A case in the scalar of a method: every number rounded to the nearest S. In double nothing changes.
//
// A magnitude beyond the range of float becomes infinite, and the method then refuses the case; one below it
// becomes a subnormal or 0, and the case means what it then says.
#pragma once

#include <vector>

#include "corpus/case.hpp"

namespace graze::engine {

template <Scalar To, Scalar From>
[[nodiscard]] Vec3<To> round_to(const Vec3<From>& v) {
  return v.template cast<To>();
}

template <Scalar To, Scalar From>
[[nodiscard]] Shape<To> round_to(const Shape<From>& shape) {
  struct Rounding {
    Shape<To> operator()(const Point<From>&) const { return Point<To>{}; }
    Shape<To> operator()(const Sphere<From>& s) const { return Sphere<To>{static_cast<To>(s.radius)}; }
    Shape<To> operator()(const Box<From>& b) const { return Box<To>{round_to<To>(b.half_extents)}; }
    Shape<To> operator()(const Hull<From>& h) const {
      std::vector<Vec3<To>> vertices;
      vertices.reserve(h.size());
      for (const Vec3<From>& v : h.vertices()) vertices.push_back(round_to<To>(v));
      return Hull<To>(std::span<const Vec3<To>>(vertices));
    }
  };
  return std::visit(Rounding{}, shape);
}

template <Scalar To, Scalar From>
[[nodiscard]] Body<To> round_to(const Body<From>& body) {
  const Quaternion<From>& q = body.orientation;
  return {
      .shape = round_to<To>(body.shape),
      .position = round_to<To>(body.position),
      .orientation = {static_cast<To>(q.w), static_cast<To>(q.x), static_cast<To>(q.y), static_cast<To>(q.z)},
      .displacement = round_to<To>(body.displacement)};
}

// The case with every number of its question rounded to S and written as a double again. What is expected of
// the given numbers need not hold for these, so `expect` survives only where nothing changes.
template <Scalar S>
[[nodiscard]] corpus::Case rounded_case(const corpus::Case& problem) {
  if constexpr (std::same_as<S, double>) {
    return problem;
  } else {
    corpus::Case seen = problem;
    seen.a = round_to<double>(round_to<S>(problem.a));
    seen.b = round_to<double>(round_to<S>(problem.b));
    seen.t_max = static_cast<S>(problem.t_max);
    seen.target_distance = static_cast<S>(problem.target_distance);
    seen.expect.reset();
    return seen;
  }
}

}  // namespace graze::engine
