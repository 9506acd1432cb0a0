#include "tools/commands/engines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "certify/external/engine_methods.hpp"
#include "certify/tally.hpp"
#include "corpus/format/fields.hpp"
#include "engines/system/system.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

constexpr const char* kGroup = "Third-party engines";
// Seconds: what a limit counts, and a day.
constexpr double kLeastTime = 0.001, kMostTime = 86400;
constexpr std::array<std::string_view, 7> kAnswers = {"verdict",  "time",  "normal", "witnesses",
                                                      "distance", "depth", "proof"};

// Accepts only these names. Any other name would be refused for every engine.
CLI::Validator one_of(std::span<const std::string_view> names, const char* what) {
  return {[=](const std::string& text) {
            if (std::find(names.begin(), names.end(), text) != names.end()) return std::string();
            return fmt::format("{} is no {}; it is {}", text, what, corpus::joined(names));
          },
          ""};
}

// The needed properties that an engine does not declare. Empty if it declares all.
std::string lacking(const external::Declaration& engine, const EngineArguments& arguments) {
  for (const std::string& shape : arguments.needed_shapes) {
    if (!engine.takes(shape)) return fmt::format("it does not take the shape {}", shape);
  }
  for (const std::string& answer : arguments.needed_answers) {
    const auto holds = [&](const external::Offer& offer) {
      return answer == "verdict" || (answer == "time" && offer.holds.time) ||
             (answer == "normal" && offer.holds.normal) || (answer == "witnesses" && offer.holds.witnesses) ||
             (answer == "distance" && offer.holds_distance) || (answer == "depth" && offer.holds_depth) ||
             (answer == "proof" && offer.holds_proof);
    };
    if (std::none_of(engine.offers.begin(), engine.offers.end(), holds))
      return fmt::format("none of its answers holds {}", answer);
  }
  return {};
}

}  // namespace

void add_engine_options(CLI::App& command, EngineArguments& arguments) {
  command
      .add_option("--engine", arguments.commands,
                  "Ask this program, with its arguments, or this shared library (may be repeated). Our own "
                  "methods are then asked only if --method names them")
      ->type_name("COMMAND")
      ->allow_extra_args(false)
      ->group(kGroup);
  command.add_option("--time-limit", arguments.time_limit, "Seconds that an engine has for an answer (1)")
      ->check(number_from(kLeastTime, kMostTime))
      ->type_name("S")
      ->group(kGroup);
  command
      .add_option("--memory-limit", arguments.memory_limit,
                  "MiB of memory that a process of the engine may use (2048)")
      ->check(whole_number(1, 1U << 20))
      ->type_name("MIB")
      ->group(kGroup);
  command
      .add_flag("--beyond-limits", arguments.beyond_limits,
                "Also ask questions beyond the limits that the engine documents")
      ->group(kGroup);
}

void add_promise_options(CLI::App& command, EngineArguments& arguments) {
  command
      .add_option("--tolerance", arguments.tolerance,
                  "Judge the engine by this error bound, a length, whatever it declares")
      ->check(number_from(0))
      ->type_name("X")
      ->group(kGroup);
  command
      .add_option("--relative-tolerance", arguments.relative_tolerance,
                  "The same, relative to the scale of each question")
      ->check(number_from(0))
      ->type_name("X")
      ->group(kGroup);
  command.add_option("--kappa", arguments.kappa, "The same, in units of u scale")
      ->check(number_from(0))
      ->type_name("K")
      ->group(kGroup);
  command
      .add_flag(
          "--measure", arguments.measure,
          fmt::format(
              "Only measure errors, whatever the engine declares. Without a declared or given bound, the "
              "bound is {:g} of scale",
              external::kAssumedRelativeTolerance))
      ->excludes("--tolerance")
      ->excludes("--relative-tolerance")
      ->excludes("--kappa")
      ->group(kGroup);
}

CLI::Option* add_declined_option(CLI::App& command, bool& allow_declined) {
  return command.add_flag(
      "--allow-declined", allow_declined,
      fmt::format("An engine may answer unsupported to more than {:g} % of the questions that it "
                  "takes",
                  100 * kMostDeclined));
}

void add_need_options(CLI::App& command, EngineArguments& arguments) {
  command
      .add_option("--needs-shape", arguments.needed_shapes,
                  "Refuse an engine that does not declare this shape (may be repeated)")
      ->check(one_of(external::shape_names(), "shape"))
      ->type_name("SHAPE")
      ->allow_extra_args(false)
      ->group(kGroup);
  command
      .add_option("--needs-answer", arguments.needed_answers,
                  "Refuse an engine none of whose queries declares this answer (may be repeated)")
      ->check(one_of(kAnswers, "answer"))
      ->type_name("ANSWER")
      ->allow_extra_args(false)
      ->group(kGroup);
}

void require_engine(const CLI::App& command) {
  if (command.get_option("--engine")->count() > 0) return;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group() != kGroup || option->count() == 0) continue;
    const std::string name = option->get_name();
    const char* what = name.starts_with("--needs")       ? "is what an engine must declare"
                       : name.find("limit") != name.npos ? "applies to third-party engines"
                                                         : "is what an engine is held to";
    throw std::runtime_error(fmt::format("{}: {}; name one with --engine", name, what));
  }
}

Engines::Engines(const EngineArguments& arguments) {
  std::map<std::string, std::string> names;
  for (const std::string& command : arguments.commands) {
    external::EngineOptions options{.command = command,
                                    .library_host = {system::same_program(), "host"},
                                    .host_takes_frames = true,
                                    .tolerance = arguments.tolerance,
                                    .relative_tolerance = arguments.relative_tolerance,
                                    .kappa = arguments.kappa,
                                    .measure = arguments.measure,
                                    .beyond_limits = arguments.beyond_limits};
    options.limits.time =
        std::chrono::milliseconds(static_cast<std::int64_t>(std::ceil(arguments.time_limit * 1000)));
    options.limits.memory = arguments.memory_limit << 20;
    engines_.push_back(std::make_unique<external::Engine>(std::move(options)));
    if (const std::string what = lacking(engines_.back()->declaration(), arguments); !what.empty())
      throw std::runtime_error(fmt::format("--engine: {}: {}", command, what));
    const std::string& name = engines_.back()->declaration().name;
    if (const auto [known, is_new] = names.emplace(name, command); !is_new) {
      throw std::runtime_error(
          fmt::format("--engine: {} and {} both call themselves {}; an engine has a name of its own",
                      known->second, command, name));
    }
  }
}

std::vector<const engine::Method*> Engines::methods(std::optional<engine::Kind> kind) const {
  std::vector<const engine::Method*> all;
  for (const auto& engine : engines_) {
    for (const engine::Method& method : engine->methods()) {
      if (!kind || method.kind == *kind) all.push_back(&method);
    }
  }
  return all;
}

std::vector<std::string> Engines::finish() const {
  std::vector<std::string> lines;
  for (const auto& engine : engines_) {
    if (const int left = engine->finish(); left > 0) {
      lines.push_back(fmt::format("{}: {} process{} outlived it, left behind", engine->declaration().name,
                                  left, left > 1 ? "es" : ""));
    }
  }
  return lines;
}

int with_orphaned_processes(const Engines& engines, int code) {
  const std::vector<std::string> lines = engines.finish();
  for (const std::string& line : lines) fmt::print("broken: {}\n", line);
  return code == 0 && !lines.empty() ? 1 : code;
}

}  // namespace graze::tool
