// random_rotating: two bodies of any shapes with moderate motion, rotating by a turn or two at most.
// Hardness: the nesting depth of combinators in one of them, 0 without combinators. One in six only spins,
// one body in four does not rotate, pivots are anywhere.
#include "corpus/families/families_list.hpp"
#include "corpus/families/turning.hpp"

namespace graze::corpus {
namespace {

void fill_random_rotating(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  const int depth = static_cast<int>(hardness);
  const auto plain = [&] {
    if (random.once_in(3)) return draw.shape(kReach, random.integer(4, 16));
    return draw.leaf(kReach, random.once_in(4) ? 2 : 0);
  };
  problem.a.shape = depth == 0 ? plain() : nested_shape(draw, depth);
  problem.b.shape = plain();
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  for (Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    if (random.once_in(2)) spin->pivot = draw.vector(random.once_in(4) ? 16 : kReach);
  }
  Meeting meeting;
  meeting.t = meeting_time(draw);
  if (!random.once_in(4)) meeting.turn_a = some_turn(draw);
  if (!random.once_in(4)) meeting.turn_b = some_turn(draw);
  const bool still = random.once_in(6);
  const Vec3<double> v = draw.vector(16);
  set_motion(draw, problem, still ? Vec3<double>::Zero() : v);
  meet(draw, problem, meeting, random.once_in(2) ? 0.25 : kReach);
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kRandomRotatingLevels[] = {0, 1, 2, 3};

}  // namespace

const Family family::random_rotating{
    .name = "random_rotating",
    .sentence = "Any two shapes, rotating and moving at moderate speed.",
    .hardness_meaning = "how deep the combinators of one body are nested; 0 for none",
    .levels = kRandomRotatingLevels,
    .fill = fill_random_rotating,
    .rotating = true,
    .picture = {1, 1},
};

}  // namespace graze::corpus
