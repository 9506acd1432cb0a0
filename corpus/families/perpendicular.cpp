// perpendicular: v makes an angle of 10^-k with the face that it would hit. Now and then it lies in the
// face's plane. Hardness: k.
//
// Frame: C's top face is z = 0, of a half width of about 4 to 400, and holds the origin. v = (v_x, v_y, -w)
// with w = 10^-k |(v_x, v_y)|, and B's own z-coordinate is exactly w t_c. The path passes the face's plane at
// the time t_c, and the origin, or the point above or below it, at t0. It hits the face if it comes through
// the plane over the face. It hits the side in front if it comes through sooner. If it comes through later,
// it misses by a clearance of about 10^-k times the width.
//
// Difficulties:
//   - n.v is a difference that cancels, and a time found by dividing by it loses k digits,
//   - a bound on it ("if |n.v| < epsilon: parallel, no hit") is wrong however it is chosen,
//   - a portal of the line along v lies edge on.
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/topped.hpp"

namespace graze::corpus {
namespace {

void fill_perpendicular(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;  // size of the smaller body (length)
  Random& random = draw.random;
  const double width = kReach * power_of_ten(random.integer(0, 2));
  const double x = draw.positive_on_grid(width), y = draw.positive_on_grid(width);
  const double z = draw.positive_on_grid(kReach);
  Topped a{Box<double>{Vec3<double>(x, y, z)}, {}, Vec3<double>(0, 0, -z)};
  Topped b = random.once_in(2)   ? topped_face(draw, kReach)
             : random.once_in(2) ? topped_edge(draw, kReach, edge_vector(draw))
                                 : topped_vertex(draw, kReach);
  if (random.once_in(3)) turn_about_z(draw, a);
  if (random.once_in(3)) turn_about_z(draw, b);

  const double reach = std::floor(reach_of(a) + reach_of(b)) + 1;
  const double t0 = 0.125 * random.integer(3, 5);
  Vec3<double> v;
  const int axis = random.integer(0, 1);
  const double along = 3 * reach + draw.positive_on_grid(reach);
  const double across = random.once_in(4) ? 0 : draw.on_grid(reach);
  v[axis] = random.once_in(2) ? along : -along;
  v[1 - axis] = across;
  const double unit = power_of_ten(-static_cast<int>(hardness));
  const double speed = std::sqrt(along * along + across * across);
  const double sink = random.once_in(16) ? 0 : unit * speed;
  // The face is passed within x / |v_x| and y / |v_y| of t0, whichever is less.
  const double half = std::min(x / std::max(std::abs(v[0]), 1.0), y / std::max(std::abs(v[1]), 1.0));
  const double crossing = t0 + half * random.uniform(-1.5, 3);
  // In the plane of the face: through it, above it or below.
  const double level = sink == 0 ? unit * random.integer(-1, 1) : sink * crossing;
  const bool floats = draw.coordinates == Coordinates::floats;
  v[2] = floats ? 0 - round_to_float(sink) : 0 - sink;

  const Topped below = mirrored(b);
  problem.a.shape = a.shape;
  problem.a.orientation = a.orientation;
  problem.a.position = a.position - below.position;
  problem.b.shape = below.shape;
  problem.b.orientation = below.orientation;
  problem.b.position = Vec3<double>(0 - t0 * v[0], 0 - t0 * v[1], floats ? round_to_float(level) : level);
  set_motion(draw, problem, v);
  finish_exactly(draw, problem);
}

constexpr double kPerpendicularLevels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

}  // namespace

const Family family::perpendicular{
    .name = "perpendicular",
    .sentence = "The motion lies nearly in the face that would be hit.",
    .hardness_meaning = "k: the angle between motion and face is 10^-k radians; one case in 16 has 0",
    .levels = kPerpendicularLevels,
    .fill = fill_perpendicular,
    .picture = {2, 1},
};

}  // namespace graze::corpus
