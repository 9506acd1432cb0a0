// graze judge: answers that were made elsewhere, by any program at any time, under the judge of graze certify.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <thread>

#include "certify/certification.hpp"
#include "certify/engine_report.hpp"
#include "certify/external/read_answer.hpp"
#include "certify/external/recorded.hpp"
#include "certify/report.hpp"
#include "corpus/curate/location.hpp"
#include "corpus/format/case_json.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/stop.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/engines.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using engine::Kind;

struct JudgeArguments {
  std::string answers, engine_file, json;
  std::vector<std::string> cases;
  external::Held held;
  bool allow_declined = false, full = false;
  unsigned threads = 0;  // 0: as many as the machine has
};

// Complaints about the input, each with its place. The first few of a kind are lines of their own.
class Complaints {
 public:
  static constexpr std::size_t kMostOfAKind = 20;
  void say(const std::string& kind, const std::string& what) {
    if (++counts_[kind] <= kMostOfAKind) complain(what);
  }
  // Prints how many more there are. Returns true if there were any.
  bool finish() {
    for (const auto& [kind, count] : counts_) {
      if (count > kMostOfAKind) complain(fmt::format("{} more {}", count - kMostOfAKind, kind));
    }
    return !counts_.empty();
  }

 private:
  std::map<std::string, std::size_t> counts_;
};

std::vector<Case> read_cases(const JudgeArguments& arguments, bool& bad) {
  std::vector<Case> cases;
  if (arguments.cases.empty()) {
    corpus::ReadResult curated = corpus::read_directory(corpus::corpus_directory() / "cases");
    for (const corpus::ReadError& error : curated.errors) complain(error.text());
    bad = bad || !curated.ok();
    return std::move(curated.cases);
  }
  CaseFiles files = read_case_files(arguments.cases);
  bad = bad || files.bad;
  for (CaseFile& file : files.files) {
    std::move(file.cases.begin(), file.cases.end(), std::back_inserter(cases));
  }
  return cases;
}

// By id. Unknown ids, ids that are there twice and lines without one are complained about.
external::RecordedLines read_answers(const std::string& name, const std::vector<Case>& cases,
                                     Complaints& complaints) {
  std::map<std::string, const Case*> known;
  for (const Case& problem : cases) known.emplace(problem.id, &problem);
  const std::string text = read_text(name);
  external::RecordedLines lines;
  std::map<std::string, int> first;
  for (const corpus::TextLine& line : corpus::split_lines(text)) {
    const std::string place = fmt::format("{}:{}", name, line.number);
    const std::string id = external::id_of_answer(line.text);
    if (id.empty()) {
      complaints.say("lines that are no answer",
                     place + ": is no graze.answer/1 that says which case it answers, by its id");
      continue;
    }
    const auto found = known.find(id);
    if (found == known.end()) {
      complaints.say("unknown ids", fmt::format("{}: id {}: no case has it", place, id));
      continue;
    }
    if (!external::question_of(*found->second)) {
      complaints.say("questions of another kind",
                     fmt::format("{}: id {}: the case asks what no graze.question/1 does", place, id));
      continue;
    }
    if (const auto [before, is_new] = first.emplace(id, line.number); !is_new) {
      complaints.say("answers given twice",
                     fmt::format("{}: id {}: line {} answers it, too", place, id, before->second));
      continue;
    }
    lines.emplace(id, line.text);
  }
  return lines;
}

