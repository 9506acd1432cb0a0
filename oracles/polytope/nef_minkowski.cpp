// Decides: the CSO of two polytopes and the line through it, exactly, by CGAL's Nef polyhedra. It forms
// neither pairwise differences nor a hull of them. Brackets: nothing. Costs: 20 to 50 ms at 8 vertices a
// shape. Cannot be trusted: for a flat CSO (two flat bodies in one plane), which it refuses. It is too slow
// for more than a sample.
#include "oracles/polytope/nef_minkowski.hpp"

#include <algorithm>
#include <stdexcept>

#include "oracles/polytope/exact_body.hpp"
#include "oracles/polytope/nef_kernel.hpp"

namespace graze::oracle {
namespace {

using Kernel = NefKernel;

CGAL::Gmpq to_exact(const Rational& q) { return CGAL::Gmpq(q.get_mpq_t()); }

Rational to_rational(const CGAL::Gmpq& e) { return Rational(e.mpq()); }

// A, or -A.
Nef body_hull(const ExactBody& body, int sign) {
  if (sgn(body.radius) != 0) throw std::invalid_argument("Nef sums are for polytopes without rounding");
  NefPoints points;
  for (const RationalPoint& p : body.vertices) {
    points.emplace_back(to_exact(sign * p[0]), to_exact(sign * p[1]), to_exact(sign * p[2]));
  }
  return nef_hull(points);
}

// Do the two bodies' own directions together fail to span space? (CGAL's sum of two parallel segments
// crashes.)
bool sum_is_flat(const ExactBody& a, const ExactBody& b) {
  NefPoints along = {CGAL::ORIGIN};
  for (const ExactBody* body : {&a, &b}) {
    const RationalPoint& from = body->vertices[0];
    for (const RationalPoint& p : body->vertices) {
      along.emplace_back(to_exact(p[0] - from[0]), to_exact(p[1] - from[1]), to_exact(p[2] - from[2]));
    }
  }
  const auto first = [&](auto is_off) { return std::find_if(along.begin(), along.end(), is_off); };
  const auto second = first([&](const auto& p) { return p != along[0]; });
  if (second == along.end()) return true;
  const auto third = first([&](const auto& p) { return !CGAL::collinear(along[0], *second, p); });
  if (third == along.end()) return true;
  return first([&](const auto& p) { return !CGAL::coplanar(along[0], *second, *third, p); }) == along.end();
}

Rational dot(const RationalPoint& l, const RationalPoint& r) {
  return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

}  // namespace

NefCso nef_cso(const corpus::Case& problem) {
  if (problem.target_distance != 0)
    throw std::invalid_argument("Nef sums are for polytopes without rounding");
  const ExactBody body_a = exact_body(problem.a), body_b = exact_body(problem.b);
  if (sum_is_flat(body_a, body_b)) throw std::invalid_argument("Nef sums are for a CSO that is solid");
  Nef a = body_hull(body_a, 1), minus_b = body_hull(body_b, -1);
  const Nef sum = nef_sum(a, minus_b);
  NefCso cso;
  RationalPoint inner = {0, 0, 0};  // the vertices' centre
  for (auto v = sum.vertices_begin(); v != sum.vertices_end(); ++v) {
    RationalPoint& p = cso.vertices.emplace_back();
    p = {to_rational(v->point().x()), to_rational(v->point().y()), to_rational(v->point().z())};
    for (std::size_t i = 0; i < 3; ++i) inner[i] += p[i];
  }
  for (Rational& c : inner) c /= static_cast<unsigned long>(cso.vertices.size());
  std::sort(cso.vertices.begin(), cso.vertices.end());
  // Each face is there twice, once a side. Both are turned outward, away from the centre.
  for (auto f = sum.halffacets_begin(); f != sum.halffacets_end(); ++f) {
    if (f->is_twin()) continue;
    const Kernel::Plane_3& plane = f->plane();
    NefCso::HalfSpace h;
    h.normal = {to_rational(plane.a()), to_rational(plane.b()), to_rational(plane.c())};
    h.offset = -to_rational(plane.d());
    if (dot(h.normal, inner) > h.offset) {
      for (Rational& c : h.normal) c = -c;
      h.offset = -h.offset;
    }
    cso.half_spaces.push_back(std::move(h));
  }
  return cso;
}

std::optional<std::pair<Rational, Rational>> NefCso::clip(const RationalPoint& v) const {
  std::optional<Rational> in, out;
  for (const HalfSpace& h : half_spaces) {
    const Rational rate = dot(h.normal, v);
    if (sgn(rate) == 0) {
      if (sgn(h.offset) < 0) return {};
      continue;
    }
    const Rational t = h.offset / rate;
    if (sgn(rate) < 0 && (!in || t > *in)) in = t;
    if (sgn(rate) > 0 && (!out || t < *out)) out = t;
  }
  if (!in || !out || *in > *out) return {};
  return std::pair{*in, *out};
}

Rational NefCso::depth_sq() const {
  std::optional<Rational> least;
  for (const HalfSpace& h : half_spaces) {
    if (sgn(h.offset) < 0) throw std::logic_error("depth_sq: the origin is outside");
    const Rational squared = h.offset * h.offset / dot(h.normal, h.normal);
    if (!least || squared < *least) least = squared;
  }
  return least.value();
}

}  // namespace graze::oracle
