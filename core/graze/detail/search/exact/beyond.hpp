// Is any vertex of C strictly farther than a given one along an exact direction, and which?
//
//   n = sign (f_1 x f_2), an exact cross product of two terms;   n.(w - c_0) > 0 for some vertex w of C?
//
// C is a sum, so each leaf is queried alone: does it have a vertex x with n.(x - x_0) > 0, x_0 its vertex in c_0? If
// no leaf has one, c_0 is proved to be a maximum. Within a leaf, the sign in doubles decides if it is beyond its
// rounding. A tie by indices is decided for free. Everything else is decided exactly (exact_scene.hpp).
//
// Ties by construction are these three, or two of them combined:
//   - A step across an axis that n is parallel to.
//   - If two vertices of C in n's plane differ in one leaf only, their vertices of that leaf tie.
//   - For a box, x_0's three neighbours are enough, n being separable.
#pragma once

#include <cstddef>
#include <graze/detail/pairs/prepared_pair.hpp>
#include <graze/detail/search/exact/heights.hpp>
#include <graze/result.hpp>
#include <new>
#include <type_traits>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// n and its approximation in doubles: |approx_i - lambda n_i| <= error_i for some lambda > 0. An error of 0 means
// that n_i is 0.
struct Direction {
  Term f1, f2;
  int sign = 1;
  Vec3<double> approx = Vec3<double>::Zero(), error = Vec3<double>::Zero();
  // R^T n in the same form, in the axes of one body, or of both if their rotations are equal. If f_1 and f_2 are
  // differences of vertices of that body alone, it contains no rotation. of_body: whose axes.
  std::array<bool, 2> of_body = {false, false};
  // There is no f_1 x f_2: cases that doubles leave open stay open (BeyondSearch::in_doubt).
  bool rounded = false;
  Vec3<double> own = Vec3<double>::Zero(), own_error = Vec3<double>::Zero();
};

// A direction with unknown components in doubles. They are finite, so that no product with a 0 is NaN.
inline Direction unknown_direction(const Term& f1, const Term& f2, int sign) {
  Direction out{f1, f2, sign};
  out.error.setConstant(0x1p600);
  return out;
}

// The direction of two terms, rounded from pairs of doubles. Used for directions that are not available in doubles.
template <Scalar S>
Direction direction_of(const Scene<S>& scene, const Term& f1, const Term& f2, int sign) {
  const Fine x = scene.fine(f1), y = scene.fine(f2);
  const double size_x = std::max(x.size, 0x1p-1000), size_y = std::max(y.size, 0x1p-1000);
  // Near 1 first: the products must not vanish.
  const Pair scale_x{power_of_two(-exponent_of(size_x)), 0}, scale_y{power_of_two(-exponent_of(size_y)), 0};
  const Pair3 n = cross(scaled(x.x, scale_x), scaled(y.x, scale_y));
  Direction out{f1, f2, sign};
  for (int i = 0; i < 3; ++i) out.approx[i] = sign * rounded(n[static_cast<std::size_t>(i)]);
  // The factors are below 4, within 2^-90 of that each. The rounding of the result is added. With more parts,
  // kMaxParts = 2^12 of them at most, the low halves grow to 2^-40 of the size. Each of as many sums loses 2^-92 of
  // it and each product 2^-79: within 2^-78 a factor.
  out.error.setConstant((scene.has_fine() ? 0x1p-85 : 0x1p-72) +
                        kUnitRoundoff<double> * out.approx.cwiseAbs().maxCoeff());
  // Weights of many leaves, each deep in rotations, outgrow doubles: nothing is known then, and every sign is
  // decided exactly.
  if (!(norm_1(out.approx) < kInfinity<double>)) out = unknown_direction(f1, f2, sign);
  return out;
}

// More than the underflow of products in doubles, flushed or not.
inline constexpr double kUnderflow = 0x1p-960;

// One edge of C in doubles: the steps of A and of B that it is the difference of, each of two given numbers.
struct Steps {
  Triple a, b;

  [[nodiscard]] Triple edge() const { return a - b; }
  // The size of the summands: 0 if the edge's component is 0 exactly.
  [[nodiscard]] Triple size() const { return magnitude(a) + magnitude(b); }
};
// How far e x f in doubles is off: an edge is of two roundings, a product adds one, their difference another. 0 where
// the component is 0 exactly.
inline Vec3<double> normal_error(const Steps& e, const Steps& f) {
  const auto error = [](double a, double b, double c, double d) {
    const double size = fl(a * b) + fl(c * d);
    return size == 0 ? 0 : 8 * kUnitRoundoff<double> * size + kUnderflow;
  };
  const Triple p = e.size(), q = f.size();
  return {error(p.y, q.z, p.z, q.y), error(p.z, q.x, p.x, q.z), error(p.x, q.y, p.y, q.x)};
}

