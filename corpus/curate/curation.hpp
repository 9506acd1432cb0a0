// What a curated case must have beyond its format, and when two cases ask the same.
#pragma once

#include <string>
#include <vector>

#include "corpus/case.hpp"

namespace graze::corpus {

// A comment says in a sentence why the case is hard; fewer characters say nothing.
inline constexpr std::size_t kShortestComment = 20;

enum class Shelf {
  cases,  // corpus/cases: every flag helps to find the case again, so there is one at least
  known,  // corpus/known_failures.jsonl: a mechanism that is not mended yet, and may have no flag
};

// What is missing, one line each, empty for a sound case: the id is family/name, the comment a sentence, a
// flag is set, and what was reported has its address.
[[nodiscard]] std::vector<std::string> curation_faults(const Case& problem, Shelf shelf);

// The case without what is said about it: its id, family, hardness, comment, source, flags and answer.
// Written in one line; two cases are the same question if these lines are equal.
[[nodiscard]] std::string question_of(const Case& problem);

}  // namespace graze::corpus
