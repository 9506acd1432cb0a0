#include "tools/commands/try_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "certify/laws.hpp"
#include "certify/laws_of_others.hpp"
#include "certify/suites.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/page_scene.hpp"
#include "reports/text/counted.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/stop.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

using engine::Kind;
using law::Law;

std::vector<Law> wanted_laws(const std::vector<std::string>& names) {
  const std::span<const Law> all = law::laws();
  if (names.empty()) return {all.begin(), all.end()};
  std::vector<Law> wanted;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Law& law) { return law.name == name; });
    if (found == all.end()) {
      throw std::runtime_error(fmt::format("--law: {} is no law; `graze laws --list` lists them", name));
    }
    wanted.push_back(*found);
  }
  return wanted;
}

void check_methods(const std::vector<std::string>& names, const std::vector<Law>& laws) {
  for (const std::string& name : names) {
    const bool known = std::any_of(laws.begin(), laws.end(), [&](const Law& law) {
      return std::any_of(law.methods().begin(), law.methods().end(),
                         [&](const engine::Method& method) { return selects(name, method); });
    });
    if (!known) {
      throw std::runtime_error(
          fmt::format("--method: no law asks a method {}; it is one of {}", name, all_names()));
    }
  }
}

// Bodies of a query other than the cast are cast. The laws of the queries make their own questions.
void take(std::vector<LawSuite>& suites, const std::string& name, const std::vector<corpus::Case>& cases) {
  LawSuite straight{.suite = {.family = name}}, turning{.suite = {.kind = Kind::rotating, .family = name}};
  for (corpus::Case problem : cases) {
    const bool turns = engine::turns(problem);
    if (!turns) problem.query = corpus::Query::cast;
    (turns ? turning : straight).suite.cases.push_back(std::move(problem));
  }
  for (LawSuite* one : {&straight, &turning}) {
    if (one->suite.size() > 0) suites.push_back(std::move(*one));
  }
}

LawSuite suite_of(const corpus::Family& family, const LawArguments& arguments, const Engines& engines) {
  // For rotating families, the easier half of the levels. The hardest levels take the oracle minutes.
  const std::size_t levels = family.rotating ? (family.levels.size() + 1) / 2 : family.levels.size();
  const std::size_t count = family.rotating ? arguments.rotating.value_or(kRotatingLawCases)
                                            : arguments.count.value_or(kLinearLawCases);
  // If only third-party engines are asked, the cases are those that they take.
  const bool is_drawn = !arguments.our_methods().empty() || count == 0;
  const auto takes = [&](const corpus::Case& problem) {
    const std::vector<const engine::Method*> others = engines.methods();
    return std::any_of(others.begin(), others.end(), [&](const engine::Method* method) {
      return (method->kind == Kind::rotating) == family.rotating && method->refuses(problem).empty();
    });
  };
  LawSuite one{
      .suite = is_drawn ? drawn_suite(family, family.levels.first(levels), count, arguments.seed)
                        : sought_suite(family, family.levels.first(levels), count, arguments.seed, takes)};
  one.seed = [draw = one.suite.draw](std::size_t i) {
    // name/h<hardness>/s<seed>
    const std::string id = draw(i).id;
    const std::size_t h = id.find("/h"), s = id.find("/s", h);
    return fmt::format("graze generate {} --hardness {} --seed {} --count 1", id.substr(0, h),
                       id.substr(h + 2, s - h - 2), id.substr(s + 2));
  };
  return one;
}

// The command that shows the smallest case of a breach. `file` holds the case, and is empty if nothing was
// saved.
std::string look_command(const LawBreach& breach, const std::string& file) {
  const law::Finding& finding = breach.finding;
  const bool is_ours = std::ranges::any_of(
      engine::methods(), [&](const engine::Method& method) { return selects(finding.method, method); });
  std::string text = "graze show " + shell_word(file.empty() ? "case.json" : file);
  if (!file.empty()) text += " --id " + shell_word(law::as_case(finding).id);
  if (is_ours) text += " --method " + shell_word(finding.method);
  return text + " --out case.html";
}

