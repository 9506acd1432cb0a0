// A run's side of a Memory: what it says of a pair, what the run adds, and what the next step is handed.
#pragma once

#include <graze/scene/memory.hpp>

#include "apart.hpp"
#include "candidates.hpp"
#include "events.hpp"

namespace graze::scene {

// What was found about one pair, and by what.
struct Looked {
  enum class How : std::uint8_t { moot, cast, kept, parted };
  How how = How::moot;
  std::optional<Answer> answer;  // of a cast
  const Event* kept = nullptr;   // of bodies that rest as they did, in contact
  Memory::Pair next;             // what the next step may know of it
  Counters counters;             // beside the answer's
};

class Recall {
 public:
  Recall(const Scene& scene, const Options& options, Memory& memory);

  // Over [0, until]. Reads only, so that many threads may look at once.
  [[nodiscard]] Looked look(const Candidate& pair, double until) const;
  // A pair that nobody looks at.
  [[nodiscard]] Looked pass_over(const Candidate& pair) const;
  // What the next step is to know of the pair; in the order of the pairs.
  void keep(const Looked& looked);
  // The memory is now of this step.
  void end();

 private:
  [[nodiscard]] Memory::Pair known(const Candidate& pair) const;
  [[nodiscard]] StepLimits limits(double until) const {
    return {until, options_.target_distance, options_.tolerance};
  }
  void learn(const Candidate& pair, double until, Looked& looked) const;
  void index();

  const Scene& scene_;
  const Options& options_;
  Memory& memory_;
  Memory::Settings settings_;
  std::vector<char> rests_as_it_did_;  // of each body
  std::vector<Memory::Pair> pairs_;    // of this step
  std::vector<Event> events_;
};

}  // namespace graze::scene
