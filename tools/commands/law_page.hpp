// The laws as a list, and as docs/reference/laws.md: by their requirements, with the planted defects that each is known
// to detect.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "properties/laws/law.hpp"

namespace graze::tool {

// A patch of properties/defects/patches: the defect, and the laws that detect it according to the patch.
struct PlantedDefect {
  std::string name, what;
  std::vector<std::string> laws;
};

// Reads every .patch in the folder, by name. Throws std::runtime_error with a one-line message if there is no patch or
// one lacks its lines "Defect: ..." and "Law: ...".
[[nodiscard]] std::vector<PlantedDefect> read_defects(const std::filesystem::path& directory);

// Name and sentence of each law, by the laws' requirements.
[[nodiscard]] std::string law_list(std::span<const law::Law> laws);

// docs/reference/laws.md, whole. Throws std::runtime_error with one line to show for a defect that names no law.
[[nodiscard]] std::string law_page(std::span<const law::Law> laws, std::span<const PlantedDefect> defects);

}  // namespace graze::tool
