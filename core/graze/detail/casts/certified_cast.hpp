// Tier certified of linear casts: a bracket of the first contact, proved without condition for the true
// shapes.
//
//   toi_lower <= TOI <= toi_upper for the sets that the given numbers define. This counts every rounding of the
//   search, of the support functions and of the times. The width of the bracket, the larger backward error of the two
//   ends, is proved to be at most kLinearCertifiedWidth of scale. The verdict is never wrong.
//
// Supports every shape, with S float or double. Everything is computed in double, and the two times are rounded
// outward to S at the end (for float this adds to the width). The exact tier answers polytopes and rounded polytopes,
// with an even narrower bracket.
//   miss                   proved by an axis or by exact arithmetic: apart at the start, and the motion does not
//                          approach
//   initially_overlapping  C holds the origin. Proved by two portals, of the line forwards and backwards, or by exact
//                          arithmetic (exact_start.hpp), which covers touching bodies
//   hit                    proved by an axis and a portal. toi_lower = 0 if the start is within the width of contact,
//                          is not proved to be in contact, and contact is proved a little later
//   not_converged          a tie: at toi_lower the bodies are within the width of contact, or the motion ends there,
//                          and neither contact nor a miss is proved. The answer has a normal, witnesses and
//                          `distance`, a bound of the gap that is at most the width, so a caller can take it for
//                          contact. This occurs only if clearance or depth is below the width, or under pass_over if
//                          that much decides whether the start leaves. A search that ends at the caller's own
//                          max_iterations may say less. For a shape far out in its own frame, at 1e12 scale and more,
//                          the width is limited by the resolution of sums of two doubles there: 2^10 times the error
//                          of named_point.hpp
//
// Method. The exact tier answers spheres, capsules and polytopes at a distance. It also answers other rounded
// polytopes if all other methods leave them open. casts/curved_bracket.hpp answers pairs with a cylinder, a cone or
// an ellipsoid. In all other cases the two halves of the bracket are proved as follows.
//   - Upper half: a portal of exactly named points (proving/certified_portal.hpp), with decisions beyond
//     predicate_error.
//   - Lower half: the axis of that portal, of MPR or of the GJK ray cast. These axes are too short when an edge lies
//     between a face that is nearly along the path and another face. Then the axis runs from C to a point of the path
//     a little before contact. This point is farther from C than the rounding of h, so its axis is proved. It is also
//     nearer than the width, which is enough.
//
// Both halves' backward errors are then bounded:
//   distance of t v from C      <= (upper - t) |v|, and by GJK
//   depth of [0, t) v in C      <= max(0, h(n) - min(0, t n.v)) for every unit n: moved so far along -n, C
//                                  lies beneath the path
#pragma once

