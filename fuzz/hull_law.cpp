#include "fuzz/hull_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <graze/detail/shapes/leaf.hpp>
#include <map>
#include <set>

#include "oracles/polytope/exact_cso.hpp"
#include "oracles/polytope/integer_scene.hpp"

namespace graze::fuzz {

namespace {

using oracle::fold_denominators, oracle::support, oracle::times;
using oracle::HalfSpace;
using oracle::Integer;
using oracle::IntVec;

using Face = std::vector<std::uint32_t>;

template <Scalar S>
class HullCheck {
 public:
  HullCheck(std::span<const Vec3<S>> points, corpus::Random& random) : points_(points), random_(random) {
    for (const Vec3<S>& p : points) fold_denominators(unit_, oracle::rational(p.template cast<double>()));
    for (const Vec3<S>& p : points) at_.push_back(times(unit_, oracle::rational(p.template cast<double>())));
    truth_ = oracle::convex_hull(at_);
    for (std::uint32_t i = 0; i < at_.size(); ++i) index_.emplace(at_[i], i);  // the first of equal points
    if (truth_.dimension == 3) find_extreme();
  }

  [[nodiscard]] std::string fault() {
    const Hull<S> plain(points_), derived = with_adjacency<S>(points_);
    if (derived.has_adjacency() != (truth_.dimension == 3)) {
      return fmt::format("adjacency is {} for a hull of dimension {}",
                         derived.has_adjacency() ? "made" : "refused", truth_.dimension);
    }
    std::string found = support_fault(plain, "without adjacency");
    if (truth_.dimension != 3 || !found.empty()) return found;
    found = graph_fault(derived.graph());
    if (found.empty()) found = support_fault(derived, "with adjacency");
    if (found.empty()) found = hint_fault();
    return found;
  }

 private:
  // Facets' planes by their least integer normal: a facet that is several triangles is one plane.
  void find_extreme() {
    std::set<IntVec> seen;
    for (const HalfSpace& h : truth_.half_spaces) {
      Integer common = gcd(gcd(h.normal.x, h.normal.y), h.normal.z);
      const IntVec n = {h.normal.x / common, h.normal.y / common, h.normal.z / common};
      if (seen.insert(n).second) planes_.push_back({n, support(truth_, n)});
    }
    for (const IntVec& v : truth_.vertices) {
      const auto meets = [&](const HalfSpace& h) { return dot(h.normal, v) == h.offset; };
      // One plane inside a face, two inside an edge.
      if (std::count_if(planes_.begin(), planes_.end(), meets) >= 3) extreme_.insert(index_.at(v));
    }
  }

  [[nodiscard]] std::string graph_fault(const HullGraph<S>& graph) const {
    const std::set<std::uint32_t> vertices(graph.vertex.begin(), graph.vertex.end());
    if (vertices != extreme_ || graph.vertex.size() != extreme_.size()) {
      return fmt::format("{} vertices in the graph, {} extreme points", graph.vertex.size(), extreme_.size());
    }
    if (graph.neighbours.entries.size() != 2 * (3 * extreme_.size() - 6))
      return "the graph is none of a triangulated sphere";
    for (const HalfSpace& plane : planes_) {
      for (std::uint32_t r = 0; r < graph.vertex.size(); ++r) {
        const Integer height = dot(plane.normal, at_[graph.vertex[r]]);
        const auto higher = [&](std::uint32_t j) { return dot(plane.normal, at_[graph.vertex[j]]) > height; };
        if (height < plane.offset &&
            std::none_of(graph.neighbours.list(r), graph.neighbours.list(r + 1), higher)) {
          return fmt::format("vertex {} is a local maximum and not the greatest", graph.vertex[r]);
        }
      }
    }
    return {};
  }

  [[nodiscard]] Vec3<S> direction() {
    Vec3<S> d;
    if (!planes_.empty() && !random_.once_in(3)) {
      // A facet's normal, rounded: its corners are near-ties.
      const IntVec& n = planes_[random_.below(planes_.size())].normal;
      const Integer most = std::max({Integer(abs(n.x)), Integer(abs(n.y)), Integer(abs(n.z))});
      const oracle::Rational scale(1, most);
      d = Vec3<double>(oracle::Rational(n.x * scale).get_d(), oracle::Rational(n.y * scale).get_d(),
                       oracle::Rational(n.z * scale).get_d())
              .template cast<S>();
    } else {
      for (int i = 0; i < 3; ++i) d[i] = static_cast<S>(random_.integer(-4, 4));
    }
    // Beyond this the height is exact all the same, and slower.
    for (int i = 0; i < 3; ++i) {
      if (std::abs(d[i]) < S(0x1p-60)) d[i] = 0;
    }
    return d;
  }

