// Computes where a line enters C: Minkowski portal refinement along a direction, in the plane across it.
//
//   z_in = min z over {c in C : c projects to the origin},   C rounded by its radius.   Frame: frame.hpp.
//
// Notation
//   q        (x, y, z), a support point in the frame
//   portal   up to three of them, whose projections hold the origin in their hull
//   lambda   their weights
//   n        the portal's normal, n_z < 0
// A portal bounds from above, z_in <= sum lambda z. Its normal bounds from below, z_in >= h(n) / n_z. [Snethen 2008]
// Discovery is the same question in the plane: GJK in two dimensions. A support that stays on its own side of the
// origin proves that the line misses, with n_z = 0. Differs: lines instead of rays, so no point of C's inside is
// needed to start from. A flat projection (a flat C seen edge on, a segment, a point) has portals of two points or of
// one.
//
// Rounding: every decision is the sign of a cross product of projected points, which are small if the decision is
// close. A wrong sign moves the answer by a few u scale, not by u scale^2 / |edge|.
#pragma once

#include <algorithm>

#include <graze/detail/pairs/cso.hpp>
#include <graze/detail/search/robust/line_frame.hpp>
#include <graze/result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
struct PortalPoint {
  CsoPoint<S> c;
  Vec3<S> q = Vec3<S>::Zero();
};

template <Scalar S>
struct Portal {
  int size = 0;  // 1: the line meets a vertex, 2: an edge of a flat C, 3: a triangle, x-y counter-clockwise
  std::array<PortalPoint<S>, 3> p;
};

template <Scalar S>
struct PortalSearch {
  enum class State : std::uint8_t { entered, missed, accepted, rejected, exhausted };
  State state = State::exhausted;
  Portal<S> portal;
  std::array<S, 3> lambda{};
  S lower = -kInfinity<S>, upper = kInfinity<S>;  // of z_in
  Vec3<S> n = Vec3<S>::Zero();       // world axes, unit: the normal that proves lower, or the miss
  Vec3<S> facing = Vec3<S>::Zero();  // entered: the last portal's own normal, which supports C within the gap
};

template <Scalar S>
S cross2(const Vec3<S>& a, const Vec3<S>& b) {
  return fl(a[0] * b[1]) - fl(a[1] * b[0]);
}

// Support along n given in the frame. `mirror` = -1 looks at C from behind: z becomes -z, so that the exit of
// the line is the entry of the mirrored one.
template <Scalar S>
struct PortalView {
  const Cso<S>& cso;
  const Frame<S>& frame;
  S mirror;
  Counters& counters;
  // C is seen moved by so much across the line: by no more than rounding, where a search finds no way past a
  // tie.
  S aside_x = 0, aside_y = 0;

  // A typical rounding error of a projected support point: 4 u of the lengths in it.
  [[nodiscard]] S noise() const { return 4 * kUnitRoundoff<S> * (cso.scale() + cso.radius()); }
  [[nodiscard]] Vec3<S> world(const Vec3<S>& n) const {
    return frame.to_world(Vec3<S>(n[0], n[1], mirror * n[2]));
  }
  [[nodiscard]] PortalPoint<S> support(const Vec3<S>& n) const {
    ++counters.supports;
    PortalPoint<S> out;
    // A polytope's support point does not depend on the length, while products stay within range.
    const Vec3<S> along = world(n);
    const S size = along.cwiseAbs().maxCoeff();
    const bool plain = !cso.curved() && !(cso.radius() > 0) && size > S(0x1p-60) && size < S(0x1p60);
    out.c = plain ? cso.support(along) : cso.rounded_support(unit(along));
    out.q = frame.to_frame(out.c.w);
    out.q[0] += aside_x;
    out.q[1] += aside_y;
    out.q[2] *= mirror;
    // Far below what rounding makes of it a coordinate is 0: products of two such would vanish, and a sign
    // with them.
    for (int i = 0; i < 2; ++i) {
      if (std::abs(out.q[i]) < kUnitRoundoff<S> * noise()) out.q[i] = 0;
    }
    return out;
  }
};

