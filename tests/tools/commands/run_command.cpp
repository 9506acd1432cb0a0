#include "run_command.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace graze::test {

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "graze-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void Folder::write(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories((path_ / name).parent_path());
  std::ofstream(path_ / name, std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const {
  std::ifstream file(path_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

CommandRun Folder::graze(const std::string& arguments, const std::string& input) const {
  return shell("graze " + arguments, input);
}

CommandRun Folder::shell(const std::string& line, const std::string& input) const {
  write("stdin", input);
  const std::string command = "cd '" + path_.string() + "' && graze() { '" GRAZE_COMMAND "' \"$@\"; } && { " +
                              line + "; } <stdin >stdout 2>stderr";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("stdout"), read("stderr")};
}

}  // namespace graze::test
