#include "reports/drawing/geometry.hpp"

#include <algorithm>
#include <numbers>

namespace graze::draw {
namespace {

constexpr std::size_t kMostVertices = 4096;

// x -> q x conj(q) / |q|^2.
Mat rotation_of(const Quaternion<double>& q) {
  const Real w = q.w;
  const Vec r(q.x, q.y, q.z);
  Mat cross;
  cross << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  const Real norm_sq = w * w + r.squaredNorm();
  return Mat::Identity() + (2 / norm_sq) * (w * cross + cross * cross);
}

Vec direction_of(const Vec& n) {
  const Real length = n.norm();
  return length > 0 ? Vec(n / length) : Vec(Vec::Zero());
}

struct SupportPoint {
  const Vec& n;

  [[nodiscard]] Vec farthest(std::span<const Vec3<double>> points) const {
    Vec best = Vec::Zero();
    Real most = -kUnbounded;
    for (const Vec3<double>& point : points) {
      const Real h = n.dot(wide(point));
      if (!(h > most)) continue;
      most = h;
      best = wide(point);
    }
    return best;
  }
  [[nodiscard]] Vec rim(Real radius, Real z) const {
    const Vec outward = direction_of(Vec(n[0], n[1], 0));
    return {radius * outward[0], radius * outward[1], z};
  }

  Vec operator()(const Point<double>&) const { return Vec::Zero(); }
  Vec operator()(const Segment<double>& s) const {
    const Vec3<double> ends[] = {s.a, s.b};
    return farthest(ends);
  }
  Vec operator()(const Triangle<double>& t) const {
    const Vec3<double> corners[] = {t.a, t.b, t.c};
    return farthest(corners);
  }
  Vec operator()(const Sphere<double>& s) const { return Real(s.radius) * direction_of(n); }
  Vec operator()(const Capsule<double>& c) const {
    return Real(c.radius) * direction_of(n) + Vec(0, 0, n[2] < 0 ? -c.half_height : c.half_height);
  }
  Vec operator()(const Box<double>& b) const {
    Vec out = wide(b.half_extents);
    for (int i = 0; i < 3; ++i) {
      if (n[i] < 0) out[i] = -out[i];
    }
    return out;
  }
  Vec operator()(const Ellipsoid<double>& e) const {
    const Vec radii = wide(e.radii), scaled = radii.cwiseProduct(n);
    return radii.cwiseProduct(direction_of(scaled));
  }
  Vec operator()(const Cylinder<double>& c) const {
    return rim(c.radius, n[2] < 0 ? -c.half_height : c.half_height);
  }
  Vec operator()(const Cone<double>& c) const {
    const Vec base = rim(c.radius, -c.half_height), apex(0, 0, c.half_height);
    return n.dot(base) > n.dot(apex) ? base : apex;
  }
  Vec operator()(const Hull<double>& h) const { return farthest(h.vertices()); }
  Vec operator()(const Posed<double>& p) const {
    const Mat rotation = rotation_of(p.orientation);
    return wide(p.position) + rotation * support_point(p.shape->shape, rotation.transpose() * n);
  }
  Vec operator()(const Rounded<double>& r) const {
    return support_point(r.shape->shape, n) + Real(r.radius) * direction_of(n);
  }
  Vec operator()(const Sum<double>& s) const {
    Vec total = Vec::Zero();
    for (const SharedShape<double>& part : s.shapes) total += support_point(part->shape, n);
    return total;
  }
  Vec operator()(const HullOf<double>& h) const {
    Vec best = Vec::Zero();
    Real most = -kUnbounded;
    for (const SharedShape<double>& part : h.shapes) {
      const Vec point = support_point(part->shape, n);
      if (!(n.dot(point) > most)) continue;
      most = n.dot(point);
      best = point;
    }
    return best;
  }
};

using Vertices = std::optional<std::vector<Vec>>;

struct PolytopeVertices {
  static Vertices of(std::span<const Vec3<double>> points) {
    if (points.size() > kMostVertices) return {};
    std::vector<Vec> out;
    out.reserve(points.size());
    for (const Vec3<double>& point : points) out.push_back(wide(point));
    return out;
  }

