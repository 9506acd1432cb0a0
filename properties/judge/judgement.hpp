// The judgement of one answer: its faults, its tolerated deviations, and the sizes of its errors.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "engines/method.hpp"

namespace graze::law {

enum class ProofState {
  none,      // no proof, or one that proves less than the verdict
  accepted,  // and it proves the verdict
  refused,   // a claim of it is false
};

// Proved errors over scale, by the oracle. NaN where answer or truth has no such error.
struct Errors {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double forward = kNone;   // in times: the larger of the bracket's two ends
  double backward = kNone;  // the same, as a length. For a wrong verdict: depth or clearance. For a query:
                            // the error of a distance or a depth.
  double normal = kNone;    // by how much it fails to support C, or to separate the bodies
  double witness = kNone;   // the larger distance of the two from their bodies
  double passed = kNone;    // for casts of rotating bodies: the depth of a contact that a miss denies or that
                            // toi_lower has passed.
  double scale = kNone;     // of the question, a length
  // Not over scale: the proved error over the error that the guarantee grants, for an answer that converged.
  // It is the lower end of `backward` if the oracle has a bracket of its own. For a linear cast it is above 1
  // only if faulty.
  double over_limit = kNone;
};

struct Judgement {
  Outcome outcome = Outcome::invalid_input;
  // Faults: why, or empty.
  engine::Failure failure = engine::Failure::none;  // for `failed`: the kind
  std::string failed;       // a third-party engine crashed, hung, or wrote no valid answer
  std::string wrong;        // the verdict, by more than the limit, or an answer that makes no sense
  std::string late;         // toi_lower is past the contact, by more than the limit
  std::string early;        // contact is claimed at toi_upper before there is any, by more than the limit
  std::string off;          // an end of a bracket is farther off than the guarantee lets it be
  std::string bad_contact;  // the normal or a witness is farther off than its limit
  std::string unproved;     // tier certified, rotating: no proof, or one that claims less than the answer
  std::string false_proof;  // the claim of it that is false
  std::string work;         // more support evaluations than the guarantee's most_supports
  // Not a fault by itself, but its frequency is capped: not_converged, or a bracket that the answer marks as
  // wide. In tier certified only if clearance or depth exceeds the width of its guarantee, with the reason.
  bool stalled = false;
  std::string undecided;
  bool within_tolerance = false;  // the question is decided by less than the limit
  bool hidden = false;            // a contact missed or passed that the guarantee lets be missed
  bool open = false;              // the oracle cannot tell whether the answer stands
  std::string why_open;           // the reason for that
  bool by_oracle = false;         // the oracle was called
  bool skipped = false;           // not a question for the method, or one that the oracle has no answer to
  bool declined = false;          // in that case: an engine answered that it does not support the question
  ProofState proof = ProofState::none;
  int supports = 0;  // support evaluations that the answer took
  Errors errors;     // by_oracle only

  // An answer counts as one fault, the worst: an index into kFaultKinds, or kFaults if it has no fault.
  [[nodiscard]] std::size_t worst_fault() const;
  [[nodiscard]] const std::string& fault() const;  // the reason of the worst fault, or empty
  // The same, and in brackets the other kinds of fault: "... (also off, contact off)".
  [[nodiscard]] std::string told_fault() const;
  [[nodiscard]] bool faulty() const { return !fault().empty(); }
};

// The kinds of fault, the worst first: their names in reports, and the description of the answers that have them.
struct FaultKind {
  const char* name;
  const char* sentence;
  std::string Judgement::*why;
};
inline constexpr FaultKind kFaultKinds[] = {
    {"failed", "without an answer", &Judgement::failed},
    {"wrong", "wrong", &Judgement::wrong},
    {"late", "late", &Judgement::late},
    {"early", "early", &Judgement::early},
    {"off", "with a bracket off by more than the guarantee", &Judgement::off},
    {"contact off", "with a normal or a witness off by more than the guarantee", &Judgement::bad_contact},
    {"unproved", "without its proof", &Judgement::unproved},
    {"false proof", "with a false proof", &Judgement::false_proof},
    {"work", "by more support evaluations than the guarantee", &Judgement::work},
};
inline constexpr std::size_t kFaults = std::size(kFaultKinds);

// Keeps the first reason.
inline void add_fault(std::string& fault, std::string why) {
  if (fault.empty()) fault = std::move(why);
}

// A length over scale: over a scale of 0 an error of 0 is 0 and any other is infinite.
[[nodiscard]] double over(double length, double scale);

// The reason why an answer to a cast makes no sense, whatever the case. Empty for a sensible one.
[[nodiscard]] std::string senseless(const engine::Answer& answer, double t_max);

// The most support evaluations that the method's guarantee allows for a case. A rotating cast under pass_over may take
// kFollowing times as many: it follows the contact of the start before it searches. For each further quarter turn that
// the faster body begins, it may take half as many more.
inline constexpr int kFollowing = 2;
[[nodiscard]] std::optional<double> most_supports(const engine::Method& method, const corpus::Case& problem);
// Compares the supports with it: Judgement::supports and Judgement::work.
void judge_work(Judgement& judgement, const engine::Method& method, const corpus::Case& problem,
                const Counters& counters);

[[nodiscard]] bool claims_contact(const engine::Answer& answer);  // hit or initially_overlapping

// The name of an end of the bracket in a fault. An engine that answers one number has a time and no bracket.
[[nodiscard]] inline std::string_view lower_name(const engine::Answer& answer) {
  return answer.toi_lower == answer.toi_upper ? "the time" : "toi_lower";
}
[[nodiscard]] inline std::string_view upper_name(const engine::Answer& answer) {
  return answer.toi_lower == answer.toi_upper ? "the time" : "toi_upper";
}

// The bracket of a time that is too large for the scalar: from its largest number to infinity. Only float has such
// times, for motion below 1e-38 or so over lengths of 1. The guarantee then is only that the time is no sooner.
[[nodiscard]] bool is_beyond_range(double lower, double upper, double unit_roundoff);

[[nodiscard]] std::string_view label_of(Outcome outcome);
// Numbers as the shortest decimals that read back to the same bits.
[[nodiscard]] std::string decimal(double x);
[[nodiscard]] std::string decimal(const Vec3<double>& x);
// All that an answer holds, in one line.
[[nodiscard]] std::string describe(const engine::Answer& answer);

}  // namespace graze::law
