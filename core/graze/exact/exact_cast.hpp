// Tier exact: the first contact of two moving polytopes, correctly rounded.
//
//   toi_lower = the largest S not above the exact TOI of the true shapes, toi_upper = the least not below it;
//   the verdict is exact, touching included. For every valid input: point, segment, triangle, box, hull,
//   posed and summed (so swept), any orientation; no target distance. It never stalls.
//
// The proof of every answer is accepted to the last bit: its axis is symbolic, its times are the double
// bracket (for S = float the closer one). Also exact: overlap at t = 0, overlap on the path, the signed
// answer.
#pragma once

#include <graze/exact/answer.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/swept_overlap.hpp>

namespace graze {

namespace exact {

// The largest S not above x, and the least not below.
template <Scalar S>
S round_down(double x) {
  if constexpr (std::same_as<S, double>) {
    return x;
  } else {
    const float near = static_cast<float>(x);
    return static_cast<double>(near) > x ? std::nextafter(near, -kInfinity<float>) : near;
  }
}
template <Scalar S>
S round_up(double x) {
  return -round_down<S>(-x);
}

// What tier exact refuses beyond the door.
template <Scalar S>
Invalid refusal(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  const Invalid invalid = validate(a, b, options);
  if (invalid != Invalid::none) return invalid;
  const bool known = is_exact(a.shape) && is_exact(b.shape) && !(options.target_distance > 0);
  return known ? Invalid::none : Invalid::not_exact;
}

// Unit, from A to B: -(f_1 x f_2) at an entry, f_1 x f_2 at an exit, as the facet's n.v > 0.
template <Scalar S>
Vec3<S> outward_normal(const Scene<S>& scene, const Facet& facet, bool entry) {
  const Vec3<double> n = unit_normal(scene, facet);
  return (entry ? Vec3<double>(-n) : n).template cast<S>();
}

// A miss by the line: a unit vector that separates.
template <Scalar S>
Vec3<S> separating_normal(const Scene<S>& scene, const Answer& answer) {
  const Facet plane{{}, answer.miss_f1, answer.miss_f2, {}, 0};
  return (answer.miss_sign * unit_normal(scene, plane)).template cast<S>();
}

}  // namespace exact

template <Scalar S>
CastResult<S> cast_exact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options = {}) {
  using exact::Passage;
  CastResult<S> out;
  out.method = Method::exact_portal;
  out.invalid = exact::refusal(a, b, options);
  if (out.invalid != Invalid::none) return out;

  exact::LineCast<S> cast(a, b, out.counters);
  const exact::Scene<S>& scene = cast.scene();
  const exact::Term& v = cast.line().v;
  const exact::Answer answer = cast.pass();
  const double t_max = static_cast<double>(options.t_max);
  exact::TimeBracket toi{kInfinity<double>, kInfinity<double>};
  out.outcome = Outcome::miss;
  if (answer.passage == Passage::contact) {
    out.passed_over = options.start_policy == StartPolicy::pass_over && cast.leaves_or_slides();
    if (!out.passed_over) {
      out.outcome = Outcome::initially_overlapping;
      toi = {0, 0};
    }
  } else if (answer.passage == Passage::ahead && cast.pair().moves()) {
    // t_max is a double: t_in <= t_max iff the least double not below t_in is.
    const exact::TimeBracket t_in = exact::round_time(scene, answer.facet, v);
    if (t_in.upper <= t_max) {
      out.outcome = Outcome::hit;
      toi = t_in;
    }
  }
  out.toi_lower = exact::round_down<S>(toi.lower);
  out.toi_upper = exact::round_up<S>(toi.upper);
  if (out.outcome == Outcome::hit) {
    const Triple& r = cast.pair().direction();
    const double speed = std::sqrt(dot(r, r)) * power_of_two(scene.speed_exponent());
    out.distance = static_cast<S>((double(out.toi_upper) - double(out.toi_lower)) * speed);
    if (asks_for(options.request, Request::normal))
      out.normal = exact::outward_normal(scene, answer.facet, true);
    if (asks_for(options.request, Request::witnesses)) {
      const std::array<double, 3> weight = exact::facet_weights(scene, answer.facet, v);
      const auto point = [&](const Body<S>& body, const Guide<S>& guide, bool of_a) -> Vec3<S> {
        return exact::facet_point(body, guide, scene.length_exponent(), answer.facet, weight, of_a,
                                  double(out.toi_lower))
            .template cast<S>();
      };
      out.point_a = point(a, cast.pair().a(), true);
      out.point_b = point(b, cast.pair().b(), false);
    }
  }
  if (asks_for(options.request, Request::proof) && !out.passed_over)
    out.proof = exact::prove(answer, out.outcome, toi, options.start_policy);
  out.counters.exact_decisions = scene.exact_decisions();
  if (!scene.valid()) {
    out = {};
    out.method = Method::exact_portal;
    out.invalid = Invalid::too_complex;
  }
  return out;
}

