#include "properties/laws/linear/proof.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "oracles/checker/check_proof.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;

namespace {

std::string bracket_fault(const Case& seen, const Answer& answer) {
  const double lower = answer.toi_lower, upper = answer.toi_upper;
  switch (answer.outcome) {
    case Outcome::initially_overlapping:
      return lower == 0 && upper == 0 ? "" : "a start in contact not at time 0";
    case Outcome::hit:
      if (is_beyond_range(lower, upper, kUnitRoundoff<float>) && std::isinf(seen.t_max)) return "";
      if (!(lower >= 0 && lower <= upper && upper > 0 && std::isfinite(upper)))
        return "a hit without a bracket";
      return lower <= seen.t_max ? "" : "a hit beyond t_max";
    case Outcome::miss:
      return std::isinf(lower) && std::isinf(upper) && lower > 0 ? "" : "a miss with a time";
    case Outcome::not_converged:
      return lower >= 0 && lower <= upper ? "" : "no bracket is handed in";
    case Outcome::invalid_input:
      return "a valid case was refused";
  }
  return "no such outcome";
}

LawResult answer_is_consistent(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  const Request request = Request::normal | Request::witnesses;
  const Answer answer = method.ask(seen, {.request = request});
  const std::string fault = consistency_fault(seen, method, answer, request);
  if (!fault.empty()) return broken(fault + ": " + describe(answer));
  return holds({label_of(answer.outcome)});
}

LawResult proof_is_accepted(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  const Answer answer = method.ask(seen, {.request = Request::proof});
  const std::string fault = proof_fault(seen, answer);
  if (!fault.empty()) return broken(fault + "; answered: " + describe(answer));
  LawResult result = holds({label_of(answer.outcome)});
  if (!answer.proof) result.labels.push_back("no proof");
  return result;
}

LawResult bad_input_is_refused(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_question_for(method, seen)) return not_applicable("not a cast that the method answers");
  std::string fault;
  const auto expect_refusal = [&](const Case& bad, const std::string& what) {
    const Answer answer = method.ask(bad, {.request = Request::everything});
    if (answer.outcome == Outcome::invalid_input && answer.invalid != Invalid::none &&
        answer.counters.iterations == 0 && std::isnan(answer.toi_lower) && std::isnan(answer.toi_upper)) {
      return;
    }
    if (fault.empty()) fault = fmt::format("{} is let in: {}", what, describe(answer));
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = kInfinity<double>;
  // Every scalar of a small case, and a share of a large hull's, chosen by its numbers.
  constexpr std::size_t kMostPoisoned = 32;
  const std::size_t count = scalars(seen).size(), stride = (count + kMostPoisoned - 1) / kMostPoisoned;
  for (std::size_t i = hash_of(seen) % stride; i < count; i += stride) {
    for (const double poison : {kNan, kInf, -kInf, std::numeric_limits<double>::max()}) {
      std::size_t at = 0;
      bool bad = true;
      const Case poisoned = map_scalars(seen, [&](Slot slot, double x) {
        if (at++ != i) return x;
        // The horizon may be infinite, and has no least or greatest value.
        if (slot == Slot::horizon && poison > 0) bad = false;
        return poison;
      });
      if (bad) expect_refusal(poisoned, fmt::format("{} as scalar number {}", poison, i));
    }
  }
  for (const bool first : {true, false}) {
    Case bad = seen;
    Body<double>& body = first ? bad.a : bad.b;
    body.orientation = {0, 0, 0, 0};
    expect_refusal(bad, "a zero quaternion");
    body.orientation = {};
    body.shape = Hull<double>();
    expect_refusal(bad, "an empty hull");
    body.shape = Sphere<double>{-1};
    expect_refusal(bad, "a negative radius");
    body.shape = Box<double>{{1, -0x1p-30, 1}};
    expect_refusal(bad, "a negative half extent");
    body.shape = Ellipsoid<double>{{1, 1, -0x1p-30}};
    expect_refusal(bad, "a negative radius of an ellipsoid");
    body.shape = Cone<double>{1, -1};
    expect_refusal(bad, "a negative half height");
    body.shape = Rounded<double>{share<double>(Point<double>{}), -1};
    expect_refusal(bad, "a negative rounding");
    body.shape = Sum<double>{};
    expect_refusal(bad, "a sum of nothing");
    body.shape = HullOf<double>{{share<double>(Point<double>{}), nullptr}};
    expect_refusal(bad, "a missing part");
    body.shape = posed<double>(Point<double>{}, Vec3<double>::Zero(), {0, 0, 0, 0});
    expect_refusal(bad, "a zero quaternion in a part");
    body.shape = Point<double>{};
    for (int depth = 0; depth < 17; ++depth) body.shape = rounded<double>(std::move(body.shape), 0);
    expect_refusal(bad, "parts nested deeper than 16");
    body.shape = Box<double>{};
    for (int twice = 0; twice < 4; ++twice) body.shape = sum<double>(body.shape, body.shape);
    expect_refusal(bad, "a sum of 2^48 vertices");
  }
  Case bad = seen;
  bad.target_distance = -1;
  expect_refusal(bad, "a negative target distance");
  bad.target_distance = seen.target_distance;
  bad.t_max = -1;
  expect_refusal(bad, "a negative t_max");
  if (!fault.empty()) return broken(fault);
  return holds({label_of(method.ask(seen, {}).outcome)});
}

}  // namespace

std::string consistency_fault(const Case& seen, const Method& method, const Answer& answer, Request request) {
  if (std::string fault = bracket_fault(seen, answer); !fault.empty()) return fault;
  if (answer.outcome != Outcome::hit) return "";
  const double u = method.unit_roundoff;
  if (asks_for(request, Request::normal)) {
    if (!(std::abs(answer.normal.norm() - 1) <= 8 * u)) return "a normal of a length other than 1";
    const Vec3<double> v = velocity(seen);
    // Divided first: the products of extreme lengths may leave the exponent range.
    const double speed = v.stableNorm();
    const double receding = speed > 0 ? answer.normal.dot(v / speed) : 0;
    if (!(receding <= contact_kappa(method, seen) * u)) {
      return fmt::format("a normal along the motion, n.v = {} |v|", receding);
    }
  }
  if (asks_for(request, Request::witnesses) && !(answer.point_a.allFinite() && answer.point_b.allFinite())) {
    return "a witness that is not a point";
  }
  return "";
}

std::string proof_fault(const Case& seen, const Answer& answer) {
  if (!answer.proof) return "";
  const oracle::Verdict verdict = oracle::check_proof(seen, *answer.proof);
  if (verdict.accepted() || verdict.refusal == oracle::Refusal::out_of_range) return "";
  return fmt::format("proof refused, {}: {}", oracle::to_string(verdict.refusal), verdict.detail);
}

std::vector<Law> linear_proof_laws() {
  return {
      {"answer_is_consistent",
       "Outcome and bracket agree. A normal is a unit vector and does not follow the motion.",
       Needs::metamorphic, &answer_is_consistent},
      {"bad_input_is_refused",
       "A NaN, an infinity, an empty hull, a negative extent or q = 0 is refused at the door.",
       Needs::metamorphic, &bad_input_is_refused},
      {"proof_is_accepted", "Every proof is accepted by the checker.", Needs::proof, &proof_is_accepted},
  };
}

}  // namespace graze::law
