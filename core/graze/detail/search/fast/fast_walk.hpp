// The quick walk: computes where the path enters C = A - B. It takes polytopes, works in doubles and may give up.
//
// The path is s r, 0 <= s <= horizon, in the units and the frame of prepared_pair.hpp.
// Notation   m(c) = c x r,   det(c, d) = det(c, d, r) = c.m(d).
//
// Portal refinement (portal.hpp) without its treatment of ties: the walk follows the signs as they are computed. No
// step has to be right, since the answer is verified at the end:
//   miss      an axis n with h(n) < min(0, n.(horizon r)), confirmed with the farthest vertex of each body
//   hit       upper: weights >= 0 of a portal whose point p is within the noise of the path, s = p.r / r.r.
//             lower: h(n) / n.r for the last normal n, however that was found.
//             upper - lower is below the target
//   contact   two portals whose points are within the noise of the line, one at s <= 0 and one at s >= 0.
//             C is convex, so the start is between them
// If that fails, near the start, near the end of the path or after kFastSteps, it gives up, and the search of
// portal.hpp answers.
//
// For a stricter walk it seeks instead. A miss is proved as above. For any other outcome it returns only the portal
// that it ended with, unverified (search/exact/walk.hpp begins there).
//
// Rounding, internal length, over |n|_1, with e = err(a) + err(b) of prepared_pair.hpp, M the extent, u in double:
//   a vertex c of C     e + the offset's error + 4 u M per component (two sums)
//   n.c                 3 u M
//   n rotated           2 e, and sums compared, 8 u M, for the farthest vertex in doubles
//   horizon n.r         12 u M, as |horizon r| <= 4 M, and r rounded, 4 u M
// Together below margin = 4 e + offset's error + 40 u M. A vertex guessed in floats is within support_error() of the
// farthest. For S = float this is below the noise, and the vertex serves as the farthest for `lower`. In all other
// places where it decides, a scan in doubles confirms it.
#pragma once

#include <graze/detail/pairs/pair_support.hpp>
#include <graze/detail/search/fast/fast_path.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// The limit of steps of the walk. Common cases need fewer.
inline constexpr int kFastSteps = 48;

struct FastCorner : PairVertex {
  Triple m;
};

// The result of a walk that seeks: nothing, a proof that the path misses, or three vertices that are about the line.
// `passed` means that the next portal lies on the other side of the origin. Otherwise it was the last.
enum class Seed : std::uint8_t { none, miss, portal, passed };

// kSeeks: it seeks a seed, for seek(). Otherwise it answers, for run(). kDecides: it decides whether, not when. Any
// portal that the path passes shows contact, within the noise as above, and a hit has no time.
template <Scalar S, bool kSeeks = false, bool kDecides = false>
class FastWalk {
 public:
  // `horizon` may be infinite. `tolerance` over scale, 0 for the noise.
  FastWalk(const PreparedPair<S>& pair, double horizon, double tolerance, int budget, Counters& counters)
      : support_(pair, counters),
        r_(pair.direction()),
        counters_(counters),
        budget_(std::min(budget, kFastSteps)) {
    r_sq_ = dot(r_, r_);
    // Beyond its extent nothing of C is met.
    end_ = std::min(horizon, 2 * pair.extent()) * r_;
    s_max_ = horizon;
    target_ = support_.noise();
    tolerated_ = pair.tolerated(tolerance);
  }

  [[nodiscard]] const FastSweep& run() {
    static_assert(!kSeeks);
    if (find()) refine();
    return out_;
  }
  // A portal for another walk to begin with: in double's noise whatever S is, and without verification.
  [[nodiscard]] Seed seek() {
    static_assert(kSeeks);
    target_ = kContact * kUnitRoundoff<double> * support_.pair().size();
    if (find()) refine();
    if (out_.outcome == Outcome::miss) return Seed::miss;
    return !has_portal() ? Seed::none : passed_ ? Seed::passed : Seed::portal;
  }
  // Error bound on n.w, over |n|_1, w the farthest vertex. It covers the path's end, up to the reach of C.
  [[nodiscard]] double margin() const { return support_.margin(); }
  [[nodiscard]] const Triple& end() const { return end_; }
  // For a miss: the axis that shows it.
  [[nodiscard]] const Triple& axis() const { return out_.n; }
  // Three vertices that are likely to be about the line. It also returns the last portal, if it found one, or the one
  // before if that passed the origin.
  [[nodiscard]] bool has_portal() const { return at_[0] != nullptr; }
  [[nodiscard]] bool passed() const { return passed_; }
  [[nodiscard]] const FastCorner& corner(std::size_t i) const { return *at_[i]; }

