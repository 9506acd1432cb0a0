// Judges the answers to queries between bodies that the exact oracles do not represent: ellipsoids,
// cylinders, cones and what is made of them.
//
// As properties/judge/judge.hpp, by brackets that ball arithmetic proves (oracles/truth/bracket_truth.hpp) in
// the place of exact numbers: a fault is what a bracket proves beyond the limit, and a verdict that the
// bracket leaves open is excused. The normals of misses, and of penetrations along a direction, are not
// judged.
#pragma once

#include "properties/judge/judge.hpp"

namespace graze::tool {

// `problem` is the case as the method saw it, valid and without rotation.
[[nodiscard]] law::QueryJudgement judge_curved_query(const corpus::Case& problem,
                                                     const engine::Method& method,
                                                     const engine::Answer& answer,
                                                     const law::QueryLimits& limits);

}  // namespace graze::tool
