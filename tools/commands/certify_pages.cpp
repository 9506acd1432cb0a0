// The output of `graze certify`, on the screen and in files.
#include "tools/commands/certify_pages.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "certify/engine_report.hpp"
#include "certify/report.hpp"
#include "certify/report_page.hpp"
#include "corpus/curate/location.hpp"
#include "corpus/format/case_json.hpp"
#include "reports/pages/page.hpp"
#include "reports/text/counted.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

// Prints the known failures that are not fixed yet. They are judged and shown in every run, and do not affect
// the verdict. A case moves from this file to corpus/cases when its mechanism is fixed.
void print_known_failures(std::FILE* screen, const Settings& settings, bool in_full) {
  const std::filesystem::path file = known_failures();
  if (!std::filesystem::exists(file)) return;
  const corpus::ReadResult known = corpus::read_file(file.string());
  for (const corpus::ReadError& error : known.errors) complain(error.text());
  if (known.cases.empty()) return;
  Intake intake;
  intake.take("known failures", known.cases, true);
  const Certification failing = certify(intake.suites, settings);
  fmt::print(
      screen,
      "{} of {} known failures fail, which does not affect the verdict (corpus/{}; --full says how).\n",
      failing.convicted.size(), known.cases.size(), file.filename().string());
  if (!in_full) return;
  for (const std::string& line : failing.breaches) fmt::print(screen, "known: {}\n", line);
}

// Prints the given questions other than casts, and those that are not judged.
void print_intake(std::FILE* screen, const Intake& intake) {
  if (intake.questions > 0) {
    fmt::print(screen, "{} beside the cast {} judged as {} asked.\n", counted(intake.questions, "question"),
               intake.questions == 1 ? "is" : "are", intake.questions == 1 ? "it is" : "they are");
  }
  if (intake.recast > 0)
    fmt::print(screen, "{} of contact {}, too.\n", intake.recast,
               intake.recast == 1 ? "is judged as a cast" : "are judged as casts");
  if (intake.left_out > 0)
    fmt::print(screen, "{} {} not judged.\n", counted(intake.left_out, "case"),
               intake.left_out == 1 ? "is" : "are");
}

void print_screen(std::FILE* screen, const Certification& certification, const Settings& settings) {
  fmt::print(screen, "\n{}", summary_table(certification, settings));
  fmt::print(screen,
             "Answers are in both scalars. open: not converged, or a bracket that is marked as wide. "
             "proofs: accepted by the\n"
             "checker. error / limit: the largest error that the oracle measured, over the limit of the "
             "guarantee. most supports:\n"
             "support evaluations of the costliest answer. --full prints everything.\n");
}

// The command line that repeats the judgement, without the output files.
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

}  // namespace

std::filesystem::path known_failures() { return corpus::corpus_directory() / "known_failures.jsonl"; }

CertifyFiles::CertifyFiles(const CertifyArguments& arguments)
    : report_(arguments.report), screen_(arguments.screen()) {
  const auto open = [](const std::string& name) {
    return name.empty() ? nullptr : std::make_unique<OutputFile>(name);
  };
  save_ = open(arguments.save);
  json_ = open(arguments.json);
  if (!report_.empty()) {
    page_ = open((std::filesystem::path(report_) / "index.html").string());
    beside_page_ = open((std::filesystem::path(report_) / "certification.json").string());
  }
  junit_ = open(arguments.junit);
}

void CertifyFiles::write(const Certification& certification, const Settings& settings, double seconds,
                         const std::string& html) {
  if (json_) {
    json_->write_line(certification_json(certification, settings, seconds));
    json_->close();
  }
  if (page_) {
    if (!show::has_viewer())
      complain("this graze was built without Node: the report lacks the viewer (docs/howto/show.md)");
    page_->write_line(html.substr(0, html.size() - 1));
    page_->close();
    beside_page_->write_line(certification_json(certification, settings, seconds));
    beside_page_->close();
    fmt::print(screen_, "The report is {}.\n", (std::filesystem::path(report_) / "index.html").string());
  }
  if (junit_) {
    junit_->write_line(certification_junit(certification, settings, seconds));
    junit_->close();
  }
  if (save_) {
    for (const corpus::Case& problem : with_own_ids(certification.convicted))
      save_->write_line(corpus::write_case(problem));
    save_->close();
  }
}

std::string certify_page(const CertifyArguments& arguments, const Selection& selection,
                         const Certification& certification, const Settings& settings,
                         const WorstCases& worst, const std::vector<EngineFinding>& findings,
                         double seconds) {
  std::string plain = verdict_line(certification, seconds);
  if (selection.has_ours()) plain += "\n" + summary_table(certification, settings);
  if (!selection.engines().empty()) plain += "\n" + certificates(certification, settings);
  return report_page({.certification = certification,
                      .settings = settings,
                      .worst = worst,
                      .findings = findings,
                      .seconds = seconds,
                      .command = certify_line(arguments),
                      .plain = plain,
                      .most_scenes = arguments.report_cases});
}

void print_certification(const CertifyArguments& arguments, const Selection& selection,
                         const Certification& certification, const Settings& settings, const Intake& intake,
                         double seconds) {
  std::FILE* const screen = arguments.screen();
  fmt::print(screen, "{}", verdict_line(certification, seconds));
  if (!certification.unfinished.empty()) {
    fmt::print(screen, "Not finished: {}\n", fmt::join(certification.unfinished, ", "));
  }
  // The known failures of our own methods.
  if (arguments.takes_curated() && !settings.stop() && arguments.engines.commands.empty())
    print_known_failures(screen, settings, arguments.full || arguments.thorough);
  print_intake(screen, intake);
  if (arguments.full || arguments.thorough) {
    fmt::print(screen, "\n{}", full_tables(certification, settings));
  } else {
    if (selection.has_ours()) print_screen(screen, certification, settings);
  }
  if (!selection.engines().empty()) {
    fmt::print(screen, "\n{}", certificates(certification, settings));
    if (const std::string times = time_table(certification, settings); !times.empty())
      fmt::print(screen, "\n{}", times);
  }
  const bool in_full = arguments.full || arguments.thorough;
  const std::vector<std::string> lines = fault_lines(certification);
  if (!lines.empty()) fmt::print(screen, "\n");
  for (const std::string& line : lines) fmt::print(screen, "{}\n", line);
  if (in_full) {
    if (!lines.empty()) fmt::print(screen, "\n");
    for (const std::string& breach : certification.breaches) fmt::print(screen, "broken: {}\n", breach);
  }
}

}  // namespace graze::tool
