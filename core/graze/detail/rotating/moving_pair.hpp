// Represents two rotating bodies as a CSO that can be placed at any time.
//
// Frame: world axes, origin on the path of A's pivot, c_A + v_A t. Internal units of cso.hpp (world lengths
// times 2^-k, k that of t = 0). The arms are r_X = R(orientation)(center - pivot) at t = 0, and R_X(t) are the
// bodies' rotations. Then
//   offset(t) = (c_B - c_A) + (v_B - v_A) t + R_B(t) r_B - R_A(t) r_A,
// summed in two doubles and rounded once. Large common positions and arms of many sizes cost no accuracy.
// cso.hpp bounds the rounding of the CSO's results. `error()` is the total.
//
// The relative speed of points is bounded by the sum of both bodies' speeds. If both bodies rotate by exactly
// one w, the common part cancels: x_B - x_A = (c_B - c_A) + v t + R(t) (r_B - r_A + y_B - y_A), y from the
// centres. Let `common_rho` be the largest distance of r_B - r_A + y_B - y_A from the axis. Then
//   |d/dt n.(x_B - x_A - v t)| <= |n x w| common_rho,     |d^2/dt^2 n.(x_B - x_A)| <= |w| |n x w| common_rho.
// Bodies on equal arms about different pivots do not move relative to each other, however long the arms.
#pragma once

#include <graze/detail/pairs/cso.hpp>
#include <graze/detail/rotating/mobility.hpp>
#include <graze/detail/rotating/turn.hpp>
#include <graze/result.hpp>
#include <graze/rotating_proof.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// One body's rotation and arm at any time.
struct TurningSide {
  TurnsAbout turns{Vec3<double>::Zero()};
  Quaternion<double> start;  // scaled by a power of two, so that its components are near 1
  Mat3<double> start_rotation = Mat3<double>::Identity();
  TurnedRotation rotation;                    // of a rotating body
  Vec3<double> pivot = Vec3<double>::Zero();  // own frame, world lengths
  TwoDoubles3 arm{};                          // internal units
  bool has_arm = false;
  Mobility mobility;
  double swing = 0;            // |w x (c_B - c_A)| at t = 0
  double across_velocity = 0;  // |w x v|
  // The body as given, and reach_at_all_angles() of its scalar.
  const void* given = nullptr;
  double (*reach)(const TurningSide& side, double unit, const Vec3<double>& n) = nullptr;

  struct Placed {
    Mat3<double> rotation = Mat3<double>::Identity();
    TwoDoubles3 arm{};
  };
  [[nodiscard]] Placed at(double t) const {
    if (!turns.turns() || t == 0) return {start_rotation, arm};
    return {rotation.at(turns, t), has_arm ? turns.at(t)(arm) : arm};
  }
};

template <Scalar S>
Quaternion<double> scaled_near_one(const Quaternion<S>& given) {
  const Quaternion<double> q = as_double(given);
  const double most = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  const double factor = power_of_two(-exponent_of(most));
  return {q.w * factor, q.x * factor, q.y * factor, q.z * factor};
}

// R(orientation) x, within 2^-98.
inline TwoDoubles3 posed(const Quaternion<double>& q, const Vec3<double>& x) {
  return q.is_identity() || x == Vec3<double>::Zero() ? exactly(x) : rotate_accurately(q, x);
}

