// graze laws: checks the laws that every answer must satisfy, or lists them.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "corpus/curate/location.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/engines.hpp"
#include "tools/commands/law_page.hpp"
#include "tools/commands/try_laws.hpp"

namespace graze::tool {
namespace {

struct LawsSettings {
  LawArguments tried;
  bool list = false, page = false;
  std::string defects;  // empty: of the source tree
};

int run_laws_command(const LawsSettings& settings) {
  const std::span<const law::Law> laws = law::laws();
  if (settings.list) {
    fmt::print("{}", law_list(laws));
    return 0;
  }
  if (!settings.page) return try_laws(settings.tried);
  // They lie beside the corpus in the source tree, and are not installed.
  const std::filesystem::path folder = settings.defects.empty() ? corpus::corpus_directory().parent_path() /
                                                                      "properties" / "defects" / "patches"
                                                                : std::filesystem::path(settings.defects);
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error(folder.string() + ": is no folder of planted defects; --defects names one");
  fmt::print("{}", law_page(laws, read_defects(folder.string())));
  return 0;
}

// Throws std::runtime_error with a one-line message for an option that does not apply to a list or a page.
void require_meaning(const CLI::App& command) {
  require_engine(command);
  for (const std::string alone : {"--list", "--page"}) {
    if (command.get_option(alone)->count() == 0) continue;
    for (const CLI::Option* option : command.get_options()) {
      const std::string name = option->get_name();
      if (option->count() > 0 && name != alone && name != "--defects")
        throw std::runtime_error(
            fmt::format("{}: has no meaning beside {}, which tries no law", name, alone));
    }
  }
}

}  // namespace

void add_laws_command(CLI::App& app, int& exit_code) {
  const auto settings = std::make_shared<LawsSettings>();
  LawArguments& tried = settings->tried;
  CLI::App* command = app.add_subcommand(
      "laws", "Does every answer of every method obey the laws? Makes a case that breaks one small.");
  add_file_options(*command, tried);
  command->add_option("--law", tried.laws, "This law, not all (may be repeated)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  add_judged_options(*command, tried, fmt::format("Generated cases a family ({})", kLinearLawCases),
                     fmt::format("Generated cases of a rotating family ({})", kRotatingLawCases));
  command->add_option("--save", tried.save, "Write the smallest case on which each law broke to this file")
      ->type_name("OUT.jsonl");
  command
      ->add_option("--report", tried.report,
                   "Write those cases into this folder: cases.jsonl, and index.html to look at them")
      ->type_name("DIR");
  add_engine_options(*command, tried.engines);
  add_need_options(*command, tried.engines);
  command->add_flag("--list", settings->list, "Only list the laws");
  CLI::Option* page = command->add_flag(
      "--page", settings->page,
      "Only print docs/reference/laws.md: the laws, and the planted defects that each notices");
  command->add_option("--defects", settings->defects, "The folder of planted defects")
      ->type_name("DIR")
      ->needs(page);
  command->footer(
      "Without files or families: the curated corpus and every generated family. docs/reference/laws.md "
      "says what each law is.\n\n"
      "  graze laws --list\n"
      "  graze laws --law never_late my_cases.jsonl\n"
      "  graze laws --family grazing_edge --count 500 --report broken\n"
      "  graze laws --engine ./my_engine                       the laws that apply to it\n"
      "  graze laws --page > docs/reference/laws.md\n\n"
      "Exit code: 0 if every law holds, 1 if one is broken, 2 for bad input, and if there is nothing to "
      "judge.");
  command->callback([settings, command, &exit_code] {
    require_meaning(*command);
    exit_code = run_laws_command(*settings);
  });
}

}  // namespace graze::tool
