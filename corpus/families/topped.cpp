#include "corpus/families/topped.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze::corpus {
namespace {

// The other vertices lie below the top by at least this much (length, sizes are about 4).
constexpr double kBelowTop = 0.25;
// A quarter of a turn about z.
constexpr Quaternion<double> kQuarterTurn = {1, 0, 0, 1};

Vec3<double> below(Draw& draw, double reach) {
  const double x = draw.on_grid(reach), y = draw.on_grid(reach);
  const double depth = std::max(draw.positive_on_grid(2 * reach), std::max(kBelowTop, draw.grid_step()));
  return {x, y, -depth};
}

// Away from the body's own origin, half of the time.
Vec3<double> shift_of(Draw& draw, double reach) {
  if (draw.random.once_in(2)) return Vec3<double>::Zero();
  const double x = draw.on_grid(reach), y = draw.on_grid(reach);
  return {x, y, draw.on_grid(reach)};
}

// On a corner: R of (2, 1, 1, 0) is {{2, 1, 2}, {1, 2, -2}, {-2, 2, 1}} / 3, and the extents are multiples
// of 3.
Topped box_on_corner(Draw& draw, double reach) {
  const double x = draw.positive_on_grid(reach / 3), y = draw.positive_on_grid(reach / 3);
  const double z = draw.positive_on_grid(reach / 3);
  // Its top corner is (-x, y, z) times 3.
  const Vec3<double> corner((y + 2 * z) - 2 * x, (2 * y - x) - 2 * z, (2 * x + 2 * y) + z);
  return {Box<double>{Vec3<double>(3 * x, 3 * y, 3 * z)}, {2, 1, 1, 0}, Vec3<double>::Zero() - corner};
}

// On an edge along x: (2, 1, 0, 0) turns about x by an angle of cosine 3/5 and sine 4/5.
Topped box_on_edge(Draw& draw, double reach, bool along_x) {
  const double length = draw.positive_on_grid(reach);
  const double y = draw.positive_on_grid(reach / 4), z = draw.positive_on_grid(reach / 4);
  const Vec3<double> corner(0, 3 * y - 4 * z, 4 * y + 3 * z);
  Topped box{Box<double>{Vec3<double>(length, 5 * y, 5 * z)}, {2, 1, 0, 0}, Vec3<double>::Zero() - corner};
  if (!along_x) {
    box.orientation = multiply(kQuarterTurn, box.orientation);
    box.position = rotate(kQuarterTurn, box.position);
  }
  return box;
}

Topped hull_of_top(Draw& draw, std::vector<Vec3<double>> top, double reach) {
  const Vec3<double> shift = shift_of(draw, reach);
  return {hull_under(draw, std::move(top), reach, shift), {}, shift};
}

Vec3<double> negated(const Vec3<double>& x) { return Vec3<double>::Zero() - x; }

Shape<double> negated(const Shape<double>& shape) {
  if (const auto* segment = std::get_if<Segment<double>>(&shape)) {
    return Segment<double>{negated(segment->a), negated(segment->b)};
  }
  if (const auto* triangle = std::get_if<Triangle<double>>(&shape)) {
    return Triangle<double>{negated(triangle->a), negated(triangle->b), negated(triangle->c)};
  }
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) {
    std::vector<Vec3<double>> list(hull->vertices().begin(), hull->vertices().end());
    for (Vec3<double>& x : list) x = negated(x);
    return Hull<double>(std::span<const Vec3<double>>(list));
  }
  if (const auto* round = std::get_if<Rounded<double>>(&shape)) {
    return rounded<double>(negated(round->shape->shape), round->radius);
  }
  return shape;  // symmetric about its origin
}

}  // namespace

Shape<double> hull_under(Draw& draw, std::vector<Vec3<double>> top, double reach, const Vec3<double>& shift) {
  Random& random = draw.random;
  const int vertices = random.integer(4, 24);
  while (static_cast<int>(top.size()) < vertices) top.push_back(below(draw, reach));
  // Any order: no method may lean on the top feature being first.
  for (std::size_t k = top.size(); k > 1; --k) std::swap(top[k - 1], top[random.below(k)]);
  for (Vec3<double>& x : top) x = x - shift;
  return Hull<double>(std::span<const Vec3<double>>(top));
}

Topped topped_vertex(Draw& draw, double reach) {
  const Vec3<double> top = Vec3<double>::Zero();
  switch (draw.random.below(8)) {
    case 0:
      return {Point<double>{}, {}};
    case 1: {
      const Vec3<double> shift = shift_of(draw, reach);
      return {Segment<double>{top - shift, below(draw, reach) - shift}, {}, shift};
    }
    case 2: {
      const Vec3<double> shift = shift_of(draw, reach), low = below(draw, reach);
      return {Triangle<double>{low - shift, top - shift, below(draw, reach) - shift}, {}, shift};
    }
    case 3:
    case 4:
      return box_on_corner(draw, reach);
    default:
      return hull_of_top(draw, {top}, reach);
  }
}

