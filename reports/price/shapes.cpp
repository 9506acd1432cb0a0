#include "reports/price/shapes.hpp"

#include <cmath>
#include <graze/hull.hpp>

namespace graze::price {

double to_float(double x) { return static_cast<double>(static_cast<float>(x)); }
Vec3<double> to_float(const Vec3<double>& x) { return {to_float(x[0]), to_float(x[1]), to_float(x[2])}; }

namespace {

Vec3<double> in_cube(Random& random, double reach) {
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
  return {x, y, random.uniform(-reach, reach)};
}

Vec3<double> sizes(Random& random) {
  const double x = size(random), y = size(random);
  return {x, y, size(random)};
}

}  // namespace

Vec3<double> direction(Random& random) {
  Vec3<double> x;
  do {
    x = in_cube(random, 1);
  } while (!(x.squaredNorm() <= 1 && x.squaredNorm() > 0.01));
  return x / std::sqrt(x.squaredNorm());
}

Quaternion<double> orientation(Random& random) {
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

double size(Random& random) { return to_float(random.uniform(0.5, 1)); }

Shape<double> round_shape(Random& random, Round kind) {
  switch (kind) {
    case Round::sphere:
      return Sphere<double>{size(random)};
    case Round::capsule: {
      const double radius = size(random) / 2;
      return Capsule<double>{radius, size(random) / 2};
    }
    case Round::ellipsoid:
      return Ellipsoid<double>{sizes(random)};
    case Round::cylinder: {
      const double radius = size(random);
      return Cylinder<double>{radius, size(random)};
    }
    case Round::cone:
      break;
  }
  const double radius = size(random);
  return Cone<double>{radius, size(random)};
}

Shape<double> round_hull(Random& random, int vertices, bool climbs) {
  const Vec3<double> radii = sizes(random);
  std::vector<Vec3<double>> list;
  list.reserve(static_cast<std::size_t>(vertices));
  for (int i = 0; i < vertices; ++i) list.push_back(to_float(radii.cwiseProduct(direction(random))));
  const std::span<const Vec3<double>> points(list);
  return climbs ? with_adjacency(points) : Hull<double>(points);
}

Shape<double> box(Random& random) { return Box<double>{sizes(random)}; }

Shape<double> curved_sum(Random& random) {
  const auto any_round = [&] { return round_shape(random, static_cast<Round>(random.below(5))); };
  switch (random.below(4)) {
    case 0: {
      Shape<double> first = any_round();
      return sum<double>(std::move(first), box(random));
    }
    case 1: {
      Shape<double> first = any_round();
      return hull_of<double>(std::move(first), translated<double>(any_round(), to_float(in_cube(random, 1))));
    }
    case 2: {
      Shape<double> swept_one = swept<double>(any_round(), to_float(in_cube(random, 1)));
      return rounded<double>(std::move(swept_one), size(random) / 4);
    }
    default: {
      Shape<double> first = round_shape(random, Round::ellipsoid);
      const Quaternion<double> turned = orientation(random);
      return sum<double>(std::move(first), posed<double>(any_round(), {0, 0, 0}, turned));
    }
  }
}

void send(Random& random, corpus::Case& problem, double beside) {
  problem.a.orientation = orientation(random);
  problem.b.orientation = orientation(random);
  problem.a.position = to_float(in_cube(random, 1));
  const Vec3<double> start = random.uniform(3, 4) * direction(random);
  const Vec3<double> target = beside * in_cube(random, 1);
  if (random.once_in(2)) problem.a.displacement = to_float(in_cube(random, 1));
  problem.b.position = to_float(Vec3<double>(problem.a.position + start));
  problem.b.displacement =
      to_float(Vec3<double>(problem.a.displacement + random.uniform(1, 2) * (target - start)));
}

void stand(Random& random, corpus::Case& problem, double apart) {
  problem.a.orientation = orientation(random);
  problem.b.orientation = orientation(random);
  problem.a.position = to_float(in_cube(random, 1));
  problem.b.position = to_float(Vec3<double>(problem.a.position + apart * direction(random)));
}

}  // namespace graze::price
