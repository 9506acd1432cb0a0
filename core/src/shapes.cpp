// Shapes, hulls and their graphs, and the check of every input.
#include <graze/numeric/flags.hpp>
#include <graze/support/hull_data.hpp>
#include <graze/support/hull_graph.hpp>
#include <graze/support/shape_copies.hpp>
#include <graze/support/validate.hpp>

namespace graze::inline GRAZE_LINKAGE {

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

}  // namespace graze::inline GRAZE_LINKAGE
