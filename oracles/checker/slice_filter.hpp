// A slice of a rotating proof in double with running error bounds (filtered.hpp). It is proved here, or left
// to the balls of slice_claim.hpp.
//
// Notation   u = w/|w|, the axis of a body's rotation,   theta = |w| t,   arm = R(orientation) pivot.
//   R(t) n = cos n + sin u x n + (1 - cos)(u.n) u, and R(t)^-1 n by -sin. cos and sin are balls rounded once.
//   max over X(t) of n.x = h(R^-1 n) - (R^-1 n).arm + n.(position + arm + t v), h that of the shape about its
//   position (tree_support.hpp). Only the difference of the two positions is taken, of exact doubles.
// The bounds of derivatives are those that ball_motion.cpp derives, without the ones for a shape of
// revolution about its own axis. If they do not suffice, the bound of second derivatives is computed as a
// ball. For the oracles' own .cpp files (it includes Arb).
#pragma once

#include "oracles/checker/tree_support.hpp"
#include "oracles/curved/ball_motion.hpp"

namespace graze::oracle {

// A double within a running error of every number in the ball. The radius of a ball is an m 2^e of 30 bits,
// so a double holds it, or rounds it up where it is subnormal or smaller.
[[nodiscard]] inline Filtered filtered(const Ball& x) {
  const double v = x.mid_double();
  const double error =
      mag_get_d(arb_radref(x.get())) + 2 * kUnitRoundoff<double> * std::abs(v) + Filtered::kTiny;
  return {v, std::abs(v) < kInfinity<double> ? error * Filtered::kUp : kInfinity<double>};
}
[[nodiscard]] inline Triple<Filtered> filtered(const BallVec& x) {
  return {filtered(x.x), filtered(x.y), filtered(x.z)};
}

class SliceFilter {
 public:
  // The trees and the motions live as long.
  SliceFilter(const corpus::Case& problem, const PartTree& tree_a, const PartTree& tree_b,
              const BallMotion& a, const BallMotion& b)
      : a_(tree_a, a, problem.a.orientation),
        b_(tree_b, b, problem.b.orientation),
        between_(difference<Filtered>(problem.b.position, problem.a.position) + (b_.arm - a_.arm)),
        velocity_(difference<Filtered>(problem.b.displacement, problem.a.displacement)),
        target_distance_(problem.target_distance),
        common_(CommonTurn::of(a, b)) {}

  // How far a body has turned.
  struct Turn {
    Filtered cos{1}, sin{0};
  };
  struct Instant {
    double t = 0;
    Turn a, b;
  };
  [[nodiscard]] Instant at(double t) const { return {t, a_.turn(t), b_.turn(t)}; }

  // Is the slice proved on [begin, end], whole or in at most `most` pieces? Their number is added to
  // `pieces`.
  [[nodiscard]] bool proves(const TimeSlice& slice, const Instant& begin, const Instant& end, int most,
                            long long& pieces) {
    const Triple<Filtered> n = triple<Filtered>(slice.axis);
    const Filtered length = root(dot(n, n));
    const Piece whole{begin.t, end.t, low(excess(slice.frame, n, length, begin)),
                      low(excess(slice.frame, n, length, end))};
    ++pieces;
    if (!(whole.first > 0 && whole.last > 0)) return false;
    if (begin.t == end.t) return true;
    Slopes slopes{.bend = high(this->bound(slice.frame, n, length, begin.t, end.t))};
    if (stays_positive(whole, slopes)) return true;
    if (slice.frame == AxisFrame::world) {
      const Filtered turning = speed(n), moving = dot(n, velocity_);
      slopes.falls = top(turning - moving);
      slopes.rises = top(turning + moving);
      const BallVec axis(slice.axis);
      slopes.bend =
          std::min(slopes.bend, (a_.motion.second_bound(axis) + b_.motion.second_bound(axis)).high_double());
      if (common_) {
        slopes.bend = std::min(slopes.bend, common_->second_bound(axis).high_double());
        const Filtered least = filtered(common_->first_bound(axis));
        slopes.falls = std::min(slopes.falls, top(least - moving));
        slopes.rises = std::min(slopes.rises, top(least + moving));
      }
    }
    open_.assign(1, whole);
    for (int cuts = 1; !open_.empty();) {
      const Piece piece = open_.back();
      open_.pop_back();
      if (stays_positive(piece, slopes)) continue;
      const double middle = piece.begin + (piece.end - piece.begin) / 2;
      if (!(piece.begin < middle && middle < piece.end) || ++cuts > most) return false;
      ++pieces;
      const double between = low(excess(slice.frame, n, length, at(middle)));
      if (!(between > 0)) return false;
      open_.push_back({middle, piece.end, between, piece.last});
      open_.push_back({piece.begin, middle, piece.first, between});
    }
    return true;
  }

