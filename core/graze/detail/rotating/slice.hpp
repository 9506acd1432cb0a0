// A slice of time that one axis proves free of contact: how long can it be?
//
// Lengths: internal; n unit, world axes, from A to B. The gap along n at time t is s(t) = min over B of n.b -
// max over A of n.a, less the target distance; positive: apart. From a time t_0 with the bodies apart, either
//   conservative:  s(t) >= s_0 - L (t - t_0), L = -n.v + sum |n x w| rho (mobility.hpp), so the slice is
//                  s_0 / L long; or along an axis that turns with a body, L how fast the other's points move
//                  in its axes (moving_pair.hpp);
//   bilateral:     every point's n.x(t) stays within M (t - t_0)(t_1 - t)/2 of its chord, M the sum of the
//                  accelerations, so s(t) is above the chord of s_0 and s_1 less that, and positive on all of
//                  [t_0, t_1] iff sqrt(s_0) + sqrt(s_1) > (t_1 - t_0) sqrt(M/2).
// [Mirtich 1996; Catto, Continuous Collision, GDC 2013, whose bilateral advancement asks for s_1 > 0 only.]
//   along an axis that moves: evenly from n_0 at t_0 to n_1 at t_1. It is no longer than 1 in between, and n(t).x(t)
//                  bends by 2 |n'| times the speed more. So the gap at either end is that of its own best axis: it is
//                  the distance itself where line meets line, or a rim a face, and no one axis serves both ends. A
//                  proof has no name for such an axis.
//
// Where the bilateral t_1 is looked for, in this order: a little before the root of the distance itself, by
// the secant of its last two values, with the axis found there (where a face turns, an old axis is good for a
// part of the way only, the new one for all of it); else along the old axis, as far as M allows or towards
// the first root of s, by the secant, in the frame that lets points bend least, or in another; else the same
// with the cylinder that a body sweeps in a whole turn (whole_turns.hpp). What no try proves becomes a
// conservative slice. No root finder can stall, and none is believed.
#pragma once

#include <graze/detail/rotating/arc.hpp>
#include <graze/detail/rotating/nearest.hpp>
#include <graze/detail/rotating/whole_turns.hpp>
#include <optional>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

enum class Advance { conservative, bilateral };

struct MarchLimits {
  Advance advance = Advance::bilateral;
  double begin = 0, end = 1;  // a contact that is passed over has ended at `begin`
  double stop = 0;            // a gap that axes cannot close
  double width = 0;           // how far from contact either end of the bracket may be, where that is more
  double touching = -1;       // bodies with no more distance are in contact; below 0: only what is proved
  bool proves_later = false;  // `touching` is about the start alone
  int budget = 0;             // support evaluations
  bool record = false;        // keep the chain
  bool asks_start = false;    // a start that stays open ends the march, for its caller to decide
  WholeTurns may_sweep{true, true};  // whole_turns.hpp
};

struct Slice {
  double end = 0;
  Vec3<double> axis = Vec3<double>::Zero();  // as a proof names it: at t = 0, where it turns
  AxisFrame frame = AxisFrame::world;
  double expected = 0;           // the gap at the end is no less
  std::optional<Nearest> there;  // at the end, where it is known
};

// A time, and how far apart the bodies are then.
struct Seen {
  double t = 0;
  Nearest near;
};

// The last double that is not later than t + h. Near contact a step is a few units in the last place of t.
inline double not_after(double t, double h) {
  GRAZE_ASSERT(h >= 0);
  const double end = t + h;
  return end - t > h ? std::nextafter(end, t) : end;
}

// What failed is tried ever more seldom: the next try waits for about as many turns as there were failures.
class Patience {
 public:
  [[nodiscard]] bool waits() { return --wait_ > 0; }
  void fail() { wait_ = failures_ = std::min(2 * failures_ + 1, 64); }
  void succeed() { failures_ = 0; }

 private:
  int wait_ = 0, failures_ = 0;
};

class SliceSearch {
 public:
  SliceSearch(MovingPair& pair, const MarchLimits& limits, Counters& counters)
      : pair_(pair),
        limits_(limits),
        counters_(counters),
        records_(limits.record),
        speed_in_a_(pair.relative_speed(AxisFrame::a, limits.end)),
        speed_in_b_(pair.relative_speed(AxisFrame::b, limits.end)) {}

  // What follows is part of no proof, so that bounds that a proof has no name for serve as well.
  void stop_recording() { records_ = false; }

