// What `graze certify` is given to judge, sorted: casts of bodies that do not turn, casts of bodies that do,
// and questions beside the cast.
#pragma once

#include <string>
#include <vector>

#include "certify/linear.hpp"

namespace graze::tool {

struct Intake {
  std::vector<Suite> linear, rotating;
  // Questions beside the cast; those at t = 0 without the turn that they do not see.
  std::vector<corpus::Case> asked;
  std::size_t recast = 0;        // questions about contact that are judged as the cast of their bodies, too
  std::size_t left_out = 0;      // cases that nothing judges
  std::vector<std::string> why;  // of files: which and why not, a line a reason

  // The cases of a file, or of our own corpus. Whether bodies touch, when, and how far apart they are, is
  // judged as the cast of the same bodies as well, which is the harder question.
  void take(const std::string& name, const std::vector<corpus::Case>& cases, bool ours);

  [[nodiscard]] bool empty() const { return linear.empty() && rotating.empty() && asked.empty(); }
};

// The cases that a run found, to be written to a file and read again: each once, and each with its own id.
// Where two questions have one id, the later gets its query's name, and a number if need be.
[[nodiscard]] std::vector<corpus::Case> with_own_ids(const std::vector<corpus::Case>& found);

}  // namespace graze::tool
