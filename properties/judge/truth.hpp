// The truth about one case: the exact oracles' answers and the bracket oracle's, each computed on first use, and the
// facts that accepted proofs have shown. One thread at a time.
#pragma once

#include <memory>

#include "engines/method.hpp"
#include "oracles/checker/check_proof.hpp"
#include "oracles/checker/check_rotating_proof.hpp"
#include "oracles/truth/case_truth.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "oracles/truth/penetration_truth.hpp"
#include "oracles/truth/rotating_truth.hpp"

namespace graze::law {

// The facts that accepted proofs have shown: no contact before `lower`, contact by `upper`.
struct ProvedBracket {
  double lower = 0, upper = kInfinity<double>;
};

class Truth {
 public:
  // `problem`: as a method sees it. `reference`: a method whose proof of this case may be requested for
  // rotating bodies, or nullptr.
  explicit Truth(corpus::Case problem, const engine::Method* reference = nullptr)
      : problem_(std::move(problem)), reference_(reference) {}
  [[nodiscard]] const corpus::Case& problem() const { return problem_; }

  // For a linear cast. Throws std::invalid_argument if no oracle takes the case.
  [[nodiscard]] const oracle::CaseTruth& cast();
  [[nodiscard]] bool has_cast() const { return cast_ != nullptr; }  // it was asked for

  // For queries between bodies that oracles/polytope/exact_body.hpp represents.
  [[nodiscard]] const oracle::LinearTruth& moving();            // as the case says
  [[nodiscard]] const oracle::LinearTruth& at_rest();           // at t = 0, without the target distance
  [[nodiscard]] const oracle::PenetrationTruth& penetration();  // the same

  // For bodies that may rotate.
  [[nodiscard]] const oracle::RotatingTruth& bracket();
  // The truth about times, beside the proved bracket, which has an upper end.
  [[nodiscard]] const oracle::RotatingTruth& beside_proof();
  // The checker's verdict on a proof. An accepted proof narrows proved(). A claim that contradicts what was
  // accepted before comes back with a detail and no refusal.
  oracle::RotatingVerdict check(const RotatingProof& proof);
  // The same for the proof of the reference, once. False if it gave no new information.
  bool learn_from_reference();
  [[nodiscard]] const ProvedBracket& proved() const { return proved_; }

 private:
  corpus::Case problem_;
  const engine::Method* reference_;
  ProvedBracket proved_;
  std::unique_ptr<oracle::CaseTruth> cast_;
  std::unique_ptr<oracle::LinearTruth> moving_, at_rest_;
  std::unique_ptr<oracle::PenetrationTruth> penetration_;
  std::unique_ptr<oracle::RotatingTruth> bracket_, beside_proof_;
};

// The oracle for a linear case. Polytopes, alone or rounded by one radius, go to the exact one if they have no more
// than kMostDifferences pairs of vertices (256 x 256 take it 0.2 s, 512 x 512 a second, the bracket oracle 2 ms).
// Everything else goes to the bracket oracle.
inline constexpr std::uint64_t kMostDifferences = 1u << 14;
[[nodiscard]] oracle::CaseTruth truth_within_reach(corpus::Case problem);
[[nodiscard]] bool is_exactly_decided(const corpus::Case& problem);

}  // namespace graze::law
