// The notes on the flags of the curated cases: what a flagged property breaks, whom it affects, and where it
// was seen. corpus/flags.json holds them. Every flag of a case has a note, and every note is used (tested).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/case.hpp"

namespace graze::corpus {

struct FlagNote {
  std::string breaks;              // the trap, in a sentence
  std::string affects;             // for whom, and how it shows
  std::vector<std::string> cases;  // ids of cases that show it as it was reported, possibly empty
};

struct FlagNotes {
  std::map<std::string, FlagNote> notes;
  std::string error;  // one line, empty on success
};

[[nodiscard]] FlagNotes read_flag_notes(std::string_view text, const std::string& name);
[[nodiscard]] FlagNotes read_flag_notes_file(const std::filesystem::path& path);

// One line for each flag of a case without a note, each note without a flagged case, and each case that a
// note names and that does not exist or lacks the flag.
[[nodiscard]] std::vector<std::string> flag_mismatches(const std::vector<Case>& cases,
                                                       const FlagNotes& flags);

}  // namespace graze::corpus
