// The two linear casts on top of GJK: conservative advancement, and the ray cast on the CSO.
//
// Both walk along the path s r by axes. A unit n with h(n) + R < n.(s r) proves that no contact is before
//   s' = s + (n.(s r) - h(n) - R) / -(n.r)      when n.r < 0,     and none at all when n.r >= 0.
// s is never later than what some axis proves, up to rounding. Both stop at contact, |v| <= R + noise. Within the
// caller's tolerance they stop if the current simplex closes the bracket from above. A portal closes it if the search
// did not converge.
#pragma once

#include <graze/detail/search/robust/mpr.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// One advance. Returns false if the cast is decided: out.outcome is a miss.
template <Scalar S>
bool advance(Sweep<S>& out, const Vec3<S>& r, const Vec3<S>& n, S apart, S s_max) {
  // An axis that separates: no length, or none, would prove a miss.
  GRAZE_ASSERT(apart > 0 && std::abs(squared_norm(n) - 1) < S(kNearUnit));
  const S closing = -dot(n, r);
  const S next = out.lower + apart / closing;
  if (!(closing > 0) || next > s_max) {
    out.outcome = Outcome::miss;
    out.n = n;
    return false;
  }
  if (next > out.lower) {
    out.lower = next;
    out.n = n;
  }
  return true;
}

// On a rounded C the contact is where the core's closest point looks towards x, which is known to u. The axis that
// proved the bound is known only to the root of u, as every supporting normal of a curved surface is.
template <Scalar S>
void point_at(Simplex<S>& contact, const Vec3<S>& x) {
  Vec3<S> towards = x;
  for (std::size_t i = 0; i < static_cast<std::size_t>(contact.size); ++i) {
    towards -= contact.lambda[i] * contact.point[i].w;
  }
  const Vec3<S> e = unit(towards);
  for (std::size_t i = 0; i < static_cast<std::size_t>(contact.size); ++i) contact.point[i].e = e;
}

// Within the caller's tolerance of contact: does the path ahead of x = lower r meet the simplex, which is in C? On a rounded C
// the simplex's point nearest to x is the centre of a ball of radius R. Else a triangle may lie across the path. The path must
// pass inside by more than the noise, so that no axis can separate them: the verdict is the one without a tolerance. This
// takes no support.
template <Scalar S>
bool closes_in_hand(Sweep<S>& out, const Cso<S>& cso, const SweepLimits<S>& limits, S apart) {
  if (!(limits.target > limits.noise) || !(out.lower > 0) || !(apart <= limits.target)) return false;
  const Vec3<S>& r = cso.direction();
  const Vec3<S> x = out.lower * r;
  const S R = cso.radius(), speed = norm(r);
  const Simplex<S>& simplex = out.contact;
  S ahead = kInfinity<S>;  // of s
  std::array<S, 3> weights{};
  if (R > 0) {
    Vec3<S> v = -x;
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.size); ++i)
      v += simplex.lambda[i] * simplex.point[i].w;
    // |ahead r - v| = R, by twice the areas that v spans with r: nothing cancels at a graze.
    const S along = dot(v, r), off = squared_norm(cross(v, r)), inner = R - limits.noise;
    if (along > 0 && inner > 0 && off < speed * speed * inner * inner)
      ahead = (along - square_root(fl(speed * speed * R * R) - off)) / (speed * speed);
  } else if (simplex.size == 3) {
    S sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3<S> p = simplex.point[(i + 1) % 3].w - x, q = simplex.point[(i + 2) % 3].w - x;
      weights[i] = dot(r, cross(p, q));
      sum += weights[i];
    }
    if (!(std::abs(sum) > 0)) return false;
    Vec3<S> v = Vec3<S>::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      // Seen along r, a corner's weight is the path's distance from the other edge over the corner's height above it.
      const S edge = norm(simplex.point[(i + 1) % 3].w - simplex.point[(i + 2) % 3].w);
      const S inside = std::copysign(weights[i], weights[i] * sum);
      if (!(inside > limits.noise * speed * edge)) return false;
      weights[i] /= sum;
      v += weights[i] * (simplex.point[i].w - x);
    }
    ahead = dot(v, r) / (speed * speed);
    if (!(norm(v - ahead * r) <= limits.noise / 4)) return false;
  }
  if (!(ahead >= 0 && ahead * speed <= limits.target)) return false;
  // Neither the start nor the end of the path is within rounding.
  if (!(out.lower * speed > 2 * limits.noise)) return false;
  if (!(fl((out.lower + ahead) * speed) + limits.noise < limits.s_max * speed)) return false;
  out.outcome = Outcome::hit;
  out.upper = out.lower + ahead;
  out.apart = apart;
  if (R > 0) {
    point_at(out.contact, x);
  } else {
    for (std::size_t i = 0; i < 3; ++i) out.contact.lambda[i] = weights[i];
  }
  return true;
}

