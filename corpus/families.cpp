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
constexpr double kSmoothGrazeLevels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
constexpr double kNoiseLevels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
constexpr double kRatioLevels[] = {0, 1, 2, 3, 4, 5, 6};
constexpr double kFarLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr double kTouchingLevels[] = {-1024, -64, -8, -4, -2, -1, 0};
constexpr double kCurvedLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
constexpr double kCombinatorsLevels[] = {1, 2, 3, 4, 5};
constexpr double kHullsLevels[] = {8, 10, 12, 14, 16};
constexpr double kTenthsLevels[] = {1, 2, 4, 6, 8, 10, 12, 14, 16, 17};  // 17: none at all
constexpr double kRedundantLevels[] = {0, 1, 2, 3, 4, 5};
constexpr double kLatticeLevels[] = {0, 1, 2, 3, 4, 5, 6};
constexpr double kSlidingLevels[] = {0, 1, 2, 4, 6, 8, 10, 12, 14, 16, 17};
constexpr double kSpeedsLevels[] = {0, 1, 2, 3, 5, 8, 12, 16, 20, 25, 30, 40, 50};
constexpr double kMarginLevels[] = {-6, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4};
constexpr double kScaledLevels[] = {0, 10, 20, 30, 40, 50, 75, 100};
constexpr double kManyLevels[] = {5, 6, 7, 8, 9};
constexpr double kMixedLevels[] = {1, 2, 3, 5, 8, 12, 16, 20, 30, 40, 50, 59};
constexpr double kLevelPrismsLevels[] = {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
constexpr double kOwnFrameLevels[] = {2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

constexpr Family kFamilies[] = {
    {"random", "Two random bodies, one aimed near the other.", "the number of vertices of a hull",
     kRandomLevels, fill_random},
    {"aligned_boxes", "Boxes on a grid: support ties along the whole path.",
     "the number of axes along which the boxes' faces lie in one plane at t = 0", kAlignedLevels,
     fill_aligned_boxes},
    {"grazing_vertex", "The path just touches, or just misses, a vertex.",
     "k: the clearance is 10^-k, or the depth at most that, for shapes of size 4", kGrazingLevels,
     fill_grazing_vertex},
    {"grazing_edge", "The path just touches, or just misses, an edge.",
     "k: the clearance is 10^-k, or the depth at most that, for shapes of size 4", kGrazingLevels,
     fill_grazing_edge},
    {"grazing_face", "The path just touches, or just misses, a face.",
     "k: the clearance is 10^-k, or the depth at most that, for shapes of size 4", kGrazingLevels,
     fill_grazing_face},
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
    {"hulls", "Two hulls of few random vertices, not turned, one aimed near the other.",
     "the number of vertices of each hull", kHullsLevels, fill_hulls},
    {"hulls_rotated", "Two hulls of few random vertices, turned, one aimed near the other.",
     "the number of vertices of each hull", kHullsLevels, fill_hulls_rotated},
    {"flat_shapes", "Plates, needles and specks, in one plane, on one line, or anyhow.",
     "k: the flattest body's least extent is 10^-k of its largest; 17 is exactly flat", kTenthsLevels,
     fill_flat_shapes},
    {"redundant_vertices", "Hulls that list more than their corners: copies, midpoints, inner points.",
     "k: 2^k redundant vertices for each corner", kRedundantLevels, fill_redundant_vertices},
    {"lattice", "Shapes, positions and motion on a coarse lattice.",
     "k: the shapes' coordinates are integers of -2^(6-k) .. 2^(6-k)", kLatticeLevels, fill_lattice},
    {"contained", "One body within the other, or on its way to the other's middle.",
     "k: the centres meet but for 10^-k of a size of 4 along an axis; 17 is concentric", kTenthsLevels,
     fill_contained},
    {"sliding", "Bodies in touch that slide off, along, or into each other.",
     "k: |n.v| is 10^-k of the largest component of v; 17 is exactly along the face", kSlidingLevels,
     fill_sliding},
    {"speeds", "Very slow and very fast motion over very long and very short times.",
     "k: |v| is 10^k or 10^-k of what arrives within a unit of time", kSpeedsLevels, fill_speeds},
    {"target_margin", "Casts to a target distance, from far below the shapes' size to far above.",
     "k: the target distance is 10^k sizes of 4", kMarginLevels, fill_target_margin},
    {"scaled_scene", "A scene that is tiny or huge, with gaps near the usual absolute tolerances.",
     "j: the scene is 2^j or 2^-j as large as shapes of size 4", kScaledLevels, fill_scaled_scene},
    {"many_vertices", "Dense hulls: spheres, caps, prisms, rings of nearly coplanar triangles.",
     "k: one hull has 2^k corners", kManyLevels, fill_many_vertices},
    {"needles", "Long thin bodies that meet near their ends.", "k: the length is 10^k times the width",
     kRatioLevels, fill_needles},
    {"plates", "Flat bodies that meet flat on flat, edge on edge or edge on flat, near their rims.",
     "k: the width is 10^k times the thickness", kRatioLevels, fill_plates},
    {"parallel_faces", "A small body falls face on face, the two nearly parallel.",
     "k: the angle between the faces is 10^-k radians", kGrazingLevels, fill_parallel_faces},
    {"parallel_edges", "Two edges meet that are nearly parallel.",
     "k: the angle between the edges is 10^-k radians", kGrazingLevels, fill_parallel_edges},
    {"perpendicular", "The motion lies nearly in the face that would be hit.",
     "k: the angle between motion and face is 10^-k radians; one case in 16 has 0", kGrazingLevels,
     fill_perpendicular},
    {"noisy_copy", "A hull and a copy of it with noise.",
     "k: the noise is 10^-k a coordinate, for shapes of size 4", kNoiseLevels, fill_noisy_copy},
    {"smooth_graze", "Round shapes that pass at a small gap, or meet to a small depth.",
     "k: the clearance is 10^-k, or the depth at most that, for shapes of size 4", kSmoothGrazeLevels,
     fill_smooth_graze},
    {"slivers", "Triangles and hulls with nearly collinear corners.",
     "k: a corner is within 10^-k of an edge, for shapes of size 4", kNoiseLevels, fill_slivers},
    {"far_own_frame", "A random pair, near the origin, of bodies that lie far out in their own frames.",
     "k: they are about 10^k out, for shapes of size 4", kOwnFrameLevels, fill_far_own_frame},
    {"mixed_magnitudes", "Sums and nested poses of coordinates of very different size.",
     "k: coordinates are 0, or 10^-k to 10^k in size, each by itself", kMixedLevels, fill_mixed_magnitudes},
    {"level_prisms", "Prisms with level ends, whose edges are nearly parallel.",
     "k: edges lean by 10^-k, for shapes of size 4", kLevelPrismsLevels, fill_level_prisms},
};

constexpr double kSpinningGrazeLevels[] = {4, 8, 12, 16, 20, 24, 28, 32, 36, 40};
constexpr double kFastSpinLevels[] = {4, 5, 6, 7, 8, 9, 10, 11, 12};
constexpr double kOffCentreLevels[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 10};
constexpr double kEntersLevels[] = {2, 4, 6, 8, 10, 12, 14, 16};
constexpr double kBothTurnLevels[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40};
constexpr double kSlowSpinLevels[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40};
constexpr double kRandomRotatingLevels[] = {0, 1, 2, 3};
constexpr double kFarTurningLevels[] = {10, 13, 16, 19, 22, 25, 28, 31, 34, 37, 40};
constexpr double kLongArmsLevels[] = {0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40};
constexpr double kSwungLevels[] = {0, 1, 2, 3, 4, 5, 6, 8, 10, 12};

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
    {"pure_spin", "No linear motion: a body meets the other by turning alone.",
     "k: the clearance is 2^-k, or the depth at most that, for an arm of 5 to 160", kSpinningGrazeLevels,
     fill_pure_spin, true},
    {"far_own_frame_turning", "Bodies that lie far out in their own frames meet near the origin, turning.",
     "k: they are about 2^k out, for shapes of size 4", kFarTurningLevels, fill_far_own_frame_turning, true},
    {"long_arms", "Both bodies, on arms far longer than they are, turn as one but for the last digits.",
     "k: the arms are about 2^k, for shapes of size 4", kLongArmsLevels, fill_long_arms, true},
    {"swung_balls", "A ball, written as another shape, swings about a far pivot by up to a few turns.",
     "k: the pivot is 2^k radii away", kSwungLevels, fill_swung_balls, true},
};

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
