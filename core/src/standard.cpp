// Tier standard, and the choice of a tier.
#include <graze/detail/casts/standard_cast.hpp>
#include <graze/detail/numeric/flags.hpp>

#include "elsewhere.hpp"

namespace graze { inline namespace GRAZE_LINKAGE {

#define GRAZE_INSTANCES(S)                                                                    \
  template CastResult<S> cast(const Body<S>&, const Body<S>&, const CastOptions<S>&);         \
  template CastResult<S> cast_conservative_advancement(const Body<S>&, const Body<S>&,        \
                                                       const CastOptions<S>&);                \
  template CastResult<S> cast_gjk_ray(const Body<S>&, const Body<S>&, const CastOptions<S>&); \
  template CastResult<S> cast_mpr_sweep(const Body<S>&, const Body<S>&, const CastOptions<S>&);

GRAZE_INSTANCES(float)
GRAZE_INSTANCES(double)

}}  // namespace graze::GRAZE_LINKAGE
