#include "properties/judge/linear_faults.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engines/guarantees.hpp"
#include "properties/edit/case.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;
using oracle::CaseTruth;

namespace {

// The latest time of contact. If the truth is open, it is the end of the path.
double latest_contact(const Case& problem) {
  const CaseTruth& truth = truth_of(problem);
  return is_undecided(truth) ? std::min(truth.toi_upper(), problem.t_max) : truth.toi_upper();
}

Limits limits_on(const Method& method, const Case& problem) {
  return limits_of(method, problem, truth_of(problem).scale().high);
}

// If a method's limit counts the time, contact that may be at any time leaves everything open.
bool is_open_for_ever(const Limits& limits, const Case& problem) {
  return limits.rounds_times && is_undecided(truth_of(problem)) &&
         !(latest_contact(problem) < kInfinity<double>);
}

}  // namespace

double bound_of(const Method& method, const Case& problem) {
  const Limits limits = limits_on(method, problem);
  return is_open_for_ever(limits, problem) ? kInfinity<double> : limits.wide_at(latest_contact(problem));
}

double proved_bound_of(const Method& method, const Case& problem) {
  return method.is_certified() ? 0 : bound_of(method, problem);
}

double contact_bound_of(const Method& method, const Case& problem) {
  const Limits limits = limits_on(method, problem);
  return is_open_for_ever(limits, problem) && method.is_certified()
             ? kInfinity<double>
             : limits.contact_at(latest_contact(problem));
}

namespace {

// nullptr if the oracle refuses the case.
const CaseTruth* find_truth(const Case& problem) {
  struct Entry {
    std::optional<Case> problem;
    std::optional<CaseTruth> truth;
  };
  thread_local std::array<Entry, 4> kept;
  thread_local std::size_t next = 0;
  const auto answer = [](const Entry& entry) { return entry.truth ? &*entry.truth : nullptr; };
  for (const Entry& entry : kept) {
    if (entry.problem && same_input(*entry.problem, problem)) return answer(entry);
  }
  Entry& entry = kept[next++ % kept.size()];
  entry.problem.reset();
  entry.truth.reset();
  // The oracle reports an undecided case by this exception, and nothing else.
  try {
    entry.truth.emplace(truth_within_reach(problem));
  } catch (const std::invalid_argument&) {
  }
  entry.problem = problem;
  return answer(entry);
}

}  // namespace

bool has_truth(const Case& problem) { return find_truth(problem) != nullptr; }

const CaseTruth& truth_of(const Case& problem) {
  const CaseTruth* truth = find_truth(problem);
  if (truth == nullptr) throw std::logic_error("no oracle takes this case: see has_truth");
  return *truth;
}

bool is_undecided(const CaseTruth& truth) { return truth.outcome() == Outcome::not_converged; }

bool is_linear_question(const Case& problem) {
  return engine::unsupported(engine::Kind::linear, problem).empty() && in_domain(problem);
}

bool is_question_for(const Method& method, const Case& seen) {
  return is_linear_question(seen) && (!method.is_exact() || engine::is_exact_question(seen));
}

namespace {

std::string text_of(const CaseTruth& truth) {
  return fmt::format("{}, toi in [{}, {}]", label_of(truth.outcome()), decimal(truth.toi_lower()),
                     decimal(truth.toi_upper()));
}

std::string over_scale(double error, const CaseTruth& truth) {
  return fmt::format("{} ({:.3g} of the scale)", error, error / truth.scale().low);
}

}  // namespace

std::string verdict_fault(const CaseTruth& truth, const Answer& answer, double bound) {
  if (answer.outcome == Outcome::invalid_input) return "a valid case was refused";
  if (is_undecided(truth)) return "";
  const bool contact = truth.outcome() != Outcome::miss;
  if (answer.outcome == Outcome::miss && contact && truth.depth().low > bound) {
    return fmt::format("miss claimed of a path of depth {}; true: {}", over_scale(truth.depth().low, truth),
                       text_of(truth));
  }
  if (claims_contact(answer) && !contact && truth.clearance().low > bound) {
    return fmt::format("{} claimed of a path of clearance {}", label_of(answer.outcome),
                       over_scale(truth.clearance().low, truth));
  }
  return "";
}

