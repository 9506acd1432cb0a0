// Decides exactly: whether the bodies are in contact, the least penetration with all its normals, the
// penetration along a direction, and the errors of proposed ones, as roots of rationals that neighbouring
// doubles enclose. Brackets: nothing else.
//
// Costs, medians in milliseconds of CPU, random hulls, identity poses (rotated by any four doubles):
//   vertices a shape                       8 x 8          16 x 16       64 x 64
//   construction (hull, depth, normals)    0.5 (0.8)      1.3 (1.9)     13 (17)
//   along                                  0.02 (0.05)    0.05 (0.1)    0.2 (0.4)
//   errors of a depth, a normal, a pair    below 0.1      below 0.2     below 1
//   along_error                            a construction and a depth of the path: 0.6 to 30
//
// Cannot be trusted: for curved shapes and hulls of unequal radii, which it refuses. Its hull is CGAL's.
// Tests compare depths with Nef polyhedra and with the quadratic program, which do not use it.
#include "oracles/truth/penetration_truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "oracles/arithmetic/default_environment.hpp"
#include "oracles/arithmetic/root_sum.hpp"
#include "oracles/polytope/integer_scene.hpp"
#include "oracles/truth/first_contact.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "oracles/truth/unbounded.hpp"

namespace graze::oracle {
namespace {

// n over the greatest common divisor of its components: equal for parallel vectors of the same sense.
IntVec primitive(const IntVec& n) {
  const Integer divisor = gcd(gcd(n.x, n.y), n.z);
  return {n.x / divisor, n.y / divisor, n.z / divisor};
}

// n / |n|, component by component to the nearest double.
Vec3<double> unit_vector(const IntVec& n) {
  const Integer norm_sq = dot(n, n);
  const auto component = [&](const Integer& c) {
    return nearest_double(RootSum{0, sgn(c), fraction(c * c, norm_sq), 0, 0});
  };
  return {component(n.x), component(n.y), component(n.z)};
}

corpus::Case without_motion(corpus::Case problem) {
  problem.a.displacement.setZero();
  problem.b.displacement.setZero();
  problem.target_distance = 0;
  return problem;
}

Enclosure larger(const Enclosure& l, const Enclosure& r) {
  return {std::max(l.low, r.low), std::max(l.high, r.high)};
}

}  // namespace

struct PenetrationTruth::Impl : IntegerScene {
  corpus::Case problem;
  bool contact = false;
  RootSum depth;  // in the caller's unit, valid in contact
  std::vector<Vec3<double>> normals;

  explicit Impl(const corpus::Case& given);

