// Decides exactly: the verdict (overlapping at the start, hit, miss) wherever clearance or depth exceeds the
//   requested width times scale.
// Brackets only: every number. The TOI to the requested width (1e-3 to 1e-60 of scale), distances and lengths to
//   that width or 2^-45 of themselves, depths within kDepthSlack.
// Costs, milliseconds of one core, mean (worst) of 120 turned pairs:
//   pair                        polytopes      polytope, curved   curved, curved
//   TOI, width 1e-20            0.3 (0.6)      1.1 (5)            2.1 (5)
//   TOI, width 1e-30            0.3 (12)       1.7 (8)            3.5 (9)
//   depth_before, an ulp late   0.2 (0.3)      1.1 (3)            1.6 (3)
//   distance_at                 0.1 (0.2)      0.4 (2)            0.6 (2)
//   depth of the path           0.2 (0.4)      0.3 (0.6)          0.4 (0.7)
//   A penetration that is the same in all directions (concentric balls) takes 3 at a slack of 1/16, and 210
//   to spend its whole budget at 1e-6, where it ends at 1/140.
// Cannot be trusted: to answer at all where pairs touch, where a flat CSO moves in its own plane, and where
//   clearance or depth is below the width. There the answer is not_converged, undecided. Its answers are proved.
//
// Notation   C = A - B + ball(m),   K(t) = C - [0, t] v, the swept CSO. The path over [0, t] makes contact
//   iff 0 is in K(t). Its clearance is the distance of 0 from K(T), its depth the depth of 0 in K(T).
//
// A horizon beyond T' = 2 M / |v|, M >= |c| for every c in C, changes none of these. Contact needs t |v| <=
// M, and turning n across v by an angle changes h(n) by at most sqrt(2) M sin(angle) < T' |v| sin(angle).
//
// Proof of an upper bound. Let q be a combination of points of C, e = |q - s v|, and let the ball of radius r
// about 0 be in K(T') (the polytope of least_depth). With a = e / (e + r), C has a point e' + t' v with
//   e' = -(q - s v) (1 - a) / a,   |e'| = r,   t' <= T',
// so (1 - a) q + a (e' + t' v) = ((1 - a) s + a t') v is in C, and TOI <= s + a max(0, T' - s). So the search
// may run about a line that passes the origin by a tiny shift, where no ties arise.
#include "oracles/truth/bracket_truth.hpp"

#include <flint/fmpq.h>

#include <cmath>
#include <stdexcept>

#include "oracles/arithmetic/default_environment.hpp"
#include "oracles/curved/ball_body.hpp"
#include "oracles/curved/ball_search.hpp"
#include "oracles/truth/by_time.hpp"
#include "oracles/truth/unbounded.hpp"

namespace graze::oracle {
namespace {

constexpr long kExactBits = ARF_PREC_EXACT;
constexpr double kRelativeDistance = 0x1p-45;

BallVec exact_difference(const BallVec& l, const BallVec& r) {
  const WorkingPrecision exact(kExactBits);
  return l - r;
}

struct BallBox {
  BallVec low, high;
};

BallBox bounds(const BallBody& body) {
  const auto reach = [&](double x, double y, double z) {
    return body.support(BallVec(Vec3<double>(x, y, z))).reach;
  };
  return {{-reach(-1, 0, 0), -reach(0, -1, 0), -reach(0, 0, -1)},
          {reach(1, 0, 0), reach(0, 1, 0), reach(0, 0, 1)}};
}

Rational to_rational(const Ball& exact) {
  fmpq_t q;
  fmpq_init(q);
  arf_get_fmpq(q, arb_midref(exact.get()));
  Rational result;
  fmpq_get_mpq(result.get_mpq_t(), q);
  fmpq_clear(q);
  return result;
}

struct TimeBracket {
  Ball lower, upper;  // exact
};

void refuse_what_is_no_linear_case(const corpus::Case& problem, double width) {
  if (!problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0)) {
    throw std::invalid_argument("a rotating case: this oracle decides linear motion");
  }
  if (!(problem.t_max >= 0)) throw std::invalid_argument("t_max: it is below 0 or NaN");
  if (!(problem.target_distance >= 0) || std::isinf(problem.target_distance)) {
    throw std::invalid_argument("target_distance: it is below 0, infinite or NaN");
  }
  if (!(width >= BracketTruth::kLeastWidth && width <= BracketTruth::kGreatestWidth)) {
    throw std::invalid_argument("width: it is outside 1e-60 .. 1e-3");
  }
}

}  // namespace

