// Answers that were made elsewhere, at another time, as methods that can be judged: to each case the line that answers its
// id.
//
// The engine's author made the question from the case. So the case is taken as it was given, rounded to the scalar, in its
// own unit of length.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "certify/external/declaration.hpp"
#include "certify/external/engine_methods.hpp"
#include "engines/guarantees.hpp"

namespace graze::external {

// By the id of the case.
using RecordedLines = std::map<std::string, std::string>;

// One that makes no promise, in double, which takes every shape. A field is held by the answers to a query where one of
// them holds it. `problems`: the cases, by which a line's query is known.
[[nodiscard]] Declaration declaration_of(const RecordedLines& lines, std::span<const corpus::Case> problems);

// The protocol's question for a case, if there is one. For casts it depends on whether a body rotates.
[[nodiscard]] std::optional<Question> question_of(const corpus::Case& problem);

class Recorded {
 public:
  Recorded(Declaration declaration, RecordedLines lines, const Held& held);
  Recorded(const Recorded&) = delete;
  Recorded& operator=(const Recorded&) = delete;

  // A method for each thing that it says it can be asked, but rays, which no case asks for.
  [[nodiscard]] std::span<const engine::Method> methods() const { return methods_; }

 private:
  [[nodiscard]] engine::Answer answer(const Offer& offer, const Terms& terms,
                                      const corpus::Case& problem) const;

  Declaration declaration_;
  RecordedLines lines_;
  std::vector<engine::Guarantee> guarantees_;
  std::vector<engine::Method> methods_;
};

}  // namespace graze::external
