// Runs a fuzz target on files, without a fuzzer: built everywhere, so a target never rots and a crash file
// replays under any debugger.
//
//   replay PATH...                 runs every file, and every file of a directory. Finding none is an error.
//   replay --print FILE            prints the file's case as JSON, ready for `graze corpus add` (--decode: the same).
//   replay --minimise FILE [OUT]   prints the smallest case that still has a finding, and writes its bytes to OUT.
//   replay --encode DIR FILE...    writes the cases of .json and .jsonl files to DIR as seeds (seed_corpus.cpp
//                                  does so for the whole corpus).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "corpus/format/case_io.hpp"
#include "fuzz/codec.hpp"
#include "fuzz/mutator.hpp"
#include "fuzz/target.hpp"
#include "properties/edit/case.hpp"
#include "properties/generate/shrink.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;
using graze::corpus::Case;
using graze::fuzz::Bytes;
using graze::fuzz::Finding;
using graze::fuzz::Input;
using graze::fuzz::kTarget;

constexpr int kBadInput = 2;

int refuse(const std::string& what) {
  fmt::print(stderr, "{}\n", what);
  return kBadInput;
}

bool read_bytes(const fs::path& file, Bytes& bytes) {
  std::ifstream in(file, std::ios::binary);
  if (!fs::is_regular_file(file) || !in) return false;
  bytes.assign(std::istreambuf_iterator<char>(in), {});
  return true;
}

bool write_bytes(const fs::path& file, const Bytes& bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return static_cast<bool>(out);
}

std::string no_such_file(const fs::path& file) { return file.string() + ": no such file"; }

// As a curated one is written: an id, a family, and a sentence.
Case dressed(Case problem, const std::string& comment) {
  problem.family = "fuzz";
  problem.id = fmt::format("fuzz/{}-{:016x}", kTarget.name, graze::law::hash_of(problem));
  std::replace(problem.id.begin(), problem.id.end(), '_', '-');
  problem.comment = comment;
  return problem;
}

std::string comment_of(const std::optional<Finding>& finding) {
  if (!finding) return fmt::format("An input of the fuzz target {}.", kTarget.name);
  return fmt::format("Found by the fuzz target {}: {}, {}: {}", kTarget.name, finding->law, finding->method,
                     finding->fault);
}

int print_case(const fs::path& file) {
  Bytes bytes;
  if (!read_bytes(file, bytes)) return refuse(no_such_file(file));
  const std::optional<Finding> finding = graze::fuzz::judge(bytes).finding;
  const Case problem = finding ? finding->problem : graze::fuzz::input_of(bytes).problem;
  fmt::print("{}", graze::corpus::write_case_pretty(dressed(problem, comment_of(finding))));
  return 0;
}

int minimise(const fs::path& file, const std::string& out) {
  Bytes bytes;
  if (!read_bytes(file, bytes)) return refuse(no_such_file(file));
  const Input input = graze::fuzz::input_of(bytes);
  const auto find = [&](const Case& problem) {
    Input other = input;
    other.problem = problem;
    return kTarget.judge(other).finding;
  };
  const std::optional<Finding> first = find(input.problem);
  if (!first) {
    fmt::print(stderr, "{}: no finding\n", file.string());
    return 1;
  }
  // The same law, by the same method. Another fault would be another finding.
  const auto fails = [&](const Case& problem) {
    const std::optional<Finding> finding = find(problem);
    return finding && finding->law == first->law && finding->method == first->method;
  };
  // A case that can be encoded stays so.
  const Case least = graze::law::minimised(
      input.problem, [&](const Case& c) { return graze::fuzz::bytes_of(c, input) && fails(c); }, 3000);
  const std::optional<Finding> last = find(least);
  fmt::print("{}", graze::corpus::write_case_pretty(dressed(last->problem, comment_of(last))));
  fmt::print(stderr, "{}", graze::fuzz::report(*last));
  if (!out.empty() && !write_bytes(out, graze::fuzz::bytes_of(least, input).value()))
    return refuse(out + ": cannot be written");
  return 0;
}

int encode_files(const fs::path& directory, const std::vector<std::string>& files) {
  std::error_code failed;
  fs::create_directories(directory, failed);
  int written = 0, skipped = 0;
  for (const std::string& name : files) {
    const graze::corpus::ReadResult read = graze::corpus::read_file(name);
    for (const graze::corpus::ReadError& error : read.errors) fmt::print(stderr, "{}\n", error.text());
    if (!read.ok()) return kBadInput;
    for (const Case& problem : read.cases) {
      const auto bytes = graze::fuzz::encode(problem);
      if (!bytes) {
        ++skipped;
        continue;
      }
      std::string id = problem.id;
      std::replace(id.begin(), id.end(), '/', '.');
      if (!write_bytes(directory / id, *bytes))
        return refuse((directory / id).string() + ": cannot be written");
      ++written;
    }
  }
  fmt::print("{} seeds written, {} cases left out (too large)\n", written, skipped);
  return written > 0 ? 0 : kBadInput;
}

