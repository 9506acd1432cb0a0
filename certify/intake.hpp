// What `graze certify` is given to judge, sorted: casts of bodies that do not turn, casts of bodies that do,
// and questions beside the cast.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "certify/suites.hpp"

namespace graze::tool {

struct Intake {
  std::vector<Suite> suites;     // of each source up to one of each kind
  std::size_t questions = 0;     // beside the cast; those at t = 0 without the turn that they do not see
  std::size_t recast = 0;        // of those about contact, judged as the cast of their bodies, too
  std::size_t left_out = 0;      // cases that nothing judges
  std::vector<std::string> why;  // of files: which and why not, a line a reason

  // The cases of a file, or of our own corpus. Whether bodies touch, when, and how far apart they are, is
  // judged as the cast of the same bodies as well, which is the harder question.
  void take(const std::string& name, const std::vector<corpus::Case>& cases, bool ours);

  // The cases that none of these methods is for. Those of files are said to be left out.
  void leave_out(std::span<const engine::Method* const> methods, const std::vector<std::string>& files);
};

// The cases that a run found, to be written to a file and read again: each once, and each with its own id.
// Where two questions have one id, the later gets its query's name, and a number if need be.
[[nodiscard]] std::vector<corpus::Case> with_own_ids(const std::vector<corpus::Case>& found);

}  // namespace graze::tool
