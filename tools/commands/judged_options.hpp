// The options of the commands that judge methods on cases, certify, laws and stability: which methods, on which cases.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/commands/engines.hpp"

namespace graze::tool {

struct JudgedArguments {
  std::vector<std::string> files, families, methods;
  EngineArguments engines;
  std::optional<std::size_t> count,
      rotating;  // cases of a family or of each level, the command has defaults
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: as many as the machine has
  std::string corpus, guarantees, save;

  // All of ours, unless third-party engines are to be judged.
  [[nodiscard]] std::vector<std::string> our_methods() const {
    return methods.empty() && engines.commands.empty() ? std::vector<std::string>{"all"} : methods;
  }
  [[nodiscard]] bool takes_curated() const { return files.empty() && families.empty(); }
  [[nodiscard]] std::filesystem::path curated_directory() const;
  [[nodiscard]] unsigned most_threads() const;
};

// --family, --count, --rotating, --seed, --method and --threads. `counted` and `rotated` describe the two counts.
void add_judged_options(CLI::App& command, JudgedArguments& arguments, const std::string& counted,
                        const std::string& rotated);
void add_file_options(CLI::App& command, JudgedArguments& arguments);  // FILE... and --corpus
void add_guarantees_option(CLI::App& command, JudgedArguments& arguments);

}  // namespace graze::tool
