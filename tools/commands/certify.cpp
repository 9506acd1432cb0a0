// graze certify: how accurate, how fast and how safe is each method, and does it keep its guarantee?
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

#include "certify/built_in.hpp"
#include "certify/certification.hpp"
#include "certify/engine_findings.hpp"
#include "certify/intake.hpp"
#include "certify/worst_cases.hpp"
#include "reports/text/counted.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/stop.hpp"
#include "tools/commands/certify_pages.hpp"
#include "tools/commands/certify_selection.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/engines.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

using engine::Kind;

// The number of calls that may reduce a finding of a third-party engine.
constexpr int kSmallerAsks = 2000;
constexpr double kSmallerSeconds = 20;

// True if an engine took none of the judged cases. Its verdict would rest on nothing.
bool complain_of_unasked(const Engines& engines, const Certification& certification) {
  bool is_any = false;
  for (const auto& engine : engines.all()) {
    std::size_t asked = 0;
    // Each guarantee belongs to one method.
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

// True if no answer at all was judged and the run was not stopped.
bool complain_of_no_answer(const Certification& certification) {
  if (certification.answers > 0 || !certification.unfinished.empty()) return false;
  complain(fmt::format("no answer was judged: of {} no method takes any{}",
                       counted(certification.questions, "case"),
                       certification.unasked.empty() ? "" : "; " + certification.unasked));
  return true;
}

int run_certify_command(const CertifyArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const Selection selection(arguments);
  Settings settings{.methods = selection.all(), .threads = arguments.most_threads()};
  will_read(arguments.files);
  if (arguments.takes_curated()) {
    const std::string curated = arguments.curated_directory().string();
    if (!std::filesystem::is_directory(curated))
      throw std::runtime_error(curated + ": is no folder of cases");
    will_read({curated, known_failures().string()});
  }
  if (!arguments.findings.empty()) require_folder(arguments.findings);
  if (!arguments.report.empty()) require_folder(arguments.report);
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
  const std::vector<std::string> orphans = selection.engines().finish();
  certification.breaches.insert(certification.breaches.end(), orphans.begin(), orphans.end());
  // Written first, so that a broken pipe ends the run before any text is printed.
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

// For one version, an option that became a command of its own prints that command.
void refuse_old_spellings(const CLI::App& command) {
  for (const auto& [option, now] :
       {std::pair{"--laws", "laws"}, std::pair{"--law", "laws --law"}, std::pair{"--stability", "stability"},
        std::pair{"--plot", "stability --plot"}}) {
    if (is_given(command, option))
      throw std::runtime_error(fmt::format("{}: is a command of its own now: graze {}", option, now));
  }
}

// Throws std::runtime_error with one line to show for an option that nothing would come of.
void require_meaning(const CLI::App& command) {
  require_engine(command);
  if (is_given(command, "--findings") && !is_given(command, "--engine"))
    throw std::runtime_error("--findings: applies to third-party engines; name one with --engine");
  if (is_given(command, "--report-cases") && !is_given(command, "--report"))
    throw std::runtime_error("--report-cases: applies to the report; name its folder with --report");
}

}  // namespace

void add_certify_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<CertifyArguments>();
  CLI::App* command = app.add_subcommand(
      "certify", "How accurate, fast and safe is each method? Judges it against its guarantee.");
  add_file_options(*command, *arguments);
  add_judged_options(
      *command, *arguments, fmt::format("Generated cases a family ({})", kUsual.linear),
      fmt::format("Generated cases of a rotating family ({}); 0 leaves every rotating cast out",
                  kUsual.rotating));
  command
      ->add_option("--oracle-every", arguments->oracle_every,
                   "Also measure every N-th generated case by the exact oracle (20). Cases of files are "
                   "all measured")
      ->check(whole_number(1))
      ->type_name("N");
  command
      ->add_option(
          "--queries", arguments->queries,
          fmt::format(
              "Also ask the other queries about the bodies of this many cases of each suite ({}; 0: none)",
              kUsual.queries))
      ->check(whole_number())
      ->type_name("N");
  command->add_flag("--full", arguments->full,
                    "Print everything: each method on each family, every guarantee");
  command->add_flag(
      "--thorough", arguments->thorough,
      fmt::format("Judge more: {} cases a family, {} of a rotating one, {} for queries; and print "
                  "everything",
                  kThorough.linear, kThorough.rotating, kThorough.queries));
  command->add_flag("--fail-fast", arguments->fail_fast, "Stop at the first fault");
  command
      ->add_option("--save", arguments->save,
                   "Write the cases on which a method was wrong or did not converge to this file")
      ->type_name("OUT.jsonl");
  command
      ->add_option("--json", arguments->json,
                   "Write the counts by method and by family to this file, as one JSON object")
      ->type_name("OUT.json");
  command
      ->add_option("--junit", arguments->junit,
                   "Write a test of each method and family to this file, as JUnit's XML, for build servers")
      ->type_name("OUT.xml");
  command
      ->add_option("--findings", arguments->findings,
                   "Write one shrunk case for each engine and kind of fault into this folder")
      ->type_name("DIR");
  add_engine_options(*command, arguments->engines);
  command
      ->add_option("--report", arguments->report,
                   "Write the report into this folder: index.html, one page that needs no network, and "
                   "certification.json, the counts")
      ->type_name("DIR");
  command
      ->add_option("--report-cases", arguments->report_cases,
                   fmt::format("The report holds this many of its cases in full, the worst first ({})",
                               ReportDefaults::kCases))
      ->check(whole_number(0, ReportDefaults::kMost))
      ->type_name("N");
  add_promise_options(*command, arguments->engines);
  add_declined_option(*command, arguments->engines.allow_declined)
      ->group(command->get_option("--engine")->get_group());
  add_need_options(*command, arguments->engines);
  add_guarantees_option(*command, *arguments);
  for (const char* old : {"--laws", "--stability"}) command->add_flag(old)->group("");
  for (const char* old : {"--law", "--plot"})
    command->add_option(old)->allow_extra_args(false)->take_all()->group("");
  command->footer(
      "Without files or families: the curated corpus and every generated family. An answer is judged by "
      "its proof\n"
      "first. The exact oracle decides refused and unproved answers, and measures the errors on a sample.\n"
      "docs/reference/guarantees.md explains the columns. Queries in files are judged as they are asked. "
      "Cases that\n"
      "nothing can judge (a line of rotating bodies) are reported, and do not affect the exit code.\n\n"
      "  graze certify\n"
      "  graze certify --family grazing_face --count 20000 --method mpr/float --save hard.jsonl\n"
      "  graze certify --method exact --count 20000 --oracle-every 500   a million exact casts\n"
      "  graze certify --family fast_spin --rotating 1000   a thousand cases with rotating bodies\n"
      "  graze certify my_cases.jsonl\n\n"
      "Exit code: 0 if every method keeps its guarantee, 1 if one does not,\n"
      "2 for bad input, and if there is nothing to judge.");
  command->callback([arguments, command, &exit_code] {
    refuse_old_spellings(*command);
    require_meaning(*command);
    exit_code = run_certify_command(*arguments);
  });
}

}  // namespace graze::tool
