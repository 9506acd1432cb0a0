// Notation: C = A - B grown by the target distance, h(n) its support, n unit. The gap along n is -h(n), and v(t) the
// vector from A's centre to B's. Internal lengths.
//
// An axis separates the bodies for the whole step in two cases. Let s_0 and s_1 be the gaps at the two ends, less the
// margin.
//   none rotates   The gap is linear in t: s_0 > 0 and s_1 > 0 prove all between.
//   one rotates    Every point stays within M t (T - t) / 2 of its chord along n, M <= |w| |n x w| rho of each body.
//                  So sqrt(s_0) + sqrt(s_1) > T sqrt(M / 2) proves all between (rotating/slice.hpp).
// An invisible rotation is not followed. With it, no point of the body, as a set, gets farther than its
// rotation_displacement from its position in the linear motion (mobility.hpp). So the linear motion's body grown by
// the rotation_displacement holds the body. A rotation of more than kMostAngle is not followed either if the
// rotation_displacement is less than the ball about the pivot. Otherwise that ball stands for the core.
//
// Contact is tested at t = 0 alone, whatever the rotation. Points w_i of C, each within e of where it is computed. If
// the computed ones' hull holds a ball of radius e + d about the origin, the true ones' holds one of radius d: h(n) falls by
// e at most. For a core with a ball of radius R about it: a convex combination v of the w_i with |v| <= R - e - d is as
// good.
//
// Rounding. Entries of R are within 9 u, those of the rotated one within (48 + 8 angle) u: the half angle within 2 u of
// itself, a product of quaternions, and 9 u. A point is three products of a row. A direction is rotated back at
// either of two vertices that are compared. These cost (288 + 48 angle) u of the core's size. Positions, ways and
// pivots are sums of at most six terms. All are below 512 u (1 + angle) of L, the sum of the lengths. The choice and
// the rounding of a side itself are its support_error and its point_error (side.hpp), taken four times for three
// coordinates and two points.
//
// The margin. A cast answers by the verdict if clearance and depth exceed the tier's width. This is
// kLinearCertifiedWidth of scale, for rotating bodies 1e-9 (kCertifiedTurningWidth), or the caller's tolerance.
// Standard methods answer within kappa u scale, below 2^-36 of it (swept_box.hpp). scale is at most the sum of the
// sizes and the distance.
#include "apart.hpp"

#include <graze/detail/rotating/mobility.hpp>
#include <graze/detail/rotating/turn.hpp>
#include <graze/detail/search/robust/gjk.hpp>

#include <algorithm>
#include <cmath>

