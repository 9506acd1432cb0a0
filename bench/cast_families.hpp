// The cases of the benchmark of casts, by family.
//
// Every number is a float (held in a double), so that contestants in float and in double get the same cases. The cases
// of a family share a pool of shapes, as in a scene. t_max is 1, and v is of the order of the shapes' size.
#pragma once

#include <algorithm>
#include <graze/rotating_body.hpp>
#include <string>
#include <vector>

namespace graze::bench {

struct Placed {
  std::size_t shape = 0;  // index into CastFamily::shapes
  Vec3<double> position = Vec3<double>::Zero();
  Quaternion<double> orientation = {};
  Vec3<double> displacement = Vec3<double>::Zero();
  Vec3<double> rotation = Vec3<double>::Zero();  // of a rotating family: rotation vector over the step
  Vec3<double> pivot = Vec3<double>::Zero();     // own frame
};

struct CastCase {
  Placed a, b;
  bool contact = false;               // in [0, 1], by the family's judge
  double latest = kInfinity<double>;  // no later than this, where the judge knows
};

struct CastFamily {
  std::string name;
  bool rotated = false;
  bool in_contact = false;  // every case starts so
  bool turning = false;     // rotates in the course of the step
  std::vector<Shape<double>> shapes;
  std::vector<CastCase> cases;

  [[nodiscard]] std::ptrdiff_t contacts() const { return std::ranges::count_if(cases, &CastCase::contact); }
};

template <Scalar S>
[[nodiscard]] Body<S> body_of(const Placed& placed, const std::vector<Shape<S>>& shapes) {
  const Quaternion<double>& q = placed.orientation;
  return {.shape = shapes[placed.shape],
          .position = placed.position.cast<S>(),
          .orientation = {S(q.w), S(q.x), S(q.y), S(q.z)},
          .displacement = placed.displacement.cast<S>()};
}

template <Scalar S>
[[nodiscard]] RotatingBody<S> turning_body_of(const Placed& placed, const std::vector<Shape<S>>& shapes) {
  return {body_of<S>(placed, shapes), placed.rotation.cast<S>(), placed.pivot.cast<S>()};
}

struct FamilySize {
  std::size_t cases = 512;   // of each family
  std::size_t shapes = 128;  // in its pool
};

// For verdicts, judged by tier standard in double. They come in the order of the report. Deterministic.
[[nodiscard]] std::vector<CastFamily> cast_families(const FamilySize& size);
// Curved bodies, a family for a pair of kinds, judged by tier certified.
[[nodiscard]] std::vector<CastFamily> curved_families(const FamilySize& size);
// Bodies that rotate in the course of the step, judged by tier certified.
[[nodiscard]] std::vector<CastFamily> rotating_families(const FamilySize& size);
// For the data that an engine returns, judged by tier exact: ten families, with or without orientations.
[[nodiscard]] std::vector<CastFamily> response_families(const FamilySize& size, bool turned);
// Hulls of 16 to 4,096 vertices, a family for each number.
[[nodiscard]] std::vector<CastFamily> growth_families(const FamilySize& size);

}  // namespace graze::bench