  Vertices operator()(const Point<double>&) const { return std::vector<Vec>{Vec::Zero()}; }
  Vertices operator()(const Segment<double>& s) const {
    const Vec3<double> ends[] = {s.a, s.b};
    return of(ends);
  }
  Vertices operator()(const Triangle<double>& t) const {
    const Vec3<double> corners[] = {t.a, t.b, t.c};
    return of(corners);
  }
  Vertices operator()(const Box<double>& b) const {
    std::vector<Vec> out;
    for (int k = 0; k < 8; ++k) {
      Vec corner = wide(b.half_extents);
      for (int i = 0; i < 3; ++i) {
        if ((k >> i & 1) == 0) corner[i] = -corner[i];
      }
      out.push_back(corner);
    }
    return out;
  }
  Vertices operator()(const Hull<double>& h) const { return of(h.vertices()); }
  Vertices operator()(const Posed<double>& p) const {
    Vertices out = polytope_vertices(p.shape->shape);
    if (!out) return {};
    const Mat rotation = rotation_of(p.orientation);
    for (Vec& point : *out) point = wide(p.position) + rotation * point;
    return out;
  }
  Vertices operator()(const Rounded<double>& r) const {
    return r.radius == 0 ? polytope_vertices(r.shape->shape) : Vertices();
  }
  Vertices operator()(const Sum<double>& s) const {
    std::vector<Vec> total = {Vec::Zero()};
    for (const SharedShape<double>& part : s.shapes) {
      const Vertices more = polytope_vertices(part->shape);
      if (!more || total.size() * more->size() > kMostVertices) return {};
      std::vector<Vec> sums;
      for (const Vec& x : total) {
        for (const Vec& y : *more) sums.push_back(x + y);
      }
      total = std::move(sums);
    }
    return total;
  }
  Vertices operator()(const HullOf<double>& h) const {
    std::vector<Vec> all;
    for (const SharedShape<double>& part : h.shapes) {
      const Vertices more = polytope_vertices(part->shape);
      if (!more || all.size() + more->size() > kMostVertices) return {};
      all.insert(all.end(), more->begin(), more->end());
    }
    return all;
  }
  template <class Curved>
  Vertices operator()(const Curved&) const {
    return {};
  }
};

Real cross(const Flat& l, const Flat& r) { return l[0] * r[1] - l[1] * r[0]; }

// Andrew's monotone chain (1979), anticlockwise.
std::vector<Flat> flat_hull(std::vector<Flat> points) {
  const auto less = [](const Flat& l, const Flat& r) { return l[0] != r[0] ? l[0] < r[0] : l[1] < r[1]; };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Flat> hull;
  const auto add = [&](const Flat& p, std::size_t keep) {
    while (hull.size() >= keep + 2 &&
           !(cross(hull.back() - hull[hull.size() - 2], p - hull[hull.size() - 2]) > 0))
      hull.pop_back();
    hull.push_back(p);
  };
  for (const Flat& p : points) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.pop_back();
  return hull;
}

// Samples the outline of a curved shape by its supports in the view's plane, finer where it bends.
class Tracer {
 public:
  Tracer(const Shape<double>& shape, const Pose& pose, const View& view, const Window& window, Real tolerance)
      : shape_(shape), pose_(pose), view_(view), window_(window), tolerance_(tolerance) {}

  std::vector<Flat> operator()() {
    constexpr int kFirst = 16;
    constexpr Real kTurn = 2 * std::numbers::pi_v<Real>;
    Sample from = at(0);
    for (int k = 1; k <= kFirst; ++k) {
      const Sample to = at(kTurn * k / kFirst);
      refine(from, to, 0);
      from = to;
    }
    return flat_hull(std::move(points_));
  }

 private:
  struct Sample {
    Real angle;
    Flat normal, point;
  };

  [[nodiscard]] Sample at(Real angle) const {
    const Flat normal(std::cos(angle), std::sin(angle));
    const Vec n = normal[0] * view_.right + normal[1] * view_.up;
    const Vec local = support_point(shape_, pose_.rotation.transpose() * n);
    return {angle, normal, view_.project(pose_.position + pose_.rotation * local)};
  }
  // Between the two points the outline stays in the triangle of them and where their tangents meet.
  void refine(const Sample& from, const Sample& to, int depth) {
    constexpr int kDeepest = 48;
    const Flat chord = to.point - from.point;
    const Real length = chord.norm();
    if (depth < kDeepest && length > tolerance_) {
      // The tangents' corner is off the chord by this much.
      const Real a = std::abs(from.normal.dot(chord)), b = std::abs(to.normal.dot(chord));
      const Real turn = std::abs(cross(from.normal, to.normal));
      const Real off = a * b / (turn * length);
      const Flat corner = from.point + Flat(-from.normal[1], from.normal[0]) * (b / turn);
      if (!(off <= tolerance_) && meets_window(from.point, to.point, corner)) {
        const Sample middle = at((from.angle + to.angle) / 2);
        refine(from, middle, depth + 1);
        refine(middle, to, depth + 1);
        return;
      }
    }
    points_.push_back(to.point);
  }
  [[nodiscard]] bool meets_window(const Flat& a, const Flat& b, const Flat& c) const {
    const Flat half(window_.half_width, window_.half_height);
    for (int i = 0; i < 2; ++i) {
      const Real low = std::min({a[i], b[i], c[i]}), high = std::max({a[i], b[i], c[i]});
      if (low > window_.middle[i] + half[i] || high < window_.middle[i] - half[i]) return false;
    }
    return true;
  }

