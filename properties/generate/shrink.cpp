#include "properties/generate/shrink.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "properties/edit/case.hpp"

namespace graze::law {

using corpus::Case;

namespace {

// The number of bits behind the point: 0 for an integer.
int fraction_bits(double x) {
  if (x == 0 || !std::isfinite(x)) return 0;
  int exponent = 0;
  const auto bits = static_cast<std::uint64_t>(std::scalbn(std::frexp(std::abs(x), &exponent), 53));
  return std::max(0, 53 - std::countr_zero(bits) - exponent);
}

// The measure of a number: 0 for 0, then significant bits, exponent, and the bits behind the point. Smaller numbers
// read better.
int complexity(double x) {
  if (x == 0) return 0;
  if (!std::isfinite(x)) return 1;  // an infinite horizon (nothing else infinite is drawn)
  int exponent = 0;
  const double mantissa = std::frexp(std::abs(x), &exponent);
  const auto bits = static_cast<std::uint64_t>(std::scalbn(mantissa, 53));
  const int significant = 53 - std::countr_zero(bits);
  return 1 + 2 * significant + std::abs(exponent - 1) + 3 * std::min(fraction_bits(x), 8) + (x < 0 ? 1 : 0);
}

double keep_bits(double x, int bits) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::scalbn(std::nearbyint(std::scalbn(mantissa, bits)), exponent - bits);
}

// To the nearest multiple of 2^grid, never -0.
double on_grid(double x, int grid) { return std::scalbn(std::nearbyint(std::scalbn(x, -grid)), grid) + 0.0; }

std::vector<double> simpler_numbers(double x) {
  std::vector<double> all;
  if (!std::isfinite(x)) return all;
  for (const double y : {0.0, 1.0, x < 0 ? -1.0 : 2.0, std::nearbyint(x), keep_bits(x, 2), keep_bits(x, 8),
                         keep_bits(x, 24), x / 2, -x, keep_bits(x, 40)}) {
    if (complexity(y) < complexity(x) && std::find(all.begin(), all.end(), y) == all.end()) all.push_back(y);
  }
  return all;
}

// Shapes with fewer nodes, or fewer and simpler numbers: a part for the whole, a ball for what is round,
// fewer vertices.
void simpler_shapes(const Shape<double>& shape, std::vector<Shape<double>>& all) {
  const auto add = [&](Shape<double> one) { all.push_back(std::move(one)); };
  if (!std::holds_alternative<Point<double>>(shape)) add(Point<double>{});
  if (const auto* triangle = std::get_if<Triangle<double>>(&shape)) {
    add(Segment<double>{triangle->a, triangle->b});
    add(Segment<double>{triangle->a, triangle->c});
    add(Segment<double>{triangle->b, triangle->c});
  } else if (const auto* ellipsoid = std::get_if<Ellipsoid<double>>(&shape)) {
    add(Sphere<double>{ellipsoid->radii.maxCoeff()});
  } else if (const auto* capsule = std::get_if<Capsule<double>>(&shape)) {
    add(Sphere<double>{capsule->radius});
  } else if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape)) {
    add(Sphere<double>{cylinder->radius});
  } else if (const auto* cone = std::get_if<Cone<double>>(&shape)) {
    add(Sphere<double>{cone->radius});
  } else if (const auto* hull = std::get_if<Hull<double>>(&shape)) {
    // Halves, then single vertices.
    for (std::size_t chunk = hull->size() / 2; chunk >= 1; chunk /= 2) {
      for (std::size_t first = 0; first + chunk <= hull->size(); first += chunk) {
        std::vector<Vec3<double>> rest;
        for (std::size_t i = 0; i < hull->size(); ++i) {
          if (i < first || i >= first + chunk) rest.push_back(hull->vertex(i));
        }
        if (!rest.empty()) add(Hull<double>(std::span<const Vec3<double>>(rest)));
      }
    }
  }
  // A part by itself, the combinator without one part, or with one part made simpler.
  const std::vector<SharedShape<double>> parts = parts_of(shape);
  const bool many =
      std::holds_alternative<Sum<double>>(shape) || std::holds_alternative<HullOf<double>>(shape);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i]) continue;
    add(parts[i]->shape);
    if (many && parts.size() > 1) {
      std::vector<SharedShape<double>> rest = parts;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      add(with_parts(shape, std::move(rest)));
    }
    std::vector<Shape<double>> smaller;
    simpler_shapes(parts[i]->shape, smaller);
    for (Shape<double>& one : smaller) {
      std::vector<SharedShape<double>> changed = parts;
      changed[i] = share(std::move(one));
      add(with_parts(shape, std::move(changed)));
    }
  }
}

