// Computes where the path enters C = K + ball(R). Here K = A - B, where A or B is a cylinder, a cone or an ellipsoid.
// It works in doubles and may give up.
//
// The path is s r, 0 <= s <= horizon, in the units and the frame of prepared_pair.hpp. With the axis n at n.r/|r| =
// -1, the time of impact times |r| is the largest -h(n): a convex function of (x, y) in n = -r/|r| + x e + y f. h is
// the largest of h_k, one for each pair of pieces of A and B (prepared_curved.hpp), and each h_k is smooth:
//   gradient            the pair's point w_k(n) seen along the path, q_k
//   second derivative   B_k, the bend of the pieces
// Portal refinement knows the values and gradients of three of them. It closes in by a constant factor per step if C
// is curved. Newton's method with several functions also uses the bends. With B = sum l_k B_k, the step d is the
// least of
//   max over k of (h_k + q_k.d)  +  d.B d / 2.
// There one, two or three h_k are equal, and the weights l_k >= 0, sum 1, solve sum l_k q_k + B d = 0. Examples are a
// vertex that meets a face, a rim on an edge, and an ellipsoid's inside. Each has its pieces, and none is a special
// case. Only a flat end, where n is along the axis and a rim's bend is infinite, is tried by itself. If a step brings
// no progress, a portal's step is next.
//
// No step has to be right, since the answer is verified at the end:
//   miss      an axis n with h(n) < min(0, n.(horizon r)), confirmed with the farthest point of each body
//   hit       upper: a point sum l_k w_k of C within the noise of the path. lower: h(n) / n.r.
//             upper - lower is below the target
//   contact   points of C within the noise of the line, one at s <= 0 and one at s >= 0
// Near the start, near the end of the path and where the path grazes it gives up, and the search of mpr.hpp answers.
//
// Rounding, over |n|_1, as in round_walk.hpp: a curved point errs by error(), and by twice that where a farther one is
// passed over, which the four times of margin hold. The ball's point R n/|n| errs by 5 u R.
#pragma once

#include <graze/detail/pairs/prepared_curved.hpp>
#include <graze/detail/search/fast/fast_path.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

template <Scalar S>
[[nodiscard]] bool is_curved_or_round(const Shape<S>& shape) {
  return is_curved_leaf(shape) || has_fast_search(shape) || std::holds_alternative<Sphere<S>>(shape) ||
         std::holds_alternative<Capsule<S>>(shape);
}

// The limit of supports of the walk. Common cases need fewer.
inline constexpr int kCurvedSteps = 48;

// The bodies are curved or round.
template <Scalar S>
using CurvedPair = PreparedPair<S, PreparedCurved<S>>;

// Error bound on a point of C, per component.
template <Scalar S>
[[nodiscard]] double point_error(const CurvedPair<S>& pair) {
  return pair.a().error() + pair.b().error() + pair.offset_error() +
         4 * kUnitRoundoff<double> * (pair.extent() + 2 * pair.radius());
}

// A point of C, ball and all, and as it is seen along the path.
struct CurvedCorner {
  Triple w{0, 0, 0};
  double u = 0, v = 0;  // w along e and f
  std::uint32_t piece_a = 0, piece_b = 0;
};

// outcome not_converged: it gave up.
struct CurvedSweep {
  Outcome outcome = Outcome::not_converged;
  double lower = 0, upper = 0;  // hit: of s
  Triple n{0, 0, 0};            // hit, miss: the axis, of any length
  double reach = 0;             // hit: n.w of the farthest point along n
  // hit: what is met, points of A's and B's cores in their own axes about their centres, internal length.
  int size = 0;
  std::array<Triple, 3> own_a{Triple{0, 0, 0}, Triple{0, 0, 0}, Triple{0, 0, 0}}, own_b = own_a;
  std::array<double, 3> lambda{};
};

