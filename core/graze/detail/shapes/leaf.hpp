// Support points of the shapes that are no combinators, from their numbers. Direction d and point x are in the
// shape's own frame. d has any length but 0, or any sign of 0. x is in the unit of the numbers given.
//
// Relative errors: below 6 u of the shape's reach for the curved ones, none for polytopes. Ties and
// directions along which a curved shape is flat give one of the points that are greatest, always the same.
#pragma once

#include <graze/detail/shapes/approximate_scan.hpp>
#include <graze/detail/shapes/hull_graph.hpp>
#include <graze/shape.hpp>
#include <span>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Vertex k of a box, of a capsule's core.
template <Scalar S>
Vec3<S> box_vertex(const Vec3<S>& half, std::uint32_t k) {
  GRAZE_ASSERT(k < 8);
  return {k & 1u ? half[0] : -half[0], k & 2u ? half[1] : -half[1], k & 4u ? half[2] : -half[2]};
}
template <Scalar S>
std::uint32_t box_support(const Vec3<S>& d) {
  return (d[0] >= 0 ? 1u : 0u) | (d[1] >= 0 ? 2u : 0u) | (d[2] >= 0 ? 4u : 0u);
}

// d.x, its products rounded (machine.hpp).
template <Scalar S>
[[nodiscard, gnu::always_inline]] inline S height_along(const Vec3<S>& d, S x, S y, S z) {
  return fl(x * d[0]) + fl(y * d[1]) + fl(z * d[2]);
}

// R x and R^T n, likewise.
template <Scalar S>
[[nodiscard]] Vec3<S> turned_by(const Mat3<S>& r, const Vec3<S>& x) {
  const auto row = [&](int i) { return height_along<S>(x, r(i, 0), r(i, 1), r(i, 2)); };
  return {row(0), row(1), row(2)};
}
template <Scalar S>
[[nodiscard]] Vec3<S> turned_back_by(const Mat3<S>& r, const Vec3<S>& n) {
  const auto column = [&](int i) { return height_along<S>(n, r(0, i), r(1, i), r(2, i)); };
  return {column(0), column(1), column(2)};
}

// The first of a few points that is greatest along d.
template <Scalar S>
std::uint32_t first_greatest(std::span<const Vec3<S>> points, const Vec3<S>& d) {
  GRAZE_ASSERT(!points.empty());
  std::uint32_t best = 0;
  for (std::uint32_t k = 1; k < points.size(); ++k) {
    const Vec3<S> step = points[k] - points[best];
    if (height_along<S>(d, step[0], step[1], step[2]) > 0) best = k;
  }
  return best;
}

// x_i = r_i (r_i d_i) / |(r_j d_j)_j|, or the centre if the ellipsoid is flat along d.
template <Scalar S>
Vec3<S> ellipsoid_point(const Vec3<S>& radii, const Vec3<S>& d) {
  return scaled_by_axis(radii, unit(Vec3<S>(scaled_by_axis(radii, unit(d)))));
}

// The point of the circle of radius r about z, at height z, farthest along d, or its centre if d is along z.
template <Scalar S>
Vec3<S> rim_point(S radius, S z, const Vec3<S>& d) {
  const Vec3<S> across = radius * unit(Vec3<S>(d[0], d[1], 0));
  return {across[0], across[1], z};
}
template <Scalar S>
Vec3<S> cylinder_point(S radius, S half_height, const Vec3<S>& d) {
  return rim_point(radius, d[2] >= 0 ? half_height : -half_height, d);
}
template <Scalar S>
Vec3<S> cone_point(S radius, S half_height, const Vec3<S>& d) {
  // The apex wins where 2 half_height d_z >= radius |d_xy|.
  const Vec3<S> e = unit(d);
  if (2 * half_height * e[2] >= radius * norm(e.template head<2>())) return {0, 0, half_height};
  return rim_point(radius, -half_height, d);
}

