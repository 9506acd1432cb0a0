// Writes the seeds of a pool of fuzz targets (targets.txt), one file a case, named by its id.
//
//   graze_seed_corpus POOL DIR          from the built-in corpus: every case that fits
//   graze_seed_corpus POOL DIR FILE...  from these .json and .jsonl files
//
// The pool `turning` gets the cases with a rotation and a few without, `linear` those without, `proofs` all. A seed of
// `text` or `scenes` is the text of the case, a seed of another pool the bytes of codec.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

#include "corpus/curate/location.hpp"
#include "corpus/format/case_io.hpp"
#include "fuzz/codec.hpp"
#include "properties/edit/case.hpp"

namespace {

namespace fs = std::filesystem;
using graze::corpus::Case;
using graze::corpus::ReadResult;

int refuse(const std::string& what) {
  fmt::print(stderr, "graze_seed_corpus: {}\n", what);
  return 2;
}

enum class Kind { text, linear, turning, any };

std::optional<Kind> kind_of(const std::string& pool) {
  if (pool == "text" || pool == "scenes") return Kind::text;
  if (pool == "turning") return Kind::turning;
  if (pool == "proofs") return Kind::any;
  if (pool == "linear") return Kind::linear;
  return std::nullopt;
}

// Bodies that do not turn are the limit of those that do: one such case in so many is a seed, too.
constexpr int kStillOneIn = 8;

bool is_wanted(Kind kind, const Case& problem, int still) {
  if (kind == Kind::text || kind == Kind::any) return true;
  return graze::law::has_spin(problem) == (kind == Kind::turning) ||
         (kind == Kind::turning && still % kStillOneIn == 0);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 2) return refuse("usage: graze_seed_corpus POOL DIR [FILE...]");
  const std::optional<Kind> kind = kind_of(words[0]);
  if (!kind) return refuse(words[0] + ": no such pool; fuzz/targets.txt lists them in its second column");

  std::vector<ReadResult> reads;
  if (words.size() == 2) {
    reads.push_back(graze::corpus::read_directory(graze::corpus::corpus_directory() / "cases"));
  }
  for (std::size_t i = 2; i < words.size(); ++i) reads.push_back(graze::corpus::read_file(words[i]));
  for (const ReadResult& read : reads) {
    if (!read.ok()) return refuse(read.errors.front().text());
  }

  const fs::path directory = words[1];
  std::error_code failed;
  fs::create_directories(directory, failed);
  int written = 0, large = 0, still = 0;
  for (const ReadResult& read : reads) {
    for (const Case& problem : read.cases) {
      still += !graze::law::has_spin(problem);
      if (!is_wanted(*kind, problem, still)) continue;
      std::string bytes;
      if (*kind == Kind::text) {
        bytes = graze::corpus::write_case(problem) + "\n";
      } else if (const auto encoded = graze::fuzz::encode(problem)) {
        bytes.assign(encoded->begin(), encoded->end());
      } else {
        ++large;
        continue;
      }
      std::string id = problem.id;
      std::replace(id.begin(), id.end(), '/', '.');
      std::ofstream out(directory / id, std::ios::binary);
      if (!(out << bytes)) return refuse((directory / id).string() + ": cannot be written");
      ++written;
    }
  }
  fmt::print("{} seeds written to {}, {} cases too large\n", written, directory.string(), large);
  return written > 0 ? 0 : 2;
}