struct BracketTruth::Impl {
  double width;
  long bits = 256;
  double target, t_max;
  std::optional<BallBody> a, b;
  BallVec between, v;          // position of B from A, and velocity (both exact)
  Ball scale, unit, greatest;  // unit = width scale, exact, and greatest >= |c| for c in C
  Ball speed, horizon;         // |v|, and min(T, T'), exact
  BallVec shift;

  bool passes_over = false;     // the policy
  bool is_passed_over = false;  // a start that leaves or slides, under that policy
  Outcome outcome = Outcome::not_converged;
  bool contact = false;
  Ball lower, upper;  // of the TOI, exact
  double width_found = kInf;
  mutable std::optional<Enclosure> clearance, depth;
  ByTime distances, depths;

  Impl(const corpus::Case& problem, double asked);
  void measure(const corpus::Case& problem);
  void decide();
  void find_time(const std::vector<CsoPoint>& swept_points, const Ball& inside);
  [[nodiscard]] std::optional<TimeBracket> first_time(const BallVec& w, std::vector<CsoPoint> points,
                                                      const Ball& inside, const Ball& latest,
                                                      const Ball& far_behind) const;
  [[nodiscard]] std::optional<bool> leaves_or_slides() const;

  // A - B + ball(m) - [0, t] v - origin
  [[nodiscard]] ConvexSet swept(const Ball& t, double m, const BallVec& origin = {}) const;
  [[nodiscard]] Ball clipped(double t) const;
  [[nodiscard]] Nearest3 distance_of(const ConvexSet& set) const;
  [[nodiscard]] Depth3 depth_of(const ConvexSet& set, double slack) const;
};

BracketTruth::Impl::Impl(const corpus::Case& problem, double asked)
    : width(asked), target(problem.target_distance), t_max(problem.t_max) {
  refuse_what_is_no_linear_case(problem, asked);
  {
    const WorkingPrecision precision(bits);
    measure(problem);
  }
  // The search resolves features of the size of the square root of the width and of the shift, width^2, and
  // takes differences of products of them. The bits are three widths, the cost of the offsets of the shapes,
  // and 128 bits to spare.
  const double offsets = a->magnitude() + b->magnitude() + target;
  const double size = scale.low_double();
  const double lost = size > 0 ? std::log2(std::max(1.0, offsets / size)) : 0;
  bits = 128 + static_cast<long>(-3 * std::log2(width) + 2 * lost);
  const WorkingPrecision precision(bits);
  measure(problem);
  decide();
  passes_over = problem.start_policy == corpus::StartPolicy::pass_over;
  if (passes_over && contact && outcome != Outcome::hit) {
    const std::optional<bool> leaves = leaves_or_slides();
    if (!leaves) {
      outcome = Outcome::not_converged;
      contact = false;
    } else if (*leaves) {
      is_passed_over = outcome == Outcome::initially_overlapping;
      outcome = is_passed_over ? Outcome::miss : Outcome::not_converged;
      contact = false;
    }
  }
}

void BracketTruth::Impl::measure(const corpus::Case& problem) {
  a.emplace(problem.a);
  b.emplace(problem.b);
  between = exact_difference(b->position(), a->position());
  v = exact_difference(b->displacement(), a->displacement());
  const BallBox box_a = bounds(*a), box_b = bounds(*b);
  const Ball half = 0.5;
  const BallVec centers = between + half * ((box_b.low + box_b.high) - (box_a.low + box_a.high));
  scale = max(max(norm(box_a.high - box_a.low), norm(box_b.high - box_b.low)), norm(centers));
  unit = (Ball(width) * scale).high();
  const BallVec low = box_a.low - box_b.high - between, high = box_a.high - box_b.low - between;
  greatest = (norm(BallVec{max(abs(low.x), abs(high.x)), max(abs(low.y), abs(high.y)),
                           max(abs(low.z), abs(high.z))}) +
              target)
                 .high();
  speed = norm(v);
  horizon = clipped(t_max);
  // Any direction in general position serves. Its length is far below the width squared.
  const Ball length = unit * Ball(width) * Ball(0x1p-6);
  shift = BallVec{length * Ball(0.53771), length * Ball(-0.31883), length * Ball(0.75213)}.mid();
}

