// cast_all allocates nothing in the caller's thread, and validating a scene nothing for a body: every allocation of this
// program is counted.
#include <gtest/gtest.h>
#include <graze/cast_all.hpp>
#include <graze/scene.hpp>

#include <cstdlib>
#include <new>

namespace {
std::size_t allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
// Not inlined: g++ would see free() called on what its own operator new returned.
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace graze::scene {
namespace {

TEST(CastAll, AllocatesNothing) {
  std::vector<Body<double>> bodies;
  for (int k = 0; k < 40; ++k) {
    bodies.push_back({.shape = Box<double>{{0.5, 0.5, 0.5}},
                      .position = {0.5 * k, 0, 0},
                      .displacement = {0, 1.0 - 0.1 * k, 1}});
    if (k % 2 == 1) bodies.back().shape = Capsule<double>{0.25, 0.5};
  }
  std::vector<Question> questions;
  for (const Body<double>& a : bodies) {
    for (const Body<double>& b : bodies) questions.push_back({&a, &b});
  }
  const std::vector<RayQuestion> rays(40, RayQuestion{{0, 0, -4}, {0, 0.1, 1}});
  std::vector<CastResult<double>> answers(questions.size());
  const std::size_t before = allocations;
  cast_all(questions, answers);
  cast_all(bodies[0], bodies, answers);
  cast_rays(bodies[0], rays, answers);
  EXPECT_EQ(allocations, before);
  EXPECT_GT(before, 0u);
}

// The exact cast of a combinator allocates its list of leaves, so a cast to validate a body would be seen.
TEST(Scene, ValidatingAnExactSceneCastsNothing) {
  const auto allocated = [](std::size_t bodies) {
    Scene scene;
    scene.bodies.resize(bodies);
    for (Member& member : scene.bodies)
      member.body.body.shape = posed<double>(Box<double>{{1, 2, 3}}, {1, 0, 0}, {1, 2, 0, 0});
    Options options;
    options.tier = Tier::exact;
    const std::size_t before = allocations;
    EXPECT_EQ(why_invalid(scene, options), "");
    return allocations - before;
  };
  EXPECT_EQ(allocated(100), allocated(10));
}

}  // namespace
}  // namespace graze::scene
