// Random parts of the benchmarks' families of casts: directions, orientations, shapes, and a body that flies at
// another.
//
// Every number is a float, held in a double. Deterministic: the generator's bits alone.
#pragma once

#include <functional>
#include <graze/result.hpp>

#include "bench/cast_families.hpp"
#include "corpus/random.hpp"

namespace graze::bench {

using corpus::Random;

[[nodiscard]] double to_float(double x);
[[nodiscard]] Vec3<double> to_float(const Vec3<double>& x);
// |x_i| <= reach.
[[nodiscard]] Vec3<double> in_cube(Random& random, double reach);
// Of length 1.
[[nodiscard]] Vec3<double> direction(Random& random);
[[nodiscard]] Quaternion<double> turn(Random& random);

// Points on an ellipsoid with the given radii: in convex position, as a hull in a scene is.
[[nodiscard]] Shape<double> ellipsoid_hull(Random& random, int vertices, const Vec3<double>& radii);
// With radii of size/2 to size.
[[nodiscard]] Shape<double> round_hull(Random& random, int vertices, double size);

// The relative motion goes to B, and half of the time A moves as well.
void set_motion(Random& random, CastCase& c, const Vec3<double>& v);
// B starts `away` from A, up to half as far again, and flies at a point within `beside` of A's middle. Its path is 1.1
// to 2 times the distance to that point. A is from the first half of the family's shapes, B from the second.
[[nodiscard]] CastCase aimed(Random& random, const CastFamily& family, double size_a, double away,
                             double beside);

// The answer to a case with the given options.
[[nodiscard]] Outcome outcome_of(const CastFamily& family, const CastCase& c,
                                 const CastOptions<double>& options);
// Draws until half of the cases are hits and half misses. A start in contact counts as neither.
void fill_half(CastFamily& family, std::size_t cases, const CastOptions<double>& options,
               const std::function<CastCase()>& draw);
// As drawn. Starts in contact are left out.
void fill_drawn(CastFamily& family, std::size_t cases, const CastOptions<double>& options,
                const std::function<CastCase()>& draw);
// Draws until all have the wanted outcome.
void fill_with(CastFamily& family, std::size_t cases, const CastOptions<double>& options, Outcome wanted,
               const std::function<CastCase()>& draw);

// The offset aside from its path at which the case that at(offset) draws is nearly a miss, to a float and beyond it.
[[nodiscard]] double grazing_offset(const CastFamily& family, const CastOptions<double>& options,
                                    const std::function<CastCase(double)>& at);

}  // namespace graze::bench
