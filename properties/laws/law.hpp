// A law: one sentence about every answer of every method, as a plain function of a case and a method.
//
// RapidCheck, the fuzzers, the corpus runs and the tool call the same functions. A law never throws, asks the
// method itself (as often as it needs), and answers: holds, broken with a reason, or not applicable. Where a
// metamorphic law sees two answers differ, it blames nobody by itself: the exact oracle says which one breaks
// its row, since at a graze two times may both be right and yet far apart.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/case.hpp"
#include "engines/method.hpp"

namespace graze::law {

enum class Holding { holds, broken, not_applicable };

struct LawResult {
  Holding holding = Holding::holds;
  std::string reason;  // broken: what was seen and what should be, numbers as decimals; not applicable: why
  // Classification of what was drawn, for counting: the outcome, and what the law distinguishes. Of a law
  // that is not applicable: "undecided", where an oracle was asked in vain.
  std::vector<std::string_view> labels;
};

// What a law stands on, hence what it costs: the method alone, the checker of proofs, or the exact oracle.
enum class Needs { metamorphic, proof, oracle };

using engine::Kind;
using engine::Method;

struct Law {
  std::string name, sentence;
  Needs needs = Needs::metamorphic;
  // Not applicable: the case is no question for the law, or the method none that it is about.
  std::function<LawResult(const corpus::Case&, const Method&)> check;
  // Of the methods that it judges; a law of the queries is called with the bodies of a linear case.
  Kind kind = Kind::linear;

  [[nodiscard]] std::span<const Method> methods() const { return engine::methods(kind); }
};

// In the order of the tables: of linear casts, of the queries, of casts of turning bodies.
[[nodiscard]] std::span<const Law> laws();
[[nodiscard]] std::span<const Law> laws(Kind kind);
[[nodiscard]] const Law* find_law(std::string_view name);  // nullptr if there is none

[[nodiscard]] std::string_view to_text(Needs needs);

}  // namespace graze::law
