// Laws of the options of a search and of the state that it leaves behind: budgets that end too soon, tolerances,
// another scalar or tier, and the same question again.
#include <fmt/format.h>

#include <cmath>

#include "properties/edit/same_body.hpp"
#include "properties/laws/ask_twice.hpp"
#include "properties/laws/linear/proof.hpp"
#include "properties/laws/tables.hpp"
#include "properties/laws/work.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;
using oracle::CaseTruth;

namespace {

// Support evaluations: one after the other where a search begins, then farther apart.
constexpr int kBudgets[] = {1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 24, 48, 96};

bool same_bits(const Vec3<double>& l, const Vec3<double>& r) { return l == r; }

// Compares verdict, times, contact, cost and proved bounds.
bool is_same_answer(const Answer& one, const Answer& two) {
  const Counters &c = one.counters, &d = two.counters;
  const auto same = [](double l, double r) { return l == r || (std::isnan(l) && std::isnan(r)); };
  if (one.outcome != two.outcome || one.passed_over != two.passed_over ||
      !same(one.toi_lower, two.toi_lower) || !same(one.toi_upper, two.toi_upper) ||
      !same(one.distance, two.distance)) {
    return false;
  }
  if (!same_bits(one.normal, two.normal) || !same_bits(one.point_a, two.point_a) ||
      !same_bits(one.point_b, two.point_b)) {
    return false;
  }
  if (c.iterations != d.iterations || c.supports != d.supports || c.gjk_iterations != d.gjk_iterations ||
      c.portal_steps != d.portal_steps || c.exact_decisions != d.exact_decisions) {
    return false;
  }
  if (one.proof.has_value() != two.proof.has_value()) return false;
  return !one.proof ||
         (one.proof->toi_lower == two.proof->toi_lower && one.proof->toi_upper == two.proof->toi_upper &&
          one.proof->portal_size == two.proof->portal_size && one.proof->axis == two.proof->axis);
}

LawResult interrupting(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  const Answer full = method.ask(seen, {});
  LawResult result = holds({label_of(full.outcome)});
  if (full.outcome == Outcome::not_converged) return result;
  // The least part of the default, 256, that one stage of a search has: a third of three quarters, or a quarter
  // (casts/robust_cast.hpp). The full answer may have used it up.
  constexpr int kLeastPart = 64;
  if (const Answer more = method.ask(seen, {.max_iterations = 4096});
      full.counters.supports < kLeastPart && !is_same_answer(full, more)) {
    return broken(fmt::format("a budget larger than needed changes the answer: {}; against {}",
                              describe(full), describe(more)));
  }
  // Searches whose every support point may raise the bound go the same way until the budget ends.
  // Conservative advancement advances by a distance that is cut short, too, and then along another axis.
  const bool every_support_counts = method.name != "ca";
  double proved = 0;  // by a smaller budget
  for (const int budget : kBudgets) {
    const Answer cut = method.ask(seen, {.max_iterations = budget});
    if (is_same_answer(cut, full)) break;
    const auto with_budget = [&] {
      return fmt::format("with a budget of {}: {}; in full: {}", budget, describe(cut), describe(full));
    };
    if (cut.outcome == Outcome::invalid_input) return broken("refused " + with_budget());
    const double u = method.unit_roundoff;
    bool consistent = agree_within_rows(method, seen, cut, full);
    if (cut.outcome == Outcome::not_converged) {
      result.labels.push_back("interrupted");
      if (!(cut.toi_lower >= 0 && cut.toi_lower <= cut.toi_upper))
        return broken("no bracket " + with_budget());
      if (every_support_counts && cut.toi_lower < proved * (1 - 16 * u)) {
        // Each is a lower bound within the guarantee. At a graze two such bounds may be far apart.
        if (const auto open = without_truth(seen)) return *open;
        Answer before = cut;
        before.toi_lower = proved;
        if (const std::string late = late_fault(truth_of(seen), before, proved_bound_of(method, seen));
            !late.empty()) {
          return broken(fmt::format("the lower bound goes back from {} {}", decimal(proved), with_budget()));
        }
        result.labels.push_back("goes back");
      }
      proved = std::max(proved, cut.toi_lower);
      // The bracket meets that of the answer. A miss leaves nothing except the end of the path.
      consistent = full.outcome == Outcome::miss || (cut.toi_lower <= full.toi_upper * (1 + 16 * u) &&
                                                     cut.toi_upper * (1 + 16 * u) >= full.toi_lower);
    }
    if (consistent) continue;
    // An answer that did not converge is not a fault here: tier certified must decide only with its own
    // budget.
    const double bound = has_truth(seen) ? proved_bound_of(method, seen) : 0;
    if (const auto open = without_truth(seen)) return *open;
    for (const Answer* said : {&cut, &full}) {
      for (const auto fault : {&verdict_fault, &late_fault, &early_fault}) {
        if (const std::string why = fault(truth_of(seen), *said, bound); !why.empty())
          return broken(why + "; " + with_budget());
      }
    }
    result.labels.push_back("arbitrated");
  }
  return result;
}

LawResult tightening(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  const double u = method.unit_roundoff;
  const Answer full = method.ask(seen, {});
  LawResult result = holds({label_of(full.outcome)});
  Answer best;  // the bracket that looser tolerances leave
  best.outcome = Outcome::not_converged;
  best.toi_lower = 0;
  best.toi_upper = kInfinity<double>;
  for (const double tolerance : {1.0, 0x1p-2, 0x1p-4, 0x1p-6, 0x1p-8, 0x1p-12, 0x1p-16, 0.0}) {
    const Answer answer = tolerance > 0 ? method.ask(seen, {.tolerance = tolerance}) : full;
    if (const std::string why = moved_by_tolerance(full, answer, tolerance); !why.empty()) return broken(why);
    if (answer.outcome != Outcome::hit) continue;
    if (answer.toi_lower < best.toi_lower * (1 - 16 * u) ||
        answer.toi_upper > best.toi_upper * (1 + 16 * u)) {
      // Each may be right within the guarantee, whatever the tolerance.
      if (const auto open = without_truth(seen)) return *open;
      const double bound = proved_bound_of(method, seen);
      for (const Answer* said : {static_cast<const Answer*>(&best), &answer}) {
        for (const auto fault : {&late_fault, &early_fault}) {
          if (const std::string why = fault(truth_of(seen), *said, bound); !why.empty()) {
            return broken(fmt::format("the tolerance {} leaves [{}, {}], a looser one [{}, {}]: {}",
                                      decimal(tolerance), decimal(answer.toi_lower),
                                      decimal(answer.toi_upper), decimal(best.toi_lower),
                                      decimal(best.toi_upper), why));
          }
        }
      }
      result.labels.push_back("arbitrated");
    }
    if (answer.toi_lower > best.toi_lower && best.toi_lower > 0) result.labels.push_back("advanced");
    best.toi_lower = std::max(best.toi_lower, answer.toi_lower);
    best.toi_upper = std::min(best.toi_upper, answer.toi_upper);
  }
  return result;
}

LawResult interrupted_is_right(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  if (const auto open = without_truth(seen)) return *open;
  const CaseTruth& truth = truth_of(seen);
  const double bound = proved_bound_of(method, seen);
  LawResult result = holds({label_of(truth.outcome())});
  for (const int budget : kBudgets) {
    const Answer cut = method.ask(seen, {.max_iterations = budget});
    for (const auto fault : {&verdict_fault, &late_fault, &early_fault}) {
      if (const std::string why = fault(truth, cut, bound); !why.empty())
        return broken(fmt::format("{}; with a budget of {}: {}", why, budget, describe(cut)));
    }
    // The rest is the full answer, which other laws judge.
    if (cut.outcome != Outcome::not_converged) break;
    result.labels.push_back("interrupted");
  }
  return result;
}

LawResult every_iterate_is_proved(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  LawResult result = holds();
  for (const int budget : kBudgets) {
    const Answer cut = method.ask(seen, {.request = Request::proof, .max_iterations = budget});
    if (const std::string fault = proof_fault(seen, cut); !fault.empty())
      return broken(fmt::format("{}; with a budget of {}: {}", fault, budget, describe(cut)));
    if (cut.outcome != Outcome::not_converged) {
      result.labels.push_back(label_of(cut.outcome));
      break;
    }
    result.labels.push_back(cut.proof && cut.proof->has_axis ? "interrupted with an axis" : "interrupted");
  }
  return result;
}

LawResult tolerance_bounds_the_error(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  if (const auto open = without_truth(seen)) return *open;
  const CaseTruth& truth = truth_of(seen);
  LawResult result = holds({label_of(truth.outcome())});
  for (const double tolerance : {0x1p-30, 0x1p-10, 0.5}) {
    const Answer answer = method.ask(seen, {.request = Request::normal, .tolerance = tolerance});
    const double row = proved_bound_of(method, seen), slack = tolerance * truth.scale().high;
    const double wide = bound_of(method, seen) + slack;
    // The verdict and the early side of the bracket do not depend on the tolerance.
    std::string fault = verdict_fault(truth, answer, row);
    if (fault.empty()) fault = late_fault(truth, answer, row);
    if (fault.empty()) fault = early_fault(truth, answer, row);
    if (fault.empty()) fault = time_fault(truth, answer, wide);
    if (fault.empty() && answer.outcome == Outcome::hit && truth.outcome() == Outcome::hit)
      fault = normal_fault(seen, answer, answer.normal, contact_bound_of(method, seen) + slack);
    if (!fault.empty())
      return broken(
          fmt::format("{}; with the tolerance {}: {}", fault, decimal(tolerance), describe(answer)));
    if (answer.outcome == Outcome::hit && answer.toi_lower < answer.toi_upper)
      result.labels.push_back("wide");
  }
  return result;
}

LawResult scalars_meet(const Case& problem, const Method& method) {
  if (method.scalar != "float") return not_applicable("double is what float is compared with");
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  const Method* wide = engine::find_method(engine::Kind::linear, method.name + "/double");
  if (wide == nullptr || !same_input(wide->seen(seen), seen))
    return not_applicable("no such method in double");
  const Answer one = method.ask(seen, {}), two = wide->ask(seen, {});
  LawResult result = holds({label_of(two.outcome)});
  if (agree_within_rows(method, seen, one, two)) return result;
  // Each within its own guarantee.
  if (const auto open = without_truth(seen)) return *open;
  for (const auto& [judged, answer] : {std::pair(&method, &one), std::pair(wide, &two)}) {
    if (const std::string fault = any_fault(*judged, seen, *answer); !fault.empty()) {
      return broken(fmt::format("float and double do not meet: {}; against {}; at fault is {}: {}",
                                describe(one), describe(two), judged->full_name(), fault));
    }
  }
  result.labels.push_back("arbitrated");
  return result;
}

LawResult tiers_nest(const Case& problem, const Method& method) {
  if (!method.is_certified()) return not_applicable("not a method of tier certified");
  const Case seen = method.seen(problem);
  const Method* exact = engine::find_method(engine::Kind::linear, "exact/" + method.scalar);
  if (exact == nullptr || !is_question_for(*exact, seen)) return not_applicable("not a cast of tier exact");
  // Tier certified leaves polytopes to tier exact: the same set as a hull of shapes, which it searches
  // itself.
  Case round = seen;
  round.a.shape = hull_of<double>(seen.a.shape, seen.a.shape);
  if (!is_sound_edit(round, method)) return not_applicable("nested too deep");
  const Answer inner = exact->ask(seen, {}), outer = method.ask(round, {});
  bool nests = false;
  switch (outer.outcome) {
    case Outcome::miss:
    case Outcome::initially_overlapping:
      nests = inner.outcome == outer.outcome;
      break;
    case Outcome::hit:
    case Outcome::not_converged:
      // A bracket from 0 leaves open whether the start is in contact.
      nests = inner.outcome == Outcome::hit
                  ? outer.toi_lower <= inner.toi_lower && inner.toi_upper <= outer.toi_upper
                  : outer.toi_lower == 0 ||
                        (inner.outcome == Outcome::miss && outer.outcome == Outcome::not_converged);
      if (outer.outcome == Outcome::hit && inner.outcome == Outcome::miss) nests = false;
      break;
    case Outcome::invalid_input:
      break;
  }
  if (!nests) {
    return broken(fmt::format("the exact answer is not within the certified bracket: {}; against {}",
                              describe(inner), describe(outer)));
  }
  LawResult result = holds({label_of(inner.outcome)});
  if (outer.outcome == Outcome::not_converged) result.labels.push_back("left open");
  return result;
}

LawResult asking_again(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return outside();
  const engine::Ask ask{.request = Request::everything};
  const Answer first = method.ask(seen, ask);
  // Another question between: the same bodies exchanged, or grown, or apart.
  Case other = (hash_of(seen) & 1) != 0 ? swapped(seen) : grown(seen, hash_of(seen));
  if ((hash_of(seen) & 2) != 0) other.b.position += Vec3<double>(1, 2, 4);
  (void)method.ask(other, ask);
  const Answer second = method.ask(seen, ask);
  if (!is_same_answer(first, second)) {
    return broken(fmt::format("asked again, after another question: {}; before it: {}", describe(second),
                              describe(first)));
  }
  LawResult result = holds({label_of(first.outcome)});
  // Adjacency adds no information about the bodies to their vertices.
  const auto given = with_other_hulls(seen);
  if (!given) return result;
  const Answer third = method.ask(*given, ask);
  if (!is_same_answer(first, third)) {
    return broken(fmt::format("with adjacency where there was none, or without: {}; as it was: {}",
                              describe(third), describe(first)));
  }
  result.labels.push_back("adjacency");
  return result;
}

LawResult work(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  return is_question_for(method, seen) ? within_its_work(seen, method) : outside();
}

}  // namespace

