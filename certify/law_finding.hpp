// A broken law, prepared for the person who fixes it: the case as a file for `graze cast`, its picture, and
// the command that adds it to the corpus.
#pragma once

#include <filesystem>
#include <string>

#include "corpus/case.hpp"

namespace graze::law {

struct Finding {
  std::string law, sentence, method, reason;
  std::string seed;      // how to draw the first case again: a command or a setting
  corpus::Case problem;  // the smallest that breaks the law
};

// The case as a curated one is written: id law/NAME-HASH, family law, the reason as its comment.
[[nodiscard]] corpus::Case as_case(const Finding& finding);

struct SavedFinding {
  std::filesystem::path file, picture;  // NAME-HASH.jsonl and NAME-HASH.svg
};
// Writes both into the folder, which is created. The same finding has the same file names. Throws
// std::runtime_error with a one-line message.
[[nodiscard]] SavedFinding save_finding(const Finding& finding, const std::filesystem::path& directory);

// Law, method, reason, seed, files and commands, a line each, and the case.
[[nodiscard]] std::string text_of(const Finding& finding, const SavedFinding& saved);

// The environment variable GRAZE_FINDINGS_DIR if it is set, else `usual`.
[[nodiscard]] std::filesystem::path findings_directory(const std::filesystem::path& usual);

}  // namespace graze::law
