// graze price: measures how much time accuracy costs.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <thread>

#include "corpus/format/case_json.hpp"
#include "corpus/workloads.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/price_page.hpp"
#include "reports/price/advice.hpp"
#include "reports/price/price_run.hpp"
#include "reports/price/price_workloads.hpp"
#include "reports/price/screen.hpp"
#include "reports/price/sentences.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/stop.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/engines.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

constexpr std::uint64_t kFastRounds = 5, kThoroughRounds = 9, kMostRounds = 999;

struct PriceArguments {
  std::vector<std::string> only;
  EngineArguments engines;
  bool quick = false, thorough = false, full = false, goes_on = false;
  std::uint64_t seed = 1, rounds = 0;
  unsigned threads = 0;
  std::string json, csv, report, page;
  std::optional<std::uint64_t> workloads;
};

// As it would be typed again.
std::string price_line(const PriceArguments& arguments) {
  std::string text = "graze price";
  for (const std::string& name : arguments.only) text += fmt::format(" --only '{}'", name);
  for (const std::string& engine : arguments.engines.commands) text += fmt::format(" --engine '{}'", engine);
  if (arguments.thorough) text += " --thorough";
  if (arguments.seed != 1) text += fmt::format(" --seed {}", arguments.seed);
  if (arguments.rounds > 0) text += fmt::format(" --rounds {}", arguments.rounds);
  return text;
}

int rounds_of(const PriceArguments& arguments) {
  const std::uint64_t usual = arguments.thorough ? kThoroughRounds : kFastRounds;
  return static_cast<int>(arguments.rounds > 0 ? arguments.rounds : usual);
}

// The results that a stopped run left in the file that this run writes.
price::Document begun(const PriceArguments& arguments) {
  if (!arguments.goes_on) return {};
  if (arguments.json.empty() || arguments.json == "-")
    throw std::runtime_error("--continue: needs --json FILE, the file of the run that was stopped");
  if (!std::filesystem::exists(arguments.json)) return {};
  const corpus::FileText file = corpus::read_whole_file(arguments.json);
  if (!file.error.empty()) throw std::runtime_error(arguments.json + ": " + file.error);
  price::Document document = price::read_document(file.text, arguments.json);
  const std::string effort = arguments.thorough ? "thorough" : "quick";
  if (document.effort != effort || document.seed != arguments.seed) {
    throw std::runtime_error(fmt::format("{}: is of a {} run with seed {}, and this is a {} one with seed {}",
                                         arguments.json, document.effort, document.seed, effort,
                                         arguments.seed));
  }
  if (document.rounds != rounds_of(arguments)) {
    throw std::runtime_error(fmt::format("{}: is of {} rounds, and this run is of {}", arguments.json,
                                         document.rounds, rounds_of(arguments)));
  }
  const price::Machine here = price::this_machine();
  if (document.machine.processor != here.processor || document.machine.build != here.build)
    throw std::runtime_error(arguments.json + ": machine: is another one, or another build");
  return document;
}

void write_whole(const std::string& name, const std::string& text) {
  OutputFile file(name);
  file.write_line(text);
  file.close();
}

// index.html, and the measurements, price.json.
void write_report(const PriceArguments& arguments, const price::Document& document) {
  if (arguments.report.empty()) return;
  const std::filesystem::path folder = arguments.report;
  const std::string measured = price::write_document(document);
  write_whole((folder / "price.json").string(), measured);
  const std::string page = show::price_page(
      show::read_price(measured),
      {.command = price_line(arguments), .plain = price::screen_of(document, arguments.full)});
  write_whole((folder / "index.html").string(), page.substr(0, page.size() - 1));
  if (!show::has_viewer())
    complain("this graze was built without Node: the report lacks the viewer (docs/howto/show.md)");
}

void write_json(const PriceArguments& arguments, const price::Document& document) {
  if (!arguments.json.empty()) write_whole(arguments.json, price::write_document(document));
}

// --workloads: the steps of simulations instead.
int show_workloads(const PriceArguments& arguments) {
  for (const std::string& name : arguments.only) {
    const auto all = corpus::workloads();
    if (std::none_of(all.begin(), all.end(), [&](const corpus::Family& one) { return one.name == name; }))
      throw std::runtime_error(
          fmt::format("--only: {} is no workload; `graze generate --help` lists them", name));
  }
  const StopBySignal signals;
  const price::WorkloadSettings settings{
      .casts = *arguments.workloads, .seed = arguments.seed, .only = arguments.only, .stop = [] {
        return StopBySignal::received() != 0;
      }};
  const std::vector<price::WorkloadRow> rows = price::measure_workloads(settings);
  fmt::print("{}", price::workload_table(rows));
  if (const int signal = StopBySignal::received(); signal != 0) return 128 + signal;
  if (!arguments.page.empty()) {
    std::string page = price::workload_page(rows, settings, price::this_machine());
    page.pop_back();
    write_whole(arguments.page, page);
  }
  return 0;
}

