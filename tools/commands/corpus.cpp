#include "tools/commands/corpus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <thread>

#include "corpus/format/case_io.hpp"
#include "reports/text/counted.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/corpus_add.hpp"
#include "tools/commands/corpus_files.hpp"
#include "tools/commands/corpus_verify.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

using Files = std::vector<std::string>;

// The files themselves are rewritten, and nothing else that is read.
int rewrite(const Files& files, bool fill) {
  will_read(files);
  corpus::Ids ids;
  bool bad = false;
  for (const std::string& name : files) {
    std::optional<std::vector<corpus::Case>> cases = read_sound(name, ids);
    bad = bad || !cases;
    if (!cases) continue;
    try {
      for (corpus::Case& problem : *cases) {
        if (fill) fill_in(name, problem);
      }
    } catch (const std::invalid_argument& error) {
      complain(name + ": " + error.what());
      bad = true;
      continue;
    }
    replace_file(name, *cases);
  }
  return bad ? 2 : 0;
}

int validate(const Files& files) {
  will_read(files);
  corpus::Ids ids;
  std::size_t count = 0;
  bool bad = false;
  for (const std::string& name : files) {
    const corpus::ReadResult result = std::filesystem::is_directory(name) ? corpus::read_directory(name, ids)
                                                                          : corpus::read_file(name, ids);
    for (const corpus::ReadError& error : result.errors) complain(error.text());
    bad = bad || !result.ok();
    count += result.cases.size();
  }
  fmt::print("{}\n", counted(count, "valid case"));
  return bad ? 2 : 0;
}

CLI::App* add_files_command(CLI::App& parent, const char* name, const char* what,
                            const std::shared_ptr<Files>& files) {
  CLI::App* command = parent.add_subcommand(name, what);
  command->add_option("files", *files, "Files of cases, .json or .jsonl")->required()->type_name("FILE");
  return command;
}

void add_add_command(CLI::App& parent, int& exit_code) {
  const auto addition = std::make_shared<Addition>();
  CLI::App* command = parent.add_subcommand(
      "add", "Makes a finding a curated case: checks it, derives its answer, appends it to a file.");
  command->add_option("finding", addition->input, "A file of cases, .json or .jsonl, or - for standard input")
      ->required()
      ->type_name("FILE");
  CLI::App* where = command->add_option_group("where", "The destination, one of");
  where->add_option("--into", addition->into, "A file of corpus/cases, which may be new")->type_name("FILE");
  where->add_flag("--known", addition->known, "corpus/known_failures.jsonl, until the mechanism is mended");
  where->require_option(1);
  command->add_option("--id", addition->id, "family/name; without it the case keeps its id")->type_name("ID");
  command->add_option("--comment", addition->comment, "Why it is hard, in a sentence")->type_name("TEXT");
  command
      ->add_option("--flag", addition->flags, "A flag with a note on what the case breaks (may be repeated)")
      ->type_name("FLAG")
      ->allow_extra_args(false);
  command->add_option("--source", addition->source, "The place where it was reported")->type_name("URL");
  command->add_flag("--dry-run", addition->dry_run, "Prints what would be appended, and writes nothing");
  command->footer(
      "The family is the first part of the id. The hardness is kept if the family is. An id or a case that "
      "the\n"
      "corpus already has, a flag without a note and a missing comment are refused, and then nothing is\n"
      "written.\n\n"
      "  graze corpus add finding.json --into corpus/cases/grazing.jsonl --id graze/rim-on-rim \\\n"
      "      --flag Graze --comment \"Rims that pass each other by less than a rounding.\"\n\n"
      "Exit codes: 0; 2 for bad input.");
  command->callback([addition, &exit_code] { exit_code = add_cases(*addition); });
}

}  // namespace

void add_corpus_command(CLI::App& app, int& exit_code) {
  CLI::App* corpus = app.add_subcommand("corpus", "Adds, fills, formats, validates and verifies cases.");
  corpus->require_subcommand(1);
  corpus->footer(
      "  graze corpus validate new.json    says what is wrong with it, or that it is valid\n"
      "  graze corpus fill new.json        writes the oracle's answer into it\n"
      "  graze corpus add new.json --into corpus/cases/ties.jsonl --id ties/three-cubes\n"
      "                                    makes it a case of the corpus\n"
      "  graze corpus verify               derives every answer of the built-in corpus again\n\n"
      "Exit codes: 0; 1 if verify finds a difference; 2 for bad input, a file of which is left as it was.");
  const auto files = std::make_shared<Files>();
  const auto directory = std::make_shared<std::string>();
  const auto threads = std::make_shared<unsigned>(std::max(1U, std::thread::hardware_concurrency()));

  add_add_command(*corpus, exit_code);
  add_files_command(*corpus, "fill",
                    "Derives the expected answer of every case, and writes it into the file.", files)
      ->callback([files, &exit_code] { exit_code = rewrite(*files, true); });
  add_files_command(*corpus, "format", "Rewrites files in the canonical form.", files)
      ->callback([files, &exit_code] { exit_code = rewrite(*files, false); });
  add_files_command(*corpus, "validate", "Reads files or directories, and changes nothing.", files)
      ->callback([files, &exit_code] { exit_code = validate(*files); });
  CLI::App* check = corpus->add_subcommand(
      "verify", "Derives every expected answer again and reports differences; flags and notes as well.");
  check->add_option("directory", *directory, "A directory of cases; the built-in corpus without one")
      ->type_name("DIR");
  check->add_option("--threads", *threads, "Threads that derive; the report does not depend on them")
      ->type_name("N")
      ->check(whole_number(1, kMostThreads));
  check->callback([directory, threads, &exit_code] { exit_code = verify_corpus(*directory, *threads); });
}

}  // namespace graze::tool
