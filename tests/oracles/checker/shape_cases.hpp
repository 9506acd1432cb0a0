// Random shapes of every kind, and points of them.
#pragma once

#include "tests/oracles/checker/proof_cases.hpp"
#include "tests/oracles/checker/shape_reference.hpp"

namespace graze::test {

enum class Kind {
  point,
  segment,
  triangle,
  sphere,
  capsule,
  box,
  ellipsoid,
  cylinder,
  cone,
  hull,
  posed,
  rounded,
  sum,
  hull_of,
  nested,
};
inline constexpr int kLeafKinds = 10, kKinds = 15;
inline constexpr const char* kKindNames[kKinds] = {"point", "segment",   "triangle", "sphere",  "capsule",
                                                   "box",   "ellipsoid", "cylinder", "cone",    "hull",
                                                   "posed", "rounded",   "sum",      "hull_of", "nested"};

// A length from 0 to 3, sometimes 0.
inline double draw_extent(Draw& draw, Numbers numbers) {
  return draw.random.once_in(12) ? 0 : std::abs(draw.number(numbers, 3));
}

inline Shape<double> draw_kind(Draw& draw, Kind kind, Numbers numbers, Pose pose);

inline SharedShape<double> draw_part(Draw& draw, Numbers numbers, Pose pose, int kinds) {
  const auto kind = static_cast<Kind>(draw.random.below(static_cast<std::uint64_t>(kinds)));
  return share<double>(draw_kind(draw, kind, numbers, pose));
}
inline std::vector<SharedShape<double>> draw_parts(Draw& draw, Numbers numbers, Pose pose, int kinds) {
  std::vector<SharedShape<double>> parts(static_cast<std::size_t>(draw.random.integer(1, 3)));
  for (auto& part : parts) part = draw_part(draw, numbers, pose, kinds);
  return parts;
}

inline Shape<double> draw_kind(Draw& draw, Kind kind, Numbers numbers, Pose pose) {
  const auto extent = [&] { return draw_extent(draw, numbers); };
  switch (kind) {
    case Kind::point:
      return Point<double>{};
    case Kind::segment: {
      const Vec3<double> a = draw.vector(numbers, 3), b = draw.vector(numbers, 3);
      return Segment<double>{a, b};
    }
    case Kind::triangle: {
      const Vec3<double> a = draw.vector(numbers, 3), b = draw.vector(numbers, 3),
                         c = draw.vector(numbers, 3);
      return Triangle<double>{a, b, c};
    }
    case Kind::sphere:
      return Sphere<double>{extent()};
    case Kind::capsule: {
      const double r = extent(), h = extent();
      return Capsule<double>{r, h};
    }
    case Kind::box:
      return Box<double>{{extent(), extent(), extent()}};
    case Kind::ellipsoid:
      return Ellipsoid<double>{{extent(), extent(), extent()}};
    case Kind::cylinder: {
      const double r = extent(), h = extent();
      return Cylinder<double>{r, h};
    }
    case Kind::cone: {
      const double r = extent(), h = extent();
      return Cone<double>{r, h};
    }
    case Kind::hull:
      return draw.hull(numbers, 4, 6);
    case Kind::posed: {
      auto part = draw_part(draw, numbers, pose, kLeafKinds);
      const Vec3<double> position = draw.vector(numbers, 3);
      return Posed<double>{std::move(part), position, draw.orientation(pose)};
    }
    case Kind::rounded: {
      auto part = draw_part(draw, numbers, pose, kLeafKinds);
      return Rounded<double>{std::move(part), extent()};
    }
    case Kind::sum:
      return Sum<double>{draw_parts(draw, numbers, pose, kLeafKinds)};
    case Kind::hull_of:
      return HullOf<double>{draw_parts(draw, numbers, pose, kLeafKinds)};
    case Kind::nested:
      break;
  }
  // Combinators of combinators of leaves.
  auto first = draw_part(draw, numbers, pose, kKinds - 1),
       second = draw_part(draw, numbers, pose, kKinds - 1);
  const Vec3<double> position = draw.vector(numbers, 3);
  switch (draw.random.below(4)) {
    case 0:
      return Posed<double>{share<double>(HullOf<double>{{first, second}}), position, draw.orientation(pose)};
    case 1:
      return Rounded<double>{share<double>(Posed<double>{first, position, draw.orientation(pose)}), extent()};
    case 2:
      return Sum<double>{{share<double>(Posed<double>{first, position, draw.orientation(pose)}), second}};
    default:
      return HullOf<double>{{first, share<double>(Posed<double>{second, position, draw.orientation(pose)})}};
  }
}

// A point of the part, up to a hundredth from its boundary.
inline Vec3<double> draw_inside(Draw& draw, const Shape<double>& part) {
  Vec3<double> u = draw.vector(Numbers::doubles, 1);
  if (const auto* s = std::get_if<Ellipsoid<double>>(&part))
    return s->radii.cwiseProduct(u * (0.99 / std::max(1.0, u.norm())));
  const double across = std::hypot(u.x(), u.y()), shrink = 0.99 / std::max(1.0, across);
  if (const auto* s = std::get_if<Cylinder<double>>(&part))
    return {u.x() * shrink * s->radius, u.y() * shrink * s->radius, u.z() * s->half_height};
  const auto& cone = std::get<Cone<double>>(part);
  const double here = cone.radius * (1 - u.z()) / 2;
  return {u.x() * shrink * here, u.y() * shrink * here, u.z() * cone.half_height};
}

// A point of the shape, all its numbers in use.
inline Feature draw_feature(Draw& draw, const std::vector<NamedVertex>& vertices) {
  Feature feature;
  feature.vertex = static_cast<std::uint32_t>(draw.random.below(vertices.size()));
  const NamedVertex& v = vertices[feature.vertex];
  if (v.radius > 0) {
    const Vec3<double> way = draw.vector(Numbers::doubles, 1);
    feature.offset = way * (0.99 * v.radius.get_d() / std::max(1.0, way.norm()));
  }
  for (std::size_t k = 0; k < std::min(v.slots.size(), kCurvedParts); ++k)
    feature.curved[k] = draw_inside(draw, *v.slots[k].part);
  return feature;
}

}  // namespace graze::test
