// A run's side of a Memory: its data about a pair, the additions of the run, and the data for the next step.
#pragma once

#include <graze/scene/memory.hpp>

#include "apart.hpp"
#include "candidates.hpp"
#include "events.hpp"

namespace graze::scene {

// The finding about one pair, and its source.
struct Looked {
  enum class How : std::uint8_t { moot, cast, kept, parted, held };
  How how = How::moot;
  std::optional<Answer> answer;  // of a cast
  const Event* kept = nullptr;   // of bodies that rest as they did, in contact
  Memory::Pair next;             // knowledge for the next step, with the touching below
  std::optional<Touching> touching;
  Counters counters;  // beside the answer's
};

class Recall {
 public:
  Recall(const Scene& scene, const Options& options, Memory& memory);

  // The pairs to be examined.
  void prepare(std::span<const Candidate> pairs);
  // Over [0, until]. Reads only, so that many threads may look at once.
  [[nodiscard]] Looked look(const Candidate& pair, double until) const;
  // For a pair that is not examined.
  [[nodiscard]] Looked pass_over(const Candidate& pair) const;
  // The knowledge about the pairs for the next step, in the order of the pairs.
  void keep(const Looked& looked);
  // The memory is now of this step.
  void end();

 private:
  [[nodiscard]] Memory::Pair known(const Candidate& pair) const;
  [[nodiscard]] bool both_rest(const Candidate& pair) const {
    return is_at_rest(scene_.bodies[pair.a].body) && is_at_rest(scene_.bodies[pair.b].body);
  }
  // For bodies that do not both rest.
  [[nodiscard]] StepPair step_of(const Candidate& pair, Counters& counters) const {
    return {bodies_[places_[pair.a]], bodies_[places_[pair.b]], limits_, counters};
  }
  [[nodiscard]] bool follows(const Candidate& pair, Looked& looked) const;
  void learn(const Candidate& pair, Looked& looked) const;
  void index();

  const Scene& scene_;
  const Options& options_;
  Memory& memory_;
  Memory::Settings settings_;
  std::vector<char> rests_as_it_did_;  // of each body
  std::vector<Memory::Pair> pairs_;    // of this step
  std::vector<Touching> touching_;
  std::vector<Event> events_;
  StepLimits limits_;
  std::vector<std::uint32_t> places_;  // of each body in the next
  std::vector<StepBody> bodies_;
};

}  // namespace graze::scene
