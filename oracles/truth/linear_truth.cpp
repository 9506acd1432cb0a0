// Decides exactly: outcome, TOI and every comparison of a time with it, both ends of the signed answer,
// leaving or sliding. It covers linear motion of every shape that exact_body.hpp represents, with target
// distance, any T.
//
// Brackets only: lengths that are roots of rationals, by neighbouring doubles, and an irrational TOI, to
// 2^-230 of it.
//
// Costs, medians in milliseconds of CPU, random hulls, identity poses (rotated by any four doubles):
//   vertices a shape              8 x 8         16 x 16      64 x 64     16 and a sphere
//   construction (hull and TOI)   0.4 (0.6)     0.8 (1.1)    15 (19)     0.2 (0.3)
//   depth                         0.06 (0.13)   0.1 (0.2)    2.7 (3.5)   0.03 (0.04)
//   distance_at, witness          0.01 to 0.1 everywhere. compare under 0.001, in the last bits of a root as
//                                 distance_at
//   contact_interval, both rounded by a radius: 1.0 (1.4), 1.8 (2.8), 9 (15). Without radii under 0.5
//   construction, a sum of 64, 512, 4,096 vertices against a ball: 1, 12, 90. 512 x 512 points of a sphere:
//   1,200
//
// Cannot be trusted: for curved shapes and hulls of unequal radii, which it refuses. Its hull is CGAL's
// (exact_cso.cpp). linear_program.cpp and nef_minkowski.cpp do not use that hull and serve as checks.
//
// Notation   P = hull of the differences a - b, R = r_A + r_B + m, so C = P + ball(R),   f(t) = dist(t v, P).
//   All lengths are integers here: the case's times one common denominator `unit`.
#include "oracles/truth/linear_truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "oracles/arithmetic/default_environment.hpp"
#include "oracles/polytope/integer_scene.hpp"
#include "oracles/truth/first_contact.hpp"
#include "oracles/truth/unbounded.hpp"

namespace graze::oracle {
namespace {

using OptionalTime = std::optional<Rational>;  // nothing: infinity

HomogeneousPoint along(const IntVec& v, const Rational& t) { return {t.get_num() * v, t.get_den()}; }

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

// The times of a path that are queried. Nothing stands for minus and plus infinity.
struct Span {
  OptionalTime from, to;
};

// One side of the swept P: over times t its support is offset - t rate along the normal.
struct SweepSide {
  Integer offset, rate, normal_sq;
};

}  // namespace

struct LinearTruth::Impl : IntegerScene {
  OptionalTime horizon;
  std::optional<LineDistance> line;  // for v != 0

  bool passes_over = false;     // the policy
  bool is_passed_over = false;  // a start that leaves or slides, under that policy
  Outcome outcome = Outcome::miss;
  Root toi;  // of a hit or a start in contact
  double lower = kInf, upper = kInf;
  mutable std::vector<SweepSide> sides;

  explicit Impl(const corpus::Case& problem);
  void decide();
  [[nodiscard]] bool leaves_or_slides() const;

  [[nodiscard]] Rational radius_sq() const { return Rational(radius * radius); }
  [[nodiscard]] PointDistance at(const Rational& t) const { return cso->from_point(along(v, t)); }
  // sign(f(t) - R)
  [[nodiscard]] int excess(const Rational& t) const { return cmp(at(t).distance_sq, radius_sq()); }
  [[nodiscard]] int compare(const Rational& t) const;

  [[nodiscard]] Enclosure root_of(const Rational& squared) const { return enclose_sqrt(length_sq(squared)); }
  // max(0, sqrt(squared) - r), and max(0, r - sqrt(squared))
  [[nodiscard]] Enclosure beyond(const Rational& squared, const Integer& r) const;
  [[nodiscard]] Enclosure short_of(const Rational& squared, const Integer& r) const;

