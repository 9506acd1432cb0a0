// Laws that compare one answer with an oracle's knowledge, each within the method's guarantee.
#include <fmt/format.h>

#include <cmath>

#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/judge/own_frames.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;
using oracle::CaseTruth;

using Fault = std::string (*)(const CaseTruth&, const Answer&, double);

using Bound = double (*)(const Method&, const Case&);

namespace {

LawResult judged_by(Fault fault, const Case& problem, const Method& method, Bound bound = &proved_bound_of) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  if (const auto open = without_truth(seen)) return *open;
  const Answer answer = method.ask(seen, {});
  const CaseTruth& truth = truth_of(seen);
  const std::string reason = fault(truth, answer, bound(method, seen));
  if (!reason.empty()) return broken(reason + "; answered: " + describe(answer));
  LawResult result = holds({label_of(truth.outcome())});
  if (answer.outcome == Outcome::not_converged) result.labels.push_back("not_converged");
  return result;
}

LawResult verdict_is_right(const Case& problem, const Method& method) {
  return judged_by(&verdict_fault, problem, method);
}

LawResult never_late(const Case& problem, const Method& method) {
  return judged_by(&late_fault, problem, method);
}

LawResult bracket_holds_toi(const Case& problem, const Method& method) {
  return judged_by(
      [](const CaseTruth& truth, const Answer& answer, double bound) {
        std::string late = late_fault(truth, answer, bound);
        return late.empty() ? early_fault(truth, answer, bound) : late;
      },
      problem, method);
}

LawResult time_is_stable(const Case& problem, const Method& method) {
  return judged_by(&time_fault, problem, method, &bound_of);
}

LawResult certified_decides(const Case& problem, const Method& method) {
  if (!method.is_certified()) return not_applicable("not a method of tier certified");
  return judged_by(&undecided_fault, problem, method, &bound_of);
}

// The width, and the cost of rounding toi_lower to the scalar, because an open answer may have no upper end.
double width_at_lower(const Method& method, const Case& seen, const Answer& answer) {
  return limits_of(method, seen, truth_of(seen).scale().high).wide_at(answer.toi_lower);
}

// Ties are open for the oracle as well, but its distances hold all the same.
LawResult certified_lower_is_near(const Case& problem, const Method& method) {
  if (!method.is_certified()) return not_applicable("not a method of tier certified");
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  if (!has_truth(seen)) return not_applicable("no oracle takes the case");
  const Answer answer = method.ask(seen, {});
  const std::string fault =
      lower_fault(truth_of(seen), answer, seen.t_max, width_at_lower(method, seen, answer));
  if (!fault.empty()) return broken(fault + "; answered: " + describe(answer));
  return holds({label_of(answer.outcome)});
}

LawResult open_answer_is_near_contact(const Case& problem, const Method& method) {
  if (!method.is_certified()) return not_applicable("not a method of tier certified");
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  const Answer answer = method.ask(seen, {.request = Request::normal | Request::witnesses});
  if (answer.outcome != Outcome::not_converged) return holds({label_of(answer.outcome)});
  if (!has_truth(seen)) return not_applicable("no oracle takes the case");
  const std::string fault =
      open_answer_fault(truth_of(seen), method, seen, answer, width_at_lower(method, seen, answer));
  if (!fault.empty()) return broken(fault + "; answered: " + describe(answer));
  return holds({label_of(answer.outcome)});
}

LawResult normal_supports(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  if (const auto open = without_truth(seen)) return *open;
  const Answer answer = method.ask(seen, {.request = Request::normal});
  if (answer.outcome != Outcome::hit) return holds({label_of(answer.outcome)});
  const CaseTruth& truth = truth_of(seen);
  if (truth.outcome() != Outcome::hit)
    return holds({label_of(answer.outcome), "near a start in contact or a miss"});
  const std::string fault = normal_fault(seen, answer, answer.normal, contact_bound_of(method, seen));
  if (!fault.empty()) return broken(fault + ": " + describe(answer));
  return holds({label_of(answer.outcome)});
}

