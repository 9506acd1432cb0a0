// Symbolic axes for the tests and the benchmark of the proof checker, with their values in rationals: made by
// hand, drawn, and found as the facet of C through which the path enters.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "tests/oracles/checker/shape_cases.hpp"

namespace graze::test {

inline AxisFactor given(const Vec3<double>& x) {
  AxisFactor factor;
  factor.given = x;
  return factor;
}
inline AxisFactor motion() {
  AxisFactor factor;
  factor.kind = AxisFactor::Kind::motion;
  return factor;
}
inline AxisFactor difference(const SupportPair& from, const SupportPair& to) {
  AxisFactor factor;
  factor.kind = AxisFactor::Kind::difference;
  factor.from = from;
  factor.to = to;
  return factor;
}
inline SupportPair vertices(std::size_t a, std::size_t b) {
  SupportPair pair;
  pair.a.vertex = static_cast<std::uint32_t>(a);
  pair.b.vertex = static_cast<std::uint32_t>(b);
  return pair;
}
// a_to - a_from, and -(b_to - b_from).
inline AxisFactor edge_of_a(std::size_t from, std::size_t to) {
  return difference(vertices(from, 0), vertices(to, 0));
}
inline AxisFactor edge_of_b(std::size_t from, std::size_t to) {
  return difference(vertices(0, from), vertices(0, to));
}

inline Proof lower_proof(double toi, const AxisFactor& first, const AxisFactor& second, int axis_sign = 1) {
  Proof proof;
  proof.toi_lower = toi;
  proof.has_axis = true;
  proof.symbolic = true;
  proof.axis_sign = axis_sign;
  proof.factor = {first, second};
  return proof;
}
inline Proof flipped(Proof proof) {
  proof.axis_sign = -proof.axis_sign;
  return proof;
}
inline Proof claiming(Proof proof, double toi) {
  proof.toi_lower = toi;
  return proof;
}

// The cross product of the factors in rationals, with its sign.
inline RationalVec axis_in_rationals(const corpus::Case& c, const Proof& proof) {
  const auto named_a = named_vertices(c.a.shape), named_b = named_vertices(c.b.shape);
  const auto value = [&](const AxisFactor& factor) -> RationalVec {
    const auto point = [&](const SupportPair& s) {
      return world_point(c.a, named_a, s.a) - world_point(c.b, named_b, s.b);
    };
    switch (factor.kind) {
      case AxisFactor::Kind::given:
        return rational(factor.given);
      case AxisFactor::Kind::motion:
        return rational(c.b.displacement) - rational(c.a.displacement);
      case AxisFactor::Kind::difference:
        break;
    }
    return point(factor.to) - point(factor.from);
  };
  return Rational(proof.axis_sign) * outer(value(proof.factor[0]), value(proof.factor[1]));
}

// One factor of each kind, its features anywhere on the shapes.
inline AxisFactor draw_factor(Draw& draw, const std::vector<NamedVertex>& of_a,
                              const std::vector<NamedVertex>& of_b) {
  switch (draw.random.below(8)) {
    case 0:
      return given(draw.vector(Numbers::doubles, 2));
    case 1:
      return motion();
    default:
      break;
  }
  SupportPair from, to;
  from.a = draw_feature(draw, of_a);
  from.b = draw_feature(draw, of_b);
  to.a = draw_feature(draw, of_a);
  to.b = draw_feature(draw, of_b);
  const std::uint64_t moving = draw.random.below(3);
  if (moving == 0) to.a = from.a;
  if (moving == 1) to.b = from.b;
  return difference(from, to);
}

// A cross product of two factors. It points from A to B within the rounding of doubles.
inline Proof draw_symbolic(Draw& draw, const corpus::Case& c) {
  const auto of_a = named_vertices(c.a.shape), of_b = named_vertices(c.b.shape);
  const AxisFactor first = draw_factor(draw, of_a, of_b), second = draw_factor(draw, of_a, of_b);
  Proof proof = lower_proof(0, first, second);
  const RationalVec n = axis_in_rationals(c, proof);
  const Vec3<double> rounded(n[0].get_d(), n[1].get_d(), n[2].get_d());
  return rounded.dot(c.b.position - c.a.position) < 0 ? flipped(proof) : proof;
}

// The axis of the facet of C = A - B through which t v, or its line, enters C. Among all cross products of
// edges that support C to rounding, it is the one of the latest h(n) / (n.v). For polytopes with facets of
// their own, by brute force, in double.
class EnteringFacet {
 public:
  explicit EnteringFacet(const corpus::Case& c)
      : a_(world(c.a)), b_(world(c.b)), v_(c.b.displacement - c.a.displacement) {
    const auto edges_a =
        facets(a_, [this](const Vec3<double>& n, std::size_t i, std::size_t j, std::size_t k) {
          consider(n, [=] { return lower_proof(0, edge_of_a(i, j), edge_of_a(i, k)); });
        });
    const auto edges_b =
        facets(b_, [this](const Vec3<double>& n, std::size_t i, std::size_t j, std::size_t k) {
          consider(n, [=] { return lower_proof(0, edge_of_b(i, j), edge_of_b(i, k)); });
        });
    for (const auto& [i, j] : edges_a)
      for (const auto& [k, l] : edges_b)
        // edge_of_b is the negated edge.
        consider((a_[j] - a_[i]).cross(b_[k] - b_[l]),
                 [i = i, j = j, k = k, l = l] { return lower_proof(0, edge_of_a(i, j), edge_of_b(k, l)); });
  }
  // Claims nothing yet.
  [[nodiscard]] const std::optional<Proof>& proof() const { return best_; }

