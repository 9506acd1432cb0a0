// Time-step subdivision: overlap tests at equal steps, and bisection between the last time apart and the first in
// contact. A contact that begins and ends between two tests is missed. `hidden` bounds the motion of every point in
// between.
//
// [The lecture: "simplest implementation: time-step sub-division", slow and may miss, and its idea for MPR, to begin
// where bounding spheres first meet.] Any overlap method can be used. This one is GJK's distance at the noise.
#pragma once

#include <graze/detail/rotating/march.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct StepLimits {
  double begin = 0, end = 1;  // tests at begin, and at every later multiple of end / steps
  int steps = 64;
  double touching = 0;  // internal length
  double width = 0;     // largest distance from contact at the bracket's beginning, if above 2 touching
  int budget = 0;
};

inline March step_through(MovingPair& pair, const StepLimits& limits, Counters& counters) {
  March out;
  Vec3<double> axis = Vec3<double>::Zero();
  Simplex<double> closest;
  const auto touches = [&](double t) {
    ++counters.iterations;
    pair.place(t);
    const Nearest near = nearest(pair, closest, 0, limits.touching / 2, limits.budget, counters);
    if (near.n != Vec3<double>::Zero()) axis = near.n;
    closest = near.simplex;
    if (near.apart <= limits.touching) return true;
    // A search that ended inside C, or at its border, knows no distance.
    if (!(near.gap > 0) &&
        proved_contact(pair, axis, limits.touching, near.simplex, limits.budget, counters).proved)
      return true;
    out.lower = t;
    out.apart = near.apart;
    out.closest = near.simplex;
    out.n = axis;
    return false;
  };
  // By the number of the step: found from t again it could be the step that t is, as quotient and product round.
  const double width = limits.end / limits.steps;
  double t = limits.begin, step = std::floor(t / width);
  while (!touches(t)) {
    if (t >= limits.end) {
      out.outcome = Outcome::miss;
      out.lower = kInfinity<double>;
      return out;
    }
    if (counters.supports >= limits.budget) {
      out.lower = 0;
      return out;
    }
    const double before = t;
    while (step < limits.steps && !(t > before)) t = ++step * width;
    if (!(step < limits.steps)) t = limits.end;
  }
  out.upper = t;
  if (t == 0) {
    out.outcome = Outcome::initially_overlapping;
    return out;
  }
  out.outcome = Outcome::hit;
  if (t == limits.begin) {  // the spheres' first contact is the bodies'
    out.lower = t;
    out.closest = closest;
    out.n = axis != Vec3<double>::Zero() ? axis : away_from_middle(pair);
    return out;
  }
  // Until the bodies are apart by no more than the noise or the width, or no double is between.
  while (out.apart > std::max(2 * limits.touching, limits.width) && counters.supports < limits.budget) {
    const double middle = out.lower + (out.upper - out.lower) / 2;
    if (!(middle > out.lower && middle < out.upper)) break;
    if (touches(middle)) out.upper = middle;
  }
  return out;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
