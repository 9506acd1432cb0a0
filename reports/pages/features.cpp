#include "reports/pages/features.hpp"

#include <Eigen/Geometry>

namespace graze::show {
namespace {

using draw::Pose;
using draw::Real;
using draw::Vec;

// How many vertices the core of a shape has (core/graze/shape.hpp).
struct VertexCount {
  std::uint64_t operator()(const Segment<double>&) const { return 2; }
  std::uint64_t operator()(const Triangle<double>&) const { return 3; }
  std::uint64_t operator()(const Capsule<double>&) const { return 2; }
  std::uint64_t operator()(const Box<double>&) const { return 8; }
  std::uint64_t operator()(const Hull<double>& hull) const { return hull.size(); }
  std::uint64_t operator()(const Posed<double>& posed) const { return std::visit(*this, posed.shape->shape); }
  std::uint64_t operator()(const Rounded<double>& rounded) const {
    return std::visit(*this, rounded.shape->shape);
  }
  std::uint64_t operator()(const Sum<double>& sum) const {
    std::uint64_t product = 1;
    for (const SharedShape<double>& part : sum.shapes) product *= std::visit(*this, part->shape);
    return product;
  }
  std::uint64_t operator()(const HullOf<double>& hull) const {
    std::uint64_t total = 0;
    for (const SharedShape<double>& part : hull.shapes) total += std::visit(*this, part->shape);
    return total;
  }
  template <class One>
  std::uint64_t operator()(const One&) const {
    return 1;
  }
};

std::uint64_t count(const Shape<double>& shape) { return std::visit(VertexCount(), shape); }

class Place {
 public:
  explicit Place(const Feature& feature) : feature_(feature) {}

  Vec at(const Shape<double>& shape, std::uint64_t vertex) {
    return std::visit([&](const auto& one) { return of(one, vertex); }, shape);
  }

 private:
  Vec curved() {
    return next_ < kCurvedParts ? Vec(feature_.curved[next_++].cast<Real>()) : Vec(Vec::Zero());
  }
  Vec of(const Point<double>&, std::uint64_t) { return Vec::Zero(); }
  Vec of(const Sphere<double>&, std::uint64_t) { return Vec::Zero(); }
  Vec of(const Segment<double>& s, std::uint64_t k) { return (k == 0 ? s.a : s.b).cast<Real>(); }
  Vec of(const Triangle<double>& t, std::uint64_t k) {
    return (k == 0 ? t.a : k == 1 ? t.b : t.c).cast<Real>();
  }
  Vec of(const Capsule<double>& c, std::uint64_t k) {
    return {0, 0, k == 0 ? -Real(c.half_height) : Real(c.half_height)};
  }
  Vec of(const Box<double>& b, std::uint64_t k) {
    Vec x = b.half_extents.cast<Real>();
    for (int i = 0; i < 3; ++i) {
      if ((k >> i & 1) == 0) x[i] = -x[i];
    }
    return x;
  }
  Vec of(const Ellipsoid<double>&, std::uint64_t) { return curved(); }
  Vec of(const Cylinder<double>&, std::uint64_t) { return curved(); }
  Vec of(const Cone<double>&, std::uint64_t) { return curved(); }
  Vec of(const Hull<double>& h, std::uint64_t k) {
    return k < h.size() ? Vec(h.vertex(k).cast<Real>()) : Vec(Vec::Zero());
  }
  Vec of(const Posed<double>& p, std::uint64_t k) {
    Body<double> part;
    part.position = p.position;
    part.orientation = p.orientation;
    const Pose pose = draw::pose_at(part, {}, 0, Vec::Zero());
    return pose.position + pose.rotation * at(p.shape->shape, k);
  }
  Vec of(const Rounded<double>& r, std::uint64_t k) { return at(r.shape->shape, k); }
  Vec of(const Sum<double>& s, std::uint64_t k) {
    std::uint64_t rest = count(s);
    Vec total = Vec::Zero();
    for (const SharedShape<double>& part : s.shapes) {
      rest /= count(part->shape);
      total += at(part->shape, k / rest);
      k %= rest;
    }
    return total;
  }
  Vec of(const HullOf<double>& h, std::uint64_t k) {
    for (const SharedShape<double>& part : h.shapes) {
      const std::uint64_t here = count(part->shape);
      if (k < here) return at(part->shape, k);
      k -= here;
    }
    return Vec::Zero();
  }
  static std::uint64_t count(const Shape<double>& shape) { return show::count(shape); }
  template <class S>
  static std::uint64_t count(const S& shape) {
    return VertexCount()(shape);
  }

  const Feature& feature_;
  std::size_t next_ = 0;
};

}  // namespace

Vec feature_point(const Shape<double>& shape, const Feature& feature) {
  return Place(feature).at(shape, feature.vertex);
}

Vec difference_of(const SupportPair& pair, const Shape<double>& a, const Pose& at_a, const Shape<double>& b,
                  const Pose& at_b) {
  return at_a.rotation * feature_point(a, pair.a) - at_b.rotation * feature_point(b, pair.b) +
         (at_a.position - at_b.position) + (pair.a.offset.cast<Real>() - pair.b.offset.cast<Real>());
}

Vec axis_of(const Proof& proof, const Shape<double>& a, const Pose& at_a, const Shape<double>& b,
            const Pose& at_b, const Vec& velocity) {
  if (!proof.has_axis) return Vec::Zero();
  Vec axis = proof.axis.cast<Real>();
  if (proof.symbolic && proof.nearest.size > 0) {
    // z less its part along each direction, which are made orthogonal first.
    const NearestAxis& nearest = proof.nearest;
    const Vec first = difference_of(nearest.pair[0], a, at_a, b, at_b);
    std::vector<Vec> directions;
    if (nearest.motion) directions.push_back(velocity);
    for (std::size_t i = 1; i < static_cast<std::size_t>(nearest.size); ++i)
      directions.push_back(difference_of(nearest.pair[i], a, at_a, b, at_b) - first);
    axis = Real(nearest.time) * velocity - first;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vec e = directions[i].stableNormalized();
      axis -= axis.dot(e) * e;
      for (std::size_t j = i + 1; j < directions.size(); ++j) directions[j] -= directions[j].dot(e) * e;
    }
  } else if (proof.symbolic) {
    std::array<Vec, 2> factor;
    for (std::size_t i = 0; i < 2; ++i) {
      const AxisFactor& one = proof.factor[i];
      factor[i] =
          one.kind == AxisFactor::Kind::given ? Vec(one.given.cast<Real>())
          : one.kind == AxisFactor::Kind::motion
              ? velocity
              : Vec(difference_of(one.to, a, at_a, b, at_b) - difference_of(one.from, a, at_a, b, at_b));
    }
    axis = Real(proof.axis_sign) * factor[0].cross(factor[1]);
  }
  const Real length = axis.norm();
  return length > 0 ? Vec(axis / length) : Vec(Vec::Zero());
}

}  // namespace graze::show
