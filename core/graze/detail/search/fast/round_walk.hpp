// Computes where the path enters C = K + ball(R). K = A - B the difference of two cores that are polytopes, R > 0
// their radii and the target distance: spheres, capsules, rounded polytopes, and polytopes at a distance. It works in
// doubles and may give up.
//
// The path is s r, 0 <= s <= s_end, in the units and the frame of prepared_pair.hpp.
// Notation   F   up to three corners of K, the feature that the path is expected to meet.   x = s r
//            p   the point of F's hull nearest to x.   n = x - p
// Contact with a feature has a closed form. A corner's ball gives a quadratic, an edge's cylinder the same across the
// edge, and a face's plane is moved by R. So the walk does not compute the support point along n at the x that it has
// proved, as the GJK ray cast does, but at the point where F would be met. If K has nothing beyond p there, F was the
// feature, and its time is the answer. Otherwise the new point joins F, which keeps the part nearest to the path.
// No step has to be right, since the answer is verified at the end:
//   miss      an axis n with h(n) + R |n| < n.(s r) from the s on that others have proved, to the end of the path
//   hit       |x - p| <= R up to the noise, p in K, and h(n) + R |n| <= n.x up to the noise
//   contact   |p| <= R at x = 0
// The walk from below comes from [van den Bergen 2004].
//
// Rounding, over |n|_1, as in fast_walk.hpp with M + R for M, since contact is at |s r| <= M + R. In addition R |n|
// errs by 3 u R |n| of the sum of three, 4 u R |n| of the norm and 2 u of the sum that it joins. Together below
// margin = 4 e + offset's error + 64 u (M + R).
#pragma once

#include <graze/detail/pairs/pair_support.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// A ball about a shape whose vertices a walk takes as they are.
template <Scalar S>
[[nodiscard]] bool is_round(const Shape<S>& shape) {
  return std::holds_alternative<Sphere<S>>(shape) || std::holds_alternative<Capsule<S>>(shape) ||
         has_fast_search(without_ball(shape));
}

inline constexpr int kRoundSteps = 32;

// Error bound on a point of K, per component: e + the offset's error + 4 u M (fast_walk.hpp).
template <Scalar S>
[[nodiscard]] double point_error(const PreparedPair<S>& pair) {
  return pair.a().error() + pair.b().error() + pair.offset_error() +
         4 * kUnitRoundoff<double> * pair.extent();
}

// outcome not_converged: it gave up.
struct RoundSweep {
  Outcome outcome = Outcome::not_converged;
  double lower = 0, upper = 0;  // hit: of s
  Triple n{0, 0, 0};            // axis of a hit or a miss, for a hit from the nearest point at upper
  double length = 0;            // |n|
  Triple normal{0, 0, 0};       // hit: the axis of lower, of length 1
  double reach = 0;             // hit: n.w for the farthest vertex that was found along n
  int size = 0;                 // of F
  std::array<double, 3> lambda{};
};

template <Scalar S>
class RoundWalk {
 public:
  // `unit`: the roundoff whose noise is contact.
  RoundWalk(const PreparedPair<S>& pair, double horizon, double tolerance, int budget, Counters& counters,
            double unit = double(kUnitRoundoff<S>))
      : pair_(pair),
        support_(pair, counters),
        counters_(counters),
        r_(pair.direction()),
        radius_(pair.radius()) {
    budget_ = std::min(budget, kRoundSteps);
    r_sq_ = dot(r_, r_);
    // |r| >= 1: beyond, nothing of C is met.
    s_end_ = std::min(horizon, 2 * (pair.extent() + radius_));
    end_ = s_end_ * r_;
    noise_ = kContact * unit * pair.size();
    target_ = std::max(noise_, pair.tolerated(tolerance));
    margin_ = pair.ball_margin();
    guess_ = pair.a().support_error() + pair.b().support_error();
  }

