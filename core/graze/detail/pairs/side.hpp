// One body of a pair, prepared for the solvers: its core's support function in its own axes, and its bounds.
//
//   internal length = world length 2^-k (cso.hpp),   points about `center`, which the pair's offset takes in.
#pragma once

#include <graze/body.hpp>
#include <graze/detail/shapes/shape_tree.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Bounds of a shape's core in world lengths about its centre, in double, and the radius of its ball.
struct Bounds {
  Vec3<double> center = Vec3<double>::Zero(), half = Vec3<double>::Zero(), middle = Vec3<double>::Zero();
  double radius = 0;
};

// The centre is 0 but along axes where the offset exceeds the extent: subtracting it is exact (hull.hpp).
inline Bounds bounds_between(const Vec3<double>& low, const Vec3<double>& high) {
  Bounds out;
  for (int i = 0; i < 3; ++i) {
    const double middle = low[i] / 2 + high[i] / 2, half = high[i] / 2 - low[i] / 2;
    if (std::abs(middle) > 2.5 * half) out.center[i] = middle;
    out.half[i] = half;
    out.middle[i] = (low[i] - out.center[i]) + half;
  }
  return out;
}

template <Scalar S>
Vec3<double> wide(const Vec3<S>& x) {
  return x.template cast<double>();
}

template <Scalar S>
Bounds bounds(const Shape<S>& shape);

// Bounds of a combinator from its own support points, first about its origin, then about that centre.
// Rotations use two doubles, as parts that lie far out and are rotated back would otherwise err by 23 u of
// their distance.
template <Scalar S>
Bounds bounds_of_tree(const Shape<S>& shape) {
  const auto between = [&](const Vec3<double>& center, Vec3<double>& low, Vec3<double>& high) {
    const Placement at = Placement{Turning::accurate}.moved(-center);
    for (int i = 0; i < 3; ++i) {
      for (const double sign : {1.0, -1.0}) {
        const Vec3<double> n = sign * Vec3<double>::Unit(i);
        const TreePoint p = TreeWalk<S>(n)(shape, at);
        (sign > 0 ? high : low)[i] = p.x[i] + fl(sign * p.excess.hi);
      }
    }
  };
  Vec3<double> low, high;
  between(Vec3<double>::Zero(), low, high);
  Bounds out = bounds_between(low, high);
  if (out.center != Vec3<double>::Zero()) {
    between(out.center, low, high);
    out.half = (high - low) / 2;
    out.middle = low + out.half;
  }
  out.radius = common_radius(shape);
  return out;
}

template <Scalar S>
Bounds bounds(const Shape<S>& shape) {
  const auto about_zero = [](const Vec3<double>& half, double radius = 0) {
    Bounds out;
    out.half = half;
    out.radius = radius;
    return out;
  };
  return std::visit(
      Overloaded{
          [](const Point<S>&) { return Bounds{}; },
          [&](const Sphere<S>& s) { return about_zero(Vec3<double>::Zero(), s.radius); },
          [&](const Capsule<S>& s) {
            return about_zero({0, 0, double(s.half_height)}, s.radius);
          },
          [&](const Box<S>& s) { return about_zero(wide(s.half_extents)); },
          [&](const Ellipsoid<S>& s) { return about_zero(wide(s.radii)); },
          [&](const Cylinder<S>& s) { return about_zero(Vec3<double>(s.radius, s.radius, s.half_height)); },
          [&](const Cone<S>& s) { return about_zero(Vec3<double>(s.radius, s.radius, s.half_height)); },
          [](const Segment<S>& s) {
            return bounds_between(wide(s.a).cwiseMin(wide(s.b)), wide(s.a).cwiseMax(wide(s.b)));
          },
          [](const Triangle<S>& s) {
            return bounds_between(wide(s.a).cwiseMin(wide(s.b)).cwiseMin(wide(s.c)),
                                  wide(s.a).cwiseMax(wide(s.b)).cwiseMax(wide(s.c)));
          },
          [](const Hull<S>& s) {
            const double unit = power_of_two(s.exponent());
            Bounds out;
            out.center = wide(s.center());
            // In double: half extents that are rounded in float hold no vertex in double.
            const Vec3<double> low = wide(s.scan_low());
            out.half = unit * ((wide(s.scan_high()) - low) / 2);
            out.middle = unit * low + out.half;
            return out;
          },
          [&](const auto&) { return bounds_of_tree(shape); }},
      shape);
}

// A point of a core in the side's own axes about its centre, internal units, and the index of its vertex.
template <Scalar S>
struct SidePoint {
  Vec3<S> x;
  std::uint32_t vertex;
};

template <Scalar S>
struct Side {
  // Along a direction of any length. `chosen` selects a vertex instead of the greatest. The direction then
  // selects the point of a curved core.
  using Support = SidePoint<S> (*)(const Side&, const Vec3<S>& direction, const std::uint32_t* chosen);

