// Shapes, hulls and their graphs, and the check of every input.
#include <graze/detail/numeric/flags.hpp>
#include <graze/detail/shapes/hull_data.hpp>
#include <graze/detail/shapes/hull_graph.hpp>
#include <graze/detail/shapes/shape_copies.hpp>
#include <graze/detail/shapes/validation.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

#define GRAZE_INSTANCES(S)                                                                            \
  template class Hull<S>;                                                                             \
  template class Shape<S>;                                                                            \
  template Hull<S> with_adjacency(std::span<const Vec3<S>>);                                          \
  template Hull<S> with_faces(std::span<const Vec3<S>>, std::span<const std::vector<std::uint32_t>>); \
  template Invalid validate(const Body<S>&);                                                          \
  template Invalid validate(const CastOptions<S>&);                                                   \
  template Invalid validate(const Body<S>&, const Body<S>&, const CastOptions<S>&);

GRAZE_INSTANCES(float)
GRAZE_INSTANCES(double)

}}  // namespace graze::GRAZE_LINKAGE
