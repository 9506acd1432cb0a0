#include "properties/judge/rotating_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "oracles/checker/check_record.hpp"
#include "properties/judge/by_proof.hpp"
#include "properties/judge/rotating.hpp"

namespace graze::tool {
namespace {

using engine::RotatingAnswer;
using law::RotatingError;
using oracle::RotatingTruth;

void convict(std::string& fault, std::string why) {
  if (fault.empty()) fault = std::move(why);
}

// Does an accepted proof say all that the answer says?
bool proves(const RotatingProof& proof, const RotatingAnswer& answer) {
  switch (answer.outcome) {
    case Outcome::miss:
      return proof.toi_lower == kInfinity<double>;
    case Outcome::initially_overlapping:
      return proof.toi_upper == 0;
    case Outcome::hit:
    case Outcome::not_converged:
      return proof.toi_lower >= answer.toi_lower && proof.toi_upper <= answer.toi_upper;
    case Outcome::invalid_input:
      break;
  }
  return false;
}

// What accepted proofs leave open of an answer.
enum class Open { nothing, width, anything };

// With l <= TOI <= u proved and V the top speed of a point of one body against the other: the bodies are no
// farther apart at t than (u - t) V, and before t no deeper in each other than (t - l) V. Both are rounded
// outward, and so is the comparison: what is then within the row is so without doubt.
Open left_open_by(const ProvedBracket& proved, const RotatingAnswer& answer, const law::RotatingRow& row) {
  const auto way = [&](double from, double to) {
    return std::max(0.0, to - from) * row.speed * kSlack * kSlack;
  };
  switch (answer.outcome) {
    case Outcome::miss:
      return proved.lower == kInfinity<double> ? Open::nothing : Open::anything;
    case Outcome::initially_overlapping:
      return proved.upper == 0 ? Open::nothing : Open::anything;
    case Outcome::hit: {
      if (!(proved.upper < kInfinity<double>)) return Open::anything;
      if (way(proved.lower, answer.toi_lower) > (row.strict ? 0 : row.limit)) return Open::anything;  // late
      if (way(answer.toi_upper, proved.upper) > (row.strict ? 0 : row.wide)) return Open::anything;   // early
      const bool narrow =
          way(answer.toi_lower, proved.upper) <= row.wide + row.rounding_at(answer.toi_lower) &&
          way(proved.lower, answer.toi_upper) <= row.wide + row.rounding_at(answer.toi_upper);
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
  RotatingJudge(TurningTruth& truth, const RotatingAnswer& answer, const RotatingLimits& limits,
                Request request)
      : truth_(truth), answer_(answer), limits_(limits), request_(request) {
    judgement_.outcome = answer.outcome;
  }

  // With `oracle` it is asked whatever the proofs say.
  RotatingJudgement operator()(bool oracle) {
    if (settled_at_the_door()) return judgement_;
    const corpus::Case& problem = truth_.problem();
    if (std::string why = senseless(answer_.outcome, answer_.toi_lower, answer_.toi_upper, problem.t_max);
        !why.empty()) {
      convict(judgement_.wrong, std::move(why));
      return judgement_;
    }
    proof();
    const Open open = left_open(problem);
    if (open == Open::nothing && !oracle) return judgement_;
    if (open == Open::width && !oracle) {
      const RotatingTruth& beside = truth_.beside_proof();
      row_ = law::row_of(*limits_.method, *limits_.row, problem, beside.scale().high);
      width(beside);
      return judgement_;
    }
    judgement_.by_oracle = true;
    const RotatingTruth& truth = truth_.bracket();
    row_ = law::row_of(*limits_.method, *limits_.row, problem, truth.scale().high);
    judgement_.open = truth.outcome() == Outcome::not_converged;
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
    return judgement_;
  }

 private:
  using Error = RotatingError(const RotatingTruth&, const RotatingAnswer&, const law::RotatingRow&);

  [[nodiscard]] double in_scale(double length) const {
    return std::isnan(length) ? length : over(length, row_.scale);
  }
  // The error, its fault noted.
  RotatingError take(Error* error, const RotatingTruth& truth, std::string& fault) {
    RotatingError found = error(truth, answer_, row_);
    if (!found.fault.empty()) convict(fault, found.fault);
    return found;
  }

  [[nodiscard]] bool claims_contact() const {
    return answer_.outcome == Outcome::hit || answer_.outcome == Outcome::initially_overlapping;
  }

  bool settled_at_the_door() {
    const corpus::Case& problem = truth_.problem();
    const std::string invalid = why_invalid(problem);
    const bool refused = answer_.outcome == Outcome::invalid_input;
    if (invalid.empty() && (!refused || answer_.invalid == Invalid::not_linear) &&
        (problem.t_max == kInfinity<double> || problem.start_policy == StartPolicy::pass_over)) {
      judgement_.not_asked = true;
      return true;
    }
    if (refused != !invalid.empty()) {
      convict(judgement_.wrong, refused ? "refuses a valid case" : "answers a case that has " + invalid);
    }
    return refused || !invalid.empty();
  }

  // No verdict is proved, but that the bodies come no farther than a part of the width from touching:
  // clearance and depth are below it. An answer that leaves the verdict open is right then, and so is one
  // that the row lets decide by as little, if its times are.
  [[nodiscard]] bool stands_within(const RotatingTruth& truth) const {
    const bool decides = answer_.outcome != Outcome::not_converged;
    if (decides && row_.strict) return false;
    const double limit = row_.strict ? row_.wide : row_.limit;
    const bool not_late = answer_.outcome == Outcome::miss || truth_.proved().lower >= answer_.toi_lower ||
                          truth.toi_lower() >= answer_.toi_lower ||
                          (!row_.strict && truth.depth_before(answer_.toi_lower).high <= limit);
    if (!not_late || truth.clearance().high > limit || truth.depth().high > limit) return false;
    if (answer_.outcome != Outcome::hit) return true;
    return truth.backward_error(answer_.toi_lower).high <= row_.wide + row_.rounding_at(answer_.toi_lower) &&
           truth.backward_error(answer_.toi_upper).high <= row_.wide + row_.rounding_at(answer_.toi_upper);
  }

  // By the scale in rounded doubles, brought below the true one.
  Open left_open(const corpus::Case& problem) {
    const law::RotatingRow row =
        law::row_of(*limits_.method, *limits_.row, problem, law::scale_of(problem) / kSlack);
    const Open open = left_open_by(truth_.proved(), answer_, row);
    if (open != Open::anything || !truth_.learn_from_reference()) return open;
    return left_open_by(truth_.proved(), answer_, row);
  }

  void proof() {
    if (answer_.proof) {
      const oracle::RotatingVerdict verdict = truth_.check(*answer_.proof);
      if (!verdict.accepted() || !verdict.detail.empty()) {
        judgement_.proof = ProofState::refused;
        judgement_.false_proof = fmt::format("{}: {}", to_string(verdict.refusal), verdict.detail);
      } else if (proves(*answer_.proof, answer_)) {
        judgement_.proof = ProofState::accepted;
      }
    }
    // A bracket that claims nothing needs no proof; of contact that no proof can name, the lower end has one.
    const bool in_part = answer_.proof && judgement_.proof == ProofState::none && claims_contact() &&
                         !oracle::can_name_contact(truth_.problem()) &&
                         answer_.proof->toi_lower >= answer_.toi_lower;
    const bool claims = answer_.toi_lower > 0 || answer_.toi_upper < kInfinity<double>;
    if (limits_.method->is_certified() && asks_for(request_, Request::proof) && claims &&
        judgement_.proof == ProofState::none && !answer_.passed_over && !in_part) {
      convict(judgement_.unproved,
              answer_.proof ? "its proof claims less than the answer" : "a certified answer without a proof");
    }
  }

  void miss(const RotatingTruth& truth) {
    if (judgement_.open || truth.outcome() == Outcome::miss) return;
    const RotatingError denied = take(&law::verdict_error, truth, judgement_.wrong);
    judgement_.passed = in_scale(denied.length);
    if (denied.fault.empty()) (denied.length > row_.limit ? judgement_.hidden : judgement_.excused) = true;
  }

  // A hit, or a start in contact.
  void contact(const RotatingTruth& truth) {
    if (truth.outcome() == Outcome::miss) {
      if (!take(&law::verdict_error, truth, judgement_.wrong).fault.empty()) return;
      judgement_.excused = true;
    }
    late(truth);
    take(&law::early_error, truth, judgement_.early);
    width(truth);
    take(&law::distance_error, truth, judgement_.wide);
    if (answer_.outcome != Outcome::hit) return;
    if (asks_for(request_, Request::normal))
      judgement_.normal = in_scale(take(&law::normal_error, truth, judgement_.bad_contact).length);
    if (asks_for(request_, Request::witnesses))
      judgement_.witness = in_scale(take(&law::witness_error, truth, judgement_.bad_contact).length);
  }

  void width(const RotatingTruth& truth) {
    judgement_.width_limit = in_scale(row_.wide + row_.rounding_at(answer_.toi_upper));
    judgement_.width = in_scale(take(&law::width_error, truth, judgement_.wide).length);
  }

  void not_converged(const RotatingTruth& truth) {
    late(truth);
    take(&law::early_error, truth, judgement_.early);
    take(&law::distance_error, truth, judgement_.wide);
    // Where clearance or depth is below the row's length, a flat C's depth of 0 too, nothing decides.
    const RotatingError left = take(&law::undecided_error, truth, judgement_.undecided);
    if (!left.fault.empty()) return;
    const bool decides = left.length > (row_.strict ? row_.wide : row_.limit);
    (decides ? judgement_.stalled : judgement_.excused) = true;
  }

  void late(const RotatingTruth& truth) {
    const RotatingError passed = take(&law::late_error, truth, judgement_.late);
    if (std::isnan(passed.length)) return;
    judgement_.passed = in_scale(passed.length);
    if (passed.fault.empty() && passed.length > row_.limit) judgement_.hidden = true;
  }

  TurningTruth& truth_;
  const RotatingAnswer& answer_;
  const RotatingLimits& limits_;
  Request request_;
  law::RotatingRow row_;
  RotatingJudgement judgement_;
};

}  // namespace

const RotatingTruth& TurningTruth::bracket() {
  if (bracket_) return *bracket_;
  bracket_ = std::make_unique<RotatingTruth>(problem_);
  // What comes nearer than its width is looked at again through the finest.
  if (bracket_->outcome() == Outcome::not_converged && !bracket_->budget_ended()) {
    auto finer = std::make_unique<RotatingTruth>(problem_, RotatingTruth::kLeastWidth);
    if (finer->outcome() != Outcome::not_converged) bracket_ = std::move(finer);
  }
  return *bracket_;
}

const RotatingTruth& TurningTruth::beside_proof() {
  if (!beside_proof_) {
    const double upper = std::min(proved_.upper, problem_.t_max);
    beside_proof_ = std::make_unique<RotatingTruth>(RotatingTruth::of_proved(problem_, proved_.lower, upper));
  }
  return *beside_proof_;
}

oracle::RotatingVerdict TurningTruth::check(const RotatingProof& proof) {
  oracle::RotatingVerdict verdict = oracle::check_rotating_proof(problem_, proof);
  if (!verdict.accepted()) return verdict;
  const ProvedBracket both{.lower = std::max(proved_.lower, proof.toi_lower),
                           .upper = std::min(proved_.upper, proof.toi_upper)};
  if (both.lower > both.upper) {
    verdict.detail = fmt::format(
        "it says that contact comes in [{:.17g}, {:.17g}], another that was "
        "accepted, in [{:.17g}, {:.17g}]",
        proof.toi_lower, proof.toi_upper, proved_.lower, proved_.upper);
    return verdict;
  }
  proved_ = both;
  return verdict;
}

bool TurningTruth::learn_from_reference() {
  if (reference_ == nullptr) return false;
  const RotatingAnswer answer =
      std::exchange(reference_, nullptr)->cast(problem_, {.request = Request::everything});
  if (!answer.proof) return false;
  const oracle::RotatingVerdict verdict = check(*answer.proof);
  return verdict.accepted() && verdict.detail.empty();
}

RotatingLimits limits_of(const engine::RotatingEngineMethod& method, const engine::Guarantee* row) {
  static const engine::Guarantee kPlain{.method = {},
                                        .scalar = {},
                                        .tier = {},
                                        .kappa_polytope = kPlainKappa,
                                        .kappa_rounded = kPlainKappa,
                                        .mechanism = {}};
  return {&method, row != nullptr ? row : &kPlain};
}

const std::string& RotatingJudgement::fault() const {
  static const std::string kNone;
  for (const std::string* fault :
       {&wrong, &late, &early, &wide, &bad_contact, &undecided, &unproved, &false_proof}) {
    if (!fault->empty()) return *fault;
  }
  return kNone;
}

RotatingJudgement judge_rotating(TurningTruth& truth, const RotatingAnswer& answer,
                                 const RotatingLimits& limits, Request request) {
  return RotatingJudge(truth, answer, limits, request)(true);
}

RotatingJudgement judge_rotating_by_proof(TurningTruth& truth, const RotatingAnswer& answer,
                                          const RotatingLimits& limits, Request request, bool measure) {
  return RotatingJudge(truth, answer, limits, request)(measure);
}

}  // namespace graze::tool
