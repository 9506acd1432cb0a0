// Runs a fuzz target on files, without a fuzzer: built everywhere, so a target never rots and a crash file
// replays under any debugger.
//
//   replay PATH...               runs every file, and every file of a directory; finding none is an error
//   replay --encode DIR FILE...  writes the cases of .json and .jsonl files to DIR as seeds
//   replay --decode FILE         prints the file's case as JSON
//   replay --minimise FILE       prints the smallest case that still has a fault
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "corpus/case_io.hpp"
#include "fuzz/codec.hpp"
#include "properties/judge_cast.hpp"
#include "properties/shrink.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

Bytes read_bytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

int encode_files(const fs::path& directory, const std::vector<std::string>& files) {
  fs::create_directories(directory);
  int written = 0, skipped = 0;
  for (const std::string& name : files) {
    const graze::corpus::ReadResult read = graze::corpus::read_file(name);
    for (const graze::corpus::ReadError& error : read.errors) fmt::print(stderr, "{}\n", error.text());
    if (!read.ok()) return 2;
    for (const graze::corpus::Case& problem : read.cases) {
      const auto bytes = graze::fuzz::encode(problem);
      if (!bytes) {
        ++skipped;
        continue;
      }
      std::string id = problem.id;
      std::replace(id.begin(), id.end(), '/', '.');
      std::ofstream(directory / id, std::ios::binary)
          .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
      ++written;
    }
  }
  fmt::print("{} seeds written, {} cases left out (too large, or more than a linear cast)\n", written,
             skipped);
  return written > 0 ? 0 : 2;
}

int minimise(const fs::path& file) {
  const auto fails = [](const graze::corpus::Case& c) {
    return !graze::law::judge_cast(c, true).fault.empty();
  };
  const graze::corpus::Case problem = graze::fuzz::decode(read_bytes(file));
  if (!fails(problem)) {
    fmt::print(stderr, "{}: no fault\n", file.string());
    return 1;
  }
  const graze::corpus::Case least = graze::law::minimised(problem, fails);
  fmt::print("{}", graze::corpus::write_case_pretty(least));
  fmt::print(stderr, "{}", graze::law::report(least, graze::law::judge_cast(least, true)));
  return 0;
}

int replay(const std::vector<std::string>& paths) {
  std::vector<fs::path> files;
  for (const fs::path path : paths) {
    if (fs::is_directory(path)) {
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
      }
    } else {
      files.push_back(path);
    }
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    if (!fs::is_regular_file(file)) {
      fmt::print(stderr, "{}: no such file\n", file.string());
      return 2;
    }
    fmt::print("{}\n", file.string());
    std::fflush(stdout);
    const Bytes bytes = read_bytes(file);
    (void)LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  fmt::print("{} inputs replayed\n", files.size());
  return files.empty() ? 2 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() >= 3 && words[0] == "--encode")
    return encode_files(words[1], {words.begin() + 2, words.end()});
  if (words.size() == 2 && words[0] == "--decode") {
    fmt::print("{}", graze::corpus::write_case_pretty(graze::fuzz::decode(read_bytes(words[1]))));
    return 0;
  }
  if (words.size() == 2 && words[0] == "--minimise") return minimise(words[1]);
  if (!words.empty() && words[0].rfind("--", 0) != 0) return replay(words);
  fmt::print(stderr, "usage: {} PATH... | --encode DIR FILE... | --decode FILE | --minimise FILE\n", argv[0]);
  return 2;
}
