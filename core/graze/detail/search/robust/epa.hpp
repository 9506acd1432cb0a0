// min over unit n of h(n), for the core C of a CSO that holds the origin: the expanding polytope.
// Units: internal.   Frame: world axes.
//
// Notation   P = the polytope, the hull of support points found so far, P inside C.   A face f of P has a
// unit outward normal n_f and the offset d_f = n_f.p from the origin.   w = support(n_f), h(n_f) = n_f.w.
// With the origin in P, its distance from P's boundary is min d_f, so
//     min d_f  <=  min over n of h(n)  <=  h(n_f):     stop when the two meet.
// [van den Bergen, Proximity Queries and Penetration Depth Computation on 3D Game Objects, 2001].
// Differs: P starts as a fat tetrahedron of C that need not hold the origin. The face with the least d_f, < 0
// or not, is the one to expand either way. So no start is degenerate. A C of fewer dimensions is found as one
// (its own normal n has h(n) = 0). An origin on a face, an edge or a vertex of P is like any other.
//
// Rounding. A face within kVisible u scale of the new point counts as seen by it. A face that stays lies below the
// point by more, so no new face is thinner than that, and P loses no more than that to the faces that go. If the seen
// faces are not one disc, which only rounding can cause, P stays as it was: the search did not converge.
#pragma once

#include <algorithm>
#include <graze/detail/search/robust/gjk.hpp>
#include <graze/detail/search/robust/line_frame.hpp>
#include <vector>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Vertices. A polytope has an end, after as many supports as C has vertices around the answer: 5 to 40, all of them
// where they are equally near. A curved C has no end. It halves the gap with every 2 to 4 supports, so it needs 60 to
// 190 for 46 bits, and more if it is nearly a ball or a tube about the origin. If the limit is reached first, the
// bracket is wide.
inline constexpr std::size_t kMostCurvedVertices = 1024;

// See above. The closest-point searches call 32 u scale contact (sweep.hpp).
inline constexpr int kVisible = 32;

template <Scalar S>
struct EpaFace {
  Vec3<S> n = Vec3<S>::Zero();          // unit, outward
  S d = 0;                              // n.p, internal length
  std::array<std::uint32_t, 3> v;       // vertices, counter-clockwise seen from outside
  std::array<std::uint32_t, 3> across;  // the face beyond the edge v[i] -> v[i + 1]
  std::uint32_t made = 0;               // which face of its slot this is
  bool alive = false, settled = false;  // settled: n, d are of the triangle's point nearest to the origin
};