  Support support = nullptr;
  const void* shape = nullptr;                               // Hull<Given>*, or Shape<Given>* of a combinator
  S unit = 1;                                                // internal length of one unit of a hull
  double tree_unit = 1;                                      // of a combinator: may be beyond the range of S
  Vec3<S> half = Vec3<S>::Zero(), middle = Vec3<S>::Zero();  // bounds, internal units, own axes
  S reach = 0;                                               // bounds |x| over the core
  // A segment's, triangle's or capsule's vertices.
  std::array<Vec3<S>, 3> few = {Vec3<S>::Zero(), Vec3<S>::Zero(), Vec3<S>::Zero()};
  Vec3<double> center = Vec3<double>::Zero();  // world length, own axes
  Mat3<S> rotation = Mat3<S>::Identity();
  bool rotated = false, curved = false;
  Turning turning = Turning::quick;
  S turn = 0;           // rotating x is within turn u |x| per component
  S point_error = 0;    // a point's own rounding, per component, internal units
  S support_error = 0;  // how far over |n| the chosen point may lie below the greatest, n being exact
  S radius = 0;

  [[nodiscard]] Vec3<S> to_own(const Vec3<S>& n) const {
    return rotated ? Vec3<S>(rotation.transpose() * n) : n;
  }
  [[nodiscard]] Vec3<S> to_world(const Vec3<S>& x) const { return rotated ? Vec3<S>(rotation * x) : x; }
  // Sets a rotation other than the given orientation. A point's rotation about itself has no effect.
  void turn_to(const Mat3<S>& r);
  // For a combinator with curved parts.
  [[nodiscard]] bool is_curved_tree() const { return curved && shape; }
};

template <Scalar S>
SidePoint<S> point_of_side(const Side<S>&, const Vec3<S>&, const std::uint32_t*) {
  return {Vec3<S>::Zero(), 0};
}
template <Scalar S, std::size_t N>
SidePoint<S> few_of_side(const Side<S>& side, const Vec3<S>& d, const std::uint32_t* chosen) {
  const std::uint32_t k =
      chosen ? *chosen : first_greatest<S>(std::span<const Vec3<S>>(side.few).first(N), d);
  return {side.few[k], k};
}
template <Scalar S>
SidePoint<S> box_of_side(const Side<S>& side, const Vec3<S>& d, const std::uint32_t* chosen) {
  const std::uint32_t k = chosen ? *chosen : box_support(d);
  return {box_vertex(side.half, k), k};
}
template <Scalar S>
SidePoint<S> ellipsoid_of_side(const Side<S>& side, const Vec3<S>& d, const std::uint32_t*) {
  return {ellipsoid_point(side.half, d), 0};
}
template <Scalar S>
SidePoint<S> cylinder_of_side(const Side<S>& side, const Vec3<S>& d, const std::uint32_t*) {
  return {cylinder_point(side.half[0], side.half[2], d), 0};
}
template <Scalar S>
SidePoint<S> cone_of_side(const Side<S>& side, const Vec3<S>& d, const std::uint32_t*) {
  return {cone_point(side.half[0], side.half[2], d), 0};
}
template <Scalar S, Scalar Given>
SidePoint<S> hull_of_side(const Side<S>& side, const Vec3<S>& d, const std::uint32_t* chosen) {
  const auto& hull = *static_cast<const Hull<Given>*>(side.shape);
  const std::uint32_t k = chosen ? *chosen : hull_support(hull, d);
  return {side.unit * hull_vertex<S>(hull, k), k};
}
// The direction of the support queries on a combinator's parts.
template <Scalar S>
Vec3<double> walked_along(const Vec3<S>& d) {
  const Vec3<double> x = wide(d);
  const double most = x.cwiseAbs().maxCoeff();
  if (!(most > 0)) return Vec3<double>::Zero();
  const Vec3<double> scaled_near_one = x / most;
  return scaled_near_one / square_root(height_along<double>(scaled_near_one, scaled_near_one[0],
                                                            scaled_near_one[1], scaled_near_one[2]));
}
template <Scalar S, Scalar Given>
SidePoint<S> tree_of_side(const Side<S>& side, const Vec3<S>& d, const std::uint32_t* chosen) {
  const auto& shape = *static_cast<const Shape<Given>*>(side.shape);
  const Vec3<double> n = walked_along(d);
  const TreePoint p = TreeWalk<Given>(n)(shape, Placement{side.turning}.moved(-side.center), chosen);
  return {(side.tree_unit * (p.x + (p.lo + p.excess.hi * n))).template cast<S>(), p.vertex};
}

// A bound in S. If it exceeds the range of S, it is the largest number of S that leaves room to add a few.
template <Scalar S>
S capped(double error) {
  return static_cast<S>(std::min(error, static_cast<double>(std::numeric_limits<S>::max()) / 64));
}

