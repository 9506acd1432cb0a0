// Families that measure how the cost of a cast grows with the number of vertices. The hulls are points on ellipsoids,
// 16 to 4,096 in each hull, and the bodies have random orientations. Half of the cases are hits and half misses, judged
// by tier exact.
#include <fmt/format.h>

#include <graze/cast.hpp>

#include "bench/draw_casts.hpp"

namespace graze::bench {

std::vector<CastFamily> growth_families(const FamilySize& size) {
  std::vector<CastFamily> out;
  for (int n = 16; n <= 4096; n *= 2) {
    CastFamily& family = out.emplace_back();
    family.name = fmt::format("hulls of {}", n);
    family.rotated = true;
    Random random(corpus::fnv1a(family.name));
    for (std::size_t i = 0; i < size.shapes; ++i) family.shapes.push_back(round_hull(random, n, 1));
    fill_half(family, size.cases, {.tier = Tier::exact}, [&] { return aimed(random, family, 1, 3, 1.2); });
  }
  return out;
}

}  // namespace graze::bench
