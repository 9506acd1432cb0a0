// A body that moves and rotates, in ball arithmetic: its support at any time, named points of it, and bounds
// on the speed and the curvature of its points' motion along an axis.
//
// Notation   R(t) = R(t w), w the rotation vector,   c = position + R(orientation) pivot,   v the velocity.
//   A world point x of the body at t = 0 is at R(t) (x - c) + c + t v at time t.
// Frame: world axes, origin at the `reference` that is given at construction, subtracted exactly. Bodies of
// one pair share it.
//
// Followed points. Only the set counts, so the body may be covered at every t by any points that stay in it.
// The bounds below hold for these curves:
//   - a ball of a sphere, capsule, rounding or ellipsoid of equal radii does not turn: its points are
//     centre(t) + a constant. The centres are the body's *core*, and ball() is the part left out of it,
//   - a cylinder, cone or ellipsoid of revolution about its own axis a is followed in a frame that does not
//     spin about a, if that frame gives a better bound (ball_motion.cpp).
//
// The pivot of a body that does not rotate may be any point, whatever the case gives. One far from the body
// would count in pivot_reach(), so a point amid the body is used. Only spin() makes this choice. For the
// oracles' own .cpp files (it includes Arb).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "corpus/case.hpp"
#include "oracles/arithmetic/number.hpp"
#include "oracles/curved/ball_body.hpp"
#include "oracles/curved/ball_rotation.hpp"

namespace graze::oracle {

// A point of the body that a proof names: R(orientation) (x - pivot), world axes of t = 0, without the
// feature's offset, and the sum of the radii on the way to it.
struct NamedPoint {
  BallVec from_pivot;
  Ball radius;
  std::size_t curved_parts = 0;  // on the way (a feature holds points for kCurvedParts of them)
  Answer inside = Answer::yes;   // do the feature's curved points lie in their parts, proved?
};

// A part of a shape of revolution with the centre o and the axis a. Its greatest n.(x - o) is height n.a +
// sqrt(radius^2 (n.n - (n.a)^2) + length^2 (n.a)^2): a rim or a tip of length 0, or an ellipsoid.
struct RevolvedPart {
  double height, radius, length;
};

class BallMotion {
 public:
  // Rounded to the working precision at construction. Throws std::invalid_argument as BallBody does, and for
  // a spin that is not finite.
  BallMotion(const Body<double>& body, const corpus::Spin& spin,
             const Vec3<double>& reference = Vec3<double>::Zero());
  ~BallMotion();
  BallMotion(BallMotion&&) noexcept;
  BallMotion& operator=(BallMotion&&) noexcept;

  // The body where it stands at a time.
  class Pose {
   public:
    // h(n) and a point of the set.
    [[nodiscard]] BallSupport support(const BallVec& n) const;
    [[nodiscard]] BallVec place(const BallVec& from_pivot) const { return turn(from_pivot) + pivot_; }
    [[nodiscard]] BallVec place(const NamedPoint& point) const { return place(point.from_pivot); }
    // R(t) n and R(t)^-1 n: axes that turn with the body.
    [[nodiscard]] BallVec turn(const BallVec& n) const { return rotation_.apply(n); }
    [[nodiscard]] BallVec turn_back(const BallVec& n) const { return rotation_.apply_inverse(n); }
    // The map from the shape's own frame, rounded, and where it takes the frame's origin.
    [[nodiscard]] Mat3<double> frame() const { return rotation_.mid_double() * body_->orientation_; }
    [[nodiscard]] BallVec origin() const { return place(-body_->arm_); }

   private:
    friend class BallMotion;
    const BallMotion* body_ = nullptr;
    BallRotation rotation_;
    BallVec pivot_;  // at that time
  };
  // Valid while the body lives. t any ball: the pose then holds those of all its times.
  [[nodiscard]] Pose at(const Ball& t) const;
  [[nodiscard]] BallSupport support(const BallVec& n, const Ball& t) const { return at(t).support(n); }

  // Throws std::invalid_argument for a vertex that the shape does not have, and for a shape of more than 64
  // levels or 4,096 parts.
  [[nodiscard]] NamedPoint named(const Feature& feature) const;
  // The number of vertices that features may name. A value of at least 2^32 allows any.
  [[nodiscard]] std::uint64_t vertex_count() const;

  [[nodiscard]] const BallVec& velocity() const { return velocity_; }  // exact
  [[nodiscard]] const BallVec& rotation() const { return rotation_; }  // w, exact
  [[nodiscard]] const BallVec& pivot() const { return pivot_; }        // c at t = 0
  // The same in doubles: w, and the pivot that counts, in the body's own frame.
  [[nodiscard]] const corpus::Spin& spin() const { return spin_; }
  [[nodiscard]] bool turns() const { return !rotation_.is_zero(); }
  // An upper bound of the magnitudes of the numbers in it, the velocity and the reference aside.
  [[nodiscard]] double magnitude() const { return magnitude_; }

