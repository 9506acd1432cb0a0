// How a hull is prepared: its scan, declared in graze/hull.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <graze/detail/numeric/machine.hpp>
#include <graze/hull.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

template <Scalar S>
Hull<S>::Hull(std::span<const Vec3<S>> vertices) : data_(std::make_shared<const Data>(vertices)) {}

template <Scalar S>
Hull<S>::Data::Data(std::span<const Vec3<S>> given) : vertices(given.begin(), given.end()) {
  if (vertices.empty()) return;
  Vec3<S> low = vertices[0], high = vertices[0];
  for (const Vec3<S>& v : vertices) {
    for (int i = 0; i < 3; ++i) {
      const S magnitude = std::abs(v[i]);
      if (!(magnitude <= std::numeric_limits<S>::max())) finite = false;
      flushed = flushed || is_flushed(v[i]);
      largest = magnitude > largest ? magnitude : largest;
      if (magnitude > 0 && (smallest == 0 || magnitude < smallest)) smallest = magnitude;
    }
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  if (!finite) return;
  for (int i = 0; i < 3; ++i) {
    // Halved before adding: the sum of two finite numbers may overflow.
    const S middle_i = low[i] / 2 + high[i] / 2, half_i = high[i] / 2 - low[i] / 2;
    if (std::abs(middle_i) > S(2.5) * half_i) center[i] = middle_i;
  }
  S most_of_all = 0;
  for (const Vec3<S>& v : vertices) most_of_all = std::max(most_of_all, (v - center).cwiseAbs().maxCoeff());
  for (int i = 0; i < 3; ++i) {
    const auto less = [i](const Vec3<S>& x, const Vec3<S>& y) { return x[i] < y[i]; };
    const auto [least, greatest] = std::minmax_element(vertices.begin(), vertices.end(), less);
    // Sixths are added: no sum of large numbers overflows.
    for (const auto at : {least, greatest}) inside += (*at - center).template cast<double>() / 6;
  }
  exponent = most_of_all > 0 ? std::ilogb(most_of_all) : 0;
  // x 2^-exponent, rounded once if at all: by a product, where the power is a normal number.
  const bool normal = std::abs(exponent) < std::numeric_limits<S>::max_exponent - 2;
  const S power = normal ? static_cast<S>(power_of_two(-exponent)) : S(1);
  const auto scaled = [&](S x) { return normal ? x * power : std::scalbn(x, -exponent); };
  padded = (vertices.size() + kBlock - 1) / kBlock * kBlock;
  scan.resize(3 * padded);
  for (std::size_t k = 0; k < padded; ++k) {
    const Vec3<S>& v = vertices[k < vertices.size() ? k : 0];
    for (std::size_t i = 0; i < 3; ++i) {
      scan[i * padded + k] = scaled(v[static_cast<int>(i)] - center[static_cast<int>(i)]);
    }
  }
  for (int i = 0; i < 3; ++i) {
    const S l = scaled(low[i] - center[i]), h = scaled(high[i] - center[i]);
    scan_low[i] = l;
    scan_high[i] = h;
    half[i] = (h - l) / 2;
    middle[i] = l + half[i];
  }
  const Vec3<double> extent =
      power_of_two(exponent) * (half.template cast<double>() + middle.cwiseAbs().template cast<double>());
  size = extent.maxCoeff();
  reach = detail::square_root(detail::fl(extent[0] * extent[0]) + detail::fl(extent[1] * extent[1]) +
                              detail::fl(extent[2] * extent[2])) *
          (1 + 0x1p-50);
  // An offset below an eighth of the extent costs no more than that: not worth a second scan.
  if (!((middle.cwiseAbs() - half / 8).maxCoeff() <= 0)) {
    choice = scan;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < padded; ++k) choice[i * padded + k] -= middle[static_cast<int>(i)];
    }
  }
  if constexpr (std::same_as<S, double>) {
    const std::vector<S>& from = choice.empty() ? scan : choice;
    guess.resize(from.size());
    for (std::size_t k = 0; k < from.size(); ++k) guess[k] = static_cast<float>(from[k]);
  }
}

}}  // namespace graze::GRAZE_LINKAGE
