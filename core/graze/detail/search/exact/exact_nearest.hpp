// Decides exactly whether a polytope K comes within R of the origin. Use it if rounding leaves that open.
//
//   f = min |x|^2 over K;   sign of f - R^2, and p, a positive multiple of the nearest point.
// K is given by its vertices: `points.at(id)` is an exact vector with a weight, and `points.lowest(p)` returns a
// vertex x with the least p.x. The search is GJK in dyadic numbers, so that every decision is the sign of a rational
// number:
//
//   feature     p                          |p|^2 as a fraction       the foot is inside
//   vertex X    X                          X.X                       -
//   edge e      (e.e) X - (X.e) e          |X x e|^2 / e.e           0 <= -X.e <= e.e
//   face e, g   (X.N) N,  N = e x g        (X.N)^2 / N.N             N.((-X) x g), N.(e x (-X)) and N.N less both >= 0
//
// The nearest feature of a simplex is the one whose foot is inside and that no other corner lies beyond:
// p.(c - X) >= 0. A support point strictly beyond it shortens |p|, and simplices are finite, so the search ends. On a
// tie both features are correct. A decision stops once it is certain. `settle` continues to the nearest point of K.
#pragma once

#include <graze/detail/numeric/vectors.hpp>
#include <optional>
#include <span>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// x as a double vector of about length 1, each coordinate within 2^-51 of the largest. Zero stays zero.
inline Vec3<double> direction_of(const exact::Dyadic3& x) {
  bool any = false;
  int most = 0;
  for (const exact::Dyadic& one : x) {
    if (one.sign() == 0) continue;
    most = any ? std::max(most, one.order()) : one.order();
    any = true;
  }
  Vec3<double> out = Vec3<double>::Zero();
  for (int i = 0; i < 3; ++i) {
    const exact::Dyadic& one = x[static_cast<std::size_t>(i)];
    if (one.sign() != 0 && one.order() - most > -200)
      out[i] = one.leading() * power_of_two(one.order() - most);
  }
  return out;
}
inline exact::Dyadic3 minus(const exact::Dyadic3& x) { return {-x[0], -x[1], -x[2]}; }
inline exact::Dyadic3 difference(const exact::Dyadic3& x, const exact::Dyadic3& y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}
inline exact::Dyadic3 times(const exact::Dyadic& k, const exact::Dyadic3& x) {
  return {k * x[0], k * x[1], k * x[2]};
}

// x / y as a double, within 2^-50 of itself. For y != 0.
inline double ratio(const exact::Dyadic& x, const exact::Dyadic& y) {
  if (x.sign() == 0) return 0;
  return std::ldexp(x.leading() / y.leading(), std::clamp(x.order() - y.order(), -1000, 1000));
}

// The same within u and a little.
inline double near_ratio(const exact::Dyadic& x, const exact::Dyadic& y) {
  const double q = ratio(x, y);
  return q + ratio(x - exact::Dyadic(q) * y, y);
}

// The result for a start. `n` is a positive multiple of a normal from A to B, with h(n) over C and the balls:
enum class StartKind : std::uint8_t {
  open,
  apart,     // h(n) + R |n| < 0
  touching,  // in contact, and h(n) + R |n| = 0 if n != 0
  deep,      // in contact, and the origin is inside of C
  contact,   // in contact, possibly only touching
};
struct ExactStart {
  StartKind kind = StartKind::open;
  exact::Dyadic3 n;
  bool only_normal = false;  // touching: every other normal is a multiple of n
  [[nodiscard]] bool is_contact() const { return kind != StartKind::open && kind != StartKind::apart; }
};

template <class Points>
class ExactNearest {
  using Dyadic = exact::Dyadic;
  using Dyadic3 = exact::Dyadic3;
  using Id = typename Points::Id;

 public:
  // `radius`: R >= 0.
  ExactNearest(const Points& points, const Dyadic& radius) : points_(points), radius_(radius) {}

