// The functions behind the table of queries.cpp, by the file that holds them.
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

using QueryCheck = LawResult(const corpus::Case&, const engine::Method&);

// any.cpp: of every query
QueryCheck query_swapping, query_scaling, query_translating, query_requesting, query_answer_is_consistent,
    query_bad_input_is_refused;

// gap.cpp: overlap, distance, penetration
QueryCheck gaps_agree, growing_closes_gaps, rounding_takes_its_radius, moving_along_the_normal,
    no_way_is_shorter, growing_lengthens_the_way;

// motion.cpp: line, swept overlap
QueryCheck line_holds_cast, line_reversed, line_grows, swept_overlap_is_cast, swept_overlap_grows,
    swept_overlap_of_volume, motion_at_rest, target_is_rounding;

// proof.cpp: what an answer shows by itself
QueryCheck distance_is_shown, depth_is_shown, miss_is_shown, line_normals_support;

// oracle.cpp
QueryCheck query_verdict_is_right, query_bracket_is_right, query_contact_is_right;

}  // namespace graze::law