#include <graze/detail/casts/certified_ray.hpp>
#include <graze/detail/casts/curved_bracket.hpp>
#include <graze/detail/casts/degenerate_round.hpp>
#include <graze/detail/casts/exact_ray.hpp>
#include <graze/detail/casts/exact_round_answer.hpp>
#include <graze/detail/numeric/rounding.hpp>
#include <graze/detail/proving/prove.hpp>
#include <graze/detail/proving/surround.hpp>
#include <graze/detail/search/exact/exact_start.hpp>
#include <graze/detail/search/robust/leaving.hpp>
#include <optional>
#include <utility>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
class CertifiedCast {
 public:
  CertifiedCast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, double t_max,
                double target_distance, Counters& counters)
      : a_(a),
        b_(b),
        cso_(a, b, static_cast<S>(target_distance), Turning::accurate),
        context_(proof_context(a, b, cso_, t_max, target_distance)),
        counters_(counters),
        points_(context_, counters),
        target_distance_(target_distance),
        budget_(options.max_iterations),
        wants_proof_(asks_for(options.request, Request::proof)),
        // cso.scale() is not above the pair's. A portal is 2^9 times the predicate_error of its corners high.
        width_allowed_(fl(kLinearCertifiedWidth * (1 - 0x1p-20) * cso_.scale()) + 0x1p10 * points_.error()) {}
  CertifiedCast(const CertifiedCast&) = delete;
  CertifiedCast& operator=(const CertifiedCast&) = delete;

  void run() {
    if (is_swept()) {
      sweep();
    } else {
      rest();
    }
    if (outcome == Outcome::not_converged) come_near();
    if (outcome == Outcome::hit || outcome == Outcome::not_converged) settle_start();
    if (outcome == Outcome::not_converged) fill_open();
  }
  // The same where a quicker search has left the verdict open: if the axis at t = 0 proves a miss, or the bodies touch
  // then up to rounding, that is decided first. A proof of contact may come of the wider search alone.
  void run_open() {
    Simplex<double> simplex;
    const Distance<double> d =
        gjk_distance(cso_, Vec3<double>(Vec3<double>::Zero()), simplex, 0.0, 0.0, budget_, counters_);
    if (is_miss(d.n)) return;
    if (std::abs(d.upper - cso_.radius()) <= width_allowed_ && !wants_proof_) {
      if (is_shown_at_start() || settle_start()) return;
    }
    run();
  }

  // Witnesses of a hit: points of A and B, in the world at t = 0, that are in contact at `lower`, within the width.
  struct Contact {
    Vec3<double> on_a = Vec3<double>::Zero(), on_b = Vec3<double>::Zero();
    void add(double weight, const NamedPoint& p) {
      on_a += weight * p.on_a;
      on_b += weight * p.on_b;
    }
  };
  [[nodiscard]] Contact contact() {
    Contact out;
    const double s = cso_.to_parameter(lower);
    if ((cso_.to_parameter(upper) - s) * norm(context_.r) <= width_allowed_ / 8) {
      for (std::size_t i = 0; i < 3; ++i) out.add(portal.lambda[i], portal.p[i].point);
      return out;
    }
    // A graze: the portal is farther along the path. The closest points at `lower`.
    Simplex<double> simplex;
    const Vec3<double> x = path_at(s);
    const Distance<double> d = gjk_distance(cso_, x, simplex, width_allowed_ / 64, 0.0, budget_, counters_);
    const Closest<double> closest = closest_to_origin(simplex, x);
    reduce(simplex, closest);
    Vec3<double> towards = d.n != Vec3<double>::Zero() ? d.n : n;
    // The balls touch along what is between the cores, which is known better than the normal of the search.
    if (cso_.radius() > 0 && norm(closest.v) > cso_.radius() / 2) towards = -unit(closest.v);
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.size); ++i) {
      const CsoPoint<double>& p = simplex.point[i];
      const Vec3<double> e = p.n != Vec3<double>::Zero() ? unit(p.n) : towards;
      out.add(simplex.lambda[i], points_.named(p, e));
      // A curved core's points are found along directions of their own, but the balls about them all use one
      // direction.
      out.on_a += simplex.lambda[i] * context_.radius_a * (towards - e);
      out.on_b -= simplex.lambda[i] * context_.radius_b * (towards - e);
    }
    return out;
  }

  // After run() of a start in contact, or maybe in contact: does its ray go into C's inside, or leave, or
  // slide? This concerns C without the target distance.
  [[nodiscard]] Start start() {
    Proof away;
    prove_miss(context_, Vec3<double>(Vec3<double>::Zero()), away, counters_);
    if (away.toi_lower == kInfinity<double>) return Start::leaves;
    if (const Start exactly = start_exactly(); exactly != Start::open) return exactly;
    // An n with h(n) <= 0 has n.v <= 0 if C has a point ahead on the line. In addition n.v = 0 only if n, seen along
    // the line, keeps all of C in a half-plane. If points of C surround the line, no such n exists. At rest any line
    // will do, and the origin is inside C if it is between the portals. And from C's inside every motion stays there
    // for a while.
    const ProvedView<S> ahead = view(false);
    const ProvedPortal in = ahead.enter({}, gap()), out = view(true).enter({}, gap());
    // For long thin shapes the rounding of the search's axis exceeds their thickness.
    for (const Vec3<double>& axis : {in.n, in.across, out.n, out.across}) {
      if (prove_lower(context_, axis, true, away, counters_)) return Start::leaves;
    }
    if (in.found && out.found && ahead.is_surrounded(in, out)) {
      if (cso_.moves() ? out.upper < 0 : in.upper < 0 && out.upper < 0) return Start::enters;
    }
    return around_origin(true) ? Start::enters : Start::open;
  }

  // After run(): nothing is known but that the bodies are near contact at t = 0.
  void leave_open() {
    outcome = Outcome::not_converged;
    proof = {};
    upper = kInfinity<double>;
    apart = cso_.to_length(near(0).distance);
    fill_open();
  }

  Outcome outcome = Outcome::not_converged;
  Proof proof;  // times in double, with a portal's pairs only while its points have names
  double lower = 0, upper = kInfinity<double>;  // t
  double apart = kInfinity<double>;             // upper bound of the gap at lower, world length
  Vec3<double> n = Vec3<double>::Zero();  // hit, not_converged: unit, supports C at the contact, or nearly
  ProvedPortal portal;                    // hit

 private:
  [[nodiscard]] bool is_swept() const { return cso_.moves() && context_.s_max > 0; }
  [[nodiscard]] Vec3<double> path_at(double s) const {
    return {fl(s * context_.r[0]), fl(s * context_.r[1]), fl(s * context_.r[2])};
  }
  // A portal's own rounding, and what its points are drawn in by, is 32 u of the lengths in them.
  [[nodiscard]] double gap() const { return 32 * kUnitRoundoff<double> * cso_.scale(); }

  // The line of the motion or, where nothing moves, of a direction from the origin to the middle of C.
  [[nodiscard]] ProvedView<S> view(bool backwards) const {
    if (!cso_.moves()) {
      const Vec3<double> d = cso_.middle();
      return along(d == Vec3<double>::Zero() ? Vec3<double>(Vec3<double>::UnitZ()) : unit(d), backwards);
    }
    Vec3<double> from = wide(a_.displacement), to = wide(b_.displacement);
    if (backwards) std::swap(from, to);
    return {points_, scaled_by(apart_exactly(to, from), power_of_two(-cso_.speed_exponent())), from, to};
  }
  // A line through the origin along d.
  [[nodiscard]] ProvedView<S> along(const Vec3<double>& d, bool backwards) const {
    const Vec3<double> zero = Vec3<double>::Zero();
    const Vec3<double>&from = backwards ? d : zero, &to = backwards ? zero : d;
    return {points_, apart_exactly(to, from), from, to};
  }
  static TwoDoubles3 apart_exactly(const Vec3<double>& to, const Vec3<double>& from) {
    TwoDoubles3 r;
    for (int i = 0; i < 3; ++i) r[static_cast<std::size_t>(i)] = two_sum(to[i], -from[i]);
    return r;
  }
  // Directions that are no symmetry of anything: where the line of the motion passes the border of two
  // portals, and is proved by neither, these do not.
  static constexpr std::array<std::array<double, 3>, 4> kSkew = {{{0.8125, 0.4375, 0.3828125},
                                                                  {-0.40625, 0.859375, 0.3125},
                                                                  {0.28125, -0.34375, 0.89453125},
                                                                  {-0.640625, -0.5703125, 0.515625}}};
  // Finds the entry into C. For an entry at s <= 0 its exact position is not needed.
  [[nodiscard]] ProvedPortal enter(const Portal<double>& first = {}) {
    return view(false).enter(first, gap(), 0);
  }
  // The same line backwards: -upper is not above the s where it leaves C.
  [[nodiscard]] ProvedPortal leave() { return view(true).enter({}, gap(), 0); }

  bool is_miss(const Vec3<double>& axis) {
    if (proof.toi_lower == kInfinity<double>) return true;
    if (axis.cwiseAbs().maxCoeff() > 0 && prove_lower(context_, axis, true, proof, counters_)) {
      outcome = Outcome::miss;
      lower = kInfinity<double>;
    }
    return outcome == Outcome::miss;
  }
  bool is_miss_by_search(const Vec3<double>& hint) {
    prove_miss(context_, hint, proof, counters_);
    if (proof.toi_lower == kInfinity<double>) {
      outcome = Outcome::miss;
      lower = kInfinity<double>;
    }
    return outcome == Outcome::miss;
  }
  // Contact at t = 0, between two portals.
  void overlap(const ProvedPortal& in, const ProvedPortal& out) {
    outcome = Outcome::initially_overlapping;
    lower = upper = 0;
    proof = {};
    if (!wants_proof_) return;
    const Surrounding four = surrounding(points_, in, out);
    if (!four.found) return prove_start(context_, proof, counters_);
    for (std::size_t i = 0; i < 4; ++i) {
      if (!four.p[i].named) return;
      proof.portal[i] = four.p[i].name;
    }
    proof.portal_size = 4;
    proof.toi_upper = 0;
  }

  // Nothing moves, or for no time.
  void rest() {
    Simplex<double> simplex;
    const Distance<double> d =
        gjk_distance(cso_, Vec3<double>(Vec3<double>::Zero()), simplex, 0.0, 0.0, budget_, counters_);
    if (is_miss(d.n) || (d.upper < cso_.radius() + gap() && is_shown_at_start())) return;
    const ProvedPortal in = enter(), out = leave();
    if (in.found && out.found && in.upper <= 0 && out.upper <= 0) return overlap(in, out);
    if (is_miss(in.n) || is_miss(out.n) || is_miss(in.across) || is_miss(out.across)) return;
    if (is_miss_by_search(d.n) || is_deep_at_start()) return;
    // GJK ends when a step brings no progress within the precision of doubles, even if its axis would still change.
    // Seen along a line, what separates C from it is exact.
    for (const auto& [x, y, z] : kSkew) {
      const ProvedPortal aside = along(Vec3<double>(x, y, z), false).enter({}, gap());
      if (is_miss(aside.found ? aside.n : aside.across)) return;
    }
  }

  void sweep() {
    const Frame<double> frame(context_.r);
    const double z_max = context_.s_max * frame.length;
    const PortalSearch<double> search = enter_line(cso_, frame, z_max, gap(), budget_, counters_);
    using State = PortalSearch<double>::State;
    if ((search.state == State::missed || search.state == State::rejected) && is_miss_by_search(search.n))
      return;
    if (search.state == State::entered && search.upper < 0 && is_shown_at_start()) return;
    portal = enter(search.portal);
    if (!portal.found || !(portal.upper <= context_.s_max * (1 - 4 * kUnitRoundoff<double>))) {
      if (is_miss(portal.found ? portal.n : portal.across) || is_miss_by_search(search.n)) return;
      // A line through the border of two portals, of symmetry mostly, is proved by neither.
      if (is_deep_at_start()) return;
      return bound_below(search);
    }
    if (portal.upper <= 0) {
      const ProvedPortal out = leave();
      if (out.found && out.upper <= 0) return overlap(portal, out);
      if (is_miss(out.found ? out.n : out.across) || is_miss_by_search(search.n)) return;
      is_deep_at_start();
      return;
    }
    bound_below(search);
    if (!(proof.toi_lower > 0) && is_deep_at_start()) return;
    // The portal's point may lie before the start. With a point of C behind the start, contact is in between.
    if (!(portal.least >= 0)) {
      const ProvedPortal out = leave();
      if (!out.found || !(out.upper <= 0)) return;
    }
    close();
  }

  // If the portals along the path cannot be found, or lie almost along it, contact at its start may be plain along
  // another direction.
  bool is_deep_at_start() {
    if (is_shown_at_start()) return true;
    const auto portals = around_origin(false);
    if (portals) overlap(portals->first, portals->second);
    return portals.has_value();
  }
  // By four points around the origin, of a start that is as deep as rounding. Asked once: it does not change.
  bool is_shown_at_start() {
    if (start_was_asked_) return false;
    start_was_asked_ = true;
    Proof start;
    prove_start(context_, start, counters_);
    if (start.portal_size != 4) return false;
    outcome = Outcome::initially_overlapping;
    lower = upper = 0;
    proof = start;
    return true;
  }
  // Portals on either side of the origin along a line of kSkew, or, `strictly`, with the origin inside of
  // their hull: beyond the predicate_error of their heights, or exactly. In a body that lies far out in its own frame
  // the predicate_error may be more than the body.
  [[nodiscard]] std::optional<std::pair<ProvedPortal, ProvedPortal>> around_origin(bool strictly) const {
    for (const auto& [x, y, z] : kSkew) {
      const ProvedView<S> view = along(Vec3<double>(x, y, z), false);
      const double enough = strictly ? -kInfinity<double> : 0.0;
      const ProvedPortal in = view.enter({}, gap(), enough);
      if (!in.found || !(strictly || in.upper <= 0)) continue;
      const ProvedPortal out = along(Vec3<double>(x, y, z), true).enter({}, gap(), enough);
      if (!out.found || !(strictly || out.upper <= 0)) continue;
      const bool beyond_predicate_error = in.upper < 0 && out.upper < 0 && view.is_surrounded(in, out);
      if (!strictly || beyond_predicate_error || surrounding(points_, in, out, true).found)
        return std::pair(in, out);
    }
    return std::nullopt;
  }

  void bound_below(const PortalSearch<double>& search) {
    prove_lower(context_, portal.n, false, proof, counters_);
    if (!(portal.n.cwiseAbs().maxCoeff() > 0) || !(portal.beyond <= gap())) {
      prove_lower(context_, search.n, false, proof, counters_);
      prove_lower(context_, search.facing, false, proof, counters_);
    }
  }
  // ---- where the search ends without a verdict ----

  struct Near {
    double distance;  // not below the distance of s r from C, internal length
    Vec3<double> n;
  };

  // A lower end near contact, by conservative advancement: each axis from C to the path's point at the lower end proves a
  // later one. Past a rounded side each step halves the way to the nearest point, at least.
  void come_near() {
    double s = cso_.to_parameter(std::min(proof.toi_lower, context_.t_max));
    Near at = near(s);
    for (int i = 0; i < kAdvances && !(at.distance <= width_allowed_); ++i) {
      if (is_miss(at.n) || is_left_behind(at.n)) return;
      if (!is_swept() || !(prove_later(at.n) || looks_from_before(s, at)) || at.distance <= width_allowed_)
        break;
      s = cso_.to_parameter(std::min(proof.toi_lower, context_.t_max));
      at = near(s);
    }
    if (!(at.distance <= width_allowed_) && is_miss_by_search(at.n)) return;
    apart = cso_.to_length(at.distance);
    n = at.n;
  }
  // Another axis proves that the path is free until toi_lower. This one separates there, and the path does not come
  // nearer along it: so the rest is free, too. One axis for both may need more digits than a double has.
  bool is_left_behind(const Vec3<double>& axis) {
    const double away = context_.rate(axis).low;
    if (!(away >= 0 &&
          context_.reach(axis, counters_) < proof.toi_lower * away * (1 - 4 * kUnitRoundoff<double>)))
      return false;
    outcome = Outcome::miss;
    lower = kInfinity<double>;
    return true;
  }
  [[nodiscard]] bool prove_later(const Vec3<double>& axis) {
    const double before = proof.toi_lower;
    prove_lower(context_, axis, false, proof, counters_);
    return proof.toi_lower > before;
  }
  // So near to C the direction to it is rounding, and a search may not converge. It searches at points of the path ever
  // farther before s. Its axis there may prove a later bound. C is no farther from s than the distance of C from that
  // point plus the way back.
  [[nodiscard]] bool looks_from_before(double s, Near& at) {
    const double speed = norm(context_.r) * (1 + 4 * kUnitRoundoff<double>);
    for (double before = width_allowed_ / 16 / speed; before < kFarBefore; before *= 2) {
      const Near there = near(s - before);
      at.distance = std::min(at.distance, there.distance + fl(before * speed));
      if (at.distance <= width_allowed_ || prove_later(there.n)) return true;
    }
    return false;
  }
  // Decides in exact arithmetic whether a start that is not proved to be free of contact is in contact. Returns true
  // if it is, or if the bodies are apart and stay so.
  bool settle_start() {
    if (proof.toi_lower > 0) return false;
    const ExactStart start = decide_start();
    if (start.is_contact()) {
      outcome = Outcome::initially_overlapping;
      lower = upper = 0;
      proof = {};
    } else if (start.kind == StartKind::apart && (!is_swept() || rate_along(start.n) >= 0)) {
      outcome = Outcome::miss;
      lower = upper = kInfinity<double>;
    }
    return outcome == Outcome::initially_overlapping || outcome == Outcome::miss;
  }
  [[nodiscard]] ExactStart decide_start() {
    return StartDecision<S>(a_, b_, cso_, target_distance_, budget_, counters_)();
  }
  // The sign of n.v.
  [[nodiscard]] int rate_along(const exact::Dyadic3& direction) const {
    const exact::Exact v = exact::Exact::of(wide(b_.displacement), wide(a_.displacement));
    return exact::dot(direction, v.x).sign();
  }
  // This concerns C without the target distance.
  [[nodiscard]] Start start_exactly() {
    const ExactStart start = decide_start();
    if (start.kind == StartKind::deep) return Start::enters;
    const bool known = start.kind == StartKind::touching || start.kind == StartKind::apart;
    if (!known || direction_of(start.n) == Vec3<double>::Zero()) return Start::open;
    if (rate_along(start.n) >= 0) return Start::leaves;
    return start.only_normal ? Start::enters : Start::open;
  }
  // The tie is open, and the bodies are within the width: what a caller needs who takes it for contact.
  void fill_open() {
    lower = std::min(proof.toi_lower, context_.t_max);
    proof.toi_lower = lower;
    // If the bodies touch, the search's direction between them may be noise. The best direction is the one along
    // which C extends least beyond the path, among those of points beside it as well.
    const Vec3<double> x = path_at(cso_.to_parameter(lower));
    double least = kInfinity<double>;
    Vec3<double> best = Vec3<double>::Zero();
    const auto try_direction = [&](const Vec3<double>& given) {
      if (!(given.cwiseAbs().maxCoeff() > 0)) return;
      const Vec3<double> e = unit(given);
      const double beyond =
          fl(context_.reach(e, counters_) * power_of_two(-cso_.length_exponent())) - dot(e, x);
      if (beyond < least) {
        least = beyond;
        best = e;
      }
    };
    for (const Vec3<double>& e : {n, portal.n, proof.axis}) try_direction(e);
    try_direction(Vec3<double>(x - cso_.middle()));
    // C may be flat, with its middle at x: then an axis of a body is across it.
    const bool has_none = !(least < kInfinity<double>);
    for (int i = 0; i < 3 && has_none; ++i) {
      for (const Side<double>* side : {&cso_.side_a(), &cso_.side_b()}) {
        try_direction(side->to_world(Vec3<double>::Unit(i)));
        try_direction(side->to_world(-Vec3<double>::Unit(i)));
      }
    }
    for (const double away : {0x1p-20, 0x1p-26}) {
      Simplex<double> simplex;
      try_direction(
          gjk_distance(cso_, Vec3<double>(x + away * best), simplex, 0.0, 0.0, budget_, counters_).n);
    }
    n = best;
  }

  // Not below the depth of the path over [0, t) in C, internal length, by the axis n.
  [[nodiscard]] double depth_before(const Vec3<double>& axis, double t) {
    if (!(axis.cwiseAbs().maxCoeff() > 0)) return kInfinity<double>;
    const Vec3<double> e = unit(axis);
    const double least = std::min(0.0, t * context_.rate(e).low * (1 + 4 * kUnitRoundoff<double>));
    const double h = context_.reach(e, counters_);
    return std::max(0.0, h - least) * (1 + 16 * kUnitRoundoff<double>)*power_of_two(-cso_.length_exponent());
  }
  [[nodiscard]] Near near(double s) {
    Simplex<double> simplex;
    const Vec3<double> x = path_at(s);
    Distance<double> d = gjk_distance(cso_, x, simplex, width_allowed_ / 64, 0.0, budget_, counters_);
    // GJK stalls at a rim or a line that almost lies in a face: then nearer points, and better axes.
    if (d.stalled && d.upper - d.lower > width_allowed_ / 8 && d.upper - cso_.radius() > width_allowed_ / 8) {
      const auto support = [&](const Vec3<double>& e) {
        CsoPoint<double> p = cso_.support(e);
        p.w -= x;
        return p;
      };
      for (CsoPoint<double>& p : simplex.point) p.w -= x;
      go_on(d, support, simplex, width_allowed_ / 64, counters_);
      if (d.upper - d.lower > width_allowed_ / 8)
        turn_axis(d, support, simplex, width_allowed_ / 64, counters_);
    }
    const double rounding =
        16 * kUnitRoundoff<double> * (cso_.extent() + cso_.radius()) + 4 * cso_.point_error();
    return {std::min(std::max(d.upper - cso_.radius(), 0.0), from_portal(x)) + rounding, d.n};
  }
  // The distance of x from the portal's triangle, all of it in C. On thin curved shapes GJK's is worse: so
  // near to C the direction to it is rounding, and the support point along it is off by the thin radius times
  // the angle's square.
  [[nodiscard]] double from_portal(const Vec3<double>& x) const {
    if (!portal.found) return kInfinity<double>;
    Simplex<double> triangle;
    for (const ProvedPoint& p : portal.p) {
      CsoPoint<double> corner;
      corner.w = rounded_once(p.point.w);
      triangle.add(corner);
    }
    return square_root(closest_to_origin(triangle, x).dist_sq);
  }

  // A hit is proved. Computes the width of its bracket and narrows it if necessary.
  void close() {
    const double speed = norm(context_.r) * (1 + 4 * kUnitRoundoff<double>);
    upper = std::min(cso_.to_time(portal.upper) * (1 + kUnitRoundoff<double>), context_.t_max);
    // If the path is in the plane of a face, the portal's bracket is as long as the face, and `upper` may lie past C.
    if (!((portal.upper - portal.least) * speed <= width_allowed_) &&
        !(near(cso_.to_parameter(upper)).distance <= width_allowed_)) {
      upper = kInfinity<double>;
      return;
    }
    const auto length_before = [&](double t) {
      return cso_.to_parameter(upper - t) * speed * (1 + 8 * kUnitRoundoff<double>);
    };
    double short_of = length_before(proof.toi_lower);  // not below the distance at toi_lower
    Vec3<double> steep = Vec3<double>::Zero();
    if (!(short_of <= width_allowed_)) {
      const Near at_lower = near(cso_.to_parameter(proof.toi_lower));
      short_of = at_lower.distance;
      steep = at_lower.n;
    }
    if (!(short_of <= width_allowed_)) short_of = nearer(steep);
    if (!(short_of <= width_allowed_)) {
      come_near();
      if (outcome == Outcome::miss) return;
      short_of = apart * power_of_two(-cso_.length_exponent());
    }
    n = portal.n;
    double deep = depth_before(n, upper);
    const auto try_axis = [&](const Vec3<double>& axis) {
      if (const double d = depth_before(axis, upper); d < deep) {
        deep = d;
        n = unit(axis);
      }
    };
    if (!(deep <= width_allowed_ / 8)) {
      try_axis(proof.axis);
      try_axis(steep);
    }
    // From C to a point of the line before contact, the path's or one behind its start.
    for (double before = width_allowed_ / norm(context_.r); !(deep <= width_allowed_) && before < kFarBefore;
         before *= 32) {
      try_axis(near(cso_.to_parameter(upper) - before).n);
    }
    lower = proof.toi_lower;
    apart = cso_.to_length(short_of);
    if (short_of <= width_allowed_ && deep <= width_allowed_) outcome = Outcome::hit;
    name_portal();
  }
  // Axes from C to points of the path, farther and farther before contact, until one is proved. Returns a
  // bound of the distance from C at the time proved.
  double nearer(Vec3<double>& steep) {
    double before = width_allowed_ / 8 / norm(context_.r);
    for (int i = 0; i < 64; ++i, before *= 2) {
      const double s = cso_.to_parameter(upper) - before;
      const Near there = near(std::max(s, 0.0));
      if (!(there.distance <= width_allowed_) || !(s > 0)) break;
      steep = there.n;
      if (prove_lower(context_, there.n, false, proof, counters_)) {
        const double t = proof.toi_lower;
        const Near proved = near(cso_.to_parameter(t));
        if (proved.distance <= width_allowed_) return proved.distance;
      }
    }
    // If the path meets the rim of a flat end, the axes from C to it are tilted by its distance from the rim. The
    // end's own normal is along one of the body's axes.
    for (const Side<double>* side : {&cso_.side_a(), &cso_.side_b()}) {
      for (int i = 0; i < 3; ++i) {
        const Vec3<double> own = side->to_world(Vec3<double>(Vec3<double>::Unit(i)));
        for (const Vec3<double>& axis : {own, Vec3<double>(-own)}) {
          const double before_it = proof.toi_lower;
          prove_lower(context_, axis, false, proof, counters_);
          if (proof.toi_lower > before_it) steep = axis;
        }
      }
    }
    return near(cso_.to_parameter(proof.toi_lower)).distance;
  }
  void name_portal() {
    if (!(portal.least >= 0)) return;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!portal.p[i].point.named) return;
      proof.portal[i] = portal.p[i].point.name;
    }
    proof.portal_size = 3;
    proof.toi_upper = upper;
  }

  // A path parameter: the root of the width, from which an axis is tilted by more than the width allows.
  static constexpr double kFarBefore = 1e-6;
  // The limit of come_near(): 40 halvings of the way lead from the scale to the width, and as many more are for
  // rounding that undoes some.
  static constexpr int kAdvances = 80;

  const Body<S>&a_, &b_;
  Cso<double> cso_;
  ProofContext<S> context_;
  Counters& counters_;
  NamedPoints<S> points_;
  double target_distance_;
  int budget_;
  bool wants_proof_;
  bool start_was_asked_ = false;  // and not shown
  double width_allowed_;          // internal length
};

