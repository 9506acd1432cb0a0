// Shapes as the laws and the generator use them: a tree whose leaves hold numbers. There is one recursion for each
// operation, so that no law has to know the kinds of shapes.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <graze/hull.hpp>
#include <optional>
#include <vector>

#include "corpus/case.hpp"

namespace graze::law {

// The meaning of a scalar of a case.
enum class Slot : std::uint8_t {
  vertex,
  extent,
  position,
  orientation,
  displacement,
  horizon,
  target,
  rotation,
  pivot,
};

[[nodiscard]] constexpr bool is_length(Slot slot) {
  return slot != Slot::orientation && slot != Slot::horizon && slot != Slot::rotation;
}

// The shape with every scalar x replaced by f(slot, x), in the order of its fields. Parts come in their order. A
// missing part stays missing.
template <class F>
[[nodiscard]] Shape<double> map_shape(const Shape<double>& shape, F& f);

namespace detail {

template <class F>
struct ShapeMap {
  F& f;

  Vec3<double> vector(Slot slot, Vec3<double> v) const {
    for (int i = 0; i < 3; ++i) v[i] = f(slot, v[i]);
    return v;
  }
  Quaternion<double> quaternion(Quaternion<double> q) const {
    for (double* x : {&q.w, &q.x, &q.y, &q.z}) *x = f(Slot::orientation, *x);
    return q;
  }
  static bool same_bits(double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  }
  SharedShape<double> part(const SharedShape<double>& given) const {
    return given ? share(map_shape(given->shape, f)) : nullptr;
  }

  Shape<double> operator()(const Point<double>& p) const { return p; }
  Shape<double> operator()(Segment<double> s) const {
    for (Vec3<double>* x : {&s.a, &s.b}) *x = vector(Slot::vertex, *x);
    return s;
  }
  Shape<double> operator()(Triangle<double> t) const {
    for (Vec3<double>* x : {&t.a, &t.b, &t.c}) *x = vector(Slot::vertex, *x);
    return t;
  }
  Shape<double> operator()(Sphere<double> s) const {
    s.radius = f(Slot::extent, s.radius);
    return s;
  }
  Shape<double> operator()(Box<double> b) const {
    b.half_extents = vector(Slot::extent, b.half_extents);
    return b;
  }
  Shape<double> operator()(Ellipsoid<double> e) const {
    e.radii = vector(Slot::extent, e.radii);
    return e;
  }
  Shape<double> operator()(const Hull<double>& h) const {
    std::vector<Vec3<double>> vertices(h.vertices().begin(), h.vertices().end());
    bool changed = false;
    for (Vec3<double>& v : vertices) {
      const Vec3<double> before = v;
      v = vector(Slot::vertex, v);
      for (int i = 0; i < 3; ++i) changed = changed || !same_bits(before[i], v[i]);
    }
    // An unchanged hull needs no new adjacency.
    if (!changed) return h;
    const bool sound =
        std::all_of(vertices.begin(), vertices.end(), [](const Vec3<double>& v) { return v.allFinite(); });
    if (h.has_adjacency() && sound) return with_adjacency<double>(vertices);
    return Hull<double>(std::span<const Vec3<double>>(vertices));
  }
  Shape<double> operator()(Posed<double> p) const {
    p.shape = part(p.shape);
    p.position = vector(Slot::position, p.position);
    p.orientation = quaternion(p.orientation);
    return p;
  }
  Shape<double> operator()(Rounded<double> r) const {
    r.shape = part(r.shape);
    r.radius = f(Slot::extent, r.radius);
    return r;
  }
  // Capsule, cylinder, cone.
  template <class Round>
  requires requires(Round s) { s.half_height; }
  Shape<double> operator()(Round s) const {
    s.radius = f(Slot::extent, s.radius);
    s.half_height = f(Slot::extent, s.half_height);
    return s;
  }
  // Sum, hull of several.
  template <class Combinator>
  requires requires(Combinator s) { s.shapes; }
  Shape<double> operator()(Combinator s) const {
    for (SharedShape<double>& one : s.shapes) one = part(one);
    return s;
  }
};

}  // namespace detail

template <class F>
Shape<double> map_shape(const Shape<double>& shape, F& f) {
  return std::visit(detail::ShapeMap<F>{f}, shape);
}

namespace detail {

// The same visit for callers that only read: no shape is copied.
template <class F>
struct ShapeVisit {
  F& f;

