// Where the built-in corpus is.
#pragma once

#include <filesystem>

namespace graze::corpus {

// The environment variable GRAZE_CORPUS if it is set; else ../share/graze/corpus beside the program, where it is
// installed; else corpus/ in the source tree of this build. It holds cases/ and flags.json.
[[nodiscard]] std::filesystem::path corpus_directory();

}  // namespace graze::corpus
