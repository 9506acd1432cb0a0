// The families, in the order in which they are judged. A family is a file of this folder, and a name here.
#pragma once

#include "corpus/families.hpp"
#include "corpus/families/draw.hpp"

// clang-format off
#define GRAZE_LINEAR_FAMILIES(family) \
  family(random) family(aligned_boxes) family(grazing_vertex) family(grazing_edge) \
  family(grazing_face) family(size_ratio) family(far_from_origin) family(touching) family(curved) \
  family(combinators) family(hulls) family(hulls_rotated) family(flat_shapes) \
  family(redundant_vertices) family(lattice) family(contained) family(sliding) family(speeds) \
  family(target_margin) family(scaled_scene) family(many_vertices) family(needles) family(plates) \
  family(parallel_faces) family(parallel_edges) family(perpendicular) family(noisy_copy) \
  family(smooth_graze) family(slivers) family(far_own_frame) family(mixed_magnitudes) \
  family(level_prisms) family(at_rest) family(coaxial) family(equal_distances) \
  family(parallel_caps) family(rods_and_round) family(smooth_depths) family(rays) \
  family(round_ties) family(apexes) family(ray_ties)

// Those in which bodies turn.
#define GRAZE_ROTATING_FAMILIES(family) \
  family(spinning_graze) family(fast_spin) family(off_centre_pivot) family(enters_and_leaves) \
  family(both_turn) family(slow_spin) family(random_rotating) family(pure_spin) \
  family(far_own_frame_turning) family(long_arms) family(swung_balls) family(level_tiles) \
  family(wheels) family(flat_plates_turning) family(above_a_floor) family(resting_turns)
// clang-format on

namespace graze::corpus::family {

#define GRAZE_FAMILY(name) extern const Family name;
GRAZE_LINEAR_FAMILIES(GRAZE_FAMILY)
GRAZE_ROTATING_FAMILIES(GRAZE_FAMILY)
#undef GRAZE_FAMILY

}  // namespace graze::corpus::family
