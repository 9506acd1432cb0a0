// Names the vectors that the exact tier decides about: vertices of C, its summands, and vectors between them.
//
// A vertex of C is one of A and one of B (shape.hpp has the indices). C is a sum of leaves, +R x for the vertices x
// of A's parts and -R x for B's, and of the translations of the parts. A term is a vector that is given by such
// names, and is therefore exact.
#pragma once

#include <graze/body.hpp>
#include <graze/detail/shapes/shape_tree.hpp>
#include <vector>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// A vertex of C.
struct Vertex {
  std::uint32_t a, b;
  friend bool operator==(const Vertex&, const Vertex&) = default;
};

// Is the shape a polytope that the exact tier knows? `rounded`: or one with a ball about it.
template <Scalar S>
bool is_exact(const Shape<S>& shape, bool rounded = false) {
  const auto all = [&](std::span<const SharedShape<S>> parts) {
    return std::all_of(parts.begin(), parts.end(),
                       [&](const SharedShape<S>& part) { return is_exact<S>(part->shape, rounded); });
  };
  return std::visit(
      Overloaded{[](const Point<S>&) { return true; }, [](const Segment<S>&) { return true; },
                 [](const Triangle<S>&) { return true; }, [](const Box<S>&) { return true; },
                 [](const Hull<S>&) { return true; }, [&](const Sphere<S>&) { return rounded; },
                 [&](const Capsule<S>&) { return rounded; },
                 [&](const Rounded<S>& s) { return rounded && all(std::span(&s.shape, 1)); },
                 [&](const Posed<S>& s) { return all(std::span(&s.shape, 1)); },
                 [&](const Sum<S>& s) { return all(s.shapes); }, [](const auto&) { return false; }},
      shape);
}

// One summand of C: sign R x for the vertices x of a shape that is no combinator. R is a product of rotations,
// outermost first. The translations are in the scene's shifts.
template <Scalar S>
struct Leaf {
  enum class Kind : std::uint8_t { point, few, list, box };
  Kind kind = Kind::point;
  bool of_b = false;
  bool turned = false;
  std::uint32_t stride = 1, count = 1;  // its vertex is (body's vertex / stride) % count
  const Shape<S>* shape = nullptr;
  const Vec3<S>* list = nullptr;  // a hull's vertices
  std::array<Vec3<S>, 3> few;     // a segment's or a triangle's, for a box the half extents first
  Quaternion<double> outer = {};  // the body's
  std::vector<Quaternion<double>> inner = {};

  void init(const Shape<S>& given, bool is_of_b, const Quaternion<double>& outer_turn) {
    of_b = is_of_b;
    shape = &without_ball(given);
    outer = outer_turn;
    turned = !outer.is_identity();
    if (const auto* hull = std::get_if<Hull<S>>(shape)) {
      kind = Kind::list;
      list = hull->vertices().data();
      count = static_cast<std::uint32_t>(hull->size());
    } else if (const auto* box = std::get_if<Box<S>>(shape)) {
      kind = Kind::box;
      few[0] = box->half_extents;
      count = 8;
    } else if (const auto* segment = std::get_if<Segment<S>>(shape)) {
      kind = Kind::few;
      few = {segment->a, segment->b, segment->b};
      count = 2;
    } else if (const auto* capsule = std::get_if<Capsule<S>>(shape)) {
      kind = Kind::few;  // of its core
      few[1] = few[2] = Vec3<S>(0, 0, capsule->half_height);
      few[0] = -few[1];
      count = 2;
    } else if (const auto* triangle = std::get_if<Triangle<S>>(shape)) {
      kind = Kind::few;
      few = {triangle->a, triangle->b, triangle->c};
      count = 3;
    }
  }

  // As given, in caller's units and the leaf's own frame.
  [[nodiscard]] Vec3<double> point(std::uint32_t k) const {
    switch (kind) {
      case Kind::list:
        return list[k].template cast<double>();
      case Kind::box:
        return box_vertex(Vec3<double>(few[0].template cast<double>()), k);
      case Kind::few:
        return few[k].template cast<double>();
      case Kind::point:
        break;
    }
    return Vec3<double>::Zero();
  }
  [[nodiscard]] std::uint32_t vertex(const Vertex& v) const {
    const std::uint32_t whole = of_b ? v.b : v.a;
    return stride == 1 && whole < count ? whole : whole / stride % count;
  }
  // v with another vertex of this leaf.
  [[nodiscard]] Vertex with(Vertex v, std::uint32_t k) const {
    std::uint32_t& whole = of_b ? v.b : v.a;
    whole += (k - vertex(v)) * stride;  // modulo 2^32, which cancels
    return v;
  }
};

// The same rotation, its largest component in [1, 2).
inline Quaternion<double> scaled_to_one(const Quaternion<double>& q) {
  const double largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  const int shift = -exponent_of(largest);
  const double scale = power_of_two(shift);  // exact: the range is that of valid input
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

// An exact vector.
struct Term {
  enum class Kind : std::uint8_t {
    motion,      // v
    given,       // a triple of doubles
    point,       // vertex `to` of C
    difference,  // to - from, both of C
    step,        // of a leaf, as part of C: from its vertex k to its vertex l
    inside,      // around[0] + around[1] + around[2] - 3 from
  };
  Kind kind;
  // Only the members that the kind needs are set.
  Vertex from, to;
  std::uint32_t leaf, k, l;
  std::array<Vertex, 3> around;
  std::array<double, 3> triple;

  static Term of(Kind kind) {
    Term out;
    out.kind = kind;
    return out;
  }
  static Term motion() { return of(Kind::motion); }
  static Term given(const Vec3<double>& x) {
    Term out = of(Kind::given);
    out.triple = {x[0], x[1], x[2]};
    return out;
  }
  static Term point(const Vertex& v) {
    Term out = of(Kind::point);
    out.to = v;
    return out;
  }
  static Term difference(const Vertex& from, const Vertex& to) {
    Term out = of(Kind::difference);
    out.from = from;
    out.to = to;
    return out;
  }
  static Term step(std::uint32_t leaf, std::uint32_t k, std::uint32_t l) {
    Term out = of(Kind::step);
    out.leaf = leaf;
    out.k = k;
    out.l = l;
    return out;
  }
  static Term inside(const std::array<Vertex, 3>& around, const Vertex& from) {
    Term out = of(Kind::inside);
    out.around = around;
    out.from = from;
    return out;
  }
  [[nodiscard]] Vec3<double> given_triple() const { return {triple[0], triple[1], triple[2]}; }
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