template <Scalar S>
void pass_over_start(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                     CertifiedCast<S>& cast, CastResult<S>& out) {
  const bool in_contact = cast.outcome == Outcome::initially_overlapping;
  if (cast.outcome == Outcome::miss || cast.proof.toi_lower > 0) return;
  CertifiedCast<S> core(a, b, options, kInfinity<double>, 0, out.counters);
  const Start start = core.start();
  if (start == Start::enters) return;
  if (start == Start::leaves && in_contact) {
    out.passed_over = true;
    cast.outcome = Outcome::miss;
    cast.lower = cast.upper = kInfinity<double>;
    return;
  }
  // It is open whether the start is in contact, or whether it leaves. All that follows is then open too.
  cast.leave_open();
}

// Everything about the answer of the certified search, in the caller's scalar.
template <Scalar S>
void fill_certified(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CertifiedCast<S>& cast,
                    CastResult<S>& out) {
  if (options.start_policy == StartPolicy::pass_over) {
    pass_over_start(a, b, options, cast, out);
  }
  out.outcome = cast.outcome;
  out.toi_lower = cast.lower < kInfinity<double> ? time_down<S>(cast.lower) : kInfinity<S>;
  out.toi_upper = cast.outcome == Outcome::miss || !(cast.upper < kInfinity<double>)
                      ? kInfinity<S>
                      : std::min(time_up<S>(cast.upper), options.t_max);
  if (out.outcome == Outcome::hit || out.outcome == Outcome::not_converged) {
    // At the time as rounded down, v within 8 u of itself.
    const Vec3<double> v = wide(b.displacement) - wide(a.displacement);
    const double way = norm(v) * (cast.lower - static_cast<double>(out.toi_lower));
    out.distance = round_up<S>((cast.apart + way) * (1 + 0x1p-48));
    if (asks_for(options.request, Request::normal)) out.normal = cast.n.template cast<S>();
    if (asks_for(options.request, Request::witnesses)) {
      const auto at_lower = [&](const Body<S>& body, const Vec3<double>& x) -> Vec3<S> {
        return (x + double(out.toi_lower) * wide(body.displacement)).template cast<S>();
      };
      const auto contact = cast.contact();
      out.point_a = at_lower(a, contact.on_a);
      out.point_b = at_lower(b, contact.on_b);
    }
  }
  out.counters.iterations = out.counters.portal_steps + out.counters.gjk_iterations;
  if (asks_for(options.request, Request::proof) && !out.passed_over) {
    out.proof = under_policy(cast.proof, options.start_policy);
  }
}

