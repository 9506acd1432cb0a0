#include "properties/judge/own_frames.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <variant>

#include "corpus/support_value.hpp"
#include "engines/guarantees.hpp"
#include "properties/edit/shape.hpp"

namespace graze::law {

namespace {

// How far beyond `scale` positions and leaves reach that `rotations` turn, as often as they are turned.
double reach_beyond(const Shape<double>& shape, double scale, int rotations) {
  const auto excess = [&](double length) { return rotations * std::max(length - scale, 0.0); };
  return std::visit(
      [&]<class T>(const T& one) {
        if constexpr (std::same_as<T, Posed<double>>) {
          const int below = rotations + !one.orientation.is_identity();
          return excess(one.position.norm()) + reach_beyond(one.shape->shape, scale, below);
        } else if constexpr (std::same_as<T, Rounded<double>>) {
          return reach_beyond(one.shape->shape, scale, rotations);
        } else if constexpr (requires { one.shapes; }) {
          double sum = 0;
          for (const SharedShape<double>& part : one.shapes)
            sum += reach_beyond(part->shape, scale, rotations);
          return sum;
        } else {
          if (rotations == 0) return 0.0;
          const corpus::Bounds box = corpus::bounds(shape);
          return excess(box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm());
        }
      },
      shape);
}

}  // namespace

double unseen_of_trees(const corpus::Case& problem, double scale) {
  return 46 * kUnitRoundoff<double> *
         (reach_beyond(problem.a.shape, scale, 0) + reach_beyond(problem.b.shape, scale, 0));
}

double unseen_of_turns(const corpus::Case& problem) {
  const auto lengths = [&](const Body<double>& body, const corpus::Spin& spin) {
    const corpus::Bounds box = corpus::bounds(body.shape);
    const double way = std::isfinite(problem.t_max) ? problem.t_max * body.displacement.norm() : 0;
    return body.position.norm() + spin.pivot.norm() +
           box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm() + way;
  };
  return 0x1p-87 * (lengths(problem.a, problem.spin_a) + lengths(problem.b, problem.spin_b));
}

double weight_of_own_frames(const corpus::Case& problem) {
  double lengths = 0, nodes = 0;
  const auto add = [&](Slot slot, double x) {
    if (is_length(slot)) lengths += std::abs(x);
    nodes += 1;  // a node has one number at least, except a point
    return x;
  };
  static_cast<void>(map_shape(problem.a.shape, add));
  static_cast<void>(map_shape(problem.b.shape, add));
  return (nodes + 2) * lengths;
}

double unseen_of_own_frames(const corpus::Case& problem) {
  return engine::kOwnFramesOfCertified * weight_of_own_frames(problem);
}

}  // namespace graze::law
