// graze certify: how accurate, how fast and how safe is each method, and does it keep its guarantee?
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include "certify/intake.hpp"
#include "certify/linear.hpp"
#include "certify/query.hpp"
#include "certify/rotating.hpp"
#include "certify/suites.hpp"
#include "certify/tolerance_study.hpp"
#include "corpus/curate/location.hpp"
#include "corpus/families.hpp"
#include "corpus/format/case_json.hpp"
#include "report/inputs.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/law.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/stability.hpp"

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
  will_read({arguments.guarantees});
  const corpus::FileText file = corpus::read_whole_file(arguments.guarantees);
  if (!file.error.empty()) throw std::runtime_error(arguments.guarantees + ": " + file.error);
  try {
    return engine::parse_guarantees(file.text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(arguments.guarantees + ": " + error.what());
  }
}

std::filesystem::path curated_directory(const Arguments& arguments) {
  return arguments.corpus.empty() ? corpus::corpus_directory() / "cases"
                                  : std::filesystem::path(arguments.corpus);
}
std::filesystem::path known_failures() { return corpus::corpus_directory() / "known_failures.jsonl"; }

// Casts that the command line names no method for. Those of files are said to be left out.
void leave_out(std::vector<Suite>& suites, Intake& intake, const CaseFiles& files) {
  for (const Suite& suite : suites) {
    const bool is_given = std::any_of(files.files.begin(), files.files.end(),
                                      [&](const CaseFile& file) { return file.name == suite.family; });
    if (!is_given) continue;
    intake.left_out += suite.size();
    intake.why.push_back(fmt::format(
        "{}: {} casts are not judged, in which {} body turns: the command line leaves no method for "
        "them",
        suite.family, suite.size(), engine::turns(suite.at(0)) ? "a" : "no"));
  }
  suites.clear();
}

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
  const std::filesystem::path file = known_failures();
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
                  const std::vector<ToleranceRow>& study) {
  std::size_t judged = 0;
  for (const Tally& tally : certification.tallies) judged += tally.cases;
  fmt::print(
      "Certification: {} casts judged, by proof first; {} cases answered by the exact oracle as well.\n",
      judged, certification.oracle_cases);
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
}

// What was given beside casts, and what of all that nothing judges.
void print_intake(const Intake& intake) {
  if (!intake.asked.empty()) {
    fmt::print("{} questions beside the cast are judged as they are asked.\n", intake.asked.size());
  }
  if (intake.recast > 0) fmt::print("{} of contact are judged as casts, too.\n", intake.recast);
  if (intake.left_out > 0) fmt::print("{} cases are not judged.\n", intake.left_out);
  if (intake.asked.size() + intake.recast + intake.left_out > 0) fmt::print("\n");
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
  will_read(arguments.files);
  if (arguments.files.empty() && arguments.families.empty() && !arguments.stability) {
    const std::string curated = curated_directory(arguments).string();
    if (!std::filesystem::is_directory(curated))
      throw std::runtime_error(curated + ": is no folder of cases");
    will_read({curated, known_failures().string()});
  }
  if (!arguments.plot.empty()) require_folder(arguments.plot);
  if (arguments.stability) return show_stability(arguments, settings, turning);
  const std::size_t linear_count = arguments.count.value_or(kLinearCases);
  const std::size_t rotating_count = arguments.rotating.value_or(kRotatingCases);
  const std::vector<const corpus::Family*> families =
      wanted_families(arguments.families, !arguments.files.empty());
  std::unique_ptr<OutputFile> save;
  if (!arguments.save.empty()) save = std::make_unique<OutputFile>(arguments.save);

  Intake intake;
  bool bad = false;
  if (arguments.files.empty() && arguments.families.empty()) {
    const corpus::ReadResult curated = corpus::read_directory(curated_directory(arguments));
    for (const corpus::ReadError& error : curated.errors) complain(error.text());
    bad = !curated.ok();
    intake.take("curated", curated.cases, true);
  }
  const CaseFiles files = read_case_files(arguments.files);
  for (const CaseFile& file : files.files) intake.take(file.name, file.cases, false);
  bad = bad || files.bad;
  for (const corpus::Family* family : families) {
    const std::size_t count = family->rotating ? rotating_count : linear_count;
    if (count > 0) {
      (family->rotating ? intake.rotating : intake.linear)
          .push_back(generated_suite(*family, arguments, count));
    }
  }
  if (rotating_count == 0 || selected.rotating.empty()) leave_out(intake.rotating, intake, files);
  if (selected.linear.empty()) leave_out(intake.linear, intake, files);
  if (intake.empty()) {
    if (!bad) {
      complain(fmt::format(
          "{}there is no case to judge; give a file with one, or a count above 0, and a method for it",
          intake.why.empty() ? "" : fmt::format("{}; ", fmt::join(intake.why, "; "))));
    }
    return 2;
  }

  for (const std::string& line : intake.why) complain(line);
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
  if (!intake.asked.empty() || arguments.queries > 0) {
    queries = certify_queries(
        intake.asked, intake.linear,
        {.count = arguments.queries, .guarantees = settings.guarantees, .threads = settings.threads});
  }
  const RotatingCertification rotating = certify_rotating(intake.rotating, turning);
  if (arguments.files.empty() && arguments.families.empty()) print_known_failures(settings);
  print_intake(intake);
  if (!intake.linear.empty()) print_tables(certification, settings, study);
  if (!queries.tallies.empty()) {
    fmt::print(
        "Queries beside the cast: as they are asked, and on the bodies of the casts where the exact oracles "
        "know them; and their rows\n\n{}\n",
        query_table(queries, settings.guarantees));
  }
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
    std::vector<corpus::Case> found = certification.convicted;
    for (const std::vector<corpus::Case>& more : {queries.convicted, rotating.convicted}) {
      found.insert(found.end(), more.begin(), more.end());
    }
    for (const corpus::Case& problem : with_own_ids(found)) save->write_line(corpus::write_case(problem));
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
                      kLinearCases, kLevelCases))
      ->check(whole_number())
      ->type_name("N");
  command->add_option("--seed", arguments->seed, "The first seed of the generated cases (1)")
      ->check(seed_number())
      ->type_name("S");
  command
      ->add_option("--method", arguments->methods,
                   fmt::format("{}; of rotating casts {}; one with its scalar (mpr/float), or all (may be "
                               "repeated)",
                               linear_names(), rotating_names()))
      ->type_name("NAME")
      ->allow_extra_args(false);
  command
      ->add_option("--oracle-every", arguments->oracle_every,
                   "Also measure every N-th generated case by the exact oracle (20); of files, all are")
      ->check(whole_number(1))
      ->type_name("N");
  command
      ->add_option("--queries", arguments->queries,
                   "Cases of each suite whose bodies are asked the other queries, too (100); 0 asks none")
      ->check(whole_number())
      ->type_name("N");
  command
      ->add_option(
          "--rotating", arguments->rotating,
          fmt::format("Generated cases of a rotating family ({}; with --stability, of each level, {}); 0 "
                      "leaves every rotating cast out",
                      kRotatingCases, kRotatingLevelCases))
      ->check(whole_number())
      ->type_name("N");
  command
      ->add_option("--threads", arguments->threads, "Threads that judge; the result does not depend on them")
      ->check(whole_number(0, kMostThreads))
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
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace graze::tool
