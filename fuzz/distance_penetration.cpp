// Does any query beside the cast answer wrongly: overlap, distance, penetration, the line?
//
//   1. Decode.
//   2. Choose a method of a query by the choice. If no law applies to it, take the next.
//   3. Check every law of queries that needs no oracle.
//   4. For one case in kOneIn, check those that need one.
#include "corpus/format/names.hpp"
#include "fuzz/repair.hpp"
#include "fuzz/target.hpp"
#include "properties/laws/law.hpp"

namespace graze::fuzz {

namespace {

constexpr std::uint64_t kOneIn = 64;

Judged judge_queries(const Input& input) {
  const corpus::Case problem = as_linear(input.problem);
  const auto methods = engine::methods(engine::Kind::query);
  Judged judged;
  judged.by_oracle = input.choice % kOneIn == 0;
  for (std::size_t i = 0; i < methods.size() && !judged.reached; ++i) {
    const engine::Method& method = methods[(input.choice / kOneIn + i) % methods.size()];
    const std::string name = std::string(corpus::name_of(method.query)) + " " + method.full_name();
    for (const law::Law& one : law::laws(engine::Kind::query)) {
      if (judged.finding) break;
      if (one.needs == law::Needs::oracle && !judged.by_oracle) continue;
      add(judged, one.name, name, one.check(problem, method), problem);
    }
  }
  return judged;
}

}  // namespace

const Target kTarget = {.name = "distance_penetration", .judge = &judge_queries};

}  // namespace graze::fuzz
