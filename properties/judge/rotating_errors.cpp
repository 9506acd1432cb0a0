#include "properties/judge/rotating_errors.hpp"

#include <fmt/format.h>

#include <cmath>

#include "corpus/format/names.hpp"
#include "corpus/support_value.hpp"
#include "properties/judge/own_frames.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;
using engine::Unseen;
using oracle::Enclosure;
using oracle::RotatingTruth;

namespace {

std::string text_of(double length, const Limits& limits) {
  if (length == 0) return "0 of scale";
  return fmt::format("{:.1e} of scale", limits.scale > 0 ? length / limits.scale : kInfinity<double>);
}

// How deep a contact may be that goes unseen.
double allowed(Unseen unseen, const Answer& answer, const Limits& limits) {
  switch (unseen) {
    case Unseen::anything:
      return kInfinity<double>;
    case Unseen::hidden_motion:
      return limits.limit + answer.hidden_motion;
    case Unseen::nothing:
      break;
  }
  return limits.limit;
}

}  // namespace

RotatingError verdict_error(const RotatingTruth& truth, const Answer& answer, const Limits& limits) {
  if (answer.outcome == Outcome::invalid_input) return {.fault = "refuses a valid case"};
  RotatingError out;
  if (answer.outcome == Outcome::miss && truth.contact_proved()) {
    out.length = truth.depth().low;
    // If a contact at t = 0 is left open beside one nearby, only the depth is known.
    if (out.length > allowed(limits.may_miss, answer, limits) ||
        (limits.strict && truth.outcome() != Outcome::not_converged)) {
      out.fault = fmt::format("says miss; there is contact, {} deep, at {} for the first time",
                              text_of(out.length, limits), truth.toi_upper());
    }
  }
  if (claims_contact(answer) && truth.outcome() == Outcome::miss) {
    out.length = truth.clearance().low;
    if (limits.strict || out.length > limits.wide) {
      out.fault = fmt::format("says {}; the bodies stay {} apart", corpus::name_of(answer.outcome),
                              text_of(out.length, limits));
    }
  }
  return out;
}

RotatingError late_error(const RotatingTruth& truth, const Answer& answer, const Limits& limits) {
  // A miss is judged as a verdict.
  if (answer.outcome == Outcome::miss || !(answer.toi_lower > 0)) return {};
  if (std::isinf(answer.toi_lower)) return {.fault = "an infinite toi_lower without a miss"};
  if (truth.outcome() == Outcome::miss || truth.compare(answer.toi_lower) <= 0) return {};
  RotatingError out{.length = truth.depth_before(answer.toi_lower).low};
  if (limits.strict || out.length > allowed(limits.may_be_late, answer, limits)) {
    out.fault = fmt::format("{} {} is past the contact at {}, {} deep", lower_name(answer), answer.toi_lower,
                            truth.toi_upper(), text_of(out.length, limits));
  }
  return out;
}

RotatingError early_error(const RotatingTruth& truth, const Answer& answer, const Limits& limits) {
  if (answer.outcome == Outcome::miss || !(answer.toi_upper < kInfinity<double>)) return {};
  if (truth.compare(answer.toi_upper) >= 0) return {};
  RotatingError out{.length = truth.distance_at(answer.toi_upper).low};
  if (limits.strict || out.length > limits.wide) {
    out.fault = fmt::format("claims contact by {}, where the bodies are {} apart", answer.toi_upper,
                            text_of(out.length, limits));
  }
  return out;
}

RotatingError width_error(const RotatingTruth& truth, const Answer& answer, const Limits& limits) {
  if (!claims_contact(answer)) return {};
  const double before = truth.distance_at(answer.toi_lower).low;
  // A bracket that ends before the first contact has no depth.
  const double depth = truth.compare(answer.toi_upper) >= 0 ? truth.depth_before(answer.toi_upper).low : 0.0;
  const double may_be_apart = limits.wide + limits.rounding_at(answer.toi_lower),
               may_be_deep = std::max(limits.wide, allowed(limits.may_be_late, answer, limits)) +
                             limits.rounding_at(answer.toi_upper);
  RotatingError out{.length = std::max(before, depth),
                    .over_limit = std::max(over(before, may_be_apart), over(depth, may_be_deep))};
  if (before > may_be_apart) {
    out.fault = fmt::format("at {} {} the bodies are {} apart", lower_name(answer), answer.toi_lower,
                            text_of(before, limits));
  } else if (depth > may_be_deep) {
    out.fault = fmt::format("by {} {} the bodies have met {} deep", upper_name(answer), answer.toi_upper,
                            text_of(depth, limits));
  }
  return out;
}