  void vector(Slot slot, const Vec3<double>& v) const {
    for (int i = 0; i < 3; ++i) f(slot, v[i]);
  }
  void quaternion(const Quaternion<double>& q) const {
    for (const double x : {q.w, q.x, q.y, q.z}) f(Slot::orientation, x);
  }
  void part(const SharedShape<double>& given) const {
    if (given) std::visit(*this, given->shape);
  }

  void operator()(const Point<double>&) const {}
  void operator()(const Segment<double>& s) const {
    for (const Vec3<double>* x : {&s.a, &s.b}) vector(Slot::vertex, *x);
  }
  void operator()(const Triangle<double>& t) const {
    for (const Vec3<double>* x : {&t.a, &t.b, &t.c}) vector(Slot::vertex, *x);
  }
  void operator()(const Sphere<double>& s) const { f(Slot::extent, s.radius); }
  void operator()(const Box<double>& b) const { vector(Slot::extent, b.half_extents); }
  void operator()(const Ellipsoid<double>& e) const { vector(Slot::extent, e.radii); }
  void operator()(const Hull<double>& h) const {
    for (const Vec3<double>& v : h.vertices()) vector(Slot::vertex, v);
  }
  void operator()(const Posed<double>& p) const {
    part(p.shape);
    vector(Slot::position, p.position);
    quaternion(p.orientation);
  }
  void operator()(const Rounded<double>& r) const {
    part(r.shape);
    f(Slot::extent, r.radius);
  }
  template <class Round>
  requires requires(Round s) { s.half_height; }
  void operator()(const Round& s) const {
    f(Slot::extent, s.radius);
    f(Slot::extent, s.half_height);
  }
  template <class Combinator>
  requires requires(Combinator s) { s.shapes; }
  void operator()(const Combinator& s) const {
    for (const SharedShape<double>& one : s.shapes) part(one);
  }
};

}  // namespace detail

// The parts of a combinator, or nothing for a leaf.
[[nodiscard]] std::vector<SharedShape<double>> parts_of(const Shape<double>& shape);
// The combinator with other parts, as many as it had for posed and rounded. A leaf stays as it is.
[[nodiscard]] Shape<double> with_parts(const Shape<double>& shape, std::vector<SharedShape<double>> parts);

// Everything of a shape but its scalars: kinds, numbers of vertices and of parts, where parts are missing.
// Two shapes with one outline have the same scalars in the same slots.
[[nodiscard]] std::vector<std::uint32_t> outline(const Shape<double>& shape);
[[nodiscard]] int node_count(const Shape<double>& shape);

// Vertices by the rule of core/graze/shape.hpp, counted, saturating at 2^63.
[[nodiscard]] std::uint64_t vertex_count(const Shape<double>& shape);
// Is the shape refused whatever the numbers are? Such shapes are an empty hull, a combinator without parts or with a
// missing one, and a zero quaternion in a part's pose. Parts nested deeper than 16 and more than 2^32 - 1 vertices are
// refused, too.
[[nodiscard]] bool is_malformed(const Shape<double>& shape);

// Without an ellipsoid, a cylinder or a cone. Such a shape is made of polytopes and balls.
[[nodiscard]] bool is_uncurved(const Shape<double>& shape);
// Made of points, segments, triangles, boxes and hulls alone.
[[nodiscard]] bool is_polytope(const Shape<double>& shape);
// The vertices of a polytope in its own frame, by index. Every one must be a triple of doubles without rounding, and
// there must be no more than `most`.
[[nodiscard]] std::optional<std::vector<Vec3<double>>> exact_vertices(const Shape<double>& shape,
                                                                      std::size_t most);

// A superset: an extent grown, a vertex more, or a point turned into a sphere or a segment. In a combinator, one of its
// parts is grown, or a rounding. `salt` chooses.
[[nodiscard]] Shape<double> grown(const Shape<double>& shape, std::uint64_t salt);

// SplitMix64's finaliser (Steele, Lea, Flood 2014): a bijection on 64 bits.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// A signed permutation of the axes that x -> q x conj(q) / |q|^2 makes, if it is one that needs no
// arithmetic: the identity and the half turns about the axes.
[[nodiscard]] std::optional<Vec3<double>> signs_of(const Quaternion<double>& q);

// a + b where exact.
[[nodiscard]] std::optional<double> exact_sum(double a, double b);
[[nodiscard]] std::optional<Vec3<double>> exact_sum(const Vec3<double>& a, const Vec3<double>& b);

}  // namespace graze::law