 private:
  struct Side {
    const PartTree& tree;
    const BallMotion& motion;
    std::vector<Scan> scans;
    bool turns;
    Ball rate_ball;
    Filtered rate, axis_reach, pivot_reach;
    Triple<Filtered> rotation, unit, arm;

    // The turn is the motion's own: it says what pivot the body has.
    Side(const PartTree& tree_, const BallMotion& motion_, const Quaternion<double>& orientation)
        : tree(tree_),
          motion(motion_),
          scans(tree.size()),
          turns(motion.turns()),
          rate_ball(norm(motion.rotation())),
          rate(filtered(rate_ball)),
          axis_reach(filtered(motion.axis_reach())),
          pivot_reach(filtered(motion.pivot_reach())),
          rotation(triple<Filtered>(motion.spin().rotation)),
          unit(triple<Filtered>(Vec3<double>::Zero())),
          arm(triple<Filtered>(motion.spin().pivot)) {
      if (turns) unit = filtered((Ball(1) / rate_ball) * motion.rotation());
      if (orientation.is_identity()) return;
      const Frame<Filtered> frame(true, scaled_to_one(orientation));
      arm = frame.apply(motion.spin().pivot);
      arm = {arm.x / frame.weight, arm.y / frame.weight, arm.z / frame.weight};
    }

    [[nodiscard]] Turn turn(double t) const {
      if (!turns) return {};
      Ball angle = rate_ball, c, s;
      angle *= Ball(t);
      arb_sin_cos(s.get(), c.get(), angle.get(), kBits);
      return {filtered(c), filtered(s)};
    }
    [[nodiscard]] Triple<Filtered> turned(const Turn& turn, const Filtered& sin,
                                          const Triple<Filtered>& n) const {
      if (!turns) return n;
      return scaled(turn.cos, n) + scaled(sin, cross(unit, n)) +
             scaled((Filtered(1) - turn.cos) * dot(unit, n), unit);
    }
    // max over X(t) of n.x less n.(position + arm + t v), by m = R^-1 n.
    [[nodiscard]] Filtered reach(const Triple<Filtered>& m, const Filtered& length) {
      return TreeSupport<Filtered>(tree, scans)(m, length).value - dot(m, arm);
    }
  };

  // With lower bounds of the excess at its ends.
  struct Piece {
    double begin, end, first, last;
  };

  // Bits of sines and cosines. The angle is known to 128 bits.
  static constexpr long kBits = 80;

  [[nodiscard]] static double low(const Filtered& x) { return (x.value() - x.error()) * (1 - 0x1p-50); }
  [[nodiscard]] static double high(const Filtered& x) {
    return (std::abs(x.value()) + x.error()) * Filtered::kUp;
  }
  // Upper bound of a number of either sign, kept from vanishing.
  [[nodiscard]] static double top(const Filtered& x) {
    const double most = x.value() + x.error();
    return most + 0x1p-50 * (std::abs(x.value()) + x.error()) + 0x1p-900;
  }

