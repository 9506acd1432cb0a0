// A fuzz target: a question about a case (or a text), asked of bytes.
//
// A target's file defines kTarget and nothing else. From it target_main.cpp makes the function that libFuzzer calls, so
// that every target counts, reports and aborts alike, and replay_main.cpp can minimise its findings.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "corpus/case.hpp"
#include "properties/laws/law.hpp"

namespace graze::fuzz {

// The broken property. `law` names the law, or the step of the target, and `method` the method that broke it, if any.
struct Finding {
  std::string law, method, fault;
  corpus::Case problem;  // as the target asked it
  std::string sides;     // every side's answer, several lines, or nothing
};

// The result for one input.
struct Judged {
  bool reached = false;  // some law applied to it (otherwise the input was no question for this target)
  bool by_oracle = false;
  bool known = false;  // the broken law is listed as a known failure (properties/laws/reach.hpp), which is
                       // not a finding
  std::optional<Finding> finding;
};

// A case, and the choices that the target may draw about it.
struct Input {
  corpus::Case problem;
  // A hash of the case's bytes, with the tail's first eight bytes added bit by bit. A mutant of an input that
  // drew the oracle therefore draws anew. Otherwise a fuzzer, which keeps inputs that reach new code, would
  // fill its corpus with them. The choice stays the same while a finding is minimised.
  std::uint64_t choice = 0;
  std::span<const std::uint8_t> tail;
};

[[nodiscard]] Input input_of(std::span<const std::uint8_t> bytes);
// The bytes of a case whose choice is this one, if it can be encoded.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> bytes_of(const corpus::Case& problem,
                                                                const Input& like);

struct Target {
  const char* name;
  Judged (*judge)(const Input&);                                  // of a case, or nullptr
  Judged (*judge_text)(std::span<const std::uint8_t>) = nullptr;  // of a text
};
extern const Target kTarget;

// target.cpp defines these two for cases, text_target.cpp for texts.
[[nodiscard]] Judged judge(std::span<const std::uint8_t> bytes);

// target, law, method, fault and the case as JSON, a line each. Then come every number as a hexfloat and every side.
[[nodiscard]] std::string report(const Finding& finding);
// The first four of these lines.
[[nodiscard]] inline std::string heading(const Finding& finding) {
  return std::string("target: ") + kTarget.name + "\nlaw: " + finding.law + "\nmethod: " + finding.method +
         "\nfault: " + finding.fault + "\n";
}

// Adds the result of a law for a method's answer: reached if it applied, a finding if it broke.
void add(Judged& judged, std::string_view law, std::string_view method, const law::LawResult& said,
         const corpus::Case& problem);

}  // namespace graze::fuzz