// min(t, T'): nothing beyond T' matters.
Ball BracketTruth::Impl::clipped(double t) const {
  if (!speed.is_positive() || t <= 0) return 0;
  const Ball most = (Ball(2) * greatest / speed.low()).high();
  return std::isinf(t) || certainly_less(most, Ball(t)) ? most : Ball(t);
}

ConvexSet BracketTruth::Impl::swept(const Ball& t, double m, const BallVec& origin) const {
  const BallVec sweep = t * v;
  const bool moves = !t.is_zero();
  return [this, t, m, sweep, moves, origin](const BallVec& n) {
    const BallSupport from_a = a->support(n), from_b = b->support(-n);
    CsoPoint p;
    p.a = a->position() + from_a.point;
    p.b = b->position() + from_b.point;
    p.point = from_a.point - from_b.point - between - origin;
    p.reach = from_a.reach + from_b.reach - dot(n, between + origin);
    if (m > 0) {
      const Ball length = norm(n);
      p.reach += m * length;
      if (length.is_positive()) p.point = p.point + (Ball(m) / length) * n;
    }
    if (moves) {
      const Ball gain = -dot(n, sweep);
      if (gain.mid_sign() > 0) {
        p.point = p.point - sweep;
        p.s = t;
      }
      p.reach += not_below_zero(gain);
    }
    return p;
  };
}

Nearest3 BracketTruth::Impl::distance_of(const ConvexSet& set) const {
  return nearest(set, shift, {.absolute = unit, .relative = kRelativeDistance});
}

// The depth of the origin in the set. If the origin is not proved to be inside, the bounds are 0 and an upper
// bound.
Depth3 BracketTruth::Impl::depth_of(const ConvexSet& set, double slack) const {
  const Nearest3 near = nearest(set, shift, {.until_separated = true});
  Depth3 found;
  if (near.lower.is_positive()) return found;
  found.upper = near.least_reach;
  if (!near.around) return found;
  // upper <= (1 + slack) lower, as a part of upper
  return least_depth(set, near.inner.points,
                     {.absolute = unit * Ball(0.25), .relative = slack / (1 + slack) * (1 - 0x1p-20)});
}

void BracketTruth::Impl::decide() {
  const ConvexSet path = swept(horizon, target);
  const Nearest3 near = nearest(path, shift, {.until_separated = true});
  if (near.lower.is_positive()) {
    outcome = Outcome::miss;
    return;
  }
  if (!near.around) return;
  const Depth3 inside =
      least_depth(path, near.inner.points, {.absolute = unit * Ball(0x1p-10), .relative = 0.5});
  if (!inside.lower.is_positive()) return;
  contact = true;
  if (horizon.is_zero()) {
    outcome = Outcome::initially_overlapping;
    width_found = 0;
    return;
  }
  find_time(near.inner.points, inside.lower);
}

// The least t with t w in C, w = v or -v. The ball of radius `inside` about 0 is in the hull of `points`,
// which are c - s w with c in C and s <= latest.
std::optional<TimeBracket> BracketTruth::Impl::first_time(const BallVec& w, std::vector<CsoPoint> points,
                                                          const Ball& inside, const Ball& latest,
                                                          const Ball& far_behind) const {
  for (CsoPoint& p : points) {
    p.point = p.point + p.s * w;
    p.s = 0;
  }
  const auto found = first_on_line(swept(0, target), w, points, shift,
                                   {.absolute = unit * Ball(0.25), .far_behind = far_behind});
  if (!found) return {};
  const Ball part = found->off / (found->off + inside);
  const Ball reached = found->height + part * not_below_zero(latest - found->height);
  return TimeBracket{found->lower, reached.high()};
}

