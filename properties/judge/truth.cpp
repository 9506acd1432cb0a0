#include "properties/judge/truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "oracles/polytope/exact_body.hpp"
#include "properties/edit/case.hpp"

namespace graze::law {

using oracle::RotatingTruth;

namespace {

corpus::Case rest(corpus::Case problem) {
  problem.query = corpus::Query::cast;
  problem.a.displacement.setZero();
  problem.b.displacement.setZero();
  problem.target_distance = 0;
  problem.start_policy = StartPolicy::report;
  return problem;
}

bool has_exact_bodies(const corpus::Case& problem) {
  return oracle::is_exact_body(problem.a.shape) && oracle::is_exact_body(problem.b.shape);
}

bool has_many_differences(const corpus::Case& problem) {
  const std::uint64_t a = vertex_count(problem.a.shape), b = vertex_count(problem.b.shape);
  return a > kMostDifferences || b > kMostDifferences || a * b > kMostDifferences;
}

}  // namespace

// CaseTruth takes polytopes to the exact oracle however many vertices they have. The same set with an
// ellipsoid of no extent added goes to the bracket oracle.
oracle::CaseTruth truth_within_reach(corpus::Case problem) {
  if (has_exact_bodies(problem) && has_many_differences(problem)) {
    problem.a.shape = sum<double>(std::move(problem.a.shape), Ellipsoid<double>{Vec3<double>::Zero()});
  }
  return oracle::CaseTruth(problem);
}

bool is_exactly_decided(const corpus::Case& problem) {
  return has_exact_bodies(problem) && !has_many_differences(problem);
}

const oracle::CaseTruth& Truth::cast() {
  if (!cast_) cast_ = std::make_unique<oracle::CaseTruth>(truth_within_reach(problem_));
  return *cast_;
}

const oracle::LinearTruth& Truth::moving() {
  if (!moving_) moving_ = std::make_unique<oracle::LinearTruth>(problem_);
  return *moving_;
}
const oracle::LinearTruth& Truth::at_rest() {
  if (!at_rest_) at_rest_ = std::make_unique<oracle::LinearTruth>(rest(problem_));
  return *at_rest_;
}
const oracle::PenetrationTruth& Truth::penetration() {
  if (!penetration_) penetration_ = std::make_unique<oracle::PenetrationTruth>(rest(problem_));
  return *penetration_;
}

const RotatingTruth& Truth::bracket() {
  if (bracket_) return *bracket_;
  bracket_ = std::make_unique<RotatingTruth>(problem_);
  // A case that comes nearer than the oracle's width is examined again with the finest width.
  if (bracket_->outcome() == Outcome::not_converged && !bracket_->budget_ended()) {
    auto finer = std::make_unique<RotatingTruth>(problem_, RotatingTruth::kLeastWidth);
    if (finer->outcome() != Outcome::not_converged) bracket_ = std::move(finer);
  }
  return *bracket_;
}

const RotatingTruth& Truth::beside_proof() {
  if (!beside_proof_) {
    const double upper = std::min(proved_.upper, problem_.t_max);
    beside_proof_ = std::make_unique<RotatingTruth>(RotatingTruth::of_proved(problem_, proved_.lower, upper));
  }
  return *beside_proof_;
}

oracle::RotatingVerdict Truth::check(const RotatingProof& proof) {
  oracle::RotatingVerdict verdict = oracle::check_rotating_proof(problem_, proof);
  if (!verdict.accepted()) return verdict;
  const ProvedBracket both{.lower = std::max(proved_.lower, proof.toi_lower),
                           .upper = std::min(proved_.upper, proof.toi_upper)};
  if (both.lower > both.upper) {
    verdict.detail = fmt::format(
        "it says that contact comes in [{:.17g}, {:.17g}], another that was "
        "accepted, in [{:.17g}, {:.17g}]",
        proof.toi_lower, proof.toi_upper, proved_.lower, proved_.upper);
    return verdict;
  }
  proved_ = both;
  return verdict;
}

bool Truth::learn_from_reference() {
  if (reference_ == nullptr) return false;
  const engine::Answer answer =
      std::exchange(reference_, nullptr)->ask(problem_, {.request = Request::everything});
  if (!answer.rotating_proof) return false;
  const oracle::RotatingVerdict verdict = check(*answer.rotating_proof);
  return verdict.accepted() && verdict.detail.empty();
}

}  // namespace graze::law
