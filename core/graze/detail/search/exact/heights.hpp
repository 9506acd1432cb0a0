// Compares two vertices of a leaf along an exact direction n = f_1 x f_2. Use it for many comparisons along one n.
//
//   n.(+-R x) = +-(R^T n).x,   R the leaf's rotation, - for a leaf of B:
//
// n is formed once, in the leaf's own axes, in each of the two arithmetics beyond plain doubles (exact_scene.hpp), and
// each when first needed. A step between two vertices is there the difference of two given numbers, exact as a pair,
// so that a sign costs three products. Thousands of vertices may be closer to the plane than the rounding of doubles,
// as the caps of two prisms that are parallel up to the last bits.
//
// Fine. |q|^2 is the weight of R, X and Y the sizes of f_1 and f_2, D the step's largest component. The error bounds
// are:
//   - f_1 and f_2: 2^-92 of their sizes.
//   - n, at most 2 X Y: 2^-89.9 X Y (two products, and the rounding of pairs is below 2^-95 X Y).
//   - R^T n, at most 6 |q|^2 X Y: three times that times |q|^2, and 2^-95 |q|^2 X Y of its entries and products,
//     which is 2^-88.3 |q|^2 X Y.
//   - its product with the step: three times that times D, and 2^-93 |q|^2 X Y D, which is below 2^-86 |q|^2 X Y D.
//
// Leaves that combinators rotate inside their body have several rotations. Their comparisons are determinants.
#pragma once

#include <graze/detail/search/exact/exact_scene.hpp>
#include <optional>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

template <Scalar S>
class Heights {
 public:
  // Leaf `index` of the scene. The terms live as long.
  Heights(const Scene<S>& scene, std::uint32_t index, const Term& f1, const Term& f2)
      : scene_(scene),
        leaf_(scene.leaves()[index]),
        index_(index),
        f1_(f1),
        f2_(f2),
        inside_(!leaf_.inner.empty()),
        straight_(scene.is_straight(Term::step(index, 0, 0), f1, f2)) {
    if (!inside_ && scene.has_fine()) find_fine();
  }

  // The sign of n.(x_to - x_from), of the vertices as parts of C.
  [[nodiscard]] int sign(std::uint32_t from, std::uint32_t to) {
    if (inside_) return scene_.determinant_sign(Term::step(index_, from, to), f1_, f2_);
    const int own = own_sign(scene_.at(leaf_, from), scene_.at(leaf_, to));
    return leaf_.of_b ? -own : own;
  }

 private:
  static constexpr double kFineError = 0x1p-86;

  [[nodiscard]] bool turns() const { return !straight_ && leaf_.turned; }

  void find_fine() {
    const Fine x = scene_.fine(f1_, straight_), y = scene_.fine(f2_, straight_);
    size_ = x.size * y.size;
    if (fuses()) {
      set_fine<true>(x, y);
    } else {
      set_fine<false>(x, y);
    }
    const auto is_zero = [](const Pair& p) { return p.hi == 0 && p.lo == 0; };
    for (std::size_t i = 0; i < 3; ++i) level_[i] = !turns() && is_zero(x.x[i]) && is_zero(y.x[i]);
    on_grid_ = !turns() && !x.weighted && !y.weighted;
  }
  template <bool kFused>
  [[gnu::flatten, gnu::noinline]] void set_fine(const Fine& x, const Fine& y) {
    const Pair3Of<kFused> n = cross(pairs_as<kFused>(x.x), pairs_as<kFused>(y.x));
    fine_ = pairs_as<false>(n);
    if (!turns()) return;
    const FineTurn& turn = scene_.turn(leaf_.of_b, leaf_.outer);
    for (std::size_t i = 0; i < 3; ++i) {
      const Pair3Of<kFused> column = {pair_as<kFused>(turn.row[0][i]), pair_as<kFused>(turn.row[1][i]),
                                      pair_as<kFused>(turn.row[2][i])};
      fine_[i] = pair_as<false>(dot(column, n));
    }
    size_ *= turn.weight.hi;
  }
  template <bool kFused>
  [[nodiscard, gnu::flatten, gnu::noinline]] double fine_height(const Pair3& step) const {
    return rounded(dot(pairs_as<kFused>(fine_), pairs_as<kFused>(step)));
  }

  [[nodiscard]] int own_sign(const Vec3<double>& from, const Vec3<double>& to) {
    if (from == to) return 0;
    const Pair3 step = {difference(to[0], from[0]), difference(to[1], from[1]), difference(to[2], from[2])};
    const double size = size_ * std::max({std::abs(step[0].hi), std::abs(step[1].hi), std::abs(step[2].hi)});
    if (size > Scene<S>::kLeastSize && size < Scene<S>::kMostSize) {
      const double value = fuses() ? fine_height<true>(step) : fine_height<false>(step),
                   error = kFineError * size;
      if (value > error) return 1;
      if (value < -error) return -1;
      // All three in one plane across an axis: a row of their determinant is 0.
      for (std::size_t i = 0; i < 3; ++i) {
        if (level_[i] && step[i].hi == 0) return 0;
      }
      if (on_grid_) {
        const int grid = grid_of_terms() + std::min(trailing_exponent(from), trailing_exponent(to));
        if (grid > -900 && std::abs(value) + error < power_of_two(std::min(grid, 0))) return 0;
      }
    }
    return exact_sign(from, to);
  }
  [[nodiscard]] int grid_of_terms() {
    if (!has_grid_) grid_ = scene_.grid_of(f1_) + scene_.grid_of(f2_);
    has_grid_ = true;
    return grid_;
  }
  [[nodiscard, gnu::noinline]] int exact_sign(const Vec3<double>& from, const Vec3<double>& to) {
    scene_.count_exact_decision();
    if (!exact_) {
      const bool own = straight_ && leaf_.turned;
      Exact n;
      n.x = cross(scene_.exact(f1_, own).x, scene_.exact(f2_, own).x);
      const Quaternion<double>& q = leaf_.outer;
      if (turns()) ExactTurn{{q.w, -q.x, -q.y, -q.z}}(n);
      exact_.emplace(n.x);
    }
    const Dyadic height = dot(*exact_, Exact::of(to, from).x);
    if (!height.valid()) scene_.invalidate();
    return height.sign();
  }

  const Scene<S>& scene_;
  const Leaf<S>& leaf_;
  std::uint32_t index_;
  const Term &f1_, &f2_;
  bool inside_, straight_;
  bool on_grid_ = false, has_grid_ = false;
  int grid_ = 0;
  std::array<bool, 3> level_ = {false, false, false};  // f_1 and f_2 are 0 along the axis
  // n in the leaf's axes, times |q|^2 if the leaf is rotated. size_: |q|^2 X Y, or 0 if pairs are not accurate
  // enough.
  Pair3 fine_;
  double size_ = 0;
  std::optional<Dyadic3> exact_;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