void BracketTruth::Impl::find_time(const std::vector<CsoPoint>& swept_points, const Ball& inside) {
  upper = horizon;
  const auto time = first_time(v, swept_points, inside, horizon, (-unit / speed).mid());
  if (time) {
    lower = not_below_zero(time->lower);
    upper = min(upper, not_below_zero(time->upper)).high();
    if (time->lower.is_positive()) {
      outcome = Outcome::hit;
    } else if (time->upper.mid_sign() <= 0) {
      outcome = Outcome::initially_overlapping;
      lower = 0;
    }
  }
  width_found = ((upper - lower) * speed).high_double();
}

// Leaving or sliding: n.v >= 0 for some n != 0 with h(n) <= 0, h of A - B: the origin is not inside
// K(infinity) of A - B.
std::optional<bool> BracketTruth::Impl::leaves_or_slides() const {
  const ConvexSet ray = swept(clipped(kInf), 0);
  const Nearest3 near = nearest(ray, shift, {.until_separated = true});
  if (near.lower.is_positive()) return true;
  if (!near.around) return {};
  const Depth3 inside =
      least_depth(ray, near.inner.points, {.absolute = unit * Ball(0x1p-10), .relative = 0.5});
  if (inside.lower.is_positive()) return false;
  return {};
}

BracketTruth::BracketTruth(const corpus::Case& problem, double width) {
  const DefaultEnvironment environment;
  impl_ = std::make_unique<Impl>(problem, width);
}
BracketTruth::~BracketTruth() = default;
BracketTruth::BracketTruth(BracketTruth&&) noexcept = default;
BracketTruth& BracketTruth::operator=(BracketTruth&&) noexcept = default;

Outcome BracketTruth::outcome() const { return impl_->outcome; }
bool BracketTruth::contact_proved() const { return impl_->contact; }

double BracketTruth::toi_lower() const {
  const DefaultEnvironment environment;
  if (impl_->contact) return impl_->lower.low_double();
  return impl_->outcome == Outcome::miss ? kInf : 0;
}

double BracketTruth::toi_upper() const {
  const DefaultEnvironment environment;
  return impl_->contact ? impl_->upper.high_double() : kInf;
}

RationalBracket BracketTruth::toi_bracket() const {
  const DefaultEnvironment environment;
  if (!impl_->contact) throw std::logic_error("toi_bracket: contact is not proved");
  return {to_rational(impl_->lower), to_rational(impl_->upper)};
}

double BracketTruth::width() const { return impl_->contact ? impl_->width_found : kInf; }

int BracketTruth::compare(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) throw std::invalid_argument("compare: NaN is not a time");
  if (impl_->outcome == Outcome::miss) return -1;
  if (!impl_->contact) return t < 0 ? -1 : 0;
  if (std::isinf(t)) return t < 0 ? -1 : 1;
  if (impl_->outcome == Outcome::initially_overlapping) return t < 0 ? -1 : (t > 0 ? 1 : 0);
  if (certainly_less(Ball(t), impl_->lower)) return -1;
  return certainly_less(impl_->upper, Ball(t)) ? 1 : 0;
}

Enclosure BracketTruth::scale() const {
  const DefaultEnvironment environment;
  return impl_->scale.enclosure();
}

Enclosure BracketTruth::clearance() const {
  const DefaultEnvironment environment;
  if (impl_->contact) return {};
  if (!impl_->clearance) {
    const WorkingPrecision precision(impl_->bits);
    const bool passed = impl_->is_passed_over;
    const Nearest3 near = impl_->distance_of(passed ? impl_->swept(impl_->clipped(kInf), 0)
                                                    : impl_->swept(impl_->horizon, impl_->target));
    impl_->clearance = {near.lower.low_double(), near.upper.high_double()};
    if (passed) {
      const Depth3 start = impl_->depth_of(impl_->swept(0, impl_->target), kDepthSlack);
      impl_->clearance->low = std::min(impl_->clearance->low, start.lower.low_double());
      impl_->clearance->high = std::min(impl_->clearance->high, start.upper.high_double());
    }
  }
  return *impl_->clearance;
}

