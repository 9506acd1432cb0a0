#include "properties/judge_rotating.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "corpus/support_value.hpp"
#include "properties/case_edit.hpp"
#include "properties/judge.hpp"

namespace graze::law {

using corpus::Case;
using engine::RotatingAnswer;
using engine::RotatingEngineMethod;
using engine::Unseen;
using oracle::RotatingTruth;

double scale_of(const Case& problem) {
  const corpus::Bounds a = corpus::bounds(problem.a.shape, problem.a.orientation),
                       b = corpus::bounds(problem.b.shape, problem.b.orientation);
  const Vec3<double> apart =
      (problem.b.position - problem.a.position) + (b.low + b.high) / 2 - (a.low + a.high) / 2;
  return std::max({(a.high - a.low).norm(), (b.high - b.low).norm(), apart.norm()});
}

double top_speed_of(const Case& problem) {
  const auto fastest = [](const Body<double>& body, const corpus::Spin& spin) {
    const corpus::Bounds box = corpus::bounds(body.shape);
    const double arm = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm() + spin.pivot.norm();
    return body.displacement.norm() + spin.rotation.norm() * arm;
  };
  return fastest(problem.a, problem.spin_a) + fastest(problem.b, problem.spin_b);
}

RotatingRow row_of(const RotatingEngineMethod& method, const Case& seen, double tolerance, double slack) {
  const engine::Guarantee* row = engine::find_guarantee(engine::guarantees(), method);
  RotatingRow out;
  out.unit_roundoff = method.unit_roundoff;
  out.speed = top_speed_of(seen);
  if (row == nullptr) {
    // It promises nothing.
    out.limit = out.wide = kInfinity<double>;
    return out;
  }
  const double scale = scale_of(seen);
  out.limit = row->kappa(seen) * method.unit_roundoff * scale + slack;
  out.wide = std::max(out.limit, std::max(row->width.value_or(0), tolerance) * scale + slack);
  out.may_miss = row->may_miss;
  out.may_be_late = row->may_be_late;
  return out;
}

bool is_rotating_question(const Case& seen) {
  if (!engine::unsupported_rotating(seen).empty() || !in_domain(seen)) return false;
  if (!std::isfinite(seen.t_max) || seen.start_policy != StartPolicy::report) return false;
  const double most = std::max(seen.spin_a.rotation.norm(), seen.spin_b.rotation.norm());
  return most * seen.t_max <= 0x1p30;
}

bool follows_plan(const RotatingEngineMethod& method) {
  return method.name == "plan" || method.is_certified();
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
  // The oracle says what it does not decide by this exception, and nothing else.
  try {
    entry.truth.emplace(seen, RotatingTruth::kDefaultWidth, kTruthBudget);
  } catch (const std::invalid_argument&) {
  }
  entry.problem = seen;
  return answer(entry);
}

bool claims_contact(const RotatingAnswer& answer) {
  return answer.outcome == Outcome::hit || answer.outcome == Outcome::initially_overlapping;
}

std::string describe(const RotatingAnswer& answer) {
  std::string reasons;
  for (int k = 0; k < kPlanReasons; ++k) {
    const auto reason = static_cast<PlanReason>(k);
    if (answer.plan.has(reason)) reasons += fmt::format("{}{}", reasons.empty() ? "" : ", ", to_text(reason));
  }
  return fmt::format("{}, toi in [{}, {}], simulated: {} ({}), {} poses, {} supports",
                     label_of(answer.outcome), hex(answer.toi_lower), hex(answer.toi_upper),
                     to_text(answer.plan.effects), reasons, answer.counters.poses, answer.counters.supports);
}

namespace {

std::string over(double length, const RotatingTruth& truth) {
  return fmt::format("{} ({:.3g} of the scale)", length, length / truth.scale().low);
}
std::string describe(const RotatingTruth& truth) {
  return fmt::format("{}, toi in [{}, {}]", label_of(truth.outcome()), hex(truth.toi_lower()),
                     hex(truth.toi_upper()));
}

double allowed(Unseen unseen, const RotatingAnswer& answer, const RotatingRow& row) {
  switch (unseen) {
    case Unseen::anything:
      return kInfinity<double>;
    case Unseen::hidden_motion:
      return row.limit + answer.hidden_motion;
    case Unseen::nothing:
      break;
  }
  return row.limit;
}

}  // namespace

std::string verdict_fault(const RotatingTruth& truth, const RotatingAnswer& answer, const RotatingRow& row) {
  if (answer.outcome == Outcome::invalid_input) return "a valid case was refused";
  if (answer.outcome == Outcome::miss && truth.contact_proved()) {
    // Without a limit any contact counts.
    const double depth = truth.depth().low, most = allowed(row.may_miss, answer, row);
    if (depth > most || (most == 0 && truth.outcome() == Outcome::hit)) {
      return fmt::format("miss claimed of a contact of depth {}; true: {}", over(depth, truth),
                         describe(truth));
    }
  }
  if (claims_contact(answer) && truth.outcome() == Outcome::miss) {
    const double clearance = truth.clearance().low;
    if (clearance > row.wide || row.limit == 0) {
      return fmt::format("{} claimed of a clearance of {}", label_of(answer.outcome), over(clearance, truth));
    }
  }
  return "";
}

std::string late_fault(const RotatingTruth& truth, const RotatingAnswer& answer, const RotatingRow& row) {
  // A miss is judged as a verdict.
  if (answer.outcome == Outcome::miss || !(answer.toi_lower > 0)) return "";
  if (std::isinf(answer.toi_lower)) return "an infinite toi_lower without a miss";
  if (truth.outcome() == Outcome::miss || truth.compare(answer.toi_lower) <= 0) return "";
  const double most = allowed(row.may_be_late, answer, row);
  const double late = most > 0 ? truth.depth_before(answer.toi_lower).low : 0;
  if (most > 0 && !(late > most)) return "";
  return fmt::format("toi_lower {} is late by a depth of {}; true: {}", hex(answer.toi_lower),
                     over(late, truth), describe(truth));
}

std::string early_fault(const RotatingTruth& truth, const RotatingAnswer& answer, const RotatingRow& row) {
  if (answer.outcome == Outcome::miss || std::isinf(answer.toi_upper)) return "";
  if (truth.compare(answer.toi_upper) >= 0) return "";
  const double early = row.limit > 0 ? truth.distance_at(answer.toi_upper).low : 0;
  if (row.limit > 0 && !(early > row.wide)) return "";
  return fmt::format("toi_upper {} claims contact before there is any, by a distance of {}; true: {}",
                     hex(answer.toi_upper), over(early, truth), describe(truth));
}

std::string width_fault(const RotatingTruth& truth, const RotatingAnswer& answer, const RotatingRow& row) {
  if (!claims_contact(answer)) return "";
  const double before = truth.distance_at(answer.toi_lower).low;
  if (before > row.wide + row.rounding_at(answer.toi_lower)) {
    return fmt::format("at toi_lower {} the bodies are {} apart; true: {}", hex(answer.toi_lower),
                       over(before, truth), describe(truth));
  }
  if (truth.compare(answer.toi_upper) < 0) return "";
  const double depth = truth.depth_before(answer.toi_upper).low;
  if (depth > std::max(row.wide, allowed(row.may_be_late, answer, row)) + row.rounding_at(answer.toi_upper)) {
    return fmt::format("by toi_upper {} the bodies have met {} deep; true: {}", hex(answer.toi_upper),
                       over(depth, truth), describe(truth));
  }
  return "";
}

std::string any_fault(const RotatingTruth& truth, const RotatingAnswer& answer, const RotatingRow& row) {
  for (const auto fault : {&verdict_fault, &late_fault, &early_fault, &width_fault}) {
    if (std::string reason = fault(truth, answer, row); !reason.empty()) return reason;
  }
  return "";
}

Times times_of(const RotatingAnswer& answer) { return {answer.toi_lower, answer.toi_upper}; }

bool overlap(const Times& one, const Times& other) {
  return std::max(one.lower, other.lower) <= std::min(one.upper, other.upper);
}

bool same_times(const RotatingAnswer& one, const RotatingAnswer& other) {
  const auto same = [](double l, double r) { return l == r || (std::isnan(l) && std::isnan(r)); };
  return one.outcome == other.outcome && same(one.toi_lower, other.toi_lower) &&
         same(one.toi_upper, other.toi_upper);
}

LawResult compare(const RotatingEngineMethod& method, const RotatingAsked& one, const RotatingAsked& other,
                  std::string_view disagreement) {
  LawResult result = holds({label_of(one.answer.outcome)});
  if (overlap(times_of(one.answer), times_of(other.answer))) return result;
  if (row_of(method, one.problem).may_be_late == Unseen::anything) {
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
    const std::string fault =
        any_fault(*truth, asked->answer, row_of(method, asked->problem, asked->tolerance, asked->slack));
    if (!fault.empty()) return broken(fmt::format("{}; at fault is {}: {}", all, asked->name, fault));
  }
  return result;
}

}  // namespace graze::law
