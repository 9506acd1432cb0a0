// The point of a simplex that is closest to the origin, and the axis that it gives.
//
// Input: one to four points y_i. Output: the least sub-simplex whose hull holds the closest point
//   v = sum lambda_i y_i,  lambda > 0,  and n, a unit vector from the simplex to the origin.
// Notation   e = an edge,  m = the normal of a face.
//
// v is always a convex combination as rounded, so |v| bounds the distance from above, regardless of earlier
// errors. The axis n is found from the feature, not from v: at contact v is noise, but the normal of a
// triangle is not. A feature too thin to have a normal (a sliver, a flat tetrahedron) is left to its own
// edges and faces. Cf. Ericson, Real-Time Collision Detection (2005), 5.1, and van den Bergen, Collision
// Detection (2003), 4.3. Differs: the answer is the least |v| over all features whose weights are positive,
// so that a wrong region can cost a step, never an answer.
#pragma once

#include <graze/detail/pairs/cso.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// y_i = w_i - x: the CSO relative to the point x of the path.
template <Scalar S>
struct Simplex {
  int size = 0;
  std::array<CsoPoint<S>, 4> point;
  std::array<S, 4> lambda{};

  void add(const CsoPoint<S>& p) {
    GRAZE_ASSERT(size >= 0 && size < 4);
    point[static_cast<std::size_t>(size++)] = p;
  }
  [[nodiscard]] bool holds(const CsoPoint<S>& p) const {
    for (int i = 0; i < size; ++i) {
      if (point[static_cast<std::size_t>(i)].same_feature(p)) return true;
    }
    return false;
  }
};

// sum lambda w: the point that the weights make of the corners.
template <Scalar S>
Vec3<S> combination(const Simplex<S>& simplex) {
  Vec3<S> out = Vec3<S>::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.size); ++i) {
    out += simplex.lambda[i] * simplex.point[i].w;
  }
  return out;
}

// (b - a) x (c - a), from the two shorter edges. A product of two long edges that nearly agree rounds in
// every direction, also along them, where the face reaches far. The short edge keeps the error relative to
// the area. If the corners are nearly in a line even that edge is not short. The product's component along
// the longest edge is then rounding, u |edge|^2 / height of the normal, and is subtracted.
template <Scalar S>
Vec3<S> face_normal(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c) {
  const Vec3<S> ab = b - a, bc = c - b, ca = a - c;
  const S ab_sq = squared_norm(ab), bc_sq = squared_norm(bc), ca_sq = squared_norm(ca);
  const auto across = [](const Vec3<S>& m, const Vec3<S>& longest, S length_sq) -> Vec3<S> {
    return length_sq > 0 ? Vec3<S>(m - (dot(m, longest) / length_sq) * longest) : m;
  };
  if (ab_sq >= bc_sq && ab_sq >= ca_sq) return across(cross(bc, ca), ab, ab_sq);
  return bc_sq >= ca_sq ? across(cross(ca, ab), bc, bc_sq) : across(cross(ab, bc), ca, ca_sq);
}

template <Scalar S>
struct Closest {
  Vec3<S> v = Vec3<S>::Zero();
  Vec3<S> n = Vec3<S>::Zero();  // zero if the feature gives none (the origin on it)
  S dist_sq = kInfinity<S>;
  int size = 0;
  std::array<std::uint8_t, 4> index{};
  std::array<S, 4> lambda{};
};

template <Scalar S>
using Points4 = std::array<Vec3<S>, 4>;

// Square of the sine of a corner's angle below which a face is a sliver: from there its weights lose ten
// bits.
template <Scalar S>
inline constexpr S kSliver = S(0x1p-20);

template <Scalar S>
void keep_nearer(Closest<S>& best, const Closest<S>& one) {
  // On a tie the smaller feature stays: its weights are the better known.
  if (one.size > 0 && (best.size == 0 || one.dist_sq < best.dist_sq)) best = one;
}

