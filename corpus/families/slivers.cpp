// slivers: triangles and hulls with faces that are needles of aspect 10^k. Hardness: k.
//
// The shapes are:
//   - a triangle with its third corner 10^-k beside the middle of the opposite side, or beside one of its ends,
//   - a tetrahedron of two diagonals that pass each other by 10^-k,
//   - the ten nodes of a second-order tetrahedron, four corners and the edges' midpoints with noise of 10^-k,
//   - a hull with 2 to 6 more corners beside its edges.
// The corner beside the middle is (0, 0, 0) and that offset, exact however small. Other corners are the
// doubles next to the offset position, known to 4 u of coordinates of 4.
//
// Difficulties: normals by cross products of such edges have no digit from k = 8 on (their squares from k =
// 4, in float). Barycentric divisors vanish. A point of the simplex that is nearest by rounding is not the
// nearest. Mesh importers and element libraries produce such corners all the time.
#include <utility>

#include "corpus/families/families_list.hpp"
#include "corpus/families/placing.hpp"

namespace graze::corpus {
namespace {

constexpr double kSliverReach = 4;  // size of a shape (length)

Vec3<double> noise(Random& random, double size) {
  Vec3<double> x;
  for (int i = 0; i < 3; ++i) x[i] = size * random.uniform(-1, 1);
  return x;
}

// A grid vector of 1 to 4 along an axis.
Vec3<double> side(Draw& draw) {
  Vec3<double> p;
  for (int i = 0; i < 3; ++i) p[i] = draw.on_grid(kSliverReach);
  p[draw.random.integer(0, 2)] = 1 + draw.positive_on_grid(kSliverReach - 1);
  return p;
}

// The point of the edge at a quarter, the half or three quarters of it, and the noise.
Vec3<double> beside_edge(Random& random, const Vec3<double>& p, const Vec3<double>& q, double t,
                         double size) {
  const Vec3<double> off = noise(random, size);
  Vec3<double> x;
  for (int i = 0; i < 3; ++i) x[i] = (p[i] + t * (q[i] - p[i])) + off[i];
  return x;
}

Shape<double> sliver(Draw& draw, double size) {
  Random& random = draw.random;
  const Vec3<double> zero = Vec3<double>::Zero();
  switch (random.below(6)) {
    case 0: {
      const Vec3<double> p = side(draw);
      return Triangle<double>{p, zero - p, noise(random, size)};
    }
    case 1: {
      const Vec3<double> p = side(draw), q = draw.vector(kSliverReach);
      const Vec3<double> r = beside_edge(random, p, q, 0, size);
      return Triangle<double>{q, p, r};
    }
    case 2: {
      const Vec3<double> p = side(draw), q = side(draw), off = noise(random, size);
      const Vec3<double> list[] = {p, zero - p, q + off, off - q};
      return Hull<double>(std::span<const Vec3<double>>(list));
    }
    case 3: {
      std::vector<Vec3<double>> nodes;
      nodes.reserve(10);
      for (int k = 0; k < 4; ++k) nodes.push_back(draw.vector(kSliverReach));
      for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
          nodes.push_back(beside_edge(random, nodes[i], nodes[j], 0.5, size));
        }
      }
      return Hull<double>(std::span<const Vec3<double>>(nodes));
    }
    default: {
      std::vector<Vec3<double>> list;
      const int vertices = random.integer(4, 8), more = random.integer(2, 6);
      list.reserve(static_cast<std::size_t>(vertices) + static_cast<std::size_t>(more));
      for (int k = 0; k < vertices; ++k) list.push_back(draw.vector(kSliverReach));
      for (int k = 0; k < more; ++k) {
        const auto i = static_cast<std::size_t>(random.integer(0, vertices - 2));
        const double t = 0.25 * random.integer(0, 3);
        list.push_back(beside_edge(random, list[i], list[i + 1], t, size));
      }
      for (std::size_t k = list.size(); k > 1; --k) std::swap(list[k - 1], list[random.below(k)]);
      return Hull<double>(std::span<const Vec3<double>>(list));
    }
  }
}

Shape<double> partner(Draw& draw, double size) {
  Random& random = draw.random;
  switch (random.below(6)) {
    case 0:
      return Point<double>{};
    case 1:
      return Segment<double>{draw.vector(kSliverReach), draw.vector(kSliverReach)};
    case 2: {
      const double x = draw.positive_on_grid(kSliverReach), y = draw.positive_on_grid(kSliverReach);
      return Box<double>{Vec3<double>(x, y, draw.positive_on_grid(kSliverReach))};
    }
    default:
      return sliver(draw, size);
  }
}

void fill_slivers(Draw& draw, double hardness, Case& problem) {
  Random& random = draw.random;
  const double size = power_of_ten(-static_cast<int>(hardness));
  problem.a.shape = sliver(draw, size);
  problem.b.shape = partner(draw, size);
  problem.a.orientation = draw.pose();
  problem.b.orientation = draw.pose();
  problem.a.position = draw.vector(8);
  const std::vector<Vec3<double>> list = corners(problem.a.shape), others = corners(problem.b.shape);
  const Vec3<double>& p = list[random.below(list.size())];
  const Vec3<double>& q = list[random.below(list.size())];

  Vec3<double> v = draw.vector(16);
  const int axis = random.integer(0, 2);
  const double along = draw.snap(random.uniform(8, 24));
  v[axis] = random.once_in(2) ? along : -along;
  // Along an edge of A, in the plane of a sliver or nearly.
  if (random.once_in(4) && p != q) {
    const Vec3<double> edge = rotate(problem.a.orientation, p - q);
    for (int i = 0; i < 3; ++i) v[i] = draw.real(4 * edge[i]);
  }
  // Onto a corner, or the middle of two. The target is beside it by as much as the noise, or by a size, or
  // exact.
  Vec3<double> target = p;
  if (random.once_in(2)) {
    for (int i = 0; i < 3; ++i) target[i] = (p[i] + q[i]) / 2;
  }
  Vec3<double> beside = Vec3<double>::Zero();
  if (random.once_in(2)) beside = noise(random, random.once_in(2) ? kSliverReach : 4 * size);
  const Vec3<double> a = rotate(problem.a.orientation, target);
  const Vec3<double> b = rotate(problem.b.orientation, others[random.below(others.size())]);
  meet(draw, problem, a, b, beside, v, meeting_time(random));
  draw_horizon(random, problem);
  vary_time_scale(draw, problem);
  maybe_swap(draw, problem);
}

constexpr double kSliversLevels[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

}  // namespace

const Family family::slivers{
    .name = "slivers",
    .sentence = "Triangles and hulls with nearly collinear corners.",
    .hardness_meaning = "k: a corner is within 10^-k of an edge, for shapes of size 4",
    .levels = kSliversLevels,
    .fill = fill_slivers,
    .picture = {2, 2},
};

}  // namespace graze::corpus
