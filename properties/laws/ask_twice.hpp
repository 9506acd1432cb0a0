// Shared by the laws that call a method twice: two questions with one answer, and the decision about which answer is at
// fault if they differ.
#pragma once

#include "corpus/support_value.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/linear_faults.hpp"

namespace graze::law {

// An edit must survive the rounding to the method's scalar, or the two questions are not the intended ones. The method
// must also answer it.
[[nodiscard]] inline bool is_sound_edit(const corpus::Case& edited, const engine::Method& method) {
  return is_question_for(method, edited) && same_input(method.seen(edited), edited);
}

[[nodiscard]] inline LawResult outside() { return not_applicable("not a cast that the method answers"); }

// A lower bound of the scale, without an oracle: half the largest extent of a body along an axis of its own.
[[nodiscard]] inline double half_extent(const corpus::Case& problem) {
  double most = 0;
  for (const Body<double>* body : {&problem.a, &problem.b}) {
    const corpus::Bounds box = corpus::bounds(body->shape);
    most = std::max(most, (box.high - box.low).maxCoeff() / 2);
  }
  return most;
}

// Equal verdicts, and times that lie within both guarantees by the path between them. No oracle is needed then. It
// returns false for a graze, where right times may be far apart.
[[nodiscard]] inline bool agree_within_rows(const engine::Method& method, const corpus::Case& seen,
                                            const engine::Answer& one, const engine::Answer& other) {
  if (agree(one, other, method.unit_roundoff)) return true;
  const double gap = std::max(one.toi_lower - other.toi_upper, other.toi_lower - one.toi_upper);
  // Open both times. Another law limits how often that may happen.
  if (one.outcome == Outcome::not_converged && other.outcome == one.outcome) return gap <= 0;
  if (one.outcome != Outcome::hit || other.outcome != Outcome::hit || method.is_exact()) return false;
  const double row = method.is_certified() ? 0 : kappa(method, seen) * method.unit_roundoff;
  return gap * velocity(seen).stableNorm() <= 2 * row * half_extent(seen);
}

// Two cases with one contact, at one time. `seen` is the case as the method sees it, and `other` a sound edit.
[[nodiscard]] inline LawResult same_contact(const engine::Method& method, const corpus::Case& seen,
                                            const corpus::Case& other, std::string_view name,
                                            std::string_view disagreement) {
  const engine::Answer one = method.ask(seen, {}), two = method.ask(other, {});
  LawResult result = agree(one, two, method.unit_roundoff)
                         ? holds()
                         : arbitrate(method, {{"the original", seen, one}, {name, other, two}}, disagreement);
  if (result.holding == Holding::holds) result.labels.push_back(label_of(one.outcome));
  return result;
}

}  // namespace graze::law
