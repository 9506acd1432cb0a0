// Brackets a round walk's contact between two neighbouring doubles, proved in pairs of doubles. Use it first.
// round_search.hpp decides the cases that it leaves open.
//
//   F     the feature that the walk ended with: corners c_i of K, all times the weight W of the bodies' rotations
//   z     = s W v - c_0, e = c_1 - c_0, g = c_2 - c_0, N = e x g. The quadratic q has the sign of f - R^2:
//         vertex z.z - (R W)^2      edge |z x e|^2 - (R W)^2 e.e      face (z.N)^2 - (R W)^2 N.N
//   lower: q > 0, the foot of z is inside of F, no vertex of K is beyond F (beyond.hpp), and the path approaches: TOI
//          is above that double.
//   upper: q < 0 with the foot inside of F: TOI is below that double. If q = 0 there, under the same terms as at the
//          lower, TOI is that double.
// All is formed once, at the walk's time. As q is a quadratic in s, plain doubles suffice for a step of a few units
// in the last place to the two doubles.
//
// Every number carries its error bound. With |x| <= X within x', |y| <= Y within y', pairs kept normal:
//   dot    3 (X y' + x' Y + x' y') + 2^-94 3 X Y,  as products are within 2^-97 X Y and their sums within 2^-101 of theirs
//   cross  2 (X y' + x' Y + x' y') + 2^-94 2 X Y
//   z      2^-91 of the size of its summands, the terms being within 2^-92 (vectors.hpp)
// Units and frame: internal, prepared_pair.hpp.
#pragma once

#include <graze/detail/search/exact/beyond.hpp>
#include <graze/detail/search/exact/exact_answer.hpp>
#include <graze/detail/search/exact/passage.hpp>
#include <graze/detail/search/fast/round_walk.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

template <bool kFused>
class BoundedNumbers {
 public:
  using P = PairOf<kFused>;
  struct Number {
    P x;
    double size, error;  // |x| <= size, within error
  };
  struct Vector {
    Pair3Of<kFused> x;
    double size, error;  // of each component
    [[nodiscard]] Vec3<double> value() const { return {x[0].hi, x[1].hi, x[2].hi}; }
  };

  static Vector vector(const Pair3Of<kFused>& x, double error) {
    Vector out{{normal(x[0]), normal(x[1]), normal(x[2])}, 0, error};
    for (const P& one : out.x) out.size = greater(out.size, std::abs(one.hi));
    out.size = fl(out.size * (1 + 0x1p-50)) + error;
    return out;
  }
  static Number number(const P& x, double error) {
    const P out = normal(x);
    return {out, fl(std::abs(out.hi) * (1 + 0x1p-50)) + error, error};
  }
  static double lost(const Vector& a, const Vector& b) {
    return fl(a.size * b.error) + fl(a.error * b.size) + fl(a.error * b.error) +
           fl(0x1p-94 * a.size * b.size);
  }
  static P dot_of(const Vector& a, const Vector& b, double& error) {
    error = 3 * lost(a, b);
    return dot(a.x, b.x);
  }
  static Vector cross_of(const Vector& a, const Vector& b) { return vector(cross(a.x, b.x), 2 * lost(a, b)); }
  static P normal(const P& x) {
    const TwoDoubles s = two_sum(x.hi, x.lo);
    return {s.hi, s.lo};
  }
};

// A bracket of two neighbouring doubles, of the caller's time, with the normal and the weights of the walk's corners.
struct RoundProof {
  bool proved = false;
  TimeBracket toi;
  Triple normal{0, 0, 0};
  std::array<double, 3> lambda{};
};

template <Scalar S, bool kFused>
class RoundProver {
  using B = BoundedNumbers<kFused>;
  using P = typename B::P;
  using Vector = typename B::Vector;

 public:
  RoundProver(const PreparedPair<S>& pair, const Scene<S>& scene, const CastOptions<S>& options)
      : pair_(pair), scene_(scene) {
    const double unit = scene.unit();
    const TwoDoubles balls = two_sum(unit * pair.radius_a(), unit * pair.radius_b());
    const TwoDoubles all = two_sum(balls.hi, unit * double(options.target_distance));
    radius_ = B::normal({all.hi, all.lo + balls.lo});
  }

