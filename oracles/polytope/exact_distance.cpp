// Decides: the squared distance of a point, and of a line, from a hull, and the interval of a line inside it.
//
// A feature is nearest when the projection on its affine hull lies in it and the hull lies behind the plane
// through the projection (the condition of Karush, Kuhn and Tucker, sufficient for convex sets). Doubles
// propose an order of features, and integers decide. All features are tried before giving up.
//
// Brackets: nothing. Costs: about 20 microseconds a point at 30 vertices. Cannot be trusted: nowhere known.
#include "oracles/polytope/exact_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace graze::oracle {
namespace {

long exponent_of(const IntVec& v) {
  long top = std::numeric_limits<long>::min();
  for (const Integer* c : {&v.x, &v.y, &v.z}) {
    if (sgn(*c) != 0) top = std::max(top, static_cast<long>(mpz_sizeinbase(c->get_mpz_t(), 2)));
  }
  return top;
}

double scaled(const Integer& i, long exponent) {
  if (sgn(i) == 0) return 0;
  long e = 0;
  const double mantissa = mpz_get_d_2exp(&e, i.get_mpz_t());
  return e - exponent < -1000 ? 0.0 : std::ldexp(mantissa, static_cast<int>(e - exponent));
}

Guess scaled(const IntVec& v, long exponent) {
  return {scaled(v.x, exponent), scaled(v.y, exponent), scaled(v.z, exponent)};
}

double dot(const Guess& l, const Guess& r) { return l[0] * r[0] + l[1] * r[1] + l[2] * r[2]; }

double segment_distance_sq(const Guess& from, const Guess& to) {
  const Guess e = {from[0] - to[0], from[1] - to[1], from[2] - to[2]};  // from, to: relative to the far ends
  const double length_sq = dot(e, e);
  const double s = length_sq > 0 ? std::clamp(dot(from, e) / length_sq, 0.0, 1.0) : 0.0;
  const Guess r = {from[0] - s * e[0], from[1] - s * e[1], from[2] - s * e[2]};
  return dot(r, r);
}

}  // namespace

HullDistance::HullDistance(ConvexHull hull) : hull_(std::move(hull)) {
  for (const HullFacet& facet : hull_.facets) {
    const IntVec& n = hull_.half_spaces[facet.half_space].normal;
    Guess unit = scaled(n, exponent_of(n));
    const double length = std::sqrt(dot(unit, unit));
    for (double& c : unit) c /= length;
    unit_normals_.push_back(unit);
  }
}

bool HullDistance::contains(const HomogeneousPoint& p) const {
  return std::all_of(hull_.half_spaces.begin(), hull_.half_spaces.end(),
                     [&](const HalfSpace& h) { return oracle::dot(h.normal, p.x) <= p.w * h.offset; });
}

bool HullDistance::supports(const IntVec& direction, int vertex) const {
  const Integer most = oracle::dot(direction, hull_.vertices[vertex]);
  return std::all_of(hull_.vertices.begin(), hull_.vertices.end(),
                     [&](const IntVec& c) { return oracle::dot(direction, c) <= most; });
}

HullDistance::Candidate HullDistance::try_facet(const Integer& w, const Relative& relative, int facet) const {
  const HullFacet& f = hull_.facets[facet];
  const IntVec& n = hull_.half_spaces[f.half_space].normal;
  const Integer above = oracle::dot(n, relative[f.loop[0]]);
  if (sgn(above) <= 0) return {};
  for (std::size_t i = 0; i < f.loop.size(); ++i) {
    if (sgn(oracle::dot(f.outward[i], relative[f.loop[i]])) > 0) return {};
  }
  return PointDistance{fraction(above * above, w * w * oracle::dot(n, n)), Nearest::facet, facet};
}

HullDistance::Candidate HullDistance::try_edge(const Integer& w, const Relative& relative, int edge) const {
  const HullEdge& e = hull_.edges[edge];
  const IntVec& from = relative[e.from];
  const Integer along = oracle::dot(from, e.direction), length_sq = oracle::dot(e.direction, e.direction);
  if (sgn(along) <= 0) return try_vertex(w, relative, e.from);
  if (along >= length_sq * w) return try_vertex(w, relative, e.to);
  const IntVec rest = length_sq * from - along * e.direction;  // w |e|^2 (p - projection)
  if (!supports(rest, e.from)) return {};
  const Integer scale = w * length_sq;
  return PointDistance{fraction(oracle::dot(rest, rest), scale * scale), Nearest::edge, edge};
}

HullDistance::Candidate HullDistance::try_vertex(const Integer& w, const Relative& relative,
                                                 int vertex) const {
  if (!supports(relative[vertex], vertex)) return {};
  return PointDistance{fraction(oracle::dot(relative[vertex], relative[vertex]), w * w), Nearest::vertex,
                       vertex};
}

