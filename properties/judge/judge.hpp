// The judge: is the verdict right, is the time never late, is contact not claimed before there is any, is the
// bracket as near as its guarantee says, are the claims of its proof true?
//
// One function for every question. `truth` is about the case as the method saw it; the method's row of the
// guarantees says what is let pass (limits.hpp). An answer is looked at by its proof first: where the checker
// accepts it, and what it proves leaves nothing of the answer open, no oracle is asked. The oracle decides
// the rest, and measures whatever it is asked to, as for a sample.
#pragma once

#include "properties/judge/judgement.hpp"
#include "properties/judge/truth.hpp"

namespace graze::law {

// `request`: what the method was asked for. `measure`: ask the oracle in any case.
[[nodiscard]] Judgement judge(Truth& truth, const engine::Method& method, const engine::Answer& answer,
                              Request request, bool measure);

// By kind; of linear casts by tier. Tier exact is judged to the last bit (exact_answer.hpp); queries have no
// proof, and are always measured: by the exact oracles, and of bodies that these do not represent by proved
// brackets.
[[nodiscard]] Judgement judge_linear(Truth& truth, const engine::Method& method, const engine::Answer& answer,
                                     Request request, bool measure);
// `tolerance`: what the query was asked with, over scale: what a bracket may be wider by.
[[nodiscard]] Judgement judge_query(Truth& truth, const engine::Method& method, const engine::Answer& answer,
                                    double tolerance = 0);
[[nodiscard]] Judgement judge_rotating(Truth& truth, const engine::Method& method,
                                       const engine::Answer& answer, Request request, bool measure);

// Of queries between bodies that the exact oracles do not represent: ellipsoids, cylinders, cones and what is
// made of them. A fault is what a bracket proves beyond the limit, and a verdict that the bracket leaves open
// is within tolerance. The normals of misses, and of penetrations along a direction, are not judged.
[[nodiscard]] Judgement judge_curved_query(const corpus::Case& seen, const engine::Method& method,
                                           const engine::Answer& answer, double tolerance = 0);

// The errors of an answer to a linear cast against any truth: for a float answer, against the input before it
// was rounded.
[[nodiscard]] Errors errors_of(Truth& truth, const engine::Answer& answer, Request request);

}  // namespace graze::law
