// What engines of others were convicted of, made ready for whoever mends it: of each method and each kind of fault the
// first case, made small under the engine itself.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "certify/certification.hpp"

namespace graze::tool {

struct EngineFinding {
  const engine::Method* method = nullptr;
  std::string fault;      // of law::kFaultKinds, and of what failed how: "wrong", "failed: crashed"
  std::string reason;     // of the small case
  std::string family;     // where it was met first
  std::string first;      // the case, before it was made small
  std::size_t times = 0;  // on how many of that family's cases
  corpus::Case problem;   // small
};

// A fault stays the fault that it was, while the case is made small, and a body that has an inside keeps one. At most `budget` questions, and `seconds`, each.
[[nodiscard]] std::vector<EngineFinding> engine_findings(const Certification& certification, int budget,
                                                         double seconds);

// Writes each as a case, ENGINE-QUESTION-FAULT.json, into the folder, which is made; its comment is the reason. Returns
// a line each. Throws std::runtime_error with one line to show.
[[nodiscard]] std::string save_findings(const std::vector<EngineFinding>& findings,
                                        const std::filesystem::path& directory);

}  // namespace graze::tool
