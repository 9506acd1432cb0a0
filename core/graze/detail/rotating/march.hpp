// The safe march: steps from one contact-free time to the next until contact is proved.
//
// Internal lengths, t as the caller's. While the bodies are farther apart than `stop`, the march takes slices that an
// axis proves free of contact (slice.hpp). At smaller gaps no axis gives a useful slice. For bodies that rotate
// almost as one, the limit is the accuracy of an axis that rotates with them. Bodies within `touching` are in
// contact, if the caller accepts that as contact.
//
// Otherwise the march walks forward from there until contact is proved (contact.hpp, crossing.hpp), or the bodies are
// apart again. The first stride is one that cannot pass through more than twice `stop`. Each further stride is twice
// as long, but never so long that the unseen depth reaches `stop`. If the proof came late, the walk goes back by
// halves. The lower end of the bracket is always the time at which the walk began. A tie that the walk proves neither
// way stays open after kMostTieSupports.
//
// A `width` ends the same march earlier and changes nothing else. It ends the march if the current closest points,
// carried to a time shortly after, prove contact there. This takes no support evaluation, so a wider bracket never
// costs more of them than the least one. As the contact is proved, the verdict is the same.
#pragma once

#include <graze/detail/rotating/crossing.hpp>
#include <graze/detail/rotating/slice.hpp>
#include <graze/rotating_result.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

struct March {
  Outcome outcome = Outcome::not_converged;
  double lower = 0, upper = kInfinity<double>;
  double apart = 0;  // at `lower`, at most
  Vec3<double> n = Vec3<double>::Zero();
  Simplex<double> closest;  // at `lower`, with n
  Contact contact;          // at `upper`
  std::vector<TimeSlice> chain;
};

class Marcher {
 public:
  Marcher(MovingPair& pair, const MarchLimits& limits, Counters& counters)
      : pair_(pair),
        limits_(limits),
        counters_(counters),
        search_(pair, limits, counters),
        near_(too_near(pair, limits)) {}

  March operator()() {
    walk();
    // A cast that stays open within the stop has a location, too.
    if (out_.outcome == Outcome::not_converged && open_ && !left_to_caller_ && !is_spent()) name_contact();
    return std::move(out_);
  }

 private:
  void walk() {
    look(limits_.begin, 0);
    while (true) {
      if (now_.near.gap > near_) {
        stride_ = 0;
        if (now_.t >= limits_.end) return end();
        if (is_spent() || closes_in_hand()) return;
        if (slice_on()) {
          if (crossed()) return;
          continue;
        }
      }
      if (!open_) tie_budget_ = counters_.supports + kMostTieSupports;
      open_ = true;  // too near for axes, or for the next double of t
      search_.stop_recording();
      place(now_.t);
      if (contact_here()) return;
      left_to_caller_ = limits_.asks_start && now_.t == 0;
      if (left_to_caller_) return;
      unproved_ = now_.t;
      if (now_.t >= limits_.end || is_spent() || stays_shallow() || counters_.supports >= tie_budget_) return;
      before_.reset();
      look(stride_on(), 0);
      if (crossed()) return;
    }
  }

  // The gap below which slices make no progress. Bodies on long arms that rotate equally move fast, but hardly
  // relative to each other. World axes give slices of almost no length, and the rounding of a body's axes is larger
  // than the stop.
  static double too_near(const MovingPair& pair, const MarchLimits& limits) {
    constexpr double kAlmostAsOne = 0x1p-6;
    const double cost = std::max(pair.frame_error(AxisFrame::a), pair.frame_error(AxisFrame::b));
    const bool as_one = pair.approach_speed(limits.end) < kAlmostAsOne * pair.top_speed();
    return as_one ? std::max(limits.stop, 2 * cost) : limits.stop;
  }

  void place(double t) {
    if (pair_.time() != t) pair_.place(t);
  }

  void look(double t, double expected) {
    place(t);
    see(t, nearest(pair_, now_.near.simplex, expected, limits_.stop, limits_.budget, counters_));
  }
  void see(double t, const Nearest& near) {
    ++counters_.iterations;
    if (now_.near.gap > 0) faced_ = now_;
    now_ = {t, near};
    if (near.n != Vec3<double>::Zero()) axis_ = near.n;
    if (open_) return;
    GRAZE_ASSERT(t >= out_.lower);  // the proof so far stays valid
    met_at_lower_ = near.met;
    out_.lower = t;
    out_.apart = near.apart;
    out_.closest = near.simplex;
    out_.n = axis_;
  }

  [[nodiscard]] bool is_spent() const { return counters_.supports >= limits_.budget; }

  // False: the end of the slice is no later double. With the budget spent nothing moves on.
  bool slice_on() {
    Slice slice = search_(now_, before_);
    // A search cut short proves less than a complete one, or more. Its slice is dropped: a larger budget might not
    // find it.
    if (is_spent()) return true;
    if (!(slice.end > now_.t)) return false;
    if (limits_.record && !open_) out_.chain.push_back({slice.end, slice.axis, slice.frame});
    before_ = now_;
    if (slice.there) {
      see(slice.end, *slice.there);
    } else {
      look(slice.end, slice.expected);
    }
    return true;
  }

