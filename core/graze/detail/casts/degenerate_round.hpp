// Round shapes without roundness, as the polytopes that they are, and the names of their points.
//
//   a sphere or a rounding of radius 0, a capsule, cylinder or cone of radius 0, an ellipsoid of at most one
//   radius.
// Their casts are the exact tier's; a vertex of the polytope is then named as the given shape names it.
#pragma once

#include <graze/body.hpp>
#include <graze/detail/search/exact/term.hpp>
#include <graze/detail/shapes/shape_tree.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
CastResult<S> cast_exact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options);  // cast.hpp

// Nothing for a shape that has roundness, or is a polytope already.
template <Scalar S>
std::optional<Shape<S>> as_polytope(const Shape<S>& shape) {
  const auto along = [](const Vec3<S>& end) { return Segment<S>{-end, end}; };
  return std::visit(Overloaded{[](const Sphere<S>& s) -> std::optional<Shape<S>> {
                                 if (s.radius > 0) return {};
                                 return Point<S>{};
                               },
                               [](const Rounded<S>& s) -> std::optional<Shape<S>> {
                                 if (s.radius > 0) return {};
                                 const Shape<S>& inner = s.shape->shape;
                                 return exact::is_exact(inner) ? std::optional<Shape<S>>(inner)
                                                               : as_polytope(inner);
                               },
                               [&](const Ellipsoid<S>& s) -> std::optional<Shape<S>> {
                                 if ((s.radii.array() > 0).count() > 1) return {};
                                 return along(s.radii);
                               },
                               [&]<class T>(const T& s) -> std::optional<Shape<S>> {
                                 if constexpr (requires { s.half_height; }) {
                                   if (s.radius > 0) return {};
                                   return along({0, 0, s.half_height});
                                 } else {
                                   return {};
                                 }
                               }},
                    shape);
}

// Vertex k of the polytope as a feature of the given shape.
template <Scalar S>
void rename(const Shape<S>& given, Feature& feature) {
  const auto end = [&](const Vec3<double>& x) {
    feature.curved[0] = feature.vertex == 0 ? Vec3<double>(-x) : x;
    feature.vertex = 0;
  };
  std::visit(Overloaded{[&](const Rounded<S>& s) {
                          if (!exact::is_exact(s.shape->shape)) rename(s.shape->shape, feature);
                        },
                        [&](const Ellipsoid<S>& s) { end(s.radii.template cast<double>()); },
                        [&](const Cylinder<S>& s) {
                          end({0, 0, double(s.half_height)});
                        },
                        [&](const Cone<S>& s) {
                          end({0, 0, double(s.half_height)});
                        },
                        [](const auto&) {}},
             given);
}

// The exact cast of two shapes, one of which at least is such a polytope; nothing if either has roundness.
template <Scalar S>
std::optional<CastResult<S>> cast_flat(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  const bool known_a = exact::is_exact(a.shape), known_b = exact::is_exact(b.shape);
  const std::optional<Shape<S>> flat_a = known_a ? a.shape : as_polytope(a.shape);
  const std::optional<Shape<S>> flat_b = known_b ? b.shape : as_polytope(b.shape);
  if (!flat_a || !flat_b) return {};
  const Body<S> as_a{*flat_a, a.position, a.orientation, a.displacement};
  const Body<S> as_b{*flat_b, b.position, b.orientation, b.displacement};
  CastResult<S> out = cast_exact(as_a, as_b, options);
  if (!out.proof) return out;
  const auto pair = [&](SupportPair& p) {
    if (!known_a) rename(a.shape, p.a);
    if (!known_b) rename(b.shape, p.b);
  };
  for (int i = 0; i < out.proof->portal_size; ++i) pair(out.proof->portal[static_cast<std::size_t>(i)]);
  for (AxisFactor& factor : out.proof->factor) {
    if (factor.kind != AxisFactor::Kind::difference) continue;
    pair(factor.from);
    pair(factor.to);
  }
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
