// Proves contact with a flat C, which has no interior: a point passes through a triangle, or an edge passes an edge.
// The contact is proved between two times t_1 < t_2 instead of at one.
//
// Three support pairs span a triangle of C at every t. Let n be its normal at t_1. Seen along n, the origin lies
// inside the triangle, and its distance from the edges exceeds the motion of every corner until t_2. So the line
// {s n} pierces the triangle at all times between, at a height that changes continuously. If the height changes sign, it
// is 0 at some time between, and then the origin is in C. (The idea comes from continuous tests on meshes, Provot
// 1997. Here the coplanar instant is bracketed, not computed.)
#pragma once

#include <graze/detail/rotating/contact.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Points of either body, in its own frame: the corners of a triangle that moves with them.
struct CrossingPoints {
  std::array<Vec3<double>, 3> a, b;
};
// As the pair is placed.
inline CrossingPoints points_of(const MovingPair& pair, const Simplex<double>& triangle) {
  const auto &a = pair.cso().side_a(), &b = pair.cso().side_b();
  CrossingPoints out;
  for (std::size_t i = 0; i < 3; ++i) {
    const CsoPoint<double>& p = triangle.point[i];
    out.a[i] = a.support(a, a.to_own(p.n), &p.vertex_a).x;
    out.b[i] = b.support(b, b.to_own(Vec3<double>(-p.n)), &p.vertex_b).x;
  }
  return out;
}
inline std::array<Vec3<double>, 3> corners_now(const MovingPair& pair, const CrossingPoints& points) {
  const Cso<double>& cso = pair.cso();
  const auto &a = cso.side_a(), &b = cso.side_b();
  std::array<Vec3<double>, 3> out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = a.to_world(points.a[i]) - (b.to_world(points.b[i]) + cso.offset());
  return out;
}

// Does the origin pass through the triangle between t_1 and t_2? Only for cores without a radius. Leaves the pair
// placed at either time.
inline bool crosses(MovingPair& pair, const Simplex<double>& triangle, double t_1, double t_2) {
  if (triangle.size != 3 || pair.radius() > 0) return false;
  pair.place(t_1);
  const double e = contact_error(pair);
  const CrossingPoints points = points_of(pair, triangle);
  const auto before = corners_now(pair, points);
  const Vec3<double> m = face_normal(before[0], before[1], before[2]);
  const double area = norm(m);
  const double height = dot(m, before[0]) / area;
  // Twice the area over an edge is an altitude. The origin's part of it is its distance from the edge. A corner is a
  // point of its body: it also rotates about a solid's own axis, which top_speed() leaves out.
  const auto turning = [](const Mobility& body) { return fl(body.rate * body.rho); };
  const double fastest = pair.cso().curved()
                             ? turning(pair.mobility_a()) + turning(pair.mobility_b()) + norm(pair.velocity())
                             : pair.top_speed();
  const double moved = fl(fastest * (t_2 - t_1) * (1 + 0x1p-40));
  bool inside = area > 0;
  for (std::size_t i = 0; i < 3 && inside; ++i) {
    const Vec3<double>&a = before[i], &b = before[(i + 1) % 3];
    const double from_edge = dot(m, cross(a, b)) / (area * norm(b - a));
    // m within 8 u longest^2 / area of its direction, a x b within 8 u |a| |b|.
    const double longest = std::max({norm(b - a), norm(a), norm(b)});
    const double predicate_error = fl(64 * kUnitRoundoff<double> * longest * (1 + longest * longest / area));
    inside = from_edge > moved + e + predicate_error;
  }
  if (!inside) return false;
  pair.place(t_2);
  // The height of the plane along n at t_2.
  const auto after = corners_now(pair, points);
  const Vec3<double> m_2 = face_normal(after[0], after[1], after[2]);
  const double facing = dot(m_2, m) / (norm(m_2) * area);
  const double height_2 = dot(m_2, after[0]) / norm(m_2);
  // Inside the triangle, corners that move by e move the plane's height along n by e / facing at most.
  return facing > 0.875 && std::abs(height) > 2 * e && std::abs(height_2) > 2 * e && height * height_2 < 0;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
