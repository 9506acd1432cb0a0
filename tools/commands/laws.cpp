// graze laws: what must hold of every answer.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "corpus/curate/location.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/law_page.hpp"

namespace graze::tool {
namespace {

struct LawsSettings {
  bool page = false;
  std::string defects;  // empty: of the source tree
};

int run_laws_command(const LawsSettings& settings) {
  const std::span<const law::Law> laws = law::laws();
  if (!settings.page) {
    fmt::print("{}", law_list(laws));
    return 0;
  }
  // They lie beside the corpus in the source tree, and are not installed.
  const std::filesystem::path folder =
      settings.defects.empty() ? corpus::corpus_directory().parent_path() / "properties" / "defects"
                               : std::filesystem::path(settings.defects);
  if (!std::filesystem::is_directory(folder))
    throw std::runtime_error(folder.string() + ": is no folder of planted defects; --defects names one");
  fmt::print("{}", law_page(laws, read_defects(folder.string())));
  return 0;
}

}  // namespace

void add_laws_command(CLI::App& app, int& exit_code) {
  const auto settings = std::make_shared<LawsSettings>();
  CLI::App* command =
      app.add_subcommand("laws", "Lists the laws that every answer of every method must obey.");
  CLI::Option* page = command->add_flag(
      "--page", settings->page, "As docs/reference/laws.md, with the planted defects that each notices");
  command->add_option("--defects", settings->defects, "The folder of planted defects")
      ->type_name("DIR")
      ->needs(page);
  command->footer(
      "`graze certify --laws` tries them.\n\n"
      "  graze laws\n"
      "  graze laws --page > docs/reference/laws.md\n\n"
      "Exit codes: 0; 2 for bad input.");
  command->callback([settings, &exit_code] { exit_code = run_laws_command(*settings); });
}

}  // namespace graze::tool
