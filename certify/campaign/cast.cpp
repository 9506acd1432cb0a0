#include "certify/campaign/cast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <graze/support/tree.hpp>
#include <utility>

#include "corpus/format/case_io.hpp"
#include "corpus/format/names.hpp"
#include "corpus/random.hpp"
#include "properties/laws/queries/question.hpp"

namespace graze::tool {
namespace {

// What a caller gets by default.
constexpr Request kPlain = Request::normal | Request::witnesses;

Request request_of(const DrawnCase& drawn) { return drawn.seed % 2 == 0 ? Request::everything : kPlain; }

AnswerWords words_of(const engine::RotatingAnswer& answer) {
  return {.outcome = answer.outcome, .numbers = {answer.toi_lower, answer.toi_upper}, .count = 2};
}

AnswerWords words_of(const engine::QueryAnswer& answer) {
  AnswerWords words{.outcome = answer.outcome};
  for (const auto* bracket : {&answer.distance, &answer.depth, &answer.t_in, &answer.t_out}) {
    if (!*bracket) continue;
    words.numbers[words.count++] = (*bracket)->lower;
    words.numbers[words.count++] = (*bracket)->upper;
  }
  return words;
}

// The truth about the case as it is seen: one that there is, or a new one.
template <class T, class... Arguments>
T& truth_of(std::vector<std::unique_ptr<T>>& truths, corpus::Case seen, const Arguments&... arguments) {
  for (const std::unique_ptr<T>& truth : truths) {
    if (corpus::same_case(truth->problem(), seen)) return *truth;
  }
  return *truths.emplace_back(std::make_unique<T>(std::move(seen), arguments...));
}

// The proof that the method has when it is asked for one; why it is refused, or empty.
std::string refusal_of_proof(TurningTruth& truth, const engine::RotatingEngineMethod& method,
                             const corpus::Case& problem) {
  const engine::RotatingAnswer answer = method.cast(problem, {.request = Request::everything});
  if (!answer.proof) return {};
  const oracle::RotatingVerdict verdict = truth.check(*answer.proof);
  if (verdict.accepted() && verdict.detail.empty()) return {};
  return fmt::format("{}: {}", to_string(verdict.refusal), verdict.detail);
}

std::string& fault_of(CampaignCast& cast, Fault fault) {
  return cast.faults[static_cast<std::size_t>(fault)];
}

// An answer, with times that make sense: what is counted and not judged where a case is not.
bool is_answer(Outcome outcome, double lower, double upper, double t_max) {
  return outcome != Outcome::not_converged && outcome != Outcome::invalid_input &&
         senseless(outcome, lower, upper, t_max).empty();
}

}  // namespace

AnswerWords words_of(const engine::Answer& answer) {
  return {.outcome = answer.outcome, .numbers = {answer.toi_lower, answer.toi_upper}, .count = 2};
}

bool CampaignCast::faulty() const {
  return std::any_of(faults.begin(), faults.end(), [](const std::string& why) { return !why.empty(); });
}

std::string CampaignCast::reason() const {
  const auto first =
      std::find_if(faults.begin(), faults.end(), [](const std::string& why) { return !why.empty(); });
  if (first != faults.end()) return *first;
  return answer.outcome == Outcome::not_converged ? "did not converge" : "stalled with a wide bracket";
}

corpus::Case question_of(const Contender& contender, const DrawnCase& drawn) {
  if (contender.kind() != PartKind::queries) return drawn.problem;
  const corpus::Query query = std::get<1>(contender.method)->query;
  corpus::Case question = law::question_for(drawn.problem, query, drawn.seed);
  // Where bodies stay where they are, the case has no other id yet.
  if (question.id == drawn.problem.id) question.id.append("/").append(corpus::name_of(query));
  return question;
}

CampaignCast CaseJudge::ask(const Contender& contender) {
  CampaignCast asked;
  try {
    switch (contender.kind()) {
      case PartKind::casts:
        return cast(*std::get<0>(contender.method), contender.row);
      case PartKind::queries:
        return query(*std::get<1>(contender.method), contender);
      case PartKind::rotating:
        return turn(*std::get<2>(contender.method), contender.row);
    }
  } catch (const std::exception& error) {
    fault_of(asked, Fault::wrong) = std::string("could not be judged: ") + error.what();
  }
  return asked;
}

CampaignCast CaseJudge::cast(const engine::EngineMethod& method, const engine::Guarantee* row) {
  const corpus::Case& problem = drawn_.problem;
  if (!drawn_.judged) {
    const engine::Answer answer = method.cast(problem, {.request = kPlain});
    if (is_answer(answer.outcome, answer.toi_lower, answer.toi_upper, problem.t_max))
      return {.answer = words_of(answer)};
  }
  const engine::Answer answer = method.cast(problem, {.request = Request::everything});
  CampaignCast asked{.answer = words_of(answer)};
  try {
    Truth& truth = truth_of(casts_, method.seen(problem));
    Judgement judgement = judge_method(truth, problem, method, answer, row, drawn_.sampled);
    asked.faults = {std::move(judgement.wrong),       std::move(judgement.late),
                    std::move(judgement.off),         std::move(judgement.bad_contact),
                    std::move(judgement.false_proof), {}};
    asked.proof = judgement.proof;
    asked.by_oracle = judgement.by_oracle;
    // Of tier exact a stall is a fault; it is counted once.
    asked.stalled = judgement.stalled && !asked.faulty();
    asked.excused = judgement.excused;
    const double granted =
        row == nullptr ? 0 : row->width.value_or(row->kappa(problem) * method.unit_roundoff);
    if (granted > 0) asked.widest = judgement.errors.backward / granted;
  } catch (const std::exception& error) {
    fault_of(asked, Fault::wrong) = std::string("could not be judged: ") + error.what();
  }
  return asked;
}

CampaignCast CaseJudge::query(const engine::QueryMethod& method, const Contender& contender) {
  const engine::Guarantee* row = contender.row;
  const corpus::Case question = question_of(contender, drawn_);
  corpus::Case seen = law::seen_by(method, question);
  CampaignCast asked;
  // The scalar has made it another question.
  asked.not_asked = !why_invalid(seen).empty();
  if (asked.not_asked) return asked;
  const engine::QueryAnswer answer = method.answer(question);
  asked.answer = words_of(answer);
  const double kappa = row != nullptr ? row->kappa(seen) : kPlainKappa;
  const law::QueryLimits limits{
      .kappa = kappa,
      .unit_roundoff = method.scalar == "float" ? kUnitRoundoff<float> : kUnitRoundoff<double>,
      .contact_kappa = row != nullptr ? row->contact_kappa(seen) : kPlainKappa};
  if (!drawn_.sampled || !drawn_.judged) {
    asked.not_asked = answer.invalid == Invalid::not_exact;
    asked.stalled = answer.stalled || answer.outcome == Outcome::not_converged;
    if (answer.outcome == Outcome::invalid_input && !asked.not_asked)
      fault_of(asked, Fault::wrong) = "refuses a valid case";
    return asked;
  }
  law::QueryJudgement judgement =
      law::judge_query(truth_of(queries_, std::move(seen)), method, answer, limits);
  asked.not_asked = judgement.not_asked && judgement.wrong.empty();
  asked.by_oracle = !asked.not_asked;
  asked.faults = {std::move(judgement.wrong),       {}, std::move(judgement.off),
                  std::move(judgement.bad_contact), {}, {}};
  asked.stalled = judgement.stalled && !asked.faulty();
  asked.excused = judgement.excused;
  if (kappa > 0) asked.widest = judgement.backward / (kappa * limits.unit_roundoff);
  return asked;
}

CampaignCast CaseJudge::turn(const engine::RotatingEngineMethod& method, const engine::Guarantee* row) {
  const Request request = drawn_.judged ? request_of(drawn_) : kPlain;
  const engine::RotatingAnswer answer = method.cast(drawn_.problem, {.request = request});
  CampaignCast asked{.answer = words_of(answer)};
  if (!drawn_.judged && is_answer(answer.outcome, answer.toi_lower, answer.toi_upper, drawn_.problem.t_max))
    return asked;
  try {
    TurningTruth& truth = truth_of(turns_, method.seen(drawn_.problem),
                                   engine::find_rotating_method("certified/" + method.scalar));
    std::string refused;
    if (!asks_for(request, Request::proof)) refused = refusal_of_proof(truth, method, drawn_.problem);
    RotatingJudgement judgement =
        judge_rotating_by_proof(truth, answer, limits_of(method, row), request, drawn_.sampled);
    asked.not_asked = judgement.not_asked;
    asked.faults = {std::move(judgement.wrong),
                    std::move(judgement.late),
                    std::move(judgement.early.empty() ? judgement.wide : judgement.early),
                    std::move(judgement.bad_contact),
                    std::move(judgement.false_proof),
                    std::move(judgement.unproved)};
    if (std::string& why = fault_of(asked, Fault::false_proof); why.empty()) why = std::move(refused);
    asked.proof = judgement.proof;
    asked.by_oracle = judgement.by_oracle;
    if (judgement.by_oracle && judgement.open) asked.undecided = truth.bracket().reason();
    asked.stalled = judgement.stalled || !judgement.undecided.empty();
    asked.excused = judgement.excused;
    if (judgement.width_limit > 0) asked.widest = judgement.width / judgement.width_limit;
  } catch (const std::exception& error) {
    fault_of(asked, Fault::wrong) = std::string("could not be judged: ") + error.what();
  }
  return asked;
}

std::uint64_t answer_hash(std::uint64_t index, const AnswerWords& answer) {
  // A NaN has many patterns of bits and is one answer.
  const auto bits = [](double t) { return t == t ? std::bit_cast<std::uint64_t>(t) : ~std::uint64_t{0}; };
  std::uint64_t hash = corpus::Random(index).bits();
  hash = corpus::Random(hash ^ static_cast<std::uint64_t>(answer.outcome)).bits();
  for (std::size_t i = 0; i < answer.count; ++i) {
    hash = corpus::Random(hash ^ bits(answer.numbers[i])).bits();
  }
  return hash;
}

std::uint64_t answer_hash(std::uint64_t index, const Contender& contender, const DrawnCase& drawn) {
  const corpus::Case question = question_of(contender, drawn);
  switch (contender.kind()) {
    case PartKind::casts:
      return answer_hash(
          index, words_of(std::get<0>(contender.method)->cast(question, {.request = Request::everything})));
    case PartKind::queries:
      return answer_hash(index, words_of(std::get<1>(contender.method)->answer(question)));
    case PartKind::rotating:
      break;
  }
  return answer_hash(index,
                     words_of(std::get<2>(contender.method)->cast(question, {.request = request_of(drawn)})));
}

}  // namespace graze::tool