Enclosure BracketTruth::depth() const {
  const DefaultEnvironment environment;
  if (impl_->outcome == Outcome::miss) return {};
  if (!impl_->depth) {
    const WorkingPrecision precision(impl_->bits);
    const Depth3 depth = impl_->depth_of(impl_->swept(impl_->horizon, impl_->target), kDepthSlack);
    impl_->depth = {depth.lower.low_double(), depth.upper.high_double()};
    if (impl_->passes_over) {
      const Nearest3 start = impl_->distance_of(impl_->swept(0, impl_->target));
      const Depth3 ray = impl_->depth_of(impl_->swept(impl_->clipped(kInf), 0), kDepthSlack);
      const auto least = [](double path, double from_start, double in_shapes) {
        return std::min(path, std::max(from_start, in_shapes));
      };
      impl_->depth = {least(impl_->depth->low, start.lower.low_double(), ray.lower.low_double()),
                      least(impl_->depth->high, start.upper.high_double(), ray.upper.high_double())};
    }
  }
  return *impl_->depth;
}

Enclosure BracketTruth::distance_at(double t) const {
  const DefaultEnvironment environment;
  if (!std::isfinite(t)) return kUnbounded;
  return impl_->distances.at(t, [&]() -> Enclosure {
    const WorkingPrecision precision(impl_->bits);
    const Nearest3 near = impl_->distance_of(impl_->swept(0, impl_->target, Ball(t) * impl_->v));
    return {near.lower.low_double(), near.upper.high_double()};
  });
}

Enclosure BracketTruth::depth_before(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) return kUnbounded;
  if (t <= 0 || compare(t) < 0) {
    if (t <= 0 || impl_->contact) return {};
  }
  return impl_->depths.at(t, [&]() -> Enclosure {
    const WorkingPrecision precision(impl_->bits);
    const Depth3 depth = impl_->depth_of(impl_->swept(impl_->clipped(t), impl_->target), kDepthSlack);
    return {depth.lower.low_double(), depth.upper.high_double()};
  });
}

Enclosure BracketTruth::backward_error(double t) const {
  const DefaultEnvironment environment;
  if (!std::isfinite(t) || t < 0) return kUnbounded;
  const Enclosure distance = distance_at(t);
  if (impl_->contact && compare(t) < 0) return distance;
  const Enclosure depth = depth_before(t);
  return {std::max(distance.low, depth.low), std::max(distance.high, depth.high)};
}

Enclosure BracketTruth::forward_error(double t) const {
  const DefaultEnvironment environment;
  if (!std::isfinite(t) || impl_->outcome == Outcome::miss) return kUnbounded;
  if (!impl_->contact) return {0, kInf};
  const WorkingPrecision precision(impl_->bits);
  const Ball time = hull_of(impl_->lower, impl_->upper);
  const Enclosure error = (abs(Ball(t) - time) * impl_->speed).enclosure();
  return {std::max(0.0, error.low), error.high};
}

Enclosure BracketTruth::lateness(double t) const {
  const DefaultEnvironment environment;
  if (std::isnan(t)) return kUnbounded;
  if (impl_->outcome == Outcome::miss) return {};
  const int order = compare(t);
  if (order < 0) return {};
  const bool beyond_horizon = std::isinf(t) || t > impl_->t_max;
  const Enclosure late = beyond_horizon ? depth() : depth_before(t);
  return {order > 0 ? late.low : 0, late.high};
}

Enclosure BracketTruth::normal_error(const Vec3<double>& n) const {
  const DefaultEnvironment environment;
  if (impl_->outcome == Outcome::miss || !finite(n) || n.isZero(0)) return kUnbounded;
  if (!impl_->contact) return {0, kInf};
  const WorkingPrecision precision(impl_->bits);
  const BallVec axis(n);
  const Ball reach = impl_->swept(0, impl_->target)(axis).reach;
  const Ball rate = dot(axis, impl_->v);
  const Ball error = hull_of(reach - impl_->lower * rate, reach - impl_->upper * rate) / norm(axis);
  return {std::max(0.0, error.low_double()), std::max(0.0, error.high_double())};
}

