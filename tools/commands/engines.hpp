// The options that name third-party engines (docs/reference/protocol.md), and those engines.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certify/external/engine.hpp"

namespace graze::tool {

struct EngineArguments {
  std::vector<std::string> commands;
  double time_limit = 1;              // seconds
  std::uint64_t memory_limit = 2048;  // MiB
  std::optional<double> tolerance, relative_tolerance, kappa;
  bool measure = false, allow_declined = false;
  bool beyond_limits = false;
  std::vector<std::string> needed_shapes, needed_answers;  // every engine must declare these
};

// Adds the options that name engines and limit a question, for every command that asks engines.
void add_engine_options(CLI::App& command, EngineArguments& arguments);
// Adds the options for the engines' guarantees, for commands that judge.
void add_promise_options(CLI::App& command, EngineArguments& arguments);
CLI::Option* add_declined_option(CLI::App& command, bool& allow_declined);
// Adds the options for properties that each engine must declare.
void add_need_options(CLI::App& command, EngineArguments& arguments);
// Throws std::runtime_error with one line to show if one of these options is given, and no engine.
void require_engine(const CLI::App& command);

// The engines that the command line names, for as long as they are asked.
class Engines {
 public:
  // Starts each engine. Throws std::runtime_error with a one-line message if one cannot be asked, or if two have one
  // name.
  explicit Engines(const EngineArguments& arguments);

  [[nodiscard]] bool empty() const { return engines_.empty(); }
  [[nodiscard]] std::span<const std::unique_ptr<external::Engine>> all() const { return engines_; }
  // Their methods, engine by engine. With `kind`, only those of that kind.
  [[nodiscard]] std::vector<const engine::Method*> methods(std::optional<engine::Kind> kind = {}) const;

  // Ends each engine. Returns a line for every engine that left processes behind.
  [[nodiscard]] std::vector<std::string> finish() const;

 private:
  std::vector<std::unique_ptr<external::Engine>> engines_;
};

// Ends each engine, and reports those that left processes behind. Returns the exit code of a run that would end with
// `code`.
[[nodiscard]] int with_orphaned_processes(const Engines& engines, int code);

}  // namespace graze::tool
