// Distance, penetration, overlap, a line, a swept overlap.
#include <graze/detail/numeric/flags.hpp>
#include <graze/detail/queries/distance_query.hpp>
#include <graze/detail/queries/line_query.hpp>
#include <graze/detail/queries/overlap_query.hpp>
#include <graze/detail/queries/penetration_query.hpp>
#include <graze/detail/queries/swept_overlap_query.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

#define GRAZE_INSTANCES(S)                                                                                 \
  template DistanceResult<S> distance(const Body<S>&, const Body<S>&, const DistanceOptions<S>&);          \
  template Prepared<S>::Prepared(const Body<S>&);                                                          \
  template const Body<S>& Prepared<S>::body() const;                                                       \
  template Invalid Prepared<S>::invalid() const;                                                           \
  template DistanceResult<S> distance(const Prepared<S>&, const Prepared<S>&, const DistanceOptions<S>&);  \
  template OverlapResult<S> overlap_mpr(const Prepared<S>&, const Prepared<S>&, const WarmStart&);         \
  template OverlapResult<S> overlap_gjk(const Prepared<S>&, const Prepared<S>&, const WarmStart&);         \
  template OverlapResult<S> overlap_mpr(const Body<S>&, const Body<S>&, const WarmStart&);                 \
  template OverlapResult<S> overlap_gjk(const Body<S>&, const Body<S>&, const WarmStart&);                 \
  template PenetrationResult<S> penetration(const Body<S>&, const Body<S>&, const PenetrationOptions<S>&); \
  template PenetrationResult<S> penetration(const Prepared<S>&, const Prepared<S>&,                        \
                                            const PenetrationOptions<S>&);                                 \
  template PenetrationResult<S> penetration_along(const Body<S>&, const Body<S>&, const Vec3<S>&,          \
                                                  const PenetrationOptions<S>&);                           \
  template LineResult<S> line(const Body<S>&, const Body<S>&, const LineOptions<S>&);                      \
  template SweptOverlapResult<S> swept_overlap(const Body<S>&, const Body<S>&,                             \
                                               const SweptOverlapOptions<S>&);                             \
  template SweptOverlapResult<S> swept_overlap_before_after(const Body<S>&, const Body<S>&,                \
                                                            SweptOverlapOptions<S>);

GRAZE_INSTANCES(float)
GRAZE_INSTANCES(double)

}}  // namespace graze::GRAZE_LINKAGE
