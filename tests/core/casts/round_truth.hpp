// When are two moving rounded polytopes first in contact? By closed forms in rational numbers, feature by
// feature. This is the reference for the exact tier's tests of rounded shapes. It shares nothing with the
// search.
//
//   K + ball(R) is the union of balls about K's vertices, cylinders about its edges and prisms over its triangles, K the
//   hull of the differences of the cores' vertices, and of K itself. Every triple of vertices is taken for a face.
//   The additional triangles are in K, so nothing wrong is added.
//   The foot of t v is in the feature during an interval with rational ends. Over it, the squared distance less R^2
//   is a quadratic, whose least value there is rational. Its sign decides whether the path is in contact.
#pragma once

#include <gmpxx.h>

#include <graze/body.hpp>
#include <optional>
#include <vector>

namespace graze::test {

using Rational = mpq_class;
using Point3 = std::array<Rational, 3>;

inline Point3 operator-(const Point3& x, const Point3& y) { return {x[0] - y[0], x[1] - y[1], x[2] - y[2]}; }
inline Point3 operator+(const Point3& x, const Point3& y) { return {x[0] + y[0], x[1] + y[1], x[2] + y[2]}; }
inline Point3 operator*(const Rational& k, const Point3& x) { return {k * x[0], k * x[1], k * x[2]}; }
inline Rational dot(const Point3& x, const Point3& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
inline Point3 cross(const Point3& x, const Point3& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
template <class S>
Point3 rational(const Vec3<S>& x) {
  return {Rational(static_cast<double>(x[0])), Rational(static_cast<double>(x[1])),
          Rational(static_cast<double>(x[2]))};
}
template <class S>
Point3 turned(const Quaternion<S>& q, const Point3& x) {
  const Rational w(static_cast<double>(q.w));
  const Vec3<S> imaginary(q.x, q.y, q.z);
  const Point3 u = rational(imaginary);
  const Rational all = w * w + dot(u, u);
  // x + 2 u x (u x x + w x) / |q|^2
  return x + Rational(2 / all) * cross(u, cross(u, x) + w * x);
}

// A core and its ball.
struct Core {
  std::vector<Point3> vertex;
  Rational radius;
};
template <class S>
Core core_of(const Shape<S>& shape) {
  Core out;
  if (std::holds_alternative<graze::Point<S>>(shape)) {
    out.vertex.emplace_back();
  } else if (const auto* sphere = std::get_if<Sphere<S>>(&shape)) {
    out.vertex.emplace_back();
    out.radius = Rational(double(sphere->radius));
  } else if (const auto* capsule = std::get_if<Capsule<S>>(&shape)) {
    const Rational h(double(capsule->half_height));
    out.vertex.resize(2);
    out.vertex[0][2] = -h;
    out.vertex[1][2] = h;
    out.radius = Rational(double(capsule->radius));
  } else if (const auto* segment = std::get_if<Segment<S>>(&shape)) {
    out.vertex = {rational(segment->a), rational(segment->b)};
  } else if (const auto* triangle = std::get_if<Triangle<S>>(&shape)) {
    out.vertex = {rational(triangle->a), rational(triangle->b), rational(triangle->c)};
  } else if (const auto* box = std::get_if<Box<S>>(&shape)) {
    const Point3 h = rational(box->half_extents);
    for (int k = 0; k < 8; ++k)
      out.vertex.push_back({k & 1 ? h[0] : -h[0], k & 2 ? h[1] : -h[1], k & 4 ? h[2] : -h[2]});
  } else if (const auto* hull = std::get_if<Hull<S>>(&shape)) {
    for (const Vec3<S>& x : hull->vertices()) out.vertex.push_back(rational(x));
  } else if (const auto* rounded = std::get_if<Rounded<S>>(&shape)) {
    out = core_of<S>(rounded->shape->shape);
    out.radius += Rational(double(rounded->radius));
  } else if (const auto* posed = std::get_if<Posed<S>>(&shape)) {
    out = core_of<S>(posed->shape->shape);
    for (Point3& x : out.vertex) x = turned(posed->orientation, x) + rational(posed->position);
  } else if (const auto* sum = std::get_if<Sum<S>>(&shape)) {
    out.vertex.emplace_back();
    for (const auto& part : sum->shapes) {
      const Core one = core_of<S>(part->shape);
      std::vector<Point3> more;
      for (const Point3& x : out.vertex) {
        for (const Point3& y : one.vertex) more.push_back(x + y);
      }
      out.vertex = more;
      out.radius += one.radius;
    }
  }
  return out;
}

class RoundTruth {
 public:
  template <class S>
  RoundTruth(const Body<S>& a, const Body<S>& b, S target) {
    const Core core_a = core_of(a.shape), core_b = core_of(b.shape);
    v_ = rational(b.displacement) - rational(a.displacement);
    balls_ = core_a.radius + core_b.radius;
    radius_ = balls_ + Rational(double(target));
    for (const Point3& x : core_a.vertex) {
      for (const Point3& y : core_b.vertex) {
        const Point3 c = turned(a.orientation, x) + rational(a.position) -
                         (turned(b.orientation, y) + rational(b.position));
        if (std::find(k_.begin(), k_.end(), c) == k_.end()) k_.push_back(c);
      }
    }
  }

  [[nodiscard]] bool starts_in_contact() const {
    return meets(v_, radius_, 0, Rational(0)) || holds_origin();
  }
  // Is there contact at some t in [0, end], or, if `before`, in [0, end)? Requires no contact at 0. No end: a
  // ray.
  [[nodiscard]] bool contact_until(const std::optional<Rational>& end, bool before = false) const {
    return meets(v_, radius_, 0, end, before);
  }
  // In contact at t = 0, of a motion and r > 0: the ray stays r apart.
  [[nodiscard]] bool leaves_or_slides() const {
    return !meets(v_, balls_, 0, std::nullopt, false, true) && !holds_origin();
  }
  // Is the line in contact at some t <= end (toward -1), or at some t >= end?
  [[nodiscard]] bool line_until(const Rational& end, int toward, bool before) const {
    return toward < 0 ? meets(v_, radius_, std::nullopt, end, before)
                      : meets(Rational(-1) * v_, radius_, std::nullopt, Rational(-end), before);
  }
  [[nodiscard]] bool line_meets() const {
    return meets(v_, radius_, std::nullopt, std::nullopt) || holds_origin();
  }
  [[nodiscard]] bool moves() const { return dot(v_, v_) > 0; }

  // The greatest n.c over K.
  [[nodiscard]] Rational reach(const Point3& n) const {
    Rational most = dot(n, k_.front());
    for (const Point3& c : k_) most = std::max(most, dot(n, c));
    return most;
  }
  [[nodiscard]] const Rational& radius() const { return radius_; }
  [[nodiscard]] const Rational& balls() const { return balls_; }
  [[nodiscard]] const Point3& motion() const { return v_; }

 private:
  // A quadratic a s^2 + 2 b s + c over the times where two or fewer linear functions are >= 0.
  struct Piece {
    std::optional<Rational> low, high, end;  // end: of the whole path
    bool empty = false;
    // k + l s >= 0
    void keep(const Rational& k, const Rational& l) {
      if (l == 0) {
        empty = empty || k < 0;
      } else if (l > 0) {
        if (!low || *low < -k / l) low = -k / l;
      } else {
        if (!high || *high > -k / l) high = -k / l;
      }
      empty = empty || (low && high && *low > *high);
    }
    // Is it <= 0 somewhere, or, if `strictly`, < 0? If `before`: before the end?
    [[nodiscard]] bool meets(const Rational& a, const Rational& b, const Rational& c, bool before,
                             bool strictly) const {
      if (empty) return false;
      Rational s = 0;
      if (a > 0) {
        s = -b / a;
      } else if (low) {
        s = *low;  // a constant: b is 0 with a
      } else if (high) {
        s = *high - 1;
      }
      if (low && s < *low) s = *low;
      if (high && s > *high) s = *high;
      const Rational least = a * s * s + 2 * b * s + c;
      if (before && end && s == *end) return least < 0 && !(low && *low == *end);
      return strictly ? least < 0 : least <= 0;
    }
  };

  [[nodiscard]] bool holds_origin() const {
    const Point3 aside = {1, Rational(3, 7), Rational(5, 11)};
    return meets(aside, 0, 0, std::nullopt) && meets(Rational(-1) * aside, 0, 0, std::nullopt);
  }
  [[nodiscard]] bool meets(const Point3& v, const Rational& radius, const std::optional<Rational>& from,
                           const std::optional<Rational>& to, bool before = false,
                           bool strictly = false) const {
    Piece whole;
    whole.low = from;
    whole.high = whole.end = to;
    const Rational square = radius * radius;
    // |s m - x|^2 - scale R^2
    const auto quadratic = [&](const Piece& piece, const Point3& m, const Point3& x, const Rational& scale) {
      return piece.meets(dot(m, m), -dot(m, x), dot(x, x) - scale * square, before, strictly);
    };
    for (std::size_t i = 0; i < k_.size(); ++i) {
      const Point3& c = k_[i];
      if (quadratic(whole, v, c, 1)) return true;
      for (std::size_t j = i + 1; j < k_.size(); ++j) {
        const Point3 e = k_[j] - c;
        const Rational ee = dot(e, e), ev = dot(e, v), ec = dot(e, c);
        Piece along = whole;
        along.keep(-ec, ev);
        along.keep(ee + ec, -ev);
        if (!along.empty && quadratic(along, cross(v, e), cross(c, e), ee)) return true;
        for (std::size_t k = j + 1; k < k_.size(); ++k) {
          const Point3 g = k_[k] - c, n = cross(e, g);
          const Rational area = dot(n, n);
          if (area == 0) continue;
          Piece over = whole;
          // The foot's coordinates of e and g.
          const Rational e_0 = -dot(n, cross(c, g)), e_1 = dot(n, cross(v, g));
          const Rational g_0 = -dot(n, cross(e, c)), g_1 = dot(n, cross(e, v));
          over.keep(e_0, e_1);
          over.keep(g_0, g_1);
          over.keep(area - e_0 - g_0, -e_1 - g_1);
          const Rational rise = dot(n, v), height = dot(n, c);
          if (!over.empty &&
              over.meets(rise * rise, -rise * height, height * height - area * square, before, strictly))
            return true;
        }
      }
    }
    return false;
  }

  std::vector<Point3> k_;
  Point3 v_;
  Rational radius_, balls_;
};

}  // namespace graze::test