template <Scalar S>
class CurvedWalk {
 public:
  // `horizon` may be infinite. `unit`: the roundoff whose noise is contact.
  CurvedWalk(const CurvedPair<S>& pair, double horizon, double tolerance, int budget, Counters& counters,
             double unit = double(kUnitRoundoff<S>))
      : pair_(pair), counters_(counters), r_(pair.direction()), radius_(pair.radius()) {
    budget_ = std::min(budget, kCurvedSteps);
    r_sq_ = dot(r_, r_);
    length_ = square_root(r_sq_);
    r_unit_ = (1 / length_) * r_;
    s_max_ = horizon;
    // Beyond its extent nothing of C is met.
    end_ = std::min(horizon, 2 * (pair.extent() + radius_)) * r_;
    noise_ = kContact * unit * pair.size();
    reach_ = pair.a().reach() + pair.b().reach() + radius_;
    target_ = std::max(noise_, pair.tolerated(tolerance));
    margin_ = pair.ball_margin();
    guess_ = pair.a().support_error() + pair.b().support_error();
    set_frame();
  }

  [[nodiscard]] const CurvedSweep& run() {
    // With balls that dwarf the path's lengths, products would lose their range.
    if (!(radius_ < 0x1p100) || !find()) return out_;
    orient();
    axis_a_ = pair_.a().axis();
    axis_b_ = pair_.b().axis();
    own_e_a_ = pair_.a().core().to_own(e_);
    own_f_a_ = pair_.a().core().to_own(f_);
    own_e_b_ = pair_.b().core().to_own(e_);
    own_f_b_ = pair_.b().core().to_own(f_);
    for (int round = 0; round < kCurvedSteps && budget_ > 0; ++round) {
      if (newton() || flat_end(axis_, kNearEnd) || !step_portal()) break;
    }
    return out_;
  }

  // Three points of C about the line, near where a hit's axis n supports C: along n and up to `tilt` |n| beside it.
  [[nodiscard]] bool surround(const Triple& n, double tilt) {
    budget_ += kCurvedSteps / 2;
    // A guess in floats does not resolve the tilt.
    sure_ = guess_ > noise_;
    base_ = n;
    tilt_ = tilt * square_root(dot(n, n));
    return find_about(0.8, 0.6);
  }
  // Coordinates of corner i: across the line, and along it.
  [[nodiscard]] Vec3<double> seen(std::size_t i) const {
    return {at_[i].u, at_[i].v, dot(at_[i].w, r_unit_)};
  }

 private:
  struct Piece {
    std::uint32_t a, b;
    double lambda;
    Triple on_a, on_b;  // of a polytope's: where it is
    CurvedCorner at;    // its point along the current axis
    double h;
  };
  // Values of a curved body's pieces along the current axis.
  struct Turned {
    std::array<bool, 2> known{};
    std::array<Triple, 2> at{Triple{0, 0, 0}, Triple{0, 0, 0}};
    std::array<Bend, 2> bend{};
  };

  void set_frame() {
    const double x = std::abs(r_unit_.x), y = std::abs(r_unit_.y), z = std::abs(r_unit_.z);
    const Triple least = x <= y && x <= z ? Triple{1, 0, 0} : y <= z ? Triple{0, 1, 0} : Triple{0, 0, 1};
    const Triple e = cross(least, r_unit_);
    e_ = (1 / square_root(dot(e, e))) * e;
    f_ = cross(r_unit_, e_);
  }
  void set(const Triple& a, const Triple& b, const Triple& n, CurvedCorner& out) const {
    out.w = a - (b + pair_.offset());
    if (radius_ > 0) out.w = out.w + (radius_ / square_root(dot(n, n))) * n;
    out.u = dot(out.w, e_);
    out.v = dot(out.w, f_);
  }
  void support(const Triple& n, CurvedCorner& out) {
    ++counters_.supports;
    --budget_;
    if (sure_) {
      set(pair_.a().farthest(n, out.piece_a), pair_.b().farthest(-n, out.piece_b), n, out);
    } else {
      set(pair_.a().support(n, out.piece_a), pair_.b().support(-n, out.piece_b), n, out);
    }
  }
  // The farthest in doubles.
  [[gnu::noinline]] void sure_support(const Triple& n, CurvedCorner& out) {
    ++counters_.supports;
    const Triple a = pair_.a().farthest(n, out.piece_a), b = pair_.b().farthest(-n, out.piece_b);
    set(a, b, n, out);
  }
  [[nodiscard]] static double det(const CurvedCorner& c, const CurvedCorner& d) {
    return fl(c.u * d.v) - fl(c.v * d.u);
  }

