#include "tools/campaign_cast.hpp"

#include <exception>

namespace graze::tool {

CampaignCast campaign_cast(const corpus::Case& problem, const engine::EngineMethod& method,
                           const engine::Guarantee* row, bool measure) {
  CampaignCast cast{.answer = method.cast(problem, {.request = Request::everything}), .judgement = {}};
  try {
    Truth truth(method.seen(problem));
    cast.judgement = judge_method(truth, problem, method, cast.answer, row, measure);
  } catch (const std::exception& error) {
    cast.judgement.outcome = cast.answer.outcome;
    cast.judgement.wrong = std::string("could not be judged: ") + error.what();
  }
  return cast;
}

}  // namespace graze::tool
