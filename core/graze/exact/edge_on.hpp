// The line {t v} and a C that has no area seen along v: a segment, or a point. The rare case, in exact terms.
//
// Seen as a segment: C lies in a plane parallel to v. Where that holds the line, x being an axis that is not
// parallel to it, s(c) = det(c, x, v) tells where along the segment c is seen, o at 0; the portal is two
// vertices with s < 0 < s, its plane that of their difference e and x, the walk that of walk.hpp one
// dimension lower, for the same reasons: o is moved towards the middle of the first two vertices, then along
// the segment. Seen as a point: C lies on a line along v.
#pragma once

#include <graze/exact/facet.hpp>
#include <graze/exact/walk.hpp>

namespace graze::inline GRAZE_LINKAGE::exact {

template <Scalar S>
class EdgeOnWalk {
 public:
  // first, second: vertices of C that are seen apart, or twice the same one if there are none.
  EdgeOnWalk(const Scene<S>& scene, const BeyondSearch<S>& beyond, const Line& line, const Vertex& first,
             const Vertex& second, Counters& counters)
      : scene_(scene), beyond_(beyond), line_(line), corner_{first, second}, counters_(counters) {
    size_ = first == second ? 1 : 2;
    x_ = Term::given(Vec3<double>(Vec3<double>::Unit(line.x)));
    y_ = Term::given(Vec3<double>(Vec3<double>::Unit(line.y)));
    if (line.sign < 0) std::swap(x_, y_);  // (x_ x y_).v > 0
  }

  WalkState find(bool outward = false) {
    outward_ = outward;
    return size_ == 1 ? find_point() : find_segment();
  }

  template <class Stop>
  bool refine(int toward, const Stop& stop) {
    while (goes_on(scene_, counters_)) {
      const Facet f = facet();
      Vertex w;
      if (!find_beyond(f.f1, f.f2, toward, corner_[0], w)) return false;
      previous_ = corner_;
      newest_ = w;
      if (size_ == 1) {
        corner_[0] = corner_[1] = w;
      } else {
        corner_[place(w) < 0 ? 0 : 1] = w;
      }
      if (stop(*this)) return true;
    }
    return false;
  }

  [[nodiscard]] Facet facet() const {
    Facet out{corner_[0], x_, y_, {corner_[0]}, 1};
    if (size_ == 2) {
      out.f1 = Term::difference(corner_[0], corner_[1]);
      out.f2 = x_;
      out.corner[1] = corner_[1];
      out.size = 2;
    }
    return out;
  }
  [[nodiscard]] int height_sign() const {
    const Facet f = facet();
    return scene_.determinant_sign(Term::point(f.c0), f.f1, f.f2);
  }
  // The portal before the last step, and what came in: their hull holds both portals.
  [[nodiscard]] int hull_before(std::array<Vertex, 4>& out) const {
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) out[i] = previous_[i];
    out[static_cast<std::size_t>(size_)] = newest_;
    return size_ + 1;
  }
  [[nodiscard]] const Term& miss_f1() const { return miss_f1_; }
  [[nodiscard]] const Term& miss_f2() const { return miss_f2_; }
  [[nodiscard]] int miss_sign() const { return miss_sign_; }

 private:
  WalkState misses(const Term& f1, const Term& f2, int sign) {
    miss_f1_ = f1;
    miss_f2_ = f2;
    miss_sign_ = sign;
    return WalkState::beside;
  }
  bool find_beyond(const Term& f1, const Term& f2, int sign, const Vertex& from, Vertex& out) const {
    ++counters_.supports;
    return beyond_.find(direction_of(scene_, f1, f2, sign), from, {}, out);
  }

  WalkState find_point() {
    for (const Term& axis : {x_, y_}) {
      // n = v x axis, the same for all of C
      const int s = scene_.determinant_sign(Term::point(corner_[0]), line_.v, axis);
      if (s != 0) return misses(line_.v, axis, -s);
    }
    if (outward_) return misses(line_.v, x_, 1);  // C is its own border
    return WalkState::through;
  }

  WalkState find_segment() {
    const Term e = Term::difference(corner_[0], corner_[1]);
    const int s = scene_.determinant_sign(Term::point(corner_[0]), line_.v, e);
    if (s != 0) return misses(line_.v, e, -s);
    if (outward_) return misses(line_.v, e, 1);  // C is its own border
    // det(e, x, v) > 0, so that s rises from corner_[0] to corner_[1].
    int along = scene_.determinant_sign(e, x_, line_.v);
    if (along == 0) {
      std::swap(x_, y_);
      along = scene_.determinant_sign(e, x_, line_.v);
    }
    if (along < 0) std::swap(corner_[0], corner_[1]);
    first_ = corner_;
    // Both ends on one side of o: towards it, while there is more of C.
    for (const int end : {0, 1}) {
      const std::size_t i = static_cast<std::size_t>(end);
      const int wanted = end == 0 ? -1 : 1;
      while (place(corner_[i]) != wanted && goes_on(scene_, counters_)) {
        Vertex w;
        // s grows along x_ x v, falls along v x x_.
        if (!find_beyond(x_, line_.v, wanted, corner_[i], w)) return misses(x_, line_.v, wanted);
        corner_[i] = w;
      }
    }
    return WalkState::through;
  }

  // The sign of s(c), o moved as above; never 0.
  [[nodiscard]] int place(const Vertex& c) const {
    if (const int s = scene_.determinant_sign(Term::point(c), x_, line_.v); s != 0) return s;
    const Term middle = Term::inside({first_[0], first_[1], c}, c);
    if (const int s = scene_.determinant_sign(middle, x_, line_.v); s != 0) return -s;
    return -1;  // o moves along the segment, where s rises
  }

  const Scene<S>& scene_;
  const BeyondSearch<S>& beyond_;
  const Line& line_;
  std::array<Vertex, 2> corner_, previous_, first_;
  Vertex newest_;
  int size_ = 2;
  Term x_, y_;
  bool outward_ = false;
  Term miss_f1_, miss_f2_;
  int miss_sign_ = 1;
  Counters& counters_;
};

}  // namespace graze::inline GRAZE_LINKAGE::exact
