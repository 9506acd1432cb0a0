// graze certify: how accurate, how fast and how safe is each method, and does it keep its guarantee?
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include "certify/built_in.hpp"
#include "certify/certification.hpp"
#include "certify/engine_findings.hpp"
#include "certify/engine_report.hpp"
#include "certify/intake.hpp"
#include "certify/report.hpp"
#include "certify/report_page.hpp"
#include "certify/worst_cases.hpp"
#include "corpus/curate/location.hpp"
#include "corpus/format/case_json.hpp"
#include "report/inputs.hpp"
#include "report/stop.hpp"
#include "show/page.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/engines.hpp"
#include "tools/commands/law.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/stability.hpp"

namespace graze::tool {
namespace {

using engine::Kind;

// Cases of each level of a family, for curves of error against hardness: the oracle measures every one, of
// curved shapes in tens of milliseconds.
constexpr std::size_t kLevelCases = 40, kRotatingLevelCases = 12;

// To make a finding of an engine of others small.
constexpr int kSmallerAsks = 2000;
constexpr double kSmallerSeconds = 20;

// Cases that a report holds in full: a page of more takes long to make, and to open.
struct ReportDefaults {
  static constexpr std::size_t kCases = 20, kMost = 1000;
};

struct CertifyArguments {
  std::vector<std::string> files, families, methods, law_names;
  EngineArguments engines;
  std::optional<std::size_t> count, rotating, queries;  // defaults: see above
  std::size_t oracle_every = kOracleEvery;
  bool stability = false, laws = false, full = false, thorough = false, fail_fast = false;
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: as many as the machine has
  std::string corpus, guarantees, save, plot, json, junit, findings, report;
  std::size_t report_cases = ReportDefaults::kCases;

  // All of ours, unless engines of others are to be judged.
  [[nodiscard]] std::vector<std::string> our_methods() const {
    return methods.empty() && engines.commands.empty() ? std::vector<std::string>{"all"} : methods;
  }
  [[nodiscard]] Counts counts() const {
    const Counts& usual = thorough ? kThorough : kUsual;
    return {count.value_or(usual.linear), rotating.value_or(usual.rotating), queries.value_or(usual.queries)};
  }
  [[nodiscard]] bool takes_curated() const { return files.empty() && families.empty(); }
};

// The methods that the command line selects, each with the row that it is held to.
class Selection {
 public:
  explicit Selection(const CertifyArguments& arguments) : engines_(arguments.engines) {
    if (!arguments.guarantees.empty()) read_table(arguments.guarantees);
    if (const std::vector<std::string> names = arguments.our_methods(); !names.empty()) {
      for (const engine::Method* method : select_methods(names)) {
        methods_.push_back(*method);
        if (!arguments.guarantees.empty()) {
          methods_.back().guarantee = engine::find_guarantee(table_, *method);
        }
      }
    }
    for (const engine::Method* method : engines_.methods()) methods_.push_back(*method);
  }
  [[nodiscard]] const Engines& engines() const { return engines_; }
  Selection(const Selection&) = delete;
  Selection& operator=(const Selection&) = delete;

  [[nodiscard]] std::vector<const engine::Method*> all() const {
    std::vector<const engine::Method*> out;
    for (const engine::Method& method : methods_) out.push_back(&method);
    return out;
  }
  [[nodiscard]] bool has_ours() const {
    return std::any_of(methods_.begin(), methods_.end(),
                       [](const engine::Method& method) { return method.is_ours(); });
  }
  // Is a cast one that some engine of others is asked, or asked queries about?
  [[nodiscard]] bool takes(const corpus::Case& problem) const {
    return std::any_of(methods_.begin(), methods_.end(), [&](const engine::Method& method) {
      return (engine::turns(problem) ? method.kind == Kind::rotating : method.kind != Kind::rotating) &&
             method.refuses(problem).empty();
    });
  }
  // Why the first of the methods that it is a question for is not asked it.
  [[nodiscard]] std::string why_not(const corpus::Case& problem) const {
    for (const engine::Method& method : methods_) {
      if (engine::turns(problem) != (method.kind == Kind::rotating)) continue;
      if (std::string why = method.refuses(problem); !why.empty())
        return fmt::format("{}: {}", method.question_name(), why);
    }
    return fmt::format("no method is one for {}",
                       engine::turns(problem) ? "bodies that turn" : "bodies that do not turn");
  }
  [[nodiscard]] bool has(Kind kind) const {
    return std::any_of(methods_.begin(), methods_.end(),
                       [&](const engine::Method& method) { return method.kind == kind; });
  }