bool plain(const Quaternion<double>& q) { return q.is_identity() && q.w == 1; }
bool plain(const Body<double>& body) { return plain(body.orientation); }

// Simpler bodies at the place of a part of this one, for a body without orientation. A posed part becomes a body in
// that pose. A point is put at a vertex, in the middle between two, or in the middle of a box's face.
void pieces_in_place(const Body<double>& body, std::vector<Body<double>>& all) {
  if (!plain(body)) return;
  const auto add = [&](Shape<double> shape, const Vec3<double>& offset, const Quaternion<double>& turn) {
    Body<double> piece = body;
    piece.shape = std::move(shape);
    piece.position += offset;
    piece.orientation = turn;
    all.push_back(std::move(piece));
  };
  if (const auto* posed = std::get_if<Posed<double>>(&body.shape); posed != nullptr && posed->shape) {
    add(posed->shape->shape, posed->position, posed->orientation);
  }
  std::vector<Vec3<double>> vertices;
  if (const auto* segment = std::get_if<Segment<double>>(&body.shape)) {
    vertices = {segment->a, segment->b};
  } else if (const auto* triangle = std::get_if<Triangle<double>>(&body.shape)) {
    vertices = {triangle->a, triangle->b, triangle->c};
  } else if (const auto* hull = std::get_if<Hull<double>>(&body.shape)) {
    for (std::size_t i = 0; i < hull->size(); ++i) vertices.push_back(hull->vertex(i));
  }
  if (const auto* box = std::get_if<Box<double>>(&body.shape)) {
    for (int i = 0; i < 6; ++i) {
      add(Point<double>{}, (i < 3 ? 1 : -1) * box->half_extents[i % 3] * Vec3<double>::Unit(i % 3), {});
    }
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3<double> signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      add(Point<double>{}, box->half_extents.cwiseProduct(signs), {});
    }
  }
  for (const Vec3<double>& vertex : vertices) add(Point<double>{}, vertex, {});
  constexpr std::size_t kFew = 4;  // pairs of more would take the whole budget
  for (std::size_t i = 0; vertices.size() <= kFew && i < vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) add(Point<double>{}, (vertices[i] + vertices[j]) / 2, {});
  }
}

// Facts about the lengths of a case: the exponent of the largest, by frexp, and the most bits behind the point.
struct Lengths {
  int exponent = 0, fraction = 0;
};
Lengths lengths_of(const Case& problem) {
  double largest = 0;
  Lengths lengths;
  visit_scalars(problem, [&](Slot slot, double x) {
    if (!is_length(slot)) return;
    largest = std::max(largest, std::abs(x));
    lengths.fraction = std::max(lengths.fraction, fraction_bits(x));
  });
  (void)std::frexp(largest, &lengths.exponent);
  return lengths;
}

// All lengths at once, if no number can change by itself. They are brought near 1 by a power of two, made integers by
// one, or rounded to one grid, from 1/2 to 1/256 of the largest.
void simpler_scenes(const Case& problem, std::vector<Case>& all) {
  const auto [exponent, fraction] = lengths_of(problem);
  for (const int k : {1 - exponent, 2 - exponent, 3 - exponent, fraction}) {
    if (std::optional<Case> other = k == 0 ? std::nullopt : scaled(problem, k))
      all.push_back(std::move(*other));
  }
  for (const int bits : {1, 2, 3, 4, 6, 8}) {
    const int grid = exponent - bits;
    all.push_back(
        map_scalars(problem, [&](Slot slot, double x) { return is_length(slot) ? on_grid(x, grid) : x; }));
  }
}

// The vertices where the rotation puts them, rounded to a grid of 1/16 or 1/4096 of the largest, instead of the
// rotation.
void turned_vertices(const Body<double>& body, std::vector<Body<double>>& all) {
  const auto* hull = std::get_if<Hull<double>>(&body.shape);
  if (hull == nullptr || hull->size() == 0 || plain(body)) return;
  const Quaternion<double>& q = body.orientation;
  const Eigen::Matrix3d turn = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  double largest = 0;
  for (std::size_t i = 0; i < hull->size(); ++i) {
    largest = std::max(largest, hull->vertex(i).cwiseAbs().maxCoeff());
  }
  int exponent = 0;
  (void)std::frexp(largest, &exponent);
  for (const int bits : {4, 12}) {
    std::vector<Vec3<double>> vertices;
    for (std::size_t i = 0; i < hull->size(); ++i) {
      Vec3<double> x = turn * hull->vertex(i);
      for (double& one : x) {
        one = on_grid(one, exponent - bits);
      }
      vertices.push_back(x);
    }
    Body<double> other = body;
    other.shape = Hull<double>(std::span<const Vec3<double>>(vertices));
    other.orientation = {};
    all.push_back(std::move(other));
  }
}

}  // namespace

