#include "corpus/curate/location.hpp"

#include <cstdlib>
#include <fstream>
#include <string>

#include "engines/system/system.hpp"

namespace graze::corpus {

namespace fs = std::filesystem;

namespace {

bool is_corpus(const fs::path& folder) {
  std::error_code none;
  return fs::is_directory(folder / "cases", none) && fs::exists(folder / "flags.json", none);
}

}  // namespace

// No path of the tree that it was built in is in the program: it may be installed, and moved.
fs::path corpus_directory() {
  if (const char* set = std::getenv("GRAZE_CORPUS"); set != nullptr && *set != '\0') return set;
  const fs::path program = system::program();
  fs::path beside = program.parent_path().parent_path() / "share" / "graze" / "corpus";
  if (is_corpus(beside)) return beside;
  for (fs::path folder = program.parent_path(); !folder.empty(); folder = folder.parent_path()) {
    if (is_corpus(folder / "corpus")) return folder / "corpus";
    if (std::ifstream pointer(folder / kCorpusPointer); pointer) {
      std::string named;
      if (std::getline(pointer, named) && is_corpus(named)) return named;
    }
    if (folder == folder.root_path()) break;
  }
  return beside;
}

}  // namespace graze::corpus
