/// @file
/// Shapes: closed convex sets given by finite numbers, in the body's own frame and the caller's length unit.
///
/// The set is exactly the one that the numbers define. Zero extents and radii are valid, negative ones are
/// `invalid_input`. A shape is a value. Copies share hulls and the parts of combinators, which never change.
///
/// A shape is the Minkowski sum of its core and a ball: of `radius` for spheres and capsules, of radius 0 for the
/// others. Proofs name a vertex of the core by its index. Each shape says how its vertices are counted.
#pragma once

#include <graze/hull.hpp>
#include <variant>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The point {0}, the origin of the body's frame. The cast of a point is a ray. Vertex 0.
template <Scalar S>
struct Point {};

/// The segment between a and b, which may be equal. Vertices a, b.
template <Scalar S>
struct Segment {
  Vec3<S> a = Vec3<S>::Zero();  ///< One end, in the body's own frame.
  Vec3<S> b = Vec3<S>::Zero();  ///< The other end.
};

/// The triangle a b c, without a thickness or an inner side. Vertices a, b, c.
template <Scalar S>
struct Triangle {
  Vec3<S> a = Vec3<S>::Zero();  ///< A corner, in the body's own frame. Any order will do.
  Vec3<S> b = Vec3<S>::Zero();  ///< A corner.
  Vec3<S> c = Vec3<S>::Zero();  ///< A corner.
};

/// The ball {x : |x| <= radius}. Vertex 0, the centre.
template <Scalar S>
struct Sphere {
  S radius = 0;  ///< 0 or more, a length.
};

/// All points within `radius` of the segment from -half_height to +half_height on z. Vertex 0 below, 1 above.
template <Scalar S>
struct Capsule {
  S radius = 0;       ///< 0 or more, a length.
  S half_height = 0;  ///< 0 or more. The capsule is 2 (half_height + radius) high.
};

/// The box {x : |x_i| <= half_extents_i}. Vertex k of 0..7 has x_i = +half_extents_i if bit i of k is set, else the
/// negative.
template <Scalar S>
struct Box {
  Vec3<S> half_extents = Vec3<S>::Zero();  ///< Half the lengths of the sides along x, y and z, 0 or more.
};

/// The ellipsoid {x : sum (x_i / radii_i)^2 <= 1}, with x_i = 0 where radii_i = 0. It is curved: vertex 0 stands for
/// all its points, as it does for the cylinder and the cone.
template <Scalar S>
struct Ellipsoid {
  Vec3<S> radii = Vec3<S>::Zero();  ///< The half axes along x, y and z, lengths, 0 or more.
};

/// The cylinder about z, {x : x^2 + y^2 <= radius^2, |z| <= half_height}. Curved.
template <Scalar S>
struct Cylinder {
  S radius = 0;       ///< 0 or more, a length.
  S half_height = 0;  ///< 0 or more. With 0 it is a disc.
};

/// The cone about z: the hull of the apex (0, 0, half_height) and the disc x^2 + y^2 <= radius^2 at z = -half_height.
/// Curved.
template <Scalar S>
struct Cone {
  S radius = 0;       ///< Radius of the base, 0 or more.
  S half_height = 0;  ///< 0 or more. With 0 it is a disc.
};

template <Scalar S>
struct ShapeNode;

/// A part of a combinator, made by share(). A null pointer is `invalid_input` (Invalid::missing_part).
template <Scalar S>
using SharedShape = std::shared_ptr<const ShapeNode<S>>;

/// A shape at a pose of its own, {position + R(orientation) x : x in shape}. It has the vertices of the shape. posed()
/// and translated() make it.
template <Scalar S>
struct Posed {
  SharedShape<S> shape;                ///< The shape that is placed.
  Vec3<S> position = Vec3<S>::Zero();  ///< Position of the shape's own origin, a length.
  Quaternion<S> orientation = {};      ///< Any quaternion other than 0.
};

