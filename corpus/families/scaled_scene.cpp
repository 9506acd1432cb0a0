// scaled_scene: a whole scene, 2^j or 2^-j as large. Hardness: j, so sizes of 4 become sizes of 4 times that.
// Exact: only exponents change, so the answer is that of the scene as drawn.
//
// Three cases in four pass a top feature of C, as in `grazing`. Once scaled, the height (or the depth) is
// 0.1, 1 or 10 times an absolute tolerance in common use, 1e-4, FLT_EPSILON or 1e-12. The fourth is a random
// pair. Below 10^-4 in size, such a gap is larger than the bodies, and above 10^12 smaller than their
// rounding.
//
// This breaks an absolute tolerance compared with a length, an area or a volume. Squares vanish or overflow
// (2^100 squared exceeds the floats).
#include <algorithm>
#include <cmath>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

Vec3<double> scaled(const Vec3<double>& x, int exponent) {
  return {std::scalbn(x[0], exponent), std::scalbn(x[1], exponent), std::scalbn(x[2], exponent)};
}

// For the shapes that capped() and shape() draw.
Shape<double> scaled(const Shape<double>& shape, int exponent) {
  if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) {
    return Sphere<double>{std::scalbn(sphere->radius, exponent)};
  }
  if (const auto* box = std::get_if<Box<double>>(&shape)) {
    return Box<double>{scaled(box->half_extents, exponent)};
  }
  const auto* hull = std::get_if<Hull<double>>(&shape);
  if (hull == nullptr) return shape;  // a point
  std::vector<Vec3<double>> vertices;
  vertices.reserve(hull->size());
  for (const Vec3<double>& x : hull->vertices()) vertices.push_back(scaled(x, exponent));
  return Hull<double>(std::span<const Vec3<double>>(vertices));
}

void fill_scaled_scene(Draw& draw, double hardness, Case& problem) {
  constexpr double kTolerances[] = {1e-4, 0x1p-23, 1e-12}, kFactors[] = {0.1, 1, 10};
  Random& random = draw.random;
  const int j = static_cast<int>(hardness), exponent = random.once_in(2) ? j : -j;
  if (random.once_in(4)) {
    problem.a.shape = draw.shape(4, random.integer(4, 12));
    problem.b.shape = draw.shape(4, random.integer(4, 12));
    problem.a.orientation = draw.pose();
    problem.b.orientation = draw.pose();
    problem.a.position = draw.vector(8);
    aim(draw, problem, 4);
    vary_time_scale(draw, problem);
    maybe_swap(draw, problem);
  } else {
    const double tolerance = kTolerances[random.below(std::size(kTolerances))];
    const double gap = tolerance * kFactors[random.below(3)];
    const double delta = draw.real(std::scalbn(gap, -exponent));
    // A path may pass above C at any height, and reach into it by no more than C is thick.
    pass_top_feature(draw, problem, random.once_in(2) ? delta : 0 - std::min(delta, 0x1p-4));
  }
  for (Body<double>* body : {&problem.a, &problem.b}) {
    body->shape = scaled(body->shape, exponent);
    body->position = scaled(body->position, exponent);
    body->displacement = scaled(body->displacement, exponent);
  }
}

constexpr double kScaledSceneLevels[] = {0, 10, 20, 30, 40, 50, 75, 100};

}  // namespace

const Family family::scaled_scene{
    .name = "scaled_scene",
    .sentence = "A scene that is tiny or huge, with gaps near the usual absolute tolerances.",
    .hardness_meaning = "j: the scene is 2^j or 2^-j as large as shapes of size 4",
    .levels = kScaledSceneLevels,
    .fill = fill_scaled_scene,
    .picture = {40, 3},
};

}  // namespace graze::corpus
