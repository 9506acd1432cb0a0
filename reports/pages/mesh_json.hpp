// A mesh in a document: flat arrays, as docs/reference/page-format.md describes them.
#pragma once

#include <nlohmann/json.hpp>

#include "reports/pages/mesh.hpp"

namespace graze::show {

[[nodiscard]] nlohmann::ordered_json mesh_json(const Mesh& mesh);

}  // namespace graze::show
