// Decides exactly: nothing.
// Brackets only: separations, distances and depths at a time, separations over a slice.
// Costs: 20 microseconds a separation of two placed boxes at 192 bits, 5 to 500 to find an axis.
// Cannot be trusted: it can. A contact closer than `fine` stays open.
#include "oracles/curved/rotating_pair.hpp"

#include <cmath>

#include "oracles/curved/axis_guess.hpp"

namespace graze::oracle {
namespace {

// Any direction in general position serves. Its length is far below the resolution, so that ties do not
// arise.
BallVec shift_for(const Ball& fine) {
  return ((fine * Ball(0x1p-10)) * BallVec(Vec3<double>(0.53771, -0.31883, 0.75213))).mid();
}

BallVec unit_ball(const Vec3<double>& n) {
  const BallVec exact(n);
  return (Ball(1) / norm(exact)) * exact;
}

Vec3<double> unit_double(const BallVec& n) {
  const Ball length = norm(n);
  return length.is_positive() ? ((Ball(1) / length) * n).mid_double() : Vec3<double>::Zero();
}

}  // namespace

RotatingPair::RotatingPair(const corpus::Case& problem)
    : shape_a_(problem.a.shape),
      shape_b_(problem.b.shape),
      target_(problem.target_distance),
      a_(problem.a, problem.spin_a, problem.a.position),
      b_(problem.b, problem.spin_b, problem.a.position) {
  const PairPose start = at(0);
  std::array<BallVec, 2> low, high;
  for (std::size_t i = 0; i < 2; ++i) {
    const BallMotion::Pose& pose = i == 0 ? start.a : start.b;
    const auto reach = [&](double x, double y, double z) {
      return pose.support(BallVec(Vec3<double>(x, y, z))).reach;
    };
    low[i] = {-reach(-1, 0, 0), -reach(0, -1, 0), -reach(0, 0, -1)};
    high[i] = {reach(1, 0, 0), reach(0, 1, 0), reach(0, 0, 1)};
  }
  const BallVec between = Ball(0.5) * ((low[1] + high[1]) - (low[0] + high[0]));
  scale_ = max(max(norm(high[0] - low[0]), norm(high[1] - low[1])), norm(between)).high();
  const double size = scale_.mid_double();
  exponent_ = size > 0 && std::isfinite(size) ? std::ilogb(size) : 0;
  turned_a_ = turned_body(a_);
  turned_b_ = turned_body(b_);
}

Ball RotatingPair::separation(const BallVec& n, const PairPose& pose) const {
  const Ball across = -pose.b.support(-n).reach - pose.a.support(n).reach;
  return (across / norm(n) - target_).low();
}

namespace {

ConvexSet difference(double target, std::function<BallSupport(const BallVec&)> a,
                     std::function<BallSupport(const BallVec&)> b) {
  return [target, a = std::move(a), b = std::move(b)](const BallVec& n) {
    const BallSupport from_a = a(n), from_b = b(-n);
    CsoPoint p;
    p.a = from_a.point;
    p.b = from_b.point;
    p.point = from_a.point - from_b.point;
    p.reach = from_a.reach + from_b.reach;
    if (target > 0) {
      const Ball length = norm(n);
      p.reach += target * length;
      if (length.is_positive()) p.point = p.point + (Ball(target) / length) * n;
    }
    return p;
  };
}

}  // namespace

ConvexSet RotatingPair::set(const PairPose& pose) const {
  return difference(
      target_, [&pose](const BallVec& n) { return pose.a.support(n); },
      [&pose](const BallVec& n) { return pose.b.support(n); });
}

Ball RotatingPair::bound(const BallVec& axis, const PairPose& from, const Ball& to, Turning turning) const {
  switch (turning) {
    case Turning::world:
      return a_.second_bound(axis) + b_.second_bound(axis);
    case Turning::with_a:
      return second_bound_turning(a_, b_, from.a.turn_back(axis), from.t, to);
    case Turning::with_b:
      return second_bound_turning(b_, a_, from.b.turn_back(axis), from.t, to);
  }
  return {};
}

Turning RotatingPair::steadiest(const BallVec& axis, const PairPose& from, const Ball& to) const {
  Turning best = Turning::world;
  Ball least = bound(axis, from, to, best);
  for (const Turning turning : {Turning::with_a, Turning::with_b}) {
    if (!(turning == Turning::with_a ? a_ : b_).turns()) continue;
    const Ball other = bound(axis, from, to, turning);
    if (mid_less(other, least)) {
      least = other;
      best = turning;
    }
  }
  return best;
}

BallVec RotatingPair::turned(const BallVec& axis, const PairPose& from, const PairPose& to,
                             Turning turning) const {
  if (turning == Turning::with_a) return to.a.turn(from.a.turn_back(axis));
  if (turning == Turning::with_b) return to.b.turn(from.b.turn_back(axis));
  return axis;
}

SliceBound RotatingPair::over(const Vec3<double>& axis, bool at_end, Turning turning, const PairPose& from,
                              const PairPose& to) const {
  const BallVec n = unit_ball(axis);
  const BallVec first = at_end ? turned(n, to, from, turning) : n;
  const BallVec last = at_end ? n : turned(n, from, to, turning);
  return {separation(first, from), separation(last, to), bound(first, from, to.t, turning), to.t - from.t};
}

Nearest3 RotatingPair::distance(const PairPose& pose, const Ball& fine, double relative) const {
  return nearest(set(pose), shift_for(fine), {.absolute = fine, .relative = relative});
}

Nearest3 RotatingPair::distance_from_body(char body, const PairPose& pose, const BallVec& point,
                                          const Ball& fine, double relative) const {
  const BallMotion::Pose& placed = body == 'a' ? pose.a : pose.b;
  const ConvexSet set = [&](const BallVec& n) {
    const BallSupport s = placed.support(n);
    CsoPoint p;
    p.point = s.point - point;
    p.reach = s.reach - dot(n, point);
    return p;
  };
  return nearest(set, shift_for(fine), {.absolute = fine, .relative = relative});
}

Contact RotatingPair::contact(const PairPose& pose, const Vec3<double>& start, const Ball& fine,
                              const Ball& near, double slack) const {
  const PlacedShapes placed{
      shape_a_, shape_b_, pose.a.frame(), pose.b.frame(), (pose.b.origin() - pose.a.origin()).mid_double(),
      target_,  exponent_};
  const AxisGuess guess = guess_axis(placed, start);
  Contact result;
  if (guess.apart) {
    const Ball shown = separation(BallVec(guess.axis), pose);
    if (mid_less(near, shown) && mid_less(Ball(0.5 * guess.upper), shown)) {
      result.kind = Contact::Kind::apart;
      result.axis = guess.axis;
      result.lower = shown;
      arb_pos_inf(result.upper.get());
      return result;
    }
  }
  // The axis along which the origin is least deep, of those that the search tries.
  Ball least_depth_seen;
  BallVec shallow;
  const ConvexSet placed_set = set(pose);
  const ConvexSet k = [&](const BallVec& n) {
    CsoPoint p = placed_set(n);
    const Ball length = norm(n);
    if (length.is_positive()) {
      const Ball depth = p.reach / length;
      if (shallow.is_zero() || mid_less(depth, least_depth_seen)) {
        least_depth_seen = depth;
        shallow = n;
      }
    }
    return p;
  };
  const auto shows_apart = [&](const Nearest3& found) {
    if (!found.lower.is_positive()) return false;
    const Vec3<double> n = unit_double(found.axis);
    const Ball shown = separation(BallVec(n), pose);
    if (!shown.is_positive()) return false;
    result.kind = Contact::Kind::apart;
    result.axis = n;
    result.lower = shown;
    return true;
  };
  Nearest3 found = nearest(k, shift_for(fine), {.absolute = Ball(0.125) * fine, .relative = Ball(0.125)});
  result.upper = found.upper;
  result.depth = found.least_reach;
  if (shows_apart(found)) return result;
  // As near as that, a search that ends at no distance tells on which side the origin is.
  if (!found.around) {
    found = nearest(k, shift_for(fine), {.until_separated = true});
    result.depth = min(result.depth, found.least_reach);
    if (shows_apart(found)) return result;
  }
  result.axis = unit_double(shallow);
  if (!found.around) return result;
  const Depth3 inside =
      least_depth(k, found.inner.points, {.absolute = Ball(0.125) * fine, .relative = slack / (1 + slack)});
  result.axis = unit_double(inside.axis);
  result.depth = inside.upper;
  if (!inside.lower.is_positive()) return result;
  result.kind = Contact::Kind::overlapping;
  result.lower = inside.lower;
  return result;
}

// Supports in 16 directions e around the axis: a point x of the shape has |x across the axis| cos(angle to
// the nearest e) <= h(e), and that angle is at most pi / 16.
RotatingPair::Turned RotatingPair::turned_body(const BallMotion& body) {
  constexpr int kAround = 16;
  Turned turned;
  if (!body.turns()) return turned;
  const BallVec& w = body.rotation();
  turned.axis = (Ball(1) / norm(w)) * w;
  const BallMotion::Pose start = body.at(0);
  const auto reach = [&](const BallVec& n) { return start.support(n).reach - dot(n, body.pivot()); };
  turned.high = reach(turned.axis).high();
  turned.low = (-reach(-turned.axis)).low();
  const Vec3<double> a = turned.axis.mid_double();
  int least = 0;
  a.cwiseAbs().minCoeff(&least);
  BallVec e = cross(turned.axis, BallVec(Vec3<double>::Unit(least)));
  e = (Ball(1) / norm(e)) * e;
  Ball sixteenth, cosine;
  arb_const_pi(sixteenth.get(), WorkingPrecision::bits());
  sixteenth /= Ball(kAround);
  arb_cos(cosine.get(), sixteenth.get(), WorkingPrecision::bits());
  const BallRotation step((Ball(2) * sixteenth) * turned.axis);
  for (int i = 0; i < kAround; ++i) {
    turned.radius = max(turned.radius, reach(e) / cosine).high();
    e = step.apply(e);
  }
  return turned;
}

BallSupport RotatingPair::turned_support(const BallMotion& body, const Turned& turned, const BallVec& n,
                                         const Ball& t) const {
  const BallVec pivot = body.pivot() + t * body.velocity();
  if (!body.turns()) {
    BallSupport s = body.at(0).support(n);
    const BallVec way = t * body.velocity();
    return {s.reach + dot(n, way), s.point + way};
  }
  const Ball along = dot(n, turned.axis);
  const BallVec across = n - along * turned.axis;
  const Ball length = norm(across);
  BallSupport s{dot(n, pivot) + max(along * turned.high, along * turned.low) + turned.radius * length,
                pivot + (along.mid_sign() < 0 ? turned.low : turned.high) * turned.axis};
  if (length.is_positive()) s.point = s.point + (turned.radius / length) * across;
  return s;
}

Ball RotatingPair::turned_separation(const BallVec& n, const Ball& t) const {
  const Ball across = -turned_support(b_, turned_b_, -n, t).reach - turned_support(a_, turned_a_, n, t).reach;
  return (across / norm(n) - target_).low();
}

Nearest3 RotatingPair::turned_distance(const Ball& t, const Ball& fine, double relative) const {
  const ConvexSet set = difference(
      target_, [&](const BallVec& n) { return turned_support(a_, turned_a_, n, t); },
      [&](const BallVec& n) { return turned_support(b_, turned_b_, n, t); });
  return nearest(set, shift_for(fine), {.absolute = fine, .relative = relative});
}

}  // namespace graze::oracle
