// Computes where the path enters C = A - B. It is the GJK ray cast of two polytopes, in doubles, with guessed
// vertices. It may give up.
//
// The path is x = s r, 0 <= s <= horizon, in the units and the frame of prepared_pair.hpp.
// Notation   n = a vector from the simplex to x, of any length.   w = C's vertex along n.   h(n) = n.w.
//
// As advancement.hpp, a support point clips the path at once: if h(n) < n.x, the next x is at s = h(n) / n.r.
// But no single step has to be right, since the answer is verified at the end:
//   miss      an axis n with h(n) < n.x from the s on that another axis has proved, to the end of the path
//   hit       upper: weights >= 0 of the simplex, whose point is within the noise of the path. If nothing lies
//             beyond a triangle, the point at which the path passes it.
//             lower: h(n) / n.r for the axis that proved the last step, confirmed with the farthest vertex.
//             upper - lower is below the noise, or within the caller's tolerance if that changes no verdict
//   contact   the simplex holds the start within the noise
// If that fails, near the start, near the end of the path or after kFastRaySteps, it gives up, and the search of
// advancement.hpp answers.
// [van den Bergen 2004]
//
// Rounding: margin as in fast_walk.hpp, of which 16 u M are for n.(s r) as rounded, s <= 2 M. There s is the end of
// the path, here also the point up to which the axis before has proved that nothing is met.
#pragma once

#include <graze/detail/pairs/pair_support.hpp>
#include <graze/detail/search/fast/fast_path.hpp>
#include <graze/detail/search/fast/fast_simplex.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

inline constexpr int kFastRaySteps = 64;

template <Scalar S>
class FastRay {
 public:
  // `horizon` may be infinite. `tolerance` over scale, 0 for the noise.
  FastRay(const PreparedPair<S>& pair, double horizon, double tolerance, int budget, Counters& counters)
      : support_(pair, counters),
        counters_(counters),
        r_(pair.direction()),
        budget_(std::min(budget, kFastRaySteps)) {
    // Beyond its extent nothing of C is met.
    s_end_ = std::min(horizon, 2 * pair.extent());
    s_max_ = horizon;
    r_sq_ = dot(r_, r_);
    noise_ = support_.noise();
    tolerated_ = pair.tolerated(tolerance);
    margin_ = support_.margin();
    guess_ = pair.a().support_error() + pair.b().support_error();
    // A guess in floats decides in doubles only after a second look.
    makes_sure_ = std::same_as<S, double>;
  }

  [[nodiscard]] const FastSweep& run() {
    Triple n = fast_first_direction(support_.pair());
    if (is_small_direction(n)) return out_;
    support_.guess(n, slot_[0]);
    feature_.at[0] = 0;
    feature_.size = 1;
    if (!advance(n, slot_[0])) return out_;
    look(0);
    std::array<std::uint8_t, 4> at = feature_.at;
    std::uint32_t size = 1;
    double nearest = kInfinity<double>;
    const double fine_sq = support_.fine() * support_.fine(), noise_sq = noise_ * noise_;
    while (budget_-- > 0) {
      ++counters_.gjk_iterations;
      FastSimplex::closest(y_, at, size, feature_);
      if (feature_.size == 4 || feature_.dist_sq <= fine_sq) {
        meet();
        return out_;
      }
      n = feature_.n;
      if (is_small_direction(n)) return out_;
      const std::uint8_t free = free_slot();
      PairVertex& w = slot_[free];
      const bool face = feature_.size == 3;
      sure_ ? support_.sure(n, w) : support_.guess(n, w);
      const double size_n = sum(magnitude(n)), level = dot(n, slot_[feature_.at[0]].w);
      if (face && !(dot(n, w.w) - level > noise_ / 4 * size_n) && dot(n, r_) < 0) {
        if (makes_sure_ && !sure_) support_.sure(n, w);
        if (!(dot(n, w.w) - level > noise_ / 4 * size_n) && close(n, dot(n, w.w))) return out_;
      } else if (face && tolerated_ > noise_ && dot(n, w.w) - level <= tolerated_ * size_n &&
                 closes_early(n, dot(n, w.w), size_n)) {
        return out_;
      }
      const double before = s_, clear = dot(n, x_) - dot(n, w.w);
      const double least = feature_.dist_sq <= noise_sq ? support_.fine() * size_n : 0.0;
      if (clear > least && !advance(n, w)) return out_;
      const bool moved = s_ > before, known = holds(w);
      if (!moved && (known || !(feature_.dist_sq < nearest))) {
        if (sure_ || !makes_sure_) return out_;
        sure_ = true;
      }
      nearest = moved ? kInfinity<double> : feature_.dist_sq;
      at = feature_.at;
      size = feature_.size;
      if (!known) at[size++] = free;
      if (moved) {
        for (std::uint32_t i = 0; i < size; ++i) look(at[i]);
      } else if (!known) {
        look(free);
      }
    }
    return out_;
  }
  // A corner of the feature that was hit.
  [[nodiscard]] const PairVertex& corner(std::size_t i) const { return slot_[feature_.at[i]]; }

 private:
  // y = w - x
  void look(std::uint8_t i) {
    y_[i].x = slot_[i].w.x - x_.x;
    y_[i].y = slot_[i].w.y - x_.y;
    y_[i].z = slot_[i].w.z - x_.z;
  }
  [[nodiscard]] std::uint8_t free_slot() const {
    unsigned used = 0;
    for (std::uint32_t i = 0; i < feature_.size; ++i) used |= 1u << feature_.at[i];
    return static_cast<std::uint8_t>(std::countr_one(used));
  }
  [[nodiscard]] bool holds(const PairVertex& w) const {
    bool out = false;
    for (std::uint32_t i = 0; i < feature_.size; ++i) out = out || slot_[feature_.at[i]].is(w);
    return out;
  }
  void go_to(double s) {
    s_ = s;
    x_ = s * r_;
  }

