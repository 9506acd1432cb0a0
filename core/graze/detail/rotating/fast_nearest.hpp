// Computes the distance of two cores as placed. This is GJK with few operations, and it may give up.
//
// Notation   y_i = w_i, the simplex's points relative to the origin;   m = the normal of a triangle;
//            n = unit vector from the simplex to the origin;   v = the simplex's point closest to it.
//
// The results have the same bounds as those of gjk.hpp:
//   upper   the length of a convex combination of support points, as rounded
//   lower   -n.w of the support point w along a unit n: the pair's error() holds for any n
// The regions of a simplex are determined by signs in plain doubles, and only the feature that is kept gets a unit
// normal. If rounding becomes visible, it gives up, and gjk.hpp starts from the beginning. It gives up in four cases:
//   - No feature is closest.
//   - The closest feature is not nearer than the last one.
//   - A support was already known.
//   - A tetrahedron is too flat to have a sign or weights.
// [Ericson, Real-Time Collision Detection, 2005, 5.1]
#pragma once

#include <graze/detail/pairs/prepared_pair.hpp>
#include <graze/detail/search/robust/gjk.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

class FastClosest {
 public:
  explicit FastClosest(const Simplex<double>& simplex) : size_(simplex.size) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) y_[i] = triple(simplex.point[i].w);
    switch (size_) {
      case 1:
        vertex(0);
        break;
      case 2:
        edge(0, 1);
        break;
      case 3:
        triangle(0, 1, 2, cross(y_[1] - y_[0], y_[2] - y_[0]));
        break;
      default:
        tetrahedron();
    }
  }
  // Number of points of the closest feature. 0 if none is known, 4 if the origin is inside.
  [[nodiscard]] int size() const { return kept_; }
  [[nodiscard]] std::size_t index(int i) const { return index_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double lambda(int i) const { return lambda_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double dist_sq() const { return dist_sq_; }
  [[nodiscard]] const Triple& n() const { return n_; }  // of any length
  // Is |v| = `length` within the rounding of a sum of the points? For a tetrahedron with one corner far from the
  // other three the volume may have a sign and the weights hardly a correct digit. Its v is then far from the origin.
  [[nodiscard]] bool is_noise(double length) const {
    double longest_sq = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i)
      longest_sq = std::max(longest_sq, dot(y_[i], y_[i]));
    return length <= 32 * kUnitRoundoff<double> * square_root(longest_sq);
  }
  // |v| by its weights, from the first of its points.
  [[nodiscard]] double weighted() const {
    const Triple& first = y_[index_[0]];
    Triple v = first;
    for (std::size_t i = 1; i < static_cast<std::size_t>(kept_); ++i)
      v = v + lambda_[i] * (y_[index_[i]] - first);
    return square_root(dot(v, v));
  }

 private:
  void keep(double dist_sq, const Triple& n, std::initializer_list<std::size_t> index,
            std::initializer_list<double> lambda) {
    dist_sq_ = dist_sq;
    n_ = n;
    kept_ = static_cast<int>(index.size());
    std::copy(index.begin(), index.end(), index_.begin());
    std::copy(lambda.begin(), lambda.end(), lambda_.begin());
  }
  void vertex(std::size_t a) {
    const double dist_sq = dot(y_[a], y_[a]);
    if (dist_sq < dist_sq_) keep(dist_sq, -y_[a], {a}, {1});
  }
  void edge(std::size_t a, std::size_t b) {
    const Triple ab = y_[b] - y_[a];
    const double along = -dot(y_[a], ab), length_sq = dot(ab, ab);
    if (!(along > 0)) return vertex(a);
    if (!(along < length_sq)) return vertex(b);
    const double t = along / length_sq;
    // A second pass removes the remainder of the first subtraction along the edge. A long edge would make a tilted
    // axis of it.
    Triple v = y_[a] + t * ab;
    v = v - (dot(v, ab) / length_sq) * ab;
    const double dist_sq = dot(v, v);
    if (dist_sq < dist_sq_) keep(dist_sq, -v, {a, b}, {1 - t, t});
  }
  // m = (b - a) x (c - a).
  void triangle(std::size_t a, std::size_t b, std::size_t c, const Triple& m) {
    // The side of each edge, in the triangle's plane, on which the origin lies.
    const double la = dot(m, cross(y_[b], y_[c])), lb = dot(m, cross(y_[c], y_[a])),
                 lc = dot(m, cross(y_[a], y_[b]));
    if (la > 0 && lb > 0 && lc > 0) {
      const double height = dot(m, y_[a]), dist_sq = height * height / dot(m, m);
      if (!(dist_sq < dist_sq_)) return;
      const double one = 1 / (la + lb + lc);
      return keep(dist_sq, height > 0 ? -m : m, {a, b, c}, {la * one, lb * one, lc * one});
    }
    if (!(la > 0)) edge(b, c);
    if (!(lb > 0)) edge(c, a);
    if (!(lc > 0)) edge(a, b);
  }
  void tetrahedron() {
    // The faces from the newest. The origin is beyond a face if the corner opposite to it is on the other side.
    const Triple &a = y_[0], &b = y_[1], &c = y_[2], &d = y_[3];
    const Triple da = a - d, db = b - d, dc = c - d;
    const Triple bc = cross(db, dc), ca = cross(dc, da), ab = cross(da, db);
    const double volume = dot(bc, da), sign = volume < 0 ? -1 : 1;
    const double la = -sign * dot(bc, d), lb = -sign * dot(ca, d), lc = -sign * dot(ab, d),
                 ld = fl(sign * volume) - (la + lb + lc);
    if (la > 0 && lb > 0 && lc > 0 && ld > 0) {
      // As closest_inside() in search/robust/simplex.hpp.
      const double predicate_error =
          8 * kUnitRoundoff<double> * square_root(dot(da, da) * dot(db, db) * dot(dc, dc));
      if (!(sign * volume > predicate_error)) return;
      const double one = sign / volume;
      return keep(0, {0, 0, 0}, {0, 1, 2, 3}, {la * one, lb * one, lc * one, ld * one});
    }
    if (!(la > 0)) triangle(3, 1, 2, bc);
    if (!(lb > 0)) triangle(3, 2, 0, ca);
    if (!(lc > 0)) triangle(3, 0, 1, ab);
    if (!(ld > 0)) triangle(0, 1, 2, cross(b - a, c - a));
  }

  int size_, kept_ = 0;
  std::array<Triple, 4> y_;
  double dist_sq_ = kInfinity<double>;
  Triple n_{0, 0, 0};
  std::array<std::size_t, 4> index_{};
  std::array<double, 4> lambda_{};
};

