#include "properties/judge/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "corpus/support_value.hpp"
#include "properties/judge/judgement.hpp"
#include "properties/judge/own_frames.hpp"

namespace graze::law {

using corpus::Case;
using engine::Kind;
using engine::Method;

double Limits::rounding_at(double t) const {
  if (!(t < kInfinity<double>)) return 0;
  // Below the least normal number a time may become that number, or 0 (a tier may leave subnormal ones out).
  const double least = unit_roundoff == kUnitRoundoff<float> ? double(std::numeric_limits<float>::min())
                                                             : std::numeric_limits<double>::min();
  // The speed rounds, too.
  return (2 * unit_roundoff * t + least) * speed * (1 + 8 * kUnitRoundoff<double>);
}

double kappa(const Method& method, const Case& problem) {
  return method.guarantee != nullptr ? method.guarantee->kappa(problem) : kInfinity<double>;
}

double contact_kappa(const Method& method, const Case& problem) {
  return method.guarantee != nullptr ? method.guarantee->contact_kappa(problem) : kInfinity<double>;
}

namespace {

Limits promising_nothing(const Method& method) {
  return {.limit = kInfinity<double>,
          .wide = kInfinity<double>,
          .contact = kInfinity<double>,
          .contact_u = kInfinity<double>,
          .may_miss = engine::Unseen::anything,
          .may_be_late = engine::Unseen::anything,
          .unit_roundoff = method.unit_roundoff};
}

// Rounding errors beyond those that the scale covers.
double unseen_of(const Method& method, const Case& seen, double scale) {
  if (method.kind == Kind::rotating) return unseen_of_turns(seen);
  if (method.is_exact()) return 0;
  return method.is_certified() ? unseen_of_own_frames(seen) : unseen_of_trees(seen, scale);
}

}  // namespace

Limits limits_of(const Method& method, const Case& seen, double scale, double tolerance, double slack) {
  const bool turning = method.kind == Kind::rotating;
  Limits out = promising_nothing(method);
  out.scale = scale;
  out.speed = turning ? top_speed_of(seen) : (seen.b.displacement - seen.a.displacement).stableNorm();
  if (method.guarantee == nullptr || method.guarantee->is_open) return out;

  const engine::Guarantee& row = *method.guarantee;
  const double declared = row.tolerance + row.relative_tolerance * scale +
                          (row.own_frames > 0 ? row.own_frames * weight_of_own_frames(seen) : 0);
  const double unseen = slack + unseen_of(method, seen, scale);
  const double width = std::max(row.width.value_or(0), turning ? tolerance : 0) * scale;
  out.strict = method.is_certified() && slack == 0;
  out.limit =
      kappa(method, seen) * method.unit_roundoff * scale + declared + (out.strict && !turning ? 0 : unseen);
  out.early = row.early;
  out.wide = std::max(out.limit + row.early, width + unseen);
  out.contact_u = contact_kappa(method, seen) * method.unit_roundoff + over(declared, scale);
  // In tier certified the contact of a linear cast is itself known to its width. For rotating bodies it is
  // the contact at toi_lower.
  out.contact = contact_kappa(method, seen) * method.unit_roundoff * scale + declared +
                (turning                 ? unseen
                 : method.is_certified() ? out.wide
                                         : 0);
  out.may_miss = row.may_miss;
  out.may_be_late = row.may_be_late;
  out.contact_rounds_times = !turning && method.is_certified() && method.in_float();
  out.rounds_times = turning || method.is_exact() || (method.is_certified() && method.in_float());
  return out;
}

double scale_of(const Case& problem) {
  const corpus::Bounds a = corpus::bounds(problem.a.shape, problem.a.orientation),
                       b = corpus::bounds(problem.b.shape, problem.b.orientation);
  const Vec3<double> apart =
      (problem.b.position - problem.a.position) + (b.low + b.high) / 2 - (a.low + a.high) / 2;
  return std::max({(a.high - a.low).stableNorm(), (b.high - b.low).stableNorm(), apart.stableNorm()});
}

double top_speed_of(const Case& problem) {
  const auto fastest = [](const Body<double>& body, const corpus::Spin& spin) {
    const corpus::Bounds box = corpus::bounds(body.shape, body.orientation);
    const double arm = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm() + spin.pivot.norm();
    return body.displacement.norm() + spin.rotation.norm() * arm;
  };
  return fastest(problem.a, problem.spin_a) + fastest(problem.b, problem.spin_b);
}

double scale_of_question(corpus::Query query, double target_distance, double scale_of_pair) {
  return query == corpus::Query::line ? std::max(scale_of_pair, target_distance) : scale_of_pair;
}

}  // namespace graze::law
