// Decides exactly: outcome, TOI and every comparison of a time with it, for linear motion of points, spheres,
// boxes and hulls, with target distance, any T.
// Brackets only: lengths that are roots of rationals, by neighbouring doubles; an irrational TOI, to 2^-230
// of it.
// Costs, medians in milliseconds, random hulls, identity poses (rotated by any four doubles):
//   vertices a shape              8 x 8         16 x 16      64 x 64     16 and a sphere
//   construction (hull and TOI)   0.4 (0.6)     0.8 (1.1)    15 (19)     0.2 (0.3)
//   depth                         0.06 (0.13)   0.1 (0.2)    2.7 (3.5)   0.03 (0.04)
//   distance_at, witness          0.01 to 0.1 everywhere; compare under 0.001, in the last bits of a root as
//                                 distance_at
// Cannot be trusted: for curved shapes other than spheres, which it refuses. Its hull is CGAL's
// (exact_cso.cpp); linear_program.cpp and nef_minkowski.cpp, which do not use it, are its checks.
//
// Notation   P = hull of the differences a - b, R = r_A + r_B + m, so C = P + ball(R);   f(t) = dist(t v, P).
//   All lengths are integers here: the case's times one common denominator `unit`.
// f is convex. Let s be the first t in R at which it is least (rational: a line and a polytope). Then f falls
// strictly on (-inf, s], so before s  "f(t) > R"  is  "t < TOI", and nothing else is ever asked of a root.
#include "oracles/linear_truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "oracles/exact_body.hpp"
#include "oracles/exact_distance.hpp"

namespace graze::oracle {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr Enclosure kUnbounded = {kInf, kInf};
// An irrational TOI is enclosed to this many bits before doubles are read off.
constexpr unsigned kRootBits = 256;

using OptionalTime = std::optional<Rational>;  // nothing: infinity

void fold_denominators(Integer& unit, const RationalPoint& p) {
  for (const Rational& c : p) mpz_lcm(unit.get_mpz_t(), unit.get_mpz_t(), c.get_den_mpz_t());
}

Integer times(const Integer& unit, const Rational& q) { return unit / q.get_den() * q.get_num(); }

IntVec times(const Integer& unit, const RationalPoint& p) {
  return {times(unit, p[0]), times(unit, p[1]), times(unit, p[2])};
}

HomogeneousPoint along(const IntVec& v, const Rational& t) { return {t.get_num() * v, t.get_den()}; }

bool finite(const Vec3<double>& x) {
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

// a t^2 - 2 b t + c = 0, its smaller root c / (b + sqrt(b^2 - a c)) for b, c > 0.
struct Quadratic {
  Integer a, b, c;
};

// A rational interval around a root, or the root itself.
struct Root {
  Rational low, high;
  bool exact = false;
};

std::optional<Root> smaller_root(const Quadratic& q) {
  const Integer discriminant = q.b * q.b - q.a * q.c;
  if (sgn(q.b) <= 0 || sgn(q.c) <= 0 || sgn(discriminant) < 0) return {};
  if (mpz_perfect_square_p(discriminant.get_mpz_t()) != 0) {
    const Rational root = fraction(q.c, q.b + sqrt(discriminant));
    return Root{root, root, true};
  }
  // sqrt(4^k discriminant) to one unit, with kRootBits and more to spare; then k cancels. The quotient is cut
  // to kRootBits, and two units on each side cover both roundings.
  const unsigned k = 2 * kRootBits;
  const Integer root = sqrt(Integer(discriminant << (2 * k)));
  Integer numerator = q.c << k, denominator = (q.b << k) + root;
  const long shift = static_cast<long>(kRootBits) +
                     static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2)) -
                     static_cast<long>(mpz_sizeinbase(numerator.get_mpz_t(), 2));
  Integer scale = 1;
  scale <<= static_cast<unsigned long>(std::abs(shift));
  (shift >= 0 ? numerator : denominator) *= scale;
  const Integer quotient = numerator / denominator;
  const auto unscaled = [&](const Integer& i) {
    return shift >= 0 ? fraction(i, scale) : Rational(i * scale);
  };
  return Root{unscaled(quotient - 2), unscaled(quotient + 2), false};
}

