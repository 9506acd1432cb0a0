// Does CGAL's exact arithmetic find a wrong cast of small polytopes?
//
//   1. Decode, and make both bodies polytopes of at most 8 vertices in identity poses.
//   2. Choose a scalar: double three times in four, else float.
//   3. Call every method of that scalar with everything requested.
//   4. The exact oracle judges all of each answer: verdict, bracket, time, normal, witnesses, the tightness of the
//      proof, and every bit of tier exact (the laws that need an oracle).
#include "fuzz/repair.hpp"
#include "fuzz/target.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::fuzz {

namespace {

Judged judge_exactly(const Input& input) {
  const corpus::Case problem = as_few_vertices(input.problem);
  const char* const scalar = input.choice % 4 == 0 ? "float" : "double";
  Judged judged;
  for (const engine::Method& method : engine::methods(engine::Kind::linear)) {
    if (method.scalar != scalar) continue;
    for (const law::Law& one : law::laws(engine::Kind::linear)) {
      const bool exact = one.name == "exact_equals_oracle" || one.name == "exact_queries_agree";
      if (one.needs != law::Needs::oracle && !(exact && method.is_exact())) continue;
      add(judged, one.name, method.full_name(), one.check(problem, method), problem);
    }
  }
  judged.by_oracle = judged.reached;
  return judged;
}

}  // namespace

const Target kTarget = {.name = "exact_oracle", .judge = &judge_exactly};

}  // namespace graze::fuzz
