// Judges the answers to the queries beside the cast: overlap, distance, penetration, line, swept overlap. The
// exact oracles decide every one; there is no proof to look at first.
//
//   limit = kappa u scale, a length. Errors are lengths over scale: of a distance or depth what it is off by,
//   of a time its backward error. A verdict is wrong where distance, depth or clearance exceeds the limit.
#pragma once

#include <memory>

#include "engines/queries.hpp"
#include "oracles/linear_truth.hpp"
#include "oracles/penetration_truth.hpp"
#include "tools/judge.hpp"

namespace graze::tool {

// A case of any query between bodies that exact_body.hpp represents, and what is true of it. One thread.
class QueryTruth {
 public:
  explicit QueryTruth(corpus::Case problem) : problem_(std::move(problem)) {}
  [[nodiscard]] const corpus::Case& problem() const { return problem_; }
  [[nodiscard]] const oracle::LinearTruth& moving();            // as the case says
  [[nodiscard]] const oracle::LinearTruth& at_rest();           // at t = 0, without the target distance
  [[nodiscard]] const oracle::PenetrationTruth& penetration();  // the same

 private:
  corpus::Case problem_;
  std::unique_ptr<oracle::LinearTruth> moving_, at_rest_;
  std::unique_ptr<oracle::PenetrationTruth> penetration_;
};

// wrong: the verdict; off: a bracket's end; bad_contact: the normal or a witness. errors.backward: the larger
// error of the bracket's ends.
[[nodiscard]] Judgement judge_query(QueryTruth& truth, const engine::QueryAnswer& answer,
                                    const Limits& limits);

// Tier exact: verdict and both ends of the line to the last bit; a separating normal by limits.contact_kappa.
[[nodiscard]] Judgement judge_exact_query(QueryTruth& truth, const engine::QueryAnswer& answer,
                                          const Limits& limits);

}  // namespace graze::tool
