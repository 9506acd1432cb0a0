// Does any text break a reader?
//
//   1. The bytes are a file: of one case, of cases a line, of proofs, and of guarantees.
//   2. No reader crashes or throws anything that it does not document. Each gives a case or an error, and every error
//      is one line that begins with the file's name and says something after it.
//   3. The result is written and read again: the same bits, the same line.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "corpus/format/case_io.hpp"
#include "corpus/format/proof_io.hpp"
#include "engines/guarantees.hpp"
#include "fuzz/target.hpp"

namespace graze::fuzz {

namespace {

constexpr const char* kName = "file";

std::string error_fault(const corpus::ReadError& error) {
  const std::string text = error.text();
  if (text.find('\n') != std::string::npos) return "an error of several lines: " + text;
  if (text.rfind(std::string(kName) + ":", 0) != 0) return "an error that does not name its file: " + text;
  if (error.what.empty()) return "an error that says nothing: " + text;
  return {};
}

std::string errors_fault(const std::vector<corpus::ReadError>& errors, std::size_t read) {
  if (errors.empty() && read == 0) return "neither a case nor an error";
  for (const corpus::ReadError& error : errors) {
    if (std::string fault = error_fault(error); !fault.empty()) return fault;
  }
  return {};
}

std::string cases_fault(std::string_view text, bool lines) {
  const corpus::ReadResult read = corpus::read_text(text, kName, lines);
  std::string fault = errors_fault(read.errors, read.cases.size());
  for (const corpus::Case& one : read.cases) {
    for (const std::string& written : {corpus::write_case(one), corpus::write_case_pretty(one)}) {
      const corpus::ReadResult again = corpus::read_text(written, kName, false);
      const bool same = again.ok() && again.cases.size() == 1 && corpus::same_case(again.cases[0], one);
      if (!same && fault.empty()) fault = "another case is read from what was written: " + written;
    }
  }
  return fault;
}

std::string proofs_fault(std::string_view text) {
  const corpus::ProofReadResult read = corpus::read_proofs_text(text, kName);
  std::string fault = errors_fault(read.errors, read.proofs.size());
  for (const corpus::ProofRecord& one : read.proofs) {
    const std::string written = corpus::write_proof(one);
    const corpus::ProofReadResult again = corpus::read_proofs_text(written, kName);
    const bool same = again.ok() && again.proofs.size() == 1 &&
                      corpus::same_case(again.proofs[0].problem, one.problem) &&
                      corpus::write_proof(again.proofs[0]) == written;
    if (!same && fault.empty()) fault = "another proof is read from what was written: " + written;
  }
  return fault;
}

std::string guarantees_fault(std::string_view text) {
  try {
    (void)engine::parse_guarantees(text);
  } catch (const std::runtime_error& error) {
    const std::string_view what = error.what();
    if (what.empty()) return "an error that says nothing";
    if (what.find('\n') != std::string_view::npos) return fmt::format("an error of several lines: {}", what);
  }
  return {};
}

Judged judge_text(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  Judged judged{.reached = true, .by_oracle = false, .finding = {}};
  const std::pair<const char*, std::string> faults[] = {{"case_file", cases_fault(text, false)},
                                                        {"case_lines", cases_fault(text, true)},
                                                        {"proof_lines", proofs_fault(text)},
                                                        {"guarantees_file", guarantees_fault(text)}};
  for (const auto& [reader, fault] : faults) {
    if (fault.empty() || judged.finding) continue;
    judged.finding = Finding{std::string(reader) + "_is_read_right", "reader", fault, {}, {}};
  }
  return judged;
}

}  // namespace

const Target kTarget = {.name = "case_files", .judge = nullptr, .judge_text = &judge_text};

}  // namespace graze::fuzz
