// Decides: the questions of linear_truth.cpp and penetration_truth.cpp, for curved shapes those of
// closed_form.cpp and bracket_truth.cpp, and for casts of rotating bodies those of rotating_truth.cpp.
// Lengths are rounded to the nearest double. Costs: as there.
#include "oracles/truth/derive.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "oracles/arithmetic/default_environment.hpp"
#include "oracles/polytope/exact_body.hpp"
#include "oracles/truth/bracket_truth.hpp"
#include "oracles/truth/closed_form.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "oracles/truth/penetration_truth.hpp"
#include "oracles/truth/rotating_truth.hpp"

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
  problem.spin_a = problem.spin_b = {};
  problem.start_policy = corpus::StartPolicy::report;
  return problem;
}

// Lengths that are too small convict nobody: rounded down, over a scale that is rounded up.
template <class Truth>
void measure(const Truth& truth, Expect& expect) {
  expect.scale = truth.scale().high;
  if (truth.outcome() == Outcome::miss) {
    expect.clearance = truth.clearance().low;
  } else {
    expect.path_depth = truth.depth().low;
  }
}

Expect cast_expectation(const corpus::Case& problem) {
  const LinearTruth truth(problem);
  Expect expect;
  expect.by = name_of_oracle(truth.dimension(), truth.is_polytope());
  expect.outcome = truth.outcome();
  expect.toi_lower = truth.toi_lower();
  expect.toi_upper = truth.toi_upper();
  expect.toi_exact = truth.toi_exact();
  if (problem.query != Query::line) {
    measure(truth, expect);
    return expect;
  }
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
      const BracketTruth bracket(problem, kWidth);
      if (bracket.outcome() == expect.outcome) measure(bracket, expect);
      return expect;
    }
  }
  const BracketTruth truth(problem, kWidth);
  if (truth.outcome() == Outcome::not_converged) undecided();
  expect.by = "bracket in ball arithmetic (Arb)";
  expect.outcome = truth.outcome();
  expect.toi_lower = truth.toi_lower();
  expect.toi_upper = truth.toi_upper();
  if (problem.query != Query::line) {
    measure(truth, expect);
    return expect;
  }
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
  // A contact is proved by the bodies' overlap, of which the bracket of the distance keeps its width.
  expect.distance = truth.outcome() == Outcome::miss ? truth.nearest_distance() : 0;
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
      expect.clearance.reset();
      expect.path_depth.reset();
      expect.scale.reset();
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

bool turns(const corpus::Case& problem) {
  return !problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0);
}

// Over scale: how wide an expected bracket may be.
constexpr double kExpectedWidth = 1e-14;

// The expectation for a start in contact that is followed (judge/judge_followed.hpp). It must be the same for
// any depth from kTouching to kDeep over scale that counts as deeper. Nothing if the start is apart.
std::optional<Expect> followed_expectation(const corpus::Case& reported) {
  constexpr double kTouching = 1e-14, kDeep = 1e-12;
  const RotatingTruth truth = RotatingTruth::of_proved(reported, 0, 0, kTouching / 8);
  const double touching = kTouching * truth.scale().low, deep = kDeep * truth.scale().high;
  if (truth.distance_at(0).low > deep) return {};
  if (truth.distance_at(0).high > touching)
    throw Undecided("a start within rounding of contact, by pass_over");
  Expect expect;
  expect.by = "time subdivision in balls";
  const Enclosure start = truth.depth_at(0), all = truth.depth_before(reported.t_max);
  if (start.low > deep) {
    expect.outcome = Outcome::initially_overlapping;
    expect.toi_lower = expect.toi_upper = 0;
    return expect;
  }
  if (start.high > touching) throw Undecided("a start about as deep as is followed, by pass_over");
  if (all.high <= touching) {
    // Bodies that come apart and touch again without depth may or may not make new contact.
    constexpr int kTimes = 64;
    bool apart = false;
    for (int i = 1; i <= kTimes; ++i) {
      const Enclosure distance = truth.distance_at(reported.t_max * i / kTimes);
      if (apart && distance.low <= deep) throw Undecided("a contact anew without depth, by pass_over");
      apart = apart || distance.low > deep;
    }
    expect.outcome = Outcome::miss;
    expect.toi_lower = expect.toi_upper = kInfinity<double>;
    return expect;
  }
  if (!(all.low > deep)) throw Undecided("a contact that gets about as deep as is followed, by pass_over");
  // The first time that is known to be deeper, and the last that is known not to be, by halves down to a double.
  const auto halve = [](double low, double high, const auto& is_high) {
    constexpr int kMostHalves = 128;
    for (int i = 0; i < kMostHalves; ++i) {
      const double middle = low + (high - low) / 2;
      if (!(low < middle && middle < high)) break;
      (is_high(middle) ? high : low) = middle;
    }
    return std::pair(low, high);
  };
  const double upper =
      halve(0, reported.t_max, [&](double t) { return truth.depth_before(t).low > deep; }).second;
  const double lower = halve(0, upper, [&](double t) { return truth.depth_before(t).high > touching; }).first;
  expect.outcome = Outcome::hit;
  expect.toi_lower = lower;
  expect.toi_upper = upper;
  return expect;
}

Expect rotating_expectation(corpus::Case problem) {
  if (problem.query == Query::line) throw Undecided("a line has no meaning where bodies turn");
  const bool any_time = problem.query == Query::swept_overlap;
  if (any_time) problem.start_policy = corpus::StartPolicy::report;
  if (std::isinf(problem.t_max)) throw Undecided("a rotating cast with an infinite t_max");
  if (problem.start_policy == corpus::StartPolicy::pass_over) {
    problem.start_policy = corpus::StartPolicy::report;
    if (std::optional<Expect> followed = followed_expectation(problem)) return *followed;
  }
  const RotatingTruth truth(problem, kExpectedWidth);
  if (truth.outcome() == Outcome::not_converged && !(any_time && truth.contact_proved())) {
    throw Undecided(truth.reason());
  }
  Expect expect;
  expect.by = "time subdivision in balls";
  if (any_time) {
    expect.outcome = truth.outcome() == Outcome::miss ? Outcome::miss : Outcome::hit;
    return expect;
  }
  expect.outcome = truth.outcome();
  expect.toi_lower = truth.toi_lower();
  expect.toi_upper = truth.toi_upper();
  return expect;
}

}  // namespace

Expect derive_expectation(const corpus::Case& given) {
  const DefaultEnvironment environment;
  corpus::Case problem = given;
  if (turns(given)) {
    switch (given.query) {
      case Query::cast:
      case Query::line:
      case Query::swept_overlap:
        return rotating_expectation(given);
      case Query::overlap:
      case Query::distance:
      case Query::penetration:
      case Query::penetration_along:
        problem.spin_a = problem.spin_b = {};  // asked at t = 0
    }
  }
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
