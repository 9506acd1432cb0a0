// Vertices of D = C + segment(0, -e), C swept back along the path's e = s r, for the quick GJK: D holds 0 where the path
// meets C.
//
// In the frame and the units of prepared_pair.hpp. h_D(n) = h_C(n) - min(0, n.e): D's vertex along n is C's, moved by -e
// where n.e < 0. A moved vertex is another of D's, and says so in its index.
//
// Rounding, per component: C's vertex errs by its e, the offset's error and 4 u M (fast_walk.hpp). As |e| <= 2 M, e
// errs by 4 u M, r being within u, and the sum by 3 u M. A moved vertex therefore errs by 7 u M more. A quarter of
// the noise is left to what GJK makes of them. A separating axis is checked with C's own vertex and the level min(0,
// n.e), by the margin that counts the path's end (pair_support.hpp).
#pragma once

#include <graze/detail/pairs/pair_support.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// How far along r the path is swept: nothing of C is met from there on.
template <Scalar S>
[[nodiscard]] double swept_reach(const PreparedPair<S>& pair, double horizon) {
  const Triple& r = pair.direction();
  return std::min(horizon, 2 * pair.extent() / square_root(dot(r, r)));
}

// kBoth: each support is searched twice, for C and for C moved, as the lecture's slow version has it.
template <Scalar S, bool kBoth = false>
class SweptSupport {
 public:
  // Requires that the pair moves. s = swept_reach().
  SweptSupport(const PreparedPair<S>& pair, double s, Counters& counters)
      : at_start_(pair, counters), at_end_(pair, uncounted_), end_(s * pair.direction()) {}

  void guess(const Triple& n, PairVertex& out) {
    at_start_.guess(n, out);
    if constexpr (kBoth) at_end_.guess(n, also_);
    move(n, out);
  }
  void sure(const Triple& n, PairVertex& out) {
    at_start_.sure(n, out);
    if constexpr (kBoth) at_end_.sure(n, also_);
    move(n, out);
  }
  void at(std::uint32_t vertex_a, std::uint32_t vertex_b, PairVertex& out) const {
    at_start_.at(vertex_a & ~kMoved, vertex_b, out);
    if ((vertex_a & kMoved) != 0) move_by_end(out);
  }
  [[nodiscard]] bool has(std::uint32_t vertex_a, std::uint32_t vertex_b) const {
    return at_start_.has(vertex_a & ~kMoved, vertex_b);
  }
  // Is h_D(n) < 0 beyond rounding? w: a vertex far along n, which may come out farther.
  [[nodiscard]] bool separates(const Triple& n, PairVertex& w) {
    if (!(dot(n, w.w) < 0)) return false;
    at_start_.at(w.vertex_a & ~kMoved, w.vertex_b, w);
    if (at_start_.separates(n, w, std::min(0.0, dot(n, end_)))) return true;
    move(n, w);
    return false;
  }

  [[nodiscard]] const PreparedPair<S>& pair() const { return at_start_.pair(); }
  [[nodiscard]] double noise() const { return at_start_.noise() / 4; }
  [[nodiscard]] double fine() const { return at_start_.fine(); }

 private:
  static constexpr std::uint32_t kMoved = std::uint32_t{1} << 31;

  void move(const Triple& n, PairVertex& out) const {
    if (dot(n, end_) < 0) move_by_end(out);
  }
  void move_by_end(PairVertex& out) const {
    out.w.x -= end_.x;
    out.w.y -= end_.y;
    out.w.z -= end_.z;
    out.vertex_a |= kMoved;
  }

  Counters uncounted_;
  PairSupport<S> at_start_, at_end_;
  PairVertex also_{};
  Triple end_;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
