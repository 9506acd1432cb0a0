// One answer of a campaign: a contender is asked about a case, and judged, by its proof first.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "certify/campaign/cases.hpp"
#include "properties/judge/query.hpp"
#include "properties/judge/rotating_answer.hpp"

namespace graze::tool {

// What an answer can be convicted of.
enum class Fault { wrong, late, off, contact, false_proof, unproved };
inline constexpr std::size_t kFaults = 6;

// An outcome and the numbers that bracket it.
struct AnswerWords {
  Outcome outcome = Outcome::invalid_input;
  std::array<double, 8> numbers = {};
  std::size_t count = 0;
};
[[nodiscard]] AnswerWords words_of(const engine::Answer& answer);

struct CampaignCast {
  AnswerWords answer;
  std::array<std::string, kFaults> faults = {};  // why, or empty
  ProofState proof = ProofState::none;
  bool by_oracle = false;
  std::string undecided = {};  // why the oracle, which was asked, could not tell
  bool stalled = false;        // not_converged, and not excused; its frequency is capped by the row
  bool excused = false;        // decided by less than the row's limit
  bool not_asked = false;      // no question for this contender
  // By the oracle: the error of the bracket's worse end, over what the row grants.
  double widest = std::numeric_limits<double>::quiet_NaN();

  [[nodiscard]] bool faulty() const;
  [[nodiscard]] std::string reason() const;  // the first fault, or what stalled
};

// A case as a contender is asked it: of queries another than what was drawn.
[[nodiscard]] corpus::Case question_of(const Contender& contender, const DrawnCase& drawn);

// One case and what is found out about it, for all contenders that are asked. One thread.
class CaseJudge {
 public:
  explicit CaseJudge(DrawnCase drawn) : drawn_(std::move(drawn)) {}
  [[nodiscard]] const DrawnCase& drawn() const { return drawn_; }

  // Asked for everything, with its proof; of turning bodies every other answer is without one, since the plan
  // simulates less then, and is held to the proof that the method has of the same case. The oracle decides
  // what proofs leave open and, of a case that is sampled, the rest as well; a query has no proof, and only
  // the oracle. Without a row a method is held to kPlainKappa. Does not throw: a judge that cannot judge
  // convicts with its reason.
  [[nodiscard]] CampaignCast ask(const Contender& contender);

 private:
  [[nodiscard]] CampaignCast cast(const engine::EngineMethod& method, const engine::Guarantee* row);
  [[nodiscard]] CampaignCast query(const engine::QueryMethod& method, const Contender& contender);
  [[nodiscard]] CampaignCast turn(const engine::RotatingEngineMethod& method, const engine::Guarantee* row);

  DrawnCase drawn_;
  // Of the case as each scalar sees it; where that is the same case, one.
  std::vector<std::unique_ptr<Truth>> casts_;
  std::vector<std::unique_ptr<law::QueryTruth>> queries_;
  std::vector<std::unique_ptr<TurningTruth>> turns_;
};

// Of one answer: its index, its outcome and the bits of its numbers.
[[nodiscard]] std::uint64_t answer_hash(std::uint64_t index, const AnswerWords& answer);
// The contender asked, and not judged.
[[nodiscard]] std::uint64_t answer_hash(std::uint64_t index, const Contender& contender,
                                        const DrawnCase& drawn);

}  // namespace graze::tool
