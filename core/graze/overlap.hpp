/// @file
/// Overlap: do two bodies touch at t = 0? By MPR, by GJK, or exactly. Touching counts.
///
/// The answer is right if distance or penetration exceeds kappa u scale (in the table of guarantees).
#pragma once

#include <graze/body.hpp>
#include <graze/prepared.hpp>
#include <graze/result.hpp>
#include <graze/warm_start.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The answer of an overlap query.
template <Scalar S>
struct OverlapResult {
  Outcome outcome = Outcome::invalid_input;  ///< initially_overlapping, miss, not_converged or invalid_input.
  Invalid invalid = Invalid::none;           ///< For invalid_input: the reason.
  InvalidAt invalid_at = {};                 ///< For invalid_input: the place.
  Vec3<S> normal = Vec3<S>::Zero();  ///< For a miss: unit, from A to B, world axes. It separates the bodies.
  /// For the next query about the pair, by MPR or GJK. It is empty if there is nothing to keep.
  WarmStart warm;
  Counters counters;  ///< The work that was done.
};

/// Do the bodies touch at t = 0? By MPR, the fastest for polytopes: does the ray from an interior point of C = A - B
/// through the origin leave C beyond the origin?
///
/// World axes, the caller's units. Motion is ignored. Invalid input is the outcome `invalid_input`. Nothing is thrown
/// or allocated. It evaluates the support function 3 to 12 times typically. `start` is the `warm` of an earlier answer
/// about the pair.
///
/// @code
/// const graze::Body<double> box{.shape = graze::Box<double>{{1, 1, 1}}};
/// const graze::Body<double> touching{.shape = graze::Box<double>{{1, 1, 1}}, .position = {2, 0, 0}};
/// const graze::Body<double> apart{.shape = graze::Sphere<double>{1}, .position = {3, 0, 0}};
/// assert(graze::overlap_exact(box, touching).outcome == graze::Outcome::initially_overlapping);
/// const graze::OverlapResult<double> r = graze::overlap_mpr(box, apart);
/// assert(r.outcome == graze::Outcome::miss && r.normal[0] > 0);
/// @endcode
template <Scalar S>
OverlapResult<S> overlap_mpr(const Body<S>& a, const Body<S>& b, const WarmStart& start = {});
/// The same for prepared bodies, which saves preparing them again.
template <Scalar S>
OverlapResult<S> overlap_mpr(const Prepared<S>& a, const Prepared<S>& b, const WarmStart& start = {});
/// The same by GJK: is the distance zero? The warm start of distance() serves here too. It is faster than MPR for
/// spheres, capsules and rounded shapes. It evaluates the support function 1 to 8 times typically, and up to 40 times
/// for cones.
///
/// @code
/// const graze::Body<double> capsule{.shape = graze::Capsule<double>{0.5, 1}};
/// graze::Body<double> ball{.shape = graze::Sphere<double>{0.5}, .position = {1.2, 0, 0}};
/// const graze::OverlapResult<double> before = graze::overlap_gjk(capsule, ball);
/// assert(before.outcome == graze::Outcome::miss && before.normal[0] > 0.99);
///
/// ball.position[0] = 0.9;  // the next step begins where the last one ended
/// const graze::OverlapResult<double> after = graze::overlap_gjk(capsule, ball, before.warm);
/// assert(after.outcome == graze::Outcome::initially_overlapping);
/// @endcode
template <Scalar S>
OverlapResult<S> overlap_gjk(const Body<S>& a, const Body<S>& b, const WarmStart& start = {});
/// The same for prepared bodies, which saves preparing them again.
template <Scalar S>
OverlapResult<S> overlap_gjk(const Prepared<S>& a, const Prepared<S>& b, const WarmStart& start = {});
/// The same for the true shapes, decided exactly. Only for the shapes of the exact tier (cast.hpp). Others are
/// `invalid_input` (Invalid::not_exact).
///
/// For polytopes it takes about twice as long as overlap_mpr(). Spheres, capsules and rounded shapes take another
/// search, which allocates memory and takes longer (5 us for two spheres, 35 us for two rounded boxes).
template <Scalar S>
OverlapResult<S> overlap_exact(const Body<S>& a, const Body<S>& b);

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/queries/exact_queries.hpp>
#include <graze/detail/queries/overlap_query.hpp>
#endif
