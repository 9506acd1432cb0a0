#include "properties/judge/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "corpus/support_value.hpp"
#include "engines/guarantees.hpp"

namespace graze::law {

std::size_t Judgement::worst_fault() const {
  std::size_t k = 0;
  while (k < kFaults && (this->*kFaultKinds[k].why).empty()) ++k;
  return k;
}

const std::string& Judgement::fault() const {
  static const std::string kNone;
  const std::size_t worst = worst_fault();
  return worst < kFaults ? this->*kFaultKinds[worst].why : kNone;
}

std::string Judgement::told_fault() const {
  std::string others;
  for (std::size_t k = worst_fault() + 1; k < kFaults; ++k) {
    if (!(this->*kFaultKinds[k].why).empty())
      others += fmt::format("{}{}", others.empty() ? "" : ", ", kFaultKinds[k].name);
  }
  return others.empty() ? fault() : fmt::format("{} (also {})", fault(), others);
}

namespace {

// Farther from its own origin than 2^16 times its size. Rounding to float changes such a shape so much that its work
// gives no information about the case.
bool lies_far_out_in_its_frame(const Shape<double>& shape) {
  const corpus::Bounds box = corpus::bounds(shape);
  return (box.high + box.low).norm() / 2 > 0x1p16 * (box.high - box.low).norm();
}

}  // namespace

std::optional<double> most_supports(const engine::Method& method, const corpus::Case& problem) {
  if (method.guarantee == nullptr || !method.guarantee->most_supports) return {};
  const double most = *method.guarantee->most_supports;
  if (method.kind != engine::Kind::rotating) return most;
  const double angle =
      problem.t_max * std::max(problem.spin_a.rotation.norm(), problem.spin_b.rotation.norm());
  const double quarters = std::ceil(angle / (std::numbers::pi / 2)) - 1;
  const bool follows = problem.start_policy == StartPolicy::pass_over;
  return most * ((follows ? kFollowing : 1) + std::max(quarters, 0.0) / 2);
}

void judge_work(Judgement& judgement, const engine::Method& method, const corpus::Case& problem,
                const Counters& counters) {
  judgement.supports = counters.supports;
  const std::optional<double> most = most_supports(method, problem);
  if (judgement.skipped || !most || counters.supports <= *most) return;
  if (lies_far_out_in_its_frame(problem.a.shape) || lies_far_out_in_its_frame(problem.b.shape)) return;
  judgement.work = fmt::format("{} support evaluations; the guarantee is {:.0f}", counters.supports, *most);
}

double over(double length, double scale) {
  if (length == 0 || std::isnan(length)) return length;
  return scale > 0 ? length / scale : kInfinity<double>;
}

std::string senseless(const engine::Answer& answer, double t_max) {
  const double lower = answer.toi_lower, upper = answer.toi_upper;
  switch (answer.outcome) {
    case Outcome::initially_overlapping:
      if (!(lower == 0 && upper == 0)) return "a start in contact has a time other than 0";
      return {};
    case Outcome::miss:
      if (!(lower == kInfinity<double> && upper == kInfinity<double>)) return "a miss has a finite time";
      return {};
    case Outcome::hit:
      if (!(0 <= lower && lower <= upper && upper < kInfinity<double> && lower <= t_max)) {
        return "a hit has a bracket that is no interval of times up to t_max";
      }
      if (upper == 0) return "a hit at time 0; a contact at the start is initially_overlapping";
      return {};
    case Outcome::not_converged:
      if (!(0 <= lower && lower <= upper && lower < kInfinity<double>)) {
        return "the bracket of not_converged is no interval";
      }
      return {};
    case Outcome::invalid_input:
      return {};
  }
  return "an outcome that does not exist";
}

bool claims_contact(const engine::Answer& answer) {
  return answer.outcome == Outcome::hit || answer.outcome == Outcome::initially_overlapping;
}

bool is_beyond_range(double lower, double upper, double unit_roundoff) {
  const double largest = unit_roundoff == kUnitRoundoff<float> ? double(std::numeric_limits<float>::max())
                                                               : std::numeric_limits<double>::max();
  return lower == largest && upper == kInfinity<double>;
}

std::string_view label_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::initially_overlapping:
      return "initially_overlapping";
    case Outcome::hit:
      return "hit";
    case Outcome::miss:
      return "miss";
    case Outcome::not_converged:
      return "not_converged";
    case Outcome::invalid_input:
      return "invalid_input";
  }
  return "no outcome";
}

std::string decimal(double x) { return fmt::format("{}", x); }
std::string decimal(const Vec3<double>& x) {
  return fmt::format("[{}, {}, {}]", decimal(x[0]), decimal(x[1]), decimal(x[2]));
}

namespace {

std::string bracket_text(const engine::Interval& bracket) {
  return fmt::format("[{}, {}]", decimal(bracket.lower), decimal(bracket.upper));
}

std::string plan_text(const Plan& plan) {
  std::string reasons;
  for (int k = 0; k < kPlanReasons; ++k) {
    const auto reason = static_cast<PlanReason>(k);
    if (plan.has(reason)) reasons += fmt::format("{}{}", reasons.empty() ? "" : ", ", to_text(reason));
  }
  return reasons.empty() ? "" : fmt::format(", simulated: {} ({})", to_text(plan.effects), reasons);
}

}  // namespace

std::string describe(const engine::Answer& answer) {
  std::string out(label_of(answer.outcome));
  if (answer.toi_lower != 0 || answer.toi_upper != 0)
    out += ", toi in " + bracket_text({answer.toi_lower, answer.toi_upper});
  if (answer.separation) out += ", distance in " + bracket_text(*answer.separation);
  if (answer.depth) out += ", depth in " + bracket_text(*answer.depth);
  if (answer.t_in) out += ", t_in in " + bracket_text(*answer.t_in);
  if (answer.t_out) out += ", t_out in " + bracket_text(*answer.t_out);
  if (answer.has_normal()) out += ", normal " + decimal(answer.normal);
  if (!answer.normal_out.isZero(0)) out += ", leaving " + decimal(answer.normal_out);
  if (answer.has_points || !answer.point_a.isZero(0) || !answer.point_b.isZero(0))
    out += ", points " + decimal(answer.point_a) + " and " + decimal(answer.point_b);
  if (answer.stalled) out += ", stalled";
  out += plan_text(answer.plan);
  out += fmt::format(", {} iterations, {} supports", answer.counters.iterations, answer.counters.supports);
  if (answer.counters.poses > 0) out += fmt::format(", {} poses", answer.counters.poses);
  return out;
}

}  // namespace graze::law
