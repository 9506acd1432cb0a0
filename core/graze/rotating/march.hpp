// The safe march: from contact-free time to contact-free time, until contact is proved.
//
// Lengths: internal; t as the caller's; n unit, world axes, from A to B. The gap along n at time t is s(t) =
// min over B of n.b - max over A of n.a, less the target distance; positive: apart. At a time t_0 with the
// bodies apart, GJK gives n, the axis along which s(t_0) is their distance, and then either
//   conservative:  s(t) >= s_0 - L (t - t_0), L = -n.v + sum |n x w| rho (mobility.hpp): the step is s_0 / L;
//   bilateral:     every point's n.x(t) stays within M (t - t_0)(t_1 - t)/2 of its chord, M = sum of the
//                  accelerations, so s(t) is above the chord of s_0 and s_1 less that, and positive on all of
//                  [t_0, t_1] iff sqrt(s_0) + sqrt(s_1) > (t_1 - t_0) sqrt(M/2). The t_1 looked for is the
//                  largest such, near the first root of s: where s_1 <= 0 the secant is followed, and a step
//                  that is not proved after a few tries becomes a conservative one. No root finder can stall,
//                  and none is believed.
// [Mirtich 1996; Catto, Continuous Collision, GDC 2013, whose bilateral advancement asks s_1 > 0 only.]
//
// Nearer than `stop` a march cannot go by axes. From there it walks forward, at first by what cannot pass
// through more than `stop`, then by twice as much, never by more than what keeps the unseen depth below
// `stop`, until contact is proved (contact.hpp) or the bodies are apart again. The time at which it began to
// do so is the lower end of the bracket, whatever follows.
#pragma once

#include <graze/distance.hpp>
#include <graze/rotating/crossing.hpp>
#include <graze/rotating/rotating_result.hpp>

namespace graze::detail {

enum class Advance { conservative, bilateral };

struct MarchLimits {
  Advance advance = Advance::bilateral;
  double begin = 0, end = 1;  // no contact before `begin` is known
  double stop = 0;            // a gap that axes cannot close
  double touching = 0;        // a start with no more distance is in contact; 0: only what is proved
  int budget = 0;             // support evaluations
  bool record = false;        // keep the chain
};

struct March {
  Outcome outcome = Outcome::not_converged;
  double lower = 0, upper = kInfinity<double>;
  double apart = 0;  // at `lower`, at most
  Vec3<double> n = Vec3<double>::Zero();
  Simplex<double> closest;  // at `lower`
  Contact contact;          // at `upper`
  std::vector<TimeSlice> chain;
};

struct Nearest {
  double gap = 0;    // lower bound of the distance, less the target distance
  double apart = 0;  // upper bound
  Vec3<double> n = Vec3<double>::Zero();
  Simplex<double> simplex;
};

// Of the bodies as placed. `expected`: a lower bound of the gap that is known; the search may be as much
// rougher.
inline Nearest nearest(const MovingPair& pair, const Vec3<double>& start, double expected, double stop,
                       int budget, Counters& counters) {
  Nearest out;
  const Cso<double>& cso = pair.cso();
  const double R = pair.radius(), error = pair.error();
  const auto support = [&](const Vec3<double>& n) { return cso.support(n); };
  const Vec3<double> zero = Vec3<double>::Zero();
  Distance<double> d = gjk_distance(support, zero, start == zero ? Vec3<double>(-cso.middle()) : start,
                                    out.simplex, std::max(stop / 16, expected / 16), R, budget, counters);
  if (d.stalled && d.upper - d.lower > stop / 4 && d.upper > R) {
    SweepLimits<double> limits;
    limits.noise = stop / 4;
    limits.budget = budget;
    steady_axis(d, cso, out.simplex, limits, counters);
  }
  out.apart = std::max(d.upper - R, 0.0) + error;
  out.gap = d.lower - R - error;
  out.n = d.n;
  return out;
}

class Marcher {
 public:
  Marcher(MovingPair& pair, const MarchLimits& limits, Counters& counters)
      : pair_(pair), limits_(limits), counters_(counters) {}

  March operator()() {
    double t = limits_.begin, expected = 0, stride = 0;
    bool open = false;  // from out_.lower on, contact is not excluded
    while (true) {
      ++counters_.iterations;
      if (pair_.time() != t) pair_.place(t);
      const Nearest near = nearest(pair_, axis_, expected, limits_.stop, limits_.budget, counters_);
      if (near.n != Vec3<double>::Zero()) axis_ = near.n;
      if (!open) {
        keep(t, near);
      } else if (near.gap > 0 && crossed_by(t)) {  // apart again, and contact was not seen: C is thin
        return out_;
      }
      if (near.gap > 0) {
        facing_ = near.simplex;
        faced_at_ = t;
      }
      const bool apart = near.gap > limits_.stop;
      if (apart) {
        stride = 0;
        if (t >= limits_.end) return ended(open);
        const double next = counters_.supports < limits_.budget ? step(t, near.gap, expected) : t;
        if (next > t) {
          if (limits_.record && !open) out_.chain.push_back({next, axis_, AxisFrame::world});
          t = next;
          continue;
        }
        if (counters_.supports >= limits_.budget) return out_;
      }
      // Too near for axes, or for the next double of t.
      open = true;
      expected = 0;
      if (!apart || next_after(t) >= limits_.end) {
        if (contact_at(t)) return out_;
        if (t == 0 && limits_.touching > 0 && near.apart <= limits_.touching) {
          out_.outcome = Outcome::initially_overlapping;
          out_.upper = 0;
          return out_;
        }
      }
      if (t >= limits_.end || counters_.supports >= limits_.budget) return out_;
      t = stride_on(t, stride);
    }
  }

