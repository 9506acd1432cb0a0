#include "properties/judge/judge.hpp"

namespace graze::law {

Judgement judge(Truth& truth, const engine::Method& method, const engine::Answer& answer, Request request,
                bool measure) {
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

}  // namespace graze::law
