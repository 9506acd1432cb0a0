#include "properties/judge/judge.hpp"

#include <fmt/format.h>

namespace graze::law {

namespace {

Judgement judge_by_kind(Truth& truth, const engine::Method& method, const engine::Answer& answer,
                        Request request, bool measure) {
  switch (method.kind) {
    case engine::Kind::linear:
      return judge_linear(truth, method, answer, request, measure);
    case engine::Kind::query:
      return judge_query(truth, method, answer);
    case engine::Kind::rotating:
      break;
  }
  return judge_rotating(truth, method, answer, request, measure);
}

// The part of a request that the answers of a method hold.
Request held_of(Request request, const engine::Holds& holds) {
  unsigned held = static_cast<unsigned>(request);
  if (!holds.normal) held &= ~static_cast<unsigned>(Request::normal);
  if (!holds.witnesses) held &= ~static_cast<unsigned>(Request::witnesses);
  return static_cast<Request>(held);
}

}  // namespace

Judgement judge(Truth& truth, const engine::Method& method, const engine::Answer& answer, Request request,
                bool measure) {
  Judgement judgement;
  if (method.is_ours()) {
    judgement = judge_by_kind(truth, method, answer, request, measure);
    if (!asks_for(request, Request::proof)) judge_work(judgement, method, truth.problem(), answer.counters);
    return judgement;
  }
  judgement.outcome = answer.outcome;
  if (answer.failure != engine::Failure::none) {
    judgement.failure = answer.failure;
    judgement.failed = fmt::format("{}: {}", to_text(answer.failure), answer.message);
    return judgement;
  }
  if (answer.declined) {
    judgement.skipped = judgement.declined = true;
    return judgement;
  }
  // Its certificate is the least limit that it would have kept: every error is measured.
  judgement = judge_by_kind(truth, method, answer, held_of(request, method.holds), true);
  judge_work(judgement, method, truth.problem(), answer.counters);
  return judgement;
}

}  // namespace graze::law
