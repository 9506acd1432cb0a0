// Answers to linear casts, of every tier.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "properties/edit/case.hpp"
#include "properties/judge/by_proof.hpp"
#include "properties/judge/exact_answer.hpp"
#include "properties/judge/judge.hpp"
#include "properties/judge/judge_contact.hpp"
#include "properties/judge/judge_start.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::law {
namespace {

using engine::Answer;
using engine::Method;
using oracle::CaseTruth;

class LinearJudge {
 public:
  LinearJudge(Truth& truth, const Method& method, const Answer& answer, Request request)
      : truth_(truth), method_(method), answer_(answer), request_(request) {
    judgement_.outcome = answer.outcome;
    judgement_.stalled = answer.outcome == Outcome::not_converged;
  }

  Judgement operator()(bool measure) {
    if (method_.is_exact() && is_not_asked()) return judgement_;
    if (is_settled_by_validity()) return judgement_;
    if (method_.is_exact()) {
      exact(measure);
      return judgement_;
    }
    if (is_settled_beyond_range()) return judgement_;
    if (std::string why = senseless(answer_, problem().t_max); !why.empty() && method_.holds.time) {
      add_fault(judgement_.wrong, std::move(why));
      return judgement_;
    }
    if (proof() && !measure) return judgement_;
    if (starts_unasked()) return judgement_;
    judgement_.by_oracle = true;
    const double granted = by_oracle();
    judgement_.errors = errors_of(truth_, answer_, request_);
    judgement_.errors.scale = truth_.cast().scale().high;
    start();
    if (!method_.is_ours()) judgement_.errors.backward = least_limit();
    // For an answer that did not converge, the guarantee states only that it is neither late nor early.
    if (answer_.outcome != Outcome::not_converged && !std::isnan(judgement_.errors.backward)) {
      // The proved part of the error, as in faults: for bodies apex to apex the oracle may know a contact to
      // 1e-5 only.
      judgement_.errors.over_limit = over(least_limit(), granted);
    }
    return judgement_;
  }

 private:
  [[nodiscard]] const corpus::Case& problem() const { return truth_.problem(); }

  // Input validation. True if there is nothing more to judge.
  bool is_settled_by_validity() {
    const std::string invalid = why_invalid(problem());
    const bool refused = answer_.outcome == Outcome::invalid_input;
    if (refused != !invalid.empty()) {
      add_fault(judgement_.wrong, refused ? "refuses a valid case" : "answers a case that has " + invalid);
    }
    return refused || !invalid.empty();
  }

  // A hit at a time that the scalar cannot hold. True if there is nothing more to judge.
  bool is_settled_beyond_range() {
    if (answer_.outcome != Outcome::hit || problem().t_max < kInfinity<double> ||
        !is_beyond_range(answer_.toi_lower, answer_.toi_upper, method_.unit_roundoff)) {
      return false;
    }
    judgement_.by_oracle = true;
    const CaseTruth& exact = truth_.cast();
    const bool contact = exact.outcome() != Outcome::miss;
    if (contact && exact.compare(answer_.toi_lower) <= 0) return true;
    // There is contact before that, or none. The error is measured as for any other time and verdict.
    const double scale = exact.scale().high;
    const double error = (contact ? exact.lateness(answer_.toi_lower) : exact.clearance()).low;
    if (error <= limits_of(method_, problem(), scale).limit) {
      judgement_.within_tolerance = true;
    } else {
      add_fault(judgement_.wrong,
                fmt::format("a time beyond the scalar's range; {} by {:.1e} of scale",
                            contact ? "contact is before that," : "the path stays away", over(error, scale)));
    }
    return true;
  }

  // Some third-party engines do not support a start in contact.
  bool starts_unasked() {
    if (method_.asks_starts || truth_.cast().outcome() != Outcome::initially_overlapping) return false;
    judgement_.skipped = true;
    judgement_.stalled = false;
    return true;
  }

  // Judges a start in contact by the oracle.
  void start() {
    judge_start(judgement_, truth_, answer_, method_,
                limits_of(method_, problem(), truth_.cast().scale().high), request_);
  }

  // Over scale: the least limit with which verdict and times would pass, by what is proved of each.
  [[nodiscard]] double least_limit() {
    const CaseTruth& exact = truth_.cast();
    const double scale = exact.scale().high;
    const bool contact = exact.outcome() != Outcome::miss, decided = !is_undecided(exact);
    double least = 0;
    if (answer_.outcome == Outcome::miss) return contact && decided ? over(exact.depth().low, scale) : 0;
    if (claims_contact(answer_) && !contact) least = exact.clearance().low;
    if (answer_.toi_lower > 0 && answer_.toi_lower < kInfinity<double> && contact)
      least = std::fmax(least, exact.lateness(answer_.toi_lower).low);
    if (!claims_contact(answer_) || !method_.holds.time) return over(least, scale);
    // The ends of a bracket that did not close do not count as claimed times.
    for (const double t : {answer_.toi_lower, answer_.toi_upper}) {
      if (t < kInfinity<double>) least = std::fmax(least, exact.backward_error(t).low);
    }
    return over(least, scale);
  }

