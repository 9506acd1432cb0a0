// Prints a hash of the answers of every query, tier, method and scalar, one line for each. The lines are the same on
// every machine, with every compiler and every flag. usage: digests [flush | GROUP [NUMBER]]
//
// With `flush`, subnormals are flushed to 0 and only the exact tier is asked, as the others promise nothing then. With the
// name of a group, its answers are printed one by one, to find the first that differs. With its number, so are its words.
//
// The input must not depend on the machine either. Every number is an integer times a power of two, and every sum
// stays within 53 bits before it is rounded once.
#include "draw.hpp"
#include "hash.hpp"

#include <graze/cast.hpp>
#include <graze/cast_all.hpp>
#include <graze/distance.hpp>
#include <graze/line.hpp>
#include <graze/overlap.hpp>
#include <graze/penetration.hpp>
#include <graze/prepared.hpp>
#include <graze/rotating_cast.hpp>
#include <graze/scene.hpp>
#include <graze/swept_overlap.hpp>

#include <cstdlib>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

namespace graze::bits {
namespace {

template <Scalar S>
void linear(Table& table, const Body<S>& a, const Body<S>& b, CastOptions<S> options) {
  options.request = Request::everything;
  options.tier = Tier::exact;
  table.add<S>("cast, exact", cast(a, b, options));
  Body<S> origin;
  origin.position = b.position;
  origin.displacement = b.displacement;
  CastOptions<S> of_ray = options;
  of_ray.t_max = kInfinity<S>;
  table.add<S>("ray, exact", cast(origin, a, of_ray));
  if (table.exact_only()) return;
  of_ray.request = Request::normal | Request::witnesses;
  for (const Tier tier : {Tier::standard, Tier::certified}) {
    of_ray.tier = tier;
    table.add<S>(tier == Tier::standard ? "ray, standard" : "ray, certified", cast(origin, a, of_ray));
  }
  options.tier = Tier::certified;
  table.add<S>("cast, certified", cast(a, b, options));
  options.tier = Tier::standard;
  table.add<S>("cast, standard, proved", cast(a, b, options));
  options.request = Request::normal | Request::witnesses;
  table.add<S>("cast, standard", cast(a, b, options));
  table.add<S>("cast, gjk", cast_gjk_ray(a, b, options));
  table.add<S>("cast, mpr", cast_mpr_sweep(a, b, options));
  table.add<S>("cast, advancement", cast_conservative_advancement(a, b, options));
}

template <Scalar S>
void others(Table& table, const Body<S>& a, const Body<S>& b, const CastOptions<S>& options) {
  const LineOptions<S> of_line{.target_distance = options.target_distance};
  SweptOverlapOptions<S> swept{.t_max = options.t_max, .target_distance = options.target_distance};
  table.add<S>("line, exact", line_exact(a, b, of_line));
  table.add<S>("overlap, exact", overlap_exact(a, b));
  table.add<S>("distance, exact", distance_exact(a, b));
  table.add<S>("swept overlap, exact", swept_overlap_exact(a, b, swept));
  if (table.exact_only()) return;
  table.add<S>("line", line(a, b, of_line));
  table.add<S>("overlap, gjk", overlap_gjk(a, b));
  table.add<S>("overlap, mpr", overlap_mpr(a, b));
  for (const SweptMethod method : {SweptMethod::gjk, SweptMethod::mpr, SweptMethod::before_after}) {
    swept.method = method;
    table.add<S>("swept overlap", swept_overlap(a, b, swept));
  }
  table.add<S>("distance", distance(a, b));
  table.add<S>("penetration", penetration(a, b));
  table.add<S>("penetration along", penetration_along(a, b, Vec3<S>(1, 2, -2)));
  // Prepared once, and from the answer before.
  const Prepared<S> kept_a(a), kept_b(b);
  const DistanceResult<S> apart = distance(kept_a, kept_b);
  table.add<S>("prepared, distance", apart);
  table.add<S>("prepared, distance", distance(kept_a, kept_b, DistanceOptions<S>{.start = apart.warm}));
  table.add<S>("prepared, overlap", overlap_mpr(kept_a, kept_b, overlap_mpr(kept_a, kept_b).warm));
  table.add<S>("prepared, overlap", overlap_gjk(kept_a, kept_b, overlap_gjk(kept_a, kept_b).warm));
  table.add<S>("prepared, penetration", penetration(kept_a, kept_b));
}

template <Scalar S>
void rotating(Table& table, const RotatingBody<S>& a, const RotatingBody<S>& b, RotatingOptions<S> options) {
  if (table.exact_only()) return;
  options.request = Request::everything;
  options.tier = Tier::certified;
  table.add<S>("rotating, certified", cast(a, b, options));
  options.tier = Tier::standard;
  table.add<S>("rotating, standard, proved", cast(a, b, options));
  options.request = Request::normal | Request::witnesses;
  table.add<S>("rotating, standard", cast(a, b, options));
  options.max_iterations = 2048;
  for (const auto& [name, method] :
       {std::pair("rotating, advancement", RotatingMethod::conservative_advancement),
        std::pair("rotating, bilateral", RotatingMethod::bilateral_advancement),
        std::pair("rotating, bilateral published", RotatingMethod::bilateral_published),
        std::pair("rotating, spheres", RotatingMethod::bounding_spheres),
        std::pair("rotating, steps", RotatingMethod::time_steps)}) {
    options.method = method;
    table.add<S>(name, cast(a, b, options));
  }
}

// Many casts and rays against one body.
void batches(Table& table, const std::vector<RotatingBody<double>>& bodies) {
  if (table.exact_only()) return;
  std::vector<Body<double>> many;
  std::vector<scene::RayQuestion> rays;
  for (const RotatingBody<double>& one : bodies) {
    many.push_back(one.body);
    rays.push_back({one.body.position, Vec3<double>(one.body.displacement - one.body.position)});
  }
  std::vector<CastResult<double>> answers(many.size());
  std::vector<scene::RayAnswer> slim(rays.size());
  for (std::size_t k = 0; k < many.size(); k += 4) {
    scene::cast_all(many[k], many, answers);
    for (const CastResult<double>& answer : answers) table.add<double>("casts against one body", answer);
    scene::cast_rays(many[k], rays, slim);
    for (const scene::RayAnswer& answer : slim) table.add<double>("rays against one body", answer);
  }
}

void scenes(Table& table, const std::vector<RotatingBody<double>>& bodies) {
  if (table.exact_only()) return;
  scene::Scene scene;
  for (const RotatingBody<double>& body : bodies) scene.bodies.push_back({.body = body});
  for (int i = 0; i < 8; ++i) {
    const Vec3<double> from(40, i - 4, 8 - 2 * i);
    scene.probes.push_back(scene::ray("", from, Vec3<double>(-1, 0.125 * (4 - i), 0.25 * (i - 4))));
    scene.probes.back().first_only = i % 2 == 0;
  }
  const auto add = [&](const char* events, const char* rays, const scene::Options& options) {
    const scene::Report report = scene::run(scene, options);
    for (const scene::Event& event : report.events) table.add<double>(events, event);
    for (const scene::Event& event : report.probe_events) table.add<double>(rays, event);
    table.count(events, report.counters);
  };
  for (const Tier tier : {Tier::standard, Tier::certified})
    add("scene", "scene, rays", {.tier = tier, .request = Request::everything});
  for (const scene::Ask ask : {scene::Ask::verdict, scene::Ask::first, scene::Ask::body})
    add("scene, first events", "scene, first rays", {.ask = ask});
  for (scene::Member& member : scene.bodies) member.body.rotation = Vec3<double>::Zero();
  add("linear scene by the exact tier", "rays by the exact tier",
      {.tier = Tier::exact, .request = Request::everything});
}

template <Scalar S>
void ask(Table& table, const Kind& kind, int pairs) {
  Draw<S> draw(kind);
  std::vector<RotatingBody<double>> bodies;
  for (int i = 0; i < pairs; ++i) {
    const auto [a, b] = draw.pair();
    CastOptions<S> options;
    options.t_max = i % 4 == 3 ? kInfinity<S> : S(4);
    if (i % 5 == 4) options.target_distance = draw.length();
    if (i % 7 == 6) options.start_policy = StartPolicy::pass_over;
    linear(table, a.body, b.body, options);
    others(table, a.body, b.body, options);
    if (i % 4 != 0) continue;  // these are slower
    rotating(
        table, a, b,
        {.t_max = S(4), .target_distance = options.target_distance, .start_policy = options.start_policy});
    if constexpr (std::same_as<S, double>) {
      if (bodies.size() < 40) bodies.insert(bodies.end(), {a, b});
    }
  }
  if constexpr (std::same_as<S, double>) {
    scenes(table, bodies);
    batches(table, bodies);
  }
}

}  // namespace
}  // namespace graze::bits

int main(int argc, char** argv) {
  constexpr int kPairs = 250;  // of each kind
  const std::string given = argc > 1 ? argv[1] : "";
  const bool flush = given == "flush";
  if (flush) {
#if defined(__SSE2__)
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#else
    std::puts("no flush");
    return 77;
#endif
  }
  graze::bits::Table table(flush, given, argc > 2 ? std::atol(argv[2]) : 0);
  for (const graze::bits::Kind& kind : graze::bits::kKinds) {
    graze::bits::ask<double>(table, kind, kPairs);
    graze::bits::ask<float>(table, kind, kPairs);
  }
  table.print();
  return 0;
}