 private:
  using Points = std::vector<Vec3<double>>;
  using Edges = std::vector<std::pair<std::size_t, std::size_t>>;
  static constexpr double kSlack = 1e-10;  // length, of shapes some 4 across

  static Points world(const Body<double>& body) {
    Points points;
    for (const NamedVertex& v : named_vertices(body.shape)) {
      const RationalVec x = moved(v, body.orientation, body.position).fixed;
      points.emplace_back(x[0].get_d(), x[1].get_d(), x[2].get_d());
    }
    return points;
  }
  static double reach(const Points& points, const Vec3<double>& n) {
    double far = -kInfinity<double>;
    for (const Vec3<double>& x : points) far = std::max(far, n.dot(x));
    return far;
  }

  // Visits the triples that lie in facets, and returns their edges.
  template <class Visit>
  static Edges facets(const Points& x, const Visit& visit) {
    std::vector<std::vector<bool>> found(x.size(), std::vector<bool>(x.size(), false));
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = i + 1; j < x.size(); ++j)
        for (std::size_t k = j + 1; k < x.size(); ++k) {
          const Vec3<double> n = (x[j] - x[i]).cross(x[k] - x[i]);
          const double slack = kSlack * n.norm(), at = n.dot(x[i]);
          const bool above = reach(x, n) > at + slack, below = reach(x, -n) > slack - at;
          if (slack == 0 || (above && below)) continue;
          found[i][j] = found[i][k] = found[j][k] = true;
          visit(n, i, j, k);
        }
    Edges edges;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = i + 1; j < x.size(); ++j)
        if (found[i][j]) edges.emplace_back(i, j);
    return edges;
  }

  // h(n) is that of C whatever the edges, so an n that supports no facet proves less and is not the best.
  template <class Make>
  void consider(const Vec3<double>& m, const Make& make) {
    const double slope = m.dot(v_);
    if (!(std::abs(slope) > kSlack * m.norm())) return;
    const Vec3<double> n = slope < 0 ? m : Vec3<double>(-m);
    const double t = (reach(a_, n) + reach(b_, -n)) / -std::abs(slope);
    if (!(t > latest_)) return;
    latest_ = t;
    best_ = slope < 0 ? make() : flipped(make());
  }

  Points a_, b_;
  Vec3<double> v_;
  double latest_ = -kInfinity<double>;
  std::optional<Proof> best_;
};

inline std::optional<Proof> entering_facet(const corpus::Case& c) { return EnteringFacet(c).proof(); }

}  // namespace graze::test
