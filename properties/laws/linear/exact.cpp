#include "properties/laws/linear/exact.hpp"

#include <fmt/format.h>

#include "corpus/format/names.hpp"
#include "engines/method.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/exact_answer.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Query;
using engine::Answer;
using engine::Method;

namespace {

// The exact oracle judges one case in so many, chosen by its numbers, because it takes up to a millisecond.
constexpr std::uint64_t kOracleShare = 16;

bool is_asked(const Method& method, const Case& seen) {
  return method.is_exact() && is_question_for(method, seen);
}

const engine::Method* exact_query(Query query, const std::string& scalar) {
  for (const engine::Method& one : engine::methods(engine::Kind::query)) {
    if (one.query == query && one.is_exact() && one.scalar == scalar) return &one;
  }
  return nullptr;
}

std::string line_fault(const Case& seen, const Answer& line, bool in_float) {
  if (!is_exactly_decided(seen)) return {};
  const std::optional<oracle::ContactInterval> interval = oracle::LinearTruth(seen).contact_interval();
  if ((line.outcome == Outcome::hit) != interval.has_value()) return "the line's verdict is not the oracle's";
  if (!interval) return {};
  if (!line.t_in || !line.t_out) return "the line is met at no time";
  if (!detail::is_outward(line.t_in, interval->in, in_float)) {
    return fmt::format("t_in is [{}, {}], not [{}, {}]", decimal(line.t_in->lower), decimal(line.t_in->upper),
                       decimal(interval->in.low), decimal(interval->in.high));
  }
  if (!detail::is_outward(line.t_out, interval->out, in_float)) {
    return fmt::format("t_out is [{}, {}], not [{}, {}]", decimal(line.t_out->lower),
                       decimal(line.t_out->upper), decimal(interval->out.low), decimal(interval->out.high));
  }
  return {};
}

std::string distance_fault(const Case& seen, const Answer& answer, bool in_float) {
  if (answer.outcome != Outcome::miss && answer.outcome != Outcome::initially_overlapping)
    return "the distance has no verdict";
  if (!is_exactly_decided(seen)) return {};
  const oracle::Enclosure distance = oracle::LinearTruth(seen).distance();
  if (detail::is_outward(answer.separation, distance, in_float)) return {};
  return fmt::format("the distance is not [{}, {}]", decimal(distance.low), decimal(distance.high));
}

// The bodies start within a target distance if it is the distance's upper end, and not if it is a smaller lower end.
std::string start_fault(Case seen, const Method& method, const engine::Interval& distance) {
  for (const double target : {distance.upper, distance.lower}) {
    seen.target_distance = target;
    const Outcome outcome = method.ask(seen, {}).outcome;
    const bool starts = outcome == Outcome::initially_overlapping;
    if (outcome != Outcome::invalid_input && starts != (target == distance.upper))
      return fmt::format("a cast at the target distance {} {} in contact", decimal(target),
                         starts ? "starts" : "does not start");
  }
  return {};
}

// overlap, distance, swept overlap and line agree with the cast. `cast` has been judged.
std::string query_fault(const Case& seen, const Method& method, const Answer& cast, bool ask_oracle) {
  const auto ask = [&](Query query) {
    Case question = seen;
    question.query = query;
    question.start_policy = StartPolicy::report;
    return exact_query(query, method.scalar)->answer(question);
  };
  const bool contact = cast.outcome != Outcome::miss;
  const Answer swept = ask(Query::swept_overlap), overlap = ask(Query::overlap), line = ask(Query::line),
               distance = ask(Query::distance);
  if (swept.outcome != (contact ? Outcome::hit : Outcome::miss)) return "the swept overlap is not the cast's";
  const bool starts = cast.outcome == Outcome::initially_overlapping;
  // An overlap knows no target distance.
  if (seen.target_distance == 0 &&
      overlap.outcome != (starts ? Outcome::initially_overlapping : Outcome::miss))
    return "the overlap is not the cast's";
  if (distance.outcome != overlap.outcome) return "the distance is not the overlap's";
  if (distance.outcome == Outcome::miss && distance.separation) {
    if (std::string fault = start_fault(seen, method, *distance.separation); !fault.empty()) return fault;
  }
  if (line.outcome != Outcome::hit && line.outcome != Outcome::miss) return "the line has no verdict";
  if (contact && line.outcome != Outcome::hit) return "the line misses what the cast meets";
  const bool moves = seen.a.displacement != seen.b.displacement;
  if (line.outcome == Outcome::hit && moves) {
    const engine::Interval in = line.t_in.value_or(engine::Interval{1, 0});
    const engine::Interval out = line.t_out.value_or(engine::Interval{0, 1});
    if (!(in.lower <= in.upper && out.lower <= out.upper && in.lower <= out.upper))
      return "the line's ends are no interval";
    if (cast.outcome == Outcome::hit && !(in.lower == cast.toi_lower && in.upper == cast.toi_upper))
      return "the line enters at another time than the cast's";
    if (starts && !(in.lower <= 0 && out.upper >= 0)) return "the line is not met at the start";
    if (!contact && in.upper <= seen.t_max && out.lower >= 0) return "the cast misses what the line meets";
  }
  if (!ask_oracle) return "";
  const bool in_float = method.scalar == "float";
  const std::string fault = distance_fault(seen, distance, in_float);
  return fault.empty() ? line_fault(seen, line, in_float) : fault;
}

LawResult exact_equals_oracle(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_asked(method, seen)) return not_applicable("not a cast of tier exact");
  const ExactJudgement judgement = judge_exact(seen, method, hash_of(seen) % kOracleShare == 0);
  if (!judgement.fault.empty()) return broken(judgement.fault + "; answered: " + describe(judgement.answer));
  LawResult result = holds({label_of(judgement.answer.outcome)});
  if (judgement.by_oracle) result.labels.push_back("by oracle");
  if (judgement.answer.counters.exact_decisions > 0) result.labels.push_back("near a tie");
  return result;
}

