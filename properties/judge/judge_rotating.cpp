// Judges answers to casts of bodies that may rotate.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "oracles/checker/check_record.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/by_proof.hpp"
#include "properties/judge/judge.hpp"
#include "properties/judge/judge_followed.hpp"
#include "properties/judge/judge_start.hpp"
#include "properties/judge/rotating_errors.hpp"

namespace graze::law {
namespace {

using engine::Answer;
using oracle::RotatingTruth;

// The part of an answer that accepted proofs leave open.
enum class Open { nothing, width, anything };

// With l <= TOI <= u proved and V the top speed of a point of one body against the other, two bounds follow. The bodies
// are no farther apart at t than (u - t) V, and before t no deeper in each other than (t - l) V. Both are rounded
// outward, and so is the comparison: a result within the guarantee is then so without predicate_error.
Open left_open_by(const ProvedBracket& proved, const Answer& answer, const Limits& limits) {
  const auto way = [&](double from, double to) {
    return std::max(0.0, to - from) * limits.speed * kSlack * kSlack;
  };
  switch (answer.outcome) {
    case Outcome::miss:
      return proved.lower == kInfinity<double> ? Open::nothing : Open::anything;
    case Outcome::initially_overlapping:
      return proved.upper == 0 ? Open::nothing : Open::anything;
    case Outcome::hit: {
      if (!(proved.upper < kInfinity<double>)) return Open::anything;
      if (way(proved.lower, answer.toi_lower) > (limits.strict ? 0 : limits.limit))
        return Open::anything;  // late
      if (way(answer.toi_upper, proved.upper) > (limits.strict ? 0 : limits.wide))
        return Open::anything;  // early
      const bool narrow =
          way(answer.toi_lower, proved.upper) <= limits.wide + limits.rounding_at(answer.toi_lower) &&
          way(proved.lower, answer.toi_upper) <= limits.wide + limits.rounding_at(answer.toi_upper);
      return narrow ? Open::nothing : Open::width;
    }
    case Outcome::not_converged:
    case Outcome::invalid_input:
      break;
  }
  return Open::anything;
}

class RotatingJudge {
 public:
  RotatingJudge(Truth& truth, const engine::Method& method, const Answer& answer, Request request)
      : truth_(truth), method_(method), answer_(answer), request_(request) {
    judgement_.outcome = answer.outcome;
  }

  // With `oracle` it is called whatever the proofs show.
  Judgement operator()(bool oracle) {
    if (is_settled_by_validity()) return judgement_;
    const corpus::Case& problem = truth_.problem();
    if (std::string why = senseless(answer_, problem.t_max); !why.empty() && method_.holds.time) {
      add_fault(judgement_.wrong, std::move(why));
      return judgement_;
    }
    if (problem.start_policy == StartPolicy::pass_over) {
      start_passed_over(oracle);
      return judgement_;
    }
    proof();
    const Open open = left_open(problem);
    if (open == Open::nothing && !oracle) return judgement_;
    if (open == Open::width && !oracle) {
      const RotatingTruth& beside = truth_.beside_proof();
      limits_ = limits_of(method_, problem, beside.scale().high);
      width(beside);
      return judgement_;
    }
    judgement_.by_oracle = true;
    const RotatingTruth& truth = truth_.bracket();
    limits_ = limits_of(method_, problem, truth.scale().high);
    judgement_.open = truth.outcome() == Outcome::not_converged;
    if (judgement_.open) judgement_.why_open = truth.reason();
    switch (answer_.outcome) {
      case Outcome::miss:
        miss(truth);
        break;
      case Outcome::not_converged:
        not_converged(truth);
        break;
      default:
        contact(truth);
        break;
    }
    if (judgement_.open && stands_within(truth)) judgement_.open = false;
    judgement_.errors.scale = limits_.scale;
    return judgement_;
  }

 private:
  using Error = RotatingError(const RotatingTruth&, const Answer&, const Limits&);

