// Computes the distance of the bodies as placed, with an axis that proves it: GJK, started from another time's
// result.
//
// Internal lengths. The gap is the distance less the target distance. The rounding is subtracted from its lower
// bound, so a positive gap is proved.
#pragma once

#include <graze/detail/rotating/fast_nearest.hpp>
#include <graze/detail/rotating/moving_pair.hpp>
#include <graze/detail/search/robust/refine_axis.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct Nearest {
  double gap = 0;                         // lower bound of the distance, less the target distance
  double apart = 0;                       // upper bound
  Vec3<double> n = Vec3<double>::Zero();  // unit, from A to B, proves the gap, or zero if nothing does
  Simplex<double> simplex;
  // The search ended as the balls about the cores met: neither n nor the simplex is that of the least
  // distance.
  bool met = false;
};

// The same features at their present positions. A search that begins with them takes a step or two.
inline Simplex<double> carried_over(const MovingPair& pair, const Simplex<double>& before) {
  const Cso<double>& cso = pair.cso();
  const auto &a = cso.side_a(), &b = cso.side_b();
  Simplex<double> out;
  for (std::size_t i = 0; i < static_cast<std::size_t>(before.size); ++i) {
    CsoPoint<double> p = before.point[i];
    const Vec3<double> d_b = -p.n;
    p.w = a.to_world(a.support(a, a.to_own(p.n), &p.vertex_a).x) -
          (b.to_world(b.support(b, b.to_own(d_b), &p.vertex_b).x) + cso.offset());
    out.add(p);
  }
  return out;
}

// The closest point on B, from A's pivot, as the pair is placed.
inline Vec3<double> closest_on_b(const MovingPair& pair, const Simplex<double>& closest) {
  const auto& side_b = pair.cso().side_b();
  Vec3<double> b = Vec3<double>::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(closest.size); ++i) {
    const CsoPoint<double>& p = closest.point[i];
    const Vec3<double> d_b = -p.n;
    b += closest.lambda[i] * side_b.support(side_b, side_b.to_own(d_b), &p.vertex_b).x;
  }
  return side_b.to_world(b) + pair.center_b();
}

// `before`: the closest points at some other time, or empty. `expected`: a known lower bound of the gap. A larger
// bound allows a rougher search. `stop`: the gap at which the search may stop.
inline Nearest nearest(const MovingPair& pair, const Simplex<double>& before, double expected, double stop,
                       int budget, Counters& counters) {
  Nearest out;
  out.simplex = carried_over(pair, before);
  const Cso<double>& cso = pair.cso();
  const double R = pair.radius(), error = pair.error();
  const auto support = [&](const Vec3<double>& n) { return cso.support(n); };
  const double close_enough = std::max(stop / 16, expected / 16);
  Distance<double> d;
  const auto search = [&](double loose) {
    return gjk_distance(support, Vec3<double>(Vec3<double>::Zero()), Vec3<double>(-cso.middle()), out.simplex,
                        close_enough, R, budget, counters, loose);
  };
  if (!fast_distance(cso, out.simplex, close_enough, R, budget, d, counters)) {
    out.simplex = carried_over(pair, before);
    d = search(kNearestPart * std::max(d.lower - R, 0.0));
  }
  // A simplex that was closest at another time may be a sliver now, which leads nowhere.
  if (d.stalled && d.upper - d.lower > std::max(stop / 4, expected / 4) && before.size > 0) {
    out.simplex = {};
    d = search(0);
  }
  if (d.stalled && d.upper - d.lower > stop / 4 && d.upper > R) {
    SweepLimits<double> limits;
    limits.noise = stop / 4;
    limits.budget = budget;
    steady_axis(d, cso, out.simplex, limits, counters);
  }
  out.apart = std::max(d.upper - R, 0.0) + error;
  out.gap = d.lower - R - error;
  out.met = R > 0 && d.upper <= R;
  out.n = d.n;
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