// Do they touch at t = 0? Touching counts.
template <Scalar S>
OverlapResult<S> overlap_exact(const Body<S>& a, const Body<S>& b) {
  OverlapResult<S> out;
  Body<S> fixed_a = a, fixed_b = b;
  fixed_a.displacement = fixed_b.displacement = Vec3<S>::Zero();
  out.invalid = exact::refusal(a, b, CastOptions<S>{});
  if (out.invalid != Invalid::none) return out;
  exact::LineCast<S> cast(fixed_a, fixed_b, out.counters);
  const exact::Answer answer = cast.pass();
  out.outcome = Outcome::miss;
  switch (answer.passage) {
    case exact::Passage::contact:
      out.outcome = Outcome::initially_overlapping;
      break;
    case exact::Passage::beside:
      out.normal = exact::separating_normal(cast.scene(), answer);
      break;
    default:
      out.normal = exact::outward_normal(cast.scene(), answer.facet, answer.passage == exact::Passage::ahead);
  }
  out.counters.exact_decisions = cast.scene().exact_decisions();
  if (!cast.scene().valid()) {
    out = {};
    out.invalid = Invalid::too_complex;
  }
  return out;
}

// Do they touch at any t in [0, t_max]? options.method is not read.
template <Scalar S>
SweptOverlapResult<S> swept_overlap_exact(const Body<S>& a, const Body<S>& b,
                                          const SweptOverlapOptions<S>& options = {}) {
  CastOptions<S> as_cast;
  as_cast.request = Request::normal;
  as_cast.t_max = options.t_max;
  as_cast.target_distance = options.target_distance;
  as_cast.max_iterations = options.max_iterations;
  SweptOverlapResult<S> out;
  out.invalid = exact::refusal(a, b, as_cast);
  if (out.invalid != Invalid::none) return out;
  exact::LineCast<S> cast(a, b, out.counters);
  const exact::Answer answer = cast.pass();
  const bool ahead = answer.passage == exact::Passage::ahead;
  const double t_max = static_cast<double>(options.t_max);
  const bool meets = answer.passage == exact::Passage::contact ||
                     (ahead && cast.pair().moves() &&
                      (t_max == kInfinity<double> ||
                       exact::compare_time(cast.scene(), answer.facet, cast.line().v, t_max) <= 0));
  out.outcome = meets ? Outcome::hit : Outcome::miss;
  if (!meets) {
    out.normal = answer.passage == exact::Passage::beside
                     ? exact::separating_normal(cast.scene(), answer)
                     : exact::outward_normal(cast.scene(), answer.facet, ahead);
  }
  out.counters.exact_decisions = cast.scene().exact_decisions();
  if (!cast.scene().valid()) {
    out = {};
    out.invalid = Invalid::too_complex;
  }
  return out;
}

// The signed answer {t in R : contact at t}: each end as its two neighbouring S, or one.
template <Scalar S>
LineResult<S> line_exact(const Body<S>& a, const Body<S>& b, const LineOptions<S>& options = {}) {
  CastOptions<S> checked;
  checked.target_distance = options.target_distance;
  checked.tolerance = options.tolerance;
  checked.max_iterations = options.max_iterations;
  LineResult<S> out;
  out.invalid = exact::refusal(a, b, checked);
  if (out.invalid != Invalid::none) return out;
  exact::LineCast<S> cast(a, b, out.counters);
  const exact::Scene<S>& scene = cast.scene();
  if (!cast.pair().moves()) {
    const OverlapResult<S> rest = overlap_exact(a, b);
    out.invalid = rest.invalid;
    out.counters = rest.counters;
    out.outcome = rest.outcome == Outcome::initially_overlapping ? Outcome::hit : rest.outcome;
    if (out.outcome == Outcome::miss) out.normal_in = rest.normal;
    if (out.outcome == Outcome::hit) {
      out.in_upper = -kInfinity<S>;
      out.out_lower = kInfinity<S>;
    }
    return out;
  }
  const exact::Answer in = cast.end(-1);
  if (in.passage == exact::Passage::beside) {
    out.outcome = Outcome::miss;
    out.normal_in = exact::separating_normal(scene, in);
  } else {
    const exact::Answer leave = cast.end(1);
    out.outcome = Outcome::hit;
    const exact::TimeBracket t_in = exact::round_time(scene, in.facet, cast.line().v),
                             t_out = exact::round_time(scene, leave.facet, cast.line().v);
    out.in_lower = exact::round_down<S>(t_in.lower);
    out.in_upper = exact::round_up<S>(t_in.upper);
    out.out_lower = exact::round_down<S>(t_out.lower);
    out.out_upper = exact::round_up<S>(t_out.upper);
    if (asks_for(options.request, Request::normal)) {
      out.normal_in = exact::outward_normal(scene, in.facet, true);
      out.normal_out = exact::outward_normal(scene, leave.facet, false);
    }
  }
  out.counters.exact_decisions = scene.exact_decisions();
  if (!scene.valid()) {
    out = {};
    out.invalid = Invalid::too_complex;
  }
  return out;
}

}  // namespace graze
