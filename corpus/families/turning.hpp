// The drawing tools of the rotating families: turns, and the place of a rotating body.
//
// A body that rotates by |w| radians has a pose with cos |w| and sin |w|, and no library gives these to the
// same bits everywhere. So a turn is drawn as an integer quaternion q. Its angle, 2 atan(|q.xyz| / q.w), is
// summed here. At a drawn time, the body then has the rational pose q, to within the rounding of its rotation
// vector.
#pragma once

#include "corpus/families/draw.hpp"

namespace graze::corpus {

inline constexpr double kPi = 0x1.921fb54442d18p+1;  // to nearest

// The angle of the turn q, in 0 .. 2 pi, to within a few units in the last place.
[[nodiscard]] double angle_of(const Quaternion<double>& q);
// q's axis times (its angle + 2 pi turns). It is 0 if there is no turn at all.
[[nodiscard]] Vec3<double> rotation_vector(const Quaternion<double>& q, int turns);
// A unit vector, to rounding, among the directions that integers of -3 .. 3 turn z to.
[[nodiscard]] Vec3<double> direction(Draw& draw);
// Four integers of -3 .. 3 that turn by something.
[[nodiscard]] Quaternion<double> some_turn(Draw& draw);
// About x: it leaves every x-coordinate as it is, exactly.
[[nodiscard]] Quaternion<double> turn_about_x(Draw& draw);

// Leaf or, one in four, a tree of combinators.
[[nodiscard]] Shape<double> any_shape(Draw& draw, double reach);

// Both bodies at a time t, each turned by q since t = 0.
struct Meeting {
  double t = 0.5;
  Quaternion<double> turn_a, turn_b;
  int turns_a = 0, turns_b = 0;  // whole ones before that
};
// Gives the bodies the rotations of the meeting. B gets the position that brings a point of its bounding box
// to one of A's at that time, or beside it by `miss` at most along each axis. The other poses and motions are
// given.
void meet(Draw& draw, Case& problem, const Meeting& meeting, double miss);
// One of a few times of the step [0, 1] and after its end: a turn is over a quarter of it at the least.
[[nodiscard]] double meeting_time(Draw& draw);
// A horizon of 1, one in six of 1/2 or 2. Then the same path in another time (vary_time_scale).
void vary_horizon(Draw& draw, Case& problem);

// A body that rotates about x through its origin and reaches no further from it than `reach`, which `feature`
// does.
struct Spinner {
  Shape<double> shape;
  double reach = 0;
  Vec3<double> feature = Vec3<double>::Zero();
};
[[nodiscard]] Spinner spinner(Draw& draw);

// A spinner whose feature passes, at the height delta below it, a body that rests, slides or turns on the
// plane above. A negative delta is the depth that they reach. The feature passes once if |angle| < 2 pi. The
// angle is drawn between the two bounds and is at least 3.7.
void spin_past(Draw& draw, Case& problem, double delta, double least_angle, double most_angle);

}  // namespace graze::corpus
