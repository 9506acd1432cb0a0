#include "corpus/families.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "corpus/families/families_list.hpp"

namespace graze::corpus {
namespace {

constexpr double kRandomLevels[] = {4, 6, 8, 12, 16, 24};
constexpr double kAlignedLevels[] = {0, 1, 2, 3};
constexpr double kGrazingLevels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
constexpr double kRatioLevels[] = {0, 1, 2, 3, 4, 5, 6};
constexpr double kFarLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr double kTouchingLevels[] = {-1024, -64, -8, -4, -2, -1, 0};
constexpr double kCurvedLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr double kCombinatorsLevels[] = {1, 2, 3, 4, 5};

constexpr Family kFamilies[] = {
    {"random", "Two random bodies, one aimed near the other.", "the number of vertices of a hull",
     kRandomLevels, fill_random},
    {"aligned_boxes", "Boxes on a grid: support ties along the whole path.",
     "the number of axes along which the boxes' faces lie in one plane at t = 0", kAlignedLevels,
     fill_aligned_boxes},
    {"grazing", "The path just touches, or just misses, a vertex, an edge or a face.",
     "k: the clearance is 10^-k, or the depth at most that, for shapes of size 4", kGrazingLevels,
     fill_grazing},
    {"size_ratio", "A small body falls anywhere on a large one.", "k: the large body is 10^k times as large",
     kRatioLevels, fill_size_ratio},
    {"far_from_origin", "A random pair far from the origin.",
     "k: the offset is about 10^k, for shapes of size 4", kFarLevels, fill_far_from_origin},
    {"touching", "Bodies that start in touch, or within a few units in the last place of it.",
     "-n: the gap is n units in the last place of 1 (2^-23 or 2^-52), either sign; 0 touches",
     kTouchingLevels, fill_touching},
    {"curved", "Round shapes and thin ones.",
     "k: the thin extents are 10^-k of the others, for shapes of size 4", kCurvedLevels, fill_curved},
    {"combinators", "Sums, sweeps, hulls of two, roundings and poses, nested.",
     "how deep the combinators are nested", kCombinatorsLevels, fill_combinators},
};

}  // namespace

Case Family::generate(double hardness, std::uint64_t seed) const {
  const double level = std::clamp(std::floor(hardness + 0.5), levels.front(), levels.back());
  Case problem;
  problem.id =
      std::string(name) + "/h" + std::to_string(static_cast<long long>(level)) + "/s" + std::to_string(seed);
  problem.family = name;
  problem.hardness = level;
  problem.comment = sentence;
  // Every family and level has its own stream: seeds are small numbers, and mixed by the hash of the name.
  Draw draw(fnv1a(problem.id));
  fill(draw, level, problem);
  return problem;
}

std::span<const Family> families() { return kFamilies; }

const Family* find_family(std::string_view name) {
  for (const Family& family : kFamilies) {
    if (family.name == name) return &family;
  }
  return nullptr;
}

}  // namespace graze::corpus
