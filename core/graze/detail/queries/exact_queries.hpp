// The other questions of tier exact: overlap and distance at t = 0, overlap on the path, the signed answer. Touching
// counts.
//
// The distance |w| - R is compared with a double x by the sign of w.w - (R + x)^2, which is rational.
//
// Supports the shapes of casts/exact_cast.hpp. Other shapes are invalid_input with not_exact. Normals are within 2 u
// per component of one that separates, or supports C where the line enters and leaves.
#pragma once

#include <graze/detail/casts/exact_ends.hpp>
#include <graze/detail/casts/exact_round_answer.hpp>
#include <graze/detail/numeric/rounding.hpp>
#include <graze/detail/queries/distance_query.hpp>
#include <graze/detail/search/exact/exact_answer.hpp>
#include <graze/detail/search/exact/meeting.hpp>
#include <graze/detail/shapes/validation.hpp>
#include <graze/distance.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/swept_overlap.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

// In distance_query.hpp, which may be what includes this file.
template <Scalar S>
CastOptions<S> checked(const DistanceOptions<S>& options);

}  // namespace detail

namespace detail { namespace exact {

// A miss by the line: a unit vector that separates.
template <Scalar S>
Vec3<S> separating_normal(const Scene<S>& scene, const Answer& answer) {
  const Facet plane{{}, answer.miss.f1, answer.miss.f2, {}, 0};
  return (answer.miss.sign * unit_normal(scene, plane)).template cast<S>();
}

// The result with its cost, or the report that a number outgrew its room (dyadic.hpp).
template <Scalar S, class Result>
Result finished(const Scene<S>& scene, Result result) {
  result.counters.exact_decisions = scene.exact_decisions();
  if (scene.valid()) return result;
  Result refused;
  refuse_as_too_complex(refused);
  return refused;
}

template <Scalar S, class Result>
Result finished(const RoundSearch<S>& search, Result result) {
  ++result.counters.exact_decisions;
  result.counters.supports += search.supports();
  if (search.valid()) return result;
  Result refused;
  refuse_as_too_complex(refused);
  return refused;
}

// A search that begins with the corners nearest at t = 0, in doubles.
template <Scalar S>
void begin_at_start(const Body<S>& a, const Body<S>& b, S target_distance, RoundSearch<S>& search,
                    Counters& counters) {
  search.begin_at(nearest_corners(a, b, target_distance, 0.0, counters));
}

// The first contact on the line, near a guess if that is right. None: the line misses.
template <Scalar S>
std::optional<RoundContact> line_entry(const Body<S>& a, const Body<S>& b, S target_distance, double guess,
                                       RoundSearch<S>& search, Counters& counters) {
  const bool is_guess = std::abs(guess) < kInfinity<double>;
  const RoundGuess near = nearest_corners(a, b, target_distance, is_guess ? guess : 0.0, counters);
  if (is_guess) {
    if (std::optional<RoundContact> contact = search.contact_near(near, -kInfinity<double>)) return contact;
  }
  search.begin_at(near);
  const auto path = search.path(search.begin(), search.end(kInfinity<double>));
  if (path == RoundSearch<S>::Path::misses) return {};
  return search.first_contact(path, near.time);
}

// A line of rounded shapes, not at rest: t_in, and t_out as that of the opposite motion. line() has the guesses.
template <Scalar S>
LineResult<S> round_line(const Body<S>& a, const Body<S>& b, const LineOptions<S>& options) {
  const S target = options.target_distance;
  LineResult<S> out;
  LineOptions<S> plain;
  plain.request = Request::verdict;
  plain.target_distance = target;
  const LineResult<S> about = line(a, b, plain);
  out.counters = about.counters;
  RoundSearch<S> search(a, b, double(target));
  const auto in = line_entry(a, b, target, double(about.in_lower), search, out.counters);
  out.outcome = in ? Outcome::hit : Outcome::miss;
  if (!in) {
    out.normal_in = unit_of(search.separating()).template cast<S>();
    return finished(search, out);
  }
  Body<S> back_a = a, back_b = b;
  std::swap(back_a.displacement, back_b.displacement);
  RoundSearch<S> back(back_a, back_b, double(target));
  const auto leave = line_entry(back_a, back_b, target, -double(about.out_upper), back, out.counters);
  if (!leave) return finished(back, out);
  out.counters.supports += back.supports();
  out.in_lower = round_down<S>(in->toi.lower);
  out.in_upper = round_up<S>(in->toi.upper);
  out.out_lower = round_down<S>(0 - leave->toi.upper);
  out.out_upper = round_up<S>(0 - leave->toi.lower);
  if (asks_for(options.request, Request::normal)) {
    out.normal_in = unit_of(in->normal).template cast<S>();
    out.normal_out = unit_of(leave->normal).template cast<S>();
  }
  return finished(search, out);
}

}}  // namespace detail::exact

