// What a certification says of engines of others: their certificates, and all that was counted.
#pragma once

#include <string>

#include "certify/certification.hpp"

namespace graze::tool {

// What an engine is held to, in words: "1e-09 scale".
[[nodiscard]] std::string limit_text(const engine::Guarantee& row);

// Of each method of others in a line: how many answers, what kept it from answering, faults, and the least limits with
// which verdicts and times would have passed, kappa, over scale, and as a length, with the case that needs them.
[[nodiscard]] std::string certificates(const Certification& certification, const Settings& settings);

// What a call takes, by family, of the engines that time their own calls in machine code, beside ours that are judged with
// them. Empty where there is no such engine.
[[nodiscard]] std::string time_table(const Certification& certification, const Settings& settings);

// All that was counted, of every method, as one JSON object: graze.certification/1.
[[nodiscard]] std::string certification_json(const Certification& certification, const Settings& settings,
                                             double seconds);

// The same for build servers, JUnit's XML: of each method a suite, of each family a test; a family on which the method
// does not keep its row has failed, with the first case of each fault and the reason.
[[nodiscard]] std::string certification_junit(const Certification& certification, const Settings& settings,
                                              double seconds);

}  // namespace graze::tool
