// The laws of linear casts: one line each.
#include "properties/laws/linear/advancement.hpp"
#include "properties/laws/linear/checker.hpp"
#include "properties/laws/linear/distance.hpp"
#include "properties/laws/linear/exact.hpp"
#include "properties/laws/linear/metamorphic.hpp"
#include "properties/laws/linear/motion.hpp"
#include "properties/laws/linear/oracle.hpp"
#include "properties/laws/linear/proof.hpp"
#include "properties/laws/linear/symmetry.hpp"

#include "properties/laws/tables.hpp"

namespace graze::law {

std::vector<Law> linear_laws() {
  return {
      {"swapping", "Swapping A and B changes no contact and puts the normal in the negated cone.",
       Needs::metamorphic, &swapping},
      {"scaling", "Multiplying every length by a power of two changes no time, no normal and no iteration.",
       Needs::metamorphic, &scaling},
      {"translating", "Translating both bodies by an exact amount changes no contact.", Needs::metamorphic,
       &translating},
      {"superset", "A superset of a body is never hit later.", Needs::metamorphic, &superset},
      {"ray_is_point_cast", "A cast is the ray against the CSO, which is the cast of a point.",
       Needs::metamorphic, &ray_is_point_cast},
      {"splitting",
       "Casting over [0, T] is casting over [0, s] and then, from where the bodies are, over [s, T].",
       Needs::metamorphic, &splitting},
      {"methods_meet", "The brackets of the methods of one scalar meet, each within its row.",
       Needs::metamorphic, &methods_meet},
      {"requesting", "Asking for less changes no verdict, costs no more and computes nothing unasked.",
       Needs::metamorphic, &requesting},
      {"moving_the_horizon",
       "A longer horizon keeps the contact found within a shorter; one before toi_lower is a miss.",
       Needs::metamorphic, &moving_the_horizon},
      {"keeping_distance", "A target distance is a rounding of either body; a larger one is never met later.",
       Needs::metamorphic, &keeping_distance},
      {"changing_the_clock",
       "T times 2^k and velocities by it multiply every time by 2^k and change no normal and no count.",
       Needs::metamorphic, &changing_the_clock},
      {"moving_together", "A velocity added to both bodies changes no contact.", Needs::metamorphic,
       &moving_together},
      {"reversing", "The path run backwards meets the other end of the line's contact.", Needs::metamorphic,
       &reversing},
      {"extending", "Starting farther back on the same line delays the contact by as much.",
       Needs::metamorphic, &extending},
      {"threshold_of_swept_overlap", "The swept overlap over [0, T] is in contact if T is not below the TOI.",
       Needs::metamorphic, &threshold_of_swept_overlap},
      {"permuting_the_axes", "The 48 signed permutations of the axes change no contact.", Needs::metamorphic,
       &permuting_the_axes},
      {"turning",
       "A Pythagorean rotation of both bodies, with every length times its denominator, changes no contact.",
       Needs::metamorphic, &turning},
      {"reordering", "The order of vertices and of parts, and doubling some, change no contact.",
       Needs::metamorphic, &reordering},
      {"redundant_points", "Points of a hull added to its vertices change no contact.", Needs::metamorphic,
       &redundant_points},
      {"describing_otherwise", "Another description of the same set answers the same contact.",
       Needs::metamorphic, &describing_otherwise},
      {"interrupting",
       "A budget too small leaves a bracket that meets the answer's; a lower end that decreases with "
       "the budget was right all the same (of ca, an advance cut short may lead farther).",
       Needs::metamorphic, &interrupting},
      {"tightening", "A tighter tolerance never lowers toi_lower and never raises toi_upper.",
       Needs::metamorphic, &tightening},
      {"asking_again", "The same question gets the same bits, whatever was asked between.",
       Needs::metamorphic, &asking_again},
      {"scalars_meet", "The brackets of a method in float and in double meet, each within its row.",
       Needs::metamorphic, &scalars_meet},
      {"tiers_nest", "The exact bracket lies within the certified one.", Needs::metamorphic, &tiers_nest},
      {"answer_is_consistent",
       "Outcome and bracket say one thing; a normal is unit and does not follow the motion.",
       Needs::metamorphic, &answer_is_consistent},
      {"bad_input_is_refused",
       "A NaN, an infinity, an empty hull, a negative extent or q = 0 is refused at the door.",
       Needs::metamorphic, &bad_input_is_refused},
      {"proof_is_accepted", "Every proof is accepted by the checker.", Needs::proof, &proof_is_accepted},
      {"overclaims_are_refused", "Of an accepted proof no more is accepted than its bounds leave room for.",
       Needs::proof, &overclaims_are_refused},
      {"every_iterate_is_proved",
       "Every proof of an answer cut short by its budget is accepted by the checker.", Needs::proof,
       &every_iterate_is_proved},
      {"verdict_is_right", "Contact or no contact is wrong only within kappa u scale in clearance or depth.",
       Needs::oracle, &verdict_is_right},
      {"never_late", "toi_lower is late by a depth of kappa u scale at most.", Needs::oracle, &never_late},
      {"bracket_holds_toi", "The bracket holds the time of impact, each end within kappa u scale.",
       Needs::oracle, &bracket_holds_toi},
      {"time_is_stable", "The backward error of a contact's time is within kappa u scale.", Needs::oracle,
       &time_is_stable},
      {"normal_supports", "The normal of a hit supports the CSO at the contact within kappa u scale.",
       Needs::oracle, &normal_supports},
      {"witnesses_touch", "The witnesses of a hit lie in their bodies at toi_lower, and at each other.",
       Needs::oracle, &witnesses_touch},
      {"distance_is_stated",
       "At toi_lower the bodies' distance exceeds the target distance by no more than the answer says.",
       Needs::oracle, &distance_is_stated},
      {"proof_is_tight", "A proof's bounds are within kappa u scale of the bracket's.", Needs::oracle,
       &proof_is_tight},
      {"certified_decides",
       "Tier certified leaves a verdict open only where clearance or depth is below the width of its row.",
       Needs::oracle, &certified_decides},
      {"interrupted_is_right",
       "An answer cut short by its budget is never late, and a verdict of it never wrong, beyond kappa u "
       "scale.",
       Needs::oracle, &interrupted_is_right},
      {"tolerance_bounds_the_error",
       "A looser tolerance widens the backward error by no more than itself, is never late, and changes no "
       "verdict.",
       Needs::oracle, &tolerance_bounds_the_error},
      {"exact_equals_oracle",
       "Tier exact: the verdict is the exact one, and the bracket the two S next to the TOI, to the last "
       "bit.",
       Needs::proof, &exact_equals_oracle},
      {"exact_queries_agree",
       "Tier exact: overlap, swept overlap and line say what the cast and the exact oracle say, to the last "
       "bit.",
       Needs::proof, &exact_queries_agree},
  };
}

}  // namespace graze::law
