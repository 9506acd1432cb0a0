// What the caller keeps of one step for the next: of each pair that was looked at the axis that parted it, or a few
// directions whose supports showed that it was in contact; and of bodies at rest what their overlap was.
//
//   Memory memory;
//   for (each step) report = run(scene, options, memory);
//
// A step that follows a step is much like it. A pair that missed is asked along its last axis first: where that
// parts the two for the whole step, proved with every rounding counted, the pair is a miss, and not cast. A pair that
// began in contact is, where the same directions still show it. The overlap of two bodies that rest as they did, to the
// bit, is the one that is known. All else is cast as without a memory, so the events are the same: times, normals and
// points to the bit. Only what an event says of how it was known, effects and reasons, is "nothing" where no cast was.
//
// A value: nothing is kept anywhere else. It may be of another scene, out of date or empty; a good one saves time. A
// body is known by its index. Copies are independent.
#pragma once

#include <graze/scene.hpp>

namespace graze::scene {

// Directions, in world axes, along which points of A - B lie whose hull, with the balls about them, holds the origin.
struct Touching {
  int size = 0;
  std::array<Vec3<double>, 4> direction;
};

class Memory {
 public:
  // Pairs of which something is known, and what that takes.
  [[nodiscard]] std::size_t pairs() const { return pairs_.size(); }
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
    Vec3<double> axis = Vec3<double>::Zero();  // unit, from a to b, in world axes; 0: none is known
    // Searches for an axis or for points of contact that found none: the next waits for as many casts.
    std::uint8_t failures = 0, wait = 0;
  };
  struct Resting {
    std::uint32_t index = 0;
    Body<double> body;
  };
  // What an overlap at rest depends on beside the bodies.
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

[[nodiscard]] Report run(const Scene& scene, const Options& options, Memory& memory);

// The scene as it stands at t, moving on as it does, whatever it meets: what a longer step is cut into. Poses are
// rounded; what does not move keeps every bit.
[[nodiscard]] Scene at_time(const Scene& scene, double t);

}  // namespace graze::scene
