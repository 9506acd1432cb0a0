// graze compare: compares two runs of graze price for slower times and less accurate answers.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "corpus/format/case_json.hpp"
#include "reports/price/price_compare.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

struct CompareArguments {
  std::string before, after;
  double threshold = 0.1, error_factor = 2;
  bool all = false;
};

price::Document read(const std::string& name) {
  const corpus::FileText file = corpus::read_whole_file(name);
  if (!file.error.empty()) throw std::runtime_error(name + ": " + file.error);
  return price::read_document(file.text, name);
}

int run_compare_command(const CompareArguments& arguments) {
  will_read({arguments.before, arguments.after});
  const price::Document before = read(arguments.before), after = read(arguments.after);
  const price::Comparison found = price::compare(
      before, after, {.threshold = arguments.threshold, .error_factor = arguments.error_factor});
  for (const std::string& line : found.worse) fmt::print("worse: {}\n", line);
  if (arguments.all) {
    for (const std::string& line : found.better) fmt::print("better: {}\n", line);
  }
  for (const std::string& line : found.not_compared) fmt::print("not compared: {}\n", line);
  fmt::print("{} rows compared: {} worse, {} better, {} not compared.\n", found.rows, found.worse.size(),
             found.better.size(), found.not_compared.size());
  return found.worse.empty() ? 0 : 1;
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand(
      "compare", "Lists what got slower or less accurate between two runs of graze price.");
  command->add_option("old", arguments->before, "The file that graze price --json wrote before")
      ->required()
      ->type_name("OLD.json");
  command->add_option("new", arguments->after, "And now")->required()->type_name("NEW.json");
  command
      ->add_option("--threshold", arguments->threshold,
                   "Report a ratio of times or a mean of supports if it grew by this fraction (0.1)")
      ->check(number_from(0, 100))
      ->type_name("X");
  command
      ->add_option("--error-factor", arguments->error_factor,
                   "Report an error if it grew by this factor, beyond rounding (2)")
      ->check(number_from(1, 1e12))
      ->type_name("X");
  command->add_flag("--all", arguments->all, "Also report what got better");
  command->footer(
      "Two kinds of numbers are compared: ratios to the baseline of the same run whose spreads do not "
      "overlap, and numbers\n"
      "that depend on no clock (supports, steps, errors, verdicts). Times are never compared, so the runs "
      "may come from two\n"
      "machines.\n\n"
      "  graze compare old.json new.json --threshold 0.2\n\n"
      "Exit code: 0; 1 if something got worse; 2 for bad input.");
  command->callback([arguments, &exit_code] { exit_code = run_compare_command(*arguments); });
}

}  // namespace graze::tool