struct Box3 {
  RationalPoint low, high;
};

Box3 bounds(const ExactBody& body) {
  Box3 box{body.vertices[0], body.vertices[0]};
  for (const RationalPoint& p : body.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (p[i] < box.low[i]) box.low[i] = p[i];
      if (p[i] > box.high[i]) box.high[i] = p[i];
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] -= body.radius;
    box.high[i] += body.radius;
  }
  return box;
}

Rational squared_length(const RationalPoint& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; }

RationalPoint minus(const RationalPoint& l, const RationalPoint& r) {
  return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}

// One side of the swept P, over [0, t]: its support is offset + t rise along the normal.
struct SweepSide {
  Integer offset, rise, normal_sq;
};

}  // namespace

struct LinearTruth::Impl {
  ExactBody a, b;
  Integer unit = 1;
  IntVec v;
  Integer radius, shape_radius;  // R; R - m
  OptionalTime horizon;
  std::optional<HullDistance> cso;
  std::optional<LineDistance> line;  // for v != 0

  Outcome outcome = Outcome::miss;
  Root toi;  // of a hit or a start in contact
  double lower = kInf, upper = kInf;
  mutable std::vector<SweepSide> sides;
  mutable std::optional<HullDistance> body_a, body_b;

  explicit Impl(const corpus::Case& problem);
  void decide();
  void find_root(Rational end);
  void round_root();
  [[nodiscard]] bool leaves_or_slides() const;

  [[nodiscard]] Rational radius_sq() const { return Rational(radius * radius); }
  [[nodiscard]] PointDistance at(const Rational& t) const { return cso->from_point(along(v, t)); }
  // sign(f(t) - R)
  [[nodiscard]] int excess(const Rational& t) const { return cmp(at(t).distance_sq, radius_sq()); }
  [[nodiscard]] Quadratic quadratic(const PointDistance& nearest) const;
  [[nodiscard]] int compare(const Rational& t) const;

  // Lengths, back in the caller's unit.
  [[nodiscard]] Rational length(const Integer& x) const { return fraction(x, unit); }
  [[nodiscard]] Enclosure root_of(const Rational& squared) const {
    return enclose_sqrt(squared / (unit * unit));
  }
  // max(0, sqrt(squared) - r), and max(0, r - sqrt(squared))
  [[nodiscard]] Enclosure beyond(const Rational& squared, const Integer& r) const;
  [[nodiscard]] Enclosure short_of(const Rational& squared, const Integer& r) const;

  [[nodiscard]] Rational path_distance_sq(const OptionalTime& end) const;
  [[nodiscard]] bool sweeps_flat() const;
  void prepare_sides() const;
  [[nodiscard]] Enclosure sweep_depth(const OptionalTime& end) const;
  [[nodiscard]] const HullDistance& body_hull(char body) const;
};

LinearTruth::Impl::Impl(const corpus::Case& problem) : a(exact_body(problem.a)), b(exact_body(problem.b)) {
  if (!problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0)) {
    throw std::invalid_argument("a rotating case: this oracle decides linear motion");
  }
  if (!(problem.t_max >= 0)) throw std::invalid_argument("t_max: it is below 0 or NaN");
  if (!(problem.target_distance >= 0) || std::isinf(problem.target_distance)) {
    throw std::invalid_argument("target_distance: it is below 0, infinite or NaN");
  }
  if (!std::isinf(problem.t_max)) horizon = Rational(problem.t_max);
  const Rational target(problem.target_distance);
  const Rational shapes = a.radius + b.radius, total = shapes + target;
  const RationalPoint velocity = minus(b.displacement, a.displacement);
  for (const ExactBody* body : {&a, &b}) {
    for (const RationalPoint& p : body->vertices) fold_denominators(unit, p);
    fold_denominators(unit, body->displacement);
  }
  fold_denominators(unit, {a.radius, b.radius, target});
  v = times(unit, velocity);
  radius = times(unit, total);
  shape_radius = times(unit, shapes);
  std::vector<IntVec> from_a, from_b, differences;
  for (const RationalPoint& p : a.vertices) from_a.push_back(times(unit, p));
  for (const RationalPoint& p : b.vertices) from_b.push_back(times(unit, p));
  for (const IntVec& p : from_a) {
    for (const IntVec& q : from_b) differences.push_back(p - q);
  }
  cso.emplace(convex_hull(std::move(differences)));
  decide();
  const bool contact = outcome == Outcome::initially_overlapping;
  if (contact && problem.start_policy == corpus::StartPolicy::pass_over && leaves_or_slides()) {
    outcome = Outcome::miss;
  }
  if (outcome != Outcome::miss) round_root();
}

