#include "properties/mutants/aimed.hpp"

#include <algorithm>
#include <cmath>
#include <graze/detail/shapes/hull_graph.hpp>

#include "corpus/families.hpp"
#include "corpus/random.hpp"

namespace graze::mutants {

using corpus::Case;
using corpus::Family;

namespace {

const Family& family(std::string_view name) {
  const auto all = corpus::families();
  return *std::find_if(all.begin(), all.end(), [&](const Family& one) { return one.name == name; });
}

void derive(Shape<double>& shape) {
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) shape = with_adjacency<double>(hull->vertices());
}

// Hulls large enough for a map of directions, with adjacency, which a method in float derives for itself.
void add_mapped(std::vector<Case>& out, std::size_t count) {
  for (std::size_t seed = 0; seed < count; ++seed) {
    Case one = family("many_vertices").generate(8 + static_cast<double>(seed % 2), 1000 + seed);
    derive(one.a.shape);
    derive(one.b.shape);
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

// Thin plates, and a point or a ball a few roundings above them. At rest, the line to the middle runs nearly in the
// plate. Otherwise the point or ball comes down to it by next to nothing, on a path that ends about where it meets the
// plate.
void add_plates(std::vector<Case>& out, std::size_t count) {
  for (std::size_t seed = 0; seed < count; ++seed) {
    corpus::Random random(3000 + seed);
    Case one;
    one.family = "plates";
    const double thin = random.once_in(2) ? 0 : std::exp2(random.uniform(-56, -40));
    switch (random.below(3)) {
      case 0:
        one.a.shape = Box<double>{{1, 1, thin}};
        break;
      case 1:
        one.a.shape = Cylinder<double>{1, thin};
        break;
      default:
        one.a.shape = Triangle<double>{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
    }
    const double radius = random.once_in(3) ? std::exp2(random.uniform(-50, -2)) : 0;
    one.b.shape = radius > 0 ? Shape<double>(Sphere<double>{radius}) : Shape<double>(Point<double>{});
    const double top = thin + radius, beside = random.uniform(-0.25, 0.25);
    if (random.once_in(2)) {
      one.b.position = {random.uniform(-1, 1), beside, top + std::exp2(random.uniform(-54, -40))};
    } else {
      const double slope = std::exp2(random.uniform(-52, -20)), length = random.uniform(0.5, 2);
      one.b.position = {random.uniform(-1, 0), beside, top + length * slope};
      one.b.displacement = {length, 0, -(1 - std::exp2(random.uniform(-30, -1))) * length * slope};
    }
    out.push_back(std::move(one));
  }
}

// Flat bodies whose C is seen edge on, or as a point: a point that flies in a triangle's plane, or starts in
// it and slides, segments on one line.
void add_flat(std::vector<Case>& out, std::size_t count) {
  for (std::size_t seed = 0; seed < count; ++seed) {
    corpus::Random random(4000 + seed);
    Case one;
    one.family = "flat";
    const auto whole = [&](int most) { return static_cast<double>(random.integer(-most, most)); };
    one.b.shape = Point<double>{};
    if (random.once_in(3)) {
      one.a.shape = Segment<double>{{-1, 0, 0}, {1, 0, 0}};
      one.b.shape = Segment<double>{{0, 0, 0}, {whole(2), 0, 0}};
      one.b.position = {whole(6), 0, 0};
      one.b.displacement = {whole(8), 0, 0};
    } else {
      one.a.shape = Triangle<double>{{-2, -1, 0}, {2, -1, 0}, {0, 3, 0}};
      one.b.position = {whole(3) / 2, whole(3) / 2, 0};
      one.b.displacement = {whole(6), whole(6), 0};
    }
    if (random.once_in(2)) one.start_policy = StartPolicy::pass_over;
    out.push_back(std::move(one));
  }
}

}  // namespace

std::vector<Case> aimed_cases(std::size_t rounds) {
  std::vector<Case> out = hard_half(corpus::families(), rounds);
  add_mapped(out, (rounds + 1) / 2);
  add_plates(out, 3 * rounds);
  add_flat(out, 3 * rounds);
  return out;
}

std::vector<Case> aimed_rotating_cases(std::size_t rounds) {
  return hard_half(corpus::rotating_families(), rounds);
}

}  // namespace graze::mutants
