// The results of a certification for third-party engines: their certificates, and all counts.
#pragma once

#include <string>

#include "certify/certification.hpp"

namespace graze::tool {

// The limit that an engine is judged by, in words: "1e-09 scale".
[[nodiscard]] std::string limit_text(const engine::Guarantee& row);

// A line for each method of a third-party engine: the number of answers, the failures, and the faults. It also has the
// least limits with which verdicts and times would have passed, as kappa, over scale and as a length, with the case
// that needs them.
[[nodiscard]] std::string certificates(const Certification& certification, const Settings& settings);

// The time of a call, by family, for the engines that time their own calls in machine code, beside our methods that are
// judged with them. Empty if there is no such engine.
[[nodiscard]] std::string time_table(const Certification& certification, const Settings& settings);

// All that was counted, of every method, as one JSON object: graze.certification/1.
[[nodiscard]] std::string certification_json(const Certification& certification, const Settings& settings,
                                             double seconds);

// The same for build servers, in JUnit's XML: a suite for each method, a test for each family. The test fails if the
// method breaks its guarantee on the family. It then shows the first case of each fault and the reason.
[[nodiscard]] std::string certification_junit(const Certification& certification, const Settings& settings,
                                              double seconds);

}  // namespace graze::tool