template <Scalar S>
Closest<S> closest_vertex(const Points4<S>& y, int i) {
  Closest<S> out;
  out.v = y[static_cast<std::size_t>(i)];
  out.dist_sq = squared_norm(out.v);
  out.n = -unit(out.v);
  out.size = 1;
  out.index[0] = static_cast<std::uint8_t>(i);
  out.lambda[0] = 1;
  return out;
}

// The interior of the edge i j, or size 0 if the closest point is one of its ends.
template <Scalar S>
Closest<S> closest_edge(const Points4<S>& y, int i, int j) {
  // Measured from the end nearer to the origin: less is cancelled.
  if (squared_norm(y[static_cast<std::size_t>(j)]) < squared_norm(y[static_cast<std::size_t>(i)]))
    std::swap(i, j);
  const Vec3<S>&from = y[static_cast<std::size_t>(i)], &to = y[static_cast<std::size_t>(j)];
  const Vec3<S> e = to - from;
  const S along = -dot(from, e), length_sq = squared_norm(e);
  Closest<S> out;
  if (!(along > 0 && along < length_sq)) return out;
  const S lambda = along / length_sq;
  out.v = from + lambda * e;
  out.v -= e * (dot(out.v, e) / length_sq);  // once more: what the first subtraction left along e
  out.dist_sq = squared_norm(out.v);
  out.n = -unit(out.v);
  out.size = 2;
  out.index = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)};
  out.lambda = {1 - lambda, lambda};
  return out;
}

// The interior of the face, or size 0 if the closest point is on its rim, or if the face is a sliver.
template <Scalar S>
Closest<S> closest_face(const Points4<S>& y, std::array<int, 3> at) {
  // From the corner nearest to the origin.
  for (std::size_t i = 1; i < 3; ++i) {
    if (squared_norm(y[static_cast<std::size_t>(at[i])]) < squared_norm(y[static_cast<std::size_t>(at[0])])) {
      std::swap(at[0], at[i]);
    }
  }
  const Vec3<S>&a = y[static_cast<std::size_t>(at[0])], &b = y[static_cast<std::size_t>(at[1])],
        &c = y[static_cast<std::size_t>(at[2])];
  const Vec3<S> e1 = b - a, e2 = c - a, m = face_normal(a, b, c);
  const S area_sq = squared_norm(m);
  Closest<S> out;
  if (!(area_sq > 0)) return out;
  S lambda1 = -dot(m, cross(a, e2)) / area_sq, lambda2 = -dot(m, cross(e1, a)) / area_sq;
  S lambda0 = 1 - lambda1 - lambda2;
  if (!(lambda0 > 0 && lambda1 > 0 && lambda2 > 0)) return out;
  out.v = a + lambda1 * e1 + lambda2 * e2;
  // On a sliver of height h the weights round by u |a| / h, and v by that along its length: what v has in the
  // plane is taken off once, v being short.
  if (area_sq < kSliver<S> * squared_norm(e1) * squared_norm(e2)) {
    const S again1 = lambda1 - dot(m, cross(out.v, e2)) / area_sq,
            again2 = lambda2 - dot(m, cross(e1, out.v)) / area_sq, again0 = 1 - again1 - again2;
    const Vec3<S> nearer = a + again1 * e1 + again2 * e2;
    if (again0 > 0 && again1 > 0 && again2 > 0 && squared_norm(nearer) < squared_norm(out.v)) {
      lambda0 = again0;
      lambda1 = again1;
      lambda2 = again2;
      out.v = nearer;
    }
  }
  out.dist_sq = squared_norm(out.v);
  out.n = unit(dot(m, a) > 0 ? Vec3<S>(-m) : m);
  out.size = 3;
  out.index = {static_cast<std::uint8_t>(at[0]), static_cast<std::uint8_t>(at[1]),
               static_cast<std::uint8_t>(at[2])};
  out.lambda = {lambda0, lambda1, lambda2};
  return out;
}

