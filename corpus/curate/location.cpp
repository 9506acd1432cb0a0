#include "corpus/curate/location.hpp"

#include <cstdlib>

namespace graze::corpus {

std::filesystem::path corpus_directory() {
  const char* set = std::getenv("GRAZE_CORPUS");
  return set != nullptr && *set != '\0' ? set : GRAZE_CORPUS_DIRECTORY;
}

}  // namespace graze::corpus
