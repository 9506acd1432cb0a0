#include "properties/generate/large_hull.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <graze/detail/shapes/hull_graph.hpp>
#include <utility>
#include <vector>

#include "corpus/families/draw.hpp"
#include "properties/generate/meeting.hpp"

namespace graze::law {

using corpus::Case;
using corpus::Random;

namespace {

using Points = std::vector<Vec3<double>>;

// Not of length 0. Uniform in no sense, and without a cosine: the same on every machine.
Vec3<double> draw_unit(Random& random) {
  Vec3<double> x = draw_vector(random, 1);
  while (x.squaredNorm() < 0.01) x = draw_vector(random, 1);
  return x / std::sqrt(x.squaredNorm());
}

// On the circle of radius 1 about z.
Vec3<double> draw_on_circle(Random& random) {
  const double t = random.uniform(-1, 1), norm = 1 + t * t, x = (1 - t * t) / norm;
  return {random.once_in(2) ? x : -x, 2 * t / norm, 0};
}

// Two points of the unit sphere on either side of a plane through the origin: one is the farther to one side, the other
// to the other. In the cube of directions the plane is a line beside a border of the map's squares. It is nearer to the
// border than the error of a computed place on the cube. `between` is beyond the line, from the border, and as near.
// Both are beside a corner of the squares, or the middle of an edge.
struct Pair {
  Vec3<double> one, other, between;
};
Pair draw_pair(Random& random) {
  const int axis = random.integer(0, 2);
  const bool turn = random.once_in(2);
  const int across = (axis + (turn ? 2 : 1)) % 3, along = (axis + (turn ? 1 : 2)) % 3;
  const double side = random.once_in(2) ? 1 : -1,
               border = (random.once_in(2) ? 1 : -1) * (random.once_in(4) ? 0.25 : 0.5);
  Vec3<double> middle;
  middle[axis] = side;
  const double beyond = random.unit();
  middle[across] = border * (1 + 0x1p-11 * beyond);
  middle[along] = 0.25 * random.integer(-3, 3);
  Vec3<double> apart = Vec3<double>::Zero();  // perpendicular to the plane
  apart[axis] = -side * middle[across];
  apart[across] = 1;
  apart *= std::ldexp(1.0, -random.integer(3, 5));
  Pair out{(middle + apart).normalized(), (middle - apart).normalized(), middle};
  out.between[across] = border * (1 + 0x1p-11 * random.uniform(beyond, 1));
  return out;
}

// Points, and directions along which the hull is worth meeting.
struct Dense {
  Points points;
  std::vector<Vec3<double>> directions;
};

enum class Sort { ellipsoid, lattice, rings, cone, clusters, pairs };
constexpr std::array kSorts = {Sort::ellipsoid, Sort::lattice,  Sort::rings,
                               Sort::cone,      Sort::clusters, Sort::pairs};

// Within [-1, 1] in each axis, which pairs reach.
Dense draw_points(Random& random, Sort sort, std::size_t count) {
  Dense out;
  Points& all = out.points;
  switch (sort) {
    case Sort::ellipsoid:
      while (all.size() < count) all.push_back(draw_unit(random));
      break;
    case Sort::lattice: {
      const int reach = random.integer(4, 6);
      while (all.size() < count) {
        const Vec3<double> x(random.integer(-reach, reach), random.integer(-reach, reach),
                             random.integer(-reach, reach));
        if (x.squaredNorm() <= reach * reach) all.emplace_back(x / 8);
      }
      break;
    }
    case Sort::rings:
      while (all.size() < count) {
        const Vec3<double> x = draw_on_circle(random);
        for (const double z : {0.5, -0.5}) all.emplace_back(x + Vec3<double>(0, 0, z));
      }
      break;
    case Sort::cone:
      all.emplace_back(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1);
      while (all.size() < count) all.push_back(draw_on_circle(random));
      break;
    case Sort::clusters: {
      const double apart = std::ldexp(1.0, -random.integer(19, 26));
      while (all.size() < count) {
        const Vec3<double> x = draw_unit(random);
        for (int k = 0; k < 6; ++k) all.emplace_back(x + draw_vector(random, apart));
        out.directions.push_back(x);
      }
      break;
    }
    case Sort::pairs:
      for (int i = 0; i < 3; ++i) {
        all.push_back(Vec3<double>::Unit(i));
        all.emplace_back(-Vec3<double>::Unit(i));
      }
      while (all.size() < count) {
        const Pair pair = draw_pair(random);
        all.push_back(pair.one);
        all.push_back(pair.other);
        out.directions.push_back(pair.between);
      }
      break;
  }
  return out;
}

struct Large {
  Hull<double> hull;
  std::vector<Vec3<double>> directions;
};

Large draw_hull(Random& random) {
  constexpr std::size_t kMore = 64;
  const Sort sort = kSorts[random.below(kSorts.size())];
  Dense dense = draw_points(random, sort, graze::detail::kMapFrom + random.below(kMore));
  Points& all = dense.points;
  Vec3<double> extent(1, 1, 1);
  if (!random.once_in(3)) {
    for (int i = 0; i < 3; ++i) extent[i] = std::ldexp(1.0, random.integer(-2, 2));
    if (random.once_in(4)) extent[random.integer(0, 2)] = std::ldexp(1.0, -random.integer(8, 20));
    // Floats cannot tell its two sides apart.
    if (random.once_in(16)) extent[random.integer(0, 2)] = std::ldexp(1.0, -random.integer(64, 80));
  }
  const bool floats = random.once_in(2);
  const Vec3<double> out = random.once_in(4) ? draw_vector(random, std::ldexp(1.0, random.integer(1, 10)))
                                             : Vec3<double>(Vec3<double>::Zero());
  for (Vec3<double>& x : all) {
    x = x.cwiseProduct(extent) + out;
    for (int i = 0; floats && i < 3; ++i) x[i] = corpus::round_to_float(x[i]);
  }
  for (std::size_t k = all.size(); k > 1; --k) std::swap(all[k - 1], all[random.below(k)]);
  for (Vec3<double>& d : dense.directions) d = d.cwiseQuotient(extent).normalized();
  return {with_adjacency(all), std::move(dense.directions)};
}

Vec3<double> farthest(const Hull<double>& hull, const Vec3<double>& d) {
  Vec3<double> best = hull.vertex(0);
  for (const Vec3<double>& x : hull.vertices()) {
    if (x.dot(d) > best.dot(d)) best = x;
  }
  return best;
}

// Turns z to n, which is no -z.
Quaternion<double> turning_up_to(const Vec3<double>& n) { return {1 + n[2], -n[1], n[0], 0}; }

// B, and its point that will meet A, where n is A's normal. A box's face has the same normal.
Vec3<double> take_box(Random& random, Body<double>& b, const Vec3<double>& n) {
  const Vec3<double> half(random.uniform(0.5, 4), random.uniform(0.5, 4), random.uniform(0.125, 1));
  b.shape = Box<double>{half};
  if (1 + n[2] > 0.01) b.orientation = turning_up_to(n);
  const Vec3<double> x(random.uniform(-0.5, 0.5) * half[0], random.uniform(-0.5, 0.5) * half[1], -half[2]);
  return corpus::rotate(b.orientation, x);
}
Vec3<double> take_other(Random& random, Body<double>& b, const Vec3<double>& n) {
  switch (random.below(5)) {
    case 0:
      b.shape = Point<double>{};
      return Vec3<double>::Zero();
    case 1: {
      const double radius = std::ldexp(1.0, -random.integer(0, 6));
      b.shape = Sphere<double>{radius};
      return -radius * n;
    }
    case 2: {
      const Triangle<double> triangle{draw_vector(random, 1), draw_vector(random, 1), draw_vector(random, 1)};
      b.shape = triangle;
      return triangle.b;
    }
    case 3: {
      Vec3<double> half(random.uniform(0.5, 4), random.uniform(0.5, 4), random.uniform(0.125, 1));
      b.shape = Box<double>{half};
      return half;
    }
    default: {
      Large other = draw_hull(random);
      Vec3<double> x = farthest(other.hull, -n);
      b.shape = random.once_in(3) ? Hull<double>(other.hull.vertices()) : std::move(other.hull);
      return x;
    }
  }
}

}  // namespace

Case draw_large_hull(Random& random) {
  Case problem;
  problem.family = "large hulls";
  const Large large = draw_hull(random);
  const auto& known = large.directions;
  const Vec3<double> d = known.empty() ? draw_unit(random) : known[random.below(known.size())];
  problem.a.shape = large.hull;
  if (random.once_in(2)) problem.a.orientation = draw_orientation(random);
  problem.a.position = draw_vector(random, 2);
  const Vec3<double> n = corpus::rotate(problem.a.orientation, d);
  const Vec3<double> at =
      random.once_in(3) ? take_other(random, problem.b, n) : take_box(random, problem.b, n);
  const Vec3<double> met =
      problem.a.position + corpus::rotate(problem.a.orientation, farthest(large.hull, d)) - at;
  Vec3<double> v = -random.uniform(1, 4) * n;
  double over = 0;
  switch (random.below(3)) {
    case 0:
      break;
    case 1:
      v += draw_vector(random, 2);
      break;
    default:
      // Across n, over A or into it by this much, and never farther from contact than a step of the path.
      v = n.cross(draw_unit(random)) * 4;
      over = (random.once_in(2) ? 1 : -1) * std::ldexp(1.0, -random.integer(8, 30));
  }
  problem.b.displacement = v;
  const double t = random.once_in(8) ? 0 : random.uniform(0.25, 0.75);
  problem.b.position = met + over * n - t * v;
  if (random.once_in(2)) std::swap(problem.a, problem.b);
  return problem;
}

Case draw_turning_large_hull(Random& random) {
  Case problem = draw_large_hull(random);
  corpus::Spin *one = &problem.spin_a, *other = &problem.spin_b;
  if (random.once_in(2)) std::swap(one, other);
  one->rotation = draw_vector(random, 2);
  if (random.once_in(2)) other->rotation = draw_vector(random, 2);
  return problem;
}

}  // namespace graze::law
