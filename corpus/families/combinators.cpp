// combinators: a tree of sums, sweeps, hulls of two, roundings and poses against a shape, or against one of
// them. Hardness: the depth of the tree. The parts that are added in are smooth, so that the vertices of a
// sum at most double with each level: never more than a few hundred.
#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

Shape<double> tree(Draw& draw, int depth) {
  constexpr double kReach = 2;
  constexpr int kThinness = 2;
  Random& random = draw.random;
  if (depth == 0) return draw.leaf(kReach, random.once_in(4) ? kThinness : 0);
  Shape<double> child = tree(draw, depth - 1);
  switch (random.below(5)) {
    case 0: {
      Shape<double> other = draw.smooth_leaf(kReach, 0);
      if (random.once_in(2)) std::swap(child, other);
      return sum<double>(std::move(child), std::move(other));
    }
    case 1:
      return swept<double>(std::move(child), draw.vector(kReach));
    case 2: {
      Shape<double> leaf = draw.leaf(kReach, 0);
      Shape<double> other = translated<double>(std::move(leaf), draw.vector(kReach));
      if (random.once_in(2)) std::swap(child, other);
      return hull_of<double>(std::move(child), std::move(other));
    }
    case 3:
      return rounded<double>(std::move(child), draw.snap(random.uniform(0, kReach)));
    default: {
      const Vec3<double> position = draw.vector(kReach);
      return posed<double>(std::move(child), position, draw.pose());
    }
  }
}

}  // namespace

void fill_combinators(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  problem.a.shape = tree(draw, static_cast<int>(hardness));
  problem.b.shape = random.once_in(2) ? draw.leaf(kReach, 0) : tree(draw, 1);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  aim(draw, problem, random.once_in(2) ? kReach : 0.25);
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

}  // namespace graze::corpus
