#include "certify/worst_cases.hpp"

#include <fmt/format.h>

namespace graze::tool {

corpus::Case WorstCases::Place::problem(const engine::Method& method) const {
  corpus::Case problem = suite->at(index);
  std::optional<corpus::Case> asked = question_for(*suite, index, problem, method);
  return asked ? std::move(*asked) : std::move(problem);
}

void WorstCases::note(const Suite& suite, std::size_t i, const engine::Method& method,
                      const law::Judgement& judgement) {
  if (judgement.skipped) return;
  const bool measured = judgement.errors.over_limit >= 0;
  Cell& cell = cells_[{&method, suite.family}];
  const auto named = [&](const std::string& why) {
    const Place place{&suite, i};
    return Named{.id = place.problem(method).id,
                 .why = why,
                 .over_limit = judgement.errors.over_limit,
                 .supports = judgement.supports,
                 .place = place};
  };
  // The id takes the case, which takes time to draw: only where it is kept.
  if (measured && (!cell.worst || judgement.errors.over_limit > cell.worst->over_limit))
    cell.worst = named("");
  if (judgement.supports > 0 && (!cell.costliest || judgement.supports > cell.costliest->supports))
    cell.costliest = named(fmt::format("{} support evaluations", judgement.supports));
  if (const std::size_t k = judgement.worst_fault(); k < law::kFaults && !cell.faults[k])
    cell.faults[k] = named(judgement.told_fault());
  if (judgement.stalled && !cell.stalled) cell.stalled = named(judgement.undecided);
}

const WorstCases::Cell* WorstCases::find(const engine::Method& method, const std::string& family) const {
  const auto found = cells_.find({&method, family});
  return found == cells_.end() ? nullptr : &found->second;
}

}  // namespace graze::tool
