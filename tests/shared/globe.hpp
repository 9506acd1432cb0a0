// A polytope of any size whose faces are known: points on circles of latitude, and the two poles.
#pragma once

#include <cmath>
#include <graze/hull.hpp>

namespace graze::test {

template <class S>
struct Globe {
  std::vector<Vec3<S>> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;  // counter-clockwise seen from outside
};

// rings * around + 2 vertices, rounded to S: the quadrangles between two circles are flat except for that.
template <class S>
Globe<S> globe(int rings, int around, double radius) {
  const double pi = std::acos(-1.0);
  Globe<S> out;
  for (int r = 0; r < rings; ++r) {
    const double polar = pi * (r + 1) / (rings + 1);
    for (int k = 0; k < around; ++k) {
      const double turn = 2 * pi * k / around;
      out.vertices.push_back((radius * Vec3<double>(std::sin(polar) * std::cos(turn),
                                                    std::sin(polar) * std::sin(turn), std::cos(polar)))
                                 .template cast<S>());
    }
  }
  const auto at = [&](int r, int k) { return static_cast<std::uint32_t>(r * around + k % around); };
  const auto north = static_cast<std::uint32_t>(out.vertices.size()), south = north + 1;
  out.vertices.push_back(Vec3<S>(0, 0, static_cast<S>(radius)));
  out.vertices.push_back(Vec3<S>(0, 0, static_cast<S>(-radius)));
  for (int k = 0; k < around; ++k) {
    out.faces.push_back({north, at(0, k), at(0, k + 1)});
    for (int r = 0; r + 1 < rings; ++r) {
      out.faces.push_back({at(r, k), at(r + 1, k), at(r + 1, k + 1)});
      out.faces.push_back({at(r, k), at(r + 1, k + 1), at(r, k + 1)});
    }
    out.faces.push_back({south, at(rings - 1, k + 1), at(rings - 1, k)});
  }
  return out;
}

}  // namespace graze::test
