// Decides whether two polytopes touch. It is MPR in doubles, with guessed vertices. It may give up.
//
// Notation   v0 = a point inside C = A - B.   The portal v1 v2 v3 is a triangle of C that the ray from v0 through the
// origin passes, refined outward.   n = the portal's outward normal.
//
// As fast_walk.hpp, it follows the signs as they are computed, and verifies the answer at the end:
//   apart     an axis n with h(n) < 0 beyond rounding, confirmed with the farthest vertex
//   contact   a convex combination of v0 and the portal within an eighth of the noise of the origin
// The first direction, from v0 to the origin, separates most bodies that are apart, with one support.
// A start (warm_start.hpp) puts an axis, or a portal, before that. It is a guess like any other.
// [Snethen, XenoCollide, in Game Programming Gems 7, 2008]
#pragma once

#include <graze/detail/pairs/pair_support.hpp>
#include <graze/warm_start.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
class FastOverlap {
 public:
  FastOverlap(const PreparedPair<S>& pair, Counters& counters)
      : support_(pair, counters), counters_(counters) {}

  // not_converged: it gave up.
  [[nodiscard]] Outcome run(const WarmStart& start) {
    if (start.has_axis() && tries(triple(start.axis))) return Outcome::miss;
    inside_ = support_.pair().a().inside() - (support_.pair().b().inside() + support_.pair().offset());
    v0_ = scaled_near_one(inside_);
    if (start.size == 3 && adopt(start)) {
      const Outcome out = refine();
      if (out != Outcome::not_converged) return out;
    }
    return find() ? refine() : out_;
  }
  // Set for a miss, any length.
  [[nodiscard]] const Triple& axis() const { return n_; }
  // For the next question about the pair.
  [[nodiscard]] WarmStart warm(Outcome outcome) const {
    WarmStart out;
    if (outcome == Outcome::miss) out.axis = n_.vector();
    if (outcome != Outcome::initially_overlapping || portal_[2] == nullptr) return out;
    for (std::size_t i = 0; i < 3; ++i) {
      out.vertex_a[i] = portal_[i]->vertex_a;
      out.vertex_b[i] = portal_[i]->vertex_b;
    }
    out.size = 3;
    return out;
  }

 private:
  [[nodiscard]] bool tries(const Triple& n) {
    n_ = n;
    support_.guess(n_, slot_[0]);
    return support_.separates(n_, slot_[0]);
  }
  // Along n: false if it ends the search, apart or out of the range of directions.
  [[nodiscard]] bool go(const Triple& n, PairVertex& out) {
    n_.x = n.x;
    n_.y = n.y;
    n_.z = n.z;
    if (is_small_direction(n_)) return false;
    support_.guess(n_, out);
    if (!support_.separates(n_, out)) return true;
    out_ = Outcome::miss;
    return false;
  }

