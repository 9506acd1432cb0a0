// Finds the feature of up to four points closest to the origin: a vertex, an edge, a triangle, or all four around it.
// In doubles, quick rather than right: a wrong feature costs its user a step.
//
// Notation   y = a point.   n = a vector from the feature to the origin, of any length. It is -v, v being the closest
// point, or the normal of a triangle, which is known where v is noise.
// No weights and no roots are computed here. A caller that ends with a feature computes the weights then.
// [Ericson, Real-Time Collision Detection, 2005, 5.1]
#pragma once

#include <graze/detail/pairs/prepared_pair.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Points by their places in a list of four.
struct FastFeature {
  double dist_sq = kInfinity<double>;
  Triple n{0, 0, 0};
  std::uint32_t size = 0;
  std::array<std::uint8_t, 4> at{};
};

class FastSimplex {
 public:
  using Points = std::array<Triple, 4>;

  // The feature of the points at[0] .. at[size - 1], of which the last is the newest. Size 4: the origin is inside.
  [[gnu::noinline]] static void closest(const Points& y, const std::array<std::uint8_t, 4>& at,
                                        std::uint32_t size, FastFeature& out) {
    out.dist_sq = kInfinity<double>;
    out.size = 0;
    switch (size) {
      case 1:
        return vertex(y, at[0], out);
      case 2:
        return edge(y, at[0], at[1], out);
      case 3:
        return triangle(y, at[0], at[1], at[2], out);
      default:
        return tetrahedron(y, at, out);
    }
  }

  // v = sum lambda_i y_i, lambda >= 0 with sum 1, of the feature.
  static Triple weighted(const Points& y, const FastFeature& f, std::array<double, 4>& lambda) {
    lambda = {1, 0, 0, 0};
    const Triple& a = y[f.at[0]];
    if (f.size == 2) {
      const Triple ab = y[f.at[1]] - a;
      const double t = std::clamp(-dot(a, ab) / dot(ab, ab), 0.0, 1.0);
      lambda = {1 - t, t, 0, 0};
    } else if (f.size == 3) {
      const Triple &b = y[f.at[1]], &c = y[f.at[2]];
      const Triple m = cross(b - a, c - a);
      normalise(lambda, {dot(m, cross(b, c)), dot(m, cross(c, a)), dot(m, cross(a, b)), 0});
    } else if (f.size == 4) {
      const Triple &b = y[f.at[1]], &c = y[f.at[2]], &d = y[f.at[3]];
      const Triple da = a - d, db = b - d, dc = c - d;
      const double volume = dot(cross(db, dc), da), sign = volume < 0 ? -1 : 1;
      const double la = -sign * dot(cross(db, dc), d), lb = -sign * dot(cross(dc, da), d),
                   lc = -sign * dot(cross(da, db), d);
      normalise(lambda, {la, lb, lc, fl(sign * volume) - (la + lb + lc)});
    }
    Triple v{0, 0, 0};
    for (std::uint32_t i = 0; i < f.size; ++i) v = v + lambda[i] * y[f.at[i]];
    return v;
  }

 private:
  static void normalise(std::array<double, 4>& lambda, const std::array<double, 4>& size) {
    double all = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      lambda[i] = std::max(size[i], 0.0);
      all += lambda[i];
    }
    for (double& one : lambda) one /= all;
  }
  [[gnu::always_inline]] static void set(FastFeature& out, double dist_sq, double x, double y, double z) {
    out.dist_sq = dist_sq;
    out.n.x = x;
    out.n.y = y;
    out.n.z = z;
  }
  static void vertex(const Points& y, std::uint8_t a, FastFeature& out) {
    const double dist_sq = dot(y[a], y[a]);
    if (!(dist_sq < out.dist_sq)) return;
    set(out, dist_sq, -y[a].x, -y[a].y, -y[a].z);
    out.at[0] = a;
    out.size = 1;
  }
  static void edge(const Points& y, std::uint8_t a, std::uint8_t b, FastFeature& out) {
    const Triple ab = y[b] - y[a];
    const double along = -dot(y[a], ab), length_sq = dot(ab, ab);
    if (!(along > 0)) return vertex(y, a, out);
    if (!(along < length_sq)) return vertex(y, b, out);
    const double one = 1 / length_sq;
    // Once more: what the first subtraction left along the edge, which a long edge would make a tilted axis of.
    Triple v = y[a] + (along * one) * ab;
    v = v - (dot(v, ab) * one) * ab;
    const double dist_sq = dot(v, v);
    if (!(dist_sq < out.dist_sq)) return;
    set(out, dist_sq, -v.x, -v.y, -v.z);
    out.at[0] = a;
    out.at[1] = b;
    out.size = 2;
  }
  static void triangle(const Points& y, std::uint8_t a, std::uint8_t b, std::uint8_t c, FastFeature& out) {
    const Triple m = cross(y[b] - y[a], y[c] - y[a]);
    // The side of each edge, in the triangle's plane, on which the origin lies.
    const double la = dot(m, cross(y[b], y[c])), lb = dot(m, cross(y[c], y[a])),
                 lc = dot(m, cross(y[a], y[b]));
    if (la > 0 && lb > 0 && lc > 0) {
      const double height = dot(m, y[a]), dist_sq = height * height / dot(m, m);
      if (!(dist_sq < out.dist_sq)) return;
      const double sign = height > 0 ? -1 : 1;
      set(out, dist_sq, sign * m.x, sign * m.y, sign * m.z);
      out.at[0] = a;
      out.at[1] = b;
      out.at[2] = c;
      out.size = 3;
      return;
    }
    if (!(la > 0)) edge(y, b, c, out);
    if (!(lb > 0)) edge(y, c, a, out);
    if (!(lc > 0)) edge(y, a, b, out);
  }
  static void tetrahedron(const Points& y, const std::array<std::uint8_t, 4>& at, FastFeature& out) {
    // The faces at the newest corner d. The origin is beyond a face if the opposite corner is on the other side.
    const std::uint8_t a = at[0], b = at[1], c = at[2], d = at[3];
    const Triple da = y[a] - y[d], db = y[b] - y[d], dc = y[c] - y[d];
    const Triple bc = cross(db, dc), ca = cross(dc, da), ab = cross(da, db);
    const double volume = dot(bc, da), sign = volume < 0 ? -1 : 1;
    const double la = -sign * dot(bc, y[d]), lb = -sign * dot(ca, y[d]), lc = -sign * dot(ab, y[d]),
                 ld = fl(sign * volume) - (la + lb + lc);
    if (la > 0 && lb > 0 && lc > 0 && ld > 0) {
      out.dist_sq = 0;
      out.size = 4;
      out.at = at;
      return;
    }
    if (!(la > 0)) triangle(y, d, b, c, out);
    if (!(lb > 0)) triangle(y, d, c, a, out);
    if (!(lc > 0)) triangle(y, d, a, b, out);
    if (!(ld > 0)) triangle(y, a, b, c, out);
  }
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