  // now.near.gap > 0. Leaves the pair placed anywhere.
  Slice operator()(const Seen& now, const std::optional<Seen>& before) {
    GRAZE_ASSERT(now.near.gap > 0 && now.t >= 0 && now.t <= limits_.end);
    ++slices_;
    Slice out;
    const double rest = limits_.end - now.t, safe = conservative(now, out);
    if (limits_.advance == Advance::conservative || safe >= rest) return out;
    if (towards_contact(now, before, safe, out)) return out;
    // Where a face turns, an axis that turns with it may prove much more than the steadiest one.
    const std::array<Frame, 3> all = frames(now.near.n);
    for (const Frame& frame : all) {
      const double longest = out.end - now.t;
      if (!(std::min(rest, 2 * std::sqrt(now.near.gap) / frame.bend_root) > kWorthTrying * longest)) continue;
      place(now.t);
      const Vec3<double> own = pair_.to_own(frame.of, now.near.n);
      along_axis(Along{now.t, own, now.near.gap - pair_.frame_error(frame.of), frame, {}}, longest, out);
    }
    by_two_axes(now, out);
    by_arc(now, out);
    by_whole_turns(now, out);
    return out;
  }

  // Is the gap along n, in the frame that lets points bend least or with a spinning body as what it sweeps, above
  // `least` from t to the end?
  bool keeps_above(double t, const Vec3<double>& n, double least) {
    const double rest = limits_.end - t;
    const auto above = [&](const Along& along) {
      const auto gap = [&](double at) {
        pair_.place(at);
        const Vec3<double> axis = pair_.to_world(along.frame.of, along.own);
        return along.whole.any() ? swept_gap(pair_, along.whole, axis, counters_)
                                 : pair_.gap(axis, counters_) - pair_.frame_error(along.frame.of);
      };
      return proves(rest, gap(t) - least, gap(limits_.end) - least, along.frame.bend_root);
    };
    const Frame steadiest = frames(n)[0];
    place(t);
    if (above({t, pair_.to_own(steadiest.of, n), 0, steadiest, {}})) return true;
    const WholeTurns whole = swept_in(rest, 0);
    return whole.any() && above({t, n, 0, still(whole, n), whole});
  }