// At the noise the simplex itself is the contact. If the search did not converge, only a portal can tell whether the
// path continues to a hit.
template <Scalar S>
void close_from_above(Sweep<S>& out, const Cso<S>& cso, const SweepLimits<S>& limits, S apart,
                      Counters& counters) {
  out.apart = apart;
  if (apart <= limits.noise) {
    out.outcome = out.lower > 0 ? Outcome::hit : Outcome::initially_overlapping;
    out.upper = out.lower;
    if (cso.radius() > 0) point_at(out.contact, Vec3<S>(out.lower * cso.direction()));
    return;
  }
  const int iterations = counters.iterations;
  const Sweep<S> above = mpr_sweep(cso, limits, counters);
  counters.iterations = iterations;
  // Near a graze GJK and MPR may differ by rounding. If MPR reports a miss, a later lower bound, or a contact before
  // ours, its answer is returned whole, since a bracket with ends from two searches may be invalid.
  if (above.outcome == Outcome::miss || above.lower > out.lower || above.upper < out.lower) {
    out = above;
    return;
  }
  out.outcome = above.outcome;
  out.contact = above.contact;
  out.upper = above.upper;
}

// Distance, advance, distance, ... [Mirtich 1996, and the lecture]. It differs from the lecture in three points. The
// loop runs while the shapes are apart, not while they are near. An axis along which they do not approach proves a
// miss and divides nothing. The path's end is checked before a contact is claimed.
template <Scalar S>
Sweep<S> conservative_advancement(const Cso<S>& cso, const SweepLimits<S>& limits, S s_begin,
                                  const Vec3<S>& n_begin, Counters& counters) {
  Sweep<S> out;
  out.lower = s_begin;
  out.n = n_begin;
  const Vec3<S>& r = cso.direction();
  const S R = cso.radius();
  S apart = kInfinity<S>;
  while (counters.supports < limits.budget) {
    ++counters.iterations;
    const Vec3<S> x = out.lower * r;
    const Distance<S> d =
        gjk_distance(cso, x, out.contact, limits.fine(), R + limits.fine(), limits.budget, counters);
    apart = d.upper - R;
    // The bodies are near enough. Or they are near and no axis separates any more, because of rounding at a contact
    // or because the search did not converge.
    const S least = apart <= limits.noise ? limits.fine() : S(0);
    if (apart <= limits.fine() || !(d.lower - R > least)) break;
    if (closes_in_hand(out, cso, limits, apart)) return out;
    if (!advance(out, r, d.n, S(d.lower - R), limits.s_max)) return out;
    apart = kInfinity<S>;  // not known there
  }
  close_from_above(out, cso, limits, apart, counters);
  return out;
}

// Each support point clips the path at once, instead of after a converged distance. [van den Bergen, Ray
// Casting against General Convex Objects with Application to Continuous Collision Detection, 2004] Differs:
// the simplex keeps points of C, not of C - x, so nothing is translated as x moves.
template <Scalar S>
Sweep<S> gjk_ray_cast(const Cso<S>& cso, const SweepLimits<S>& limits, S s_begin, const Vec3<S>& n_begin,
                      Counters& counters) {
  Sweep<S> out;
  out.lower = s_begin;
  out.n = n_begin;
  const Vec3<S>& r = cso.direction();
  const S R = cso.radius();
  Vec3<S> x = out.lower * r;
  Simplex<S>& simplex = out.contact;
  simplex.add(cso.support(x - cso.middle()));
  ++counters.supports;
  S nearest = kInfinity<S>, apart = kInfinity<S>;
  // If rounding or a smooth surface prevents convergence, a portal takes the rest of the budget.
  while (counters.supports < limits.budget - limits.budget / 4) {
    ++counters.iterations;
    const Closest<S> closest = closest_to_origin(simplex, x);
    ++counters.gjk_iterations;
    reduce(simplex, closest);
    const S distance = square_root(closest.dist_sq);
    apart = distance - R;
    if (apart <= limits.fine() || simplex.size == 4 || closest.n == Vec3<S>::Zero()) break;
    if (closes_in_hand(out, cso, limits, apart)) return out;
    const CsoPoint<S> next = cso.support(closest.n);
    ++counters.supports;
    const S clear = dot(closest.n, x - next.w) - R;
    const S before = out.lower;
    // As above: of a contact that x has passed by rounding an axis tells that it lies behind.
    const S least = apart <= limits.noise ? limits.fine() : S(0);
    if (clear > least && !advance(out, r, closest.n, clear, limits.s_max)) return out;
    const bool moved = out.lower > before;
    // No advance, no new point, or no nearer: the simplex has nothing more to tell.
    if (!moved && (simplex.holds(next) || !(distance < nearest))) break;
    nearest = moved ? kInfinity<S> : distance;
    if (moved) apart = kInfinity<S>;  // not known there
    x = out.lower * r;
    if (!simplex.holds(next)) simplex.add(next);
  }
  close_from_above(out, cso, limits, apart, counters);
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