  [[nodiscard]] double in_scale(double length) const {
    return std::isnan(length) ? length : over(length, limits_.scale);
  }
  // The error, its fault noted.
  RotatingError take(Error* error, const RotatingTruth& truth, std::string& fault) {
    RotatingError found = error(truth, answer_, limits_);
    if (!found.fault.empty()) add_fault(fault, found.fault);
    return found;
  }

  bool is_settled_by_validity() {
    const corpus::Case& problem = truth_.problem();
    const std::string invalid = why_invalid(problem);
    const bool refused = answer_.outcome == Outcome::invalid_input;
    const bool endless =
        problem.t_max == kInfinity<double> && (!refused || answer_.invalid == Invalid::not_linear);
    const bool unfollowed =
        problem.start_policy == StartPolicy::pass_over && refused && answer_.invalid == Invalid::not_followed;
    if (invalid.empty() && (endless || unfollowed)) {
      judgement_.skipped = true;
      return true;
    }
    if (refused != !invalid.empty()) {
      add_fault(judgement_.wrong, refused ? "refuses a valid case" : "answers a case that has " + invalid);
    }
    return refused || !invalid.empty();
  }

  // A start that is apart is treated like any other case, also if it is apart by less than counts.
  void start_passed_over(bool oracle) {
    const corpus::Case& problem = truth_.problem();
    const RotatingTruth start = truth_from_start(problem);
    const Limits limits = limits_of(method_, problem, start.scale().high);
    const double apart = start.distance_at(0).low;
    if (apart > 0) {
      Truth reported(reporting(problem));
      Judgement judgement = RotatingJudge(reported, method_, answer_, request_)(oracle);
      if (answer_.passed_over && apart > followed_depth(limits))
        add_fault(judgement.wrong, "says that it passed over the start, which is no contact");
      if (apart > followed_depth(limits) || !(judgement.faulty() || judgement.stalled)) {
        judgement_ = std::move(judgement);
        return;
      }
    }
    judge_followed(judgement_, start, problem, answer_, limits, request_);
  }

  // No verdict is proved, only that the bodies come no farther than a part of the width from touching:
  // clearance and depth are below it. An answer that leaves the verdict open is right then. So is one that
  // the guarantee lets decide by as little, if its times are right.
  [[nodiscard]] bool stands_within(const RotatingTruth& truth) const {
    const bool decides = answer_.outcome != Outcome::not_converged;
    if (decides && limits_.strict) return false;
    const double limit = limits_.strict ? limits_.wide : limits_.limit;
    const bool not_late = answer_.outcome == Outcome::miss || truth_.proved().lower >= answer_.toi_lower ||
                          truth.toi_lower() >= answer_.toi_lower ||
                          (!limits_.strict && truth.depth_before(answer_.toi_lower).high <= limit);
    if (!not_late || truth.clearance().high > limit || truth.depth().high > limit) return false;
    if (answer_.outcome != Outcome::hit) return true;
    return truth.backward_error(answer_.toi_lower).high <=
               limits_.wide + limits_.rounding_at(answer_.toi_lower) &&
           truth.backward_error(answer_.toi_upper).high <=
               limits_.wide + limits_.rounding_at(answer_.toi_upper);
  }

  // By the scale in rounded doubles, brought below the true one.
  Open left_open(const corpus::Case& problem) {
    const Limits limits = limits_of(method_, problem, scale_of(problem) / kSlack);
    const Open open = left_open_by(truth_.proved(), answer_, limits);
    if (open != Open::anything || !truth_.learn_from_reference()) return open;
    return left_open_by(truth_.proved(), answer_, limits);
  }