std::vector<Law> linear_advancement_laws() {
  return {
      {"interrupting",
       "A budget that is too small leaves a bracket that meets the answer's. A lower end that decreases with "
       "the budget was right all the same (with ca, an advance cut short may lead farther).",
       Needs::metamorphic, &interrupting},
      {"tightening",
       "A tighter tolerance never lowers toi_lower and never raises toi_upper. No tolerance changes the "
       "verdict or costs supports.",
       Needs::metamorphic, &tightening},
      {"asking_again",
       "The same question gets the same bits, whatever was asked between, and with adjacency of its hulls or "
       "without.",
       Needs::metamorphic, &asking_again},
      {"scalars_meet", "The brackets of a method in float and in double meet, each within its guarantee.",
       Needs::metamorphic, &scalars_meet},
      {"tiers_nest", "The exact bracket lies within the certified one.", Needs::metamorphic, &tiers_nest},
      {"work", "A cast takes no more support evaluations than its guarantee's most_supports.",
       Needs::metamorphic, &work},
      {"every_iterate_is_proved",
       "Every proof of an answer cut short by its budget is accepted by the checker.", Needs::proof,
       &every_iterate_is_proved},
      {"interrupted_is_right",
       "An answer cut short by its budget is never late, and a verdict of it never wrong, beyond kappa u "
       "scale.",
       Needs::oracle, &interrupted_is_right},
      {"tolerance_bounds_the_error",
       "A looser tolerance widens the backward error, and the normal's, by no more than itself, is never "
       "late, and changes no verdict.",
       Needs::oracle, &tolerance_bounds_the_error},
  };
}

}  // namespace graze::law
