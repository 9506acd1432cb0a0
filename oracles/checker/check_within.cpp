#include "oracles/checker/check_within.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/support_value.hpp"
#include "oracles/arithmetic/default_environment.hpp"

namespace graze::oracle {

using corpus::Case;

namespace {

// The checker reads no magnitudes of a case below 1e-60. Smaller ones are left out, and counted.
constexpr double kLeast = 1e-60;

[[nodiscard]] double flushed(double x, double& lost) {
  if (x == 0 || std::abs(x) >= kLeast) return x;
  lost += kLeast;
  return 0;
}

// The body's own pose made a part of its shape, so that points in world axes can be added to it exactly. The indices of
// vertices stay: points have one each.
void add_points(Body<double>& body, std::initializer_list<Vec3<double>> points) {
  Sum<double> sum;
  sum.shapes.push_back(share<double>(
      Posed<double>{share<double>(std::move(body.shape)), Vec3<double>::Zero(), body.orientation}));
  for (const Vec3<double>& x : points) {
    if (!x.isZero(0))
      sum.shapes.push_back(share<double>(Posed<double>{share<double>(Point<double>{}), x, {}}));
  }
  body.shape = std::move(sum);
  body.orientation = {};
}

// A vector along n, no longer than `length`. It is 0 if n has no direction.
[[nodiscard]] Vec3<double> step_along(const Vec3<double>& n, double length) {
  const Vec3<double> unit = n.stableNormalized();
  if (!unit.allFinite()) return Vec3<double>::Zero();
  // The unit vector and the products round by some 2^-51 together.
  double lost = 0;
  return (unit * (length * (1 - 0x1p-48))).unaryExpr([&](double x) { return flushed(x, lost); });
}

[[nodiscard]] Verdict check_axis(Case problem, Proof proof, double length) {
  const Vec3<double> v = problem.b.displacement - problem.a.displacement;
  const Vec3<double> d = proof.symbolic ? step_along(v, length) : step_along(-proof.axis, length);
  add_points(problem.a, {d});
  proof.toi_upper = kInfinity<double>;
  proof.portal_size = 0;
  return check_proof(problem, proof);
}

// The place of the body at t = `from`: the exact product is added to its position.
void start_at(Body<double>& body, double from, double& lost) {
  Vec3<double> high, low;
  for (int i = 0; i < 3; ++i) {
    const double product = from * body.displacement[i];
    high[i] = flushed(product, lost);
    low[i] = flushed(std::fma(from, body.displacement[i], -product), lost);
  }
  add_points(body, {high, low});
}

// x - y or a little less, not below 0, for x >= y.
[[nodiscard]] double at_most_difference(double x, double y) {
  if (y == 0 || !(x < kInfinity<double>)) return x;
  const double difference = x - y;
  return difference > 0 ? std::nextafter(difference, 0) : 0;
}

// Points that rounding left outside of their ball or their part, moved towards its centre, which lies within.
void pull_inwards(Proof& proof, double most) {
  const auto pull = [&](Vec3<double>& x) {
    const double length = x.stableNorm();
    if (length > 0) x *= std::max(0.0, 1 - most / length);
  };
  for (int i = 0; i < proof.portal_size; ++i) {
    SupportPair& pair = proof.portal[static_cast<std::size_t>(i)];
    for (Feature* feature : {&pair.a, &pair.b}) {
      pull(feature->offset);
      for (Vec3<double>& x : feature->curved) pull(x);
    }
  }
}

[[nodiscard]] bool is_outside(Refusal refusal) {
  return refusal == Refusal::offset_too_long || refusal == Refusal::point_outside;
}

[[nodiscard]] Verdict check_portal(Case problem, Proof proof, double length) {
  const double from = proof.toi_lower;
  double lost = 0;
  if (from > 0) {
    start_at(problem.a, from, lost);
    start_at(problem.b, from, lost);
    // S has no contact before, so that no policy of starts applies to it.
    problem.start_policy = corpus::StartPolicy::report;
  }
  const double granted = length - lost;
  if (!(granted > 0))
    return {Refusal::portal_off_path, "too little is granted for numbers as small as these"};
  problem.target_distance = std::nextafter(problem.target_distance + granted, 0);
  problem.t_max = at_most_difference(problem.t_max, from);
  proof.toi_upper = at_most_difference(proof.toi_upper, from);
  proof.toi_lower = 0;
  proof.has_axis = false;
  Verdict verdict = check_proof(problem, proof);
  if (!is_outside(verdict.refusal)) return verdict;
  pull_inwards(proof, length / 16);
  return check_proof(problem, proof);
}

// Refusals that rounding may be the cause of.
[[nodiscard]] bool is_by_rounding(Refusal refusal) {
  switch (refusal) {
    case Refusal::offset_too_long:
    case Refusal::point_outside:
    case Refusal::lower_not_proved:
    case Refusal::miss_not_proved:
    case Refusal::portal_off_path:
    case Refusal::upper_not_proved:
      return true;
    default:
      return false;
  }
}

struct Box3 {
  Vec3<double> low, high;
  [[nodiscard]] Vec3<double> center() const { return low / 2 + high / 2; }
  [[nodiscard]] double diagonal() const { return (high - low).stableNorm(); }
  [[nodiscard]] double magnitude() const {
    return std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  }
};

// Bounds of the rotated shape, relative to the body's position.
[[nodiscard]] Box3 bounds_of(const Body<double>& body) {
  const corpus::Bounds box = corpus::bounds(body.shape, body.orientation);
  return {box.low, box.high};
}

}  // namespace

Verdict check_proof_within(const Case& problem, const Proof& proof, double length) {
  const DefaultEnvironment environment;
  Verdict exact = check_proof(problem, proof);
  if (!is_by_rounding(exact.refusal) || !(length > 0)) return exact;
  const bool claims_upper = proof.toi_upper < kInfinity<double>;
  if (claims_upper && !(proof.toi_lower <= std::min(proof.toi_upper, problem.t_max))) return exact;
  if (proof.toi_lower > 0 && !check_axis(problem, proof, length).accepted()) return exact;
  if (claims_upper && !check_portal(problem, proof, length).accepted()) return exact;
  return {};
}

RecordVerdict check_record_within(const corpus::ProofRecord& record, Kappas kappa, bool* exactly) {
  const double of_proof = rounding_granted(record, kappa.of_proof),
               of_bracket = rounding_granted(record, std::max(kappa.of_proof, kappa.of_bracket));
  RecordVerdict exact = check_record(record, of_bracket);
  if (exactly != nullptr) *exactly = true;
  // If the proof is true, rounding does not explain a record that contradicts or exceeds it.
  const bool is_false =
      exact.finding == RecordFinding::refused && exact.reason != "contradicted" && exact.reason != "unproved";
  if (!is_false || record.rotating || !(of_proof > 0)) return exact;
  if (!check_proof_within(record.problem, record.proof, of_proof).accepted()) return exact;
  if (exactly != nullptr) *exactly = false;
  return compare_claim(record, of_bracket);
}

double rounding_granted(const corpus::ProofRecord& record, double kappa) {
  const double u = record.scalar == "float" ? kUnitRoundoff<float> : kUnitRoundoff<double>;
  const double length = kappa * u * scale_from_below(record.problem) * (1 - 0x1p-50);
  return std::isfinite(length) ? length : 0;
}

// At most the scale, unless rounding of the poses lost more than a hundredth of it (hulls far from their own
// origin). Then the error of the coordinates is subtracted.
double scale_from_below(const Case& problem) {
  const Box3 a = bounds_of(problem.a), b = bounds_of(problem.b);
  const double centers = (problem.b.position - problem.a.position + b.center() - a.center()).stableNorm();
  const double coordinates =
      a.magnitude() + b.magnitude() + problem.a.position.stableNorm() + problem.b.position.stableNorm();
  const double scale = std::max({a.diagonal(), b.diagonal(), centers});
  return std::max(0.0, 0.99 * scale - 64 * kUnitRoundoff<double> * coordinates);
}

}  // namespace graze::oracle
