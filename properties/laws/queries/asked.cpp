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
#include "properties/judge/linear.hpp"
#include "properties/judge/own_frames.hpp"
#include "properties/laws/queries/question.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Query;
using engine::Interval;
using engine::QueryAnswer;
using engine::QueryMethod;

namespace {

double unit_roundoff(const QueryMethod& method) {
  return method.scalar == "float" ? kUnitRoundoff<float> : kUnitRoundoff<double>;
}

// As DESIGN has it: the largest of the boxes' diagonals and the distance of their centres.
double scale_of(const Case& seen) {
  const corpus::Bounds a = corpus::bounds(seen.a.shape, seen.a.orientation),
                       b = corpus::bounds(seen.b.shape, seen.b.orientation);
  const Vec3<double> between = seen.b.position - seen.a.position + (b.low + b.high - a.low - a.high) / 2;
  return std::max({(a.high - a.low).stableNorm(), (b.high - b.low).stableNorm(), between.stableNorm()});
}

// For which tier exact has an answer: an overlap knows no target distance.
bool is_for_tier_exact(const Case& seen) {
  Case question = seen;
  if (seen.query == Query::overlap) question.target_distance = 0;
  return engine::is_exact_question(question);
}

// Beyond, an exact answer takes more than ten milliseconds.
constexpr std::uint64_t kMostExactDifferences = 1u << 10;

bool is_for_oracle(const Case& seen) {
  return oracle::is_exact_body(seen.a.shape) && oracle::is_exact_body(seen.b.shape) &&
         vertex_count(seen.a.shape) * vertex_count(seen.b.shape) <= kMostExactDifferences;
}

// The same numbers in every place that a query reads.
bool same_question(const Case& one, const Case& other) {
  return one.query == other.query && one.direction == other.direction && same_input(one, other);
}

// The last few are kept: several methods and laws are asked about one case.
QueryTruth& truth_of_question(const Case& seen) {
  thread_local std::array<std::optional<QueryTruth>, 8> kept;
  thread_local std::size_t next = 0;
  for (std::optional<QueryTruth>& one : kept) {
    if (one && same_question(one->problem(), seen)) return *one;
  }
  return kept[next++ % kept.size()].emplace(seen);
}

std::string text(const std::optional<Interval>& bracket) {
  return bracket ? fmt::format("[{}, {}]", hex(bracket->lower), hex(bracket->upper)) : "none";
}
std::string text(const std::optional<Vec3<double>>& v) { return v ? hex(*v) : "none"; }

}  // namespace

double limit_of(const QueryMethod& method, const Case& seen) {
  const engine::Guarantee* row = engine::find_guarantee(engine::guarantees(), method);
  const double kappa = row != nullptr ? row->kappa(seen) : kInfinity<double>;
  const double scale = scale_of_question(method.query, seen.target_distance, scale_of(seen));
  return kappa == 0 ? 0 : kappa * unit_roundoff(method) * scale + unseen_of_trees(seen, scale);
}

std::optional<Question> requestioned(Case edited, const QueryMethod& method) {
  if (!in_domain(edited) || !same_input(seen_by(method, edited), edited)) return std::nullopt;
  if (method.is_exact() && !is_for_tier_exact(edited)) return std::nullopt;
  if (edited.query == Query::penetration_along) {
    // Of any length but zero, in the domain as every vector is.
    for (const double d : edited.direction) {
      if (!(d == 0 || (std::abs(d) >= 1e-60 && std::abs(d) <= 1e60))) return std::nullopt;
    }
    if (edited.direction == Vec3<double>::Zero()) return std::nullopt;
  }
  const double limit = limit_of(method, edited);
  return Question{std::move(edited), unit_roundoff(method), limit};
}

std::optional<Question> question_of(const Case& problem, const QueryMethod& method) {
  if (!engine::unsupported_query(problem).empty() || has_spin(problem) || !in_domain(problem)) {
    return std::nullopt;
  }
  return requestioned(seen_by(method, question_for(problem, method.query, hash_of(problem))), method);
}

LawResult other_query() { return not_applicable("the law is about another query"); }
LawResult no_question() { return not_applicable("not a question that the method answers"); }

bool in_contact(const QueryAnswer& answer) {
  return answer.outcome == Outcome::initially_overlapping || answer.outcome == Outcome::hit;
}

Interval gap_of(const QueryAnswer& answer) {
  Interval gap{-kInfinity<double>, kInfinity<double>};
  if (answer.distance) gap.upper = answer.distance->upper;
  if (answer.outcome == Outcome::miss) gap.lower = answer.distance ? answer.distance->lower : 0;
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

bool same_line(const QueryAnswer& one, const QueryAnswer& other, double u) {
  if (one.outcome != other.outcome || one.outcome == Outcome::not_converged) return false;
  if (one.outcome != Outcome::hit) return true;
  return one.t_in && one.t_out && other.t_in && other.t_out && same_time(*one.t_in, *other.t_in, u) &&
         same_time(*one.t_out, *other.t_out, u);
}

std::string describe(const QueryAnswer& answer) {
  std::string out(label_of(answer.outcome));
  if (answer.distance) out += ", distance in " + text(answer.distance);
  if (answer.depth) out += ", depth in " + text(answer.depth);
  if (answer.t_in) out += ", t_in in " + text(answer.t_in) + ", t_out in " + text(answer.t_out);
  if (answer.normal) out += ", normal " + text(answer.normal);
  if (answer.normal_out) out += ", leaving " + text(answer.normal_out);
  if (answer.point_a) out += ", points " + text(answer.point_a) + " and " + text(answer.point_b);
  if (answer.stalled) out += ", stalled";
  return out;
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

std::optional<QueryJudgement> oracle_judgement(const QueryMethod& method, const Case& seen,
                                               const QueryAnswer& answer) {
  if (!is_for_oracle(seen)) return std::nullopt;
  const engine::Guarantee* row = engine::find_guarantee(engine::guarantees(), method);
  if (row == nullptr) return QueryJudgement{};
  const QueryLimits limits{.kappa = row->kappa(seen),
                           .unit_roundoff = unit_roundoff(method),
                           .contact_kappa = row->contact_kappa(seen)};
  return judge_query(truth_of_question(seen), method, answer, limits);
}

LawResult arbitrate(std::initializer_list<QueryAsked> asked, std::string_view disagreement) {
  std::string all(disagreement);
  for (const QueryAsked& one : asked) all += fmt::format("; {}: {}", one.name, describe(one.answer));
  LawResult result = holds({"arbitrated"});
  for (const QueryAsked& one : asked) {
    const std::optional<QueryJudgement> judgement = oracle_judgement(one.method, one.problem, one.answer);
    if (!judgement) {
      result.labels.push_back("undecided");
    } else if (judgement->faulty()) {
      return broken(fmt::format("{}; at fault is {}: {}", all, one.name, judgement->fault()));
    }
  }
  return result;
}

}  // namespace graze::law
