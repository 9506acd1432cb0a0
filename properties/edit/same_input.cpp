// Tests if two cases are one question. Laws call it for a known truth many times a case, so it allocates nothing.
#include <algorithm>
#include <cmath>

#include "properties/edit/case.hpp"

namespace graze::law {

namespace {

bool same(double l, double r) { return l == r || (std::isnan(l) && std::isnan(r)); }
bool same(const Vec3<double>& l, const Vec3<double>& r) {
  return same(l[0], r[0]) && same(l[1], r[1]) && same(l[2], r[2]);
}
bool same(const Quaternion<double>& l, const Quaternion<double>& r) {
  return same(l.w, r.w) && same(l.x, r.x) && same(l.y, r.y) && same(l.z, r.z);
}
bool same(const corpus::Spin& l, const corpus::Spin& r) {
  return same(l.rotation, r.rotation) && same(l.pivot, r.pivot);
}

bool same(const Shape<double>& l, const Shape<double>& r);
bool same(const SharedShape<double>& l, const SharedShape<double>& r) {
  return l == r || (l && r && same(l->shape, r->shape));
}

bool same(const Point<double>&, const Point<double>&) { return true; }
bool same(const Segment<double>& l, const Segment<double>& r) { return same(l.a, r.a) && same(l.b, r.b); }
bool same(const Triangle<double>& l, const Triangle<double>& r) {
  return same(l.a, r.a) && same(l.b, r.b) && same(l.c, r.c);
}
bool same(const Sphere<double>& l, const Sphere<double>& r) { return same(l.radius, r.radius); }
bool same(const Box<double>& l, const Box<double>& r) { return same(l.half_extents, r.half_extents); }
bool same(const Ellipsoid<double>& l, const Ellipsoid<double>& r) { return same(l.radii, r.radii); }
bool same(const Hull<double>& l, const Hull<double>& r) {
  return std::equal(l.vertices().begin(), l.vertices().end(), r.vertices().begin(), r.vertices().end(),
                    [](const Vec3<double>& x, const Vec3<double>& y) { return same(x, y); });
}
bool same(const Posed<double>& l, const Posed<double>& r) {
  return same(l.position, r.position) && same(l.orientation, r.orientation) && same(l.shape, r.shape);
}
bool same(const Rounded<double>& l, const Rounded<double>& r) {
  return same(l.radius, r.radius) && same(l.shape, r.shape);
}
// Capsule, cylinder, cone, and sum or hull of several.
template <class T>
bool same(const T& l, const T& r) {
  if constexpr (requires { l.half_height; }) {
    return same(l.radius, r.radius) && same(l.half_height, r.half_height);
  } else {
    return std::equal(l.shapes.begin(), l.shapes.end(), r.shapes.begin(), r.shapes.end(),
                      [](const SharedShape<double>& x, const SharedShape<double>& y) { return same(x, y); });
  }
}

bool same(const Shape<double>& l, const Shape<double>& r) {
  return l.index() == r.index() &&
         std::visit([&]<class T>(const T& one) { return same(one, std::get<T>(r)); }, l);
}

bool same(const Body<double>& l, const Body<double>& r) {
  return same(l.position, r.position) && same(l.displacement, r.displacement) &&
         same(l.orientation, r.orientation) && same(l.shape, r.shape);
}

}  // namespace

bool same_input(const corpus::Case& left, const corpus::Case& right) {
  return left.start_policy == right.start_policy && same(left.t_max, right.t_max) &&
         same(left.target_distance, right.target_distance) && same(left.a, right.a) &&
         same(left.b, right.b) && same(left.spin_a, right.spin_a) && same(left.spin_b, right.spin_b);
}

}  // namespace graze::law
