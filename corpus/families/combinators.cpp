// combinators: a tree of sums, sweeps, hulls of two, roundings and poses against a shape, or against one of
// them. Hardness: the depth of the tree. The parts that are added in are smooth, so that the vertices of a
// sum at most double with each level: never more than a few hundred.
#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

void fill_combinators(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  problem.a.shape = nested_shape(draw, static_cast<int>(hardness));
  problem.b.shape = random.once_in(2) ? draw.leaf(kReach, 0) : nested_shape(draw, 1);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  aim(draw, problem, random.once_in(2) ? kReach : 0.25);
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kCombinatorsLevels[] = {1, 2, 3, 4, 5};

}  // namespace

const Family family::combinators{
    .name = "combinators",
    .sentence = "Sums, sweeps, hulls of two, roundings and poses, nested.",
    .hardness_meaning = "how deep the combinators are nested",
    .levels = kCombinatorsLevels,
    .fill = fill_combinators,
    .picture = {3, 3},
};

}  // namespace graze::corpus
