// Judges by the oracles if a claim about a case is true. The oracles do not look at how it was proved.
//
// For bodies that do not rotate, the judge is the exact oracle, or the bracket oracle for curved shapes. For some
// polytopes the linear program repeats the judgement. For rotating bodies, it first checks single times
// (sampled_contact.hpp), which need no bound of motion to contradict a claim, and then uses the chains of
// RotatingTruth. Each fact about a case is computed once, however many claims are judged.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "corpus/case.hpp"

namespace graze::attack {

// TOI >= lower and TOI <= upper, by the meanings of graze/proof.hpp. A lower of infinity claims a miss. A lower of 0
// and an upper of infinity claim nothing. `outcome` counts if it is part of the claim.
struct Claim {
  double lower = 0, upper = 0;
  std::optional<Outcome> outcome;
};

struct Judgement {
  enum class Kind { agreed, undecided, contradicted } kind = Kind::undecided;
  std::string fault;  // contradicted: the claim, and what is true instead
};

class ClaimJudge {
 public:
  // second_opinion: runs the linear program too, where it applies.
  explicit ClaimJudge(const corpus::Case& problem, bool second_opinion = false);
  ~ClaimJudge();
  ClaimJudge(ClaimJudge&&) noexcept;
  ClaimJudge& operator=(ClaimJudge&&) noexcept;

  [[nodiscard]] Judgement judge(const Claim& claim);
  // Is the claim true of some convex set within `length` of C = A - B + ball(m)? For bodies that do not
  // rotate. The judge checks two consequences: the path up to the lower bound is no deeper in C, and
  // somewhere between the bounds it is no farther from C. The outcome is not checked.
  [[nodiscard]] Judgement judge_within(const Claim& claim, double length);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graze::attack
