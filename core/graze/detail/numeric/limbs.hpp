// Sums and products of 64-bit limbs, with a carry: the steps of multiprecision arithmetic (dyadic.hpp).
//
// A product of two limbs has 128 bits. Compilers with a 128-bit integer use it. Others (MSVC, 32-bit targets) use
// multiply_add_in_halves(), which gives the same limbs.
#pragma once

#include <cstdint>
#include <graze/linkage.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

using Limb = std::uint64_t;

// x + y + carry: the low limb. `carry`, 0 or 1, becomes the next one.
constexpr Limb add(Limb x, Limb y, Limb& carry) {
  const Limb sum = x + y, out = sum + carry;
  carry = (sum < x ? 1U : 0U) | (out < sum ? 1U : 0U);
  return out;
}

// x - y - borrow: the low limb. `borrow`, 0 or 1, becomes the next one.
constexpr Limb subtract(Limb x, Limb y, Limb& borrow) {
  const Limb difference = x - y, out = difference - borrow;
  borrow = (x < y ? 1U : 0U) | (difference < borrow ? 1U : 0U);
  return out;
}

// x y + z + carry: the low limb. `carry`, any limb, becomes the high one. The sum fits: (2^64 - 1)^2 + 2 (2^64 - 1) is
// 2^128 - 1.
constexpr Limb multiply_add_in_halves(Limb x, Limb y, Limb z, Limb& carry) {
  constexpr Limb kHalf = 0xffffffff;
  const Limb x0 = x & kHalf, x1 = x >> 32, y0 = y & kHalf, y1 = y >> 32;
  // Each sum is at most (2^32 - 1)^2 + 2 (2^32 - 1) = 2^64 - 1.
  const Limb low = x0 * y0 + (z & kHalf) + (carry & kHalf);
  const Limb middle = x1 * y0 + (z >> 32) + (low >> 32);
  const Limb cross = x0 * y1 + (middle & kHalf) + (carry >> 32);
  carry = x1 * y1 + (middle >> 32) + (cross >> 32);
  return cross << 32 | (low & kHalf);
}

#ifdef __SIZEOF_INT128__
constexpr Limb multiply_add(Limb x, Limb y, Limb z, Limb& carry) {
  __extension__ using Wide = unsigned __int128;
  const Wide sum = static_cast<Wide>(x) * y + z + carry;
  carry = static_cast<Limb>(sum >> 64);
  return static_cast<Limb>(sum);
}
#else
constexpr Limb multiply_add(Limb x, Limb y, Limb z, Limb& carry) {
  return multiply_add_in_halves(x, y, z, carry);
}
#endif

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