  // Upper bounds over a slice: M, and how fast s falls and rises.
  struct Slopes {
    double bend, falls = kInfinity<double>, rises = kInfinity<double>;
  };

  // By (sqrt s0 + sqrt s1)^2 > d^2 M / 2, or s0 / f + s1 / r > d (ball_motion.hpp has both). Each side has
  // fewer than 10 roundings, which 2^-40 covers. M is kept from vanishing.
  [[nodiscard]] static bool stays_positive(const Piece& piece, const Slopes& slopes) {
    const double d = piece.end - piece.begin, roots = std::sqrt(piece.first) + std::sqrt(piece.last);
    const double most = std::max(slopes.bend, 0x1p-900);
    if (d * (d * (most / 2)) * (1 + 0x1p-40) + Filtered::kTiny < roots * roots * (1 - 0x1p-40)) return true;
    return slopes.falls <= 0 || slopes.rises <= 0 ||  // NaN: neither
           piece.first / slopes.falls + piece.last / slopes.rises > d * (1 + 0x1p-40) + Filtered::kTiny;
  }

  // min over B(t) of n(t).b - max over A(t) of n(t).a - m |n|
  [[nodiscard]] Filtered excess(AxisFrame frame, const Triple<Filtered>& axis, const Filtered& length,
                                const Instant& now) {
    const Triple<Filtered> n = frame == AxisFrame::a   ? a_.turned(now.a, now.a.sin, axis)
                               : frame == AxisFrame::b ? b_.turned(now.b, now.b.sin, axis)
                                                       : axis;
    const Triple<Filtered> in_a = frame == AxisFrame::a ? axis : a_.turned(now.a, -now.a.sin, n);
    const Triple<Filtered> in_b = frame == AxisFrame::b ? axis : b_.turned(now.b, -now.b.sin, n);
    const Filtered apart = dot(n, between_ + scaled(Filtered(now.t), velocity_));
    const Filtered s = apart - (a_.reach(in_a, length) + b_.reach(-in_b, length));
    return target_distance_ > 0 ? s - length * target_distance_ : s;
  }

  // How fast n.x changes by the bodies' turns, n fixed in the world.
  [[nodiscard]] Filtered speed(const Triple<Filtered>& n) const {
    Filtered sum(0);
    for (const Side* x : {&a_, &b_})
      if (x->turns) sum = sum + norm(cross(n, x->rotation)) * x->axis_reach;
    return sum;
  }

  [[nodiscard]] Filtered bound(AxisFrame frame, const Triple<Filtered>& n, const Filtered& length,
                               double begin, double end) const {
    if (frame == AxisFrame::world) {
      Filtered sum(0);
      for (const Side* x : {&a_, &b_})
        if (x->turns) sum = sum + x->rate * norm(cross(n, x->rotation)) * x->axis_reach;
      return sum;
    }
    const Side &x = frame == AxisFrame::a ? a_ : b_, &y = frame == AxisFrame::a ? b_ : a_;
    const auto swing = [&](double t) {
      return norm(cross(x.rotation, between_ + scaled(Filtered(t), velocity_)));
    };
    const Filtered relative = norm(y.rotation - x.rotation);
    const Filtered across = norm(cross(n, x.rotation));
    return length * relative * y.rate * y.axis_reach +
           across * (relative * y.pivot_reach + norm(velocity_) * 2.0 + max(swing(begin), swing(end)));
  }

  [[nodiscard]] static Filtered norm(const Triple<Filtered>& x) { return root(dot(x, x)); }
  [[nodiscard]] static Ball norm(const BallVec& x) { return oracle::norm(x); }

  Side a_, b_;
  std::vector<Piece> open_;
  Triple<Filtered> between_;  // of the pivots' paths at t = 0, B's less A's
  Triple<Filtered> velocity_;
  double target_distance_;
  std::optional<CommonTurn> common_;
};

}  // namespace graze::oracle