  // Does n, with its support point w, prove that the path misses? w may come out farther.
  [[nodiscard]] bool separates(const Triple& n, CurvedCorner& w) {
    const double size = sum(magnitude(n)), bound = std::min(0.0, dot(n, end_)) - fl(margin_ * size);
    double h = dot(n, w.w);
    if (!(h < bound)) [[likely]]
      return false;
    if (!(h < bound - fl(guess_ * size))) {
      sure_support(n, w);
      h = dot(n, w.w);
      if (!(h < bound)) return false;
    }
    out_.outcome = Outcome::miss;
    out_.n = n;
    return true;
  }

  // Three points of C around the line, counterclockwise as seen against it.
  [[nodiscard]] bool find() {
    CurvedCorner first;
    Triple n = fast_first_direction(pair_);
    if (!(largest(n) > kLeast)) n = -r_unit_;
    n = (1 / largest(n)) * n;
    support(n, first);
    if (separates(n, first)) return false;
    return find_about(first);
  }
  [[nodiscard]] bool find_about(double x, double y) {
    CurvedCorner first;
    support(base_ + tilt_ * (x * e_ + y * f_), first);
    return find_about(first);
  }
  // Across the line along (x, y): the axis, and its support point.
  [[nodiscard]] bool look(double x, double y, CurvedCorner& out) {
    const double size = std::max(std::abs(x), std::abs(y));
    if (!(size > kLeast)) return false;
    const Triple n = base_ + (tilt_ / size) * (x * e_ + y * f_);
    support(n, out);
    if (!separates(n, out)) return true;
    return false;
  }
  [[nodiscard]] bool find_about(const CurvedCorner& first) {
    CurvedCorner i = first, j, k;
    // Towards the line.
    if (!look(-i.u, -i.v, j)) return false;
    if (det(i, j) < 0) std::swap(i, j);
    while (budget_ > 0) {
      ++counters_.portal_steps;
      // Across the edge from i to j, to the line's side.
      if (!look(i.v - j.v, j.u - i.u, k)) return false;
      const double from = det(k, i), to = det(j, k);
      if (from >= 0 && to >= 0) {
        at_ = {i, j, k};
        return true;
      }
      // Nothing new: the line passes within the noise of the silhouette.
      if ((k.u == i.u && k.v == i.v) || (k.u == j.u && k.v == j.v)) return false;
      (from < to ? j : i) = k;
    }
    return false;
  }

  [[nodiscard]] Triple portal_normal() const { return cross(at_[2].w - at_[0].w, at_[1].w - at_[0].w); }
  // The portal lies before the start: the exit is looked for.
  void orient() {
    const Triple n = portal_normal();
    first_ = at_;
    side_ = dot(n, at_[0].w) * (dot(n, r_) < 0 ? 1 : -1) > 0 ? -1 : 1;
  }
  // The axis of the portal, n.r/|r| = -side.
  [[nodiscard]] bool portal_axis(double& x, double& y) const {
    const Triple n = portal_normal();
    const double along = dot(n, r_unit_), by = -side_ / along;
    x = by * dot(n, e_);
    y = by * dot(n, f_);
    return std::abs(x) < kSteepest && std::abs(y) < kSteepest;
  }
  [[nodiscard]] Triple axis_at(double x, double y) const { return -side_ * r_unit_ + (x * e_ + y * f_); }

