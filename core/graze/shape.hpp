// Shapes: closed convex sets given by finite numbers, in the body's own frame, in the caller's length unit.
//
// The set is exactly the one that the numbers define; zero extents and radii are valid. A shape is a value:
// copies share hulls and the parts of combinators, which are immutable.
//
// A shape is the Minkowski sum of its core and a ball: of `radius` for spheres and capsules, of radius 0 for
// the others. Proofs name a vertex of the core by its index; how vertices are counted is said with each
// shape.
#pragma once

#include <graze/hull.hpp>
#include <variant>

namespace graze { inline namespace GRAZE_LINKAGE {

// {0}. Vertex 0.
template <Scalar S>
struct Point {};

// The segment between a and b. Vertices a, b.
template <Scalar S>
struct Segment {
  Vec3<S> a = Vec3<S>::Zero(), b = Vec3<S>::Zero();
};

// The triangle a b c. Vertices a, b, c.
template <Scalar S>
struct Triangle {
  Vec3<S> a = Vec3<S>::Zero(), b = Vec3<S>::Zero(), c = Vec3<S>::Zero();
};

// {x : |x| <= radius}. Vertex 0, the centre.
template <Scalar S>
struct Sphere {
  S radius = 0;
};

// Within `radius` of the segment from -half_height to +half_height on z. Vertex 0 below, 1 above.
template <Scalar S>
struct Capsule {
  S radius = 0, half_height = 0;
};

// {x : |x_i| <= half_extents_i}. Vertex k of 0..7 has x_i = +half_extents_i where bit i of k is set, else -.
template <Scalar S>
struct Box {
  Vec3<S> half_extents = Vec3<S>::Zero();
};

// {x : sum (x_i / radii_i)^2 <= 1}; x_i = 0 where radii_i = 0. Curved: vertex 0 stands for all its points, as
// it does for the cylinder and the cone.
template <Scalar S>
struct Ellipsoid {
  Vec3<S> radii = Vec3<S>::Zero();
};

// {x : x^2 + y^2 <= radius^2, |z| <= half_height}. Curved.
template <Scalar S>
struct Cylinder {
  S radius = 0, half_height = 0;
};

// The hull of the apex (0, 0, half_height) and the disk x^2 + y^2 <= radius^2 at z = -half_height. Curved.
template <Scalar S>
struct Cone {
  S radius = 0, half_height = 0;
};

template <Scalar S>
struct ShapeNode;

// A part of a combinator. Without a shape it is invalid_input.
template <Scalar S>
using SharedShape = std::shared_ptr<const ShapeNode<S>>;

// {position + R(orientation) x : x in shape}. The vertices of the shape.
template <Scalar S>
struct Posed {
  SharedShape<S> shape;
  Vec3<S> position = Vec3<S>::Zero();
  Quaternion<S> orientation = {};
};

// {x + y : x in shape, |y| <= radius}. The vertices of the shape.
template <Scalar S>
struct Rounded {
  SharedShape<S> shape;
  S radius = 0;
};

// {x_1 + ... + x_n : x_i in shapes_i}, the Minkowski sum. A vertex for each choice of one vertex from every
// part; the last part's index counts fastest.
template <Scalar S>
struct Sum {
  std::vector<SharedShape<S>> shapes;
};

// The convex hull of the union. The vertices of the first part, then those of the second, ...
template <Scalar S>
struct HullOf {
  std::vector<SharedShape<S>> shapes;
};

// One of these. It is used as the std::variant that it is derived from: std::visit, std::get, std::get_if and
// std::holds_alternative take it. What copies, moves and destroys fourteen kinds is compiled with the library,
// and not again in every file that holds a shape.
template <Scalar S>
class Shape
    : public std::variant<Point<S>, Segment<S>, Triangle<S>, Sphere<S>, Capsule<S>, Box<S>, Ellipsoid<S>,
                          Cylinder<S>, Cone<S>, Hull<S>, Posed<S>, Rounded<S>, Sum<S>, HullOf<S>> {
 public:
  using Kinds = typename Shape::variant;
  using Kinds::Kinds;
  using Kinds::operator=;

  Shape() = default;
  Shape(const Shape&);
  Shape(Shape&&) noexcept;
  Shape& operator=(const Shape&);
  Shape& operator=(Shape&&) noexcept;
  ~Shape();
};

template <Scalar S>
struct ShapeNode {
  Shape<S> shape;
};

template <Scalar S>
SharedShape<S> share(Shape<S> shape) {
  return std::make_shared<const ShapeNode<S>>(ShapeNode<S>{std::move(shape)});
}

// What the combinators are made with.
template <Scalar S>
Shape<S> posed(Shape<S> shape, const Vec3<S>& position, const Quaternion<S>& orientation) {
  return Posed<S>{share<S>(std::move(shape)), position, orientation};
}
template <Scalar S>
Shape<S> translated(Shape<S> shape, const Vec3<S>& position) {
  return Posed<S>{share<S>(std::move(shape)), position, {}};
}
template <Scalar S>
Shape<S> rounded(Shape<S> shape, S radius) {
  return Rounded<S>{share<S>(std::move(shape)), radius};
}
template <Scalar S>
Shape<S> sum(Shape<S> first, Shape<S> second) {
  return Sum<S>{{share<S>(std::move(first)), share<S>(std::move(second))}};
}
template <Scalar S>
Shape<S> hull_of(Shape<S> first, Shape<S> second) {
  return HullOf<S>{{share<S>(std::move(first)), share<S>(std::move(second))}};
}
// {x + s displacement : x in shape, 0 <= s <= 1}: a sum with a segment.
template <Scalar S>
Shape<S> swept(Shape<S> shape, const Vec3<S>& displacement) {
  return sum<S>(std::move(shape), Segment<S>{Vec3<S>::Zero(), displacement});
}

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/shapes/shape_copies.hpp>
#endif
