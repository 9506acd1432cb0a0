// graze show: a page on which cases can be looked at from all sides, or a still picture of one.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "certify/external/read_answer.hpp"
#include "certify/external/recorded.hpp"
#include "corpus/format/case_io.hpp"
#include "corpus/format/case_json.hpp"
#include "reports/drawing/draw.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/page_scene.hpp"
#include "reports/text/answer_text.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/engines.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

// A page of more cases takes longer to open than to make.
constexpr std::size_t kMostScenes = 64;

struct ShowArguments {
  std::vector<std::string> files, methods, ids;
  std::string answers, out = "-";
  EngineArguments engines;
  bool svg = false;
};

external::RecordedLines read_answers(const std::string& name, const std::vector<const corpus::Case*>& cases) {
  corpus::FileText file = corpus::read_whole_file(name);
  if (!file.error.empty()) throw std::runtime_error(name + ": " + file.error);
  external::RecordedLines lines;
  for (const corpus::TextLine& line : corpus::split_lines(file.text)) {
    const std::string id = external::id_of_answer(line.text);
    if (id.empty()) {
      throw std::runtime_error(fmt::format(
          "{}:{}: is no graze.answer/1 that says which case it answers, by its id", name, line.number));
    }
    lines.emplace(id, line.text);
  }
  for (const corpus::Case* problem : cases) {
    if (lines.contains(problem->id)) return lines;
  }
  throw std::runtime_error(name + ": none of its ids is that of a case that is shown");
}

class ShowRun {
 public:
  explicit ShowRun(const ShowArguments& arguments) : arguments_(arguments), engines_(arguments.engines) {
    will_read(arguments.files);
    if (!arguments.answers.empty()) will_read({arguments.answers});
    if (!arguments.methods.empty()) claimed_ = select_methods(arguments.methods);
    inputs_ = read_case_files(arguments.files);
    for (const CaseFile& file : inputs_.files) {
      for (const corpus::Case& problem : file.cases) {
        const auto& ids = arguments.ids;
        if (!ids.empty() && std::find(ids.begin(), ids.end(), problem.id) == ids.end()) continue;
        cases_.push_back(&problem);
        files_.push_back(&file.name);
      }
    }
    for (const std::string& id : arguments.ids) {
      const auto has_it = [&](const corpus::Case* problem) { return problem->id == id; };
      if (std::none_of(cases_.begin(), cases_.end(), has_it))
        throw std::runtime_error(fmt::format("--id: {} is the id of no case in the files", id));
    }
    if (cases_.size() > kMostScenes) {
      throw std::runtime_error(
          fmt::format("show: {} cases are too many for a page, which holds {}; name some by --id",
                      cases_.size(), kMostScenes));
    }
    const std::vector<const engine::Method*> asked = engines_.methods();
    claimed_.insert(claimed_.end(), asked.begin(), asked.end());
    if (!arguments.answers.empty()) {
      external::RecordedLines lines = read_answers(arguments.answers, cases_);
      std::vector<corpus::Case> problems;
      for (const corpus::Case* problem : cases_) problems.push_back(*problem);
      external::Declaration declaration = external::declaration_of(lines, problems);
      declaration.name = std::filesystem::path(arguments.answers).filename().string();
      answered_ = lines;
      recorded_ =
          std::make_unique<external::Recorded>(std::move(declaration), std::move(lines), external::Held{});
    }
  }

  int operator()() {
    if (cases_.empty()) {
      if (!inputs_.bad) complain("show: there is no case to show");
      return 2;
    }
    if (arguments_.svg) {
      still();
    } else {
      page();
    }
    for (const std::string& line : engines_.finish()) complain(line);
    return inputs_.bad ? 2 : 0;
  }

 private:
  // Whose answers are shown of a case.
  [[nodiscard]] std::vector<const engine::Method*> claimed(const corpus::Case& problem) const {
    std::vector<const engine::Method*> out = claimed_;
    if (recorded_ && answered_.contains(problem.id)) {
      for (const engine::Method& method : recorded_->methods()) out.push_back(&method);
    }
    return out;
  }

  [[nodiscard]] std::string command(std::size_t i) const {
    const std::string generated = *files_[i] == "-" ? show::generating_command(*cases_[i]) : "";
    std::string text = !generated.empty()  ? generated + " | graze show -"
                       : *files_[i] == "-" ? "graze show case.json"
                                           : "graze show " + shell_word(*files_[i]);
    if (*files_[i] == "-") {
      // It holds this case alone.
    } else if (inputs_.files.size() > 1 || inputs_.files.front().cases.size() > 1)
      text += " --id " + shell_word(cases_[i]->id);
    for (const std::string& method : arguments_.methods) text += " --method " + shell_word(method);
    for (const std::string& engine : arguments_.engines.commands) text += " --engine " + shell_word(engine);
    if (!arguments_.answers.empty()) text += " --answers " + shell_word(arguments_.answers);
    return text + " --out case.html";
  }

