// graze certify: how accurate, how fast and how safe is each method, and does it keep its guarantee?
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <thread>

#include "certify/built_in.hpp"
#include "certify/certification.hpp"
#include "certify/engine_findings.hpp"
#include "certify/intake.hpp"
#include "certify/worst_cases.hpp"
#include "report/counted.hpp"
#include "report/inputs.hpp"
#include "report/stop.hpp"
#include "tools/commands/certify_pages.hpp"
#include "tools/commands/certify_selection.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/engines.hpp"
#include "tools/commands/law.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/stability.hpp"

namespace graze::tool {
namespace {

using engine::Kind;

// To make a finding of an engine of others small.
constexpr int kSmallerAsks = 2000;
constexpr double kSmallerSeconds = 20;

// What an exit code becomes where engines of others left processes behind, which is said.
int with_left_behind(const Engines& engines, int code) {
  const std::vector<std::string> lines = engines.finish();
  for (const std::string& line : lines) fmt::print("broken: {}\n", line);
  return code == 0 && !lines.empty() ? 1 : code;
}

// --stability: curves of error against hardness instead.
int show_stability(const CertifyArguments& arguments, const Settings& settings, const Selection& selection) {
  if (!arguments.files.empty()) {
    throw std::runtime_error("--stability: takes families, not files: a file has no levels of hardness");
  }
  const int code =
      run_stability({.settings = {.methods = settings.methods,
                                  .count = arguments.count.value_or(kLevelCases),
                                  .rotating_count = arguments.rotating.value_or(kRotatingLevelCases),
                                  .seed = arguments.seed,
                                  .threads = settings.threads},
                     .families = wanted_families(arguments.families, false),
                     .by_level = !arguments.families.empty(),
                     .plot = arguments.plot,
                     .save = arguments.save});
  return with_left_behind(selection.engines(), code);
}

// --laws: every law instead.
int show_laws(const CertifyArguments& arguments) {
  const Engines engines(arguments.engines);
  const int code = run_laws({.files = arguments.files,
                             .families = arguments.families,
                             .methods = arguments.our_methods(),
                             .laws = arguments.law_names,
                             .others = engines.methods(),
                             .count = arguments.count,
                             .rotating = arguments.rotating,
                             .seed = arguments.seed,
                             .threads = arguments.threads,
                             .corpus = arguments.corpus,
                             .save = arguments.save,
                             .report = arguments.report});
  return with_left_behind(engines, code);
}

// Whether an engine took no case of those that were judged: its verdict would be that of nothing.
bool complain_of_unasked(const Engines& engines, const Certification& certification) {
  bool is_any = false;
  for (const auto& engine : engines.all()) {
    std::size_t asked = 0;
    // A row of a promise is one method's.
    for (const engine::Method& method : engine->methods()) {
      for (const std::vector<Tally>* tallies : {&certification.tallies, &certification.beyond_limits}) {
        for (const Tally& tally : *tallies) {
          if (tally.method->guarantee == method.guarantee) asked += tally.cases;
        }
      }
    }
    if (asked > 0 || !certification.unfinished.empty()) continue;
    is_any = true;
    complain(fmt::format("{}: no answer of it was judged: of {} it takes none (docs/reference/protocol.md)",
                         engine->declaration().name, counted(certification.questions, "case")));
  }
  return is_any;
}

// Whether no answer at all was judged, and no stop was the reason.
bool complain_of_no_answer(const Certification& certification) {
  if (certification.answers > 0 || !certification.unfinished.empty()) return false;
  complain(fmt::format("no answer was judged: of {} no method takes any{}",
                       counted(certification.questions, "case"),
                       certification.unasked.empty() ? "" : "; " + certification.unasked));
  return true;
}

int run_certify_command(const CertifyArguments& arguments) {
  if (arguments.laws) return show_laws(arguments);
  const auto start = std::chrono::steady_clock::now();
  const Selection selection(arguments);
  Settings settings{.methods = selection.all(),
                    .threads = arguments.threads > 0 ? arguments.threads
                                                     : std::max(1U, std::thread::hardware_concurrency())};
  will_read(arguments.files);
  if (arguments.takes_curated() && !arguments.stability) {
    const std::string curated = curated_directory(arguments).string();
    if (!std::filesystem::is_directory(curated))
      throw std::runtime_error(curated + ": is no folder of cases");
    will_read({curated, known_failures().string()});
  }
  if (!arguments.plot.empty()) {
    if (!arguments.stability)
      throw std::runtime_error(
          "--plot: draws error against hardness, of --stability; of error against time graze price");
    require_folder(arguments.plot);
  }
  if (!arguments.findings.empty()) require_folder(arguments.findings);
  if (!arguments.report.empty()) require_folder(arguments.report);
  if (arguments.stability) return show_stability(arguments, settings, selection);
  CertifyFiles files(arguments);

  Intake intake;
  const bool bad = take_all(intake, arguments, selection);
  if (arguments.counts().rotating == 0) {
    std::erase_if(settings.methods,
                  [](const engine::Method* method) { return method->kind == Kind::rotating; });
  }
  intake.leave_out(settings.methods, arguments.files);
  if (intake.suites.empty()) {
    if (!bad) {
      complain(fmt::format(
          "{}there is no case to judge; give a file with one, or a count above 0, and a method for it",
          intake.why.empty() ? "" : fmt::format("{}; ", fmt::join(intake.why, "; "))));
    }
    return 2;
  }
  for (const std::string& line : intake.why) complain(line);

  const StopBySignal signals;
  settings.stop = [] { return StopBySignal::received() != 0; };
  settings.fail_fast = arguments.fail_fast;
  settings.allow_declined = arguments.engines.allow_declined;
  WorstCases worst;
  if (files.has_page()) {
    settings.judged = [&](const Suite& suite, std::size_t i, const engine::Method& method,
                          const law::Judgement& judgement) { worst.note(suite, i, method, judgement); };
  }
  Certification certification = certify(intake.suites, settings);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const std::vector<EngineFinding> findings =
      arguments.findings.empty() && !(files.has_page() && !selection.engines().empty())
          ? std::vector<EngineFinding>{}
          : engine_findings(certification, kSmallerAsks, kSmallerSeconds);
  std::string html;
  if (files.has_page())
    html = certify_page(arguments, selection, certification, settings, worst, findings, took.count());
  const bool is_unasked =
      complain_of_unasked(selection.engines(), certification) || complain_of_no_answer(certification);
  const std::vector<std::string> left_behind = selection.engines().finish();
  certification.breaches.insert(certification.breaches.end(), left_behind.begin(), left_behind.end());
  // First, so that a reader of them who is gone ends the run before a word is said.
  files.write(certification, settings, took.count(), html);
  print_certification(arguments, selection, certification, settings, intake, took.count());
  if (!arguments.findings.empty())
    fmt::print(arguments.screen(), "\n{}", save_findings(findings, arguments.findings));
  if (const int signal = StopBySignal::received(); signal != 0) return 128 + signal;
  if (bad || is_unasked) return 2;
  return certification.breaches.empty() ? 0 : 1;
}

bool is_given(const CLI::App& command, const std::string& option) {
  return command.get_option(option)->count() > 0;
}

// What is done instead of a judgement of answers, and the options that say nothing of it.
struct Instead {
  const char* option;
  const char* what;
  std::vector<const char*> without_meaning;
};

// Throws std::runtime_error with one line to show for an option that nothing would come of.
void require_meaning(const CLI::App& command) {
  const std::vector<const char*> of_answers = {"--json",         "--junit",     "--findings",
                                               "--full",         "--fail-fast", "--thorough",
                                               "--report-cases", "--queries",   "--oracle-every"};
  Instead laws{"--laws", "tries laws", of_answers}, stability{"--stability", "draws curves", of_answers};
  for (const char* option : {"--stability", "--plot", "--guarantees", "--tolerance", "--relative-tolerance",
                             "--kappa", "--measure", "--allow-declined"})
    laws.without_meaning.push_back(option);
  for (const char* option : {"--report", "--corpus"}) stability.without_meaning.push_back(option);
  for (const Instead& instead : {laws, stability}) {
    if (!is_given(command, instead.option)) continue;
    for (const char* option : instead.without_meaning) {
      if (!is_given(command, option)) continue;
      throw std::runtime_error(
          fmt::format("{}: has no meaning beside {}, which {} instead; leave one of them away", option,
                      instead.option, instead.what));
    }
  }
  require_engine(command);
  if (is_given(command, "--findings") && !is_given(command, "--engine"))
    throw std::runtime_error("--findings: are of engines of others; name one with --engine");
  if (is_given(command, "--report-cases") && !is_given(command, "--report"))
    throw std::runtime_error("--report-cases: is of the report; name its folder with --report");
}

}  // namespace

void add_certify_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<CertifyArguments>();
  CLI::App* command = app.add_subcommand(
      "certify", "How accurate, fast and safe is each method? Judges it against its guarantee.");
  command
      ->add_option("files", arguments->files,
                   "Case files to judge instead of what is built in, casts and other queries; - is standard "
                   "input")
      ->type_name("FILE");
  command->add_option("--family", arguments->families, "Judge cases of this family (may be repeated)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--count", arguments->count,
          fmt::format("Generated cases a family ({}); with --stability, of each level of hardness ({})",
                      kUsual.linear, kLevelCases))
      ->check(whole_number())
      ->type_name("N");
  command->add_option("--seed", arguments->seed, "The first seed of the generated cases (1)")
      ->check(seed_number())
      ->type_name("S");
  command
      ->add_option("--method", arguments->methods,
                   fmt::format("{}; of rotating casts {}; of a query (overlap gjk); one with its scalar "
                               "(mpr/float), or all (may be repeated)",
                               linear_names(), rotating_names()))
      ->type_name("NAME")
      ->allow_extra_args(false);
  command
      ->add_option("--oracle-every", arguments->oracle_every,
                   "Also measure every N-th generated case by the exact oracle (20); of files, all are")
      ->check(whole_number(1))
      ->type_name("N");
  command
      ->add_option(
          "--queries", arguments->queries,
          fmt::format("Cases of each suite whose bodies are asked the other queries, too ({}); 0 asks "
                      "none",
                      kUsual.queries))
      ->check(whole_number())
      ->type_name("N");
  command
      ->add_option(
          "--rotating", arguments->rotating,
          fmt::format("Generated cases of a rotating family ({}; with --stability, of each level, {}); 0 "
                      "leaves every rotating cast out",
                      kUsual.rotating, kRotatingLevelCases))
      ->check(whole_number())
      ->type_name("N");
  command->add_flag("--full", arguments->full,
                    "Print everything: each method on each family, every row of the guarantees");
  command->add_flag(
      "--thorough", arguments->thorough,
      fmt::format("Judge more: {} cases a family, {} of a rotating one, {} for queries; and print "
                  "everything",
                  kThorough.linear, kThorough.rotating, kThorough.queries));
  command->add_flag("--fail-fast", arguments->fail_fast, "Stop at the first fault");
  command
      ->add_option("--threads", arguments->threads, "Threads that judge; the result does not depend on them")
      ->check(whole_number(1, kMostThreads))
      ->type_name("N");
  command
      ->add_option(
          "--plot", arguments->plot,
          "With --stability: write the data and the pictures of error against hardness into this folder")
      ->type_name("DIR");
  command
      ->add_option("--save", arguments->save,
                   "Write the cases that a method got wrong or stalled on to this file")
      ->type_name("OUT.jsonl");
  command
      ->add_option(
          "--json", arguments->json,
          "Write what was counted, method by method and family by family, to this file, one JSON object")
      ->type_name("OUT.json");
  command
      ->add_option("--junit", arguments->junit,
                   "Write a test of each method and family to this file, as JUnit's XML, for build servers")
      ->type_name("OUT.xml");
  command
      ->add_option("--findings", arguments->findings,
                   "Of each engine and kind of fault write a case, made small, into this folder")
      ->type_name("DIR");
  add_engine_options(*command, arguments->engines);
  command
      ->add_option(
          "--report", arguments->report,
          "Write the report into this folder: index.html, one file to look at, which needs no "
          "network, and what was counted, certification.json; with --laws, the smallest broken cases, "
          "cases.jsonl")
      ->type_name("DIR");
  command
      ->add_option(
          "--report-cases", arguments->report_cases,
          fmt::format("Of the cases that the report names, hold this many in full, the worst first ({})",
                      ReportDefaults::kCases))
      ->check(whole_number(0, ReportDefaults::kMost))
      ->type_name("N");
  add_promise_options(*command, arguments->engines);
  add_declined_option(*command, arguments->engines.allow_declined)
      ->group(command->get_option("--engine")->get_group());
  add_need_options(*command, arguments->engines);
  command->add_flag("--stability", arguments->stability,
                    "Instead: curves of error against hardness, every case measured by the oracle "
                    "(docs/reports/stability.md)");
  command->add_option("--corpus", arguments->corpus, "The folder of curated cases")->type_name("DIR");
  command
      ->add_option("--guarantees", arguments->guarantees,
                   "Hold the methods to this table instead of the built-in one")
      ->type_name("FILE");
  add_laws_options(*command, arguments->laws, arguments->law_names);
  command->footer(
      "Without files or families: the curated corpus and every generated family. An answer is judged by its "
      "proof\n"
      "first; the exact oracle decides what is refused or unproved, and measures the errors on a sample.\n"
      "docs/reference/guarantees.md says what each column means. Of files, a query beside the cast is judged "
      "as it is "
      "asked; what\n"
      "nothing judges (a line of bodies that turn) is said, and leaves the exit code to the others.\n\n"
      "  graze certify\n"
      "  graze certify --family grazing_face --count 20000 --method mpr/float --save hard.jsonl\n"
      "  graze certify --method exact --count 20000 --oracle-every 500   a million exact casts\n"
      "  graze certify --family fast_spin --rotating 1000   a thousand cases in which a body turns\n"
      "  graze certify my_cases.jsonl\n"
      "  graze certify --stability --plot curves   how error grows with hardness, and where methods break\n"
      "  graze certify --laws --family grazing_edge --count 500   every law instead, for every method\n\n"
      "Exit code: 0 if every method keeps its row of the guarantee table (--laws: every law holds), 1 if one "
      "does not,\n2 for bad input, and if there is nothing to judge.");
  command->callback([arguments, command, &exit_code] {
    require_meaning(*command);
    exit_code = run_certify_command(*arguments);
  });
}

}  // namespace graze::tool
