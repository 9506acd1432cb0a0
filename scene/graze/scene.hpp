// A scene: many bodies over one step, and rays and casts among them. Which first touch which, and when?
//
//   run(scene, options)  = the events, in the order of time, and the plan: what was simulated, what was spared.
//   plan(scene, options) = what run would simulate, pair by pair, and why.
//
// Bodies in world axes, the caller's units, radians, in double (rotating_body.hpp); the step is t in
// [0, options.t_max]. An event is the first contact of a pair, answered by graze::cast of that pair in the
// tier that is asked for, with its guarantee. Rays and casts move among the bodies as these stand at t = 0.
//
// What a scene spares never changes a verdict: with every economy off the verdicts are the same and brackets
// meet (docs/reference/scenes.md says which law holds this, and how it is tried).
//
// Nothing throws but what allocates; nothing is global; the answer is the same to the bit in any number of
// threads.
#pragma once

#include <functional>
#include <graze/cast.hpp>
#include <graze/rotating_cast.hpp>
#include <graze/scene/economies.hpp>
#include <graze/scene/plan.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace graze::scene {

// Who may meet whom: each one's group must have a bit of the other's mask.
struct Filter {
  std::uint32_t group = 1, mask = ~std::uint32_t{0};

  [[nodiscard]] bool meets(const Filter& other) const {
    return (group & other.mask) != 0 && (other.group & mask) != 0;
  }
};

struct Member {
  std::string name;  // empty, or its own; events at one time are ordered by it, then by the index
  RotatingBody<double> body;
  Filter filter = {};
};

// A shape that moves among the bodies as they stand at t = 0. A ray is the cast of a point. A probe that neither moves
// nor rotates is answered as an overlap question at its start, whatever its t_max: a caller need not sort out the
// casts of objects that stand still. If it rotates, t_max is finite.
struct Probe {
  std::string name;
  RotatingBody<double> body;
  double t_max = 1;
  Filter filter = {};
  bool first_only = true;  // only its first contact, and what may be first; else each body's that it meets
};
// From origin, along displacement for each unit of t; by default without an end.
[[nodiscard]] Probe ray(std::string name, const Vec3<double>& origin, const Vec3<double>& displacement,
                        double t_max = kInfinity<double>);

struct Scene {
  std::vector<Member> bodies;
  std::vector<Probe> probes;
};

// Of the pairs of bodies. A pair's later contacts, after its first, are nobody's event.
enum class Ask : std::uint8_t {
  verdict,  // does anything touch? Ends with the first contact that is found
  first,    // the first event of the scene, and those that may be first as far as their brackets tell
  body,     // the first event of each body, likewise
  pair,     // of each pair: all events
};
inline constexpr int kAsks = 4;
[[nodiscard]] constexpr std::string_view to_text(Ask ask) {
  constexpr std::string_view kNames[kAsks] = {"verdict", "first", "body", "pair"};
  return static_cast<int>(ask) < kAsks ? kNames[static_cast<int>(ask)] : std::string_view{};
}

// So many of so many pairs are done. False: stop, and return what is known.
using Progress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

struct Options {
  Tier tier = Tier::standard;
  Ask ask = Ask::pair;
  Request request = Request::normal | Request::witnesses;
  double t_max = 1;            // of the step; finite
  double target_distance = 0;  // contact is when the distance reaches this (length)
  double tolerance = 0;        // of a bracket's width, over a pair's scale (RotatingOptions)
  Economies economies = {};
  unsigned threads = 1;
  // Pairs that may be looked at. A scene whose bodies are all in one spot has n^2/2: it is refused in less
  // than a second, and not begun.
  std::uint64_t most_pairs = 16'000'000;
  Progress progress = {};
};

// A pair's proof: of its linear cast, or of its rotating one.
struct EventProof {
  std::optional<Proof> linear;
  std::optional<RotatingProof> rotating;
};

struct Event {
  std::uint32_t a = 0, b = 0;  // indices: bodies a < b; of a probe's event the probe and the body
  // hit, initially_overlapping, or not_converged: it may touch, and the bracket is what is known.
  Outcome outcome = Outcome::not_converged;
  double toi_lower = 0, toi_upper = 0;
  // As in RotatingResult. Infinite if core refused the pair (too_complex), which is then open.
  double distance = 0;
  Effects effects = Effects::linear;
  std::uint16_t reasons = 0;  // as in graze::Plan
  Vec3<double> normal = Vec3<double>::Zero();
  Vec3<double> point_a = Vec3<double>::Zero(), point_b = Vec3<double>::Zero();
  std::shared_ptr<const EventProof> proof;  // when asked for, and there is one
};

enum class Status : std::uint8_t {
  complete,
  interrupted,  // by options.progress: the events are those of the pairs that were done
  over_budget,  // more than most_pairs pairs to look at: nothing was cast
  invalid,      // the scene or the options: Report::wrong says where
};
[[nodiscard]] constexpr std::string_view to_text(Status status) {
  constexpr std::string_view kNames[] = {"complete", "interrupted", "over_budget", "invalid"};
  return static_cast<std::size_t>(status) < 4 ? kNames[static_cast<std::size_t>(status)] : std::string_view{};
}

// Seconds by the wall clock; nothing else here depends on timing.
struct Times {
  double bounds = 0, casts = 0;
};

struct Report {
  Status status = Status::invalid;
  std::string wrong;                // invalid, over_budget: one line
  std::vector<Event> events;        // by toi_lower, then toi_upper, then the names of a and b
  std::vector<Event> probe_events;  // the first probe's, the second's, ..., each as above
  Counts counts;
  Counters counters;
  std::size_t tree_bytes = 0;  // what the bounds and their tree took
  Times times;
};

[[nodiscard]] Report run(const Scene& scene, const Options& options = {});

// What run would simulate, pair by pair; `wrong` as there. Of Ask::verdict, first and body it names the pairs
// that may have to be looked at: which of them an earlier event spares is not known before that is cast.
struct Planned {
  std::string wrong;
  std::vector<PairPlan> pairs;  // those that are simulated, by (a, b)
  Counts counts;
};
[[nodiscard]] Planned plan(const Scene& scene, const Options& options = {});

// What is wrong with it, in one line that names the body and the field; empty if nothing is.
[[nodiscard]] std::string why_invalid(const Scene& scene, const Options& options);

}  // namespace graze::scene