/// A shape grown by a ball, {x + y : x in shape, |y| <= radius}. It has the vertices of the shape. rounded() makes it.
template <Scalar S>
struct Rounded {
  SharedShape<S> shape;  ///< The shape that is grown.
  S radius = 0;          ///< 0 or more, a length.
};

/// The Minkowski sum {x_1 + ... + x_n : x_i in shapes_i}. It has a vertex for each choice of one vertex from every
/// part, and the last part's index counts fastest. sum() and swept() make it of two shapes.
///
/// @code
/// // A box of half extents 1, 2 and 3 as the sum of three segments. share() turns a shape into a part.
/// const graze::SharedShape<double> x = graze::share<double>(graze::Segment<double>{{-1, 0, 0}, {1, 0, 0}});
/// const graze::SharedShape<double> y = graze::share<double>(graze::Segment<double>{{0, -2, 0}, {0, 2, 0}});
/// const graze::SharedShape<double> z = graze::share<double>(graze::Segment<double>{{0, 0, -3}, {0, 0, 3}});
/// const graze::Body<double> box{.shape = graze::Sum<double>{{x, y, z}}}, corner{.position = {1, 2, 3}};
/// assert(graze::overlap_exact(box, corner).outcome == graze::Outcome::initially_overlapping);  // they touch
/// @endcode
template <Scalar S>
struct Sum {
  std::vector<SharedShape<S>> shapes;  ///< One or more.
};

/// The convex hull of the union of shapes. It has the vertices of the first part, then those of the second, and so on.
/// hull_of() makes it of two shapes.
template <Scalar S>
struct HullOf {
  std::vector<SharedShape<S>> shapes;  ///< One or more.
};

/// Any shape: one of fourteen kinds. Every kind converts to it.
///
/// Use it as the `std::variant` that it derives from, with `std::visit`, `std::get`, `std::get_if` and
/// `std::holds_alternative`. Combinators may nest 16 deep and have 4096 parts. Beyond that a query answers
/// `invalid_input` (Invalid::too_complex). A support query takes constant time for a simple shape, the time of its
/// vertices for a hull, and the sum of its parts for a combinator.
///
/// @code
/// const std::vector<graze::Shape<double>> shapes = {  // the highest point of each is at z = 1
///     graze::Segment<double>{{0, 0, -1}, {0, 0, 1}}, graze::Triangle<double>{{-1, 0, 1}, {1, 0, 1}, {0, 1, 1}},
///     graze::Ellipsoid<double>{{3, 2, 1}}, graze::Cylinder<double>{2, 1}, graze::Cone<double>{2, 1}};
/// const graze::Body<double> above{.shape = graze::Point<double>{}, .position = {0, 0, 5}};
/// for (const graze::Shape<double>& shape : shapes) {
///   const graze::Body<double> body{.shape = shape};
///   assert(std::abs(graze::distance(body, above).upper - 4) < 1e-12);
/// }
/// @endcode
///
/// @code
/// const graze::Shape<double> box = graze::Box<double>{{1, 2, 3}};
/// const graze::Shape<double> die = graze::rounded<double>(box, 0.1);
/// assert(std::get<graze::Box<double>>(box).half_extents[1] == 2);
/// assert(std::holds_alternative<graze::Rounded<double>>(die));
/// @endcode
//
// The functions that copy, move and destroy fourteen kinds are compiled with the library, and not again in every file
// that holds a shape.
template <Scalar S>
class Shape
    : public std::variant<Point<S>, Segment<S>, Triangle<S>, Sphere<S>, Capsule<S>, Box<S>, Ellipsoid<S>,
                          Cylinder<S>, Cone<S>, Hull<S>, Posed<S>, Rounded<S>, Sum<S>, HullOf<S>> {
 public:
  using Kinds = typename Shape::variant;  ///< The variant of all kinds.
  using Kinds::Kinds;
  using Kinds::operator=;

  Shape() noexcept = default;  ///< A point.
  /// @cond
  Shape(const Shape&);
  Shape(Shape&&) noexcept;
  Shape& operator=(const Shape&);
  Shape& operator=(Shape&&) noexcept;
  ~Shape();
  /// @endcond
};