  // The guarantee of an engine for bodies that touch and go no deeper.
  void touching(const CaseTruth& exact) {
    const engine::Touching promised =
        method_.guarantee == nullptr ? engine::Touching::either : method_.guarantee->touching;
    if (promised == engine::Touching::either || is_undecided(exact) || exact.outcome() == Outcome::miss ||
        exact.depth().high > 0 || answer_.outcome == Outcome::not_converged) {
      return;
    }
    if (claims_contact(answer_) == (promised == engine::Touching::contact)) return;
    add_fault(judgement_.wrong, fmt::format("says {} of bodies that touch and go no deeper, and promises {}",
                                            label_of(answer_.outcome),
                                            promised == engine::Touching::contact ? "contact" : "a miss"));
  }

  // True if the proof leaves nothing open.
  bool proof() {
    if (!answer_.proof) return false;
    const oracle::Verdict verdict = oracle::check_proof(problem(), *answer_.proof);
    // Magnitudes that the checker's arithmetic does not hold: it gives no verdict.
    if (verdict.refusal == oracle::Refusal::out_of_range) return false;
    if (!verdict.accepted()) {
      judgement_.proof = ProofState::refused;
      judgement_.false_proof = fmt::format("{}: {}", to_string(verdict.refusal), verdict.detail);
      return false;
    }
    if (!proves_verdict(*answer_.proof, answer_.outcome)) return false;
    judgement_.proof = ProofState::accepted;
    return is_settled_by(*answer_.proof, method_, problem(), answer_);
  }

  // Returns the error granted to either end of the bracket, over scale.
  double by_oracle() {
    const CaseTruth& exact = truth_.cast();
    const Limits limits = limits_of(method_, problem(), exact.scale().high);
    // If the oracle leaves the time open, the claim states the time of contact.
    const double wide = limits.wide_at(std::min(exact.toi_upper(), answer_.toi_upper));
    const double granted = over(wide, limits.scale);
    add_fault(judgement_.wrong, verdict_fault(exact, answer_, limits.limit));
    touching(exact);
    const bool contact = exact.outcome() != Outcome::miss, undecided = is_undecided(exact);
    if (limits.strict && answer_.outcome == Outcome::initially_overlapping &&
        exact.outcome() == Outcome::hit) {
      add_fault(judgement_.wrong, "claims contact at t = 0 of bodies that are apart then");
    }
    const bool errs = answer_.outcome == Outcome::miss ? contact : claims_contact(answer_) && !contact;
    judgement_.within_tolerance = errs && !undecided && judgement_.wrong.empty();
    if (!judgement_.wrong.empty() || answer_.outcome == Outcome::miss) return granted;

    if (method_.holds.time) {
      add_fault(judgement_.late, late_fault(exact, answer_, limits.limit));
      add_fault(judgement_.early, early_fault(exact, answer_, limits.limit + limits.early));
      add_fault(judgement_.off, time_fault(exact, answer_, wide));
    }
    // Tier certified and third-party engines may leave open a verdict that is decided by less than the limit.
    if ((limits.strict || !method_.is_ours()) && answer_.outcome == Outcome::not_converged &&
        wide < kInfinity<double>) {
      judgement_.undecided = undecided_fault(exact, answer_, wide);
      judgement_.stalled = !judgement_.undecided.empty();
      judgement_.within_tolerance = !judgement_.stalled;
    }
    if (limits.strict) {
      // An open answer may have no upper end, so the rounding cost is that of toi_lower.
      const double near = limits.wide_at(answer_.toi_lower);
      add_fault(judgement_.off, lower_fault(exact, answer_, problem().t_max, near));
      if (asks_for(request_, Request::normal) && asks_for(request_, Request::witnesses))
        add_fault(judgement_.bad_contact, open_answer_fault(exact, method_, problem(), answer_, near));
    }
    judge_contact(judgement_, exact, answer_, method_, problem(), limits, request_);
    return granted;
  }

  // Tier exact: a question that is not for it.
  bool is_not_asked() {
    if (!why_invalid(problem()).empty() || engine::is_exact_question(problem())) return false;
    judgement_.skipped = true;
    judgement_.stalled = false;
    if (answer_.outcome != Outcome::invalid_input || answer_.invalid != Invalid::not_exact) {
      judgement_.wrong = "answers a case that is not for the exact tier";
    }
    return true;
  }

  void exact(bool measure) {
    const ExactFinding finding = judge_exact_by_proof(problem(), answer_, method_.in_float());
    if (finding.false_proof) {
      judgement_.proof = ProofState::refused;
      judgement_.false_proof = finding.fault;
    } else {
      judgement_.proof = finding.fault.empty() && answer_.proof ? ProofState::accepted : ProofState::none;
      judgement_.wrong = finding.fault;
    }
    if (!measure && finding.settled) return;
    judgement_.by_oracle = true;
    const CaseTruth& truth = truth_.cast();
    // For many vertices it is a bracket, which gives no information about the last bits.
    if (truth.is_exact()) {
      add_fault(judgement_.wrong, exact_fault_by_truth(truth, answer_, method_.in_float()));
    } else if (const auto closed = oracle::ClosedForm::of(problem())) {
      add_fault(judgement_.wrong, exact_fault_by_truth(*closed, answer_, method_.in_float()));
    }
    const Limits limits = limits_of(method_, problem(), truth.scale().high);
    judge_contact(judgement_, truth, answer_, method_, problem(), limits, request_);
    judgement_.errors = errors_of(truth_, answer_, request_);
    start();
  }

  Truth& truth_;
  const Method& method_;
  const Answer& answer_;
  Request request_;
  Judgement judgement_;
};

}  // namespace

Judgement judge_linear(Truth& truth, const Method& method, const Answer& answer, Request request,
                       bool measure) {
  return LinearJudge(truth, method, answer, request)(measure);
}

}  // namespace graze::law