  void page() {
    OutputFile out(arguments_.out);
    show::Json scenes = show::Json::array();
    for (std::size_t i = 0; i < cases_.size(); ++i)
      scenes.push_back(show::scene_of(*cases_[i], claimed(*cases_[i]), {.command = command(i)}));
    const std::string title =
        cases_.size() == 1 ? "graze: " + cases_.front()->id : fmt::format("graze: {} cases", cases_.size());
    const show::Json data = {
        {"schema", "graze.page/1"}, {"kind", "show"}, {"title", title}, {"scenes", std::move(scenes)}};
    std::string plain;
    if (!show::has_viewer()) {
      complain("this graze was built without Node: the page holds still pictures (docs/howto/show.md)");
      for (const corpus::Case* problem : cases_) {
        for (const show::Claim& claim : show::claims_of(*problem, claimed(*problem)))
          plain += fmt::format("{}: {}\n", problem->id, claim.words);
      }
    }
    const std::string html = show::page_html(title, data, plain);
    out.write_line(html.substr(0, html.size() - 1));
    out.close();
  }

  void still() {
    if (cases_.size() > 1) {
      throw std::runtime_error(
          fmt::format("--svg: draws one case, and {} are given; name one by --id", cases_.size()));
    }
    const corpus::Case& problem = *cases_.front();
    draw::DrawSettings settings;
    settings.is_for_others = true;
    for (const show::Claim& claim : show::claims_of(problem, claimed(problem)))
      settings.claims.push_back({.words = claim.words, .time = claim.time, .is_wrong = claim.is_wrong});
    OutputFile out(arguments_.out);
    const std::string svg = draw::draw_svg(problem, settings);
    out.write_line(svg.substr(0, svg.size() - 1));
    out.close();
  }

  const ShowArguments& arguments_;
  CaseFiles inputs_;
  std::vector<const corpus::Case*> cases_;
  std::vector<const std::string*> files_;  // file of each case
  std::vector<const engine::Method*> claimed_;
  Engines engines_;
  external::RecordedLines answered_;
  std::unique_ptr<external::Recorded> recorded_;
};

}  // namespace

void add_show_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<ShowArguments>();
  CLI::App* command = app.add_subcommand(
      "show", "Makes a page on which cases are looked at from all sides: bodies, time, proof, and answers.");
  command
      ->add_option("files", arguments->files,
                   "Case files: .json holds one case, .jsonl one a line; - is standard input")
      ->required()
      ->type_name("FILE");
  command->add_option("--id", arguments->ids, "Show this case of the files only (may be repeated)")
      ->type_name("ID")
      ->allow_extra_args(false);
  command
      ->add_option(
          "--method", arguments->methods,
          "Show the answer of this method of ours beside the true one (may be repeated): mpr, mpr/float, all")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command
      ->add_option("--answers", arguments->answers,
                   "Show the answers of this file, graze.answer/1 a line, whose ids are those of cases")
      ->type_name("ANSWERS.jsonl");
  add_engine_options(*command, arguments->engines);
  add_promise_options(*command, arguments->engines);
  command->add_option("--out", arguments->out, "The page, or the picture; without it, standard output")
      ->type_name("OUT");
  command->add_flag(
      "--svg", arguments->svg,
      "A still picture of one case instead: axes, the direction it is seen from, the contact magnified, "
      "and a wrong answer beside the true one");
  command->footer(
      "The page is one file that opens anywhere, without a network: both bodies, the path, contact and "
      "witnesses, the\n"
      "difference A - B with the path of the origin and the portal or axis that proves the answer, a "
      "slider for time, the\n"
      "numbers to copy. The oracles give the true answer, and each answer is judged as in graze "
      "certify.\n\n"
      "  graze show pair.json --out pair.html\n"
      "  graze show pair.json --method mpr/float --out pair.html\n"
      "  graze show cases.jsonl --id c17 --engine ./mine --out c17.html\n"
      "  graze show pair.json --answers answers.jsonl --svg --out pair.svg   for an issue thread\n\n"
      "Exit code: 0, or 2 if a case could not be read. A wrong answer does not change it.");
  command->callback([arguments, command, &exit_code] {
    require_engine(*command);
    exit_code = ShowRun(*arguments)();
  });
}

}  // namespace graze::tool
