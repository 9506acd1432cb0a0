// support(n) = the vertex of a hull that is greatest along n, exactly, in the order
//   x < y   iff   (n.x, x_0, x_1, x_2) precedes (n.y, y_0, y_1, y_2) lexicographically,
// where n.x is the exact product of the numbers as given and the coordinates are the prepared scan's: never
// below the true maximum, ties and near-ties included.
//
// The order is that of heights along n + e (1, e, e^2) for all small e > 0, a generic direction: different
// points differ, so the answer is one vertex (of equal ones the first given), whatever the start, the method
// (climb or scan) or the hull's adjacency. On flat faces it costs nothing to know that a neighbour ties.
//
// The climb [hull_graph.hpp]. Warm: from `start`, to the greatest of the neighbours, while one is greater and
// for kWarmMoves at most; a local maximum along a generic direction is the maximum, since the hull is convex.
// Cold, or when the warm walk has not arrived: from the greatest of the base, downwards through the children.
// Every move is up in a strict order, a child has a higher rank than its parent: both loops end.
//
// Filter. fl(n.x) has three products and two sums: |fl(n.x) - n.x| <= 3 u B (1 + 3 u), B = sum |n_i| max
// |x_i| over the hull; where S is narrower than the hull's scalar, its coordinates round first, 1 u more. So
// heights as rounded that differ by more than 9 u B differ so exactly (2 (3 + 1) u B, and 1 u B for the
// roundings of the difference and of B itself); contraction only takes roundings away. kUnderflow more covers
// products that fall below the range of S. What is closer is decided by height_sign, exact while the
// components of n are within a factor 2^1000 of the largest, or 0. Overflow makes NaN, which no comparison
// accepts: exact again.
#pragma once

#include <graze/numeric/orient3d.hpp>
#include <graze/support/hull_graph.hpp>

namespace graze::inline GRAZE_LINKAGE {

// No vertex: a climb that starts cold.
inline constexpr std::uint32_t kNoStart = 0xffffffff;

// From so many vertices on, a cold climb is quicker than a scan of rounded heights (leaf.hpp's). Measured
// (bench/support_bench.cpp, ns, double, sphere; a scan and a climb, each along directions that do not
// repeat):
//   vertices    8    16    32    64   128   256   512  1024  2048  4096
//   scan       11    34    54    86   141   248   458   797  1337  2398
//   cold       18    33    44    54    64    78    92   108   124   145
//   heights     8    13    17    20    23    28    32    36    39    44
//   warm       13    14    14    16    16    16    17    19    21    24   (from a direction 0.01 away)
// Where directions repeat, so that branches are foreseen, they meet at 45; cylinders and floats are alike.
// Whole casts of two such hulls meet between 32 (a climb costs 12 % more) and 128 (20 % less): 64.
inline constexpr std::size_t kClimbFrom = 64;

namespace detail {

// A warm walk that has not arrived costs about six heights a move for nothing. Measured at 512 vertices of a
// sphere, in ns, cold 92: 17 from a start 0.01 away, 112 from 0.3, 171 from anywhere; with no move allowed
// 19, 130 and 142; with two 17, 82 and 216.
inline constexpr int kWarmMoves = 1;

// What a climb costs, in heights computed and in heights compared exactly. The default counts nothing.
struct NoCount {
  void height() {}
  void exact_comparison() {}
};

// The order of points along one direction.
template <Scalar S, Scalar Given>
class HeightOrder {
 public:
  HeightOrder(const Hull<Given>& hull, const Vec3<S>& n) : n_(n) {
    S bound = 0;
    for (int i = 0; i < 3; ++i) {
      const S reach = S(hull.scan_half_extents()[i]) + std::abs(S(hull.scan_middle()[i]));
      bound += std::abs(n[i]) * reach;
    }
    band_ = 9 * kUnitRoundoff<S> * bound + kUnderflow;
  }

  [[nodiscard]] S height(S x, S y, S z) const { return x * n_[0] + y * n_[1] + z * n_[2]; }
  [[nodiscard]] S height(const Vec3<Given>& x) const { return height(S(x[0]), S(x[1]), S(x[2])); }

  [[nodiscard]] S band() const { return band_; }

  // Does x, of height h, come after y, of height k?
  template <class Count>
  [[nodiscard]] bool greater(const Vec3<Given>& x, S h, const Vec3<Given>& y, S k, Count& count) const {
    const S difference = h - k;
    if (difference > band_) return true;
    if (difference < -band_) return false;
    count.exact_comparison();
    return greater_exactly(x, y);
  }

 private:
  // Each of six products and their sums is off by less than the least normal number when it is flushed.
  static constexpr S kUnderflow = 16 * std::numeric_limits<S>::min();