  // Every point of the body is within ball() of one of its core's, as above. Bounds of the core: its points
  // are no farther than that from the axis of rotation (0 for w = 0), and from the pivot, and between the
  // heights low and high along w/|w| from the pivot (0 for w = 0).
  [[nodiscard]] const Ball& ball() const { return ball_; }
  [[nodiscard]] const Ball& axis_reach() const { return axis_reach_; }
  [[nodiscard]] const Ball& pivot_reach() const { return pivot_reach_; }
  [[nodiscard]] const Ball& axis_low() const { return axis_low_; }
  [[nodiscard]] const Ball& axis_high() const { return axis_high_; }
  // For a rotating body: a point amid the body, from the pivot at t = 0, and the largest distance of the
  // core's points from it.
  [[nodiscard]] const Vec3<double>& middle() const { return middle_; }
  [[nodiscard]] const Ball& middle_reach() const { return middle_reach_; }
  // For n fixed in the world, of |(n.(x - t v))'| and of |(n.x)''| over the points x(t).
  [[nodiscard]] Ball first_bound(const BallVec& n) const;
  [[nodiscard]] Ball second_bound(const BallVec& n) const;
  // For a shape of revolution, n fixed in the world, and all t in [begin, end]: an upper bound of n.(x - c - t v)
  // over the points x(t) of the core. Nothing for any other shape.
  [[nodiscard]] std::optional<Ball> own_reach(const BallVec& n, double begin, double end) const;

 private:
  struct Naming;
  struct OwnAxis {
    bool exists = false;
    Ball spin, tilt;      // |w.a|, |w x a|, a a unit vector along the shape's own axis
    Ball center, around;  // distance from the axis of rotation: of the shape's centre, of points from it
    BallVec axis;         // a at t = 0
    // The centre from the pivot: along a, and across it.
    Ball along, across;
    std::vector<RevolvedPart> parts;
  };

  BallBody body_;
  std::unique_ptr<Naming> naming_;
  corpus::Spin spin_;
  BallVec velocity_, rotation_, arm_, pivot_;  // arm = R(orientation) pivot
  Mat3<double> orientation_;                   // rounded
  double magnitude_ = 0;
  Ball rate_, ball_, axis_reach_, pivot_reach_, axis_low_, axis_high_;  // rate = |w|
  Vec3<double> middle_ = Vec3<double>::Zero();
  Ball middle_reach_;
  OwnAxis own_;
};

// For an axis that turns with X, R_X(t) n: an upper bound over [begin, end] of |(R_X(t) n . (x(t) - p(t)))''|
// for Y's followed points x and p the path of X's pivot. For X's own points that is 0. Their balls, and Y's,
// add constants.
[[nodiscard]] Ball second_bound_turning(const BallMotion& x, const BallMotion& y, const BallVec& n,
                                        const Ball& begin, const Ball& end);

// For two bodies with exactly one rotation vector w. Seen from any point of one body, a point of the other
// moves as R(t) z up to a constant velocity, with z no farther than this from the axis of rotation. Nothing
// if the vectors differ or are 0. With it
//   |(n.(y - x - t v))'| <= |n x w| z,     |(n.(y - x))''| <= |w| |n x w| z.
struct CommonTurn {
  BallVec rotation;
  Ball rate, reach;  // |w|, |z|

  [[nodiscard]] static std::optional<CommonTurn> of(const BallMotion& a, const BallMotion& b);
  [[nodiscard]] Ball first_bound(const BallVec& n) const { return norm(cross(n, rotation)) * reach; }
  [[nodiscard]] Ball second_bound(const BallVec& n) const { return rate * first_bound(n); }
};

// Tests g(x) = chord from s0 at 0 to s1 at d, less bound x (d - x) / 2, over [0, d], d > 0. The vertex of g
// is at d/2 - (s1 - s0) / (bound d). If it is inside, g is positive there iff s0, s1 > 0 and
//   sqrt(s0) + sqrt(s1) > d sqrt(bound / 2).
// If it is outside, |s1 - s0| >= bound d^2 / 2, and s0, s1 > 0 already give that: (sqrt s0 + sqrt s1)^2 > |s1
// - s0|. So one test suffices for g > 0, and a positive answer is certain.
[[nodiscard]] bool chord_stays_positive(const Ball& s0, const Ball& s1, const Ball& bound, const Ball& d);
// A function from s0 at 0 to s1 at d that falls no faster than f and rises no faster than r is above s0 - f x
// and s1 - r (d - x). With both ends positive, it is positive on [0, d] if f <= 0 or r <= 0, or
//   s0 / f + s1 / r > d,
// because then the first bound stays positive beyond the point where the second becomes positive. A positive
// answer is certain.
[[nodiscard]] bool slopes_stay_positive(const Ball& s0, const Ball& s1, const Ball& f, const Ball& r,
                                        const Ball& d);
// A lower bound of the least g.
[[nodiscard]] Ball chord_minimum(const Ball& s0, const Ball& s1, const Ball& bound, const Ball& d);

}  // namespace graze::oracle
