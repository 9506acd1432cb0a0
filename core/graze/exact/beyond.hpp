// Is any vertex of C strictly farther than a given one along an exact direction, and which?
//
//   n = sign (f_1 x f_2), an exact cross product of two terms;   n.(w - c_0) > 0 for some vertex w of C?
//
// C is a sum, so each leaf is asked alone: whether it has a vertex x with n.(x - x_0) > 0, x_0 its vertex in
// c_0. If none has, c_0 is a maximum, the proved one. Within a leaf, by the sign in doubles where that is
// beyond its rounding, for free where it is a tie by its indices, else exactly (scene.hpp).
//
// Ties by construction. A vertex of C that lies in n's plane with c_0 and differs from it in one leaf only
// makes its vertex of that leaf a tie. A box: x_0's three neighbours are enough, n being separable, and
// neighbours make ties together. A hull with adjacency: x_0's neighbours are enough, a local maximum being
// one.
#pragma once

#include <graze/cso.hpp>
#include <graze/exact/scene.hpp>
#include <graze/result.hpp>

namespace graze::exact {

// n, and what doubles know of it: |approx_i - lambda n_i| <= error for some lambda > 0.
struct Direction {
  Term f1, f2;
  int sign = 1;
  Vec3<double> approx = Vec3<double>::Zero();
  double error = 0;
};

// The direction of two terms, rounded from pairs of doubles; for directions that are not at hand in doubles.
template <Scalar S>
Direction direction_of(const Scene<S>& scene, const Term& f1, const Term& f2, int sign) {
  const Fine x = scene.fine(f1), y = scene.fine(f2);
  const double size_x = std::max(x.size, 0x1p-1000), size_y = std::max(y.size, 0x1p-1000);
  detail::TwoDoubles3 p = x.x, q = y.x;
  // Near 1 first: the products must not vanish.
  const double scale_x = std::ldexp(1.0, -std::ilogb(size_x));
  const double scale_y = std::ldexp(1.0, -std::ilogb(size_y));
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = {p[i].hi * scale_x, p[i].lo * scale_x};
    q[i] = {q[i].hi * scale_y, q[i].lo * scale_y};
  }
  Direction out{f1, f2, sign, {}, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    out.approx[static_cast<int>(i)] = sign * (p[j] * q[k] + -(p[k] * q[j])).hi;
  }
  // Factors below 4, within 2^-90 of that each; and the rounding of the result.
  out.error = 0x1p-85 + kUnitRoundoff<double> * out.approx.cwiseAbs().maxCoeff();
  return out;
}

// A body's leaf in doubles: the rotation, and its rounding.
struct LeafView {
  Mat3<double> rotation = Mat3<double>::Identity();
  bool turned = false;
  double turn = 0;   // R^T n is within turn |n| per component, and R x within turn |x|
  double reach = 0;  // |x - y| <= 2 reach for any two of its vertices
};

// More than what products lose below the range of doubles, flushed or not.
inline constexpr double kUnderflow = 0x1p-960;

template <Scalar S>
class BeyondSearch {
 public:
  BeyondSearch(const Scene<S>& scene, const Cso<double>& cso) : scene_(scene), cso_(cso) {}

