// graze corpus verify: derives the corpus's expected answers again.
#pragma once

#include <string>

namespace graze::tool {

// Derives every answer of a directory of cases on a few threads, and prints every difference in the order of
// the cases. The built-in corpus, "", has further checks: its flags and notes must match both ways, its cases
// must have what a curated case needs, and no two may ask the same question. Its known failures are also
// cases. Returns 0, 1 for a difference, or 2 for files that cannot be read.
[[nodiscard]] int verify_corpus(const std::string& directory, unsigned threads);

}  // namespace graze::tool