// Valid while the bodies live. The bodies must have passed validation. Placing is cheap compared with a closest-point
// search.
class MovingPair {
 public:
  template <Scalar S>
  MovingPair(const RotatingBody<S>& a, const RotatingBody<S>& b, double target_distance)
      : cso_(a.body, b.body, static_cast<S>(0)) {
    const double unit = power_of_two(-cso_.length_exponent());
    target_ = target_distance * unit;
    radius_ = cso_.radius() + target_;
    prepare(a, cso_.side_a(), unit, a_);
    prepare(b, cso_.side_b(), unit, b_);
    start_lengths_ = unit * (lengths_of(a, cso_.side_a()) + lengths_of(b, cso_.side_b()));
    lengths_ = start_lengths_ + fl(unit * (norm(a_.pivot) + norm(b_.pivot)));
    pivots_ = scaled_by(start_of_pivot(b, b_) + -start_of_pivot(a, a_), unit);
    a_.swing = pivot_drift(a_.mobility);
    b_.swing = pivot_drift(b_.mobility);
    if (a_.turns.turns() && a_.mobility.w == b_.mobility.w) common_rho_ = distance_in_common_turn();
    start_offset_ = cso_.offset();
    for (std::size_t i = 0; i < 3; ++i) {
      const int k = static_cast<int>(i);
      const TwoDoubles v = two_sum(double(b.body.displacement[k]), -double(a.body.displacement[k]));
      velocity_[i] = {v.hi * unit, v.lo * unit};
    }
    speed_ = norm(velocity());
    a_.across_velocity = a_.mobility.across(velocity());
    b_.across_velocity = b_.mobility.across(velocity());
    place(0);
  }