  // From any vertices, one to four, different ones. The normal is -p.
  [[nodiscard]] ExactStart operator()(std::span<const Id> first) {
    for (const Id& id : first) add(id);
    for (int step = 0; step < kSteps; ++step) {
      if (!choose_feature()) return {};
      ExactStart out;
      if (sign_of_f_ < 0) return {StartKind::deep, {}, false};
      if (is_zero(p_)) {
        // The origin is in K, and R is 0: inside, or on the border. This query does not need the difference.
        return {size_ == 4 ? StartKind::deep : StartKind::contact, {}, false};
      }
      const std::optional<Id> next = points_.lowest(p_);
      if (!next || !is_valid()) return {};
      const exact::Exact c = points_.at(*next);
      // p.c > 0 and (p.c)^2 > R^2 p.p
      const Dyadic height = exact::dot(p_, c.x);
      const Dyadic reach = radius_ * c.weight;
      const Dyadic clear = height * height - reach * reach * exact::dot(p_, p_);
      if (!clear.valid()) return {};
      if (height.sign() > 0 && clear.sign() > 0) return {StartKind::apart, minus(p_), false};
      const Dyadic beyond = height * weight_ - exact::dot(p_, x_[0]) * c.weight;
      if (!beyond.valid()) return {};
      if (beyond.sign() >= 0) {
        // p is nearest, and f > R^2 was told above.
        if (sign_of_f_ > 0) return {};
        return {StartKind::touching, minus(p_), true};
      }
      add(*next);
    }
    return {};
  }

  // The nearest point of K, however far it is. False if a number outgrew its room.
  [[nodiscard]] bool settle(std::span<const Id> first) {
    for (const Id& id : first) add(id);
    while (choose_feature()) {
      if (is_zero(p_)) return true;
      const std::optional<Id> next = points_.lowest(p_);
      if (!next || !is_valid()) return false;
      const exact::Exact c = points_.at(*next);
      const Dyadic beyond = exact::dot(p_, c.x) * weight_ - exact::dot(p_, x_[0]) * c.weight;
      if (!beyond.valid()) return false;
      if (beyond.sign() >= 0) return true;
      add(*next);
    }
    return false;
  }
  // After settle(). The feature's corners: all of the hull's four if the origin is inside.
  [[nodiscard]] std::span<const Id> corners() const { return {id_.data(), size_}; }
  // A corner times the weight W of all. p is below W times the nearest point unless that is in a face.
  [[nodiscard]] const Dyadic3& corner(std::size_t i) const { return x_[i]; }
  [[nodiscard]] const Dyadic& weight() const { return weight_; }
  [[nodiscard]] const Dyadic3& p() const { return p_; }
  [[nodiscard]] int sign_of_f() const { return sign_of_f_; }
  // |p|^2 = above / below, in units of W: the table above.
  [[nodiscard]] const Dyadic& above() const { return above_; }
  [[nodiscard]] const Dyadic& below() const { return below_; }
  // The nearest point's barycentric coordinate of a corner.
  [[nodiscard]] double share(std::size_t i) const { return size_ == 1 ? 1 : ratio(share_[i], below_); }

 private:
  // GJK takes about as many steps as K's features have corners. A far larger number indicates a defect.
  static constexpr int kSteps = 200;

