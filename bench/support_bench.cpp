// The support of a hull by the scan of all its vertices and by its map of directions, as it is rounded and as floats
// guess it, and what making a hull costs, with adjacency and without. 8 to 4096 vertices, on a sphere and on a cylinder
// (two rings: flat caps, near-ties), double and float. `vertices`: in a list, on average; `bytes`: of the map, a vertex.
//
// Supports one after the other, each along a direction of its own: what waits for its answer waits longer.
#include <benchmark/benchmark.h>
#include <graze/detail/shapes/leaf.hpp>

#include "tests/shared/large_hulls.hpp"

namespace graze::test {
namespace {

constexpr std::size_t kDirections = 8192;

template <class S>
struct Scene {
  Hull<S> plain, mapped;
  std::vector<Vec3<S>> directions;

  Scene(Family family, int vertices) {
    const std::vector<Vec3<S>> given = large_hull<S>(family, vertices, 7);
    plain = Hull<S>(given);
    mapped = with_adjacency(given);
    Draw draw{8};
    for (std::size_t i = 0; i < kDirections; ++i) directions.push_back(draw.vector<S>(1).normalized());
  }
  // The map of the hull, which may be empty.
  [[nodiscard]] const detail::DirectionMap& map() const { return mapped.graph().map; }
};

template <class S, class Support>
void run(benchmark::State& state, const Scene<S>& scene, const Support& support) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(support(scene.directions[i]));
    i = (i + 1) % kDirections;
  }
}

template <class S>
void rounded(benchmark::State& state, Family family, bool mapped) {
  const Scene<S> scene(family, static_cast<int>(state.range(0)));
  const Hull<S>& hull = mapped ? scene.mapped : scene.plain;
  run<S>(state, scene, [&](const Vec3<S>& n) { return detail::hull_support<S, S>(hull, n); });
}

template <class S>
void guessed(benchmark::State& state, Family family) {
  const Scene<S> scene(family, static_cast<int>(state.range(0)));
  const float* x = scene.plain.approximate_scan(0);
  const std::size_t size = scene.plain.padded_size();
  run<S>(state, scene, [&](const Vec3<S>& n) {
    return detail::approximate_scan(x, size, float(n[0]), float(n[1]), float(n[2]));
  });
}

template <class S>
void guessed_by_map(benchmark::State& state, Family family) {
  const Scene<S> scene(family, static_cast<int>(state.range(0)));
  const detail::DirectionMap& map = scene.map();
  if (map.empty()) return state.SkipWithError("no map");
  double vertices = 0;
  run<S>(state, scene, [&](const Vec3<S>& n) {
    detail::DirectionMap::List list{};
    const float x = float(n[0]), y = float(n[1]), z = float(n[2]);
    if (!map.find(x, y, z, list)) return 0u;
    return list.vertex[detail::approximate_scan(list.xyz, list.size, x, y, z)];
  });
  for (const Vec3<S>& n : scene.directions) {
    detail::DirectionMap::List list{};
    if (map.find(float(n[0]), float(n[1]), float(n[2]), list)) vertices += static_cast<double>(list.size);
  }
  state.counters["vertices"] = vertices / kDirections;
  state.counters["bytes"] = static_cast<double>(map.bytes()) / static_cast<double>(scene.mapped.size());
}

template <class S>
void plain(benchmark::State& state, Family family) {
  const std::vector<Vec3<S>> given = large_hull<S>(family, static_cast<int>(state.range(0)), 7);
  for (auto _ : state) benchmark::DoNotOptimize(Hull<S>(given).size());
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
    add("scan_rounded", [f](benchmark::State& s) { rounded<S>(s, f, false); });
    add("map_rounded", [f](benchmark::State& s) { rounded<S>(s, f, true); });
    add("scan_guessed", [f](benchmark::State& s) { guessed<S>(s, f); });
    add("map_guessed", [f](benchmark::State& s) { guessed_by_map<S>(s, f); });
    add("plain", [f](benchmark::State& s) { plain<S>(s, f); });
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
