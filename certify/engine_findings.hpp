// Findings about third-party engines, prepared for the people who fix them: the first case of each kind of fault of
// each method, reduced to a small case by running the engine itself.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "certify/certification.hpp"

namespace graze::tool {

struct EngineFinding {
  const engine::Method* method = nullptr;
  std::string fault;      // a name in law::kFaultKinds, with the kind of a failure: "wrong", "failed:
                          // crashed"
  std::string reason;     // reason for the small case
  std::string family;     // the family in which it occurred first
  std::string first;      // the case, before it was made small
  std::size_t times = 0;  // on how many of that family's cases
  corpus::Case problem;   // small
};

// A fault stays the fault that it was, while the case is made small, and a body that has an inside keeps one. At most `budget` questions, and `seconds`, each.
[[nodiscard]] std::vector<EngineFinding> engine_findings(const Certification& certification, int budget,
                                                         double seconds);

// Writes each finding as a case, ENGINE-QUESTION-FAULT.json, into the folder, which is created. The comment of the case
// is the reason. Returns a line for each. Throws std::runtime_error with a one-line message.
[[nodiscard]] std::string save_findings(const std::vector<EngineFinding>& findings,
                                        const std::filesystem::path& directory);

}  // namespace graze::tool