std::string late_fault(const CaseTruth& truth, const Answer& answer, double bound) {
  if (answer.outcome == Outcome::miss || !(answer.toi_lower > 0)) return "";  // a miss is judged as a verdict
  if (std::isinf(answer.toi_lower)) return "an infinite toi_lower without a miss";
  const double late = truth.lateness(answer.toi_lower).low;
  if (!(late > bound)) return "";
  return fmt::format("{} {} is late by a depth of {}; true: {}", lower_name(answer),
                     decimal(answer.toi_lower), over_scale(late, truth), text_of(truth));
}

std::string early_fault(const CaseTruth& truth, const Answer& answer, double bound) {
  if (answer.outcome == Outcome::miss || std::isinf(answer.toi_upper)) return "";  // nothing is claimed
  if (truth.compare(answer.toi_upper) >= 0) return "";
  const double early = truth.distance_at(answer.toi_upper).low;
  if (!(early > bound)) return "";
  return fmt::format("{} {} is early by a distance of {}; true: {}", upper_name(answer),
                     decimal(answer.toi_upper), over_scale(early, truth), text_of(truth));
}

std::string time_fault(const CaseTruth& truth, const Answer& answer, double bound) {
  if (!claims_contact(answer)) return "";
  if (is_beyond_range(answer.toi_lower, answer.toi_upper, kUnitRoundoff<float>) &&
      truth.compare(answer.toi_lower) <= 0) {
    return "";
  }
  for (const double t : {answer.toi_lower, answer.toi_upper}) {
    if (!(t >= 0) || std::isinf(t)) return "a contact at no time: " + describe(answer);
    const double error = truth.backward_error(t).low;
    if (error > bound) {
      return fmt::format("{} at {} has backward error {}; true: {}", label_of(answer.outcome), decimal(t),
                         over_scale(error, truth), text_of(truth));
    }
  }
  return "";
}

std::string normal_fault(const Case& problem, const Answer& answer, const Vec3<double>& n, double bound) {
  const CaseTruth& truth = truth_of(problem);
  // h(n) - n.(t v) over |n|, at the true time and at the claimed one. The latter may be negative, where t v
  // is outside of C, by no more than the answer's own backward error. The true time is known to a bracket,
  // and so is the error at the claim.
  const double at_truth = truth.normal_error(n).low;
  const double speed = velocity(problem).dot(n) / n.norm();
  const double from_lower = at_truth + (truth.toi_lower() - answer.toi_lower) * speed;
  const double from_upper = at_truth + (truth.toi_upper() - answer.toi_lower) * speed;
  const auto [least, most] = std::minmax(from_lower, from_upper);
  const double at_claim = std::max({least, -most, 0.0});
  if (at_truth <= bound || at_claim <= bound) return "";
  return fmt::format(
      "the normal {} misses the cone of supporting normals by {} at the true contact, by {} at its own",
      decimal(n), over_scale(at_truth, truth), at_claim);
}

std::string undecided_fault(const CaseTruth& truth, const Answer& answer, double bound) {
  if (answer.outcome != Outcome::not_converged || is_undecided(truth)) return "";
  const bool contact = truth.outcome() != Outcome::miss;
  const double margin = contact ? truth.depth().low : truth.clearance().low;
  if (!(margin > bound)) return "";
  return fmt::format("undecided, though the {} is {}; true: {}", contact ? "depth" : "clearance",
                     over_scale(margin, truth), text_of(truth));
}

std::string lower_fault(const CaseTruth& truth, const Answer& answer, double t_max, double bound) {
  if (answer.outcome == Outcome::miss || answer.outcome == Outcome::invalid_input) return "";
  if (!(answer.toi_lower < t_max)) return "";
  if (is_beyond_range(answer.toi_lower, answer.toi_upper, kUnitRoundoff<float>)) return "";
  const double away = truth.distance_at(answer.toi_lower).low;
  if (!(away > bound)) return "";
  return fmt::format("toi_lower is {}, where the bodies are {} from contact; true: {}", answer.toi_lower,
                     over_scale(away, truth), text_of(truth));
}

