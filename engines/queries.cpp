// Our queries beside the cast as engines: a case in, an answer in doubles out.
#include <graze/distance.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/penetration.hpp>
#include <graze/swept_overlap.hpp>
#include <vector>

#include "engines/convert.hpp"
#include "engines/ours.hpp"

namespace graze::engine {
namespace {

using corpus::Case;
using corpus::Query;

template <Scalar S>
Vec3<double> widened(const Vec3<S>& v) {
  return v.template cast<double>();
}

// What all results have in common.
template <class Result>
Answer begun(const Result& result, Outcome outcome) {
  Answer answer;
  answer.outcome = result.invalid == Invalid::none ? outcome : Outcome::invalid_input;
  answer.invalid = result.invalid;
  answer.invalid_at = result.invalid_at;
  answer.counters = result.counters;
  return answer;
}

// Unasked for they are zero; where they are not, it shows.
template <class Result>
void add_points(Answer& answer, const Result& result, Request request) {
  if (!asks_for(request, Request::witnesses) && result.point_a.isZero(0) && result.point_b.isZero(0)) return;
  answer.has_points = true;
  answer.point_a = widened(result.point_a);
  answer.point_b = widened(result.point_b);
}

template <Scalar S>
Answer of_overlap(const OverlapResult<S>& result) {
  Answer answer = begun(result, result.outcome);
  answer.normal = widened(result.normal);
  return answer;
}
template <Scalar S>
Answer overlap_by_gjk(const Case& c, const Ask&) {
  return of_overlap(overlap_gjk(round_to<S>(c.a), round_to<S>(c.b)));
}
template <Scalar S>
Answer overlap_by_mpr(const Case& c, const Ask&) {
  return of_overlap(overlap_mpr(round_to<S>(c.a), round_to<S>(c.b)));
}

template <Scalar S>
Answer distance_by_gjk(const Case& c, const Ask& ask) {
  const DistanceResult<S> result =
      distance(round_to<S>(c.a), round_to<S>(c.b),
               DistanceOptions<S>{.request = ask.request, .tolerance = static_cast<S>(ask.tolerance)});
  const bool apart = result.lower > 0;
  Answer answer = begun(result, apart               ? Outcome::miss
                                : result.upper == 0 ? Outcome::initially_overlapping
                                                    : Outcome::not_converged);
  if (answer.outcome == Outcome::invalid_input) return answer;
  answer.separation = Interval{result.lower, result.upper};
  answer.stalled = result.stalled;
  if (apart) {
    answer.normal = widened(result.normal);
    add_points(answer, result, ask.request);
  }
  return answer;
}

template <Scalar S>
Answer of_penetration(const PenetrationResult<S>& result, Request request) {
  Answer answer = begun(result, result.outcome);
  if (answer.outcome == Outcome::invalid_input) return answer;
  answer.normal = widened(result.normal);
  answer.stalled = result.stalled;
  if (answer.outcome == Outcome::initially_overlapping) {
    answer.depth = Interval{result.lower, result.upper};
    add_points(answer, result, request);
  }
  return answer;
}
template <Scalar S>
PenetrationOptions<S> penetration_options(const Ask& ask) {
  return {.request = ask.request, .tolerance = static_cast<S>(ask.tolerance)};
}
template <Scalar S>
Answer penetration_by_epa(const Case& c, const Ask& ask) {
  return of_penetration(penetration(round_to<S>(c.a), round_to<S>(c.b), penetration_options<S>(ask)),
                        ask.request);
}
template <Scalar S>
Answer penetration_along_by_mpr(const Case& c, const Ask& ask) {
  return of_penetration(penetration_along(round_to<S>(c.a), round_to<S>(c.b), round_to<S>(c.direction),
                                          penetration_options<S>(ask)),
                        ask.request);
}

template <Scalar S>
Answer overlap_exactly(const Case& c, const Ask&) {
  return of_overlap(overlap_exact(round_to<S>(c.a), round_to<S>(c.b)));
}

template <Scalar S>
LineOptions<S> line_options(const Case& c, const Ask& ask) {
  LineOptions<S> options;
  options.request = ask.request;
  options.tolerance = static_cast<S>(ask.tolerance);
  options.target_distance = static_cast<S>(c.target_distance);
  return options;
}
template <Scalar S>
Answer of_line(const LineResult<S>& result) {
  Answer answer = begun(result, result.outcome);
  if (answer.outcome == Outcome::invalid_input) return answer;
  answer.normal = widened(result.normal_in);
  answer.normal_out = widened(result.normal_out);
  if (answer.outcome != Outcome::miss) {
    answer.t_in = Interval{result.in_lower, result.in_upper};
    answer.t_out = Interval{result.out_lower, result.out_upper};
  }
  return answer;
}

template <Scalar S>
Answer line_by_mpr(const Case& c, const Ask& ask) {
  return of_line(line(round_to<S>(c.a), round_to<S>(c.b), line_options<S>(c, ask)));
}
template <Scalar S>
Answer line_exactly(const Case& c, const Ask& ask) {
  return of_line(line_exact(round_to<S>(c.a), round_to<S>(c.b), line_options<S>(c, ask)));
}

template <Scalar S>
SweptOverlapOptions<S> swept_options(const Case& c) {
  SweptOverlapOptions<S> options;
  options.t_max = static_cast<S>(c.t_max);
  options.target_distance = static_cast<S>(c.target_distance);
  return options;
}
template <Scalar S>
Answer of_swept(const SweptOverlapResult<S>& result) {
  Answer answer = begun(result, result.outcome);
  answer.normal = widened(result.normal);
  return answer;
}

template <Scalar S, SweptMethod kMethod>
Answer swept_overlap_by(const Case& c, const Ask&) {
  SweptOverlapOptions<S> options = swept_options<S>(c);
  options.method = kMethod;
  return of_swept(swept_overlap(round_to<S>(c.a), round_to<S>(c.b), options));
}
template <Scalar S>
Answer swept_overlap_exactly(const Case& c, const Ask&) {
  return of_swept(swept_overlap_exact(round_to<S>(c.a), round_to<S>(c.b), swept_options<S>(c)));
}

// An overlap and a swept overlap have nothing to ask for: their axis comes with the verdict. They have no
// tolerance, either, and tier exact needs none.
template <Scalar S>
void add_methods(std::vector<Method>& out) {
  const auto add = [&](Query query, const char* name, const char* tier, auto ask) {
    out.push_back({.kind = Kind::query,
                   .query = query,
                   .name = name,
                   .scalar = std::same_as<S, float> ? "float" : "double",
                   .tier = tier,
                   .unit_roundoff = kUnitRoundoff<S>,
                   .ask = ask,
                   .seen = &rounded_case<S>});
  };
  // The first of a query, in double, is its default.
  add(Query::overlap, "gjk", "standard", &overlap_by_gjk<S>);
  add(Query::overlap, "mpr", "standard", &overlap_by_mpr<S>);
  add(Query::distance, "gjk", "standard", &distance_by_gjk<S>);
  add(Query::penetration, "epa", "standard", &penetration_by_epa<S>);
  add(Query::penetration_along, "mpr", "standard", &penetration_along_by_mpr<S>);
  add(Query::line, "mpr", "standard", &line_by_mpr<S>);
  add(Query::swept_overlap, "gjk", "standard", &swept_overlap_by<S, SweptMethod::gjk>);
  add(Query::swept_overlap, "mpr", "standard", &swept_overlap_by<S, SweptMethod::mpr>);
  add(Query::swept_overlap, "before_after", "standard", &swept_overlap_by<S, SweptMethod::before_after>);
  add(Query::overlap, "exact", "exact", &overlap_exactly<S>);
  add(Query::line, "exact", "exact", &line_exactly<S>);
  add(Query::swept_overlap, "exact", "exact", &swept_overlap_exactly<S>);
}

}  // namespace

void add_query_methods(std::vector<Method>& out) {
  add_methods<double>(out);
#ifndef GRAZE_DOUBLE_ALONE  // half the compilation, for the trial of the laws
  add_methods<float>(out);
#endif
}

}  // namespace graze::engine
