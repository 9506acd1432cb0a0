#include "corpus/curate/location.hpp"

#include <cstdlib>

namespace graze::corpus {

std::filesystem::path corpus_directory() {
  if (const char* set = std::getenv("GRAZE_CORPUS"); set != nullptr && *set != '\0') return set;
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
  if (!none) {
    std::filesystem::path beside = program.parent_path().parent_path() / "share" / "graze" / "corpus";
    if (std::filesystem::is_directory(beside / "cases", none)) return beside;
  }
  return GRAZE_CORPUS_DIRECTORY;
}

}  // namespace graze::corpus
