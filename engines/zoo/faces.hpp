// The faces of a hull, for engines that need them with its vertices.
//
// faces_of(points) = the facets of conv(points), each anticlockwise from outside, without the vertices between the ends
//                    of an edge. Nothing if the hull is flat or the faces found do not form a closed surface.
//
// Gift wrapping: over each edge the next facet is the one whose plane has all points behind it. Points within kFlat ·
// size of a facet's plane belong to it. Computed in doubles, for inputs that are not extremely degenerate. If no faces
// are found, an adapter answers `unsupported`, which does not count as a finding.
#ifndef GRAZE_ENGINES_ZOO_FACES_HPP
#define GRAZE_ENGINES_ZOO_FACES_HPP

#include <graze_adapter.hpp>

#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace graze::zoo {

inline constexpr double kFlat = 1e-9;

using Points = std::vector<adapter::Vector>;
using Face = std::vector<std::size_t>;

class Wrapping {
 public:
  explicit Wrapping(const Points& points) : points_(points) {
    using namespace adapter;
    for (const Vector& x : points_) {
      for (std::size_t k = 0; k < 3; ++k) size_ = std::max(size_, std::abs(x[k] - points_.front()[k]));
    }
  }

  std::vector<Face> faces() {
    std::vector<Face> out;
    const Face first = first_face();
    if (first.empty()) return {};
    std::vector<std::pair<std::size_t, std::size_t>> open;  // edges as their face walks them
    std::set<std::pair<std::size_t, std::size_t>> walked;
    const auto add = [&](const Face& face) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::pair<std::size_t, std::size_t> edge{face[i], face[(i + 1) % face.size()]};
        if (!walked.insert(edge).second) return false;
        open.push_back(edge);
      }
      out.push_back(face);
      return true;
    };
    if (!add(first)) return {};
    while (!open.empty()) {
      const auto [from, to] = open.back();
      open.pop_back();
      if (walked.count({to, from}) != 0) continue;
      const Face face = over(to, from);
      if (face.size() < 3 || !add(face) || out.size() > 4 * points_.size()) return {};
    }
    for (const auto& [from, to] : walked) {
      if (walked.count({to, from}) == 0) return {};
    }
    return out;
  }

 private:
  // How far a point is before the plane through p with unit normal n.
  [[nodiscard]] double before(std::size_t i, std::size_t p, const adapter::Vector& n) const {
    using namespace adapter;
    return dot(points_[i] - points_[p], n);
  }

  // The facet that walks the edge from → to, if there is one: all points are behind its plane.
  Face over(std::size_t from, std::size_t to) const {
    using namespace adapter;
    const Vector edge = points_[to] - points_[from];
    if (!(length(edge) > kFlat * size_)) return {};
    Vector normal{};
    std::size_t best = from;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector n = cross(edge, points_[i] - points_[from]);
      if (!(length(n) > kFlat * size_ * length(edge))) continue;  // on the edge's line
      if (best != from && !(before(i, from, normal) > kFlat * size_)) continue;
      best = i;
      normal = normalized(n);
    }
    return best == from ? Face{} : face_in(from, normal);
  }

  // The vertices in a supporting plane, in order around its normal.
  [[nodiscard]] Face face_in(std::size_t p, const adapter::Vector& n) const {
    using namespace adapter;
    Face in;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double d = before(i, p, n);
      if (d > 4 * kFlat * size_) return {};
      if (d > -4 * kFlat * size_) in.push_back(i);
    }
    // Jarvis's march in the plane, from the farthest along an axis of it.
    const Vector u = normalized(std::abs(n[0]) < 0.6 ? cross(n, Vector{1, 0, 0}) : cross(n, Vector{0, 1, 0}));
    std::size_t start = in.front();
    for (const std::size_t i : in) {
      const double ahead = dot(points_[i] - points_[start], u);
      const double side = dot(points_[i] - points_[start], cross(n, u));
      if (ahead > kFlat * size_ || (std::abs(ahead) <= kFlat * size_ && side > kFlat * size_)) start = i;
    }
    Face face;
    std::size_t here = start;
    do {
      face.push_back(here);
      std::size_t next = here;
      for (const std::size_t i : in) {
        const Vector way = points_[i] - points_[here];
        if (!(length(way) > kFlat * size_)) continue;
        if (next == here) {
          next = i;
          continue;
        }
        const Vector known = points_[next] - points_[here];
        const double turn = dot(cross(known, way), n) / length(known);
        // To the right of the known edge, or farther on the same line.
        if (turn < -kFlat * size_ || (turn <= kFlat * size_ && length(way) > length(known))) next = i;
      }
      if (next == here || face.size() > in.size()) return {};
      here = next;
    } while (length(points_[here] - points_[start]) > kFlat * size_);
    return face.size() < 3 ? Face{} : face;
  }

  [[nodiscard]] Face first_face() const {
    using namespace adapter;
    if (!(size_ > 0)) return {};
    std::size_t low = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      if (points_[i] < points_[low]) low = i;  // in x, then y, then z
    }
    // A supporting plane through it with normal -x, tilted about z to the first vertex, then about that edge.
    Vector normal{-1, 0, 0};
    std::size_t second = low;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector way = points_[i] - points_[low];
      const Vector n = cross(way, Vector{0, 0, 1});
      if (!(length(n) > kFlat * size_)) continue;
      if (second != low && !(before(i, low, normal) > kFlat * size_)) continue;
      second = i;
      normal = normalized(n);
    }
    if (second == low) return {};
    // Finds one edge of the hull among the vertices in that plane. The plane holds a line along z through both
    // vertices.
    Face in;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (before(i, low, normal) > -4 * kFlat * size_) in.push_back(i);
    }
    std::size_t next = low;
    for (const std::size_t i : in) {
      const Vector way = points_[i] - points_[low];
      if (!(length(way) > kFlat * size_)) continue;
      const Vector known = points_[next] - points_[low];
      const double turn = next == low ? -1 : dot(cross(known, way), normal);
      if (turn < -kFlat * size_ * length(known) ||
          (turn <= kFlat * size_ * length(known) && length(way) > length(known))) {
        next = i;
      }
    }
    for (const auto& [from, to] : {std::pair{low, next}, std::pair{next, low}}) {
      Face face = over(from, to);
      if (!face.empty()) return face;
    }
    return {};
  }

  const Points& points_;
  double size_ = 0;
};

inline std::vector<Face> faces_of(const Points& points) {
  if (points.empty()) return {};
  std::vector<Face> faces = Wrapping(points).faces();
  if (faces.size() < 4) faces.clear();  // a flat hull has two sides
  return faces;
}

}  // namespace graze::zoo

#endif
