// curved: pairs among all ten shapes, one of them round more often than not, thinned. Hardness: k, the thin
// extents are 10^-k of the others. This gives needles, disks and blades, with a curvature of 10^2k beside a
// flat side. The path aims at the middle of a side, or past it by the thin extents.
#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

void fill_curved(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;
  Random& random = draw.random;
  const int thinness = static_cast<int>(hardness);
  problem.a.shape = random.once_in(4) ? draw.leaf(kReach, thinness) : draw.smooth_leaf(kReach, thinness);
  problem.b.shape = draw.leaf(kReach, thinness);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  // By a thin extent, half of the time by a large one.
  aim(draw, problem, random.once_in(2) ? kReach : kReach * power_of_ten(-thinness));
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kCurvedLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};

}  // namespace

const Family family::curved{
    .name = "curved",
    .sentence = "Round shapes and thin ones.",
    .hardness_meaning = "k: the thin extents are 10^-k of the others, for shapes of size 4",
    .levels = kCurvedLevels,
    .fill = fill_curved,
    .picture = {2, 5},
};

}  // namespace graze::corpus
