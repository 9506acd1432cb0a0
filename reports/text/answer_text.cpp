#include "reports/text/answer_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <graze/invalid_text.hpp>

#include "corpus/format/json_value.hpp"
#include "corpus/format/names.hpp"
#include "reports/text/counted.hpp"

namespace graze::tool {
namespace {

// The shortest decimal that reads back to the same bits, or null for numbers that JSON cannot express. An
// integer keeps a decimal point, for readers that would take -0 for an integer and lose its sign.
std::string json_number(double x) {
  if (!std::isfinite(x)) return "null";
  std::string text = fmt::format("{}", x);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

// A time, which may be infinite of either sign.
std::string json_time(double t) { return std::isinf(t) ? corpus::json_number(t) : json_number(t); }

std::string json_vector(const Vec3<double>& v) {
  return fmt::format("[{}, {}, {}]", json_number(v.x()), json_number(v.y()), json_number(v.z()));
}

std::string vector_text(const Vec3<double>& v) { return fmt::format("({}, {}, {})", v.x(), v.y(), v.z()); }

bool has_times(const engine::Answer& answer) {
  return answer.outcome != Outcome::miss && answer.outcome != Outcome::invalid_input;
}

// The reason why a case was not answered, or a start in contact not reported. Empty if the outcome says all.
std::string reason_of(const engine::Answer& answer) {
  if (answer.outcome == Outcome::invalid_input) return invalid_text(answer);
  if (answer.passed_over && answer.plan.effects == Effects::rotating && answer.plan.reasons != 0)
    return "the contact at the start gets no deeper, and no other is made";
  if (answer.passed_over) return "the motion leaves or slides from its start in contact";
  return {};
}

std::string json_text(const std::string& text) { return text.empty() ? "null" : corpus::json_quote(text); }

// The method that answered, in JSON without braces.
std::string method_fields(const engine::Method& method) {
  return fmt::format(R"("method": "{}", "scalar": "{}", "tier": "{}")", method.name, method.scalar,
                     method.tier);
}
std::string work_fields(const Counters& counters) {
  return fmt::format(R"("iterations": {}, "supports": {})", counters.iterations, counters.supports);
}

std::string work_text(const Counters& counters) {
  return fmt::format("{}, {}", counted(counters.iterations, "iteration"),
                     counted(counters.supports, "support evaluation"));
}

// An open answer that has a place. A caller may treat the bodies as in contact there.
bool is_open_contact(const engine::Answer& answer) {
  return answer.outcome == Outcome::not_converged && answer.has_normal();
}
bool has_contact(const engine::Answer& answer) {
  return answer.outcome == Outcome::hit || is_open_contact(answer);
}

// The fields that answers of linear and rotating casts share, in JSON without braces.
std::string cast_fields(const corpus::Case& problem, const engine::Answer& answer) {
  const bool contact = has_contact(answer);
  const std::string toi = has_times(answer)
                              ? fmt::format(R"({{"lower": {}, "upper": {}}})", json_number(answer.toi_lower),
                                            json_number(answer.toi_upper))
                              : "null";
  std::string text = fmt::format(
      R"("id": {}, "outcome": "{}", "because": {}, "toi": {}, "normal": {}, "point_a": {}, "point_b": {})",
      corpus::json_quote(problem.id), corpus::name_of(answer.outcome), json_text(reason_of(answer)), toi,
      contact ? json_vector(answer.normal) : "null", contact ? json_vector(answer.point_a) : "null",
      contact ? json_vector(answer.point_b) : "null");
  if (is_open_contact(answer))
    text += fmt::format(R"(, "distance": {{"lower": 0.0, "upper": {}}})", json_number(answer.distance));
  return text;
}

std::string line(const char* name, const std::string& value) {
  return fmt::format("  {:<9} {}\n", name, value);
}

// The same as lines of text.
std::string cast_lines(const engine::Answer& answer) {
  std::string text = line("outcome", std::string(corpus::name_of(answer.outcome)));
  if (const std::string why = reason_of(answer); !why.empty()) text += line("because", why);
  if (has_times(answer)) text += line("toi", fmt::format("[{}, {}]", answer.toi_lower, answer.toi_upper));
  if (is_open_contact(answer)) text += line("distance", fmt::format("[0, {}]", answer.distance));
  if (has_contact(answer)) {
    text += line("normal", vector_text(answer.normal));
    text += line("point_a", vector_text(answer.point_a));
    text += line("point_b", vector_text(answer.point_b));
  }
  return text;
}

std::string method_line(const engine::Method& method) {
  return line("method", fmt::format("{}, {}, tier {}", method.name, method.scalar, method.tier));
}

}  // namespace

std::string invalid_text(const engine::Answer& answer) {
  if (answer.invalid_at.why != Invalid::none) return to_text(answer.invalid_at);
  if (answer.invalid == Invalid::none) return "a kind of case that this method does not answer";
  return std::string(to_text(answer.invalid));
}

namespace {

std::string linear_block(const corpus::Case& problem, const engine::Method& method,
                         const engine::Answer& answer) {
  return fmt::format("{}\n", problem.id) + method_line(method) + cast_lines(answer) +
         line("work", work_text(answer.counters));
}

std::string linear_json(const corpus::Case& problem, const engine::Method& method,
                        const engine::Answer& answer) {
  return fmt::format("{{{}, {}, {}}}", cast_fields(problem, answer), method_fields(method),
                     work_fields(answer.counters));
}

struct NamedInterval {
  const char* name;
  const std::optional<engine::Interval>& value;
};
std::array<NamedInterval, 4> intervals(const engine::Answer& answer) {
  return {NamedInterval{"distance", answer.separation},
          {"depth", answer.depth},
          {"t_in", answer.t_in},
          {"t_out", answer.t_out}};
}
struct NamedVector {
  const char* name;
  const Vec3<double>& value;
  bool given;
};
std::array<NamedVector, 4> vectors(const engine::Answer& answer) {
  return {NamedVector{"normal", answer.normal, answer.has_normal()},
          {"normal_out", answer.normal_out, !answer.normal_out.isZero(0)},
          {"point_a", answer.point_a, answer.has_points},
          {"point_b", answer.point_b, answer.has_points}};
}

std::string query_block(const corpus::Case& problem, const engine::Method& method,
                        const engine::Answer& answer) {
  std::string text = fmt::format("{}\n", problem.id);
  text += line("query", std::string(corpus::name_of(problem.query)));
  text += method_line(method);
  text += line("outcome", std::string(corpus::name_of(answer.outcome)));
  if (const std::string why = reason_of(answer); !why.empty()) text += line("because", why);
  for (const auto& [name, value] : intervals(answer)) {
    if (value) text += line(name, fmt::format("[{}, {}]", value->lower, value->upper));
  }
  if (answer.stalled) text += line("stalled", "the bracket is wider than rounding alone would make it");
  for (const auto& [name, value, given] : vectors(answer)) {
    if (given) text += line(name, vector_text(value));
  }
  return text + line("work", work_text(answer.counters));
}

std::string query_json(const corpus::Case& problem, const engine::Method& method,
                       const engine::Answer& answer) {
  std::string text = fmt::format(R"({{"id": {}, "query": "{}", "outcome": "{}", "because": {})",
                                 corpus::json_quote(problem.id), corpus::name_of(problem.query),
                                 corpus::name_of(answer.outcome), json_text(reason_of(answer)));
  for (const auto& [name, value] : intervals(answer)) {
    if (!value) continue;
    text += fmt::format(R"(, "{}": {{"lower": {}, "upper": {}}})", name, json_time(value->lower),
                        json_time(value->upper));
  }
  text += fmt::format(R"(, "stalled": {})", answer.stalled);
  for (const auto& [name, value, given] : vectors(answer)) {
    text += fmt::format(R"(, "{}": {})", name, given ? json_vector(value) : "null");
  }
  return text + fmt::format(", {}, {}}}", method_fields(method), work_fields(answer.counters));
}

std::vector<std::string_view> reasons_of(const Plan& plan) {
  std::vector<std::string_view> reasons;
  for (int k = 0; k < kPlanReasons; ++k) {
    const auto reason = static_cast<PlanReason>(k);
    if (plan.has(reason)) reasons.push_back(to_text(reason));
  }
  return reasons;
}

// Text of a plan, such as "linear: A's rotation cannot be seen; ...".
std::string plan_text(const Plan& plan) {
  const std::vector<std::string_view> reasons = reasons_of(plan);
  std::string text(to_text(plan.effects));
  if (!reasons.empty()) text += fmt::format(": {}", fmt::join(reasons, "; "));
  return text;
}

// The fields, without braces.
std::string plan_fields(const Plan& plan) {
  std::vector<std::string> reasons;
  for (const std::string_view reason : reasons_of(plan)) reasons.push_back(corpus::json_quote(reason));
  return fmt::format(R"("plan": "{}", "reasons": [{}])", to_text(plan.effects), fmt::join(reasons, ", "));
}

std::string rotating_block(const corpus::Case& problem, const engine::Method& method,
                           const engine::Answer& answer) {
  std::string text = fmt::format("{}\n", problem.id) + method_line(method);
  if (answer.outcome != Outcome::invalid_input) text += line("plan", plan_text(answer.plan));
  text += cast_lines(answer);
  if (answer.hidden_motion > 0) {
    text += line("hidden", fmt::format("contacts by motions below {} may be missed", answer.hidden_motion));
  }
  return text + line("work", fmt::format("{}, {}", work_text(answer.counters),
                                         counted(answer.counters.poses, "pose")));
}

std::string rotating_json(const corpus::Case& problem, const engine::Method& method,
                          const engine::Answer& answer) {
  return fmt::format(R"({{{}, {}, "hidden_motion": {}, {}, {}, "poses": {}}})", cast_fields(problem, answer),
                     plan_fields(answer.plan), json_number(answer.hidden_motion), method_fields(method),
                     work_fields(answer.counters), answer.counters.poses);
}

// The answer of a third-party engine in full, and its failure if there was one.
std::string strangers_block(const corpus::Case& problem, const engine::Method& method,
                            const engine::Answer& answer) {
  std::string text = fmt::format("{}\n", problem.id);
  if (method.kind == engine::Kind::query) text += line("query", std::string(corpus::name_of(problem.query)));
  text += method_line(method);
  if (answer.failure != engine::Failure::none)
    return text + line("failed", fmt::format("{}: {}", to_text(answer.failure), answer.message));
  text += line("outcome", std::string(corpus::name_of(answer.outcome)));
  if (!answer.message.empty()) text += line("says", answer.message);
  if (method.kind != engine::Kind::query && has_times(answer))
    text += line("toi", fmt::format("[{}, {}]", answer.toi_lower, answer.toi_upper));
  for (const auto& [name, value] : intervals(answer)) {
    if (value) text += line(name, fmt::format("[{}, {}]", value->lower, value->upper));
  }
  if (answer.has_normal()) text += line("normal", vector_text(answer.normal));
  if (method.holds.witnesses && answer.outcome == Outcome::hit) {
    text += line("point_a", vector_text(answer.point_a));
    text += line("point_b", vector_text(answer.point_b));
  }
  if (answer.ns)
    text += line("time", fmt::format("{} ns a call{}", *answer.ns, answer.native ? "" : ", WASM"));
  return text;
}

std::string strangers_json(const corpus::Case& problem, const engine::Method& method,
                           const engine::Answer& answer) {
  const bool failed = answer.failure != engine::Failure::none;
  std::string text = fmt::format(
      R"({{"id": {}, "query": "{}", {}, "failure": {}, "outcome": {}, "because": {}, "toi": {})",
      corpus::json_quote(problem.id), corpus::name_of(problem.query), method_fields(method),
      failed ? corpus::json_quote(std::string(to_text(answer.failure))) : "null",
      failed ? "null" : fmt::format("\"{}\"", corpus::name_of(answer.outcome)), json_text(answer.message),
      !failed && method.kind != engine::Kind::query && has_times(answer)
          ? fmt::format(R"({{"lower": {}, "upper": {}}})", json_number(answer.toi_lower),
                        json_number(answer.toi_upper))
          : "null");
  for (const auto& [name, value] : intervals(answer)) {
    if (value)
      text += fmt::format(R"(, "{}": {{"lower": {}, "upper": {}}})", name, json_number(value->lower),
                          json_number(value->upper));
  }
  const bool has_points = !failed && method.holds.witnesses && answer.outcome == Outcome::hit;
  return text + fmt::format(R"(, "normal": {}, "point_a": {}, "point_b": {}, "ns": {}}})",
                            answer.has_normal() ? json_vector(answer.normal) : "null",
                            has_points ? json_vector(answer.point_a) : "null",
                            has_points ? json_vector(answer.point_b) : "null",
                            answer.ns ? json_number(*answer.ns) : "null");
}

}  // namespace

std::string answer_block(const corpus::Case& problem, const engine::Method& method,
                         const engine::Answer& answer) {
  if (!method.is_ours()) return strangers_block(problem, method, answer);
  switch (method.kind) {
    case engine::Kind::linear:
      return linear_block(problem, method, answer);
    case engine::Kind::query:
      return query_block(problem, method, answer);
    case engine::Kind::rotating:
      break;
  }
  return rotating_block(problem, method, answer);
}

std::string answer_json(const corpus::Case& problem, const engine::Method& method,
                        const engine::Answer& answer) {
  if (!method.is_ours()) return strangers_json(problem, method, answer);
  switch (method.kind) {
    case engine::Kind::linear:
      return linear_json(problem, method, answer);
    case engine::Kind::query:
      return query_json(problem, method, answer);
    case engine::Kind::rotating:
      break;
  }
  return rotating_json(problem, method, answer);
}

std::string plan_block(const corpus::Case& problem, const Plan& plan) {
  std::string text = fmt::format("{}\n", problem.id) + line("plan", std::string(to_text(plan.effects)));
  for (const std::string_view reason : reasons_of(plan)) text += line("because", std::string(reason));
  return text;
}

std::string plan_json(const corpus::Case& problem, const Plan& plan) {
  return fmt::format(R"({{"id": {}, {}}})", corpus::json_quote(problem.id), plan_fields(plan));
}

}  // namespace graze::tool