void LinearTruth::Impl::decide() {
  if (!v.is_zero()) line = cso->from_line(v);
  if (excess(0) <= 0) {
    outcome = Outcome::initially_overlapping;
    toi = {0, 0, true};
    return;
  }
  if (!line || sgn(line->first) <= 0) return;  // f never falls
  const bool reaches = !horizon || *horizon >= line->first;
  if (reaches ? line->distance_sq > radius_sq() : excess(*horizon) > 0) return;
  outcome = Outcome::hit;
  if (sgn(radius) == 0) {
    toi = {line->first, line->first, true};
  } else {
    find_root(reaches ? line->first : *horizon);
  }
}

// f of the nearest feature's affine hull: a square of the form (a t^2 - 2 b t + c + R^2 k) / k, k > 0.
Quadratic LinearTruth::Impl::quadratic(const PointDistance& nearest) const {
  const ConvexHull& hull = cso->hull();
  const Integer rr = radius * radius;
  switch (nearest.feature) {
    case Nearest::vertex: {
      const IntVec& c = hull.vertices[nearest.index];
      return {dot(v, v), dot(v, c), dot(c, c) - rr};
    }
    case Nearest::edge: {
      const HullEdge& e = hull.edges[nearest.index];
      const IntVec vs = cross(v, e.direction), cs = cross(hull.vertices[e.from], e.direction);
      return {dot(vs, vs), dot(vs, cs), dot(cs, cs) - rr * dot(e.direction, e.direction)};
    }
    case Nearest::facet: {
      const HalfSpace& h = hull.half_spaces[hull.facets[nearest.index].half_space];
      const Integer rate = dot(h.normal, v);
      return {rate * rate, rate * h.offset, h.offset * h.offset - rr * dot(h.normal, h.normal)};
    }
    case Nearest::inside:
      break;
  }
  return {0, 0, 0};
}

// f(0) > R >= f(end), f falls strictly on [0, end]. The nearest feature at a probe proposes a root of its
// quadratic; the signs of f - R decide; bisection takes over every second step, so the loop always narrows.
void LinearTruth::Impl::find_root(Rational end) {
  Rational low = 0, high = std::move(end), probe = 0;
  const auto narrow = [&](const Rational& t) {  // true if t is the root
    if (t <= low || t >= high) return false;
    const int sign = excess(t);
    if (sign == 0) toi = {t, t, true};
    (sign > 0 ? low : high) = t;
    return sign == 0;
  };
  if (excess(high) == 0) {
    toi = {high, high, true};
    return;
  }
  constexpr int kBudget = 4000;  // beyond every exponent of a double; typically 1 to 4 rounds are used
  Integer precision = 1;
  precision <<= kRootBits - 16;
  for (int round = 0; round < kBudget && (high - low) * precision > high; ++round) {
    if (const auto root = smaller_root(quadratic(at(probe)))) {
      if (narrow(root->low) || (!root->exact && narrow(root->high))) return;
      probe = low;
    }
    if (round % 2 == 1) {
      probe = (low + high) / 2;
      if (narrow(probe)) return;
    }
  }
  toi = {low, high, false};
}

void LinearTruth::Impl::round_root() {
  lower = floor_double(toi.low);
  upper = toi.exact ? ceil_double(toi.low) : std::nextafter(lower, kInf);
  // The enclosure is far narrower than the spacing of doubles, so at most one of them lies inside it.
  if (!toi.exact && !std::isinf(upper)) {
    const int order = compare(Rational(upper));
    if (order <= 0) lower = upper;
    if (order < 0) upper = std::nextafter(upper, kInf);
  }
}

