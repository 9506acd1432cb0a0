// Judges one answer to one case: is the verdict right, is the time never late, is the bracket as near as its
// guarantee says?
//
// The proof is looked at first: where it is accepted and the answer's bracket stays within kappa u scale of
// what it proves, it settles everything and the exact oracle is not asked. The oracle decides the rest, and
// whatever it is asked to decide for the sample.
//
//   limit = kappa u scale, a length.   v = v_B - v_A.   Errors are those of docs/guarantees.md, by the exact
//   oracle.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "corpus/case.hpp"
#include "engines/guarantees.hpp"
#include "engines/method.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/truth/case_truth.hpp"

namespace graze::tool {

// One case and its exact answer, made when it is first asked for (milliseconds). One thread at a time.
class Truth {
 public:
  explicit Truth(corpus::Case problem) : problem_(std::move(problem)) {}
  [[nodiscard]] const corpus::Case& problem() const { return problem_; }
  [[nodiscard]] const oracle::CaseTruth& exact();
  [[nodiscard]] bool made() const { return exact_ != nullptr; }

 private:
  corpus::Case problem_;
  std::unique_ptr<oracle::CaseTruth> exact_;
};

struct Limits {
  double kappa = 0;
  double unit_roundoff = 0;
  double contact_kappa = kappa;  // of normals and witnesses
  double width = 0;              // tier certified: of the bracket, over scale
};

// Over scale. NaN where the answer or the truth has no such error.
struct Errors {
  double forward = std::numeric_limits<double>::quiet_NaN();  // the larger of the bracket's two ends
  double backward =
      std::numeric_limits<double>::quiet_NaN();  // the same; of a wrong verdict: depth or clearance
  double normal =
      std::numeric_limits<double>::quiet_NaN();  // h(n) - n.(t v), see normal_error in judge_contact.cpp
  double witness =
      std::numeric_limits<double>::quiet_NaN();  // the larger distance of the two from their bodies
};

enum class ProofState {
  none,      // no proof, or one that proves less than the verdict
  accepted,  // and it proves the verdict
  refused,   // a claim of it is false
};

struct Judgement {
  Outcome outcome = Outcome::invalid_input;
  // Faults: why, or empty.
  std::string wrong;        // the verdict, by more than the limit; or an answer that says nothing sensible
  std::string late;         // toi_lower, by more than the limit
  std::string off;          // an end of the bracket has a backward error above the limit
  std::string bad_contact;  // the normal or a witness is further off than the limit
  std::string false_proof;  // which claim of it is false
  // No fault by itself: its frequency is capped.
  bool stalled = false;  // not_converged
  bool excused = false;  // verdict wrong within the limit: the question is decided by less than that
  ProofState proof = ProofState::none;
  bool by_oracle = false;
  bool not_asked = false;  // tier exact: a question that is not for it, and that it refused with not_exact
  Errors errors;           // by_oracle only

  [[nodiscard]] bool faulty() const {
    return !(wrong.empty() && late.empty() && off.empty() && bad_contact.empty() && false_proof.empty());
  }
};

// `truth` is about the case as the method saw it. `ask_oracle`: measure the errors even if the proof settles
// all.
[[nodiscard]] Judgement judge(Truth& truth, const engine::Answer& answer, const Limits& limits,
                              bool ask_oracle, Request request);

// Tier certified: an answer, asked for everything. Its verdict and its bracket are true of the case or wrong,
// late or off; off, too, where an end has a backward error above limits.width (and, in float, what rounding
// the times costs, and of bodies far out in their own frames, what properties/judge/own_frames.hpp says).
// not_converged is a stall where clearance or depth exceeds that width, and excused below it.
[[nodiscard]] Judgement judge_certified(Truth& truth, const engine::Answer& answer, const Limits& limits,
                                        bool ask_oracle);

// Tier exact: an answer, asked for everything, judged to the last bit (properties/judge/exact_answer.hpp);
// its normal and witnesses, which are doubles, by limits.contact_kappa.
[[nodiscard]] Judgement judge_exact(Truth& truth, const engine::Answer& answer, const Limits& limits,
                                    bool ask_oracle);

// The method asked for everything about a case, and judged as its tier is, by its row; without a row, by
// kPlainKappa. `truth` is about method.seen(problem).
inline constexpr double kPlainKappa = 1024;
[[nodiscard]] Judgement judge_method(Truth& truth, const corpus::Case& problem,
                                     const engine::EngineMethod& method, const engine::Answer& answer,
                                     const engine::Guarantee* row, bool ask_oracle);

// The errors of an answer against any truth: for a float answer, against the input before it was rounded.
[[nodiscard]] Errors errors_of(Truth& truth, const engine::Answer& answer, Request request);

// What no answer may look like, whatever is true of the case; empty for a sensible one.
[[nodiscard]] std::string senseless(Outcome outcome, double toi_lower, double toi_upper, double t_max);

// A length over scale: over a scale of 0 an error of 0 is 0 and any other is infinite.
[[nodiscard]] double over(double length, double scale);

// Why a method must refuse this case ("a number is not finite", ...); empty for a valid one.
[[nodiscard]] std::string why_invalid(const corpus::Case& problem);

}  // namespace graze::tool
