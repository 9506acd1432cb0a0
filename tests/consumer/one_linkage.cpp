// The answers of one linkage, header-only or compiled, to the consumer's scenes: all of their numbers.
//
// Compiled four times for one program (both_linkages.cpp). The scenes' own types are not of graze, so they are
// made local to each: graze alone is distinguished by its namespace.
#include <cmath>
#include <cstdint>
#include <graze/cast.hpp>
#include <graze/distance.hpp>
#include <graze/eigen.hpp>
#include <graze/invalid_text.hpp>
#include <graze/rotating_cast.hpp>
#include <vector>

namespace {
#include "tests/consumer/project/scenes.hpp"

void add(std::vector<double>& out, const auto& result) {
  out.push_back(static_cast<double>(result.outcome));
  out.push_back(static_cast<double>(result.toi_lower));
  out.push_back(static_cast<double>(result.toi_upper));
  for (const auto* v : {&result.normal, &result.point_a, &result.point_b}) {
    for (int i = 0; i < 3; ++i) out.push_back(static_cast<double>((*v)[i]));
  }
}

// A body that is refused, by its pose from Eigen and a part of its shape: where, and the length of its words.
template <class S>
void add_refusal(std::vector<double>& out, const graze::Body<S>& good) {
  Eigen::Transform<S, 3, Eigen::Isometry> pose(Eigen::Translation<S, 3>(1, 2, 3));
  const graze::Body<S> bad = graze::body_at(graze::rounded<S>(graze::Sphere<S>{-1}, 1), pose);
  const graze::InvalidAt at = graze::cast(good, bad).invalid_at;
  for (const int number : {int(at.why), int(at.body), int(at.field), at.part, at.index})
    out.push_back(number);
  out.push_back(static_cast<double>(to_text(at).size()));
}

template <class S>
void add_scene(std::vector<double>& out, const Scene<S>& scene) {
  graze::CastOptions<S> options;
  options.t_max = scene.t_max;
  options.target_distance = scene.target_distance;
  for (const graze::Tier tier : {graze::Tier::standard, graze::Tier::certified}) {
    options.tier = tier;
    add(out, graze::cast(scene.a, scene.b, options));
  }
  out.push_back(static_cast<double>(graze::distance(scene.a, scene.b).upper));
  graze::RotatingBody<S> a{scene.a}, b{scene.b};
  b.rotation = {1, S(-0.5), 2};
  add(out, graze::cast(a, b));
  add_refusal(out, scene.a);
}

}  // namespace

// GRAZE_TEST_ANSWERS: a name for each linkage and scalar.
std::vector<double> GRAZE_TEST_ANSWERS(int scenes) {
  std::vector<double> out;
  for (int k = 0; k < scenes; ++k) {
    Maker maker(static_cast<std::uint64_t>(k));
    add_scene(out, maker.scene<GRAZE_TEST_SCALAR>());
  }
  return out;
}
