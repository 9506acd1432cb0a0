#include "reports/text/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "engines/system/system.hpp"

namespace graze::tool {
namespace {

namespace fs = std::filesystem;

using system::kStandardInput, system::kStandardOutput;

// The files that the run reads, and those that it is writing. One run is one process.
struct Ledger {
  std::vector<std::string> read;
  std::vector<std::weak_ptr<const std::string>> written;
};
Ledger& ledger() {
  static Ledger ledger;
  return ledger;
}

bool holds_cases(const fs::path& file) { return file.extension() == ".json" || file.extension() == ".jsonl"; }

// The file that a name leads to, even if it does not exist yet.
fs::path place_of(const fs::path& name) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(name, error);
  return error ? name.lexically_normal() : place;
}

// Two names of one file. A device or a pipe has no content to lose.
bool is_same_file(const fs::path& one, const fs::path& other) {
  std::error_code error;
  if (fs::exists(one, error) && !fs::is_regular_file(one, error)) return false;
  return fs::equivalent(one, other, error) || place_of(one) == place_of(other);
}

bool lies_in(const fs::path& file, const fs::path& folder) {
  const fs::path inner = place_of(file), outer = place_of(folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

// Is this file read, or would it be once it is there?
bool is_read_as(const std::string& name, const std::string& file) {
  const fs::path source = name == "-" ? kStandardInput : name;
  std::error_code error;
  if (!fs::is_directory(source, error)) return is_same_file(file, source);
  if (holds_cases(file) && lies_in(file, source)) return true;
  for (fs::recursive_directory_iterator it(source, error), end; !error && it != end; it.increment(error)) {
    if (holds_cases(it->path()) && is_same_file(file, it->path())) return true;
  }
  return false;
}

void require_not_read(const std::string& file, const std::string& shown) {
  for (const std::string& name : ledger().read) {
    if (!is_read_as(name, file)) continue;
    const std::string source = name == "-" ? "standard input" : name;
    throw std::runtime_error(fmt::format("{}: would be written over, and it is read{}; name another file",
                                         shown, source == shown ? "" : " as " + source));
  }
}

// After a write that failed.
[[noreturn]] void throw_not_written(const std::string& name) {
  const int error = errno;
  if (error == EPIPE) throw ReaderGone();
  throw std::runtime_error(fmt::format("{}: could not be written to its end{}{}", name,
                                       error != 0 ? ": " : "", error != 0 ? std::strerror(error) : ""));
}

}  // namespace

void will_read(const std::vector<std::string>& names) {
  Ledger& known = ledger();
  known.read.insert(known.read.end(), names.begin(), names.end());
  // A folder's listing of what is wrong with it may well go to a file beside its cases.
  std::error_code error;
  for (const std::string& name : names) {
    const fs::path source = name == "-" ? kStandardInput : name;
    if (fs::is_regular_file(source, error) && is_same_file(kStandardOutput, source)) {
      throw std::runtime_error(fmt::format("{}: is read, and standard output goes to it; name another file",
                                           name == "-" ? "standard input" : name));
    }
  }
}

void require_own_file(const std::string& name) {
  require_not_read(name, name);
  std::erase_if(ledger().written, [](const auto& output) { return output.expired(); });
  for (const auto& output : ledger().written) {
    const std::shared_ptr<const std::string> other = output.lock();
    if (other && is_same_file(name, *other)) {
      throw std::runtime_error(fmt::format("{}: is written already{}; name a file for each output", name,
                                           *other == name ? "" : " as " + *other));
    }
  }
}

void require_own_files(const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty() || names[i] == "-") continue;
    require_own_file(names[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (names[j].empty() || names[j] == "-" || !is_same_file(names[i], names[j])) continue;
      throw std::runtime_error(fmt::format("{}: is named for two outputs; name a file for each", names[i]));
    }
  }
}

void require_folder(const std::string& name) {
  std::error_code error;
  fs::create_directories(name, error);
  if (error || !fs::is_directory(name)) {
    throw std::runtime_error(name + ": is no folder and cannot become one; name another");
  }
}

OutputFile::OutputFile(std::string name) : name_(std::move(name)), is_stdout_(name_ == "-") {
  if (is_stdout_) {
    name_ = "standard output";
    return;
  }
  require_own_file(name_);
  file_.open(name_, std::ios::app);
  if (!file_) throw std::runtime_error(name_ + ": cannot be written; name a file in a folder that can");
  open_ = std::make_shared<const std::string>(name_);
  ledger().written.push_back(open_);
}

std::ostream& OutputFile::stream() {
  if (is_stdout_) return std::cout;
  if (!emptied_ && file_.is_open()) {
    emptied_ = true;
    std::error_code error;
    if (fs::is_regular_file(name_, error)) fs::resize_file(name_, 0, error);
    if (error) throw_not_written(name_);
  }
  return file_;
}

void OutputFile::write_line(const std::string& line) {
  errno = 0;
  if (!(stream() << line << '\n')) throw_not_written(name_);
}

void OutputFile::close() {
  open_.reset();
  errno = 0;
  stream().flush();
  if (!is_stdout_) file_.close();
  if (!stream()) throw_not_written(name_);
}

void OutputFile::close_what_is_written() {
  if (emptied_ || is_stdout_) return close();
  open_.reset();
  file_.close();
}

void close_standard_output() {
  errno = 0;
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout) return;
  if (is_reader_gone()) throw ReaderGone();
  throw_not_written("standard output");
}

bool is_reader_gone() {
  if (std::ferror(stdout) == 0 && std::cout) return false;
  return system::is_stdout_closed();
}

}  // namespace graze::tool
