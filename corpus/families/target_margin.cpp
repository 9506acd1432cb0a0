// target_margin: casts to a target distance m. Hardness: k, m is 10^k of a size of 4, k from -6 to 4. C is
// rounded by m. A larger m leaves the shapes a smaller share in the answer, but they still determine it.
//
// m is 4 times 10^k, rounded to float with floats and integers. The cases are of four kinds, a quarter each:
//   - paths that pass a top feature of C at the height m (1 + 2^-10) or m (1 - 2^-10), as in `grazing`,
//   - boxes on a grid whose faces are m and a few lengths more apart,
//   - starts within m of each other, as in `sliding` with a gap, that leave, slide or continue, under either
//     policy,
//   - random pairs that approach from beyond m.
//
// Difficulties: a margin that is folded into a radius and subtracted again, a constant shape margin, an
// offset of the time by |margin| / |v|, a policy that is applied to the margin instead of the shapes.
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

// From beyond the margin towards A, on either side of what it covers.
void approach_margin(Draw& draw, Case& problem, double m) {
  Random& random = draw.random;
  problem.a.shape = draw.shape(4, random.integer(4, 16));
  problem.b.shape = draw.shape(4, random.integer(4, 16));
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  const double reach = m + 12;  // beyond it no two such shapes are within m
  Vec3<double> start = draw.vector(reach), target;
  const int axis = random.integer(0, 2);
  const double away = draw.snap(reach * random.uniform(1.01, 2));
  start[axis] = random.once_in(2) ? away : -away;
  if (random.once_in(12)) start = draw.vector(0.5 * reach);
  for (int i = 0; i < 3; ++i) target[i] = draw.coordinate(0.75 * reach);
  const double far = random.uniform(0.5, 2);
  Vec3<double> v;
  for (int i = 0; i < 3; ++i) {
    problem.b.position[i] = draw.snap(problem.a.position[i] + start[i]);
    v[i] = draw.snap((target[i] - start[i]) * far);
  }
  set_motion(draw, problem, v);
  if (random.once_in(12)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
}

// Box onto box, down one axis: the faces reach m after a gap that is drawn.
void drop_box(Draw& draw, Case& problem, double m) {
  Random& random = draw.random;
  Vec3<double> half_a, half_b, start, v = Vec3<double>::Zero();
  for (int i = 0; i < 3; ++i) {
    half_a[i] = draw.positive_on_grid(4);
    half_b[i] = draw.positive_on_grid(4);
    start[i] = draw.on_grid(half_a[i] + half_b[i]);
  }
  const double gap = draw.positive_on_grid(8);
  start[2] = draw.real(half_a[2] + half_b[2] + gap + m);
  v[2] = 0 - gap * random.integer(1, 4) / 2;
  if (random.once_in(4)) v[0] = draw.on_grid(4);
  problem.a.shape = Box<double>{half_a};
  problem.b.shape = Box<double>{half_b};
  problem.b.position = start;
  set_motion(draw, problem, v);
  vary_time_scale(draw, problem);
  turn_exactly(draw, problem);
}

// A gap of quarters of m between features that face each other along z.
void start_within(Draw& draw, Case& problem, double m) {
  Random& random = draw.random;
  const Capped a = draw.capped(4), b = draw.capped_below(4);
  problem.a.shape = a.shape;
  problem.b.shape = b.shape;
  if (random.once_in(3)) problem.a.orientation = draw.pose_about_z();
  if (random.once_in(3)) problem.b.orientation = draw.pose_about_z();
  problem.a.position = Vec3<double>(0, 0, a.lift - b.lift);
  Vec3<double> v;
  for (int i = 0; i < 2; ++i) {
    problem.b.position[i] = draw.on_grid(4);
    v[i] = draw.on_grid(8);
  }
  problem.b.position[2] = draw.real(m * random.integer(1, 4) / 4);
  const double speed = draw.positive_on_grid(8);
  v[2] = random.integer(-1, 1) * speed;
  set_motion(draw, problem, v);
  if (!random.once_in(3)) problem.start_policy = StartPolicy::pass_over;
  if (random.once_in(8)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
  turn_exactly(draw, problem);
}

void fill_target_margin(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double m = draw.real(4 * power_of_ten(static_cast<int>(hardness)));
  problem.target_distance = m;
  switch (random.below(4)) {
    case 0:
      drop_box(draw, problem, m);
      break;
    case 1:
      pass_top_feature(draw, problem, draw.real(m * (random.once_in(2) ? 1 + 0x1p-10 : 1 - 0x1p-10)));
      return;  // which has swapped already
    case 2:
      start_within(draw, problem, m);
      break;
    default:
      approach_margin(draw, problem, m);
      break;
  }
  maybe_swap(draw, problem);
}

constexpr double kTargetMarginLevels[] = {-6, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4};

}  // namespace

const Family family::target_margin{
    .name = "target_margin",
    .sentence = "Casts to a target distance, from far below the shapes' size to far above.",
    .hardness_meaning = "k: the target distance is 10^k sizes of 4",
    .levels = kTargetMarginLevels,
    .fill = fill_target_margin,
    .picture = {-1, 4},
};

}  // namespace graze::corpus
