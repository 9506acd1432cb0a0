#include "corpus/families.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/workloads.hpp"

namespace graze::corpus {

namespace {

std::string run_name(const Family& family, double level, std::uint64_t run) {
  std::string name(family.name);
  name.append("/h").append(std::to_string(static_cast<long long>(level)));
  return name.append("/r").append(std::to_string(run));
}

}  // namespace

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
  Draw draw(fnv1a(of_run == 1 ? problem.id : run_name(*this, level, seed / of_run)));
  draw.question = seed % of_run;
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
  for (const std::span<const Family> list : {families(), rotating_families(), workloads()}) {
    for (const Family& family : list) {
      if (family.name == name) return &family;
    }
  }
  return nullptr;
}

}  // namespace graze::corpus
