// Proved contact of two placed bodies: pairs of support points that hold the origin between them.
//
// Lengths: internal. e bounds how far a support point may be from the point of the true CSO that its feature
// names. Contact holds if either
//   |sum l_i w_i| + e <= R, R the radii and the target distance: the closest point of the cores is near enough;
//   or the ball of radius e about the origin lies inside the tetrahedron of four support points: h(n) > e for
//   every unit n then, and moving each point by up to e leaves h > 0.
// How far a face's plane is from the origin is computed from its nearest corner w: the normal's direction is
// known to a few u over the sine of the face's widest angle, and only |w| of it counts.
#pragma once

#include <graze/gjk.hpp>
#include <graze/prove.hpp>
#include <graze/rotating/moving_pair.hpp>

namespace graze::detail {

struct Contact {
  bool proved = false;
  Simplex<double> pairs;  // weighted
};

// Of a named support point.
inline double contact_error(const MovingPair& pair) {
  const Cso<double>& cso = pair.cso();
  constexpr double u = kUnitRoundoff<double>;
  return 2 * cso.point_error() + (cso.curved() ? 2 * kInsideTree * u * cso.extent() : 0.0) +
         8 * u * (pair.radius() + cso.offset().norm());
}

// The least distance of the origin from the faces of a tetrahedron that holds it, less its rounding; negative
// where it does not, or cannot be said to.
inline double depth_inside(const std::array<Vec3<double>, 4>& w) {
  constexpr double u = kUnitRoundoff<double>;
  double least = kInfinity<double>;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3<double>&a = w[(i + 1) % 4], &b = w[(i + 2) % 4], &c = w[(i + 3) % 4];
    const Vec3<double> m = face_normal(a, b, c);
    const double area = m.norm();
    if (!(area > 0)) return -1;
    const Vec3<double>& near = a.squaredNorm() <= b.squaredNorm() && a.squaredNorm() <= c.squaredNorm() ? a
                               : b.squaredNorm() <= c.squaredNorm()                                     ? b
                                                                                                        : c;
    const double longest = std::max({(a - b).norm(), (b - c).norm(), (c - a).norm()});
    const double doubt = 16 * u * near.norm() * (1 + longest * longest / area);
    // The opposite corner and the origin lie on one side.
    const double height = m.dot(w[i] - near) / area, from = -m.dot(near) / area;
    const double inside = height > 0 ? from : -from;
    if (!(std::abs(height) > doubt)) return -1;
    least = std::min(least, inside - doubt);
  }
  return least;
}

// Weights of the origin in a tetrahedron, by volumes.
inline void weigh(Simplex<double>& pairs) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3<double>&a = pairs.point[(i + 1) % 4].w, &b = pairs.point[(i + 2) % 4].w,
          &c = pairs.point[(i + 3) % 4].w;
    pairs.lambda[i] = std::abs(a.dot(b.cross(c)));
    sum += pairs.lambda[i];
  }
  for (double& l : pairs.lambda) l = sum > 0 ? l / sum : 0.25;
}

// Points among which four may hold the origin where GJK's do not: a tie (the origin under an edge of a face, or
// under a diagonal) is not one from every side.
struct Candidates {
  std::array<CsoPoint<double>, 20> point;
  std::size_t size = 0;

  void add(const CsoPoint<double>& p) {
    for (std::size_t i = 0; i < size; ++i) {
      if (point[i].w == p.w) return;
    }
    if (size < point.size()) point[size++] = p;
  }
  // The first four that hold the ball of radius e about the origin.
  [[nodiscard]] bool hold(double e, Simplex<double>& out) const {
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = i + 1; j < size; ++j) {
        for (std::size_t k = j + 1; k < size; ++k) {
          for (std::size_t l = k + 1; l < size; ++l) {
            if (!(depth_inside({point[i].w, point[j].w, point[k].w, point[l].w}) > e)) continue;
            out.size = 0;
            for (const std::size_t m : {i, j, k, l}) out.add(point[m]);
            return true;
          }
        }
      }
    }
    return false;
  }
};

// n_hint: a normal at the contact. depth: how deep the origin is in C, about: on a curved C the points around it
// lie within sqrt(depth) of each other, so their directions differ by that.
inline Contact proved_contact(const MovingPair& pair, const Vec3<double>& n_hint, double depth, int budget,
                              Counters& counters) {
  Contact out;
  const Cso<double>& cso = pair.cso();
  const double e = contact_error(pair), R = pair.radius();
  const Vec3<double> zero = Vec3<double>::Zero();
  Simplex<double> simplex;
  const auto support = [&](const Vec3<double>& n) { return cso.support(n); };
  const Distance<double> d = gjk_distance(support, zero, Vec3<double>(-cso.middle()), simplex, 0.0,
                                          std::max(R - 2 * e, 0.0), budget, counters);
  out.pairs = simplex;
  out.proved = R > 0 && d.upper + e <= R;
  if (out.proved || d.lower - R > e) return out;
  if (simplex.size == 4) {
    const auto& p = simplex.point;
    out.proved = depth_inside({p[0].w, p[1].w, p[2].w, p[3].w}) > e;
  }
  // The cores themselves are too far apart for a tetrahedron.
  if (!out.proved && d.upper > std::max(depth, e)) return out;
  const Vec3<double> axis = n_hint == zero ? Vec3<double>(Vec3<double>::UnitZ()) : graze::unit(n_hint);
  const Frame<double> frame(axis);
  constexpr std::array<std::array<double, 2>, 5> kRing = {
      {{1, 0.125}, {0.1875, 1}, {-0.875, 0.5}, {-0.75, -0.6875}, {0.4375, -0.9375}}};
  for (const double tilt : {1.0, 0x1p-5, std::sqrt(depth)}) {
    if (out.proved) break;
    Candidates candidates;
    const auto look = [&](const Vec3<double>& n) {
      ++counters.supports;
      candidates.add(cso.support(n));
    };
    for (int i = 0; i < simplex.size; ++i) candidates.add(simplex.point[static_cast<std::size_t>(i)]);
    look(axis);
    look(-axis);
    for (const auto& [x, y] : kRing) look(axis + tilt * (x * frame.e1 + y * frame.e2));
    for (const auto& [x, y] : kRing) look(-axis + x * frame.e1 + y * frame.e2);
    out.proved = candidates.hold(e, out.pairs);
  }
  if (out.proved) weigh(out.pairs);
  return out;
}

}  // namespace graze::detail