template <Scalar S>
class BeyondSearch {
 public:
  BeyondSearch(const Scene<S>& scene, const PreparedPair<S>& pair) : scene_(scene), pair_(pair) {}

  // `ties`: vertices of C with n.(tie - from) = 0.
  [[nodiscard]] bool find(const Direction& n, const Vertex& from, std::span<const Vertex> ties,
                          Vertex& beyond) const {
    bool found = false;
    beyond = from;
    const auto leaves = scene_.leaves();
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      // Not an optional: g++ 12 clears an empty one as a whole. Those 4 kB were 6 % of a cast's instructions.
      alignas(Heights<S>) std::byte room[sizeof(Heights<S>)];
      Search s{n, from, ties, static_cast<std::uint32_t>(i), leaves[i], room};
      search(s);
      if (!s.found) continue;
      found = true;
      beyond = leaves[i].with(beyond, s.best);
    }
    return found;
  }
  // For a rounded direction: was a vertex found that may be beyond?
  [[nodiscard]] bool in_doubt() const { return in_doubt_; }

 private:
  struct Search {
    const Direction& n;
    const Vertex& from;
    std::span<const Vertex> ties;
    std::uint32_t index;
    const Leaf<S>& leaf;
    std::byte* room;                            // of `heights`
    std::uint32_t at = 0;                       // of x_0
    Vec3<double> d = Vec3<double>::Zero();      // n in the leaf's own axes, negated for B
    Vec3<double> error = Vec3<double>::Zero();  // of a step's height, over the step's components
    Heights<S>* heights = nullptr;              // if doubles did not decide
    bool found = false;
    std::uint32_t best = 0;
  };

  void search(Search& s) const {
    const Leaf<S>& leaf = s.leaf;
    if (leaf.count == 1) return;
    s.at = leaf.vertex(s.from);
    s.d = s.n.approx;
    // Per component of d: the error of n (rotated: of three components) and that of the rotation. Then three products
    // and sums of differences that round once.
    if (!leaf.turned) {
      s.error = s.n.error + 8 * kUnitRoundoff<double> * s.d.cwiseAbs();
    } else if (s.n.of_body[leaf.of_b] && leaf.inner.empty()) {
      s.d = s.n.own;
      s.error = s.n.own_error + 8 * kUnitRoundoff<double> * s.d.cwiseAbs();
    } else {
      double turn = kCoreRotation * kUnitRoundoff<double>;
      if (leaf.inner.empty()) {
        s.d = (leaf.of_b ? pair_.b() : pair_.a()).to_own(triple(s.d)).vector();
      } else {
        s.d = turn_into(leaf, turn).transpose() * s.d;
      }
      s.error.setConstant(fl(1.8 * s.n.error.maxCoeff()) +
                          fl((turn + 8 * kUnitRoundoff<double>)*norm(s.n.approx)));
    }
    if (leaf.of_b) s.d = -s.d;
    if (const auto* hull = std::get_if<Hull<S>>(leaf.shape)) {
      search_hull(s, *hull);
    } else if (std::holds_alternative<Box<S>>(*leaf.shape)) {
      search_box(s);
    } else {
      for (std::uint32_t k = 0; k < leaf.count; ++k) try_vertex(s, k);
    }
  }

  // The leaf's whole rotation. R^T n is within `turn` |n| per component: each matrix within 16 u a row, each product
  // of two adds 3 sqrt(3) u.
  [[nodiscard, gnu::noinline]] static Mat3<double> turn_into(const Leaf<S>& leaf, double& turn) {
    Mat3<double> r = rotation_matrix(leaf.outer);
    for (const Quaternion<double>& q : leaf.inner) r = Mat3<double>(r * rotation_matrix(q));
    turn = 24 * static_cast<double>(leaf.inner.size() + 1) * kUnitRoundoff<double>;
    return r;
  }

  [[nodiscard]] static Vec3<double> vertex(const Leaf<S>& leaf, std::uint32_t k) { return leaf.point(k); }

  // A vertex beside x_0: is it farther?
  [[gnu::noinline]] void try_vertex(Search& s, std::uint32_t k) const {
    if (k == s.at) return;
    const Vec3<double> step = vertex(s.leaf, k) - vertex(s.leaf, s.at);
    const double height = dot(s.d, step), error = fl(1.01 * dot(s.error, step.cwiseAbs())) + kUnderflow;
    if (height < -error) return;
    if (height > error) {
      accept(s, k);
      return;
    }
    if (ties_by_axes(s, step) || ties_by_index(s, k) || ties_by_both(s, k)) return;
    if (rises_exactly(s, s.at, k)) accept(s, k);
  }
  // Takes the farthest of the vertices that are beyond, by the same signs. A cap of thousands of vertices may be
  // parallel to the plane up to the last bits. Any other choice would be correct there, and cost the walk one step
  // per vertex.
  void accept(Search& s, std::uint32_t k) const {
    if (s.found) {
      const Vec3<double> step = vertex(s.leaf, k) - vertex(s.leaf, s.best);
      const double height = dot(s.d, step), error = fl(1.01 * dot(s.error, step.cwiseAbs())) + kUnderflow;
      if (height < -error) return;
      if (!(height > error) && (ties_by_axes(s, step) || !rises_exactly(s, s.best, k))) return;
    }
    s.found = true;
    s.best = k;
  }
  [[nodiscard, gnu::noinline]] bool rises_exactly(Search& s, std::uint32_t from, std::uint32_t to) const {
    if (s.n.rounded) {
      in_doubt_ = true;
      return false;
    }
    static_assert(std::is_trivially_destructible_v<Heights<S>>);
    if (s.heights == nullptr) s.heights = ::new (s.room) Heights<S>(scene_, s.index, s.n.f1, s.n.f2);
    return s.heights->sign(from, to) * s.n.sign > 0;
  }
  // A step that is 0 along every axis along which n is not known to be: of a face across an axis.
  [[nodiscard]] static bool ties_by_axes(const Search& s, const Vec3<double>& step) {
    return (s.error[0] == 0 || step[0] == 0) && (s.error[1] == 0 || step[1] == 0) &&
           (s.error[2] == 0 || step[2] == 0);
  }
  // Do two vertices of C in the plane differ in this leaf only, as x_0 and k do?
  [[nodiscard]] bool ties_by_index(const Search& s, std::uint32_t k) const {
    const auto in_plane = [&](const Vertex& v) {
      return v == s.from || std::find(s.ties.begin(), s.ties.end(), v) != s.ties.end();
    };
    if (in_plane(s.leaf.with(s.from, k))) return true;
    return std::any_of(s.ties.begin(), s.ties.end(), [&](const Vertex& v) {
      return s.leaf.vertex(v) == s.at && in_plane(s.leaf.with(v, k));
    });
  }

  // A step across such axes from a vertex that ties by its index: the corner of a prism's side that no corner of the
  // portal has.
  [[nodiscard]] bool ties_by_both(const Search& s, std::uint32_t k) const {
    if (s.error[0] != 0 && s.error[1] != 0 && s.error[2] != 0) return false;
    return std::any_of(s.ties.begin(), s.ties.end(), [&](const Vertex& v) {
      const std::uint32_t other = s.leaf.vertex(v);
      return other != s.at && ties_by_axes(s, vertex(s.leaf, k) - vertex(s.leaf, other)) &&
             ties_by_index(s, other);
    });
  }

  void search_box(Search& s) const {
    // Bits of x_0's neighbours that are ties: single ones first, then those that remain of two.
    std::uint32_t level = 0;
    for (int round = 0; round < 2; ++round) {
      for (std::size_t i = 0; i < s.ties.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          const Vertex &tie = s.ties[i], &other = j < i ? s.ties[j] : s.from;
          if (s.leaf.with(other, s.leaf.vertex(tie)) != tie) continue;
          const std::uint32_t flips = (s.leaf.vertex(tie) ^ s.leaf.vertex(other)) & ~level;
          if (std::has_single_bit(flips)) level |= flips;
        }
      }
    }
    const Vec3<double> x = vertex(s.leaf, s.at);
    std::uint32_t flips = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const double step = -2 * x[static_cast<int>(i)], height = s.d[static_cast<int>(i)] * step;
      const double own = s.error[static_cast<int>(i)];
      if ((level >> i & 1u) != 0 || step == 0 || own == 0) continue;
      const double error = fl(1.01 * own * std::abs(step)) + kUnderflow;
      const bool up = std::abs(height) > error ? height > 0 : rises_exactly(s, s.at, s.at ^ (1u << i));
      if (up) flips |= 1u << i;
    }
    if (flips == 0) return;
    s.found = true;
    s.best = s.at ^ flips;
  }

  // All vertices whose height is not below x_0's beyond rounding: scan units, about the hull's centre.
  void search_hull(Search& s, const Hull<S>& hull) const {
    const Vec3<double> half = hull.scan_half_extents().template cast<double>();
    const double size = s.d.cwiseAbs().maxCoeff();
    // Near 1, so that no component that counts leaves the range of floats.
    const double scale = size > 0 ? power_of_two(-exponent_of(size)) : 1.0;
    const Vec3<float> d = (scale * s.d).template cast<float>();
    const float *x = hull.approximate_scan(0), *y = hull.approximate_scan(1), *z = hull.approximate_scan(2);
    const float height = fl(x[s.at] * d[0]) + fl(y[s.at] * d[1]) + fl(z[s.at] * d[2]);
    // The rounding of a height: u of d, u of the point, 3 u of products and sums, u of float, over at most 9/8 of the
    // half extents (hull.hpp). The same for x_0, and for the difference. The error of n counts over 2 half.
    const double rounding = 14 * kUnitRoundoff<float> * scale * dot(s.d.cwiseAbs(), half);
    const double error = fl(1.01 * (fl(2 * scale * dot(s.error, half)) + rounding)) + 0x1p-120;
    const float least = below(double(height) - error);
    if (hull.has_map() && search_list(s, hull.graph().map, d, least)) return;
    for_each_above(
        x, y, z, hull.padded_size(), d, least, [&](std::size_t first) { return known_in_chunk(s, first); },
        [&](std::size_t k) {
          if (k < hull.size()) try_vertex(s, static_cast<std::uint32_t>(k));
        });
  }
  // For a hull with a map and an n that is known well enough, searches only the list of n's cell. Every vertex
  // outside the list is lower than one in it by more than the rounding of floats. False: nothing was searched.
  [[nodiscard, gnu::noinline]] bool search_list(Search& s, const DirectionMap& map, const Vec3<float>& d,
                                                float least) const {
    DirectionMap::List list;
    if (!find_list(s, map, list)) return false;
    const float *x = list.xyz, *y = x + list.size, *z = y + list.size;
    for_each_above(x, y, z, list.size, d, least, [&](std::size_t k) {
      // The list's tail is its first again, which was tried.
      if (k == 0 || list.vertex[k] != list.vertex[0]) try_vertex(s, list.vertex[k]);
    });
    return true;
  }
  // For the 64 vertices from `first` on, a bit for x_0 and for those that tie by their index (ties_by_index), for two
  // leaves and three corners. It has no branch, as the owners of a portal's edges cannot be predicted.
  [[nodiscard]] std::uint64_t known_in_chunk(const Search& s, std::size_t first) const {
    const auto bit = [&](std::uint32_t k, unsigned tie) {
      return std::uint64_t{tie & unsigned(k - first < kScanChunk)} << (k & 63u);
    };
    std::uint64_t out = bit(s.at, 1);
    if (s.ties.size() != 2 || !scene_.is_of_two_leaves()) return out;
    const Vertex &v = s.from, &p = s.ties[0], &q = s.ties[1];
    const bool of_b = s.leaf.of_b;
    const std::uint32_t at_p = of_b ? p.b : p.a, at_q = of_b ? q.b : q.a, other_v = of_b ? v.a : v.b,
                        other_p = of_b ? p.a : p.b, other_q = of_b ? q.a : q.b;
    const unsigned with_p = unsigned(other_p == other_v), with_q = unsigned(other_q == other_v),
                   both = unsigned(other_p == other_q);
    out |= bit(at_p, with_p | (both & unsigned(at_q == s.at)));
    out |= bit(at_q, with_q | (both & unsigned(at_p == s.at)));
    return out;
  }
  // n's place on the cube is known within 2^-15. The map's squares are enlarged by that and more (direction_map.hpp).
  [[nodiscard]] static bool find_list(const Search& s, const DirectionMap& map, DirectionMap::List& out) {
    const Vec3<double> reach(map.reach()[0], map.reach()[1], map.reach()[2]);
    const double size = scaled_by_axis(s.d.cwiseAbs(), reach).maxCoeff();
    if (!(scaled_by_axis(s.error, reach).maxCoeff() <= 0x1p-17 * size) || !(size > 0)) return false;
    const double scale = power_of_two(-exponent_of(size));
    return map.find(float(scale * s.d[0]), float(scale * s.d[1]), float(scale * s.d[2]), out);
  }
  // A float that is not above x, |x| < 2^60, and at most 2^-22 |x| + 2^-124 below it. The amount subtracted exceeds
  // the rounding to a float, whether or not subnormal numbers are flushed. No branch.
  [[nodiscard]] static float below(double x) {
    return static_cast<float>(x - (0x1p-23 * std::abs(x) + 0x1p-125));
  }

  const Scene<S>& scene_;
  const PreparedPair<S>& pair_;
  mutable bool in_doubt_ = false;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
