// Runs the command graze in a folder of its own, as a shell would, and keeps what it said.
#pragma once

#include <filesystem>
#include <string>

namespace graze::test {

struct CommandRun {
  int exit_code = -1;
  std::string out, err;
};

class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // Makes the folders on the way to it.
  void write(const std::string& name, const std::string& text) const;
  [[nodiscard]] std::string read(const std::string& name) const;
  // `graze arguments < input`, in this folder.
  [[nodiscard]] CommandRun graze(const std::string& arguments, const std::string& input = "") const;
  // Runs a line through a shell: `graze` is the command, and redirections are the shell's. Output that is not
  // redirected goes to the files stdout and stderr.
  [[nodiscard]] CommandRun shell(const std::string& line, const std::string& input = "") const;

 private:
  std::filesystem::path path_;
};

}  // namespace graze::test
