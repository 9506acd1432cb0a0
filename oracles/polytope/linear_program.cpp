// Decides: the TOI of a linear cast of polytopes, and both ends of the signed answer, exactly, in every
// dimension of the CSO, by CGAL's exact simplex:
//   min t   subject to   sum l_i a_i - sum m_j b_j = t v,   sum l = sum m = 1,   l, m >= 0,   0 <= t <= T
// (for the ends: t free, min and max),
// and the squared distance of t v from the CSO, by its exact quadratic solver:
//   min |sum l_i a_i - sum m_j b_j - t v|^2   over the same weights.
// It shares with linear_truth.cpp the posed vertices and nothing else. Brackets: nothing.
// Costs: 0.1 ms at 8 vertices a shape, 0.8 ms at 64, and half as much again with rotated poses.
// Cannot be trusted: for radii and target distances, which it refuses. Bland's rule keeps it from cycling.
#include "oracles/polytope/linear_program.hpp"

#include <CGAL/Gmpz.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <cmath>
#include <stdexcept>

#include "oracles/polytope/exact_body.hpp"

namespace graze::oracle {
namespace {

using Program = CGAL::Quadratic_program<CGAL::Gmpz>;

CGAL::Gmpz to_cgal(const Integer& i) { return CGAL::Gmpz(i.get_mpz_t()); }

// The goal for t: within [0, T] or free, the least or the greatest.
struct Aim {
  bool is_free = false;
  std::optional<Rational> most;  // T
  int sense = 1;                 // 1 minimises t, -1 maximises it
};

// Nothing if the program is infeasible.
std::optional<Rational> extreme_time(const ExactBody& a, const ExactBody& b, const Aim& aim) {
  // Integers throughout: each of the three rows is multiplied by its own common denominator, and the variable
  // of time is t times the denominator of T.
  const Integer time_unit = aim.most ? aim.most->get_den() : Integer(1);
  Program program(CGAL::EQUAL, true, 0, false, 0);
  const int size_a = static_cast<int>(a.vertices.size()), size_b = static_cast<int>(b.vertices.size());
  const int time = size_a + size_b;
  for (std::size_t row = 0; row < 3; ++row) {
    std::vector<Rational> entries;
    for (const RationalPoint& p : a.vertices) entries.push_back(p[row] * time_unit);
    for (const RationalPoint& p : b.vertices) entries.push_back(-p[row] * time_unit);
    entries.push_back(a.displacement[row] - b.displacement[row]);
    Integer unit = 1;
    for (const Rational& e : entries) mpz_lcm(unit.get_mpz_t(), unit.get_mpz_t(), e.get_den_mpz_t());
    for (int column = 0; column <= time; ++column) {
      const Rational entry = entries[column] * unit;
      program.set_a(column, static_cast<int>(row), to_cgal(entry.get_num()));
    }
    program.set_b(static_cast<int>(row), 0);
  }
  for (int i = 0; i < size_a; ++i) program.set_a(i, 3, 1);
  for (int j = 0; j < size_b; ++j) program.set_a(size_a + j, 4, 1);
  program.set_b(3, 1);
  program.set_b(4, 1);
  program.set_c(time, aim.sense);
  if (aim.is_free) program.set_l(time, false);
  if (aim.most) program.set_u(time, true, to_cgal(aim.most->get_num()));

  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);
  const auto solution = CGAL::solve_linear_program(program, CGAL::Gmpz(), options);
  if (solution.is_infeasible()) return {};
  if (!solution.is_optimal()) throw std::logic_error("the linear program is neither infeasible nor optimal");
  const CGAL::Quotient<CGAL::Gmpz> least = solution.objective_value();
  Rational found(Integer(least.numerator().mpz()), Integer(least.denominator().mpz()));
  found.canonicalize();
  return Rational(aim.sense * found / time_unit);
}

struct PolytopePair {
  ExactBody a, b;
  explicit PolytopePair(const corpus::Case& problem) : a(exact_body(problem.a)), b(exact_body(problem.b)) {
    if (sgn(a.radius) != 0 || sgn(b.radius) != 0 || problem.target_distance != 0) {
      throw std::invalid_argument("the linear program is for polytopes without rounding");
    }
    if (!problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0)) {
      throw std::invalid_argument("the linear program is for linear motion");
    }
  }
};

}  // namespace

std::optional<Rational> toi_by_linear_program(const corpus::Case& problem) {
  const PolytopePair pair(problem);
  if (!(problem.t_max >= 0)) throw std::invalid_argument("t_max: it is below 0 or NaN");
  Aim aim;
  if (!std::isinf(problem.t_max)) aim.most = Rational(problem.t_max);
  return extreme_time(pair.a, pair.b, aim);
}

std::optional<std::pair<Rational, Rational>> contact_times_by_linear_program(const corpus::Case& problem) {
  const PolytopePair pair(problem);
  if (pair.a.displacement == pair.b.displacement) {
    throw std::invalid_argument("without motion, contact has no first and no last time");
  }
  const auto in = extreme_time(pair.a, pair.b, {true, {}, 1});
  if (!in) return {};
  return std::pair{*in, extreme_time(pair.a, pair.b, {true, {}, -1}).value()};
}

Rational distance_sq_by_quadratic_program(const corpus::Case& problem, const Rational& t) {
  const ExactBody a = exact_body(problem.a), b = exact_body(problem.b);
  // |M x|^2, the columns of M being A's vertices at time t and B's, negated.
  std::vector<RationalPoint> columns;
  for (const RationalPoint& p : a.vertices) {
    RationalPoint& moved = columns.emplace_back(p);
    for (std::size_t i = 0; i < 3; ++i) moved[i] += t * a.displacement[i];
  }
  for (const RationalPoint& p : b.vertices) {
    RationalPoint& moved = columns.emplace_back(p);
    for (std::size_t i = 0; i < 3; ++i) moved[i] = -(moved[i] + t * b.displacement[i]);
  }
  Integer unit = 1;
  for (const RationalPoint& p : columns) {
    for (const Rational& c : p) mpz_lcm(unit.get_mpz_t(), unit.get_mpz_t(), c.get_den_mpz_t());
  }
  const int size_a = static_cast<int>(a.vertices.size()), size = static_cast<int>(columns.size());
  Program program(CGAL::EQUAL, true, 0, false, 0);
  for (int i = 0; i < size; ++i) {
    program.set_a(i, i < size_a ? 0 : 1, 1);
    for (int j = 0; j <= i; ++j) {  // CGAL's objective is x^T D x, given as 2 D, its lower triangle
      const RationalPoint &p = columns[i], &q = columns[j];
      const Rational product = (p[0] * q[0] + p[1] * q[1] + p[2] * q[2]) * (unit * unit);
      program.set_d(i, j, to_cgal(2 * product.get_num()));
    }
  }
  program.set_b(0, 1);
  program.set_b(1, 1);
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);
  const auto solution = CGAL::solve_quadratic_program(program, CGAL::Gmpz(), options);
  if (!solution.is_optimal()) throw std::logic_error("the quadratic program has no optimum");
  const CGAL::Quotient<CGAL::Gmpz> least = solution.objective_value();
  Rational squared(Integer(least.numerator().mpz()), Integer(least.denominator().mpz()));
  squared.canonicalize();
  return Rational(squared / (unit * unit));
}

}  // namespace graze::oracle