RotatingError distance_error(const RotatingTruth& truth, const Answer& answer, const Limits& limits) {
  if (answer.outcome != Outcome::hit && answer.outcome != Outcome::not_converged) return {};
  RotatingError out{.length = truth.distance_at(answer.toi_lower).low};
  if (out.length > answer.distance + limits.limit) {
    out.fault = fmt::format("says that the bodies are {} apart at toi_lower; they are {}",
                            text_of(answer.distance, limits), text_of(out.length, limits));
  }
  return out;
}

RotatingError undecided_error(const RotatingTruth& truth, const Answer& answer, const Limits& limits) {
  if (answer.outcome != Outcome::not_converged || truth.outcome() == Outcome::not_converged) return {};
  const bool miss = truth.outcome() == Outcome::miss;
  RotatingError out{.length = (miss ? truth.clearance() : truth.depth()).low};
  if (limits.strict && out.length > limits.wide) {
    out.fault = fmt::format("is undecided; {} is {}", miss ? "the clearance" : "the depth",
                            text_of(out.length, limits));
  }
  return out;
}

RotatingError normal_error(const RotatingTruth& truth, const Answer& answer, const Limits& limits) {
  if (answer.outcome != Outcome::hit) return {};
  const double length = answer.normal.norm();
  if (!(std::abs(length - 1) <= std::max(16 * limits.unit_roundoff, limits.contact_u)))
    return {.fault = fmt::format("the normal has length {}", length)};
  if (truth.outcome() != Outcome::hit) return {};
  const double between = std::max(std::abs(answer.toi_lower - truth.toi_lower()),
                                  std::abs(answer.toi_lower - truth.toi_upper()));
  const double error = truth.normal_error(answer.normal).low;
  RotatingError out{.length = std::max(error, 0.0)};
  if (error > limits.contact + between * limits.speed)
    out.fault = fmt::format("the normal fails to separate the bodies by {}", text_of(error, limits));
  return out;
}

namespace {

// How far the witnesses are off their bodies, each may be by `allowed`.
RotatingError off_its_body(const RotatingTruth& truth, const Answer& answer, const Limits& limits,
                           double allowed) {
  if (!answer.point_a.allFinite() || !answer.point_b.allFinite()) return {.fault = "a witness is not finite"};
  RotatingError out{.length = 0};
  for (const char body : {'a', 'b'}) {
    const Vec3<double>& point = body == 'a' ? answer.point_a : answer.point_b;
    // Its coordinates round by 2 u of its distance from the origin (docs/reference/guarantees.md).
    const double error = std::max(0.0, truth.distance_from_body(body, answer.toi_lower, point).low -
                                           2 * limits.unit_roundoff * point.norm() -
                                           (body == 'a' ? answer.reach_a : answer.reach_b));
    out.length = std::max(out.length, error);
    if (error > allowed && out.fault.empty())
      out.fault = fmt::format("witness {} is {} off its body", body, text_of(error, limits));
  }
  return out;
}

}  // namespace

RotatingError witness_error(const RotatingTruth& truth, const Answer& answer, const Limits& limits) {
  if (answer.outcome != Outcome::hit) return {};
  return off_its_body(truth, answer, limits, limits.contact);
}

RotatingError open_error(const RotatingTruth& truth, const corpus::Case& problem, const Answer& answer,
                         const Limits& limits) {
  if (!limits.strict || answer.outcome != Outcome::not_converged || !(answer.toi_lower < problem.t_max))
    return {};
  const double near = limits.wide + limits.rounding_at(answer.toi_lower), few = 8 * limits.unit_roundoff;
  RotatingError out{.length = truth.distance_at(answer.toi_lower).low};
  if (out.length > near) {
    out.fault = fmt::format("open, and at toi_lower {} apart", text_of(out.length, limits));
  } else if (!(answer.distance <= near * (1 + few))) {
    out.fault = fmt::format("open, and states a distance of {}", text_of(answer.distance, limits));
  } else if (!(std::abs(answer.normal.norm() - 1) <= few)) {
    out.fault = "open, and the normal is not a unit vector";
  } else if (RotatingError off = off_its_body(truth, answer, limits, near); !off.fault.empty()) {
    out.fault = "open, and " + off.fault;
  }
  return out;
}

std::string any_fault(const RotatingTruth& truth, const Answer& answer, const Limits& limits) {
  for (const auto error : {&verdict_error, &late_error, &early_error, &width_error}) {
    if (RotatingError found = error(truth, answer, limits); !found.fault.empty()) return found.fault;
  }
  return "";
}

}  // namespace graze::law