template <Scalar S>
void try_triangle(Closest<S>& best, const Points4<S>& y, int i, int j, int k) {
  keep_nearer(best, closest_edge(y, i, j));
  keep_nearer(best, closest_edge(y, j, k));
  keep_nearer(best, closest_edge(y, k, i));
  keep_nearer(best, closest_face(y, std::array<int, 3>{i, j, k}));
}

// The interior of the tetrahedron, by the signs of its volumes. The size is 0 if the origin is outside, or if
// the tetrahedron is too flat for its volume to have a sign (then the faces decide). The vector v is the
// residual of its weights: the distance by which rounding let the combination miss the origin.
template <Scalar S>
Closest<S> closest_inside(const Points4<S>& y) {
  const Vec3<S> e1 = y[1] - y[0], e2 = y[2] - y[0], e3 = y[3] - y[0], a = -y[0];
  const Vec3<S> m = cross(e2, e3);
  const S volume = dot(e1, m);
  // |error of volume| <= 8 u |e1||e2||e3|: three roundings in each product, three in the sum, two in the
  // edges.
  const S predicate_error = 8 * kUnitRoundoff<S> * norm(e1) * norm(e2) * norm(e3);
  Closest<S> out;
  if (!(std::abs(volume) > predicate_error)) return out;
  const S l1 = dot(a, m) / volume, l2 = dot(e1, cross(a, e3)) / volume, l3 = dot(e1, cross(e2, a)) / volume;
  const S l0 = 1 - l1 - l2 - l3;
  if (!(l0 > 0 && l1 > 0 && l2 > 0 && l3 > 0)) return out;
  out.v = y[0] + l1 * e1 + l2 * e2 + l3 * e3;
  out.dist_sq = squared_norm(out.v);
  out.size = 4;
  out.index = {0, 1, 2, 3};
  out.lambda = {l0, l1, l2, l3};
  return out;
}

// size 4 of the result: the origin is enclosed, and v is rounding.
template <Scalar S>
Closest<S> closest_to_origin(const Simplex<S>& simplex, const Vec3<S>& x) {
  using namespace detail;
  GRAZE_ASSERT(simplex.size >= 1 && simplex.size <= 4);
  Points4<S> y;
  for (int i = 0; i < simplex.size; ++i) {
    y[static_cast<std::size_t>(i)] = simplex.point[static_cast<std::size_t>(i)].w - x;
  }
  Closest<S> best;
  if (simplex.size == 4) best = closest_inside(y);
  for (int i = 0; i < simplex.size; ++i) keep_nearer(best, closest_vertex(y, i));
  if (simplex.size == 2) {
    keep_nearer(best, closest_edge(y, 0, 1));
  } else if (simplex.size == 3) {
    try_triangle(best, y, 0, 1, 2);
  } else if (simplex.size == 4) {
    keep_nearer(best, closest_edge(y, 0, 3));
    keep_nearer(best, closest_edge(y, 1, 3));
    keep_nearer(best, closest_edge(y, 2, 3));
    keep_nearer(best, closest_edge(y, 0, 1));
    keep_nearer(best, closest_edge(y, 1, 2));
    keep_nearer(best, closest_edge(y, 2, 0));
    keep_nearer(best, closest_face(y, std::array<int, 3>{0, 1, 2}));
    keep_nearer(best, closest_face(y, std::array<int, 3>{0, 1, 3}));
    keep_nearer(best, closest_face(y, std::array<int, 3>{1, 2, 3}));
    keep_nearer(best, closest_face(y, std::array<int, 3>{2, 0, 3}));
  }
  return best;
}

// Keeps the sub-simplex that `closest` names.
template <Scalar S>
void reduce(Simplex<S>& simplex, const Closest<S>& closest) {
  Simplex<S> kept;
  for (int i = 0; i < closest.size; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    GRAZE_ASSERT(closest.index[k] < simplex.size);
    kept.add(simplex.point[closest.index[k]]);
    kept.lambda[k] = closest.lambda[k];
  }
  simplex = kept;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
