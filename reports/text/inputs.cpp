#include "reports/text/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "corpus/format/case_json.hpp"

namespace graze::tool {
namespace {

// One object a line if the first line that is not empty is an object by itself.
bool looks_like_lines(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || text[begin] != '{') return false;
  const std::string line = text.substr(begin, text.find('\n', begin) - begin);
  return line[line.find_last_not_of(" \t\r")] == '}';
}

}  // namespace

void complain(const std::string& what) { std::fputs(("graze: " + what + "\n").c_str(), stderr); }

std::string read_stdin() {
  std::string text;
  std::array<char, 1 << 16> part;
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), stdin)) {
    text.append(part.data(), size);
  }
  if (std::ferror(stdin) != 0) throw std::runtime_error("standard input: cannot be read; give a file");
  return text;
}

std::string read_text(const std::string& name) {
  if (name == "-") return read_stdin();
  corpus::FileText file = corpus::read_whole_file(name);
  if (!file.error.empty()) throw std::runtime_error(name + ": " + file.error);
  return std::move(file.text);
}

CaseFiles read_case_files(const std::vector<std::string>& names) {
  CaseFiles files;
  corpus::Ids ids;
  for (const std::string& name : names) {
    corpus::ReadResult result;
    if (name == "-") {
      const std::string text = read_stdin();
      result = corpus::read_text(text, "standard input", looks_like_lines(text), ids);
    } else {
      result = corpus::read_file(name, ids);
    }
    for (const corpus::ReadError& error : result.errors) complain(error.text());
    files.bad = files.bad || !result.ok();
    files.files.push_back({name, std::move(result.cases)});
  }
  return files;
}

namespace {

// The name of a query's method without its scalar: `overlap gjk`.
std::string without_scalar(const engine::Method& method) {
  const std::string question = method.question_name();
  return question.substr(0, question.rfind('/'));
}

// Each once, in the order of the list.
std::string names_of(engine::Kind kind) {
  std::vector<std::string> names;
  for (const engine::Method& method : engine::methods(kind)) {
    std::string name = kind == engine::Kind::query ? without_scalar(method) : method.name;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string linear_names() { return names_of(engine::Kind::linear); }
std::string rotating_names() { return names_of(engine::Kind::rotating); }
std::string query_names() { return names_of(engine::Kind::query); }
std::string all_names() {
  return fmt::format("{}, of rotating casts {}, of queries {}, one with its scalar (mpr/float), or all",
                     linear_names(), rotating_names(), query_names());
}

bool selects(std::string_view name, const engine::Method& method) {
  return name == "all" || name == method.name || name == method.full_name() ||
         name == method.question_name() || name == without_scalar(method);
}

std::vector<const engine::Method*> select_methods(const std::vector<std::string>& names) {
  std::vector<const engine::Method*> selected;
  std::vector<bool> used(names.size(), false);
  for (const engine::Method& method : engine::methods()) {
    bool wanted = false;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!selects(names[i], method)) continue;
      used[i] = wanted = true;
    }
    if (wanted) selected.push_back(&method);
  }
  const auto unknown = std::find(used.begin(), used.end(), false);
  if (unknown != used.end()) {
    throw std::runtime_error(fmt::format("--method: {} is no method; it is one of {}",
                                         names[static_cast<std::size_t>(unknown - used.begin())],
                                         all_names()));
  }
  return selected;
}

}  // namespace graze::tool