// The point at which the line passes the edge a b, seen along it: the weight of b, within the edge, or 0 if it has no
// length across.
template <Scalar S>
S weight_along(const Vec3<S>& a, const Vec3<S>& b) {
  const S ex = b[0] - a[0], ey = b[1] - a[1], length_sq = fl(ex * ex) + fl(ey * ey);
  if (!(length_sq > 0)) return 0;
  return std::min(std::max(-(fl(a[0] * ex) + fl(a[1] * ey)) / length_sq, S(0)), S(1));
}

// The corner with the most negative weight, if the origin lies beyond the edge opposite to it, or 3 if it lies
// inside.
template <Scalar S>
std::size_t corner_beyond(const Portal<S>& portal) {
  const auto& p = portal.p;
  std::size_t out = 3;
  S worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const S l = cross2(p[(i + 1) % 3].q, p[(i + 2) % 3].q);
    if (l < worst) {
      worst = l;
      out = i;
    }
  }
  return out;
}

// |(x, y)|, of internal lengths: 0, or no smaller than the least ratio of two lengths within range, 1e-120,
// so that no square vanishes in double.
template <Scalar S>
S length_across(S x, S y) {
  const double a = static_cast<double>(x), b = static_cast<double>(y);
  return static_cast<S>(square_root(fl(a * a) + fl(b * b)));
}

// sum lambda q: the portal's own point.
template <Scalar S>
Vec3<S> portal_point(const Portal<S>& portal, const std::array<S, 3>& lambda) {
  Vec3<S> out = lambda[0] * portal.p[0].q;
  for (std::size_t i = 1; i < static_cast<std::size_t>(portal.size); ++i) out += lambda[i] * portal.p[i].q;
  return out;
}

// The weights of the origin in the portal's projection, all >= 0. A triangle has the weights of its areas, or those
// on one of its edges, whichever come nearer to the line. On a sliver, or if the line passes beside it by rounding,
// an edge's are the better known.
template <Scalar S>
std::array<S, 3> portal_weights(const Portal<S>& portal) {
  const auto& p = portal.p;
  std::array<S, 3> l{1, 0, 0};
  if (portal.size == 2) {
    l[1] = weight_along(p[0].q, p[1].q);
    l[0] = 1 - l[1];
  }
  if (portal.size < 3) return l;
  const auto off = [&](const std::array<S, 3>& lambda) {
    const Vec3<S> rho = portal_point(portal, lambda);
    return length_across(rho[0], rho[1]);
  };
  S area = 0, nearest = kInfinity<S>;
  std::array<S, 3> inner;
  for (std::size_t i = 0; i < 3; ++i) {
    inner[i] = std::max(cross2(p[(i + 1) % 3].q, p[(i + 2) % 3].q), S(0));
    area += inner[i];
  }
  if (area > 0) {
    for (S& weight : inner) weight /= area;
    // Twice: take back the combination's distance from the line, and what the sum lacks of 1, from the
    // largest.
    const std::size_t largest =
        static_cast<std::size_t>(std::max_element(inner.begin(), inner.end()) - inner.begin());
    for (int round = 0; round < 2; ++round) {
      const Vec3<S> rho = portal_point(portal, inner);
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3<S> e = p[(i + 2) % 3].q - p[(i + 1) % 3].q;
        inner[i] = std::max(inner[i] - cross2(e, rho) / area, S(0));
      }
      inner[largest] = std::max(1 - inner[(largest + 1) % 3] - inner[(largest + 2) % 3], S(0));
    }
    l = inner;
    nearest = off(l);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    std::array<S, 3> edge{};
    edge[k] = weight_along(p[j].q, p[k].q);
    edge[j] = 1 - edge[k];
    if (const S distance = off(edge); distance < nearest) {
      nearest = distance;
      l = edge;
    }
  }
  return l;
}

// Is the projected triangle higher above its longest edge than rounding alone could make it? If not, it is
// seen edge on: the sign of its n_z is not known.
template <Scalar S>
bool has_area(const PortalPoint<S>& a, const PortalPoint<S>& b, const PortalPoint<S>& c, S rounding) {
  const Vec3<S> e = b.q - a.q, f = c.q - a.q, g = c.q - b.q;
  const S longest_sq = std::max({squared_norm(e.template head<2>()), squared_norm(f.template head<2>()),
                                 squared_norm(g.template head<2>())});
  return std::abs(cross2(e, f)) > rounding * square_root(longest_sq);
}

