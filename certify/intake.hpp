// The input of `graze certify`, sorted by kind: linear casts, rotating casts, and the other queries.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "certify/suites.hpp"

namespace graze::tool {

struct Intake {
  std::vector<Suite> suites;     // at most one of each kind for each source
  std::size_t questions = 0;     // queries other than casts, those at t = 0 without the rotation that they
                                 // ignore
  std::size_t recast = 0;        // those about contact that are also judged as the cast of their bodies
  std::size_t left_out = 0;      // cases that nothing judges
  std::vector<std::string> why;  // files that were not judged and why, one line a reason

  // Takes the cases of a file, or of our own corpus. Questions about contact, its time or a distance are also
  // judged as the cast of the same bodies, which is the harder question.
  void take(const std::string& name, const std::vector<corpus::Case>& cases, bool ours);

  // The cases that none of these methods is for. Those of files are said to be left out.
  void leave_out(std::span<const engine::Method* const> methods, const std::vector<std::string>& files);
};

// The cases that a run found, to be written to a file and read again. Each occurs once and has its own id. If
// two questions share an id, the later one gets its query's name, and a number if needed.
[[nodiscard]] std::vector<corpus::Case> with_own_ids(const std::vector<corpus::Case>& found);

}  // namespace graze::tool
