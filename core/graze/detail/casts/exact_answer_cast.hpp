// The exact passage of a line through C as a cast's answer: verdict, bracket, normal and witnesses in S.
#pragma once

#include <graze/detail/casts/exact_ends.hpp>
#include <graze/detail/numeric/rounding.hpp>
#include <graze/detail/search/exact/meeting.hpp>
#include <graze/detail/shapes/validation.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// The passage as a cast's answer. `out` comes from the method that determines it, with its counters. A number that
// exceeds its storage makes the cast refuse the case.
template <Scalar S>
void answer_cast(PassageSearch<S>& cast, const Answer& answer, const CastOptions<S>& options,
                 CastResult<S>& out) {
  const double t_max = static_cast<double>(options.t_max);
  TimeBracket toi{kInfinity<double>, kInfinity<double>};
  out.outcome = Outcome::miss;
  out.toi_lower = out.toi_upper = kInfinity<S>;
  if (!cast.has_scene()) {
    if (asks_for(options.request, Request::proof))
      out.proof = prove(answer, out.outcome, toi, options.start_policy);
    return;
  }
  const Scene<S>& scene = cast.scene();
  if (answer.passage == Passage::contact) {
    out.passed_over = options.start_policy == StartPolicy::pass_over && cast.leaves_or_slides();
    if (!out.passed_over) {
      out.outcome = Outcome::initially_overlapping;
      toi = {0, 0};
      out.toi_lower = out.toi_upper = 0;
    }
  } else if (answer.passage == Passage::ahead && cast.pair().moves()) {
    // t_max is a double: t_in <= t_max iff the least double not below t_in is.
    Meeting<S> meeting(cast.pair(), scene, answer.facet, cast.v());
    const TimeBracket t_in = meeting.time();
    if (t_in.upper <= t_max) {
      out.outcome = Outcome::hit;
      toi = t_in;
      out.toi_lower = round_down<S>(toi.lower);
      out.toi_upper = round_up<S>(toi.upper);
      const Triple& r = cast.pair().direction();
      const double speed = square_root(dot(r, r)) * power_of_two(scene.speed_exponent());
      out.distance = static_cast<S>((double(out.toi_upper) - double(out.toi_lower)) * speed);
      if (asks_for(options.request, Request::normal))
        out.normal = Vec3<double>(-meeting.normal()).template cast<S>();
      if (asks_for(options.request, Request::witnesses)) {
        const std::array<Vec3<double>, 2> points = meeting.witnesses(double(out.toi_lower));
        out.point_a = points[0].template cast<S>();
        out.point_b = points[1].template cast<S>();
      }
    }
  }
  GRAZE_ASSERT(!scene.valid() || out.toi_lower <= out.toi_upper);
  if (asks_for(options.request, Request::proof) && !out.passed_over)
    out.proof = prove(answer, out.outcome, toi, options.start_policy);
  out.counters.exact_decisions = scene.exact_decisions();
  if (!scene.valid()) {
    const Method method = out.method;
    out = {};
    out.method = method;
    refuse_as_too_complex(out);
  }
}

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
