// The options that name engines of others (docs/engines.md), and the engines that they name.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "external/engine.hpp"

namespace graze::tool {

struct EngineArguments {
  std::vector<std::string> commands;
  double time_limit = 1;              // seconds
  std::uint64_t memory_limit = 2048;  // MiB
  std::optional<double> tolerance, relative_tolerance, kappa;
  bool beyond_limits = false;
  std::vector<std::string> needed_shapes, needed_answers;  // what each must declare
};

void add_engine_options(CLI::App& command, EngineArguments& arguments);

// Starts each. Throws std::runtime_error with one line to show for one that cannot be asked, and where two have one
// name.
[[nodiscard]] std::vector<std::unique_ptr<external::Engine>> start_engines(const EngineArguments& arguments);

// Ends each; a line for every one that left processes behind.
[[nodiscard]] std::vector<std::string> finish_engines(
    std::span<const std::unique_ptr<external::Engine>> engines);

}  // namespace graze::tool
