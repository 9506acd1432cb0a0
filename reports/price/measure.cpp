#include "reports/price/measure.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/format/names.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/checker/check_rotating_proof.hpp"
#include "properties/judge/by_proof.hpp"
#include "properties/judge/judge.hpp"
#include "properties/judge/limits.hpp"
#include "properties/judge/rotating_errors.hpp"

namespace graze::price {

using corpus::Case;
using engine::Answer;
using engine::Kind;
using engine::Method;
using law::over;

namespace {

const Method* reference_for(Kind kind) {
  return kind == Kind::rotating ? engine::find_method(Kind::rotating, "certified/double") : nullptr;
}

// An infinite error or NaN is not a number to report. The answer is counted among the failures.
double finite(double error) { return std::isfinite(error) ? error : kNone; }

bool is_contact(Outcome outcome) {
  return outcome == Outcome::hit || outcome == Outcome::initially_overlapping;
}

}  // namespace

Judge::Judge(Case problem, Kind kind) : truth_(std::move(problem), reference_for(kind)), kind_(kind) {
  settle();
}

void Judge::settle() {
  if (kind_ == Kind::query) {
    by_ = law::is_exactly_decided(truth_.problem()) ? TruthBy::exact : TruthBy::bracket;
    return;
  }
  if (kind_ == Kind::linear) {
    const oracle::CaseTruth& cast = truth_.cast();
    outcome_ = cast.outcome();
    lower_ = cast.toi_lower();
    upper_ = cast.toi_upper();
    scale_ = cast.scale().high;
    by_ = outcome_ == Outcome::not_converged ? TruthBy::open
          : cast.is_exact()                  ? TruthBy::exact
                                             : TruthBy::bracket;
    return;
  }
  scale_ = law::scale_of(truth_.problem());
  speed_ = law::top_speed_of(truth_.problem());
  if (truth_.learn_from_reference()) {
    const law::ProvedBracket& proved = truth_.proved();
    if (proved.lower == kInfinity<double>) outcome_ = Outcome::miss;
    if (proved.upper <= truth_.problem().t_max)
      outcome_ = proved.upper == 0 ? Outcome::initially_overlapping : Outcome::hit;
    lower_ = proved.lower;
    upper_ = proved.upper;
    by_ = TruthBy::proof;
  }
  if (outcome_ == Outcome::not_converged) {
    const oracle::RotatingTruth& bracket = truth_.bracket();
    outcome_ = bracket.outcome();
    lower_ = bracket.toi_lower();
    upper_ = bracket.toi_upper();
    by_ = outcome_ == Outcome::not_converged ? TruthBy::open : TruthBy::bracket;
  }
}

Judge::Off Judge::off_linear(double t) {
  const oracle::CaseTruth& cast = truth_.cast();
  Off off;
  off.backward = finite(over(cast.backward_error(t).high, scale_));
  off.forward = finite(over(cast.forward_error(t).high, scale_));
  off.late = cast.compare(t) > 0;
  if (off.late) off.late_by = over(cast.lateness(t).high, scale_);
  return off;
}

Judge::Off Judge::off_turning(double t) {
  Off off;
  // Within the proved bracket nothing is known of the time but the bracket: the error is its width at most.
  const double from_lower = std::abs(t - lower_), from_upper = std::abs(t - upper_);
  off.forward = finite(over(std::max(from_lower, from_upper) * speed_, scale_));
  const oracle::RotatingTruth& truth = by_ == TruthBy::proof ? truth_.beside_proof() : truth_.bracket();
  off.late = t > upper_;
  const double depth = t > lower_ ? truth.depth_before(t).high : 0;
  off.backward = finite(over(std::max(truth.distance_at(t).high, depth), scale_));
  if (off.late) off.late_by = finite(over(depth, scale_));
  return off;
}

const Judge::Off& Judge::off(double t) {
  const auto found = seen_.find(t);
  if (found != seen_.end()) return found->second;
  return seen_.emplace(t, kind_ == Kind::linear ? off_linear(t) : off_turning(t)).first->second;
}

void Judge::judge(Measured& measured, const Method& method, const Answer& answer) {
  if (!measured.asked || measured.refused) return;
  if (kind_ == Kind::query) {
    Case problem = truth_.problem();
    problem.query = method.query;
    law::Truth truth(problem);
    const law::Judgement judgement = law::judge(truth, method, answer, Request::verdict, true);
    measured.backward = finite(judgement.errors.backward);
    measured.width = measured.backward;
    measured.wrong = !judgement.wrong.empty();
    return;
  }
  if (by_ == TruthBy::open) return;
  if (answer.outcome == Outcome::miss) {
    if (!is_contact(outcome_)) return;
    measured.wrong = true;
    if (!depth_) {
      depth_ = kind_ == Kind::linear   ? truth_.cast().depth().high
               : by_ == TruthBy::proof ? truth_.beside_proof().depth_before(truth_.problem().t_max).high
                                       : truth_.bracket().depth().high;
    }
    measured.denied = finite(over(*depth_, scale_));
    return;
  }
  if (outcome_ == Outcome::miss) {
    if (answer.outcome == Outcome::not_converged) return;
    measured.wrong = true;
    if (!clearance_) {
      clearance_ = kind_ == Kind::linear ? truth_.cast().clearance().high : truth_.bracket().clearance().high;
    }
    measured.denied = finite(over(*clearance_, scale_));
    return;
  }
  if (!method.holds.time) return;
  if (!std::isfinite(answer.toi_lower)) {
    measured.no_time = true;
    return;
  }
  const Off& lower = off(answer.toi_lower);
  measured.backward = lower.backward;
  measured.forward = lower.forward;
  measured.late = lower.late;
  measured.late_by = lower.late_by;
  measured.width = measured.backward;
  if (std::isfinite(answer.toi_upper) && answer.toi_upper != answer.toi_lower)
    measured.width = std::fmax(measured.width, off(answer.toi_upper).backward);
}

Shown Judge::shown() const {
  Shown shown{.id = truth_.problem().id, .outcome = std::string(corpus::name_of(outcome_))};
  if (kind_ == Kind::query) shown.outcome.clear();
  if (is_contact(outcome_) && std::isfinite(lower_) && std::isfinite(upper_))
    shown.toi = std::pair(lower_, upper_);
  return shown;
}

Measured begun(const Case& problem, const Method& method, const Answer& answer, Request request) {
  Measured measured;
  if (answer.declined) {
    measured.asked = false;
    return measured;
  }
  measured.refused = answer.failure != engine::Failure::none || answer.outcome == Outcome::invalid_input;
  measured.not_converged = answer.outcome == Outcome::not_converged || answer.stalled;
  if (method.is_ours()) {
    measured.iterations = answer.counters.iterations;
    measured.supports = answer.counters.supports;
  }
  if (!asks_for(request, Request::proof)) return measured;
  const Case seen = method.seen(problem);
  if (answer.proof) {
    measured.proved = oracle::check_proof(seen, *answer.proof).accepted() &&
                      law::proves_verdict(*answer.proof, answer.outcome);
  }
  if (answer.rotating_proof) {
    measured.proved = oracle::check_rotating_proof(seen, *answer.rotating_proof).accepted() &&
                      law::proves(*answer.rotating_proof, answer);
  }
  return measured;
}

}  // namespace graze::price
