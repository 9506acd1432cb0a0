// The swept bounds of a body: linear in time, rounded outward.
//
// Own frame: the shape's core lies in the box of centre m and half extents e, and a ball of radius r is added
// (`core_box`). World, R = R(orientation), p = position:
//
//   linear     c = p + R m,        h_i = sum_j |R_ij| e_j + r
//   rotating   c = p + R pivot,    h_i = |points - pivot| + r at any angle,
//   or         the linear motion's c and h, with the rotation_displacement: no point gets farther from its position
//              in the linear motion than min(|w| t, 2) times its distance from the pivot.
//
// Rounding. Entries of R are within 9 u (offset.hpp) of theirs, |R_ij| <= 1. A component of R m has three products
// and two sums: within (9 + 3) u |m|_1. p + R m is within u (|p| + |m|_1) more. The same holds for h with e. A
// distance of two points within u of either's coordinates, a norm within 4 u of itself. All are below 16 u of L =
// |p|_1 + |m|_1 + |e|_1 + |pivot|_1 + r, of which 32 u are added to h. At the end c + v t: within 2 u (|c| + |v| t).
// A difference c - h rounds by u (|c| + h): 8 u of both are taken off. 2^-1000 stands for what underflows.
#include <graze/detail/rotating/mobility.hpp>

#include <graze/scene/swept_box.hpp>

namespace graze::scene {
namespace {

constexpr double kRoundoff = kUnitRoundoff<double>;  // u

struct CoreBox {
  Vec3<double> middle, half;
  double radius;
};

// Core's bounds round by one u of each number that they are made of. Core also returns how far a combinator's own
// points may lie beyond them.
CoreBox core_box(const Shape<double>& shape) {
  const detail::Bounds bounds = detail::bounds(shape);
  const Vec3<double> middle = bounds.center + bounds.middle;
  const Vec3<double> lost =
      8 * kRoundoff * (bounds.center.cwiseAbs() + bounds.middle.cwiseAbs() + bounds.half);
  const double beyond = detail::beyond_bounds(shape, bounds);
  return {middle, bounds.half + lost + Vec3<double>::Constant(beyond), bounds.radius};
}

SweptBox box_of(const Vec3<double>& c, const Vec3<double>& way, const Vec3<double>& h) {
  const Vec3<double> there = c + way;
  const Vec3<double> lost =
      8 * kRoundoff * (c.cwiseAbs() + way.cwiseAbs() + h) + Vec3<double>::Constant(0x1p-1000);
  return {c - h - lost, c + h + lost, there - h - lost, there + h + lost};
}

SweptBox sweep(const CoreBox& own, const Body<double>& body, const Turn& turn, double t_end, double around) {
  const bool turned = !body.orientation.is_identity();
  const Mat3<double> R =
      turned ? detail::rotation_matrix(body.orientation) : Mat3<double>(Mat3<double>::Identity());
  const Vec3<double> way = t_end * body.displacement;
  const double size = detail::norm_1(body.position) + detail::norm_1(own.middle) + detail::norm_1(own.half) +
                      detail::norm_1(turn.pivot) + own.radius;
  const double more = around + 32 * kRoundoff * size;
  const Vec3<double> c = body.position + R * own.middle;
  const Vec3<double> h =
      (R.cwiseAbs() * own.half + Vec3<double>::Constant(own.radius + more)) * (1 + 16 * kRoundoff);
  const double angle = detail::norm(turn.rotation) * t_end * (1 + 16 * kRoundoff);
  if (!(angle > 0)) return box_of(c, way, h);

  const double reach =
      detail::norm((own.middle - turn.pivot).cwiseAbs() + own.half) * (1 + 16 * kRoundoff) + more;
  const double rotation_displacement = std::min(angle, 2.0) * reach * (1 + 16 * kRoundoff);
  const double ball = (reach + own.radius) * (1 + 16 * kRoundoff);
  if (3 * ball <= detail::norm_1(h) + 3 * rotation_displacement) {
    const Vec3<double> pivot = body.position + R * turn.pivot;
    return box_of(pivot, way, Vec3<double>::Constant(ball));
  }
  return box_of(c, way, h + Vec3<double>::Constant(rotation_displacement));
}

}  // namespace

SweptBox swept_box(const Body<double>& body, const Turn& turn, double t_end, double around) {
  return sweep(core_box(body.shape), body, turn, t_end, around);
}

SweptBox contact_box(const Body<double>& body, const Turn& turn, double t_end, double target_distance) {
  const CoreBox own = core_box(body.shape);
  const double scale = detail::norm_1(body.position) + detail::norm_1(own.middle) +
                       2 * (detail::norm_1(own.half) + 3 * own.radius);
  return sweep(own, body, turn, t_end, target_distance / 2 * (1 + 0x1p-50) + 0x1p-36 * scale);
}

}  // namespace graze::scene