// Unit, n_z <= 0.
template <Scalar S>
Vec3<S> portal_normal(const Portal<S>& portal) {
  const auto& p = portal.p;
  Vec3<S> n(0, 0, -1);
  const Vec3<S> e = p[1].q - p[0].q;
  if (portal.size == 3) {
    n = -face_normal(p[0].q, p[1].q, p[2].q);
  } else if (portal.size == 2) {
    // In the plane of the edge and the line.
    const S across = square_root(fl(e[0] * e[0]) + fl(e[1] * e[1]));
    if (across > 0) n = Vec3<S>(e[0] * e[2] / across, e[1] * e[2] / across, -across);
  }
  return unit(n);
}

// z of the point at which the line meets the portal. It lies on the portal's plane, computed from the corner nearest
// to the line, and never beyond the corners. On a sliver the weights are the rounding of small areas, but the plane
// is not. A line that passes beside the triangle, if only by rounding, meets the edge that it passes: a steep plane
// would carry it off.
template <Scalar S>
S portal_height(const Portal<S>& portal, const Vec3<S>& n) {
  const auto& p = portal.p;
  if (portal.size == 1) return p[0].q[2];
  std::size_t j = 0, k = 1;
  if (portal.size == 3) {
    const std::size_t beyond = corner_beyond(portal);
    if (beyond == 3) {
      std::size_t nearest = 0;
      S least = kInfinity<S>, low = kInfinity<S>, high = -kInfinity<S>;
      for (std::size_t i = 0; i < 3; ++i) {
        low = std::min(low, p[i].q[2]);
        high = std::max(high, p[i].q[2]);
        const S dist_sq = squared_norm(p[i].q.template head<2>());
        if (dist_sq < least) {
          least = dist_sq;
          nearest = i;
        }
      }
      const Vec3<S>& q = p[nearest].q;
      return std::min(std::max(q[2] + (fl(n[0] * q[0]) + fl(n[1] * q[1])) / n[2], low), high);
    }
    j = (beyond + 1) % 3;
    k = (beyond + 2) % 3;
  }
  return p[j].q[2] + fl(weight_along(p[j].q, p[k].q) * (p[k].q[2] - p[j].q[2]));
}

// The distance of the origin from the projected triangle a b c, counter-clockwise, or 0 inside. Beyond the tip of a
// sliver the lines of its edges pass the origin closer than rounding can tell, so signs alone may put it inside.
// Within `noise` of a line the distance of the nearest edge therefore decides.
template <Scalar S>
S outside(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c, S noise) {
  S nearest = kInfinity<S>;
  bool inside = true;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
    const S ex = (*to)[0] - (*from)[0], ey = (*to)[1] - (*from)[1], along = weight_along(*from, *to);
    inside = inside && cross2(*from, *to) > noise * length_across(ex, ey);
    nearest = std::min(nearest, length_across((*from)[0] + fl(along * ex), (*from)[1] + fl(along * ey)));
  }
  return inside ? S(0) : nearest;
}

// A corner of the portal on the line, and the side of it on which the line passes: see replace_corner().
template <Scalar S>
struct PassedCorner {
  Vec3<S> q = Vec3<S>::Constant(kInfinity<S>);
  Vec3<S> towards = Vec3<S>::Zero();  // across the line
};

