// Exact edits of a case. Each returns a case whose true answer is known from the original's. It returns nothing if some
// number of the new case would have to be rounded, because a law must not blame a method for our own rounding.
//
// Frame: world. Linear: contact at t iff t v in C, C = A - B + ball(m), v = v_B - v_A. Rotating: a body's point x is at
// R(w t)(x - c) + c + v t, c = position + R(orientation) pivot (graze/rotating_body.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "corpus/case.hpp"
#include "properties/edit/shape.hpp"

namespace graze::law {

namespace detail {

template <class F>
void map_body(Body<double>& body, F& f) {
  const ShapeMap<F> map{f};
  body.shape = map_shape(body.shape, f);
  body.position = map.vector(Slot::position, body.position);
  body.orientation = map.quaternion(body.orientation);
  body.displacement = map.vector(Slot::displacement, body.displacement);
}
template <class F>
void map_spin(corpus::Spin& spin, F& f) {
  const ShapeMap<F> map{f};
  spin.rotation = map.vector(Slot::rotation, spin.rotation);
  spin.pivot = map.vector(Slot::pivot, spin.pivot);
}

template <class F>
void visit_body(const Body<double>& body, F& f) {
  const ShapeVisit<F> visit{f};
  std::visit(visit, body.shape);
  visit.vector(Slot::position, body.position);
  visit.quaternion(body.orientation);
  visit.vector(Slot::displacement, body.displacement);
}

}  // namespace detail

// Is a rotation or a pivot given, visible or not?
[[nodiscard]] bool has_spin(const corpus::Case& problem);

// The case with every scalar x replaced by f(slot, x). The order of the visit is fixed: A's shape, position,
// orientation and displacement, then B's, then the horizon, then the target distance. For a case with a spin, A's
// rotation and pivot and B's follow.
template <class F>
[[nodiscard]] corpus::Case map_scalars(corpus::Case problem, F&& f) {
  detail::map_body(problem.a, f);
  detail::map_body(problem.b, f);
  problem.t_max = f(Slot::horizon, problem.t_max);
  problem.target_distance = f(Slot::target, problem.target_distance);
  if (has_spin(problem)) {
    detail::map_spin(problem.spin_a, f);
    detail::map_spin(problem.spin_b, f);
  }
  return problem;
}

// f(slot, x) for every scalar, in the same order.
template <class F>
void visit_scalars(const corpus::Case& problem, F&& f) {
  detail::visit_body(problem.a, f);
  detail::visit_body(problem.b, f);
  f(Slot::horizon, problem.t_max);
  f(Slot::target, problem.target_distance);
  if (!has_spin(problem)) return;
  const detail::ShapeVisit<std::remove_reference_t<F>> visit{f};
  for (const corpus::Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    visit.vector(Slot::rotation, spin->rotation);
    visit.vector(Slot::pivot, spin->pivot);
  }
}

// Every scalar, in the order of the visit.
[[nodiscard]] std::vector<double> scalars(const corpus::Case& problem);
// Equal shapes (outline), equal bits in every scalar, and one start policy. Zeros of either sign are equal.
[[nodiscard]] bool same_input(const corpus::Case& left, const corpus::Case& right);
// The reason why every method must refuse a case ("a vertex outside 1e-60 to 1e60", ...). Empty for a valid one. The
// domain is written from the documentation of the library, not from its code:
//
// - well-formed shapes, finite numbers, each 0 or of magnitude 1e-60 to 1e60, no negative extent, q != 0
// - t_max >= 0 (infinity allowed), target_distance >= 0, a direction if the query needs one
// - rotations of 2^30 radians at most
[[nodiscard]] std::string why_invalid(const corpus::Case& problem);
[[nodiscard]] bool in_domain(const corpus::Case& problem);
[[nodiscard]] bool is_polytope(const corpus::Case& problem);  // both shapes, and no target distance

// a * b where exact.
[[nodiscard]] std::optional<double> exact_product(double a, double b);

// v = v_B - v_A rounded to double, and its length.
[[nodiscard]] Vec3<double> velocity(const corpus::Case& problem);

// A and B exchanged: TOI unchanged, the cone of normals negated.
[[nodiscard]] corpus::Case swapped(const corpus::Case& problem);
// Every length times 2^k: TOI unchanged.
[[nodiscard]] std::optional<corpus::Case> scaled(const corpus::Case& problem, int k);
// Both bodies moved by one vector, chosen among large and small ones, axis by axis, so that every sum is exact. `salt`
// varies the choice. Nothing if no axis can move. TOI unchanged.
[[nodiscard]] std::optional<corpus::Case> translated(const corpus::Case& problem, std::uint64_t salt);
// The shape of A (or B, by `salt`) replaced by a superset (shape.hpp). TOI not later.
[[nodiscard]] corpus::Case grown(const corpus::Case& problem, std::uint64_t salt);
// Linear: C as a hull of vertex differences against a moving point: the ray against the CSO. Exact posed
// vertices only.
[[nodiscard]] std::optional<corpus::Case> ray_against_cso(const corpus::Case& problem);
// Linear: [0, s] and [s, T] restarted from the bodies' places at s, with s in (0, T) dyadic. TOI = TOI_1, or s + TOI_2.
struct Split {
  double at = 0;
  corpus::Case before, after;
};
[[nodiscard]] std::optional<Split> split(const corpus::Case& problem, std::uint64_t salt);

// The edits below are for rotating bodies. Linear cases are accepted as well.
//
// Both bodies and their motion rotated about the origin by one of the rotations that permute the axes. `salt` chooses.
// TOI unchanged.
[[nodiscard]] std::optional<corpus::Case> turned_about(const corpus::Case& problem, std::uint64_t salt);
// x -> -x: rotations change their sense about y and z. TOI unchanged.
[[nodiscard]] corpus::Case mirrored(const corpus::Case& problem);
// T times 2^k, velocities of both kinds times 2^-k: TOI times 2^k.
[[nodiscard]] std::optional<corpus::Case> stretched(const corpus::Case& problem, int k);
// No body rotates. Their other motion is kept.
[[nodiscard]] corpus::Case without_turns(const corpus::Case& problem);
// The body (A for `first`) with a rotation that leaves it where it is, instead of its own. A ball rotates about any
// axis through its centre. A capsule, cylinder, cone or ellipsoid of revolution rotates about its own axis. TOI is that
// of the body without a rotation. Nothing for other shapes, or if the axis in the world is not exact.
[[nodiscard]] std::optional<corpus::Case> with_unseen_turn(const corpus::Case& problem, bool first,
                                                           std::uint64_t salt);
// B's motion replaced by A's, about the same axis: they are at rest relative to each other. Nothing if B's pivot needs
// rounding.
[[nodiscard]] std::optional<corpus::Case> moved_as_one(const corpus::Case& problem);
// The bodies as they are at time s, from where they continue. The numbers are rounded, and no point of them is off by
// more than `error`. The motion differs from the true one by that much at s, and by no more later.
struct Restart {
  double at = 0, error = 0;
  corpus::Case after;
};
[[nodiscard]] std::optional<Restart> restarted(const corpus::Case& problem, double fraction);

// A 64-bit hash of the numbers of a case, the same on every machine. It salts the choices above.
[[nodiscard]] std::uint64_t hash_of(const corpus::Case& problem);

}  // namespace graze::law