  [[nodiscard]] bool greater_exactly(const Vec3<Given>& x, const Vec3<Given>& y) const {
    const int sign =
        exact::height_sign(n_.template cast<double>(), x.template cast<double>(), y.template cast<double>());
    if (sign != 0) return sign > 0;
    for (int i = 0; i < 3; ++i) {
      if (x[i] != y[i]) return x[i] > y[i];
    }
    return false;
  }

  Vec3<S> n_;
  S band_ = 0;
};

template <Scalar S, Scalar Given, class Count>
std::uint32_t climb(const Hull<Given>& hull, const Vec3<S>& n, std::uint32_t start, Count& count) {
  GRAZE_ASSERT(hull.has_adjacency() && hull.graph().base_size > 0);
  const HullGraph<Given>& graph = hull.graph();
  const HeightOrder<S, Given> order(hull, n);
  const auto height = [&](std::uint32_t r) {
    count.height();
    return order.height(graph.point[r]);
  };
  // Moves to rank `to` if it is greater.
  std::uint32_t at = 0;
  S top = 0;
  const auto move_up = [&](std::uint32_t to) {
    const S h = height(to);
    if (!order.greater(graph.point[to], h, graph.point[at], top, count)) return false;
    at = to;
    top = h;
    return true;
  };

  if (start < graph.rank.size() && graph.rank[start] != HullGraph<Given>::kNone) {
    at = graph.rank[start];
    top = height(at);
    for (int move = 0; move <= kWarmMoves; ++move) {
      const std::uint32_t *i = graph.neighbours.list(at), *end = graph.neighbours.list(at + 1);
      bool moved = false;
      for (; i != end; ++i) moved |= move_up(*i);
      if (!moved) return graph.vertex[at];
    }
  }

  at = 0;
  top = height(0);
  for (std::uint32_t r = 1; r < graph.base_size; ++r) move_up(r);
  const std::uint32_t *i = graph.children.list(at), *end = graph.children.list(at + 1);
  while (i != end) {
    if (move_up(*i)) {
      i = graph.children.list(at);
      end = graph.children.list(at + 1);
    } else {
      ++i;
    }
  }
  return graph.vertex[at];
}

// The same by looking at every vertex: the rounded maximum first, then what is within the band of it.
template <Scalar S, Scalar Given>
std::uint32_t scan(const Hull<Given>& hull, const Vec3<S>& n) {
  const HeightOrder<S, Given> order(hull, n);
  const Given *x = hull.scan(0), *y = hull.scan(1), *z = hull.scan(2);
  constexpr std::size_t kLanes = Hull<Given>::kBlock;
  const std::size_t size = hull.padded_size();
  S best[kLanes];
  for (std::size_t l = 0; l < kLanes; ++l) best[l] = -kInfinity<S>;
  for (std::size_t i = 0; i < size; i += kLanes) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      const S h = order.height(S(x[i + l]), S(y[i + l]), S(z[i + l]));
      best[l] = h > best[l] ? h : best[l];
    }
  }
  const S least = *std::max_element(best, best + kLanes) - order.band();
  std::uint32_t at = 0;
  Vec3<Given> at_point = Vec3<Given>::Zero();
  S top = 0;
  bool found = false;
  NoCount count;
  for (std::size_t i = 0; i < size; i += kLanes) {
    int low = 0;
    for (std::size_t l = 0; l < kLanes; ++l) {
      low += order.height(S(x[i + l]), S(y[i + l]), S(z[i + l])) < least;
    }
    if (low == static_cast<int>(kLanes)) continue;
    for (std::size_t l = 0; l < kLanes && i + l < hull.size(); ++l) {
      const Vec3<Given> point(x[i + l], y[i + l], z[i + l]);
      const S h = order.height(point);
      if (h < least || (found && !order.greater(point, h, at_point, top, count))) continue;
      at = static_cast<std::uint32_t>(i + l);
      at_point = point;
      top = h;
      found = true;
    }
  }
  return at;
}

}  // namespace detail

// The support point of a hull along d, in the hull's own axes; the index of a vertex. Any finite d, scaled
// between 2^-900 and 2^900 in double (2^-100 and 2^100 in float); beyond that it is as right, and slower.
// `start`: where to begin, best the last answer for a direction nearby, or kNoStart; it changes the cost
// only.
template <Scalar S, Scalar Given>
std::uint32_t climb_support(const Hull<Given>& hull, const Vec3<S>& d, std::uint32_t start) {
  if (!hull.has_adjacency()) return detail::scan<S, Given>(hull, d);
  detail::NoCount count;
  return detail::climb<S, Given>(hull, d, start, count);
}

}  // namespace graze::inline GRAZE_LINKAGE
