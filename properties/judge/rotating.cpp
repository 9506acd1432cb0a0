#include "properties/judge/rotating.hpp"

#include <fmt/format.h>

#include <cmath>

#include "corpus/format/names.hpp"
#include "corpus/support_value.hpp"
#include "properties/judge/own_frames.hpp"

namespace graze::law {

using corpus::Case;
using engine::RotatingAnswer;
using engine::RotatingEngineMethod;
using engine::Unseen;
using oracle::Enclosure;
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
    const corpus::Bounds box = corpus::bounds(body.shape, body.orientation);
    const double arm = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm() + spin.pivot.norm();
    return body.displacement.norm() + spin.rotation.norm() * arm;
  };
  return fastest(problem.a, problem.spin_a) + fastest(problem.b, problem.spin_b);
}

RotatingRow row_of(const RotatingEngineMethod& method, const engine::Guarantee& row, const Case& seen,
                   double scale, double tolerance, double slack) {
  RotatingRow out;
  const double unseen = slack + unseen_of_turns(seen);
  out.limit = row.kappa(seen) * method.unit_roundoff * scale + unseen;
  out.wide = std::max(out.limit, std::max(row.width.value_or(0), tolerance) * scale + unseen);
  out.contact_limit = row.contact_kappa(seen) * method.unit_roundoff * scale + unseen;
  out.may_miss = row.may_miss;
  out.may_be_late = row.may_be_late;
  out.strict = method.is_certified() && slack == 0;
  out.unit_roundoff = method.unit_roundoff;
  out.speed = top_speed_of(seen);
  out.scale = scale;
  return out;
}

RotatingRow row_of(const RotatingEngineMethod& method, const Case& seen, double tolerance, double slack) {
  const engine::Guarantee* row = engine::find_guarantee(engine::guarantees(), method);
  if (row != nullptr) return row_of(method, *row, seen, scale_of(seen), tolerance, slack);
  RotatingRow out;
  out.limit = out.wide = out.contact_limit = kInfinity<double>;
  out.unit_roundoff = method.unit_roundoff;
  out.speed = top_speed_of(seen);
  out.scale = scale_of(seen);
  return out;
}

bool claims_contact(const RotatingAnswer& answer) {
  return answer.outcome == Outcome::hit || answer.outcome == Outcome::initially_overlapping;
}

