// graze corpus verify: what the corpus says, derived again.
#pragma once

#include <string>

namespace graze::tool {

// Derives every answer of a directory of cases, on a few threads, and prints every difference, in the order
// of the cases. The built-in corpus, "", is also held to its flags and notes, both ways, to what a curated
// case must have, and to asking no question twice; its known failures are cases as well.
// 0; 1 for a difference; 2 for what cannot be read.
[[nodiscard]] int verify_corpus(const std::string& directory, unsigned threads);

}  // namespace graze::tool
