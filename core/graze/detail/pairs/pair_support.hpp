// Vertices of C = A - B for the quick searches of two polytopes at rest, and when such a search may claim something.
//
// Internal length, world axes, in doubles whatever S is (prepared_pair.hpp). The searches follow guesses in floats.
// Their results rest on the farthest vertex in doubles, on weights that are not negative, and on the noise.
#pragma once

#include <graze/detail/pairs/prepared_pair.hpp>
#include <graze/detail/pairs/sweep_limits.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Written and read a number at a time, and never copied: a load that is wider than the stores before it waits for them.
struct PairVertex {
  Triple w;  // not set unless given
  std::uint32_t vertex_a, vertex_b;

  [[nodiscard]] bool is(const PairVertex& o) const {
    return vertex_a == o.vertex_a && vertex_b == o.vertex_b;
  }
};

template <Scalar S>
class PairSupport {
 public:
  explicit PairSupport(const PreparedPair<S>& pair, Counters& counters)
      : pair_(pair),
        counters_(counters),
        noise_(kContact * double(kUnitRoundoff<S>) * pair.size()),
        margin_(4 * (pair.a().error() + pair.b().error()) + pair.offset_error() +
                fl(40 * kUnitRoundoff<double> * pair.extent())),
        guess_(pair.a().support_error() + pair.b().support_error()) {}

  // Far along n, whose largest component is between 2^-80 and 2^80: within support_error() of the farthest, over |n|.
  [[gnu::noinline]] void guess(const Triple& n, PairVertex& out) { approximate_here(n, out); }
  // Inlined into the caller, which continues before the values are written to memory.
  [[gnu::always_inline]] void approximate_here(const Triple& n, PairVertex& out) {
    ++counters_.supports;
    set(pair_.a().support(n, out.vertex_a), pair_.b().support(-n, out.vertex_b), out);
  }
  // The farthest in doubles.
  [[gnu::noinline]] void sure(const Triple& n, PairVertex& out) {
    ++counters_.supports;
    set(pair_.a().farthest(n, out.vertex_a), pair_.b().farthest(-n, out.vertex_b), out);
  }
  void at(std::uint32_t vertex_a, std::uint32_t vertex_b, PairVertex& out) const {
    out.vertex_a = vertex_a;
    out.vertex_b = vertex_b;
    set(pair_.a().at(vertex_a), pair_.b().at(vertex_b), out);
  }
  [[nodiscard]] bool has(std::uint32_t vertex_a, std::uint32_t vertex_b) const {
    return pair_.a().has_vertex(vertex_a) && pair_.b().has_vertex(vertex_b);
  }
  // Is h(n) < `level` beyond rounding? At 0 the bodies are apart. w: a vertex far along n, which may come out farther.
  [[nodiscard]] bool separates(const Triple& n, PairVertex& w, double level = 0) {
    const double size = sum(magnitude(n)), bound = level - fl(margin_ * size);
    if (!(dot(n, w.w) < bound)) return false;
    if (dot(n, w.w) < bound - fl(guess_ * size)) return true;
    sure(n, w);
    return dot(n, w.w) < bound;
  }

  // Not at the lesser of 0 and `level`, if this is false. Both are compared, without a branch.
  [[nodiscard, gnu::always_inline]] bool may_separate(const Triple& n, const PairVertex& w,
                                                      double level) const {
    const double reach = dot(n, w.w), slack = fl(margin_ * sum(magnitude(n)));
    return bool(unsigned(reach < -slack) & unsigned(reach < level - slack));
  }

  [[nodiscard]] const PreparedPair<S>& pair() const { return pair_; }
  // The difference that rounding cannot tell from contact, and the goal of a search by distance (sweep.hpp).
  [[nodiscard]] double noise() const { return noise_; }
  [[nodiscard]] double fine() const { return noise_ / 8; }
  // The error bound on n.w over |n|_1, w the farthest vertex, path included: fast_walk.hpp.
  [[nodiscard]] double margin() const { return margin_; }
  // How far, over |n|_1, a guessed vertex may lie below the farthest.
  [[nodiscard]] double approximate_error() const { return guess_; }

 private:
  [[gnu::always_inline]] void set(const Triple& a, const Triple& b, PairVertex& out) const {
    const Triple& d = pair_.offset();
    out.w.x = a.x - (b.x + d.x);
    out.w.y = a.y - (b.y + d.y);
    out.w.z = a.z - (b.z + d.z);
  }

  const PreparedPair<S>& pair_;
  Counters& counters_;
  double noise_, margin_, guess_;
};

// Out of the range of directions that the scans in float keep.
[[nodiscard]] inline bool is_small_direction(const Triple& n) { return !(sum(magnitude(n)) > 0x1p-80); }
// n with its largest component near 1, scaled by a power of two, or n itself if it is near 1 already.
[[nodiscard]] inline Triple scaled_near_one(const Triple& n) {
  const double most = largest(n);
  if (most > 0x1p-20 && most < 0x1p20) return n;
  return most > 0 ? power_of_two(-exponent_of(most)) * n : n;
}

// sum lambda_i x_i of a body's vertices, world coordinates, caller's unit. k: the pair's length exponent.
template <Scalar S, std::size_t N>
[[nodiscard]] Vec3<S> pair_witness(const PreparedCore<S>& core, const std::array<std::uint32_t, N>& vertex,
                                   const std::array<double, N>& lambda, int size, int k) {
  Triple own{0, 0, 0};
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i)
    own = own + lambda[i] * core.own(vertex[i]);
  return (core.placed_center() + core.to_world(power_of_two(k) * own)).vector().template cast<S>();
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
