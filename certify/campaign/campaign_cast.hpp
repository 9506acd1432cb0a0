// One answer of a campaign: a contender is asked about a case, and judged, by its proof first.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "certify/campaign/cases.hpp"
#include "properties/judge/judge.hpp"

namespace graze::tool {

// An outcome and the numbers that bracket it.
struct AnswerWords {
  Outcome outcome = Outcome::invalid_input;
  std::array<double, 8> numbers = {};
  std::size_t count = 0;
};
[[nodiscard]] AnswerWords words_of(const engine::Answer& answer);

struct CampaignCast {
  AnswerWords answer;
  law::Judgement judgement = {};  // for tier exact, an answer that did not converge is a fault and counts
                                  // once
  std::string undecided = {};     // why the oracle, which was asked, could not tell

  [[nodiscard]] std::string reason() const;  // the first fault, or the part that did not converge
};

// A case as a contender is asked it. For queries it differs from the drawn case.
[[nodiscard]] corpus::Case question_of(const engine::Method& contender, const DrawnCase& drawn);
[[nodiscard]] corpus::Case question_of(engine::Kind kind, corpus::Query query, const DrawnCase& drawn);

// A case and the facts found about it, shared by all contenders that are asked. For one thread.
class CaseJudge {
 public:
  explicit CaseJudge(DrawnCase drawn) : drawn_(std::move(drawn)) {}
  [[nodiscard]] const DrawnCase& drawn() const { return drawn_; }

  // Requests everything, with the proof. For rotating bodies, every other answer is requested without one, because the
  // plan simulates less then. It is compared with the proof that the method has of the same case. The oracle decides
  // the cases that proofs leave open and all sampled cases. A query has no proof, so only the oracle judges it. The
  // oracle measures the answers of a third-party engine if they are judged. Does not throw: if the judge itself fails,
  // the answer is reported as at fault, with the judge's error as the reason.
  [[nodiscard]] CampaignCast ask(const engine::Method& contender);

 private:
  [[nodiscard]] CampaignCast ask_other(const engine::Method& contender);
  [[nodiscard]] law::Judgement judge(const engine::Method& method, const corpus::Case& question,
                                     const engine::Answer& answer, Request request, std::string& undecided);
  [[nodiscard]] law::Truth& truth_of(const engine::Method& method, corpus::Case seen);

  DrawnCase drawn_;
  // The truth of the case as each scalar and query sees it. Equal cases share one.
  std::vector<std::unique_ptr<law::Truth>> truths_;
};

// The hash of one answer: its index, its outcome and the bits of its numbers.
[[nodiscard]] std::uint64_t answer_hash(std::uint64_t index, const AnswerWords& answer);
// The contender asked, and not judged.
[[nodiscard]] std::uint64_t answer_hash(std::uint64_t index, const engine::Method& contender,
                                        const DrawnCase& drawn);

}  // namespace graze::tool
