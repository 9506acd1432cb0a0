// The command graze.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>

#include "engines/system/system.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/corpus.hpp"
#include "tools/commands/options.hpp"

namespace {

// The command that the line names, up to the part that was parsed: "corpus add". Empty if no command was read yet.
const CLI::App& named_command(const CLI::App& app, std::string& words) {
  const auto parsed = app.get_subcommands();
  if (parsed.empty()) return app;
  words += (words.empty() ? "" : " ") + parsed.front()->get_name();
  return named_command(*parsed.front(), words);
}

// The missing input of a command that was given nothing to work on.
std::string wanted_by(const std::string& words, const CLI::Option& missing) {
  static const std::map<std::string, std::string> kWanted = {
      {"cast", "a case file"},
      {"show", "a case file"},
      {"check", "a file of proofs"},
      {"scene", "the file of a scene"},
      {"merge", "the parts of a campaign, PART.json"},
      {"generate", "a family"},
      {"judge", "a file of answers"},
      {"compare", "two files that graze price --json wrote"},
      {"corpus add", "a file of cases"},
      {"corpus fill", "a file of cases"},
      {"corpus format", "a file of cases"},
      {"corpus validate", "a file of cases"},
  };
  const auto known = kWanted.find(words);
  return known != kWanted.end() ? known->second : missing.get_name();
}

// The error in the command line, and where to find the correct form.
std::string complaint_of(const CLI::App& app, const CLI::ParseError& error) {
  std::string words;
  const CLI::App& command = named_command(app, words);
  std::string what = error.what();
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    for (const CLI::Option* option : command.get_options()) {
      const bool is_missing = option->get_required() && option->get_positional() && option->count() == 0;
      if (!is_missing) continue;
      what = words + ": name " + wanted_by(words, *option);
      break;
    }
  }
  return what + "; see graze " + words + (words.empty() ? "" : " ") + "--help";
}

int run(int argc, char** argv) {
  int exit_code = 0;
  CLI::App app(
      "graze: certified casts for convex shapes. It casts a moving shape against another, proves its\n"
      "answers, checks proofs, and certifies how accurate, how fast and how safe each method is.",
      "graze");
  app.set_version_flag("--version", "graze " GRAZE_VERSION);
  app.require_subcommand(1);
  app.footer(
      "  graze certify               judges our methods on the hard cases and families that are built in\n"
      "  graze cast pair.json        answers a case of your own (docs/reference/case-format.md says how to "
      "write one)\n"
      "  graze COMMAND --help        says more about each command\n\n"
      "Exit codes: 0; 1 if something judged was found wanting; 2 for bad input and for output that cannot "
      "be\n"
      "written, which one line on stderr explains. If the reader of a pipe closes it, the command ends "
      "silently\n"
      "by SIGPIPE. A file that is read is never written over.");
  graze::tool::add_cast_command(app, exit_code);
  graze::tool::add_scene_command(app, exit_code);
  graze::tool::add_check_command(app, exit_code);
  graze::tool::add_certify_command(app, exit_code);
  graze::tool::add_laws_command(app, exit_code);
  graze::tool::add_stability_command(app, exit_code);
  graze::tool::add_judge_command(app, exit_code);
  graze::tool::add_price_command(app, exit_code);
  graze::tool::add_compare_command(app, exit_code);
  graze::tool::add_campaign_command(app, exit_code);
  graze::tool::add_merge_command(app, exit_code);
  graze::tool::add_generate_command(app, exit_code);
  graze::tool::add_draw_command(app, exit_code);
  graze::tool::add_show_command(app, exit_code);
  graze::tool::add_report_command(app, exit_code);
  graze::tool::add_serve_command(app, exit_code);
  graze::tool::add_corpus_command(app, exit_code);
  graze::tool::add_host_command(app, exit_code);
  graze::tool::refuse_empty_values(app);
  const auto is_first_word = [&](const CLI::App* command) { return command->check_name(argv[1]); };
  if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(is_first_word).empty()) {
    throw std::runtime_error(std::string(argv[1]) + " is no command; graze --help lists them");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    throw std::runtime_error(complaint_of(app, error));
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  graze::system::secure_standard_streams();
  try {
    const int exit_code = run(argc, argv);
    graze::tool::close_standard_output();
    return exit_code;
  } catch (const graze::tool::ReaderGone&) {
    return graze::system::end_as_by_sigpipe();
  } catch (const std::system_error& error) {
    if (graze::tool::is_reader_gone()) return graze::system::end_as_by_sigpipe();
    // fmt::print does not say which file it could not write.
    graze::tool::complain(std::ferror(stdout) == 0 ? error.what()
                                                   : "standard output: could not be written to its end: " +
                                                         error.code().message());
  } catch (const std::exception& error) {
    graze::tool::complain(error.what());
  }
  return 2;
}
