#include "properties/judge/by_proof.hpp"

#include <algorithm>
#include <cmath>

#include "oracles/checker/check_within.hpp"
#include "properties/judge/limits.hpp"

namespace graze::law {

using engine::Answer;

namespace {

// An upper bound of the backward error of time t that an accepted proof implies (infinity: none).
//   distance of t v from C   <= |s - t| |v|, for the contact at s in [proof.toi_lower, proof.toi_upper].
//   depth of the path over [0, t)  <= (t - proof.toi_lower) |n.v| / |n|: move C by that much against n, and
//   the axis proves that the path up to t misses it.
// For a symbolic axis, and for a ray whose claim needs none, |n.v| / |n| is taken as its bound |v|.
double proved_backward_error(const Proof& proof, const Vec3<double>& v, double t) {
  const double apart = std::max({proof.toi_upper - t, t - proof.toi_lower, 0.0}) * v.norm();
  const bool by_triple = proof.has_axis && !proof.symbolic;
  const double slope = by_triple ? std::abs(proof.axis.normalized().dot(v)) : v.norm();
  const bool claims = proof.has_axis || proof.toi_lower > 0;
  const double before =
      t > proof.toi_lower ? (claims ? (t - proof.toi_lower) * slope : kInfinity<double>) : 0;
  return kSlack * std::max(apart, before);
}

}  // namespace

bool proves_verdict(const Proof& proof, Outcome outcome) {
  switch (outcome) {
    case Outcome::miss:
      return proof.toi_lower == kInfinity<double>;
    case Outcome::hit:
      return proof.toi_upper < kInfinity<double>;
    case Outcome::initially_overlapping:
      return proof.toi_upper == 0;
    default:
      return false;
  }
}

bool is_settled_by(const Proof& proof, const engine::Method& method, const corpus::Case& seen,
                   const Answer& answer) {
  if (!proves_verdict(proof, answer.outcome)) return false;
  if (answer.outcome != Outcome::hit) return true;
  const Vec3<double> v = seen.b.displacement - seen.a.displacement;
  const double error = std::max(proved_backward_error(proof, v, answer.toi_lower),
                                proved_backward_error(proof, v, answer.toi_upper));
  const double scale = oracle::scale_from_below(seen);
  if (method.is_certified()) {
    const Limits limits = limits_of(method, seen, scale);
    const double width = method.guarantee != nullptr ? method.guarantee->width.value_or(0) * scale : 0;
    const bool holds = answer.toi_lower <= proof.toi_lower && proof.toi_upper <= answer.toi_upper;
    return holds && error <= width + (limits.rounds_times ? limits.rounding_at(answer.toi_lower) : 0);
  }
  const double rounding = 8 * kUnitRoundoff<double> *
                          (seen.a.displacement.norm() + seen.b.displacement.norm()) * answer.toi_upper;
  return error + rounding <= kappa(method, seen) * method.unit_roundoff * scale;
}

bool proves(const RotatingProof& proof, const Answer& answer) {
  switch (answer.outcome) {
    case Outcome::miss:
      return proof.toi_lower == kInfinity<double>;
    case Outcome::initially_overlapping:
      return proof.toi_upper == 0;
    case Outcome::hit:
    case Outcome::not_converged:
      return proof.toi_lower >= answer.toi_lower && proof.toi_upper <= answer.toi_upper;
    case Outcome::invalid_input:
      break;
  }
  return false;
}

}  // namespace graze::law
