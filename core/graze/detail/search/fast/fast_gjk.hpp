// Computes the distance of two polytopes. It is GJK in doubles, with guessed vertices. It may give up.
//
// Notation   v = the simplex's point closest to the origin.   n = a vector from the simplex to the origin, of any
// length: -v, or the normal of a triangle.
//
// As gjk.hpp, but no single step has to be right. The answer is verified at the end, when these two bounds have met
//   upper   the length of a convex combination of vertices of C
//   lower   -h(n) / |n|, confirmed with the farthest vertex along n
// or when a tetrahedron of C holds the origin.
// [Gilbert, Johnson, Keerthi 1988, and Ericson, Real-Time Collision Detection, 2005, 5.1]
#pragma once

#include <graze/detail/pairs/pair_support.hpp>
#include <graze/warm_start.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

enum class FastState : std::uint8_t {
  open,      // it gave up
  apart,     // the bracket, the axis and the weights hold
  touching,  // the simplex holds the origin within the noise: weights, no tetrahedron
  enclosed,  // a tetrahedron holds it
};

// Support of C, or of another set with a support of its own (swept_support.hpp).
template <Scalar S, class Support = PairSupport<S>>
class FastGjk {
 public:
  FastGjk(Support& support, Counters& counters) : support_(support), counters_(counters) {}

  // The target of upper - lower at the finest. If the search ends by itself, the noise is enough. `loose` is a
  // caller's tolerance, or 0. It is enough if the bodies are certainly apart. It costs no support and changes no
  // verdict. `verdict`: an axis that separates is enough.
  [[nodiscard]] FastState run(const WarmStart& start, double loose, bool verdict, int budget) {
    if (!begin(start)) {
      const Triple& d = support_.pair().offset();
      const Triple along = start.has_axis()       ? triple(start.axis)
                           : largest(d) > 0x1p-80 ? scaled_near_one(d)
                                                  : Triple{1, 0, 0};
      support_.guess(along, *point_[0]);
      if (verdict && support_.separates(along, *point_[0])) return found_axis(along);
      size_ = 1;
    }
    double before = kInfinity<double>;
    for (int step = 0; step < kFastGjkSteps; ++step) {
      ++counters_.gjk_iterations;
      n_before_ = n_;
      close_in();
      if (size_ == 4) return encloses() ? FastState::enclosed : FastState::open;
      const double dist = square_root(dist_sq_);
      // No nearer: rounding, or NaN.
      if (!(dist_sq_ < before)) return FastState::open;
      before = dist_sq_;
      if (dist <= support_.fine()) {
        upper_ = dist;
        return FastState::touching;
      }
      if (is_small_direction(n_) || budget-- <= 0) return FastState::open;
      const double length = square_root(dot(n_, n_));
      PairVertex& next = *point_[static_cast<std::size_t>(size_)];
      support_.guess(n_, next);
      if (verdict && support_.separates(n_, next)) return found_axis(n_);
      bool known = holds(next);
      const double guessed = -dot(n_, next.w) / length;
      if (!known && dist - guessed > support_.fine()) {
        if constexpr (requires { support_.approximate_error(); }) {
          if (dist - guessed <= loose && closes_early(next, length, loose)) return FastState::apart;
        }
        ++size_;
        continue;
      }
      // The guess is no farther, so the farthest vertex is computed.
      support_.sure(n_, next);
      upper_ = weighted();
      lower_ = -dot(n_, next.w) / length;
      known = holds(next);
      if (upper_ - lower_ <= support_.fine() || (known && upper_ - lower_ <= support_.noise())) {
        n_ = (1 / length) * n_;
        return FastState::apart;
      }
      if (known) return FastState::open;
      ++size_;
    }
    return FastState::open;
  }

