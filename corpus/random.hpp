// A random generator whose bits are the same everywhere: integers only, and exact conversions to double.
//
// xoshiro256** 1.0 (Blackman and Vigna, "Scrambled linear pseudorandom number generators", 2021), its state
// filled by splitmix64, as its authors advise.
#pragma once

#include <cstdint>
#include <string_view>

namespace graze::corpus {

// 64-bit FNV-1a, to mix a name into a seed.
[[nodiscard]] constexpr std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

class Random {
 public:
  explicit Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) word = splitmix64(seed);
  }

  std::uint64_t bits() {
    const std::uint64_t result = rotate(state_[1] * 5, 7) * 9, shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotate(state_[3], 45);
    return result;
  }

  // 0 .. n - 1, n >= 1. The remainder's bias, n / 2^64, is far below anything that is measured here.
  std::uint64_t below(std::uint64_t n) { return bits() % n; }
  // low .. high, both included.
  int integer(int low, int high) {
    const std::int64_t from = low, width = high - from;  // wider than int
    return static_cast<int>(from + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(width) + 1)));
  }
  // True once in n.
  bool once_in(std::uint64_t n) { return below(n) == 0; }
  // A multiple of 2^-53 in [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * unit(); }

 private:
  static std::uint64_t rotate(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }
  static std::uint64_t splitmix64(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state_[4];
};

}  // namespace graze::corpus
