// Does one axis part two bodies for a whole step? A test of one or two supports for each body, with every rounding
// counted, and a search for such an axis.
#pragma once

#include <graze/result.hpp>
#include <graze/rotating_body.hpp>
#include <graze/rotating_proof.hpp>

namespace graze::scene {

// Unit, from A to B: fixed in the world, or turning with a body, then in the body's own axes.
struct PartingAxis {
  Vec3<double> axis = Vec3<double>::Zero();  // 0: none
  AxisFrame frame = AxisFrame::world;

  [[nodiscard]] bool is_known() const { return axis != Vec3<double>::Zero(); }
};

struct StepLimits {
  double t_end = 1, target_distance = 0, tolerance = 0;
};

// The bodies stay farther apart than the target distance over [0, t_end] along `hint`; or else along an axis that a
// short search from there finds, which hint then is. By more than any method's rounding and the width of any tier's
// answer, so that the pair's cast is a miss too. False: nothing is known. The bodies are valid.
[[nodiscard]] bool stays_apart(const RotatingBody<double>& a, const RotatingBody<double>& b,
                               const StepLimits& limits, PartingAxis& hint, Counters& counters);

}  // namespace graze::scene