  // min over unit n of h(n) - n.x, h of P. For x in P, this is the squared slack of the nearest face. For x
  // outside, it is the squared distance with a negative sign.
  struct Slack {
    int sign = 0;
    Rational squared;  // integer units
    PointDistance nearest;
  };
  [[nodiscard]] Slack slack(const HomogeneousPoint& x) const;
  // r + slack: negative by the distance of x from C, if it is outside of it.
  [[nodiscard]] RootSum depth_at(const Slack& s) const {
    return {length(radius), s.sign, length_sq(s.squared), 0, 0};
  }
  [[nodiscard]] RootSum depth_at(const RationalPoint& x) const { return depth_at(slack(point(x))); }
  void find_normals(const Slack& at_origin);
  // h(n) / |n|
  [[nodiscard]] RootSum reach(const Vec3<double>& n) const;
  [[nodiscard]] const RootSum& depth_in_contact() const {
    if (!contact) throw std::logic_error("penetration: the bodies are apart");
    return depth;
  }
};

PenetrationTruth::Impl::Impl(const corpus::Case& given)
    : IntegerScene(without_motion(given)), problem(without_motion(given)) {
  const Slack at_origin = slack({{0, 0, 0}, 1});
  depth = depth_at(at_origin);
  contact = sign(depth) >= 0;
  if (contact) find_normals(at_origin);
}

PenetrationTruth::Impl::Slack PenetrationTruth::Impl::slack(const HomogeneousPoint& x) const {
  PointDistance nearest = cso->from_point(x);
  if (nearest.feature != Nearest::inside) return {-1, nearest.distance_sq, nearest};
  bool found = false;
  Integer best, best_normal_sq;
  for (const HalfSpace& h : cso->hull().half_spaces) {
    const Integer below = x.w * h.offset - dot(h.normal, x.x), normal_sq = dot(h.normal, h.normal);
    if (found && below * below * best_normal_sq >= best * best * normal_sq) continue;
    best = below;
    best_normal_sq = normal_sq;
    found = true;
  }
  return {sgn(best), fraction(best * best, best_normal_sq * x.w * x.w), nearest};
}

// For an origin outside P, the direction from its nearest point of P. For an origin in P, n attains the least
// h only if the plane {h(n) = n.c} touches the ball of that radius about the origin, in a point of P. So n is
// a face's normal, or the least is 0 and n is any of the normal cone at the origin. The normals of the
// half-spaces that the origin bounds span this cone. It is a ray or, for a flat P, a line, if they are
// parallel.
void PenetrationTruth::Impl::find_normals(const Slack& at_origin) {
  const ConvexHull& hull = cso->hull();
  std::vector<IntVec> found;
  switch (at_origin.nearest.feature) {
    case Nearest::facet:
      found = {hull.half_spaces[hull.facets[at_origin.nearest.index].half_space].normal};
      break;
    case Nearest::edge: {
      const HullEdge& e = hull.edges[at_origin.nearest.index];
      const IntVec& from = hull.vertices[e.from];
      found = {dot(from, e.direction) * e.direction - dot(e.direction, e.direction) * from};
      break;
    }
    case Nearest::vertex:
      found = {-hull.vertices[at_origin.nearest.index]};
      break;
    case Nearest::inside: {
      if (hull.dimension < 2) return;
      for (const HalfSpace& h : hull.half_spaces) {
        if (fraction(h.offset * h.offset, dot(h.normal, h.normal)) == at_origin.squared) {
          found.push_back(primitive(h.normal));
        }
      }
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
      const std::size_t sides = hull.dimension == 2 ? 2 : 1;
      if (at_origin.sign == 0 && found.size() > sides) return;
      break;
    }
  }
  for (const IntVec& n : found) normals.push_back(unit_vector(n));
}

RootSum PenetrationTruth::Impl::reach(const Vec3<double>& n) const {
  const IntVec direction = homogeneous(rational(n)).x;
  const Integer most = support(cso->hull(), direction);
  return {length(radius), sgn(most), length_sq(fraction(most * most, dot(direction, direction))), 0, 0};
}

PenetrationTruth::PenetrationTruth(const corpus::Case& problem) {
  const DefaultEnvironment environment;
  impl_ = std::make_unique<Impl>(problem);
}
PenetrationTruth::~PenetrationTruth() = default;
PenetrationTruth::PenetrationTruth(PenetrationTruth&&) noexcept = default;
PenetrationTruth& PenetrationTruth::operator=(PenetrationTruth&&) noexcept = default;

bool PenetrationTruth::in_contact() const { return impl_->contact; }
int PenetrationTruth::dimension() const { return impl_->cso->hull().dimension; }
bool PenetrationTruth::is_polytope() const { return sgn(impl_->radius) == 0; }

Enclosure PenetrationTruth::depth() const {
  const DefaultEnvironment environment;
  return enclose(impl_->depth_in_contact());
}
double PenetrationTruth::nearest_depth() const {
  const DefaultEnvironment environment;
  return oracle::nearest_double(impl_->depth_in_contact());
}

// (r + s sqrt q)^2 = r^2 + q + 2 s r sqrt q
std::string PenetrationTruth::depth_sq_exact() const {
  const DefaultEnvironment environment;
  const RootSum& d = impl_->depth_in_contact();
  const Rational mixed_sq = 4 * d.part * d.part * d.root;
  if (mpz_perfect_square_p(mixed_sq.get_num_mpz_t()) == 0 ||
      mpz_perfect_square_p(mixed_sq.get_den_mpz_t()) == 0) {
    return "";
  }
  const Rational mixed = fraction(sqrt(mixed_sq.get_num()), sqrt(mixed_sq.get_den()));
  const Rational squared = d.part * d.part + d.root + d.root_sign * mixed;
  return squared.get_str();
}

const std::vector<Vec3<double>>& PenetrationTruth::normals() const {
  const DefaultEnvironment environment;
  (void)impl_->depth_in_contact();
  return impl_->normals;
}

Enclosure PenetrationTruth::depth_error(double proposed) const {
  const DefaultEnvironment environment;
  RootSum excess = impl_->depth_in_contact();
  if (!std::isfinite(proposed)) return kUnbounded;
  excess.part -= Rational(proposed);
  return enclose_magnitude(excess);
}

Enclosure PenetrationTruth::normal_error(const Vec3<double>& n) const {
  const DefaultEnvironment environment;
  const RootSum& least = impl_->depth_in_contact();
  if (!n.allFinite() || n.isZero(0)) return kUnbounded;
  RootSum excess = impl_->reach(n);
  excess.part -= least.part;
  excess.other_sign = -least.root_sign;
  excess.other = least.root;
  return enclose(excess);
}

Enclosure PenetrationTruth::reach(const Vec3<double>& n) const {
  const DefaultEnvironment environment;
  if (!n.allFinite() || n.isZero(0)) return kUnbounded;
  return enclose(impl_->reach(n));
}

Enclosure PenetrationTruth::distance_from_body(char body, const Vec3<double>& world_point) const {
  const DefaultEnvironment environment;
  return impl_->distance_from_body(body, 0, world_point);
}

Enclosure PenetrationTruth::depth_after(const Vec3<double>& x) const {
  const DefaultEnvironment environment;
  if (!x.allFinite()) return kUnbounded;
  return not_below_zero(enclose(impl_->depth_at(rational(x))));
}

Enclosure PenetrationTruth::distance_after(const Vec3<double>& x) const {
  const DefaultEnvironment environment;
  if (!x.allFinite()) return kUnbounded;
  return not_below_zero(enclose(-impl_->depth_at(rational(x))));
}

Enclosure PenetrationTruth::pair_error(const Vec3<double>& point_a, const Vec3<double>& point_b) const {
  const DefaultEnvironment environment;
  const RootSum& least = impl_->depth_in_contact();
  if (!point_a.allFinite() || !point_b.allFinite()) return kUnbounded;
  const RationalPoint a = rational(point_a), b = rational(point_b);
  const RationalPoint x = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  const Rational length_sq = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  const RootSum too_long = {Rational(-least.part), 1, length_sq, -least.root_sign, least.root};
  return larger(enclose_magnitude(too_long), enclose_magnitude(impl_->depth_at(x)));
}

std::optional<DepthAlong> PenetrationTruth::along(const Vec3<double>& d) const {
  const DefaultEnvironment environment;
  if (!d.allFinite() || d.isZero(0)) throw std::invalid_argument("direction: it is zero or not finite");
  // In integer units the line is {t D}, D = w unit d, w the weight, and s = w t.
  const HomogeneousPoint end = impl_->point(rational(d));
  const auto times = contact_times(*impl_->cso, impl_->radius, end.x);
  if (!times || sgn(times->out.high) < 0) return {};
  const Root root = {times->out.low * end.w, times->out.high * end.w, times->out.exact};
  // Beyond the exit, and only there, the distance from P exceeds r.
  const Rational radius_sq(impl_->radius * impl_->radius), weight(end.w);
  const CompareTime compare = [&](const Rational& s) {
    const Approach line{1, {0, 0, 0}, end.x};
    return cmp(impl_->cso->from_point(line.at(s / weight)).distance_sq, radius_sq);
  };
  DepthAlong result;
  result.factor = oracle::nearest_double(root, compare);
  result.factor_bounds = enclose(root, compare);
  if (root.exact) result.factor_exact = root.low.get_str();
  const RationalPoint given = rational(d);
  const Rational square = given[0] * given[0] + given[1] * given[1] + given[2] * given[2];
  result.length = oracle::nearest_double(RootSum{0, 1, root.low * root.low * square, 0, 0});
  return result;
}

Enclosure PenetrationTruth::along_error(const Vec3<double>& d, double s) const {
  const DefaultEnvironment environment;
  if (!d.allFinite() || d.isZero(0)) throw std::invalid_argument("direction: it is zero or not finite");
  if (!std::isfinite(s) || s < 0) return kUnbounded;
  corpus::Case line = impl_->problem;
  line.b.displacement = d;
  return LinearTruth(line).exit_error(s);
}

}  // namespace graze::oracle