  // Advances to the point up to which n clears the path. False if the cast is decided, or given up.
  [[gnu::always_inline]] bool advance(const Triple& n, PairVertex& w) {
    const double closing = dot(n, r_), reach = dot(n, w.w);
    if (!(closing < 0) || !(reach >= closing * s_end_)) {
      if (!(reach < closing * s_)) return true;
      if (misses(n, w)) {
        out_.outcome = Outcome::miss;
        out_.n = n;
        return false;
      }
      // The path ends where rounding cannot tell.
      return !(closing < 0);
    }
    const double next = reach / closing;
    if (next > s_) {
      go_to(next);
      axis_ = n;
      reach_ = reach;
      axis_is_sure_ = sure_;
    }
    return true;
  }
  // Does n prove that nothing is met from what the last axis proves to the end of the path? w may come out farther.
  [[gnu::noinline]] bool misses(const Triple& n, PairVertex& w) {
    const double size = sum(magnitude(n)), end = s_end_ * dot(n, r_);
    double h = dot(n, w.w);
    if (h < std::min(0.0, end) - fl((margin_ + guess_) * size)) return true;
    if (h < std::min(proved(guess_) * dot(n, r_), end) - fl((margin_ + guess_) * size)) return true;
    support_.sure(n, w);
    h = dot(n, w.w);
    if (h < std::min(0.0, end) - fl(margin_ * size)) return true;
    make_sure_of_axis();
    return h < std::min(proved(0) * dot(n, r_), end) - fl(margin_ * size);
  }
  // The error of s by the axis of the last step, whose vertex may be so far, over its length, from the farthest,
  // beyond rounding.
  [[nodiscard]] double proved(double support_error) const {
    if (!(s_ > 0)) return 0;
    const double h = reach_ + fl((margin_ + (axis_is_sure_ ? 0.0 : support_error)) * sum(magnitude(axis_)));
    return h < 0 ? h / dot(axis_, r_) * (1 - 0x1p-50) : 0.0;
  }
  void make_sure_of_axis() {
    if (axis_is_sure_ || !(s_ > 0)) return;
    PairVertex& w = slot_[4];
    support_.sure(axis_, w);
    reach_ = std::max(reach_, dot(axis_, w.w));
    axis_is_sure_ = true;
  }

  // A triangle that nothing lies beyond by more than the noise: is it where the path comes in?
  [[nodiscard]] bool close(const Triple& n, double reach) {
    const Triple &a = corner(0).w, &b = corner(1).w, &c = corner(2).w;
    const double upper = FastTriangle{a, b, c, r_, r_sq_}.pass(noise_ / 4, out_.lambda);
    const double lower = std::min(reach / dot(n, r_), upper);
    if (!is_hit(lower, upper)) return false;
    claim(n, lower, upper);
    return true;
  }
  [[nodiscard]] bool is_hit(double lower, double upper) const {
    return lower > 0 && upper < s_max_ && upper > 2 * noise_ &&
           (upper - lower) * sum(magnitude(r_)) <= noise_;
  }
  // Within the caller's tolerance already, as the quick walk has it (fast_walk.hpp): no support more, and the same verdict.
  [[nodiscard, gnu::noinline]] bool closes_early(const Triple& n, double guessed, double size) {
    const FastTriangle triangle{corner(0).w, corner(1).w, corner(2).w, r_, r_sq_};
    const double speed = sum(magnitude(r_)), along = dot(n, r_);
    if (!(along < 0) || !triangle.holds_line(2 * margin_ * support_.pair().extent() * speed)) return false;
    const double upper = triangle.pass(noise_ / 4, out_.lambda),
                 lower = std::min((guessed + fl(support_.approximate_error() * size)) / along, upper);
    if (!(lower > 2 * noise_ && upper + noise_ < s_max_ && (upper - lower) * speed <= tolerated_))
      return false;
    claim(n, lower, upper);
    return true;
  }
  void claim(const Triple& n, double lower, double upper) {
    out_.outcome = Outcome::hit;
    out_.lower = lower;
    out_.upper = upper;
    out_.n = n;
    out_.size = static_cast<int>(feature_.size);
  }
  // The simplex holds x within the noise: contact, unless a guess let x go too far.
  [[gnu::noinline]] void meet() {
    const Triple v = FastSimplex::weighted(y_, feature_, out_.lambda);
    if (!(largest(v) <= noise_ / 4)) return;
    if (!(s_ > 0)) {
      out_.outcome = Outcome::initially_overlapping;
      return;
    }
    if (makes_sure_) make_sure_of_axis();
    const double lower = std::min(reach_ / dot(axis_, r_), s_);
    if (is_hit(lower, s_)) claim(axis_, lower, s_);
  }

  PairSupport<S> support_;
  Counters& counters_;
  Triple r_, x_{0, 0, 0}, axis_{0, 0, 0};
  double r_sq_ = 1, s_ = 0, s_end_ = 0, s_max_ = 0, noise_ = 0, tolerated_ = 0, margin_ = 0, guess_ = 0,
         reach_ = 0;
  int budget_;
  bool makes_sure_ = true, sure_ = false, axis_is_sure_ = false;
  std::array<PairVertex, 5> slot_;
  FastSimplex::Points y_;
  FastFeature feature_;
  FastSweep out_;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
