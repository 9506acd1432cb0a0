// The state that a program keeps from query to query, as in the README: prepared bodies, and the end of a
// search.
//
// Prepared bodies give the same answers as the bodies, to the bit, and refuse the same inputs. A start from
// the previous step, from another pair or full of NaN changes no verdict that is clear by more than rounding.
// It keeps distances within the rounding of each other. The starts of a pair that moves slowly save supports.
// Exit code: 0, or 1 with the differences on stderr.
#include <cstdio>
#include <graze/distance.hpp>
#include <graze/overlap.hpp>
#include <graze/penetration.hpp>
#include <limits>

#include "scenes.hpp"

namespace {

int faults = 0;

void expect(bool holds, const char* what, int scene) {
  if (holds) return;
  ++faults;
  std::fprintf(stderr, "scene %d: %s\n", scene, what);
}

// Above any rounding of these queries, over the scale, and far below what the scenes are drawn by.
template <class S>
constexpr S kRounding = 1024 * std::numeric_limits<S>::epsilon();

// Above the rounding of lengths such as the scene's.
template <class S>
S rounding_of(const Scene<S>& scene) {
  S largest = 1;
  for (const graze::Body<S>* body : {&scene.a, &scene.b}) {
    largest = std::max(largest, body->position.cwiseAbs().maxCoeff());
    if (const auto* hull = std::get_if<graze::Hull<S>>(&body->shape)) {
      for (const graze::Vec3<S>& v : hull->vertices()) largest = std::max(largest, v.cwiseAbs().maxCoeff());
    } else if (const auto* box = std::get_if<graze::Box<S>>(&body->shape)) {
      largest = std::max(largest, box->half_extents.maxCoeff());
    }
  }
  return kRounding<S> * largest;
}

template <class Result>
bool same_points(const Result& one, const Result& other) {
  return one.lower == other.lower && one.upper == other.upper && one.normal == other.normal &&
         one.point_a == other.point_a && one.point_b == other.point_b && one.invalid == other.invalid;
}

template <class S>
void ask_prepared(const Scene<S>& scene, int k) {
  const graze::Prepared<S> a(scene.a), b(scene.b);
  const auto mpr = overlap_mpr(scene.a, scene.b), kept_mpr = overlap_mpr(a, b);
  expect(mpr.outcome == kept_mpr.outcome && mpr.normal == kept_mpr.normal, "MPR, prepared", k);
  const auto gjk = overlap_gjk(scene.a, scene.b), kept_gjk = overlap_gjk(a, b);
  expect(gjk.outcome == kept_gjk.outcome && gjk.normal == kept_gjk.normal, "GJK, prepared", k);
  expect(same_points(distance(scene.a, scene.b), distance(a, b)), "distance, prepared", k);
  const auto depth = penetration(scene.a, scene.b), kept_depth = penetration(a, b);
  expect(depth.outcome == kept_depth.outcome && same_points(depth, kept_depth), "penetration, prepared", k);
}

template <class S>
void refuse_prepared() {
  graze::Body<S> bad;
  bad.shape = graze::Box<S>{{1, -1, 1}};
  const graze::Prepared<S> good(graze::Body<S>{}), refused(bad);
  expect(refused.invalid() == graze::Invalid::negative_extent, "a box turned inside out is prepared", -1);
  expect(overlap_mpr(good, refused).outcome == graze::Outcome::invalid_input, "and met", -1);
  expect(distance(refused, good).invalid == graze::Invalid::negative_extent, "and measured", -1);
}

struct Supports {
  long cold = 0, warm = 0;
};

// B passes A in small steps. Every query begins at the end of the previous step's search.
template <class S>
void walk(Scene<S> scene, int k, const graze::WarmStart& other, Supports& supports) {
  constexpr int kSteps = 8;
  const S rounding = rounding_of(scene);
  const S nan = std::numeric_limits<S>::quiet_NaN();
  graze::WarmStart broken;
  broken.axis = {double(nan), 0, 1};
  broken.size = 4;
  broken.vertex_a = {0xffffffffu, 0, 1, 2};
  graze::WarmStart last, last_mpr;
  const graze::Vec3<S> step = (scene.a.position - scene.b.position) / S(64);
  for (int i = 0; i < kSteps; ++i, scene.b.position += step) {
    const auto cold = distance(scene.a, scene.b);
    const bool clear = cold.upper > rounding;
    const auto check = [&](const graze::WarmStart& start, const char* what) {
      const auto d = distance(scene.a, scene.b, {.start = start});
      expect(d.lower <= cold.upper + rounding && cold.lower <= d.upper + rounding && d.lower <= d.upper, what,
             k);
      const auto mpr = overlap_mpr(scene.a, scene.b, start);
      if (clear) expect(mpr.outcome == graze::Outcome::miss, what, k);
      return d.counters.supports;
    };
    (void)check(other, "a start of another pair");
    (void)check(broken, "a start of NaN and of no vertices");
    const int warm = check(last, "the start of the step before");
    const auto mpr = overlap_mpr(scene.a, scene.b), warm_mpr = overlap_mpr(scene.a, scene.b, last_mpr);
    if (clear) expect(mpr.outcome == warm_mpr.outcome, "MPR with its own start", k);
    if (i > 0) {
      supports.cold += cold.counters.supports + mpr.counters.supports;
      supports.warm += warm + warm_mpr.counters.supports;
    }
    last = distance(scene.a, scene.b, {.start = last}).warm;
    last_mpr = warm_mpr.warm;
  }
}

template <class S>
void run(const char* scalar) {
  constexpr int kScenes = 120;
  int apart = 0;
  Supports supports;
  graze::WarmStart other;
  refuse_prepared<S>();
  for (int k = 0; k < kScenes; ++k) {
    Maker maker(static_cast<std::uint64_t>(k));
    const Scene<S> scene = maker.scene<S>();
    ask_prepared(scene, k);
    walk(scene, k, other, supports);
    const auto d = distance(scene.a, scene.b);
    apart += d.lower > 0;
    other = d.warm;
  }
  std::printf("%s: %d of %d pairs apart, %ld supports with starts for %ld without\n", scalar, apart, kScenes,
              supports.warm, supports.cold);
  expect(apart >= 40 && apart <= kScenes - 20, "too few pairs of one kind", -1);
  expect(supports.warm < supports.cold * 3 / 4, "starts save too little", -1);
}

}  // namespace

int main() {
  run<float>("float");
  run<double>("double");
  return faults == 0 ? 0 : 1;
}
