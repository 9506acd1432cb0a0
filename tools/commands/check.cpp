// graze check: verifies proofs that anyone wrote, and that they prove what their records say.
#include <fmt/format.h>

#include <memory>

#include "engines/guarantees.hpp"
#include "oracles/arithmetic/default_environment.hpp"
#include "oracles/checker/check_within.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/outputs.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

// Exit codes, the gravest that applies.
constexpr int kAllAccepted = 0, kRefused = 1, kUnreadable = 2, kInPart = 3;

struct CheckArguments {
  std::vector<std::string> files;
  double kappa = 0;
};

int run_check_command(const CheckArguments& arguments) {
  will_read(arguments.files);
  const oracle::DefaultEnvironment environment;  // for what reads numbers, too
  std::size_t accepted = 0, within = 0, in_part = 0, refused = 0;
  bool bad = false;
  for (const std::string& name : arguments.files) {
    const corpus::ProofReadResult read = name == "-"
                                             ? corpus::read_proofs_text(read_stdin(), "standard input")
                                             : corpus::read_proofs_file(name);
    for (const corpus::ReadError& error : read.errors) complain(error.text());
    bad = bad || !read.ok();
    for (const corpus::ProofRecord& record : read.proofs) {
      bool exactly = true;
      const oracle::RecordVerdict verdict = oracle::check_record_within(
          record, {.of_proof = arguments.kappa, .of_bracket = engine::kappa_of(record)}, &exactly);
      within += exactly ? 0 : 1;
      if (verdict.finding == oracle::RecordFinding::accepted) {
        ++accepted;
        continue;
      }
      const bool is_refused = verdict.finding == oracle::RecordFinding::refused;
      ++(is_refused ? refused : in_part);
      fmt::print("{}  {}  {}/{}  {}{}\n", is_refused ? "refused" : "in part", record.problem.id,
                 record.method, record.scalar, is_refused ? verdict.reason + ": " : "", verdict.detail);
    }
  }
  fmt::print("{} accepted, {}{} refused\n", accepted,
             in_part > 0 ? fmt::format("{} proved in part, ", in_part) : "", refused);
  if (within > 0)
    fmt::print("{} of the proofs {} true within {:g} u of scale, and not exactly\n", within,
               within == 1 ? "is" : "are", arguments.kappa);
  return bad ? kUnreadable : refused > 0 ? kRefused : in_part > 0 ? kInPart : kAllAccepted;
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = app.add_subcommand(
      "check",
      "Is each proof of the files true, and does it prove what its record says? The check is exact (ball "
      "arithmetic for rotating bodies) and independent of the program that wrote the proof.");
  command
      ->add_option("files", arguments->files,
                   "Files of proofs, one a line, as `graze cast --proof` writes them; - is standard input")
      ->required()
      ->type_name("FILE");
  command
      ->add_option(
          "--kappa", arguments->kappa,
          "Also accept a linear proof that is true of shapes within K u of scale of the given ones, u the "
          "unit roundoff of its record's scalar (0: none)")
      ->check(number_from(0))
      ->type_name("K");
  command->footer(
      "A proof holds its case, an axis that bounds the time of impact from below, and a portal of support "
      "pairs that\n"
      "bounds it from above. The proof of a rotating answer holds a chain of axes with their slices of "
      "time, and pairs in\n"
      "contact at its end. The record also says what was answered: an outcome and, if it states one, a "
      "bracket.\n\n"
      "  accepted  the proof is true and proves the outcome and the bracket. In the standard tier it may "
      "prove the\n"
      "            bracket for shapes within kappa u of scale, kappa from the guarantee of the record's "
      "method\n"
      "  in part   the proof is true and proves less: a wider bracket; one half of a hit; in the standard "
      "tier, of\n"
      "            contact or a miss by the rounding alone, perhaps nothing; for a start under pass_over "
      "what the\n"
      "            format can say\n"
      "  refused   the proof is false, or contradicts what its record says, or proves nothing of it\n\n"
      "Each record that is not accepted is one line: the case, the method, what is claimed, what is "
      "proved, or why not.\n\n"
      "  graze cast cases.jsonl --proof proofs.jsonl\n"
      "  graze check proofs.jsonl\n"
      "  graze check --kappa 16 proofs_of_another_library.jsonl   (docs/explanation/checker.md says what "
      "is accepted then)\n\n"
      "Exit code: 0 if every record is accepted; 1 if one is refused; 2 if a file could not be read; 3 if "
      "none is\n"
      "refused and some are proved in part.");
  command->callback([arguments, &exit_code] { exit_code = run_check_command(*arguments); });
}

}  // namespace graze::tool