int LinearTruth::Impl::compare(const Rational& t) const {
  if (outcome == Outcome::miss) return -1;
  if (toi.exact) return cmp(t, toi.low) < 0 ? -1 : (t == toi.low ? 0 : 1);
  if (t <= toi.low) return -1;
  if (t >= toi.high) return 1;
  return -excess(t);
}

// Leaving or sliding: n.v >= 0 for some n != 0 with h(n) <= 0, h of C without the target. Such an n exists
// exactly when the origin is not interior to the hull of C and -v: for a ball around P, when the ray from 0
// along v never comes nearer to P than its radius; for a polytope, by that hull.
bool LinearTruth::Impl::leaves_or_slides() const {
  if (sgn(shape_radius) > 0) return path_distance_sq({}) >= Rational(shape_radius * shape_radius);
  std::vector<IntVec> points = cso->hull().vertices;
  points.push_back(-v);
  const ConvexHull hull = convex_hull(std::move(points));
  return hull.dimension < 3 || std::any_of(hull.half_spaces.begin(), hull.half_spaces.end(),
                                           [](const HalfSpace& h) { return sgn(h.offset) <= 0; });
}

Enclosure LinearTruth::Impl::beyond(const Rational& squared, const Integer& r) const {
  if (sgn(r) == 0) return root_of(squared);
  const Enclosure negative = enclose_radius_and_sqrt(length(r), -1, squared / (unit * unit));
  return not_below_zero({-negative.high, -negative.low});
}

Enclosure LinearTruth::Impl::short_of(const Rational& squared, const Integer& r) const {
  return not_below_zero(enclose_radius_and_sqrt(length(r), -1, squared / (unit * unit)));
}

// The least of f^2 over [0, end].
Rational LinearTruth::Impl::path_distance_sq(const OptionalTime& end) const {
  if (!line || sgn(line->first) <= 0) return at(0).distance_sq;
  if (!end || *end >= line->first) return line->distance_sq;
  return at(*end).distance_sq;
}

// P swept by v has no interior: it is no solid, and v does not leave the plane of a polygon.
bool LinearTruth::Impl::sweeps_flat() const {
  const ConvexHull& hull = cso->hull();
  return hull.dimension < 2 || (hull.dimension == 2 && sgn(dot(hull.half_spaces[0].normal, v)) == 0);
}

// Every facet of a solid P + {-s v : 0 <= s <= t} has the normal of a facet of P or is parallel to v and an
// edge of P that separates facets seen from v from facets not seen. More normals than that do no harm: depth
// is a least value over all directions.
void LinearTruth::Impl::prepare_sides() const {
  if (!sides.empty()) return;
  const ConvexHull& hull = cso->hull();
  const auto add = [&](const IntVec& n, Integer offset) {
    const Integer rate = dot(n, v);
    sides.push_back({std::move(offset), sgn(rate) < 0 ? Integer(-rate) : Integer(0), dot(n, n)});
  };
  for (const HalfSpace& h : hull.half_spaces) add(h.normal, h.offset);
  for (const HullEdge& e : hull.edges) {
    if (hull.dimension == 3) {
      const auto seen = [&](int f) {
        return sgn(dot(hull.half_spaces[hull.facets[f].half_space].normal, v));
      };
      if (seen(e.facets[0]) * seen(e.facets[1]) > 0) continue;
    }
    const IntVec n = cross(e.direction, v);
    if (n.is_zero()) continue;
    Integer most = dot(n, hull.vertices[0]), least = most;
    for (const IntVec& c : hull.vertices) {
      const Integer reach = dot(n, c);
      if (reach > most) most = reach;
      if (reach < least) least = reach;
    }
    add(n, most);
    add(-n, -least);
  }
}

Enclosure LinearTruth::Impl::sweep_depth(const OptionalTime& end) const {
  if (sweeps_flat()) return short_of(path_distance_sq(end), radius);
  prepare_sides();
  bool inside = true, found = false;
  Integer best, best_normal_sq;  // depth^2 = best^2 / best_normal_sq
  const Integer weight = end ? end->get_den() : Integer(1);
  for (const SweepSide& side : sides) {
    if (!end && sgn(side.rise) > 0) continue;
    const Integer support = end ? Integer(weight * side.offset + end->get_num() * side.rise) : side.offset;
    if (sgn(support) < 0) {
      inside = false;
      break;
    }
    if (!found || support * support * best_normal_sq < best * best * side.normal_sq) {
      best = support;
      best_normal_sq = side.normal_sq;
      found = true;
    }
  }
  if (!inside) return sgn(radius) == 0 ? Enclosure{} : short_of(path_distance_sq(end), radius);
  const Rational squared = fraction(best * best, best_normal_sq * weight * weight);
  return enclose_radius_and_sqrt(length(radius), 1, squared / (unit * unit));
}

