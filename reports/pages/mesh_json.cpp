#include "reports/pages/mesh_json.hpp"

namespace graze::show {

nlohmann::ordered_json mesh_json(const Mesh& mesh) {
  using Json = nlohmann::ordered_json;
  Json vertices = Json::array(), triangles = Json::array(), edges = Json::array();
  for (const Vec3<double>& x : mesh.vertices) {
    for (int i = 0; i < 3; ++i) vertices.push_back(x[i]);
  }
  for (const auto& triangle : mesh.triangles) {
    for (const int i : triangle) triangles.push_back(i);
  }
  for (const auto& edge : mesh.edges) {
    for (const int i : edge) edges.push_back(i);
  }
  return {{"curved", mesh.curved}, {"vertices", vertices}, {"triangles", triangles}, {"edges", edges}};
}

}  // namespace graze::show