  [[nodiscard]] Span path(OptionalTime end) const { return {Rational(0), std::move(end)}; }
  [[nodiscard]] Rational path_distance_sq(const Span& span) const;
  [[nodiscard]] bool sweeps_flat() const;
  void prepare_sides() const;
  // The depth in P + ball(r) of the path over the span.
  [[nodiscard]] Enclosure sweep_depth(const Span& span, const Integer& r) const;
  // The larger of the distance of t v from C and the depth of the path over the span.
  [[nodiscard]] Enclosure end_error(double t, const Span& span) const;
};

LinearTruth::Impl::Impl(const corpus::Case& problem) : IntegerScene(problem) {
  if (!problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0)) {
    throw std::invalid_argument("a rotating case: this oracle decides linear motion");
  }
  if (!(problem.t_max >= 0)) throw std::invalid_argument("t_max: it is below 0 or NaN");
  if (!std::isinf(problem.t_max)) horizon = Rational(problem.t_max);
  decide();
  passes_over = problem.start_policy == corpus::StartPolicy::pass_over;
  if (passes_over && outcome == Outcome::initially_overlapping && leaves_or_slides()) {
    outcome = Outcome::miss;
    is_passed_over = true;
  }
  if (outcome == Outcome::miss) return;
  const Enclosure around = enclose(toi, [this](const Rational& t) { return compare(t); });
  lower = around.low;
  upper = around.high;
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
    toi = first_contact(*cso, radius, {1, {0, 0, 0}, v}, reaches ? line->first : *horizon);
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
// exactly when the origin is not interior to the hull of C and -v. For a ball around P, this is when the ray
// from 0 along v never comes nearer to P than its radius. For a polytope, that hull decides.
bool LinearTruth::Impl::leaves_or_slides() const {
  if (sgn(shape_radius) > 0) return path_distance_sq(path({})) >= Rational(shape_radius * shape_radius);
  std::vector<IntVec> points = cso->hull().vertices;
  points.push_back(-v);
  const ConvexHull hull = convex_hull(std::move(points));
  return hull.dimension < 3 || std::any_of(hull.half_spaces.begin(), hull.half_spaces.end(),
                                           [](const HalfSpace& h) { return sgn(h.offset) <= 0; });
}

Enclosure LinearTruth::Impl::beyond(const Rational& squared, const Integer& r) const {
  if (sgn(r) == 0) return root_of(squared);
  const Enclosure negative = enclose_radius_and_sqrt(length(r), -1, length_sq(squared));
  return not_below_zero({-negative.high, -negative.low});
}

Enclosure LinearTruth::Impl::short_of(const Rational& squared, const Integer& r) const {
  return not_below_zero(enclose_radius_and_sqrt(length(r), -1, length_sq(squared)));
}

// The least of f^2 over the span: f falls before line->first and never after it.
Rational LinearTruth::Impl::path_distance_sq(const Span& span) const {
  if (!line) return at(0).distance_sq;
  if (span.to && *span.to < line->first) return at(*span.to).distance_sq;
  if (span.from && *span.from > line->first) return at(*span.from).distance_sq;
  return line->distance_sq;
}

// P swept by v has no interior: it is no solid, and v does not leave the plane of a polygon.
bool LinearTruth::Impl::sweeps_flat() const {
  const ConvexHull& hull = cso->hull();
  return hull.dimension < 2 || (hull.dimension == 2 && sgn(dot(hull.half_spaces[0].normal, v)) == 0);
}

// Every facet of a solid P + {-t v : t in a span} has one of two normals. It is the normal of a facet of P.
// Or it is parallel to v and to an edge of P that separates facets visible along v from the other facets.
// Extra normals do no harm, because depth is a least value over all directions.
void LinearTruth::Impl::prepare_sides() const {
  if (!sides.empty()) return;
  const ConvexHull& hull = cso->hull();
  const auto add = [&](const IntVec& n, Integer offset) {
    sides.push_back({std::move(offset), dot(n, v), dot(n, n)});
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

Enclosure LinearTruth::Impl::sweep_depth(const Span& span, const Integer& r) const {
  if (sweeps_flat()) return short_of(path_distance_sq(span), r);
  prepare_sides();
  // Both ends over one denominator.
  Integer weight = 1, from, to;
  if (span.from) weight *= span.from->get_den();
  if (span.to) weight *= span.to->get_den();
  if (span.from) from = times(weight, *span.from);
  if (span.to) to = times(weight, *span.to);
  bool inside = true, found = false;
  Integer best, best_normal_sq;  // depth^2 = best^2 / (weight^2 best_normal_sq)
  for (const SweepSide& side : sides) {
    const int rises = -sgn(side.rate);  // with t
    if ((rises > 0 && !span.to) || (rises < 0 && !span.from)) continue;
    const Integer most = weight * side.offset - (rises > 0 ? to : from) * side.rate;
    if (sgn(most) < 0) {
      inside = false;
      break;
    }
    if (!found || most * most * best_normal_sq < best * best * side.normal_sq) {
      best = most;
      best_normal_sq = side.normal_sq;
      found = true;
    }
  }
  if (!inside) return sgn(r) == 0 ? Enclosure{} : short_of(path_distance_sq(span), r);
  const Rational squared = fraction(best * best, best_normal_sq * weight * weight);
  return enclose_radius_and_sqrt(length(r), 1, length_sq(squared));
}

Enclosure LinearTruth::Impl::end_error(double t, const Span& span) const {
  const Enclosure distance = beyond(at(Rational(t)).distance_sq, radius), depth = sweep_depth(span, radius);
  return {std::max(distance.low, depth.low), std::max(distance.high, depth.high)};
}

LinearTruth::LinearTruth(const corpus::Case& problem) {
  const DefaultEnvironment environment;
  impl_ = std::make_unique<Impl>(problem);
}
LinearTruth::~LinearTruth() = default;
LinearTruth::LinearTruth(LinearTruth&&) noexcept = default;
LinearTruth& LinearTruth::operator=(LinearTruth&&) noexcept = default;

Outcome LinearTruth::outcome() const { return impl_->outcome; }
double LinearTruth::toi_lower() const { return impl_->lower; }
double LinearTruth::toi_upper() const { return impl_->upper; }
int LinearTruth::dimension() const { return impl_->cso->hull().dimension; }
bool LinearTruth::is_polytope() const { return sgn(impl_->radius) == 0; }

std::string LinearTruth::toi_exact() const {
  const DefaultEnvironment environment;
  return impl_->outcome != Outcome::miss && impl_->toi.exact ? impl_->toi.low.get_str() : std::string();
}

int LinearTruth::compare(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) throw std::invalid_argument("compare: NaN is not a time");
  if (std::isinf(t)) return t < 0 || impl_->outcome == Outcome::miss ? -1 : 1;
  return impl_->compare(Rational(t));
}

Enclosure LinearTruth::scale() const {
  const DefaultEnvironment environment;
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
  const DefaultEnvironment environment;
  if (impl_->outcome != Outcome::miss) return {};
  if (!impl_->is_passed_over) {
    return impl_->beyond(impl_->path_distance_sq(impl_->path(impl_->horizon)), impl_->radius);
  }
  const Enclosure ray = impl_->beyond(impl_->path_distance_sq(impl_->path({})), impl_->shape_radius);
  const Enclosure start = impl_->sweep_depth(impl_->path(Rational(0)), impl_->radius);
  return {std::min(ray.low, start.low), std::min(ray.high, start.high)};
}

Enclosure LinearTruth::depth() const {
  const DefaultEnvironment environment;
  if (impl_->outcome == Outcome::miss) return {};
  const Enclosure path = impl_->sweep_depth(impl_->path(impl_->horizon), impl_->radius);
  if (!impl_->passes_over) return path;
  const Enclosure start = impl_->beyond(impl_->at(0).distance_sq, impl_->radius);
  const Enclosure ray = impl_->sweep_depth(impl_->path({}), impl_->shape_radius);
  return {std::min(path.low, std::max(start.low, ray.low)),
          std::min(path.high, std::max(start.high, ray.high))};
}

Enclosure LinearTruth::distance_at(double t) const {
  const DefaultEnvironment environment;
  if (!std::isfinite(t)) return kUnbounded;
  return impl_->beyond(impl_->at(Rational(t)).distance_sq, impl_->radius);
}

Enclosure LinearTruth::depth_before(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) return kUnbounded;
  if (t <= 0) return {};
  return impl_->sweep_depth(impl_->path(std::isinf(t) ? OptionalTime() : OptionalTime(Rational(t))),
                            impl_->radius);
}

Enclosure LinearTruth::backward_error(double t) const {
  const DefaultEnvironment environment;
  if (!std::isfinite(t) || t < 0) return kUnbounded;
  const Enclosure distance = distance_at(t);
  // Outside C, a path that has not reached the TOI has made no contact: nothing lies behind it.
  if (distance.low > 0 && impl_->outcome != Outcome::miss && impl_->compare(Rational(t)) < 0) return distance;
  const Enclosure depth = depth_before(t);
  return {std::max(distance.low, depth.low), std::max(distance.high, depth.high)};
}

Enclosure LinearTruth::forward_error(double t) const {
  const DefaultEnvironment environment;
  if (impl_->outcome == Outcome::miss || !std::isfinite(t)) return kUnbounded;
  const Rational time(t), speed_sq = impl_->length_sq(Rational(dot(impl_->v, impl_->v)));
  const Rational d_low = time - impl_->toi.low, d_high = time - impl_->toi.high;
  const Enclosure one = enclose_sqrt(d_low * d_low * speed_sq);
  if (impl_->toi.exact) return one;
  const Enclosure other = enclose_sqrt(d_high * d_high * speed_sq);
  const bool straddles = sgn(d_low) != sgn(d_high);
  return {straddles ? 0.0 : std::min(one.low, other.low), std::max(one.high, other.high)};
}

Enclosure LinearTruth::lateness(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) return kUnbounded;
  if (impl_->outcome == Outcome::miss || compare(t) <= 0) return {};
  // A claimed miss, or a time beyond T, is late by the whole path that the case has.
  const bool beyond_horizon = std::isinf(t) || (impl_->horizon && Rational(t) > *impl_->horizon);
  return beyond_horizon ? impl_->sweep_depth(impl_->path(impl_->horizon), impl_->radius) : depth_before(t);
}

