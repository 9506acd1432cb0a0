// slow_spin: a linear cast except for a turn of 2^-k radians over the step. Hardness: k. Half of them pass a
// top feature at a height of 2^-k, as in grazing, so that the turn affects the verdict. Half are aimed
// anywhere.
#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"
#include "corpus/families/turning.hpp"

#include <cmath>

namespace graze::corpus {
namespace {

void aim_anywhere(Draw& draw, Case& problem) {
  constexpr double kReach = 4;
  problem.a.shape = any_shape(draw, kReach);
  problem.b.shape = any_shape(draw, kReach);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  aim(draw, problem, draw.random.once_in(2) ? kReach : 0.25);
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

void fill_slow_spin(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double angle = power_of_two(-static_cast<int>(hardness));
  if (random.once_in(2)) {
    pass_top_feature(draw, problem, draw.real(angle * random.uniform(-4, 4)));
  } else {
    aim_anywhere(draw, problem);
  }
  // A step ends where a body turns.
  if (std::isinf(problem.t_max)) problem.t_max = 1;
  const auto spin = [&](Spin& body) {
    const Vec3<double> axis = direction(draw);
    for (int i = 0; i < 3; ++i) body.rotation[i] = draw.real(angle / problem.t_max * axis[i]);
    if (random.once_in(2)) body.pivot = draw.vector(8);
  };
  if (random.once_in(2)) {
    spin(problem.spin_a);
    if (random.once_in(2)) spin(problem.spin_b);
  } else {
    spin(problem.spin_b);
  }
}

constexpr double kSlowSpinLevels[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40};

}  // namespace

const Family family::slow_spin{
    .name = "slow_spin",
    .sentence = "A rotation too small to matter, unless the path grazes.",
    .hardness_meaning = "k: the rotation is 2^-k radians over the step",
    .levels = kSlowSpinLevels,
    .fill = fill_slow_spin,
    .rotating = true,
    .picture = {12, 5},
};

}  // namespace graze::corpus
