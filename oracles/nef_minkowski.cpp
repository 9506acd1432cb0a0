// Decides: the CSO of two solid polytopes and the line through it, exactly, by CGAL's Nef polyhedra: neither
// pairwise differences nor a hull of them is formed. Brackets: nothing.
// Costs: 20 to 50 ms at 8 vertices a shape.
// Cannot be trusted: for flat bodies, which it refuses; too slow for more than a sample.
#include "oracles/nef_minkowski.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/minkowski_sum_3.h>

#include <algorithm>
#include <stdexcept>

#include "oracles/exact_body.hpp"

namespace graze::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Exact = Kernel::FT::ET;

Kernel::FT to_exact(const Rational& q) { return Kernel::FT(Exact(q.get_mpq_t())); }

template <class Number>
Rational to_rational(const Number& e) {
  if constexpr (requires { e.backend().data(); }) {
    return Rational(e.backend().data());
  } else if constexpr (requires { e.mpq(); }) {
    return Rational(e.mpq());
  } else {
    return e;
  }
}

Nef solid(const ExactBody& body, int sign) {
  std::vector<Kernel::Point_3> points;
  for (const RationalPoint& p : body.vertices) {
    points.emplace_back(to_exact(sign * p[0]), to_exact(sign * p[1]), to_exact(sign * p[2]));
  }
  const bool flat = std::all_of(points.begin(), points.end(), [&](const auto& p) {
    return std::all_of(points.begin(), points.end(), [&](const auto& q) {
      return std::all_of(points.begin(), points.end(),
                         [&](const auto& r) { return CGAL::coplanar(points[0], p, q, r); });
    });
  });
  if (flat || sgn(body.radius) != 0) throw std::invalid_argument("Nef sums are for solid polytopes");
  Polyhedron hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  return Nef(hull);
}

Rational dot(const RationalPoint& l, const RationalPoint& r) {
  return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}

}  // namespace

NefCso nef_cso(const corpus::Case& problem) {
  if (problem.target_distance != 0)
    throw std::invalid_argument("Nef sums are for polytopes without rounding");
  Nef a = solid(exact_body(problem.a), 1), minus_b = solid(exact_body(problem.b), -1);
  const Nef sum = CGAL::minkowski_sum_3(a, minus_b);
  NefCso cso;
  RationalPoint inner = {0, 0, 0};  // the vertices' centre
  for (auto v = sum.vertices_begin(); v != sum.vertices_end(); ++v) {
    RationalPoint& p = cso.vertices.emplace_back();
    p = {to_rational(CGAL::exact(v->point().x())), to_rational(CGAL::exact(v->point().y())),
         to_rational(CGAL::exact(v->point().z()))};
    for (std::size_t i = 0; i < 3; ++i) inner[i] += p[i];
  }
  for (Rational& c : inner) c /= static_cast<unsigned long>(cso.vertices.size());
  std::sort(cso.vertices.begin(), cso.vertices.end());
  // Each face is there twice, once a side; both are turned outward, away from the centre.
  for (auto f = sum.halffacets_begin(); f != sum.halffacets_end(); ++f) {
    if (f->is_twin()) continue;
    const Kernel::Plane_3& plane = f->plane();
    NefCso::HalfSpace h;
    h.normal = {to_rational(CGAL::exact(plane.a())), to_rational(CGAL::exact(plane.b())),
                to_rational(CGAL::exact(plane.c()))};
    h.offset = -to_rational(CGAL::exact(plane.d()));
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

}  // namespace graze::oracle
