// The judge: is the verdict right, is the time never late, is contact not claimed before there is any, is the
// bracket as near as its guarantee says, are the claims of its proof true?
//
// One function judges every question. `truth` is about the case as the method saw it. The method's guarantee states the
// tolerated errors (limits.hpp). The proof of an answer comes first: if the checker accepts it, and it leaves nothing
// of the answer open, no oracle is called. The oracle decides the rest, and measures on request, as for a sample.
#pragma once

#include "properties/judge/judgement.hpp"
#include "properties/judge/truth.hpp"

namespace graze::law {

// `request`: the request of the cast. `measure`: call the oracle in any case.
[[nodiscard]] Judgement judge(Truth& truth, const engine::Method& method, const engine::Answer& answer,
                              Request request, bool measure);

// By kind, and for linear casts by tier. Tier exact is judged to the last bit (exact_answer.hpp). Queries have no
// proof, and are always measured: by the exact oracles, or by proved brackets for bodies that these do not represent.
[[nodiscard]] Judgement judge_linear(Truth& truth, const engine::Method& method, const engine::Answer& answer,
                                     Request request, bool measure);
// `tolerance`: the query's tolerance, over scale, by which a bracket may be wider.
[[nodiscard]] Judgement judge_query(Truth& truth, const engine::Method& method, const engine::Answer& answer,
                                    double tolerance = 0);
[[nodiscard]] Judgement judge_rotating(Truth& truth, const engine::Method& method,
                                       const engine::Answer& answer, Request request, bool measure);

// For queries between bodies that the exact oracles do not represent: ellipsoids, cylinders, cones and shapes made of
// them. A fault is an error that a bracket proves to be beyond the limit. A verdict that the bracket leaves open is
// within tolerance. The normals of misses, and of penetrations along a direction, are not judged.
[[nodiscard]] Judgement judge_curved_query(const corpus::Case& seen, const engine::Method& method,
                                           const engine::Answer& answer, double tolerance = 0);

// The errors of an answer to a linear cast against any truth: for a float answer, against the input before it
// was rounded.
[[nodiscard]] Errors errors_of(Truth& truth, const engine::Answer& answer, Request request);

}  // namespace graze::law
