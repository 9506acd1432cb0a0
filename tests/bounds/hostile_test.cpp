// The generator of hostile inputs reaches what it is for: every class, by what its scenes are and not by what
// they are called, and every pair of classes that the known defects need.
#include "tests/bounds/hostile.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <graze/detail/rotating/rotating_search.hpp>

#include <graze/rotating_cast.hpp>

namespace graze::test {
namespace {

constexpr int kScenes = 20000;

double most(const Vec3<double>& x) { return x.cwiseAbs().maxCoeff(); }

TEST(Hostile, EveryClassIsReached) {
  HostileDraw draw(1);
  std::array<int, kHostileClasses> seen{};
  for (int i = 0; i < kScenes; ++i) {
    const HostileScene scene = draw.scene();
    for (unsigned k = 0; k < kHostileClasses; ++k) seen[k] += scene.is(static_cast<Hostile>(k));
  }
  for (unsigned k = 0; k < kHostileClasses; ++k) EXPECT_GE(seen[k], kScenes / 100) << kHostileNames[k];
}

TEST(Hostile, EveryScenePassesTheDoor) {
  HostileDraw draw(2);
  for (int i = 0; i < kScenes; ++i) {
    const HostileScene scene = draw.scene();
    for (const RotatingBody<double>* body : {&scene.a, &scene.b}) {
      EXPECT_EQ(detail::validate(*body, scene.t_end), Invalid::none) << i;
    }
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(draw.direction(scene).norm(), 1, 0x1p-50) << i;
      const double t = draw.time(scene);
      EXPECT_TRUE(t >= 0 && t <= scene.t_end) << i;
    }
  }
}

// By the numbers.
TEST(Hostile, TheExtremesAreThere) {
  HostileDraw draw(3);
  double most_turned = 0, farthest_pivot = 0, farthest = 0, greatest = 0;
  int parallel = 0, touching_pivots = 0, along_spin = 0, tiny = 0, huge = 0, ulp_spins = 0, flat = 0;
  for (int i = 0; i < kScenes; ++i) {
    const HostileScene scene = draw.scene();
    const auto pivot = [](const RotatingBody<double>& x) {
      return Vec3<double>(x.body.position + detail::rotation_matrix(x.body.orientation) * x.pivot);
    };
    for (const RotatingBody<double>* body : {&scene.a, &scene.b}) {
      most_turned = std::max(most_turned, body->rotation.norm() * scene.t_end);
      greatest = std::max(greatest, most(body->body.position));
      if (!scene.is(Hostile::mixed_magnitudes)) {
        farthest_pivot = std::max(farthest_pivot, most(body->pivot));
        if (const auto* s = std::get_if<Segment<double>>(&body->body.shape))
          farthest = std::max(farthest, most(s->a));
      }
      const double least = most(body->body.displacement);
      tiny += least > 0 && least < 1e-40;
      huge += most(body->body.position) > 1e40;
      if (const auto* box = std::get_if<Box<double>>(&body->body.shape))
        flat += box->half_extents.minCoeff() == 0;
    }
    const Vec3<double>&w = scene.a.rotation, &other = scene.b.rotation;
    const Vec3<double> apart = pivot(scene.b) - pivot(scene.a);
    const double size = most(pivot(scene.a)) + most(pivot(scene.b));
    parallel += most(w) > 0 && w == other;
    ulp_spins += w != other && most(w - other) <= 0x1p-50 * most(w);
    touching_pivots += most(apart) <= 0x1p-48 * size;
    along_spin += most(w) > 0 && most(apart) > 0x1p-20 * size &&
                  unit(apart).cross(unit(w)).norm() <= 0x1p-20 && w == other;
  }
  EXPECT_GE(most_turned, 0x1p29);
  EXPECT_GE(farthest_pivot, 0x1p39);
  EXPECT_GE(farthest, 0x1p38);
  EXPECT_GE(greatest, 1e55);
  for (const int seen : {parallel, touching_pivots, ulp_spins, tiny, huge, flat})
    EXPECT_GE(seen, kScenes / 100);
  EXPECT_GE(along_spin, kScenes / 200);
}

}  // namespace
}  // namespace graze::test