void print_breach(const LawBreach& breach, const std::string& file) {
  const law::Finding& finding = breach.finding;
  fmt::print(
      "broken: {} by {}, {}: {}\n"
      "  first    {}\n"
      "  again    {}\n"
      "  reason   {}\n"
      "  smallest {}\n"
      "  look     {}{}\n",
      finding.law, finding.method, counted(breach.times, "time"), finding.sentence, breach.first,
      finding.seed, finding.reason, corpus::write_case(law::as_case(finding)), look_command(breach, file),
      file.empty() ? " (the smallest, saved as case.json)" : "");
}

// The smallest cases, one of each id: two methods may break a law on the same one.
std::vector<corpus::Case> smallest_cases(const LawCertification& certification) {
  std::vector<corpus::Case> out;
  for (const LawBreach& breach : certification.breaches) {
    corpus::Case problem = law::as_case(breach.finding);
    const auto same = [&](const corpus::Case& one) { return one.id == problem.id; };
    if (std::none_of(out.begin(), out.end(), same)) out.push_back(std::move(problem));
  }
  return out;
}

void write_cases(OutputFile& file, const LawCertification& certification) {
  for (const corpus::Case& problem : smallest_cases(certification))
    file.write_line(corpus::write_case(problem));
  file.close();
}

// A page of more cases takes longer to open than to make.
constexpr std::size_t kMostShown = 40;

// --report: the smallest broken cases, cases.jsonl, and a page on which they are looked at, index.html.
void write_report(const LawArguments& arguments, const LawCertification& certification,
                  std::span<const engine::Method> others) {
  const std::filesystem::path folder = arguments.report;
  const std::string file = (folder / "cases.jsonl").string();
  OutputFile cases(file);
  write_cases(cases, certification);
  show::Json scenes = show::Json::array();
  std::string plain;
  for (const LawBreach& breach : certification.breaches) {
    const law::Finding& finding = breach.finding;
    const std::string words = fmt::format("{} broke {}, {}: {}", finding.method, finding.law,
                                          counted(breach.times, "time"), finding.reason);
    plain += fmt::format("{}\n  {}\n", words, look_command(breach, file));
    if (scenes.size() == kMostShown) continue;
    std::vector<const engine::Method*> asked;
    for (const engine::Method& method : engine::methods()) {
      if (selects(finding.method, method)) asked.push_back(&method);
    }
    for (const engine::Method& method : others) {
      if (method.full_name() == finding.method || method.question_name() == finding.method)
        asked.push_back(&method);
    }
    show::Json scene = show::scene_of(law::as_case(finding), asked, {.command = look_command(breach, file)});
    scene["broken"] = {{"law", finding.law}, {"words", words}, {"sentence", finding.sentence}};
    scenes.push_back(std::move(scene));
  }
  const std::string title =
      certification.breaches.empty()
          ? certification.unfinished.empty() ? "graze: every law holds" : "graze: laws, stopped"
      : certification.breaches.size() == 1
          ? "graze: a law is broken"
          : fmt::format("graze: laws are broken {} times", certification.breaches.size());
  OutputFile page((folder / "index.html").string());
  const std::string html = show::page_html(
      title, {{"schema", "graze.page/1"}, {"kind", "show"}, {"title", title}, {"scenes", std::move(scenes)}},
      !plain.empty()                     ? plain
      : certification.unfinished.empty() ? "Every law holds.\n"
                                         : "Stopped: no law is broken so far.\n");
  page.write_line(html.substr(0, html.size() - 1));
  page.close();
  if (certification.breaches.size() > kMostShown)
    complain(fmt::format("the page holds {} of {} broken cases; {} has all", kMostShown,
                         certification.breaches.size(), file));
  fmt::print("The report is {}.\n", (folder / "index.html").string());
}

void print_idle(const LawCertification& certification, const LawSettings& settings) {
  std::vector<std::string> idle;
  for (std::size_t l = 0; l < settings.laws.size(); ++l) {
    if (certification.tallies[l].applied() == 0) idle.push_back(settings.laws[l].name);
  }
  if (!idle.empty()) fmt::print("No case was one for: {}\n", fmt::join(idle, ", "));
}

