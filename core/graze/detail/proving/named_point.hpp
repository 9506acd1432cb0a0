// Computes points of C = A - B that have an exact name (proof.hpp), and their positions beyond all rounding.
//
//   w = (p_A + R_A x_A + o_A) - (p_B + R_B x_B + o_B) + o_m,
// Here x is a vertex or a curved part's point, o_A and o_B are offsets within the radii, and o_m is an offset within
// the target distance. All are doubles, so that w is exactly one point of C. It is a support point along n, except
// that the points of curved parts and the offsets are moved inwards by a few u (tree.hpp). Hence
//   n.w >= h(n) - 32 u extent |n|   or so. Only the accuracy of a portal depends on it, no guarantee.
//
// Positions are evaluated in sums of two doubles, and exactly if that leaves a sign open. The difference of the
// positions is exact. tree.hpp bounds the error of the trees: all within 2^-95 nodes (|p_A - p_B| + lengths). Units:
// internal, as in cso.hpp.
#pragma once

#include <graze/detail/numeric/vectors.hpp>
#include <graze/detail/proving/prove.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// x of the part in its own frame, exactly, by its name. `curved` walks along the feature's curved points.
template <Scalar S>
exact::Exact exact_point(const Shape<S>& shape, std::uint32_t vertex, const Vec3<double>*& curved) {
  using exact::Exact;
  const auto of_curved = [&] { return Exact::of(*curved++); };
  return std::visit(
      Overloaded{[&](const Ellipsoid<S>&) { return of_curved(); },
                 [&](const Cylinder<S>&) { return of_curved(); }, [&](const Cone<S>&) { return of_curved(); },
                 [&](const Posed<S>& s) {
                   Exact x = exact_point<S>(s.shape->shape, vertex, curved);
                   if (!s.orientation.is_identity()) exact::ExactTurn{as_double(s.orientation)}(x);
                   x.add(Exact::of(wide(s.position)), false);
                   return x;
                 },
                 [&](const Rounded<S>& s) { return exact_point<S>(s.shape->shape, vertex, curved); },
                 [&](const Sum<S>& s) {
                   Exact total;
                   std::uint64_t stride = count_of_sum<S>(s.shapes);
                   for (const auto& part : s.shapes) {
                     stride /= vertex_count<S>(part->shape);
                     const auto own = static_cast<std::uint32_t>(vertex / stride);
                     vertex = static_cast<std::uint32_t>(vertex % stride);
                     total.add(exact_point<S>(part->shape, own, curved), false);
                   }
                   return total;
                 },
                 [&](const HullOf<S>& s) {
                   for (const auto& part : s.shapes) {
                     const std::uint64_t count = vertex_count<S>(part->shape);
                     if (vertex < count) return exact_point<S>(part->shape, vertex, curved);
                     vertex -= static_cast<std::uint32_t>(count);
                   }
                   return Exact{};
                 },
                 [&](const auto&) {
                   Body<S> leaf;
                   leaf.shape = shape;
                   return Exact::of(exact::given_vertex(leaf, vertex));
                 }},
      shape);
}
template <Scalar S>
exact::Exact exact_point(const Body<S>& body, const Feature& feature) {
  const Vec3<double>* curved = feature.curved.data();
  exact::Exact x = exact_point<S>(body.shape, feature.vertex, curved);
  if (!body.orientation.is_identity()) exact::ExactTurn{as_double(body.orientation)}(x);
  x.add(exact::Exact::of(wide(body.position)), false);
  x.add(exact::Exact::of(feature.offset), false);
  return x;
}

// A point of C with its name. `named` is false if the name would need more than kCurvedParts curved parts: the point
// is one of C all the same.
struct NamedPoint {
  TwoDoubles3 w;  // of C, internal units, about 0
  Vec3<double> on_a = Vec3<double>::Zero(),
               on_b = Vec3<double>::Zero();  // points of A and B, world, at t = 0, rounded
  SupportPair name;
  Vec3<double> target = Vec3<double>::Zero();  // o_m
  bool named = true;
};