template <Scalar S>
OverlapResult<S> overlap_exact(const Body<S>& a, const Body<S>& b) {
  OverlapResult<S> out;
  Body<S> fixed_a = a, fixed_b = b;
  fixed_a.displacement = fixed_b.displacement = Vec3<S>::Zero();
  const CastOptions<S> options;
  out.invalid = validate(a, b, options);
  if (detail::refused(out, a, b, options) || detail::exact::refused(out, a, b)) return out;
  if (!detail::exact::is_sharp(a, b, S(0))) {
    detail::exact::RoundSearch<S> search(a, b, 0);
    detail::exact::begin_at_start(a, b, S(0), search, out.counters);
    out.outcome = search.start() <= 0 ? Outcome::initially_overlapping : Outcome::miss;
    if (out.outcome == Outcome::miss)
      out.normal = detail::exact::unit_of(search.separating()).template cast<S>();
    return detail::exact::finished(search, out);
  }
  detail::exact::PassageSearch<S> cast(fixed_a, fixed_b, out.counters);
  const detail::exact::Answer answer = cast.pass();
  out.outcome = Outcome::miss;
  switch (answer.passage) {
    case detail::exact::Passage::contact:
      out.outcome = Outcome::initially_overlapping;
      break;
    case detail::exact::Passage::beside:
      out.normal = detail::exact::separating_normal(cast.scene(), answer);
      break;
    default:
      out.normal = detail::exact::outward_normal(cast.scene(), answer.facet,
                                                 answer.passage == detail::exact::Passage::ahead);
  }
  return detail::exact::finished(cast.scene(), out);
}

template <Scalar S>
DistanceResult<S> distance_exact(const Body<S>& a, const Body<S>& b, const DistanceOptions<S>& options) {
  DistanceResult<S> out;
  const CastOptions<S> checked = detail::checked(options);
  out.invalid = validate(a, b, checked);
  if (detail::refused(out, a, b, checked) || detail::exact::refused(out, a, b)) return out;
  detail::exact::RoundSearch<S> search(a, b, 0);
  detail::exact::begin_at_start(a, b, S(0), search, out.counters);
  if (search.start() <= 0 || !search.valid()) {
    out.upper = 0;
    return detail::exact::finished(search, out);
  }
  const detail::exact::TimeBracket ends =
      detail::exact::bracket_by(search.gap(), [&](double x) { return search.sign_of_gap_minus(x); });
  out.lower = detail::round_down<S>(ends.lower);
  out.upper = detail::round_up<S>(ends.upper);
  const detail::exact::RoundContact nearest = search.nearest_point();
  const Vec3<double> n = detail::exact::unit_of(nearest.normal);
  if (asks_for(options.request, Request::normal)) out.normal = n.template cast<S>();
  if (asks_for(options.request, Request::witnesses)) {
    out.point_a = detail::exact::round_witness(a, nearest, true, 0, n).template cast<S>();
    out.point_b = detail::exact::round_witness(b, nearest, false, 0, n).template cast<S>();
  }
  return detail::exact::finished(search, out);
}

