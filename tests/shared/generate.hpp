// Small random shapes for the unit tests of core: a fixed generator, so that a failure comes back.
#pragma once

#include <graze/body.hpp>
#include <vector>

namespace graze::test {

// splitmix64 (Steele, Lea, Flood 2014).
struct Draw {
  std::uint64_t state;

  std::uint64_t bits() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }
  template <class S>
  Vec3<S> vector(double size) {
    return {static_cast<S>(between(-size, size)), static_cast<S>(between(-size, size)),
            static_cast<S>(between(-size, size))};
  }
  template <class S>
  Hull<S> hull(int vertices, double size) {
    std::vector<Vec3<S>> v;
    for (int i = 0; i < vertices; ++i) v.push_back(vector<S>(size));
    return Hull<S>(std::span<const Vec3<S>>(v));
  }
  template <class S>
  Quaternion<S> turn() {
    return {static_cast<S>(between(-1, 1)), static_cast<S>(between(-1, 1)), static_cast<S>(between(-1, 1)),
            static_cast<S>(between(-1, 1))};
  }
};

}  // namespace graze::test