Enclosure LinearTruth::normal_error(const Vec3<double>& n) const {
  const DefaultEnvironment environment;
  if (impl_->outcome == Outcome::miss || !n.allFinite() || n.isZero(0)) return kUnbounded;
  const IntVec direction = homogeneous(rational(n)).x;
  const Integer most = support(impl_->cso->hull(), direction);
  const Integer rate = dot(direction, impl_->v);
  const Rational scale_sq = Rational(dot(direction, direction)) * (impl_->unit * impl_->unit);
  const auto error = [&](const Rational& t) {  // (h - t rate) / |direction| + R
    const Rational gap = most - t * rate;
    return enclose_radius_and_sqrt(impl_->length(impl_->radius), sgn(gap) < 0 ? -1 : 1, gap * gap / scale_sq);
  };
  const Enclosure one = error(impl_->toi.low);
  if (impl_->toi.exact) return one;
  const Enclosure other = error(impl_->toi.high);
  return not_below_zero({std::min(one.low, other.low), std::max(one.high, other.high)});
}

Enclosure LinearTruth::distance_from_body(char body, double t, const Vec3<double>& world_point) const {
  const DefaultEnvironment environment;
  return impl_->distance_from_body(body, t, world_point);
}

Enclosure LinearTruth::distance() const {
  const DefaultEnvironment environment;
  return impl_->beyond(impl_->at(0).distance_sq, impl_->shape_radius);
}

