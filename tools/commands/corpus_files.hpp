// Files of cases as `graze corpus` edits them: read whole or not at all, replaced in one step, answered by
// the oracles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corpus/format/case_io.hpp"

namespace graze::tool {

// The cases of a file, or nothing if there is an error in it, which is complained about. An id that is taken
// already is one.
[[nodiscard]] std::optional<std::vector<corpus::Case>> read_sound(const std::string& name, corpus::Ids& ids);
[[nodiscard]] std::optional<std::vector<corpus::Case>> read_sound(const std::string& name);

// Writes the canonical form to a new file first, and then replaces the old one, so an interrupted run loses
// nothing. Throws std::runtime_error with a one-line message.
void replace_file(const std::string& name, const std::vector<corpus::Case>& cases);

// The oracle's answer as a case holds it: a miss has no time. Throws what derive_expectation throws.
[[nodiscard]] corpus::Expect expectation(const corpus::Case& problem);

// The same, stored in the case. One that no oracle decides keeps no answer, and the reason is complained
// about.
void fill_in(const std::string& file, corpus::Case& problem);

// Cases that fail by a mechanism that is not fixed yet. The built-in corpus may have none.
[[nodiscard]] std::string known_failures_file();

}  // namespace graze::tool
