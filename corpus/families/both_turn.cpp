// both_turn: both bodies rotate, with angular velocities that differ by at most 2^-k along each axis. Their
// points are fast and their distance changes slowly. Bounds that add the two speeds are loose by 2^k, and
// bounds that subtract them must know the arms. Hardness: k. Half of the pairs rotate about one point, as one
// body except for that difference. They start within twice that difference of each other, or within 1/4, on
// one side or the other. Half of them approach as well.
#include "corpus/families/families_list.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

void turn_nearly_alike(Draw& draw, double hardness, Case& problem) {
  const double difference = power_of_two(-static_cast<int>(hardness));
  for (int i = 0; i < 3; ++i) {
    // Not rounded to a float: that would be none.
    problem.spin_b.rotation[i] = problem.spin_a.rotation[i] + difference * draw.random.uniform(-1, 1);
  }
}

void as_one(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const Capped below = draw.capped(4), above = draw.capped_below(4);
  problem.a.shape = below.shape;
  problem.b.shape = above.shape;
  const double unit = random.once_in(4) ? 0.25 : power_of_two(-static_cast<int>(hardness));
  const double gap = draw.real(unit * random.uniform(-1, 2));
  problem.a.position = Vec3<double>(0, 0, 0 + (below.lift - above.lift));
  problem.b.position = Vec3<double>(0, 0, gap);
  // Both rotate about one point of A's frame. B's origin is off by a sum that is exact except for the gap.
  const double x = draw.on_grid(16), y = draw.on_grid(16);
  problem.spin_a.pivot = Vec3<double>(x, y, 0);
  problem.spin_b.pivot = problem.spin_a.pivot;
  problem.spin_b.pivot[2] = problem.a.position[2] - gap;
  const Vec3<double> axis = direction(draw);
  const double angle = random.uniform(0.5, 8);
  problem.spin_a.rotation = draw.real(Vec3<double>(angle * axis[0], angle * axis[1], angle * axis[2]));
  turn_nearly_alike(draw, hardness, problem);
  set_motion(draw, problem, Vec3<double>::Zero());
  turn_exactly(draw, problem);
}

void approach(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  problem.a.shape = any_shape(draw, kReach);
  problem.b.shape = any_shape(draw, kReach);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  if (random.once_in(2)) problem.spin_a.pivot = draw.vector(2 * kReach);
  if (random.once_in(2)) problem.spin_b.pivot = draw.vector(2 * kReach);
  Meeting meeting;
  meeting.t = meeting_time(draw);
  meeting.turn_a = meeting.turn_b = some_turn(draw);
  meeting.turns_a = meeting.turns_b = random.integer(0, 2);
  set_motion(draw, problem, draw.vector(16));
  meet(draw, problem, meeting, random.once_in(2) ? 0.25 : kReach);
  turn_nearly_alike(draw, hardness, problem);
}

void fill_both_turn(Draw& draw, double hardness, Case& problem) {
  if (draw.random.once_in(2)) {
    as_one(draw, hardness, problem);
  } else {
    approach(draw, hardness, problem);
  }
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kBothTurnLevels[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40};

}  // namespace

const Family family::both_turn{
    .name = "both_turn",
    .sentence = "Both bodies rotate, nearly as one.",
    .hardness_meaning = "k: the angular velocities differ by at most 2^-k along each axis",
    .levels = kBothTurnLevels,
    .fill = fill_both_turn,
    .rotating = true,
    .picture = {8, 2},
};

}  // namespace graze::corpus