template <Scalar S>
class EpaPolytope {
 public:
  // Four points with a volume, in any order. False if it has none.
  bool start(const std::array<CsoPoint<S>, 4>& corner) {
    point_.assign(corner.begin(), corner.end());
    face_.assign(4, {});
    free_.clear();
    heap_.clear();
    rim_.clear();
    leaves_.assign(4, kNone);
    const Vec3<S> e1 = corner[1].w - corner[0].w, e2 = corner[2].w - corner[0].w,
                  e3 = corner[3].w - corner[0].w;
    const S volume = dot(cross(e1, e2), e3);
    if (!(std::abs(volume) > 0)) return false;
    // Seen from outside, the face opposite to corner i of a positive tetrahedron.
    constexpr std::array<std::array<std::uint32_t, 3>, 4> kPositive = {
        {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
      auto v = kPositive[i];
      if (volume < 0) std::swap(v[1], v[2]);
      if (!set_face(face_[i], v)) return false;
      for (std::size_t k = 0; k < 3; ++k) {
        // Beyond an edge is the face opposite to the corner that this one has and the edge has not.
        face_[i].across[k] = v[(k + 2) % 3];
      }
    }
    for (std::uint32_t f = 0; f < 4; ++f) enqueue(f);
    return true;
  }

  [[nodiscard]] std::size_t faces() const { return face_.size(); }  // slots, some of them dead
  [[nodiscard]] const EpaFace<S>& face(std::size_t f) const { return face_[f]; }
  [[nodiscard]] std::size_t vertices() const { return point_.size(); }
  // Does P have this point, or one as near to it as rounding can tell?
  [[nodiscard]] bool holds(const CsoPoint<S>& p, S apart) const {
    return std::any_of(point_.begin(), point_.end(), [&](const CsoPoint<S>& q) {
      return q.same_feature(p) || squared_norm(q.w - p.w) <= apart * apart;
    });
  }
  [[nodiscard]] Closest<S> triangle(std::size_t f, Simplex<S>& corners) const {
    for (std::size_t i = 0; i < 3; ++i) corners.add(point_[face_[f].v[i]]);
    return closest_to_origin(corners, Vec3<S>(Vec3<S>::Zero()));
  }
  // The plane of a sliver is rounding: its support is a point that P has, above it. The position at which the
  // triangle is nearest to the origin is not affected.
  void settle(std::size_t f) {
    Simplex<S> corners;
    const Closest<S> closest = triangle(f, corners);
    face_[f].settled = true;
    face_[f].d = square_root(closest.dist_sq);
    if (face_[f].d > 0) face_[f].n = unit(closest.v);
    enqueue(static_cast<std::uint32_t>(f));
  }
  // The alive face with the least offset. Outdated entries before it are removed from the queue.
  [[nodiscard]] std::size_t nearest() {
    while (true) {
      const Queued& top = heap_.front();
      const EpaFace<S>& f = face_[top.face];
      if (f.alive && f.made == top.made && f.d == top.d) return top.face;
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
    }
  }

  // The hull of P and w, a point beyond the face `seen`. `visible`: how far below a face's plane w may lie
  // and still see it. False, and nothing changed, if rounding leaves no disc of faces, or if there is no
  // room.
  bool add(const CsoPoint<S>& w, std::size_t seen, S visible) {
    GRAZE_ASSERT(point_.size() >= 4 && seen < face_.size() && face_[seen].alive);
    // Walks the seen faces, from one to the next across edges, and collects the edges beyond which a face is not
    // seen.
    ++stamp_;
    mark_.resize(face_.size(), 0);
    seen_.assign(1, static_cast<std::uint32_t>(seen));
    rim_.clear();
    mark_[seen] = stamp_;
    for (std::size_t next = 0; next < seen_.size(); ++next) {
      const EpaFace<S>& f = face_[seen_[next]];
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t g = f.across[k];
        if (mark_[g] == stamp_) continue;
        if (dot(face_[g].n, w.w) - face_[g].d >= -visible) {
          mark_[g] = stamp_;
          seen_.push_back(g);
        } else {
          rim_.push_back({seen_[next], k});
        }
      }
    }
    // One disc has one rim, which leaves each of its vertices once.
    const bool whole = rim_.size() >= 3 && is_one_rim();
    if (whole) {
      const auto apex = static_cast<std::uint32_t>(point_.size());
      point_.push_back(w);
      made_.assign(rim_.size(), {});
      bool flat = false;
      for (std::size_t i = 0; i < rim_.size() && !flat; ++i)
        flat = !set_face(made_[i], {from(rim_[i]), to(rim_[i]), apex});
      if (!flat) {
        commit();
        leaves_.push_back(kNone);
        return true;
      }
      point_.pop_back();
    }
    for (const Edge& e : rim_) leaves_[from(e)] = kNone;
    return false;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Edge {
    std::uint32_t face = 0, k = 0;
  };
  struct Queued {
    S d = 0;
    std::uint32_t face = 0, made = 0;
    bool operator<(const Queued& o) const { return d != o.d ? d > o.d : face > o.face; }  // the least on top
  };
  [[nodiscard]] std::uint32_t from(Edge e) const { return face_[e.face].v[e.k]; }
  [[nodiscard]] std::uint32_t to(Edge e) const { return face_[e.face].v[(e.k + 1) % 3]; }

  void enqueue(std::uint32_t f) {
    heap_.push_back({face_[f].d, f, face_[f].made});
    std::push_heap(heap_.begin(), heap_.end());
  }

  // leaves_: for each vertex the rim's edge that begins there, or kNone outside of add().
  bool is_one_rim() {
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      std::uint32_t& at = leaves_[from(rim_[i])];
      if (at != kNone) return false;
      at = static_cast<std::uint32_t>(i);
    }
    std::size_t length = 0;
    for (std::size_t i = 0; length <= rim_.size(); ++length) {
      const std::uint32_t next = leaves_[to(rim_[i])];
      if (next == kNone) return false;
      i = next;
      if (i == 0) break;
    }
    return length + 1 == rim_.size();
  }

  bool set_face(EpaFace<S>& f, const std::array<std::uint32_t, 3>& v) const {
    const Vec3<S>&a = point_[v[0]].w, &b = point_[v[1]].w, &c = point_[v[2]].w;
    f.v = v;
    f.n = unit(face_normal(a, b, c));
    f.d = std::min({dot(f.n, a), dot(f.n, b), dot(f.n, c)});
    f.alive = true;
    f.settled = false;
    return squared_norm(f.n) > 0;  // false for NaN too
  }

