// Decides: what linear_truth.cpp decides; distances are rounded to the nearest double. Costs: as there.
#include "oracles/derive.hpp"

#include "oracles/linear_truth.hpp"

namespace graze::oracle {
namespace {

const char* name_of_oracle(const LinearTruth& truth) {
  if (truth.is_polytope()) return "exact CSO (CGAL convex_hull_3)";
  return truth.dimension() == 0 ? "closed form" : "exact rounded CSO";
}

}  // namespace

corpus::Expect derive_expectation(const corpus::Case& problem) {
  const bool is_static = problem.query == corpus::Query::overlap || problem.query == corpus::Query::distance;
  corpus::Case asked = problem;
  if (is_static) {
    asked.a.displacement.setZero();
    asked.b.displacement.setZero();
  }
  const LinearTruth truth(asked);
  corpus::Expect expect;
  expect.by = name_of_oracle(truth);
  expect.outcome = truth.outcome();
  if (is_static) {
    expect.distance = truth.nearest_distance();
    return expect;
  }
  expect.toi_lower = truth.toi_lower();
  expect.toi_upper = truth.toi_upper();
  expect.toi_exact = truth.toi_exact();
  if (problem.query == corpus::Query::line && truth.is_polytope()) {
    if (const auto interval = truth.contact_interval()) {
      expect.t_in = interval->t_in;
      expect.t_out = interval->t_out;
    }
  }
  return expect;
}

}  // namespace graze::oracle
