// The queries beside the cast, by name: what `graze cast` runs for a case whose query is not cast.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "corpus/case.hpp"

namespace graze::engine {

struct Interval {
  double lower = 0, upper = 0;
};

// An answer in doubles, whatever scalar computed it. Absent: not part of the query, or of this outcome.
struct QueryAnswer {
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  std::optional<Interval> distance, depth;  // length
  std::optional<Interval> t_in, t_out;      // brackets of the ends of {t : the bodies touch at t}
  std::optional<Vec3<double>> normal, point_a, point_b;
  std::optional<Vec3<double>> normal_out;  // of a line: where it leaves; `normal` is where it enters
  bool stalled = false;                    // the bracket is wider than was asked for
  Counters counters;
};

struct QueryAsk {
  // A request alone is asked without a tolerance.
  QueryAsk(Request wanted, double within = 0) : request(wanted), tolerance(within) {}

  Request request;
  double tolerance;  // over scale; 0: the method's rounding bound
};

struct QueryMethod {
  corpus::Query query;
  std::string name;    // "gjk", "mpr", "epa", ..., "exact"
  std::string scalar;  // "float", "double"
  std::string tier;    // "standard", "exact"
  // An overlap and a swept overlap have nothing to ask for: their axis comes with the verdict. They have no
  // tolerance, either, and tier exact needs none.
  QueryAnswer (*ask)(const corpus::Case&, const QueryAsk&);

  [[nodiscard]] QueryAnswer answer(const corpus::Case& problem, double tolerance = 0) const {
    return ask(problem, {Request::normal | Request::witnesses, tolerance});
  }
  [[nodiscard]] std::string full_name() const { return name + "/" + scalar; }
  [[nodiscard]] bool is_exact() const { return tier == "exact"; }
};

// The first of a query, in double, is its default.
[[nodiscard]] std::span<const QueryMethod> query_methods();

// What in a case no method here answers ("a rotating motion" along whose path is asked); empty when all of
// its query do. What is asked of t = 0 sees no turn.
[[nodiscard]] std::string unsupported_query(const corpus::Case& problem);

}  // namespace graze::engine
