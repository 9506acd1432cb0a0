// One case to and from a JSON value. case_io and proof_io share this code.
#pragma once

#include "corpus/format/fields.hpp"

namespace graze::corpus {

// Throws Malformed. `path` is the case's own place, empty at the top of a file.
[[nodiscard]] Case case_from_json(const JsonValue& value, const std::string& path);

// The lines of a file, without their ends, and their numbers from 1. Blank lines are left out.
struct TextLine {
  int number;
  std::string_view text;
};
[[nodiscard]] std::vector<TextLine> split_lines(std::string_view text);

// The whole file, or what is wrong with it.
struct FileText {
  std::string text;
  std::string error;
};
[[nodiscard]] FileText read_whole_file(const std::string& path);

}  // namespace graze::corpus
