// Judges one answer to one rotating case: is the verdict right, is the time never late, is contact not
// claimed before there is any, is the bracket as narrow as its row says, and are the claims of its proof
// true?
//
// The errors and what a row leaves open are those of the laws (properties/judge/rotating.hpp). Here they are
// put together: what is a fault, what is excused, and how large it was. Where the oracle itself is undecided
// (clearance and depth below its width, or its budget at an end), no verdict is wrong.
//
// A campaign looks at proofs first: those that the checker accepts bracket the first contact, and where that
// bracket settles the answer the oracle, a thousand times as dear, is not asked.
#pragma once

#include <memory>
#include <string>

#include "engines/guarantees.hpp"
#include "engines/rotating.hpp"
#include "oracles/checker/check_rotating_proof.hpp"
#include "oracles/truth/rotating_truth.hpp"
#include "properties/judge/answer.hpp"

namespace graze::tool {

// What accepted proofs have shown of a case: no contact before `lower`, contact by `upper`.
struct ProvedBracket {
  double lower = 0, upper = kInfinity<double>;
};

// One case and what is true of it, found out when it is first asked for. One thread at a time.
class TurningTruth {
 public:
  // `reference`: a method whose proof of this case may be asked for; nullptr for none.
  explicit TurningTruth(corpus::Case problem, const engine::RotatingEngineMethod* reference = nullptr)
      : problem_(std::move(problem)), reference_(reference) {}
  [[nodiscard]] const corpus::Case& problem() const { return problem_; }
  [[nodiscard]] const oracle::RotatingTruth& bracket();

  // The checker's verdict on a proof. What it accepts narrows proved(); a claim that contradicts what was
  // accepted before comes back with a detail and no refusal.
  oracle::RotatingVerdict check(const RotatingProof& proof);
  // The same for the proof of the reference, once; false if there was nothing new to learn.
  bool learn_from_reference();
  [[nodiscard]] const ProvedBracket& proved() const { return proved_; }
  // What is true of times beside the bracket that is proved, which has an upper end.
  [[nodiscard]] const oracle::RotatingTruth& beside_proof();

 private:
  corpus::Case problem_;
  const engine::RotatingEngineMethod* reference_;
  ProvedBracket proved_;
  std::unique_ptr<oracle::RotatingTruth> bracket_, beside_proof_;
};

// A method and the row that it is held to.
struct RotatingLimits {
  const engine::RotatingEngineMethod* method = nullptr;
  const engine::Guarantee* row = nullptr;
};
// Without a row, by kPlainKappa, and held to everything.
[[nodiscard]] RotatingLimits limits_of(const engine::RotatingEngineMethod& method,
                                       const engine::Guarantee* row);

struct RotatingJudgement {
  Outcome outcome = Outcome::invalid_input;
  // Faults: why, or empty.
  std::string wrong;  // the verdict, by more than the limit; or an answer that says nothing sensible
  std::string late;   // toi_lower is past the contact, by more than the limit
  std::string early;  // contact is claimed at toi_upper, and there is none yet, by more than the limit
  std::string wide;   // the bracket of a hit is wider than the limit, or farther off than it says itself
  std::string bad_contact;  // the normal or a witness is further off than its limit
  std::string undecided;    // tier certified: not_converged where clearance or depth exceeds the row's width
  std::string unproved;     // tier certified: no proof, or one that claims less than the answer
  std::string false_proof;  // which claim of it is false
  // No fault by itself.
  bool stalled = false;    // not_converged, in tier standard
  bool excused = false;    // a verdict that less than the limit decides
  bool hidden = false;     // a contact missed or passed that the row says may be
  bool open = false;       // the oracle cannot tell whether the answer stands
  bool by_oracle = false;  // it was asked
  bool not_asked = false;  // an infinite t_max or the policy pass_over: no question for the oracle
  ProofState proof = ProofState::none;
  // Over scale, what is proved of each; NaN where the answer or the truth has no such length. width: of a
  // hit, the larger of the distance at toi_lower and the depth before toi_upper. passed: the depth of a
  // contact that a miss denies or toi_lower has passed.
  double width = std::numeric_limits<double>::quiet_NaN();
  double passed = std::numeric_limits<double>::quiet_NaN();
  double width_limit = std::numeric_limits<double>::quiet_NaN();  // that the row grants `width`
  // normal: by how much it fails to separate the bodies at the first contact. witness: the larger distance of
  // the two from their bodies at toi_lower.
  double normal = std::numeric_limits<double>::quiet_NaN();
  double witness = std::numeric_limits<double>::quiet_NaN();

  [[nodiscard]] const std::string& fault() const;  // the first of the faults; empty if there is none
  [[nodiscard]] bool faulty() const { return !fault().empty(); }
};

// `truth` is about the case as the method saw it.
[[nodiscard]] RotatingJudgement judge_rotating(TurningTruth& truth, const engine::RotatingAnswer& answer,
                                               const RotatingLimits& limits, Request request);

// The same, by what proofs have shown of the case: the answer's own, then the reference's. Where they show
// verdict and times and no more is open than the width of the bracket, it is measured beside theirs. The
// oracle searches where they leave more open and, if `measure`, in any case. Else nobody looks at the normal,
// the witnesses and the stated distance, of which a proof says nothing.
[[nodiscard]] RotatingJudgement judge_rotating_by_proof(TurningTruth& truth,
                                                        const engine::RotatingAnswer& answer,
                                                        const RotatingLimits& limits, Request request,
                                                        bool measure);

}  // namespace graze::tool
