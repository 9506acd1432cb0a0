// Exact sums and products of doubles: expansions.
//
// An expansion is a sum of nonzero, non-overlapping doubles of increasing magnitude. Its last component has
// its sign, and the rounded sum is within 4 u of it, relatively. [Shewchuk, Adaptive Precision Floating-Point
// Arithmetic and Fast Robust Geometric Predicates, 1997: grow-expansion (theorem 10), scale-expansion
// (theorem 19)]
//
// Exact while no intermediate product of magnitude below 2^-968 or above 2^1023 occurs. The callers check the
// range of their inputs. Products are exact pairs and sums are Knuth's, so contraction changes nothing.
#pragma once

#include <graze/detail/numeric/offset.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

class Expansion {
 public:
  // A determinant of three columns of 4, 4 and 2 components has at most 768. Three of them are summed.
  static constexpr int kCapacity = 2304;

  Expansion() = default;
  explicit Expansion(double x) { grow(x); }
  Expansion(const Expansion& o) { *this = o; }
  Expansion& operator=(const Expansion& o) {
    if (this == &o) return *this;
    size_ = o.size_;
    for (int i = 0; i < size_; ++i) at(i) = o.at(i);
    return *this;
  }

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] int sign() const {
    if (size_ == 0) return 0;
    return at(size_ - 1) > 0 ? 1 : -1;
  }
  [[nodiscard]] double estimate() const {
    double sum = 0;
    for (int i = 0; i < size_; ++i) sum += at(i);
    return sum;
  }
  // False once something did not fit: no sign may be read then.
  [[nodiscard]] bool valid() const { return valid_; }

  // this += x
  void grow(double x) {
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      const TwoDoubles s = two_sum(x, at(i));
      if (s.lo != 0) at(kept++) = s.lo;
      x = s.hi;
    }
    if (x != 0) {
      if (kept < kCapacity) {
        at(kept++) = x;
      } else {
        valid_ = false;
      }
    }
    size_ = kept;
  }
  // this += factor * o
  void add(const Expansion& o, double factor = 1) {
    for (int i = 0; i < o.size_; ++i) {
      const TwoDoubles p = two_product(o.at(i), factor);
      grow(p.lo);
      grow(p.hi);
    }
    valid_ = valid_ && o.valid_;
  }
  // this += factor * a * b
  void add_product(const Expansion& a, const Expansion& b, double factor = 1) {
    Expansion scaled;
    scaled.add(a, factor);
    for (int i = 0; i < b.size_; ++i) add(scaled, b.at(i));
    valid_ = valid_ && b.valid_;
  }

 private:
  double& at(int i) { return components_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const double& at(int i) const { return components_[static_cast<std::size_t>(i)]; }

  std::array<double, kCapacity> components_;
  int size_ = 0;
  bool valid_ = true;
};

using Expansion3 = std::array<Expansion, 3>;

// a . (b x c)
inline Expansion determinant(const Expansion3& a, const Expansion3& b, const Expansion3& c) {
  Expansion out;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    if (a[i].size() == 0) continue;
    Expansion minor;
    minor.add_product(b[j], c[k]);
    minor.add_product(b[k], c[j], -1);
    out.add_product(minor, a[i]);
  }
  return out;
}

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
