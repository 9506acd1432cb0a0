#include "fuzz/repair.hpp"

#include <cmath>

namespace graze::fuzz {

using corpus::Case;

Case as_linear(Case problem) {
  problem.spin_a = problem.spin_b = {};
  problem.query = corpus::Query::cast;
  problem.direction.setZero();
  return problem;
}

Case as_turning(Case problem) {
  problem.query = corpus::Query::cast;
  problem.direction.setZero();
  problem.start_policy = StartPolicy::report;
  if (std::isinf(problem.t_max)) problem.t_max = 1;
  for (corpus::Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    const double angle = spin->rotation.stableNorm() * problem.t_max;
    if (!std::isfinite(angle) || angle <= kMostRadians) continue;
    const int beyond = std::ilogb(angle / kMostRadians) + 1;
    for (int i = 0; i < 3; ++i) {
      const double less = std::scalbn(spin->rotation[i], -beyond);
      spin->rotation[i] = std::abs(less) < 0x1p-192 ? 0 : less;
    }
  }
  return problem;
}

namespace {

Shape<double> few_vertices(const Shape<double>& shape);

Shape<double> few_vertices(const SharedShape<double>& part) {
  return part ? few_vertices(part->shape) : Shape<double>();
}

Shape<double> few_vertices(const Shape<double>& shape) {
  return std::visit(
      []<class T>(const T& s) -> Shape<double> {
        if constexpr (std::same_as<T, Hull<double>>) {
          if (s.size() <= kFewVertices) return s;
          return Hull<double>(s.vertices().first(kFewVertices));
        } else if constexpr (std::same_as<T, Sphere<double>>) {
          return Box<double>{{s.radius, s.radius, s.radius}};
        } else if constexpr (std::same_as<T, Capsule<double>>) {
          return Box<double>{{s.radius, s.radius, s.half_height + s.radius}};
        } else if constexpr (requires { s.half_height; }) {
          return Box<double>{{s.radius, s.radius, s.half_height}};
        } else if constexpr (std::same_as<T, Ellipsoid<double>>) {
          return Box<double>{s.radii};
        } else if constexpr (requires { s.shapes; }) {
          return s.shapes.empty() ? Shape<double>() : few_vertices(s.shapes.front());
        } else if constexpr (requires { s.shape; }) {
          return few_vertices(s.shape);
        } else {
          return s;
        }
      },
      shape);
}

}  // namespace

Case as_few_vertices(Case problem) {
  problem = as_linear(std::move(problem));
  for (Body<double>* body : {&problem.a, &problem.b}) {
    body->shape = few_vertices(body->shape);
    body->orientation = {};
  }
  problem.target_distance = 0;
  return problem;
}

}  // namespace graze::fuzz
