// The location of the built-in corpus.
#pragma once

#include <filesystem>

namespace graze::corpus {

// A file of a build folder whose one line is the corpus of the tree that it builds.
inline constexpr const char* kCorpusPointer = "graze_corpus_directory";

// Returns the folder that holds cases/ and flags.json. The search order is:
//   1. the environment variable GRAZE_CORPUS, if it is set,
//   2. ../share/graze/corpus beside the program, the place of an installed corpus,
//   3. for a program of a build folder, the first match in the folders above it: corpus/, or the folder that
//      kCorpusPointer names.
// If nothing is found, the result is the place of an installed corpus.
[[nodiscard]] std::filesystem::path corpus_directory();

}  // namespace graze::corpus
