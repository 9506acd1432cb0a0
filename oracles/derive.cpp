// Decides: what linear_truth.cpp and penetration_truth.cpp decide, for curved shapes what closed_form.cpp and
// bracket_truth.cpp do; lengths are rounded to the nearest double.
// Costs: as there.
#include "oracles/derive.hpp"

#include <stdexcept>

#include "oracles/bracket_truth.hpp"
#include "oracles/closed_form.hpp"
#include "oracles/exact_body.hpp"
#include "oracles/linear_truth.hpp"
#include "oracles/penetration_truth.hpp"

namespace graze::oracle {
namespace {

using corpus::Expect;
using corpus::Query;

const char* name_of_oracle(int dimension, bool is_polytope) {
  if (is_polytope) return "exact CSO (CGAL convex_hull_3)";
  return dimension == 0 ? "closed form" : "exact rounded CSO";
}

corpus::Case at_rest(corpus::Case problem) {
  problem.a.displacement.setZero();
  problem.b.displacement.setZero();
  problem.start_policy = corpus::StartPolicy::report;
  return problem;
}

Expect cast_expectation(const corpus::Case& problem) {
  const LinearTruth truth(problem);
  Expect expect;
  expect.by = name_of_oracle(truth.dimension(), truth.is_polytope());
  expect.outcome = truth.outcome();
  expect.toi_lower = truth.toi_lower();
  expect.toi_upper = truth.toi_upper();
  expect.toi_exact = truth.toi_exact();
  if (problem.query != Query::line) return expect;
  if (const auto interval = truth.contact_interval()) {
    expect.t_in = interval->t_in;
    expect.t_out = interval->t_out;
  }
  return expect;
}

// For the shapes that only the closed forms and the brackets know. The bracket's ends are rounded outward:
// neighbouring doubles unless the path grazes.
constexpr double kWidth = 1e-30;

[[noreturn]] void undecided() {
  throw Undecided("clearance or depth is below 1e-30 of scale, or contact at t = 0 is open");
}

Expect curved_cast_expectation(const corpus::Case& problem) {
  Expect expect;
  if (problem.query == Query::cast) {
    if (const auto closed = ClosedForm::of(problem)) {
      expect.by = "closed form";
      expect.outcome = closed->outcome();
      expect.toi_lower = closed->toi_lower();
      expect.toi_upper = closed->toi_upper();
      expect.toi_exact = closed->toi_exact();
      return expect;
    }
  }
  const BracketTruth truth(problem, kWidth);
  if (truth.outcome() == Outcome::not_converged) undecided();
  expect.by = "bracket in ball arithmetic (Arb)";
  expect.outcome = truth.outcome();
  expect.toi_lower = truth.toi_lower();
  expect.toi_upper = truth.toi_upper();
  if (problem.query != Query::line) return expect;
  const LineContact contact = truth.contact_interval();
  if (contact.outcome == Outcome::not_converged) undecided();
  if (contact.outcome == Outcome::hit) {
    expect.t_in = contact.t_in.low;
    expect.t_out = contact.t_out.high;
  }
  return expect;
}

Expect curved_distance_expectation(corpus::Case problem) {
  problem = at_rest(std::move(problem));
  problem.query = Query::cast;
  problem.target_distance = 0;
  const BracketTruth truth(problem, kWidth);
  if (truth.outcome() == Outcome::not_converged) undecided();
  Expect expect;
  expect.by = "bracket in ball arithmetic (Arb)";
  expect.outcome = truth.outcome();
  expect.distance = truth.nearest_distance();
  return expect;
}

Expect curved_expectation(corpus::Case problem) {
  switch (problem.query) {
    case Query::cast:
    case Query::line:
      return curved_cast_expectation(problem);
    case Query::overlap:
    case Query::distance:
      return curved_distance_expectation(problem);
    case Query::swept_overlap: {
      problem.query = Query::cast;
      problem.start_policy = corpus::StartPolicy::report;
      Expect expect = curved_cast_expectation(problem);
      if (expect.outcome != Outcome::miss) expect.outcome = Outcome::hit;
      expect.toi_lower.reset();
      expect.toi_upper.reset();
      expect.toi_exact.clear();
      return expect;
    }
    default:
      throw Undecided("the penetration of curved shapes is bracketed, not derived");
  }
}

Expect swept_expectation(corpus::Case problem) {
  problem.start_policy = corpus::StartPolicy::report;
  const LinearTruth truth(problem);
  Expect expect;
  expect.by = name_of_oracle(truth.dimension(), truth.is_polytope());
  expect.outcome = truth.outcome() == Outcome::miss ? Outcome::miss : Outcome::hit;
  return expect;
}

Expect distance_expectation(const corpus::Case& problem) {
  const LinearTruth truth(at_rest(problem));
  Expect expect;
  expect.by = name_of_oracle(truth.dimension(), truth.is_polytope());
  expect.outcome = truth.outcome();
  expect.distance = truth.nearest_distance();
  return expect;
}

Expect penetration_expectation(const corpus::Case& problem) {
  const PenetrationTruth truth(problem);
  if (!truth.in_contact()) {
    corpus::Case apart = problem;
    apart.target_distance = 0;
    return distance_expectation(apart);
  }
  Expect expect;
  expect.by = name_of_oracle(truth.dimension(), truth.is_polytope());
  expect.outcome = Outcome::initially_overlapping;
  if (problem.query == Query::penetration_along) {
    expect.depth = truth.along(problem.direction).value().length;
    return expect;
  }
  expect.depth = truth.nearest_depth();
  if (truth.normals().size() == 1) expect.normal = truth.normals()[0];
  return expect;
}

}  // namespace

Expect derive_expectation(const corpus::Case& problem) {
  if (!is_exact_body(problem.a.shape) || !is_exact_body(problem.b.shape)) return curved_expectation(problem);
  switch (problem.query) {
    case Query::cast:
    case Query::line:
      return cast_expectation(problem);
    case Query::overlap:
    case Query::distance:
      return distance_expectation(problem);
    case Query::swept_overlap:
      return swept_expectation(problem);
    case Query::penetration:
    case Query::penetration_along:
      return penetration_expectation(problem);
  }
  throw std::invalid_argument("a query that this oracle does not know");
}

}  // namespace graze::oracle
