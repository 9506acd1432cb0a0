// graze certify --laws: every law, over files, families or all that is built in.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engines/method.hpp"

namespace graze::tool {

struct LawArguments {
  std::vector<std::string> files, families, methods, laws;
  std::vector<const engine::Method*> others;  // methods of engines of others
  std::optional<std::size_t> count, rotating;
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: as many as the machine has
  std::string corpus, save, report;
};

// The exit code: 1 if a law is broken, 2 for bad input or nothing to judge; of a stop by signal 128 and its number.
[[nodiscard]] int run_laws(const LawArguments& arguments);

// --laws and --law.
void add_laws_options(CLI::App& command, bool& laws, std::vector<std::string>& names);

}  // namespace graze::tool
