#include "tools/commands/law_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>

#include "properties/laws/reach.hpp"

namespace graze::tool {
namespace {

using engine::Kind;
using law::Law;
using law::Needs;

struct Class {
  Needs needs;
  const char *title, *words;
};
constexpr Class kClasses[] = {
    {Needs::metamorphic, "Metamorphic: the method alone",
     "The method is called twice or more, for cases whose true answers follow from each other, or its answer "
     "is checked\nfor consistency. It takes microseconds. If two answers differ, the oracle decides which "
     "one breaks its "
     "guarantee. At a\ngraze both may be right, and yet far apart."},
    {Needs::proof, "Proof: the checker of proofs",
     "The answer carries its proof, and the exact checker, which shares no code with the search, decides."},
    {Needs::oracle, "Oracle: the true answer",
     "The exact oracle knows the answer, or the bracket oracle if shapes are curved or bodies rotate. It "
     "takes a "
     "millisecond to\na second per case."},
};

constexpr const char* kPreamble =
    R"(<!-- Made by `graze laws --page > docs/reference/laws.md`. A test compares. -->

# Laws

For developers who want to know which properties every answer must have, and which test checks each.

A law is one sentence about every answer of every method. It is a function of a case and a method. The tests, the fuzzers,
the campaigns and `graze laws` call the same one. It never throws, and returns one of three results: it holds, it is
broken (with a reason), or it does not apply. {} laws are about linear casts, {} about the queries beside the cast, {} about
casts of rotating bodies. `kappa u scale` is the error bound of the method's guarantee ([guarantees.md](guarantees.md)).

    graze laws                                     # every law, on the corpus and every family
    graze laws --law never_late mine.jsonl         # one law, on cases of your own
    graze laws --engine ./mine                     # the laws that apply to a third-party engine (protocol.md)
    ctest -L property                              # the same laws, with shrinking, over drawn cases too

If a law breaks, the case is made small (few vertices, small integers), and written as a file for `graze cast` with its
picture. `graze corpus add` keeps it. `GRAZE_FINDINGS_DIR` names the folder of a test run. The default is `findings/` in the
build folder.

A law that never applies checks nothing. So a run over the families also fails if a law never applied, never saw a hit, a
miss or a start in contact, or was never reached by a family of its kind. The exceptions are listed [below](#out-of-reach).

Each law names planted defects: small patches in `properties/defects/patches/` that make a copy of the library wrong, and
that the law notices. `./run defects --write` tries them, and writes which law notices which.
)";

std::string line_after(const std::filesystem::path& file, const std::string& text, std::string_view key) {
  const std::size_t at = text.starts_with(key) ? 0 : text.find("\n" + std::string(key));
  if (at == std::string::npos) {
    throw std::runtime_error(
        fmt::format("{}: has no line \"{}...\"; a patch begins with \"Defect: what is wrong\" and \"Law: who "
                    "notices\"",
                    file.string(), key));
  }
  const std::size_t begin = text.find(key, at) + key.size();
  return text.substr(begin, text.find('\n', begin) - begin);
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c != ' ' && c != ',') {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

// A bar would end the cell.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

// The names of the defects that each law detects, by the name of the law.
std::map<std::string, std::vector<std::string>> noticed(std::span<const Law> laws,
                                                        std::span<const PlantedDefect> defects) {
  std::map<std::string, std::vector<std::string>> by_law;
  for (const Law& law : laws) by_law[law.name];
  for (const PlantedDefect& defect : defects) {
    for (const std::string& law : defect.laws) {
      const auto found = by_law.find(law);
      if (found == by_law.end()) {
        throw std::runtime_error(
            fmt::format("{}.patch: {} is no law; `graze laws --list` lists them", defect.name, law));
      }
      found->second.push_back(defect.name);
    }
  }
  return by_law;
}

std::string reach_table() {
  std::string text = "| law | never sees | never reached by | because |\n|---|---|---|---|\n";
  for (const law::OutOfReach& one : law::out_of_reach()) {
    text += fmt::format("| `{}` | {} | {} | {} |\n", one.law,
                        fmt::join(words_of(std::string(one.outcomes)), ", "),
                        fmt::join(words_of(std::string(one.families)), ", "), cell(std::string(one.why)));
  }
  return text;
}

std::string breach_table() {
  std::string text =
      "| law | methods | known |\n"
      "|---|---|---|\n";
  for (const law::KnownBreach& one : law::known_breaches()) {
    text += fmt::format("| `{}` | {} | {} |\n", one.law, fmt::join(words_of(std::string(one.methods)), ", "),
                        cell(std::string(one.why)));
  }
  return text;
}

}  // namespace

std::vector<PlantedDefect> read_defects(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> files;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(directory, failed)) {
    if (entry.path().extension() == ".patch") files.push_back(entry.path());
  }
  if (files.empty()) {
    throw std::runtime_error(
        directory.string() +
        ": holds no .patch; name the folder properties/defects/patches of the source tree");
  }
  std::sort(files.begin(), files.end());
  std::vector<PlantedDefect> defects;
  for (const std::filesystem::path& file : files) {
    std::ifstream stream(file);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    defects.push_back({.name = file.stem().string(),
                       .what = line_after(file, text, "Defect: "),
                       .laws = words_of(line_after(file, text, "Law: "))});
  }
  return defects;
}

std::string law_list(std::span<const Law> laws) {
  std::string text;
  for (const Class& one : kClasses) {
    text += fmt::format("{}{}\n", text.empty() ? "" : "\n", one.title);
    for (const Law& law : laws) {
      if (law.needs == one.needs) text += fmt::format("  {:<32}{}\n", law.name, law.sentence);
    }
  }
  return text;
}

std::string law_page(std::span<const Law> laws, std::span<const PlantedDefect> defects) {
  const auto by_law = noticed(laws, defects);
  const auto number = [&](Kind kind) {
    return std::count_if(laws.begin(), laws.end(), [&](const Law& law) { return law.kind == kind; });
  };
  std::string text =
      fmt::format(fmt::runtime(kPreamble), number(Kind::linear), number(Kind::query), number(Kind::rotating));
  for (const Class& one : kClasses) {
    text += fmt::format("\n## {}\n\n{}\n", one.title, one.words);
    for (const Kind kind : {Kind::linear, Kind::query, Kind::rotating}) {
      std::string rows;
      for (const Law& law : laws) {
        if (law.needs != one.needs || law.kind != kind) continue;
        rows += fmt::format("| `{}` | {} | {} |\n", law.name, cell(law.sentence),
                            fmt::join(by_law.at(law.name), ", "));
      }
      if (rows.empty()) continue;
      constexpr const char* kTitles[] = {"Linear casts", "Queries beside the cast", "Rotating bodies"};
      text += fmt::format("\n### {}\n\n| law | says | notices |\n|---|---|---|\n{}",
                          kTitles[static_cast<std::size_t>(kind)], rows);
    }
  }
  text += fmt::format(
      "\n## Out of reach\n\nThese laws cannot see some outcomes, or never apply to some families:\n\n{}",
      reach_table());
  if (!law::known_breaches().empty()) {
    text += fmt::format(
        "\n## Broken\n\n"
        "Known failures: `graze laws` reports them and fails; the tests skip them, and fail once they are "
        "mended.\n\n"
        "{}",
        breach_table());
  }
  return text;
}

}  // namespace graze::tool
