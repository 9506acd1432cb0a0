// The output files of a run. Two guarantees hold for every output of every command. No file that the run reads is
// overwritten, whatever spelling, symlink or hard link names it. A file that cannot be written to its end is an error.
//
// A command first declares the files it will read. An output is checked when it is opened, before anything is emptied.
#pragma once

#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace graze::tool {

// Declares the files that this run reads, "-" for standard input. For a folder these are its files of cases (.json,
// .jsonl). None of them may be an output from then on. Throws std::runtime_error if standard output goes to one.
void will_read(const std::vector<std::string>& names);

// Throws std::runtime_error with a one-line message if writing this file would overwrite an input or an output that is
// still open. Devices and pipes are exempt.
void require_own_file(const std::string& name);
// The same check for each output of a run. It also requires that no two outputs are one file. "-" and "" are ignored.
void require_own_files(const std::vector<std::string>& names);

// Makes the folder if it is not there yet. Throws std::runtime_error if it cannot become one.
void require_folder(const std::string& name);

// A file to write, "-" for standard output. Its previous content remains until the first line is written, or until it
// is closed, so a run that is refused loses nothing. Throws std::runtime_error with a one-line message.
class OutputFile {
 public:
  explicit OutputFile(std::string name);
  void write_line(const std::string& line);  // throws if an error in writing shows at once
  void close();                              // throws if anything could not be written
  // The same for a run that failed: if no line was written, the file keeps its previous content.
  void close_what_is_written();

 private:
  [[nodiscard]] std::ostream& stream();

  std::string name_;
  std::ofstream file_;
  bool is_stdout_ = false, emptied_ = false;
  std::shared_ptr<const std::string> open_;  // while it lives the name is that of an open output
};

// The reader of an output closed the pipe before its end (`graze ... | head -1`). A run then cleans up and ends silently.
struct ReaderGone : std::runtime_error {
  ReaderGone() : std::runtime_error("the reader of an output has closed it") {}
};

// At the end of a run: throws if standard output could not be written to its end, ReaderGone or std::runtime_error.
void close_standard_output();

// Has a write to standard output failed because nobody reads it any more?
[[nodiscard]] bool is_reader_gone();

}  // namespace graze::tool
