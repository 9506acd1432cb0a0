// Decides, brackets: nothing. The balls test the axis that it finds.
// Costs: 1 to 4 microseconds for boxes and small hulls, up to 15 for two curved shapes.
// Cannot be trusted: near contact, where a direction in double is worth little.
#include <Eigen/Geometry>

#include "oracles/curved/axis_guess.hpp"

namespace graze::oracle {
namespace {

using Vec = Vec3<double>;

struct Farthest {
  const Vec& d;

  static Vec along(const Vec& d, double radius) {
    const double length = d.norm();
    return length > 0 ? Vec(radius / length * d) : Vec::Zero();
  }
  [[nodiscard]] Vec among(std::span<const Vec> vertices) const {
    Vec best = Vec::Zero();
    double most = -kInfinity<double>;
    for (const Vec& x : vertices) {
      const double value = d.dot(x);
      if (value > most) {
        most = value;
        best = x;
      }
    }
    return best;
  }
  [[nodiscard]] Vec disk(double radius, double height) const {
    Vec x = along({d[0], d[1], 0}, radius);
    x[2] = height;
    return x;
  }
  [[nodiscard]] Vec of(const SharedShape<double>& part) const { return std::visit(*this, part->shape); }

  Vec operator()(const Point<double>&) const { return Vec::Zero(); }
  Vec operator()(const Segment<double>& s) const { return among(std::array{s.a, s.b}); }
  Vec operator()(const Triangle<double>& s) const { return among(std::array{s.a, s.b, s.c}); }
  Vec operator()(const Sphere<double>& s) const { return along(d, s.radius); }
  Vec operator()(const Capsule<double>& s) const {
    return along(d, s.radius) + Vec(0, 0, std::copysign(s.half_height, d[2]));
  }
  Vec operator()(const Box<double>& s) const {
    Vec x;
    for (int i = 0; i < 3; ++i) x[i] = std::copysign(s.half_extents[i], d[i]);
    return x;
  }
  Vec operator()(const Ellipsoid<double>& s) const {
    return s.radii.cwiseProduct(along(s.radii.cwiseProduct(d), 1));
  }
  Vec operator()(const Cylinder<double>& s) const {
    return disk(s.radius, std::copysign(s.half_height, d[2]));
  }
  Vec operator()(const Cone<double>& s) const {
    const Vec base = disk(s.radius, -s.half_height), apex(0, 0, s.half_height);
    return d.dot(apex) > d.dot(base) ? apex : base;
  }
  Vec operator()(const Hull<double>& s) const { return among(s.vertices()); }
  Vec operator()(const Posed<double>& s) const {
    const Quaternion<double>& q = s.orientation;
    const Mat3<double> turn = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
    const Vec inner = turn.transpose() * d;
    return turn * Farthest{inner}.of(s.shape) + s.position;
  }
  Vec operator()(const Rounded<double>& s) const { return of(s.shape) + along(d, s.radius); }
  Vec operator()(const Sum<double>& s) const {
    Vec x = Vec::Zero();
    for (const SharedShape<double>& part : s.shapes) x += of(part);
    return x;
  }
  Vec operator()(const HullOf<double>& s) const {
    std::vector<Vec> ends;
    for (const SharedShape<double>& part : s.shapes) ends.push_back(of(part));
    return among(ends);
  }
};

// Up to four points, and the nearest point to the origin of their hull.
struct Simplex {
  std::array<Vec, 4> y;
  unsigned size = 0;

  // The affine hull's nearest point, if it lies strictly inside the hull of the points in `mask`.
  [[nodiscard]] std::optional<Vec> inside(unsigned mask) const {
    std::array<Vec, 4> p;
    p.fill(Vec::Zero());
    int k = 0;
    for (unsigned i = 0; i < size; ++i) {
      if (mask >> i & 1u) p[static_cast<std::size_t>(k++)] = y[i];
    }
    if (k == 1) return p[0];
    const Vec d = p[1] - p[0];
    if (k == 2) {
      const double t = -p[0].dot(d) / d.squaredNorm();
      if (!(t > 0 && t < 1)) return {};
      return Vec(p[0] + t * d);
    }
    const Vec e = p[2] - p[0], normal = d.cross(e);
    if (k == 3) {
      const double area = normal.squaredNorm();
      const double s = normal.dot(e.cross(p[0])) / area, t = normal.dot(p[0].cross(d)) / area;
      if (!(s > 0 && t > 0 && s + t < 1)) return {};
      return Vec(normal.dot(p[0]) / area * normal);
    }
    const Vec f = p[3] - p[0];
    const double volume = normal.dot(f);
    const double s = -p[0].dot(e.cross(f)) / volume, t = -p[0].dot(f.cross(d)) / volume;
    const double u = -p[0].dot(normal) / volume;
    if (!(s > 0 && t > 0 && u > 0 && s + t + u < 1)) return {};
    return Vec(Vec::Zero());
  }

  // Keeps the points that carry the nearest one.
  Vec reduce() {
    unsigned best = 1;
    Vec nearest = y[0];
    for (unsigned mask = 2; mask < 1u << size; ++mask) {
      const std::optional<Vec> x = inside(mask);
      if (x && x->squaredNorm() < nearest.squaredNorm()) {
        nearest = *x;
        best = mask;
      }
    }
    unsigned kept = 0;
    for (unsigned i = 0; i < size; ++i) {
      if (best >> i & 1u) y[kept++] = y[i];
    }
    size = kept;
    return nearest;
  }
};

}  // namespace

// Gilbert's descent on A - B: the nearest point of the hull of the points found so far gives the next axis.
AxisGuess guess_axis(const PlacedShapes& pair, const Vec3<double>& start) {
  constexpr int kMostSteps = 40;
  const double to_one = std::ldexp(1.0, -pair.exponent);
  AxisGuess best;
  double shown = 0;
  Simplex simplex;
  Vec n = start.normalized();
  for (int step = 0; step < kMostSteps; ++step) {
    const Vec in_a = pair.turn_a.transpose() * n, in_b = pair.turn_b.transpose() * -n;
    const Vec from_a = pair.turn_a * std::visit(Farthest{in_a}, pair.a);
    const Vec from_b = pair.turn_b * std::visit(Farthest{in_b}, pair.b);
    const Vec w = to_one * ((from_a - from_b) - pair.between + pair.rounding * n);
    if (!(w.squaredNorm() < kInfinity<double>)) return {};
    const double separation = -n.dot(w);
    if (separation > shown) {
      shown = separation;
      best.apart = true;
      best.axis = n;
    }
    simplex.y[simplex.size++] = w;
    const Vec x = simplex.reduce();
    const double distance = x.norm();
    best.upper = std::ldexp(distance, pair.exponent);
    if (shown >= 0.875 * distance || simplex.size == 4 || !(distance > 0x1p-50)) break;
    n = -x / distance;
  }
  return best;
}

}  // namespace graze::oracle
