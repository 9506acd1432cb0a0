// aligned_boxes: boxes on a grid. Hardness: the number of axes, 0..3, along which the intervals of the two
// boxes share an end at t = 0 (their faces lie in one plane: flush outside, flush inside, or equal and
// concentric). Such faces make support ties along the whole path: two vertices of C are then equally far.
#include <cmath>

#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

void fill_aligned_boxes(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  Vec3<double> half_a, half_b, start, v;
  for (int i = 0; i < 3; ++i) {
    half_a[i] = draw.positive_on_grid(kReach);
    half_b[i] = draw.positive_on_grid(kReach);
  }
  // The tied axes are the first `ties` after a random start, cyclically.
  const int ties = static_cast<int>(hardness), first = random.integer(0, 2);
  for (int n = 0; n < 3; ++n) {
    const int i = (first + n) % 3;
    const double side = random.once_in(2) ? 1 : -1;
    if (n < ties) {
      switch (random.below(3)) {
        case 0:
          start[i] = side * (half_a[i] + half_b[i]);
          break;  // flush outside: they touch along this axis
        case 1:
          start[i] = side * (half_a[i] - half_b[i]);
          break;  // flush inside
        default:
          half_b[i] = half_a[i];
          start[i] = 0;
          break;
      }
      // Mostly sliding along the shared plane.
      v[i] = random.once_in(4) ? draw.on_grid(kReach) : 0;
    } else {
      // Apart along this axis, never sharing an end: beyond the sum of the half extents by a grid step or
      // more.
      start[i] = side * (half_a[i] + half_b[i] + draw.positive_on_grid(2 * kReach));
      v[i] = 0 - side * draw.positive_on_grid(16);
    }
  }
  // Diagonal motion now and then: edges and corners arrive together.
  if (ties < 2 && random.once_in(3)) {
    const int i = (first + ties) % 3, j = (first + 2) % 3;
    const double gap_i = std::abs(start[i]) - (half_a[i] + half_b[i]);
    start[j] = (start[j] < 0 ? -1 : 1) * (half_a[j] + half_b[j] + gap_i);
    v[j] = (start[j] < 0 ? 1 : -1) * std::abs(v[i]);
  }
  problem.a.shape = Box<double>{half_a};
  problem.b.shape = Box<double>{half_b};
  for (int i = 0; i < 3; ++i) {
    problem.a.position[i] = draw.on_grid(kReach);
    problem.b.position[i] = problem.a.position[i] + start[i];
  }
  set_motion(draw, problem, v);
  switch (random.below(8)) {
    case 0:
      problem.t_max = kInfinity<double>;
      break;
    case 1:
      problem.t_max = 4;
      break;
    default:
      break;
  }
  vary_time_scale(draw, problem);
  turn_exactly(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kAlignedBoxesLevels[] = {0, 1, 2, 3};

}  // namespace

const Family family::aligned_boxes{
    .name = "aligned_boxes",
    .sentence = "Boxes on a grid: support ties along the whole path.",
    .hardness_meaning = "the number of axes along which the boxes' faces lie in one plane at t = 0",
    .levels = kAlignedBoxesLevels,
    .fill = fill_aligned_boxes,
    .picture = {2, 1},
};

}  // namespace graze::corpus