double LinearTruth::nearest_distance() const {
  const DefaultEnvironment environment;
  const Rational squared = impl_->length_sq(impl_->at(0).distance_sq);
  return std::max(0.0, nearest_sqrt_minus(squared, impl_->length(impl_->shape_radius)));
}

bool LinearTruth::leaves_or_slides() const {
  const DefaultEnvironment environment;
  return impl_->leaves_or_slides();
}

std::optional<ContactInterval> LinearTruth::contact_interval() const {
  const DefaultEnvironment environment;
  if (impl_->v.is_zero()) {
    if (impl_->excess(0) > 0) return {};
    return ContactInterval{-kInf, kInf, {-kInf, -kInf}, {kInf, kInf}, "", ""};
  }
  const auto times = contact_times(*impl_->cso, impl_->radius, impl_->v);
  if (!times) return {};
  // Beyond an end, and only there, f exceeds R.
  const CompareTime with_in = [this](const Rational& t) { return -impl_->excess(t); };
  const CompareTime with_out = [this](const Rational& t) { return impl_->excess(t); };
  const auto exactly = [](const Root& root) { return root.exact ? root.low.get_str() : std::string(); };
  return ContactInterval{oracle::nearest_double(times->in, with_in),
                         oracle::nearest_double(times->out, with_out),
                         enclose(times->in, with_in),
                         enclose(times->out, with_out),
                         exactly(times->in),
                         exactly(times->out)};
}

Enclosure LinearTruth::entry_error(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) return kUnbounded;
  if (!std::isinf(t)) return impl_->end_error(t, {{}, Rational(t)});
  // For t = -inf the claim is contact from the beginning of time on, which is true for a body at rest. For t
  // = +inf the claim is no contact at all.
  if (t < 0) return impl_->v.is_zero() ? line_clearance() : kUnbounded;
  return line_depth();
}

Enclosure LinearTruth::exit_error(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) return kUnbounded;
  if (!std::isinf(t)) return impl_->end_error(t, {Rational(t), {}});
  if (t > 0) return impl_->v.is_zero() ? line_clearance() : kUnbounded;
  return line_depth();
}

Enclosure LinearTruth::line_depth() const {
  const DefaultEnvironment environment;
  return impl_->sweep_depth({}, impl_->radius);
}

Enclosure LinearTruth::line_clearance() const {
  const DefaultEnvironment environment;
  return impl_->beyond(impl_->path_distance_sq({}), impl_->radius);
}

}  // namespace graze::oracle
