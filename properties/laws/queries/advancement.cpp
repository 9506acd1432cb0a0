// Laws of the options of a query's search and of its state afterwards: budgets that end too soon, tolerances.
#include <fmt/format.h>

#include <algorithm>
#include <graze/distance.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "properties/edit/case.hpp"
#include "properties/judge/limits.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/queries/asked.hpp"
#include "properties/laws/queries/question.hpp"
#include "properties/laws/tables.hpp"
#include "properties/laws/work.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Query;
using engine::Answer;
using engine::Ask;
using engine::Interval;
using engine::Method;

namespace {

// Support evaluations, or portal steps of each end.
constexpr int kBudgets[] = {1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 24, 48};
// Over scale.
constexpr double kTolerances[] = {0x1p-30, 0x1p-10, 0.25, 1};

bool is_at_rest(Query query) { return query != Query::line && query != Query::swept_overlap; }

// An overlap has no options, a swept overlap no tolerance. Tier exact needs neither, and reads none.
bool has_budget(const Method& method) { return method.query != Query::overlap && !method.is_exact(); }
bool has_tolerance(const Method& method) {
  return has_budget(method) && method.query != Query::swept_overlap;
}
LawResult without_option() { return not_applicable("the query has no such option"); }

Ask budget_of(int supports) { return {.request = engine::kPlain, .max_iterations = supports}; }
Ask tolerance_of(double tolerance) { return {.request = engine::kPlain, .tolerance = tolerance}; }

std::string told(const Ask& ask) {
  return ask.max_iterations != 0 ? fmt::format("with a budget of {}", ask.max_iterations)
                                 : fmt::format("with the tolerance {}", decimal(ask.tolerance));
}

// The facts that the full search knows about the question: its own answer and, for bodies at rest, their distance and
// depth, by whichever query states them.
struct Known {
  Answer answer;
  double apart = 0, deep = 0;  // at least, beyond the limits of the guarantees
};
Known known_of(const Method& method, const Question& question) {
  Known known{.answer = method.answer(question.seen)};
  if (!is_at_rest(method.query)) return known;
  for (const Query query : {Query::distance, Query::penetration}) {
    const Method& by = default_method(query, method.scalar);
    Case rest = question.seen;
    rest.query = query;
    const Answer answer = by.answer(rest);
    const double limit = question.limit + limit_of(by, rest);
    if (answer.outcome == Outcome::miss && answer.separation)
      known.apart = std::max(known.apart, answer.separation->lower - limit);
    if (answer.outcome == Outcome::initially_overlapping && answer.depth)
      known.deep = std::max(known.deep, answer.depth->lower - limit);
  }
  return known;
}

// An answer to the question with its options, beside the facts of the full search: does the verdict contradict them?
std::string against(const Known& known, const Answer& answer) {
  if (in_contact(answer) && known.apart > 0)
    return fmt::format("claims contact of bodies that are {} apart", known.apart);
  if (answer.outcome == Outcome::miss && known.deep > 0)
    return fmt::format("claims a miss of bodies that are {} deep", known.deep);
  return {};
}

// Both are decided, and they contradict each other.
bool differ(const Answer& one, const Answer& two) {
  const bool say = one.outcome != Outcome::not_converged && two.outcome != Outcome::not_converged;
  return say && in_contact(one) != in_contact(two);
}

// For a distance and a least depth the brackets meet, within the guarantees. The rest is ill-conditioned and left to an
// oracle.
double apart_of(const Method& method, const Answer& one, const Answer& two) {
  if (method.query != Query::distance && method.query != Query::penetration) return 0;
  return apart(gap_of(one), gap_of(two));
}

std::string beside(const Answer& cut, const Answer& full, const Ask& ask) {
  return fmt::format("{}: {}; in full: {}", told(ask), describe(cut), describe(full));
}

// Faults that no option may cause. `result`: labels of the outcomes.
std::string fault_of(const Method& method, const Question& question, const Known& known, const Ask& ask,
                     const Answer& cut, LawResult& result) {
  const Answer& full = known.answer;
  if (cut.outcome == Outcome::invalid_input) return "refused " + beside(cut, full, ask);
  if (const std::string why = against(known, cut); !why.empty()) return why + " " + beside(cut, full, ask);
  if (const double off = apart_of(method, cut, full); off > 2 * question.limit) {
    return fmt::format("the bracket is {} off the whole one, the guarantees allow {}: {}", off,
                       2 * question.limit, beside(cut, full, ask));
  }
  if (!differ(cut, full)) return {};
  const LawResult judged =
      arbitrate({{told(ask), method, question.seen, cut}, {"in full", method, question.seen, full}},
                "contact to one and none to the other");
  result.labels.push_back("arbitrated");
  return judged.reason;
}

LawResult query_interrupting(const Case& problem, const Method& method) {
  if (!has_budget(method)) return without_option();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Known known = known_of(method, *question);
  LawResult result = holds({label_of(known.answer.outcome)});
  for (const int budget : kBudgets) {
    const Ask ask = budget_of(budget);
    const Answer cut = method.ask(question->seen, ask);
    if (const std::string fault = fault_of(method, *question, known, ask, cut, result); !fault.empty())
      return broken(fault);
    if (cut.stalled || cut.outcome == Outcome::not_converged) result.labels.push_back("interrupted");
  }
  return result;
}

LawResult query_tolerance_widens(const Case& problem, const Method& method) {
  if (!has_tolerance(method)) return without_option();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  const Known known = known_of(method, *question);
  const double scale = scale_of(question->seen);
  LawResult result = holds({label_of(known.answer.outcome)});
  for (const double tolerance : kTolerances) {
    const Ask ask = tolerance_of(tolerance);
    const Answer loose = method.ask(question->seen, ask);
    if (const std::string fault = fault_of(method, *question, known, ask, loose, result); !fault.empty())
      return broken(fault);
    if (const std::string why = moved_by_tolerance(known.answer, loose, tolerance); !why.empty())
      return broken(why);
    const bool may_be_wide = loose.stalled || method.query == Query::penetration_along;
    for (const std::optional<Interval>* x : {&loose.separation, &loose.depth}) {
      if (!*x || may_be_wide) continue;
      const double width = (*x)->upper - (*x)->lower;
      if (!(width <= tolerance * scale + 2 * question->limit))
        return broken(fmt::format("a bracket {} wide is not marked as not converged {}", width,
                                  beside(loose, known.answer, ask)));
      if (width > 2 * question->limit) result.labels.push_back("wide");
    }
  }
  return result;
}

// Is a point beyond a body, by more than the slack, along some direction? GJK searches for one. The support function
// (corpus/support_value.hpp), which is independent of any search, confirms it.
std::string outside(const Body<double>& body, const Vec3<double>& point, double slack) {
  Body<double> still = body;
  still.displacement.setZero();
  const DistanceResult<double> found = distance(still, Body<double>{.position = point});
  if (!(found.lower > slack)) return {};
  const Reach end = reach(body, found.normal);
  const double beyond = found.normal.dot(point - body.position) - end.value - end.error;
  return beyond > slack ? fmt::format("{} outside of its body, {} allowed", beyond, slack) : std::string();
}

LawResult points_are_of_the_bodies(const Case& problem, const Method& method) {
  if (!is_at_rest(method.query) || method.query == Query::overlap) return other_query();
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  std::vector<Ask> asks = {{.request = engine::kPlain}};
  for (const int budget : kBudgets) asks.push_back(budget_of(budget));
  for (const double tolerance : kTolerances) asks.push_back(tolerance_of(tolerance));
  LawResult result = holds();
  for (const Ask& ask : asks) {
    const Answer answer = method.ask(question->seen, ask);
    if (&ask == &asks.front()) result.labels.push_back(label_of(answer.outcome));
    if (!answer.has_points) continue;
    for (const bool first : {true, false}) {
      const Body<double>& body = first ? question->seen.a : question->seen.b;
      const Vec3<double>& point = first ? answer.point_a : answer.point_b;
      const std::string fault =
          outside(body, point, contact_limit_of(method, *question) + 2 * question->u * point.norm());
      if (!fault.empty())
        return broken(fmt::format("the point of {} is {} {}: {}", first ? 'A' : 'B', fault, told(ask),
                                  describe(answer)));
    }
    if (answer.stalled) result.labels.push_back("interrupted");
  }
  return result;
}

LawResult judged_with(const Case& problem, const Method& method, std::span<const Ask> asks) {
  const auto question = question_of(problem, method);
  if (!question) return no_question();
  LawResult result = holds({label_of(method.answer(question->seen).outcome)});
  for (const Ask& ask : asks) {
    const Answer answer = method.ask(question->seen, ask);
    const auto judgement = oracle_judgement(method, question->seen, answer, ask.tolerance);
    if (!judgement) return not_applicable("not decided by the exact oracle");
    if (judgement->faulty())
      return broken(fmt::format("{} {}: {}", judgement->fault(), told(ask), describe(answer)));
    if (judgement->stalled) result.labels.push_back("interrupted");
  }
  return result;
}

LawResult interrupted_query_is_right(const Case& problem, const Method& method) {
  if (!has_budget(method)) return without_option();
  std::vector<Ask> asks;
  for (const int budget : kBudgets) asks.push_back(budget_of(budget));
  return judged_with(problem, method, asks);
}

LawResult query_tolerance_is_kept(const Case& problem, const Method& method) {
  if (!has_tolerance(method)) return without_option();
  std::vector<Ask> asks;
  for (const double tolerance : kTolerances) asks.push_back(tolerance_of(tolerance));
  return judged_with(problem, method, asks);
}

LawResult query_work(const Case& problem, const Method& method) {
  const auto question = question_of(problem, method);
  return question ? within_its_work(question->seen, method) : no_question();
}

}  // namespace

std::vector<Law> query_advancement_laws() {
  return {
      {"query_interrupting",
       "A query cut short by its budget leaves brackets that meet the whole ones, and no verdict that "
       "distance "
       "or depth contradict.",
       Needs::metamorphic, &query_interrupting},
      {"query_tolerance_widens",
       "A tolerance widens the bracket of a distance or a depth by no more than itself, off the whole one "
       "nowhere, changes no verdict and costs no support.",
       Needs::metamorphic, &query_tolerance_widens},
      {"query_work", "A query takes no more support evaluations than its guarantee's most_supports.",
       Needs::metamorphic, &query_work},
      {"points_are_of_the_bodies",
       "However wide the bracket that a budget or a tolerance leaves, the points are points of the bodies.",
       Needs::proof, &points_are_of_the_bodies},
      {"interrupted_query_is_right",
       "A query cut short by its budget holds the truth in its brackets, and its verdict is right, within "
       "kappa u "
       "scale.",
       Needs::oracle, &interrupted_query_is_right},
      {"query_tolerance_is_kept",
       "With a tolerance a query's verdict is as right as without, and its brackets are off by no more than "
       "that.",
       Needs::oracle, &query_tolerance_is_kept},
  };
}

}  // namespace graze::law
