// Data that a hull with adjacency keeps beside its vertices. These are the edges of its boundary, triangulated, and,
// for a large hull, the vertices that can be the farthest along a direction (direction_map.hpp).
#pragma once

#include <graze/detail/shapes/direction_map.hpp>
#include <graze/detail/shapes/hull_faces.hpp>
#include <graze/hull.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

template <Scalar S>
struct HullGraph {
  static constexpr std::uint32_t kNone = 0xffffffff;

  // By rank, in the order given. A vertex that is no corner of the boundary has no rank.
  std::vector<std::uint32_t> vertex;  // rank -> index in the hull, the lowest of equal points
  std::vector<std::uint32_t> rank;    // index in the hull -> rank, also of its equal, or kNone

  // Lists of ranks, one after the other: those of rank r from begin[r] to begin[r + 1].
  struct Lists {
    std::vector<std::uint32_t> begin, entries;
    [[nodiscard]] const std::uint32_t* list(std::uint32_t r) const { return entries.data() + begin[r]; }
  };
  Lists neighbours;

  DirectionMap map;  // empty where a scan of all vertices is as quick
};

// From so many vertices on there is a map. Below, casts of shapes that are not in the near caches take as long or longer
// with one (docs/reports/costs.md).
inline constexpr std::size_t kMapFrom = 192;

class GraphMaker {
 public:
  // `given`: coordinates of the prepared scan.
  explicit GraphMaker(std::vector<Vec3<double>> given) : points_(distinct(std::move(given))) {}

  [[nodiscard]] bool valid() const { return points_.valid(); }

  // The boundary, of extreme points only, or empty for points in a plane.
  [[nodiscard]] std::vector<HullTriangle> derive() const {
    std::vector<std::uint32_t> all(points_.size());
    std::iota(all.begin(), all.end(), 0u);
    return extreme_surface(std::move(all));
  }

  // The faces cut into triangles, or empty if they are not the boundary.
  [[nodiscard]] std::vector<HullTriangle> verify(std::span<const std::vector<std::uint32_t>> faces) const {
    std::vector<HullTriangle> triangles;
    for (const std::vector<std::uint32_t>& face : faces) {
      if (face.size() < 3) return {};
      for (const std::uint32_t i : face) {
        if (i >= representative_.size()) return {};
      }
      for (std::size_t i = 2; i < face.size(); ++i) {
        triangles.push_back(
            {representative_[face[0]], representative_[face[i - 1]], representative_[face[i]]});
      }
    }
    return FaceCheck(points_, triangles).is_boundary() ? triangles : std::vector<HullTriangle>();
  }

  template <Scalar S>
  [[nodiscard]] HullGraph<S> graph(const std::vector<HullTriangle>& surface) const;

 private:
  using Neighbours = std::vector<std::vector<std::uint32_t>>;

  // Keeps the first of equal points, in the order given.
  [[nodiscard]] std::vector<Vec3<double>> distinct(std::vector<Vec3<double>> given) {
    std::vector<std::uint32_t> order(given.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto less = [&](std::uint32_t i, std::uint32_t j) {
      for (int k = 0; k < 3; ++k) {
        if (given[i][k] != given[j][k]) return given[i][k] < given[j][k];
      }
      return i < j;
    };
    std::sort(order.begin(), order.end(), less);
    std::vector<std::uint32_t> first(given.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool equal = i > 0 && given[order[i]] == given[order[i - 1]];
      first[order[i]] = equal ? first[order[i - 1]] : order[i];
    }
    representative_.resize(given.size());
    std::vector<Vec3<double>> out;
    for (std::uint32_t i = 0; i < given.size(); ++i) {
      if (first[i] == i) {
        representative_[i] = static_cast<std::uint32_t>(out.size());
        given_index_.push_back(i);
        out.push_back(given[i]);
      } else {
        representative_[i] = representative_[first[i]];  // first[i] < i
      }
    }
    return out;
  }

  [[nodiscard]] std::vector<HullTriangle> extreme_surface(std::vector<std::uint32_t> subset) const {
    std::vector<HullTriangle> surface = Quickhull(points_, std::move(subset)).surface();
    std::vector<std::uint32_t> corners, extreme;
    const std::vector<std::uint32_t> planes = planes_at(surface);
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (planes[i] > 0) corners.push_back(i);
      if (planes[i] > 2) extreme.push_back(i);
    }
    if (extreme.size() == corners.size()) return surface;
    return Quickhull(points_, std::move(extreme)).surface();
  }