  // q at s, and what a small step from there needs.
  struct Value {
    double value = 0, error = 0;  // q(s)
    double slope = 0, slope_error = 0, rise = 0;
    bool inside = true;                          // is the foot inside, beyond predicate_error
    Vec3<double> w = Vec3<double>::Zero();       // a positive multiple of s v minus the foot
    double size = 0, w_error = 0;                // of w's components. The error holds for all s + d
    Vec3<double> across = Vec3<double>::Zero();  // dw / ds
    std::array<double, 2> share{};

    // q(s + d), d exact. rise is rounded by 2^-48, and so are products and sums.
    [[nodiscard]] double after(double d, double& predicate_error) const {
      predicate_error = error + fl(std::abs(d) * slope_error) +
                        0x1p-48 * (std::abs(d * slope) + fl(rise * d * d)) + 0x1p-51 * std::abs(value);
      return value + fl(d * (slope + fl(rise * d)));
    }
    // The sign of q after d. It is 0 if |q| is within predicate_error.
    [[nodiscard]] int sign_after(double d) const {
      double predicate_error = 0;
      const double rest = after(d, predicate_error);
      return rest > predicate_error ? 1 : rest < -predicate_error ? -1 : 0;
    }
  };

  // The corners of F. False: a number is out of range.
  [[nodiscard]] bool take(const RoundWalk<S>& walk, const RoundSweep& found) {
    for (std::size_t i = 0; i < std::size_t(found.size); ++i) {
      if (!(found.lambda[i] > 0)) continue;
      const PairVertex& c = walk.corner(i);
      at_[size_] = i;
      name_[size_++] = {c.vertex_a, c.vertex_b};
    }
    return size_ > 0 && take_corners();
  }
  [[nodiscard]] std::span<const Vertex> corners() const { return {name_.data(), size_}; }
  [[nodiscard, gnu::flatten]] Value at(double s) const {
    Value out;
    Pair3Of<kFused> x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = v_.x[i] * P{s, 0} - c_[0].x[i];
    const Vector z = B::vector(x, fl(s * v_.error) + c_[0].error + 0x1p-96 * (fl(s * v_.size) + c_[0].size));
    const Vec3<double> v = v_.value();
    const double far = kFar * s * v_.size;  // how far z moves
    double error = 0, scale_error = 0;
    if (size_ == 1) {
      const P square = B::dot_of(z, z, error);
      set_value(square, error, P{1, 0}, 0, out);
      set_w(z.value(), z.size, z.error, far, out);
      out.across = v;
      out.slope = 2 * dot(out.w, v);
      out.slope_error = 8 * v_.size * (z.error + 0x1p-50 * z.size);
      out.rise = dot(v, v);
    } else if (size_ == 2) {
      const Vector m = B::cross_of(z, e_);
      const P square = B::dot_of(m, m, error), length = B::dot_of(e_, e_, scale_error);
      set_value(square, error, length, scale_error, out);
      // w e.e = e x (z x e)
      const Vector w = B::cross_of(e_, m);
      set_w(w.value(), w.size, w.error, 6 * e_.size * e_.size * far, out);
      const Vec3<double> e = e_.value(), turned = cross(v, e);
      out.across = dot(e, e) * v - dot(e, v) * e;
      out.slope = 2 * dot(m.value(), turned);
      out.slope_error = 16 * v_.size * e_.size * (m.error + 0x1p-50 * m.size);
      out.rise = dot(turned, turned);
      double along_error = 0;
      const P along = B::dot_of(z, e_, along_error);
      const double a = rounded(along), l = rounded(length),
                   predicate_error = along_error + scale_error + 0x1p-50 * l + fl(4 * far * e_.size);
      out.inside = a > predicate_error && a < l - predicate_error;
      out.share = {a / l, 0};
    } else {
      double height_error = 0, to_e_error = 0, to_g_error = 0;
      // Most of it may cancel, and a product leaves out the square of the low part.
      const P height = B::normal(B::dot_of(z, n_, height_error)), area = B::dot_of(n_, n_, scale_error);
      const double h = std::abs(rounded(height)), side = rounded(height) < 0 ? -1 : 1,
                   rate = side * dot(n_.value(), v), most = 3 * n_.size * v_.size;
      set_value(height * height, fl((2 * h + height_error) * height_error) + fl(0x1p-92 * h * h), area,
                scale_error, out);
      set_w(side * n_.value(), n_.size, n_.error, 0, out);
      out.slope = 2 * h * rate;
      out.slope_error = 2 * (fl(height_error * most) + fl(h * 3 * v_.size * (n_.error + 0x1p-50 * n_.size)));
      out.rise = rate * rate;
      const double to_e = rounded(B::dot_of(B::cross_of(z, g_), n_, to_e_error)),
                   to_g = rounded(B::dot_of(B::cross_of(e_, z), n_, to_g_error)), all = rounded(area);
      const double predicate_error =
          to_e_error + to_g_error + scale_error + 0x1p-50 * all + fl(6 * far * n_.size * (e_.size + g_.size));
      out.inside = h > height_error + fl(kFar * s * most) && to_e > predicate_error &&
                   to_g > predicate_error && to_e + to_g < all - predicate_error;
      out.share = {to_e / all, to_g / all};
    }
    return out;
  }
  [[nodiscard]] RoundProof prove(const RoundWalk<S>& walk, const RoundSweep& found) {
    RoundProof out;
    if (!take(walk, found)) return out;
    // The root of q(s + d) = q + slope d + rise d^2, d being a few units in the last place of s.
    const double s = found.upper;
    const Value q = at(s);
    const double first = -q.value / q.slope;
    const double d = -(q.value + fl(q.rise * first * first)) / q.slope;
    if (!(q.slope < 0) || !(std::abs(d) < kFar / 2 * s) || q.size == 0) return out;
    const double near = s + d;
    double lower = near, upper = near;
    // For bodies that do not rotate, q is a multiple of a power of two. A smaller value is 0.
    double predicate_error = 0;
    const double rest = q.after(near - s, predicate_error);
    const int grid = scene_.is_unturned() ? grid_at(near) : -1000;
    if (!(grid > -900 && std::abs(rest) + predicate_error < power_of_two(std::min(grid, 0)))) {
      ((s - near) + d > 0 ? upper : lower) = next(near, (s - near) + d > 0);
      if (q.sign_after(lower - s) <= 0 || q.sign_after(upper - s) >= 0) return out;
    }
    if (!q.inside || !finish(q, d, out)) return out;
    const double time = power_of_two(pair_.length_exponent() - pair_.speed_exponent());
    out.toi = {lower * time, upper * time};
    // Scaling is exact.
    out.proved = out.toi.lower > 0x1p-900 && out.toi.upper < 0x1p900;
    return out;
  }

