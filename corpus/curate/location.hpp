// Where the built-in corpus is.
#pragma once

#include <filesystem>

namespace graze::corpus {

// A file of a build folder whose one line is the corpus of the tree that it builds.
inline constexpr const char* kCorpusPointer = "graze_corpus_directory";

// The environment variable GRAZE_CORPUS if it is set; else ../share/graze/corpus beside the program, where it is
// installed; else, for a program of a build folder, the first that is found in the folders above it: corpus/, or what
// kCorpusPointer names. It holds cases/ and flags.json. If there is none, where an installed one would be.
[[nodiscard]] std::filesystem::path corpus_directory();

}  // namespace graze::corpus
