// noisy_copy: B is a copy of A, the same hull of 8 to 24 vertices in the same pose, with noise of 10^-k on
// every coordinate. Hardness: k. They meet corner on corner, pass each other beside their extremes by as much
// as the noise, or start one in the other.
//
// The noise is not rounded to the kind of coordinate that A has, because a float or an integer would lose it.
//
// Difficulties: C is nearly A - A, symmetric, with a copy of every face of A and of its mirror image, each
// split into slivers by the noise. All the a_i - b_i lie within the noise of one point, so simplices are flat
// or smaller than their rounding, and a test for "the same support again" fails or holds too early.
#include <utility>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

constexpr double kNoisyReach = 4;  // size of a shape (length)

// The corner that reaches furthest along the axis, in world axes.
Vec3<double> extreme(const Body<double>& body, int axis, double sign) {
  Vec3<double> best = Vec3<double>::Zero();
  bool first = true;
  for (const Vec3<double>& corner : corners(body.shape)) {
    const Vec3<double> x = rotate(body.orientation, corner);
    if (first || sign * x[axis] > sign * best[axis]) best = x;
    first = false;
  }
  return best;
}

void fill_noisy_copy(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double noise = power_of_ten(-static_cast<int>(hardness));
  problem.a.shape = draw.hull(kNoisyReach, random.integer(8, 24));
  std::vector<Vec3<double>> copy = corners(problem.a.shape);
  for (Vec3<double>& x : copy) {
    for (int i = 0; i < 3; ++i) x[i] += noise * random.uniform(-1, 1);
  }
  if (random.once_in(4)) {
    for (std::size_t k = copy.size(); k > 1; --k) std::swap(copy[k - 1], copy[random.below(k)]);
  }
  problem.b.shape = Hull<double>(std::span<const Vec3<double>>(copy));
  problem.a.orientation = problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);

  Vec3<double> v = draw.vector(16);
  const int axis = random.integer(0, 2);
  const bool forward = random.once_in(2);
  const double along = draw.snap(random.uniform(12, 24));
  v[axis] = forward ? along : -along;
  Vec3<double> beside = Vec3<double>::Zero();
  switch (random.below(8)) {
    case 0:
    case 1:
    case 2: {
      // Past each other's extremes along another axis, by as much as the noise.
      const int side = (axis + random.integer(1, 2)) % 3;
      const double sign = random.once_in(2) ? 1 : -1;
      v[side] = 0;
      beside[side] = noise * random.uniform(-2, 2);
      meet(draw, problem, extreme(problem.a, side, sign), extreme(problem.b, side, -sign), beside, v, 0.5);
      break;
    }
    case 3: {
      // One in the other, or nearly: the start overlaps, unless the copy is all that there is.
      const Vec3<double> zero = Vec3<double>::Zero();
      for (int i = 0; i < 3; ++i) beside[i] = noise * random.uniform(-2, 2);
      meet(draw, problem, zero, zero, beside, v, random.once_in(2) ? 0 : 1);
      break;
    }
    default: {
      // Head on: the corners that lead meet, or any two do.
      const bool lead = random.once_in(2);
      const std::vector<Vec3<double>> list = corners(problem.a.shape);
      const Vec3<double> any_a = rotate(problem.a.orientation, list[random.below(list.size())]);
      const Vec3<double> any_b = rotate(problem.b.orientation, copy[random.below(copy.size())]);
      const Vec3<double> a = lead ? extreme(problem.a, axis, forward ? -1 : 1) : any_a;
      const Vec3<double> b = lead ? extreme(problem.b, axis, forward ? 1 : -1) : any_b;
      if (random.once_in(2)) {
        for (int i = 0; i < 3; ++i) beside[i] = noise * random.uniform(-2, 2);
      }
      meet(draw, problem, a, b, beside, v, meeting_time(random));
      break;
    }
  }
  draw_horizon(random, problem);
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kNoisyCopyLevels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

}  // namespace

const Family family::noisy_copy{
    .name = "noisy_copy",
    .sentence = "A hull and a copy of it with noise.",
    .hardness_meaning = "k: the noise is 10^-k a coordinate, for shapes of size 4",
    .levels = kNoisyCopyLevels,
    .fill = fill_noisy_copy,
    .picture = {1, 4},
};

}  // namespace graze::corpus