std::vector<Case> simpler(const Case& problem) {
  std::vector<Case> all;
  const auto with = [&](auto&& edit) {
    Case other = problem;
    edit(other);
    all.push_back(std::move(other));
  };
  // Two points that meet head on, at t = 1.
  with([](Case& c) {
    c.b.position = c.a.position + c.a.displacement - c.b.displacement;
    c.a.shape = c.b.shape = Point<double>{};
  });
  for (const auto body : {&Case::a, &Case::b}) {
    std::vector<Shape<double>> shapes;
    simpler_shapes((problem.*body).shape, shapes);
    for (Shape<double>& shape : shapes) with([&](Case& c) { (c.*body).shape = std::move(shape); });
    std::vector<Body<double>> pieces;
    pieces_in_place(problem.*body, pieces);
    turned_vertices(problem.*body, pieces);
    for (Body<double>& piece : pieces) with([&](Case& c) { c.*body = std::move(piece); });
    if (!plain(problem.*body)) with([&](Case& c) { (c.*body).orientation = {}; });
    if (!(problem.*body).displacement.isZero(0)) with([&](Case& c) { (c.*body).displacement.setZero(); });
  }
  for (const auto spin : {&Case::spin_a, &Case::spin_b}) {
    if (!(problem.*spin).rotation.isZero(0)) with([&](Case& c) { (c.*spin).rotation.setZero(); });
    if (!(problem.*spin).pivot.isZero(0)) with([&](Case& c) { (c.*spin).pivot.setZero(); });
  }
  // A brought to the origin, and to rest: B keeps what it is relative to A.
  if (!problem.a.position.isZero(0)) {
    with([](Case& c) {
      c.b.position -= c.a.position;
      c.a.position.setZero();
    });
  }
  if (!problem.a.displacement.isZero(0)) {
    with([](Case& c) {
      c.b.displacement -= c.a.displacement;
      c.a.displacement.setZero();
    });
  }
  if (problem.t_max != 1) with([](Case& c) { c.t_max = 1; });
  with([](Case& c) { c.start_policy = StartPolicy::report; });
  simpler_scenes(problem, all);
  // Every number by itself. A quaternion may not vanish.
  const std::vector<double> numbers = scalars(problem);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (const double y : simpler_numbers(numbers[i])) {
      std::size_t at = 0;
      bool turned_by_number = false;
      Case other = map_scalars(problem, [&](Slot slot, double x) {
        if (at++ != i) return x;
        turned_by_number = slot == Slot::orientation;
        return slot == Slot::extent || slot == Slot::horizon || slot == Slot::target ? std::abs(y) : y;
      });
      if (turned_by_number && !in_domain(other) && !!in_domain(problem)) continue;
      all.push_back(std::move(other));
    }
  }
  const auto measure = [](const Case& c) {
    long long sum = 0;
    for (const double x : scalars(c)) sum += 1 + complexity(x);
    sum += node_count(c.a.shape) + node_count(c.b.shape);
    // An identity turn, a unit horizon and no policy count as nothing, so that they are goals.
    for (const Body<double>* body : {&c.a, &c.b}) sum -= plain(*body) ? 10 : 0;
    return sum - (c.t_max == 1 ? 10 : 0) - (c.start_policy == StartPolicy::report ? 1 : 0);
  };
  const long long limit = measure(problem);
  std::erase_if(all, [&](Case& c) {
    c.expect.reset();
    return measure(c) >= limit;
  });
  return all;
}

Case minimised(Case problem, const std::function<bool(const Case&)>& fails, int budget) {
  for (bool smaller = true; smaller && budget > 0;) {
    smaller = false;
    for (Case& candidate : simpler(problem)) {
      if (budget-- <= 0) break;
      if (!fails(candidate)) continue;
      problem = std::move(candidate);
      smaller = true;
      break;
    }
  }
  return problem;
}

}  // namespace graze::law