// The accepted error of the distance, as a fraction of its excess over near_enough. The estimate of the time until
// contact needs no more: a slice that is a sixteenth shorter costs less than the steps to the last digit on smooth
// shapes.
inline constexpr double kNearestPart = 1.0 / 16;

// The distance of the origin from the core of a placed pair. The arguments are those of gjk_distance. False: it gave
// up, and the simplex is of no further use.
inline bool fast_distance(const Cso<double>& cso, Simplex<double>& simplex, double gap, double near_enough,
                          int budget, Distance<double>& out, Counters& counters) {
  constexpr int kSteps = 24;  // a longer search is not a common case
  if (simplex.size == 0) {
    simplex.add(cso.support(Vec3<double>(-cso.middle())));
    ++counters.supports;
  }
  double before = kInfinity<double>;
  for (int step = 0; step < kSteps; ++step) {
    const FastClosest closest(simplex);
    ++counters.gjk_iterations;
    const int size = closest.size();
    if (size == 0 || !(closest.dist_sq() < before)) return false;
    before = closest.dist_sq();
    // In place: the feature's points keep their order.
    std::array<double, 4> weight{};
    std::array<bool, 4> kept{};
    for (int i = 0; i < size; ++i) {
      weight[closest.index(i)] = closest.lambda(i);
      kept[closest.index(i)] = true;
    }
    std::size_t k = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!kept[i]) continue;
      if (k != i) simplex.point[k] = simplex.point[i];
      simplex.lambda[k++] = weight[i];
    }
    simplex.size = size;
    out.upper = closest.weighted();
    if (out.upper <= near_enough) return true;
    if (size == 4) return closest.is_noise(out.upper);
    const double length_sq = dot(closest.n(), closest.n());
    if (!(length_sq > 0x1p-400 && length_sq < 0x1p400) || budget-- <= 0) return false;
    const Vec3<double> n = (1 / square_root(length_sq)) * closest.n().vector();
    const CsoPoint<double> next = cso.support(n);
    ++counters.supports;
    const double lower = -dot(n, next.w);
    if (lower > out.lower) {
      out.lower = lower;
      out.n = n;
    }
    if (out.upper - out.lower <= std::max(gap, kNearestPart * (out.lower - near_enough))) return true;
    if (simplex.holds(next)) return false;
    simplex.add(next);
  }
  return false;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
