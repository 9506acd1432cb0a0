// The methods that can be judged, in one list: whatever answers a question about a case. Ours are engines
// like any other.
//
// A question is of one of three kinds: a linear cast, a rotating cast, or one of the queries other than casts. All
// kinds use the same structures for questions and answers. Fields that a kind does not use keep their defaults.
#pragma once

#include <functional>
#include <graze/rotating_result.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/case.hpp"

namespace graze::engine {

struct Guarantee;  // engines/guarantees.hpp

enum class Kind { linear, query, rotating };

struct Interval {
  double lower = 0, upper = 0;
};

// The reason why a third-party engine gave no answer at all (docs/reference/protocol.md describes each).
enum class Failure : std::uint8_t {
  none,
  crashed,
  hung,
  silent,
  half_a_line,
  garbage,
  wrong_id,
  non_finite,
  out_of_range,
  out_of_memory,
  orphaned_process,
};
inline constexpr std::size_t kFailures = 11;
[[nodiscard]] std::string_view to_text(Failure failure);

// An answer in doubles, whatever scalar computed it (a float is a double). The fields are those of CastResult,
// RotatingResult and the results of the queries. A zero vector is not part of the answer.
struct Answer {
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  InvalidAt invalid_at = {};            // the place of an input that the library refused
  double toi_lower = 0, toi_upper = 0;  // for casts
  Vec3<double> normal = Vec3<double>::Zero(), point_a = Vec3<double>::Zero(), point_b = Vec3<double>::Zero();
  // For third-party engines with a margin: the lengths by which their bodies, on which the witnesses lie, may reach
  // beyond those of the case as the engine sees it.
  double reach_a = 0, reach_b = 0;
  double distance = 0;       // for casts: upper bound at toi_lower, beyond the target distance
  bool passed_over = false;  // a miss by the start policy
  std::optional<Proof> proof = {};
  Counters counters = {};

  // Fields of rotating casts.
  Plan plan = {};
  double hidden_motion = 0;  // for steps and spheres: the length they may have missed
  std::optional<RotatingProof> rotating_proof = {};

  // Fields of the queries. Absent: not part of the query, or of this outcome.
  std::optional<Interval> separation = {}, depth = {};  // brackets of distance and penetration depth, lengths
  std::optional<Interval> t_in = {}, t_out = {};        // brackets of the ends of {t : the bodies touch at t}
  Vec3<double> normal_out = Vec3<double>::Zero();       // for a line: at the exit, `normal` is at the entry
  bool has_points = false;                              // witnesses were asked for and found
  bool stalled = false;                                 // the bracket is wider than was asked for

  // Fields of third-party engines.
  Failure failure = Failure::none;  // if set, only the following fields are valid
  std::string message = {};         // the description of a failure, else the engine's own message
  bool declined = false;            // the engine does not support the question
  std::optional<double> ns = {};    // time of a call, measured by the engine
  bool native = true;               // in machine code

