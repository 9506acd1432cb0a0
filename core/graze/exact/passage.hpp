// What the line {t v} does with C, as far as a question needs it: beside it, in it at t = 0, ahead or behind.
//
// The line is in C for t in [t_in, t_out], or never (walk.hpp, edge_on.hpp). Contact at t = 0 iff
// t_in <= 0 <= t_out: seen on the way, as the portal passes the origin. Bodies at rest relative to each
// other: any line through the origin answers.
//
// A motion that starts in contact leaves or slides (StartPolicy::pass_over) iff t_out = 0, or the line runs
// along the border of C, seen along v (walk.hpp, `outward`); at rest, iff the origin is on C's border: also
// t_in = 0.
#pragma once

#include <graze/exact/edge_on.hpp>

namespace graze::inline GRAZE_LINKAGE::exact {

// What the line does, as far as the question needs it.
enum class Passage : std::uint8_t {
  beside,   // it misses C
  contact,  // t_in <= 0 <= t_out
  ahead,    // t_in > 0; the facet is the entry's
  behind,   // t_out < 0; the facet is the exit's
};

struct Answer {
  Passage passage = Passage::beside;
  Term miss_f1, miss_f2;  // beside: n = miss_sign (f1 x f2) has n.v = 0, h(n) < 0
  int miss_sign = 1;
  Facet facet;
  std::array<Vertex, 4> hull;  // contact: the origin is in the hull of these
  int hull_size = 0;
};

template <Scalar S>
class PassageSearch {
 public:
  PassageSearch(const Body<S>& a, const Body<S>& b, Counters& counters)
      : pair_(a, b),
        scene_(a, b, pair_.length_exponent(), pair_.speed_exponent()),
        line_(line_of(pair_)),
        counters_(counters) {}

  [[nodiscard]] Answer pass() {
    return with_walk(false, [&](auto& walk) {
      Answer out;
      const int height = walk.height_sign();
      if (height == 0) {
        contact_in(walk.facet(), out);
      } else {
        const bool met =
            walk.refine(height > 0 ? -1 : 1, [&](const auto& w) { return w.height_sign() != height; });
        if (met) {
          out.passage = Passage::contact;
          out.hull_size = walk.hull_before(out.hull);
        } else {
          out.passage = height > 0 ? Passage::ahead : Passage::behind;
          out.facet = walk.facet();
        }
      }
      return out;
    });
  }
  // t_in (toward -1) or t_out (+1) of the line.
  [[nodiscard]] Answer end(int toward) {
    return with_walk(false, [&](auto& walk) {
      Answer out;
      walk.refine(toward, [](const auto&) { return false; });
      out.passage = toward < 0 ? Passage::ahead : Passage::behind;
      out.facet = walk.facet();
      return out;
    });
  }
  // In contact at t = 0: does the motion leave or slide as it begins? At rest: is the origin on C's border?
  [[nodiscard]] bool leaves_or_slides() {
    const Answer out = end(1);
    if (compare_time(scene_, out.facet, line_.v, 0.0) == 0) return true;
    if (!pair_.moves()) {
      const Answer in = end(-1);
      if (compare_time(scene_, in.facet, line_.v, 0.0) == 0) return true;
    }
    return with_walk(true, [](auto&) {
             Answer inside;
             inside.passage = Passage::contact;
             return inside;
           }).passage == Passage::beside;
  }

  [[nodiscard]] const GuidedPair<S>& pair() const { return pair_; }
  [[nodiscard]] const Scene<S>& scene() const { return scene_; }
  [[nodiscard]] const Term& v() const { return line_.v; }

 private:
  // A path, or, at rest, a line from the origin to about the middle of C.
  static Line line_of(const GuidedPair<S>& pair) {
    if (pair.moves()) return {Term::motion(), pair.direction()};
    const Triple& r = pair.offset();
    const double size = largest(r);
    const Triple near_one = size > 0 ? power_of_two(-exponent_of(size)) * r : Triple{0, 0, 1};
    return {Term::given(near_one.vector()), near_one};
  }
  static void contact_in(const Facet& facet, Answer& out) {
    out.passage = Passage::contact;
    out.hull_size = facet.size;
    for (std::size_t i = 0; i < static_cast<std::size_t>(facet.size); ++i) out.hull[i] = facet.corner[i];
  }
  // `go(walk)` once the line is found to pass through C.
  template <class Go>
  Answer with_walk(bool outward, const Go& go) {
    const auto missed = [](const auto& walk) {
      Answer out;
      out.miss_f1 = walk.miss_f1();
      out.miss_f2 = walk.miss_f2();
      out.miss_sign = walk.miss_sign();
      return out;
    };
    PortalWalk<S> walk(pair_, scene_, line_, counters_);
    const WalkState state = walk.find(outward);
    if (state == WalkState::beside) return missed(walk);
    if (state == WalkState::through) return go(walk);
    EdgeOnWalk<S> flat(scene_, walk.beyond(), line_, walk.first(), walk.second(), counters_);
    if (flat.find(outward) == WalkState::beside) return missed(flat);
    return go(flat);
  }

  GuidedPair<S> pair_;
  Scene<S> scene_;
  Line line_;
  Counters& counters_;
};

}  // namespace graze::inline GRAZE_LINKAGE::exact
