#include "tools/commands/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>

#include "certify/stability_plot.hpp"
#include "certify/stability_report.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/stop.hpp"

namespace graze::tool {
namespace {

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
      "Backward error: of the bracket's worse end, or the clearance or depth that a wrong verdict denies; "
      "over u scale of\n"
      "the method's scalar, and over scale. wrong: verdicts that are not the true one, and the clearance or "
      "depth up to\n"
      "which there were any. late: by more than the row grants. row: what the row of the guarantee table "
      "grants.\n"
      "A miss that is right and a stall have no error.\n\n");
  if (const std::string broken = break_table(curves); !broken.empty()) {
    fmt::print(
        "Where each method breaks: the first hardness at which an answer is beyond its row, the forward "
        "error "
        "exceeds sqrt(u)\nof scale (half of the digits), a verdict is not the true one, a search does not "
        "converge\n\n{}\n",
        broken);
  }
  fmt::print("Summary: each method at its worst over all families\n\n{}\n", summary_table(curves));
}

}  // namespace

int run_stability(const StabilityRun& given) {
  StabilityRun run = given;
  const StopBySignal signals;
  run.settings.stop = [] { return StopBySignal::received() != 0; };
  std::unique_ptr<OutputFile> save;
  if (!run.save.empty()) save = std::make_unique<OutputFile>(run.save);
  std::vector<Curve> curves;
  std::vector<std::string> unfinished;
  for (const corpus::Family* family : run.families) {
    if (!is_measured(*family, run.settings)) continue;
    FamilyStability measured = measure_family(*family, run.settings);
    if (measured.stopped) unfinished.push_back(measured.family);
    if (measured.stopped && measured.cases == 0) continue;
    fmt::print("{}\n", family_line(measured));
    if (run.by_level) fmt::print("\n{}\n", level_table(measured));
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
  fmt::print("{}\n", !broken.empty() ? "A method is not as stable as its row of the guarantee table says."
                     : !unfinished.empty()
                         ? "Stopped: every method is as stable as its row says so far."
                         : "Every method is as stable as its row of the guarantee table says.");
  if (const int signal = StopBySignal::received(); signal != 0) return 128 + signal;
  return broken.empty() ? 0 : 1;
}

}  // namespace graze::tool
