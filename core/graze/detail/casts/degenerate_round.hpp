// Round shapes without roundness, as the polytopes that they are, and the names of their points.
//
//   a sphere or a rounding of radius 0, a capsule, cylinder or cone of radius 0, an ellipsoid of at most one
//   radius.
// Their casts are left to the exact tier. A vertex of the polytope is then named as the given shape names it.
#pragma once

#include <graze/detail/casts/exact_cast.hpp>
#include <graze/detail/search/exact/term.hpp>
#include <graze/detail/shapes/shape_tree.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
std::optional<Shape<S>> flat(const Shape<S>& shape);

// Nothing for a shape that has roundness, or is a polytope already.
template <Scalar S>
std::optional<Shape<S>> as_polytope(const Shape<S>& shape) {
  const auto along = [](const Vec3<S>& end) { return Segment<S>{-end, end}; };
  const bool is_rounded = exact::is_exact(shape, true);
  return std::visit(Overloaded{[](const Sphere<S>& s) -> std::optional<Shape<S>> {
                                 if (s.radius > 0) return {};
                                 return Point<S>{};
                               },
                               [](const Rounded<S>& s) -> std::optional<Shape<S>> {
                                 if (s.radius > 0) return {};
                                 return flat(s.shape->shape);
                               },
                               [&](const Posed<S>& s) -> std::optional<Shape<S>> {
                                 const auto inner = is_rounded ? flat(s.shape->shape) : std::nullopt;
                                 if (!inner) return {};
                                 return Posed<S>{share<S>(*inner), s.position, s.orientation};
                               },
                               [&](const Sum<S>& s) -> std::optional<Shape<S>> {
                                 Sum<S> out;
                                 for (const SharedShape<S>& part : s.shapes) {
                                   const auto inner = is_rounded ? flat(part->shape) : std::nullopt;
                                   if (!inner) return {};
                                   out.shapes.push_back(share<S>(*inner));
                                 }
                                 return out;
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

// The polytope that a shape is equal to, or nothing if it has roundness.
template <Scalar S>
std::optional<Shape<S>> flat(const Shape<S>& shape) {
  return exact::is_exact(shape) ? std::optional<Shape<S>>(shape) : as_polytope(shape);
}

// For a body whose shape is such a polytope.
template <Scalar S>
Body<S> flat(const Body<S>& body) {
  Body<S> out = body;
  out.shape = *flat(body.shape);
  return out;
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

// The exact walk as a rung of tier certified, for polytopes, combined ones and such round shapes. False if either shape
// has roundness, or keeps a target distance.
template <Scalar S>
bool exact_walk_if_flat(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                        CastResult<S>& out) {
  if (options.target_distance > 0) return false;
  const bool known_a = exact::is_exact(a.shape), known_b = exact::is_exact(b.shape);
  if (known_a && known_b) return exact_walk(a, b, options, out);
  const std::optional<Shape<S>> flat_a = flat(a.shape), flat_b = flat(b.shape);
  if (!flat_a || !flat_b) return false;
  const Body<S> as_a{*flat_a, a.position, a.orientation, a.displacement};
  const Body<S> as_b{*flat_b, b.position, b.orientation, b.displacement};
  exact_walk(as_a, as_b, options, out);
  if (!out.proof) return true;
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
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