  [[nodiscard]] const RoundSweep& run() {
    // With balls that dwarf the path's lengths, products would lose their range.
    if (!(radius_ < 0x1p100)) return out_;
    if (!begin()) return out_;
    while (out_.outcome == Outcome::not_converged && counters_.supports < budget_) {
      ++counters_.iterations;
      if (!step()) break;
    }
    return out_;
  }
  [[nodiscard]] const PairVertex& corner(std::size_t i) const { return f_[i]; }
  // The point of F nearest to x, and its weights.
  Triple nearest(const Triple& x, std::array<double, 3>& lambda) const {
    if (size_ == 1) {
      lambda = {1, 0, 0};
      return f_[0].w;
    }
    if (size_ == 2) {
      const double l = on_edge(f_[0].w, f_[1].w, x);
      lambda = {1 - l, l, 0};
      return f_[0].w + l * (f_[1].w - f_[0].w);
    }
    return on_triangle(f_[0].w, f_[1].w, f_[2].w, x, lambda);
  }

 private:
  static double on_edge(const Triple& a, const Triple& b, const Triple& x) {
    const Triple e = b - a;
    const double length_sq = dot(e, e), along = dot(x - a, e);
    if (!(along > 0)) return 0;
    return along < length_sq ? along / length_sq : 1;
  }
  // [Ericson 2005, 5.1.5]
  static Triple on_triangle(const Triple& a, const Triple& b, const Triple& c, const Triple& x,
                            std::array<double, 3>& l) {
    const Triple ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
    const double d1 = dot(ab, ax), d2 = dot(ac, ax), d3 = dot(ab, bx), d4 = dot(ac, bx), d5 = dot(ab, cx),
                 d6 = dot(ac, cx);
    const double l_c = fl(d1 * d4) - fl(d3 * d2), l_b = fl(d5 * d2) - fl(d1 * d6),
                 l_a = fl(d3 * d6) - fl(d5 * d4);
    if (d1 <= 0 && d2 <= 0) {
      l = {1, 0, 0};
    } else if (d3 >= 0 && d4 <= d3) {
      l = {0, 1, 0};
    } else if (d6 >= 0 && d5 <= d6) {
      l = {0, 0, 1};
    } else if (l_c <= 0 && d1 >= 0 && d3 <= 0) {
      const double t = d1 / (d1 - d3);
      l = {1 - t, t, 0};
    } else if (l_b <= 0 && d2 >= 0 && d6 <= 0) {
      const double t = d2 / (d2 - d6);
      l = {1 - t, 0, t};
    } else if (l_a <= 0 && d4 >= d3 && d5 >= d6) {
      const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
      l = {0, 1 - t, t};
    } else {
      const double one = 1 / (l_a + l_b + l_c);
      l = {l_a * one, l_b * one, l_c * one};
    }
    return a + (l[1] * ab + l[2] * ac);
  }
  // On a sliver the weights of the point nearest to x round by u |edges|^2 / f_sq of its length, and |x - p| hardly
  // shows it: p is `point`, in the plane. The remainder is solved for again.
  void correct(const Triple& point, std::array<double, 3>& l) const {
    if (!(l[0] > 0 && l[1] > 0 && l[2] > 0)) return;
    const Triple ab = f_[1].w - f_[0].w, ac = f_[2].w - f_[0].w, f = cross(ab, ac);
    const double f_sq = dot(f, f);
    if (!(f_sq > kLeast * kLeast)) return;
    const Triple left = (point - f_[0].w) - (l[1] * ab + l[2] * ac);
    const double b = l[1] + dot(cross(left, ac), f) / f_sq, c = l[2] + dot(cross(ab, left), f) / f_sq;
    if (b > 0 && c > 0 && b + c < 1) l = {1 - (b + c), b, c};
  }
  void keep(const std::array<double, 3>& lambda) {
    int kept = 0;
    for (int i = 0; i < size_; ++i) {
      if (lambda[std::size_t(i)] > 0) f_[std::size_t(kept++)] = f_[std::size_t(i)];
    }
    size_ = kept;
  }
  // F becomes what of it is nearest to x: of four corners, the last of which is new, on the faces with that.
  void reduce(const Triple& x) {
    std::array<double, 3> lambda;
    if (size_ == 1) return;
    if (size_ < 4) {
      nearest(x, lambda);
      return keep(lambda);
    }
    double least = kInfinity<double>;
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, 3> l;
      const Triple y =
          x - on_triangle(f_[i == 0 ? 3 : 0].w, f_[i == 1 ? 3 : 1].w, f_[i == 2 ? 3 : 2].w, x, l);
      if (const double dist_sq = dot(y, y); dist_sq < least) {
        least = dist_sq;
        left_out = i;
        lambda = l;
      }
    }
    f_[left_out] = f_[3];
    size_ = 3;
    keep(lambda);
  }

  // The parameter at which the path meets, or passes nearest, the corner, edge or plane of the points of F that have
  // a weight, rounded.
  [[nodiscard]] double meets(const std::array<double, 3>& lambda) const {
    std::array<std::size_t, 3> at{};
    int size = 0;
    for (std::size_t i = 0; i < std::size_t(size_); ++i) {
      if (lambda[i] > 0) at[std::size_t(size++)] = i;
    }
    const Triple &w = f_[at[0]].w, &w_1 = f_[at[1]].w, &w_2 = f_[at[2]].w;
    if (size == 1) {
      const Triple m = cross(w, r_);
      return (dot(w, r_) - square_root(std::max(fl(r_sq_ * radius_ * radius_) - dot(m, m), 0.0))) / r_sq_;
    }
    if (size == 2) {
      // m.e / |e| is the area that r and w span across the edge.
      const Triple e = w_1 - w, across = cross(e, r_);
      const double e_sq = dot(e, e), rate_sq = dot(across, across);  // rate_sq = |e|^2 |r across e|^2
      if (!(rate_sq > 0x1p-60 * e_sq)) return s_low_;
      const double area = dot(w, across), middle = dot(cross(e, w), across);
      return (middle -
              square_root(std::max(fl(rate_sq * radius_ * radius_ * e_sq) - fl(e_sq * area * area), 0.0))) /
             rate_sq;
    }
    Triple f = cross(w_1 - w, w_2 - w);
    if (dot(f, s_low_ * r_ - w) < 0) f = -f;
    const double rate = dot(f, r_);
    if (!(rate < 0)) return s_low_;
    return (dot(f, w) + fl(radius_ * square_root(dot(f, f)))) / rate;
  }

  // Nothing of C is beyond a ball about the middle. The path is followed from the point at which it meets that ball.
  // The first corner: about where a ball as large as K would be met.
  [[nodiscard]] bool begin() {
    const Triple c = -pair_.offset(), beside = r_sq_ * c - dot(c, r_) * r_;
    const double along = dot(c, r_), reach = pair_.a().reach() + pair_.b().reach();
    // |c - s r|^2 r.r = |beside|^2 / r.r + (s r.r - c.r)^2
    const double beside_sq = dot(beside, beside) / r_sq_,
                 all = fl((reach + radius_) * (1 + 0x1p-40)) + margin_, all_sq = all * all * r_sq_;
    if (beside_sq > all_sq) {
      out_.outcome = Outcome::miss;
      set(-beside, square_root(dot(beside, beside)), 0, {});
      return false;
    }
    s_low_ = std::max((along - square_root(std::max(all_sq - beside_sq, 0.0))) / r_sq_ - margin_, 0.0);
    low_axis_ = s_low_ * r_ - c;
    const double ball = (fl(0.58 * reach) + radius_) * r_sq_,
                 room = std::max(fl(ball * ball) - fl(r_sq_ * beside_sq), 0.0);
    Triple n = -(ball * beside + room * r_);
    if (!(largest(n) > 0)) n = -r_;
    support_.guess((1 / largest(n)) * n, f_[0]);
    size_ = 1;
    return true;
  }

  [[nodiscard]] bool step() {
    reduce(s_low_ * r_);
    std::array<double, 3> lambda = {1, 1, 1};
    double s = ahead_ ? std::min(std::max(meets(lambda), s_low_), s_end_) : s_low_;
    Triple x = s * r_, n = x - nearest(x, lambda);
    for (int i = 1; ahead_ && i < size_ &&
                    std::any_of(lambda.begin(), lambda.begin() + size_, [](double l) { return l <= 0; });
         ++i) {
      // F's own point is at its border: that is met.
      s = std::min(std::max(meets(lambda), s_low_), s_end_);
      x = s * r_;
      n = x - nearest(x, lambda);
    }
    double length = square_root(dot(n, n)), rate = dot(n, r_);
    // Newton's steps follow if F's own point is at its border. They also correct the rounding of the closed form.
    const auto comes_in = [&] { return rate < -kComingIn * length; };
    for (int i = 0; ahead_ && i < 4 && std::abs(length - radius_) > noise_ / 32 && comes_in(); ++i) {
      const double next = std::min(std::max(s + (length - radius_) * length / -rate, s_low_), s_end_);
      if (next == s) break;
      s = next;
      x = s * r_;
      n = x - nearest(x, lambda);
      length = square_root(dot(n, n));
      rate = dot(n, r_);
    }
    const double apart = length - radius_;
    if (s <= 0 && apart <= 0) {
      out_.outcome = Outcome::initially_overlapping;
      set(n, length, 0, lambda);
      return true;
    }
    if (!(largest(n) > kLeast)) return false;
    if (size_ == 3 && lambda[0] > 0 && lambda[1] > 0 && lambda[2] > 0) {
      // A face's normal is known by its edges better than by a distance.
      const Triple f = cross(f_[1].w - f_[0].w, f_[2].w - f_[0].w);
      const double f_length = square_root(dot(f, f));
      if (f_length > kLeast) n = (std::copysign(length, dot(f, n)) / f_length) * f;
      rate = dot(n, r_);
    }
    PairVertex& w = f_[std::size_t(size_)];
    support_.guess(n, w);
    const double ball = radius_ * length, at = dot(n, x), slack = margin_ * sum(magnitude(n));
    double h = dot(n, w.w) + ball;
    // Nothing is met before what is proved so far.
    const double bound = std::min(s_low_ * rate, dot(n, end_));
    const bool ends = h - at <= noise_ / 2 * length && guess_ > noise_,
               sure = ends || (h < bound - slack && !(h < bound - slack - fl(guess_ * length)));
    if (sure) {
      support_.sure(n, w);
      h = dot(n, w.w) + ball;
    }
    if (h < bound - slack) {
      out_.outcome = Outcome::miss;
      set(n, length, 0, lambda);
      return true;
    }
    const double before = s_low_;
    // A vertex guessed in floats may lie this far below the farthest.
    const double most = h + slack + (sure ? 0.0 : guess_ * length);
    if (rate < 0 && most < 0) {
      if (const double low = std::min(most / rate, s_end_); low > s_low_) {
        s_low_ = low;
        low_axis_ = n;
      }
    }
    ahead_ = !ahead_ || s_low_ > before;
    // The path comes in: where R is below the noise, the side of a flat C that x lies on is rounding, and C has both for
    // its border.
    const bool met = std::abs(apart) <= noise_ / 8 && s > 0 && s < s_end_ && rate < 0;
    // If only the caller's tolerance closes the bracket, the hit is accepted only if its verdict is certain.
    const bool is_near = met && (s - s_low_) * square_root(r_sq_) <= target_ && target_ > noise_ &&
                         s_low_ > 2 * noise_ && s + noise_ < s_end_;
    if (met && (h - at <= noise_ / 2 * length || is_near)) {
      if (size_ == 3) correct(x - n, lambda);
      out_.outcome = Outcome::hit;
      out_.lower = is_near ? std::min(s_low_, s) : s;
      out_.upper = s;
      out_.normal = is_near ? (1 / square_root(dot(low_axis_, low_axis_))) * low_axis_ : (1 / length) * n;
      set(n, length, h - ball, lambda);
      return true;
    }
    for (int i = 0; i < size_; ++i) {
      const PairVertex& c = f_[std::size_t(i)];
      // There is nothing new, so the path continues to the end of the axis.
      if (c.is(w)) return s_low_ > before + noise_ / 8 || ++stalls_ < 4;
    }
    ++size_;
    return true;
  }
  void set(const Triple& n, double length, double reach, const std::array<double, 3>& lambda) {
    out_.n = n;
    out_.length = length;
    out_.reach = reach;
    out_.size = size_;
    out_.lambda = lambda;
  }

  static constexpr double kLeast = 0x1p-60;
  // At the point where the path passes F nearest, n.r is rounding.
  static constexpr double kComingIn = 0x1p-26;

  const PreparedPair<S>& pair_;
  PairSupport<S> support_;
  Counters& counters_;
  Triple r_, end_;
  Triple low_axis_{0, 0, 0};  // C has nothing of the path before s_low_ r along it
  double radius_, r_sq_ = 1, s_low_ = 0, s_end_ = 0, noise_ = 0, target_ = 0, margin_ = 0, guess_ = 0;
  int budget_, size_ = 0, stalls_ = 0;
  bool ahead_ =
      true;  // look where F would be met, else from the x that is proved, which always brings F nearer
  std::array<PairVertex, 4> f_;
  RoundSweep out_;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