namespace {

std::string text_of(double length, const RotatingRow& row) {
  if (length == 0) return "0 of scale";
  return fmt::format("{:.1e} of scale", row.scale > 0 ? length / row.scale : kInfinity<double>);
}

// How deep a contact may be that goes unseen.
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

RotatingError verdict_error(const RotatingTruth& truth, const RotatingAnswer& answer,
                            const RotatingRow& row) {
  if (answer.outcome == Outcome::invalid_input) return {.fault = "refuses a valid case"};
  RotatingError out;
  if (answer.outcome == Outcome::miss && truth.contact_proved()) {
    out.length = truth.depth().low;
    // Of a contact at t = 0 that is left open beside one nearby, only the depth is known.
    if (out.length > allowed(row.may_miss, answer, row) ||
        (row.strict && truth.outcome() != Outcome::not_converged)) {
      out.fault = fmt::format("says miss; there is contact, {} deep, at {:.17g} for the first time",
                              text_of(out.length, row), truth.toi_upper());
    }
  }
  if (claims_contact(answer) && truth.outcome() == Outcome::miss) {
    out.length = truth.clearance().low;
    if (row.strict || out.length > row.wide) {
      out.fault = fmt::format("says {}; the bodies stay {} apart", corpus::name_of(answer.outcome),
                              text_of(out.length, row));
    }
  }
  return out;
}

RotatingError late_error(const RotatingTruth& truth, const RotatingAnswer& answer, const RotatingRow& row) {
  // A miss is judged as a verdict.
  if (answer.outcome == Outcome::miss || !(answer.toi_lower > 0)) return {};
  if (std::isinf(answer.toi_lower)) return {.fault = "an infinite toi_lower without a miss"};
  if (truth.outcome() == Outcome::miss || truth.compare(answer.toi_lower) <= 0) return {};
  RotatingError out{truth.depth_before(answer.toi_lower).low};
  if (row.strict || out.length > allowed(row.may_be_late, answer, row)) {
    out.fault = fmt::format("toi_lower {:.17g} is past the contact at {:.17g}, {} deep", answer.toi_lower,
                            truth.toi_upper(), text_of(out.length, row));
  }
  return out;
}

RotatingError early_error(const RotatingTruth& truth, const RotatingAnswer& answer, const RotatingRow& row) {
  if (answer.outcome == Outcome::miss || !(answer.toi_upper < kInfinity<double>)) return {};
  if (truth.compare(answer.toi_upper) >= 0) return {};
  RotatingError out{truth.distance_at(answer.toi_upper).low};
  if (row.strict || out.length > row.wide) {
    out.fault = fmt::format("claims contact by {:.17g}, where the bodies are {} apart", answer.toi_upper,
                            text_of(out.length, row));
  }
  return out;
}

RotatingError width_error(const RotatingTruth& truth, const RotatingAnswer& answer, const RotatingRow& row) {
  if (!claims_contact(answer)) return {};
  const double before = truth.distance_at(answer.toi_lower).low;
  // A bracket that ends before the first contact has no depth.
  const double depth = truth.compare(answer.toi_upper) >= 0 ? truth.depth_before(answer.toi_upper).low : 0.0;
  RotatingError out{std::max(before, depth)};
  if (before > row.wide + row.rounding_at(answer.toi_lower)) {
    out.fault =
        fmt::format("at toi_lower {:.17g} the bodies are {} apart", answer.toi_lower, text_of(before, row));
  } else if (depth >
             std::max(row.wide, allowed(row.may_be_late, answer, row)) + row.rounding_at(answer.toi_upper)) {
    out.fault = fmt::format("by toi_upper {:.17g} the bodies have met {} deep", answer.toi_upper,
                            text_of(depth, row));
  }
  return out;
}

RotatingError distance_error(const RotatingTruth& truth, const RotatingAnswer& answer,
                             const RotatingRow& row) {
  if (answer.outcome != Outcome::hit && answer.outcome != Outcome::not_converged) return {};
  RotatingError out{truth.distance_at(answer.toi_lower).low};
  if (out.length > answer.distance + row.limit) {
    out.fault = fmt::format("says that the bodies are {} apart at toi_lower; they are {}",
                            text_of(answer.distance, row), text_of(out.length, row));
  }
  return out;
}

RotatingError undecided_error(const RotatingTruth& truth, const RotatingAnswer& answer,
                              const RotatingRow& row) {
  if (answer.outcome != Outcome::not_converged || truth.outcome() == Outcome::not_converged) return {};
  const bool miss = truth.outcome() == Outcome::miss;
  RotatingError out{(miss ? truth.clearance() : truth.depth()).low};
  if (row.strict && out.length > row.wide) {
    out.fault =
        fmt::format("is undecided; {} is {}", miss ? "the clearance" : "the depth", text_of(out.length, row));
  }
  return out;
}

RotatingError normal_error(const RotatingTruth& truth, const RotatingAnswer& answer, const RotatingRow& row) {
  if (answer.outcome != Outcome::hit) return {};
  const double length = answer.normal.norm();
  if (!(std::abs(length - 1) <= 16 * row.unit_roundoff))
    return {.fault = fmt::format("the normal has length {:.17g}", length)};
  if (truth.outcome() != Outcome::hit) return {};
  const double between = std::max(std::abs(answer.toi_lower - truth.toi_lower()),
                                  std::abs(answer.toi_lower - truth.toi_upper()));
  const double error = truth.normal_error(answer.normal).low;
  RotatingError out{std::max(error, 0.0)};
  if (error > row.contact_limit + between * row.speed)
    out.fault = fmt::format("the normal fails to separate the bodies by {}", text_of(error, row));
  return out;
}

RotatingError witness_error(const RotatingTruth& truth, const RotatingAnswer& answer,
                            const RotatingRow& row) {
  if (answer.outcome != Outcome::hit) return {};
  if (!answer.point_a.allFinite() || !answer.point_b.allFinite()) return {.fault = "a witness is not finite"};
  RotatingError out{0};
  for (const char body : {'a', 'b'}) {
    const Vec3<double>& point = body == 'a' ? answer.point_a : answer.point_b;
    // Its coordinates round by 2 u of its distance from the origin (docs/guarantees.md).
    const double error = std::max(0.0, truth.distance_from_body(body, answer.toi_lower, point).low -
                                           2 * row.unit_roundoff * point.norm());
    out.length = std::max(out.length, error);
    if (error > row.contact_limit && out.fault.empty())
      out.fault = fmt::format("witness {} is {} off its body", body, text_of(error, row));
  }
  return out;
}

std::string any_fault(const RotatingTruth& truth, const RotatingAnswer& answer, const RotatingRow& row) {
  for (const auto error : {&verdict_error, &late_error, &early_error, &width_error}) {
    if (RotatingError found = error(truth, answer, row); !found.fault.empty()) return found.fault;
  }
  return "";
}

}  // namespace graze::law