 private:
  static double next_after(double t) { return t + std::max(t * 2 * kUnitRoundoff<double>, 0x1p-500); }

  void keep(double t, const Nearest& near) {
    out_.lower = t;
    out_.apart = near.apart;
    out_.closest = near.simplex;
    out_.n = axis_;
  }

  March ended(bool open) {
    if (!open) {
      out_.outcome = Outcome::miss;
      out_.lower = kInfinity<double>;
      if (limits_.record && out_.chain.empty()) out_.chain.push_back({limits_.end, axis_, AxisFrame::world});
    }
    return out_;
  }

  bool contact_at(double t) {
    Contact contact = proved_contact(pair_, axis_, limits_.stop, limits_.budget, counters_);
    if (!contact.proved) return false;
    out_.contact = contact;
    out_.upper = t;
    out_.outcome = t > 0 ? Outcome::hit : Outcome::initially_overlapping;
    return true;
  }

  // Of flat bodies, since the last time at which they were apart for sure.
  bool crossed_by(double t) {
    if (!(faced_at_ < t) || !crosses(pair_, facing_, faced_at_, t)) return false;
    out_.upper = t;
    out_.outcome = Outcome::hit;
    return true;
  }

  double stride_on(double t, double& stride) {
    const bool known = axis_ != Vec3<double>::Zero();  // not of a start in contact
    const double fast = known ? std::max(pair_.closing(axis_), pair_.closing(-axis_)) : pair_.top_speed();
    const double bend = known ? pair_.bend(axis_) : pair_.top_bend();
    const double first = fast > 0 ? limits_.stop / fast : kInfinity<double>;
    const double most = std::max(bend > 0 ? std::sqrt(8 * limits_.stop / bend) : kInfinity<double>, first);
    stride = stride > 0 ? 2 * stride : first;
    const double next = t + std::min({stride, most, limits_.end - t});
    return next > t ? next : next_after(t);
  }

  // The end of the longest slice that is proved along axis_; `reached`: the gap there, as far as it is known.
  double step(double t, double gap, double& reached) {
    constexpr double kShort = 1 - 0x1p-10;  // leaves the slice's end apart by as much as the proof's rounding
    const double closing = pair_.closing(axis_);
    const double rest = limits_.end - t;
    reached = 0;
    const double safe = closing > 0 ? std::min(kShort * gap / closing, rest) : rest;
    if (safe >= rest) return limits_.end;
    if (limits_.advance == Advance::conservative) return t + safe;
    const double bend = pair_.bend(axis_) * (1 + 0x1p-40);
    const double root = std::sqrt(bend / 2), root_gap = std::sqrt(gap);
    // Proved with margin: of 1 part in 1,024.
    const auto proves = [&](double h, double s) {
      return s > 0 && (root_gap + std::sqrt(s)) * kShort > h * root;
    };
    const double wished = std::max(gap / 64, limits_.stop / 2);
    double h = root > 0 ? std::min(rest, 2 * root_gap / root * kShort) : rest;
    double good = 0, good_gap = gap;  // the longest step proved so far
    double bad = kInfinity<double>, bad_gap = 0;
    constexpr int kTries = 8;
    for (int i = 0; i < kTries && h > safe; ++i) {
      const double at = h >= rest ? limits_.end : t + h;
      pair_.place(at);
      const double s = pair_.gap(axis_, counters_);
      if (proves(h, s)) {
        good = h;
        good_gap = s;
        // Far enough: the end, all that the bend allows, or near the root.
        if (h >= rest || s <= 4 * wished || !(bad < kInfinity<double>)) break;
      } else {
        bad = h;
        bad_gap = s;
      }
      double next = 0;
      if (bad_gap > 0 && bad < kInfinity<double>) {
        next = (root_gap + std::sqrt(std::min(bad_gap, gap))) / root * (kShort * kShort);
        if (!(next < bad)) next = bad / 2;
      } else {
        // The secant between the last proved and the first failed, towards the gap wished for.
        next = good + (bad - good) * (good_gap - wished) / (good_gap - bad_gap);
        if (!(next > good && next < bad)) next = good + (bad - good) / 2;
      }
      h = next;
    }
    if (!(good > safe)) return t + safe;
    reached = good_gap;
    return good >= rest ? limits_.end : t + good;
  }

  MovingPair& pair_;
  const MarchLimits& limits_;
  Counters& counters_;
  March out_;
  Vec3<double> axis_ = Vec3<double>::Zero();
  Simplex<double> facing_;  // closest at the last time with a gap above 0
  double faced_at_ = kInfinity<double>;
};

inline March march(MovingPair& pair, const MarchLimits& limits, Counters& counters) {
  return Marcher(pair, limits, counters)();
}

}  // namespace graze::detail
