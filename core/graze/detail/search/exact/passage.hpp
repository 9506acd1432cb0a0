// Decides how the line {t v} passes C, to the extent that a query needs it: beside it, in it at t = 0, ahead or
// behind.
//
// The line is in C for t in [t_in, t_out], or never (walk.hpp). Contact at t = 0 iff t_in <= 0 <= t_out. The walk
// determines this when the portal passes the origin. For bodies at rest relative to each other, any line through the
// origin gives the answer.
//
// A motion that starts in contact leaves or slides (StartPolicy::pass_over) iff t_out = 0, or the line runs along the
// border of C, seen along v (walk.hpp, `outward`). At rest, it does so iff the origin is on C's border: also t_in =
// 0.
#pragma once

#include <graze/detail/search/exact/walk.hpp>
#include <graze/detail/search/fast/fast_walk.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

// The position of the line relative to C, to the extent that the query needs it.
enum class Passage : std::uint8_t {
  beside,   // the line misses C, or for a query about a path, the path does
  contact,  // t_in <= 0 <= t_out
  ahead,    // t_in > 0, the facet is the entry's
  behind,   // t_out < 0, the facet is the exit's
};

struct Answer {
  Passage passage = Passage::beside;
  Miss miss;  // beside
  Facet facet;
  std::array<Vertex, 4> hull;  // contact: the origin is in the hull of these
  int hull_size = 0;
};

// The portal that a quick walk ended with.
template <class Walk>
[[nodiscard]] Seeds seeds_of(const Walk& walk) {
  Seeds out;
  out.known = walk.has_portal();
  out.last = out.known && !walk.passed();
  for (std::size_t i = 0; out.known && i < 3; ++i) {
    const FastCorner& c = walk.corner(i);
    out.vertex[i] = {c.vertex_a, c.vertex_b};
  }
  return out;
}

template <Scalar S>
class PassageSearch {
 public:
  PassageSearch(const Body<S>& a, const Body<S>& b, Counters& counters)
      : a_(a),
        b_(b),
        pair_(a, b),
        counters_(counters),
        has_fast_search_(has_fast_search(a.shape) && has_fast_search(b.shape)) {}
  // For a pair that is prepared and was walked before, so that no quick walk runs first.
  PassageSearch(const PreparedPair<S>& pair, Counters& counters)
      : a_(pair.a().body()), b_(pair.b().body()), pair_(pair), counters_(counters), has_fast_search_(false) {}

  // As far as t in [0, t_max] goes: a line that is met later only may come out as one that is beside C.
  [[nodiscard]] Answer pass(double t_max = kInfinity<double>) {
    Answer out;
    Seeds seeds;
    if (!seek(t_max, seeds, out.miss)) out = pass(seeds);
    return out;
  }
  // The same of the whole line, from where another walk ended.
  [[nodiscard]] Answer pass(const Seeds& seeds) {
    Answer out;
    fuses() ? pass_fused(seeds, out) : pass_from(seeds, out);
    return out;
  }
  // t_in (toward -1) or t_out (+1) of the line.
  [[nodiscard]] Answer end(int toward) {
    Answer out;
    with_walk({}, out, [&](PortalWalk<S>& walk) {
      walk.refine(toward, [] { return false; });
      out.passage = toward < 0 ? Passage::ahead : Passage::behind;
      out.facet = walk.facet();
    });
    return out;
  }
  // In contact at t = 0: does the motion leave or slide as it begins? At rest: is the origin on C's border?
  [[nodiscard]] bool leaves_or_slides() {
    const Answer out = end(1);
    if (sign_of_time(scene(), out.facet, v()) == 0) return true;
    if (!pair_.moves()) {
      const Answer in = end(-1);
      if (sign_of_time(scene(), in.facet, v()) == 0) return true;
    }
    return slides();
  }
  // Does the line run along C's border, or pass it by?
  [[nodiscard]] bool slides() { return !PortalWalk<S>(pair_, scene(), motion(), counters_).find(true); }