template <Scalar S>
SweptOverlapResult<S> swept_overlap_exact(const Body<S>& a, const Body<S>& b,
                                          const SweptOverlapOptions<S>& options) {
  CastOptions<S> as_cast;
  as_cast.request = Request::normal;
  as_cast.t_max = options.t_max;
  as_cast.target_distance = options.target_distance;
  as_cast.max_iterations = options.max_iterations;
  SweptOverlapResult<S> out;
  out.invalid = validate(a, b, as_cast);
  if (detail::refused(out, a, b, as_cast) || detail::exact::refused(out, a, b)) return out;
  if (!detail::exact::is_sharp(a, b, options.target_distance)) {
    CastResult<S> cast;
    detail::exact::RoundGuess guess;
    detail::exact::TimeBracket toi;
    const bool is_cast = detail::exact::fast_round_cast(a, b, as_cast, cast, guess, toi);
    out.counters = cast.counters;
    if (is_cast && cast.outcome != Outcome::miss) {
      out.outcome = Outcome::hit;
      return out;
    }
    detail::exact::RoundSearch<S> search(a, b, double(options.target_distance));
    detail::exact::begin_at_start(a, b, options.target_distance, search, out.counters);
    bool meets = search.start() <= 0;
    if (!meets && search.moves() && options.t_max > 0) {
      meets =
          search.path({}, search.end(double(options.t_max))) != detail::exact::RoundSearch<S>::Path::misses;
    }
    out.outcome = meets ? Outcome::hit : Outcome::miss;
    if (!meets) out.normal = detail::exact::unit_of(search.separating()).template cast<S>();
    return detail::exact::finished(search, out);
  }
  detail::exact::PassageSearch<S> cast(a, b, out.counters);
  const double t_max = static_cast<double>(options.t_max);
  const detail::exact::Answer answer = cast.pass(t_max);
  const bool ahead = answer.passage == detail::exact::Passage::ahead;
  // t_max is a double: t_in <= t_max iff the least double not below t_in is.
  const auto time = [&] {
    return detail::exact::Meeting<S>(cast.pair(), cast.scene(), answer.facet, cast.v()).time();
  };
  const bool meets = answer.passage == detail::exact::Passage::contact ||
                     (ahead && cast.pair().moves() && time().upper <= t_max);
  out.outcome = meets ? Outcome::hit : Outcome::miss;
  if (!meets) {
    out.normal = answer.passage == detail::exact::Passage::beside
                     ? detail::exact::separating_normal(cast.scene(), answer)
                     : detail::exact::outward_normal(cast.scene(), answer.facet, ahead);
  }
  return detail::exact::finished(cast.scene(), out);
}

template <Scalar S>
LineResult<S> line_exact(const Body<S>& a, const Body<S>& b, const LineOptions<S>& options) {
  CastOptions<S> checked;
  checked.target_distance = options.target_distance;
  checked.tolerance = options.tolerance;
  checked.max_iterations = options.max_iterations;
  LineResult<S> out;
  out.invalid = validate(a, b, checked);
  if (detail::refused(out, a, b, checked) || detail::exact::refused(out, a, b)) return out;
  if (!detail::exact::is_sharp(a, b, options.target_distance)) {
    detail::exact::RoundSearch<S> search(a, b, double(options.target_distance));
    if (!search.is_rounded()) return line_exact(detail::flat(a), detail::flat(b), options);
    if (search.moves()) return detail::exact::round_line(a, b, options);
    detail::exact::begin_at_start(a, b, options.target_distance, search, out.counters);
    out.outcome = search.start() <= 0 ? Outcome::hit : Outcome::miss;
    if (out.outcome == Outcome::miss)
      out.normal_in = detail::exact::unit_of(search.separating()).template cast<S>();
    if (out.outcome == Outcome::hit) {
      out.in_upper = -kInfinity<S>;
      out.out_lower = kInfinity<S>;
    }
    return detail::exact::finished(search, out);
  }
  detail::exact::PassageSearch<S> cast(a, b, out.counters);
  const detail::exact::Scene<S>& scene = cast.scene();
  if (!cast.pair().moves()) {
    const OverlapResult<S> rest = overlap_exact(a, b);
    out.invalid = rest.invalid;
    out.invalid_at = rest.invalid_at;
    out.counters = rest.counters;
    out.outcome = rest.outcome == Outcome::initially_overlapping ? Outcome::hit : rest.outcome;
    if (out.outcome == Outcome::miss) out.normal_in = rest.normal;
    if (out.outcome == Outcome::hit) {
      out.in_upper = -kInfinity<S>;
      out.out_lower = kInfinity<S>;
    }
    return out;
  }
  const detail::exact::Answer in = cast.end(-1);
  if (in.passage == detail::exact::Passage::beside) {
    out.outcome = Outcome::miss;
    out.normal_in = detail::exact::separating_normal(scene, in);
  } else {
    const detail::exact::Answer leave = cast.end(1);
    out.outcome = Outcome::hit;
    const detail::exact::TimeBracket t_in = detail::exact::round_time(scene, in.facet, cast.v()),
                                     t_out = detail::exact::round_time(scene, leave.facet, cast.v());
    out.in_lower = detail::round_down<S>(t_in.lower);
    out.in_upper = detail::round_up<S>(t_in.upper);
    out.out_lower = detail::round_down<S>(t_out.lower);
    out.out_upper = detail::round_up<S>(t_out.upper);
    if (asks_for(options.request, Request::normal)) {
      out.normal_in = detail::exact::outward_normal(scene, in.facet, true);
      out.normal_out = detail::exact::outward_normal(scene, leave.facet, false);
    }
  }
  return detail::exact::finished(scene, out);
}

}}  // namespace graze::GRAZE_LINKAGE
