// Tier certified.
#include <graze/certified/cast.hpp>
#include <graze/numeric/flags.hpp>

#include "elsewhere.hpp"

namespace graze::inline GRAZE_LINKAGE {

#define GRAZE_INSTANCES(S) \
  template CastResult<S> cast_certified(const Body<S>&, const Body<S>&, const CastOptions<S>&);

GRAZE_INSTANCES(float)
GRAZE_INSTANCES(double)

}  // namespace graze::inline GRAZE_LINKAGE