// The portal with w as a corner: of the three triangles that w makes with the portal's edges, the one that
// holds the origin. If rounding finds it in two or three of them (on a common side, as is usual on lattices) the
// largest is taken, since the others may have no area. `noise` bounds the rounding error of a projected coordinate.
//
// If the line passes a corner within rounding, 2 `noise`, both triangles with that corner hold it. The largest would
// not do here: where the corner lies beneath a curved surface, the other two corners orbit around it. So the line counts
// as moved off that corner by an infinitesimal length in a direction between the other two (a symbolic perturbation:
// Edelsbrunner and Muecke 1990). Only one of the two triangles holds that line, and its height there decreases in every
// step. `passed` keeps the direction for as long as the corner stays.
template <Scalar S>
void replace_corner(Portal<S>& portal, const PortalPoint<S>& w, S noise, PassedCorner<S>& passed) {
  GRAZE_ASSERT(portal.size == 3);
  auto& p = portal.p;
  std::array<S, 3> off, area;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<S>&b = p[(i + 1) % 3].q, &c = p[(i + 2) % 3].q;
    off[i] = outside(w.q, b, c, noise / 8);
    area[i] = cross2(Vec3<S>(b - w.q), Vec3<S>(c - w.q));
  }
  const S least = std::min({off[0], off[1], off[2]});
  std::size_t out = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (off[i] <= least + noise / 2 && (out == 3 || area[i] > area[out])) out = i;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<S> at = p[i].q;
    if (!(length_across(at[0], at[1]) <= 2 * noise)) continue;
    const std::size_t right = (i + 1) % 3, left = (i + 2) % 3;
    if (off[i] == 0) {
      out = i;
      break;
    }
    if (passed.q != at) {
      const Vec3<S> to_right = p[right].q - at, to_left = p[left].q - at;
      const S r = length_across(to_right[0], to_right[1]), l = length_across(to_left[0], to_left[1]);
      if (!(r > 0 && l > 0)) break;
      passed = {at, to_right / r + to_left / l};
    }
    const std::size_t moved = cross2(passed.towards, Vec3<S>(w.q - at)) > 0 ? left : right;
    if (has_area(p[i], p[moved == left ? right : left], w, noise)) out = moved;
    break;
  }
  if (out < 3) p[out] = w;
}

// Replaces a triangle that is seen edge on by one of its edges. Candidates have the origin between their ends and
// pass it nearest, up to the height that such a triangle may have (`height_lost`). The edge of these that the line
// meets first is taken. So the height of the portal never rises, and the refinement does not cycle between two
// portals. It does not suffice that the origin is between the ends: this also holds for the long edge of a thin
// triangle, which may pass far away. `grown`: the last corner has just been found beyond the edge of the other two.
// An edge beside the new corner is kept only if no edge to that corner is a candidate, since otherwise the same
// corner would be found again for ever. This happens near an end of the edge, where heights agree as rounded. It also
// happens beneath an end, beside the line by less than rounding and far lower.
template <Scalar S>
void flatten(Portal<S>& portal, S height_lost, bool grown) {
  GRAZE_ASSERT(portal.size == (grown ? 2 : 3));
  std::array<S, 3> off, height;
  std::array<bool, 3> between;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<S>&a = portal.p[(i + 1) % 3].q, &b = portal.p[(i + 2) % 3].q;
    const S ex = b[0] - a[0], ey = b[1] - a[1];
    const S from_a = -(fl(a[0] * ex) + fl(a[1] * ey)), from_b = fl(b[0] * ex) + fl(b[1] * ey);
    between[i] = from_a >= 0 && from_b >= 0 && from_a + from_b > 0;
    const S along = weight_along(a, b);
    off[i] = length_across(a[0] + fl(along * ex), a[1] + fl(along * ey));
    height[i] = a[2] + fl(along * (b[2] - a[2]));
  }
  const S least = std::min({off[0], off[1], off[2]});
  std::size_t best = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (grown && i == 2 && best < 3) break;
    if (between[i] && off[i] <= least + height_lost && (best == 3 || height[i] < height[best])) best = i;
  }
  if (best == 3) best = static_cast<std::size_t>(std::min_element(off.begin(), off.end()) - off.begin());
  if (grown && best == 2) {
    // An edge to that corner may end at the origin within rounding.
    for (std::size_t i = 0; i < 2; ++i) {
      if (off[i] <= least + height_lost && height[i] < height[best]) best = i;
    }
  }
  portal.p = {portal.p[(best + 1) % 3], portal.p[(best + 2) % 3], portal.p[best]};
  portal.size = 2;
}

