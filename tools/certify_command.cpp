// graze certify: how accurate, how fast and how safe is each method, and does it keep its guarantee?
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include "corpus/families.hpp"
#include "corpus/location.hpp"
#include "tools/certification.hpp"
#include "tools/commands.hpp"
#include "tools/inputs.hpp"
#include "tools/law_command.hpp"
#include "tools/query_certification.hpp"
#include "tools/rotating_certification.hpp"
#include "tools/stability_command.hpp"
#include "tools/suites.hpp"
#include "tools/tolerance_study.hpp"

namespace graze::tool {
namespace {

// How many hits the study of tolerances measures: 7 tolerances a method, 2 exact errors each.
constexpr std::size_t kStudiedHits = 64;

// Cases of each rotating family. A rotating answer costs its oracle tens of milliseconds.
constexpr std::size_t kRotatingCases = 60;
constexpr std::size_t kLinearCases = 4000;

// Cases of each level of a family, for curves of error against hardness: the oracle measures every one, of
// curved shapes in tens of milliseconds.
constexpr std::size_t kLevelCases = 40, kRotatingLevelCases = 12;

struct Arguments {
  std::vector<std::string> files, families, methods = {"all"}, law_names;
  std::optional<std::size_t> count, rotating;  // defaults: see above
  std::size_t oracle_every = 20, queries = 100;
  bool stability = false, laws = false;
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: as many as the machine has
  std::string corpus, guarantees, save, plot;
};

std::vector<engine::Guarantee> guarantee_rows(const Arguments& arguments) {
  if (arguments.guarantees.empty()) return {engine::guarantees().begin(), engine::guarantees().end()};
  std::ifstream file(arguments.guarantees);
  if (!file) throw std::runtime_error(arguments.guarantees + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  try {
    return engine::parse_guarantees(text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(arguments.guarantees + ": " + error.what());
  }
}

// The suites to judge: linear casts, and those in which a body turns. A question about overlap or distance is
// judged as the cast of the same bodies, which is the harder question; any other is complained about, or only
// counted in our own corpus.
struct Intake {
  std::vector<Suite> linear, rotating;
  std::size_t recast = 0, skipped = 0;

  void take(const std::string& name, const std::string& file, const std::vector<corpus::Case>& cases,
            bool ours) {
    Suite straight{.family = name}, turning{.family = name};
    for (corpus::Case problem : cases) {
      const bool turns = engine::turns(problem);
      if (!turns && (problem.query == corpus::Query::overlap || problem.query == corpus::Query::distance)) {
        problem.query = corpus::Query::cast;
        ++recast;
      }
      const std::string why = turns ? engine::unsupported_rotating(problem) : engine::unsupported(problem);
      if (why.empty()) {
        (turns ? turning : straight).cases.push_back(std::move(problem));
        continue;
      }
      ++skipped;
      if (!ours) {
        complain(fmt::format("{}: case {}: has {}, which this version does not judge; give a cast", file,
                             problem.id, why));
      }
    }
    if (straight.size() > 0) linear.push_back(std::move(straight));
    if (turning.size() > 0) rotating.push_back(std::move(turning));
  }
};

Suite generated_suite(const corpus::Family& family, const Arguments& arguments, std::size_t count) {
  Suite suite = drawn_suite(family, family.levels, count, arguments.seed);
  suite.oracle_every = arguments.oracle_every;
  return suite;
}

std::vector<Truth*> studied_hits(const std::vector<std::unique_ptr<Truth>>& hits) {
  std::vector<Truth*> chosen;
  const std::size_t stride = std::max<std::size_t>(1, (hits.size() + kStudiedHits - 1) / kStudiedHits);
  for (std::size_t i = 0; i < hits.size(); i += stride) chosen.push_back(hits[i].get());
  return chosen;
}

// What is known to be wrong and not mended yet: judged and shown in every run, and held against no row. A
// case leaves this file for corpus/cases when its mechanism is mended.
void print_known_failures(const Settings& settings) {
  const std::filesystem::path file = corpus::corpus_directory() / "known_failures.jsonl";
  if (!std::filesystem::exists(file)) return;
  const corpus::ReadResult known = corpus::read_file(file.string());
  for (const corpus::ReadError& error : known.errors) complain(error.text());
  if (known.cases.empty()) return;
  const Certification failing = certify({{.family = "known failures", .cases = known.cases}}, settings);
  fmt::print("Known failures: {} cases, {} of them failing, held against no row\n\n", known.cases.size(),
             failing.convicted.size());
  for (const std::string& line : failing.breaches) fmt::print("known: {}\n", line);
  fmt::print("\n");
}

void print_tables(const Certification& certification, const Settings& settings,
                  const std::vector<ToleranceRow>& study, const QueryCertification& queries,
                  const Intake& intake) {
  std::size_t judged = 0;
  for (const Tally& tally : certification.tallies) judged += tally.cases;
  fmt::print(
      "Certification: {} casts judged, by proof first; {} cases answered by the exact oracle as well.\n",
      judged, certification.oracle_cases);
  if (intake.recast > 0)
    fmt::print("{} questions about overlap or distance are judged as casts.\n", intake.recast);
  if (intake.skipped > 0) fmt::print("{} cases are no casts, and were left out.\n", intake.skipped);
  fmt::print("\n{}\n", tally_table(certification.tallies));
  fmt::print(
      "wrong, late, off, contact off: by more than kappa u scale of the method's row, in the case as the "
      "method's\n"
      "scalar sees it. excused: a wrong verdict within it. Errors are over scale, of the bracket's worse "
      "end, on the\n"
      "cases by oracle; true in.: the backward error of a float answer against the input before rounding to "
      "float.\n"
      "Tier certified: a verdict that is not the true one and a bracket that does not hold the TOI are "
      "wrong, "
      "late or\n"
      "off, by anything at all; off, too, an end farther from contact than the row's width; not converged: "
      "what was left open\n"
      "though clearance or depth exceeds that width, excused: what was left open below it.\n"
      "Tier exact (kappa 0): a verdict or a bound that is not the exact one, by its last bit, is wrong; not "
      "asked: "
      "cases\n"
      "that are not for the tier, and that it refuses.\n"
      "median ns: one cast with normal and witnesses, shapes built beforehand.\n\n");
  if (const std::string exact = exact_summary(certification, settings); !exact.empty()) {
    fmt::print("Tier exact\n\n{}\n", exact);
  }
  if (!study.empty()) {
    fmt::print(
        "Error against time: backward error of the bracket's ends over scale, on {} measured hits.\n\n{}\n",
        study.front().cases, tolerance_table(study));
  }
  fmt::print("Guarantees\n\n{}\n", guarantee_table(certification, settings));
  if (!queries.tallies.empty()) {
    fmt::print(
        "Queries beside the cast, on the same bodies where the exact oracles know them, and their "
        "rows\n\n{}\n",
        query_table(queries, settings.guarantees));
  }
}

void print_rotating(const RotatingCertification& certification, const RotatingSettings& settings) {
  if (certification.tallies.empty()) return;
  fmt::print("Rotating casts, judged by brackets of the first contact and by proofs\n\n{}\n",
             rotating_table(certification));
  fmt::print(
      "wrong, late, early (contact claimed where there is none yet), wide: by more than kappa u scale of the "
      "method's\n"
      "row; in tier certified wrong, late and early by anything at all, wide and undecided by more than the "
      "row's width.\n"
      "excused: decided by less than that. hidden: a contact missed or passed that the row says may be. "
      "oracle open:\n"
      "the oracle decides no verdict: clearance and depth below its own width. width: of a hit, the larger "
      "of the distance at "
      "toi_lower and\n"
      "the depth before toi_upper; passed: how deep a contact was that a miss denied or toi_lower had "
      "passed; over scale.\n\n");
  fmt::print("{}\n", rotating_guarantee_table(certification, settings));
}

// --stability: curves of error against hardness instead.
int show_stability(const Arguments& arguments, const Settings& settings, const RotatingSettings& turning) {
  if (!arguments.files.empty()) {
    throw std::runtime_error("--stability: takes families, not files: a file has no levels of hardness");
  }
  return run_stability({.settings = {.linear = settings.methods,
                                     .rotating = turning.methods,
                                     .guarantees = settings.guarantees,
                                     .count = arguments.count.value_or(kLevelCases),
                                     .rotating_count = arguments.rotating.value_or(kRotatingLevelCases),
                                     .seed = arguments.seed,
                                     .threads = settings.threads},
                        .families = wanted_families(arguments.families, false),
                        .by_level = !arguments.families.empty(),
                        .plot = arguments.plot,
                        .save = arguments.save});
}

// --laws: every law instead.
int show_laws(const Arguments& arguments) {
  return run_laws({.files = arguments.files,
                   .families = arguments.families,
                   .methods = arguments.methods,
                   .laws = arguments.law_names,
                   .count = arguments.count,
                   .rotating = arguments.rotating,
                   .seed = arguments.seed,
                   .threads = arguments.threads,
                   .corpus = arguments.corpus,
                   .save = arguments.save});
}

int run(const Arguments& arguments) {
  if (arguments.laws) return show_laws(arguments);
  const std::vector<engine::Guarantee> rows = guarantee_rows(arguments);
  const SelectedMethods selected = select_methods(arguments.methods);
  const Settings settings{.methods = selected.linear,
                          .guarantees = rows,
                          .threads = arguments.threads > 0
                                         ? arguments.threads
                                         : std::max(1U, std::thread::hardware_concurrency())};
  const RotatingSettings turning{
      .methods = selected.rotating, .guarantees = rows, .threads = settings.threads};
  if (arguments.stability) return show_stability(arguments, settings, turning);
  const std::size_t linear_count = arguments.count.value_or(kLinearCases);
  const std::size_t rotating_count = arguments.rotating.value_or(kRotatingCases);
  if (arguments.oracle_every == 0) throw std::runtime_error("--oracle-every: must be 1 or more");
  const std::vector<const corpus::Family*> families =
      wanted_families(arguments.families, !arguments.files.empty());
  std::unique_ptr<OutputFile> save;
  if (!arguments.save.empty()) save = std::make_unique<OutputFile>(arguments.save);

  Intake intake;
  bool bad = false;
  if (arguments.files.empty() && arguments.families.empty()) {
    const corpus::ReadResult curated =
        corpus::read_directory(arguments.corpus.empty() ? corpus::corpus_directory() / "cases"
                                                        : std::filesystem::path(arguments.corpus));
    for (const corpus::ReadError& error : curated.errors) complain(error.text());
    bad = !curated.ok();
    intake.take("curated", "", curated.cases, true);
  }
  const CaseFiles files = read_case_files(arguments.files);
  for (const CaseFile& file : files.files) intake.take(file.name, file.name, file.cases, false);
  bad = bad || files.bad || (!arguments.files.empty() && intake.skipped > 0);
  for (const corpus::Family* family : families) {
    const std::size_t count = family->rotating ? rotating_count : linear_count;
    if (count > 0) {
      (family->rotating ? intake.rotating : intake.linear)
          .push_back(generated_suite(*family, arguments, count));
    }
  }
  if (rotating_count == 0 || selected.rotating.empty()) intake.rotating.clear();
  if (selected.linear.empty()) intake.linear.clear();
  if (intake.linear.empty() && intake.rotating.empty()) {
    if (!bad) {
      complain("there is no case to judge; give a file with one, or a count above 0, and a method for it");
    }
    return 2;
  }

  const Certification certification = certify(intake.linear, settings);
  // Float cannot follow a tolerance below its own u, and the proved tiers know none: the study is of double.
  std::vector<const engine::EngineMethod*> studied = settings.methods;
  std::erase_if(studied,
                [](const engine::EngineMethod* m) { return m->scalar != "double" || m->tier != "standard"; });
  std::vector<ToleranceRow> study;
  if (!certification.hits.empty() && !studied.empty()) {
    study = study_tolerances(studied, studied_hits(certification.hits), settings.threads);
  }
  QueryCertification queries;
  if (arguments.queries > 0) {
    queries = certify_queries(intake.linear, arguments.queries, settings.guarantees, settings.threads);
  }
  const RotatingCertification rotating = certify_rotating(intake.rotating, turning);
  if (arguments.files.empty() && arguments.families.empty()) print_known_failures(settings);
  if (!intake.linear.empty()) print_tables(certification, settings, study, queries, intake);
  if (!intake.rotating.empty()) print_rotating(rotating, turning);
  bool kept = true;
  for (const std::vector<std::string>& breaches :
       {certification.breaches, queries.breaches, rotating.breaches}) {
    for (const std::string& breach : breaches) fmt::print("broken: {}\n", breach);
    kept = kept && breaches.empty();
  }
  fmt::print("{}\n", kept ? "Every method keeps its row of the guarantee table."
                          : "A method breaks its row of the guarantee table.");
  if (!arguments.plot.empty()) fmt::print("{}\n", draw_tolerances(study, arguments.plot));
  if (save) {
    for (const std::vector<corpus::Case>& convicted :
         {certification.convicted, queries.convicted, rotating.convicted}) {
      for (const corpus::Case& problem : convicted) save->write_line(corpus::write_case(problem));
    }
    save->close();
  }
  if (bad) return 2;
  return kept ? 0 : 1;
}

}  // namespace

void add_certify_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "certify", "How accurate, fast and safe is each method? Judges it against its guarantee.");
  command
      ->add_option("files", arguments->files,
                   "Case files to judge instead of what is built in; - is standard input")
      ->type_name("FILE");
  command->add_option("--family", arguments->families, "Judge cases of this family (may be repeated)")
      ->type_name("NAME");
  command
      ->add_option(
          "--count", arguments->count,
          fmt::format("Generated cases a family ({}); with --stability, of each level of hardness ({})",
                      kLinearCases, kLevelCases))
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  command->add_option("--seed", arguments->seed, "The first seed of the generated cases (1)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("S");
  command
      ->add_option("--method", arguments->methods,
                   fmt::format("{}; of rotating casts {}; one with its scalar (mpr/float), or all (may be "
                               "repeated)",
                               linear_names(), rotating_names()))
      ->type_name("NAME");
  command
      ->add_option("--oracle-every", arguments->oracle_every,
                   "Also measure every N-th generated case by the exact oracle (20); of files, all are")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  command
      ->add_option("--queries", arguments->queries,
                   "Cases of each suite whose bodies are asked the other queries, too (100); 0 asks none")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  command
      ->add_option(
          "--rotating", arguments->rotating,
          fmt::format("Generated cases of a rotating family ({}; with --stability, of each level, {}); 0 "
                      "leaves every rotating cast out",
                      kRotatingCases, kRotatingLevelCases))
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  command
      ->add_option("--threads", arguments->threads, "Threads that judge; the result does not depend on them")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  command
      ->add_option(
          "--plot", arguments->plot,
          "Write the data and the picture of error against time into this folder; with --stability, of "
          "error against hardness")
      ->type_name("DIR");
  command
      ->add_option("--save", arguments->save,
                   "Write the cases that a method got wrong or stalled on to this file")
      ->type_name("OUT.jsonl");
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
      "docs/guarantees.md says what each column means.\n\n"
      "  graze certify\n"
      "  graze certify --family grazing_face --count 20000 --method mpr/float --save hard.jsonl\n"
      "  graze certify --method exact --count 100000 --oracle-every 500   a million exact casts\n"
      "  graze certify --family fast_spin --rotating 1000   a thousand cases in which a body turns\n"
      "  graze certify my_cases.jsonl\n"
      "  graze certify --stability --plot curves   how error grows with hardness, and where methods break\n"
      "  graze certify --laws --family grazing_edge --count 500   every law instead, for every method\n\n"
      "Exit code: 0 if every method keeps its row of the guarantee table (--laws: every law holds), 1 if one "
      "does not,\n2 for bad input.");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace graze::tool
