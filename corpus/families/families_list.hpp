// One function a family: fills the bodies and the question of a case, given its hardness.
#pragma once

#include "corpus/families/draw.hpp"

namespace graze::corpus {

void fill_random(Draw& draw, double hardness, Case& problem);
void fill_aligned_boxes(Draw& draw, double hardness, Case& problem);
void fill_grazing_vertex(Draw& draw, double hardness, Case& problem);
void fill_grazing_edge(Draw& draw, double hardness, Case& problem);
void fill_grazing_face(Draw& draw, double hardness, Case& problem);
void fill_size_ratio(Draw& draw, double hardness, Case& problem);
void fill_far_from_origin(Draw& draw, double hardness, Case& problem);
void fill_touching(Draw& draw, double hardness, Case& problem);
void fill_curved(Draw& draw, double hardness, Case& problem);
void fill_combinators(Draw& draw, double hardness, Case& problem);
void fill_hulls(Draw& draw, double hardness, Case& problem);
void fill_hulls_rotated(Draw& draw, double hardness, Case& problem);
void fill_flat_shapes(Draw& draw, double hardness, Case& problem);
void fill_redundant_vertices(Draw& draw, double hardness, Case& problem);
void fill_lattice(Draw& draw, double hardness, Case& problem);
void fill_contained(Draw& draw, double hardness, Case& problem);
void fill_sliding(Draw& draw, double hardness, Case& problem);
void fill_speeds(Draw& draw, double hardness, Case& problem);
void fill_target_margin(Draw& draw, double hardness, Case& problem);
void fill_scaled_scene(Draw& draw, double hardness, Case& problem);
void fill_many_vertices(Draw& draw, double hardness, Case& problem);
void fill_needles(Draw& draw, double hardness, Case& problem);
void fill_plates(Draw& draw, double hardness, Case& problem);
void fill_parallel_faces(Draw& draw, double hardness, Case& problem);
void fill_parallel_edges(Draw& draw, double hardness, Case& problem);
void fill_perpendicular(Draw& draw, double hardness, Case& problem);
void fill_noisy_copy(Draw& draw, double hardness, Case& problem);
void fill_smooth_graze(Draw& draw, double hardness, Case& problem);
void fill_slivers(Draw& draw, double hardness, Case& problem);
void fill_far_own_frame(Draw& draw, double hardness, Case& problem);
void fill_mixed_magnitudes(Draw& draw, double hardness, Case& problem);
void fill_level_prisms(Draw& draw, double hardness, Case& problem);

void fill_spinning_graze(Draw& draw, double hardness, Case& problem);
void fill_fast_spin(Draw& draw, double hardness, Case& problem);
void fill_off_centre_pivot(Draw& draw, double hardness, Case& problem);
void fill_enters_and_leaves(Draw& draw, double hardness, Case& problem);
void fill_both_turn(Draw& draw, double hardness, Case& problem);
void fill_slow_spin(Draw& draw, double hardness, Case& problem);
void fill_random_rotating(Draw& draw, double hardness, Case& problem);
void fill_pure_spin(Draw& draw, double hardness, Case& problem);
void fill_far_own_frame_turning(Draw& draw, double hardness, Case& problem);
void fill_long_arms(Draw& draw, double hardness, Case& problem);
void fill_swung_balls(Draw& draw, double hardness, Case& problem);

// The path passes a top feature (vertex, edge, face, or the pole of a sphere) of C at the height delta above
// it. The horizon may be infinite.
void pass_top_feature(Draw& draw, Case& problem, double delta);

}  // namespace graze::corpus
