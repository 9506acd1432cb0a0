// The requirements on a curated case beyond its format, and the test for two cases that ask the same
// question.
#pragma once

#include <string>
#include <vector>

#include "corpus/case.hpp"

namespace graze::corpus {

// A comment says in a sentence why the case is hard. A shorter comment says nothing.
inline constexpr std::size_t kShortestComment = 20;

enum class Shelf {
  cases,  // corpus/cases: every flag helps to find the case again, so there is one at least
  known,  // corpus/known_failures.jsonl: a mechanism that is not mended yet, and may have no flag
};

// The missing items, one line each. The list is empty for a sound case: the id is family/name, the comment is
// a sentence, a flag is set, and a reported case has its address.
[[nodiscard]] std::vector<std::string> curation_faults(const Case& problem, Shelf shelf);

// The case without its metadata: its id, family, hardness, comment, source, flags and answer. The text is one
// line. Two cases ask the same question if these lines are equal.
[[nodiscard]] std::string question_of(const Case& problem);

}  // namespace graze::corpus
