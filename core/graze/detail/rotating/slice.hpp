// Finds the longest slice of time that one axis proves free of contact.
//
// Lengths: internal; n unit, world axes, from A to B. The gap along n at time t is s(t) = min over B of n.b -
// max over A of n.a, less the target distance. A positive gap means that the bodies are apart. From a time t_0
// with the bodies apart, one of three bounds gives the slice:
//   conservative:  s(t) >= s_0 - L (t - t_0), L = -n.v + sum |n x w| rho (mobility.hpp), so the slice is
//                  s_0 / L long. Along an axis that rotates with a body, L is the speed of the other body's
//                  points in that body's axes (moving_pair.hpp).
//   bilateral:     every point's n.x(t) stays within M (t - t_0)(t_1 - t)/2 of its chord, M the sum of the
//                  accelerations, so s(t) is above the chord of s_0 and s_1 less that, and positive on all of
//                  [t_0, t_1] iff sqrt(s_0) + sqrt(s_1) > (t_1 - t_0) sqrt(M/2).
// [Mirtich 1996; Catto, Continuous Collision, GDC 2013, whose bilateral advancement asks for s_1 > 0 only.]
//   along an axis that moves: the axis moves evenly from n_0 at t_0 to n_1 at t_1. Its length is at most 1 in
//                  between, and n(t).x(t) bends by 2 |n'| times the speed more. Each end uses the gap along its
//                  own best axis, which is the distance itself where a line meets a line or a rim meets a face.
//                  No single axis serves both ends there. The proof format cannot express such an axis.
//
// The bilateral search tries these candidates for t_1, in this order:
//   0. After many slices, along the axis of now, with the most that a rotating body reaches (whole_turns.hpp). A wheel
//      that rolls keeps its gap for long, although its points bend. It must be much longer than the slice before.
//   1. A little before the root of the distance itself, by the secant of its last two values, with the axis
//      found there. Where a face rotates, an old axis covers part of the way only and the new one all of it.
//   2. Along the old axis, to the extent that M allows or towards the first root of s, by the secant. It uses
//      the frame in which points bend least, or another frame.
//   3. Along an axis that moves, and after many slices by its arc (arc.hpp).
//   4. As 2., with the cylinder that a body sweeps in a whole turn (whole_turns.hpp).
// If no candidate can be proved, the slice is a conservative one. The root finders only propose times, so a root
// finder that does not converge costs speed, not correctness.
#pragma once

#include <graze/detail/rotating/arc.hpp>
#include <graze/detail/rotating/nearest.hpp>
#include <graze/detail/rotating/whole_turns.hpp>
#include <optional>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

enum class Advance { conservative, bilateral };

struct MarchLimits {
  Advance advance = Advance::bilateral;
  double begin = 0, end = 1;         // a contact that is passed over has ended at `begin`
  double stop = 0;                   // a gap that axes cannot close
  double width = 0;                  // largest distance of either bracket end from contact. 0: the least one
  double touching = -1;              // bodies within this distance are in contact. Negative: proof is needed
  bool proves_later = false;         // `touching` is about the start alone
  int budget = 0;                    // support evaluations
  bool record = false;               // keep the chain
  bool asks_start = false;           // a start that stays open ends the march, for its caller to decide
  WholeTurns may_sweep{true, true};  // whole_turns.hpp
};

struct Slice {
  double end = 0;
  Vec3<double> axis = Vec3<double>::Zero();  // in the proof's convention: at t = 0 if it rotates
  AxisFrame frame = AxisFrame::world;
  double expected = 0;           // lower bound of the gap at the end
  std::optional<Nearest> there;  // closest points at the end, if known
};

// A time and the distance of the bodies at that time.
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