  // `ties`: vertices of C with n.(tie - from) = 0.
  [[nodiscard]] bool find(const Direction& n, const Vertex& from, std::span<const Vertex> ties,
                          Vertex& beyond) const {
    bool found = false;
    beyond = from;
    const auto leaves = scene_.leaves();
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      Search s{n, from, ties, static_cast<std::uint32_t>(i), leaves[i]};
      search(s);
      if (!s.found) continue;
      found = true;
      beyond = leaves[i].with(beyond, s.best);
    }
    return found;
  }

 private:
  struct Search {
    const Direction& n;
    const Vertex& from;
    std::span<const Vertex> ties;
    std::uint32_t index;
    const Leaf<S>& leaf;
    std::uint32_t at = 0;                   // of x_0
    Vec3<double> d = Vec3<double>::Zero();  // n in the leaf's own axes, negated for B
    double error = 0;                       // of d.(x - x_0) / (sum of magnitudes of x - x_0), see search()
    bool found = false;
    std::uint32_t best = 0;
    double height = 0;
  };

  void search(Search& s) const {
    const Leaf<S>& leaf = s.leaf;
    if (leaf.count == 1) return;
    s.at = leaf.vertex(s.from);
    const LeafView view = view_of(leaf);
    s.d = view.turned ? Vec3<double>(view.rotation.transpose() * s.n.approx) : s.n.approx;
    if (leaf.of_b) s.d = -s.d;
    // Per component of d: n's own error (turned: of three), the rotation's; then three products and sums of
    // differences that round once.
    const double largest = s.n.approx.norm();
    s.error = (view.turned ? 1.8 : 1.0) * s.n.error + (view.turn + 8 * kUnitRoundoff<double>)*largest;
    if (const auto* hull = std::get_if<Hull<S>>(leaf.shape)) {
      search_hull(s, *hull);
    } else if (std::holds_alternative<Box<S>>(*leaf.shape)) {
      search_box(s);
    } else {
      for (std::uint32_t k = 0; k < leaf.count; ++k) try_vertex(s, k);
    }
  }

  [[nodiscard]] LeafView view_of(const Leaf<S>& leaf) const {
    LeafView view;
    const auto& side = leaf.of_b ? cso_.side_b() : cso_.side_a();
    if (leaf.inner.empty()) {
      view.turned = side.rotated;
      view.rotation = side.rotation;
      view.turn = side.turn * kUnitRoundoff<double>;
      return view;
    }
    // Each matrix within 16 u per row sum, each product of two adds 3 sqrt(3) u.
    Mat3<double> r = Mat3<double>::Identity();
    int turns = 0;
    const auto turn = [&](const Quaternion<double>& q) {
      if (q.is_identity()) return;
      r = Mat3<double>(r * detail::rotation_matrix(q));
      ++turns;
    };
    turn(leaf.outer);
    for (const Quaternion<double>& q : leaf.inner) turn(q);
    view.turned = true;
    view.rotation = r;
    view.turn = 24 * turns * kUnitRoundoff<double>;
    return view;
  }

  [[nodiscard]] static Vec3<double> vertex(const Leaf<S>& leaf, std::uint32_t k) {
    return leaf_vertex(*leaf.shape, k);
  }

  // A vertex beside x_0: is it farther?
  void try_vertex(Search& s, std::uint32_t k) const {
    if (k == s.at) return;
    const Vec3<double> step = vertex(s.leaf, k) - vertex(s.leaf, s.at);
    const double height = s.d.dot(step), error = 1.01 * s.error * step.cwiseAbs().sum() + kUnderflow;
    if (height < -error) return;
    if (height > error) {
      accept(s, k, height);
      return;
    }
    if (ties_by_index(s, k)) return;
    if (scene_.determinant_sign(Term::step(s.index, s.at, k), s.n.f1, s.n.f2) * s.n.sign > 0)
      accept(s, k, height);
  }
  static void accept(Search& s, std::uint32_t k, double height) {
    if (s.found && !(height > s.height)) return;
    s.found = true;
    s.best = k;
    s.height = height;
  }
  // Does a tie differ from x_0's vertex in this leaf only, as k?
  [[nodiscard]] bool ties_by_index(const Search& s, std::uint32_t k) const {
    const Vertex as = s.leaf.with(s.from, k);
    return std::find(s.ties.begin(), s.ties.end(), as) != s.ties.end();
  }

  void search_box(Search& s) const {
    // Bits of x_0's neighbours that are ties: single ones first, then those that remain of two.
    std::uint32_t level = 0;
    for (int round = 0; round < 2; ++round) {
      for (const Vertex& tie : s.ties) {
        if (s.leaf.with(s.from, s.leaf.vertex(tie)) != tie) continue;
        const std::uint32_t flips = (s.leaf.vertex(tie) ^ s.at) & ~level;
        if (std::has_single_bit(flips)) level |= flips;
      }
    }
    const Vec3<double> x = vertex(s.leaf, s.at);
    std::uint32_t flips = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const double step = -2 * x[static_cast<int>(i)], height = s.d[static_cast<int>(i)] * step;
      if ((level >> i & 1u) != 0 || step == 0) continue;
      const double error = 1.01 * s.error * std::abs(step) + kUnderflow;
      const bool up =
          std::abs(height) > error
              ? height > 0
              : scene_.determinant_sign(Term::step(s.index, s.at, s.at ^ (1u << i)), s.n.f1, s.n.f2) *
                        s.n.sign >
                    0;
      if (up) flips |= 1u << i;
    }
    if (flips == 0) return;
    s.found = true;
    s.best = s.at ^ flips;
  }

  // All vertices whose height is not below x_0's beyond rounding: scan units, about the hull's centre.
  void search_hull(Search& s, const Hull<S>& hull) const {
    const S *x = hull.scan(0), *y = hull.scan(1), *z = hull.scan(2);
    const Vec3<double> half = hull.scan_half_extents().template cast<double>(),
                       middle = hull.scan_middle().template cast<double>();
    const Vec3<double>& d = s.d;
    // Heights round by 4 u sum |d_i| |x_i|; the difference of x and x_0 is at most 2 half.
    const double rounding = 8 * kUnitRoundoff<double> * d.cwiseAbs().dot(half + middle.cwiseAbs());
    const double error = 1.01 * (2 * s.error * half.sum() + rounding) + kUnderflow;
    const auto height = [&](std::size_t k) { return d[0] * x[k] + d[1] * y[k] + d[2] * z[k]; };
    const double least = height(s.at) - error;
    constexpr std::size_t kLanes = Hull<S>::kBlock;
    for (std::size_t i = 0; i < hull.padded_size(); i += kLanes) {
      double block[kLanes];
      for (std::size_t l = 0; l < kLanes; ++l) block[l] = height(i + l);
      double most = block[0];
      for (std::size_t l = 1; l < kLanes; ++l) most = block[l] > most ? block[l] : most;
      if (!(most >= least)) continue;
      for (std::size_t l = 0; l < kLanes && i + l < hull.size(); ++l) {
        if (block[l] >= least) try_vertex(s, static_cast<std::uint32_t>(i + l));
      }
    }
  }

  const Scene<S>& scene_;
  const Cso<double>& cso_;
};

}  // namespace graze::exact