  void place(double t) {
    GRAZE_ASSERT(t >= 0 && t < kInfinity<double>);
    // A slice queries its two ends alternately.
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      if (placed_[i].t == t) return stand(i);
    }
    oldest_ = (oldest_ + 1) % placed_.size();
    compute(t, placed_[oldest_]);
    ++poses_;
    stand(oldest_);
    placed_[oldest_].error =
        cso_.reach_error() + 8 * kUnitRoundoff<double> * (radius_ + norm(cso_.offset())) + offset_error();
  }

  [[nodiscard]] double time() const { return t_; }
  [[nodiscard]] const Cso<double>& cso() const { return cso_; }
  [[nodiscard]] double radius() const { return radius_; }  // both cores' balls and the target distance
  [[nodiscard]] double scale() const { return cso_.scale(); }
  [[nodiscard]] double target() const { return target_; }
  [[nodiscard]] int poses() const { return poses_; }  // number of computed poses
  [[nodiscard]] const Mobility& mobility_a() const { return a_.mobility; }
  [[nodiscard]] const Mobility& mobility_b() const { return b_.mobility; }
  [[nodiscard]] Vec3<double> velocity() const { return rounded_once(velocity_); }
  // c_B - c_A at t = 0, within u of itself and pivots_error(): the remainder if distant pivots cancel.
  [[nodiscard]] Vec3<double> pivots() const { return rounded_once(pivots_); }
  [[nodiscard]] double pivots_error() const { return 0x1p-96 * lengths_; }
  // Own frame, world lengths: the given centre of rotation, or a point of a body that does not rotate.
  [[nodiscard]] const Vec3<double>& pivot_a() const { return a_.pivot; }
  // |w x (c_B - c_A)| over |w|, raised by the rounding error of the two doubles that hold it.
  [[nodiscard]] double pivot_drift(const Mobility& body) const {
    if (!body.turns()) return 0;
    Vec3<double> product;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const double w_j = body.w[static_cast<int>(j)], w_k = body.w[static_cast<int>(k)];
      product[static_cast<int>(i)] =
          (pivots_[j] * TwoDoubles{w_k, 0} + -(pivots_[k] * TwoDoubles{w_j, 0})).hi;
    }
    return fl(scaled_norm(product) * (1 + 16 * kUnitRoundoff<double>)) + fl(body.rate * drift_lost());
  }
  [[nodiscard]] double drift_lost() const { return pivots_error() + 0x1p-96 * norm(pivots()); }
  // Vectors from A's pivot to the centres of the sides (cso.hpp) as placed.
  [[nodiscard]] Vec3<double> center_a() const { return rounded_once(now().arm_a); }
  [[nodiscard]] Vec3<double> center_b() const { return rounded_once(now().arm_b); }
  // Not rounded: far from the pivot, the distance of a point from its centre is about the body's size.
  [[nodiscard]] const TwoDoubles3& center_a_in_two() const { return now().arm_a; }
  [[nodiscard]] const TwoDoubles3& center_b_in_two() const { return now().arm_b; }
  // The vector from A's pivot to B's pivot.
  [[nodiscard]] const Vec3<double>& pivot_b_now() const { return now().pivot_b; }

  // An error bound of the gap along any unit axis.
  [[nodiscard]] double error() const { return now().error; }
  // Error bound of the offset, which is a difference of lengths that cancel. Rotated arms are within turn_error of
  // their lengths (turn.hpp), posed arms within 2^-98, and translations within 2^-100. At the start no arm counts.
  [[nodiscard]] double offset_error() const {
    if (t_ == 0) return 0x1p-96 * start_lengths_;
    const double angle = std::max(a_.mobility.rate, b_.mobility.rate) * t_;
    return fl(2 * turn_error(angle) * lengths_) + fl(0x1p-89 * speed_ * t_);
  }
  // A lower bound of min over B of n.b - max over A of n.a, less the target distance, n unit.
  [[nodiscard]] double gap(const Vec3<double>& n, Counters& counters) const {
    ++counters.supports;
    return gap_of(cso_.support(n).w, n);
  }
  // The gap of one point of C.
  [[nodiscard]] double gap_of(const Vec3<double>& w, const Vec3<double>& n) const {
    return -dot(n, w) - radius_ - error();
  }
  // Upper bound of the rate at which the gap along a fixed n shrinks, per unit of t.
  [[nodiscard]] double closing(const Vec3<double>& n) const {
    const Vec3<double> v = velocity();
    const double each = a_.mobility.speed(n) + b_.mobility.speed(n);
    return (turns_in_common() ? std::min(each, a_.mobility.across(n) * common_rho_) : each) - dot(n, v) +
           8 * kUnitRoundoff<double> * norm_1(v);
  }
  // Converts an axis that rotates with a body (frame a or b) from the body's own axes to the world as placed, and
  // back. Each conversion is within 24 u.
  [[nodiscard]] Vec3<double> to_world(AxisFrame frame, const Vec3<double>& n) const {
    return frame == AxisFrame::world
               ? n
               : Vec3<double>((frame == AxisFrame::a ? now().rotation_a : now().rotation_b) * n);
  }
  [[nodiscard]] Vec3<double> to_own(AxisFrame frame, const Vec3<double>& n) const {
    return frame == AxisFrame::world
               ? n
               : Vec3<double>((frame == AxisFrame::a ? now().rotation_a : now().rotation_b).transpose() * n);
  }
  // The most that a rotating body's core reaches from its pivot along n in [t_0, t_1]: by a whole turn, or the profile
  // of a solid of revolution. Leaves the bodies at t_1.
  [[nodiscard]] double reach(AxisFrame body, const Vec3<double>& n, double t_0, double t_1) {
    const TurningSide& side = body == AxisFrame::a ? a_ : b_;
    const Profile& profile = side.mobility.profile;
    if (profile.size == 0) return side.reach(side, power_of_two(-cso_.length_exponent()), n);
    const auto axis_at = [&](double t) {
      place(t);
      return Vec3<double>((body == AxisFrame::a ? now().rotation_a : now().rotation_b).col(profile.axis));
    };
    const Vec3<double> a_0 = axis_at(t_0);
    return side.mobility.profile_reach(n, a_0, axis_at(t_1), t_1 - t_0);
  }
  // The axis in world axes at t = 0.
  [[nodiscard]] Vec3<double> to_start(AxisFrame frame, const Vec3<double>& own) const {
    return frame == AxisFrame::world ? own
                                     : Vec3<double>((frame == AxisFrame::a ? a_ : b_).start_rotation * own);
  }
  // Error bound of the gap along a rotated axis, from that rounding.
  [[nodiscard]] double frame_error(AxisFrame frame) const {
    return frame == AxisFrame::world ? 0.0 : 64 * kUnitRoundoff<double> * (cso_.extent() + radius_);
  }
  // As bend(), for an axis that rotates with a body, n in its current direction, within 64 u (to_world, to_own
  // and to_start), for times up to t_end. Seen from A, positions are taken from the path of its pivot, in its
  // axes: x = R_A^T (R_B p + c + v t). A's points are at rest, and
  //   |n.x''| <= |w_B - w_A| (|w_A| + |w_B|) |p| + |w_A x n| (2 |v| + |w_A x c| + |w_A x v| t),
  // since, with d = w_B - w_A,
  //   (R_A^T R_B)'' = R_A^T ([d][w_B] - [w_A][d]) R_B,
  //   (R_A^T y)''   = R_A^T (y'' - 2 w_A x y' + w_A x (w_A x y)).
  [[nodiscard]] double bend(AxisFrame frame, const Vec3<double>& n, double t_end) const {
    if (frame == AxisFrame::world) return bend(n);
    return bend_of(frame, (frame == AxisFrame::a ? a_ : b_).mobility.across(n), t_end);
  }
  // The bends in the frames world, a and b.
  [[nodiscard]] std::array<double, 3> bends(const Vec3<double>& n, double t_end) const {
    const double across_a = a_.mobility.across(n), across_b = b_.mobility.across(n);
    return {bend_of_world(across_a, across_b), bend_of(AxisFrame::a, across_a, t_end),
            bend_of(AxisFrame::b, across_b, t_end)};
  }
  // As bend(), for an axis that moves evenly in the frame's axes, from n_0 in the world at t_0 to n_1 at t_1. In
  // between, its length is at most 1, and |n x w| is at most its value at an end. The second derivative of n.x gains
  // 2 n'.x'. Leaves the bodies at t_1.
  [[nodiscard]] double bend_between(AxisFrame frame, const Vec3<double>& n_0, double t_0,
                                    const Vec3<double>& n_1, double t_1, double t_end) {
    const auto across = [&](const Mobility& m) { return std::max(m.across(n_0), m.across(n_1)); };
    const double axis_rate = axis_change(frame, n_0, t_0, n_1, t_1) / (t_1 - t_0);
    const double raise = 1 + 64 * kUnitRoundoff<double>;
    if (frame == AxisFrame::world)
      return (bend_of_world(across(a_.mobility), across(b_.mobility), axis_rate) +
              fl(2 * axis_rate * norm(velocity()))) *
             raise;
    return (bend_of(frame, across((frame == AxisFrame::a ? a_ : b_).mobility), t_end) +
            fl(2 * axis_rate * relative_speed(frame, t_end))) *
           raise;
  }
  // Returns |m_1 - m_0|, where m_i is n_i as above in the frame's axes. Leaves the bodies at t_1.
  [[nodiscard]] double axis_change(AxisFrame frame, const Vec3<double>& n_0, double t_0,
                                   const Vec3<double>& n_1, double t_1) {
    if (frame == AxisFrame::world) return norm(n_1 - n_0) * (1 + 8 * kUnitRoundoff<double>);
    place(t_0);
    const Vec3<double> m_0 = to_own(frame, n_0);
    place(t_1);
    return norm(to_own(frame, n_1) - m_0) + 64 * kUnitRoundoff<double>;
  }
  // Upper bound of the speed of one body's points as seen in the axes of the other, from the path of its pivot, for
  // times up to t_end. For x above, |x'| <= |w_B - w_A| |p| + |v| + |w_A x c| + |w_A x v| t. The distance of the
  // bodies is the same in all axes, so it changes no faster, however fast both rotate as one.
  [[nodiscard]] double relative_speed(AxisFrame frame, double t_end) const {
    const Mobility &with = frame == AxisFrame::a ? a_.mobility : b_.mobility,
                   &other = frame == AxisFrame::a ? b_.mobility : a_.mobility;
    const Vec3<double> v = velocity();
    return (fl(norm(other.w - with.w) * other.reach) + norm(v) + drift_until(frame, t_end)) *
           (1 + 64 * kUnitRoundoff<double>);
  }
  [[nodiscard]] double approach_speed(double t_end) const {
    return std::min({top_speed(), relative_speed(AxisFrame::a, t_end), relative_speed(AxisFrame::b, t_end)});
  }
  // Each point's distance along n deviates from its chord by at most this, times (t - t_0)(t_1 - t)/2.
  [[nodiscard]] double bend(const Vec3<double>& n) const {
    return bend_of_world(a_.mobility.across(n), b_.mobility.across(n));
  }
  // The same for any n.
  [[nodiscard]] double top_bend() const {
    const double each = a_.mobility.top_acceleration() + b_.mobility.top_acceleration();
    return turns_in_common() ? std::min(each, a_.mobility.rate * a_.mobility.rate * common_rho_) : each;
  }
  // Largest speed of any point of one body seen from any point of the other.
  [[nodiscard]] double top_speed() const {
    const double each = a_.mobility.top_speed() + b_.mobility.top_speed();
    return (turns_in_common() ? std::min(each, a_.mobility.rate * common_rho_) : each) +
           fl(norm(velocity()) * (1 + 8 * kUnitRoundoff<double>));
  }

 private:
  // The positions of both bodies at one time.
  struct Stand {
    double t = std::numeric_limits<double>::quiet_NaN();
    Mat3<double> rotation_a, rotation_b;
    TwoDoubles3 arm_a, arm_b;
    Vec3<double> pivot_b, offset;
    double error;
  };
  void compute(double t, Stand& out) const {
    TwoDoubles3 d = pivots_;
    if (t > 0x1p500) {
      for (std::size_t i = 0; i < 3; ++i) d[i] = d[i] + times(velocity_[i], t);
    } else if (t != 0) {
      // In pairs that are not normalised (pair.hpp), within 2^-100 of the pivots' distance and 2^-96 of the
      // translation.
      for (std::size_t i = 0; i < 3; ++i) {
        const exact::Pair way = exact::Pair{velocity_[i].hi, velocity_[i].lo} * exact::Pair{t, 0};
        const exact::Pair sum = exact::Pair{d[i].hi, d[i].lo} + way;
        d[i] = two_sum(sum.hi, sum.lo);
      }
    }
    const TurningSide::Placed a = a_.at(t), b = b_.at(t);
    out.t = t;
    out.rotation_a = a.rotation;
    out.rotation_b = b.rotation;
    out.arm_a = a.arm;
    out.arm_b = b_.has_arm ? d + b.arm : d;
    out.pivot_b = rounded_once(d);
    out.offset = t == 0       ? start_offset_
                 : a_.has_arm ? rounded_once(out.arm_b + -a.arm)
                              : rounded_once(out.arm_b);
  }
  void stand(std::size_t i) {
    at_ = i;
    const Stand& now = placed_[i];
    t_ = now.t;
    cso_.place(a_.turns.turns() ? &now.rotation_a : nullptr, b_.turns.turns() ? &now.rotation_b : nullptr,
               now.offset);
  }
  [[nodiscard]] const Stand& now() const { return placed_[at_]; }
  // The term |w_A x c| + |w_A x v| t of the bound above.
  [[nodiscard]] double drift_until(AxisFrame frame, double t_end) const {
    const TurningSide& with = frame == AxisFrame::a ? a_ : b_;
    return with.swing + fl(with.across_velocity * t_end);
  }
  // The bound above for both bodies, with |n x w| of the frame's body given.
  [[nodiscard]] double bend_of(AxisFrame frame, double across_n, double t_end) const {
    const Mobility &with = frame == AxisFrame::a ? a_.mobility : b_.mobility,
                   &other = frame == AxisFrame::a ? b_.mobility : a_.mobility;
    const double across = across_n + 64 * kUnitRoundoff<double> * with.rate;
    return (fl(norm(other.w - with.w) * (with.rate + other.rate) * other.reach) +
            fl(across * (2 * norm(velocity()) + drift_until(frame, t_end)))) *
           (1 + 64 * kUnitRoundoff<double>);
  }
  [[nodiscard]] double bend_of_world(double across_a, double across_b, double axis_rate = 0) const {
    const double each =
        a_.mobility.acceleration_for(across_a, axis_rate) + b_.mobility.acceleration_for(across_b, axis_rate);
    return turns_in_common() ? std::min(each, a_.mobility.rate * (across_a + 2 * axis_rate) * common_rho_)
                             : each;
  }
  [[nodiscard]] bool turns_in_common() const { return common_rho_ < kInfinity<double>; }
  // See above. Raised by its own rounding error and by the error of the points.
  [[nodiscard]] double distance_in_common_turn() const {
    const Vec3<double> arms = rounded_once(b_.arm + -a_.arm), axis = unit(a_.mobility.w);
    const double about = cso_.side_a().reach + cso_.side_b().reach;
    return fl((norm(cross(axis, arms)) + about + 8 * cso_.point_error()) * (1 + 0x1p-44)) +
           32 * kUnitRoundoff<double> * norm(arms) + 0x1p-96 * lengths_;
  }
  // The sum of the lengths that give the body's position, without its pivot.
  template <Scalar S>
  static double lengths_of(const RotatingBody<S>& given, const Side<double>& side) {
    return norm(wide(given.body.position)) + norm(side.center);
  }
  template <Scalar S>
  static TwoDoubles3 start_of_pivot(const RotatingBody<S>& given, const TurningSide& side) {
    return exactly(wide(given.body.position)) + posed(side.start, side.pivot);
  }
  template <Scalar S>
  static void prepare(const RotatingBody<S>& given, const Side<double>& side, double unit, TurningSide& out) {
    out.turns = TurnsAbout(wide(given.rotation));
    out.start = scaled_near_one(given.body.orientation);
    if (out.turns.turns()) {
      out.rotation = TurnedRotation(out.turns, out.start);
      out.start_rotation = out.rotation.start();
    } else {
      out.start_rotation = rotation_matrix(out.start);
    }
    const Bounds bounds = detail::bounds(unwrapped<S>(given.body.shape));
    // For a body that does not rotate, any point serves. The middle of its bounds is the tightest.
    out.pivot = out.turns.turns() ? wide(given.pivot) : Vec3<double>(bounds.center + bounds.middle);
    out.has_arm = side.center != out.pivot;
    if (out.has_arm) out.arm = scaled_by(posed(out.start, side.center) + -posed(out.start, out.pivot), unit);
    out.mobility = mobility(given, out.pivot, bounds, unit, out.start_rotation);
    out.given = &given;
    out.reach = [](const TurningSide& own, double length, const Vec3<double>& n) {
      return reach_at_all_angles(*static_cast<const RotatingBody<S>*>(own.given), own.mobility, own.pivot,
                                 length, own.start_rotation, n);
    };
  }

  Cso<double> cso_;
  TurningSide a_, b_;
  TwoDoubles3 pivots_{}, velocity_{};
  std::array<Stand, 3> placed_;
  std::size_t at_ = 0, oldest_ = 2;
  double radius_ = 0, target_ = 0, t_ = 0;
  Vec3<double> start_offset_ = Vec3<double>::Zero();
  double start_lengths_ = 0, lengths_ = 0, speed_ = 0;
  double common_rho_ = kInfinity<double>;  // if both rotate by one w
  int poses_ = 0;
};

}}}  // namespace graze::GRAZE_LINKAGE::detail
