// Follows a contact that exists at t = 0 until it gets deeper, or the bodies separate. This is the start policy
// pass_over of rotating bodies. A caller uses it to find the next contact of a body that rests on another one.
//
// Lengths: internal; n unit. s_n(t) = the gap along n at t (slice.hpp). If negative, the bodies are at most -s_n deep
// along n. One axis proves "no deeper than x" over a slice of time: s_n >= -x. Pairs that hold a ball of radius x about
// the origin (contact.hpp) prove "deeper than x" at one time. With the allowed depth d,
// - a slice is passed if an axis shows that the bodies are no deeper than d / 2 on all of it.
// - the contact got deeper if it is proved deeper than d / 4, and an axis shows no more than d since the last slice.
//
// Over a slice a gap is bounded by the chord of its ends and the bend of the points (slice.hpp), by the arc of an axis
// (arc.hpp), by the supports about the middle of the slice (support_bend.hpp), or by what a solid of revolution reaches
// (whole_turns.hpp).
#pragma once

#include <graze/detail/rotating/march.hpp>
#include <graze/detail/rotating/support_bend.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct FollowLimits {
  double end = 1;
  double allowed = 0;   // d: depth of a contact that is followed
  double apart = 0;     // the bodies have separated at a larger gap
  double touching = 0;  // contact at the start if the gap is no larger
  double width = 0;     // depth that the bracket of a deepening contact may hide, at least d
  double stop = 0;      // of the closest-point searches
  int budget = 0;       // support evaluations
};

struct Followed {
  enum class State {
    none,       // no contact at the start
    deep,       // the contact at the start is deeper than is followed
    open,       // no other state is proved after found.lower
    deeper,     // in [found.lower, found.upper] it gets deeper
    separated,  // the bodies are apart at found.lower, with no deeper contact before
    ended,      // no deeper contact until the end
  } state = State::none;
  bool proved = false;  // of `deep`: by pairs
  March found;
};

class ContactFollower {
 public:
  ContactFollower(MovingPair& pair, const FollowLimits& limits, Counters& counters)
      : pair_(pair), limits_(limits), counters_(counters) {}

  Followed operator()() {
    place(0);
    now_.near = look({});
    if (now_.near.gap > 0 && now_.near.apart > limits_.touching) return out_;
    now_.n = now_.near.n;
    now_.s = deepest_axis(now_.n, now_.near.simplex);
    if (!(now_.s >= -followed())) return deep_start();
    double h = limits_.end;
    while (now_.t < limits_.end) {
      if (is_spent()) return result(Followed::State::open);
      const std::optional<double> passed = advance(h);
      if (!passed) return out_;
      if (now_.near.gap > limits_.apart) return result(Followed::State::separated);
      h = (as_long_-- > 0 ? 1 : kFaster) * *passed;
    }
    return result(Followed::State::ended);
  }

 private:
  // Fractions of the allowed depth: for following a contact, for the proof that it got deeper, for the depth that the
  // search for that time aims at, and for the largest depth allowed by then.
  static constexpr double kFollowed = 0.5, kProved = 0.25, kSought = 0.7, kDeepest = 0.95;
  // A slice is tried for this many times the last one that was passed.
  static constexpr double kFaster = 16;
  // So many slices after one that its bound cut short are tried as long as that one.
  static constexpr int kAsLong = 3;

  struct At {
    double t = 0;
    Nearest near;
    Vec3<double> n = Vec3<double>::Zero();  // along which the bodies are least deep, or farthest apart
    double s = 0;                           // the gap along it
  };

  [[nodiscard]] double followed() const { return kFollowed * limits_.allowed; }
  [[nodiscard]] bool is_spent() const { return counters_.supports >= limits_.budget; }
  void place(double t) {
    if (pair_.time() != t) pair_.place(t);
  }
  Nearest look(const Simplex<double>& before) {
    ++counters_.iterations;
    return nearest(pair_, before, 0, limits_.stop, limits_.budget, counters_);
  }

