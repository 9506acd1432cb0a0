// Any posed shape as a support function in ball arithmetic, at t = 0 in world axes.
//
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include <memory>
#include <vector>

#include "corpus/case.hpp"
#include "oracles/arithmetic/ball.hpp"

namespace graze::oracle {

// h(n) = max over the set of n.x, and a point of the set at which n.x is h(n) up to rounding.
struct BallSupport {
  Ball reach;     // holds h(n)
  BallVec point;  // holds a point of the set, exactly
};

class BallBody {
 public:
  // Throws std::invalid_argument for a number that is not finite, a negative extent, an empty hull or
  // combinator, a zero quaternion. Poses are rounded to the working precision at construction.
  explicit BallBody(const Body<double>& body);
  ~BallBody();
  BallBody(BallBody&&) noexcept;
  BallBody& operator=(BallBody&&) noexcept;

  // The support of the shape relative to the body's own position. Add the position to place it.
  [[nodiscard]] BallSupport support(const BallVec& n) const;
  [[nodiscard]] const BallVec& position() const { return position_; }
  [[nodiscard]] const BallVec& displacement() const { return displacement_; }
  // An upper bound of the magnitude of the numbers in it. Rounding errors are relative to it.
  [[nodiscard]] double magnitude() const { return magnitude_; }

 private:
  struct Node;
  struct Builder;
  BallVec position_, displacement_;
  double magnitude_ = 0;
  std::unique_ptr<Node> root_;
};

}  // namespace graze::oracle
