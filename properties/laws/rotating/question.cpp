#include "properties/laws/rotating/question.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;
using engine::Unseen;
using oracle::RotatingTruth;

bool is_rotating_question(const Case& seen) {
  if (!engine::unsupported(engine::Kind::rotating, seen).empty() || !in_domain(seen)) return false;
  if (!std::isfinite(seen.t_max) || seen.start_policy != StartPolicy::report) return false;
  return turns_within_range(seen);
}

bool turns_within_range(const Case& seen) {
  const double most = std::max(seen.spin_a.rotation.norm(), seen.spin_b.rotation.norm());
  return !std::isfinite(seen.t_max) || most * seen.t_max <= 0x1p30;
}

LawResult no_rotating_question() { return not_applicable("not a rotating cast that the method answers"); }

bool fits(const Case& edited, const Method& method) { return same_input(method.seen(edited), edited); }

bool follows_plan(const Method& method) { return method.name == "plan" || method.is_certified(); }

bool is_safe(const Method& method) {
  const engine::Guarantee* row = method.guarantee;
  return row != nullptr && row->may_miss == Unseen::nothing;
}

const RotatingTruth* rotating_truth_of(const Case& seen) {
  struct Entry {
    std::optional<Case> problem;
    std::optional<RotatingTruth> truth;
  };
  thread_local std::array<Entry, 6> kept;
  thread_local std::size_t next = 0;
  const auto answer = [](const Entry& entry) {
    return entry.truth && !entry.truth->budget_ended() ? &*entry.truth : nullptr;
  };
  for (const Entry& entry : kept) {
    if (entry.problem && same_input(*entry.problem, seen)) return answer(entry);
  }
  Entry& entry = kept[next++ % kept.size()];
  entry.problem.reset();
  entry.truth.reset();
  // The oracle reports an undecided case by this exception, and nothing else.
  try {
    entry.truth.emplace(seen, RotatingTruth::kDefaultWidth, kTruthBudget);
  } catch (const std::invalid_argument&) {
  }
  entry.problem = seen;
  return answer(entry);
}

Answer plain_answer(const Method& method, const Case& seen) {
  struct Entry {
    Case problem;
    Answer answer;
  };
  thread_local std::map<const Method*, Entry> kept;
  if (const auto found = kept.find(&method); found != kept.end() && same_input(found->second.problem, seen))
    return found->second.answer;
  Answer answer = method.ask(seen, {});
  kept.insert_or_assign(&method, Entry{seen, answer});
  return answer;
}

std::string pair_of(const Answer& one, const Answer& other) {
  return describe(one) + "; against " + describe(other);
}

LawResult labelled(LawResult result, std::initializer_list<std::string_view> labels) {
  result.labels.insert(result.labels.end(), labels);
  return result;
}

Times times_of(const Answer& answer) { return {answer.toi_lower, answer.toi_upper}; }

bool overlap(const Times& one, const Times& other) {
  return std::max(one.lower, other.lower) <= std::min(one.upper, other.upper);
}

bool same_times(const Answer& one, const Answer& other) {
  const auto same = [](double l, double r) { return l == r || (std::isnan(l) && std::isnan(r)); };
  return one.outcome == other.outcome && same(one.toi_lower, other.toi_lower) &&
         same(one.toi_upper, other.toi_upper);
}

std::string difference(const Answer& one, const Answer& two) {
  if (one.outcome != two.outcome) return "outcome";
  if (!same_times(one, two)) return "time";
  if (one.counters.iterations != two.counters.iterations || one.counters.supports != two.counters.supports ||
      one.counters.poses != two.counters.poses)
    return "count of iterations, supports or poses";
  if (one.plan.reasons != two.plan.reasons) return "plan";
  return "";
}

LawResult arbitrate(const Method& method, const RotatingAsked& one, const RotatingAsked& other,
                    std::string_view disagreement) {
  LawResult result = holds({label_of(one.answer.outcome)});
  if (limits_of(method, one.problem, scale_of(one.problem)).may_be_late == Unseen::anything) {
    // It may pass one contact here and another there.
    result.labels.push_back("may differ");
    return result;
  }
  const std::string all = fmt::format("{}; {}: {}; {}: {}", disagreement, one.name, describe(one.answer),
                                      other.name, describe(other.answer));
  if (method.is_certified() && one.slack == 0 && other.slack == 0) {
    return broken(all + "; and both are proved");
  }
  result.labels.push_back("arbitrated");
  for (const RotatingAsked* asked : {&one, &other}) {
    const RotatingTruth* truth = rotating_truth_of(asked->problem);
    if (truth == nullptr) {
      result.labels.push_back("no truth");
      continue;
    }
    const std::string fault = any_fault(
        *truth, asked->answer,
        limits_of(method, asked->problem, scale_of(asked->problem), asked->tolerance, asked->slack));
    if (!fault.empty()) return broken(fmt::format("{}; at fault is {}: {}", all, asked->name, fault));
  }
  return result;
}

LawResult compare(const Method& method, const RotatingAsked& one, const RotatingAsked& other,
                  std::string_view disagreement) {
  if (overlap(times_of(one.answer), times_of(other.answer))) return holds({label_of(one.answer.outcome)});
  return arbitrate(method, one, other, disagreement);
}

}  // namespace graze::law