// How a side's core answers. Rounding of a curved leaf: leaf.hpp.
inline constexpr int kCurvedRounding = 6;

template <Scalar S, Scalar Given>
void set_core(Side<S>& side, const Shape<Given>& shape, int k) {
  const double unit = power_of_two(-k);
  const auto few = [&](std::initializer_list<Vec3<Given>> points) {
    std::size_t i = 0;
    for (const Vec3<Given>& x : points) {
      side.few[i++] = (unit * (wide(x) - side.center)).template cast<S>();
    }
  };
  const auto curved = [&](auto support) {
    side.support = support;
    side.curved = true;
    side.point_error = kCurvedRounding * kUnitRoundoff<S> * side.reach;
    side.support_error = 2 * side.point_error;
  };
  side.support_error = 8 * kUnitRoundoff<S> * side.reach;  // leaf.hpp
  std::visit(Overloaded{[&](const Point<Given>&) { side.support = &point_of_side<S>; },
                        [&](const Sphere<Given>&) { side.support = &point_of_side<S>; },
                        [&](const Segment<Given>& s) {
                          side.support = &few_of_side<S, 2>;
                          few({s.a, s.b});
                        },
                        [&](const Triangle<Given>& s) {
                          side.support = &few_of_side<S, 3>;
                          few({s.a, s.b, s.c});
                        },
                        [&](const Capsule<Given>&) {
                          side.support = &few_of_side<S, 2>;
                          side.few[0][2] = -side.half[2];
                          side.few[1][2] = side.half[2];
                        },
                        [&](const Box<Given>&) { side.support = &box_of_side<S>; },
                        [&](const Ellipsoid<Given>&) { curved(&ellipsoid_of_side<S>); },
                        [&](const Cylinder<Given>&) { curved(&cylinder_of_side<S>); },
                        [&](const Cone<Given>&) { curved(&cone_of_side<S>); },
                        [&](const Hull<Given>& hull) {
                          side.support = &hull_of_side<S, Given>;
                          side.shape = &hull;
                          // A hull of one point has the exponent 0, which says nothing: beside the least
                          // floats the unit would be infinite.
                          side.unit = hull.size_about_center() > 0
                                          ? static_cast<S>(power_of_two(hull.exponent() - k))
                                          : S(0);
                        },
                        [&](const auto&) {
                          side.support = &tree_of_side<S, Given>;
                          side.shape = &shape;
                          side.tree_unit = unit;
                          side.curved = is_curved(shape);
                          // Computed in double whatever S is, then rounded to S once.
                          const TreeRounding own = tree_rounding(shape, side.turning);
                          const double u = kUnitRoundoff<double> * unit;
                          const double fine =
                              unit * kTwoDoublesOfANode * nodes_of<Given>(shape) * lengths_of<Given>(shape);
                          side.point_error =
                              capped<S>(fl(u * own.point) + fine) + kUnitRoundoff<S> * side.reach;
                          side.support_error = capped<S>(fl(u * own.choice) + 2 * fine);
                        }},
             shape);
}

// Entries of R within 9 u, 0.6 u, and 11 u: what three rounded products of a row come to (cso.hpp).
inline constexpr int kFastTurn = 19, kAccurateTurn = 5, kPlacedTurn = 23;

template <Scalar S>
void Side<S>::turn_to(const Mat3<S>& r) {
  if (reach == 0) return;
  rotation = r;
  rotated = true;
  turn = kPlacedTurn;
}

template <Scalar S, Scalar Given>
Side<S> make_side(const Body<Given>& body, const Bounds& bounds, int k, Turning turning) {
  Side<S> side;
  const double unit = power_of_two(-k);
  side.turning = turning;
  side.center = bounds.center;
  side.half = (unit * bounds.half).template cast<S>();
  side.middle = (unit * bounds.middle).template cast<S>();
  side.reach = norm(side.half + side.middle.cwiseAbs());
  side.radius = static_cast<S>(unit * bounds.radius);
  set_core(side, body.shape, k);
  // The error of the pair's offset that comes from this centre.
  side.point_error += capped<S>(unit * kOffsetOfCenters * norm(bounds.center));
  // A point's rotation about itself, and so a sphere's, cannot be seen.
  const Vec3<double> off = bounds.half + bounds.middle.cwiseAbs() + bounds.center.cwiseAbs();
  side.rotated = !body.orientation.is_identity() && off.maxCoeff() > 0;
  if (side.rotated) {
    const Quaternion<double> turn = as_double(body.orientation);
    const bool accurate = turning == Turning::accurate;
    side.rotation = (accurate ? accurate_rotation_matrix(turn) : rotation_matrix(turn)).template cast<S>();
    side.turn = permutes_axes(turn) ? S(0) : static_cast<S>(accurate ? kAccurateTurn : kFastTurn);
  }
  return side;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