const HullDistance& LinearTruth::Impl::body_hull(char body) const {
  if (body != 'a' && body != 'b') throw std::invalid_argument("a body is 'a' or 'b'");
  std::optional<HullDistance>& hull = body == 'a' ? body_a : body_b;
  if (!hull) {
    std::vector<IntVec> points;
    for (const RationalPoint& p : (body == 'a' ? a : b).vertices) points.push_back(times(unit, p));
    hull.emplace(convex_hull(std::move(points)));
  }
  return *hull;
}

LinearTruth::LinearTruth(const corpus::Case& problem) : impl_(std::make_unique<Impl>(problem)) {}
LinearTruth::~LinearTruth() = default;
LinearTruth::LinearTruth(LinearTruth&&) noexcept = default;
LinearTruth& LinearTruth::operator=(LinearTruth&&) noexcept = default;

Outcome LinearTruth::outcome() const { return impl_->outcome; }
double LinearTruth::toi_lower() const { return impl_->lower; }
double LinearTruth::toi_upper() const { return impl_->upper; }
int LinearTruth::dimension() const { return impl_->cso->hull().dimension; }
bool LinearTruth::is_polytope() const { return sgn(impl_->radius) == 0; }

std::string LinearTruth::toi_exact() const {
  return impl_->outcome != Outcome::miss && impl_->toi.exact ? impl_->toi.low.get_str() : std::string();
}

int LinearTruth::compare(double t) const {
  if (std::isnan(t)) throw std::invalid_argument("compare: NaN is not a time");
  if (std::isinf(t)) return t < 0 || impl_->outcome == Outcome::miss ? -1 : 1;
  return impl_->compare(Rational(t));
}

Enclosure LinearTruth::scale() const {
  const Box3 box_a = bounds(impl_->a), box_b = bounds(impl_->b);
  Rational largest =
      std::max(squared_length(minus(box_a.high, box_a.low)), squared_length(minus(box_b.high, box_b.low)));
  RationalPoint between;
  for (std::size_t i = 0; i < 3; ++i) {
    between[i] = (box_a.low[i] + box_a.high[i] - box_b.low[i] - box_b.high[i]) / 2;
  }
  return enclose_sqrt(std::max(largest, squared_length(between)));
}

Enclosure LinearTruth::clearance() const {
  if (impl_->outcome != Outcome::miss) return {};
  return impl_->beyond(impl_->path_distance_sq(impl_->horizon), impl_->radius);
}

Enclosure LinearTruth::depth() const {
  return impl_->outcome == Outcome::miss ? Enclosure{} : impl_->sweep_depth(impl_->horizon);
}

Enclosure LinearTruth::distance_at(double t) const {
  if (!std::isfinite(t)) return kUnbounded;
  return impl_->beyond(impl_->at(Rational(t)).distance_sq, impl_->radius);
}

Enclosure LinearTruth::depth_before(double t) const {
  if (std::isnan(t)) return kUnbounded;
  if (t <= 0) return {};
  return impl_->sweep_depth(std::isinf(t) ? OptionalTime() : OptionalTime(Rational(t)));
}

Enclosure LinearTruth::backward_error(double t) const {
  if (!std::isfinite(t) || t < 0) return kUnbounded;
  const Enclosure distance = distance_at(t);
  // Outside C, a path that has not reached the TOI has made no contact: nothing lies behind it.
  if (distance.low > 0 && impl_->outcome != Outcome::miss && impl_->compare(Rational(t)) < 0) return distance;
  const Enclosure depth = depth_before(t);
  return {std::max(distance.low, depth.low), std::max(distance.high, depth.high)};
}

