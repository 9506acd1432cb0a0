// Decides the claims of a proof independently: rationals with division, every vertex pair, Gaussian
// elimination. It is slow and shares no line with the checker. Its formulas differ wherever there was a
// choice.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "corpus/case.hpp"

namespace graze::test {

using Rational = mpq_class;
using RationalVec = std::array<Rational, 3>;

inline RationalVec rational(const Vec3<double>& v) {
  return {Rational(v.x()), Rational(v.y()), Rational(v.z())};
}
inline RationalVec operator-(const RationalVec& a, const RationalVec& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline RationalVec operator+(const RationalVec& a, const RationalVec& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline RationalVec operator*(const Rational& s, const RationalVec& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline RationalVec outer(const RationalVec& a, const RationalVec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Rational inner(const RationalVec& a, const RationalVec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The core vertices of a shape (the centre of a sphere), in the body's frame.
inline std::vector<Vec3<double>> local_vertices(const Shape<double>& shape) {
  if (const auto* hull = std::get_if<Hull<double>>(&shape))
    return {hull->vertices().begin(), hull->vertices().end()};
  if (const auto* box = std::get_if<Box<double>>(&shape)) {
    std::vector<Vec3<double>> corners;
    for (int z : {-1, 1})
      for (int y : {-1, 1})
        for (int x : {-1, 1}) corners.push_back(box->half_extents.cwiseProduct(Vec3<double>(x, y, z)));
    return corners;
  }
  return {Vec3<double>::Zero()};
}

// position + q x conj(q) / |q|^2, by x + 2 w (u x x) / |q|^2 + 2 u x (u x x) / |q|^2, q = (w, u).
inline RationalVec posed(const Body<double>& body, const Vec3<double>& local) {
  const RationalVec x = rational(local);
  const Rational w = body.orientation.w;
  const RationalVec u{body.orientation.x, body.orientation.y, body.orientation.z};
  const RationalVec once = outer(u, x);
  const Rational two_over = Rational(2) / (w * w + inner(u, u));
  return rational(body.position) + x + (two_over * w) * once + two_over * outer(u, once);
}

inline std::vector<RationalVec> posed_vertices(const Body<double>& body) {
  std::vector<RationalVec> posed_all;
  for (const Vec3<double>& x : local_vertices(body.shape)) posed_all.push_back(posed(body, x));
  return posed_all;
}

inline Rational radius_of(const Shape<double>& shape) {
  const auto* sphere = std::get_if<Sphere<double>>(&shape);
  return sphere == nullptr ? Rational(0) : Rational(sphere->radius);
}

// H = max n.(a - b), n.v, R and |n|^2 of an axis, and the bound that it proves.
struct AxisReference {
  Rational support, approach, radius, n_sq;

  AxisReference(const corpus::Case& c, const Vec3<double>& axis) : AxisReference(c, rational(axis)) {}
  AxisReference(const corpus::Case& c, const RationalVec& n) {
    bool first = true;
    for (const RationalVec& a : posed_vertices(c.a)) {
      for (const RationalVec& b : posed_vertices(c.b)) {
        const Rational value = inner(n, a - b);
        if (first || value > support) support = value;
        first = false;
      }
    }
    approach = inner(n, rational(c.b.displacement) - rational(c.a.displacement));
    radius = radius_of(c.a.shape) + radius_of(c.b.shape) + Rational(c.target_distance);
    n_sq = inner(n, n);
  }

  // sign(support + radius |n| - level)
  [[nodiscard]] int compare(const Rational& level) const {
    const Rational room = level - support;
    if (room < 0) return 1;
    return cmp(radius * radius * n_sq, room * room);
  }
  [[nodiscard]] bool lower_holds(double t) const {
    return approach < 0 && compare(Rational(t) * approach) <= 0;
  }
  [[nodiscard]] bool miss_holds(double horizon) const {
    if (approach >= 0) return compare(0) < 0;
    return horizon < kInfinity<double> && compare(Rational(horizon) * approach) < 0;
  }
  // The largest double t > 0 with lower_holds(t), if there is one.
  [[nodiscard]] std::optional<double> tightest() const {
    if (!(approach < 0)) return std::nullopt;
    // An estimate to start from. Quotients come first, so that extreme magnitudes do not leave double's
    // range.
    double t = Rational(support / approach).get_d();
    if (radius > 0) t += Rational(radius / approach).get_d() * std::sqrt(n_sq.get_d());
    if (!(t > 1e-200)) return std::nullopt;
    while (t > 0 && !lower_holds(t)) t = std::nextafter(t, 0.0);
    while (lower_holds(std::nextafter(t, kInfinity<double>))) t = std::nextafter(t, kInfinity<double>);
    if (!(t > 0)) return std::nullopt;
    return t;
  }
};

// The unique solution of the augmented rows [A | y], if A has full column rank and the system is consistent.
inline std::optional<std::vector<Rational>> solve(std::vector<std::vector<Rational>> rows) {
  const std::size_t columns = rows[0].size() - 1;
  for (std::size_t c = 0; c < columns; ++c) {
    std::size_t pivot = c;
    while (pivot < rows.size() && rows[pivot][c] == 0) ++pivot;
    if (pivot >= rows.size()) return std::nullopt;
    std::swap(rows[c], rows[pivot]);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == c || rows[r][c] == 0) continue;
      const Rational factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k <= columns; ++k) rows[r][k] -= factor * rows[c][k];
    }
  }
  for (std::size_t r = columns; r < rows.size(); ++r)
    if (rows[r][columns] != 0) return std::nullopt;
  std::vector<Rational> x(columns);
  for (std::size_t c = 0; c < columns; ++c) x[c] = rows[c][columns] / rows[c][c];
  return x;
}

template <class Visit>
void for_each_subset(std::size_t count, std::size_t most, const Visit& visit) {
  for (std::size_t mask = 1; mask < (std::size_t{1} << count); ++mask) {
    std::vector<std::size_t> subset;
    for (std::size_t i = 0; i < count; ++i)
      if ((mask >> i & 1) != 0) subset.push_back(i);
    if (subset.size() <= most) visit(subset);
  }
}

// {s : s v in hull(points)}, empty if the line misses it. Requires v != 0. Basic solutions of sum lambda_i
// p_i - s v = 0, sum lambda_i = 1.
struct SpanOnLine {
  std::optional<Rational> low, high;

  SpanOnLine(const std::vector<RationalVec>& points, const RationalVec& v) {
    for_each_subset(points.size(), 4, [&](const std::vector<std::size_t>& subset) {
      for (const bool with_s : {true, false}) {  // without s: s = 0 is a basic solution too
        std::vector<std::vector<Rational>> rows(4);
        for (std::size_t r = 0; r < 4; ++r) {
          for (const std::size_t i : subset) rows[r].push_back(r < 3 ? points[i][r] : Rational(1));
          if (with_s) rows[r].push_back(r < 3 ? Rational(-v[r]) : Rational(0));
          rows[r].push_back(r < 3 ? Rational(0) : Rational(1));
        }
        if (rows[0].size() > 5) continue;
        const auto x = solve(rows);
        if (!x) continue;
        bool inside = true;
        for (std::size_t i = 0; i < subset.size(); ++i) inside = inside && (*x)[i] >= 0;
        if (!inside) continue;
        const Rational s = with_s ? x->back() : Rational(0);
        if (!low || s < *low) low = s;
        if (!high || s > *high) high = s;
      }
    });
  }
};

// The squared distance of 0 from hull(points): the least over subsets whose affine foot is inside.
inline Rational distance_sq(const std::vector<RationalVec>& points) {
  std::optional<Rational> least;
  for_each_subset(points.size(), 4, [&](const std::vector<std::size_t>& subset) {
    // Minimise |sum mu_i z_i|^2, sum mu = 1: z_k.x = lambda for all k, and the sum. The unknowns are mu and
    // lambda.
    const std::size_t k = subset.size();
    std::vector<std::vector<Rational>> rows(k + 1, std::vector<Rational>(k + 2, Rational(0)));
    for (std::size_t r = 0; r < k; ++r) {
      for (std::size_t c = 0; c < k; ++c) rows[r][c] = inner(points[subset[r]], points[subset[c]]);
      rows[r][k] = -1;
      rows[k][r] = 1;
    }
    rows[k][k + 1] = 1;
    const auto x = solve(rows);
    if (!x) return;
    RationalVec foot{0, 0, 0};
    for (std::size_t i = 0; i < k; ++i) {
      if ((*x)[i] < 0) return;
      foot = foot + (*x)[i] * points[subset[i]];
    }
    const Rational d = inner(foot, foot);
    if (!least || d < *least) least = d;
  });
  return *least;
}

inline std::vector<RationalVec> portal_points(const corpus::Case& c, const Proof& proof) {
  const auto a = posed_vertices(c.a), b = posed_vertices(c.b);
  std::vector<RationalVec> points;
  for (int i = 0; i < proof.portal_size; ++i) {
    const SupportPair& s = proof.portal[static_cast<std::size_t>(i)];
    points.push_back(a[s.a.vertex] + rational(s.a.offset) - b[s.b.vertex] - rational(s.b.offset));
  }
  return points;
}

}  // namespace graze::test