 private:
  using Portal = std::array<FastCorner*, 3>;

  // Puts the vertex along n into a free slot, unless n proves with it that the path misses.
  [[gnu::always_inline]] bool misses(const Triple& n, FastCorner& w) {
    support(n.x, n.y, n.z, w);
    return separates(n, w);
  }
  [[gnu::always_inline]] bool separates(const Triple& n, FastCorner& w) {
    const double along = dot(n, end_);
    if (!support_.may_separate(n, w, along)) [[likely]]
      return false;
    if (!support_.separates(n, w, lesser(along, 0))) {
      see(w);
      return false;
    }
    out_.outcome = Outcome::miss;
    out_.n = n;
    return true;
  }
  [[gnu::noinline]] void support(double x, double y, double z, FastCorner& w) {
    support_.approximate_here({x, y, z}, w);
    see(w);
  }
  [[gnu::always_inline]] void see(FastCorner& w) {
    const Triple m = cross(w.w, r_);
    w.m.x = m.x;
    w.m.y = m.y;
    w.m.z = m.z;
  }
  [[nodiscard]] static double det(const FastCorner& c, const FastCorner& d) { return dot(c.w, d.m); }

  // A triangle around the line, seen along it: det of every edge, in turn, >= 0. The line is to the left of
  // i -> j.
  bool find() {
    FastCorner *i = &slot_[0], *j = &slot_[1], *k = &slot_[2];
    Triple n = fast_first_direction(support_.pair());
    if (misses(n, *i)) return false;
    n = cross(i->m, r_);
    if (is_small_direction(n) || misses(n, *j)) return false;
    n = i->m - j->m;
    if (det(*i, *j) < 0) {
      std::swap(i, j);
      n = -n;
    }
    while (budget_-- > 0) {
      ++counters_.portal_steps;
      FastCorner& w = *k;
      if (is_small_direction(n) || misses(n, w)) return false;
      // Nothing new: the line passes within the noise of the silhouette.
      if (w.is(*i) || w.is(*j)) return false;
      const double from = dot(w.w, i->m), to = -dot(w.w, j->m);
      if (from >= 0 && to >= 0) {
        at_ = {i, j, k};
        return true;
      }
      const std::array<Triple, 2> next = {w.m - j->m, i->m - w.m};
      const bool left = from < to;
      n.x = next[left].x;
      n.y = next[left].y;
      n.z = next[left].z;
      FastCorner* const gone = left ? j : i;
      i = left ? i : k;
      j = left ? k : j;
      k = gone;
    }
    return false;
  }

  void refine() {
    FastCorner *c0 = at_[0], *c1 = at_[1], *c2 = at_[2], *free = &slot_[3], *spare = &slot_[4];
    bool entry = true;
    // Against r, at first.
    Triple n = cross(c2->w - c0->w, c1->w - c0->w);
    if (dot(n, c0->w) > 0) {
      // The portal is at s < 0: the exit is looked for, as the entry of the line that runs the other way. The
      // path ends where it did: on a needle that it crosses n comes out tilted to it, either way.
      entry = false;
      n = -n;
      r_ = -r_;
      for (FastCorner* const c : at_) c->m = -c->m;
      std::swap(c1, c2);
    }
    while (budget_-- > 0) {
      ++counters_.portal_steps;
      const double face = dot(n, c0->w), size = sum(magnitude(n));
      if (is_small_direction(n)) return;
      if (face >= 0) {
        at_ = {c0, c1, c2};
        if constexpr (!kSeeks) touch();
        // The portal before: one step from the one that shows contact.
        passed_ = before_[0] != nullptr;
        if (passed_) at_ = before_;
        return;
      }
      if constexpr (kSeeks) at_ = {c0, c1, c2};
      if constexpr (kDecides) {
        if (entry && face >= dot(n, r_) * s_max_ && is_passed({c0, c1, c2})) return;
      }
      FastCorner& w = *free;
      if (misses(n, w)) return;
      if (!(dot(n, w.w) - face > target_ / 4 * size)) {
        if constexpr (kSeeks) return;
        if constexpr (std::same_as<S, double>) {
          support_.sure(n, w);
          see(w);
          if (separates(n, w)) return;
        }
        if (!(dot(n, w.w) - face > target_ / 4 * size)) {
          at_ = {c0, c1, c2};
          if (entry) close(n, dot(n, w.w));
          return;
        }
      }
      if constexpr (!kSeeks && !kDecides) {
        if (tolerated_ > target_ && entry && closes_early({c0, c1, c2}, n, dot(n, w.w), size)) return;
      }
      // w takes the place of the corner whose opposite edge makes with it the triangle that the line passes.
      // The normals of all three are at hand before the signs are.
      const double d0 = dot(w.w, c0->m), d1 = dot(w.w, c1->m), d2 = dot(w.w, c2->m);
      const Triple e0 = c0->w - w.w, e1 = c1->w - w.w, e2 = c2->w - w.w;
      const std::array<Triple, 3> next = {cross(e2, e1), cross(e0, e2), cross(e1, e0)};
      const unsigned third = unsigned(d0 >= 0) & unsigned(d1 <= 0),
                     first = (1 - third) & unsigned(d1 >= 0) & unsigned(d2 <= 0);
      const unsigned out = 1 + third - first;
      n.x = next[out].x;
      n.y = next[out].y;
      n.z = next[out].z;
      before_[0] = c0;
      before_[1] = c1;
      before_[2] = c2;
      const Portal corner = {c0, c1, c2};
      FastCorner* const gone = corner[out];
      c0 = out == 0 ? free : c0;
      c1 = out == 1 ? free : c1;
      c2 = out == 2 ? free : c2;
      free = spare;
      spare = gone;
    }
  }

