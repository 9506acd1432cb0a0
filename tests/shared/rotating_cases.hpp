// Small rotating cases whose answer is known.
#pragma once

#include "corpus/case.hpp"

namespace graze::test {

// A bar, 2 long and 1/2 thick, that turns about the z axis through its middle by pi/2, above a floor whose
// top is at y = -0.7. Its lower edge is at y = -(sin w t + cos(w t)/4): contact where sin + cos/4 = 0.7, then
// 1/4 + deep.
inline corpus::Case turning_bar() {
  corpus::Case problem;
  problem.id = "test/turning-bar";
  problem.a.shape = Box<double>{{1, 0.25, 0.25}};
  problem.spin_a.rotation = {0, 0, 1.5707963267948966};
  problem.b.shape = Box<double>{{2, 0.5, 2}};
  problem.b.position = {0, -1.2, 0};
  return problem;
}

// The same with the floor 0.1 below the bar's reach.
inline corpus::Case turning_bar_above() {
  corpus::Case problem = turning_bar();
  problem.id = "test/turning-bar-above";
  problem.b.position = {0, -1.65, 0};
  return problem;
}

// Its corners, at sqrt(1 + 1/16) from the axis, dip into the floor by 0.03 around t = 1/2. At both ends of
// the step it is far from the floor.
inline corpus::Case dipping_bar() {
  corpus::Case problem = turning_bar();
  problem.id = "test/dipping-bar";
  problem.spin_a.rotation = {0, 0, 3.1415926535897931};
  problem.b.position = {0, -1.5, 0};
  return problem;
}

// A ball that spins in its place as it falls onto a box: the spin cannot be seen. Contact at t = 0.1.
inline corpus::Case spinning_ball() {
  corpus::Case problem;
  problem.id = "test/spinning-ball";
  problem.a.shape = Box<double>{{1, 1, 0.125}};
  problem.b.shape = Sphere<double>{0.25};
  problem.b.position = {0.125, 0.25, 1.375};
  problem.b.displacement = {0, 0, -10};
  problem.spin_b.rotation = {3, 4, 0};
  return problem;
}

}  // namespace graze::test
