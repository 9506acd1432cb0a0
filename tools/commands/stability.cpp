// graze stability: measures the families one by one, prints the results, draws the curves.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>

#include "certify/built_in.hpp"
#include "certify/stability.hpp"
#include "certify/stability_plot.hpp"
#include "certify/stability_report.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/stop.hpp"
#include "tools/commands/certify_selection.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/judged_options.hpp"

namespace graze::tool {
namespace {

// Cases of each level of a family: the oracle measures every one, of curved shapes in tens of milliseconds.
constexpr std::size_t kLevelCases = 40, kRotatingLevelCases = 12;

struct StabilityArguments : JudgedArguments {
  std::string plot;  // the folder of the pictures, empty for none
};

bool is_measured(const corpus::Family& family, const StabilitySettings& settings) {
  const engine::Kind kind = family.rotating ? engine::Kind::rotating : engine::Kind::linear;
  const auto is_of_kind = [&](const engine::Method* method) { return method->kind == kind; };
  return (family.rotating ? settings.rotating_count : settings.count) > 0 &&
         std::any_of(settings.methods.begin(), settings.methods.end(), is_of_kind);
}

void print_drawn(const std::string& line) {
  if (!line.empty()) fmt::print("{}\n", line);
}

void print_tables(const std::vector<Curve>& curves) {
  fmt::print("\nEach method on each family, at its worst\n\n{}\n", stability_table(curves));
  fmt::print(
      "Backward error: the error of the bracket's worse end, or the clearance or depth that a wrong "
      "verdict denies, over\n"
      "u scale of the method's scalar and over scale. wrong: verdicts that are not the true one, and the "
      "largest clearance\n"
      "or depth among them. late: by more than the guarantee allows. row: the limit of the guarantee. A "
      "correct miss and\n"
      "an answer that did not converge have no error.\n\n");
  if (const std::string broken = break_table(curves); !broken.empty()) {
    fmt::print(
        "The hardness at which each method breaks: the first at which an answer exceeds its guarantee, the "
        "forward error\n"
        "exceeds sqrt(u) of scale (half of the digits), a verdict is not the true one, or a search does "
        "not converge\n\n"
        "{}\n",
        broken);
  }
  fmt::print("Summary: each method at its worst over all families\n\n{}\n", summary_table(curves));
}

// Returns the exit code: 1 if a method breaks its guarantee, 2 if there is nothing to measure, and 128 plus its number
// after a signal.
int measure(const StabilityArguments& run, const Selection& selection) {
  StabilitySettings settings{.methods = selection.all(),
                             .count = run.count.value_or(kLevelCases),
                             .rotating_count = run.rotating.value_or(kRotatingLevelCases),
                             .seed = run.seed,
                             .threads = run.most_threads()};
  const std::vector<const corpus::Family*> families = wanted_families(run.families, false);
  const StopBySignal signals;
  settings.stop = [] { return StopBySignal::received() != 0; };
  std::unique_ptr<OutputFile> save;
  if (!run.save.empty()) save = std::make_unique<OutputFile>(run.save);
  std::vector<Curve> curves;
  std::vector<std::string> unfinished;
  for (const corpus::Family* family : families) {
    if (!is_measured(*family, settings)) continue;
    FamilyStability measured = measure_family(*family, settings);
    if (measured.stopped) unfinished.push_back(measured.family);
    if (measured.stopped && measured.cases == 0) continue;
    fmt::print("{}\n", family_line(measured));
    if (!run.families.empty()) fmt::print("\n{}\n", level_table(measured));
    if (!run.plot.empty()) print_drawn(draw_family(measured, run.plot));
    std::fflush(stdout);  // a run that is stopped has shown the families that it finished
    if (save) {
      for (const corpus::Case& problem : measured.convicted) save->write_line(corpus::write_case(problem));
    }
    std::move(measured.curves.begin(), measured.curves.end(), std::back_inserter(curves));
  }
  if (curves.empty() && unfinished.empty()) {
    complain("there is nothing to measure; give a count above 0, and a method for the family");
    return 2;
  }
  if (save) save->close();
  if (!curves.empty()) print_tables(curves);
  if (!run.plot.empty()) {
    for (const bool rotating : {false, true}) print_drawn(draw_overview(curves, rotating, run.plot));
  }
  const std::vector<std::string> broken = breaches(curves);
  for (const std::string& line : broken) fmt::print("broken: {}\n", line);
  if (!unfinished.empty()) fmt::print("Not finished: {}\n", fmt::join(unfinished, ", "));
  fmt::print("{}\n", !broken.empty() ? "A method is not as stable as its guarantee says."
                     : !unfinished.empty()
                         ? "Stopped: every method is as stable as its guarantee says so far."
                         : "Every method is as stable as its guarantee says.");
  if (const int signal = StopBySignal::received(); signal != 0) return 128 + signal;
  return broken.empty() ? 0 : 1;
}

}  // namespace

void add_stability_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<StabilityArguments>();
  CLI::App* command = app.add_subcommand(
      "stability", "How does the error of each method grow with hardness? Measures curves by the oracle.");
  add_judged_options(*command, *arguments, fmt::format("Cases of each level of hardness ({})", kLevelCases),
                     fmt::format("The same of a rotating family ({})", kRotatingLevelCases));
  command
      ->add_option("--plot", arguments->plot,
                   "Write the data and the pictures of error against hardness into this folder")
      ->type_name("DIR");
  command
      ->add_option("--save", arguments->save,
                   "Write the cases on which a method was wrong or did not converge to this file")
      ->type_name("OUT.jsonl");
  add_engine_options(*command, arguments->engines);
  add_promise_options(*command, arguments->engines);
  add_need_options(*command, arguments->engines);
  add_guarantees_option(*command, *arguments);
  command->footer(
      "Every case is measured by the oracle (docs/reports/stability.md). With --family the curves are "
      "printed, level by level.\n\n"
      "  graze stability --plot curves\n"
      "  graze stability --family parallel_edges --count 200 --method mpr/double\n"
      "  graze stability --engine ./my_engine\n\n"
      "Exit code: 0 if every method is as stable as its guarantee says, 1 if one is not, 2 for bad input,\n"
      "and if there is nothing to measure.");
  command->callback([arguments, command, &exit_code] {
    require_engine(*command);
    if (!arguments->plot.empty()) require_folder(arguments->plot);
    const Selection selection(*arguments);
    exit_code = with_orphaned_processes(selection.engines(), measure(*arguments, selection));
  });
}

}  // namespace graze::tool
