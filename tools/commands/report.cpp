// graze report: the page of a price list that was measured before.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "corpus/format/case_json.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/price_page.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/commands.hpp"

namespace graze::tool {
namespace {

struct ReportArguments {
  std::string file, out = "-";
};

int run_report_command(const ReportArguments& arguments) {
  will_read({arguments.file});
  OutputFile out(arguments.out);
  std::string html;
  try {
    html = show::price_page(show::read_price(read_text(arguments.file)));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(arguments.file + ": " + error.what());
  }
  if (!show::has_viewer())
    complain("this graze was built without Node: the page lacks the viewer (docs/howto/show.md)");
  out.write_line(html.substr(0, html.size() - 1));
  out.close();
  return 0;
}

}  // namespace

void add_report_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command =
      app.add_subcommand("report", "Makes the page of a price list: figures, and the cases behind them.");
  command
      ->add_option("file", arguments->file,
                   "graze.price/1, as graze price --json writes it; - is standard input")
      ->required()
      ->type_name("PRICE.json");
  command->add_option("--out", arguments->out, "The page; without it, standard output")
      ->type_name("OUT.html");
  command->footer(
      "One file that opens anywhere, without a network: error against time, growth, what each request "
      "adds. Point at a\n"
      "mark to read what it stands for. Press it to see its case.\n\n"
      "  graze report price.json --out price.html\n\n"
      "Exit code: 0, or 2 if the file is no price list.");
  command->callback([arguments, &exit_code] { exit_code = run_report_command(*arguments); });
}

}  // namespace graze::tool
