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

}  // namespace graze::corpus