  // Along n or another axis, which then takes its place: the greatest gap that is found.
  double deepest_axis(Vec3<double>& n, const Simplex<double>& closest) {
    double best = -kInfinity<double>;
    const auto take = [&](const Vec3<double>& other) {
      const double s = pair_.gap(other, counters_);
      if (!(s > best)) return;
      best = s;
      n = other;
    };
    if (n != Vec3<double>::Zero()) best = pair_.gap(n, counters_);
    if (best >= -followed() / 2) return best;
    // The origin in a triangle, or on an edge, of a flat C.
    if (closest.size == 2 || closest.size == 3) {
      const Vec3<double> w = closest.point[0].w, along = closest.point[1].w - w;
      Vec3<double> third = closest.point[2].w;
      if (closest.size == 2 && along != Vec3<double>::Zero()) {
        const Frame<double> about(graze::unit(along));
        ++counters_.supports;
        third = pair_.cso().support(graze::unit(Vec3<double>(about.e1 + 0.5 * about.e2))).w;
      }
      const Vec3<double> m = face_normal(w, closest.point[1].w, third);
      if (m != Vec3<double>::Zero()) {
        take(graze::unit(m));
        take(Vec3<double>(-graze::unit(m)));
      }
      if (best >= -followed() / 2) return best;
    }
    if (pair_.radius() > 0) {
      // The search ended when the balls about the cores met. If the cores are apart, their own axis is the best.
      Simplex<double> simplex;
      const Distance<double> d = gjk_distance(pair_.cso(), Vec3<double>(Vec3<double>::Zero()), simplex,
                                              pair_.error(), 0.0, limits_.budget, counters_);
      if (d.lower > pair_.error()) {
        take(d.n);
        return best;
      }
    }
    // The face where C is left along an axis is no deeper than the way to it, so the face's own normal is a better axis.
    constexpr int kFaces = 4;
    const auto improve = [&](Vec3<double> from) {
      for (int i = 0; i < kFaces && from != Vec3<double>::Zero(); ++i) {
        const Vec3<double> face = enter_line(pair_.cso(), Frame<double>(Vec3<double>(-from)),
                                             kInfinity<double>, pair_.error(), limits_.budget, counters_)
                                      .facing;
        if (face == Vec3<double>::Zero()) return;
        const double s = pair_.gap(face, counters_);
        if (!(s > best)) return;
        best = s;
        n = from = face;
      }
    };
    const Vec3<double> given = n;
    improve(given);
    if (best < -followed()) improve(Vec3<double>(-pair_.cso().middle()));
    if (n == Vec3<double>::Zero()) {
      n = away_from_middle(pair_);
      best = pair_.gap(n, counters_);
    }
    return best;
  }

  Followed deep_start() {
    out_.proved = proved_contact(pair_, now_.n, limits_.allowed, now_.near.simplex, limits_.budget, counters_,
                                 kProved * limits_.allowed)
                      .proved;
    return result(Followed::State::deep);
  }
  Followed result(Followed::State state) {
    out_.state = state;
    March& found = out_.found;
    found.lower = now_.t;
    found.apart = now_.near.apart;
    found.n = now_.n;
    found.closest = now_.near.simplex;
    return out_;
  }

