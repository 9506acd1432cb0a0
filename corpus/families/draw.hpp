// The drawing tools of the families: coordinates of three kinds, shapes, poses, motions.
//
// Grid. Tie families need exact sums. Therefore there are grid coordinates beside the free ones: multiples of
// 2^-10 (float), 2^-30 (double) or 1 (integer), below 2^12 in magnitude. Sums of a few of them are exact.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::corpus {

enum class Coordinates { floats, doubles, integers };

// q x conj(q) / |q|^2 in doubles. It is exact if every product and quotient is.
[[nodiscard]] Vec3<double> rotate(const Quaternion<double>& q, const Vec3<double>& x);
[[nodiscard]] Quaternion<double> multiply(const Quaternion<double>& l, const Quaternion<double>& r);
// The radius of a ball about the body's origin that holds the shape, rounded up.
[[nodiscard]] double bounding_radius(const Shape<double>& shape);
// x rounded to the 24 bits of a float (Veltkamp's splitting, Dekker 1971), for |x| within 2^-126 .. 2^100. A
// conversion to float and back is not used, because g++ 12 at -O2 vectorises three of those in a row and
// drops the rounding.
[[nodiscard]] double round_to_float(double x);
// 10^k, k an integer: exact up to 22, correctly rounded for -22 and above.
[[nodiscard]] double power_of_ten(int k);

// A shape with its highest point on the plane z = 0 once moved by (0, 0, lift), the origin in its top
// feature.
struct Capped {
  Shape<double> shape;
  double lift = 0;
};

class Draw {
 public:
  explicit Draw(std::uint64_t seed);

  Random random;
  Coordinates coordinates;
  std::uint64_t question = 0;  // of a workload: which of the run's

  // Free coordinates, |x| <= reach.
  double coordinate(double reach);
  Vec3<double> vector(double reach);
  // Grid coordinates, |x| <= reach. A positive one is at least a grid step.
  double on_grid(double reach);
  double positive_on_grid(double reach);
  double grid_step() const;
  // x as this kind of coordinate: rounded to float, kept, or rounded to an integer.
  double snap(double x) const;
  Vec3<double> snap(const Vec3<double>& x) const;
  // x as a double or as a float: for angles, which no integer would do for.
  double real(double x) const;
  Vec3<double> real(const Vec3<double>& x) const;

  // Point, sphere, box or hull of `vertices` vertices within |x_i| <= reach.
  Shape<double> shape(double reach, int vertices);
  Shape<double> hull(double reach, int vertices);
  // One of the ten shapes that are not combinators. Each extent is 0.5 .. reach, kept, or times 10^-thinness,
  // or times a power of ten between, or, one in twelve, 0. Shapes with vertices are thinned along an axis.
  Shape<double> leaf(double reach, int thinness);
  // Without corners, or with two at most: what may be summed many times.
  Shape<double> smooth_leaf(double reach, int thinness);
  // Identity half of the time, else four integers of -3..3.
  Quaternion<double> pose();
  // The same, never the identity.
  Quaternion<double> turned_pose();
  // A turn about z by an integer quaternion (w, 0, 0, z): it leaves every z-coordinate as it is, exactly.
  Quaternion<double> pose_about_z();
  // One of the 24 rotations of the cube, as (w, x, y, z) of -1, 0, 1: exact on every double.
  Quaternion<double> cube_rotation();

  // Point, sphere, box, or hull of 4..24 vertices of which 1, 2 or 4 are the top feature. On the grid.
  Capped capped(double reach);
  // As capped, but the plane z = 0 is below: the mirror image at the origin.
  Capped capped_below(double reach);

 private:
  Shape<double> capped_hull(double reach, double lift);
  double thin_extent(double reach, int thinness);
  Vec3<double> thin_extents(double reach, int thinness);
  Shape<double> thin_hull(double reach, int thinness, int vertices);
};

// Gives the relative displacement v to B, or shares it: A gets something and B gets v more, where that is
// exact.
void set_motion(Draw& draw, Case& problem, const Vec3<double>& v);
// A tree of sums, sweeps, hulls of two, roundings and poses, so many deep. The parts that are added in are
// smooth: the vertices of a sum at most double with each level.
Shape<double> nested_shape(Draw& draw, int depth);
// A point of the shape's bounding box: its middle, or the middle of a side.
Vec3<double> middle_or_side(Random& random, const Shape<double>& shape);
// Speeds the motion up by a power of two and shortens t_max by the same, or the other way: the same path.
void vary_time_scale(Draw& draw, Case& problem);
// Turns the whole scene by a cube rotation, exactly: into the poses, or, where they are identities, half of
// the time into boxes, hulls, spheres and points.
void turn_exactly(Draw& draw, Case& problem);
// Turns the whole scene by an integer quaternion. Positions and displacements are rounded to the kind of
// coordinate (floats or doubles).
void turn_rounded(Draw& draw, Case& problem);
// Half of the scenes in doubles are turned rounded, and all others exactly.
void turn_either_way(Draw& draw, Case& problem);
// Puts B on a path that brings a point of B's bounding box to a point of A's. Each point is the middle of the
// box or the middle of a side. The meeting time is in 0 .. 2. The points may miss each other by `miss` at
// most along each axis. A has its pose. B gets its position, v is of length 8 to 40, and the horizon is
// drawn.
void aim(Draw& draw, Case& problem, double miss);
// Places A near the origin and B 8 to 24 away along an axis, one time in ten nearer. Sends B to a point near
// A's middle, far enough off to miss now and then, and not always far enough to arrive. Draws the horizon,
// the scale of time and which body is which. The shapes are 4 in size, and have their poses.
void approach(Draw& draw, Case& problem);
// Swaps A and B once in two.
void maybe_swap(Draw& draw, Case& problem);

}  // namespace graze::corpus
