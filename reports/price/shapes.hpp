// The shapes, poses and paths of the priced cases. Sizes are about 1, and every number is a float.
#pragma once

#include "corpus/case.hpp"
#include "corpus/random.hpp"

namespace graze::price {

using corpus::Random;

[[nodiscard]] double to_float(double x);
[[nodiscard]] Vec3<double> to_float(const Vec3<double>& x);
[[nodiscard]] Vec3<double> direction(Random& random);  // unit, of no particular one
[[nodiscard]] Quaternion<double> orientation(Random& random);
[[nodiscard]] double size(Random& random);  // 0.5 to 1

enum class Round { sphere, capsule, ellipsoid, cylinder, cone };
inline constexpr const char* kRoundNames[] = {"sphere", "capsule", "ellipsoid", "cylinder", "cone"};
[[nodiscard]] Shape<double> round_shape(Random& random, Round kind);
// The hull of points on an ellipsoid, with or without an adjacency graph to climb on.
[[nodiscard]] Shape<double> round_hull(Random& random, int vertices, bool climbs);
[[nodiscard]] Shape<double> box(Random& random);
// A sum, a hull of two or a rounded shape, curved, two or three deep.
[[nodiscard]] Shape<double> curved_sum(Random& random);

// B starts 3 to 4 from A's centre and moves past it within the step, at most `beside` off its centre: up to
// 1.2 most hit.
void send(Random& random, corpus::Case& problem, double beside);
// B stands at this distance from A's centre, and nothing moves.
void stand(Random& random, corpus::Case& problem, double apart);

}  // namespace graze::price
