// random: two bodies, one aimed near the other. Hardness: the vertices of a hull.
#include "corpus/families/families_list.hpp"

namespace graze::corpus {

void fill_random(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;  // size of a shape (length); integers up to 4 keep some variety
  Random& random = draw.random;
  const int vertices = static_cast<int>(hardness);
  problem.a.shape = random.once_in(4) ? draw.shape(kReach, vertices) : draw.hull(kReach, vertices);
  problem.b.shape = draw.shape(kReach, vertices);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);

  Vec3<double> start = draw.vector(6);
  if (random.once_in(10)) {
    // Near enough to be in contact at the start, or nearly.
  } else {
    const int axis = random.integer(0, 2);
    const double away = draw.snap(random.uniform(8, 24));
    start[axis] = random.once_in(2) ? away : -away;
  }
  // Aimed at a point near A's middle; far enough off to miss now and then, and not always far enough to
  // arrive.
  const Vec3<double> target = draw.vector(5);
  const double reach = random.uniform(0.5, 2);
  Vec3<double> position, v;
  for (int i = 0; i < 3; ++i) {
    position[i] = draw.snap(problem.a.position[i] + start[i]);
    v[i] = draw.snap((target[i] - start[i]) * reach);
  }
  problem.b.position = position;
  set_motion(draw, problem, v);
  switch (random.below(16)) {
    case 0:
      problem.t_max = kInfinity<double>;
      break;
    case 1:
      problem.t_max = 0.5;
      break;
    case 2:
      problem.t_max = 2;
      break;
    case 3:
      problem.t_max = 100;
      break;
    default:
      break;
  }
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

}  // namespace graze::corpus
