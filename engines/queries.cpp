#include "engines/queries.hpp"

#include <graze/distance.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/penetration.hpp>
#include <graze/swept_overlap.hpp>
#include <vector>

#include "engines/convert.hpp"

namespace graze::engine {
namespace {

using corpus::Case;
using corpus::Query;

template <Scalar S>
std::optional<Vec3<double>> widened(const Vec3<S>& v) {
  if (v == Vec3<S>::Zero()) return std::nullopt;
  return v.template cast<double>();
}

// What all results have in common.
template <class Result>
QueryAnswer begun(const Result& result, Outcome outcome) {
  QueryAnswer answer;
  answer.outcome = result.invalid == Invalid::none ? outcome : Outcome::invalid_input;
  answer.invalid = result.invalid;
  answer.counters = result.counters;
  return answer;
}

// Unasked for they are zero; where they are not, it shows.
template <class Result>
void add_points(QueryAnswer& answer, const Result& result, Request request) {
  if (!asks_for(request, Request::witnesses) && result.point_a.isZero(0) && result.point_b.isZero(0)) return;
  answer.point_a = result.point_a.template cast<double>();
  answer.point_b = result.point_b.template cast<double>();
}

template <Scalar S>
QueryAnswer of_overlap(const OverlapResult<S>& result) {
  QueryAnswer answer = begun(result, result.outcome);
  answer.normal = widened(result.normal);
  return answer;
}
template <Scalar S>
QueryAnswer overlap_by_gjk(const Case& c, const QueryAsk&) {
  return of_overlap(overlap_gjk(round_to<S>(c.a), round_to<S>(c.b)));
}
template <Scalar S>
QueryAnswer overlap_by_mpr(const Case& c, const QueryAsk&) {
  return of_overlap(overlap_mpr(round_to<S>(c.a), round_to<S>(c.b)));
}

template <Scalar S>
QueryAnswer distance_by_gjk(const Case& c, const QueryAsk& ask) {
  const DistanceResult<S> result =
      distance(round_to<S>(c.a), round_to<S>(c.b),
               DistanceOptions<S>{.request = ask.request, .tolerance = static_cast<S>(ask.tolerance)});
  const bool apart = result.lower > 0;
  QueryAnswer answer = begun(result, apart               ? Outcome::miss
                                     : result.upper == 0 ? Outcome::initially_overlapping
                                                         : Outcome::not_converged);
  if (answer.outcome == Outcome::invalid_input) return answer;
  answer.distance = Interval{result.lower, result.upper};
  answer.stalled = result.stalled;
  if (apart) {
    answer.normal = widened(result.normal);
    add_points(answer, result, ask.request);
  }
  return answer;
}

template <Scalar S>
QueryAnswer of_penetration(const PenetrationResult<S>& result, Request request) {
  QueryAnswer answer = begun(result, result.outcome);
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
PenetrationOptions<S> penetration_options(const QueryAsk& ask) {
  return {.request = ask.request, .tolerance = static_cast<S>(ask.tolerance)};
}
template <Scalar S>
QueryAnswer penetration_by_epa(const Case& c, const QueryAsk& ask) {
  return of_penetration(penetration(round_to<S>(c.a), round_to<S>(c.b), penetration_options<S>(ask)),
                        ask.request);
}
template <Scalar S>
QueryAnswer penetration_along_by_mpr(const Case& c, const QueryAsk& ask) {
  return of_penetration(penetration_along(round_to<S>(c.a), round_to<S>(c.b), round_to<S>(c.direction),
                                          penetration_options<S>(ask)),
                        ask.request);
}

template <Scalar S>
QueryAnswer overlap_exactly(const Case& c, const QueryAsk&) {
  return of_overlap(overlap_exact(round_to<S>(c.a), round_to<S>(c.b)));
}

template <Scalar S>
LineOptions<S> line_options(const Case& c, const QueryAsk& ask) {
  LineOptions<S> options;
  options.request = ask.request;
  options.tolerance = static_cast<S>(ask.tolerance);
  options.target_distance = static_cast<S>(c.target_distance);
  return options;
}
template <Scalar S>
QueryAnswer of_line(const LineResult<S>& result) {
  QueryAnswer answer = begun(result, result.outcome);
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
QueryAnswer line_by_mpr(const Case& c, const QueryAsk& ask) {
  return of_line(line(round_to<S>(c.a), round_to<S>(c.b), line_options<S>(c, ask)));
}
template <Scalar S>
QueryAnswer line_exactly(const Case& c, const QueryAsk& ask) {
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
QueryAnswer of_swept(const SweptOverlapResult<S>& result) {
  QueryAnswer answer = begun(result, result.outcome);
  answer.normal = widened(result.normal);
  return answer;
}

template <Scalar S, SweptMethod kMethod>
QueryAnswer swept_overlap_by(const Case& c, const QueryAsk&) {
  SweptOverlapOptions<S> options = swept_options<S>(c);
  options.method = kMethod;
  return of_swept(swept_overlap(round_to<S>(c.a), round_to<S>(c.b), options));
}
template <Scalar S>
QueryAnswer swept_overlap_exactly(const Case& c, const QueryAsk&) {
  return of_swept(swept_overlap_exact(round_to<S>(c.a), round_to<S>(c.b), swept_options<S>(c)));
}

template <Scalar S>
void add_methods(std::vector<QueryMethod>& out) {
  const char* scalar = std::same_as<S, float> ? "float" : "double";
  out.push_back({Query::overlap, "gjk", scalar, "standard", &overlap_by_gjk<S>});
  out.push_back({Query::overlap, "mpr", scalar, "standard", &overlap_by_mpr<S>});
  out.push_back({Query::distance, "gjk", scalar, "standard", &distance_by_gjk<S>});
  out.push_back({Query::penetration, "epa", scalar, "standard", &penetration_by_epa<S>});
  out.push_back({Query::penetration_along, "mpr", scalar, "standard", &penetration_along_by_mpr<S>});
  out.push_back({Query::line, "mpr", scalar, "standard", &line_by_mpr<S>});
  out.push_back({Query::swept_overlap, "gjk", scalar, "standard", &swept_overlap_by<S, SweptMethod::gjk>});
  out.push_back({Query::swept_overlap, "mpr", scalar, "standard", &swept_overlap_by<S, SweptMethod::mpr>});
  out.push_back({Query::swept_overlap, "before_after", scalar, "standard",
                 &swept_overlap_by<S, SweptMethod::before_after>});
  out.push_back({Query::overlap, "exact", scalar, "exact", &overlap_exactly<S>});
  out.push_back({Query::line, "exact", scalar, "exact", &line_exactly<S>});
  out.push_back({Query::swept_overlap, "exact", scalar, "exact", &swept_overlap_exactly<S>});
}

}  // namespace

std::span<const QueryMethod> query_methods() {
  static const std::vector<QueryMethod> kMethods = [] {
    std::vector<QueryMethod> out;
    add_methods<double>(out);
#ifndef GRAZE_DOUBLE_ALONE  // half the compilation, for the trial of the laws
    add_methods<float>(out);
#endif
    return out;
  }();
  return kMethods;
}

std::string unsupported_query(const Case& problem) {
  const bool along_the_path = problem.query == Query::line || problem.query == Query::swept_overlap;
  if (!along_the_path) return {};
  for (const corpus::Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    if (spin->rotation != Vec3<double>::Zero()) return "a rotating motion";
  }
  return {};
}

}  // namespace graze::engine
