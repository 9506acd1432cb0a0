// Decides: the CSO's polytope in integers. Brackets: the roots in distances. Costs: nearly all of the
// construction cost of linear_truth.cpp and penetration_truth.cpp. The hull (exact_cso.cpp) is most of it.
// Cannot be trusted: if CGAL's hull is wrong.
#include "oracles/polytope/integer_scene.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace graze::oracle {
namespace {

// From this many differences on, each body is reduced to its extreme points first: two small hulls then cost
// less than the one they save (sums and dense hulls have few extreme points among many).
constexpr std::size_t kManyDifferences = 512;

std::vector<IntVec> scaled_vertices(const Integer& unit, const ExactBody& body) {
  std::vector<IntVec> points;
  points.reserve(body.vertices.size());
  for (const RationalPoint& p : body.vertices) points.push_back(times(unit, p));
  return points;
}

}  // namespace

Integer times(const Integer& unit, const Rational& x) { return unit / x.get_den() * x.get_num(); }

IntVec times(const Integer& unit, const RationalPoint& x) {
  return {times(unit, x[0]), times(unit, x[1]), times(unit, x[2])};
}

void fold_denominators(Integer& unit, const RationalPoint& x) {
  for (const Rational& c : x) mpz_lcm(unit.get_mpz_t(), unit.get_mpz_t(), c.get_den_mpz_t());
}

HomogeneousPoint homogeneous(const RationalPoint& x) {
  Integer w = 1;
  fold_denominators(w, x);
  return {times(w, x), w};
}

RationalPoint rational(const Vec3<double>& x) { return {Rational(x[0]), Rational(x[1]), Rational(x[2])}; }

Integer support(const ConvexHull& hull, const IntVec& n) {
  Integer most = dot(n, hull.vertices[0]);
  for (const IntVec& c : hull.vertices) {
    Integer reach = dot(n, c);
    if (reach > most) most = std::move(reach);
  }
  return most;
}

IntegerScene::IntegerScene(const corpus::Case& problem) : a(exact_body(problem.a)), b(exact_body(problem.b)) {
  if (!(problem.target_distance >= 0) || std::isinf(problem.target_distance)) {
    throw std::invalid_argument("target_distance: it is below 0, infinite or NaN");
  }
  const Rational target(problem.target_distance);
  for (const ExactBody* body : {&a, &b}) {
    for (const RationalPoint& p : body->vertices) fold_denominators(unit, p);
    fold_denominators(unit, body->displacement);
  }
  fold_denominators(unit, {a.radius, b.radius, target});
  v = times(unit, b.displacement) - times(unit, a.displacement);
  shape_radius = times(unit, Rational(a.radius + b.radius));
  radius = shape_radius + times(unit, target);

  std::vector<IntVec> from_a = scaled_vertices(unit, a), from_b = scaled_vertices(unit, b);
  if (from_a.size() > kManyDifferences / from_b.size()) {
    from_a = body_hull('a').hull().vertices;
    from_b = body_hull('b').hull().vertices;
  }
  if (from_a.size() > kMostDifferences / from_b.size()) {
    throw std::invalid_argument(std::to_string(from_a.size()) + " by " + std::to_string(from_b.size()) +
                                " extreme points: this oracle forms all differences, at most " +
                                std::to_string(kMostDifferences));
  }
  std::vector<IntVec> differences;
  differences.reserve(from_a.size() * from_b.size());
  for (const IntVec& p : from_a) {
    for (const IntVec& q : from_b) differences.push_back(p - q);
  }
  cso.emplace(convex_hull(std::move(differences)));
}

HomogeneousPoint IntegerScene::point(const RationalPoint& x) const {
  return homogeneous({x[0] * unit, x[1] * unit, x[2] * unit});
}

const HullDistance& IntegerScene::body_hull(char body) const {
  if (body != 'a' && body != 'b') throw std::invalid_argument("a body is 'a' or 'b'");
  std::optional<HullDistance>& hull = body == 'a' ? body_a_ : body_b_;
  if (!hull) hull.emplace(convex_hull(scaled_vertices(unit, body == 'a' ? a : b)));
  return *hull;
}

Enclosure IntegerScene::distance_from_body(char body, double t, const Vec3<double>& world_point) const {
  const HullDistance& hull = body_hull(body);
  constexpr double kInf = std::numeric_limits<double>::infinity();
  if (!std::isfinite(t) || !world_point.allFinite()) return {kInf, kInf};
  const ExactBody& exact = body == 'a' ? a : b;
  const Rational time(t);
  RationalPoint at = rational(world_point);
  for (std::size_t i = 0; i < 3; ++i) at[i] -= time * exact.displacement[i];
  const Rational squared = length_sq(hull.from_point(point(at)).distance_sq);
  if (sgn(exact.radius) == 0) return enclose_sqrt(squared);
  const Enclosure inside = enclose_radius_and_sqrt(exact.radius, -1, squared);
  return not_below_zero({-inside.high, -inside.low});
}

}  // namespace graze::oracle
