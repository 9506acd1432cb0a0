#include "bench/draw_casts.hpp"

#include <cmath>
#include <graze/cast.hpp>

namespace graze::bench {

double to_float(double x) { return static_cast<double>(static_cast<float>(x)); }
Vec3<double> to_float(const Vec3<double>& x) { return {to_float(x[0]), to_float(x[1]), to_float(x[2])}; }

Vec3<double> in_cube(Random& random, double reach) {
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
  return {x, y, random.uniform(-reach, reach)};
}
Vec3<double> direction(Random& random) {
  Vec3<double> x;
  do {
    x = in_cube(random, 1);
  } while (!(x.squaredNorm() <= 1 && x.squaredNorm() > 0.01));
  return x / x.norm();
}
Quaternion<double> turn(Random& random) {
  double q[4], norm_sq = 0;
  do {
    norm_sq = 0;
    for (double& c : q) {
      c = random.uniform(-1, 1);
      norm_sq += c * c;
    }
  } while (!(norm_sq <= 1 && norm_sq > 0.01));
  for (double& c : q) c = to_float(c / std::sqrt(norm_sq));
  return {q[0], q[1], q[2], q[3]};
}

Shape<double> ellipsoid_hull(Random& random, int vertices, const Vec3<double>& radii) {
  std::vector<Vec3<double>> list;
  for (int i = 0; i < vertices; ++i) list.push_back(to_float(radii.cwiseProduct(direction(random))));
  return Hull<double>(std::span<const Vec3<double>>(list));
}
Shape<double> round_hull(Random& random, int vertices, double size) {
  const double x = random.uniform(0.5, 1), y = random.uniform(0.5, 1);
  return ellipsoid_hull(random, vertices, size * Vec3<double>(x, y, random.uniform(0.5, 1)));
}

void set_motion(Random& random, CastCase& c, const Vec3<double>& v) {
  if (random.once_in(2)) c.a.displacement = to_float(in_cube(random, 1));
  c.b.displacement = to_float(Vec3<double>(c.a.displacement + v));
}

CastCase aimed(Random& random, const CastFamily& family, double size_a, double away, double beside) {
  CastCase c;
  const std::size_t half = family.shapes.size() / 2;
  c.a.shape = random.below(half);
  c.b.shape = half + random.below(half);
  c.a.position = to_float(in_cube(random, 4));
  const double distance = away * random.uniform(1, 1.5);
  const Vec3<double> start = distance * direction(random);
  c.b.position = to_float(Vec3<double>(c.a.position + start));
  const Vec3<double> target = beside * size_a * in_cube(random, 1);
  set_motion(random, c, random.uniform(1.1, 2) * (target - start));
  if (family.rotated) {
    c.a.orientation = turn(random);
    c.b.orientation = turn(random);
  }
  return c;
}

Outcome outcome_of(const CastFamily& family, const CastCase& c, const CastOptions<double>& options) {
  CastOptions<double> asked = options;
  asked.request = Request::verdict;
  return cast(body_of<double>(c.a, family.shapes), body_of<double>(c.b, family.shapes), asked).outcome;
}

void fill_half(CastFamily& family, std::size_t cases, const CastOptions<double>& options,
               const std::function<CastCase()>& draw) {
  std::size_t hits = 0, misses = 0;
  while (hits + misses < cases) {
    CastCase c = draw();
    const Outcome outcome = outcome_of(family, c, options);
    c.contact = outcome == Outcome::hit;
    if (outcome == Outcome::hit && 2 * hits < cases) {
      ++hits;
      family.cases.push_back(c);
    } else if (outcome == Outcome::miss && 2 * misses < cases) {
      ++misses;
      family.cases.push_back(c);
    }
  }
}

void fill_drawn(CastFamily& family, std::size_t cases, const CastOptions<double>& options,
                const std::function<CastCase()>& draw) {
  while (family.cases.size() < cases) {
    CastCase c = draw();
    const Outcome outcome = outcome_of(family, c, options);
    c.contact = outcome == Outcome::hit;
    if (c.contact || outcome == Outcome::miss) family.cases.push_back(c);
  }
}

void fill_with(CastFamily& family, std::size_t cases, const CastOptions<double>& options, Outcome wanted,
               const std::function<CastCase()>& draw) {
  while (family.cases.size() < cases) {
    CastCase c = draw();
    c.contact = wanted != Outcome::miss;
    if (outcome_of(family, c, options) == wanted) family.cases.push_back(c);
  }
}

double grazing_offset(const CastFamily& family, const CastOptions<double>& options,
                      const std::function<CastCase(double)>& at) {
  double hit = 0, miss = 4;
  for (int i = 0; i < 30; ++i) {
    const double middle = (hit + miss) / 2;
    (outcome_of(family, at(middle), options) == Outcome::miss ? miss : hit) = middle;
  }
  return hit;
}

}  // namespace graze::bench
