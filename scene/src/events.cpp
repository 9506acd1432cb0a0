#include "events.hpp"

namespace graze::scene {
namespace {

bool turns(const RotatingBody<double>& body) { return body.rotation != Vec3<double>::Zero(); }

Request request_of(const Options& options) {
  return options.economies.has(Economy::asked) ? options.request : Request::everything;
}

// A request for a proof changes the bracket of rotating bodies: they then count as in contact only from the time at which that
// is proved. So a proof is computed only if the caller requests it.
Request request_of_turning(const Options& options) {
  const bool proves = asks_for(options.request, Request::proof) || options.economies.has(Economy::asked);
  return proves ? request_of(options) : Request::normal | Request::witnesses;
}

// Neither body rotates: a static overlap, or a linear cast.
graze::Plan plan_without_turning(const RotatingBody<double>& a, const RotatingBody<double>& b,
                                 const Options& options) {
  graze::Plan plan;
  plan.add(PlanReason::no_rotation);
  plan.effects = Effects::linear;
  if (options.economies.has(Economy::still) && a.body.displacement == b.body.displacement) {
    plan.add(PlanReason::nothing_moves);
    plan.effects = Effects::at_rest;
  }
  return plan;
}

RotatingOptions<double> turning_options(const Options& options, double t_max) {
  RotatingOptions<double> out;
  out.tier = options.tier;
  out.economies = options.economies.of_a_pair();
  out.request = request_of_turning(options);
  out.t_max = t_max;
  out.target_distance = options.target_distance;
  out.tolerance = options.tolerance;
  return out;
}

// The scene is valid, and so is each body. If core refuses the pair all the same, because the two together nest too many
// rotations for the exact tier, nothing is known about it: it is open, and no miss.
void leave_open_if_refused(RotatingResult<double>& result, double t_max) {
  if (result.outcome != Outcome::invalid_input) return;
  result.outcome = Outcome::not_converged;
  result.toi_lower = 0;
  result.toi_upper = t_max;
  result.distance = kInfinity<double>;
}

}  // namespace

Answer answer(const RotatingBody<double>& a, const RotatingBody<double>& b, const Options& options,
              double t_max) {
  Answer out;
  if (turns(a) || turns(b)) {
    out.result = graze::cast(a, b, turning_options(options, t_max));
    leave_open_if_refused(out.result, t_max);
    return out;
  }
  out.result.plan = plan_without_turning(a, b, options);
  CastOptions<double> linear;
  linear.tier = options.tier;
  linear.request = request_of(options);
  linear.t_max = out.result.plan.effects == Effects::at_rest ? 0.0 : t_max;
  linear.target_distance = options.target_distance;
  CastResult<double> found = graze::cast(a.body, b.body, linear);
  RotatingResult<double>& result = out.result;
  result.outcome = found.outcome;
  result.invalid = found.invalid;
  result.invalid_at = found.invalid_at;
  result.toi_lower = found.toi_lower;
  result.toi_upper = found.toi_upper;
  result.distance = std::max(found.distance, 0.0);
  result.normal = found.normal;
  result.point_a = found.point_a;
  result.point_b = found.point_b;
  result.counters = found.counters;
  out.proof = found.proof;
  leave_open_if_refused(result, linear.t_max);
  return out;
}

graze::Plan plan_of(const RotatingBody<double>& a, const RotatingBody<double>& b, const Options& options) {
  if (!turns(a) && !turns(b)) return plan_without_turning(a, b, options);
  return graze::plan(a, b, turning_options(options, options.t_max));
}

Event event_of(std::uint32_t a, std::uint32_t b, Answer&& answer) {
  RotatingResult<double>& found = answer.result;
  Event out;
  out.a = a;
  out.b = b;
  out.outcome = found.outcome;
  out.toi_lower = found.toi_lower;
  out.toi_upper = found.toi_upper;
  out.distance = found.distance;
  out.effects = found.plan.effects;
  out.reasons = found.plan.reasons;
  out.normal = found.normal;
  out.point_a = found.point_a;
  out.point_b = found.point_b;
  if (answer.proof || found.proof) {
    out.proof =
        std::make_shared<const EventProof>(EventProof{std::move(answer.proof), std::move(found.proof)});
  }
  return out;
}

}  // namespace graze::scene