// Finds a portal, or that the line misses C (state missed, n across the line, n.c < 0 on all of C).
template <Scalar S>
PortalSearch<S> find_portal(const PortalView<S>& view, int budget) {
  using namespace detail;
  using State = typename PortalSearch<S>::State;
  PortalSearch<S> out;
  auto& p = out.portal.p;
  const auto missed = [&](const Vec3<S>& n) {
    out.state = State::missed;
    out.n = unit(view.world(n));
    return out;
  };
  const auto found = [&](int size) {
    out.state = State::entered;
    out.portal.size = size;
    if (size == 3 && cross2(Vec3<S>(p[1].q - p[0].q), Vec3<S>(p[2].q - p[0].q)) < 0) std::swap(p[1], p[2]);
    return out;
  };

  p[0] = view.support(Vec3<S>(0, 0, -1));
  Vec3<S> n(-p[0].q[0], -p[0].q[1], 0);
  if (n == Vec3<S>::Zero()) return found(1);  // the foremost point itself, on the line
  p[1] = view.support(n);
  if (dot(n, p[1].q) < 0) return missed(n);

  while (budget-- > 0) {
    ++view.counters.portal_steps;
    const Vec3<S> e = p[1].q - p[0].q;
    const S side = cross2(p[0].q, p[1].q);  // > 0: the origin is on the left of the edge
    n = side >= 0 ? Vec3<S>(-e[1], e[0], 0) : Vec3<S>(e[1], -e[0], 0);
    const S inner = fl(p[0].q[0] * p[1].q[0]) + fl(p[0].q[1] * p[1].q[1]);
    if (side == 0 && (inner > 0 || n == Vec3<S>::Zero())) {
      // The origin on the edge's own line, beyond its nearer end: reach past that end.
      if (squared_norm(p[1].q.template head<2>()) < squared_norm(p[0].q.template head<2>()))
        std::swap(p[0], p[1]);
      n = Vec3<S>(-p[0].q[0], -p[0].q[1], 0);
      if (n == Vec3<S>::Zero()) return found(1);
      p[1] = view.support(n);
      if (dot(n, p[1].q) < 0) return missed(n);
      continue;
    }
    p[2] = view.support(n);
    if (dot(n, p[2].q) < 0) return missed(n);
    if (side == 0 || p[2].c.same_feature(p[0].c) || p[2].c.same_feature(p[1].c)) {
      // The origin is on the edge itself within rounding, so either half-plane will do.
      if (dot(n, Vec3<S>(p[2].q - p[0].q)) > 0) return found(3);
      const PortalPoint<S> other = view.support(-n);
      if (!(dot(n, other.q) < 0)) return found(2);
      p[2] = other;
      return found(3);
    }
    // Counter-clockwise, p0 -> p1 seen from the origin's side. Outside by less than rounding is inside, or
    // two triangles beside a silhouette that runs through the origin would hand it to each other for ever.
    const S turn = side >= 0 ? S(1) : S(-1);
    const S right = turn * cross2(p[2].q, p[0].q), left = turn * cross2(p[1].q, p[2].q);
    const S noise = view.noise();
    const auto across = [](const PortalPoint<S>& x, const PortalPoint<S>& y) {
      return length_across(y.q[0] - x.q[0], y.q[1] - x.q[1]);
    };
    if (right >= -noise * across(p[0], p[2]) && left >= -noise * across(p[1], p[2])) return found(3);
    if (right < left) {
      p[1] = p[2];
    } else {
      p[0] = p[2];
    }
  }
  return out;
}

// Limits at which a refinement may stop, in z of the view.
template <Scalar S>
struct PortalLimits {
  S accept_at;      // upper <= accept_at: accepted
  S reject_beyond;  // lower > reject_beyond: rejected
  S gap;            // the normal's plane is this near the portal, and the bracket as narrow: entered
  // A caller's tolerance: the gap where it moves no verdict. The line passes inside of the portal, and the bracket holds
  // neither `decided_at` nor `reject_beyond`, each by more than rounding.
  S loose_gap = 0, decided_at = -kInfinity<S>;
};