LawResult exact_queries_agree(const Case& problem, const Method& method) {
  Case seen = method.seen(problem);
  if (!is_asked(method, seen) || engine::is_exact_ray(seen))
    return not_applicable("not a cast of tier exact, or a ray that its queries do not take");
  seen.start_policy = StartPolicy::report;
  const Answer cast = method.ask(seen, {});
  const std::string fault = query_fault(seen, method, cast, hash_of(seen) % kOracleShare == 0);
  if (!fault.empty()) return broken(fault + "; the cast: " + describe(cast));
  return holds({label_of(cast.outcome)});
}

}  // namespace

ExactJudgement judge_exact(const Case& seen, const Method& method, bool ask_oracle) {
  const bool in_float = method.scalar == "float";
  ExactJudgement judgement;
  judgement.answer = method.ask(seen, {.request = Request::proof});
  const ExactFinding finding = judge_exact_by_proof(seen, judgement.answer, in_float);
  judgement.fault = finding.fault;
  // Few cases have these ties, so the oracle decides each: a contact at the end of the path, and a tie of round bodies. The
  // bracket of a graze at a double is that double, and a proof holds for a wider one, too.
  const Answer& answer = judgement.answer;
  const bool is_a_round_tie = answer.outcome == Outcome::hit && answer.counters.exact_decisions > 0 &&
                              answer.proof && answer.proof->of_cores;
  const bool is_a_tie = answer.toi_upper == seen.t_max || is_a_round_tie || engine::is_exact_ray(seen);
  if (!judgement.fault.empty() || (finding.settled && !ask_oracle && !is_a_tie)) return judgement;
  if (const auto closed = oracle::ClosedForm::of(seen); closed && engine::is_exact_ray(seen)) {
    judgement.by_oracle = true;
    judgement.fault = exact_fault_by_truth(*closed, judgement.answer, in_float);
    return judgement;
  }
  if (!is_exactly_decided(seen) || !has_truth(seen)) return judgement;
  judgement.by_oracle = true;
  judgement.fault = exact_fault_by_truth(truth_of(seen), judgement.answer, in_float);
  if (!judgement.fault.empty()) {
    judgement.fault +=
        fmt::format(": [{}, {}]", decimal(truth_of(seen).toi_lower()), decimal(truth_of(seen).toi_upper()));
  }
  return judgement;
}

std::vector<Law> linear_exact_laws() {
  return {
      {"exact_equals_oracle",
       "Tier exact: the verdict is the exact one, and the bracket the two S next to the TOI, to the last "
       "bit.",
       Needs::proof, &exact_equals_oracle},
      {"exact_queries_agree",
       "Tier exact: overlap, distance, swept overlap and line say what the cast and the exact oracle say, to "
       "the last bit.",
       Needs::proof, &exact_queries_agree},
  };
}

}  // namespace graze::law
