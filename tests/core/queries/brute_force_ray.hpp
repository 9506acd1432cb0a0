// Intersects a ray with every face of a hull: the lecture's baseline, slow, for polytopes only. For tests and
// bench.
//
//   t = the least t in [0, t_max] with origin + t direction in the hull (touching counts), or none.
//
// Inputs: the hull's vertices and all its faces as triangles, counter-clockwise seen from outside, of any
// fineness. The origin and the direction are in the same frame and unit. Standard arithmetic, no proof.
// Notation   p_i = corner i - origin, d = direction, c_ij = d.(p_i x p_j): on which side the line passes the
// edge. The line meets the triangle iff no two of c_12, c_20, c_01 differ in sign, n = (p_1 - p_0) x (p_2 - p_0),
//   t = n.p_0 / n.d.
// c_ij = -c_ji to the last bit, so that the two faces of an edge agree and no ray slips between them.
// Cf. Moeller, Trumbore, Fast Minimum Storage Ray/Triangle Intersection, 1997. Differs from the source in two ways:
// the edges' signs are taken before any division, and the whole line is tested instead of the ray, so that a
// start inside is seen.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <graze/scalar.hpp>
#include <span>

namespace graze {

template <Scalar S>
struct BruteForceRay {
  bool hit = false;
  S t = kInfinity<S>;    // of a hit, or 0 for a start inside
  std::size_t face = 0;  // of a hit: the face through which the line enters
};

template <Scalar S>
BruteForceRay<S> brute_force_ray(std::span<const Vec3<S>> vertices,
                                 std::span<const std::array<std::uint32_t, 3>> faces, const Vec3<S>& origin,
                                 const Vec3<S>& direction, S t_max) {
  BruteForceRay<S> out;
  S enter = kInfinity<S>, leave = -kInfinity<S>;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Vec3<S> p0 = vertices[faces[f][0]] - origin, p1 = vertices[faces[f][1]] - origin,
                  p2 = vertices[faces[f][2]] - origin;
    const S c01 = direction.dot(p0.cross(p1)), c12 = direction.dot(p1.cross(p2)),
            c20 = direction.dot(p2.cross(p0));
    const bool out_of_view = (c01 < 0 || c12 < 0 || c20 < 0) && (c01 > 0 || c12 > 0 || c20 > 0);
    if (out_of_view) continue;
    const Vec3<S> n = (p1 - p0).cross(p2 - p0);
    const S t = n.dot(p0) / n.dot(direction);
    // Edge on, or without area: its edges belong to faces that are neither. NaN fails both.
    if (t < enter && t > -kInfinity<S>) {
      enter = t;
      out.face = f;
    }
    if (t > leave && t < kInfinity<S>) leave = t;
  }
  if (!(leave >= 0 && enter <= t_max)) return out;
  out.hit = true;
  out.t = enter > 0 ? enter : S(0);
  return out;
}

}  // namespace graze
