// The boundary of a convex hull as triangles, by exact signs.
//
// [Barber, Dobkin, Huhdanpaa 1996] quickhull: each point outside the hull so far waits at one triangle that
// it lies strictly above. The farthest point of a triangle is joined to the horizon of what it sees. The
// points of the triangles that vanish wait at the new ones, or are inside. Differs: no facet is thick. The
// exact sign decides visibility, so the answer is the hull of the points as given. Only the choice of the
// farthest, which no answer depends on, is rounded. Cost: O(n log n) for spread points, O(n^2) at worst.
//
// "Seen" is "strictly above". A triangle in whose plane the new point p lies is not seen, and p is collinear
// with no edge of the horizon: it is strictly above the triangle on the seen side of it. So no triangle is
// degenerate, every edge is convex or flat, and a flat face is several triangles. A point above a vanishing
// triangle and outside the new hull is above a new one. Its visible region is connected. At an edge where the
// horizon crosses that region, the new triangle's outer half space holds the intersection of its two
// neighbours'.
#pragma once

#include <cstdint>
#include <graze/detail/numeric/orient3d.hpp>
#include <numeric>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Three indices of points, anticlockwise from outside.
using HullTriangle = std::array<std::uint32_t, 3>;

class Quickhull {
 public:
  Quickhull(const exact::PointSet& points, std::vector<std::uint32_t> subset)
      : points_(points), subset_(std::move(subset)) {}

  // Every extreme point of the subset is a corner, and perhaps some that lie on an edge or a face. Empty if
  // the points lie in a plane.
  [[nodiscard]] std::vector<HullTriangle> surface() {
    if (!start()) return {};
    // Triangles are appended while the loop runs.
    for (std::uint32_t f = 0; f < facets_.size(); ++f) {
      if (facets_[f].alive && !facets_[f].outside.empty()) add_farthest(f);
    }
    std::vector<HullTriangle> out;
    for (const Facet& facet : facets_) {
      if (facet.alive) out.push_back(facet.corner);
    }
    // Closed: each triangle has three edges, each edge two triangles.
    GRAZE_ASSERT(out.size() >= 4 && out.size() % 2 == 0);
    return out;
  }

 private:
  struct Facet {
    HullTriangle corner;
    std::array<std::uint32_t, 3> across = {};  // the triangle beyond the edge from corner i to corner i + 1
    std::vector<std::uint32_t> outside;        // points strictly above, waiting here
    bool alive = true;
    std::uint32_t seen_by = 0;  // the last point that saw this triangle, plus one
  };
  struct HorizonEdge {
    std::uint32_t from, to, beyond;  // `beyond` is the triangle that stays
  };

