#include "properties/law.hpp"

#include "properties/laws_exact.hpp"
#include "properties/laws_metamorphic.hpp"
#include "properties/laws_oracle.hpp"
#include "properties/laws_proof.hpp"

namespace graze::law {

namespace {

constexpr Law kLaws[] = {
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
    {"answer_is_consistent",
     "Outcome and bracket say one thing; a normal is unit and does not follow the motion.",
     Needs::metamorphic, &answer_is_consistent},
    {"bad_input_is_refused",
     "A NaN, an infinity, an empty hull, a negative extent or q = 0 is refused at the door.",
     Needs::metamorphic, &bad_input_is_refused},
    {"proof_is_accepted", "Every proof is accepted by the checker.", Needs::proof, &proof_is_accepted},
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
    {"proof_is_tight", "A proof's bounds are within kappa u scale of the bracket's.", Needs::oracle,
     &proof_is_tight},
    {"certified_decides",
     "Tier certified leaves a verdict open only where clearance or depth is below the width of its row.",
     Needs::oracle, &certified_decides},
    {"exact_equals_oracle",
     "Tier exact: the verdict is the exact one, and the bracket the two S next to the TOI, to the last bit.",
     Needs::proof, &exact_equals_oracle},
    {"exact_queries_agree",
     "Tier exact: overlap, swept overlap and line say what the cast and the exact oracle say, to the last "
     "bit.",
     Needs::proof, &exact_queries_agree},
};

}  // namespace

std::span<const Law> laws() { return kLaws; }

const Law* find_law(std::string_view name) {
  for (const Law& law : kLaws) {
    if (law.name == name) return &law;
  }
  return nullptr;
}

}  // namespace graze::law
