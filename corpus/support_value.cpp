#include "corpus/support_value.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/families/draw.hpp"

namespace graze::corpus {
namespace {

double dot(const Vec3<double>& l, const Vec3<double>& r) { return (l[0] * r[0] + l[1] * r[1]) + l[2] * r[2]; }
double norm(double x, double y, double z) { return std::sqrt((x * x + y * y) + z * z); }

double of_part(const SharedShape<double>& part, const Vec3<double>& n) {
  return part ? support_value(part->shape, n) : -kInfinity<double>;
}

// n.x over x = R y is (R^T n).y.
Vec3<double> into_frame(const Quaternion<double>& q, const Vec3<double>& n) {
  return q.is_identity() ? n : rotate({q.w, 0 - q.x, 0 - q.y, 0 - q.z}, n);
}

struct SupportValue {
  const Vec3<double>& n;

  double operator()(const Point<double>&) const { return 0; }
  double operator()(const Segment<double>& s) const { return std::max(dot(n, s.a), dot(n, s.b)); }
  double operator()(const Triangle<double>& t) const {
    return std::max({dot(n, t.a), dot(n, t.b), dot(n, t.c)});
  }
  double operator()(const Sphere<double>& s) const { return s.radius * norm(n[0], n[1], n[2]); }
  double operator()(const Capsule<double>& c) const {
    return std::abs(n[2]) * c.half_height + c.radius * norm(n[0], n[1], n[2]);
  }
  double operator()(const Box<double>& b) const { return dot(n.cwiseAbs(), b.half_extents); }
  double operator()(const Ellipsoid<double>& e) const {
    return norm(n[0] * e.radii[0], n[1] * e.radii[1], n[2] * e.radii[2]);
  }
  double operator()(const Cylinder<double>& c) const {
    return std::abs(n[2]) * c.half_height + c.radius * norm(n[0], n[1], 0);
  }
  double operator()(const Cone<double>& c) const {
    return std::max(n[2] * c.half_height, c.radius * norm(n[0], n[1], 0) - n[2] * c.half_height);
  }
  double operator()(const Hull<double>& h) const {
    double most = -kInfinity<double>;
    for (const Vec3<double>& x : h.vertices()) most = std::max(most, dot(n, x));
    return most;
  }
  double operator()(const Posed<double>& p) const {
    return dot(n, p.position) + of_part(p.shape, into_frame(p.orientation, n));
  }
  double operator()(const Rounded<double>& r) const {
    return of_part(r.shape, n) + r.radius * norm(n[0], n[1], n[2]);
  }
  double operator()(const Sum<double>& s) const {
    double total = s.shapes.empty() ? -kInfinity<double> : 0;
    for (const SharedShape<double>& part : s.shapes) total += of_part(part, n);
    return total;
  }
  double operator()(const HullOf<double>& h) const {
    double most = -kInfinity<double>;
    for (const SharedShape<double>& part : h.shapes) most = std::max(most, of_part(part, n));
    return most;
  }
};

}  // namespace

double support_value(const Shape<double>& shape, const Vec3<double>& n) {
  return std::visit(SupportValue{n}, shape);
}

Bounds bounds(const Shape<double>& shape, const Quaternion<double>& q) {
  Bounds box;
  for (int i = 0; i < 3; ++i) {
    Vec3<double> axis = Vec3<double>::Zero();
    axis[i] = 1;
    const Vec3<double> n = into_frame(q, axis);
    box.high[i] = support_value(shape, n);
    box.low[i] = 0 - support_value(shape, Vec3<double>(-n));
  }
  return box;
}

}  // namespace graze::corpus