// A fast or an exact answer with the proof of the certified search, if one is requested.
template <Scalar S>
void add_certified_proof(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                         CastResult<S>& out) {
  if (!asks_for(options.request, Request::proof) || out.passed_over) return;
  CertifiedCast<S> cast(a, b, options, static_cast<double>(options.t_max),
                        static_cast<double>(options.target_distance), out.counters);
  cast.run();
  if (cast.outcome == out.outcome) out.proof = under_policy(cast.proof, options.start_policy);
}

// The rung of the exact tier for rounded polytopes in the certified one. A number that outgrew its room is left to the
// certified search.
template <Scalar S>
bool exact_round_bracket(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                         CastResult<S>& out) {
  CastResult<S> exactly;
  if (!exact_round_cast(a, b, options, exactly) || exactly.invalid != Invalid::none) return false;
  out = exactly;
  return true;
}
// Rays: boxes and triangles exactly, and of the others what the clip leaves open.
template <Scalar S>
bool ray_bracket(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  if (kind_of(a, b, options.target_distance) == PairKind::polytopes) return ray_exact(a, b, options, out);
  if (ray_certified(a, b, options, out)) {
    add_certified_proof(a, b, options, out);
    return true;
  }
  CastResult<S> exactly;
  if (!is_solid_ray(a, b, options.target_distance) || !ray_exact(a, b, options, exactly) ||
      exactly.invalid != Invalid::none)
    return false;
  out = exactly;
  return true;
}
template <Scalar S>
bool curved_bracket(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  if (!curved_certified(a, b, options, out)) return false;
  add_certified_proof(a, b, options, out);
  return true;
}

// The certified search as a rung. It always answers. `open`: a fast search has not found a bracket that is proved, so
// contact is unlikely to be decided by its portals. A tie of rounded polytopes is decided by the exact tier.
template <bool open, Scalar S>
bool certified_search(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  CertifiedCast<S> cast(a, b, options, static_cast<double>(options.t_max),
                        static_cast<double>(options.target_distance), out.counters);
  open ? cast.run_open() : cast.run();
  if constexpr (!open) {
    CastResult<S> exactly;
    if (cast.outcome == Outcome::not_converged && exact::is_exact(a.shape, true) &&
        exact::is_exact(b.shape, true) && exact_round_cast(a, b, options, exactly) &&
        exactly.invalid == Invalid::none) {
      out = exactly;
      return true;
    }
  }
  fill_certified(a, b, options, cast, out);
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
