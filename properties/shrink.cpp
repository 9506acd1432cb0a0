#include "properties/shrink.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "properties/case_edit.hpp"

namespace graze::law {

using corpus::Case;

namespace {

// The measure of a number: 0 for 0, then significant bits and exponent; smaller reads better.
int complexity(double x) {
  if (x == 0) return 0;
  if (!std::isfinite(x)) return 1;  // an infinite horizon; nothing else infinite is drawn
  int exponent = 0;
  const double mantissa = std::frexp(std::abs(x), &exponent);
  const auto bits = static_cast<std::uint64_t>(std::scalbn(mantissa, 53));
  const int significant = 53 - std::countr_zero(bits);
  return 1 + 2 * significant + std::abs(exponent - 1) + (x < 0 ? 1 : 0);
}

double keep_bits(double x, int bits) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::scalbn(std::nearbyint(std::scalbn(mantissa, bits)), exponent - bits);
}

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
  // A part by itself; the combinator without one part; with one part made simpler.
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

bool plain(const Body<double>& body) {
  const Quaternion<double>& q = body.orientation;
  return q.is_identity() && q.w == 1;
}

}  // namespace

std::vector<Case> simpler(const Case& problem) {
  std::vector<Case> all;
  const auto with = [&](auto&& edit) {
    Case other = problem;
    edit(other);
    all.push_back(std::move(other));
  };
  for (const auto body : {&Case::a, &Case::b}) {
    std::vector<Shape<double>> shapes;
    simpler_shapes((problem.*body).shape, shapes);
    for (Shape<double>& shape : shapes) with([&](Case& c) { (c.*body).shape = std::move(shape); });
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
  // Every number by itself; a quaternion may not vanish.
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
      if (turned_by_number && must_be_refused(other) && !must_be_refused(problem)) continue;
      all.push_back(std::move(other));
    }
  }
  const auto measure = [](const Case& c) {
    long long sum = 0;
    for (const double x : scalars(c)) sum += 1 + complexity(x);
    sum += node_count(c.a.shape) + node_count(c.b.shape);
    // An identity turn and a unit horizon count as nothing, so that both are goals.
    for (const Body<double>* body : {&c.a, &c.b}) sum -= plain(*body) ? 10 : 0;
    return sum - (c.t_max == 1 ? 10 : 0);
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
