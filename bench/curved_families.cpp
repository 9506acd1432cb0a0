// The families of curved casts: a pair of kinds each, half of the cases hits and half misses, bodies turned at random.
//
// Their judge is tier certified: its verdicts are proved.
#include <graze/cast.hpp>

#include "bench/draw_casts.hpp"

namespace graze::bench {
namespace {

CastOptions<double> judge() { return {.tier = Tier::certified}; }

double size(Random& random) { return to_float(random.uniform(0.25, 1)); }

Shape<double> sphere(Random& random) { return Sphere<double>{size(random)}; }
Shape<double> capsule(Random& random) {
  const double radius = size(random);
  return Capsule<double>{radius, size(random)};
}
Shape<double> box(Random& random) {
  const double x = size(random), y = size(random);
  return Box<double>{Vec3<double>(x, y, size(random))};
}
Shape<double> cylinder(Random& random) {
  const double radius = size(random);
  return Cylinder<double>{radius, size(random)};
}
Shape<double> cone(Random& random) {
  const double radius = size(random);
  return Cone<double>{radius, size(random)};
}
Shape<double> hull_of_16(Random& random) { return round_hull(random, 16, 1); }

}  // namespace

std::vector<CastFamily> curved_families(const FamilySize& size) {
  using Draw = Shape<double> (*)(Random&);
  struct Pair {
    const char* name;
    Draw a, b;
  };
  constexpr Pair kPairs[] = {{"sphere - sphere", sphere, sphere},           {"sphere - box", sphere, box},
                             {"capsule - capsule", capsule, capsule},       {"capsule - box", capsule, box},
                             {"capsule - hull of 16", capsule, hull_of_16}, {"cylinder - box", cylinder, box},
                             {"cylinder - cylinder", cylinder, cylinder},   {"cone - box", cone, box}};
  std::vector<CastFamily> out;
  for (const Pair& pair : kPairs) {
    Random random(corpus::fnv1a(pair.name));
    CastFamily& family = out.emplace_back();
    family.name = pair.name;
    family.rotated = true;
    for (std::size_t i = 0; i < size.shapes; ++i) {
      family.shapes.push_back((i < size.shapes / 2 ? pair.a : pair.b)(random));
    }
    fill_half(family, size.cases, judge(), [&] { return aimed(random, family, 1, 3, 1.3); });
  }
  return out;
}

}  // namespace graze::bench
