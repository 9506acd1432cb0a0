// The methods that can be judged, in one list: whatever answers a question about a case. Ours are engines
// like any other.
//
// A question is of one of three kinds: a cast of bodies that do not turn, a cast of bodies that may, or one
// of the queries beside the cast. All are asked and answered through the same structures; what a kind does
// not know stays as it is by default.
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

// What kept an engine of others from answering at all (docs/reference/protocol.md has a sentence about each).
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

// An answer in doubles, whatever scalar computed it (a float is a double). Fields as in CastResult and
// RotatingResult; of the queries as their results have them. Zero vectors: not part of the answer.
struct Answer {
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;
  InvalidAt invalid_at = {};            // of an input that the library refused: where
  double toi_lower = 0, toi_upper = 0;  // of casts
  Vec3<double> normal = Vec3<double>::Zero(), point_a = Vec3<double>::Zero(), point_b = Vec3<double>::Zero();
  // Of engines of others with a margin: by how much their bodies, on which the witnesses lie, may reach beyond those of
  // the case as it is seen (lengths).
  double reach_a = 0, reach_b = 0;
  double distance = 0;       // of casts: of the bodies at toi_lower, at most, beyond the target distance
  bool passed_over = false;  // a miss by the start policy
  std::optional<Proof> proof = {};
  Counters counters = {};

  // Of casts of turning bodies.
  Plan plan = {};
  double hidden_motion = 0;  // of steps and spheres: what they may have missed (length)
  std::optional<RotatingProof> rotating_proof = {};

  // Of the queries. Absent: not part of the query, or of this outcome.
  std::optional<Interval> separation = {}, depth = {};  // brackets of distance and penetration depth, lengths
  std::optional<Interval> t_in = {}, t_out = {};        // of the ends of {t : the bodies touch at t}
  Vec3<double> normal_out = Vec3<double>::Zero();  // of a line: where it leaves; `normal` is where it enters
  bool has_points = false;                         // witnesses were asked for and found
  bool stalled = false;                            // the bracket is wider than was asked for

  // Of engines of others.
  Failure failure = Failure::none;  // then nothing else of the answer means anything, but what follows
  std::string message = {};         // of a failure: what happened; else what the engine wants said
  bool declined = false;            // the engine says that the question is none for it
  std::optional<double> ns = {};    // what its own repeated call took
  bool native = true;               // in machine code

  [[nodiscard]] bool has_normal() const { return normal != Vec3<double>::Zero(); }
};

// The answer to a question that no method of this kind takes: invalid_input, and no reason of the library.
[[nodiscard]] Answer not_taken();

struct Ask {
  Request request = Request::verdict;
  double tolerance = 0;    // over scale; 0: the least that the tier reaches
  int max_iterations = 0;  // 0: the method's default
  // Of casts of turning bodies.
  int time_steps = 0;             // 0: the default
  std::optional<Tier> tier = {};  // another than the method's
  Economies economies = {};       // of the plan
};

// What the answers of a method hold beside their outcome.
struct Holds {
  bool time = true, normal = true, witnesses = true;
};

// What a caller gets by default.
inline constexpr Request kPlain = Request::normal | Request::witnesses;

// A case in the terms of an engine of others, formed once for all that is done with it.
struct EngineView {
  std::string refused = {};    // why it is not asked; empty if it is, and then the rest holds
  bool beyond_limits = false;  // it lies beyond a limit that the engine documents
  corpus::Case seen = {};
  std::function<Answer(const Ask&)> ask = nullptr;  // while the engine lives
};

struct Method {
  Kind kind = Kind::linear;
  corpus::Query query = corpus::Query::cast;  // what it is asked
  std::string name;    // "ca", "gjk", "mpr", "epa", "bilateral", "plan", "certified", "exact", ...
  std::string scalar;  // "float", "double"
  std::string tier;    // "standard", "certified", "exact"
  double unit_roundoff = 0;
  Holds holds = {};
  bool asks_starts = true;  // false: starts in contact are no questions for it
  // A case for which unsupported() says something comes back as not_taken().
  std::function<Answer(const corpus::Case&, const Ask&)> ask = nullptr;
  // The case as this method sees it: every number rounded to its scalar. Proofs and guarantees are about it.
  std::function<corpus::Case(const corpus::Case&)> seen = nullptr;
  // Of engines of others: why a case is not asked; empty if it is. nullptr: every case is.
  std::function<std::string(const corpus::Case&)> refuses = nullptr;
  // Of engines of others: that, `seen` and `ask` at once.
  std::function<EngineView(const corpus::Case&)> engine_view = nullptr;
  // Prepares a case once (shapes built in the method's scalar) and returns the nanoseconds that one call
  // takes, the median over `repeats` timed batches; NaN: not known. nullptr: of engines that time nothing.
  std::function<double(const corpus::Case&, const Ask&, int repeats)> time_ns = nullptr;
  // Of casts of turning bodies: what they would simulate.
  std::function<Plan(const corpus::Case&, const Ask&)> plan = nullptr;
  // What it promises; nullptr: nothing.
  const Guarantee* guarantee = nullptr;

  // Asked for what a caller gets by default.
  [[nodiscard]] Answer answer(const corpus::Case& problem, double tolerance = 0) const {
    return ask(problem, {.request = kPlain, .tolerance = tolerance});
  }
  [[nodiscard]] std::string full_name() const { return name + "/" + scalar; }
  // The same with what it is asked before it: "gjk/double", "distance gjk/double", "rotating plan/double".
  [[nodiscard]] std::string question_name() const;
  [[nodiscard]] bool is_exact() const { return tier == "exact"; }
  [[nodiscard]] bool is_certified() const { return tier == "certified"; }
  // One of ours, not an engine of others.
  [[nodiscard]] bool is_ours() const { return refuses == nullptr; }
  [[nodiscard]] bool in_float() const { return scalar == "float"; }
};

// What in a case no method of a kind answers ("a rotating motion", ...); empty when all of them do. Of the
// queries by that of the case: what is asked of t = 0 sees no turn.
[[nodiscard]] std::string unsupported(Kind kind, const corpus::Case& problem);

// Every method, kind by kind; of a kind those in double first.
[[nodiscard]] std::span<const Method> methods();
[[nodiscard]] std::span<const Method> methods(Kind kind);
// By "mpr" (in double), "mpr/double", ...: nullptr if there is none.
[[nodiscard]] const Method* find_method(Kind kind, std::string_view name);
// Of a query beside the cast.
[[nodiscard]] const Method* find_method(corpus::Query query, std::string_view name);

[[nodiscard]] std::string_view to_text(Kind kind);

// Whether a case, as a method of tier exact sees it, is one that the tier answers; from any other it hands
// back invalid_input with Invalid::not_exact. Written from the documentation of the tier, not from its code:
// points, segments, triangles, boxes, hulls, spheres, capsules, posed, summed and rounded, at any target distance.
[[nodiscard]] bool is_exact_question(const corpus::Case& seen);
// Of these: whether the answer has a proof. Those of rounded shapes and of target distances have none.
[[nodiscard]] bool has_exact_proof(const corpus::Case& seen);

// Is a body given a rotation, seen or not?
[[nodiscard]] bool turns(const corpus::Case& problem);

}  // namespace graze::engine