  // apart: n proves it beyond rounding, and nothing more is known.
  [[nodiscard]] bool separated() const { return separated_; }
  // apart: unit. separated: any length.
  [[nodiscard]] const Triple& axis() const { return n_; }
  // The axis of the simplex's newest vertex, or 0 if there is no such axis.
  [[nodiscard]] const Triple& axis_before() const { return n_before_; }
  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return upper_; }
  // The simplex, and its weights.
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] const PairVertex& point(int i) const { return *point_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double lambda(int i) const { return lambda_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const std::array<double, 4>& lambda() const { return lambda_; }
  [[nodiscard]] std::array<std::uint32_t, 4> vertices(bool of_a) const {
    std::array<std::uint32_t, 4> out{};
    for (int i = 0; i < size_; ++i)
      out[static_cast<std::size_t>(i)] = of_a ? point(i).vertex_a : point(i).vertex_b;
    return out;
  }
  [[nodiscard]] WarmStart warm() const { return {n_.vector(), size_, vertices(true), vertices(false)}; }

 private:
  // With the guessed vertex, which the farthest is not much beyond.
  [[nodiscard]] bool closes_early(const PairVertex& next, double length, double loose) {
    upper_ = weighted();
    lower_ = (-dot(n_, next.w) - fl(support_.approximate_error() * sum(magnitude(n_)))) / length;
    if (!(lower_ > 2 * support_.noise() && upper_ - lower_ <= loose)) return false;
    n_ = (1 / length) * n_;
    return true;
  }
  [[nodiscard]] FastState found_axis(const Triple& n) {
    n_ = n;
    separated_ = true;
    return FastState::apart;
  }
  // The simplex of a former answer, where the shapes have its vertices.
  [[nodiscard]] bool begin(const WarmStart& start) {
    if (start.size < 1 || start.size > 4) return false;
    for (int i = 0; i < start.size; ++i) {
      const std::size_t k = static_cast<std::size_t>(i);
      if (!support_.has(start.vertex_a[k], start.vertex_b[k])) return false;
      support_.at(start.vertex_a[k], start.vertex_b[k], *point_[k]);
    }
    size_ = start.size;
    return true;
  }
  [[nodiscard]] bool holds(const PairVertex& p) const {
    bool out = false;
    for (int i = 0; i < size_; ++i) out = out || point(i).is(p);
    return out;
  }
  [[nodiscard]] double weighted() const {
    Triple v{0, 0, 0};
    for (int i = 0; i < size_; ++i) v = v + lambda(i) * point(i).w;
    return square_root(dot(v, v));
  }
  // By its weights, which round with the tetrahedron's flatness.
  [[nodiscard]] bool encloses() const { return weighted() <= support_.noise(); }

  // Results of the closest-point step of a simplex. The least is kept.
  struct Feature {
    double dist_sq = kInfinity<double>;
    Triple n{0, 0, 0};
    std::array<PairVertex*, 3> p{};
    std::array<double, 3> lambda{};
    int size = 0;
  };
  void keep(const Feature& f) {
    dist_sq_ = f.dist_sq;
    n_.x = f.n.x;
    n_.y = f.n.y;
    n_.z = f.n.z;
    for (int i = 0; i < f.size; ++i)
      lambda_[static_cast<std::size_t>(i)] = f.lambda[static_cast<std::size_t>(i)];
    // The others keep their places behind.
    std::array<PairVertex*, 5> order{};
    std::size_t k = 0;
    for (int i = 0; i < f.size; ++i) order[k++] = f.p[static_cast<std::size_t>(i)];
    for (PairVertex* const p : point_) {
      bool used = false;
      for (int i = 0; i < f.size; ++i) used = used || f.p[static_cast<std::size_t>(i)] == p;
      if (!used) order[k++] = p;
    }
    point_ = order;
    size_ = f.size;
  }
  static void vertex(PairVertex* a, Feature& out) {
    const double dist_sq = dot(a->w, a->w);
    if (!(dist_sq < out.dist_sq)) return;
    out.dist_sq = dist_sq;
    out.n = -a->w;
    out.p[0] = a;
    out.lambda[0] = 1;
    out.size = 1;
  }
  static void edge(PairVertex* a, PairVertex* b, Feature& out) {
    const Triple ab = b->w - a->w;
    const double along = -dot(a->w, ab), length_sq = dot(ab, ab);
    if (!(along > 0)) return vertex(a, out);
    if (!(along < length_sq)) return vertex(b, out);
    const double t = along / length_sq;
    // Once more: what the first subtraction left along the edge, which a long edge would make a tilted axis of.
    Triple v = a->w + t * ab;
    v = v - (dot(v, ab) / length_sq) * ab;
    const double dist_sq = dot(v, v);
    if (!(dist_sq < out.dist_sq)) return;
    out.dist_sq = dist_sq;
    out.n = -v;
    out.p[0] = a;
    out.p[1] = b;
    out.lambda[0] = 1 - t;
    out.lambda[1] = t;
    out.size = 2;
  }
  // m = (b - a) x (c - a).
  static void triangle(PairVertex* a, PairVertex* b, PairVertex* c, const Triple& m, Feature& out) {
    // The side of each edge, in the triangle's plane, on which the origin lies.
    const double la = dot(m, cross(b->w, c->w)), lb = dot(m, cross(c->w, a->w)),
                 lc = dot(m, cross(a->w, b->w));
    if (la > 0 && lb > 0 && lc > 0) {
      const double m_sq = dot(m, m), height = dot(m, a->w), dist_sq = height * height / m_sq;
      if (!(dist_sq < out.dist_sq)) return;
      const double one = 1 / (la + lb + lc);
      out.dist_sq = dist_sq;
      out.n = height > 0 ? -m : m;
      out.p = {a, b, c};
      out.lambda = {la * one, lb * one, lc * one};
      out.size = 3;
      return;
    }
    if (!(la > 0)) edge(b, c, out);
    if (!(lb > 0)) edge(c, a, out);
    if (!(lc > 0)) edge(a, b, out);
  }

  // The simplex becomes the feature of itself that is closest to the origin.
  [[gnu::noinline]] void close_in() {
    Feature f;
    PairVertex *a = point_[0], *b = point_[1], *c = point_[2], *d = point_[3];
    switch (size_) {
      case 1:
        vertex(a, f);
        break;
      case 2:
        edge(a, b, f);
        break;
      case 3:
        triangle(a, b, c, cross(b->w - a->w, c->w - a->w), f);
        break;
      default: {
        // The faces at the newest corner d. The origin is beyond a face if the opposite corner is on the other side.
        const Triple da = a->w - d->w, db = b->w - d->w, dc = c->w - d->w;
        const Triple bc = cross(db, dc), ca = cross(dc, da), ab = cross(da, db);
        const double volume = dot(bc, da);
        const double la = -dot(bc, d->w), lb = -dot(ca, d->w), lc = -dot(ab, d->w);
        const double sign = volume < 0 ? -1 : 1;
        const double ld = fl(sign * volume) - fl(sign * (la + lb + lc));
        if (sign * la > 0 && sign * lb > 0 && sign * lc > 0 && ld > 0) {
          const double one = sign / volume;
          dist_sq_ = 0;
          lambda_ = {sign * la * one, sign * lb * one, sign * lc * one, ld * one};
          return;
        }
        if (!(sign * la > 0)) triangle(d, b, c, bc, f);
        if (!(sign * lb > 0)) triangle(d, c, a, ca, f);
        if (!(sign * lc > 0)) triangle(d, a, b, ab, f);
        if (!(ld > 0)) triangle(a, b, c, cross(b->w - a->w, c->w - a->w), f);
      }
    }
    keep(f);
  }

  static constexpr int kFastGjkSteps = 48;  // what takes longer is no common case

  Support& support_;
  Counters& counters_;
  double dist_sq_ = 0, lower_ = 0, upper_ = kInfinity<double>;
  Triple n_{0, 0, 0}, n_before_{0, 0, 0};
  int size_ = 0;
  bool separated_ = false;
  std::array<PairVertex, 5> slot_;
  std::array<PairVertex*, 5> point_ = {&slot_[0], &slot_[1], &slot_[2], &slot_[3], &slot_[4]};
  std::array<double, 4> lambda_{};
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