  // The parameter s at which the line passes the portal, with its weights. NaN if it does not within the noise.
  double pass(const Portal& portal, std::array<double, 4>& lambda) const {
    return FastTriangle{portal[0]->w, portal[1]->w, portal[2]->w, r_, r_sq_}.pass(support_.noise() / 4,
                                                                                  lambda);
  }
  [[nodiscard]] bool is_passed(const Portal& portal) {
    const double s = pass(portal, out_.lambda);
    if (!(0 <= s && s <= s_max_)) return false;
    out_.outcome = Outcome::hit;
    return true;
  }
  // The portal before the last step and this one lie on either side of the start.
  void touch() {
    std::array<double, 4> lambda;
    const double s = pass(at_, lambda), before = before_[0] ? pass(before_, lambda) : s;
    if (s * before <= 0) out_.outcome = Outcome::initially_overlapping;
  }
  void close(const Triple& n, double reach) {
    const double upper = pass(at_, out_.lambda), lower = std::min(reach / dot(n, r_), upper);
    const double speed = sum(magnitude(r_));
    const bool sure =
        lower > 0 && upper < s_max_ && upper > 2 * support_.noise() && (upper - lower) * speed <= target_;
    if (!sure) return;
    out_.outcome = Outcome::hit;
    out_.lower = lower;
    out_.upper = upper;
    out_.n = n;
    out_.size = 3;
  }

  // Within the caller's tolerance already, on the way that the walk takes anyway: so a tolerance costs no support. It moves
  // no verdict either: the line passes the portal, of vertices of C, and the start is apart, both beyond rounding.
  // Otherwise the walk continues to the noise. A corner errs by less than margin / 4 per component. So det(c, d, r),
  // |c| and |d| at most M, errs by 2 sqrt(3) / 4 margin M |r|, and by a fifth of that for its products, as 40 u M is
  // in the margin.
  [[nodiscard, gnu::noinline]] bool closes_early(const Portal& portal, const Triple& n, double guessed,
                                                 double size) {
    const double speed = sum(magnitude(r_)), along = dot(n, r_);
    const double inside = 2 * support_.margin() * support_.pair().extent() * speed;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(det(*portal[i], *portal[(i + 1) % 3]) > inside)) return false;
    }
    std::array<double, 4> lambda;
    const double upper = pass(portal, lambda),
                 lower = std::min((guessed + fl(support_.approximate_error() * size)) / along, upper);
    const bool sure = along < 0 && lower > 2 * support_.noise() && upper + support_.noise() < s_max_ &&
                      (upper - lower) * speed <= tolerated_;
    if (!sure) return false;
    at_ = portal;
    out_.lambda = lambda;
    out_.outcome = Outcome::hit;
    out_.lower = lower;
    out_.upper = upper;
    out_.n = n;
    out_.size = 3;
    return true;
  }

  PairSupport<S> support_;
  Triple r_, end_;  // end_: end of the path, at most the reach of C
  Counters& counters_;
  int budget_;
  bool passed_ = false;
  double r_sq_ = 1, s_max_ = 0, target_ = 0, tolerated_ = 0;
  // Three of the portal, the one that is new, the one that the last step took out.
  std::array<FastCorner, 5> slot_;
  Portal at_{}, before_{};
  FastSweep out_;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