// See PortalLimits::loose_gap.
template <Scalar S>
[[nodiscard]] bool is_decided(const PortalSearch<S>& search, const PortalLimits<S>& limits, S noise) {
  if (!(limits.loose_gap > limits.gap) || search.portal.size != 3) return false;
  if (!(search.upper - search.lower <= 2 * limits.loose_gap)) return false;
  const S near = 2 * limits.gap;  // what the caller takes for rounding
  const bool beyond = search.lower > limits.decided_at + 2 * near,
             before = search.upper + 2 * near < limits.decided_at;
  if (!((beyond || before) && search.upper + near < limits.reject_beyond)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<S>&from = search.portal.p[i].q, &to = search.portal.p[(i + 1) % 3].q;
    if (!(cross2(from, to) > 2 * noise * length_across(to[0] - from[0], to[1] - from[1]))) return false;
  }
  return true;
}

// Moves the portal to the surface of C. Takes the state `entered` of find_portal.
template <Scalar S>
void refine_portal(const PortalView<S>& view, PortalSearch<S>& search, const PortalLimits<S>& limits,
                   int budget) {
  using namespace detail;
  using State = typename PortalSearch<S>::State;
  auto& p = search.portal.p;
  int& size = search.portal.size;
  const S noise = view.noise();
  PassedCorner<S> passed;
  GRAZE_ASSERT(search.state == State::entered && size >= 1 && size <= 3);
  search.state = State::exhausted;
  while (true) {
    if (size == 3 && !has_area(p[0], p[1], p[2], noise)) flatten(search.portal, 2 * noise, false);
    const Vec3<S> n = portal_normal(search.portal);
    if (!(n[2] < 0)) return;  // NaN, or a portal along the line
    search.upper = portal_height(search.portal, n);
    if (search.upper <= limits.accept_at) {
      search.state = State::accepted;
      search.lambda = portal_weights(search.portal);
      return;
    }
    if (budget-- <= 0) return;
    ++view.counters.portal_steps;

    const PortalPoint<S> w = view.support(n);
    const S reach = dot(n, w.q);
    if (const S lower = reach / n[2]; lower > search.lower) {
      search.lower = lower;
      search.n = view.world(n);
    }
    if (search.lower > limits.reject_beyond) {
      search.state = State::rejected;
      return;
    }
    S face = dot(n, p[0].q);
    for (std::size_t i = 1; i < static_cast<std::size_t>(size); ++i) face = std::max(face, S(dot(n, p[i].q)));
    // `told`: the bracket of z is as narrow as requested. It need not be where the gap is closed: a steep
    // plane bounds z only to the gap over n_z, and a portal beyond `reject_beyond` says nothing of what is
    // before that. In both cases the gap is closed further, to the limit of rounding.
    const S gap = is_decided(search, limits, noise) ? std::max(limits.gap, limits.loose_gap) : limits.gap;
    const S fine = std::min(limits.gap, S(4 * noise));
    const auto told = [&] {
      return search.upper - search.lower <= 2 * gap && search.upper <= limits.reject_beyond;
    };
    if (!(reach - face > (told() ? gap : fine))) {
      search.lambda = portal_weights(search.portal);
      // If the plane is steep, its height on the line has an error of rounding over n_z. The portal's own point,
      // which the witnesses are made of, has not, provided that it is on the line.
      if (const Vec3<S> own = portal_point(search.portal, search.lambda);
          length_across(own[0], own[1]) <= 2 * noise) {
        search.upper = own[2];
      }
      // Its time may be later than the plane said, so the width of the bracket is checked again. If it is not, only
      // the fine gap will do: callers rely on the point being no deeper in C than that.
      if (told() || !(reach - face > fine)) {
        search.state = State::entered;
        search.facing = view.world(n);
        return;
      }
    }
    if (size == 1) return;  // the foremost point was not: only rounding can say so
    if (size == 2) {
      const Vec3<S> e = p[1].q - p[0].q;
      p[2] = w;
      if (has_area(p[0], p[1], w, 2 * noise)) {
        // The edge was on the silhouette, and C continues beside it.
        if (cross2(e, Vec3<S>(w.q - p[0].q)) < 0) std::swap(p[0], p[1]);
        size = 3;
      } else {
        flatten(search.portal, 2 * noise, true);
      }
    } else {
      replace_corner(search.portal, w, noise, passed);
    }
  }
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
