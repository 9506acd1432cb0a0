// The first of many points that is greatest along a direction, its coordinates stored by axis.
//
//   value_k = x_k d_x + y_k d_y + z_k d_z, as rounded (products, then sums from the left, and nothing fused).
// The scan returns the least k of the greatest value. NaN loses against everything.
//
// It works in chunks. For each chunk it computes the values and their greatest, without a branch, and finds the index
// only if that is a new greatest. The number n counts whole blocks of 8 (hull.hpp pads with copies of point 0).
//
// Measured (bench/support_bench.cpp), ns a scan of 8, 16, 32, 64, 256 points: see docs/reports/costs.md.
#pragma once

#include <bit>
#include <graze/detail/numeric/pack.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

inline constexpr std::size_t kScanChunk = 64;

// The scan of at most kScanChunk points.
template <Scalar S>
inline std::size_t scan_chunk(const S* x, const S* y, const S* z, std::size_t n, const Vec3<S>& d, S& most) {
  using P = Pack<S>;
  constexpr std::size_t kStep = P::kSize;
  const typename P::Type dx = P::all(d[0]), dy = P::all(d[1]), dz = P::all(d[2]);
  const auto at = [&](std::size_t k) {
    return P::add(P::add(P::mul(P::load(x + k), dx), P::mul(P::load(y + k), dy)), P::mul(P::load(z + k), dz));
  };
  S value[kScanChunk];
  typename P::Type greatest = P::all(-kInfinity<S>);
  for (std::size_t i = 0; i < n; i += 2 * kStep) {
    const auto a = at(i), b = at(i + kStep);
    P::store(value + i, a);
    P::store(value + i + kStep, b);
    greatest = P::max(P::max(a, b), greatest);
  }
  most = P::greatest(greatest);
  // A bit for each that is equal: no branch that depends on where it is.
  const auto wanted = P::all(most);
  std::uint64_t equal = 0;
  for (std::size_t i = n; i > 0; i -= 2 * kStep) {
    const unsigned low = P::bits(P::equal(P::load(value + i - 2 * kStep), wanted)),
                   high = P::bits(P::equal(P::load(value + i - kStep), wanted));
    equal = equal << (2 * kStep) | (low | high << kStep);
  }
  return static_cast<std::size_t>(std::countr_zero(equal));
}

template <Scalar S>
inline std::size_t scan(const S* x, const S* y, const S* z, std::size_t n, const Vec3<S>& d) {
  GRAZE_ASSERT(n > 0 && n % 8 == 0);
  S top;
  const std::size_t first = scan_chunk(x, y, z, std::min(n, kScanChunk), d, top);
  std::size_t best = first < n ? first : 0;  // NaN: none is equal
  if (n <= kScanChunk) return best;
  for (std::size_t begin = kScanChunk; begin < n; begin += kScanChunk) {
    S most;
    const std::size_t k =
        scan_chunk(x + begin, y + begin, z + begin, std::min(n - begin, kScanChunk), d, most);
    if (!(most > top)) continue;
    top = most;
    best = begin + k;
  }
  return best;
}
// A bit for each of at most kScanChunk points whose value is not below `least`, as rounded. NaN counts as not below.
inline std::uint64_t above_in_chunk(const float* x, const float* y, const float* z, std::size_t n,
                                    const Vec3<float>& d, float least) {
  using P = Pack<float>;
  const P::Type dx = P::all(d[0]), dy = P::all(d[1]), dz = P::all(d[2]), bound = P::all(least);
  const auto above = [&](std::size_t k) {
    const P::Type value =
        P::add(P::add(P::mul(P::load(x + k), dx), P::mul(P::load(y + k), dy)), P::mul(P::load(z + k), dz));
    return P::bits(P::below(value, bound)) ^ 0xfu;
  };
  std::uint64_t out = 0;
  for (std::size_t k = 0; k < n; k += 8) out |= std::uint64_t{above(k) | above(k + 4) << 4} << k;
  return out;
}

// visit(k) for every point of value not below `least`, except those of a chunk, named by its first, for which
// skipped() has bits.
template <class Skipped, class Visit>
void for_each_above(const float* x, const float* y, const float* z, std::size_t n, const Vec3<float>& d,
                    float least, const Skipped& skipped, const Visit& visit) {
  for (std::size_t first = 0; first < n; first += kScanChunk) {
    const std::size_t size = std::min(n - first, kScanChunk);
    std::uint64_t above = above_in_chunk(x + first, y + first, z + first, size, d, least) & ~skipped(first);
    for (; above != 0; above &= above - 1) visit(first + static_cast<std::size_t>(std::countr_zero(above)));
  }
}
template <class Visit>
void for_each_above(const float* x, const float* y, const float* z, std::size_t n, const Vec3<float>& d,
                    float least, const Visit& visit) {
  for_each_above(
      x, y, z, n, d, least, [](std::size_t) { return std::uint64_t{0}; }, visit);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
