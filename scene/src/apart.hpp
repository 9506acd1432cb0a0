// Tests a pair over a step with a support or two instead of a cast. One axis may separate it from the beginning to
// the end, or a few of its points may show that it is in contact at the beginning. Every rounding is counted. A short
// search finds such an axis, or such points.
#pragma once

#include <graze/detail/pairs/side.hpp>
#include <graze/result.hpp>
#include <graze/rotating_body.hpp>
#include <graze/scene/memory.hpp>

namespace graze::scene {

struct StepLimits {
  double t_end = 1, target_distance = 0, tolerance = 0;
  int exponent = 0;  // internal length = world length 2^-exponent
};

// One body over a step, prepared once for all its pairs. Valid while the body lives.
struct StepBody {
  StepBody(const RotatingBody<double>& moving, const StepLimits& limits);

  detail::Side<double> side;
  std::array<Mat3<double>, 2> rotation;  // at 0 and t_end, equal if no rotation is followed
  Vec3<double> start;                    // the side's centre at 0
  std::array<Vec3<double>, 2> center;    // of what is followed over the step: the side, or the ball
  Vec3<double> w;                        // rotation vector
  double rate = 0, rho = 0;              // |w|, and how far the core's points are from the pivot, at most
  double radius = 0, size = 0;           // of the ball added to the core, and of the whole
  double swept = 0;                      // the radius, with the addition for a rotation that is not followed
  double error = 0;                      // of a point, and of h(n)
  bool turns = false;                    // the rotation is followed
  bool is_ball = false;                  // over the step the ball about the pivot stands for the core
};

class StepPair {
 public:
  StepPair(const StepBody& a, const StepBody& b, const StepLimits& limits, Counters& counters);

  // n, unit, parts the bodies over [0, t_end], by more than any method's rounding and the width of any tier's answer: the
  // pair's cast is a miss.
  [[nodiscard]] bool is_parted_by(const Vec3<double>& n);
  // Such an n, from a hint or from nothing (0). It is 0 if a short search finds none.
  [[nodiscard]] Vec3<double> find_axis(const Vec3<double>& hint);

  // Points of A - B along these directions hold the origin at t = 0, as deep: the pair's cast is initially_overlapping.
  [[nodiscard]] bool is_held_by(const Touching& features);
  [[nodiscard]] std::optional<Touching> find_touching();

 private:
  struct Ends {
    std::array<Vec3<double>, 2> w;  // of C = A - B at 0 and t_end
    std::uint32_t vertex_a = 0, vertex_b = 0;
  };
  [[nodiscard]] Ends support(const Vec3<double>& n, bool both);
  [[nodiscard]] bool holds_origin(const std::array<Vec3<double>, 4>& w, int size) const;

  const StepBody &a_, &b_;
  detail::Side<double> side_a_, side_b_;  // a climb remembers where it ended: each pair's own
  const StepLimits& limits_;
  Counters& counters_;
  std::array<Vec3<double>, 2> apart_;  // B's centre from A's, of what is followed over the step
  Vec3<double> start_;                 // and of the sides at 0
  double radius_, swept_, error_, margin_;
};

}  // namespace graze::scene
