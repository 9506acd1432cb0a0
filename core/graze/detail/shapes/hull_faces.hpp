// Is a list of faces the boundary of the hull of the points? It decides exactly, and returns nothing for any
// other list.
//
// A face is a polygon, anticlockwise from outside, cut into a fan of triangles from its first corner. The
// triangles are the boundary if and only if these four conditions hold:
//   1.  They form a closed surface: each edge is shared by two of them, in opposite directions. It is
//       connected, and V - E + F = 2: a sphere.
//   2.  No edge is concave: the far corner beyond it is not strictly above.
//   3.  Some point o lies strictly below all of them, and some ray from o meets exactly one, in its interior.
//   4.  Every other point lies above none.
// 1 and 3 make the radial projection from o a covering of a sphere by a sphere. It is branched at corners at
// most, and has one sheet where the ray meets it: a homeomorphism. So the surface is simple, and 2 makes it
// convex [Mehlhorn, Naeher, Schilz, Schirra, Seel, Seidel, Uhrig 1996, checking geometric structures].
// Differs: o is a double near the middle, and a hull so thin that o is not inside it is refused though it may
// be right.
#pragma once

#include <graze/detail/shapes/quickhull.hpp>
#include <unordered_map>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

class FaceCheck {
 public:
  // The points must be valid, and distinct where a face names them.
  FaceCheck(const exact::PointSet& points, std::vector<HullTriangle> triangles)
      : points_(points), triangles_(std::move(triangles)) {}

  [[nodiscard]] bool is_boundary() const {
    return triangles_.size() >= 4 && is_sphere() && no_edge_concave() && once_around_middle() &&
           others_inside();
  }

 private:
  static std::uint64_t edge(std::uint32_t from, std::uint32_t to) { return (std::uint64_t{from} << 32) | to; }

  // Fills left_.
  [[nodiscard]] bool is_sphere() const {
    left_.clear();
    std::vector<bool> used(points_.size(), false);
    std::size_t corners = 0;
    for (std::uint32_t f = 0; f < triangles_.size(); ++f) {
      const HullTriangle& t = triangles_[f];
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return false;
      for (std::size_t e = 0; e < 3; ++e) {
        if (!left_.emplace(edge(t[e], t[(e + 1) % 3]), f).second) return false;
        if (!used[t[e]]) ++corners;
        used[t[e]] = true;
      }
    }
    std::vector<bool> reached(triangles_.size(), false);
    std::vector<std::uint32_t> next = {0};
    reached[0] = true;
    for (std::size_t s = 0; s < next.size(); ++s) {
      const HullTriangle& t = triangles_[next[s]];
      for (std::size_t e = 0; e < 3; ++e) {
        const auto twin = left_.find(edge(t[(e + 1) % 3], t[e]));
        if (twin == left_.end()) return false;
        if (reached[twin->second]) continue;
        reached[twin->second] = true;
        next.push_back(twin->second);
      }
    }
    // Each triangle has three halves of edges: V - E + F = V - F / 2.
    return next.size() == triangles_.size() && 2 * corners == triangles_.size() + 4;
  }

  [[nodiscard]] int side(const HullTriangle& t, std::uint32_t p) const {
    return points_.orientation(t[0], t[1], t[2], p);
  }

  [[nodiscard]] bool no_edge_concave() const {
    for (const HullTriangle& t : triangles_) {
      for (std::size_t e = 0; e < 3; ++e) {
        const HullTriangle& beyond = triangles_[left_.at(edge(t[(e + 1) % 3], t[e]))];
        for (const std::uint32_t corner : beyond) {
          if (side(t, corner) > 0) return false;
        }
      }
    }
    return true;
  }

  // o: the mean of the corners, rounded. The ray's second point: near the middle of the largest triangle,
  // where rounding least moves it out.
  [[nodiscard]] bool once_around_middle() const {
    Vec3<double> o = Vec3<double>::Zero();
    for (const HullTriangle& t : triangles_) {
      for (const std::uint32_t corner : t) o += points_[corner];
    }
    o /= 3 * static_cast<double>(triangles_.size());
    std::size_t largest = 0;
    double most = -1;
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      const HullTriangle& t = triangles_[f];
      const double area_sq =
          squared_norm(cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]));
      if (area_sq > most) {
        most = area_sq;
        largest = f;
      }
    }
    const HullTriangle& aim = triangles_[largest];
    const Vec3<double> p = (points_[aim[0]] + points_[aim[1]] + points_[aim[2]]) / 3;
    std::vector<Vec3<double>> with;
    with.reserve(points_.size() + 2);
    for (std::size_t i = 0; i < points_.size(); ++i) with.push_back(points_[i]);
    with.push_back(snapped(o));
    with.push_back(snapped(p));
    const exact::PointSet all(std::move(with));
    if (!all.valid()) return false;
    const std::size_t middle = points_.size(), target = middle + 1;
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      const HullTriangle& t = triangles_[f];
      if (all.orientation(t[0], t[1], t[2], middle) >= 0) return false;
      // In the cone from o over t: to the left of its three edges, seen from o.
      int least = 1;
      for (std::size_t e = 0; e < 3; ++e) {
        least = std::min(least, all.orientation(t[e], t[(e + 1) % 3], middle, target));
      }
      if (least != (f == largest ? 1 : -1)) return false;
    }
    return true;
  }
  // Into the range of a PointSet, by rounding what is too small to 0.
  static Vec3<double> snapped(Vec3<double> x) {
    for (int i = 0; i < 3; ++i) {
      if (std::abs(x[i]) < 0x1p-60) x[i] = 0;
    }
    return x;
  }

  [[nodiscard]] bool others_inside() const {
    std::vector<bool> corner(points_.size(), false);
    for (const HullTriangle& t : triangles_) {
      for (const std::uint32_t i : t) corner[i] = true;
    }
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (corner[i]) continue;
      for (const HullTriangle& t : triangles_) {
        if (side(t, i) > 0) return false;
      }
    }
    return true;
  }

  const exact::PointSet& points_;
  std::vector<HullTriangle> triangles_;
  mutable std::unordered_map<std::uint64_t, std::uint32_t> left_;  // edge -> the triangle on its left
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
