// The laws of the queries beside the cast (overlap, distance, penetration, penetration along a direction, the
// line, swept overlap): one line each.
#include "properties/laws/queries/checks.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

std::vector<Law> query_laws() {
  return {
      {"query_swapping",
       "Swapping A and B changes no distance, depth or time of a query, and negates its normal.",
       Needs::metamorphic, &query_swapping},
      {"query_scaling",
       "Multiplying every length by a power of two scales distances, depths and points, and changes no time, "
       "normal or iteration.",
       Needs::metamorphic, &query_scaling},
      {"query_translating", "Translating both bodies by an exact amount changes the answer to no query.",
       Needs::metamorphic, &query_translating},
      {"query_requesting", "Of a query, too, asking for less changes no answer and computes nothing unasked.",
       Needs::metamorphic, &query_requesting},
      {"query_answer_is_consistent",
       "Outcome and brackets of a query say one thing; normals are unit, points finite, wide brackets "
       "stalls.",
       Needs::metamorphic, &query_answer_is_consistent},
      {"query_bad_input_is_refused",
       "Bad input is refused at the door of every query, a direction of no length among it.",
       Needs::metamorphic, &query_bad_input_is_refused},
      {"gaps_agree",
       "Overlap, distance and penetration speak of one gap: a distance above zero is a depth of none.",
       Needs::metamorphic, &gaps_agree},
      {"growing_closes_gaps", "A superset is no farther away, and no less deep.", Needs::metamorphic,
       &growing_closes_gaps},
      {"rounding_takes_its_radius",
       "Rounding a body by r takes r from the distance, or adds it to the depth.", Needs::metamorphic,
       &rounding_takes_its_radius},
      {"moving_along_the_normal",
       "Moving B by s along the normal adds s to the gap: by the depth they touch, by less they still meet.",
       Needs::metamorphic, &moving_along_the_normal},
      {"no_way_is_shorter",
       "The penetration along a direction is no less than the least, and ends on this side of its normal's "
       "plane.",
       Needs::metamorphic, &no_way_is_shorter},
      {"growing_lengthens_the_way", "The way out of a superset along a direction is no shorter.",
       Needs::metamorphic, &growing_lengthens_the_way},
      {"line_holds_cast",
       "The line's interval begins where the cast hits, and holds 0 where it starts in contact.",
       Needs::metamorphic, &line_holds_cast},
      {"line_reversed", "Backwards the line is the same interval, negated.", Needs::metamorphic,
       &line_reversed},
      {"line_grows", "The line meets a superset for no shorter a time.", Needs::metamorphic, &line_grows},
      {"swept_overlap_is_cast", "Swept overlap says whether the cast finds contact, whatever the method.",
       Needs::metamorphic, &swept_overlap_is_cast},
      {"swept_overlap_grows",
       "A longer path, a target distance and a superset lose no contact of a swept overlap.",
       Needs::metamorphic, &swept_overlap_grows},
      {"swept_overlap_of_volume", "Swept overlap is the overlap of A with the volume that B sweeps.",
       Needs::metamorphic, &swept_overlap_of_volume},
      {"motion_at_rest",
       "At rest, moved as one, or on no time at all, swept overlap and line say what the overlap says.",
       Needs::metamorphic, &motion_at_rest},
      {"target_is_rounding", "A target distance is a rounding of either body.", Needs::metamorphic,
       &target_is_rounding},
      {"distance_is_shown",
       "The normal of a distance separates by it, its points are as far apart and end their bodies there.",
       Needs::proof, &distance_is_shown},
      {"depth_is_shown", "The normal of a depth ends C there, and its points meet when B is moved by it.",
       Needs::proof, &depth_is_shown},
      {"miss_is_shown", "The axis of a miss separates the bodies, for all times that the query is about.",
       Needs::proof, &miss_is_shown},
      {"line_normals_support", "The line's normals support C where the line enters and where it leaves.",
       Needs::proof, &line_normals_support},
      {"query_verdict_is_right",
       "The verdict of a query is wrong only within kappa u scale in distance, depth or clearance.",
       Needs::oracle, &query_verdict_is_right},
      {"query_bracket_is_right",
       "Distance, depth, and both ends of a line are within kappa u scale, and held by their brackets.",
       Needs::oracle, &query_bracket_is_right},
      {"query_contact_is_right",
       "Normals of queries separate or support, and their points lie on the bodies, within kappa u scale.",
       Needs::oracle, &query_contact_is_right},
  };
}

}  // namespace graze::law
