// The path passes a top feature (vertex, edge, face, or the pole of a sphere) of C at the height delta. Above
// the feature this is a miss with clearance delta. Below it is a hit with depth at most -delta.
//
// Frame of the construction: C's top plane is z = 0, its top feature holds the origin, v is horizontal. At t0
// the path is at (0, 0, delta). B's own z-coordinate is exactly delta, however small. With floats and
// integers the scene is then turned by a rotation of the cube: clearance and depth stay exact. With full
// doubles it is turned by any integer quaternion, and positions are rounded. Then delta is known to within 4
// u times the coordinates (about 16).
#include "corpus/families/placing.hpp"

namespace graze::corpus {

void pass_top_feature(Draw& draw, Case& problem, double delta) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  const Capped a = draw.capped(kReach), b = draw.capped_below(kReach);
  problem.a.shape = a.shape;
  problem.b.shape = b.shape;
  if (random.once_in(3)) problem.a.orientation = draw.pose_about_z();
  if (random.once_in(3)) problem.b.orientation = draw.pose_about_z();

  // Far enough to start and end apart, if it misses the plane's feature: 16 exceeds the sum of the reaches.
  const double t0 = 0.25 * random.integer(1, 3);
  Vec3<double> v(draw.on_grid(32), 0, 0);
  v[1] = draw.on_grid(32);
  const int axis = random.integer(0, 1);
  const double along = 64 + draw.positive_on_grid(32);
  v[axis] = random.once_in(2) ? along : -along;
  if (random.once_in(4)) v[1 - axis] = 0;

  problem.a.position = Vec3<double>(0, 0, 0 + (a.lift - b.lift));
  problem.b.position = Vec3<double>(0 - t0 * v[0], 0 - t0 * v[1], delta);
  set_motion(draw, problem, v);
  if (random.once_in(16)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
  if (draw.coordinates == Coordinates::doubles) {
    turn_rounded(draw, problem);
  } else {
    turn_exactly(draw, problem);
  }
  maybe_swap(draw, problem);
}

}  // namespace graze::corpus