  const Shape<double>& shape_;
  const Pose& pose_;
  const View& view_;
  const Window& window_;
  Real tolerance_;
  std::vector<Flat> points_;
};

// f >= 0 is kept.
std::vector<Flat> keep_half(const std::vector<Flat>& polygon, const auto& f) {
  std::vector<Flat> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Flat &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Real fp = f(p), fq = f(q);
    if (fp >= 0) out.push_back(p);
    if ((fp < 0) != (fq < 0)) out.push_back(p + (q - p) * (fp / (fp - fq)));
  }
  return out;
}

}  // namespace

Mat turn_by(const Vec& w) {
  const Real angle = w.norm();
  if (!(angle > 0)) return Mat::Identity();
  const Vec axis = w / angle;
  Mat k;
  k << 0, -axis[2], axis[1], axis[2], 0, -axis[0], -axis[1], axis[0], 0;
  const Real half_sine = std::sin(angle / 2);
  return Mat::Identity() + std::sin(angle) * k + (2 * half_sine * half_sine) * (k * k);
}

Pose pose_at(const Body<double>& body, const corpus::Spin& spin, Real t, const Vec& origin) {
  const Mat placed = rotation_of(body.orientation);
  const Mat turned = turn_by(t * wide(spin.rotation));
  // c, of which `arm` is seen from the body's origin.
  const Vec arm = placed * wide(spin.pivot);
  const Vec moved = t == 0 ? Vec(Vec::Zero()) : Vec(t * wide(body.displacement));
  return {.rotation = turned * placed,
          .position = ((wide(body.position) - origin) + moved) + (arm - turned * arm)};
}

Vec support_point(const Shape<double>& shape, const Vec& n) { return std::visit(SupportPoint{n}, shape); }

Real height(const Shape<double>& shape, const Pose& pose, const Vec& n) {
  return n.dot(pose.position) + n.dot(pose.rotation * support_point(shape, pose.rotation.transpose() * n));
}

Extent extent(const Shape<double>& shape) {
  Vec low, high;
  for (int i = 0; i < 3; ++i) {
    high[i] = support_point(shape, Vec::Unit(i))[i];
    low[i] = support_point(shape, -Vec::Unit(i))[i];
  }
  return {.middle = (low + high) / 2, .diagonal = (high - low).norm()};
}

std::optional<std::vector<Vec>> polytope_vertices(const Shape<double>& shape) {
  return std::visit(PolytopeVertices{}, shape);
}

std::vector<Flat> outline(const Shape<double>& shape, const Pose& pose, const View& view,
                          const Window& window, Real tolerance) {
  const std::optional<std::vector<Vec>> vertices = polytope_vertices(shape);
  if (!vertices) return Tracer(shape, pose, view, window, tolerance)();
  std::vector<Flat> points;
  points.reserve(vertices->size());
  for (const Vec& x : *vertices) points.push_back(view.project(pose.position + pose.rotation * x));
  return flat_hull(std::move(points));
}

std::vector<Flat> clip_polygon(std::vector<Flat> polygon, const Window& window) {
  const Flat half(window.half_width, window.half_height);
  if (polygon.size() == 1) {
    const Flat off = (polygon[0] - window.middle).cwiseAbs() - half;
    return off.maxCoeff() <= 0 ? polygon : std::vector<Flat>();
  }
  for (int i = 0; i < 2; ++i) {
    for (const Real side : {Real(1), Real(-1)}) {
      polygon = keep_half(polygon, [&](const Flat& p) { return half[i] - side * (p[i] - window.middle[i]); });
    }
  }
  return polygon;
}

std::optional<std::pair<Flat, Flat>> clip_segment(Flat from, Flat to, const Window& window) {
  const Flat half(window.half_width, window.half_height);
  for (int i = 0; i < 2; ++i) {
    for (const Real side : {Real(1), Real(-1)}) {
      const Real f = half[i] - side * (from[i] - window.middle[i]);
      const Real g = half[i] - side * (to[i] - window.middle[i]);
      if (f < 0 && g < 0) return {};
      if (f < 0) from += (to - from) * (f / (f - g));
      if (g < 0) to = from + (to - from) * (f / (f - g));
    }
  }
  return std::pair{from, to};
}

}  // namespace graze::draw
