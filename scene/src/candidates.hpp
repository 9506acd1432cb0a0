// Finds the pairs of a scene that must be examined, by their swept bounds. The other pairs are counted.
#pragma once

#include <graze/scene.hpp>
#include <graze/scene/tree.hpp>

namespace graze::scene {

struct Candidate {
  std::uint32_t a = 0, b = 0;  // a < b
  double begin = 0;            // their bounds do not meet before

  // The order in which an earlier event saves most. It is total.
  [[nodiscard]] bool before(const Candidate& other) const {
    if (begin != other.begin) return begin < other.begin;
    return a != other.a ? a < other.a : b < other.b;
  }
};

struct Candidates {
  bool over_budget = false;
  std::vector<Candidate> pairs;
  Counts counts;  // bodies, pairs, and the pairs that are spared here
};

[[nodiscard]] bool is_at_rest(const RotatingBody<double>& body);
// A tree of all bodies over [0, t_max], contact being at the target distance.
[[nodiscard]] Tree tree_of(const Scene& scene, const Options& options);
// The answer for a scene with more pairs than this.
[[nodiscard]] std::string over_budget_text(std::uint64_t most_pairs);
[[nodiscard]] Candidates candidates(const Scene& scene, const Options& options, const Tree& tree);

}  // namespace graze::scene
