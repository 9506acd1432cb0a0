// fast_spin: one body, or both, rotates by up to 2^k radians over the step while the other passes near.
// Within a turn the contact comes and goes. A bound on the speed of its points grows with the number of
// turns. Hardness: k. The bodies meet, or pass each other, at a drawn time, with rational poses at that time.
#include "corpus/families/families_list.hpp"
#include "corpus/families/turning.hpp"

#include <cmath>

namespace graze::corpus {
namespace {

void fill_fast_spin(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  problem.a.shape = any_shape(draw, kReach);
  problem.b.shape = any_shape(draw, kReach);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  if (random.once_in(3)) problem.spin_a.pivot = draw.vector(kReach);
  if (random.once_in(3)) problem.spin_b.pivot = draw.vector(kReach);

  Meeting meeting;
  meeting.t = meeting_time(draw);
  meeting.turn_a = some_turn(draw);
  const double most = power_of_two(static_cast<int>(hardness)) * meeting.t / (2 * kPi);
  meeting.turns_a = static_cast<int>(std::floor(most * random.uniform(0.5, 1)));
  if (random.once_in(3)) {
    meeting.turn_b = some_turn(draw);
    meeting.turns_b = static_cast<int>(std::floor(most * random.unit()));
  }
  // One in four spins in its place, beside the other.
  const bool still = random.once_in(4);
  const Vec3<double> way = draw.vector(16);
  set_motion(draw, problem, still ? Vec3<double>::Zero() : way);
  meet(draw, problem, meeting, random.once_in(3) ? 0.25 : 2 * kReach);
  vary_horizon(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kFastSpinLevels[] = {4, 5, 6, 7, 8, 9, 10, 11, 12};

}  // namespace

const Family family::fast_spin{
    .name = "fast_spin",
    .sentence = "A body rotates many times while another passes.",
    .hardness_meaning = "k: it rotates by up to 2^k radians a unit of time, or by a few turns more",
    .levels = kFastSpinLevels,
    .fill = fill_fast_spin,
    .rotating = true,
    .picture = {5, 2},
};

}  // namespace graze::corpus