  // The portal of a former answer, where the ray still passes it.
  [[nodiscard]] bool adopt(const WarmStart& start) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!support_.has(start.vertex_a[i], start.vertex_b[i])) return false;
      support_.at(start.vertex_a[i], start.vertex_b[i], slot_[i]);
    }
    PairVertex *v1 = &slot_[0], *v2 = &slot_[1], *v3 = &slot_[2];
    const Triple m1 = cross(v2->w, v3->w), m2 = cross(v3->w, v1->w), m3 = cross(v1->w, v2->w);
    const double d1 = dot(m1, v0_), d2 = dot(m2, v0_), d3 = dot(m3, v0_);
    if (!((d1 <= 0 && d2 <= 0 && d3 <= 0) || (d1 >= 0 && d2 >= 0 && d3 >= 0))) return false;
    if (d1 + d2 + d3 > 0) std::swap(v1, v2);
    portal_ = {v1, v2, v3};
    // Before v0, not behind it.
    const Triple n = cross(v2->w - v1->w, v3->w - v1->w);
    return dot(n, v1->w) > dot(n, inside_);
  }

  // A triangle of C that the ray from v0 through the origin passes.
  [[nodiscard]] bool find() {
    PairVertex *v1 = &slot_[0], *v2 = &slot_[1], *v3 = &slot_[2];
    if (!(largest(inside_) > support_.noise() / 16)) {
      out_ = Outcome::initially_overlapping;
      return false;
    }
    if (!go(-v0_, *v1)) return false;
    if (!go(cross(v1->w, v0_), *v2)) return false;
    Triple n = cross(v1->w - inside_, v2->w - inside_);
    if (dot(n, v0_) > 0) {
      std::swap(v1, v2);
      n = -n;
    }
    for (int step = 0; step < kFastOverlapSteps; ++step) {
      ++counters_.portal_steps;
      if (!go(n, *v3)) return false;
      if (dot(cross(v1->w, v3->w), v0_) < 0) {
        std::swap(v2, v3);
      } else if (dot(cross(v3->w, v2->w), v0_) < 0) {
        std::swap(v1, v3);
      } else {
        portal_ = {v1, v2, v3};
        return true;
      }
      n = cross(v1->w - inside_, v2->w - inside_);
    }
    return false;
  }

  [[nodiscard]] Outcome refine() {
    PairVertex *v1 = portal_[0], *v2 = portal_[1], *v3 = portal_[2], *v4 = &slot_[3];
    out_ = Outcome::not_converged;
    for (int step = 0; step < kFastOverlapSteps; ++step) {
      ++counters_.portal_steps;
      portal_ = {v1, v2, v3};
      const Triple n = cross(v2->w - v1->w, v3->w - v1->w);
      const double face = dot(n, v1->w);
      if (face >= 0) return holds() ? Outcome::initially_overlapping : Outcome::not_converged;
      if (!go(n, *v4)) return out_;
      // No farther: the surface, and the origin outside it by less than rounding can tell.
      if (!(dot(n, v4->w) - face > support_.noise() / 8 * sum(magnitude(n))))
        return holds() ? Outcome::initially_overlapping : Outcome::not_converged;
      const Triple m = cross(v4->w, v0_);
      const bool first = dot(v1->w, m) > 0, second = dot(v2->w, m) > 0, third = dot(v3->w, m) > 0;
      PairVertex*& gone = first ? (second ? v1 : v3) : (third ? v2 : v1);
      std::swap(gone, v4);
    }
    return Outcome::not_converged;
  }

  // Is the origin a convex combination of v0 and the portal, within an eighth of the noise?
  [[nodiscard]] bool holds() const {
    const Triple &w1 = portal_[0]->w, &w2 = portal_[1]->w, &w3 = portal_[2]->w;
    double l1 = std::max(-dot(cross(w2, w3), v0_), 0.0), l2 = std::max(-dot(cross(w3, w1), v0_), 0.0),
           l3 = std::max(-dot(cross(w1, w2), v0_), 0.0);
    const double one = 1 / (l1 + l2 + l3);
    l1 *= one;
    l2 *= one;
    l3 *= one;
    // The point at which the ray passes the portal. The origin is beside the line from there to v0, or beyond the
    // portal.
    const Triple p = l1 * w1 + l2 * w2 + l3 * w3;
    const double along = std::max(-dot(p, v0_) / dot(v0_, v0_), 0.0);
    return largest(p + along * v0_) <= support_.noise() / 8;
  }

  static constexpr int kFastOverlapSteps = 48;  // what takes longer is no common case

  PairSupport<S> support_;
  Counters& counters_;
  Triple inside_{0, 0, 0}, v0_{0, 0, 0}, n_{0, 0, 0};  // v0, as it is and with its largest component near 1
  Outcome out_ = Outcome::not_converged;
  std::array<PairVertex, 4> slot_;
  std::array<PairVertex*, 3> portal_{};
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
