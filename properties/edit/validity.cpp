// Input validation: why a method must refuse a case, whatever it would answer. Written from the documentation
// of the library, not from its code.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "properties/edit/case.hpp"

namespace graze::law {
namespace {

// The range that every method accepts: 0, and magnitudes of 1e-60 to 1e60.
bool in_range(double x) {
  const double magnitude = std::abs(x);
  return magnitude == 0 || (magnitude >= 1e-60 && magnitude <= 1e60);
}
bool in_range(const Vec3<double>& x) { return in_range(x.x()) && in_range(x.y()) && in_range(x.z()); }

std::string orientation_fault(const Quaternion<double>& q) {
  if (!in_range({q.x, q.y, q.z}) || !in_range(q.w)) return "a quaternion outside 1e-60 to 1e60";
  return q.w == 0 && q.is_identity() ? "a zero quaternion" : "";
}

// The reason why a shape must be refused. Empty for a sound one.
struct ShapeFault {
  int* parts_seen;
  int nested = 0;  // combinators around it

  [[nodiscard]] static std::string length(double x, const char* what) {
    if (!in_range(x)) return fmt::format("a {} outside 1e-60 to 1e60", what);
    return x < 0 ? fmt::format("a negative {}", what) : "";
  }
  [[nodiscard]] static std::string lengths(const Vec3<double>& x, const char* what) {
    for (int i = 0; i < 3; ++i) {
      if (std::string why = length(x[i], what); !why.empty()) return why;
    }
    return "";
  }
  [[nodiscard]] static std::string vertices(std::initializer_list<Vec3<double>> all) {
    const bool inside = std::all_of(all.begin(), all.end(), [](const auto& x) { return in_range(x); });
    return inside ? "" : "a vertex outside 1e-60 to 1e60";
  }
  [[nodiscard]] std::string parts(std::span<const SharedShape<double>> all) const {
    constexpr int kMostNested = 16, kMostParts = 4096;
    if (all.empty()) return "a combinator without parts";
    if (nested >= kMostNested) return "combinators nested deeper than 16";
    for (const SharedShape<double>& part : all) {
      if (!part) return "a combinator with a missing part";
      if (++*parts_seen > kMostParts) return "combinators of more than 4096 parts";
      const ShapeFault inner{parts_seen, nested + 1};
      if (std::string why = std::visit(inner, part->shape); !why.empty()) return why;
    }
    return "";
  }

  std::string operator()(const Point<double>&) const { return ""; }
  std::string operator()(const Segment<double>& s) const { return vertices({s.a, s.b}); }
  std::string operator()(const Triangle<double>& t) const { return vertices({t.a, t.b, t.c}); }
  std::string operator()(const Sphere<double>& s) const { return length(s.radius, "radius"); }
  std::string operator()(const Box<double>& b) const { return lengths(b.half_extents, "half extent"); }
  std::string operator()(const Ellipsoid<double>& e) const { return lengths(e.radii, "radius"); }
  std::string operator()(const Hull<double>& h) const {
    if (h.size() == 0) return "a hull without a vertex";
    const auto all = h.vertices();
    const bool inside = std::all_of(all.begin(), all.end(), [](const auto& x) { return in_range(x); });
    return inside ? "" : "a vertex outside 1e-60 to 1e60";
  }
  std::string operator()(const Posed<double>& p) const {
    if (!in_range(p.position)) return "a position outside 1e-60 to 1e60";
    if (std::string why = orientation_fault(p.orientation); !why.empty()) return why;
    return parts(std::span(&p.shape, 1));
  }
  std::string operator()(const Rounded<double>& r) const {
    if (std::string why = length(r.radius, "radius"); !why.empty()) return why;
    return parts(std::span(&r.shape, 1));
  }
  // Sum, hull of several.
  template <class Combinator>
  requires requires(Combinator s) { s.shapes; }
  std::string operator()(const Combinator& s) const { return parts(s.shapes); }
  // Capsule, cylinder, cone.
  template <class Round>
  requires requires(Round s) { s.half_height; }
  std::string operator()(const Round& s) const {
    if (std::string why = length(s.radius, "radius"); !why.empty()) return why;
    return length(s.half_height, "half height");
  }
};

// Vertices by the rule of core/graze/shape.hpp, for a shape without another fault. A double can hold counts that no
// integer type does.
constexpr double kMostVerticesInDomain = 4294967295.0;
double vertices_in(const Shape<double>& shape) {
  return std::visit(
      []<class T>(const T& s) -> double {
        if constexpr (requires { s.shape; }) {
          return vertices_in(s.shape->shape);
        } else if constexpr (requires { s.shapes; }) {
          constexpr bool kProduct = std::same_as<T, Sum<double>>;
          double count = kProduct ? 1 : 0;
          for (const auto& part : s.shapes) {
            const double more = vertices_in(part->shape);
            count = std::min(kProduct ? count * more : count + more, 1e300);
          }
          return count;
        } else if constexpr (std::same_as<T, Hull<double>>) {
          return static_cast<double>(s.size());
        } else if constexpr (std::same_as<T, Box<double>>) {
          return 8;
        } else if constexpr (std::same_as<T, Triangle<double>>) {
          return 3;
        } else {
          return std::same_as<T, Segment<double>> || std::same_as<T, Capsule<double>> ? 2 : 1;
        }
      },
      shape);
}

}  // namespace

std::string why_invalid(const corpus::Case& problem) {
  for (const corpus::Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    if (!in_range(spin->rotation) || !in_range(spin->pivot))
      return "a rotation or a pivot outside 1e-60 to 1e60";
    constexpr double kMostTurn = 0x1p30;  // radians
    if (problem.t_max < kInfinity<double> && spin->rotation.norm() * problem.t_max > kMostTurn)
      return "a turn of more than 2^30 radians";
  }
  for (const Body<double>* body : {&problem.a, &problem.b}) {
    if (!in_range(body->position) || !in_range(body->displacement)) {
      return "a magnitude outside 1e-60 to 1e60";
    }
    if (std::string why = orientation_fault(body->orientation); !why.empty()) return why;
    int parts_seen = 0;
    if (std::string why = std::visit(ShapeFault{&parts_seen}, body->shape); !why.empty()) return why;
    if (vertices_in(body->shape) > kMostVerticesInDomain) return "a shape of more than 2^32 - 1 vertices";
  }
  if (problem.query == corpus::Query::penetration_along) {
    if (!in_range(problem.direction)) return "a direction outside 1e-60 to 1e60";
    if (problem.direction == Vec3<double>::Zero()) return "a direction of length zero";
  }
  if (!(problem.t_max >= 0)) return "a negative t_max";
  if (!in_range(problem.target_distance) || problem.target_distance < 0)
    return "a target distance out of range";
  return {};
}

}  // namespace graze::law