 private:
  // The foot and w are needed at s + d, |d| < kFar s.
  static constexpr double kFar = 0x1p-40;

  // Without a rotation z is a multiple of 2^g, and e and g of 2^h: q is one of 2^(2 (g + (corners - 1) h)).
  [[nodiscard]] int grid_at(double s) const {
    int corner = 0;
    for (std::size_t i = 0; i < size_; ++i) corner = std::min(corner, scene_.grid_of(Term::point(name_[i])));
    const int z = std::min({corner, trailing_exponent(s) + scene_.grid_of(Term::motion()),
                            trailing_exponent(radius_.hi), trailing_exponent(radius_.lo)});
    return 2 * (z + (static_cast<int>(size_) - 1) * corner);
  }
  [[nodiscard]] bool take_corners() {
    const Fine v = scene_.fine(Term::motion());
    double size = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Fine c = scene_.fine(Term::point(name_[i]));
      size = std::max(size, c.size);
      c_[i] = B::vector(pairs_as<kFused>(c.x), 0x1p-92 * c.size);
      if (i == 0) weight_ = c.weighted ? pair_as<kFused>(c.weight) : P{1, 0};
    }
    Pair3Of<kFused> motion;
    for (std::size_t i = 0; i < 3; ++i) motion[i] = pair_as<kFused>(v.x[i]) * weight_;
    v_ = B::vector(motion, 0x1p-91 * v.size * weight_.hi);
    const P reach = radius_ * weight_;
    square_ = B::number(reach * reach, 0x1p-92 * reach.hi * reach.hi);
    if (size_ > 1) e_ = step(1);
    if (size_ > 2) {
      g_ = step(2);
      n_ = B::cross_of(e_, g_);
    }
    // Within the range of exact products. Their underflow is small compared with the bounds.
    return size < 0x1p100 && radius_.hi > 0x1p-100 && (size_ < 2 || e_.size > 0x1p-100) &&
           (size_ < 3 || (g_.size > 0x1p-100 && n_.size > 0x1p-250));
  }
  [[nodiscard]] Vector step(std::size_t i) const {
    return B::vector({c_[i].x[0] - c_[0].x[0], c_[i].x[1] - c_[0].x[1], c_[i].x[2] - c_[0].x[2]},
                     c_[i].error + c_[0].error + 0x1p-99 * (c_[i].size + c_[0].size));
  }
  // q = square - (R W)^2 scale
  void set_value(const P& square, double error, const P& scale, double scale_error, Value& out) const {
    out.value = rounded(square - square_.x * scale);
    out.error = error + fl(square_.size * scale_error) +
                fl(square_.error * (std::abs(scale.hi) + scale_error)) +
                0x1p-92 * (std::abs(square.hi) + fl(square_.size * std::abs(scale.hi)));
  }
  void set_w(const Vec3<double>& w, double size, double error, double moved, Value& out) const {
    out.w = w;
    out.size = w.cwiseAbs().maxCoeff();
    out.w_error = error + 0x1p-51 * size + moved;
  }

  // Checks that no vertex is beyond and that the path approaches. Then sets normal and weights.
  [[nodiscard]] bool finish(const Value& q, double d, RoundProof& out) const {
    if (!(q.w_error < 0x1p-30 * q.size) || !(dot(q.w, v_.value()) < -0x1p-20 * q.size * v_.size))
      return false;
    Direction n = unknown_direction(Term::motion(), Term::motion(), 1);
    if (size_ == 3) {
      n.f1 = Term::difference(name_[0], name_[1]);
      n.f2 = Term::difference(name_[0], name_[2]);
      n.sign = dot(q.w, n_.value()) < 0 ? -1 : 1;
    }
    n.rounded = size_ < 3;
    n.approx = q.w;
    n.error.setConstant(q.w_error);
    // Across an edge along an axis, w is level.
    if (const int axis = size_ == 2 ? axis_of_edge() : -1; axis >= 0) n.approx[axis] = n.error[axis] = 0;
    const BeyondSearch<S> beyond(scene_, pair_);
    Vertex other;
    if (beyond.find(n, name_[0], std::span<const Vertex>(name_.data() + 1, size_ - 1), other) ||
        beyond.in_doubt())
      return false;
    // In a face w keeps its direction. By as small a step as leaves w's direction the rounding of d does not count.
    Vec3<double> w = q.w;
    if (size_ < 3) {
      const Vec3<double> moved = d * q.across;
      if (!(moved.cwiseAbs().maxCoeff() < 0x1p-20 * q.size)) return false;
      w += moved;
    }
    out.normal = triple(over_length_as<kFused>(w));
    out.lambda = {};
    if (size_ > 1) out.lambda[at_[1]] = q.share[0];
    if (size_ > 2) out.lambda[at_[2]] = q.share[1];
    out.lambda[at_[0]] = 1 - q.share[0] - q.share[1];
    return true;
  }
  // The axis that an edge is parallel to, for bodies that do not rotate, or -1.
  [[nodiscard]] int axis_of_edge() const {
    int axis = -1;
    const Vertex &p = name_[0], &q = name_[1];
    for (int i = 0; i < 3; ++i) {
      bool level = true;
      for (const Leaf<S>& leaf : scene_.leaves()) {
        level = level && !leaf.turned && leaf.point(leaf.vertex(p))[i] == leaf.point(leaf.vertex(q))[i];
      }
      if (level) continue;
      if (axis >= 0) return -1;
      axis = i;
    }
    return axis;
  }

  const PreparedPair<S>& pair_;
  const Scene<S>& scene_;
  P radius_{0, 0}, weight_{1, 0};
  typename B::Number square_{};
  std::size_t size_ = 0;
  std::array<std::size_t, 3> at_{};
  std::array<Vertex, 3> name_{};
  std::array<Vector, 3> c_;
  Vector v_, e_, g_, n_;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
