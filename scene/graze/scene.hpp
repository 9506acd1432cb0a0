/// @file
/// Scenes: many bodies over one step, and rays and casts among them. Finds the first contacts of each body and their
/// times.
///
/// run() returns the events in the order of time, and what was simulated for them. plan() returns what run() would
/// simulate, pair by pair, and why. Bodies are in world axes, the caller's units and radians, in double. The step is
/// t in [0, Options::t_max].
///
/// Skipped work never changes a verdict: with every economy off the verdicts are the same, and brackets meet. A law
/// of the tests holds this.
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

/// The filter of the pairs that may meet: each one's group must have a bit of the other's mask.
struct Filter {
  std::uint32_t group = 1;                 ///< The bits of this body. By default everything meets.
  std::uint32_t mask = ~std::uint32_t{0};  ///< The bits of those that it may meet.

  /// True if the two may meet.
  [[nodiscard]] bool meets(const Filter& other) const {
    return (group & other.mask) != 0 && (other.group & mask) != 0;
  }
};

/// A body of a scene.
struct Member {
  std::string name = {};      ///< Empty, or unique. Events at one time are ordered by it, then by the index.
  RotatingBody<double> body;  ///< Shape, pose and motion.
  Filter filter = {};         ///< The bodies and probes that it may meet.
};

/// A shape that moves among the bodies as they stand at t = 0. A ray is the cast of a point.
///
/// A probe that neither moves nor rotates is answered as an overlap query at its start, whatever its `t_max`. So you
/// can pass the casts of objects that stand still.
struct Probe {
  std::string name = {};      ///< Empty, or unique.
  RotatingBody<double> body;  ///< Shape, pose and motion.
  double t_max = 1;           ///< The end of the cast. It is finite if the probe rotates.
  Filter filter = {};         ///< The bodies that it may meet.
  /// True for its first contact only, and those that may be first. Else one for each body.
  bool first_only = true;
};
/// The probe of a ray from `origin`, along `displacement` for each unit of t. By default it has no end.
[[nodiscard]] Probe ray(std::string name, const Vec3<double>& origin, const Vec3<double>& displacement,
                        double t_max = kInfinity<double>);

/// Bodies, and probes among them.
struct Scene {
  std::vector<Member> bodies;  ///< The bodies, in any order.
  std::vector<Probe> probes;   ///< The rays and casts among them.
};

/// The events to find. Only the first contact of a pair is an event.
enum class Ask : std::uint8_t {
  verdict,  ///< Does anything touch? The run ends with the first contact that is found.
  first,    ///< The first event of the scene, and those that may be first by their brackets.
  body,     ///< The first event of each body, likewise.
  pair,     ///< The event of each pair: all events.
};
/// The number of enumerators of Ask.
inline constexpr int kAsks = 4;
/// The enumerator's name.
[[nodiscard]] constexpr std::string_view to_text(Ask ask) {
  constexpr std::string_view kNames[kAsks] = {"verdict", "first", "body", "pair"};
  return static_cast<int>(ask) < kAsks ? kNames[static_cast<int>(ask)] : std::string_view{};
}

/// A callback: so many of so many pairs are done. Return false to stop the run, which then returns what is known.
using Progress = std::function<bool(std::uint64_t done, std::uint64_t total)>;

/// The options of a run.
struct Options {
  Tier tier = Tier::standard;                              ///< Guarantee of each event.
  Ask ask = Ask::pair;                                     ///< The events to find.
  Request request = Request::normal | Request::witnesses;  ///< The results to compute.
  double t_max = 1;                                        ///< The end of the step. Finite.
  double target_distance = 0;  ///< A length: contact is when the distance reaches it.
  double tolerance = 0;        ///< The requested width of a bracket, over the scale of its pair.
  Economies economies = {};    ///< Steps that may be skipped.
  unsigned threads = 1;        ///< The number of threads. The answer does not depend on it.
  /// The most pairs that may be looked at. A scene whose n bodies are all in one spot has n^2/2 pairs. It is refused
  /// before anything is cast.
  std::uint64_t most_pairs = 16'000'000;
  Progress progress = {};  ///< Called between parts of the run, if set.
};

/// The proof of an event: that of a linear cast, or that of a rotating one.
struct EventProof {
  std::optional<Proof> linear;            ///< The proof of a linear cast.
  std::optional<RotatingProof> rotating;  ///< The proof of a rotating cast.
};

/// The first contact of a pair, as graze::cast of that pair returns it.
struct Event {
  std::uint32_t a = 0;  ///< The index of a body, or for a probe's event that of the probe.
  std::uint32_t b = 0;  ///< The index of the other body. For two bodies, a < b.
  /// hit, initially_overlapping, or not_converged: the pair may touch, and the bracket is what is known.
  Outcome outcome = Outcome::not_converged;
  double toi_lower = 0;  ///< The lower end of the bracket of the time of impact.
  double toi_upper = 0;  ///< The upper end.
  /// As in RotatingResult. It is infinite if the cast refused the pair (Invalid::too_complex), which is then open.
  double distance = 0;
  Effects effects = Effects::linear;           ///< The effects that were simulated.
  std::uint16_t reasons = 0;                   ///< Why, as in graze::Plan.
  Vec3<double> normal = Vec3<double>::Zero();  ///< If requested: unit, from a to b, world axes.
  /// If requested: the contact point of a at `toi_lower`, in world coordinates.
  Vec3<double> point_a = Vec3<double>::Zero();
  Vec3<double> point_b = Vec3<double>::Zero();  ///< That of b.
  std::shared_ptr<const EventProof> proof;      ///< If requested, and if there is one.
};