template <Scalar S>
class NamedPoints {
 public:
  NamedPoints(const ProofContext<S>& context, Counters& counters)
      : c_(context), counters_(counters), unit_(power_of_two(-context.cso.length_exponent())) {
    const double apart = norm_1(wide(context.b.position) - wide(context.a.position));
    const double lengths = apart + lengths_of(context.a.shape) + lengths_of(context.b.shape) + context.radius;
    error_ = kTwoDoublesOfANode * (nodes_of(context.a.shape) + nodes_of(context.b.shape)) * unit_ * lengths;
    target_ = context.cso.to_length(context.cso.target());
  }

  // w times a positive weight, world length. For a point that is named.
  [[nodiscard]] exact::Dyadic3 exactly(const NamedPoint& p) const {
    ++counters_.exact_decisions;
    exact::Exact w = exact_point(c_.a, p.name.a);
    w.add(exact_point(c_.b, p.name.b), true);
    w.add(exact::Exact::of(p.target), false);
    return w.x;
  }
  // Error bound of every coordinate of w.
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] const ProofContext<S>& context() const { return c_; }

  // Along n, world axes, of any length but 0. `drawn`: the distance by which the point is moved inwards beyond the
  // allowance for rounding, as a fraction. The point is still one of C, and near the support point.
  [[nodiscard]] NamedPoint along(const Vec3<double>& n, double drawn = 0) const {
    const Vec3<double> e = unit(n);
    ++counters_.supports;
    return named(c_.cso.support(e), e, drawn);
  }
  // The point that a search found along p.n or, if C's core is a polytope, along any direction. e is the direction of
  // the balls.
  [[nodiscard]] NamedPoint named(const CsoPoint<double>& p, const Vec3<double>& e, double drawn = 0) const {
    NamedPoint out;
    const Part a = part(c_.a, c_.cso.side_a(), p.vertex_a, e, c_.radius_a, drawn, out.name.a);
    const Part b = part(c_.b, c_.cso.side_b(), p.vertex_b, Vec3<double>(-e), c_.radius_b, drawn, out.name.b);
    out.named = a.named && b.named;
    out.on_a = rounded_once(a.x);
    out.on_b = rounded_once(b.x);
    // Positions first: their common part cancels exactly.
    TwoDoubles3 w = a.turned + -b.turned;
    const Vec3<double>& o_m = out.target = e * (target_ * (1 - kInsideTree * kUnitRoundoff<double> - drawn));
    for (int i = 0; i < 3; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      w[k] = two_sum(double(c_.a.position[i]), -double(c_.b.position[i])) + w[k];
      w[k] = w[k] + (two_sum(out.name.a.offset[i], -out.name.b.offset[i]) + TwoDoubles{o_m[i], 0});
    }
    out.w = scaled_by(w, unit_);
    return out;
  }

 private:
  struct Part {
    TwoDoubles3 turned, x;  // R x, and p + R x + o
    bool named;
  };
  static Part part(const Body<S>& body, const Side<double>& side, std::uint32_t vertex, const Vec3<double>& e,
                   double radius, double drawn, Feature& feature) {
    feature = {};
    feature.vertex = vertex;
    TreeWalk<S> walk(unit(side.to_own(e)), &feature, drawn);
    const TreePoint p = walk(body.shape, Placement{Turning::accurate}, &vertex);
    const double excess = side.curved ? p.excess.hi : 0.0;
    feature.offset = e * ((radius + excess) * (1 - inside_slack(body) - drawn));
    const Quaternion<double> q = as_double(body.orientation);
    Part out;
    out.turned = detail::exactly(p.x);
    if (!q.is_identity()) {
      out.turned = rotate_accurately(q, p.x);
      if (p.lo != Vec3<double>::Zero()) out.turned = out.turned + rotate_accurately(q, p.lo);
    } else {
      out.turned = out.turned + detail::exactly(p.lo);
    }
    out.x = detail::exactly(wide(body.position)) + (out.turned + detail::exactly(feature.offset));
    out.named = walk.curved_parts() <= kCurvedParts;
    return out;
  }

  const ProofContext<S>& c_;
  Counters& counters_;
  double unit_, error_ = 0, target_ = 0;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