  // A hit, a contact or open. p is a point of C, within the noise of the line. h = n.w, w being the farthest along n.
  [[nodiscard]] bool close(const Triple& n, double h, const Triple& p) {
    const double s = dot(p, r_) / r_sq_;
    if (!(largest(p - s * r_) <= noise_ / 4)) return false;
    if (side_ < 0 ? s >= 0 : s <= 0) {
      std::array<double, 3> lambda;
      const double before = pass(first_, lambda);
      if (s * before <= 0) out_.outcome = Outcome::initially_overlapping;
      return true;
    }
    if (side_ < 0) return true;
    const double lower = std::min(h / dot(n, r_), s), width = (s - lower) * length_;
    if (!(width <= target_)) return false;
    // If only the caller's tolerance closes the bracket, the hit is accepted only if its verdict is certain.
    // Otherwise the walk continues as without a tolerance.
    if (width > noise_ && !(lower > 2 * noise_ && s + noise_ < s_max_)) return false;
    if (!(lower > 0 && s < s_max_ && s > 2 * noise_)) return true;
    out_.outcome = Outcome::hit;
    out_.lower = lower;
    out_.upper = s;
    out_.n = n;
    out_.reach = h;
    return true;
  }
  // The weights of the line's point in a triangle, as it is seen along the path, of either orientation. They are not
  // negative and their sum is 1, whatever rounding does: so the points that they make are on the bodies. For needles
  // that rounding turns inside out the points miss the line, which the callers detect. NaN of a triangle without
  // area.
  static void weigh_by_areas(const CurvedCorner& c0, const CurvedCorner& c1, const CurvedCorner& c2,
                             std::array<double, 3>& lambda) {
    const double area0 = det(c1, c2), area1 = det(c2, c0), area2 = det(c0, c1),
                 sign = area0 + area1 + area2 < 0 ? -1 : 1;
    const double l0 = std::max(sign * area0, 0.0), l1 = std::max(sign * area1, 0.0),
                 l2 = std::max(sign * area2, 0.0), one = 1 / (l0 + l1 + l2);
    lambda = {l0 * one, l1 * one, l2 * one};
  }
  // The parameter at which the line passes a portal, or NaN if it does not within the noise.
  [[nodiscard]] double pass(const std::array<CurvedCorner, 3>& c, std::array<double, 3>& lambda) const {
    weigh_by_areas(c[0], c[1], c[2], lambda);
    const Triple p = lambda[0] * c[0].w + lambda[1] * c[1].w + lambda[2] * c[2].w;
    const double s = dot(p, r_) / r_sq_;
    return largest(p - s * r_) <= noise_ / 4 ? s : std::numeric_limits<double>::quiet_NaN();
  }

  // A flat end of one body that the other meets, of those within an angle of the axis and not tried yet.
  [[nodiscard]] bool flat_end(const Triple& n, double cosine) {
    if (side_ < 0) return false;
    const double length = square_root(dot(n, n));
    for (const bool of_a : {true, false}) {
      const PreparedCurved<S>& body = of_a ? pair_.a() : pair_.b();
      if (!body.is_curved()) continue;
      const Triple axis = of_a ? axis_a_ : axis_b_;
      const double along = of_a ? dot(axis, n) : -dot(axis, n);
      bool& tried = tried_[(of_a ? 0u : 2u) + (along > 0 ? 1u : 0u)];
      if (tried || !(std::abs(along) > cosine * length) || !body.has_end(along > 0)) continue;
      tried = true;
      if (meet_flat_end(body, axis, along > 0, of_a)) return true;
    }
    return false;
  }
  [[nodiscard]] bool meet_flat_end(const PreparedCurved<S>& body, const Triple& axis, bool up, bool of_a) {
    const Triple out = up ? axis : -axis, n = of_a ? out : -out;
    const double rate = dot(n, r_unit_);
    if (!(rate < -1 / kSteepest)) return false;
    CurvedCorner w;
    support(n, w);
    if (separates(n, w)) return true;
    if (guess_ > noise_) sure_support(n, w);
    const PreparedCurved<S>& other = of_a ? pair_.b() : pair_.a();
    const std::uint32_t piece = of_a ? w.piece_b : w.piece_a;
    const Triple met = other.own(piece, -out), there = other.core().to_world(met);
    const Triple end = body.half_height() * out;
    // C's points that n supports: `end` and what is across the axis from it, less or plus the other's point.
    const Triple fixed = (of_a ? end - (there + pair_.offset()) : there - (end + pair_.offset())) +
                         (radius_ / square_root(dot(n, n))) * n;
    const double h = dot(n, w.w), s = h / dot(n, r_);
    Triple beside = s * r_ - fixed;
    beside = (of_a ? 1.0 : -1.0) * (beside - dot(beside, axis) * axis);
    const double from = square_root(dot(beside, beside)), rim = body.rim_radius();
    if (!(from <= rim * (1 - 0x1p-40))) return false;
    if (!close(n, h, fixed + (of_a ? 1.0 : -1.0) * beside)) return false;
    if (out_.outcome != Outcome::hit) return true;
    // On a diameter.
    const Triple to = body.core().to_own(from > 0 ? (rim / from) * beside : Triple{0, 0, 0});
    const double z = up ? body.half_height() : -body.half_height();
    const std::array<Triple, 2> ends = {Triple{to.x, to.y, z}, Triple{-to.x, -to.y, z}};
    for (std::size_t i = 0; i < 2; ++i) {
      out_.own_a[i] = of_a ? ends[i] : met;
      out_.own_b[i] = of_a ? met : ends[i];
    }
    out_.size = 2;
    const double l = rim > 0 ? from / rim / 2 : 0;
    out_.lambda = {0.5 + l, 0.5 - l, 0};
    return true;
  }

