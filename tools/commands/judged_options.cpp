#include "tools/commands/judged_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "certify/suites.hpp"
#include "corpus/curate/location.hpp"
#include "reports/text/inputs.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {

std::filesystem::path JudgedArguments::curated_directory() const {
  return corpus.empty() ? corpus::corpus_directory() / "cases" : std::filesystem::path(corpus);
}

unsigned JudgedArguments::most_threads() const {
  return threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
}

void add_judged_options(CLI::App& command, JudgedArguments& arguments, const std::string& counted,
                        const std::string& rotated) {
  command.add_option("--family", arguments.families, "Judge cases of this family (may be repeated)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command.add_option("--count", arguments.count, counted)->check(whole_number())->type_name("N");
  command.add_option("--rotating", arguments.rotating, rotated)->check(whole_number())->type_name("N");
  command.add_option("--seed", arguments.seed, "The first seed of the generated cases (1)")
      ->check(seed_number())
      ->type_name("S");
  command
      .add_option(
          "--method", arguments.methods,
          fmt::format("{}; for rotating casts {}; for queries {}; with a scalar (mpr/float); or all (may be "
                      "repeated)",
                      linear_names(), rotating_names(), query_names()))
      ->type_name("NAME")
      ->allow_extra_args(false);
  command
      .add_option("--threads", arguments.threads, "Threads that judge; the result does not depend on them")
      ->check(whole_number(1, kMostThreads))
      ->type_name("N");
}

void add_file_options(CLI::App& command, JudgedArguments& arguments) {
  command
      .add_option("files", arguments.files,
                  "Case files to judge instead of what is built in, casts and other queries; - is standard "
                  "input")
      ->type_name("FILE");
  command.add_option("--corpus", arguments.corpus, "The folder of curated cases")->type_name("DIR");
}

void add_guarantees_option(CLI::App& command, JudgedArguments& arguments) {
  command
      .add_option("--guarantees", arguments.guarantees,
                  "Hold the methods to this table instead of the built-in one")
      ->type_name("FILE");
}

}  // namespace graze::tool