  void proof() {
    if (answer_.rotating_proof) {
      const oracle::RotatingVerdict verdict = truth_.check(*answer_.rotating_proof);
      if (!verdict.accepted() || !verdict.detail.empty()) {
        judgement_.proof = ProofState::refused;
        judgement_.false_proof = fmt::format("{}: {}", to_string(verdict.refusal), verdict.detail);
      } else if (proves(*answer_.rotating_proof, answer_)) {
        judgement_.proof = ProofState::accepted;
      }
    }
    // A bracket that claims nothing needs no proof. A contact that no proof can name has a proof of its lower
    // end.
    const bool in_part = answer_.rotating_proof && judgement_.proof == ProofState::none &&
                         claims_contact(answer_) && !oracle::can_name_contact(truth_.problem()) &&
                         answer_.rotating_proof->toi_lower >= answer_.toi_lower;
    const bool claims = answer_.toi_lower > 0 || answer_.toi_upper < kInfinity<double>;
    if (method_.is_certified() && asks_for(request_, Request::proof) && claims &&
        judgement_.proof == ProofState::none && !answer_.passed_over && !in_part) {
      add_fault(judgement_.unproved, answer_.rotating_proof ? "its proof claims less than the answer"
                                                            : "a certified answer without a proof");
    }
  }

  void miss(const RotatingTruth& truth) {
    if (judgement_.open || truth.outcome() == Outcome::miss) return;
    const RotatingError denied = take(&law::verdict_error, truth, judgement_.wrong);
    judgement_.errors.passed = in_scale(denied.length);
    if (denied.fault.empty())
      (denied.length > limits_.limit ? judgement_.hidden : judgement_.within_tolerance) = true;
  }

  // A hit, or a start in contact.
  void contact(const RotatingTruth& truth) {
    if (truth.outcome() == Outcome::miss) {
      const RotatingError claimed = take(&law::verdict_error, truth, judgement_.wrong);
      judgement_.errors.backward = in_scale(claimed.length);
      if (!claimed.fault.empty()) return;
      judgement_.within_tolerance = true;
    }
    if (method_.holds.time) {
      late(truth);
      take(&law::early_error, truth, judgement_.early);
      width(truth);
      take(&law::distance_error, truth, judgement_.off);
    }
    if (answer_.outcome != Outcome::hit)
      return judge_start(judgement_, truth_, answer_, method_, limits_, request_);
    if (asks_for(request_, Request::normal))
      judgement_.errors.normal = in_scale(take(&law::normal_error, truth, judgement_.bad_contact).length);
    if (asks_for(request_, Request::witnesses))
      judgement_.errors.witness = in_scale(take(&law::witness_error, truth, judgement_.bad_contact).length);
  }

  void width(const RotatingTruth& truth) {
    const RotatingError found = take(&law::width_error, truth, judgement_.off);
    judgement_.errors.backward = in_scale(found.length);
    judgement_.errors.over_limit = found.over_limit;
  }

  void not_converged(const RotatingTruth& truth) {
    late(truth);
    take(&law::early_error, truth, judgement_.early);
    take(&law::distance_error, truth, judgement_.off);
    // If clearance or depth is below the limit, or a flat C has depth 0, nothing decides.
    const RotatingError left = take(&law::undecided_error, truth, judgement_.undecided);
    const bool decides = left.length > (limits_.strict ? limits_.wide : limits_.limit);
    judgement_.stalled = decides || !left.fault.empty();
    judgement_.within_tolerance = !judgement_.stalled;
    if (!asks_for(request_, Request::normal) || !asks_for(request_, Request::witnesses)) return;
    if (const RotatingError open = open_error(truth, truth_.problem(), answer_, limits_); !open.fault.empty())
      add_fault(judgement_.bad_contact, open.fault);
  }

  void late(const RotatingTruth& truth) {
    const RotatingError passed = take(&law::late_error, truth, judgement_.late);
    if (std::isnan(passed.length)) return;
    judgement_.errors.passed = in_scale(passed.length);
    if (passed.fault.empty() && passed.length > limits_.limit) judgement_.hidden = true;
  }

  Truth& truth_;
  const engine::Method& method_;
  const Answer& answer_;
  Request request_;
  Limits limits_;
  Judgement judgement_;
};

}  // namespace

Judgement judge_rotating(Truth& truth, const engine::Method& method, const Answer& answer, Request request,
                         bool measure) {
  return RotatingJudge(truth, method, answer, request)(measure);
}

}  // namespace graze::law