  // ---- Newton's steps. True: nothing is left to do, whether or not it answered.

  void take(std::uint32_t a, std::uint32_t b, double lambda) {
    for (int i = 0; i < count_; ++i) {
      if (piece_[std::size_t(i)].a == a && piece_[std::size_t(i)].b == b) {
        piece_[std::size_t(i)].lambda += lambda;
        return;
      }
    }
    std::size_t to = std::size_t(count_);
    if (count_ == 4) {
      // In the place of one that has no weight.
      to = 0;
      for (std::size_t i = 1; i < 4; ++i) {
        if (piece_[i].lambda < piece_[to].lambda) to = i;
      }
    } else {
      ++count_;
    }
    piece_[to].a = a;
    piece_[to].b = b;
    piece_[to].lambda = lambda;
    if (!pair_.a().is_curved()) piece_[to].on_a = pair_.a().core().at(a);
    if (!pair_.b().is_curved()) piece_[to].on_b = pair_.b().core().at(b);
  }

  [[nodiscard]] bool newton() {
    double x = 0, y = 0;
    if (!portal_axis(x, y)) return false;
    count_ = 0;
    std::array<double, 3> lambda;
    (void)pass(at_, lambda);
    for (std::size_t i = 0; i < 3; ++i) take(at_[i].piece_a, at_[i].piece_b, lambda[i]);
    CurvedCorner w;
    Triple n = axis_at(x, y);
    support(n, w);
    if (separates(n, w)) return true;
    double h = dot(n, w.w), moved = 1;  // by the last step, of n
    take(w.piece_a, w.piece_b, 0);
    for (int step = 0; step < kNewtonSteps && budget_ > 0; ++step) {
      ++counters_.iterations;
      Bend bend;
      Turned turned_a, turned_b;
      const Triple ball = radius_ > 0 ? (radius_ / square_root(dot(n, n))) * n : Triple{0, 0, 0};
      for (std::size_t i = 0; i < std::size_t(count_); ++i) {
        Piece& p = piece_[i];
        const Triple a = pair_.a().is_curved() ? turn(pair_.a(), p.a, n, own_e_a_, own_f_a_, turned_a)
                                               : p.on_a,
                     b = pair_.b().is_curved() ? turn(pair_.b(), p.b, -n, own_e_b_, own_f_b_, turned_b)
                                               : p.on_b;
        p.at.w = (a - (b + pair_.offset())) + ball;
        p.at.u = dot(p.at.w, e_);
        p.at.v = dot(p.at.w, f_);
        p.h = dot(n, p.at.w);
        if (!(p.lambda > 0)) continue;
        if (pair_.a().is_curved()) add(turned_a.bend[p.a], p.lambda, bend);
        if (pair_.b().is_curved()) add(turned_b.bend[p.b], p.lambda, bend);
      }
      if (radius_ > 0) {
        const double n_sq = 1 + fl(x * x) + fl(y * y), by = radius_ / square_root(n_sq);
        bend.ee += fl(by * (1 - x * x / n_sq));
        bend.ef -= by * x * y / n_sq;
        bend.ff += fl(by * (1 - y * y / n_sq));
      }
      axis_ = n;
      if ((step > 0 && closes(n, w)) || flat_end(n, kAtEnd)) return true;
      const double length = square_root(1 + fl(x * x) + fl(y * y)),
                   stiff = fl(reach_ / length * std::min(std::max(moved * moved, kSoft), kStiff));
      bend.ee += stiff;
      bend.ff += stiff;
      double dx = 0, dy = 0;
      if (!least(bend, dx, dy)) return false;
      double by = std::min(1.0, kLongest * length / square_root(fl(dx * dx) + fl(dy * dy)));
      bool better = false;
      for (int i = 0; i < 3 && !better; ++i, by /= 4) {
        const double next_x = x + fl(by * dx), next_y = y + fl(by * dy);
        if (!(std::abs(next_x) < kSteepest && std::abs(next_y) < kSteepest)) return false;
        const Triple next = axis_at(next_x, next_y);
        CurvedCorner there;
        support(next, there);
        if (separates(next, there)) return true;
        const double there_h = dot(next, there.w);
        better = there_h <= h + noise_;
        take(there.piece_a, there.piece_b, 0);
        if (better || i == 2) {
          moved = by * square_root(fl(dx * dx) + fl(dy * dy)) / length;
          x = next_x;
          y = next_y;
          n = next;
          w = there;
          h = there_h;
        }
      }
      if (!better) return false;
    }
    return false;
  }

