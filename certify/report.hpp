// What a certification comes to, as text: a verdict in one line, then a screen (40 lines, 110 columns), then
// everything.
#pragma once

#include <string>

#include "certify/certification.hpp"

namespace graze::tool {

// How many cases and answers were judged, how many were found wanting, and whether every method keeps its
// row. That fewer answers than kFewAnswers keep it is said to certify little.
inline constexpr std::size_t kFewAnswers = 10;
[[nodiscard]] std::string verdict_line(const Certification& certification, double seconds);

// A line for each kind of fault: how many answers have it as their worst, of how many methods, in how many families, and
// the first. Then what breaks a guarantee otherwise. Empty if every guarantee is kept.
[[nodiscard]] std::vector<std::string> fault_lines(const Certification& certification);

// A line a method, both scalars side by side: answers, faults, open answers, proofs, the worst error over its limit and
// where that was, the most support evaluations, time.
[[nodiscard]] std::string summary_table(const Certification& certification, const Settings& settings);

// Everything, with what the columns mean. Of one kind of method; empty where there is none of it.
[[nodiscard]] std::string full_tables(const Certification& certification, const Settings& settings);

// Which methods there are, what their rows promise, and whether it was kept; of queries with what was
// counted.
[[nodiscard]] std::string guarantee_table(engine::Kind kind, const Certification& certification,
                                          const Settings& settings);

// A line a method and family.
[[nodiscard]] std::string tally_table(engine::Kind kind, const Certification& certification);

// What the exact tier's casts come to: how many, how many wrong or stalled, and the rate of failures that so
// many without one allow at 95 %; empty without a method of that tier.
[[nodiscard]] std::string exact_summary(const Certification& certification, const Settings& settings);

}  // namespace graze::tool