Enclosure BracketTruth::distance_from_body(char which, double t, const Vec3<double>& world_point) const {
  const DefaultEnvironment environment;
  if (which != 'a' && which != 'b') throw std::invalid_argument("a body is 'a' or 'b'");
  if (!std::isfinite(t) || !finite(world_point)) return kUnbounded;
  const WorkingPrecision precision(impl_->bits);
  const BallBody& body = which == 'a' ? *impl_->a : *impl_->b;
  BallVec from_body = exact_difference(BallVec(world_point), body.position());
  from_body = from_body - Ball(t) * body.displacement();
  const ConvexSet set = [&](const BallVec& n) {
    const BallSupport s = body.support(n);
    CsoPoint p;
    p.point = s.point - from_body;
    p.reach = s.reach - dot(n, from_body);
    return p;
  };
  const Nearest3 near = impl_->distance_of(set);
  return {near.lower.low_double(), near.upper.high_double()};
}

// The line is the path over [-T', T'].
LineContact BracketTruth::contact_interval() const {
  const DefaultEnvironment environment;
  const WorkingPrecision precision(impl_->bits);
  const Ball most = impl_->clipped(kInf);
  const BallVec before = (-most) * impl_->v;
  const ConvexSet line = impl_->swept((Ball(2) * most).mid(), impl_->target, before);
  const Nearest3 near = nearest(line, impl_->shift, {.until_separated = true});
  if (near.lower.is_positive()) return {Outcome::miss, {}, {}};
  if (!near.around) return {};
  const Depth3 inside =
      least_depth(line, near.inner.points, {.absolute = impl_->unit * Ball(0x1p-10), .relative = 0.5});
  if (!inside.lower.is_positive()) return {};
  if (most.is_zero()) return {Outcome::hit, {-kInf, -kInf}, {kInf, kInf}};
  // A point c + T' v - s v is c - (s - T') v and c - (T' - s) (-v).
  std::vector<CsoPoint> forward = near.inner.points, backward = near.inner.points;
  for (CsoPoint& p : forward) p.s = p.s - most;
  for (CsoPoint& p : backward) p.s = most - p.s;
  const Ball never = Ball(-4) * most;
  const auto in = impl_->first_time(impl_->v, std::move(forward), inside.lower, most, never);
  const auto out = impl_->first_time(-impl_->v, std::move(backward), inside.lower, most, never);
  if (!in || !out) return {};
  return {Outcome::hit,
          {in->lower.low_double(), in->upper.high_double()},
          {-out->upper.high_double(), -out->lower.low_double()}};
}

ClosestPoints BracketTruth::closest_points() const {
  const DefaultEnvironment environment;
  const WorkingPrecision precision(impl_->bits);
  const Nearest3 near = impl_->distance_of(impl_->swept(0, 0));
  ClosestPoints result;
  result.distance = {near.lower.low_double(), near.upper.high_double()};
  result.point_a = near.inner.of(&CsoPoint::a).mid_double();
  result.point_b = near.inner.of(&CsoPoint::b).mid_double();
  const Ball length = norm(near.axis);
  if (length.is_positive()) result.axis = ((Ball(1) / length) * near.axis).mid_double();
  return result;
}

Enclosure BracketTruth::distance() const {
  const DefaultEnvironment environment;
  return closest_points().distance;
}

double BracketTruth::nearest_distance() const {
  const DefaultEnvironment environment;
  const Enclosure d = distance();
  return d.low + (d.high - d.low) / 2;
}

ClosestPoints BracketTruth::penetration(double slack) const {
  const DefaultEnvironment environment;
  const WorkingPrecision precision(impl_->bits);
  const Depth3 depth = impl_->depth_of(impl_->swept(0, 0), slack);
  ClosestPoints result;
  result.distance = {depth.lower.low_double(), depth.upper.high_double()};
  const Ball length = norm(depth.axis);
  if (length.is_positive()) result.axis = ((Ball(1) / length) * depth.axis).mid_double();
  return result;
}

}  // namespace graze::oracle