// Every file, and every file of a directory, in order.
std::vector<fs::path> files_of(const std::vector<std::string>& paths) {
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
  return files;
}

int replay(const std::vector<std::string>& paths) {
  const std::vector<fs::path> files = files_of(paths);
  for (const fs::path& file : files) {
    Bytes bytes;
    if (!read_bytes(file, bytes)) return refuse(no_such_file(file));
    fmt::print("{}\n", file.string());
    std::fflush(stdout);
    (void)LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  fmt::print("{} inputs replayed\n", files.size());
  return files.empty() ? kBadInput : 0;
}

// Texts, and one case in four, by a byte.
Bytes changed(Bytes bytes, graze::corpus::Random& random) {
  if (kTarget.judge != nullptr && !random.once_in(4)) {
    if (auto moved = graze::fuzz::mutated(bytes, 1u << 12, random.bits())) return *std::move(moved);
  }
  if (bytes.empty()) return {static_cast<std::uint8_t>(random.bits())};
  const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(random.below(bytes.size()));
  switch (random.below(3)) {
    case 0:
      *at = static_cast<std::uint8_t>(random.bits());
      break;
    case 1:
      bytes.erase(at);
      break;
    default:
      bytes.insert(at, bytes[random.below(bytes.size())]);
      break;
  }
  return bytes;
}

// A mutant takes its parent's place one time in so many: walks of some length from every seed.
constexpr std::uint64_t kHeirOneIn = 8;

int mutate(long long count, std::uint64_t seed, const std::vector<std::string>& paths) {
  std::vector<Bytes> pool;
  for (const fs::path& file : files_of(paths)) {
    if (!read_bytes(file, pool.emplace_back())) return refuse(no_such_file(file));
  }
  if (pool.empty()) return refuse("no inputs to mutate");
  const std::vector<Bytes> seeds = pool;
  graze::corpus::Random random(seed);
  long long reached = 0, by_oracle = 0, findings = 0;
  const auto start = std::chrono::steady_clock::now();
  for (long long i = 0; i < count; ++i) {
    const std::size_t which = random.below(pool.size());
    Bytes bytes = changed(random.once_in(2) ? seeds[which] : pool[which], random);
    const graze::fuzz::Judged judged = graze::fuzz::judge(bytes);
    reached += judged.reached;
    by_oracle += judged.by_oracle;
    if (judged.finding) {
      const std::string file = fmt::format("finding-{}-{}", seed, i);
      if (!write_bytes(file, bytes)) return refuse(file + ": cannot be written");
      fmt::print(stderr, "{}saved as {}\n", graze::fuzz::report(*judged.finding), file);
      ++findings;
    } else if (random.once_in(kHeirOneIn)) {
      pool[which] = std::move(bytes);
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  fmt::print("{} of {} executions reached a law, {} asked the oracle, {} findings, {:.0f} a second\n",
             reached, count, by_oracle, findings, static_cast<double>(count) / seconds.count());
  return findings > 0 ? 1 : 0;
}

// N and SEED of --mutate.
template <class T>
bool read_number(const std::string& word, T& number) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

int usage(const char* name) {
  return refuse(
      fmt::format("usage: {} PATH... | --print FILE | --minimise FILE [OUT] | --mutate N SEED PATH... | "
                  "--encode DIR FILE...",
                  name));
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) return usage(argv[0]);
  if (words[0].rfind("--", 0) != 0) return replay(words);
  if (words.size() >= 4 && words[0] == "--mutate") {
    long long count = 0;
    std::uint64_t seed = 0;
    if (!read_number(words[1], count) || count < 1 || !read_number(words[2], seed))
      return refuse("--mutate: want a number of mutations, 1 or more, and a seed, 0 or more");
    return mutate(count, seed, {words.begin() + 3, words.end()});
  }
  if (kTarget.judge == nullptr) return refuse(words[0] + ": the target reads text, not cases");
  if (words.size() >= 3 && words[0] == "--encode")
    return encode_files(words[1], {words.begin() + 2, words.end()});
  if (words.size() == 2 && (words[0] == "--print" || words[0] == "--decode")) return print_case(words[1]);
  if ((words.size() == 2 || words.size() == 3) && words[0] == "--minimise")
    return minimise(words[1], words.size() == 3 ? words[2] : "");
  return usage(argv[0]);
}