void print_ours(const LawCertification& certification, const LawSettings& settings) {
  fmt::print("{}\n", law_table(certification, settings));
  fmt::print(
      "answers: a case and a method, to which the law applies. left open: by the oracle that the law "
      "needs. not for the\n"
      "law: the method does not answer such a case, or the law does not apply to it. "
      "docs/reference/laws.md says what each law is.\n\n");
  print_idle(certification, settings);
}

}  // namespace

int try_laws(const LawArguments& arguments) {
  const bool takes_curated = arguments.takes_curated();
  const std::vector<std::string> ours = arguments.our_methods();
  const Engines engines(arguments.engines);
  if (takes_curated && !std::filesystem::is_directory(arguments.curated_directory())) {
    throw std::runtime_error(arguments.curated_directory().string() + ": is no folder of cases");
  }
  will_read(takes_curated ? std::vector{arguments.curated_directory().string()} : arguments.files);
  LawSettings settings;
  settings.laws = wanted_laws(arguments.laws);
  check_methods(ours, settings.laws);
  settings.is_asked = [&](const engine::Method& method) {
    return std::any_of(ours.begin(), ours.end(),
                       [&](const std::string& name) { return selects(name, method); });
  };
  std::vector<engine::Method> others;
  for (const engine::Method* method : engines.methods()) others.push_back(as_laws_ask(*method));
  settings.others = others;
  settings.threads = arguments.most_threads();
  const std::vector<const corpus::Family*> families =
      wanted_families(arguments.families, !arguments.files.empty());
  std::unique_ptr<OutputFile> save;
  if (!arguments.report.empty()) {
    require_folder(arguments.report);
    for (const char* name : {"index.html", "cases.jsonl"})
      require_own_file((std::filesystem::path(arguments.report) / name).string());
  }
  if (!arguments.save.empty()) save = std::make_unique<OutputFile>(arguments.save);

  std::vector<LawSuite> suites;
  bool bad = false;
  if (takes_curated) {
    const corpus::ReadResult curated = corpus::read_directory(arguments.curated_directory());
    for (const corpus::ReadError& error : curated.errors) complain(error.text());
    bad = !curated.ok();
    take(suites, "curated", curated.cases);
  }
  const CaseFiles files = read_case_files(arguments.files);
  for (const CaseFile& file : files.files) take(suites, file.name, file.cases);
  bad = bad || files.bad;
  for (const corpus::Family* family : families) suites.push_back(suite_of(*family, arguments, engines));
  std::erase_if(suites, [](const LawSuite& one) { return one.suite.size() == 0; });
  if (suites.empty()) {
    if (!bad) complain("there is no case to judge; give a file with one, or a count above 0");
    return 2;
  }

  // A law without cases of its kind is not listed, unless it was requested by name.
  if (arguments.laws.empty()) {
    std::erase_if(settings.laws, [&](const Law& law) {
      return std::none_of(suites.begin(), suites.end(), [&](const LawSuite& one) {
        return (one.suite.kind == Kind::rotating) == (law.kind == Kind::rotating);
      });
    });
  }
  const StopBySignal signals;
  settings.stop = [] { return StopBySignal::received() != 0; };
  const LawCertification certification = certify_laws(suites, settings);
  fmt::print("{} over {}\n\n", counted(settings.laws.size(), "law"), counted(certification.cases, "case"));
  if (!others.empty()) fmt::print("{}\n", other_law_table(certification, settings));
  if (!ours.empty()) print_ours(certification, settings);
  const std::string file = !arguments.save.empty() ? arguments.save
                           : !arguments.report.empty()
                               ? (std::filesystem::path(arguments.report) / "cases.jsonl").string()
                               : "";
  for (const LawBreach& breach : certification.breaches) print_breach(breach, file);
  const bool held = certification.breaches.empty();
  const bool stopped = !certification.unfinished.empty();
  if (stopped) fmt::print("Not finished: {}\n", fmt::join(certification.unfinished, ", "));
  fmt::print("{}\n", !held     ? "A law is broken."
                     : stopped ? "Stopped: no law is broken so far."
                               : "Every law holds.");
  if (save) write_cases(*save, certification);
  if (!arguments.report.empty()) write_report(arguments, certification, others);
  const int signal = StopBySignal::received();
  return with_orphaned_processes(engines, signal != 0 ? 128 + signal : bad ? 2 : held ? 0 : 1);
}

}  // namespace graze::tool
