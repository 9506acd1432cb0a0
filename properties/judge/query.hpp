// Judges the answers to the queries beside the cast: overlap, distance, penetration, line, swept overlap. The
// exact oracles decide every one; there is no proof to look at first.
//
//   limit = kappa u scale, a length. Errors are lengths over scale: of a distance or depth what it is off by,
//   of a time its backward error. A verdict is wrong where distance, depth or clearance exceeds the limit.
#pragma once

#include <limits>
#include <memory>
#include <string>

#include "engines/queries.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "oracles/truth/penetration_truth.hpp"

namespace graze::law {

struct QueryLimits {
  double kappa = 0;
  double unit_roundoff = 0;
  double contact_kappa = kappa;  // of normals and witnesses
};

struct QueryJudgement {
  Outcome outcome = Outcome::invalid_input;
  // Faults: why, or empty.
  std::string wrong;        // the verdict, by more than the limit
  std::string off;          // an end of a bracket, by more than the limit
  std::string bad_contact;  // the normal or a witness, by more than the limit
  // No fault by itself: its frequency is capped.
  bool stalled = false;    // not_converged, or a bracket that says of itself that it is wide
  bool excused = false;    // verdict wrong within the limit: the question is decided by less than that
  bool not_asked = false;  // tier exact: a question that is not for it, and that it refused with not_exact
  // Over scale; NaN where the answer has no such error.
  double backward = std::numeric_limits<double>::quiet_NaN();  // the larger of a bracket's two ends
  double normal = std::numeric_limits<double>::quiet_NaN();
  double witness = std::numeric_limits<double>::quiet_NaN();  // the larger of the two

  [[nodiscard]] bool faulty() const { return !(wrong.empty() && off.empty() && bad_contact.empty()); }
  // The first of the faults, or empty.
  [[nodiscard]] const std::string& fault() const {
    return !wrong.empty() ? wrong : !off.empty() ? off : bad_contact;
  }
};

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

// What a limit is relative to, from the scale of the pair. A line meets C behind its start as well, as far as
// the target distance back.
[[nodiscard]] double scale_of_question(corpus::Query query, double target_distance, double scale_of_pair);

[[nodiscard]] QueryJudgement judge_query(QueryTruth& truth, const engine::QueryAnswer& answer,
                                         const QueryLimits& limits);

// Tier exact: verdict and both ends of the line to the last bit; a separating normal by limits.contact_kappa.
[[nodiscard]] QueryJudgement judge_exact_query(QueryTruth& truth, const engine::QueryAnswer& answer,
                                               const QueryLimits& limits);

// By the tier of the method.
[[nodiscard]] QueryJudgement judge_query(QueryTruth& truth, const engine::QueryMethod& method,
                                         const engine::QueryAnswer& answer, const QueryLimits& limits);

}  // namespace graze::law
