// Tier certified.
#include <graze/detail/casts/certified_cast.hpp>
#include <graze/detail/numeric/flags.hpp>

#include "elsewhere.hpp"

namespace graze { inline namespace GRAZE_LINKAGE {

#define GRAZE_INSTANCES(S) \
  template CastResult<S> cast_certified(const Body<S>&, const Body<S>&, const CastOptions<S>&);

GRAZE_INSTANCES(float)
GRAZE_INSTANCES(double)

}}  // namespace graze::GRAZE_LINKAGE