  [[nodiscard]] bool above(const Facet& facet, std::uint32_t p) const {
    return points_.orientation(facet.corner[0], facet.corner[1], facet.corner[2], p) > 0;
  }
  void wait_at_one_of(std::uint32_t p, std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t f = first; f < last; ++f) {
      if (above(facets_[f], p)) {
        facets_[f].outside.push_back(p);
        return;
      }
    }
  }

  // Four points that span a tetrahedron, each far from the hull of those before it, as rounded.
  [[nodiscard]] bool start() {
    if (subset_.size() < 4) return false;
    std::array<std::uint32_t, 4> base = {subset_[0], 0, 0, 0};
    const auto p = [&](std::uint32_t i) -> const Vec3<double>& { return points_[i]; };
    // The candidate of the greatest measure that passes the exact test. All are tried.
    const auto choose = [&](const auto& measure, const auto& passes, std::uint32_t& chosen) {
      double most = -1;
      for (const std::uint32_t i : subset_) {
        const double size = measure(i);
        if (size > most && passes(i)) {
          most = size;
          chosen = i;
        }
      }
      return most >= 0;
    };
    if (!choose([&](auto i) { return squared_norm(p(i) - p(base[0])); },
                [&](auto i) { return p(i) != p(base[0]); }, base[1])) {
      return false;
    }
    const Vec3<double> along = p(base[1]) - p(base[0]);
    if (!choose([&](auto i) { return squared_norm(cross(along, p(i) - p(base[0]))); },
                [&](auto i) { return !points_.collinear(base[0], base[1], i); }, base[2])) {
      return false;
    }
    const Vec3<double> normal = cross(along, p(base[2]) - p(base[0]));
    if (!choose([&](auto i) { return std::abs(dot(normal, p(i) - p(base[0]))); },
                [&](auto i) { return points_.orientation(base[0], base[1], base[2], i) != 0; }, base[3])) {
      return false;
    }
    if (points_.orientation(base[0], base[1], base[2], base[3]) > 0) std::swap(base[1], base[2]);
    const auto [a, b, c, d] = base;
    facets_ = {{.corner = {a, b, c}, .across = {1, 2, 3}, .outside = {}},
               {.corner = {b, a, d}, .across = {0, 3, 2}, .outside = {}},
               {.corner = {c, b, d}, .across = {0, 1, 3}, .outside = {}},
               {.corner = {a, c, d}, .across = {0, 2, 1}, .outside = {}}};
    for (const std::uint32_t i : subset_) {
      if (std::find(base.begin(), base.end(), i) == base.end()) wait_at_one_of(i, 0, 4);
    }
    return true;
  }

  [[nodiscard]] std::uint32_t farthest(const Facet& facet) const {
    const Vec3<double>& a = points_[facet.corner[0]];
    const Vec3<double> n = cross(points_[facet.corner[1]] - a, points_[facet.corner[2]] - a);
    std::uint32_t chosen = facet.outside[0];
    double most = -kInfinity<double>;
    for (const std::uint32_t i : facet.outside) {
      const double height = dot(n, points_[i] - a);
      if (height > most) {
        most = height;
        chosen = i;
      }
    }
    return chosen;
  }

  void add_farthest(std::uint32_t start) {
    const std::uint32_t p = farthest(facets_[start]);
    seen_ = {start};
    horizon_.clear();
    facets_[start].seen_by = p + 1;
    for (std::size_t s = 0; s < seen_.size(); ++s) {
      const std::uint32_t f = seen_[s];
      facets_[f].alive = false;
      for (std::size_t e = 0; e < 3; ++e) {
        const std::uint32_t g = facets_[f].across[e];
        if (facets_[g].seen_by == p + 1) continue;
        if (above(facets_[g], p)) {
          facets_[g].seen_by = p + 1;
          seen_.push_back(g);
        } else {
          horizon_.push_back({facets_[f].corner[e], facets_[f].corner[(e + 1) % 3], g});
        }
      }
    }
    const std::uint32_t first = static_cast<std::uint32_t>(facets_.size());
    join(p);
    const std::uint32_t last = static_cast<std::uint32_t>(facets_.size());
    for (const std::uint32_t f : seen_) {
      const std::vector<std::uint32_t> waiting = std::move(facets_[f].outside);
      facets_[f].outside.clear();
      for (const std::uint32_t i : waiting) {
        if (i != p) wait_at_one_of(i, first, last);
      }
    }
  }

  // A triangle from each edge of the horizon to p. The horizon is one simple cycle, so that each of its
  // points starts one edge.
  void join(std::uint32_t p) {
    if (starts_.empty()) starts_.resize(points_.size());
    const std::uint32_t first = static_cast<std::uint32_t>(facets_.size());
    for (const HorizonEdge& edge : horizon_) {
      const std::uint32_t f = static_cast<std::uint32_t>(facets_.size());
      starts_[edge.from] = f;
      facets_.push_back({.corner = {edge.from, edge.to, p}, .across = {edge.beyond, 0, 0}, .outside = {}});
      Facet& beyond = facets_[edge.beyond];
      for (std::size_t e = 0; e < 3; ++e) {
        if (beyond.corner[e] == edge.to && beyond.corner[(e + 1) % 3] == edge.from) beyond.across[e] = f;
      }
    }
    for (std::uint32_t f = first; f < facets_.size(); ++f) {
      const std::uint32_t next = starts_[facets_[f].corner[1]];
      facets_[f].across[1] = next;
      facets_[next].across[2] = f;
    }
  }

  const exact::PointSet& points_;
  std::vector<std::uint32_t> subset_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> seen_, starts_;
  std::vector<HorizonEdge> horizon_;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