Vec3<double> edge_vector(Draw& draw) {
  if (draw.random.once_in(2)) {
    return draw.random.once_in(2) ? Vec3<double>(1, 0, 0) : Vec3<double>(0, 1, 0);
  }
  const double x = draw.on_grid(1);
  const Vec3<double> edge(1 + draw.positive_on_grid(1), x, 0);
  return draw.random.once_in(2) ? edge : Vec3<double>(edge[1], edge[0], 0);
}

Topped topped_edge(Draw& draw, double reach, const Vec3<double>& edge) {
  const Vec3<double> p = draw.random.integer(1, 2) * edge;
  const Vec3<double> q = negated(draw.random.integer(1, 2) * edge);
  switch (draw.random.below(8)) {
    case 0:
      return {Segment<double>{p, q}, {}};
    case 1: {
      const Vec3<double> shift = shift_of(draw, reach);
      return {Triangle<double>{p - shift, below(draw, reach) - shift, q - shift}, {}, shift};
    }
    case 2:
    case 3:
    case 4:
      if (edge[0] == 0 || edge[1] == 0) return box_on_edge(draw, reach, edge[1] == 0);
      [[fallthrough]];
    default:
      return hull_of_top(draw, {p, q}, reach);
  }
}

Topped topped_face(Draw& draw, double reach) {
  // (a, b) and a vector to its left, |b| and the other's x of either size: never collinear.
  const double a = draw.positive_on_grid(reach / 2), b = std::abs(draw.on_grid(reach / 2));
  const double c = -draw.positive_on_grid(reach / 2), d = draw.positive_on_grid(reach / 2);
  const Vec3<double> p(a, b, 0), q(c, d, 0), r(0 - (a + c), 0 - (b + d), 0);
  switch (draw.random.below(8)) {
    case 0:
      return {Triangle<double>{p, q, r}, {}};
    case 1:
    case 2:
    case 3: {
      const double x = draw.positive_on_grid(reach), y = draw.positive_on_grid(reach);
      const double z = draw.positive_on_grid(reach);
      return {Box<double>{Vec3<double>(x, y, z)}, {}, Vec3<double>(0, 0, -z)};
    }
    case 4:
    case 5:
      return hull_of_top(draw, {p, q, r}, reach);
    default:
      return hull_of_top(draw, {p, q, negated(p), negated(q)}, reach);
  }
}

void turn_about_z(Draw& draw, Topped& body) {
  if (body.position[0] == 0 && body.position[1] == 0) {
    body.orientation = multiply(draw.pose_about_z(), body.orientation);
  } else {
    body.orientation = multiply(kQuarterTurn, body.orientation);
    body.position = rotate(kQuarterTurn, body.position);
  }
}

Topped mirrored(const Topped& body) {
  // A cone's mirror image is the cone turned by half a turn about x.
  const bool cone = std::holds_alternative<Cone<double>>(body.shape);
  return {negated(body.shape), cone ? multiply(body.orientation, {0, 1, 0, 0}) : body.orientation,
          negated(body.position)};
}

double reach_of(const Topped& body) {
  const Vec3<double> x = body.position;
  return std::sqrt(x[0] * x[0] + x[1] * x[1]) + bounding_radius(body.shape);
}

void finish_exactly(Draw& draw, Case& problem) {
  Random& random = draw.random;
  if (random.once_in(16)) problem.t_max = kInfinity<double>;
  vary_time_scale(draw, problem);
  if (random.once_in(6)) {
    // As it stands: z is up.
  } else {
    turn_either_way(draw, problem);
  }
  maybe_swap(draw, problem);
}

Topped topped_any(Draw& draw, double reach) {
  switch (draw.random.below(3)) {
    case 0:
      return topped_vertex(draw, reach);
    case 1:
      return topped_edge(draw, reach, edge_vector(draw));
    default:
      return topped_face(draw, reach);
  }
}

void pass_over(Draw& draw, Case& problem, const Topped& a, const Topped& b, const Vec3<double>& direction,
               double delta) {
  Random& random = draw.random;
  const double t0 = 0.125 * random.integer(3, 5);
  // Three times it is a grid number and, times t0 or 1 - t0, more than the sum of the reaches.
  const double reach = std::floor(reach_of(a) + reach_of(b)) + 1;
  Vec3<double> v;
  if (direction == Vec3<double>::Zero()) {
    const int axis = random.integer(0, 1);
    const double along = 3 * reach + draw.positive_on_grid(reach);
    const double across = random.once_in(4) ? 0 : draw.on_grid(reach);
    v[axis] = random.once_in(2) ? along : -along;
    v[1 - axis] = across;
    v[2] = 0;
  } else {
    const double largest = std::max(std::abs(direction[0]), std::abs(direction[1]));
    const double times = std::floor(3 * reach / largest) + random.integer(1, 4);
    v = (random.once_in(2) ? times : -times) * direction;
    for (int i = 0; i < 3; ++i) v[i] = 0 + v[i];
  }
  const Topped below = mirrored(b);
  problem.a.shape = a.shape;
  problem.a.orientation = a.orientation;
  problem.a.position = a.position - below.position;
  problem.b.shape = below.shape;
  problem.b.orientation = below.orientation;
  problem.b.position = Vec3<double>(0 - t0 * v[0], 0 - t0 * v[1], delta);
  set_motion(draw, problem, v);
  finish_exactly(draw, problem);
}

}  // namespace graze::corpus
