// The laws of rotating casts that need the checker of proofs.
#include <fmt/format.h>

#include <algorithm>

#include "engines/method.hpp"
#include "oracles/checker/check_rotating_proof.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/rotating/question.hpp"
#include "properties/laws/tables.hpp"

namespace graze::law {

using corpus::Case;
using engine::Answer;
using engine::Method;

namespace {

// The number of points of curved parts in a point of the shape. A proof's feature names kCurvedParts.
std::size_t curved_points(const Shape<double>& shape) {
  const auto of_part = [](const SharedShape<double>& part) { return part ? curved_points(part->shape) : 0; };
  if (const auto* posed = std::get_if<Posed<double>>(&shape)) return of_part(posed->shape);
  if (const auto* rounded = std::get_if<Rounded<double>>(&shape)) return of_part(rounded->shape);
  std::size_t count = 0;
  if (const auto* sum = std::get_if<Sum<double>>(&shape)) {
    for (const auto& part : sum->shapes) count += of_part(part);
    return count;
  }
  if (const auto* hull = std::get_if<HullOf<double>>(&shape)) {
    for (const auto& part : hull->shapes) count = std::max(count, of_part(part));
    return count;
  }
  return std::holds_alternative<Ellipsoid<double>>(shape) ||
                 std::holds_alternative<Cylinder<double>>(shape) ||
                 std::holds_alternative<Cone<double>>(shape)
             ? 1
             : 0;
}

LawResult turning_proof_is_accepted(const Case& problem, const Method& method) {
  const Case seen = method.seen(problem);
  if (!is_rotating_question(seen)) return no_rotating_question();
  const Answer answer = method.ask(seen, {.request = Request::proof});
  if (!answer.rotating_proof) {
    // A bracket that claims nothing needs no proof.
    const bool claims = answer.toi_lower > 0 || answer.toi_upper < kInfinity<double>;
    if (method.is_certified() && claims)
      return broken("a certified answer without a proof: " + describe(answer));
    return holds({label_of(answer.outcome), "no proof"});
  }
  const RotatingProof& proof = *answer.rotating_proof;
  const oracle::RotatingVerdict verdict = oracle::check_rotating_proof(seen, proof);
  if (!verdict.accepted() && verdict.refusal != oracle::RotatingRefusal::out_of_range) {
    return broken(fmt::format("proof refused, {}: {}; answered: {}", oracle::to_string(verdict.refusal),
                              verdict.detail, describe(answer)));
  }
  // In doubles, before the times are rounded to the scalar. A start that counts as contact because it is near
  // has no upper half. Neither has a contact whose points cannot be named.
  const bool near = (answer.outcome == Outcome::initially_overlapping && !method.is_certified()) ||
                    std::max(curved_points(seen.a.shape), curved_points(seen.b.shape)) > kCurvedParts;
  if (!(proof.toi_lower >= answer.toi_lower) || !(near || proof.toi_upper <= answer.toi_upper)) {
    return broken(fmt::format("the proof says [{}, {}] only; answered: {}", decimal(proof.toi_lower),
                              decimal(proof.toi_upper), describe(answer)));
  }
  return holds({label_of(answer.outcome)});
}

}  // namespace

std::vector<Law> rotating_proof_laws() {
  return {
      {"turning_proof_is_accepted", "Every proof is accepted, and says as much as the answer.", Needs::proof,
       &turning_proof_is_accepted},
  };
}

}  // namespace graze::law
