// enters_and_leaves: apart at both ends of the step, in contact for about 2^-k of it, or less. Hardness: k.
// Half of them spin: a feature dips below a plane, as in spinning_graze, by so much that it is back after
// that time. Half are shot: 2^k sizes in the step, past a body, both turning.
#include "corpus/families/families_list.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

void shoot(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 2;
  Random& random = draw.random;
  problem.a.shape = any_shape(draw, kReach);
  problem.b.shape = any_shape(draw, kReach);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  if (random.once_in(3)) problem.spin_a.pivot = draw.vector(kReach);
  if (random.once_in(3)) problem.spin_b.pivot = draw.vector(kReach);

  Meeting meeting;
  meeting.t = 0.25 * random.integer(1, 3);
  meeting.turn_a = draw.pose();
  meeting.turn_b = some_turn(draw);
  const double way = 16 * power_of_two(static_cast<int>(hardness));
  const Vec3<double> along = direction(draw);
  set_motion(draw, problem, draw.real(Vec3<double>(way * along[0], way * along[1], way * along[2])));
  // Close: the boxes' sides are on or in the shapes, nearly.
  meet(draw, problem, meeting, random.once_in(4) ? 2 * kReach : 0.125);
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

void fill_enters_and_leaves(Draw& draw, double hardness, Case& problem) {
  if (draw.random.once_in(2)) {
    shoot(draw, hardness, problem);
    return;
  }
  // A feature at the distance r from the axis, turning by w, is below a plane at r - d for the fraction
  // 2 sqrt(2 d / r) / w of the step, nearly. With r of 2 .. 8 and w of 3.7 .. 5.8: 2^-k times 0.6 to 1.9.
  const double part = power_of_two(-static_cast<int>(hardness));
  spin_past(draw, problem, -12.5 * part * part, 3.7, 5.8);
}

constexpr double kEntersAndLeavesLevels[] = {2, 4, 6, 8, 10, 12, 14, 16};

}  // namespace

const Family family::enters_and_leaves{
    .name = "enters_and_leaves",
    .sentence = "Apart at both ends of the step, in contact in between.",
    .hardness_meaning = "k: the contact lasts about 2^-k of the step, or less",
    .levels = kEntersAndLeavesLevels,
    .fill = fill_enters_and_leaves,
    .rotating = true,
    .picture = {6, 1},
};

}  // namespace graze::corpus
