// The laws of rotating casts and of the plan: one line each.
#include "properties/laws/rotating/answer.hpp"
#include "properties/laws/rotating/oracle.hpp"
#include "properties/laws/rotating/plan.hpp"
#include "properties/laws/rotating/proof.hpp"
#include "properties/laws/rotating/standing.hpp"
#include "properties/laws/rotating/symmetry.hpp"
#include "properties/laws/rotating/time.hpp"
#include "properties/laws/rotating/validity.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

std::vector<Law> rotating_laws() {
  return {
      {"turning_swapping", "Swapping A and B keeps the bracket.", Needs::metamorphic, &turning_swapping},
      {"turning_scaling", "Multiplying every length by a power of two changes no time and no count.",
       Needs::metamorphic, &turning_scaling},
      {"turning_translating", "Translating both bodies by an exact amount keeps the bracket.",
       Needs::metamorphic, &turning_translating},
      {"turning_both", "Turning both bodies and their motion, or mirroring them, keeps the bracket.",
       Needs::metamorphic, &turning_both},
      {"stretching_time", "A step 2^k times as long at velocities 2^-k times as large has times times 2^k.",
       Needs::metamorphic, &stretching_time},
      {"turning_horizon", "A shorter step has the same first contact, or none before its end.",
       Needs::metamorphic, &turning_horizon},
      {"turning_splitting", "Casting from where the bodies are at s, on to T, finds the same first contact.",
       Needs::metamorphic, &turning_splitting},
      {"turning_superset", "A superset, or a larger target distance, is never hit later.", Needs::metamorphic,
       &turning_superset},
      {"turning_backwards",
       "On the way back contact is no later than T less the first one, and a miss stays a miss.",
       Needs::metamorphic, &turning_backwards},
      {"whole_turn_is_all", "A body that only turns meets nothing new after a whole turn.",
       Needs::metamorphic, &whole_turn_is_all},
      {"turning_stands_as_said",
       "Placed at a moment, bodies do not overlap before toi_lower, and are as near there as is said.",
       Needs::metamorphic, &turning_stands_as_said},
      {"pivot_is_a_line", "A pivot moved along its axis keeps the bracket.", Needs::metamorphic,
       &pivot_is_a_line},
      {"idle_pivot_is_nothing", "The pivot of a body that does not turn changes nothing.", Needs::metamorphic,
       &idle_pivot_is_nothing},
      {"turning_drifting", "A velocity that both bodies share keeps the bracket, and carries the witnesses.",
       Needs::metamorphic, &turning_drifting},
      {"unturned_is_linear", "Without turns the answer is the linear cast's.", Needs::metamorphic,
       &unturned_is_linear},
      {"unseen_turn_is_none", "A ball's turn about its centre, or a solid's about its axis, changes nothing.",
       Needs::metamorphic, &unseen_turn_is_none},
      {"as_one_stands_still", "Bodies that turn and move as one meet at t = 0 or never.", Needs::metamorphic,
       &as_one_stands_still},
      {"plan_changes_nothing", "Every economy on or off, verdicts stay and brackets meet.",
       Needs::metamorphic, &plan_changes_nothing},
      {"plan_spares_the_work", "What a plan spares is not done, and a plan says what is done.",
       Needs::metamorphic, &plan_spares_the_work},
      {"plan_is_monotone", "One more economy never leaves more to simulate.", Needs::metamorphic,
       &plan_is_monotone},
      {"turning_methods_meet", "The brackets of the methods of one scalar meet, each within its row.",
       Needs::metamorphic, &turning_methods_meet},
      {"turning_scalars_meet", "The brackets of a method in float and in double meet, each within its row.",
       Needs::metamorphic, &turning_scalars_meet},
      {"turning_budget", "With a larger budget a bracket is within the one before, and the whole one in it.",
       Needs::metamorphic, &turning_budget},
      {"tolerance_is_kept", "A tolerance widens a bracket by no more than itself, and makes no time late.",
       Needs::metamorphic, &tolerance_is_kept},
      {"turning_requesting",
       "Asking for less changes no verdict, costs no more and computes nothing unasked.", Needs::metamorphic,
       &turning_requesting},
      {"turning_answer_is_consistent", "Outcome and bracket say one thing.", Needs::metamorphic,
       &turning_answer_is_consistent},
      {"bad_turn_is_refused", "A NaN, an infinity, 2^31 radians, or a seen turn without an end is refused.",
       Needs::metamorphic, &bad_turn_is_refused},
      {"turning_proof_is_accepted", "Every proof is accepted, and says as much as the answer.", Needs::proof,
       &turning_proof_is_accepted},
      {"turning_verdict_is_right", "Contact or no contact is wrong only within the row.", Needs::oracle,
       &turning_verdict_is_right},
      {"turning_is_never_late", "toi_lower is not past the first contact by more than the row's depth.",
       Needs::oracle, &turning_is_never_late},
      {"turning_claims_no_contact_early", "At toi_upper the bodies have met.", Needs::oracle,
       &turning_claims_no_contact_early},
      {"turning_bracket_is_narrow", "Either end of a contact's bracket is as near to it as the row says.",
       Needs::oracle, &turning_bracket_is_narrow},
      {"turning_distance_is_stated", "At toi_lower the bodies are no farther apart than the answer says.",
       Needs::oracle, &turning_distance_is_stated},
      {"turning_certified_decides",
       "Tier certified leaves a verdict open only where clearance or depth is below the width of its row.",
       Needs::oracle, &turning_certified_decides},
      {"turning_contact_is_right", "A hit's normal separates the bodies, and its witnesses lie in them.",
       Needs::oracle, &turning_contact_is_right},
  };
}

}  // namespace graze::law
