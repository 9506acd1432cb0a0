#include "properties/mutants/compare.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engines/guarantees.hpp"
#include "properties/edit/case.hpp"
#include "properties/laws/queries/question.hpp"
#include "properties/mutants/mutants.hpp"

namespace graze::mutants {

namespace {

// An answer as words, compared bit by bit (two NaN are the same).
struct Words {
  std::vector<std::uint64_t> answer, cost;
  bool stalls = false;

  void add(double x) { answer.push_back(std::bit_cast<std::uint64_t>(x)); }
  void add(const Vec3<double>& x) {
    for (int i = 0; i < 3; ++i) add(x[i]);
  }
  void add(const std::optional<engine::Interval>& x) {
    add(x ? x->lower : -1);
    add(x ? x->upper : -1);
  }
  void add(const Counters& c) {
    for (const int n :
         {c.iterations, c.supports, c.gjk_iterations, c.portal_steps, c.exact_decisions, c.poses})
      cost.push_back(static_cast<std::uint64_t>(n));
  }
};

Words words_of(const engine::Answer& a) {
  Words out;
  for (const double x :
       {static_cast<double>(a.outcome), static_cast<double>(a.invalid), a.toi_lower, a.toi_upper, a.distance,
        static_cast<double>(a.passed_over), static_cast<double>(a.stalled),
        static_cast<double>(a.proof.has_value() || a.rotating_proof.has_value())})
    out.add(x);
  for (const std::optional<engine::Interval>& x : {a.separation, a.depth, a.t_in, a.t_out}) out.add(x);
  for (const Vec3<double>& x : {a.normal, a.normal_out, a.point_a, a.point_b}) out.add(x);
  out.add(a.counters);
  out.stalls = a.stalled || a.outcome == Outcome::not_converged;
  return out;
}

template <class Ask>
void compare_answers(const Ask& ask, int mutant, Difference& sum, std::size_t method) {
  graze_mutants::active = -1;
  const Words before = ask();
  graze_mutants::active = mutant;
  const Words after = ask();
  ++sum.asked;
  Stalls& stalls = sum.stalls[method];
  ++stalls.asked;
  stalls.without += before.stalls ? 1 : 0;
  stalls.with += after.stalls ? 1 : 0;
  if (before.answer != after.answer) {
    ++sum.answers;
  } else if (before.cost != after.cost) {
    ++sum.costs;
  }
  graze_mutants::comparing = true;
  const long already = graze_mutants::differed[mutant];
  static_cast<void>(ask());
  graze_mutants::comparing = false;
  sum.executed += graze_mutants::differed[mutant] - already;
}

}  // namespace

void compare(engine::Kind kind, const corpus::Case& problem, int mutant, Difference& sum) {
  std::size_t at = 0;
  for (const engine::Method& method : engine::methods()) {
    const std::size_t place = at++;
    if (method.kind != kind) continue;
    const bool is_query = kind == engine::Kind::query;
    const corpus::Case question =
        is_query ? law::question_for(problem, method.query, law::hash_of(problem)) : problem;
    const Request request = is_query ? engine::kPlain : Request::everything;
    compare_answers([&] { return words_of(method.ask(question, {.request = request})); }, mutant, sum, place);
  }
}

std::string stall_fault(const Difference& sum) {
  std::size_t at = 0;
  for (const engine::Method& method : engine::methods()) {
    const Stalls& stalls = sum.stalls[at++];
    const double cap = method.guarantee != nullptr ? method.guarantee->stall_cap : 1;
    const bool above = static_cast<double>(stalls.with) > std::ceil(cap * static_cast<double>(stalls.asked));
    if (above && stalls.with > stalls.without)
      return fmt::format("{}: {} of {} end undecided, {} without the mutant", method.full_name(), stalls.with,
                         stalls.asked, stalls.without);
  }
  return "";
}

}  // namespace graze::mutants
