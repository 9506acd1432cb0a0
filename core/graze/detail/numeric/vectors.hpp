// Vectors in the two arithmetics beyond plain doubles, and rotations of them: nothing is divided, so each has
// a positive weight, the |q|^2 of the rotations in it.
//
//   Fine   pairs of doubles (pair.hpp): each coordinate within 2^-92 size of what it stands for, where size
//          bounds |x_i|, if it is a sum of at most 16 parts (Scene::has_fine) after at most 17 rotations:
//          a rotation adds 2^-97 of size (what was added before anything cancelled), a sum or a weight 2^-99,
//          and low halves stay below 2^-49 of size, as 16 sums add 2^-53 of it each;
//   Exact  dyadic numbers.
#pragma once

#include <graze/detail/numeric/dyadic.hpp>
#include <graze/detail/numeric/pair.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// A vector in pairs of doubles.
struct Fine {
  Pair3 x = {Pair{0, 0}, Pair{0, 0}, Pair{0, 0}};
  double size = 0;
  Pair weight{1, 0};  // > 0
  bool weighted = false;

  // x - y, exact: however far out x and y are, nothing is lost, so its size is that of the difference.
  static Fine of(const Vec3<double>& x, const Vec3<double>& y) {
    Fine out;
    for (int i = 0; i < 3; ++i) {
      const Pair d = difference(x[i], y[i]);
      out.x[static_cast<std::size_t>(i)] = d;
      out.size = std::max(out.size, size_of(d));
    }
    return out;
  }
  // Bounds |x|, x being a rounded sum of two with |lo| <= u |hi|. It is 0 only if x is.
  static double size_of(const Pair& x) { return (1 + 0x1p-52) * std::abs(x.hi); }
  static Fine of(const Vec3<double>& x) {
    Fine out;
    for (int i = 0; i < 3; ++i) out.x[static_cast<std::size_t>(i)].hi = x[i];
    out.size = x.cwiseAbs().maxCoeff();
    return out;
  }
  void add(const Fine& part, bool negative) {
    if (part.weighted || weighted) return add_weighted(part, negative);
    for (std::size_t i = 0; i < 3; ++i) x[i] = x[i] + (negative ? -part.x[i] : part.x[i]);
    size += part.size;
  }

 private:
  void add_weighted(const Fine& part, bool negative) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Pair own = part.weighted ? x[i] * part.weight : x[i];
      const Pair more = weighted ? part.x[i] * weight : part.x[i];
      x[i] = own + (negative ? -more : more);
    }
    size = fl(size * part.weight.hi) + fl(part.size * weight.hi);
    if (part.weighted) weight = weighted ? weight * part.weight : part.weight;
    weighted = true;
  }
};

// |q|^2 R(q) and |q|^2, for a q whose largest component is in [1, 2): entries within 2^-99 |q|^2. T: of one q, or of two
// side by side.
template <class T>
struct FineTurnOf {
  std::array<Pair3Of<false, T>, 3> row;  // not set by the default constructor
  PairOf<false, T> weight;

  // Flat, so that a number is split once for all its products.
  template <bool kFused>
  [[gnu::flatten]] void form(T w, T x, T y, T z) {
    using P = PairOf<kFused, T>;
    const auto times = [](T a, T b) { return product<kFused>(a, b); };
    const P ww = times(w, w), xx = times(x, x), yy = times(y, y), zz = times(z, z);
    const P xy = times(x, y), xz = times(x, z), yz = times(y, z), wx = times(w, x), wy = times(w, y),
            wz = times(w, z);
    const auto same = [](const P& p) { return pair_as<false>(p); };
    const auto twice = [](const P& p) { return PairOf<false, T>{2.0 * p.hi, 2.0 * p.lo}; };
    row[0] = {same((ww + xx) - (yy + zz)), twice(xy - wz), twice(xz + wy)};
    row[1] = {twice(xy + wz), same((ww + yy) - (xx + zz)), twice(yz - wx)};
    row[2] = {twice(xz - wy), twice(yz + wx), same((ww + zz) - (xx + yy))};
    weight = same((ww + xx) + (yy + zz));
  }
  template <bool kFused>
  [[nodiscard, gnu::flatten]] Pair3Of<kFused, T> of(const Pair3Of<kFused, T>& x) const {
    const auto along = [&](std::size_t i) { return dot(pairs_as<kFused>(row[i]), x); };
    return {along(0), along(1), along(2)};
  }
};

struct FineTurn : FineTurnOf<double> {
  FineTurn() = default;
  explicit FineTurn(const Quaternion<double>& q) {
    if (fuses()) {
      form<true>(q.w, q.x, q.y, q.z);
    } else {
      form<false>(q.w, q.x, q.y, q.z);
    }
  }
  void operator()(Fine& v) const {
    v.x = fuses() ? turned<true>(v.x) : turned<false>(v.x);
    v.size *= 2 * weight.hi;  // |R x|_i <= |x|_2 < 2 |x|_inf
    v.weight = v.weighted ? v.weight * weight : weight;
    v.weighted = true;
  }
  template <bool kFused>
  [[nodiscard]] Pair3 turned(const Pair3& x) const {
    return pairs_as<false>(of<kFused>(pairs_as<kFused>(x)));
  }
};

// A vector in dyadic numbers.
struct Exact {
  Dyadic3 x;
  Dyadic weight = Dyadic(1);  // > 0
  bool weighted = false;      // the weight is not 1

  static Exact of(const Vec3<double>& x, const Vec3<double>& y) {
    Exact out;
    for (int i = 0; i < 3; ++i) out.x[static_cast<std::size_t>(i)] = Dyadic(x[i]) - Dyadic(y[i]);
    return out;
  }
  static Exact of(const Vec3<double>& x) {
    Exact out;
    for (int i = 0; i < 3; ++i) out.x[static_cast<std::size_t>(i)] = Dyadic(x[i]);
    return out;
  }
  void add(const Exact& part, bool negative) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Dyadic more = weighted ? part.x[i] * weight : part.x[i];
      x[i] = (part.weighted ? x[i] * part.weight : x[i]) + (negative ? -more : more);
    }
    if (part.weighted) weight = weighted ? weight * part.weight : part.weight;
    weighted = weighted || part.weighted;
  }
};

struct ExactTurn {
  Quaternion<double> q;
  void operator()(Exact& e) const {
    const Dyadic w(q.w);
    const Dyadic3 u = {Dyadic(q.x), Dyadic(q.y), Dyadic(q.z)};
    const Dyadic ww = w * w, uu = dot(u, u), along = dot(u, e.x).times_power_of_two(1);
    const Dyadic straight = ww - uu, twist = w.times_power_of_two(1);
    const Dyadic3 around = cross(u, e.x);
    for (std::size_t i = 0; i < 3; ++i) e.x[i] = straight * e.x[i] + along * u[i] + twist * around[i];
    e.weight = e.weighted ? e.weight * (ww + uu) : ww + uu;
    e.weighted = true;
  }
};

// The exponent of the last bit of x that is set, or kAnyGrid for 0.
inline constexpr int kAnyGrid = 100000;
inline int trailing_exponent(double x) {
  const auto bits = detail::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t magnitude = biased == 0 ? fraction : fraction | std::uint64_t{1} << 52;
  return magnitude == 0 ? kAnyGrid : std::max(biased, 1) - 1075 + std::countr_zero(magnitude);
}
inline int trailing_exponent(const Vec3<double>& x) {
  return std::min({trailing_exponent(x[0]), trailing_exponent(x[1]), trailing_exponent(x[2])});
}

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