  [[nodiscard]] static const Triple& turn(const PreparedCurved<S>& body, std::uint32_t piece, const Triple& n,
                                          const Triple& e, const Triple& f, Turned& turned) {
    if (!turned.known[piece]) {
      turned.known[piece] = true;
      turned.at[piece] = body.turn(piece, n, e, f, turned.bend[piece]);
    }
    return turned.at[piece];
  }
  static void add(const Bend& bend, double weight, Bend& out) {
    out.ee += fl(weight * bend.ee);
    out.ef += fl(weight * bend.ef);
    out.ff += fl(weight * bend.ff);
  }

  // With the weights of the last step: is the point that they make within the noise of the path?
  [[nodiscard]] bool closes(const Triple& n, CurvedCorner& w) {
    std::array<std::size_t, 3> at{};
    int size = 0;
    for (std::size_t i = 0; i < std::size_t(count_); ++i) {
      if (piece_[i].lambda > 0 && size < 3) at[std::size_t(size++)] = i;
    }
    if (size == 0) return false;
    const CurvedCorner &c0 = piece_[at[0]].at, &c1 = piece_[at[1]].at, &c2 = piece_[at[2]].at;
    std::array<double, 3> l = {1, 0, 0};
    if (size == 2) {
      const double u = c1.u - c0.u, v = c1.v - c0.v,
                   along = -(fl(u * c0.u) + fl(v * c0.v)) / (fl(u * u) + fl(v * v));
      l[1] = std::min(std::max(along, 0.0), 1.0);
      l[0] = 1 - l[1];
    } else if (size == 3) {
      weigh_by_areas(c0, c1, c2, l);
    }
    const Triple p = l[0] * c0.w + l[1] * c1.w + l[2] * c2.w;
    const double s = dot(p, r_) / r_sq_;
    if (!(largest(p - s * r_) <= noise_ / 4)) return false;
    if (guess_ > noise_) sure_support(n, w);
    if (!close(n, dot(n, w.w), p)) return false;
    out_.size = size;
    out_.lambda = l;
    for (std::size_t i = 0; i < std::size_t(size); ++i) {
      out_.own_a[i] = pair_.a().own(piece_[at[i]].a, n);
      out_.own_b[i] = pair_.b().own(piece_[at[i]].b, -n);
    }
    return true;
  }

