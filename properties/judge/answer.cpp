#include "properties/judge/answer.hpp"

#include <fmt/format.h>

#include "corpus/format/names.hpp"
#include "properties/judge/by_proof.hpp"
#include "properties/judge/contact.hpp"
#include "properties/judge/exact_answer.hpp"
#include "properties/judge/linear.hpp"
#include "properties/judge/own_frames.hpp"

namespace graze::tool {

using engine::Answer;
using oracle::CaseTruth;
using oracle::Enclosure;

const CaseTruth& Truth::exact() {
  if (!exact_) exact_ = std::make_unique<CaseTruth>(problem_);
  return *exact_;
}

std::string senseless(Outcome outcome, double lower, double upper, double t_max) {
  switch (outcome) {
    case Outcome::initially_overlapping:
      if (!(lower == 0 && upper == 0)) return "a start in contact has a time other than 0";
      return {};
    case Outcome::miss:
      if (!(lower == kInfinity<double> && upper == kInfinity<double>)) return "a miss has a finite time";
      return {};
    case Outcome::hit:
      if (!(0 <= lower && lower <= upper && upper < kInfinity<double> && lower <= t_max)) {
        return "a hit has a bracket that is no interval of times up to t_max";
      }
      return {};
    case Outcome::not_converged:
      if (!(0 <= lower && lower <= upper && lower < kInfinity<double>)) {
        return "the bracket of not_converged is no interval";
      }
      return {};
    case Outcome::invalid_input:
      return {};
  }
  return "an outcome that does not exist";
}

namespace {

bool claims_contact(Outcome outcome) {
  return outcome == Outcome::hit || outcome == Outcome::initially_overlapping;
}

void judge_by_oracle(Judgement& judgement, const CaseTruth& exact, const Answer& answer,
                     const corpus::Case& problem, const Limits& limits, Request request) {
  const double scale = exact.scale().high;
  const double limit = limits.kappa * limits.unit_roundoff * scale + law::unseen_of_trees(problem, scale);
  const bool contact = exact.outcome() != Outcome::miss;
  const auto beyond = [&](const Enclosure& error) { return error.low > limit; };
  const auto in_scale = [&](const Enclosure& error) { return fmt::format("{:.1e}", over(error.low, scale)); };

  if (answer.outcome == Outcome::miss) {
    if (!contact) return;
    const Enclosure depth = exact.depth();
    if (beyond(depth)) {
      convict(judgement.wrong, fmt::format("says miss; the path meets C {} of scale deep", in_scale(depth)));
    } else {
      judgement.excused = true;
    }
    return;
  }
  if (contact) {
    const Enclosure lateness = exact.lateness(answer.toi_lower);
    if (beyond(lateness)) {
      convict(judgement.late,
              fmt::format("toi_lower {:.17g} is past the contact at {:.17g}, {} of scale deep",
                          answer.toi_lower, exact.toi_lower(), in_scale(lateness)));
    }
  }
  if (claims_contact(answer.outcome)) {
    if (!contact) {
      const Enclosure clearance = exact.clearance();
      if (beyond(clearance)) {
        convict(judgement.wrong, fmt::format("says {}; the path stays {} of scale away",
                                             corpus::name_of(answer.outcome), in_scale(clearance)));
        return;
      }
      judgement.excused = true;
    }
    for (const double t : {answer.toi_lower, answer.toi_upper}) {
      const Enclosure error = exact.backward_error(t);
      if (beyond(error)) {
        convict(judgement.off, fmt::format("backward error {} of scale at t = {:.17g}", in_scale(error), t));
      }
    }
    const double contact_limit = limits.contact_kappa * limits.unit_roundoff * scale;
    judge_contact(judgement, exact, answer, problem, limits, contact_limit, request);
    return;
  }
  // not_converged. Its finite upper end claims contact by then; up to the first contact the distance from C
  // never grows (C is convex), so it is least at that end.
  if (answer.toi_upper < kInfinity<double> && (!contact || exact.compare(answer.toi_upper) < 0)) {
    const Enclosure apart = contact ? exact.distance_at(answer.toi_upper) : exact.clearance();
    if (beyond(apart)) {
      convict(judgement.wrong, fmt::format("says contact by {:.17g}; the path stays {} of scale away",
                                           answer.toi_upper, in_scale(apart)));
    }
  }
}

// The door. True if there is nothing more to judge.
bool is_settled_at_the_door(Judgement& judgement, const corpus::Case& problem, const Answer& answer) {
  judgement.outcome = answer.outcome;
  judgement.stalled = answer.outcome == Outcome::not_converged;
  const std::string invalid = why_invalid(problem);
  const bool refused = answer.outcome == Outcome::invalid_input;
  if (refused != !invalid.empty()) {
    convict(judgement.wrong, refused ? "refuses a valid case" : "answers a case that has " + invalid);
  }
  return refused || !invalid.empty();
}

// A hit at a time that the scalar cannot hold. True if there is nothing more to judge.
bool is_settled_beyond_range(Judgement& judgement, Truth& truth, const Answer& answer, const Limits& limits) {
  if (answer.outcome != Outcome::hit || truth.problem().t_max < kInfinity<double> ||
      !law::is_beyond_range(answer.toi_lower, answer.toi_upper, limits.unit_roundoff)) {
    return false;
  }
  judgement.by_oracle = true;
  const CaseTruth& exact = truth.exact();
  const bool contact = exact.outcome() != Outcome::miss;
  if (contact && exact.compare(answer.toi_lower) <= 0) return true;
  // Contact before that, or none: by how much, as of any other time and verdict.
  const double scale = exact.scale().high;
  const double limit = limits.width > 0 ? 0
                                        : limits.kappa * limits.unit_roundoff * scale +
                                              law::unseen_of_trees(truth.problem(), scale);
  const double error = (contact ? exact.lateness(answer.toi_lower) : exact.clearance()).low;
  if (error <= limit) {
    judgement.excused = true;
  } else {
    convict(judgement.wrong,
            fmt::format("a time beyond the scalar's range; {} by {:.1e} of scale",
                        contact ? "contact is before that," : "the path stays away", over(error, scale)));
  }
  return true;
}

}  // namespace

Judgement judge(Truth& truth, const Answer& answer, const Limits& limits, bool ask_oracle, Request request) {
  Judgement judgement;
  if (is_settled_at_the_door(judgement, truth.problem(), answer)) return judgement;
  if (is_settled_beyond_range(judgement, truth, answer, limits)) return judgement;
  if (const std::string why =
          senseless(answer.outcome, answer.toi_lower, answer.toi_upper, truth.problem().t_max);
      !why.empty()) {
    convict(judgement.wrong, why);
    return judgement;
  }

  bool settled = false;
  if (answer.proof) {
    const oracle::Verdict verdict = oracle::check_proof(truth.problem(), *answer.proof);
    if (!verdict.accepted()) {
      judgement.proof = ProofState::refused;
      judgement.false_proof = fmt::format("{}: {}", to_string(verdict.refusal), verdict.detail);
    } else if (proves_verdict(*answer.proof, answer.outcome)) {
      judgement.proof = ProofState::accepted;
      settled = settled_by(*answer.proof, truth.problem(), answer, limits);
    }
  }
  if (settled && !ask_oracle) return judgement;
  judgement.by_oracle = true;
  judge_by_oracle(judgement, truth.exact(), answer, truth.problem(), limits, request);
  judgement.errors = errors_of(truth, answer, request);
  return judgement;
}

namespace {

void judge_certified_by_oracle(Judgement& judgement, const CaseTruth& exact, const Answer& answer,
                               const corpus::Case& problem, const Limits& limits) {
  const double width = limits.width * exact.scale().high + law::unseen_of_own_frames(problem);
  const double time = std::min(exact.toi_upper(), answer.toi_upper);  // where the oracle is open, the claim
  const double bound = width + rounding_of_times(problem, time, limits);
  convict(judgement.wrong, law::verdict_fault(exact, answer, 0));
  if (answer.outcome == Outcome::initially_overlapping && exact.outcome() == Outcome::hit)
    convict(judgement.wrong, "claims contact at t = 0 of bodies that are apart then");
  convict(judgement.late, law::late_fault(exact, answer, 0));
  convict(judgement.off, law::early_fault(exact, answer, 0));
  convict(judgement.off, law::time_fault(exact, answer, bound));
  if (answer.outcome == Outcome::not_converged) {
    judgement.stalled = !law::undecided_fault(exact, answer, bound).empty();
    judgement.excused = !judgement.stalled;
  }
  const double limit = limits.contact_kappa * limits.unit_roundoff * exact.scale().high + bound;
  judge_contact(judgement, exact, answer, problem, limits, limit, Request::everything);
}

}  // namespace

Judgement judge_certified(Truth& truth, const Answer& answer, const Limits& limits, bool ask_oracle) {
  const corpus::Case& problem = truth.problem();
  Judgement judgement;
  if (is_settled_at_the_door(judgement, problem, answer)) return judgement;
  if (is_settled_beyond_range(judgement, truth, answer, limits)) return judgement;
  if (std::string why = senseless(answer.outcome, answer.toi_lower, answer.toi_upper, problem.t_max);
      !why.empty()) {
    convict(judgement.wrong, std::move(why));
    return judgement;
  }
  bool settled = false;
  if (answer.proof) {
    const oracle::Verdict verdict = oracle::check_proof(problem, *answer.proof);
    if (!verdict.accepted()) {
      judgement.proof = ProofState::refused;
      judgement.false_proof = fmt::format("{}: {}", to_string(verdict.refusal), verdict.detail);
    } else if (proves_verdict(*answer.proof, answer.outcome)) {
      judgement.proof = ProofState::accepted;
      settled = certified_by(*answer.proof, problem, answer, limits);
    }
  }
  if (settled && !ask_oracle) return judgement;
  judgement.by_oracle = true;
  judge_certified_by_oracle(judgement, truth.exact(), answer, problem, limits);
  judgement.errors = errors_of(truth, answer, Request::everything);
  return judgement;
}

Judgement judge_exact(Truth& truth, const Answer& answer, const Limits& limits, bool ask_oracle) {
  const corpus::Case& problem = truth.problem();
  const bool in_float = limits.unit_roundoff == kUnitRoundoff<float>;
  Judgement judgement;
  if (why_invalid(problem).empty() && !engine::is_exact_question(problem)) {
    judgement.outcome = answer.outcome;
    judgement.not_asked = true;
    if (answer.outcome != Outcome::invalid_input || answer.invalid != Invalid::not_exact) {
      judgement.wrong = "answers a case that is not for the exact tier";
    }
    return judgement;
  }
  if (is_settled_at_the_door(judgement, problem, answer)) return judgement;

  const law::ExactFinding finding = law::judge_exact_by_proof(problem, answer, in_float);
  if (finding.false_proof) {
    judgement.proof = ProofState::refused;
    judgement.false_proof = finding.fault;
  } else {
    judgement.proof = finding.fault.empty() && answer.proof ? ProofState::accepted : ProofState::none;
    judgement.wrong = finding.fault;
  }
  if (!ask_oracle && finding.settled) return judgement;
  judgement.by_oracle = true;
  const CaseTruth& exact = truth.exact();
  if (std::string why = law::exact_fault_by_truth(exact, answer, in_float); !why.empty()) {
    convict(judgement.wrong, std::move(why));
  }
  const double limit = limits.contact_kappa * limits.unit_roundoff * exact.scale().high;
  judge_contact(judgement, exact, answer, problem, limits, limit, Request::everything);
  judgement.errors = errors_of(truth, answer, Request::everything);
  return judgement;
}

Judgement judge_method(Truth& truth, const corpus::Case& problem, const engine::EngineMethod& method,
                       const Answer& answer, const engine::Guarantee* row, bool ask_oracle) {
  const Limits limits{.kappa = row != nullptr ? row->kappa(problem) : kPlainKappa,
                      .unit_roundoff = method.unit_roundoff,
                      .contact_kappa = row != nullptr ? row->contact_kappa(problem) : kPlainKappa,
                      .width = row != nullptr ? row->width.value_or(0) : 0};
  if (method.is_certified()) return judge_certified(truth, answer, limits, ask_oracle);
  return method.is_exact() ? judge_exact(truth, answer, limits, ask_oracle)
                           : judge(truth, answer, limits, ask_oracle, Request::everything);
}

}  // namespace graze::tool