  void end() {
    if (open_) return;
    out_.outcome = Outcome::miss;
    out_.lower = kInfinity<double>;
    if (limits_.record && out_.chain.empty()) out_.chain.push_back({limits_.end, axis_, AxisFrame::world});
  }

  // Near enough to be contact as it is, without a proof.
  [[nodiscard]] bool is_touching(double t, const Nearest& near) const {
    return near.apart <= limits_.touching && (t == 0 || !limits_.proves_later);
  }

  bool contact_here() {
    if (now_.near.gap > limits_.stop) return false;
    out_.contact = {};
    const bool touching = is_touching(now_.t, now_.near);
    // A gap that is known to be positive leaves no contact to be proved.
    if (!(now_.near.gap > 0) && (limits_.record || !touching))
      out_.contact = proved_contact(pair_, axis_, limits_.stop, now_.near.simplex, limits_.budget, counters_);
    if (!out_.contact.proved && !touching) return false;
    if (stride_ > 0) come_back();
    out_.upper = now_.t;
    out_.outcome = now_.t > 0 ? Outcome::hit : Outcome::initially_overlapping;
    if (now_.t > 0) name_contact();
    return true;
  }
  void name_contact() {
    if (met_at_lower_ || out_.n == Vec3<double>::Zero()) out_.n = entry_normal();
  }

  // Within `width` of contact: do the current closest points, at their positions a little later, prove it? By then
  // the bodies have approached by their distance, a quarter of it for the terms that are not linear in time, and 4
  // stops for the rounding of a proof.
  bool closes_in_hand() {
    const double apart = now_.near.apart, way = fl(1.25 * apart) + 4 * limits_.stop;
    if (!(way <= limits_.width && now_.t > 0)) return false;
    // The pair returns to its time, so that the march continues as without a tolerance, to the bit.
    const double placed = pair_.time();
    if (closes_after(way)) return true;
    place(placed);
    return false;
  }
  bool closes_after(double way) {
    if (!(pair_.radius() > 0) && !(now_.near.simplex.size == 3 && may_cross())) return false;
    const double fast = search_.approach(now_), t = now_.t + way / fast;
    if (!(fast > 0 && t <= limits_.end && t > now_.t)) return false;
    Contact found;
    if (pair_.radius() > 0) {
      place(t);
      found.pairs = carried_over(pair_, now_.near.simplex);
      found.pairs.lambda = now_.near.simplex.lambda;
      Vec3<double> sum = Vec3<double>::Zero();
      for (std::size_t i = 0; i < static_cast<std::size_t>(found.pairs.size); ++i)
        sum += found.pairs.lambda[i] * found.pairs.point[i].w;
      found.proved = fl(norm(sum) * (1 + 8 * kUnitRoundoff<double>)) + contact_error(pair_) <= pair_.radius();
    } else if (crosses(pair_, now_.near.simplex, now_.t, t)) {
      found.proved = found.crossing = true;
      found.pairs = now_.near.simplex;
      found.from = now_.t;
    }
    if (!found.proved) return false;
    out_.contact = found;
    out_.upper = t;
    out_.outcome = Outcome::hit;
    return true;
  }
  // The points of a crossing have names in a proof where none is a curved part's.
  [[nodiscard]] bool may_cross() const { return !limits_.record || !pair_.cso().curved(); }

  // At `lower`, in contact or almost. The search found only that the balls about the cores meet. The normal is the
  // axis of the cores with their closest points, if the cores are apart. Otherwise it is the normal at the point at
  // which the line from the origin to C's middle enters C.
  Vec3<double> entry_normal() {
    pair_.place(out_.lower);
    const Cso<double>& cso = pair_.cso();
    if (pair_.radius() > 0) {
      Simplex<double> simplex;
      const Distance<double> d = gjk_distance(cso, Vec3<double>(Vec3<double>::Zero()), simplex,
                                              limits_.stop / 16, 0.0, limits_.budget, counters_);
      if (d.lower > pair_.error()) {
        out_.closest = simplex;
        return d.n;
      }
    }
    if (out_.n != Vec3<double>::Zero()) return out_.n;
    const Vec3<double> n = facing_from_middle();
    return n != Vec3<double>::Zero() ? n : away_from_middle(pair_);
  }
  // The normal of C's face at which the line from the origin to C's middle enters C. Zero if that is not known.
  Vec3<double> facing_from_middle() {
    const Cso<double>& cso = pair_.cso();
    if (cso.middle() == Vec3<double>::Zero()) return Vec3<double>::Zero();
    return enter_line(cso, Frame<double>(cso.middle()), kInfinity<double>, pair_.error(), limits_.budget,
                      counters_)
        .facing;
  }

