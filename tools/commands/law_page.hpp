// The laws as a list to read, and as docs/reference/laws.md: by what they need, with the planted defects that each is
// known to notice.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "properties/laws/law.hpp"

namespace graze::tool {

// A patch of properties/defects/patches: what is wrong, and the laws that it says notice.
struct PlantedDefect {
  std::string name, what;
  std::vector<std::string> laws;
};

// Reads every .patch in the folder, by name. Throws std::runtime_error with a one-line message if there is no patch or
// one lacks its lines "Defect: ..." and "Law: ...".
[[nodiscard]] std::vector<PlantedDefect> read_defects(const std::filesystem::path& directory);

// Name and sentence, by what the laws need.
[[nodiscard]] std::string law_list(std::span<const law::Law> laws);

// docs/reference/laws.md, whole. Throws std::runtime_error with one line to show for a defect that names no law.
[[nodiscard]] std::string law_page(std::span<const law::Law> laws, std::span<const PlantedDefect> defects);

}  // namespace graze::tool