Enclosure LinearTruth::forward_error(double t) const {
  if (impl_->outcome == Outcome::miss || !std::isfinite(t)) return kUnbounded;
  const Rational time(t), speed_sq = Rational(dot(impl_->v, impl_->v)) / (impl_->unit * impl_->unit);
  const Rational d_low = time - impl_->toi.low, d_high = time - impl_->toi.high;
  const Enclosure one = enclose_sqrt(d_low * d_low * speed_sq);
  if (impl_->toi.exact) return one;
  const Enclosure other = enclose_sqrt(d_high * d_high * speed_sq);
  const bool straddles = sgn(d_low) != sgn(d_high);
  return {straddles ? 0.0 : std::min(one.low, other.low), std::max(one.high, other.high)};
}

Enclosure LinearTruth::lateness(double t) const {
  if (std::isnan(t)) return kUnbounded;
  if (impl_->outcome == Outcome::miss || compare(t) <= 0) return {};
  // A claimed miss, or a time beyond T, is late by the whole path that the case has.
  const bool beyond_horizon = std::isinf(t) || (impl_->horizon && Rational(t) > *impl_->horizon);
  return beyond_horizon ? impl_->sweep_depth(impl_->horizon) : depth_before(t);
}

Enclosure LinearTruth::normal_error(const Vec3<double>& n) const {
  if (impl_->outcome == Outcome::miss || !finite(n) || n.isZero(0)) return kUnbounded;
  const RationalPoint exact = {Rational(n[0]), Rational(n[1]), Rational(n[2])};
  Integer denominator = 1;
  fold_denominators(denominator, exact);
  const IntVec direction = times(denominator, exact);
  const ConvexHull& hull = impl_->cso->hull();
  Integer support = dot(direction, hull.vertices[0]);
  for (const IntVec& c : hull.vertices) {
    const Integer reach = dot(direction, c);
    if (reach > support) support = reach;
  }
  const Integer rate = dot(direction, impl_->v);
  const Rational scale_sq = Rational(dot(direction, direction)) * (impl_->unit * impl_->unit);
  const auto error = [&](const Rational& t) {  // (support - t rate) / |direction| + R
    const Rational gap = support - t * rate;
    return enclose_radius_and_sqrt(impl_->length(impl_->radius), sgn(gap) < 0 ? -1 : 1, gap * gap / scale_sq);
  };
  const Enclosure one = error(impl_->toi.low);
  if (impl_->toi.exact) return one;
  const Enclosure other = error(impl_->toi.high);
  return not_below_zero({std::min(one.low, other.low), std::max(one.high, other.high)});
}

Enclosure LinearTruth::distance_from_body(char body, double t, const Vec3<double>& world_point) const {
  const HullDistance& hull = impl_->body_hull(body);
  if (!std::isfinite(t) || !finite(world_point)) return kUnbounded;
  const ExactBody& exact = body == 'a' ? impl_->a : impl_->b;
  const Rational time(t);
  RationalPoint relative;
  Integer w = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    relative[i] = (Rational(world_point[static_cast<int>(i)]) - time * exact.displacement[i]) * impl_->unit;
  }
  fold_denominators(w, relative);
  return impl_->beyond(hull.from_point({times(w, relative), w}).distance_sq,
                       times(impl_->unit, exact.radius));
}

Enclosure LinearTruth::distance() const {
  return impl_->beyond(impl_->at(0).distance_sq, impl_->shape_radius);
}

double LinearTruth::nearest_distance() const {
  const Rational squared = impl_->at(0).distance_sq / (impl_->unit * impl_->unit);
  return std::max(0.0, nearest_sqrt_minus(squared, impl_->length(impl_->shape_radius)));
}

std::optional<ContactInterval> LinearTruth::contact_interval() const {
  if (!is_polytope()) throw std::logic_error("contact_interval: for polytopes without rounding");
  if (impl_->v.is_zero()) {
    if (impl_->excess(0) > 0) return {};
    return ContactInterval{-kInf, kInf};
  }
  const auto interval = impl_->cso->clip_line({{0, 0, 0}, 1}, impl_->v);
  if (!interval) return {};
  return ContactInterval{nearest_double(interval->in), nearest_double(interval->out)};
}

}  // namespace graze::oracle
