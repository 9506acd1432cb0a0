#include "properties/edit/same_body.hpp"

#include <cmath>
#include <graze/detail/shapes/hull_graph.hpp>
#include <utility>

namespace graze::law {

namespace {

using Vertices = std::vector<Vec3<double>>;

// Fisher and Yates.
template <class T>
void shuffle(std::vector<T>& all, std::uint64_t salt) {
  for (std::size_t i = all.size(); i > 1; --i) {
    salt = mix(salt);
    std::swap(all[i - 1], all[salt % i]);
  }
}

Shape<double> hull_like(const Shape<double>& shape, const Vertices& vertices) {
  const auto* hull = std::get_if<Hull<double>>(&shape);
  if (hull != nullptr && hull->has_adjacency()) return with_adjacency<double>(vertices);
  return Hull<double>(std::span<const Vec3<double>>(vertices));
}

// (a + b) / 2 where exact.
std::optional<Vec3<double>> midpoint(const Vec3<double>& a, const Vec3<double>& b) {
  auto sum = exact_sum(a, b);
  if (!sum) return std::nullopt;
  const Vec3<double> half = *sum / 2;
  if (Vec3<double>(2 * half) != *sum) return std::nullopt;
  return half;
}

// The first part that `edit` changes, in the parts' order, or nothing.
template <class F>
std::optional<Shape<double>> with_one_part(const Shape<double>& shape, const F& edit) {
  std::vector<SharedShape<double>> parts = parts_of(shape);
  for (SharedShape<double>& part : parts) {
    if (!part) continue;
    if (auto other = edit(part->shape)) {
      part = share(*std::move(other));
      return with_parts(shape, std::move(parts));
    }
  }
  return std::nullopt;
}

SharedShape<double> segment_along(int axis, double half) {
  const Vec3<double> end = half * Vec3<double>::Unit(axis);
  return share<double>(Segment<double>{-end, end});
}

struct Otherwise {
  std::uint64_t pick;
  using Found = std::optional<Shape<double>>;

  Found operator()(const Point<double>&) const {
    if (pick & 1) return Sphere<double>{0};
    return Segment<double>{};
  }
  Found operator()(const Segment<double>& s) const {
    if (pick & 1) return Hull<double>{s.a, s.b};
    return Triangle<double>{s.a, s.b, s.a};
  }
  Found operator()(const Triangle<double>& t) const { return Hull<double>{t.a, t.b, t.c}; }
  Found operator()(const Sphere<double>& s) const {
    if (pick & 1) return rounded<double>(Point<double>{}, s.radius);
    return Capsule<double>{s.radius, 0};
  }
  Found operator()(const Capsule<double>& c) const {
    const Vec3<double> top(0, 0, c.half_height);
    if (pick & 1) return rounded<double>(Segment<double>{-top, top}, c.radius);
    return hull_of<double>(translated<double>(Sphere<double>{c.radius}, -top),
                           translated<double>(Sphere<double>{c.radius}, top));
  }
  Found operator()(const Box<double>& b) const {
    if (pick & 1) {
      return Sum<double>{{segment_along(0, b.half_extents[0]), segment_along(1, b.half_extents[1]),
                          segment_along(2, b.half_extents[2])}};
    }
    return Hull<double>(std::span<const Vec3<double>>(*exact_vertices(Box<double>{b}, 8)));
  }
  Found operator()(const Ellipsoid<double>& e) const {
    if (e.radii[0] != e.radii[1] || e.radii[1] != e.radii[2]) return std::nullopt;
    return Sphere<double>{e.radii[0]};
  }
  Found operator()(const Cylinder<double>& c) const {
    return Sum<double>{{share<double>(Cylinder<double>{c.radius, 0}), segment_along(2, c.half_height)}};
  }
  Found operator()(const Cone<double>& c) const {
    const Vec3<double> apex(0, 0, c.half_height);
    return hull_of<double>(translated<double>(Cylinder<double>{c.radius, 0}, -apex), Hull<double>{apex});
  }
  Found operator()(const Hull<double>& h) const {
    // The last vertex apart. For one vertex, a point at its place.
    Vertices all(h.vertices().begin(), h.vertices().end());
    const Vec3<double> last = all.back();
    if (all.size() == 1) return translated<double>(Point<double>{}, last);
    all.pop_back();
    return hull_of<double>(Hull<double>(std::span<const Vec3<double>>(all)), Hull<double>{last});
  }
  Found operator()(const Rounded<double>& r) const {
    if (!r.shape) return std::nullopt;
    return Sum<double>{{r.shape, share<double>(Sphere<double>{r.radius})}};
  }
  // Posed, sum, hull of shapes.
  template <class Combinator>
  Found operator()(const Combinator& s) const {
    constexpr std::size_t kMost = 64;
    if (const auto vertices = exact_vertices(s, kMost)) return hull_like(s, *vertices);
    return with_one_part(s, [&](const Shape<double>& part) { return described_otherwise(part, pick >> 1); });
  }
};

}  // namespace

std::optional<Shape<double>> reordered(const Shape<double>& shape, std::uint64_t salt) {
  const auto again = [&](const Shape<double>& part) { return reordered(part, mix(salt)); };
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) {
    if (hull->size() == 0) return std::nullopt;
    Vertices vertices(hull->vertices().begin(), hull->vertices().end());
    const std::size_t twice = salt % 3;
    for (std::size_t i = 0; i < twice; ++i) vertices.push_back(hull->vertex(mix(salt + i) % hull->size()));
    shuffle(vertices, salt);
    return hull_like(shape, vertices);
  }
  if (const auto* triangle = std::get_if<Triangle<double>>(&shape)) {
    return Triangle<double>{triangle->c, triangle->a, triangle->b};
  }
  if (const auto* segment = std::get_if<Segment<double>>(&shape)) {
    return Segment<double>{segment->b, segment->a};
  }
  if (std::holds_alternative<Sum<double>>(shape) || std::holds_alternative<HullOf<double>>(shape)) {
    auto parts = parts_of(shape);
    if (parts.size() < 2) return with_one_part(shape, again);
    shuffle(parts, salt);
    return with_parts(shape, std::move(parts));
  }
  return with_one_part(shape, again);
}

