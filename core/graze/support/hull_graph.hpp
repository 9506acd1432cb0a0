// The graph that a hull's support walks on: the edges of its boundary, and of a pyramid of coarser hulls.
//
//   P_0 the hull, triangulated;  I_k an independent set of vertices of P_k, each of low degree;
//   P_(k+1) = hull of the vertices of P_k without I_k;  the last, the base, has few.
// [Dobkin, Kirkpatrick 1985] Let < order the points by height along a direction, ties broken so that no two
// are equal as if the direction were turned a little (climb.hpp). If v is the greatest of P_(k+1), the
// greatest of P_k is v or the one neighbour of v in P_k that is greater: what is greater than v lies in I_k,
// and whoever is the greater of its neighbours, none of which is in I_k, is a local maximum, so the greatest.
// So a vertex keeps its neighbours of every I_k, the `children`, coarse levels first; the descent takes the
// first child that is greater, and goes on with that one's children. Vertices and children add up to O(n).
//
// A base that is left large, or a vertex with many edges (the apex of a pyramid over n points has n), costs
// its size.
#pragma once

#include <graze/hull.hpp>
#include <graze/support/hull_faces.hpp>

namespace graze::inline GRAZE_LINKAGE {

template <Scalar S>
struct HullGraph {
  static constexpr std::uint32_t kNone = 0xffffffff;

  // By rank: the base first, then the levels from coarse to fine; what is no vertex of P_0 has none.
  std::vector<std::uint32_t> vertex;  // rank -> index in the hull, the lowest of equal points
  std::vector<std::uint32_t> rank;    // index in the hull -> rank, of its equal too; or kNone
  std::vector<Vec3<S>> point;         // rank -> the prepared scan's coordinates
  std::uint32_t base_size = 0;

  // Lists of ranks, one after the other: those of rank r from begin[r] to begin[r + 1].
  struct Lists {
    std::vector<std::uint32_t> begin, entries;
    [[nodiscard]] const std::uint32_t* list(std::uint32_t r) const { return entries.data() + begin[r]; }
  };
  Lists children, neighbours;
};

namespace detail {

// A base is scanned: about as large as what two levels would cost.
inline constexpr std::size_t kBaseSize = 12;
// A vertex of a triangulation has fewer than six neighbours on average, so more than a third have at most
// this many.
inline constexpr std::size_t kLowDegree = 8;

class GraphMaker {
 public:
  // `given`: coordinates of the prepared scan.
  explicit GraphMaker(std::vector<Vec3<double>> given) : points_(distinct(std::move(given))) {}

  [[nodiscard]] bool valid() const { return points_.valid(); }

  // The boundary, of extreme points only; empty for points in a plane.
  [[nodiscard]] std::vector<HullTriangle> derive() const {
    std::vector<std::uint32_t> all(points_.size());
    std::iota(all.begin(), all.end(), 0u);
    return extreme_surface(std::move(all));
  }

  // The faces cut into triangles; empty if they are not the boundary.
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

  // Vertices of low degree, the lowest first, no two of them neighbours.
  [[nodiscard]] static std::vector<std::uint32_t> independent(const Neighbours& at) {
    std::vector<bool> taken(at.size(), false);
    std::vector<std::uint32_t> out;
    for (std::size_t degree = 3; degree <= kLowDegree; ++degree) {
      for (std::uint32_t i = 0; i < at.size(); ++i) {
        if (at[i].size() != degree || taken[i]) continue;
        out.push_back(i);
        for (const std::uint32_t j : at[i]) taken[j] = true;
      }
    }
    return out;
  }

  template <class Rank>
  static void append(std::vector<std::uint32_t>& begin, std::vector<std::uint32_t>& entries,
                     const std::vector<std::uint32_t>& list, const Rank& rank) {
    for (const std::uint32_t i : list) entries.push_back(rank(i));
    begin.push_back(static_cast<std::uint32_t>(entries.size()));
  }

  std::vector<std::uint32_t> representative_;  // index given -> point; filled while points_ is made
  std::vector<std::uint32_t> given_index_;     // point -> the first index given
  exact::PointSet points_;
};

template <Scalar S>
HullGraph<S> GraphMaker::graph(const std::vector<HullTriangle>& surface) const {
  const Neighbours finest = neighbours(surface);
  Neighbours at = finest;
  std::vector<std::vector<std::uint32_t>> levels;  // I_0, I_1, ...
  Neighbours children(points_.size());             // from fine to coarse
  std::vector<bool> ranked(points_.size(), false);
  std::vector<std::uint32_t> left;
  for (;;) {
    left.clear();
    for (std::uint32_t i = 0; i < at.size(); ++i) {
      if (!at[i].empty()) left.push_back(i);
    }
    if (left.size() <= kBaseSize) break;
    std::vector<std::uint32_t> removed = independent(at);
    for (const std::uint32_t w : removed) ranked[w] = true;
    std::vector<std::uint32_t> rest;
    for (const std::uint32_t i : left) {
      if (!ranked[i]) rest.push_back(i);
    }
    const std::vector<HullTriangle> coarser =
        removed.empty() ? std::vector<HullTriangle>() : extreme_surface(std::move(rest));
    if (coarser.empty()) {  // nothing to remove, or the rest is flat
      for (const std::uint32_t w : removed) ranked[w] = false;
      break;
    }
    for (const std::uint32_t w : removed) {
      for (const std::uint32_t v : at[w]) children[v].push_back(w);
    }
    levels.push_back(std::move(removed));
    at = neighbours(coarser);
  }

  HullGraph<S> out;
  std::vector<std::uint32_t> order = left, rank_of(points_.size(), HullGraph<S>::kNone);
  out.base_size = static_cast<std::uint32_t>(left.size());
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    order.insert(order.end(), level->begin(), level->end());
  }
  // Corners inside an edge or a face of a verified surface, which no coarser hull has.
  for (const std::uint32_t i : order) ranked[i] = true;
  for (std::uint32_t i = 0; i < finest.size(); ++i) {
    if (!finest[i].empty() && !ranked[i]) order.push_back(i);
  }
  for (std::uint32_t r = 0; r < order.size(); ++r) {
    rank_of[order[r]] = r;
    out.vertex.push_back(given_index_[order[r]]);
    out.point.push_back(points_[order[r]].template cast<S>());
  }
  const auto rank = [&](std::uint32_t i) { return rank_of[i]; };
  for (const std::uint32_t i : representative_) out.rank.push_back(rank_of[i]);
  GRAZE_ASSERT(out.base_size > 0 && out.rank.size() == representative_.size());
  out.children.begin = out.neighbours.begin = {0};
  for (const std::uint32_t i : order) {
    std::reverse(children[i].begin(), children[i].end());
    append(out.children.begin, out.children.entries, children[i], rank);
    append(out.neighbours.begin, out.neighbours.entries, finest[i], rank);
  }
  return out;
}

// The prepared scan as doubles; empty unless every coordinate is exact (a float may underflow).
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
  return hull.with_graph(std::make_shared<const HullGraph<S>>(maker.graph<S>(surface)));
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

}  // namespace graze::inline GRAZE_LINKAGE