 private:
  void read_table(const std::string& name) {
    will_read({name});
    const corpus::FileText file = corpus::read_whole_file(name);
    if (!file.error.empty()) throw std::runtime_error(name + ": " + file.error);
    try {
      table_ = engine::parse_guarantees(file.text);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(name + ": " + error.what());
    }
  }

  std::vector<engine::Guarantee> table_;
  Engines engines_;
  std::vector<engine::Method> methods_;
};

std::filesystem::path curated_directory(const CertifyArguments& arguments) {
  return arguments.corpus.empty() ? corpus::corpus_directory() / "cases"
                                  : std::filesystem::path(arguments.corpus);
}
std::filesystem::path known_failures() { return corpus::corpus_directory() / "known_failures.jsonl"; }

// What is known to be wrong and not mended yet: judged and shown in every run, and held against no row. A
// case leaves this file for corpus/cases when its mechanism is mended.
void print_known_failures(const Settings& settings, bool in_full) {
  const std::filesystem::path file = known_failures();
  if (!std::filesystem::exists(file)) return;
  const corpus::ReadResult known = corpus::read_file(file.string());
  for (const corpus::ReadError& error : known.errors) complain(error.text());
  if (known.cases.empty()) return;
  Intake intake;
  intake.take("known failures", known.cases, true);
  const Certification failing = certify(intake.suites, settings);
  fmt::print("{} of {} known failures fail, held against no row (corpus/{}; --full says how).\n",
             failing.convicted.size(), known.cases.size(), file.filename().string());
  if (!in_full) return;
  for (const std::string& line : failing.breaches) fmt::print("known: {}\n", line);
}

// What was given beside casts, and what of all that nothing judges.
void print_intake(const Intake& intake) {
  if (intake.questions > 0) {
    fmt::print("{} questions beside the cast are judged as they are asked.\n", intake.questions);
  }
  if (intake.recast > 0) fmt::print("{} of contact are judged as casts, too.\n", intake.recast);
  if (intake.left_out > 0) fmt::print("{} cases are not judged.\n", intake.left_out);
}

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

// The curated corpus, the files and the families that are asked for. True if something could not be read.
bool take_all(Intake& intake, const CertifyArguments& arguments, const Selection& selection) {
  bool bad = false;
  if (arguments.takes_curated()) {
    const corpus::ReadResult curated = corpus::read_directory(curated_directory(arguments));
    for (const corpus::ReadError& error : curated.errors) complain(error.text());
    bad = !curated.ok();
    intake.take("curated", curated.cases, true);
  }
  const CaseFiles files = read_case_files(arguments.files);
  for (const CaseFile& file : files.files) intake.take(file.name, file.cases, false);
  const Counts counts = arguments.counts();
  const std::vector<const corpus::Family*> families =
      wanted_families(arguments.families, !arguments.files.empty());
  if (selection.has_ours()) {
    take_families(intake, families, counts, arguments.seed, arguments.oracle_every);
  } else {
    for (const corpus::Family* family : families) {
      const std::size_t count = family->rotating ? counts.rotating : counts.linear;
      if (count == 0) continue;
      Suite suite = sought_suite(*family, family->levels, count, arguments.seed,
                                 [&](const corpus::Case& problem) { return selection.takes(problem); });
      suite.oracle_every = arguments.oracle_every;
      if (suite.size() == 0) {
        const corpus::Case first = family->generate(family->levels.front(), arguments.seed);
        intake.why.push_back(fmt::format("{}: none of its cases is asked; the first, {}: {}", family->name,
                                         first.id, selection.why_not(first)));
      }
      intake.suites.push_back(std::move(suite));
    }
  }
  if (selection.has(Kind::query)) take_queries(intake, counts);
  return bad || files.bad;
}

void print_screen(const Certification& certification, const Settings& settings) {
  fmt::print("\n{}", summary_table(certification, settings));
  fmt::print(
      "answers in both scalars; stalls: not converged, or a bracket that says of itself that it is wide; "
      "proofs: "
      "that the\nchecker accepted; error / limit: the largest that the oracle measured over what the "
      "guarantee "
      "grants. --full: all.\n");
}

// What asks for the same judgement again; what is written where is left out.
std::string certify_line(const CertifyArguments& arguments) {
  std::string text = "graze certify";
  const auto add = [&](const char* option, const std::string& value) {
    const bool plain = value.find_first_of(" '\"$&|;<>()") == std::string::npos;
    text += fmt::format("{}{}{}{}{}", *option == 0 ? "" : " ", option, plain ? " " : " '", value,
                        plain ? "" : "'");
  };
  for (const std::string& file : arguments.files) add("", file);
  for (const std::string& family : arguments.families) add("--family", family);
  for (const std::string& method : arguments.methods) add("--method", method);
  for (const std::string& engine : arguments.engines.commands) add("--engine", engine);
  if (arguments.thorough) text += " --thorough";
  if (arguments.count) add("--count", fmt::to_string(*arguments.count));
  if (arguments.rotating) add("--rotating", fmt::to_string(*arguments.rotating));
  if (arguments.queries) add("--queries", fmt::to_string(*arguments.queries));
  if (arguments.seed != 1) add("--seed", fmt::to_string(arguments.seed));
  if (arguments.oracle_every != kOracleEvery) add("--oracle-every", fmt::to_string(arguments.oracle_every));
  if (!arguments.guarantees.empty()) add("--guarantees", arguments.guarantees);
  if (!arguments.corpus.empty()) add("--corpus", arguments.corpus);
  return text;
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
    complain(fmt::format("{}: no answer of it was judged: of {} cases it takes none (docs/engines.md)",
                         engine->declaration().name, certification.questions));
  }
  return is_any;
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
  std::unique_ptr<OutputFile> save;
  if (!arguments.save.empty()) save = std::make_unique<OutputFile>(arguments.save);
  std::unique_ptr<OutputFile> json;
  if (!arguments.json.empty()) json = std::make_unique<OutputFile>(arguments.json);
  std::unique_ptr<OutputFile> page, beside_page;
  if (!arguments.report.empty()) {
    const std::filesystem::path folder = arguments.report;
    page = std::make_unique<OutputFile>((folder / "index.html").string());
    beside_page = std::make_unique<OutputFile>((folder / "certification.json").string());
  }
  std::unique_ptr<OutputFile> junit;
  if (!arguments.junit.empty()) junit = std::make_unique<OutputFile>(arguments.junit);

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
  WorstCases worst;
  if (page) {
    settings.judged = [&](const Suite& suite, std::size_t i, const engine::Method& method,
                          const law::Judgement& judgement) { worst.note(suite, i, method, judgement); };
  }
  Certification certification = certify(intake.suites, settings);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const std::vector<EngineFinding> findings =
      arguments.findings.empty() && !(page && !selection.engines().empty())
          ? std::vector<EngineFinding>{}
          : engine_findings(certification, kSmallerAsks, kSmallerSeconds);
  std::string html;
  if (page) {
    std::string plain = verdict_line(certification, took.count());
    if (selection.has_ours()) plain += "\n" + summary_table(certification, settings);
    if (!selection.engines().empty()) plain += "\n" + certificates(certification, settings);
    html = report_page({.certification = certification,
                        .settings = settings,
                        .worst = worst,
                        .findings = findings,
                        .seconds = took.count(),
                        .command = certify_line(arguments),
                        .plain = plain,
                        .most_scenes = arguments.report_cases});
  }
  const bool is_unasked = complain_of_unasked(selection.engines(), certification);
  const std::vector<std::string> left_behind = selection.engines().finish();
  certification.breaches.insert(certification.breaches.end(), left_behind.begin(), left_behind.end());
  fmt::print("{}", verdict_line(certification, took.count()));
  for (const std::string& breach : certification.breaches) fmt::print("broken: {}\n", breach);
  if (!certification.unfinished.empty()) {
    fmt::print("Not finished: {}\n", fmt::join(certification.unfinished, ", "));
  }
  // What is known of our own methods.
  if (arguments.takes_curated() && !settings.stop() && arguments.engines.commands.empty())
    print_known_failures(settings, arguments.full || arguments.thorough);
  print_intake(intake);
  if (arguments.full || arguments.thorough) {
    fmt::print("\n{}", full_tables(certification, settings));
  } else {
    if (selection.has_ours()) print_screen(certification, settings);
  }
  if (!selection.engines().empty()) {
    fmt::print("\n{}", certificates(certification, settings));
    if (const std::string times = time_table(certification, settings); !times.empty())
      fmt::print("\n{}", times);
  }
  if (!arguments.findings.empty()) fmt::print("\n{}", save_findings(findings, arguments.findings));
  if (json) {
    json->write_line(certification_json(certification, settings, took.count()));
    json->close();
  }
  if (page) {
    if (!show::has_viewer())
      complain("this graze was built without Node: the report lacks the viewer (docs/show.md)");
    page->write_line(html.substr(0, html.size() - 1));
    page->close();
    beside_page->write_line(certification_json(certification, settings, took.count()));
    beside_page->close();
    fmt::print("The report is {}.\n", (std::filesystem::path(arguments.report) / "index.html").string());
  }
  if (junit) {
    junit->write_line(certification_junit(certification, settings, took.count()));
    junit->close();
  }
  if (save) {
    for (const corpus::Case& problem : with_own_ids(certification.convicted))
      save->write_line(corpus::write_case(problem));
    save->close();
  }
  if (const int signal = StopBySignal::received(); signal != 0) return 128 + signal;
  if (bad || is_unasked) return 2;
  return certification.breaches.empty() ? 0 : 1;
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
      ->check(whole_number(0, kMostThreads))
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
  add_need_options(*command, arguments->engines);
  command->add_flag("--stability", arguments->stability,
                    "Instead: curves of error against hardness, every case measured by the oracle "
                    "(docs/stability.md)");
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
      "docs/guarantees.md says what each column means. Of files, a query beside the cast is judged as it is "
      "asked; what\n"
      "nothing judges (a line of bodies that turn) is said, and leaves the exit code to the others.\n\n"
      "  graze certify\n"
      "  graze certify --family grazing_face --count 20000 --method mpr/float --save hard.jsonl\n"
      "  graze certify --method exact --count 100000 --oracle-every 500   a million exact casts\n"
      "  graze certify --family fast_spin --rotating 1000   a thousand cases in which a body turns\n"
      "  graze certify my_cases.jsonl\n"
      "  graze certify --stability --plot curves   how error grows with hardness, and where methods break\n"
      "  graze certify --laws --family grazing_edge --count 500   every law instead, for every method\n\n"
      "Exit code: 0 if every method keeps its row of the guarantee table (--laws: every law holds), 1 if one "
      "does not,\n2 for bad input, and if there is nothing to judge.");
  command->callback([arguments, &exit_code] { exit_code = run_certify_command(*arguments); });
}

}  // namespace graze::tool