external::Declaration read_declaration(const std::string& name) {
  const std::string text = read_text(name);
  try {
    return external::parse_declaration(text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

// By kind and family. Cases without an answer are missed where the engine takes them.
std::vector<Suite> suites_of(const std::vector<Case>& cases, const external::RecordedLines& lines,
                             const external::Recorded& engine, Complaints& complaints) {
  std::map<std::pair<Kind, std::string>, std::vector<Case>> sorted;
  for (const Case& problem : cases) {
    const auto question = external::question_of(problem);
    if (!question) continue;
    const Kind kind = problem.query != corpus::Query::cast ? Kind::query
                      : engine::turns(problem)             ? Kind::rotating
                                                           : Kind::linear;
    const auto method = std::find_if(
        engine.methods().begin(), engine.methods().end(),
        [&](const engine::Method& one) { return one.kind == kind && one.query == problem.query; });
    const bool is_answered = lines.contains(problem.id);
    if (method == engine.methods().end()) {
      if (is_answered)
        complaints.say("answers to what it does not take",
                       fmt::format("id {}: the engine does not say that it can be asked {}", problem.id,
                                   external::to_text(*question)));
      continue;
    }
    if (!is_answered && method->refuses(problem).empty()) {
      complaints.say("cases without an answer", fmt::format("id {}: is not answered", problem.id));
      continue;
    }
    if (kind == Kind::query && !why_unjudged(problem).empty()) {
      complaints.say("questions that cannot be judged",
                     fmt::format("id {}: has {}, and is not judged", problem.id, why_unjudged(problem)));
      continue;
    }
    sorted[{kind, problem.family}].push_back(problem);
  }
  std::vector<Suite> suites;
  suites.reserve(sorted.size());
  for (auto& [key, problems] : sorted) {
    suites.push_back({.kind = key.first,
                      .family = key.second.empty() ? "without a family" : key.second,
                      .cases = std::move(problems)});
  }
  return suites;
}

int run_judge_command(const JudgeArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  will_read({arguments.answers});
  will_read(arguments.cases);
  if (!arguments.engine_file.empty()) will_read({arguments.engine_file});
  bool bad = false;
  const std::vector<Case> cases = read_cases(arguments, bad);
  Complaints complaints;
  external::RecordedLines lines = read_answers(arguments.answers, cases, complaints);
  external::Declaration declaration = arguments.engine_file.empty() ? external::declaration_of(lines, cases)
                                                                    : read_declaration(arguments.engine_file);
  const external::Recorded engine(std::move(declaration), lines, arguments.held);
  const std::vector<Suite> suites = suites_of(cases, lines, engine, complaints);
  bad = complaints.finish() || bad;
  if (suites.empty()) {
    complain(arguments.answers + ": there is no answer to judge");
    return 2;
  }
  std::unique_ptr<OutputFile> json;
  if (!arguments.json.empty()) json = std::make_unique<OutputFile>(arguments.json);

  Settings settings;
  settings.threads =
      arguments.threads > 0 ? arguments.threads : std::max(1U, std::thread::hardware_concurrency());
  for (const engine::Method& method : engine.methods()) settings.methods.push_back(&method);
  settings.allow_declined = arguments.allow_declined;
  // Standard output is one thing's.
  std::FILE* const screen = arguments.json == "-" ? stderr : stdout;
  std::size_t faulty = 0;
  std::vector<std::string> told;  // --full: a line for each answer at fault
  settings.judged = [&](const Suite& suite, std::size_t i, const engine::Method&,
                        const law::Judgement& judgement) {
    if (judgement.skipped || !judgement.faulty()) return;
    ++faulty;
    if (!arguments.full) return;
    told.push_back(fmt::format("{}  {}  {}", suite.at(i).id, law::kFaultKinds[judgement.worst_fault()].name,
                               judgement.told_fault()));
  };
  const StopBySignal signals;
  settings.stop = [] { return StopBySignal::received() != 0; };
  const Certification certification = certify(suites, settings);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  fmt::print(screen, "{} of {} answers at fault", faulty, certification.answers);
  for (const std::string& line : certification.declined) fmt::print(screen, "; {}", line);
  fmt::print(screen, "\n\n{}", certificates(certification, settings));
  for (const std::vector<std::string>& part : {fault_lines(certification), told}) {
    if (!part.empty()) fmt::print(screen, "\n{}\n", fmt::join(part, "\n"));
  }
  if (json) {
    json->write_line(certification_json(certification, settings, took.count()));
    json->close();
  }
  if (const int signal = StopBySignal::received(); signal != 0) return 128 + signal;
  if (bad) return 2;
  return certification.breaches.empty() ? 0 : 1;
}

CLI::Option* add_limit(CLI::App& command, const char* name, std::optional<double>& target, const char* what) {
  return command.add_option(name, target, what)->check(number_from(0))->type_name("X");
}

}  // namespace

void add_judge_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<JudgeArguments>();
  CLI::App* command = app.add_subcommand(
      "judge", "Judges answers that were made elsewhere, by any program at any time, as certify does.");
  command
      ->add_option("answers", arguments->answers,
                   "graze.answer/1, a line each, whose ids are those of cases; - is standard input")
      ->required()
      ->type_name("ANSWERS.jsonl");
  command
      ->add_option("--cases", arguments->cases,
                   "The files of cases that are answered (may be repeated); without it the curated corpus")
      ->type_name("FILE");
  command
      ->add_option("--engine-file", arguments->engine_file,
                   "The engine that answered, a graze.engine/1 (default: an engine in double that declares "
                   "no bound)")
      ->type_name("ENGINE.json");
  add_limit(*command, "--tolerance", arguments->held.tolerance,
            "Judge the engine by this error bound, a length, whatever it declares");
  add_limit(*command, "--relative-tolerance", arguments->held.relative_tolerance,
            "The same, relative to the scale of each question");
  add_limit(*command, "--kappa", arguments->held.kappa, "The same, in units of u scale");
  command
      ->add_flag(
          "--measure", arguments->held.measure,
          fmt::format(
              "Only measure errors, whatever the engine declares. Without a declared or given bound, the "
              "bound is {:g} of scale",
              external::kAssumedRelativeTolerance))
      ->excludes("--tolerance")
      ->excludes("--relative-tolerance")
      ->excludes("--kappa");
  add_declined_option(*command, arguments->allow_declined);
  command->add_flag("--full", arguments->full, "Print a line for each answer at fault, too");
  command->add_option("--json", arguments->json, "Write what was counted to this file, one JSON object")
      ->type_name("OUT.json");
  command
      ->add_option("--threads", arguments->threads, "Threads that judge; the result does not depend on them")
      ->check(whole_number(1, kMostThreads))
      ->type_name("N");
  command->footer(
      "Prints what certify prints of third-party engines, the least limit with which every answer would have "
      "passed, then a\nline for each kind of fault. An answer counts as its worst fault. Without a promise "
      "or a "
      "limit the answers are held\nto 0.001 of scale. A case without an answer, an answer to no case and a "
      "second "
      "answer are errors.\ndocs/reference/protocol.md has the documents.\n\n"
      "  graze judge answers.jsonl --cases cases.jsonl --tolerance 1e-6\n\n"
      "Exit code: 0 if it keeps what it promises, 1 if it does not, 2 for bad input.");
  command->callback([arguments, &exit_code] { exit_code = run_judge_command(*arguments); });
}

}  // namespace graze::tool