  // Apart again, and contact was not seen: C is thin.
  bool crossed() {
    if (!open_ || !may_cross() || !(now_.near.gap > 0 && faced_.near.gap > 0 && faced_.t < now_.t))
      return false;
    if (!crosses(pair_, faced_.near.simplex, faced_.t, now_.t)) return false;
    out_.contact.proved = out_.contact.crossing = true;
    out_.contact.pairs = faced_.near.simplex;
    out_.contact.from = faced_.t;
    out_.upper = now_.t;
    out_.outcome = Outcome::hit;
    return true;
  }

  // If strides had grown before contact was proved, bisects for an earlier time with proved contact.
  void come_back() {
    constexpr int kHalves = 6;
    const double fast = speed_on();
    for (int i = 0; i < kHalves && (now_.t - unproved_) * fast > 3 * limits_.stop; ++i) {
      const double middle = unproved_ + (now_.t - unproved_) / 2;
      if (!(unproved_ < middle && middle < now_.t)) return;
      if (touches(middle)) {
        now_.t = middle;
      } else {
        unproved_ = middle;
      }
    }
  }

  bool touches(double t) {
    place(t);
    Contact found;
    const bool touching =
        !limits_.proves_later &&
        is_touching(t, nearest(pair_, now_.near.simplex, 0, limits_.stop, limits_.budget, counters_));
    if (!touching) {
      found = proved_contact(pair_, axis_, limits_.stop, {}, limits_.budget, counters_);
      if (!found.proved) return false;
    }
    out_.contact = found;
    return true;
  }

  // In contact the search has no axis, and the last gap's axis may belong to another face. A crate that yaws from one
  // tile onto the next meets its edge, and then rests on its top, along which nothing moves. If the axis does not
  // support C, the normal of the face that holds the origin does.
  void face_contact() {
    if (now_.near.n != Vec3<double>::Zero() || supports(axis_)) return;
    const Vec3<double> n = facing_from_middle();
    if (supports(n)) axis_ = n;
  }
  // C reaches no farther along n than the stop.
  [[nodiscard]] bool supports(const Vec3<double>& n) {
    if (n == Vec3<double>::Zero()) return false;
    ++counters_.supports;
    return dot(n, pair_.cso().support(n).w) + pair_.radius() <= limits_.stop;
  }

  // From here on, does the axis keep the bodies from being deeper in each other than the stop? Then no later contact is
  // proved either: a crate that yaws on a floor, a wheel whose rim passes it. Asked ever more seldom.
  bool stays_shallow() {
    if (asked_.waits()) return false;
    asked_.fail();
    face_contact();
    return axis_ != Vec3<double>::Zero() && search_.keeps_above(now_.t, axis_, -limits_.stop);
  }

  // How fast the gap changes at most, seen along the axis.
  [[nodiscard]] double speed_on() const {
    const double fast = pair_.approach_speed(limits_.end);
    if (axis_ == Vec3<double>::Zero()) return fast;  // of a start in contact
    return std::min(fast, std::max(pair_.closing(axis_), pair_.closing(-axis_)));
  }

  double stride_on() {
    face_contact();
    const double fast = speed_on();
    double bend = pair_.top_bend();
    if (axis_ != Vec3<double>::Zero()) {
      for (const AxisFrame frame : {AxisFrame::world, AxisFrame::a, AxisFrame::b})
        bend = std::min(bend, pair_.bend(frame, axis_, limits_.end));
    }
    const double first = fast > 0 ? 2 * limits_.stop / fast : kInfinity<double>;
    const double most = std::max(bend > 0 ? square_root(8 * limits_.stop / bend) : kInfinity<double>, first);
    stride_ = stride_ > 0 ? 2 * stride_ : first;
    const double t = now_.t, next = t + std::min({stride_, most, limits_.end - t});
    return next > t ? next : t + std::max(t * 2 * kUnitRoundoff<double>, 0x1p-500);
  }

  MovingPair& pair_;
  const MarchLimits& limits_;
  Counters& counters_;
  SliceSearch search_;
  double near_;
  March out_;
  Seen now_;
  std::optional<Seen> before_;  // the slice's beginning
  Seen faced_;                  // the last time with a gap above 0 for sure, before now
  bool met_at_lower_ = false;
  bool open_ = false;  // from out_.lower on contact is not excluded
  // Bodies that stay within the stop, as a wheel that rolls, are no nearer to a proof after as many supports.
  static constexpr int kMostTieSupports = 2048;
  int tie_budget_ = 0;
  bool left_to_caller_ = false;
  Patience asked_;  // of stays_shallow()
  double stride_ = 0;
  double unproved_ = 0;  // the last time on the way at which contact was not proved
  Vec3<double> axis_ = Vec3<double>::Zero();
};

inline March march(MovingPair& pair, const MarchLimits& limits, Counters& counters) {
  return Marcher(pair, limits, counters)();
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
