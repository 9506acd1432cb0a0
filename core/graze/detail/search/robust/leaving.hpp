// Does a motion that starts in contact leave, or slide, as it begins?
//
// It does iff n.v >= 0 for some n != 0 with h(n) <= 0, h of C without the target distance: C is convex, so
// such a motion never makes contact anew. Equivalently, the ray {s r : s >= 0} does not go into C. There are three
// tests, each up to the noise of contact (sweep.hpp):
//   - The line misses C.
//   - The line leaves C at s = 0 or before.
//   - The line runs along C's silhouette: seen along r, the origin lies on the border of C's projection.
// The last is decided in the plane across r. A polygon inside the projection is expanded, edge by edge from the one
// nearest to the origin. It ends when a support line passes within the noise of the origin, or no edge does (EPA of
// van den Bergen 2001, one dimension lower).
#pragma once

#include <graze/detail/search/robust/sweep.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

enum class Start { enters, leaves, open };  // leaves includes slides, open: budget ended before a decision

// The limit of the polygon's corners, more than a silhouette needs to pass the noise (2^-53 is 26 halvings of an
// arc).
inline constexpr std::size_t kSilhouetteCorners = 64;

template <Scalar S>
bool on_silhouette(const PortalView<S>& view, S noise) {
  std::array<Vec3<S>, kSilhouetteCorners> corner;
  std::size_t size = 0;
  for (const auto& [x, y] : {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)}) {
    corner[size++] = view.support(Vec3<S>(S(x), S(y), 0)).q;
  }
  while (true) {
    std::size_t nearest = 0;
    S least = kInfinity<S>;
    Vec3<S> n_least = Vec3<S>::Zero();
    for (std::size_t i = 0; i < size; ++i) {
      const Vec3<S>&a = corner[i], &b = corner[(i + 1) % size];
      const Vec3<S> n = unit(Vec3<S>(b[1] - a[1], a[0] - b[0], 0));
      const S from_origin = dot(n, a);
      if (from_origin < least && n != Vec3<S>::Zero()) {
        least = from_origin;
        nearest = i;
        n_least = n;
      }
    }
    if (least == kInfinity<S>) return true;  // the projection is a point
    if (!(least <= noise)) return false;
    const PortalPoint<S> w = view.support(n_least);
    const S reach = dot(n_least, w.q);
    if (reach <= noise) return true;
    // No farther than the edge: it is C's border there, and beyond the noise it is not.
    if (!(reach > least) || size == kSilhouetteCorners) return false;
    for (std::size_t i = size; i > nearest + 1; --i) corner[i] = corner[i - 1];
    corner[nearest + 1] = w.q;
    ++size;
  }
}

// cso: without the target distance. Contact at s = 0 was found, for the CSO with it. Without motion the question is
// whether the origin lies on C's border. Any direction answers it, and the one away from the middle is best.
template <Scalar S>
Start start_of(const Cso<S>& cso, const SweepLimits<S>& limits, Counters& counters) {
  using State = typename PortalSearch<S>::State;
  const Vec3<S> outward =
      cso.middle() == Vec3<S>::Zero() ? Vec3<S>(Vec3<S>::UnitZ()) : Vec3<S>(-cso.middle());
  const Frame<S> frame(cso.moves() ? cso.direction() : outward);
  // Seen from behind, the exit is the entry of the mirrored line, at -z. Corners and edges that lie one beneath
  // the other, nearer to the line than rounding can tell, may make the refinement cycle (seen with coordinates
  // of magnitudes far apart, and with discs in one plane). Then C is moved aside by 6 u scale, and the search begins
  // again.
  PortalView<S> view{cso, frame, S(-1), counters};
  PortalSearch<S> exit;
  for (const auto& [x, y] :
       {std::pair(0, 0), std::pair(1, 1), std::pair(-1, 1), std::pair(-1, -1), std::pair(1, -1)}) {
    view.aside_x = S(x) * limits.fine();
    view.aside_y = S(y) * limits.fine();
    exit = find_portal(view, limits.budget / 2);
    if (exit.state == State::missed) return Start::leaves;
    if (exit.state == State::entered) {
      refine_portal(view, exit, PortalLimits<S>{-limits.noise, -limits.noise, limits.noise / 2},
                    limits.budget / 2);
    }
    if (exit.state != State::exhausted) break;
  }
  if (exit.state == State::exhausted) return Start::open;
  if (exit.state != State::accepted) return Start::leaves;
  return on_silhouette(view, limits.noise) ? Start::leaves : Start::enters;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