std::string open_answer_fault(const CaseTruth& truth, const Method& method, const Case& problem,
                              const Answer& answer, double bound) {
  if (answer.outcome != Outcome::not_converged || !(answer.toi_lower < problem.t_max)) return "";
  const double u = method.unit_roundoff;
  if (!(answer.distance <= bound * (1 + 8 * u))) return fmt::format("open, and {} apart", answer.distance);
  if (!(std::abs(answer.normal.norm() - 1) <= 8 * u)) return "open, and the normal is not a unit vector";
  for (const char body : {'a', 'b'}) {
    const Vec3<double>& point = body == 'a' ? answer.point_a : answer.point_b;
    const Body<double>& of = body == 'a' ? problem.a : problem.b;
    if (!point.allFinite()) return fmt::format("open, and the witness of {} is not finite", body);
    const double size = std::max({point.cwiseAbs().maxCoeff(), of.position.cwiseAbs().maxCoeff(),
                                  answer.toi_lower * of.displacement.cwiseAbs().maxCoeff()});
    const double away = truth.distance_from_body(body, answer.toi_lower, point).low;
    if (!(away <= bound + 8 * u * size))
      return fmt::format("open, and the witness of {} lies {} away from it", body, over_scale(away, truth));
  }
  return "";
}

std::string any_fault(const CaseTruth& truth, const Answer& answer, double bound) {
  for (const auto fault : {&verdict_fault, &late_fault, &early_fault, &time_fault}) {
    if (std::string reason = fault(truth, answer, bound); !reason.empty()) return reason;
  }
  return "";
}

std::string any_fault(const Method& method, const Case& problem, const Answer& answer) {
  const CaseTruth& truth = truth_of(problem);
  const double bound = bound_of(method, problem);
  std::string reason = any_fault(truth, answer, bound);
  if (!reason.empty() || !method.is_certified()) return reason;
  for (const auto fault : {&verdict_fault, &late_fault, &early_fault}) {
    if (reason = fault(truth, answer, proved_bound_of(method, problem)); !reason.empty()) return reason;
  }
  return undecided_fault(truth, answer, bound);
}

LawResult holds(std::vector<std::string_view> labels) { return {Holding::holds, "", std::move(labels)}; }
LawResult broken(std::string reason) { return {Holding::broken, std::move(reason), {}}; }
LawResult not_applicable(std::string why) { return {Holding::not_applicable, std::move(why), {}}; }

std::optional<LawResult> without_truth(const Case& problem) {
  const CaseTruth* truth = find_truth(problem);
  if (truth == nullptr) return not_applicable("no oracle takes the case");
  if (!is_undecided(*truth)) return {};
  return LawResult{Holding::not_applicable, "undecided by the bracket oracle", {"undecided"}};
}

std::optional<LawResult> without_exact_truth(const Case& problem) {
  if (!is_exactly_decided(problem)) return not_applicable("not decided by the exact oracle");
  return without_truth(problem);
}

bool agree(const Answer& one, const Answer& other, double u) {
  if (one.outcome != other.outcome) return false;
  if (one.outcome == Outcome::not_converged) return false;
  if (one.outcome != Outcome::hit) return true;
  const double gap = std::max(one.toi_lower - other.toi_upper, other.toi_lower - one.toi_upper);
  return gap <= 16 * u * std::max(one.toi_upper, other.toi_upper);
}

LawResult arbitrate(const Method& method, std::initializer_list<Asked> asked, std::string_view disagreement) {
  std::string all(disagreement);
  for (const Asked& one : asked) all += fmt::format("; {}: {}", one.name, describe(one.answer));
  LawResult result = holds({"arbitrated"});
  for (const Asked& one : asked) {
    if (const auto open = without_truth(one.problem)) return *open;
  }
  for (const Asked& one : asked) {
    const std::string fault = any_fault(method, one.problem, one.answer);
    if (!fault.empty()) return broken(fmt::format("{}; at fault is {}: {}", all, one.name, fault));
    if (one.answer.outcome == Outcome::not_converged) result.labels.push_back("not_converged");
  }
  return result;
}

}  // namespace graze::law