// Backs off after failures: the next try waits for about as many rounds as there were failures.
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

  // The slices from here on are part of no proof. They may use bounds that the proof format cannot express.
  void stop_recording() { records_ = false; }

  // Requires now.near.gap > 0. The pair may be left at any time.
  Slice operator()(const Seen& now, const std::optional<Seen>& before) {
    GRAZE_ASSERT(now.near.gap > 0 && now.t >= 0 && now.t <= limits_.end);
    ++slices_;
    Slice out;
    const double rest = limits_.end - now.t, safe = conservative(now, out);
    if (limits_.advance == Advance::conservative || safe >= rest) return out;
    if (slices_ > kManySlices && keeps_its_gap(now, before) && by_reach(now, now.t - before->t, out))
      return out;
    if (towards_contact(now, before, safe, out)) return out;
    // If a face rotates, an axis that rotates with it may prove much more than the steadiest one.
    const std::array<Frame, 3> all = frames(now.near.n);
    for (const Frame& frame : all) {
      const double longest = out.end - now.t;
      if (!(std::min(rest, 2 * square_root(now.near.gap) / frame.bend_root) > kWorthTrying * longest))
        continue;
      place(now.t);
      const Vec3<double> own = pair_.to_own(frame.of, now.near.n);
      along_axis(Along{now.t, own, now.near.gap - pair_.frame_error(frame.of), frame, {}}, longest, out);
    }
    by_two_axes(now, out);
    by_arc(now, out);
    by_whole_turns(now, out);
    return out;
  }

  // Does the gap along n stay above `least` from t to the end? Tried in the frame in which points bend least, and
  // with a spinning body replaced by the cylinder that it sweeps.
  bool keeps_above(double t, const Vec3<double>& n, double least) {
    const double rest = limits_.end - t;
    const auto above = [&](const Along& along) {
      const auto gap = [&](double at) {
        pair_.place(at);
        const Vec3<double> axis = pair_.to_world(along.frame.of, along.own);
        return along.whole.any() ? swept_gap(pair_, along.whole, axis, counters_)
                                 : pair_.gap(axis, counters_) - pair_.frame_error(along.frame.of);
      };
      // In this order, which a call would leave to the compiler: the bodies stay where they were placed last.
      const double at_end = gap(limits_.end) - least, at_begin = gap(t) - least;
      return proves(rest, at_begin, at_end, along.frame.bend_root);
    };
    const Frame steadiest = frames(n)[0];
    place(t);
    if (above({t, pair_.to_own(steadiest.of, n), 0, steadiest, {}})) return true;
    const WholeTurns whole = reaching(rest);
    if (!whole.any()) return false;
    const auto [first, last] = gaps_between(pair_, whole, n, t, limits_.end, counters_);
    return proves(rest, first - least, last - least, still(whole, n).bend_root);
  }

  // The speed at which the closest points approach each other: the derivative of the distance while the features
  // stay. An estimate.
  double approach(const Seen& now) {
    place(now.t);
    const Simplex<double>& closest = now.near.simplex;
    Vec3<double> apart = Vec3<double>::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(closest.size); ++i)
      apart += closest.lambda[i] * closest.point[i].w;
    const Vec3<double> b = closest_on_b(pair_, closest), a = b + apart;
    const Vec3<double> faster = pair_.velocity() + cross(pair_.mobility_b().w, b - pair_.pivot_b_now()) -
                                cross(pair_.mobility_a().w, a);
    return -dot(now.near.n, faster);
  }

 private:
  // Leaves a gap at the slice's end that covers the rounding of a proof.
  static constexpr double kShort = 1 - 0x1p-10;
  // A rotating axis costs rounding, here and in every proof. It must make the slice longer by at least this factor.
  static constexpr double kWorthAFrame = 2;
  // An alternative is tried only if its best case is longer by this factor.
  static constexpr double kWorthTrying = 4;
  // Fraction of the longest slice that ends at contact.
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
  // A frame in which an axis is held fixed, and sqrt(M/2).
  struct Frame {
    AxisFrame of = AxisFrame::world;
    double bend_root = 0;
  };
  // The frames for an axis n in its current direction, sorted with the least bend first.
  [[nodiscard]] const std::array<Frame, 3>& frames(const Vec3<double>& n) {
    if (n == frames_of_) return frames_;  // the axis at the last slice's end
    frames_of_ = n;
    const std::array<double, 3> bends = pair_.bends(n, limits_.end);
    std::array<Frame, 3>& out = frames_;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto of = static_cast<AxisFrame>(i);
      out[i] = {of, square_root(bends[i] / 2 * (1 + 0x1p-40))};
    }
    // A stable in-place sort of three elements.
    const auto in_order = [&](std::size_t i) {
      if (out[i + 1].bend_root < out[i].bend_root) std::swap(out[i], out[i + 1]);
    };
    in_order(0);
    in_order(1);
    in_order(0);
    return out;
  }
  static bool proves(double h, double s_0, double s_1, double bend_root) {
    return s_0 > 0 && s_1 > 0 && (square_root(s_0) + square_root(s_1)) * kShort > h * bend_root;
  }
  // The gap wanted at the end of a slice towards contact. It shrinks faster each time, so that the search is
  // superlinear.
  [[nodiscard]] double wished(double gap, const std::optional<Seen>& before) const {
    const double known = before ? std::min(1.0, before->near.gap) : 1.0;
    return std::max(gap * std::min(1.0 / 64, gap * known), limits_.stop / 2);
  }

  // The time from now until the gap falls to `left`. It comes from the quadratic polynomial in the gap through the
  // time before, if there is one, and now, with the present rate of the gap. Infinite if the gap does not fall.
  struct Due {
    double slope = 0, bend = 0;  // of the time as a function of the gap
    [[nodiscard]] double at(double fallen) const { return (slope + fl(bend * fallen)) * fallen; }
  };
  Due due(const Seen& now, const std::optional<Seen>& before) {
    const double fast = approach(now);
    if (!(fast > 0)) return {kInfinity<double>, 0};
    Due out{1 / fast, 0};
    if (!before) return out;
    const double fallen = before->near.gap - now.near.gap;
    if (!(fallen > 0)) return out;
    // At the time before, -fallen: t - t_now = -slope fallen + bend fallen^2.
    const double bend = (fl(out.slope * fallen) - (now.t - before->t)) / (fallen * fallen);
    // The quadratic term is used only if it changes the estimate by less than half.
    if (std::abs(bend) * now.near.gap < out.slope / 2) out.bend = bend;
    return out;
  }

  bool towards_contact(const Seen& now, const std::optional<Seen>& before, double safe, Slice& out) {
    const double gap = now.near.gap, rest = limits_.end - now.t;
    const Due guess = due(now, before);
    if (!(guess.slope < kInfinity<double>)) return false;
    // This limit holds for every axis, and also if the gap at the end is almost 0.
    const double root = frames(now.near.n)[0].bend_root, most = square_root(gap) / root * kTowards;
    // A body that comes to rest against the other, as onto the edge of a tile, has slices that are all the same part of
    // the time until contact. The first try is a little longer than the last success. The third and the fourth are worth
    // it only far beyond what costs nothing.
    constexpr int kTries = 4;
    constexpr double kGrows = 1.5;
    double last = kInfinity<double>, longest = kInfinity<double>;
    for (int tried = 0; tried < kTries; ++tried) {
      const double due_in = guess.at(gap - (tried == 0 ? wished(gap, before) : gap / 8)),
                   due_or_most = std::min({due_in, most, rest}), h = std::min(part_ * due_or_most, longest);
      // A body that spins on before contact is due is left to the cylinder that it sweeps.
      if (due_in > most && spins(rest)) return false;
      if (!(h > (tried < 2 ? 1 : kWorthTrying) * safe && h < last)) return false;
      last = h;
      const double end = h >= rest ? limits_.end : not_after(now.t, h);
      pair_.place(end);
      Nearest there = nearest(pair_, now.near.simplex, 0, limits_.stop, limits_.budget, counters_);
      if (!(there.gap > 0)) continue;
      part_ = std::min(kGrows * h / due_or_most, 1.0);
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

  // Uses the axes at both ends. No support evaluations.
  bool between_axes(const Seen& now, double end, const Nearest& there, Slice& out) {
    if (records_) return false;
    const double h = end - now.t;
    for (const Frame& frame : std::array<Frame, 3>(frames(there.n))) {
      const double error = pair_.frame_error(frame.of), s_0 = now.near.gap - error, s_1 = there.gap - error;
      if (!proves(h, s_0, s_1, frame.bend_root)) continue;  // no more than the fixed axis allows
      const double bend = pair_.bend_between(frame.of, now.near.n, now.t, there.n, end, limits_.end);
      if (!proves(h, s_0, s_1, square_root(bend / 2 * (1 + 0x1p-40)))) continue;
      out.end = end;
      out.there = there;
      return true;
    }
    return false;
  }

  // For bodies that do not approach each other while their axis moves. The slice is as long as the gap allows if it
  // stays constant, or a part of that.
  void by_two_axes(const Seen& now, Slice& out) {
    if (records_) return;
    const double rest = limits_.end - now.t;
    double h = std::min(rest, kTowards * 2 * square_root(now.near.gap) / frames(now.near.n)[0].bend_root);
    constexpr int kTries = 3;
    for (int i = 0; i < kTries && h > kWorthTrying * (out.end - now.t); ++i, h /= 4) {
      const double end = h >= rest ? limits_.end : not_after(now.t, h);
      pair_.place(end);
      const Nearest there = nearest(pair_, now.near.simplex, 0, limits_.stop, limits_.budget, counters_);
      if (there.gap > 0 && between_axes(now, end, there, out)) return;
    }
  }

  // Used after many slices. A body that tips about its lowest point has distant points that bend, and yet keeps its
  // distance. The proof format cannot express this bound.
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
        if (!proves(1, s_0, s_1, 2 * square_root(k))) continue;
        out = {};
        out.end = end;
        out.expected = s_1;
        arcs_.succeed();
        return;
      }
    }
    arcs_.fail();
  }

  // The setting of a search along one axis: the gap at t, the frame in which the axis is held fixed, and the bodies
  // whose rotation is replaced by their swept cylinder.
  struct Along {
    double t;
    Vec3<double> own;
    double gap;
    Frame frame;
    WholeTurns whole;
  };

  // The gap of a pair of points, at the beginning.
  double gap_at(const Along& from, const Simplex<double>& pair_of_points) {
    place(from.t);
    return pair_.gap_of(carried_over(pair_, pair_of_points).point[0].w,
                        pair_.to_world(from.frame.of, from.own));
  }

  void along_axis(const Along& from, double safe, Slice& out) {
    const double gap = from.gap, rest = limits_.end - from.t, left = gap / 16, root = from.frame.bend_root;
    if (!(gap > 0)) return;
    double h = root > 0 ? std::min(rest, 2 * square_root(gap) / root * kShort) : rest;
    double good = 0, good_gap = gap;  // of the proved slice
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
        break;  // longer slices failed or do not exist: the next slice gets its own axis
      }
      bad = h;
      bad_gap = s;
      if (bad_gap > 0) {
        h = (square_root(gap) + square_root(std::min(bad_gap, gap))) / root * (kShort * kShort);
        if (!(h < bad)) h = bad / 2;
      } else {
        // Takes the secant between the beginning and the failed time, towards the gap wanted. The beginning's gap is
        // that of the points in contact at the failed time. They may have been farther apart than the nearest points
        // at the beginning.
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
  // Is the gap about as large as a slice ago?
  [[nodiscard]] static bool keeps_its_gap(const Seen& now, const std::optional<Seen>& before) {
    return before && now.near.gap < 2 * before->near.gap && before->near.gap < 2 * now.near.gap;
  }
  // Does a body have more than a turn left?
  static constexpr double kTurn = 6.3, kCorner = 0.5;
  [[nodiscard]] bool spins(double rest) const {
    return std::max(pair_.mobility_a().rate, pair_.mobility_b().rate) * rest > kTurn;
  }
  [[nodiscard]] double much_turning() const { return slices_ > kManySlices ? kCorner : kTurn; }
  // The bodies to replace by their swept cylinder, if a slice covers a small part of the rest of the step. Such a body
  // spins by more than a turn in that rest. After many slices a corner's rotation is enough, for a wheel whose every
  // corner passes nearby.
  [[nodiscard]] WholeTurns swept_in(double rest, double slice) const {
    if (!(slice * kWorthTrying < rest)) return {false, false};
    const auto spins = [&](const Mobility& m) { return m.rate * rest > much_turning(); };
    return {limits_.may_sweep.a && spins(pair_.mobility_a()),
            limits_.may_sweep.b && spins(pair_.mobility_b())};
  }
  [[nodiscard]] Frame still(const WholeTurns& whole, const Vec3<double>& n) const {
    return {AxisFrame::world, square_root(swept_bend(pair_, whole, n) / 2 * (1 + 0x1p-40))};
  }
  // The bodies whose greatest reach over a span of time tells more than their points' bends: solids of revolution, and
  // those that spin as above.
  [[nodiscard]] WholeTurns reaching(double rest) const {
    const auto reaches = [&](const Mobility& m) {
      return m.profile.size > 0 ? m.turns() : m.rate * rest > much_turning();
    };
    return {limits_.may_sweep.a && reaches(pair_.mobility_a()),
            limits_.may_sweep.b && reaches(pair_.mobility_b())};
  }
  // For a wheel that rolls, or a ball that spins, along the axis that they have. `former`: the slice before.
  bool by_reach(const Seen& now, double former, Slice& out) {
    const double rest = limits_.end - now.t;
    const WholeTurns whole = reaching(rest);
    if (!whole.any() || reaches_.waits()) return false;
    const Vec3<double> n = now.near.n;
    const double root = still(whole, n).bend_root;
    double h = rest;
    constexpr int kTries = 4;
    for (int i = 0; i < kTries && h > kWorthTrying * former; ++i, h /= 16) {
      const double end = h >= rest ? limits_.end : not_after(now.t, h);
      const auto [first, last] = gaps_between(pair_, whole, n, now.t, end, counters_);
      if (!proves(end - now.t, first, last, root)) continue;
      out = {};
      out.end = end;
      out.axis = n;
      reaches_.succeed();
      return true;
    }
    reaches_.fail();
    return false;
  }
  // The cylinder is seldom clear if it was not clear a moment ago.
  void by_whole_turns(const Seen& now, Slice& out) {
    const double h = out.end - now.t;
    const WholeTurns whole = swept_in(limits_.end - now.t, h);
    if (!whole.any() || turns_.waits()) return;
    pair_.place(now.t);
    Slice swept;
    swept.end = now.t;
    Vec3<double> n = now.near.n;
    double gap = swept_gap(pair_, whole, n, counters_);
    if (!(gap > 0)) {
      Simplex<double> simplex;
      const auto support = [&](const Vec3<double>& d) { return swept_support(pair_, whole, d); };
      n = gjk_distance(support, Vec3<double>(Vec3<double>::Zero()), n, simplex, now.near.gap / 16,
                       pair_.radius(), limits_.budget, counters_)
              .n;
      if (n != Vec3<double>::Zero()) gap = swept_gap(pair_, whole, n, counters_);
    }
    if (gap > 0) along_axis(Along{now.t, n, gap, still(whole, n), whole}, h, swept);
    if (swept.end > out.end) {
      swept.expected = 0;  // the gap is the cylinder's, not that of the body in it
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
  double part_ = 1;                  // of the time until contact, which towards_contact() tries first
  Patience arcs_, turns_, reaches_;  // of by_arc(), by_whole_turns(), by_reach()
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
