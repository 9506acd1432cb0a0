#include "corpus/families.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "corpus/families/families_list.hpp"

namespace graze::corpus {

Case Family::generate(double hardness, std::uint64_t seed) const {
  const double level = std::clamp(std::floor(hardness + 0.5), levels.front(), levels.back());
  Case problem;
  problem.id.reserve(name.size() + 32);
  problem.id.append(name).append("/h").append(std::to_string(static_cast<long long>(level)));
  problem.id.append("/s").append(std::to_string(seed));
  problem.family = name;
  problem.hardness = level;
  problem.comment = sentence;
  // Every family and level has its own stream: seeds are small numbers, and mixed by the hash of the name.
  Draw draw(fnv1a(problem.id));
  fill(draw, level, problem);
  return problem;
}

#define GRAZE_FAMILY(name) family::name,

std::span<const Family> families() {
  static const Family kFamilies[] = {GRAZE_LINEAR_FAMILIES(GRAZE_FAMILY)};
  return kFamilies;
}

std::span<const Family> rotating_families() {
  static const Family kFamilies[] = {GRAZE_ROTATING_FAMILIES(GRAZE_FAMILY)};
  return kFamilies;
}

#undef GRAZE_FAMILY

const Family* find_family(std::string_view name) {
  for (const std::span<const Family> list : {families(), rotating_families()}) {
    for (const Family& family : list) {
      if (family.name == name) return &family;
    }
  }
  return nullptr;
}

}  // namespace graze::corpus