  void add(const Id& id) {
    id_[size_] = id;
    given_[size_++] = points_.at(id);
  }
  static bool is_zero(const Dyadic3& x) { return x[0].sign() == 0 && x[1].sign() == 0 && x[2].sign() == 0; }
  [[nodiscard]] bool is_valid() const {
    for (const Dyadic3& x : x_) {
      for (const Dyadic& one : x) {
        if (!one.valid()) return false;
      }
    }
    return weight_.valid() && valid_;
  }
  // The corners with one weight.
  void bring_together() {
    weight_ = given_[0].weight;
    bool same = true;
    for (std::size_t i = 1; i < size_; ++i) same = same && (given_[i].weight - weight_).sign() == 0;
    for (std::size_t i = 0; i < size_; ++i) {
      x_[i] = given_[i].x;
      for (std::size_t j = 0; !same && j < size_; ++j) {
        if (j != i) x_[i] = times(given_[j].weight, x_[i]);
      }
    }
    for (std::size_t i = 1; !same && i < size_; ++i) weight_ = weight_ * given_[i].weight;
  }
  [[nodiscard]] int sign(const Dyadic& x) {
    valid_ = valid_ && x.valid();
    return x.sign();
  }
  // Is p the nearest of the simplex? Then it keeps the feature's corners alone.
  bool is_nearest(std::array<std::size_t, 3> corner, std::size_t count) {
    for (std::size_t k = 0; k < size_; ++k) {
      const bool own = k == corner[0] || (count > 1 && k == corner[1]) || (count > 2 && k == corner[2]);
      if (!own && sign(exact::dot(p_, difference(x_[k], x_[corner[0]]))) < 0) return false;
    }
    keep(corner, count);
    return true;
  }
  void keep(std::array<std::size_t, 3> corner, std::size_t count) {
    std::array<Id, 4> id = id_;
    std::array<exact::Exact, 3> given;
    std::array<Dyadic3, 3> x;
    for (std::size_t i = 0; i < count; ++i) {
      id[i] = id_[corner[i]];
      given[i] = given_[corner[i]];
      x[i] = x_[corner[i]];
    }
    for (std::size_t i = 0; i < count; ++i) {
      id_[i] = id[i];
      given_[i] = given[i];
      x_[i] = x[i];
    }
    size_ = count;
  }
  // |p|^2 = above / below against R^2, x having the weight W.
  void compare(const Dyadic& above, const Dyadic& below) {
    above_ = above;
    below_ = below;
    const Dyadic reach = radius_ * weight_;
    sign_of_f_ = sign(above - reach * reach * below);
  }
  // The nearest feature of the simplex: p, and the sign of f - R^2. False if a number outgrew its room.
  bool choose_feature() {
    bring_together();
    for (std::size_t i = 0; i < size_; ++i) {
      p_ = x_[i];
      if (!is_nearest({i, 0, 0}, 1)) continue;
      compare(exact::dot(p_, p_), Dyadic(1));
      return valid_;
    }
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t j = i + 1; j < size_; ++j) {
        const Dyadic3 e = difference(x_[j], x_[i]);
        const Dyadic along = -exact::dot(x_[i], e), length = exact::dot(e, e);
        if (sign(along) < 0 || sign(length - along) < 0 || sign(length) == 0) continue;
        const Dyadic3 at = times(length, x_[i]), by = times(along, e);
        p_ = {at[0] + by[0], at[1] + by[1], at[2] + by[2]};
        const Dyadic3 across = exact::cross(x_[i], e);
        if (!is_nearest({i, j, 0}, 2)) continue;
        share_ = {length - along, along, Dyadic()};
        compare(exact::dot(across, across), length);
        return valid_;
      }
    }
    for (std::size_t skip = 0; skip < size_; ++skip) {
      if (size_ == 3 && skip > 0) break;
      std::array<std::size_t, 3> at{};
      std::size_t count = 0;
      for (std::size_t i = 0; i < size_ && count < 3; ++i) {
        if (size_ == 3 || i != skip) at[count++] = i;
      }
      if (count < 3) break;
      const Dyadic3 z = minus(x_[at[0]]);
      const Dyadic3 e = difference(x_[at[1]], x_[at[0]]), g = difference(x_[at[2]], x_[at[0]]);
      const Dyadic3 n = exact::cross(e, g);
      const Dyadic area = exact::dot(n, n);
      if (sign(area) == 0) continue;
      const Dyadic to_e = exact::dot(n, exact::cross(z, g)), to_g = exact::dot(n, exact::cross(e, z));
      if (sign(to_e) < 0 || sign(to_g) < 0 || sign(area - to_e - to_g) < 0) continue;
      const Dyadic height = -exact::dot(z, n);
      const int side = sign(height);
      p_ = side == 0 ? Dyadic3{} : side > 0 ? n : minus(n);
      if (!is_nearest(at, 3)) continue;
      share_ = {area - to_e - to_g, to_e, to_g};
      compare(height * height, area);
      return valid_;
    }
    // None: the origin is strictly inside of the tetrahedron.
    if (size_ < 4) return false;
    p_ = {};
    sign_of_f_ = radius_.sign() > 0 ? -1 : 0;
    return valid_;
  }

  const Points& points_;
  Dyadic radius_, weight_;
  std::size_t size_ = 0;
  std::array<Id, 4> id_{};
  std::array<exact::Exact, 4> given_;
  std::array<Dyadic3, 4> x_;
  Dyadic3 p_, share_;
  Dyadic above_, below_;
  int sign_of_f_ = 0;
  bool valid_ = true;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
