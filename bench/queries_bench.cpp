// The costs of the queries side by side: the lecture's claims about cost, measured.
//
//   penetration   "EPA is the expensive way": the least depth by EPA, the depth along a direction by MPR, and
//                 the distance by GJK, all on the same two hulls (in contact for the first two, apart for GJK),
//                 and the least depth of all pairs of primitives except boxes with boxes.
//   swept         the sum with a segment beside the points before and after.
//   ray           every face beside GJK and MPR, on a globe of 8 to 1,024 vertices.
// A row has 64 pairs, each queried once an iteration. The time is that of one query, in nanoseconds. `supports` is the
// number of support evaluations a query. Built with -DGRAZE_BENCH=ON, run by hand.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <graze/cast.hpp>
#include <graze/distance.hpp>
#include <graze/penetration.hpp>
#include <graze/swept_overlap.hpp>

#include "tests/core/queries/brute_force_ray.hpp"
#include "tests/shared/generate.hpp"
#include "tests/shared/globe.hpp"
#include "tests/shared/primitives.hpp"

namespace graze::test {
namespace {

constexpr int kPairs = 64;

struct Pair {
  Body<double> a, b;
};

// A globe of about that many vertices, rotated.
Globe<double> globe_of(int vertices) {
  const int rings = std::max(1, static_cast<int>(std::lround(std::sqrt(vertices / 2.0))));
  return globe<double>(rings, std::max(3, static_cast<int>(std::lround(double(vertices - 2) / rings))), 1);
}

// Hulls of that many vertices on the unit sphere, their centres at that distance.
std::vector<Pair> pairs(int vertices, double distance) {
  Draw draw{5};
  std::vector<Pair> out;
  const auto hull = [&] {
    std::vector<Vec3<double>> v;
    for (int i = 0; i < vertices; ++i) v.push_back(unit(draw.vector<double>(1)));
    return Hull<double>(std::span<const Vec3<double>>(v));
  };
  while (out.size() < kPairs) {
    Pair pair{{.shape = hull(), .orientation = draw.turn<double>()},
              {.shape = hull(), .orientation = draw.turn<double>()}};
    const Vec3<double> towards = unit(draw.vector<double>(1));
    pair.b.position = distance * towards;
    pair.b.displacement = -distance * towards + draw.vector<double>(1.5);
    out.push_back(pair);
  }
  return out;
}

// `query` returns the number of supports that it took.
template <class Jobs, class Query>
void run(benchmark::State& state, const Jobs& jobs, const Query& query) {
  double supports = 0;
  for (auto _ : state) {
    for (const auto& job : jobs) supports += query(job);
  }
  const double count = static_cast<double>(state.iterations()) * static_cast<double>(jobs.size());
  state.counters["supports"] = supports / count;
  // Inverted rate: seconds a query.
  state.counters["query"] =
      benchmark::Counter(count, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

constexpr double kDeep = 0.7, kShallow = 1.6, kApart = 3;  // of two hulls in unit balls

void penetration_epa(benchmark::State& state) {
  run(state, pairs(static_cast<int>(state.range(0)), state.range(1) ? kDeep : kShallow), [](const Pair& p) {
    const auto r = penetration(p.a, p.b);
    benchmark::DoNotOptimize(r.upper);
    return r.counters.supports;
  });
}
void penetration_mpr_along(benchmark::State& state) {
  run(state, pairs(static_cast<int>(state.range(0)), state.range(1) ? kDeep : kShallow), [](const Pair& p) {
    const auto r = penetration_along(p.a, p.b, p.b.position);
    benchmark::DoNotOptimize(r.upper);
    return r.counters.supports;
  });
}
// Two of each of sphere, capsule, box, ellipsoid, cylinder and cone, boxes with boxes aside.
enum Fit { kRotatedShallow, kCoaxial, kRotatedDeep };
std::vector<Pair> smooth_pairs(Fit fit) {
  Draw draw{8};
  std::vector<Pair> out;
  constexpr int kEach = 16;
  for (int i = 0; i < kPrimitives; ++i) {
    for (int j = i; j < kPrimitives; ++j) {
      if (i == kBoxPrimitive && j == kBoxPrimitive) continue;
      for (int k = 0; k < kEach;) {
        Pair pair{{.shape = primitive(i, draw)}, {.shape = primitive(j, draw)}};
        if (fit != kCoaxial) {
          pair.a.orientation = draw.turn<double>();
          pair.b.orientation = draw.turn<double>();
        }
        const Vec3<double> towards =
            fit == kCoaxial ? Vec3<double>(Vec3<double>::UnitZ()) : unit(draw.vector<double>(1));
        double away = draw.between(0, 1.2);
        if (fit == kRotatedShallow) {
          pair.b.position = 4 * towards;
          pair.b.displacement = -4 * towards;
          away = 4 * (1 - cast(pair.a, pair.b).toi_upper) - draw.between(0.01, 0.15);
        }
        pair.b.position = away * towards;
        pair.b.displacement = Vec3<double>::Zero();
        if (penetration(pair.a, pair.b).outcome != Outcome::initially_overlapping) continue;
        out.push_back(pair);
        ++k;
      }
    }
  }
  return out;
}
// `median`, `p99`: seconds, of the least of five times of each pair.
void penetration_smooth(benchmark::State& state) {
  const std::vector<Pair> all = smooth_pairs(static_cast<Fit>(state.range(0)));
  const auto ask = [](const Pair& p) {
    const auto r = penetration(p.a, p.b);
    benchmark::DoNotOptimize(r.upper);
    return r.counters.supports;
  };
  run(state, all, ask);
  std::vector<double> seconds;
  for (const Pair& p : all) {
    double least = 1;
    for (int i = 0; i < 5; ++i) {
      const auto begin = std::chrono::steady_clock::now();
      ask(p);
      least =
          std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    seconds.push_back(least);
  }
  std::sort(seconds.begin(), seconds.end());
  state.counters["median"] = seconds[seconds.size() / 2];
  state.counters["p99"] = seconds[seconds.size() * 99 / 100];
}
// fit: 0 rotated and shallow, 1 coaxial, 2 rotated and deep.
BENCHMARK(penetration_smooth)->ArgName("fit")->DenseRange(0, 2);

void distance_gjk(benchmark::State& state) {
  run(state, pairs(static_cast<int>(state.range(0)), kApart), [](const Pair& p) {
    const auto r = distance(p.a, p.b);
    benchmark::DoNotOptimize(r.upper);
    return r.counters.supports;
  });
}
BENCHMARK(penetration_epa)->ArgNames({"vertices", "deep"})->ArgsProduct({{8, 32, 128, 512}, {0, 1}});
BENCHMARK(penetration_mpr_along)->ArgNames({"vertices", "deep"})->ArgsProduct({{8, 32, 128, 512}, {0, 1}});
BENCHMARK(distance_gjk)->ArgName("vertices")->Arg(8)->Arg(32)->Arg(128)->Arg(512);

void swept(benchmark::State& state) {
  SweptOverlapOptions<double> options;
  options.method = static_cast<SweptMethod>(state.range(1));
  run(state, pairs(static_cast<int>(state.range(0)), kApart), [&](const Pair& p) {
    const auto r = swept_overlap(p.a, p.b, options);
    benchmark::DoNotOptimize(r.outcome);
    return r.counters.supports;
  });
}
// method: 0 the sum by GJK, 1 MPR, 2 before and after by GJK.
BENCHMARK(swept)->ArgNames({"vertices", "method"})->ArgsProduct({{8, 32, 128, 512}, {0, 2, 1}});

struct Ray {
  const Globe<double>& globe;
  Body<double> hull, point;
};

std::vector<Ray> rays(const Globe<double>& globe) {
  Draw draw{6};
  const Hull<double> hull{std::span<const Vec3<double>>(globe.vertices)};
  std::vector<Ray> out;
  for (int i = 0; i < kPairs; ++i) {
    const Vec3<double> from = 3 * unit(draw.vector<double>(1));
    const Vec3<double> to = draw.vector<double>(1);
    out.push_back({globe, {.shape = hull}, {.position = from, .displacement = 2 * (to - from)}});
  }
  return out;
}

void ray_brute_force(benchmark::State& state) {
  const Globe<double> globe = globe_of(static_cast<int>(state.range(0)));
  run(state, rays(globe), [](const Ray& r) {
    const auto hit =
        brute_force_ray<double>(r.globe.vertices, r.globe.faces, r.point.position, r.point.displacement, 1.0);
    benchmark::DoNotOptimize(hit.t);
    return 0;
  });
}
void ray_cast(benchmark::State& state) {
  const Globe<double> globe = globe_of(static_cast<int>(state.range(0)));
  CastOptions<double> options;
  options.method = static_cast<Method>(state.range(1));
  options.request = Request::normal;
  run(state, rays(globe), [&](const Ray& r) {
    const auto hit = cast(r.hull, r.point, options);
    benchmark::DoNotOptimize(hit.toi_lower);
    return hit.counters.supports;
  });
}
BENCHMARK(ray_brute_force)->ArgName("vertices")->RangeMultiplier(2)->Range(8, 1024);
// method: 1 GJK ray cast, 2 MPR.
BENCHMARK(ray_cast)
    ->ArgNames({"vertices", "method"})
    ->ArgsProduct({benchmark::CreateRange(8, 1024, 2),
                   {static_cast<int>(Method::gjk_ray_cast), static_cast<int>(Method::mpr_sweep)}});

}  // namespace
}  // namespace graze::test