  // The faces of made_ take the slots of the seen ones, then dead ones, then fresh ones.
  void commit() {
    slot_.clear();
    for (const std::uint32_t f : seen_) {
      face_[f].alive = false;
      free_.push_back(f);
    }
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      if (free_.empty()) {
        free_.push_back(static_cast<std::uint32_t>(face_.size()));
        face_.push_back({});
      }
      slot_.push_back(free_.back());
      free_.pop_back();
    }
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      const std::uint32_t after = leaves_[made_[i].v[1]];
      made_[i].across[0] = face_[rim_[i].face].across[rim_[i].k];
      made_[i].across[1] = slot_[after];
      made_[after].across[2] = slot_[i];
    }
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      // The face outside still points at one that goes.
      EpaFace<S>& outside = face_[made_[i].across[0]];
      for (std::size_t k = 0; k < 3; ++k) {
        if (outside.v[k] == made_[i].v[1] && outside.v[(k + 1) % 3] == made_[i].v[0])
          outside.across[k] = slot_[i];
      }
      leaves_[made_[i].v[0]] = kNone;
    }
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      EpaFace<S>& slot = face_[slot_[i]];
      made_[i].made = slot.made + 1;
      slot = made_[i];
      enqueue(slot_[i]);
    }
  }

  std::vector<CsoPoint<S>> point_;
  std::vector<EpaFace<S>> face_, made_;
  std::vector<Edge> rim_;
  std::vector<Queued> heap_;
  std::vector<std::uint32_t> leaves_, slot_, seen_, free_, mark_;
  std::uint32_t stamp_ = 0;
};

template <Scalar S>
struct Epa {
  S lower = 0, upper = kInfinity<S>;  // of the least h(n)
  Vec3<S> n = Vec3<S>::Zero();        // unit, with h(n) = upper
  Simplex<S> contact;                 // face of P, weighted at its point nearest to the origin, or empty
  bool stalled = false;
  bool enclosed = false;  // P holds the origin, or C is flat and holds it within `known`
};

// The dimension of C, as distinguishable from rounding.
template <Scalar S>
struct Tetrahedron {
  int dimension = 0;  // of C. At 3 `corner` is a tetrahedron in C
  std::array<CsoPoint<S>, 4> corner;
  Vec3<S> n = Vec3<S>::Zero();  // unit if dimension < 3, and C has no extent along it
};

// Four support points far from each other: the ends of C's longest axis, the point farthest from their line,
// the point farthest from the plane of the three. `flat`: an extent that counts as none.
template <Scalar S, class Support>
Tetrahedron<S> spread_tetrahedron(const Support& support, S flat) {
  Tetrahedron<S> out;
  auto& c = out.corner;
  S longest = -1;
  for (int i = 0; i < 3; ++i) {
    const CsoPoint<S> low = support(Vec3<S>(-Vec3<S>::Unit(i))), high = support(Vec3<S>(Vec3<S>::Unit(i)));
    if (const S length = high.w[i] - low.w[i]; length > longest) {
      longest = length;
      c[0] = low;
      c[1] = high;
    }
  }
  out.n = Vec3<S>::UnitX();
  if (!(longest > flat)) return out;
  // Searches across the line. The four directions find a point at 1/sqrt(2) of the greatest distance, or farther.
  const Frame<S> frame(Vec3<S>(c[1].w - c[0].w));
  S farthest = 0;
  for (const Vec3<S>& across : {frame.e1, Vec3<S>(-frame.e1), frame.e2, Vec3<S>(-frame.e2)}) {
    const CsoPoint<S> p = support(across);
    if (const S distance = dot(across, p.w - c[0].w); distance > farthest) {
      farthest = distance;
      c[2] = p;
    }
  }
  out.dimension = 1;
  out.n = frame.e1;
  if (!(farthest > flat)) return out;
  out.dimension = 2;
  out.n = unit(face_normal(c[0].w, c[1].w, c[2].w));
  const CsoPoint<S> above = support(out.n), below = support(Vec3<S>(-out.n));
  const S up = dot(out.n, above.w - c[0].w), down = dot(out.n, c[0].w - below.w);
  if (std::max(up, down) > flat) out.dimension = 3;
  c[3] = up > down ? above : below;
  return out;
}

