// graze generate: the cases of a family, to standard output.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "corpus/workloads.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

struct GenerateSettings {
  std::string family;
  std::optional<double> hardness;
  std::uint64_t count = 10, seed = 1;
};

std::string family_list() {
  std::string text;
  std::size_t width = 0;
  for (const auto families : {corpus::families(), corpus::rotating_families(), corpus::workloads()}) {
    for (const corpus::Family& family : families) width = std::max(width, family.name.size() + 2);
  }
  const auto add = [&](std::span<const corpus::Family> families) {
    for (const corpus::Family& family : families) {
      text += fmt::format("  {:<{}}{}\n  {:<{}}hardness {} to {}: {}\n", family.name, width, family.sentence,
                          "", width, family.levels.front(), family.levels.back(), family.hardness_meaning);
    }
  };
  add(corpus::families());
  text += "\nFamilies with rotating bodies:\n";
  add(corpus::rotating_families());
  text += "\nWorkloads, the steps of simulations (consecutive seeds are the questions of one run):\n";
  add(corpus::workloads());
  return text;
}

int run_generate_command(const GenerateSettings& settings) {
  const corpus::Family* family = corpus::find_family(settings.family);
  if (family == nullptr) {
    throw std::runtime_error(
        fmt::format("{} is no family; `graze generate --help` lists them", settings.family));
  }
  const auto& levels = family->levels;
  if (settings.hardness && !(*settings.hardness >= levels.front() && *settings.hardness <= levels.back())) {
    throw std::runtime_error(fmt::format("--hardness: {} is outside the family's {} to {}",
                                         *settings.hardness, levels.front(), levels.back()));
  }
  OutputFile out("-");
  for (std::uint64_t i = 0; i < settings.count; ++i) {
    const double hardness = settings.hardness ? *settings.hardness : levels[i % levels.size()];
    out.write_line(corpus::write_case(family->generate(hardness, settings.seed + i)));
  }
  out.close();
  return 0;
}

}  // namespace

void add_generate_command(CLI::App& app, int& exit_code) {
  const auto settings = std::make_shared<GenerateSettings>();
  CLI::App* command =
      app.add_subcommand("generate", "Writes cases of a family, one a line, to standard output.");
  command->add_option("family", settings->family, "The family's name, see below")
      ->required()
      ->type_name("FAMILY");
  command->add_option("--hardness", settings->hardness, "The hardness (default: all levels in turn)")
      ->check(number_from())
      ->type_name("H");
  command->add_option("--count", settings->count, "How many cases (10)")
      ->check(whole_number())
      ->type_name("N");
  command->add_option("--seed", settings->seed, "The first seed (1). The next cases have the next seeds")
      ->check(seed_number())
      ->type_name("S");
  command->footer(
      "A case is a pure function of family, hardness and seed: the same bits on every machine.\n\n" +
      family_list() + "\n  graze generate grazing_edge --hardness 12 --count 5 | graze cast - --json");
  command->callback([settings, &exit_code] { exit_code = run_generate_command(*settings); });
}

}  // namespace graze::tool
