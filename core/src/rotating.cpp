// Rotating casts.
#include <graze/numeric/flags.hpp>
#include <graze/rotating/cast.hpp>

namespace graze::inline GRAZE_LINKAGE {

#define GRAZE_INSTANCES(S)                                                        \
  template RotatingResult<S> cast(const RotatingBody<S>&, const RotatingBody<S>&, \
                                  const RotatingOptions<S>&);                     \
  template Plan plan(const RotatingBody<S>&, const RotatingBody<S>&, const RotatingOptions<S>&);

GRAZE_INSTANCES(float)
GRAZE_INSTANCES(double)

}  // namespace graze::inline GRAZE_LINKAGE
