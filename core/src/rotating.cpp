// Rotating casts.
#include <graze/detail/numeric/flags.hpp>
#include <graze/detail/rotating/rotating_search.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

#define GRAZE_INSTANCES(S)                                                        \
  template RotatingResult<S> cast(const RotatingBody<S>&, const RotatingBody<S>&, \
                                  const RotatingOptions<S>&);                     \
  template Plan plan(const RotatingBody<S>&, const RotatingBody<S>&, const RotatingOptions<S>&);

GRAZE_INSTANCES(float)
GRAZE_INSTANCES(double)

}}  // namespace graze::GRAZE_LINKAGE
