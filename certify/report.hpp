// The result of a certification as text: a verdict in one line, then a screen (40 lines, 110 columns), then all tables.
#pragma once

#include <string>

#include "certify/certification.hpp"

namespace graze::tool {

// The verdict: how many cases and answers were judged, how many failed, and whether every method keeps its guarantee.
// If there are fewer answers than kFewAnswers, it says that this certifies little.
inline constexpr std::size_t kFewAnswers = 10;
[[nodiscard]] std::string verdict_line(const Certification& certification, double seconds);

// A line for each kind of fault: the number of answers with it as their worst, the numbers of methods and families, and
// the first case. Then the other broken guarantees. Empty if every guarantee is kept.
[[nodiscard]] std::vector<std::string> fault_lines(const Certification& certification);

// A line for each method, with both scalars side by side: answers, faults, open answers, proofs, the worst error over
// its limit and its family, the most support evaluations, and the time.
[[nodiscard]] std::string summary_table(const Certification& certification, const Settings& settings);

// All tables of one kind of method, with the meaning of the columns. Empty if there is no method of the kind.
[[nodiscard]] std::string full_tables(const Certification& certification, const Settings& settings);

// The methods, their guarantees, and whether they were kept. For queries it includes the counts.
[[nodiscard]] std::string guarantee_table(engine::Kind kind, const Certification& certification,
                                          const Settings& settings);

// A line a method and family.
[[nodiscard]] std::string tally_table(engine::Kind kind, const Certification& certification);

// A summary of the exact tier's casts: how many, how many were wrong or did not converge, and the failure rate that
// this number without a failure bounds at 95 % confidence. Empty without a method of that tier.
[[nodiscard]] std::string exact_summary(const Certification& certification, const Settings& settings);

}  // namespace graze::tool