/// The object that a SharedShape points to.
///
/// @code
/// const graze::SharedShape<double> part = graze::share<double>(graze::Sphere<double>{2});
/// assert(std::get<graze::Sphere<double>>(part->shape).radius == 2);
/// @endcode
template <Scalar S>
struct ShapeNode {
  Shape<S> shape;  ///< The part.
};

/// Makes a part of a combinator from a shape. It allocates memory once. The part may be used in many combinators.
template <Scalar S>
SharedShape<S> share(Shape<S> shape) {
  return std::make_shared<const ShapeNode<S>>(ShapeNode<S>{std::move(shape)});
}

/// The shape at a pose: {position + R(orientation) x : x in shape}. `position` is a length, and `orientation` any
/// quaternion other than 0. It allocates memory for the part, as the functions below do.
///
/// @code
/// // A T from two boxes: the bar, and the stem below it.
/// const graze::Shape<double> bar = graze::Box<double>{{1, 0.1, 0.1}};
/// const graze::Shape<double> stem = graze::posed<double>(bar, {0, 0, -1}, {1, 0, 1, 0});
/// const graze::Shape<double> filled_t = graze::hull_of<double>(bar, stem);  // convex, so not the T itself
/// assert(std::get<graze::HullOf<double>>(filled_t).shapes.size() == 2);
/// @endcode
template <Scalar S>
Shape<S> posed(Shape<S> shape, const Vec3<S>& position, const Quaternion<S>& orientation) {
  return Posed<S>{share<S>(std::move(shape)), position, orientation};
}
/// The shape moved by `position`, a length: {position + x : x in shape}.
///
/// @code
/// const graze::Shape<double> raised = graze::translated<double>(graze::Box<double>{{1, 1, 1}}, {0, 0, 3});
/// assert(std::get<graze::Posed<double>>(raised).position[2] == 3);
/// const graze::Shape<double> tall = graze::sum<double>(raised, graze::Box<double>{{0.5, 0.5, 2}});  // z from 0 to 6
/// const graze::Shape<double> path = graze::swept<double>(tall, {9, 0, 0});  // x from -1.5 to 10.5
/// const graze::Body<double> point{.position = {12.5, 0, 5}};
/// assert(std::abs(graze::distance(graze::Body<double>{.shape = path}, point).upper - 2) < 1e-12);
/// @endcode
template <Scalar S>
Shape<S> translated(Shape<S> shape, const Vec3<S>& position) {
  return Posed<S>{share<S>(std::move(shape)), position, {}};
}
/// The shape grown by a ball of this radius, a length of 0 or more.
template <Scalar S>
Shape<S> rounded(Shape<S> shape, S radius) {
  return Rounded<S>{share<S>(std::move(shape)), radius};
}
/// The Minkowski sum of two shapes. For more than two, fill a Sum.
template <Scalar S>
Shape<S> sum(Shape<S> first, Shape<S> second) {
  return Sum<S>{{share<S>(std::move(first)), share<S>(std::move(second))}};
}
/// The convex hull of two shapes. For more than two, fill a HullOf.
template <Scalar S>
Shape<S> hull_of(Shape<S> first, Shape<S> second) {
  return HullOf<S>{{share<S>(std::move(first)), share<S>(std::move(second))}};
}
/// The set that a shape sweeps along a displacement, {x + s displacement : x in shape, 0 <= s <= 1}. It is the sum of
/// the shape and a segment. The displacement is a length in the shape's own frame.
template <Scalar S>
Shape<S> swept(Shape<S> shape, const Vec3<S>& displacement) {
  return sum<S>(std::move(shape), Segment<S>{Vec3<S>::Zero(), displacement});
}

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/shapes/shape_copies.hpp>
#endif
