// graze check: verifies proofs that anyone wrote.
#include <fmt/format.h>

#include <memory>

#include "oracles/check_proof.hpp"
#include "oracles/check_rotating_proof.hpp"
#include "tools/commands.hpp"
#include "tools/inputs.hpp"

namespace graze::tool {
namespace {

// Of either form of proof.
struct Judgement {
  bool accepted;
  const char* refusal;
  std::string detail;
};

template <class Verdict>
[[nodiscard]] Judgement judgement(const Verdict& verdict) {
  return {verdict.accepted(), to_string(verdict.refusal), verdict.detail};
}

[[nodiscard]] Judgement judge(const corpus::ProofRecord& record) {
  if (record.rotating) return judgement(oracle::check_rotating_proof(record.problem, *record.rotating));
  return judgement(oracle::check_proof(record.problem, record.proof));
}

int run(const std::vector<std::string>& files) {
  std::size_t accepted = 0, refused = 0;
  bool bad = false;
  for (const std::string& name : files) {
    const corpus::ProofReadResult read = name == "-"
                                             ? corpus::read_proofs_text(read_stdin(), "standard input")
                                             : corpus::read_proofs_file(name);
    for (const corpus::ReadError& error : read.errors) complain(error.text());
    bad = bad || !read.ok();
    for (const corpus::ProofRecord& record : read.proofs) {
      const Judgement verdict = judge(record);
      if (verdict.accepted) {
        ++accepted;
        continue;
      }
      ++refused;
      fmt::print("refused  {}  {}/{}  {}: {}\n", record.problem.id, record.method, record.scalar,
                 verdict.refusal, verdict.detail);
    }
  }
  fmt::print("{} accepted, {} refused\n", accepted, refused);
  return bad ? 2 : refused > 0 ? 1 : 0;
}

}  // namespace

void add_check_command(CLI::App& app, int& exit_code) {
  const auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand(
      "check",
      "Is each proof of the files true? Exact, in balls where bodies turn; independent of who wrote it.");
  command
      ->add_option("files", *files,
                   "Files of proofs, one a line, as `graze cast --proof` writes them; - is standard input")
      ->required()
      ->type_name("FILE");
  command->footer(
      "A proof holds its case, an axis that bounds the time of impact from below, and a portal of support "
      "pairs that\n"
      "bounds it from above; of a rotating answer, a chain of axes with their slices of time, and pairs in "
      "contact at\n"
      "its end. Each refusal is a line: the case, the method, the first claim that fails, and why.\n\n"
      "  graze cast cases.jsonl --proof proofs.jsonl\n"
      "  graze check proofs.jsonl\n\n"
      "Exit code: 0 if every proof is accepted, 1 if one is refused, 2 if a file could not be read.");
  command->callback([files, &exit_code] { exit_code = run(*files); });
}

}  // namespace graze::tool
