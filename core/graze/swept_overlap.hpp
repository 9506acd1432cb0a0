/// @file
/// Swept overlap: do two linearly moving bodies touch at any t in [0, t_max]? Only whether, not when.
///
/// The answer is right if clearance or depth exceeds kappa u scale (in the table of guarantees). Touching counts.
//
// Contact at t iff t v in C, so contact at some t iff 0 is in C swept by -v:
//   D = C + segment(0, -t_max v),   h_D(n) = h_C(n) + max(0, -t_max n.v).
// Three ways:
//   gjk           the distance of 0 from D. A support of D is one of C and the choice of the segment's end.
//   mpr           seen along v, D and C project alike: a portal of C holds the line or it does not, and D is
//                 entered before t_max and left after 0 or it is not. That is the MPR sweep without its time.
//   before_after  the lecture's slow version: D as the hull of C at t = 0 and C at t_max. Each support
//                 searches all points of C twice, once where they are before and once where they are after.
//                 Kept as the baseline that the sum is measured against (bench/queries_bench.cpp).
#pragma once

#include <graze/body.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

/// The search of swept_overlap().
enum class SweptMethod : std::uint8_t {
  gjk,           ///< The distance of 0 from C, swept by -v.
  mpr,           ///< The MPR sweep without its time.
  before_after,  ///< Searches the points of both ends of the motion. Slower, kept for comparison.
};
/// The enumerator's name.
[[nodiscard]] constexpr std::string_view to_text(SweptMethod method) {
  switch (method) {
    case SweptMethod::gjk:
      return "gjk";
    case SweptMethod::mpr:
      return "mpr";
    case SweptMethod::before_after:
      return "before_after";
  }
  return {};
}

/// The options of swept_overlap() and swept_overlap_exact(). Options out of range are `invalid_input`.
/// swept_overlap_exact() only checks `max_iterations`.
template <Scalar S>
struct SweptOverlapOptions {
  SweptMethod method = SweptMethod::gjk;  ///< The search. swept_overlap_exact() does not read it.
  S t_max = 1;                            ///< The end of the motion. Infinity makes it a ray.
  S target_distance = 0;                  ///< m, a length: contact is when the distance reaches m.
  int max_iterations = 256;               ///< The largest number of support evaluations.
};

/// The answer of swept_overlap() and swept_overlap_exact().
template <Scalar S>
struct SweptOverlapResult {
  /// hit (contact at some t, 0 included), miss, not_converged, invalid_input.
  Outcome outcome = Outcome::invalid_input;
  Invalid invalid = Invalid::none;  ///< For invalid_input: the reason.
  InvalidAt invalid_at = {};        ///< For invalid_input: the place.
  /// For a miss: unit, from A to B, world axes. It separates the bodies at all t in [0, t_max].
  Vec3<S> normal = Vec3<S>::Zero();
  Counters counters;  ///< The work that was done.
};

/// Do the bodies touch at any t in [0, t_max]? World axes, the caller's units, and t in units of the displacement.
/// Invalid input is the outcome `invalid_input`. Nothing is thrown or allocated.
///
/// By GJK it evaluates the support function 3 to 10 times typically. For polytopes it is cheaper than a cast, and MPR
/// takes 0.7 of GJK's time (costs.md). For spheres, capsules and other curved shapes it saves no time over a cast. MPR
/// may then take 100 evaluations.
///
/// @code
/// const graze::Body<double> sheet{.shape = graze::Box<double>{{1e-4, 5, 5}}, .position = {10, 0, 0}};
/// const graze::Body<double> bullet{.shape = graze::Sphere<double>{0.01}, .displacement = {20, 0, 0}};
/// assert(graze::swept_overlap(sheet, bullet).outcome == graze::Outcome::hit);
/// assert(graze::swept_overlap(sheet, bullet, {.t_max = 0.4}).outcome == graze::Outcome::miss);
/// @endcode
template <Scalar S>
SweptOverlapResult<S> swept_overlap(const Body<S>& a, const Body<S>& b,
                                    const SweptOverlapOptions<S>& options = {});
/// The same by SweptMethod::before_after, whatever method the options name. For hulls of 8 to 512 vertices it takes 1.2
/// to 1.9 times as long as GJK (costs.md).
template <Scalar S>
SweptOverlapResult<S> swept_overlap_before_after(const Body<S>& a, const Body<S>& b,
                                                 SweptOverlapOptions<S> options = {});
/// The same for the true shapes, decided exactly. Only for the shapes of the exact tier (cast.hpp). Others are
/// `invalid_input` (Invalid::not_exact).
///
/// For polytopes it takes about three times as long as swept_overlap(). Spheres, capsules, rounded shapes and a target
/// distance take about as long as a cast if they meet. Otherwise another search allocates memory and takes longer (40 us
/// for two spheres, 200 us for two boxes at a target distance).
///
/// @code
/// const graze::Body<double> wall{.shape = graze::Box<double>{{1, 5, 5}}, .position = {10, 0, 0}};
/// const graze::Body<double> ray{.displacement = {3, 0, 0}};  // it meets the wall at t = 3
/// const graze::SweptOverlapOptions<double> by_mpr{.method = graze::SweptMethod::mpr, .t_max = 2};
/// const graze::SweptOverlapResult<double> r = graze::swept_overlap(wall, ray, by_mpr);
/// assert(r.outcome == graze::Outcome::miss && r.normal[0] < 0);  // from the wall to the ray
/// assert(graze::swept_overlap_before_after(wall, ray, by_mpr).outcome == r.outcome);
///
/// assert(graze::swept_overlap_exact(wall, ray, {.t_max = 3}).outcome == graze::Outcome::hit);  // touching counts
/// assert(graze::swept_overlap_exact(wall, ray, {.t_max = std::nextafter(3.0, 0)}).outcome == graze::Outcome::miss);
/// @endcode
template <Scalar S>
SweptOverlapResult<S> swept_overlap_exact(const Body<S>& a, const Body<S>& b,
                                          const SweptOverlapOptions<S>& options = {});

}}  // namespace graze::GRAZE_LINKAGE

#ifndef GRAZE_COMPILED
#include <graze/detail/queries/exact_queries.hpp>
#include <graze/detail/queries/swept_overlap_query.hpp>
#endif
