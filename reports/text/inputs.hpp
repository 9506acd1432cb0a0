// Reads the files of a command line. Errors in a file go to stderr, a line each, and the other files are
// still read.
#pragma once

#include <string>
#include <vector>

#include "corpus/format/case_io.hpp"
#include "corpus/format/proof_io.hpp"
#include "engines/method.hpp"
#include "reports/text/outputs.hpp"

namespace graze::tool {

// Writes `graze: what` to stderr. If stderr cannot be written, nothing happens.
void complain(const std::string& what);

struct CaseFile {
  std::string name;
  std::vector<corpus::Case> cases;
};

struct CaseFiles {
  std::vector<CaseFile> files;
  bool bad = false;  // something was complained about
};

// "-" is standard input, which may hold one object or one a line. An id is read once: a case that has it
// again, in the same file or in another, is complained about and left out.
[[nodiscard]] CaseFiles read_case_files(const std::vector<std::string>& names);

// The whole of standard input. Throws std::runtime_error if it cannot be read to its end.
[[nodiscard]] std::string read_stdin();
// The whole of a file, or of standard input for "-". Throws std::runtime_error that names the file.
[[nodiscard]] std::string read_text(const std::string& name);

// True if a name on a command line selects this method. "mpr" selects all of that name, whatever their
// question and scalar, and "mpr/float" those of one scalar. "overlap mpr" and "overlap mpr/float" select
// those of one query. "all" selects every method.
[[nodiscard]] bool selects(std::string_view name, const engine::Method& method);
// The methods that `names` select, in the order of the list. Throws std::runtime_error for a name that
// selects nothing.
[[nodiscard]] std::vector<const engine::Method*> select_methods(const std::vector<std::string>& names);

// Their names, "ca, gjk, mpr": of the linear casts, of the rotating ones, of the queries ("overlap gjk").
[[nodiscard]] std::string linear_names();
[[nodiscard]] std::string rotating_names();
[[nodiscard]] std::string query_names();
// What --method takes, for messages.
[[nodiscard]] std::string all_names();

}  // namespace graze::tool
