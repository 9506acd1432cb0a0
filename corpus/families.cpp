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

constexpr double kSpinningGrazeLevels[] = {4, 8, 12, 16, 20, 24, 28, 32, 36, 40};
constexpr double kFastSpinLevels[] = {4, 5, 6, 7, 8, 9, 10, 11, 12};
constexpr double kOffCentreLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 10};
constexpr double kEntersLevels[] = {2, 4, 6, 8, 10, 12, 14, 16};
constexpr double kBothTurnLevels[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40};
constexpr double kSlowSpinLevels[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40};
constexpr double kRandomRotatingLevels[] = {0, 1, 2, 3};

constexpr Family kRotatingFamilies[] = {
    {"spinning_graze",
     "A spinning corner just passes, or just meets, a face, an edge, a corner or a round body.",
     "k: the clearance is 2^-k, or the depth at most that, for shapes of size 4 to 16", kSpinningGrazeLevels,
     fill_spinning_graze, true},
    {"fast_spin", "A body turns many times while another passes.",
     "k: it turns by up to 2^k radians a unit of time, or by a few turns more", kFastSpinLevels,
     fill_fast_spin, true},
    {"off_centre_pivot", "A body turns about a point far outside.",
     "k: the pivot is 2^k sizes of 4 from the body's origin", kOffCentreLevels, fill_off_centre_pivot, true},
    {"enters_and_leaves", "Apart at both ends of the step, in contact in between.",
     "k: the contact lasts about 2^-k of the step, or less", kEntersLevels, fill_enters_and_leaves, true},
    {"both_turn", "Both bodies turn, nearly as one.",
     "k: the angular velocities differ by at most 2^-k along each axis", kBothTurnLevels, fill_both_turn,
     true},
    {"slow_spin", "A turn too small to matter, unless the path grazes.",
     "k: the turn is 2^-k radians over the step", kSlowSpinLevels, fill_slow_spin, true},
    {"random_rotating", "Any two shapes, turning and moving at moderate speed.",
     "how deep the combinators of one body are nested; 0 for none", kRandomRotatingLevels,
     fill_random_rotating, true},
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

std::span<const Family> rotating_families() { return kRotatingFamilies; }

const Family* find_family(std::string_view name) {
  for (const std::span<const Family> list : {families(), rotating_families()}) {
    for (const Family& family : list) {
      if (family.name == name) return &family;
    }
  }
  return nullptr;
}

}  // namespace graze::corpus
