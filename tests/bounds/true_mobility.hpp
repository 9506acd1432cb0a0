// The quantities that mobility.hpp bounds, by its own formulas in balls: a computed bound must not be less.
// mobility_test.cpp tests by differences of supports that the formulas bound the motion.
#pragma once

#include <graze/detail/rotating/mobility.hpp>
#include <optional>

#include "tests/bounds/bound_truth.hpp"

namespace graze::test {

// The shape without what rounds it and without poses that do nothing: of the same core.
inline const Shape<double>& of_same_core(const Shape<double>& shape) {
  if (const auto* rounded = std::get_if<Rounded<double>>(&shape)) return of_same_core(rounded->shape->shape);
  if (const auto* posed = std::get_if<Posed<double>>(&shape);
      posed && posed->orientation.is_identity() && posed->position == Vec3<double>::Zero())
    return of_same_core(posed->shape->shape);
  return shape;
}
inline bool revolves(const Shape<double>& shape) {
  return detail::axis_of_revolution(of_same_core(shape)) >= 0;
}

// A solid of revolution about its own axis a.
struct Revolved {
  Ball tilt, own, center, around;  // |w x a|, |a.w|, |c_perp|, r

  Revolved(const TrueBody& body, const Shape<double>& given, const Vec3<double>& pivot) {
    const Shape<double>& shape = of_same_core(given);
    BallVec foot;  // of the pivot on the axis of revolution, own frame
    if (detail::is_ball(shape)) {
      own = body.rate;
    } else {
      const int k = detail::axis_of_revolution(shape);
      const BallVec a = body.orientation.apply(BallVec(Vec3<double>(Vec3<double>::Unit(k))));
      tilt = norm(cross(body.w, a));
      own = abs(dot(body.w, a));
      foot = BallVec(Vec3<double>(pivot[k] * Vec3<double>::Unit(k)));
    }
    const BallVec c = body.orientation.apply(foot - BallVec(pivot));
    center = norm(cross(body.w, c)) / body.rate;
    for (const BallVec& arm : body.arms) around = max(around, norm(arm - c));
  }
};

// The mobility of a rotating body, lengths times `unit`. All values are 0 for a body that does not rotate.
class TrueMobility {
 public:
  TrueMobility(const TrueBody& body, const RotatingBody<double>& given, const Vec3<double>& pivot,
               const Ball& unit)
      : w_(body.w), rate_(body.rate), reach_(unit * body.reach()) {
    if (!body.turns) return;
    rho_ = unit * body.rho();
    if (!revolves(given.body.shape)) return;
    own_.emplace(body, given.body.shape, pivot);
    own_->center *= unit;
    own_->around *= unit;
  }

  [[nodiscard]] const BallVec& w() const { return w_; }
  [[nodiscard]] const Ball& rate() const { return rate_; }
  [[nodiscard]] const Ball& reach() const { return reach_; }
  [[nodiscard]] Ball speed(const BallVec& n) const { return first(norm(cross(n, w_))); }
  [[nodiscard]] Ball acceleration(const BallVec& n) const { return second(rate_ * norm(cross(n, w_))); }
  [[nodiscard]] Ball top_speed() const { return first(rate_); }
  [[nodiscard]] Ball top_acceleration() const { return second(rate_ * rate_); }
  // The displacement of the set when a point at distance 1 from the axis gets `chord` far.
  [[nodiscard]] Ball rotation_displacement(const Ball& chord) const {
    return own_ ? min(chord * rho_, chord * (own_->center + own_->tilt / rate_ * own_->around))
                : chord * rho_;
  }

 private:
  [[nodiscard]] Ball first(const Ball& across) const {
    return own_ ? min(across * rho_, across * own_->center + own_->tilt * own_->around) : across * rho_;
  }
  [[nodiscard]] Ball second(const Ball& across) const {
    if (!own_) return across * rho_;
    return min(across * rho_, across * own_->center + own_->tilt * (own_->tilt + own_->own) * own_->around);
  }

  BallVec w_;
  Ball rate_, reach_, rho_;
  std::optional<Revolved> own_;
};

}  // namespace graze::test