// The first vertex that is greatest along d, as rounded, of all. The coordinates about the middle are within u of
// them, and a product of three terms within 3 u. So both of two vertices compared are within 4 u sum |d_i| half_i
// (4.4 for small offsets): at most 8 u |d| diameter below the true maximum.
template <Scalar S, Scalar Given>
std::uint32_t scan_hull(const Hull<Given>& hull, const Vec3<S>& d) {
  GRAZE_ASSERT(hull.size() > 0 && hull.finite());
  if constexpr (std::same_as<S, Given>) {
    const std::size_t k =
        scan(hull.choice_scan(0), hull.choice_scan(1), hull.choice_scan(2), hull.padded_size(), d);
    return static_cast<std::uint32_t>(k);
  } else {
    // In a wider scalar than the hull's, the choice scan's rounding would count for more than the offset's.
    constexpr bool kWider = sizeof(S) > sizeof(Given);
    const auto axis = [&](int i) { return kWider ? hull.scan(i) : hull.choice_scan(i); };
    const Given *x = axis(0), *y = axis(1), *z = axis(2);
    // A block at a time in S, then as one of S.
    constexpr std::size_t kBlock = Hull<Given>::kBlock;
    std::size_t best = 0;
    S top = -kInfinity<S>;
    for (std::size_t i = 0; i < hull.padded_size(); i += kBlock) {
      S value[kBlock];
      for (std::size_t l = 0; l < kBlock; ++l)
        value[l] = height_along<S>(d, S(x[i + l]), S(y[i + l]), S(z[i + l]));
      S most = value[0];
      for (std::size_t l = 1; l < kBlock; ++l) most = value[l] > most ? value[l] : most;
      if (!(most > top)) continue;
      top = most;
      std::size_t l = 0;
      while (l + 1 < kBlock && value[l] != most) ++l;
      best = i + l;
    }
    return static_cast<std::uint32_t>(best);
  }
}
// The same, to the bit, of the list that the hull's map has for d. A double uses floats first, as the map's margin is
// theirs. Heights in floats are off by 5 u B (u of float): 3 of products and sums, one of the direction, one of
// coordinates or of their middle. Here B = sum |d_i| max |x_i|. A vertex more than twice that below the greatest is
// lower in double, too.
template <Scalar S, Scalar Given>
std::uint32_t support_of_list(const Hull<Given>& hull, const DirectionMap& map,
                              const DirectionMap::List& list, const Vec3<S>& d) {
  const Vec3<float> guess = d.template cast<float>();
  const std::uint32_t k = approximate_scan(list.xyz, list.size, guess[0], guess[1], guess[2]);
  if constexpr (std::same_as<S, float>) {
    return list.vertex[k];
  } else {
    const float *x = list.xyz, *y = x + list.size, *z = y + list.size;
    const float size = fl(std::abs(guess[0]) * map.reach()[0]) + fl(std::abs(guess[1]) * map.reach()[1]) +
                       fl(std::abs(guess[2]) * map.reach()[2]);
    const float top = height_along<float>(guess, x[k], y[k], z[k]);
    constexpr bool kWider = sizeof(S) > sizeof(Given);
    const auto axis = [&](int i) { return kWider ? hull.scan(i) : hull.choice_scan(i); };
    const Given *a = axis(0), *b = axis(1), *c = axis(2);
    std::uint32_t best = list.vertex[k];
    S most = -kInfinity<S>;
    for_each_above(x, y, z, list.size, guess, top - fl(12 * kUnitRoundoff<float> * size),
                   [&](std::size_t one) {
                     const std::uint32_t v = list.vertex[one];
                     const S value = height_along<S>(d, S(a[v]), S(b[v]), S(c[v]));
                     if (!(value > most)) return;
                     most = value;
                     best = v;
                   });
    return best;
  }
}
template <Scalar S, Scalar Given>
std::uint32_t hull_support(const Hull<Given>& hull, const Vec3<S>& d) {
  if (hull.has_map()) {
    const DirectionMap& map = hull.graph().map;
    DirectionMap::List list;
    if (map.find(float(d[0]), float(d[1]), float(d[2]), list)) return support_of_list(hull, map, list, d);
  }
  return scan_hull(hull, d);
}
// In the hull's scan units, about its centre.
template <Scalar S, Scalar Given>
Vec3<S> hull_vertex(const Hull<Given>& hull, std::uint32_t k) {
  GRAZE_ASSERT(k < hull.size());
  return {S(hull.scan(0)[k]), S(hull.scan(1)[k]), S(hull.scan(2)[k])};
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