  // The number of planes that meet at each point of a surface: one inside a face, two inside an edge, three
  // or more at an extreme point. Going round a point, it is the number of edges that are not flat.
  [[nodiscard]] std::vector<std::uint32_t> planes_at(const std::vector<HullTriangle>& surface) const {
    std::unordered_map<std::uint64_t, std::uint32_t> opposite;  // edge -> the third corner on its left
    const auto key = [](std::uint32_t from, std::uint32_t to) { return (std::uint64_t{from} << 32) | to; };
    for (const HullTriangle& t : surface) {
      for (std::size_t e = 0; e < 3; ++e) opposite[key(t[e], t[(e + 1) % 3])] = t[(e + 2) % 3];
    }
    std::vector<std::uint32_t> bends(points_.size(), 0), edges(points_.size(), 0);
    for (const HullTriangle& t : surface) {
      for (std::size_t e = 0; e < 3; ++e) {
        const std::uint32_t from = t[e], to = t[(e + 1) % 3];
        edges[from] = 1;
        if (from < to && points_.orientation(t[0], t[1], t[2], opposite.at(key(to, from))) != 0) {
          ++bends[from];
          ++bends[to];
        }
      }
    }
    for (std::size_t i = 0; i < bends.size(); ++i) bends[i] = std::max(bends[i], edges[i]);
    return bends;
  }

  [[nodiscard]] Neighbours neighbours(const std::vector<HullTriangle>& surface) const {
    Neighbours out(points_.size());
    // Each edge runs both ways in a closed surface.
    for (const HullTriangle& t : surface) {
      for (std::size_t e = 0; e < 3; ++e) out[t[e]].push_back(t[(e + 1) % 3]);
    }
    return out;
  }

  std::vector<std::uint32_t> representative_;  // index given -> point, filled while points_ is made
  std::vector<std::uint32_t> given_index_;     // point -> the first index given
  exact::PointSet points_;
};

template <Scalar S>
HullGraph<S> GraphMaker::graph(const std::vector<HullTriangle>& surface) const {
  const Neighbours at = neighbours(surface);
  HullGraph<S> out;
  std::vector<std::uint32_t> rank_of(points_.size(), HullGraph<S>::kNone);
  for (std::uint32_t i = 0; i < at.size(); ++i) {
    if (at[i].empty()) continue;
    rank_of[i] = static_cast<std::uint32_t>(out.vertex.size());
    out.vertex.push_back(given_index_[i]);
  }
  for (const std::uint32_t i : representative_) out.rank.push_back(rank_of[i]);
  out.neighbours.begin = {0};
  for (const std::vector<std::uint32_t>& list : at) {
    if (list.empty()) continue;
    for (const std::uint32_t i : list) out.neighbours.entries.push_back(rank_of[i]);
    out.neighbours.begin.push_back(static_cast<std::uint32_t>(out.neighbours.entries.size()));
  }
  return out;
}

// Empty for a hull so thin that floats may not tell its sides apart.
template <Scalar S>
DirectionMap map_of(const Hull<S>& hull) {
  if (hull.size() < kMapFrom) return {};
  for (int i = 0; i < 3; ++i) {
    const float* x = hull.approximate_scan(i);
    const auto far = [](float c) { return std::abs(c) >= DirectionMap::kLeastReach; };
    if (std::none_of(x, x + hull.size(), far)) return {};
  }
  return {hull.approximate_scan(0), hull.approximate_scan(1), hull.approximate_scan(2), hull.size()};
}

// The prepared scan as doubles. It is empty unless every coordinate is exact (a float may underflow).
template <Scalar S>
std::vector<Vec3<double>> exact_scan(const Hull<S>& hull) {
  std::vector<Vec3<double>> out(hull.finite() ? hull.size() : 0);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const S x = hull.scan(k)[i];
      if (std::scalbn(x, hull.exponent()) + hull.center()[k] != hull.vertex(i)[k]) return {};
      out[i][k] = x;
    }
  }
  return out;
}

template <Scalar S, class MakeSurface>
Hull<S> with_surface(std::span<const Vec3<S>> vertices, const MakeSurface& make_surface) {
  Hull<S> hull(vertices);
  const GraphMaker maker(exact_scan(hull));
  if (!maker.valid()) return hull;
  const std::vector<HullTriangle> surface = make_surface(maker);
  if (surface.empty()) return hull;
  HullGraph<S> graph = maker.graph<S>(surface);
  graph.map = map_of(hull);
  const bool has_map = !graph.map.empty();
  return hull.with_graph(std::make_shared<const HullGraph<S>>(std::move(graph)), has_map);
}

}  // namespace detail

template <Scalar S>
Hull<S> with_adjacency(std::span<const Vec3<S>> vertices) {
  return detail::with_surface(vertices, [](const auto& maker) { return maker.derive(); });
}

template <Scalar S>
Hull<S> with_faces(std::span<const Vec3<S>> vertices, std::span<const std::vector<std::uint32_t>> faces) {
  return detail::with_surface(vertices, [&](const auto& maker) { return maker.verify(faces); });
}

}}  // namespace graze::GRAZE_LINKAGE
