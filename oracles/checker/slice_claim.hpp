// The slice claim of a rotating proof, in balls: its axis keeps the bodies apart at every time of the slice.
//
// With s(t) = min over B(t) of n(t).b - max over A(t) of n(t).a and M a bound on how fast the slope of any
// point's n(t).x(t) changes, s lies at most M (t - t_0)(t_1 - t)/2 below its chord on [t_0, t_1].
// ball_motion.hpp proves it. In the frame of a body the points are taken relative to the path of its pivot,
// which cancels in s. The slice requires s - m |n| > 0. Along an axis of the world the speed of the points
// gives a second bound, which is stronger for a slice of very many radians. A piece that both bounds leave
// open is cut in the middle. Near a contact at t* that the bodies approach with a speed, halves as short as
// t* - t suffice, so the number of pieces grows only with the logarithm of the gap.
//
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include <utility>
#include <vector>

#include "oracles/checker/check_rotating_proof.hpp"
#include "oracles/checker/pair_motion.hpp"

namespace graze::oracle {

enum class SliceFinding { holds, is_false, open, too_many_pieces };

struct SliceAnswer {
  SliceFinding finding = SliceFinding::holds;
  double at = 0;      // is_false, open: a time where s - m |n| is not positive, or not known to be
  double excess = 0;  // about s - m |n| there
};

class SliceClaim {
 public:
  SliceClaim(const PairMotion& motion, const TimeSlice& slice, double begin, RotatingCheckCost& cost)
      : motion_(motion),
        n_(slice.axis),
        frame_(slice.frame),
        margin_(motion.target_distance * norm(n_)),
        bound_(bound(begin, slice.end)),
        cost_(cost) {}

  [[nodiscard]] SliceAnswer prove(const PairInstant& begin, const PairInstant& end) const {
    const Ball first = excess(begin), last = excess(end);
    if (!first.is_positive()) return not_positive(begin.t, first);
    if (!last.is_positive()) return not_positive(end.t, last);
    if (!holds(begin.t, end.t, first, last) && holds_by_whole_turns(begin, end)) return {};
    struct Piece {
      double begin, end;
      Ball first, last;
    };
    std::vector<Piece> open;
    open.push_back({begin.t, end.t, first, last});
    for (int pieces = 1; !open.empty();) {
      const Piece piece = std::move(open.back());
      open.pop_back();
      if (holds(piece.begin, piece.end, piece.first, piece.last)) continue;
      const double middle = piece.begin + (piece.end - piece.begin) / 2;
      if (!(piece.begin < middle && middle < piece.end) || ++pieces > kMostPieces)
        return {SliceFinding::too_many_pieces, piece.begin, piece.first.mid_double()};
      ++cost_.pieces;
      const Ball between = excess(PairInstant(motion_, middle));
      if (!between.is_positive()) return not_positive(middle, between);
      open.push_back({middle, piece.end, between, piece.last});
      open.push_back({piece.begin, middle, piece.first, between});
    }
    return {};
  }

 private:
  // s - m |n|
  [[nodiscard]] Ball excess(const PairInstant& now) const {
    const BallVec n = frame_ == AxisFrame::a ? now.a.turn(n_) : frame_ == AxisFrame::b ? now.b.turn(n_) : n_;
    return -(now.a.support(n).reach + now.b.support(-n).reach) - margin_;
  }

  // M_A + M_B over [begin, end].
  [[nodiscard]] Ball bound(double begin, double end) const {
    switch (frame_) {
      case AxisFrame::world:
        return motion_.second_bound(n_);
      case AxisFrame::a:
        return second_bound_turning(motion_.a, motion_.b, n_, begin, end);
      case AxisFrame::b:
        break;
    }
    return second_bound_turning(motion_.b, motion_.a, n_, begin, end);
  }

  [[nodiscard]] bool holds(double begin, double end, const Ball& first, const Ball& last) const {
    if (begin == end) return true;
    const Ball d = Ball(end) - Ball(begin);
    if (chord_stays_positive(first, last, bound_, d)) return true;
    if (frame_ != AxisFrame::world) return false;
    const Ball turning = motion_.first_bound(n_),
               moving = dot(n_, motion_.b.velocity() - motion_.a.velocity());
    return slopes_stay_positive(first, last, turning - moving, turning + moving, d);
  }

  // One body, or both, at all angles at once. Only the rotation of the other one bends the separation.
  [[nodiscard]] bool holds_by_whole_turns(const PairInstant& begin, const PairInstant& end) const {
    if (frame_ != AxisFrame::world) return false;
    for (const auto& [a, b] : {std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
      if ((a && !motion_.swept_a) || (b && !motion_.swept_b)) continue;
      const auto excess_at = [&, a = a, b = b](const PairInstant& now) {
        const Ball of_a =
            a ? motion_.swept_a->reach(motion_.a, n_, now.t, begin.t, end.t) : now.a.support(n_).reach;
        const Ball of_b =
            b ? motion_.swept_b->reach(motion_.b, -n_, now.t, begin.t, end.t) : now.b.support(-n_).reach;
        return -(of_a + of_b) - margin_;
      };
      const Ball bound =
          (a ? Ball(0) : motion_.a.second_bound(n_)) + (b ? Ball(0) : motion_.b.second_bound(n_));
      const Ball first = excess_at(begin), last = excess_at(end);
      if (first.is_positive() && last.is_positive() &&
          chord_stays_positive(first, last, bound, Ball(end.t) - Ball(begin.t)))
        return true;
    }
    return false;
  }

  [[nodiscard]] static SliceAnswer not_positive(double t, const Ball& excess) {
    const bool no = certainly_at_most(excess, Ball(0));
    return {no ? SliceFinding::is_false : SliceFinding::open, t, excess.mid_double()};
  }

  const PairMotion& motion_;
  BallVec n_;
  AxisFrame frame_;
  Ball margin_;  // m |n|
  Ball bound_;   // M_A + M_B
  RotatingCheckCost& cost_;
};

}  // namespace graze::oracle