  // How fast the closest points near each other: the derivative of the distance, while the features stay. A guess.
  double approach(const Seen& now) {
    place(now.t);
    const Cso<double>& cso = pair_.cso();
    const auto& side_b = cso.side_b();
    const Simplex<double>& closest = now.near.simplex;
    Vec3<double> b = Vec3<double>::Zero(), apart = Vec3<double>::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(closest.size); ++i) {
      const CsoPoint<double>& p = closest.point[i];
      const Vec3<double> d_b = -p.n;
      b += closest.lambda[i] * side_b.support(side_b, side_b.to_own(d_b), &p.vertex_b).x;
      apart += closest.lambda[i] * p.w;
    }
    b = side_b.to_world(b) + pair_.center_b();
    const Vec3<double> a = b + apart;  // from A's pivot
    const Vec3<double> faster = pair_.velocity() + pair_.mobility_b().w.cross(b - pair_.pivot_b_now()) -
                                pair_.mobility_a().w.cross(a);
    return -now.near.n.dot(faster);
  }

 private:
  // Leaves the slice's end apart by as much as a proof may round.
  static constexpr double kShort = 1 - 0x1p-10;
  // An axis that turns costs rounding, here and in every proof: it must give as many times the length.
  static constexpr double kWorthAFrame = 2;
  // And what another may give at best, for it to be tried.
  static constexpr double kWorthTrying = 4;
  // Of the longest slice that ends at contact.
  static constexpr double kTowards = 0.9;

  void place(double t) {
    if (pair_.time() != t) pair_.place(t);
  }
  // The longest conservative slice, and its length.
  double conservative(const Seen& now, Slice& out) {
    const double rest = limits_.end - now.t;
    const auto length = [](double gap, double closing) {
      return closing > 0 ? kShort * gap / closing : kInfinity<double>;
    };
    double best = length(now.near.gap, pair_.closing(now.near.n));
    out.axis = now.near.n;
    for (const AxisFrame frame : {AxisFrame::a, AxisFrame::b}) {
      const double gap = now.near.gap - pair_.frame_error(frame);
      const double h = length(gap, frame == AxisFrame::a ? speed_in_a_ : speed_in_b_);
      if (!(best < rest && gap > 0 && h > kWorthAFrame * best)) continue;
      place(now.t);
      best = h;
      out.axis = pair_.to_start(frame, pair_.to_own(frame, now.near.n));
      out.frame = frame;
    }
    out.end = best >= rest ? limits_.end : not_after(now.t, best);
    return best;
  }
  // A frame in which an axis can stand still, and sqrt(M/2).
  struct Frame {
    AxisFrame of = AxisFrame::world;
    double bend_root = 0;
  };
  // For an axis n as it stands now; the one that lets points bend least first.
  [[nodiscard]] const std::array<Frame, 3>& frames(const Vec3<double>& n) {
    if (n == frames_of_) return frames_;  // of the last slice's end
    frames_of_ = n;
    const std::array<double, 3> bends = pair_.bends(n, limits_.end);
    std::array<Frame, 3>& out = frames_;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto of = static_cast<AxisFrame>(i);
      out[i] = {of, std::sqrt(bends[i] / 2 * (1 + 0x1p-40))};
    }
    // Three, in place, and stable.
    const auto in_order = [&](std::size_t i) {
      if (out[i + 1].bend_root < out[i].bend_root) std::swap(out[i], out[i + 1]);
    };
    in_order(0);
    in_order(1);
    in_order(0);
    return out;
  }
  static bool proves(double h, double s_0, double s_1, double bend_root) {
    return s_0 > 0 && s_1 > 0 && (std::sqrt(s_0) + std::sqrt(s_1)) * kShort > h * bend_root;
  }
  // What may be left at the end of a slice towards contact: less and less, so that the search is superlinear.
  [[nodiscard]] double wished(double gap, const std::optional<Seen>& before) const {
    const double known = before ? std::min(1.0, before->near.gap) : 1.0;
    return std::max(gap * std::min(1.0 / 64, gap * known), limits_.stop / 2);
  }

  // When the gap is due to be `left`, from now: of the polynomial of second degree in the gap through the time before,
  // where there is one, and now, with what the gap changes by now; infinite where none is due.
  struct Due {
    double slope = 0, bend = 0;  // of the time over the gap
    [[nodiscard]] double at(double fallen) const { return (slope + bend * fallen) * fallen; }
  };
  Due due(const Seen& now, const std::optional<Seen>& before) {
    const double fast = approach(now);
    if (!(fast > 0)) return {kInfinity<double>, 0};
    Due out{1 / fast, 0};
    if (!before) return out;
    const double fallen = before->near.gap - now.near.gap;
    if (!(fallen > 0)) return out;
    // At the time before, -fallen: t - t_now = -slope fallen + bend fallen^2.
    const double bend = (out.slope * fallen - (now.t - before->t)) / (fallen * fallen);
    // Only what turns the guess by less than half of itself is a correction.
    if (std::abs(bend) * now.near.gap < out.slope / 2) out.bend = bend;
    return out;
  }

  bool towards_contact(const Seen& now, const std::optional<Seen>& before, double safe, Slice& out) {
    const double gap = now.near.gap, rest = limits_.end - now.t;
    const Due guess = due(now, before);
    if (!(guess.slope < kInfinity<double>)) return false;
    // Of any axis alike; and where the gap at the end is next to nothing.
    const double root = frames(now.near.n)[0].bend_root, most = std::sqrt(gap) / root * kTowards;
    double last = kInfinity<double>, longest = kInfinity<double>;
    for (const double left : {wished(gap, before), gap / 8}) {
      const double due_in = guess.at(gap - left), h = std::min({due_in, most, rest, longest});
      // What spins on before contact is due is left to the cylinder that it sweeps.
      if (due_in > most && spins(rest)) return false;
      if (!(h > safe && h < last)) return false;
      last = h;
      const double end = h >= rest ? limits_.end : not_after(now.t, h);
      pair_.place(end);
      Nearest there = nearest(pair_, now.near.simplex, 0, limits_.stop, limits_.budget, counters_);
      if (!(there.gap > 0)) continue;
      if (between_axes(now, end, there, out)) return true;
      const std::array<Frame, 3> all = frames(there.n);
      std::array<Vec3<double>, 3> owns;
      for (std::size_t i = 0; i < 3; ++i) owns[i] = pair_.to_own(all[i].of, there.n);
      for (std::size_t i = 0; i < 3; ++i) {
        const Frame& frame = all[i];
        const Vec3<double>& own = owns[i];
        const double error = pair_.frame_error(frame.of);
        place(now.t);
        const double gap_now = pair_.gap(pair_.to_world(frame.of, own), counters_) - error;
        if (!proves(end - now.t, gap_now, there.gap - error, frame.bend_root)) continue;
        out.end = end;
        out.axis = pair_.to_start(frame.of, own);
        out.frame = frame.of;
        out.there = there;
        return true;
      }
      longest = h / 2;
    }
    return false;
  }

  // By the axes at both ends. It takes no support.
  bool between_axes(const Seen& now, double end, const Nearest& there, Slice& out) {
    if (records_) return false;
    const double h = end - now.t;
    for (const Frame& frame : std::array<Frame, 3>(frames(there.n))) {
      const double error = pair_.frame_error(frame.of), s_0 = now.near.gap - error, s_1 = there.gap - error;
      if (!proves(h, s_0, s_1, frame.bend_root)) continue;  // no more than the axis that stands still allows
      const double bend = pair_.bend_between(frame.of, now.near.n, now.t, there.n, end, limits_.end);
      if (!proves(h, s_0, s_1, std::sqrt(bend / 2 * (1 + 0x1p-40)))) continue;
      out.end = end;
      out.there = there;
      return true;
    }
    return false;
  }

  // Where the bodies do not near each other, but their axis moves on: as far as the gap allows if it stays, or a part
  // of that.
  void by_two_axes(const Seen& now, Slice& out) {
    if (records_) return;
    const double rest = limits_.end - now.t;
    double h = std::min(rest, kTowards * 2 * std::sqrt(now.near.gap) / frames(now.near.n)[0].bend_root);
    constexpr int kTries = 3;
    for (int i = 0; i < kTries && h > kWorthTrying * (out.end - now.t); ++i, h /= 4) {
      const double end = h >= rest ? limits_.end : not_after(now.t, h);
      pair_.place(end);
      const Nearest there = nearest(pair_, now.near.simplex, 0, limits_.stop, limits_.budget, counters_);
      if (there.gap > 0 && between_axes(now, end, there, out)) return;
    }
  }

  // After many slices: a body that tips about its lowest point has far points that bend, and yet keeps its distance. A
  // proof has no name for this bound.
  void by_arc(const Seen& now, Slice& out) {
    if (records_ || slices_ <= kManySlices || arcs_.waits()) return;
    const double rest = limits_.end - now.t;
    constexpr int kTries = 3;
    double h = rest;
    for (int i = 0; i < kTries && h > kWorthTrying * (out.end - now.t); ++i, h /= 8) {
      const double end = h >= rest ? limits_.end : not_after(now.t, h);
      for (const AxisFrame frame : {AxisFrame::world, AxisFrame::a, AxisFrame::b}) {
        place(now.t);
        const Vec3<double> own = pair_.to_own(frame, now.near.n);
        const double k = bend_of_arc(pair_, frame, own, now.t, end, counters_);
        if (!(k < kInfinity<double>)) continue;
        pair_.place(end);
        const double error = pair_.frame_error(frame), s_0 = now.near.gap - error,
                     s_1 = pair_.gap(pair_.to_world(frame, own), counters_) - error;
        if (!proves(1, s_0, s_1, 2 * std::sqrt(k))) continue;
        out = {};
        out.end = end;
        out.expected = s_1;
        arcs_.succeed();
        return;
      }
    }
    arcs_.fail();
  }

  // What a search along one axis is about: the gap at t, the frame in which the axis stands still, and whose
  // turns do not count.
  struct Along {
    double t;
    Vec3<double> own;
    double gap;
    Frame frame;
    WholeTurns whole;
  };

  // Of a pair of points, at the beginning.
  double gap_at(const Along& from, const Simplex<double>& pair_of_points) {
    place(from.t);
    return pair_.gap_of(carried_over(pair_, pair_of_points).point[0].w,
                        pair_.to_world(from.frame.of, from.own));
  }

  void along_axis(const Along& from, double safe, Slice& out) {
    const double gap = from.gap, rest = limits_.end - from.t, left = gap / 16, root = from.frame.bend_root;
    if (!(gap > 0)) return;
    double h = root > 0 ? std::min(rest, 2 * std::sqrt(gap) / root * kShort) : rest;
    double good = 0, good_gap = gap;  // of what is proved
    double bad, bad_gap;              // of the try before
    constexpr int kTries = 8;
    for (int i = 0; i < kTries && h > safe; ++i) {
      h = h >= rest ? rest : not_after(from.t, h) - from.t;
      pair_.place(h >= rest ? limits_.end : from.t + h);
      const Vec3<double> n = pair_.to_world(from.frame.of, from.own);
      Simplex<double> nearest_pair;
      double s;
      if (from.whole.any()) {
        s = swept_gap(pair_, from.whole, n, counters_);
      } else {
        ++counters_.supports;
        nearest_pair.add(pair_.cso().support(n));
        s = pair_.gap_of(nearest_pair.point[0].w, n) - pair_.frame_error(from.frame.of);
      }
      if (proves(h, gap, s, root)) {
        good = h;
        good_gap = s;
        break;  // what is longer failed, or there is none: the next slice has an axis of its own
      }
      bad = h;
      bad_gap = s;
      if (bad_gap > 0) {
        h = (std::sqrt(gap) + std::sqrt(std::min(bad_gap, gap))) / root * (kShort * kShort);
        if (!(h < bad)) h = bad / 2;
      } else {
        // The secant between the beginning and what failed, towards the gap wished for: of the points that are in contact
        // there, which may have been farther apart than the nearest at the beginning.
        const double begin = from.whole.any() ? gap : std::max(gap, gap_at(from, nearest_pair));
        h = bad * (begin - left) / (begin - bad_gap);
        if (!(h > 0 && h < bad)) h = bad / 2;
      }
    }
    if (!(good > safe)) return;
    out.end = good >= rest ? limits_.end : from.t + good;
    out.axis = pair_.to_start(from.frame.of, from.own);
    out.frame = from.frame.of;
    out.expected = good_gap;
  }

  static constexpr int kManySlices = 12;
  // Has a body more than a turn to go?
  static constexpr double kTurn = 6.3;
  [[nodiscard]] bool spins(double rest) const {
    return std::max(pair_.mobility_a().rate, pair_.mobility_b().rate) * rest > kTurn;
  }
  // The bodies that spin in what is left: by more than a turn, or after many slices, of a wheel whose every corner
  // passes near by, by more than a corner; and of which a slice sees a small part.
  [[nodiscard]] WholeTurns swept_in(double rest, double slice) const {
    constexpr double kCorner = 0.5, kLittle = 2;
    const double much = slices_ > kManySlices ? kCorner : kTurn;
    const auto spins = [&](const Mobility& m) { return m.rate * rest > much && m.rate * slice < kLittle; };
    return {limits_.may_sweep.a && spins(pair_.mobility_a()),
            limits_.may_sweep.b && spins(pair_.mobility_b())};
  }
  [[nodiscard]] Frame still(const WholeTurns& whole, const Vec3<double>& n) const {
    return {AxisFrame::world, std::sqrt(swept_bend(pair_, whole, n) / 2 * (1 + 0x1p-40))};
  }
  // The cylinder is seldom clear where it was not a moment ago.
  void by_whole_turns(const Seen& now, Slice& out) {
    const double h = out.end - now.t;
    const WholeTurns whole = swept_in(limits_.end - now.t, h);
    if (!whole.any() || turns_.waits()) return;
    pair_.place(now.t);
    Simplex<double> simplex;
    const auto support = [&](const Vec3<double>& n) { return swept_support(pair_, whole, n); };
    const Distance<double> d = gjk_distance(support, Vec3<double>(Vec3<double>::Zero()), now.near.n, simplex,
                                            now.near.gap / 16, pair_.radius(), limits_.budget, counters_);
    const double gap = d.n == Vec3<double>::Zero() ? 0.0 : swept_gap(pair_, whole, d.n, counters_);
    Slice swept;
    swept.end = now.t;
    if (gap > 0) along_axis(Along{now.t, d.n, gap, still(whole, d.n), whole}, h, swept);
    if (swept.end > out.end) {
      swept.expected = 0;  // of the cylinder, not of the body in it
      out = swept;
      turns_.succeed();
      return;
    }
    turns_.fail();
  }

  MovingPair& pair_;
  const MarchLimits& limits_;
  Counters& counters_;
  bool records_;
  double speed_in_a_, speed_in_b_;
  Vec3<double> frames_of_ = Vec3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
  std::array<Frame, 3> frames_;
  int slices_ = 0;
  Patience arcs_, turns_;  // of by_arc(), by_whole_turns()
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
