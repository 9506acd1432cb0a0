// Casts with the user's own flags. usage: consumer DIRECTORY [flush | flushed]
//
//   flush     sets flush-to-zero and denormals-are-zero first;   flushed   requires that they are already set
//
// Writes every answer and every proof to DIRECTORY for judge_answers. Checks itself the two properties that
// need no judge: every cast converges, and answers do not change by one bit when all lengths are multiplied
// by a power of two. Exit code: 0, or 1 with the reason on stderr.
#include <limits>
#include <string>
#include <string_view>

#if defined(__SSE2__)
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

#include "records.hpp"

namespace {

constexpr int kScenes = 240;

struct NamedMethod {
  const char* name;
  graze::Method method;
};
constexpr NamedMethod kMethods[] = {{"ca", graze::Method::conservative_advancement},
                                    {"gjk", graze::Method::gjk_ray_cast},
                                    {"mpr", graze::Method::mpr_sweep}};

struct Tally {
  int outcomes[5] = {}, stalls = 0, changed = 0;
};

bool flushes_subnormals() {
  volatile double least = std::numeric_limits<double>::min();
  volatile double half = least / 2;
  return half == 0;
}

template <class S>
graze::CastOptions<S> options_of(const Scene<S>& scene, graze::Method method) {
  graze::CastOptions<S> out;
  out.method = method;
  out.request = graze::Request::everything;
  out.t_max = scene.t_max;
  out.target_distance = scene.target_distance;
  return out;
}

template <class S>
bool same(const graze::CastResult<S>& one, const graze::CastResult<S>& other) {
  return one.outcome == other.outcome && one.toi_lower == other.toi_lower &&
         one.toi_upper == other.toi_upper && one.normal == other.normal;
}

// The scene by every method, at its own size and at others: lengths by 2^40 up and down, and up to the limits
// of the scalar's range of exponents and graze's (1e-60 .. 1e60).
template <class S>
void run(const std::string& id, const Scene<S>& scene, Records& records, Tally& tally) {
  constexpr int far = sizeof(S) == 4 ? 100 : 175;
  const int exponents[] = {40, -40, far, -far};
  for (const NamedMethod& m : kMethods) {
    const graze::CastResult<S> result = graze::cast(scene.a, scene.b, options_of(scene, m.method));
    records.write(id, m.name, scene, result);
    ++tally.outcomes[static_cast<int>(result.outcome)];
    if (result.outcome == graze::Outcome::not_converged) {
      ++tally.stalls;
      std::fprintf(stderr, "%s: %s stalls\n", id.c_str(), m.name);
    }
    for (const int e : exponents) {
      const Scene<S> other = scaled(scene, e);
      const graze::CastResult<S> again = graze::cast(other.a, other.b, options_of(other, m.method));
      if (m.method == graze::Method::gjk_ray_cast) {
        records.write(id + "/times-2p" + std::to_string(e), m.name, other, again);
      }
      if (same(result, again)) continue;
      ++tally.changed;
      std::fprintf(stderr, "%s: %s changes by a factor of 2^%d: %s %a %a, then %s %a %a\n", id.c_str(),
                   m.name, e, Records::name_of(result.outcome), static_cast<double>(result.toi_lower),
                   static_cast<double>(result.toi_upper), Records::name_of(again.outcome),
                   static_cast<double>(again.toi_lower), static_cast<double>(again.toi_upper));
    }
  }
}

// The first thing that anybody tries.
template <class S>
Scene<S> ball_on_floor() {
  Scene<S> out;
  out.a = {.shape = graze::Box<S>{{500, 500, 500}}, .position = {0, -500, 0}};
  out.b = {.shape = graze::Sphere<S>{S(0.5)}, .position = {3, 10, -7}, .displacement = {0, -20, 0}};
  return out;
}

// A cube standing on its edge, half its diagonal above the floor: rotated, and a tie along the edge.
template <class S>
Scene<S> two_boxes(bool rotated) {
  Scene<S> out;
  out.a.shape = graze::Box<S>{{4, 1, 4}};
  out.b.shape = graze::Box<S>{{1, 1, 1}};
  out.b.position = {0, 8, 0};
  out.b.displacement = {1, -8, 0};
  if (rotated) out.b.orientation = {12, 5, 0, 0};  // rational sine and cosine
  return out;
}

template <class S>
bool show(const char* what, const Scene<S>& scene) {
  const graze::CastResult<S> r =
      graze::cast(scene.a, scene.b, options_of(scene, graze::Method::gjk_ray_cast));
  std::printf("%s: %s, %.9g <= TOI <= %.9g, normal (%.9g, %.9g, %.9g)\n", what, Records::name_of(r.outcome),
              static_cast<double>(r.toi_lower), static_cast<double>(r.toi_upper),
              static_cast<double>(r.normal[0]), static_cast<double>(r.normal[1]),
              static_cast<double>(r.normal[2]));
  return r.outcome == graze::Outcome::hit;
}

template <class S>
bool run_all(const char* scalar, Records& records, Tally& tally) {
  const Scene<S> simple[] = {ball_on_floor<S>(), two_boxes<S>(false), two_boxes<S>(true)};
  const char* const names[] = {"ball-on-floor", "boxes", "rotated-boxes"};
  bool good = true;
  for (int i = 0; i < 3; ++i) {
    good = show(names[i], simple[i]) && good;
    run(std::string(names[i]) + "/" + scalar, simple[i], records, tally);
  }
  for (int k = 0; k < kScenes; ++k) {
    Maker maker(static_cast<std::uint64_t>(k));
    run("scene-" + std::to_string(k) + "/" + scalar, maker.scene<S>(), records, tally);
  }
  return good;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fprintf(stderr, "usage: consumer DIRECTORY [flush | flushed]\n");
    return 2;
  }
  const std::string_view mode = count > 2 ? arguments[2] : "";
#if defined(__SSE2__)
  if (mode == "flush") {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
#endif
  const bool wanted = mode == "flush" || mode == "flushed";
  if (flushes_subnormals() != wanted) {
    std::fprintf(stderr, "subnormals are %s\n", wanted ? "not flushed" : "flushed, and nobody asked for it");
    return 1;
  }
  Records records(arguments[1]);
  if (!records.open()) {
    std::fprintf(stderr, "cannot write to %s\n", arguments[1]);
    return 1;
  }
  Tally tally;
  bool good = run_all<float>("float", records, tally);
  good = run_all<double>("double", records, tally) && good;
  good = records.close() && good;
  std::printf("%d in contact at the start, %d hits, %d misses, %d stalls, %d changed by a power of two\n",
              tally.outcomes[0], tally.outcomes[1], tally.outcomes[2], tally.stalls, tally.changed);
  // Too few of a kind would make the run say little.
  for (int k = 0; k < 3; ++k) good = good && tally.outcomes[k] >= 100;
  return good && tally.stalls == 0 && tally.changed == 0 && tally.outcomes[4] == 0 ? 0 : 1;
}
