// A law: one sentence about every answer of every method, as a plain function of a case and a method.
//
// RapidCheck, the fuzzers, the corpus runs and the tool call the same functions. A law never throws, calls the method
// itself (as often as it needs), and answers: holds, broken with a reason, or not applicable. If the two answers in a
// metamorphic law differ, the law does not decide which is at fault. The exact oracle names the one that breaks its
// guarantee, since at a graze two times may both be right and yet far apart.
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
  std::string reason;  // if broken: the observed and the expected, numbers as decimals. If not applicable:
                       // why
  // Classification of the drawn case, for counting: the outcome, and the distinctions of the law. If the law
  // is not applicable: "undecided", when an oracle was called without result.
  std::vector<std::string_view> labels;
};

// The basis of a law, hence its cost: the method alone, the checker of proofs, or the exact oracle.
enum class Needs { metamorphic, proof, oracle };

using engine::Kind;
using engine::Method;

struct Law {
  std::string name, sentence;
  Needs needs = Needs::metamorphic;
  // Not applicable: the case is not a question for the law, or the law does not cover the method.
  std::function<LawResult(const corpus::Case&, const Method&)> check;
  // The kind of the methods that it judges. A law of the queries is called with the bodies of a linear case.
  Kind kind = Kind::linear;

  [[nodiscard]] std::span<const Method> methods() const { return engine::methods(kind); }
};

// In the order of the tables: linear casts, queries, rotating casts.
[[nodiscard]] std::span<const Law> laws();
[[nodiscard]] std::span<const Law> laws(Kind kind);
[[nodiscard]] const Law* find_law(std::string_view name);  // nullptr for an unknown name

[[nodiscard]] std::string_view to_text(Needs needs);

}  // namespace graze::law
