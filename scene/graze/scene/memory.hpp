/// @file
/// Memories: what a caller keeps of one step of a scene for the next, to save casts.
#pragma once

#include <graze/scene.hpp>

namespace graze::scene {

/// @cond
// Directions, in world axes, along which points of A - B lie whose hull, with the balls about them, holds the origin.
struct Touching {
  int size = 0;
  std::array<Vec3<double>, 4> direction;
};
/// @endcond

/// Knowledge about the pairs after a step: the axis that separated a pair, a few directions whose support points
/// showed contact, or for bodies at rest their overlap.
///
/// A step is much like the one before. A pair that missed is tested along its last axis first. If that separates the
/// two for the whole step, proved with every rounding counted, the pair is a miss without a cast. Likewise for a pair
/// that begins in contact, and for two bodies that rest as they did, to the bit. Everything else is cast as without a
/// memory. So the events are the same: times, normals and points to the bit. Only the effects and reasons of an event
/// that needed no cast differ.
///
/// A memory is a value. It may be empty, out of date or of another scene. A good one saves time, and none changes an
/// answer. A body is known by its index.
class Memory {
 public:
  /// The number of pairs of which something is known.
  [[nodiscard]] std::size_t pairs() const { return pairs_.size(); }
  /// The memory that it takes.
  [[nodiscard]] std::size_t bytes() const {
    return pairs_.capacity() * sizeof(Pair) + slots_.capacity() * sizeof(std::uint32_t) +
           touching_.capacity() * sizeof(Touching) + resting_.capacity() * sizeof(Resting) +
           events_.capacity() * sizeof(Event);
  }

 private:
  friend class Recall;
  friend struct Looked;

  static constexpr std::uint32_t kNothing = ~std::uint32_t{0}, kMiss = kNothing - 1;
  struct Pair {
    std::uint32_t a = 0, b = 0;                // a < b
    std::uint32_t answer = kNothing;           // of bodies at rest: kMiss, or an index of events_
    std::uint32_t touching = kNothing;         // an index of touching_
    Vec3<double> axis = Vec3<double>::Zero();  // unit, from a to b, in world axes, or 0 if not known
    // Searches for an axis or for points of contact that found none: the next waits for as many casts.
    std::uint8_t failures = 0, wait = 0;
  };
  struct Resting {
    std::uint32_t index = 0;
    Body<double> body;
  };
  // The inputs of an overlap at rest beside the bodies.
  struct Settings {
    Tier tier = Tier::standard;
    Request request = Request::verdict;
    double target_distance = 0, tolerance = 0;
    Economies economies;
    friend bool operator==(const Settings&, const Settings&) = default;
  };

  std::vector<Pair> pairs_;
  std::vector<std::uint32_t> slots_;  // a table of pairs_ by (a, b), open addressing
  std::vector<Touching> touching_;
  std::vector<Resting> resting_;  // by index
  std::vector<Event> events_;
  Settings settings_;
};

/// run() with a memory of the step before, which it updates.
///
/// @code
/// graze::scene::Scene scene;
/// const graze::Body<double> ball{.shape = graze::Sphere<double>{1}};
/// const graze::Body<double> other{
///     .shape = graze::Sphere<double>{1}, .position = {2.5, 2.5, 0}, .displacement = {-1, 1, 0}};
/// scene.bodies = {{.body = {.body = ball}}, {.body = {.body = other}}};
/// graze::scene::Memory memory;
/// for (int step = 0; step < 2; ++step) {
///   const graze::scene::Report report = graze::scene::run(scene, {}, memory);
///   assert(report.events.empty());
/// }
/// @endcode
[[nodiscard]] Report run(const Scene& scene, const Options& options, Memory& memory);

/// The scene as it is at time t if nothing stops its bodies, for cutting a longer step into parts. Poses are rounded.
/// Bodies that do not move keep every bit.
[[nodiscard]] Scene at_time(const Scene& scene, double t);

}  // namespace graze::scene
