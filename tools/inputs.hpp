// The files of a command line: what was wrong in one goes to stderr, a line each, and the others are read.
#pragma once

#include <fstream>
#include <iosfwd>
#include <string>
#include <vector>

#include "corpus/case_io.hpp"
#include "corpus/proof_io.hpp"
#include "engines/method.hpp"
#include "engines/rotating.hpp"

namespace graze::tool {

// `graze: what` on stderr.
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

// The whole of standard input.
[[nodiscard]] std::string read_stdin();

// A file to write, "-" for standard output. Throws std::runtime_error with one line to show.
class OutputFile {
 public:
  explicit OutputFile(std::string name);
  void write_line(const std::string& line);
  void close();  // throws if anything could not be written

 private:
  std::string name_;
  std::ofstream file_;
  bool is_stdout_ = false;
};

// The casts that `names` select: "mpr" all scalars of it, "mpr/float" that one, "all" every one; in the order
// of the engine tables. A name may stand for a linear method and a rotating one. Throws std::runtime_error
// for a name that selects nothing.
struct SelectedMethods {
  std::vector<const engine::EngineMethod*> linear;
  std::vector<const engine::RotatingEngineMethod*> rotating;
};
[[nodiscard]] SelectedMethods select_methods(const std::vector<std::string>& names);

// Their names, "ca, gjk, mpr": of the linear casts, of the rotating ones.
[[nodiscard]] std::string linear_names();
[[nodiscard]] std::string rotating_names();

}  // namespace graze::tool
