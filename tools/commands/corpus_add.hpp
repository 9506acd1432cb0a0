// graze corpus add: a finding becomes a curated case.
#pragma once

#include <string>
#include <vector>

namespace graze::tool {

struct Addition {
  std::string input;                // a file of cases, or "-"
  std::string into;                 // the file they go to
  std::string id, comment, source;  // replace those of the case, empty keeps them
  std::vector<std::string> flags;   // added to those of the case
  bool known = false;               // to the known failures, not to `into`
  bool dry_run = false;             // print what would be appended, and write nothing
};

// Appends all of the cases, answered by the oracles, or none of them: 0, or 2 with a complaint for whatever
// keeps a case out. Throws std::runtime_error with one line to show.
//
// A case is not added in four cases: it is not sound, its id is or was in any file of the corpus, a flag has
// no note, or a case of the corpus asks the same question. The family is the first part of the id. Hardness
// has a meaning within its family only, so it is kept only if the case keeps its family.
[[nodiscard]] int add_cases(const Addition& addition);

}  // namespace graze::tool