int run_price_command(const PriceArguments& arguments) {
  if (arguments.workloads) return show_workloads(arguments);
  if (!arguments.page.empty()) throw std::runtime_error("--page: applies to --workloads; give both");
  if (arguments.quick && arguments.thorough)
    throw std::runtime_error("--quick and --thorough: a run is one of the two");
  require_own_files({arguments.json, arguments.csv});
  if (!arguments.report.empty()) require_folder(arguments.report);
  price::Document document = begun(arguments);
  const Engines engines(arguments.engines);
  price::RunSettings settings{.thorough = arguments.thorough,
                              .seed = arguments.seed,
                              .threads = arguments.threads > 0
                                             ? arguments.threads
                                             : std::max(1U, std::thread::hardware_concurrency()),
                              .rounds = rounds_of(arguments),
                              .others = engines.methods(),
                              .only = arguments.only};
  for (const std::string& name : arguments.only) {
    if (!price::is_known(name, arguments.thorough)) {
      throw std::runtime_error(
          fmt::format("--only: {} is no table, group or series; groups are smooth, rotation, sums, large, "
                      "ties and polytopes, "
                      "docs/reports/price.md has the others",
                      name));
    }
  }
  document.version = GRAZE_VERSION;
  document.machine = price::this_machine();
  // Both files are written before anything is measured, so an error in writing is reported at once. Results
  // are saved table by table, so that a run that is stopped, or ends otherwise, can be continued.
  settings.keep = [&](const price::Document& so_far) {
    if (arguments.json != "-") write_json(arguments, so_far);
  };
  document.finished = false;
  settings.keep(document);
  if (!arguments.csv.empty() && arguments.csv != "-") write_whole(arguments.csv, price::csv_of(document));
  const StopBySignal signals;
  settings.stop = [] { return StopBySignal::received() != 0; };
  document = price::run(settings, std::move(document));
  document.machine = price::this_machine();
  document.advice = price::advice_of(document);
  document.sentences = price::sentences_of(document);
  const std::vector<std::string> orphans = engines.finish();
  for (const std::string& line : orphans) complain(line);
  write_json(arguments, document);
  if (!arguments.csv.empty()) write_whole(arguments.csv, price::csv_of(document));
  write_report(arguments, document);
  // Standard output is one thing's.
  if (arguments.json != "-" && arguments.csv != "-") {
    fmt::print("{}", price::screen_of(document, arguments.full));
    fmt::print("{} tables, {} rounds, {:.0f} s on {} ({} cores, load {:.1f}), {}, {}.\n",
               document.tables.size(), document.rounds, document.seconds, document.machine.processor,
               document.machine.cores, document.machine.load, document.machine.compiler,
               document.machine.build);
  }
  if (const int signal = StopBySignal::received(); signal != 0) {
    if (!arguments.json.empty() && arguments.json != "-")
      complain("stopped; the same command with --continue continues from here");
    return 128 + signal;
  }
  return orphans.empty() ? 0 : 1;
}

}  // namespace

void add_price_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<PriceArguments>();
  CLI::App* command = app.add_subcommand(
      "price", "Measures what accuracy costs in time: every method's error against its time.");
  command->add_flag("--quick", arguments->quick, "The default: a few dozen cases a table, half a minute");
  command->add_flag("--thorough", arguments->thorough,
                    "Eight times the cases, every decade of tolerance, more rounds: an hour or so");
  command
      ->add_option(
          "--only", arguments->only,
          "Measure this table, group or series (may be repeated): smooth, polytopes, 'vertices, climbed'")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--seed", arguments->seed, "The seed of the cases (1)")
      ->check(seed_number())
      ->type_name("S");
  command
      ->add_option("--rounds", arguments->rounds,
                   fmt::format("How often each contender is timed on each case ({}; --thorough {})",
                               kFastRounds, kThoroughRounds))
      ->check(whole_number(1, kMostRounds))
      ->type_name("N");
  command
      ->add_option("--threads", arguments->threads, "Threads that measure errors; one alone measures times")
      ->check(whole_number(1, kMostThreads))
      ->type_name("N");
  command->add_flag("--full", arguments->full, "Print every row of every table");
  command
      ->add_option("--json", arguments->json,
                   "Write everything to this file (docs/schemas/graze.price.schema.json), after every table")
      ->type_name("OUT.json");
  command->add_option("--csv", arguments->csv, "Write every row of every table to this file")
      ->type_name("OUT.csv");
  command
      ->add_option(
          "--report", arguments->report,
          "Write the report into this folder: index.html, one page that needs no network, and price.json")
      ->type_name("DIR");
  command
      ->add_option(
          "--workloads", arguments->workloads,
          "Instead: the steps of simulations (docs/reference/workloads.md), N casts of each workload at each "
          "place; --only names workloads")
      ->check(whole_number(1))
      ->type_name("N");
  command
      ->add_option("--page", arguments->page,
                   "With --workloads: write docs/reports/workloads.md to this file")
      ->type_name("OUT.md");
  command->add_flag("--continue", arguments->goes_on,
                    "Continue the stopped run whose results are in the file of --json");
  add_engine_options(*command, arguments->engines);
  command->footer(
      "One run asks all contenders the same cases in turn, in a new random order for every round. Ratios "
      "are relative to\n"
      "the baseline that each table names, with the least and the greatest of the rounds. Errors are "
      "measured against the\n"
      "exact or the bracket oracle, for rotating bodies against a proof. docs/reports/price.md explains "
      "the results.\n\n"
      "  graze price --json price.json\n"
      "  graze price --only smooth --only polytopes --full\n"
      "  graze price --engine ./my_engine --only polytopes    it stands in the tables if it times its "
      "calls\n"
      "  graze price --report DIR                             a page to look at: DIR/index.html\n"
      "  python3 reports/price/figures.py price.json figures  every figure\n"
      "  graze price --workloads 1000                         what the steps of simulations cost\n"
      "  graze compare old.json price.json                    what got slower, what less accurate?\n\n"
      "Exit code: 0; 2 for bad input; 130 if it was stopped.");
  command->callback([arguments, command, &exit_code] {
    require_engine(*command);
    exit_code = run_price_command(*arguments);
  });
}

}  // namespace graze::tool
