// Tier exact: casts, and the queries that it answers.
#include <graze/detail/casts/ladder.hpp>
#include <graze/detail/numeric/flags.hpp>
#include <graze/detail/queries/exact_queries.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

#define GRAZE_INSTANCES(S)                                                                                 \
  template bool detail::exact_walk(const Body<S>&, const Body<S>&, const CastOptions<S>&, CastResult<S>&); \
                                                                                                           \
  template CastResult<S> cast_exact(const Body<S>&, const Body<S>&, const CastOptions<S>&);                \
  template OverlapResult<S> overlap_exact(const Body<S>&, const Body<S>&);                                 \
  template DistanceResult<S> distance_exact(const Body<S>&, const Body<S>&, const DistanceOptions<S>&);    \
  template LineResult<S> line_exact(const Body<S>&, const Body<S>&, const LineOptions<S>&);                \
  template SweptOverlapResult<S> swept_overlap_exact(const Body<S>&, const Body<S>&,                       \
                                                     const SweptOverlapOptions<S>&);

GRAZE_INSTANCES(float)
GRAZE_INSTANCES(double)

}}  // namespace graze::GRAZE_LINKAGE
