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
  void add(const std::optional<Vec3<double>>& x) { add(x ? *x : Vec3<double>(0, 0, 0)); }
  void add(const Counters& c) {
    for (const int n :
         {c.iterations, c.supports, c.gjk_iterations, c.portal_steps, c.exact_decisions, c.poses})
      cost.push_back(static_cast<std::uint64_t>(n));
  }
};

template <class A>
Words cast_words(const A& a) {
  Words out;
  for (const double x :
       {static_cast<double>(a.outcome), static_cast<double>(a.invalid), a.toi_lower, a.toi_upper, a.distance,
        static_cast<double>(a.passed_over), static_cast<double>(a.proof.has_value())})
    out.add(x);
  for (const Vec3<double>& x : {a.normal, a.point_a, a.point_b}) out.add(x);
  out.add(a.counters);
  out.stalls = a.outcome == Outcome::not_converged;
  return out;
}

Words query_words(const engine::Answer& a) {
  Words out;
  for (const double x :
       {static_cast<double>(a.outcome), static_cast<double>(a.invalid), static_cast<double>(a.stalled)})
    out.add(x);
  for (const std::optional<engine::Interval>& x : {a.distance, a.depth, a.t_in, a.t_out}) out.add(x);
  for (const std::optional<Vec3<double>>& x : {a.normal, a.point_a, a.point_b}) out.add(x);
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
  const Request everything = Request::everything;
  std::size_t at = 0;
  if (kind == engine::Kind::linear) {
    for (const engine::Method& method : engine::methods(engine::Kind::linear))
      compare_answers([&] { return cast_words(method.ask(problem, {.request = everything})); }, mutant, sum,
                      at++);
    return;
  }
  at += engine::methods(engine::Kind::linear).size();
  if (kind == engine::Kind::query) {
    for (const engine::Method& method : engine::methods(engine::Kind::query)) {
      const corpus::Case question = law::question_for(problem, method.query, law::hash_of(problem));
      compare_answers([&] { return query_words(method.answer(question)); }, mutant, sum, at++);
    }
    return;
  }
  at += engine::methods(engine::Kind::query).size();
  for (const engine::Method& method : engine::methods(engine::Kind::rotating))
    compare_answers([&] { return cast_words(method.ask(problem, {.request = everything})); }, mutant, sum,
                    at++);
}

std::string stall_fault(const Difference& sum) {
  std::size_t at = 0;
  std::string out;
  const auto check = [&](const auto& methods) {
    for (const auto& method : methods) {
      const Stalls& stalls = sum.stalls[at++];
      const engine::Guarantee* const row = method.guarantee;
      const double cap = row != nullptr ? row->stall_cap : 1;
      const bool above =
          static_cast<double>(stalls.with) > std::ceil(cap * static_cast<double>(stalls.asked));
      if (out.empty() && above && stalls.with > stalls.without)
        out = fmt::format("{}: {} of {} end undecided, {} without the mutant", method.full_name(),
                          stalls.with, stalls.asked, stalls.without);
    }
  };
  check(engine::methods(engine::Kind::linear));
  check(engine::methods(engine::Kind::query));
  check(engine::methods(engine::Kind::rotating));
  return out;
}

}  // namespace graze::mutants
