// Contact of moving and turning bodies at single times: the cheap half of a judge, which convicts and never
// acquits.
//
// At each time that it looks at, the bodies are placed and their overlap is proved in ball arithmetic, or it
// is not. Nothing is said of the times between, so no bound of a motion enters: neither the chains of
// RotatingTruth nor the slices of the checker, which stand on ball_motion's bounds, can be wrong in the same
// way as this. What it shares with both is where a body is at a time.
//
// No header of Arb here. One object is for one thread.
#pragma once

#include <memory>

#include "corpus/case.hpp"

namespace graze::oracle {

class SampledContact {
 public:
  // Throws std::invalid_argument for what RotatingTruth refuses, but the policy, which is not looked at.
  explicit SampledContact(const corpus::Case& problem);
  ~SampledContact();
  SampledContact(SampledContact&&) noexcept;
  SampledContact& operator=(SampledContact&&) noexcept;

  // Looks at `times` times that are spread over [0, t_max], both ends among them, from the earliest on, and
  // around the nearest approaches among them; ends with the first contact.
  void search(int times);
  // Is contact at that time proved? It then counts for earliest().
  bool look_at(double t);
  // The earliest time at which contact was proved; infinity if it was nowhere.
  [[nodiscard]] double earliest() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graze::oracle
