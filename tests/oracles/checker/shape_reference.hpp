// A second definition of every kind of shape, for the tests of the proof checker. It has the support point in
// numbers of 2,048 bits (the checker has support values, division-free), and all named vertices of a core by
// enumeration.
#pragma once

#include "tests/oracles/checker/proof_reference.hpp"

namespace graze::test {

using High = mpf_class;
using HighVec = std::array<High, 3>;

// Results have a relative error of some 2^-2040. Sums of numbers near 1 to 1e6 that differ by less than
// 2^-1500 are taken as equal (two that differ at all, of roots of numbers this short, differ by far more).
inline constexpr int kHighBits = 2048, kEqualBits = 1500;
inline const bool kHighPrecision = (mpf_set_default_prec(kHighBits), true);

inline HighVec high(const Vec3<double>& v) { return {High(v.x()), High(v.y()), High(v.z())}; }
inline HighVec rounded_high(const RationalVec& v) { return {High(v[0]), High(v[1]), High(v[2])}; }
inline HighVec operator+(const HighVec& a, const HighVec& b) {
  return {High(a[0] + b[0]), High(a[1] + b[1]), High(a[2] + b[2])};
}
inline HighVec operator*(const High& s, const HighVec& a) {
  return {High(s * a[0]), High(s * a[1]), High(s * a[2])};
}
inline High inner(const HighVec& a, const HighVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline High length(const HighVec& a) { return sqrt(inner(a, a)); }

// q x conj(q) / |q|^2 by the vector form of proof_reference.hpp. inverse: by conj(q).
inline HighVec turned(const Quaternion<double>& q, const HighVec& x, bool inverse) {
  const High w = q.w;
  HighVec u = high({q.x, q.y, q.z});
  if (inverse) u = High(-1) * u;
  const auto cross = [](const HighVec& l, const HighVec& r) -> HighVec {
    return {High(l[1] * r[2] - l[2] * r[1]), High(l[2] * r[0] - l[0] * r[2]),
            High(l[0] * r[1] - l[1] * r[0])};
  };
  const High two_over = 2 / High(w * w + inner(u, u));
  const HighVec once = cross(u, x);
  return x + High(two_over * w) * once + two_over * cross(u, once);
}

// The vertices of a polytope's core in its own frame, or the centre of a ball. Empty for other shapes.
inline std::vector<Vec3<double>> core_vertices(const Shape<double>& shape) {
  if (const auto* s = std::get_if<Segment<double>>(&shape)) return {s->a, s->b};
  if (const auto* s = std::get_if<Triangle<double>>(&shape)) return {s->a, s->b, s->c};
  if (const auto* s = std::get_if<Capsule<double>>(&shape))
    return {{0, 0, -s->half_height}, {0, 0, s->half_height}};
  for (const bool simple :
       {std::holds_alternative<Point<double>>(shape), std::holds_alternative<Sphere<double>>(shape),
        std::holds_alternative<Box<double>>(shape), std::holds_alternative<Hull<double>>(shape)})
    if (simple) return local_vertices(shape);
  return {};
}
inline double ball_radius(const Shape<double>& shape) {
  if (const auto* s = std::get_if<Sphere<double>>(&shape)) return s->radius;
  if (const auto* s = std::get_if<Capsule<double>>(&shape)) return s->radius;
  return 0;
}

// A point of the shape that is farthest along n, in the shape's frame.
inline HighVec support_point(const Shape<double>& shape, const HighVec& n) {
  const auto stretched = [](const HighVec& d, double to) -> HighVec {
    const High l = length(d);
    return l > 0 ? High(to / l) * d : HighVec{High(0), High(0), High(0)};
  };
  if (const auto vertices = core_vertices(shape); !vertices.empty()) {
    HighVec best = high(vertices[0]);
    for (const Vec3<double>& x : vertices)
      if (inner(n, high(x)) > inner(n, best)) best = high(x);
    return best + stretched(n, ball_radius(shape));
  }
  if (const auto* s =
          std::get_if<Ellipsoid<double>>(&shape)) {  // r_i^2 n_i over the root of their sum with n
    const HighVec r = high(s->radii), d{High(r[0] * n[0]), High(r[1] * n[1]), High(r[2] * n[2])};
    const HighVec unit = stretched(d, 1);
    return {High(r[0] * unit[0]), High(r[1] * unit[1]), High(r[2] * unit[2])};
  }
  const HighVec flat{n[0], n[1], High(0)};
  if (const auto* s = std::get_if<Cylinder<double>>(&shape))
    return stretched(flat, s->radius) + high({0, 0, n[2] > 0 ? s->half_height : -s->half_height});
  if (const auto* s = std::get_if<Cone<double>>(&shape)) {
    const HighVec apex = high({0, 0, s->half_height}),
                  rim = stretched(flat, s->radius) + high({0, 0, -s->half_height});
    return inner(n, apex) > inner(n, rim) ? apex : rim;
  }
  if (const auto* s = std::get_if<Posed<double>>(&shape))
    return high(s->position) +
           turned(s->orientation, support_point(s->shape->shape, turned(s->orientation, n, true)), false);
  if (const auto* s = std::get_if<Rounded<double>>(&shape))
    return support_point(s->shape->shape, n) + stretched(n, s->radius);
  if (const auto* s = std::get_if<Sum<double>>(&shape)) {
    HighVec sum = high({0, 0, 0});
    for (const auto& part : s->shapes) sum = sum + support_point(part->shape, n);
    return sum;
  }
  const auto& hull = std::get<HullOf<double>>(shape);
  HighVec best = support_point(hull.shapes[0]->shape, n);
  for (const auto& part : hull.shapes)
    if (const HighVec x = support_point(part->shape, n); inner(n, x) > inner(n, best)) best = x;
  return best;
}

// h(n) and n.v of a case, and what they prove.
struct HighAxis {
  High support, approach;

  HighAxis(const corpus::Case& c, const Vec3<double>& axis) : HighAxis(c, high(axis)) {}
  HighAxis(const corpus::Case& c, const HighVec& n) {
    const HighVec minus = High(-1) * n;
    const auto reach = [](const Body<double>& body, const HighVec& d) {
      const HighVec local = support_point(body.shape, turned(body.orientation, d, true));
      return inner(d, high(body.position) + turned(body.orientation, local, false));
    };
    support = reach(c.a, n) + reach(c.b, minus) + length(n) * c.target_distance;
    approach = inner(n, high(c.b.displacement)) - inner(n, high(c.a.displacement));
  }
  // sign(h(n) - t n.v)
  [[nodiscard]] int compare(double t) const {
    High room = support - t * approach, equal = abs(support) + abs(approach) * t + 1;
    mpf_div_2exp(equal.get_mpf_t(), equal.get_mpf_t(), kEqualBits);
    return room > equal ? 1 : room < -equal ? -1 : 0;
  }
  [[nodiscard]] bool lower_holds(double t) const { return approach < 0 && compare(t) <= 0; }
  [[nodiscard]] bool miss_holds(double horizon) const {
    if (approach >= 0) return compare(0) < 0;
    return horizon < kInfinity<double> && compare(0) < 0 && compare(horizon) < 0;
  }
  // The largest double t > 0 with lower_holds(t), if there is one.
  [[nodiscard]] std::optional<double> tightest() const {
    if (!(approach < 0) || support >= 0) return std::nullopt;
    double t = High(support / approach).get_d();
    if (!(t > 1e-200)) return std::nullopt;
    while (t > 0 && !lower_holds(t)) t = std::nextafter(t, 0.0);
    while (lower_holds(std::nextafter(t, kInfinity<double>))) t = std::nextafter(t, kInfinity<double>);
    return t;
  }
};

// A vertex of a core, within `radius` of fixed + sum over its curved parts of map x, x in the part.
struct NamedVertex {
  struct Slot {
    const Shape<double>* part;
    std::array<RationalVec, 3> columns;
  };
  RationalVec fixed{0, 0, 0};
  Rational radius = 0;
  std::vector<Slot> slots;
};

inline RationalVec mapped(const std::array<RationalVec, 3>& columns, const RationalVec& x) {
  return x[0] * columns[0] + x[1] * columns[1] + x[2] * columns[2];
}
inline std::array<RationalVec, 3> rotation_columns(const Quaternion<double>& q) {
  Body<double> turn;
  turn.orientation = q;
  return {posed(turn, {1, 0, 0}), posed(turn, {0, 1, 0}), posed(turn, {0, 0, 1})};
}
inline NamedVertex moved(NamedVertex v, const Quaternion<double>& q, const Vec3<double>& position) {
  const auto columns = rotation_columns(q);
  v.fixed = mapped(columns, v.fixed) + rational(position);
  for (auto& slot : v.slots)
    for (RationalVec& column : slot.columns) column = mapped(columns, column);
  return v;
}

// All of them, in the order of their indices.
inline std::vector<NamedVertex> named_vertices(const Shape<double>& shape) {
  std::vector<NamedVertex> all;
  if (const auto vertices = core_vertices(shape); !vertices.empty()) {
    for (const Vec3<double>& x : vertices) all.push_back({rational(x), Rational(ball_radius(shape)), {}});
  } else if (const auto* p = std::get_if<Posed<double>>(&shape)) {
    for (NamedVertex& v : named_vertices(p->shape->shape))
      all.push_back(moved(std::move(v), p->orientation, p->position));
  } else if (const auto* r = std::get_if<Rounded<double>>(&shape)) {
    all = named_vertices(r->shape->shape);
    for (NamedVertex& v : all) v.radius += Rational(r->radius);
  } else if (const auto* s = std::get_if<Sum<double>>(&shape)) {
    all.push_back({});
    for (const auto& part : s->shapes) {
      std::vector<NamedVertex> longer;
      const std::vector<NamedVertex> more = named_vertices(part->shape);
      for (const NamedVertex& first : all) {
        for (const NamedVertex& second : more) {
          NamedVertex sum = first;
          sum.fixed = sum.fixed + second.fixed;
          sum.radius += second.radius;
          sum.slots.insert(sum.slots.end(), second.slots.begin(), second.slots.end());
          longer.push_back(std::move(sum));
        }
      }
      all = std::move(longer);
    }
  } else if (const auto* h = std::get_if<HullOf<double>>(&shape)) {
    for (const auto& part : h->shapes)
      for (NamedVertex& v : named_vertices(part->shape)) all.push_back(std::move(v));
  } else {
    all.push_back({{0, 0, 0}, 0, {{&shape, rotation_columns({})}}});
  }
  return all;
}

inline RationalVec world_point(const Body<double>& body, const std::vector<NamedVertex>& vertices,
                               const Feature& feature) {
  const NamedVertex v = moved(vertices[feature.vertex], body.orientation, body.position);
  RationalVec at = v.fixed + rational(feature.offset);
  for (std::size_t k = 0; k < v.slots.size(); ++k)
    at = at + mapped(v.slots[k].columns, rational(feature.curved[k]));
  return at;
}

// Is x in the ellipsoid, cylinder or cone? By division.
inline bool in_part(const Shape<double>& part, const Vec3<double>& point) {
  const RationalVec x = rational(point);
  if (const auto* s = std::get_if<Ellipsoid<double>>(&part)) {
    Rational sum = 0;
    for (int i = 0; i < 3; ++i) {
      if (s->radii[i] == 0 && point[i] != 0) return false;
      const Rational ratio = s->radii[i] == 0 ? Rational(0) : Rational(x[i] / Rational(s->radii[i]));
      sum += ratio * ratio;
    }
    return sum <= 1;
  }
  const auto* cylinder = std::get_if<Cylinder<double>>(&part);
  const Rational r = cylinder ? cylinder->radius : std::get<Cone<double>>(part).radius;
  const Rational h = cylinder ? cylinder->half_height : std::get<Cone<double>>(part).half_height;
  if (abs(x[2]) > h) return false;
  const Rational here = cylinder || h == 0 ? r : Rational(r * (h - x[2]) / (2 * h));
  return x[0] * x[0] + x[1] * x[1] <= here * here;
}

}  // namespace graze::test
