#include "properties/mutants/aimed.hpp"

#include <algorithm>
#include <graze/hull_graph.hpp>

#include "corpus/families.hpp"

namespace graze::mutants {

using corpus::Case;
using corpus::Family;

namespace {

const Family& family(std::string_view name) {
  const auto all = corpus::families();
  return *std::find_if(all.begin(), all.end(), [&](const Family& one) { return one.name == name; });
}

void climb(Shape<double>& shape) {
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) shape = with_adjacency<double>(hull->vertices());
}

// Hulls large enough for the climb, with adjacency, which a method in float derives for itself.
void add_climbed(std::vector<Case>& out, std::size_t count) {
  for (std::size_t seed = 0; seed < count; ++seed) {
    Case one = family("many_vertices").generate(6 + static_cast<double>(seed % 2), 1000 + seed);
    climb(one.a.shape);
    climb(one.b.shape);
    out.push_back(std::move(one));
  }
}

// The harder half of the families' levels, hardest first, each level once in so many rounds.
std::vector<Case> hard_half(std::span<const Family> families, std::size_t rounds) {
  std::vector<Case> out;
  for (std::size_t round = 0; round < rounds; ++round) {
    for (const Family& one : families) {
      const std::size_t hard = one.levels.size() / 2;
      if (hard == 0 || one.name == "many_vertices") continue;
      const double level = one.levels[one.levels.size() - 1 - round % hard];
      out.push_back(one.generate(level, 2000 + round));
    }
  }
  return out;
}

}  // namespace

std::vector<Case> aimed_cases(std::size_t rounds) {
  std::vector<Case> out = hard_half(corpus::families(), rounds);
  add_climbed(out, (rounds + 1) / 2);
  return out;
}

std::vector<Case> aimed_rotating_cases(std::size_t rounds) {
  return hard_half(corpus::rotating_families(), rounds);
}

}  // namespace graze::mutants
