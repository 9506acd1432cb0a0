// Penetration.
#include <graze/numeric/flags.hpp>
#include <graze/queries/penetration.hpp>

namespace graze::inline GRAZE_LINKAGE {

#define GRAZE_INSTANCES(S)                                                                                 \
  template PenetrationResult<S> penetration(const Body<S>&, const Body<S>&, const PenetrationOptions<S>&); \
  template PenetrationResult<S> penetration(const Prepared<S>&, const Prepared<S>&,                        \
                                            const PenetrationOptions<S>&);                                 \
  template PenetrationResult<S> penetration_along(const Body<S>&, const Body<S>&, const Vec3<S>&,          \
                                                  const PenetrationOptions<S>&);

GRAZE_INSTANCES(float)
GRAZE_INSTANCES(double)

}  // namespace graze::inline GRAZE_LINKAGE