/// How a run ended.
enum class Status : std::uint8_t {
  complete,     ///< All pairs are done.
  interrupted,  ///< Options::progress stopped it. The events are those of the pairs that were done.
  over_budget,  ///< There are more than Options::most_pairs pairs to look at. Nothing was cast.
  invalid,      ///< The scene or the options are refused. Report::wrong says where.
};
/// The enumerator's name.
[[nodiscard]] constexpr std::string_view to_text(Status status) {
  constexpr std::string_view kNames[] = {"complete", "interrupted", "over_budget", "invalid"};
  return static_cast<std::size_t>(status) < 4 ? kNames[static_cast<std::size_t>(status)] : std::string_view{};
}

/// Seconds by the wall clock. Nothing else in a report depends on timing.
struct Times {
  double bounds = 0;  ///< For the bounds and their tree.
  double casts = 0;   ///< For the casts.
};

/// The answer of a run.
struct Report {
  Status status = Status::invalid;  ///< How the run ended.
  std::string wrong;                ///< For invalid and over_budget: the reason, in one line.
  std::vector<Event> events;        ///< By toi_lower, then toi_upper, then the names of a and b.
  /// Those of the first probe, then of the second, and so on, each as above.
  std::vector<Event> probe_events;
  Counts counts;               ///< How many pairs were simulated or skipped, and why.
  Counters counters;           ///< The work of all casts.
  std::size_t tree_bytes = 0;  ///< The memory that the bounds and their tree took.
  Times times;                 ///< How long it took.
};

/// Finds the events of a scene over one step.
///
/// An event has the guarantee of the requested tier. Its answer is that of graze::cast of the pair. Nothing throws
/// except allocations, and nothing is global. The answer is the same to the bit with any number of threads. For n
/// bodies with few contacts, the search for pairs takes O(n log n) time and some 200 bytes a body.
///
/// @code
/// graze::scene::Scene scene;
/// const graze::Body<double> floor{.shape = graze::Box<double>{{9, 9, 1}}, .position = {0, 0, -1}};
/// scene.bodies.push_back({.name = "floor", .body = {.body = floor}});
/// for (int k = 1; k <= 3; ++k) {
///   const graze::Body<double> ball{
///       .shape = graze::Sphere<double>{0.5}, .position = {2.0 * k, 0, 0.5 + k}, .displacement = {0, 0, -2}};
///   scene.bodies.push_back({.name = "ball " + std::to_string(k), .body = {.body = ball}});
/// }
/// scene.probes.push_back(graze::scene::ray("down", {2, 0, 9}, {0, 0, -1}));
///
/// const graze::scene::Report report = graze::scene::run(scene);
/// assert(report.status == graze::scene::Status::complete);
/// assert(report.events.size() == 2 && scene.bodies[report.events[0].b].name == "ball 1");  // ball 3 is 1 too high
/// assert(std::abs(report.events[0].toi_lower - 0.5) < 1e-12);
/// assert(scene.bodies[report.probe_events[0].b].name == "ball 1");
/// @endcode
[[nodiscard]] Report run(const Scene& scene, const Options& options = {});

/// The answer of plan().
struct Planned {
  std::string wrong;            ///< Why the scene or the options are refused. Empty if they are not.
  std::vector<PairPlan> pairs;  ///< The pairs that are simulated, by (a, b).
  Counts counts;                ///< How many pairs would be simulated or skipped, and why.
};
/// Returns the plan of run(), pair by pair. For Ask::verdict, first and body it names the pairs that may have to be
/// looked at. An earlier event makes some of them unnecessary, but this is not known before that event is cast.
///
/// @code
/// graze::scene::Scene scene;
/// scene.bodies.push_back({.body = {.body = {.shape = graze::Sphere<double>{1}}, .rotation = {0, 0, 300}}});
/// scene.bodies.push_back({.body = {.body = {.shape = graze::Sphere<double>{1}, .displacement = {1, 0, 0}}}});
/// const graze::scene::Planned planned = graze::scene::plan(scene);
/// assert(planned.pairs.size() == 1 && planned.pairs[0].plan.effects == graze::Effects::linear);
/// @endcode
[[nodiscard]] Planned plan(const Scene& scene, const Options& options = {});

/// Why run() would refuse the scene, in one line that names the body and the field. Empty if it would not.
///
/// @code
/// graze::scene::Scene scene;
/// scene.bodies.push_back({.name = "ball", .body = {.body = {.shape = graze::Sphere<double>{-1}}}});
/// assert(graze::scene::why_invalid(scene, {}).find("radius") != std::string::npos);
/// @endcode
[[nodiscard]] std::string why_invalid(const Scene& scene, const Options& options);

}  // namespace graze::scene