  [[nodiscard]] const PreparedPair<S>& pair() const { return pair_; }
  [[nodiscard]] const Scene<S>& scene() const {
    if (!scene_) scene_.emplace(a_, b_, pair_.length_exponent(), pair_.speed_exponent());
    return *scene_;
  }
  // False: the quick walk told, and no number but doubles was needed.
  [[nodiscard]] bool has_scene() const { return scene_.has_value(); }
  [[nodiscard]] const Term& v() const { return motion().v; }

 private:
  const Line& motion() const {
    if (!line_) line_.emplace(line_of(pair_));
    return *line_;
  }
  // A path, or, at rest, a line from the origin to about the middle of C.
  static Line line_of(const PreparedPair<S>& pair) {
    if (pair.moves()) return {Term::motion(), pair.direction()};
    const Triple& r = pair.offset();
    const double size = largest(r);
    const Triple scaled_near_one = size > 0 ? power_of_two(-exponent_of(size)) * r : Triple{0, 0, 1};
    return {Term::given(scaled_near_one.vector()), scaled_near_one};
  }
  static void contact_in(const Facet& facet, Answer& out) {
    out.passage = Passage::contact;
    out.hull_size = facet.size;
    for (std::size_t i = 0; i < static_cast<std::size_t>(facet.size); ++i) out.hull[i] = facet.corner[i];
  }
  // Runs the quick walk first (fast_walk.hpp). True: it proves a miss by an axis n, as n_z n = f_1 x f_2. Here f_1 =
  // (n_z, 0, -n_x) and f_2 = (0, n_z, -n_y), z being the axis of n's largest component. False: the exact walk begins
  // at the vertices with which the quick walk ended.
  bool seek(double t_max, Seeds& seeds, Miss& miss) {
    if (!pair_.moves() || !(t_max > 0) || !has_fast_search_) return false;
    const double horizon = t_max * power_of_two(pair_.speed_exponent() - pair_.length_exponent());
    FastWalk<S, true> walk(pair_, horizon, 0, kFastSteps, counters_);
    const Seed seed = walk.seek();
    if (seed == Seed::none) return false;
    if (seed != Seed::miss) {
      seeds = seeds_of(walk);
      return false;
    }
    const Triple& n = walk.axis();
    const Triple size = magnitude(n);
    // The quick walk cuts a path at the end of C. For a longer path n proves a miss only if n.v > 0. r is within u of
    // v per component, below 2, and three products and sums are as large: 14 u |n|_1.
    if (!(horizon <= 2 * pair_.extent()) && !(dot(n, pair_.direction()) > 16 * kU * sum(size))) return false;
    const int z = largest_axis(size), x = z == 2 ? 0 : z + 1, y = 3 - z - x;
    Vec3<double> f1 = Vec3<double>::Zero(), f2 = Vec3<double>::Zero();
    f1[z] = -n[x];
    f1[x] = n[z];
    f2[z] = -n[y];
    f2[y] = n[z];
    miss = {Term::given(f1), Term::given(f2), n[z] > 0 ? 1 : -1};
    return true;
  }
  void pass_from(const Seeds& seeds, Answer& out) {
    with_walk(seeds, out, [&](PortalWalk<S>& walk) {
      const int height = walk.height_sign();
      if (height == 0) {
        contact_in(walk.facet(), out);
      } else if (walk.refine(height > 0 ? -1 : 1, [&] { return walk.height_sign() != height; })) {
        out.passage = Passage::contact;
        out.hull_size = walk.hull_before(out.hull);
      } else {
        out.passage = height > 0 ? Passage::ahead : Passage::behind;
        out.facet = walk.facet();
      }
    });
  }
  GRAZE_FUSED void pass_fused(const Seeds& seeds, Answer& out) { pass_from(seeds, out); }
  // Calls `go(walk)` once the line is found to pass through C. Otherwise determines how it misses.
  template <class Go>
  void with_walk(const Seeds& seeds, Answer& out, const Go& go) {
    PortalWalk<S> walk(pair_, scene(), motion(), counters_);
    if (walk.find(false, seeds)) {
      go(walk);
    } else {
      out.miss = walk.miss();
    }
  }

  const Body<S>&a_, &b_;
  PreparedPair<S> pair_;
  // Created when needed: a miss that the quick walk proves needs neither.
  mutable std::optional<Scene<S>> scene_;
  mutable std::optional<Line> line_;
  Counters& counters_;
  bool has_fast_search_;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