  [[nodiscard]] std::string support_fault(const Hull<S>& hull, const char* how) {
    for (int tries = 0; tries < 8; ++tries) {
      const Vec3<S> d = direction();
      if (d.isZero(0)) continue;
      const std::uint32_t found = detail::hull_support<S, S>(hull, d);
      Integer unit = 1;
      const oracle::RationalPoint exact = oracle::rational(d.template cast<double>());
      fold_denominators(unit, exact);
      const IntVec n = times(unit, exact);
      // 8 u sum |n_i| extent_i (leaf.hpp).
      if (found >= at_.size() ||
          ((support(truth_, n) - dot(n, at_[found])) << std::numeric_limits<S>::digits) > 8 * reach(n)) {
        return fmt::format("the support {} along [{:a}, {:a}, {:a}] is vertex {}, below the greatest", how,
                           d[0], d[1], d[2], found);
      }
    }
    return {};
  }
  [[nodiscard]] Integer reach(const IntVec& n) const {
    Integer out = 0;
    for (const auto axis : {&IntVec::x, &IntVec::y, &IntVec::z}) {
      const auto less = [axis](const IntVec& p, const IntVec& q) { return p.*axis < q.*axis; };
      const auto [low, high] = std::minmax_element(at_.begin(), at_.end(), less);
      out += abs(n.*axis) * (*high.*axis - *low.*axis);
    }
    return out;
  }

  // CGAL's facets as they are, or spoilt in one place.
  [[nodiscard]] std::string hint_fault() {
    std::vector<Face> faces;
    for (const oracle::HullFacet& facet : truth_.facets) {
      Face face;
      for (const int v : facet.loop) face.push_back(index_.at(truth_.vertices[static_cast<std::size_t>(v)]));
      faces.push_back(std::move(face));
    }
    Face& one = faces[random_.below(faces.size())];
    const std::size_t corner = random_.below(one.size());
    switch (random_.below(5)) {
      case 0:
        one[corner] = static_cast<std::uint32_t>(random_.below(points_.size()));
        break;
      case 1:
        std::swap(one[corner], one[(corner + 1) % one.size()]);
        break;
      case 2:
        std::swap(one, faces.back());
        faces.pop_back();
        break;
      case 3:
        one.push_back(static_cast<std::uint32_t>(random_.below(points_.size())));
        break;
      default:
        break;
    }
    if (!with_faces<S>(points_, std::span<const Face>(faces)).has_adjacency()) return {};
    return is_boundary(faces) ? "" : "faces are taken that are not the boundary";
  }

  [[nodiscard]] bool is_boundary(const std::vector<Face>& faces) const {
    std::set<std::uint32_t> corners;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    const auto first = [&](std::uint32_t i) { return index_.at(at_[i]); };
    for (const Face& face : faces) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        corners.insert(first(face[i]));
        ++edges[{first(face[i]), first(face[(i + 1) % face.size()])}];
      }
      for (std::size_t i = 2; i < face.size(); ++i) {
        const IntVec& a = at_[face[0]];
        const IntVec normal = cross(at_[face[i - 1]] - a, at_[face[i]] - a);
        if (normal.is_zero() || support(truth_, normal) != dot(normal, a)) return false;
      }
    }
    for (const auto& [edge, count] : edges) {
      const auto back = edges.find({edge.second, edge.first});
      if (count != 1 || back == edges.end()) return false;
    }
    return std::includes(corners.begin(), corners.end(), extreme_.begin(), extreme_.end());
  }

  std::span<const Vec3<S>> points_;
  corpus::Random& random_;
  Integer unit_ = 1;
  std::vector<IntVec> at_;
  std::map<IntVec, std::uint32_t> index_;
  oracle::ConvexHull truth_;
  std::vector<HalfSpace> planes_;
  std::set<std::uint32_t> extreme_;
};

}  // namespace

template <Scalar S>
std::vector<Vec3<S>> as_hull_question(std::span<const Vec3<double>> points) {
  constexpr bool kDouble = sizeof(S) == sizeof(double);
  constexpr double kMost = kDouble ? 1e60 : 0x1p126;
  double most = 0;
  for (const Vec3<double>& p : points) {
    if (p.allFinite()) most = std::max(most, p.cwiseAbs().maxCoeff());
  }
  const int down = most > kMost ? std::ilogb(most / kMost) + 1 : 0;
  // A coordinate of the scan is one of the hull times a power of two, less a centre: down to u of the least.
  constexpr double kNear = kDouble ? 0x1p-200 : 0x1p-90;
  const double least = std::scalbn(most, 1 - down) * kNear;
  std::vector<Vec3<S>> question;
  for (const Vec3<double>& p : points) {
    if (!p.allFinite()) continue;
    Vec3<S>& q = question.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const double x = std::scalbn(p[i], -down);
      q[i] = std::abs(x) < least ? S(0) : static_cast<S>(x);
    }
  }
  return question;
}

template <Scalar S>
std::string hull_fault(std::span<const Vec3<S>> points, corpus::Random& random) {
  return HullCheck<S>(points, random).fault();
}

template std::vector<Vec3<float>> as_hull_question(std::span<const Vec3<double>> points);
template std::vector<Vec3<double>> as_hull_question(std::span<const Vec3<double>> points);
template std::string hull_fault(std::span<const Vec3<float>> points, corpus::Random& random);
template std::string hull_fault(std::span<const Vec3<double>> points, corpus::Random& random);

}  // namespace graze::fuzz
