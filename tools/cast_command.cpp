// graze cast: the answer of a method to each case of the files.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "corpus/names.hpp"
#include "tools/answer_text.hpp"
#include "tools/commands.hpp"
#include "tools/inputs.hpp"

namespace graze::tool {
namespace {

struct Settings {
  std::vector<std::string> files;
  std::string method = "mpr", scalar = "double", tier = "standard", proofs;
  bool json = false;
};

std::vector<const engine::EngineMethod*> methods_of(const Settings& settings) {
  if (settings.tier != "standard") {
    const bool known = settings.tier == "certified" || settings.tier == "exact";
    throw std::runtime_error(fmt::format("--tier: {} is {}; use standard", settings.tier,
                                         known ? "not available in this version" : "no tier"));
  }
  if (settings.scalar != "double" && settings.scalar != "float") {
    throw std::runtime_error(
        fmt::format("--scalar: {} is no scalar; it is double or float", settings.scalar));
  }
  std::vector<const engine::EngineMethod*> methods = select_methods({settings.method});
  if (settings.method.find('/') == std::string::npos) {
    std::erase_if(methods, [&](const engine::EngineMethod* m) { return m->scalar != settings.scalar; });
  }
  return methods;
}

int run(const Settings& settings) {
  const std::vector<const engine::EngineMethod*> methods = methods_of(settings);
  std::unique_ptr<OutputFile> proofs;
  if (!settings.proofs.empty()) proofs = std::make_unique<OutputFile>(settings.proofs);
  const Request request = Request::normal | Request::witnesses | (proofs ? Request::proof : Request::verdict);

  const CaseFiles inputs = read_case_files(settings.files);
  bool bad = inputs.bad;
  for (const CaseFile& file : inputs.files) {
    for (const corpus::Case& problem : file.cases) {
      if (const std::string why = engine::unsupported(problem); !why.empty()) {
        complain(fmt::format("{}: case {}: has {}, which this version does not cast; give a linear cast",
                             file.name, problem.id, why));
        bad = true;
        continue;
      }
      for (const engine::EngineMethod* method : methods) {
        const engine::Answer answer = method->cast(problem, {.request = request});
        fmt::print("{}\n", settings.json ? answer_json(problem, *method, answer)
                                         : answer_block(problem, *method, answer));
        if (answer.outcome == Outcome::invalid_input) {
          complain(fmt::format("{}: case {}: is invalid_input for {}: {}", file.name, problem.id,
                               method->full_name(), invalid_text(answer.invalid)));
          bad = true;
        }
        if (proofs && answer.proof) {
          proofs->write_line(corpus::write_proof({.problem = method->seen(problem),
                                                  .method = method->name,
                                                  .scalar = method->scalar,
                                                  .outcome = answer.outcome,
                                                  .proof = *answer.proof}));
        }
      }
    }
  }
  if (proofs) proofs->close();
  return bad ? 2 : 0;
}

}  // namespace

void add_cast_command(CLI::App& app, int& exit_code) {
  const auto settings = std::make_shared<Settings>();
  CLI::App* command =
      app.add_subcommand("cast", "When do the bodies of a case first touch? Answers each case of the files.");
  command
      ->add_option("files", settings->files,
                   "Case files: .json holds one case, .jsonl one a line; - is standard input")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--method", settings->method,
                   "mpr (MPR sweep, the default), gjk (GJK ray cast), ca (conservative advancement), or all")
      ->type_name("NAME");
  command
      ->add_option("--scalar", settings->scalar,
                   "double (the default) or float: rounds the case, then casts it")
      ->type_name("NAME");
  command->add_option("--tier", settings->tier, "standard: the tier of this version")->type_name("NAME");
  command->add_flag("--json", settings->json,
                    "One JSON object a line, whose numbers read back to the same bits");
  command->add_option("--proof", settings->proofs, "Also write the proofs to this file, for `graze check`")
      ->type_name("OUT.jsonl");
  command->footer(
      "The time runs from 0 to the case's t_max (1 by default). A bracket [lower, upper] holds the time of "
      "impact;\n"
      "use lower in a simulator: it is never late. The normal is from A to B; point_a and point_b are the "
      "contact\n"
      "on each body at lower, in world coordinates.\n\n"
      "  graze cast pair.json\n"
      "  graze cast cases.jsonl --json --method all --proof proofs.jsonl && graze check proofs.jsonl\n\n"
      "Exit code: 0, or 2 if a file or a case could not be read or answered; the others are answered all the "
      "same.");
  command->callback([settings, &exit_code] { exit_code = run(*settings); });
}

}  // namespace graze::tool