LawResult witnesses_touch(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  if (const auto open = without_truth(seen)) return *open;
  const Answer answer = method.ask(seen, {.request = Request::witnesses});
  if (answer.outcome != Outcome::hit) return holds({label_of(answer.outcome)});
  // At the largest float the bodies may still be apart.
  if (is_beyond_range(answer.toi_lower, answer.toi_upper, kUnitRoundoff<float>))
    return holds({label_of(answer.outcome), "beyond range"});
  const CaseTruth& truth = truth_of(seen);
  const double bound = std::max(contact_bound_of(method, seen), bound_of(method, seen));
  // A coordinate of a witness, position + t displacement + ..., is rounded at the size of its largest term.
  const auto rounding = [&](const Body<double>& body, const Vec3<double>& point) {
    const double size = std::max({point.cwiseAbs().maxCoeff(), body.position.cwiseAbs().maxCoeff(),
                                  answer.toi_lower * body.displacement.cwiseAbs().maxCoeff()});
    return 8 * method.unit_roundoff * size;
  };
  const double slack_a = rounding(seen.a, answer.point_a), slack_b = rounding(seen.b, answer.point_b);
  for (const char body : {'a', 'b'}) {
    const Vec3<double>& point = body == 'a' ? answer.point_a : answer.point_b;
    const double away = truth.distance_from_body(body, answer.toi_lower, point).low;
    if (!(away <= bound + (body == 'a' ? slack_a : slack_b))) {
      return broken(fmt::format("the witness of {} lies {} away from it at toi_lower: {}", body, away,
                                describe(answer)));
    }
  }
  // toi_lower may be a bound short of contact, and either witness a bound off its body.
  const double gap = (answer.point_a - answer.point_b).norm();
  if (!(gap <= seen.target_distance + 3 * bound + slack_a + slack_b)) {
    return broken(fmt::format("the witnesses of a contact lie {} apart: {}", gap, describe(answer)));
  }
  return holds({label_of(answer.outcome)});
}

LawResult proof_is_tight(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  if (const auto open = without_truth(seen)) return *open;
  const Answer answer = method.ask(seen, {.request = Request::proof});
  if (answer.outcome != Outcome::hit && answer.outcome != Outcome::miss)
    return holds({label_of(answer.outcome)});
  if (!answer.proof) return holds({label_of(answer.outcome), "no proof"});
  const CaseTruth& truth = truth_of(seen);
  // The bracket may be a bound off, and the proof a bound wider than the bracket.
  const double bound = 2 * bound_of(method, seen) + unseen_of_own_frames(seen);
  const Proof& proof = *answer.proof;
  LawResult result = holds({label_of(answer.outcome)});
  if (answer.outcome == Outcome::miss) {
    if (std::isinf(proof.toi_lower)) return result;
    result.labels.push_back("miss unproved");
    if (truth.clearance().low > bound) {
      return broken(fmt::format("a miss of clearance {} is not proved, only TOI >= {}", truth.clearance().low,
                                decimal(proof.toi_lower)));
    }
    return result;
  }
  // If the path misses by less than the guarantee allows, no axis has to prove its end near the claimed
  // contact: n.v is rounding there.
  if (truth.outcome() != Outcome::hit)
    return holds({label_of(answer.outcome), "near a start in contact or a miss"});
  // For curved shapes the halves of a hit's proof are not judged. A portal rests on points a little inside
  // the shapes, which costs 130 u scale and more. Past a rounded side an axis may fall 6e-8 of the scale
  // short.
  if (const auto open = without_exact_truth(seen)) return *open;
  const double short_of = proof.has_axis ? truth.distance_at(proof.toi_lower).low : 0;
  if (short_of > bound) {
    return broken(fmt::format("the axis proves only toi_lower {}, {} short of contact: {}",
                              decimal(proof.toi_lower), short_of, describe(answer)));
  }
  const bool upper = std::isfinite(proof.toi_upper);
  const double beyond = upper ? truth.depth_before(proof.toi_upper).low : 0;
  if (beyond > bound) {
    return broken(fmt::format("the portal proves only toi_upper {}, {} deep: {}", decimal(proof.toi_upper),
                              beyond, describe(answer)));
  }
  if (!proof.has_axis) result.labels.push_back("no axis");
  if (!upper) result.labels.push_back("no portal");
  return result;
}

}  // namespace

std::vector<Law> linear_oracle_laws() {
  return {
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
       "Tier certified leaves a verdict open only where clearance or depth is below the guaranteed width.",
       Needs::oracle, &certified_decides},
      {"certified_lower_is_near",
       "At toi_lower of a certified answer the bodies are within the width of contact, or the motion ends "
       "there.",
       Needs::oracle, &certified_lower_is_near},
      {"open_answer_is_near_contact",
       "An open answer of tier certified has a unit normal, witnesses on their bodies, and a distance within "
       "the width.",
       Needs::oracle, &open_answer_is_near_contact},
  };
}

}  // namespace graze::law
