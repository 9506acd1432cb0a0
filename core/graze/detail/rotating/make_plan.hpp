// Decides which simulation a pair needs: none, a static query, a linear cast, or a rotating cast.
//
// Internal lengths. A rotation is negligible if it moves no point of the body, as a set, by more than `noise` from
// its position in the linear motion. C is then the linear cast's C' within the tier's kappa u scale. In tier
// certified only 0 is below noise. No plan depends on the tolerance.
#pragma once

#include <graze/detail/numeric/vectors.hpp>
#include <graze/detail/rotating/spheres.hpp>
#include <graze/rotating_result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct PlanLimits {
  double t_end = 1;  // may be infinite
  double noise = 0;  // internal length
};

// Neither body rotates: no bounds of rotating points are needed.
template <Scalar S>
Plan plan_without_rotation(const RotatingBody<S>& a, const RotatingBody<S>& b, const Economies& economies) {
  Plan out;
  out.add(PlanReason::no_rotation);
  out.effects = Effects::linear;
  if (economies.at_rest && a.body.displacement == b.body.displacement) {
    out.add(PlanReason::nothing_moves);
    out.effects = Effects::at_rest;
  }
  return out;
}

// Both bodies rotate equally about one axis, and translate equally. They are at rest relative to each other, except
// that the pivots' difference c swings: |c x w| / |w| times the chord of the rotation.
inline double swing_as_one(const MovingPair& pair, double t_end) {
  const Mobility &a = pair.mobility_a(), &b = pair.mobility_b();
  if (a.w != b.w || pair.velocity() != Vec3<double>::Zero()) return kInfinity<double>;
  const double across = pair.pivot_drift(a) / norm(a.w) * (1 + 8 * kUnitRoundoff<double>);
  return std::min(a.rate * t_end, 2.0) * across;
}

// Is the pivots' difference exactly parallel to w, by which both bodies rotate? The rounding of two doubles is
// resolved in dyadic numbers: a posed pivot is rational (numeric/vectors.hpp).
template <Scalar S>
bool swing_about_one_line(const RotatingBody<S>& a, const RotatingBody<S>& b) {
  const auto pivot_of = [](const RotatingBody<S>& moving) {
    exact::Exact out = exact::Exact::of(wide(moving.pivot));
    if (!moving.body.orientation.is_identity()) exact::ExactTurn{as_double(moving.body.orientation)}(out);
    out.add(exact::Exact::of(wide(moving.body.position)), false);
    return out;
  };
  exact::Exact apart = pivot_of(b);
  apart.add(pivot_of(a), true);
  const exact::Dyadic3 w = exact::Exact::of(wide(a.rotation)).x;
  for (const exact::Dyadic& one : exact::cross(apart.x, w)) {
    if (!one.valid() || one.sign() != 0) return false;
  }
  return true;
}

// Do the bodies rotate as one within the noise, or exactly if the noise is 0?
template <Scalar S>
bool turn_as_one(const MovingPair& pair, const RotatingBody<S>& a, const RotatingBody<S>& b,
                 const PlanLimits& limits) {
  const double swing = swing_as_one(pair, limits.t_end);
  if (swing <= limits.noise) return true;
  // A chord is at most 2. A swing of more than the rounding error is a swing.
  return swing <= 4 * pair.drift_lost() && swing_about_one_line(a, b);
}

template <Scalar S>
Plan plan_of(const MovingPair& pair, const RotatingBody<S>& a_given, const RotatingBody<S>& b_given,
             const Economies& economies, const PlanLimits& limits) {
  Plan out;
  const Mobility &a = pair.mobility_a(), &b = pair.mobility_b();
  if (economies.bounds && !cast_spheres(pair, limits.t_end, limits.noise).meet) {
    out.effects = Effects::nothing;
    out.add(PlanReason::bounds_never_meet);
    return out;
  }
  if (economies.as_one && turn_as_one(pair, a_given, b_given, limits)) {
    out.effects = Effects::at_rest;
    out.add(PlanReason::as_one);
    return out;
  }
  const double rotation_displacement_a = a.rotation_displacement(limits.t_end),
               rotation_displacement_b = b.rotation_displacement(limits.t_end);
  const bool unseen_a = economies.unseen_spin && rotation_displacement_a <= limits.noise / 2;
  const bool unseen_b = economies.unseen_spin && rotation_displacement_b <= limits.noise / 2;
  const bool seen_a = a.turns() && !unseen_a, seen_b = b.turns() && !unseen_b;
  if (a.turns() && unseen_a) out.add(PlanReason::unseen_spin_a);
  if (b.turns() && unseen_b) out.add(PlanReason::unseen_spin_b);
  if (!seen_a && !seen_b) {
    const bool still = pair.velocity() == Vec3<double>::Zero();
    out.effects = still && economies.at_rest ? Effects::at_rest : Effects::linear;
    if (out.effects == Effects::at_rest) out.add(PlanReason::nothing_moves);
    return out;
  }
  out.effects = Effects::rotating;
  if (seen_a) out.add(PlanReason::rotation_a);
  if (seen_b) out.add(PlanReason::rotation_b);
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
