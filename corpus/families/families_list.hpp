// One function a family: fills the bodies and the question of a case, given its hardness.
#pragma once

#include "corpus/families/draw.hpp"

namespace graze::corpus {

void fill_random(Draw& draw, double hardness, Case& problem);
void fill_aligned_boxes(Draw& draw, double hardness, Case& problem);
void fill_grazing(Draw& draw, double hardness, Case& problem);
void fill_size_ratio(Draw& draw, double hardness, Case& problem);
void fill_far_from_origin(Draw& draw, double hardness, Case& problem);
void fill_touching(Draw& draw, double hardness, Case& problem);
void fill_curved(Draw& draw, double hardness, Case& problem);
void fill_combinators(Draw& draw, double hardness, Case& problem);

void fill_spinning_graze(Draw& draw, double hardness, Case& problem);
void fill_fast_spin(Draw& draw, double hardness, Case& problem);
void fill_off_centre_pivot(Draw& draw, double hardness, Case& problem);
void fill_enters_and_leaves(Draw& draw, double hardness, Case& problem);
void fill_both_turn(Draw& draw, double hardness, Case& problem);
void fill_slow_spin(Draw& draw, double hardness, Case& problem);
void fill_random_rotating(Draw& draw, double hardness, Case& problem);

// The construction of `grazing`: the path passes a top feature of C at the height delta above it. The horizon
// may be infinite.
void pass_top_feature(Draw& draw, Case& problem, double delta);

}  // namespace graze::corpus
