// Computes how deep the origin is in C, for two polytopes. It is the expanding polytope algorithm in doubles, with
// guessed vertices. It may give up.
//
// Notation   P = the hull of the vertices of C found so far.   A face f of P has a unit outward normal n_f and the
// offset d_f of its plane from the origin.   h(n) = the farthest vertex along n.
//
// As epa.hpp (equation, start and rounding there), in fixed storage on the stack, none of it set before it is used.
// The faces that see a point are found by a walk from face to face across edges, which meets the rim of the seen
// faces in its order. A rim that does not close, or passes a vertex twice, does not bound a disc and ends the search.
// The answer is
//   lower   the least d_f of a P around the origin: P is in C
//   upper   h(n_f), confirmed with the farthest vertex
// returned once the two have met, with the weights of a face that the origin projects into.
#pragma once

#include <graze/detail/pairs/pair_support.hpp>
#include <graze/detail/search/robust/simplex.hpp>  // face_normal

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
class FastEpa {
 public:
  FastEpa(PairSupport<S>& support, Counters& counters) : support_(support), counters_(counters) {}

  // Four vertices, in any order, that need not hold the origin. Returns true if the answer holds within `gap`, or
  // within `loose`, a caller's tolerance, which costs no support.
  [[nodiscard]] bool run(const std::array<PairVertex, 4>& corner, double gap, double loose, int budget) {
    visible_ = kVisibleNoises * support_.noise();
    if (!begin(corner)) return false;
    while (budget-- > 0 && vertices_ < kMostVertices) {
      ++counters_.iterations;
      std::size_t f = nearest();
      Triple n = face_[f].n;
      PairVertex& w = point_[vertices_];
      support_.guess(n, w);
      if (!(dot(n, w.w) - d_[f] > gap)) {
        support_.sure(n, w);
        upper_ = dot(n, w.w);
        if (!(upper_ - d_[f] > gap)) {
          // The origin outside a P that is all of C there: apart, or nearly.
          if (!(d_[f] >= -support_.fine())) return false;
          lower_ = d_[f];
          const std::size_t touching = projected_into(f);
          if (touching == kFaces) return false;
          if (touching == f) {
            n_ = n;
            return true;
          }
          // Another face of the same depth, so far.
          f = touching;
          n = face_[f].n;
          support_.sure(n, w);
          if (!(dot(n, w.w) - d_[f] > gap)) {
            upper_ = dot(n, w.w);
            n_ = n;
            return true;
          }
        }
      }
      if (dot(n, w.w) - d_[f] <= loose && closes_early(f, w, loose)) return true;
      if (!add(f, visible_) && !add(f, 0.0)) return false;
    }
    return false;
  }

  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return upper_; }
  [[nodiscard]] const Triple& normal() const { return n_; }
  [[nodiscard]] const PairVertex& point(std::size_t i) const { return point_[face_[answer_].v[i]]; }
  [[nodiscard]] const std::array<double, 3>& lambda() const { return lambda_; }

 private:
  // For hulls of 64 vertices, searches end with 10 to 35. A face's vertices are in a mask of 64 bits.
  static constexpr std::size_t kMostVertices = 60, kFaces = 3 * kMostVertices + 8;
  static constexpr std::uint8_t kNone = 0xff;
  static_assert(kFaces < kNone);
  // kVisible u scale of epa.hpp, in noises (both are 32 u of what counts as the scale).
  static constexpr double kVisibleNoises = 1;
  // Square of the sine below which a corner is thin: from there the product of two edges loses 5 bits, and the shorter
  // two are taken, with care (simplex.hpp).
  static constexpr double kThin = 0x1p-10;

  // The cosine between the height and an edge of a tetrahedron: its volume rounds by some 8 u of this.
  static constexpr double kFlat = 0x1p-24;

  struct Face {
    Triple n;  // unit, outward
    std::array<std::uint8_t, 3> v, across,
        back;  // across v[i] -> v[i + 1] lies face across[i], there as edge back[i]
    bool alive;
  };
  struct RimEdge {
    std::uint8_t face, edge;  // of the face that stays
  };

  [[nodiscard]] static std::size_t after(std::size_t i) { return i == 2 ? 0 : i + 1; }

  [[nodiscard]] bool begin(const std::array<PairVertex, 4>& corner) {
    const PairVertex &a = corner[0], &b = corner[1], &c = corner[2], &d = corner[3];
    std::copy(corner.begin(), corner.end(), point_.begin());
    vertices_ = 4;
    const Triple m = cross(b.w - a.w, c.w - a.w), rise = d.w - a.w;
    const double volume = dot(m, rise);
    // Flat: rounding decides which side is out.
    if (!(std::abs(volume) > kFlat * sum(magnitude(m)) * sum(magnitude(rise)))) return false;
    // The face opposite to corner i of a positive tetrahedron, seen from outside, and the edge that it shares with
    // the next face.
    constexpr std::array<std::array<std::uint8_t, 3>, 4> kPositive = {
        {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
      auto v = kPositive[i];
      if (volume < 0) std::swap(v[1], v[2]);
      if (!set_face(i, v)) return false;
      // Beyond an edge is the face opposite to the corner that this one has and the edge has not.
      for (std::size_t k = 0; k < 3; ++k) face_[i].across[k] = v[after(after(k))];
    }
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Face& g = face_[face_[i].across[k]];
        std::uint8_t edge = 0;
        while (edge < 2 && g.v[edge] != face_[i].v[after(k)]) ++edge;
        face_[i].back[k] = edge;
      }
    }
    faces_ = 4;
    return true;
  }

  // Returns false if it has no normal, which includes NaN.
  [[nodiscard]] bool set_face(std::size_t f, const std::array<std::uint8_t, 3>& v) {
    const Triple &a = point_[v[0]].w, &b = point_[v[1]].w, &c = point_[v[2]].w;
    const Triple ab = b - a, ac = c - a;
    Triple n = cross(ab, ac);
    double n_sq = dot(n, n);
    if (n_sq < kThin * (dot(ab, ab) * dot(ac, ac))) [[unlikely]] {
      n = triple(face_normal<double>(a.vector(), b.vector(), c.vector()));
      n_sq = dot(n, n);
    }
    const double one = 1 / square_root(n_sq);
    Face& out = face_[f];
    out.n.x = one * n.x;
    out.n.y = one * n.y;
    out.n.z = one * n.z;
    out.v = v;
    out.alive = true;
    d_[f] = std::min({dot(out.n, a), dot(out.n, b), dot(out.n, c)});
    seen_[f] = 0;
    // A square that vanishes is no normal, either.
    return n_sq > 0x1p-200 && n_sq < kInfinity<double>;
  }

  // The alive face with the least offset.
  [[nodiscard]] std::size_t nearest() const {
    std::size_t best = 0;
    double least = kInfinity<double>;
    for (std::size_t f = 0; f < faces_; ++f) {
      const bool less = d_[f] < least;
      best = less ? f : best;
      least = less ? d_[f] : least;
    }
    return best;
  }

  // Finds the faces that see the new vertex. From face g, entered across its edge e, with the edges in the order in
  // which one goes around. Seen faces die, and the edges of the others are the rim.
  [[nodiscard]] bool look(std::size_t g, std::size_t e, const Triple& w, double visible) {
    if (seen_[g] == stamp_) return true;
    if (dot(face_[g].n, w) - d_[g] < -visible) {
      if (rim_ == kFaces) return false;
      rim_edge_[rim_++] = {static_cast<std::uint8_t>(g), static_cast<std::uint8_t>(e)};
      return true;
    }
    seen_[g] = stamp_;
    gone_[gone_count_++] = static_cast<std::uint8_t>(g);
    const std::size_t first = after(e), second = after(first);
    return look(face_[g].across[first], face_[g].back[first], w, visible) &&
           look(face_[g].across[second], face_[g].back[second], w, visible);
  }

  // The hull of P and the vertex that stands at the end of point_, which is beyond face f. False: P is as it was.
  [[nodiscard]] bool add(std::size_t f, double visible) {
    const Triple& w = point_[vertices_].w;
    for (std::size_t i = 0; i < vertices_; ++i) {
      if (point_[i].is(point_[vertices_])) return false;
    }
    ++stamp_;
    rim_ = 0;
    gone_count_ = 1;
    gone_[0] = static_cast<std::uint8_t>(f);
    seen_[f] = stamp_;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!look(face_[f].across[k], face_[f].back[k], w, visible)) return false;
    }
    // One disc has one rim, which comes through each of its vertices once.
    if (rim_ < 3) return false;
    std::uint64_t passed = 0;
    for (std::size_t i = 0; i < rim_; ++i) {
      const std::uint64_t at = std::uint64_t{1} << from(i);
      if ((passed & at) != 0 || to(i) != from(i + 1 == rim_ ? 0 : i + 1)) return false;
      passed |= at;
    }
    // The new faces are made behind the others first, so that P stays as it was if one has no normal.
    if (faces_ + rim_ > kFaces) return false;
    const auto apex = static_cast<std::uint8_t>(vertices_);
    for (std::size_t i = 0; i < rim_; ++i) {
      if (!set_face(faces_ + i, {from(i), to(i), apex})) return false;
    }
    for (std::size_t i = 0; i < rim_; ++i) {
      Face& made = face_[faces_ + i];
      const auto next = static_cast<std::uint8_t>(faces_ + (i + 1 == rim_ ? 0 : i + 1)),
                 last = static_cast<std::uint8_t>(faces_ + (i == 0 ? rim_ - 1 : i - 1));
      made.across = {rim_edge_[i].face, next, last};
      made.back = {rim_edge_[i].edge, 2, 1};
      Face& outside = face_[rim_edge_[i].face];
      outside.across[rim_edge_[i].edge] = static_cast<std::uint8_t>(faces_ + i);
      outside.back[rim_edge_[i].edge] = 0;
    }
    faces_ += rim_;
    ++vertices_;
    for (std::size_t i = 0; i < gone_count_; ++i) face_[gone_[i]].alive = false;
    for (std::size_t i = 0; i < gone_count_; ++i) bury(gone_[i]);
    return true;
  }
  // A dead face's place is taken by the last one.
  void bury(std::size_t dead) {
    while (faces_ > 0 && !face_[faces_ - 1].alive) --faces_;
    if (dead >= faces_) return;
    const std::size_t last = --faces_;
    face_[dead] = face_[last];
    d_[dead] = d_[last];
    seen_[dead] = seen_[last];
    face_[last].alive = false;
    for (std::size_t k = 0; k < 3; ++k)
      face_[face_[dead].across[k]].across[face_[dead].back[k]] = static_cast<std::uint8_t>(dead);
  }
  // An edge of the rim, in the direction of the seen face: opposite to that of the face that stays.
  [[nodiscard]] std::uint8_t from(std::size_t i) const {
    return face_[rim_edge_[i].face].v[after(rim_edge_[i].edge)];
  }
  [[nodiscard]] std::uint8_t to(std::size_t i) const { return face_[rim_edge_[i].face].v[rim_edge_[i].edge]; }

  // A face no deeper than upper_ that the origin projects into, f if it is one, and its weights. kFaces if there is
  // no such face. It uses the current vertex, and the farthest along the face's normal is not much beyond that.
  [[nodiscard]] bool closes_early(std::size_t f, const PairVertex& w, double loose) {
    const Triple n = face_[f].n;
    const double h = dot(n, w.w) + fl(support_.approximate_error() * sum(magnitude(n)));
    if (!(d_[f] >= 0 && h - d_[f] <= loose && projects(f))) return false;
    answer_ = f;
    upper_ = h;
    lower_ = d_[f];
    n_ = n;
    return true;
  }
  [[nodiscard]] std::size_t projected_into(std::size_t f) {
    if (projects(f)) return answer_ = f;
    for (std::size_t g = 0; g < faces_; ++g) {
      if (d_[g] <= upper_ + support_.noise() && projects(g)) return answer_ = g;
    }
    return kFaces;
  }
  [[nodiscard]] bool projects(std::size_t f) {
    const Face& face = face_[f];
    const Triple &a = point_[face.v[0]].w, &b = point_[face.v[1]].w, &c = point_[face.v[2]].w, &n = face.n;
    const double la = std::max(dot(n, cross(b, c)), 0.0), lb = std::max(dot(n, cross(c, a)), 0.0),
                 lc = std::max(dot(n, cross(a, b)), 0.0), one = 1 / (la + lb + lc);
    lambda_ = {la * one, lb * one, lc * one};
    const Triple p = lambda_[0] * a + lambda_[1] * b + lambda_[2] * c - d_[f] * n;
    return largest(p) <= support_.noise();
  }

  PairSupport<S>& support_;
  Counters& counters_;
  std::size_t vertices_ = 0, faces_ = 0, rim_ = 0, gone_count_ = 0, answer_ = 0;
  std::uint32_t stamp_ = 0;
  double lower_ = 0, upper_ = kInfinity<double>, visible_ = 0;
  Triple n_{0, 0, 0};
  std::array<double, 3> lambda_{};
  // As far as they are used.
  std::array<PairVertex, kMostVertices + 1> point_;
  std::array<Face, kFaces> face_;
  std::array<double, kFaces> d_;
  std::array<std::uint32_t, kFaces> seen_;
  std::array<RimEdge, kFaces> rim_edge_;
  std::array<std::uint8_t, kFaces> gone_;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
