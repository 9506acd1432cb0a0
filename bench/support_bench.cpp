// The support of a hull by the scan, and by the climb: cold, warm from a direction 0.01 or 0.3 away, and warm
// from a direction that has nothing to do with it. 8 to 4096 vertices, on a sphere and on a cylinder (two
// rings: flat caps, near-ties), double and float. `heights`: vertices looked at, on average.
//
// climb.hpp draws kClimbFrom from this table.
#include <benchmark/benchmark.h>
#include <graze/support/climb.hpp>
#include <graze/support/leaf.hpp>

#include "tests/shared/large_hulls.hpp"

namespace graze::test {
namespace {

constexpr std::size_t kDirections = 8192;

struct Counted {
  long heights = 0;
  void height() { ++heights; }
  void exact_comparison() {}
};

template <class S>
struct Scene {
  Hull<S> hull;
  std::vector<Vec3<S>> directions;
  std::vector<std::uint32_t> starts;

  // tilt: how far the direction of the warm start lies from the one asked for; negative: anywhere.
  Scene(Family family, int vertices, double tilt) {
    const std::vector<Vec3<S>> given = large_hull<S>(family, vertices, 7);
    hull = with_adjacency(std::span<const Vec3<S>>(given));
    Draw draw{8};
    for (std::size_t i = 0; i < kDirections; ++i) {
      const Vec3<S> n = draw.vector<S>(1).normalized(), other = draw.vector<S>(1).normalized();
      directions.push_back(n);
      const Vec3<S> from = tilt < 0 ? other : Vec3<S>(n + S(tilt) * other);
      starts.push_back(climb_support<S, S>(hull, from, kNoStart));
    }
  }
};

template <class S, class Support>
void run(benchmark::State& state, const Scene<S>& scene, const Support& support) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(support(scene.directions[i], scene.starts[i]));
    i = (i + 1) % kDirections;
  }
}

template <class S>
void scan_rounded(benchmark::State& state, Family family) {
  const Scene<S> scene(family, static_cast<int>(state.range(0)), -1);
  run<S>(state, scene,
         [&](const Vec3<S>& n, std::uint32_t) { return detail::hull_support<S, S>(scene.hull, n); });
}

template <class S>
void scan_exact(benchmark::State& state, Family family) {
  const Scene<S> scene(family, static_cast<int>(state.range(0)), -1);
  run<S>(state, scene, [&](const Vec3<S>& n, std::uint32_t) { return detail::scan<S, S>(scene.hull, n); });
}

template <class S>
void climbed(benchmark::State& state, Family family, double tilt, bool warm) {
  const Scene<S> scene(family, static_cast<int>(state.range(0)), tilt);
  detail::NoCount nothing;
  run<S>(state, scene, [&](const Vec3<S>& n, std::uint32_t start) {
    return detail::climb<S, S>(scene.hull, n, warm ? start : kNoStart, nothing);
  });
  Counted counted;
  for (std::size_t i = 0; i < kDirections; ++i) {
    detail::climb<S, S>(scene.hull, scene.directions[i], warm ? scene.starts[i] : kNoStart, counted);
  }
  state.counters["heights"] = static_cast<double>(counted.heights) / kDirections;
}

template <class S>
void derive(benchmark::State& state, Family family) {
  const std::vector<Vec3<S>> given = large_hull<S>(family, static_cast<int>(state.range(0)), 7);
  for (auto _ : state)
    benchmark::DoNotOptimize(with_adjacency(std::span<const Vec3<S>>(given)).has_adjacency());
}

template <class S>
void enroll(const std::string& scalar) {
  for (const auto& [name, family] : {std::pair{std::string("sphere"), Family::sphere},
                                     std::pair{std::string("cylinder"), Family::turned_cylinder}}) {
    const Family f = family;
    const std::string on = "/" + name + "/" + scalar;
    const auto add = [&](const std::string& what, auto body) {
      benchmark::RegisterBenchmark((what + on).c_str(), body)->RangeMultiplier(2)->Range(8, 4096);
    };
    add("scan_rounded", [f](benchmark::State& s) { scan_rounded<S>(s, f); });
    add("scan_exact", [f](benchmark::State& s) { scan_exact<S>(s, f); });
    add("climb_cold", [f](benchmark::State& s) { climbed<S>(s, f, -1, false); });
    add("climb_warm_0.01", [f](benchmark::State& s) { climbed<S>(s, f, 0.01, true); });
    add("climb_warm_0.3", [f](benchmark::State& s) { climbed<S>(s, f, 0.3, true); });
    add("climb_warm_anywhere", [f](benchmark::State& s) { climbed<S>(s, f, -1, true); });
    add("derive", [f](benchmark::State& s) { derive<S>(s, f); });
  }
}

}  // namespace
}  // namespace graze::test

int main(int argc, char** argv) {
  graze::test::enroll<double>("double");
  graze::test::enroll<float>("float");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
