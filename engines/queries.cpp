// Our queries other than casts as engines: a case in, an answer in doubles out.
#include <graze/distance.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/penetration.hpp>
#include <graze/swept_overlap.hpp>
#include <vector>

#include "engines/convert.hpp"
#include "engines/ours.hpp"
#include "engines/timing.hpp"

namespace graze::engine {
namespace {

using corpus::Case;
using corpus::Query;

template <Scalar S>
Vec3<double> widened(const Vec3<S>& v) {
  return v.template cast<double>();
}

// Starts an answer with the fields that all results share.
template <class Result>
Answer begun(const Result& result, Outcome outcome) {
  Answer answer;
  answer.outcome = result.invalid == Invalid::none ? outcome : Outcome::invalid_input;
  answer.invalid = result.invalid;
  answer.invalid_at = result.invalid_at;
  answer.counters = result.counters;
  return answer;
}

// Witnesses that were not requested are zero. If they are not, the answer shows them.
template <class Result>
void add_points(Answer& answer, const Result& result, Request request) {
  if (!asks_for(request, Request::witnesses) && result.point_a.isZero(0) && result.point_b.isZero(0)) return;
  answer.has_points = true;
  answer.point_a = widened(result.point_a);
  answer.point_b = widened(result.point_b);
}

template <Scalar S>
Answer of_overlap(const OverlapResult<S>& result, const Ask&) {
  Answer answer = begun(result, result.outcome);
  answer.normal = widened(result.normal);
  return answer;
}

template <Scalar S>
Answer of_distance(const DistanceResult<S>& result, const Ask& ask) {
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
Answer of_penetration(const PenetrationResult<S>& result, const Ask& ask) {
  Answer answer = begun(result, result.outcome);
  if (answer.outcome == Outcome::invalid_input) return answer;
  answer.normal = widened(result.normal);
  answer.stalled = result.stalled;
  if (answer.outcome == Outcome::initially_overlapping) {
    answer.depth = Interval{result.lower, result.upper};
    add_points(answer, result, ask.request);
  }
  return answer;
}
// Copies the part of an Ask that every search has.
template <Scalar S, class Options>
Options searching(Options options, const Ask& ask) {
  if constexpr (requires { options.tolerance; }) options.tolerance = static_cast<S>(ask.tolerance);
  if constexpr (requires { options.request; }) options.request = ask.request;
  if (ask.max_iterations != 0) options.max_iterations = ask.max_iterations;
  return options;
}

template <Scalar S>
LineOptions<S> line_options(const Case& c, const Ask& ask) {
  return searching<S>(LineOptions<S>{.target_distance = static_cast<S>(c.target_distance)}, ask);
}
template <Scalar S>
Answer of_line(const LineResult<S>& result, const Ask&) {
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
SweptOverlapOptions<S> swept_options(const Case& c, const Ask& ask, SweptMethod method = {}) {
  return searching<S>(SweptOverlapOptions<S>{.method = method,
                                             .t_max = static_cast<S>(c.t_max),
                                             .target_distance = static_cast<S>(c.target_distance)},
                      ask);
}
template <Scalar S>
Answer of_swept(const SweptOverlapResult<S>& result, const Ask&) {
  Answer answer = begun(result, result.outcome);
  answer.normal = widened(result.normal);
  return answer;
}

// Builds a method from a call with bodies of its scalar, and from a function that turns the result into an
// answer. Only the call is timed.
template <Scalar S, class Call, class Widen>
Method method_of(Query query, const char* name, const char* tier, const Call& call, const Widen& widen) {
  return {.kind = Kind::query,
          .query = query,
          .name = name,
          .scalar = std::same_as<S, float> ? "float" : "double",
          .tier = tier,
          .unit_roundoff = kUnitRoundoff<S>,
          .ask = [=](const Case& c,
                     const Ask& ask) { return widen(call(round_to<S>(c.a), round_to<S>(c.b), c, ask), ask); },
          .seen = &rounded_case<S>,
          .time_ns =
              [=](const Case& c, const Ask& ask, int repeats) {
                const Body<S> a = round_to<S>(c.a), b = round_to<S>(c.b);
                return median_ns([&] { return call(a, b, c, ask); }, repeats);
              }};
}

// An overlap and a swept overlap have nothing to ask for: their axis comes with the verdict. They have no
// tolerance, either, and tier exact needs none.
template <Scalar S>
void add_queries(std::vector<Method>& out) {
  using B = Body<S>;
  const auto add = [&](Query query, const char* name, const char* tier, auto call, auto widen) {
    out.push_back(method_of<S>(query, name, tier, call, widen));
  };
  const auto swept_by = [](SweptMethod method) {
    return [method](const B& a, const B& b, const Case& c, const Ask& ask) {
      return swept_overlap(a, b, swept_options<S>(c, ask, method));
    };
  };
  // The first of a query, in double, is its default.
  add(
      Query::overlap, "gjk", "standard",
      [](const B& a, const B& b, const Case&, const Ask&) { return overlap_gjk(a, b); }, &of_overlap<S>);
  add(
      Query::overlap, "mpr", "standard",
      [](const B& a, const B& b, const Case&, const Ask&) { return overlap_mpr(a, b); }, &of_overlap<S>);
  add(
      Query::distance, "gjk", "standard",
      [](const B& a, const B& b, const Case&, const Ask& ask) {
        return distance(a, b, searching<S>(DistanceOptions<S>{}, ask));
      },
      &of_distance<S>);
  add(
      Query::penetration, "epa", "standard",
      [](const B& a, const B& b, const Case&, const Ask& ask) {
        return penetration(a, b, searching<S>(PenetrationOptions<S>{}, ask));
      },
      &of_penetration<S>);
  add(
      Query::penetration_along, "mpr", "standard",
      [](const B& a, const B& b, const Case& c, const Ask& ask) {
        return penetration_along(a, b, round_to<S>(c.direction), searching<S>(PenetrationOptions<S>{}, ask));
      },
      &of_penetration<S>);
  add(
      Query::line, "mpr", "standard",
      [](const B& a, const B& b, const Case& c, const Ask& ask) {
        return line(a, b, line_options<S>(c, ask));
      },
      &of_line<S>);
  add(Query::swept_overlap, "gjk", "standard", swept_by(SweptMethod::gjk), &of_swept<S>);
  add(Query::swept_overlap, "mpr", "standard", swept_by(SweptMethod::mpr), &of_swept<S>);
  add(Query::swept_overlap, "before_after", "standard", swept_by(SweptMethod::before_after), &of_swept<S>);
  add(
      Query::overlap, "exact", "exact",
      [](const B& a, const B& b, const Case&, const Ask&) { return overlap_exact(a, b); }, &of_overlap<S>);
  add(
      Query::distance, "exact", "exact",
      [](const B& a, const B& b, const Case&, const Ask& ask) {
        return distance_exact(a, b, searching<S>(DistanceOptions<S>{}, ask));
      },
      &of_distance<S>);
  add(
      Query::line, "exact", "exact",
      [](const B& a, const B& b, const Case& c, const Ask& ask) {
        return line_exact(a, b, line_options<S>(c, ask));
      },
      &of_line<S>);
  add(
      Query::swept_overlap, "exact", "exact",
      [](const B& a, const B& b, const Case& c, const Ask& ask) {
        return swept_overlap_exact(a, b, swept_options<S>(c, ask));
      },
      &of_swept<S>);
}

}  // namespace

void add_query_methods(std::vector<Method>& out) {
  add_queries<double>(out);
#ifndef GRAZE_DOUBLE_ALONE  // half the compilation, for the trial of the laws
  add_queries<float>(out);
#endif
}

}  // namespace graze::engine
