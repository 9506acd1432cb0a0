#include "certify/campaign/campaign_cast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <exception>
#include <utility>

#include "corpus/format/case_io.hpp"
#include "corpus/format/names.hpp"
#include "corpus/random.hpp"
#include "properties/edit/case.hpp"
#include "properties/laws/queries/question.hpp"

namespace graze::tool {
namespace {

using engine::Kind;
using engine::Method;

// For rotating bodies, every other answer is computed without a proof. A query has no proof.
Request request_of(const Method& method, const DrawnCase& drawn) {
  if (method.kind == Kind::query || !drawn.judged) return engine::kPlain;
  const bool whole = method.kind == Kind::linear || drawn.seed % 2 == 0;
  return whole ? Request::everything : engine::kPlain;
}

// Why the proof is refused that the method returns on request. Empty if it is accepted.
std::string refusal_of_proof(law::Truth& truth, const Method& method, const corpus::Case& problem) {
  const engine::Answer answer = method.ask(problem, {.request = Request::everything});
  if (!answer.rotating_proof) return {};
  const oracle::RotatingVerdict verdict = truth.check(*answer.rotating_proof);
  if (verdict.accepted() && verdict.detail.empty()) return {};
  return fmt::format("{}: {}", to_string(verdict.refusal), verdict.detail);
}

// The check of an answer that is counted without being judged: it converged, and its times make sense.
bool is_answer(const Method& method, const engine::Answer& answer, double t_max) {
  return answer.outcome != Outcome::not_converged && answer.outcome != Outcome::invalid_input &&
         (method.kind == Kind::query || law::senseless(answer, t_max).empty());
}

// The number of support evaluations is judged even then, because it needs no truth.
law::Judgement unjudged(const Method& method, const corpus::Case& problem, const engine::Answer& answer) {
  law::Judgement judgement;
  judgement.outcome = answer.outcome;
  judgement.stalled = answer.stalled || answer.outcome == Outcome::not_converged;
  law::judge_work(judgement, method, problem, answer.counters);
  return judgement;
}

}  // namespace

AnswerWords words_of(const engine::Answer& answer) {
  AnswerWords words{.outcome = answer.outcome};
  bool is_query = false;
  for (const auto* bracket : {&answer.separation, &answer.depth, &answer.t_in, &answer.t_out}) {
    if (!*bracket) continue;
    is_query = true;
    words.numbers[words.count++] = (*bracket)->lower;
    words.numbers[words.count++] = (*bracket)->upper;
  }
  if (is_query) return words;
  words.numbers = {answer.toi_lower, answer.toi_upper};
  words.count = 2;
  return words;
}

std::string CampaignCast::reason() const {
  if (judgement.faulty()) return judgement.told_fault();
  if (!judgement.undecided.empty()) return judgement.undecided;
  return answer.outcome == Outcome::not_converged ? "did not converge"
                                                  : "did not converge, with a wide bracket";
}

corpus::Case question_of(Kind kind, corpus::Query query, const DrawnCase& drawn) {
  if (kind != Kind::query) return drawn.problem;
  corpus::Case question = law::question_for(drawn.problem, query, drawn.seed);
  // If the bodies do not move, the case has no other id yet.
  if (question.id == drawn.problem.id) question.id.append("/").append(corpus::name_of(query));
  return question;
}

corpus::Case question_of(const Method& contender, const DrawnCase& drawn) {
  return question_of(contender.kind, contender.query, drawn);
}

law::Truth& CaseJudge::truth_of(const Method& method, corpus::Case seen) {
  for (const std::unique_ptr<law::Truth>& truth : truths_) {
    if (corpus::same_case(truth->problem(), seen)) return *truth;
  }
  const Method* reference = method.kind == Kind::rotating
                                ? engine::find_method(Kind::rotating, "certified/" + method.scalar)
                                : nullptr;
  return *truths_.emplace_back(std::make_unique<law::Truth>(std::move(seen), reference));
}

law::Judgement CaseJudge::judge(const Method& method, const corpus::Case& question,
                                const engine::Answer& answer, Request request, std::string& undecided) {
  law::Truth& truth = truth_of(method, method.seen(question));
  std::string refused;
  const bool hides_its_proof =
      method.is_ours() && method.kind == Kind::rotating && !asks_for(request, Request::proof);
  if (hides_its_proof) refused = refusal_of_proof(truth, method, question);
  law::Judgement judgement = law::judge(truth, method, answer, request, drawn_.sampled);
  law::add_fault(judgement.false_proof, std::move(refused));
  if (judgement.by_oracle && judgement.open) undecided = judgement.why_open;
  return judgement;
}

CampaignCast CaseJudge::ask_other(const Method& contender) {
  CampaignCast asked;
  try {
    const corpus::Case question = question_of(contender, drawn_);
    if (!law::in_domain(question) || !contender.refuses(question).empty()) {
      asked.judgement.skipped = true;
      return asked;
    }
    const engine::Answer answer = contender.ask(question, {.request = engine::kPlain});
    asked.answer = words_of(answer);
    const bool is_judged = drawn_.judged && (contender.kind != Kind::query || drawn_.sampled);
    if (answer.failure == engine::Failure::none && !answer.declined && !is_judged &&
        is_answer(contender, answer, drawn_.problem.t_max)) {
      asked.judgement = unjudged(contender, question, answer);
      return asked;
    }
    asked.judgement = judge(contender, question, answer, engine::kPlain, asked.undecided);
  } catch (const std::exception& error) {
    asked.judgement.wrong = std::string("could not be judged: ") + error.what();
  }
  return asked;
}

CampaignCast CaseJudge::ask(const Method& contender) {
  if (!contender.is_ours()) return ask_other(contender);
  CampaignCast asked;
  try {
    const corpus::Case question = question_of(contender, drawn_);
    // The scalar has made it another question.
    if (contender.kind == Kind::query && !law::in_domain(contender.seen(question))) {
      asked.judgement.skipped = true;
      return asked;
    }
    Request request = request_of(contender, drawn_);
    engine::Answer answer = contender.ask(question, {.request = request});
    asked.answer = words_of(answer);
    const bool is_query = contender.kind == Kind::query;
    if (is_query ? !drawn_.sampled || !drawn_.judged
                 : !drawn_.judged && is_answer(contender, answer, drawn_.problem.t_max)) {
      asked.judgement = unjudged(contender, question, answer);
      asked.judgement.skipped = is_query && answer.invalid == Invalid::not_exact;
      if (is_query && answer.outcome == Outcome::invalid_input && !asked.judgement.skipped)
        asked.judgement.wrong = "refuses a valid case";
      return asked;
    }
    if (contender.kind == Kind::linear && request != Request::everything) {
      request = Request::everything;
      answer = contender.ask(question, {.request = request});
      asked.answer = words_of(answer);
    }
    asked.judgement = judge(contender, question, answer, request, asked.undecided);
    if (request != engine::kPlain)
      law::judge_work(asked.judgement, contender, question,
                      contender.ask(question, {.request = engine::kPlain}).counters);
    asked.judgement.skipped = asked.judgement.skipped && asked.judgement.wrong.empty();
    if (contender.is_exact() && asked.judgement.faulty()) asked.judgement.stalled = false;
  } catch (const std::exception& error) {
    asked.judgement.wrong = std::string("could not be judged: ") + error.what();
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

std::uint64_t answer_hash(std::uint64_t index, const Method& contender, const DrawnCase& drawn) {
  const corpus::Case question = question_of(contender, drawn);
  return answer_hash(index, words_of(contender.ask(question, {.request = request_of(contender, drawn)})));
}

}  // namespace graze::tool
