// The expected answer of a case, by the exact oracle: what the corpus stores and a later run derives again.
#pragma once

#include "corpus/case.hpp"

namespace graze::oracle {

// Fills `by` and outcome. A cast, ray or line also gets toi_lower, toi_upper and toi_exact (empty if
// irrational). An overlap or distance query is asked at t = 0: its outcome is initially_overlapping or miss,
// and `distance` (target distance not counted) is the nearest double. A line query between polytopes also
// gets t_in and t_out where the line meets the CSO. Throws std::invalid_argument for what LinearTruth does
// not decide.
[[nodiscard]] corpus::Expect derive_expectation(const corpus::Case& problem);

}  // namespace graze::oracle
