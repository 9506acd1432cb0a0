#include "properties/laws/queries/asked.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "corpus/format/case_io.hpp"
#include "corpus/support_value.hpp"
#include "engines/guarantees.hpp"
#include "oracles/polytope/exact_body.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/judge/own_frames.hpp"
#include "properties/laws/queries/question.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Query;
using engine::Answer;
using engine::Interval;
using engine::Method;

namespace {

// Questions for which tier exact has an answer. An overlap has no target distance.
bool is_for_tier_exact(const Case& seen) {
  Case question = seen;
  if (seen.query == Query::overlap) question.target_distance = 0;
  return engine::is_exact_question(question);
}

// Beyond this, an exact answer takes more than ten milliseconds.
constexpr std::uint64_t kMostExactDifferences = 1u << 10;

bool is_for_oracle(const Case& seen) {
  return oracle::is_exact_body(seen.a.shape) && oracle::is_exact_body(seen.b.shape) &&
         vertex_count(seen.a.shape) * vertex_count(seen.b.shape) <= kMostExactDifferences;
}

// The same numbers in every place that a query reads.
bool same_question(const Case& one, const Case& other) {
  return one.query == other.query && one.direction == other.direction && same_input(one, other);
}

// The last few are kept, because several methods and laws use one case.
Truth& truth_of_question(const Case& seen) {
  thread_local std::array<std::optional<Truth>, 8> kept;
  thread_local std::size_t next = 0;
  for (std::optional<Truth>& one : kept) {
    if (one && same_question(one->problem(), seen)) return *one;
  }
  return kept[next++ % kept.size()].emplace(seen);
}

}  // namespace

double limit_of(const Method& method, const Case& seen) {
  return limits_of(method, seen, scale_of_question(method.query, seen.target_distance, scale_of(seen))).limit;
}

// The last summand: the laws evaluate h in doubles, which round at the size of far parts.
double contact_limit_of(const Method& method, const Question& question) {
  if (!method.is_exact()) return question.limit;
  const Case& seen = question.seen;
  const double scale = scale_of_question(method.query, seen.target_distance, scale_of(seen));
  return limits_of(method, seen, scale).contact + unseen_of_trees(seen, scale);
}

std::optional<Question> requestioned(Case edited, const Method& method) {
  if (!in_domain(edited) || !same_input(seen_by(method, edited), edited)) return std::nullopt;
  if (method.is_exact() && !is_for_tier_exact(edited)) return std::nullopt;
  if (edited.query == Query::penetration_along) {
    // Any length except zero, in the domain as every vector is.
    for (const double d : edited.direction) {
      if (!(d == 0 || (std::abs(d) >= 1e-60 && std::abs(d) <= 1e60))) return std::nullopt;
    }
    if (edited.direction == Vec3<double>::Zero()) return std::nullopt;
  }
  const double limit = limit_of(method, edited);
  return Question{std::move(edited), method.unit_roundoff, limit};
}

std::optional<Question> question_of(const Case& problem, const Method& method) {
  if (!engine::unsupported(engine::Kind::query, problem).empty() || has_spin(problem) ||
      !in_domain(problem)) {
    return std::nullopt;
  }
  return requestioned(seen_by(method, question_for(problem, method.query, hash_of(problem))), method);
}

LawResult other_query() { return not_applicable("the law is about another query"); }
LawResult no_question() { return not_applicable("not a question that the method answers"); }

bool in_contact(const Answer& answer) {
  return answer.outcome == Outcome::initially_overlapping || answer.outcome == Outcome::hit;
}

Interval gap_of(const Answer& answer) {
  Interval gap{-kInfinity<double>, kInfinity<double>};
  if (answer.separation) gap.upper = answer.separation->upper;
  if (answer.outcome == Outcome::miss) gap.lower = answer.separation ? answer.separation->lower : 0;
  if (answer.outcome == Outcome::initially_overlapping) {
    gap.upper = answer.depth ? -answer.depth->lower : 0;
    if (answer.depth) gap.lower = -answer.depth->upper;
  }
  return gap;
}

double apart(const Interval& one, const Interval& other) {
  return std::max({0.0, one.lower - other.upper, other.lower - one.upper});
}

bool same_time(const Interval& one, const Interval& other, double u) {
  const double size = std::max({std::abs(one.lower), std::abs(one.upper), std::abs(other.lower)});
  return !(apart(one, other) > (std::isfinite(size) ? 16 * u * size : 0));
}

bool same_line(const Answer& one, const Answer& other, double u) {
  if (one.outcome != other.outcome || one.outcome == Outcome::not_converged) return false;
  if (one.outcome != Outcome::hit) return true;
  return one.t_in && one.t_out && other.t_in && other.t_out && same_time(*one.t_in, *other.t_in, u) &&
         same_time(*one.t_out, *other.t_out, u);
}

Reach reach(const Body<double>& body, const Vec3<double>& n) {
  const Shape<double> turned = posed<double>(body.shape, Vec3<double>::Zero(), body.orientation);
  const corpus::Bounds box = corpus::bounds(turned);
  const double size = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  return {corpus::support_value(turned, n), 64 * kUnitRoundoff<double> * size * n.norm()};
}

Reach reach(const Case& seen, const Vec3<double>& n) {
  const Reach a = reach(seen.a, n), b = reach(seen.b, Vec3<double>(-n));
  const Vec3<double> between = seen.a.position - seen.b.position;
  return {n.dot(between) + a.value + b.value,
          a.error + b.error + 8 * kUnitRoundoff<double> * between.norm() * n.norm()};
}

std::optional<Judgement> oracle_judgement(const Method& method, const Case& seen, const Answer& answer,
                                          double tolerance) {
  if (!is_for_oracle(seen)) return std::nullopt;
  return judge_query(truth_of_question(seen), method, answer, tolerance);
}

namespace {

// Two answers that differ are worth a bracket that takes longer, of bodies that the exact oracle does not represent.
std::optional<Judgement> arbiter_judgement(const AskedQuery& one) {
  if (auto judgement = oracle_judgement(one.method, one.problem, one.answer)) return judgement;
  if (is_uncurved(one.problem.a.shape) && is_uncurved(one.problem.b.shape)) return std::nullopt;
  return judge_query(truth_of_question(one.problem), one.method, one.answer);
}

}  // namespace

LawResult arbitrate(std::initializer_list<AskedQuery> asked, std::string_view disagreement) {
  std::string all(disagreement);
  for (const AskedQuery& one : asked) all += fmt::format("; {}: {}", one.name, describe(one.answer));
  LawResult result = holds({"arbitrated"});
  for (const AskedQuery& one : asked) {
    const std::optional<Judgement> judgement = arbiter_judgement(one);
    if (!judgement) {
      result.labels.push_back("undecided");
    } else if (judgement->faulty()) {
      return broken(fmt::format("{}; at fault is {}: {}", all, one.name, judgement->fault()));
    }
  }
  return result;
}

}  // namespace graze::law
