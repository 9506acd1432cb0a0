// A file of laws ends with their table. A table that tables.hpp does not name compiles, but never runs. A law
// that its table does not name is an unused function, which does not compile.
#include "properties/laws/tables.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

namespace graze::law {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

// All matches of the pattern's group.
std::multiset<std::string> found(const std::string& text, const char* pattern) {
  const std::regex wanted(pattern);
  std::multiset<std::string> names;
  for (std::sregex_iterator i(text.begin(), text.end(), wanted), end; i != end; ++i) names.insert((*i)[1]);
  return names;
}

TEST(LawTables, EveryFileOfLawsIsNamed) {
  const fs::path laws = fs::path(GRAZE_SOURCE_DIR) / "properties" / "laws";
  std::multiset<std::string> defined;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(laws)) {
    if (entry.path().extension() != ".cpp" || entry.path().parent_path() == laws) continue;
    const std::multiset<std::string> tables =
        found(text_of(entry.path()), R"(\bstd::vector<Law> (\w+)\(\) \{)");
    defined.insert(tables.begin(), tables.end());
  }
  EXPECT_EQ(found(text_of(laws / "tables.hpp"), R"(&(\w+_laws)\})"), defined);
  EXPECT_EQ(defined.size(), std::size(kLawTables));
}

}  // namespace
}  // namespace graze::law
