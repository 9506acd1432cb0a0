// Shapes: closed convex sets given by finite numbers, in the body's own frame, in the caller's length unit.
//
// The set is exactly the one that the numbers define; zero extents and radii are valid. A shape is a value;
// a hull shares its immutable vertices between copies.
#pragma once

#include <graze/hull.hpp>
#include <variant>

namespace graze {

// {0}
template <Scalar S>
struct Point {};

// {x : |x| <= radius}
template <Scalar S>
struct Sphere {
  S radius = 0;
};

// {x : |x_i| <= half_extents_i}. Vertex k of 0..7 has x_i = +half_extents_i where bit i of k is set, else -.
template <Scalar S>
struct Box {
  Vec3<S> half_extents = Vec3<S>::Zero();
};

template <Scalar S>
using Shape = std::variant<Point<S>, Sphere<S>, Box<S>, Hull<S>>;

}  // namespace graze
