// Exact edits of a case. Each returns a case whose true answer is known from the original's, or nothing where
// some number of the new case would have to be rounded: a law must not blame a method for our own rounding.
//
// Frame: world. Contact at t iff t v in C, C = A - B + ball(m), v = v_B - v_A.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "corpus/case.hpp"

namespace graze::law {

// What a scalar of a case means. The order of the visit is fixed: A's shape, position, orientation and
// displacement, then B's, then the horizon, then the target distance.
enum class Slot : std::uint8_t { vertex, extent, position, orientation, displacement, horizon, target };

[[nodiscard]] constexpr bool is_length(Slot slot) {
  return slot != Slot::orientation && slot != Slot::horizon;
}

namespace detail {

template <class F>
void map_shape(Shape<double>& shape, F& f) {
  if (auto* sphere = std::get_if<Sphere<double>>(&shape)) {
    sphere->radius = f(Slot::extent, sphere->radius);
  } else if (auto* box = std::get_if<Box<double>>(&shape)) {
    for (int i = 0; i < 3; ++i) box->half_extents[i] = f(Slot::extent, box->half_extents[i]);
  } else if (auto* hull = std::get_if<Hull<double>>(&shape)) {
    std::vector<Vec3<double>> vertices(hull->vertices().begin(), hull->vertices().end());
    for (Vec3<double>& v : vertices) {
      for (int i = 0; i < 3; ++i) v[i] = f(Slot::vertex, v[i]);
    }
    *hull = Hull<double>(std::span<const Vec3<double>>(vertices));
  }
}

template <class F>
void map_body(Body<double>& body, F& f) {
  map_shape(body.shape, f);
  for (int i = 0; i < 3; ++i) body.position[i] = f(Slot::position, body.position[i]);
  Quaternion<double>& q = body.orientation;
  for (double* x : {&q.w, &q.x, &q.y, &q.z}) *x = f(Slot::orientation, *x);
  for (int i = 0; i < 3; ++i) body.displacement[i] = f(Slot::displacement, body.displacement[i]);
}

}  // namespace detail

// The case with every scalar x replaced by f(slot, x).
template <class F>
[[nodiscard]] corpus::Case map_scalars(corpus::Case problem, F&& f) {
  detail::map_body(problem.a, f);
  detail::map_body(problem.b, f);
  problem.t_max = f(Slot::horizon, problem.t_max);
  problem.target_distance = f(Slot::target, problem.target_distance);
  return problem;
}

// Every scalar, in the order of the visit.
[[nodiscard]] std::vector<double> scalars(const corpus::Case& problem);
// Equal shapes (kind and size) and equal bits in every scalar; zeros of either sign are equal.
[[nodiscard]] bool same_input(const corpus::Case& left, const corpus::Case& right);
// The domain: finite numbers, each 0 or of magnitude 1e-60 to 1e60, no empty hull, no negative extent, q !=
// 0, t_max >= 0 (infinity allowed), target_distance >= 0. Written from the documentation of the library, not
// from its code.
[[nodiscard]] bool in_domain(const corpus::Case& problem);
// A NaN, an infinity (but in t_max), an empty hull, a negative extent or distance, q = 0: must be refused.
[[nodiscard]] bool must_be_refused(const corpus::Case& problem);
[[nodiscard]] bool is_polytope(const corpus::Case& problem);  // no sphere and no target distance

// a - b, a + b, a * b where exact.
[[nodiscard]] std::optional<double> exact_sum(double a, double b);
[[nodiscard]] std::optional<double> exact_product(double a, double b);

// v = v_B - v_A rounded to double, and its length.
[[nodiscard]] Vec3<double> velocity(const corpus::Case& problem);

// A and B exchanged: TOI unchanged, the cone of normals negated.
[[nodiscard]] corpus::Case swapped(const corpus::Case& problem);
// Every length times 2^k: TOI unchanged.
[[nodiscard]] std::optional<corpus::Case> scaled(const corpus::Case& problem, int k);
// Both bodies moved by one vector, chosen among large and small ones, axis by axis, so that every sum is
// exact; `salt` varies the choice. Nothing where no axis can move. TOI unchanged.
[[nodiscard]] std::optional<corpus::Case> translated(const corpus::Case& problem, std::uint64_t salt);
// The shape of A (or B, by `salt`) replaced by a superset: a box or a sphere grown, a hull with one more
// vertex, a point become a sphere or a segment. TOI not later.
[[nodiscard]] corpus::Case grown(const corpus::Case& problem, std::uint64_t salt);
// C as a hull of vertex differences against a moving point: the ray against the CSO. Exact posed vertices
// only.
[[nodiscard]] std::optional<corpus::Case> ray_against_cso(const corpus::Case& problem);
// [0, s] and [s, T] restarted from where the bodies are at s; s in (0, T) dyadic. TOI = TOI_1, or s + TOI_2.
struct Split {
  double at = 0;
  corpus::Case before, after;
};
[[nodiscard]] std::optional<Split> split(const corpus::Case& problem, std::uint64_t salt);

// A 64-bit hash of the numbers of a case: the same on every machine; it salts the choices above.
[[nodiscard]] std::uint64_t hash_of(const corpus::Case& problem);

}  // namespace graze::law
