// Reading and writing cases, graze.case/1 and graze.case/2 (docs/reference/case-format.md).
//
// Guarantees. A number is the double nearest to its decimal or hexfloat. Written text reads back to the same
// bits. Nothing throws. A file gives all its good cases and an error for every bad one.
#pragma once

#include <filesystem>
#include <map>
#include <string_view>

#include "corpus/case.hpp"

namespace graze::corpus {

// The error, its place, and the correct form, in one line.
struct ReadError {
  std::string file;
  int line = 0;       // line of a .jsonl file, from 1 (0 for a file that holds one object)
  std::string field;  // path of the field, such as a.shape.vertices[3], possibly empty
  std::string what;

  // `file:line: field: what`
  [[nodiscard]] std::string text() const;
};

struct ReadResult {
  std::vector<Case> cases;
  std::vector<ReadError> errors;
  [[nodiscard]] bool ok() const { return errors.empty(); }
};

// The ids that were read so far. An id names one case in everything that is read together.
class Ids {
 public:
  // The place that already has this id, "x.jsonl:3" or "x.json". It is empty if the id is new, and the id is
  // then stored with `place`.
  [[nodiscard]] std::string taken(const std::string& id, const std::string& place);

 private:
  std::map<std::string, std::string> places_;
};

// A file holds one object, or one a line if its name ends in .jsonl. No case at all is an error, and so is an
// id that was already read: the first case keeps it, and the other is left out. Files that are read together
// share their `ids`.
[[nodiscard]] ReadResult read_file(const std::filesystem::path& path, Ids& ids);
[[nodiscard]] ReadResult read_text(std::string_view text, const std::string& name, bool jsonl, Ids& ids);
// Every .json and .jsonl file under a directory, in the order of their paths. A directory without a case is
// an error.
[[nodiscard]] ReadResult read_directory(const std::filesystem::path& directory, Ids& ids);
// By themselves.
[[nodiscard]] ReadResult read_file(const std::filesystem::path& path);
[[nodiscard]] ReadResult read_text(std::string_view text, const std::string& name, bool jsonl);
[[nodiscard]] ReadResult read_directory(const std::filesystem::path& directory);

// One line, without the newline at its end.
[[nodiscard]] std::string write_case(const Case& problem);
// A few lines, each body on its own, with the newline at the end.
[[nodiscard]] std::string write_case_pretty(const Case& problem);
// The object of the field `expect`.
[[nodiscard]] std::string write_expect(const Expect& expect);

// Equal in every field, doubles by their bits (so -0 differs from 0).
[[nodiscard]] bool same_case(const Case& l, const Case& r);

}  // namespace graze::corpus
