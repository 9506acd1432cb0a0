// Contact with a flat C, which has no interior: a point passes through a triangle, or an edge passes an edge.
// Contact is then proved between two times t_1 < t_2 instead of at one.
//
// Three support pairs span a triangle of C at every t. Let n be its normal at t_1. Seen along n, the origin
// lies inside the triangle, farther from its edges than any of its corners moves until t_2. So the line
// {s n} pierces the triangle at all times between, at a height that changes continuously. If the height
// changes sign, it is 0 at some time between, and then the origin is in C. (The idea of continuous tests on
// meshes, Provot 1997; here the coplanar instant is bracketed, not solved for.)
#pragma once

#include <Eigen/Geometry>  // cross
#include <graze/rotating/contact.hpp>

namespace graze::inline GRAZE_LINKAGE::detail {

// The corners of the triangle as placed now.
inline std::array<Vec3<double>, 3> corners_now(const MovingPair& pair, const Simplex<double>& triangle) {
  const Cso<double>& cso = pair.cso();
  const auto &a = cso.side_a(), &b = cso.side_b();
  const Vec3<double> any = Vec3<double>::UnitZ();
  std::array<Vec3<double>, 3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const CsoPoint<double>& p = triangle.point[i];
    out[i] = a.to_world(a.support(a, any, &p.vertex_a).x) -
             (b.to_world(b.support(b, any, &p.vertex_b).x) + cso.offset());
  }
  return out;
}

// Does the origin pass through the triangle between t_1 and t_2? Leaves the pair placed at t_2. Of polytopes
// without a radius.
inline bool crosses(MovingPair& pair, const Simplex<double>& triangle, double t_1, double t_2) {
  if (triangle.size != 3 || pair.cso().curved() || pair.radius() > 0) return false;
  pair.place(t_1);
  const double e = contact_error(pair);
  const auto before = corners_now(pair, triangle);
  const Vec3<double> m = face_normal(before[0], before[1], before[2]);
  const double area = m.norm();
  const double height = m.dot(before[0]) / area;
  // Twice the area over an edge is an altitude; the part of it that is the origin's is its distance from it.
  const double moved = pair.top_speed() * (t_2 - t_1) * (1 + 0x1p-40);
  bool inside = area > 0;
  for (std::size_t i = 0; i < 3 && inside; ++i) {
    const Vec3<double>&a = before[i], &b = before[(i + 1) % 3];
    const double from_edge = m.dot(a.cross(b)) / (area * (b - a).norm());
    // m within 8 u longest^2 / area of its direction, a x b within 8 u |a| |b|.
    const double longest = std::max({(b - a).norm(), a.norm(), b.norm()});
    const double doubt = 64 * kUnitRoundoff<double> * longest * (1 + longest * longest / area);
    inside = from_edge > moved + e + doubt;
  }
  pair.place(t_2);
  if (!inside) return false;
  // The height of the plane along n at t_2.
  const auto after = corners_now(pair, triangle);
  const Vec3<double> m_2 = face_normal(after[0], after[1], after[2]);
  const double facing = m_2.dot(m) / (m_2.norm() * area);
  const double height_2 = m_2.dot(after[0]) / m_2.norm();
  // Inside the triangle, corners that move by e move the plane's height along n by e / facing at most.
  return facing > 0.875 && std::abs(height) > 2 * e && std::abs(height_2) > 2 * e && height * height_2 < 0;
}

}  // namespace graze::inline GRAZE_LINKAGE::detail
