// Is a claim about a case true? By the oracles, which do not look at how it was proved.
//
// Bodies that do not turn: the exact oracle, or the bracket oracle for curved shapes; of polytopes, one in
// some, the linear program says it again. Turning ones: looks at single times first (sampled_contact.hpp),
// which convict at once and know no bound of motion, then the chains of RotatingTruth. What is asked of a
// case is computed once, however many claims are judged.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "corpus/case.hpp"

namespace graze::attack {

// TOI >= lower and TOI <= upper, by the meanings of graze/proof.hpp: a lower of infinity says that it misses,
// a lower of 0 and an upper of infinity say nothing. `outcome`, where it is part of the claim.
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
  // second_opinion: asks the linear program too, where there is one.
  explicit ClaimJudge(const corpus::Case& problem, bool second_opinion = false);
  ~ClaimJudge();
  ClaimJudge(ClaimJudge&&) noexcept;
  ClaimJudge& operator=(ClaimJudge&&) noexcept;

  [[nodiscard]] Judgement judge(const Claim& claim);
  // Is the claim true of some convex set within `length` of C = A - B + ball(m)? Of bodies that do not turn. What must
  // hold then is judged: the path up to the lower bound is no deeper in C, and somewhere between the bounds it
  // is no farther from C. The outcome is not looked at.
  [[nodiscard]] Judgement judge_within(const Claim& claim, double length);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graze::attack