  // Advances from now_ by a slice of at most h and returns its length. No value: out_ is the answer.
  std::optional<double> advance(double h) {
    // A time that is known to be deep is not passed.
    if (deep_.t - now_.t <= h) h = towards_deep();
    while (true) {
      const double rest = limits_.end - now_.t, next = std::nextafter(now_.t, limits_.end);
      const double t = h >= rest ? limits_.end : std::max(now_.t + h, next);
      if (is_spent()) return stopped(Followed::State::open);
      const At there = at(t);
      const Slope slope = steepest(there);
      if (slope.low >= -followed()) {
        const std::optional<double> hop = there.near.gap > limits_.apart ? std::nullopt : hops(there);
        if (hop && !(*hop > 0)) {
          h = (t - now_.t) / 2;
          continue;
        }
        if (hop) return hop;
        const double passed = t - now_.t;
        now_ = there;
        return passed;
      }
      const bool least = !(t > next), deep = there.s < -followed();
      if (deep && (least || slope.low >= -std::max(kDeepest * limits_.allowed, limits_.width)) &&
          got_deeper(there)) {
        out_.found.upper = t;
        return stopped(Followed::State::deeper);
      }
      if (least) return stopped(Followed::State::open);
      const double tried = t - now_.t, room = square_root(std::max(now_.s + followed(), 0.0));
      // In this time points bend by as much as the depth that is followed.
      const double straight = tried * room / square_root(slope.k);
      if (deep) {
        deeper_ = deep_;
        deep_ = {t, there.s};
        h = towards_deep();
        if (straight < tried / 2) h = std::max(h, straight);
      } else {
        as_long_ = kAsLong;
        const double end = square_root(std::max(there.s + followed(), 0.0));
        h = tried * std::clamp(0.9 * (room + end) / (2 * square_root(slope.k)), 0x1p-6, 0.5);
      }
    }
  }
  std::optional<double> stopped(Followed::State state) {
    result(state);
    return {};
  }

  // The time from now_ at which the contact is expected to reach the depth aimed at. It comes from the line through
  // the last two times with depth, because a landing body has no depth before. Otherwise it comes from the chord. The
  // result is at least a part of the way and never all of it.
  [[nodiscard]] double towards_deep() const {
    const double sought = -kSought * limits_.allowed, way = deep_.t - now_.t;
    const double slope = (deeper_.s - deep_.s) / (deeper_.t - deep_.t);
    double h = way * (now_.s - sought) / (now_.s - deep_.s);
    if (slope < 0) {
      const double due = way - (deep_.s - sought) / slope;
      if (due > h) h = due;
    }
    return std::min(h, 0.75 * way);
  }

  At at(double t) {
    place(t);
    At out{t, look(now_.near.simplex), {}, 0};
    out.n = now_.n;
    if (out.near.gap > 0) {
      out.n = out.near.n;
      out.s = out.near.gap;
    } else {
      out.s = deepest_axis(out.n, out.near.simplex);
    }
    return out;
  }

  // Are the bodies apart in the middle of a slice whose ends are in contact? The slice ends there, if that can be
  // proved. No value: they are not apart. 0: they are, and it cannot be proved.
  std::optional<double> hops(const At& there) {
    const double middle = now_.t + (there.t - now_.t) / 2;
    if (!(now_.t < middle && middle < there.t)) return {};
    place(middle);
    At between{middle, look(now_.near.simplex), {}, 0};
    if (!(between.near.gap > limits_.apart)) return {};
    between.n = between.near.n;
    between.s = between.near.gap;
    if (!(steepest(between).low >= -followed())) return 0;
    const double h = middle - now_.t;
    now_ = between;
    return h;
  }

  [[nodiscard]] bool got_deeper(const At& there) {
    place(there.t);
    return proved_contact(pair_, there.n, limits_.allowed, there.near.simplex, limits_.budget, counters_,
                          kProved * limits_.allowed)
        .proved;
  }

