// Two bodies that move and rotate: their separation along an axis at a time and over a slice of time, and
// whether they touch at a time, proved in ball arithmetic.
//
// Notation   s(n, t) = min over b in B(t) of n.b - max over a in A(t) of n.a - m |n|, m the target distance.
//   If it is positive, the bodies are more than m apart.   n(t) = n, or n turned with A or with B.
//   penetration p(t) = max(0, least over unit n of -s(n, t)).
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include "oracles/curved/ball_motion.hpp"
#include "oracles/curved/ball_search.hpp"

namespace graze::oracle {

enum class Turning { world, with_a, with_b };

// The pair at one time. Valid while the pair lives.
struct PairPose {
  Ball t;  // exact
  BallMotion::Pose a, b;
};

// A bound of s over a slice for an axis that turns as `turning` says:
//   s(t) >= chord of s0, s1 - bound (t - t0)(t1 - t) / 2.
// Proof: s is the least, over pairs of followed points (ball_motion.hpp), of f(t) = n(t).(b(t) - a(t)) less a
// constant, and |f''| <= bound. So f + bound t^2 / 2 is convex and f - bound t^2 / 2 concave. The latter lies
// above its chord. Each f therefore lies above its chord less that term. So does the least of them, above the
// chord of its own end values, which are no greater than theirs.
struct SliceBound {
  Ball s0, s1, bound, duration;  // s0 and s1 over |axis|, from below
  [[nodiscard]] bool exceeds(const Ball& least) const {
    return chord_stays_positive(s0 - least, s1 - least, bound, duration);
  }
  // A lower bound of s over the slice.
  [[nodiscard]] Ball least() const { return chord_minimum(s0, s1, bound, duration); }
};

// Apart: s(axis, t) = lower > 0, and distance <= upper (infinite where the axis was good enough to go on).
// Overlapping: 0 < lower <= p(t) <= depth, and s(axis, t) >= -depth. Open: distance <= upper, p(t) <= depth.
struct Contact {
  enum class Kind { apart, overlapping, open } kind = Kind::open;
  Vec3<double> axis = Vec3<double>::Zero();  // unit up to rounding, or zero if none was found
  Ball lower, upper, depth;
};

class RotatingPair {
 public:
  // Throws std::invalid_argument for shapes that BallMotion refuses. Rounded to the working precision.
  explicit RotatingPair(const corpus::Case& problem);

  [[nodiscard]] const BallMotion& a() const { return a_; }
  [[nodiscard]] const BallMotion& b() const { return b_; }
  [[nodiscard]] const Ball& scale() const { return scale_; }  // DESIGN: the largest extent at t = 0
  [[nodiscard]] double magnitude() const { return a_.magnitude() + b_.magnitude() + target_; }

  [[nodiscard]] PairPose at(const Ball& t) const { return {t, a_.at(t), b_.at(t)}; }
  // s(n, t) / |n|, from below.
  [[nodiscard]] Ball separation(const BallVec& n, const PairPose& pose) const;
  // K = A(t) - B(t) + ball(m)
  [[nodiscard]] ConvexSet set(const PairPose& pose) const;

  // The second derivative's bound over [from, to], `axis` of length 1 as it stands at `from`.
  [[nodiscard]] Ball bound(const BallVec& axis, const PairPose& from, const Ball& to, Turning turning) const;
  // The turning of least bound.
  [[nodiscard]] Turning steadiest(const BallVec& axis, const PairPose& from, const Ball& to) const;
  [[nodiscard]] BallVec turned(const BallVec& axis, const PairPose& from, const PairPose& to,
                               Turning turning) const;
  // The bound over [from, to]. `axis` is unit up to rounding, in world axes at one of the two times.
  [[nodiscard]] SliceBound over(const Vec3<double>& axis, bool at_end, Turning turning, const PairPose& from,
                                const PairPose& to) const;

  // Decides whether the bodies are apart or overlapping, to a length of `fine`, an exact ball. The search
  // begins with the axis `start`. If the bodies are further apart than `near`, any axis is accepted that
  // shows half the distance. For an overlap, depth <= (1 + slack) lower or both are about `fine`.
  [[nodiscard]] Contact contact(const PairPose& pose, const Vec3<double>& start, const Ball& fine,
                                const Ball& near, double slack) const;
  // A slack of contact() for callers that only need a proof of overlap: the depth is within a factor of 16.
  static constexpr double kAnyDepth = 15;
  // The distance at a time: within `fine` or that part of itself.
  [[nodiscard]] Nearest3 distance(const PairPose& pose, const Ball& fine, double relative) const;
  // From body 'a' or 'b' of a world point, from the reference: A's position at t = 0.
  [[nodiscard]] Nearest3 distance_from_body(char body, const PairPose& pose, const BallVec& point,
                                            const Ball& fine, double relative) const;

  // Each body with the set that it sweeps as it rotates about its axis. These sets only translate. Returns s
  // of these sets, placed at t. It is a lower bound of s(n, t), and linear in t.
  [[nodiscard]] Ball turned_separation(const BallVec& n, const Ball& t) const;
  [[nodiscard]] Nearest3 turned_distance(const Ball& t, const Ball& fine, double relative) const;

 private:
  // The set that a body sweeps in a whole turn lies in the cylinder about its pivot's axis of rotation.
  struct Turned {
    BallVec axis;  // of length 1
    Ball radius, low, high;
  };
  [[nodiscard]] static Turned turned_body(const BallMotion& body);
  [[nodiscard]] BallSupport turned_support(const BallMotion& body, const Turned& turned, const BallVec& n,
                                           const Ball& t) const;

  Shape<double> shape_a_, shape_b_;
  double target_;
  BallMotion a_, b_;
  Ball scale_;
  int exponent_ = 0;
  Turned turned_a_, turned_b_;
};

}  // namespace graze::oracle
