// random: two bodies, one aimed near the other. Hardness: the vertices of a hull.
#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

void fill_random(Draw& draw, double hardness, Case& problem) {
  constexpr double kReach = 4;  // size of a shape (length), where integers up to 4 keep some variety
  Random& random = draw.random;
  const int vertices = static_cast<int>(hardness);
  problem.a.shape = random.once_in(4) ? draw.shape(kReach, vertices) : draw.hull(kReach, vertices);
  problem.b.shape = draw.shape(kReach, vertices);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  approach(draw, problem);
}

constexpr double kRandomPairLevels[] = {4, 6, 8, 12, 16, 24};

}  // namespace

const Family family::random{
    .name = "random",
    .sentence = "Two random bodies, one aimed near the other.",
    .hardness_meaning = "the number of vertices of a hull",
    .levels = kRandomPairLevels,
    .fill = fill_random,
    .picture = {8, 2},
};

}  // namespace graze::corpus