  // A lower bound of a slice's least gap along an axis, and the k of that bound.
  struct Slope {
    double low = -kInfinity<double>, k = kInfinity<double>;
  };
  static Slope least_of(double s_0, double s_1, double k) {
    const double fall = s_1 - s_0;
    if (!(k < kInfinity<double>)) return {};
    if (std::abs(fall) >= 4 * k) return {std::min(s_0, s_1), k};
    return {(s_0 + s_1) / 2 - k - fall * fall / (16 * k), k};
  }
  // By the axis of either end, or one that moves from the first to the other.
  Slope steepest(const At& there) {
    Slope best;
    between(there, best);
    if (best.low >= -followed()) return best;
    by_reach(there, best);
    if (best.low >= -followed()) return best;
    along(there.n, there.t, there, best);
    if (best.low < -followed()) along(now_.n, now_.t, there, best);
    return best;
  }
  // Uses an axis that moves evenly in the axes of the world or of a body, from the known axes at both ends. In between it
  // is shorter than 1, and the bodies are deeper along its unit vector by that factor.
  void between(const At& there, Slope& best) {
    const double h = there.t - now_.t;
    for (const AxisFrame frame : {AxisFrame::world, AxisFrame::a, AxisFrame::b}) {
      if (stands_still(frame)) continue;
      const double change = pair_.axis_change(frame, now_.n, now_.t, there.n, there.t);
      const double shortest_sq = 1 - change * change / 4, error = pair_.frame_error(frame);
      if (!(shortest_sq > 0.25)) continue;
      const double bend = pair_.bend_between(frame, now_.n, now_.t, there.n, there.t, limits_.end);
      const auto take_k = [&](double k) {
        Slope one = least_of(now_.s - error, there.s - error, k);
        if (one.low < 0) one.low *= (1 + 8 * kUnitRoundoff<double>) / square_root(shortest_sq);
        take(one, best);
      };
      take_k(bend * h * h / 8 * (1 + 0x1p-40));
      if (best.low >= -followed()) return;
      if (are_followed(now_.s, there.s)) {
        place(now_.t);
        const Vec3<double> contact = closest_on_b(pair_, now_.near.simplex);
        take_k(bend_of_supports(pair_, frame, now_.n, now_.t, there.n, there.t, contact, counters_));
      }
      if (best.low >= -followed()) return;
    }
  }
  // No bound helps an axis along which an end is deeper.
  [[nodiscard]] bool are_followed(double s_0, double s_1) const {
    return std::min(s_0, s_1) >= -std::max(limits_.allowed, limits_.width);
  }
  // A solid of revolution that rolls reaches hardly farther in between (whole_turns.hpp). If the other body rotates, too,
  // its points bend.
  void by_reach(const At& there, Slope& best) {
    const auto rolls = [](const Mobility& m) { return m.turns() && m.profile.size > 0; };
    const WholeTurns whole{rolls(pair_.mobility_a()), rolls(pair_.mobility_b())};
    if (!whole.any()) return;
    const double h = there.t - now_.t;
    const auto [first, last] = gaps_between(pair_, whole, there.n, now_.t, there.t, counters_);
    Slope one = least_of(first, last, swept_bend(pair_, whole, there.n) * h * h / 8 * (1 + 0x1p-40));
    one.k = std::max(one.k, (now_.s + there.s) / 2 - one.low);
    take(one, best);
  }
  [[nodiscard]] bool stands_still(AxisFrame frame) const {
    return (frame == AxisFrame::a && !pair_.mobility_a().turns()) ||
           (frame == AxisFrame::b && !pair_.mobility_b().turns());
  }
  // n has its direction at time `stands`, one of the two ends. It is fixed in the world or rotates with a body: a
  // face that rotates about a point of the contact keeps its normal.
  void along(const Vec3<double>& n, double stands, const At& there, Slope& best) {
    const double h = there.t - now_.t;
    const std::array<double, 3> bends = pair_.bends(n, limits_.end);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto frame = static_cast<AxisFrame>(i);
      if (stands_still(frame)) continue;
      place(stands);
      const Vec3<double> own = pair_.to_own(frame, n);
      const auto gap_at = [&](double t) {
        place(t);
        return pair_.gap(pair_.to_world(frame, own), counters_) - pair_.frame_error(frame);
      };
      const double s_0 = gap_at(now_.t), s_1 = gap_at(there.t);
      take(least_of(s_0, s_1, bends[i] * h * h / 8 * (1 + 0x1p-40)), best);
      if (best.low >= -followed()) return;
      if (are_followed(s_0, s_1))
        take(least_of(s_0, s_1, bend_of_arc(pair_, frame, own, now_.t, there.t, counters_)), best);
      if (best.low >= -followed()) return;
    }
  }
  static void take(const Slope& one, Slope& best) {
    if (one.low > best.low || !(best.k < kInfinity<double>)) best = one;
  }

  MovingPair& pair_;
  const FollowLimits& limits_;
  Counters& counters_;
  At now_;
  // The last two times that are deeper than is followed.
  struct Deep {
    double t = kInfinity<double>, s = 0;
  } deep_, deeper_;
  int as_long_ = 0;
  Followed out_;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
