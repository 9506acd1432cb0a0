// Are two bodies one and the same, to the bit? Hulls and the parts of combinators count as the same if they are
// shared. Others are taken for different, which costs a cast.
#pragma once

#include <graze/body.hpp>

#include <cstring>

namespace graze::scene {

template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] bool same_bits(Number l, Number r) { return std::memcmp(&l, &r, sizeof l) == 0; }
[[nodiscard]] inline bool same_bits(const Vec3<double>& l, const Vec3<double>& r) {
  return std::memcmp(l.data(), r.data(), 3 * sizeof(double)) == 0;
}
[[nodiscard]] inline bool same_bits(const Quaternion<double>& l, const Quaternion<double>& r) {
  return same_bits(l.w, r.w) && same_bits(l.x, r.x) && same_bits(l.y, r.y) && same_bits(l.z, r.z);
}

struct SameShape {
  bool operator()(const Point<double>&, const Point<double>&) const { return true; }
  bool operator()(const Segment<double>& l, const Segment<double>& r) const {
    return same_bits(l.a, r.a) && same_bits(l.b, r.b);
  }
  bool operator()(const Triangle<double>& l, const Triangle<double>& r) const {
    return same_bits(l.a, r.a) && same_bits(l.b, r.b) && same_bits(l.c, r.c);
  }
  bool operator()(const Sphere<double>& l, const Sphere<double>& r) const {
    return same_bits(l.radius, r.radius);
  }
  bool operator()(const Capsule<double>& l, const Capsule<double>& r) const { return same_rod(l, r); }
  bool operator()(const Cylinder<double>& l, const Cylinder<double>& r) const { return same_rod(l, r); }
  bool operator()(const Cone<double>& l, const Cone<double>& r) const { return same_rod(l, r); }
  bool operator()(const Box<double>& l, const Box<double>& r) const {
    return same_bits(l.half_extents, r.half_extents);
  }
  bool operator()(const Ellipsoid<double>& l, const Ellipsoid<double>& r) const {
    return same_bits(l.radii, r.radii);
  }
  bool operator()(const Hull<double>& l, const Hull<double>& r) const {
    const auto graph = [](const Hull<double>& hull) {
      return hull.has_adjacency() ? &hull.graph() : nullptr;
    };
    return l.vertices().data() == r.vertices().data() && graph(l) == graph(r);
  }
  bool operator()(const Posed<double>& l, const Posed<double>& r) const {
    return l.shape == r.shape && same_bits(l.position, r.position) && same_bits(l.orientation, r.orientation);
  }
  bool operator()(const Rounded<double>& l, const Rounded<double>& r) const {
    return l.shape == r.shape && same_bits(l.radius, r.radius);
  }
  bool operator()(const Sum<double>& l, const Sum<double>& r) const { return l.shapes == r.shapes; }
  bool operator()(const HullOf<double>& l, const HullOf<double>& r) const { return l.shapes == r.shapes; }
  template <class L, class R>
  bool operator()(const L&, const R&) const {
    return false;
  }

 private:
  template <class Rod>
  static bool same_rod(const Rod& l, const Rod& r) {
    return same_bits(l.radius, r.radius) && same_bits(l.half_height, r.half_height);
  }
};

// For bodies at rest.
[[nodiscard]] inline bool is_same(const Body<double>& l, const Body<double>& r) {
  return same_bits(l.position, r.position) && same_bits(l.orientation, r.orientation) &&
         std::visit(SameShape{}, l.shape, r.shape);
}

}  // namespace graze::scene