namespace graze::scene {
namespace {

constexpr double u = kUnitRoundoff<double>;
constexpr double kUp = 1 + 0x1p-40;  // above what a few roundings leave
constexpr double kMostAngle = 1;     // radians of a step
constexpr double kUnseen =
    0x1p-36;                 // of a body's size: a rotation of less rotation_displacement is not followed
constexpr int kBudget = 24;  // supports of a search, beyond which the pair is cast

Vec3<double> zero() { return Vec3<double>::Zero(); }

}  // namespace

StepBody::StepBody(const RotatingBody<double>& moving, const StepLimits& limits) : w(moving.rotation) {
  const Body<double>& body = moving.body;
  const double unit = power_of_two(-limits.exponent);
  const detail::Bounds bounds = detail::bounds(body.shape);
  side = detail::make_side<double>(body, bounds, limits.exponent, detail::Turning::quick);
  const Vec3<double> middle = bounds.center + bounds.middle;
  const Vec3<double> arm = bounds.center - moving.pivot, position = unit * body.position,
                     way = unit * limits.t_end * body.displacement;
  rate = detail::norm(w) * kUp;
  radius = side.radius;
  const double core = detail::norm(bounds.half) + detail::beyond_bounds(body.shape, bounds);
  rho = unit * (detail::norm(middle - moving.pivot) + core) * kUp;
  size = 2 * (unit * core + 2 * radius) * kUp;
  const double angle = rate * limits.t_end;
  turns = angle > 0;

  rotation[0] = detail::rotation_matrix(body.orientation);
  rotation[1] = rotation[0];
  start = position + unit * (rotation[0] * bounds.center);
  center = {start, start + way};
  swept = radius;
  if (turns) {
    const Mat3<double> accurate = detail::accurate_rotation_matrix(body.orientation);
    const detail::Bounds own = detail::bounds(detail::unwrapped<double>(body.shape));
    const double rotation_displacement =
        detail::mobility(moving, moving.pivot, own, unit, accurate).rotation_displacement(limits.t_end) * kUp;
    const bool follows = angle <= kMostAngle;
    if (rotation_displacement <= (follows ? kUnseen * size : rho)) {
      swept += rotation_displacement;
      turns = false;
    } else if (!follows) {
      center[0] = position + unit * (rotation[0] * moving.pivot);
      center[1] = center[0] + way;
      swept += rho;
      turns = false;
      is_ball = true;
    } else {
      const detail::TurnsAbout about(w);
      rotation[1] = detail::TurnedRotation(about, body.orientation).at(about, limits.t_end);
      center[1] += unit * (rotation[1] * arm - rotation[0] * arm);
    }
  }
  const double lengths = detail::norm_1(position) + detail::norm_1(way) + rho + radius +
                         unit * (detail::norm_1(bounds.center) + detail::norm_1(moving.pivot) +
                                 detail::norm_1(bounds.middle) + core);
  error = 512 * u * (1 + (turns ? angle : 0.0)) * lengths + 4 * (side.support_error + side.point_error);
}

StepPair::StepPair(const StepBody& a, const StepBody& b, const StepLimits& limits, Counters& counters)
    : a_(a), b_(b), side_a_(a.side), side_b_(b.side), limits_(limits), counters_(counters) {
  for (const std::size_t end : {0u, 1u}) apart_[end] = b.center[end] - a.center[end];
  start_ = b.start - a.start;
  const double target = limits.target_distance * power_of_two(-limits.exponent);
  radius_ = (a.radius + b.radius + target) * kUp;
  swept_ = (a.swept + b.swept + target) * kUp;
  error_ = a.error + b.error;
  const double scale = a.size + b.size + target + detail::norm_1(start_);
  const bool turns = a.rate > 0 || b.rate > 0;
  margin_ = ((turns ? 2e-9 : 0x1p-36) + limits.tolerance) * scale + error_;
}

StepPair::Ends StepPair::support(const Vec3<double>& n, bool both) {
  ++counters_.supports;
  Ends out;
  const auto point = [&](const StepBody& body, const detail::Side<double>& side, const Vec3<double>& d,
                         std::size_t end, std::uint32_t& vertex) -> Vec3<double> {
    if (both && body.is_ball) return zero();
    const detail::SidePoint<double> p = side.support(side, body.rotation[end].transpose() * d, nullptr);
    vertex = p.vertex;
    return body.rotation[end] * p.x;
  };
  const Vec3<double> a = point(a_, side_a_, n, 0, out.vertex_a), b = point(b_, side_b_, -n, 0, out.vertex_b);
  out.w[0] = a - b - (both ? apart_[0] : start_);
  if (!both) return out;
  std::uint32_t unnamed = 0;
  const Vec3<double> a_end = a_.turns ? point(a_, side_a_, n, 1, unnamed) : a,
                     b_end = b_.turns ? point(b_, side_b_, -n, 1, unnamed) : b;
  out.w[1] = a_end - b_end - apart_[1];
  return out;
}

bool StepPair::is_parted_by(const Vec3<double>& n) {
  const Ends ends = support(n, true);
  const double lost = swept_ + error_ + margin_;
  const double s_0 = -detail::dot(n, ends.w[0]) - lost, s_1 = -detail::dot(n, ends.w[1]) - lost;
  if (!(s_0 > 0 && s_1 > 0)) return false;
  double bend = 0;
  for (const StepBody* body : {&a_, &b_}) {
    if (body->turns) bend += body->rate * detail::length_of_cross(n, body->w) * body->rho;
  }
  return (detail::square_root(s_0) + detail::square_root(s_1)) * (1 - 0x1p-20) >
         limits_.t_end * detail::square_root(bend / 2);
}

// The axis of C at both ends, taken as one: GJK.
Vec3<double> StepPair::find_axis(const Vec3<double>& hint) {
  const auto farther = [&](const Vec3<double>& n) {
    const Ends ends = support(n, true);
    const bool is_end = detail::dot(n, ends.w[1]) > detail::dot(n, ends.w[0]);
    detail::CsoPoint<double> p;
    p.w = ends.w[is_end ? 1 : 0];
    p.vertex_a = ends.vertex_a;
    p.vertex_b = ends.vertex_b;
    p.e = is_end ? Vec3<double>(Vec3<double>::UnitX()) : zero();
    p.n = n;
    return p;
  };
  detail::Simplex<double> simplex;
  const Vec3<double> start = hint != zero() ? hint : Vec3<double>((apart_[0] + apart_[1]) / 2);
  const Vec3<double> n = detail::gjk_distance(farther, zero(), start, simplex, 0x1p-10 * (a_.size + b_.size),
                                              swept_ + margin_, kBudget, counters_)
                             .n;
  return n != zero() && is_parted_by(n) ? n : zero();
}

bool StepPair::holds_origin(const std::array<Vec3<double>, 4>& w, int size) const {
  const double most = 2 * error_ + margin_;  // what a point may be off, and the depth
  detail::Simplex<double> simplex;
  double longest = 0;
  for (int i = 0; i < size; ++i) {
    detail::CsoPoint<double> p;
    p.w = w[static_cast<std::size_t>(i)];
    simplex.add(p);
    longest = std::max(longest, detail::norm_1(p.w));
  }
  if (radius_ > 0) {
    const detail::Closest<double> closest = detail::closest_to_origin(simplex, zero());
    if (detail::norm(closest.v) * kUp + 16 * u * longest + most <= radius_ * (1 - 0x1p-38)) return true;
  }
  if (size != 4) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3<double>&p = w[i], &q = w[(i + 1) % 4], &r = w[(i + 2) % 4], &opposite = w[(i + 3) % 4];
    const Vec3<double> m = detail::cross(q - p, r - p);
    // The height of the origin over the face, times |m|. Products of three lengths round by 64 u of their cube.
    const double height = -detail::dot(m, p),
                 lost = most * detail::norm(m) * kUp + 64 * u * longest * longest * longest;
    const double altitude = detail::dot(m, opposite - p);
    if (!(altitude > 0 ? altitude > lost && height > lost : altitude < -lost && height < -lost)) return false;
  }
  return true;
}

bool StepPair::is_held_by(const Touching& features) {
  std::array<Vec3<double>, 4> w;
  for (int i = 0; i < features.size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    w[k] = support(features.direction[k], false).w[0];
  }
  return holds_origin(w, features.size);
}

std::optional<Touching> StepPair::find_touching() {
  const auto at_start = [&](const Vec3<double>& n) {
    const Ends ends = support(n, false);
    detail::CsoPoint<double> p;
    p.w = ends.w[0];
    p.n = n;
    p.vertex_a = ends.vertex_a;
    p.vertex_b = ends.vertex_b;
    return p;
  };
  detail::Simplex<double> simplex;
  detail::gjk_distance(at_start, zero(), start_, simplex, 0.0, radius_ / 2, kBudget, counters_);
  Touching out;
  out.size = simplex.size;
  std::array<Vec3<double>, 4> w;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.size); ++i) {
    out.direction[i] = simplex.point[i].n;
    w[i] = simplex.point[i].w;
  }
  if (!holds_origin(w, out.size)) return {};
  return out;
}

}  // namespace graze::scene
