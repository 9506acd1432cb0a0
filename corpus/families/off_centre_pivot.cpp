// off_centre_pivot: a body turns about a point 2^k sizes away, by an arc of a few sizes or by any part of a
// turn. Spheres about the pivot hold all that the arm sweeps, and the angular bound is the arm's, not the
// body's. Hardness: k.
#include "corpus/families/families_list.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

void fill_off_centre_pivot(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  const double arm = kReach * power_of_two(static_cast<int>(hardness));
  problem.a.shape = any_shape(draw, kReach);
  problem.b.shape = any_shape(draw, kReach);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  const Vec3<double> way = direction(draw);
  problem.spin_b.pivot = draw.snap(Vec3<double>(arm * way[0], arm * way[1], arm * way[2]));
  if (random.once_in(3)) problem.spin_a.pivot = draw.vector(kReach);

  Meeting meeting;
  meeting.t = meeting_time(draw);
  meeting.turn_b = some_turn(draw);
  // An arc of a few sizes: the turn's half angle is |q.xyz| / q.w or so.
  if (!random.once_in(3)) meeting.turn_b.w = random.integer(1, 3) * power_of_two(static_cast<int>(hardness));
  if (random.once_in(3)) meeting.turn_a = some_turn(draw);
  const bool still = random.once_in(3);
  const Vec3<double> v = draw.vector(16);
  set_motion(draw, problem, still ? Vec3<double>::Zero() : v);
  meet(draw, problem, meeting, random.once_in(2) ? 0.25 : kReach);
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kOffCentrePivotLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 10};

}  // namespace

const Family family::off_centre_pivot{
    .name = "off_centre_pivot",
    .sentence = "A body rotates about a point far outside.",
    .hardness_meaning = "k: the pivot is 2^k sizes of 4 from the body's origin",
    .levels = kOffCentrePivotLevels,
    .fill = fill_off_centre_pivot,
    .rotating = true,
    .picture = {4, 4},
};

}  // namespace graze::corpus
