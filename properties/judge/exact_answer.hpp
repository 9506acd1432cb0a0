// Judges one answer by the guarantee of the exact tier, to the last bit.
//
//   verdict exact,   toi_lower the largest S not above the TOI,   toi_upper the least S not below it.
//
// The first judge is its proof, in microseconds. It must be accepted, and claim a bracket of doubles that, rounded
// outward to S, is the answer's. It must also be tight: the ends are equal, or neighbours, and then the checker must
// refuse the same proof with either end moved to the other. So the axis proves less than the upper end and the portal
// lies beyond the lower one. This leaves open a TOI that is an end itself, where axis and portal do not belong to one
// facet. The exact oracle, called on a sample, leaves nothing open. It also decides everything that a proof does not
// state:
//
// - a start that is passed over, or reported under the policy pass_over
// - a hit whose lower bound is 0
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "engines/method.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/truth/case_truth.hpp"
#include "oracles/truth/closed_form.hpp"

namespace graze::law {

struct ExactFinding {
  std::string fault = {};    // why the answer is wrong, or empty
  bool false_proof = false;  // the fault is a claim that the checker refuses
  bool settled = false;      // nothing is left to the oracle
};

namespace detail {

// The largest float not above x, and the least not below. Doubles are left as they are.
inline double outward_down(double x, bool in_float) {
  if (!in_float) return x;
  const float near = static_cast<float>(x);
  return static_cast<double>(near) > x ? std::nextafter(near, -kInfinity<float>) : near;
}
inline double outward_up(double x, bool in_float) { return -outward_down(-x, in_float); }
// Is the bracket the exact value, rounded outward?
inline bool is_outward(const std::optional<engine::Interval>& bracket, const oracle::Enclosure& exact,
                       bool in_float) {
  return bracket && bracket->lower == outward_down(exact.low, in_float) &&
         bracket->upper == outward_up(exact.high, in_float);
}

inline bool same_bracket(const engine::Answer& answer, double lower, double upper, bool in_float) {
  return answer.toi_lower == outward_down(lower, in_float) && answer.toi_upper == outward_up(upper, in_float);
}

}  // namespace detail

// `seen`: the case as the method saw it, an exact question (is_exact_question) in the domain. The answer was
// asked for its proof.
inline ExactFinding judge_exact_by_proof(const corpus::Case& seen, const engine::Answer& answer,
                                         bool in_float) {
  const auto fault = [](std::string why) { return ExactFinding{.fault = std::move(why)}; };
  switch (answer.outcome) {
    case Outcome::invalid_input:
      return fault("a valid case was refused");
    case Outcome::not_converged:
      return fault("the exact tier did not converge");
    case Outcome::initially_overlapping:
      if (!(answer.toi_lower == 0 && answer.toi_upper == 0)) return fault("a start in contact not at time 0");
      break;
    case Outcome::miss:
      if (!(answer.toi_lower == kInfinity<double> && answer.toi_upper == kInfinity<double>))
        return fault("a miss with a time");
      if (answer.passed_over) {
        return seen.start_policy == StartPolicy::pass_over ? ExactFinding{} : fault("passed over unasked");
      }
      break;
    case Outcome::hit:
      break;
  }
  if (!answer.proof) return fault("no proof");
  const Proof& proof = *answer.proof;
  oracle::MovedBounds moved;
  const oracle::Verdict verdict = oracle::check_bracket(seen, proof, moved);
  if (!verdict.accepted()) {
    return {.fault = std::string(to_string(verdict.refusal)) + ": " + verdict.detail, .false_proof = true};
  }
  const bool reports = seen.start_policy == StartPolicy::report;
  switch (answer.outcome) {
    case Outcome::initially_overlapping:
      // A proof cannot say that a start does not leave: under pass_over it claims nothing.
      if (reports && proof.toi_upper != 0) return fault("the contact at the start is not proved");
      return {.settled = reports};
    case Outcome::miss:
      if (proof.toi_lower != kInfinity<double>) return fault("the miss is not proved");
      return {.settled = true};
    default:
      break;
  }
  const double lower = proof.toi_lower, upper = proof.toi_upper;
  if (!detail::same_bracket(answer, lower, upper, in_float)) return fault("the proof claims another bracket");
  if (!(lower <= upper && upper > 0 && lower <= seen.t_max)) return fault("a hit at no time of the path");
  if (lower == upper) return {.settled = true};
  if (std::nextafter(lower, kInfinity<double>) != upper)
    return fault("the bracket's ends are not neighbours");
  if (moved.lower_accepted) return fault("toi_lower is below the TOI by a double");
  if (moved.upper_accepted) return fault("toi_upper is above the TOI by a double");
  return {.settled = lower > 0};
}

// Judges by the true answer for the case as the method saw it: by the exact oracle's, or a closed form. Returns the
// fault, or empty.
template <class Truth>
std::string exact_fault_by_truth(const Truth& truth, const engine::Answer& answer, bool in_float) {
  if (answer.outcome != truth.outcome()) return "the verdict is not the exact oracle's";
  if (answer.outcome != Outcome::hit) return {};
  return detail::same_bracket(answer, truth.toi_lower(), truth.toi_upper(), in_float)
             ? ""
             : "the bracket is not the exact oracle's";
}

}  // namespace graze::law