std::optional<Shape<double>> with_redundant_points(const Shape<double>& shape, std::uint64_t salt) {
  constexpr std::size_t kMost = 300;
  const auto given = parts_of(shape).empty() ? exact_vertices(shape, kMost) : std::nullopt;
  if (!given) {
    return with_one_part(shape,
                         [&](const Shape<double>& part) { return with_redundant_points(part, mix(salt)); });
  }
  if (given->size() < 2) return std::nullopt;
  Vertices all = *given;
  const auto any = [&](std::uint64_t k) { return all[mix(salt + k) % all.size()]; };
  for (std::uint64_t k = 0; k < 4; ++k) {
    // Any of all points so far, so that midpoints of midpoints occur by themselves.
    if (const auto middle = midpoint(any(2 * k), any(2 * k + 1))) all.push_back(*middle);
  }
  if (all.size() == given->size()) return std::nullopt;
  if ((salt & 1) != 0) shuffle(all, salt);
  return hull_like(shape, all);
}

std::optional<Shape<double>> with_other_adjacency(const Shape<double>& shape) {
  const auto* hull = std::get_if<Hull<double>>(&shape);
  if (hull == nullptr) return with_one_part(shape, &with_other_adjacency);
  if (hull->has_adjacency()) return Hull<double>(hull->vertices());
  if (hull->size() < graze::detail::kMapFrom) return std::nullopt;
  Hull<double> derived = with_adjacency(hull->vertices());
  if (!derived.has_adjacency()) return std::nullopt;
  return derived;
}

std::optional<corpus::Case> with_other_hulls(const corpus::Case& problem) {
  corpus::Case given = problem;
  bool differs = false;
  for (Body<double>* body : {&given.a, &given.b}) {
    if (auto shape = with_other_adjacency(body->shape)) {
      body->shape = *std::move(shape);
      differs = true;
    }
  }
  if (!differs) return std::nullopt;
  return given;
}

std::optional<Shape<double>> described_otherwise(const Shape<double>& shape, std::uint64_t salt) {
  return std::visit(Otherwise{mix(salt)}, shape);
}

}  // namespace graze::law