  // The minimum of the model and its weights, by trying which of the pieces are equal there.
  [[nodiscard]] bool least(const Bend& bend, double& dx, double& dy) {
    // As many as the last step had, first.
    if (least_of(last_size_, bend, dx, dy)) return true;
    for (int size = 3; size >= 1; --size) {
      if (size != last_size_ && least_of(size, bend, dx, dy)) {
        last_size_ = size;
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool least_of(int size, const Bend& bend, double& dx, double& dy) {
    const std::size_t n = std::size_t(count_);
    for (std::size_t i = 0; i < n; ++i) {
      if (size == 1 && least_of_one(bend, i, dx, dy)) return true;
      for (std::size_t j = i + 1; size > 1 && j < n; ++j) {
        if (size == 2 && least_of_two(bend, i, j, dx, dy)) return true;
        for (std::size_t k = j + 1; size > 2 && k < n; ++k) {
          if (least_of_three(bend, i, j, k, dx, dy)) return true;
        }
      }
    }
    return false;
  }
  // No other piece is above `top` at the step.
  [[nodiscard]] bool is_top(double top, double dx, double dy) const {
    for (std::size_t i = 0; i < std::size_t(count_); ++i) {
      const Piece& p = piece_[i];
      if (p.h + fl(p.at.u * dx) + fl(p.at.v * dy) > top + noise_) return false;
    }
    return true;
  }
  [[nodiscard]] double value(const Piece& p, double dx, double dy) const {
    return p.h + fl(p.at.u * dx) + fl(p.at.v * dy);
  }
  void weigh(std::size_t i, double l_i, std::size_t j, double l_j, std::size_t k, double l_k) {
    for (Piece& p : piece_) p.lambda = 0;
    piece_[i].lambda = l_i;
    if (j != i) piece_[j].lambda = l_j;
    if (k != i) piece_[k].lambda = l_k;
  }
  [[nodiscard]] bool least_of_three(const Bend& bend, std::size_t i, std::size_t j, std::size_t k, double& dx,
                                    double& dy) {
    const Piece &a = piece_[i], &b = piece_[j], &c = piece_[k];
    const double bu = b.at.u - a.at.u, bv = b.at.v - a.at.v, cu = c.at.u - a.at.u, cv = c.at.v - a.at.v,
                 area = fl(bu * cv) - fl(bv * cu);
    if (!(std::abs(area) > kThin * (fl(bu * bu) + fl(bv * bv) + fl(cu * cu) + fl(cv * cv)))) return false;
    const double to_b = a.h - b.h, to_c = a.h - c.h;
    const double x = (fl(to_b * cv) - fl(to_c * bv)) / area, y = (fl(bu * to_c) - fl(cu * to_b)) / area;
    // a + l_b (b - a) + l_c (c - a) = -B d
    const double u = -(fl(bend.ee * x) + fl(bend.ef * y)) - a.at.u,
                 v = -(fl(bend.ef * x) + fl(bend.ff * y)) - a.at.v;
    const double l_b = (fl(u * cv) - fl(v * cu)) / area, l_c = (fl(bu * v) - fl(bv * u)) / area,
                 l_a = 1 - l_b - l_c;
    if (!(l_a >= 0 && l_b >= 0 && l_c >= 0) || !is_top(value(a, x, y), x, y)) return false;
    dx = x;
    dy = y;
    weigh(i, l_a, j, l_b, k, l_c);
    return true;
  }
  [[nodiscard]] bool least_of_two(const Bend& bend, std::size_t i, std::size_t j, double& dx, double& dy) {
    const Piece &a = piece_[i], &b = piece_[j];
    const double u = b.at.u - a.at.u, v = b.at.v - a.at.v, apart_sq = fl(u * u) + fl(v * v);
    if (!(apart_sq > 0)) return false;
    // d = along (u, v) + across (-v, u)
    const double along = (a.h - b.h) / apart_sq;
    const double b_across_u = fl(-bend.ee * v) + fl(bend.ef * u),
                 b_across_v = fl(-bend.ef * v) + fl(bend.ff * u),
                 stiff = fl(-v * b_across_u) + fl(u * b_across_v);
    if (!(stiff > kThin * apart_sq)) return false;
    const double across =
        -((fl(-v * a.at.u) + fl(u * a.at.v)) + fl(along * (fl(u * b_across_u) + fl(v * b_across_v)))) / stiff;
    const double x = fl(along * u) - fl(across * v), y = fl(along * v) + fl(across * u);
    const double l = -(fl(u * (a.at.u + fl(bend.ee * x) + fl(bend.ef * y))) +
                       fl(v * (a.at.v + fl(bend.ef * x) + fl(bend.ff * y)))) /
                     apart_sq;
    if (!(l >= 0 && l <= 1) || !is_top(value(a, x, y), x, y)) return false;
    dx = x;
    dy = y;
    weigh(i, 1 - l, j, l, i, 0);
    return true;
  }
  [[nodiscard]] bool least_of_one(const Bend& bend, std::size_t i, double& dx, double& dy) {
    const Piece& a = piece_[i];
    const double stiff = fl(bend.ee * bend.ff) - fl(bend.ef * bend.ef);
    if (!(stiff > kThin * (fl(bend.ee * bend.ee) + fl(bend.ff * bend.ff)))) return false;
    const double x = -(fl(bend.ff * a.at.u) - fl(bend.ef * a.at.v)) / stiff,
                 y = -(fl(bend.ee * a.at.v) - fl(bend.ef * a.at.u)) / stiff;
    if (!is_top(value(a, x, y), x, y)) return false;
    dx = x;
    dy = y;
    weigh(i, 1, i, 0, i, 0);
    return true;
  }

  // A step of portal refinement. False if there is no such step.
  [[nodiscard]] bool step_portal() {
    ++counters_.portal_steps;
    double x = 0, y = 0;
    if (!portal_axis(x, y)) return false;
    const Triple n = axis_at(x, y);
    CurvedCorner w;
    support(n, w);
    if (separates(n, w)) return false;
    if (!(dot(n, w.w) - dot(n, at_[0].w) > noise_ / 8 * sum(magnitude(n)))) return false;
    const double d0 = det(w, at_[0]), d1 = det(w, at_[1]), d2 = det(w, at_[2]);
    const std::size_t out = d0 >= 0 && d1 <= 0 ? 2 : d1 >= 0 && d2 <= 0 ? 0 : 1;
    at_[out] = w;
    return true;
  }

  static constexpr double kLeast = 0x1p-80;
  // n over n.r beyond which the path grazes, and the longest step of n over |n|.
  static constexpr double kSteepest = 0x1p20, kLongest = 0.5;
  // Relative threshold: below it, pieces lie one behind the other, and a bend counts as zero.
  static constexpr double kThin = 0x1p-40;
  // Cosines of the angle to a flat end's normal, at which it is tried: on the way, and where the steps end.
  static constexpr double kAtEnd = 0.9, kNearEnd = 0.5;
  // Regularisation of the bends, over the reach: the square of the last step, within these limits.
  static constexpr double kSoft = 0x1p-20, kStiff = 0x1p-4;
  static constexpr int kNewtonSteps = 16;

  const CurvedPair<S>& pair_;
  Counters& counters_;
  Triple r_, r_unit_{0, 0, 0}, e_{0, 0, 0}, f_{0, 0, 0}, end_{0, 0, 0};
  Triple base_{0, 0, 0};  // supports about the line are along base + tilt (x e + y f)
  double tilt_ = 1, radius_, r_sq_ = 1, length_ = 1, s_max_ = 0, noise_ = 0, target_ = 0, margin_ = 0,
         guess_ = 0;
  double reach_ = 0;
  Triple own_e_a_{0, 0, 0}, own_f_a_{0, 0, 0}, own_e_b_{0, 0, 0},
      own_f_b_{0, 0, 0};                                      // e and f in the bodies' axes
  Triple axis_a_{0, 0, 0}, axis_b_{0, 0, 0}, axis_{0, 0, 0};  // of the bodies, and the last of Newton's steps
  std::array<bool, 4> tried_{};                               // flat ends: of A below, above, of B
  double side_ = 1;                                           // 1: the entry is looked for, -1: the exit
  bool sure_ = false;                                         // every support is of the farthest
  int budget_ = 0, count_ = 0, last_size_ = 3;
  std::array<CurvedCorner, 3> at_, first_;
  std::array<Piece, 4> piece_{};
  CurvedSweep out_;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