PointDistance HullDistance::from_point(const HomogeneousPoint& p) const {
  Relative relative;
  relative.reserve(hull_.vertices.size());
  long exponent = std::numeric_limits<long>::min();
  for (const IntVec& c : hull_.vertices) {
    relative.push_back(p.x - p.w * c);
    exponent = std::max(exponent, exponent_of(relative.back()));
  }
  std::vector<Guess> guess;
  guess.reserve(relative.size());
  for (const IntVec& r : relative) guess.push_back(scaled(r, exponent));

  // The plane that is farthest below p: if the nearest point is inside a facet, it is inside this one.
  std::vector<double> height(hull_.facets.size());
  double top = -std::numeric_limits<double>::infinity();
  std::size_t top_facet = 0;
  for (std::size_t f = 0; f < height.size(); ++f) {
    height[f] = dot(unit_normals_[f], guess[hull_.facets[f].loop[0]]);
    if (height[f] > top) {
      top = height[f];
      top_facet = f;
    }
  }
  const auto outside_of = [&](std::size_t f) {
    const HullFacet& facet = hull_.facets[f];
    return sgn(oracle::dot(hull_.half_spaces[facet.half_space].normal, relative[facet.loop[0]])) > 0;
  };
  const bool outside = !height.empty() && outside_of(top_facet);
  if (!outside && contains(p)) return {};

  constexpr double kTie = 1e-9;  // over the distance to the farthest vertex: which facets to try first
  for (std::size_t f = 0; f < height.size(); ++f) {
    if (!(height[f] >= top - kTie)) continue;
    if (const Candidate found = try_facet(p.w, relative, static_cast<int>(f))) return *found;
  }
  std::vector<double> edge_guess;
  for (const HullEdge& e : hull_.edges) edge_guess.push_back(segment_distance_sq(guess[e.from], guess[e.to]));
  std::vector<int> order(hull_.edges.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int l, int r) { return edge_guess[l] < edge_guess[r]; });
  for (const int e : order) {
    if (const Candidate found = try_edge(p.w, relative, e)) return *found;
  }
  for (std::size_t f = 0; f < height.size(); ++f) {
    if (const Candidate found = try_facet(p.w, relative, static_cast<int>(f))) return *found;
  }
  if (hull_.dimension == 0) return *try_vertex(p.w, relative, 0);
  throw std::logic_error("no feature of the hull is nearest: the hull is not convex");
}

std::optional<LineInterval> HullDistance::clip_line(const HomogeneousPoint& base, const IntVec& v) const {
  // s n.v <= slack / w, slack = w offset - n.base. Bounds are kept as slack / (n.v) with positive
  // denominators.
  struct Bound {
    Integer numerator, denominator;  // denominator 0: none yet
  } in, out;
  for (const HalfSpace& h : hull_.half_spaces) {
    Integer rate = oracle::dot(h.normal, v);
    Integer slack = base.w * h.offset - oracle::dot(h.normal, base.x);
    const int side = sgn(rate);
    if (side == 0) {
      if (sgn(slack) < 0) return {};
      continue;
    }
    if (side < 0) {
      rate = -rate;
      slack = -slack;
    }
    Bound& bound = side < 0 ? in : out;
    const int order = sgn(bound.denominator) == 0
                          ? side
                          : -cmp(Integer(slack * bound.denominator), Integer(bound.numerator * rate));
    // A lower bound moves up, an upper one down.
    if (sgn(bound.denominator) == 0 || (side < 0 ? order < 0 : order > 0)) bound = {slack, rate};
  }
  if (in.numerator * out.denominator > out.numerator * in.denominator) return {};
  return LineInterval{fraction(in.numerator, in.denominator * base.w),
                      fraction(out.numerator, out.denominator * base.w)};
}

LineDistance HullDistance::from_line(const IntVec& v) const {
  if (const auto inside = clip_line({{0, 0, 0}, 1}, v)) return {0, inside->in};
  const Integer vv = oracle::dot(v, v);
  const auto project = [&](const IntVec& c) { return vv * c - oracle::dot(c, v) * v; };
  const auto result = [&](const HomogeneousPoint& foot) {
    // The line foot + s v touches the hull. The first point of the touch is the answer's.
    return LineDistance{fraction(oracle::dot(foot.x, foot.x), foot.w * foot.w),
                        clip_line(foot, v).value().in};
  };
  for (int i = 0; i < static_cast<int>(hull_.vertices.size()); ++i) {
    const IntVec shadow = project(hull_.vertices[i]);
    if (supports(-shadow, i)) return result({shadow, vv});
  }
  for (const HullEdge& e : hull_.edges) {
    const IntVec along = project(e.direction), from = project(hull_.vertices[e.from]);
    const Integer s = -oracle::dot(from, along), length_sq = oracle::dot(along, along);
    if (sgn(s) <= 0 || s >= length_sq) continue;
    const IntVec foot = length_sq * from + s * along;
    if (supports(-foot, e.from)) return result({foot, length_sq * vv});
  }
  throw std::logic_error("no feature of the hull is nearest to the line: the hull is not convex");
}

}  // namespace graze::oracle