  [[nodiscard]] bool has_normal() const { return normal != Vec3<double>::Zero(); }
};

// The answer to a question that no method of this kind takes: invalid_input, and no reason of the library.
[[nodiscard]] Answer not_taken();

struct Ask {
  Request request = Request::verdict;
  double tolerance = 0;    // over scale, 0 for the least that the tier reaches
  int max_iterations = 0;  // 0: the method's default
  // Fields of rotating casts.
  int time_steps = 0;             // 0: the default
  std::optional<Tier> tier = {};  // another than the method's
  Economies economies = {};       // for the plan
};

// The parts of an answer, beside the outcome, that a method computes.
struct Holds {
  bool time = true, normal = true, witnesses = true;
};

// The default request of a caller.
inline constexpr Request kPlain = Request::normal | Request::witnesses;

// A case in the terms of a third-party engine, formed once for all its uses.
struct EngineView {
  std::string refused = {};    // why it is not asked, empty if the other fields are valid
  bool beyond_limits = false;  // it lies beyond a limit that the engine documents
  corpus::Case seen = {};
  std::function<Answer(const Ask&)> ask = nullptr;  // while the engine lives
};

struct Method {
  Kind kind = Kind::linear;
  corpus::Query query = corpus::Query::cast;  // the query it answers
  std::string name;    // "ca", "gjk", "mpr", "epa", "bilateral", "plan", "certified", "exact", ...
  std::string scalar;  // "float", "double"
  std::string tier;    // "standard", "certified", "exact"
  double unit_roundoff = 0;
  Holds holds = {};
  bool asks_starts = true;  // false if starts in contact are not questions for it
  // A case for which unsupported() is not empty returns not_taken().
  std::function<Answer(const corpus::Case&, const Ask&)> ask = nullptr;
  // The case as this method sees it: every number rounded to its scalar. Proofs and guarantees are about it.
  std::function<corpus::Case(const corpus::Case&)> seen = nullptr;
  // For third-party engines: why a case is not asked, empty if it is. nullptr: every case is asked.
  std::function<std::string(const corpus::Case&)> refuses = nullptr;
  // For third-party engines: `refuses`, `seen` and `ask` in one call.
  std::function<EngineView(const corpus::Case&)> engine_view = nullptr;
  // Prepares a case once (with shapes in the method's scalar) and returns the nanoseconds that one call takes, as the
  // median over `repeats` timed batches. NaN if the time is not known. nullptr for engines that time nothing.
  std::function<double(const corpus::Case&, const Ask&, int repeats)> time_ns = nullptr;
  // For rotating casts: the plan of the simulation.
  std::function<Plan(const corpus::Case&, const Ask&)> plan = nullptr;
  // The method's guarantee, or nullptr if it promises nothing.
  const Guarantee* guarantee = nullptr;

  // The answer to a caller's default request.
  [[nodiscard]] Answer answer(const corpus::Case& problem, double tolerance = 0) const {
    return ask(problem, {.request = kPlain, .tolerance = tolerance});
  }
  [[nodiscard]] std::string full_name() const { return name + "/" + scalar; }
  // The same with the query in front: "gjk/double", "distance gjk/double", "rotating plan/double".
  [[nodiscard]] std::string question_name() const;
  [[nodiscard]] bool is_exact() const { return tier == "exact"; }
  [[nodiscard]] bool is_certified() const { return tier == "certified"; }
  // True for methods of graze, false for third-party engines.
  [[nodiscard]] bool is_ours() const { return refuses == nullptr; }
  [[nodiscard]] bool in_float() const { return scalar == "float"; }
};

// The part of a case that no method of this kind supports ("a rotating motion", ...), or empty if all methods support
// it. For queries it depends on the query of the case, because a query about t = 0 ignores rotation.
[[nodiscard]] std::string unsupported(Kind kind, const corpus::Case& problem);

// Every method, kind by kind. Within a kind the methods in double come first.
[[nodiscard]] std::span<const Method> methods();
[[nodiscard]] std::span<const Method> methods(Kind kind);
// The method named "mpr" (in double), "mpr/double", ..., or nullptr if there is no such method.
[[nodiscard]] const Method* find_method(Kind kind, std::string_view name);
// The same for a query other than the cast.
[[nodiscard]] const Method* find_method(corpus::Query query, std::string_view name);

[[nodiscard]] std::string_view to_text(Kind kind);

// True if tier exact answers this case, as a method of the tier sees it. For any other case the tier returns
// invalid_input with Invalid::not_exact. This is written from the documentation of the tier and not from its code:
// points, segments, triangles, boxes, hulls, spheres, capsules, posed, summed and rounded, at any target distance, and
// exact rays.
[[nodiscard]] bool is_exact_question(const corpus::Case& seen);
// True for the cast of a point at an ellipsoid, a cylinder or a cone, without a target distance.
[[nodiscard]] bool is_exact_ray(const corpus::Case& seen);
// True for exact questions without rounded shapes and target distances.
[[nodiscard]] bool is_sharp_question(const corpus::Case& seen);

// Is a body given a rotation, seen or not?
[[nodiscard]] bool turns(const corpus::Case& problem);

}  // namespace graze::engine
