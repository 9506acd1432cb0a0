// Contact of moving and rotating bodies at single times. It is the cheap half of a judge, which convicts and
// never acquits.
//
// At each sampled time, the bodies are placed and their overlap is proved in ball arithmetic, or it is not.
// Nothing is claimed about the times between, so no bound of a motion enters. The chains of RotatingTruth and
// the slices of the checker depend on ball_motion's bounds, so they cannot be wrong in the same way as this
// code. The part shared with both is the pose of a body at a time.
//
// No header of Arb here. One object is for one thread.
#pragma once

#include <memory>

#include "corpus/case.hpp"

namespace graze::oracle {

class SampledContact {
 public:
  // Throws std::invalid_argument for cases that RotatingTruth refuses. It ignores the policy.
  explicit SampledContact(const corpus::Case& problem);
  ~SampledContact();
  SampledContact(SampledContact&&) noexcept;
  SampledContact& operator=(SampledContact&&) noexcept;

  // Samples `times` times that are spread over [0, t_max], both ends among them, from the earliest on, and
  // around the nearest approaches among them. It ends with the first contact.
  void search(int times);
  // Is contact at that time proved? It then counts for earliest().
  bool look_at(double t);
  // The earliest time at which contact was proved, or infinity if there is no such time.
  [[nodiscard]] double earliest() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graze::oracle