// The face of P nearest to the origin as a triangle, of those whose plane is no farther than `within`: of two
// coplanar ones, that which the origin projects into.
template <Scalar S>
std::size_t touching_face(const EpaPolytope<S>& P, S within, Simplex<S>& contact) {
  std::size_t best = P.faces();
  S least = kInfinity<S>;
  for (std::size_t f = 0; f < P.faces(); ++f) {
    if (!P.face(f).alive || !(P.face(f).d <= within)) continue;
    Simplex<S> triangle;
    const Closest<S> closest = P.triangle(f, triangle);
    if (!(closest.dist_sq < least)) continue;
    least = closest.dist_sq;
    best = f;
    reduce(triangle, closest);
    contact = triangle;
  }
  return best;
}

// `known`: how far outside C the origin may be, at most: a lower bound of -h. `gap`: upper - lower to reach. `loose`:
// a caller's tolerance, which ends the same search earlier. `noise`: what rounding cannot tell from nothing
// (sweep.hpp). Ends after `budget` supports beside the first twelve, or with `most_vertices`.
template <Scalar S, class Support>
Epa<S> epa(const Support& given, const Simplex<S>& around, S known, S gap, S loose, S noise, S scale,
           int budget, std::size_t most_vertices, Counters& counters) {
  const auto support = [&](const Vec3<S>& n) {
    ++counters.supports;
    return given(n);
  };
  Epa<S> out;
  out.lower = -known;
  const auto bound = [&](const Vec3<S>& n, S h) {
    if (h < out.upper) {
      out.upper = h;
      out.n = n;
    }
  };
  EpaPolytope<S> P;
  // The tetrahedron that a former search ended with, if it is not a thin one: a sixteenth of a cube's corner.
  bool begun = false;
  if (around.size == 4) {
    const Vec3<S> e1 = around.point[1].w - around.point[0].w, e2 = around.point[2].w - around.point[0].w,
                  e3 = around.point[3].w - around.point[0].w;
    const S size = std::max({squared_norm(e1), squared_norm(e2), squared_norm(e3)});
    begun = std::abs(dot(cross(e1, e2), e3)) > size * square_root(size) / 16 && size > scale * scale / 4096 &&
            P.start(around.point);
  }
  if (!begun) {
    const Tetrahedron<S> spread = spread_tetrahedron<S>(support, noise);
    if (spread.dimension < 3) {
      for (const Vec3<S>& n : {spread.n, Vec3<S>(-spread.n)}) bound(n, dot(n, support(n).w));
      return out;
    }
    if (!P.start(spread.corner)) {
      out.stalled = true;
      return out;
    }
  }
  const S visible = kVisible * kUnitRoundoff<S> * scale, same = visible / 4;
  // Once P holds the origin it always does: then a face that has the origin outside is a sliver.
  bool& enclosed = out.enclosed;
  enclosed = begun;
  std::size_t f = P.nearest();
  while (true) {
    ++counters.iterations;
    const EpaFace<S> face = P.face(f);
    const CsoPoint<S> w = support(face.n);
    const S h = dot(face.n, w.w), least = P.face(P.nearest()).d;
    bound(face.n, h);
    enclosed = enclosed || least >= 0;
    // The origin outside P: P says nothing about the depth of C yet.
    out.lower = std::max(S(-known), least >= 0 ? least : S(-known));
    const bool closed = out.upper - out.lower <= gap;
    if (closed) {
      const std::size_t touching = touching_face(P, S(out.upper + noise), out.contact);
      if (touching == f && h <= out.upper + gap) {
        out.upper = h;
        out.n = face.n;
        return out;
      }
      if (touching == P.faces() || budget <= 0) return out;
      if (touching != f) {
        if (dot(out.n, combination(out.contact)) >= out.upper - gap) return out;
        // Another direction of the same depth, so far.
        --budget;
        f = touching;
        continue;
      }
    }
    if (loose > gap && !closed && least >= 0 && h <= out.upper && out.upper - out.lower <= loose &&
        touching_face(P, S(out.upper + noise), out.contact) == f)
      return out;
    // No new point, no room, or no budget: the search returns its bracket. NaN ends here too.
    const bool known_point = P.holds(w, same);
    if (budget-- > 0 && known_point && enclosed && !face.settled) {
      P.settle(f);
    } else if (!(h - face.d > gap) || known_point || budget < 0 || P.vertices() >= most_vertices ||
               !(P.add(w, f, visible) || P.add(w, f, S(0)))) {
      out.stalled = !closed;
      if (!closed) touching_face(P, S(out.upper + noise), out.contact);
      return out;
    }
    f = P.nearest();
  }
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
