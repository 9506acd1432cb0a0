// graze laws: what must hold of every answer.
#include <fmt/format.h>

#include <memory>

#include "tools/commands/commands.hpp"
#include "tools/commands/law_page.hpp"

namespace graze::tool {
namespace {

struct Settings {
  bool page = false;
  std::string defects = GRAZE_DEFECTS_DIRECTORY;
};

int run(const Settings& settings) {
  const std::span<const law::Law> laws = law::laws();
  fmt::print("{}", settings.page ? law_page(laws, read_defects(settings.defects)) : law_list(laws));
  return 0;
}

}  // namespace

void add_laws_command(CLI::App& app, int& exit_code) {
  const auto settings = std::make_shared<Settings>();
  CLI::App* command =
      app.add_subcommand("laws", "Lists the laws that every answer of every method must obey.");
  CLI::Option* page = command->add_flag("--page", settings->page,
                                        "As docs/laws.md, with the planted defects that each notices");
  command->add_option("--defects", settings->defects, "The folder of planted defects")
      ->type_name("DIR")
      ->needs(page);
  command->footer(
      "`graze certify --laws` tries them.\n\n"
      "  graze laws\n"
      "  graze laws --page > docs/laws.md\n\n"
      "Exit codes: 0; 2 for bad input.");
  command->callback([settings, &exit_code] { exit_code = run(*settings); });
}

}  // namespace graze::tool
