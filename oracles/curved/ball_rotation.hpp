// Rotations in ball arithmetic: by a quaternion, and by a rotation vector.
//
// For the oracles' own .cpp files (it includes Arb).
#pragma once

#include <stdexcept>

#include "oracles/arithmetic/ball.hpp"

namespace graze::oracle {

// A rotation as a matrix, rounded to the working precision of its construction.
class BallRotation {
 public:
  BallRotation() = default;  // the identity

  // x -> q x conj(q) / |q|^2. Throws std::invalid_argument for q = 0.
  explicit BallRotation(const Quaternion<double>& q) : identity_(q.is_identity()) {
    const Ball w = q.w, x = q.x, y = q.y, z = q.z;
    if (identity_) {
      if (w.is_zero()) throw std::invalid_argument("orientation: the zero quaternion is not a rotation");
      return;
    }
    const Ball ww = w * w, xx = x * x, yy = y * y, zz = z * z;
    const Ball one = Ball(1) / (ww + xx + yy + zz), two = one + one;
    const Ball xy = x * y, xz = x * z, yz = y * z, wx = w * x, wy = w * y, wz = w * z;
    row_ = {BallVec{(ww + xx - yy - zz) * one, (xy - wz) * two, (xz + wy) * two},
            BallVec{(xy + wz) * two, (ww - xx + yy - zz) * one, (yz - wx) * two},
            BallVec{(xz - wy) * two, (yz + wx) * two, (ww - xx - yy + zz) * one}};
  }

  // By |w| radians about w (Rodrigues), without a division by |w|: with s(x) = sin(x) / x,
  //   R(w) = cos|w| 1 + s(|w|) [w]x + (1/2) s(|w| / 2)^2 w w^T.
  explicit BallRotation(const BallVec& w) : identity_(w.is_zero()) {
    if (identity_) return;
    const Ball angle = norm(w), half = Ball(0.5) * angle;
    Ball c, s, h;
    arb_cos(c.get(), angle.get(), WorkingPrecision::bits());
    arb_sinc(s.get(), angle.get(), WorkingPrecision::bits());
    arb_sinc(h.get(), half.get(), WorkingPrecision::bits());
    const BallVec sw = s * w, kw = (Ball(0.5) * h * h) * w;
    row_ = {BallVec{c + kw.x * w.x, kw.x * w.y - sw.z, kw.x * w.z + sw.y},
            BallVec{kw.y * w.x + sw.z, c + kw.y * w.y, kw.y * w.z - sw.x},
            BallVec{kw.z * w.x - sw.y, kw.z * w.y + sw.x, c + kw.z * w.z}};
  }

  [[nodiscard]] bool is_identity() const { return identity_; }
  [[nodiscard]] BallVec apply(const BallVec& x) const {
    return identity_ ? x : BallVec{dot(row_[0], x), dot(row_[1], x), dot(row_[2], x)};
  }
  [[nodiscard]] BallVec apply_inverse(const BallVec& x) const {
    return identity_ ? x : x.x * row_[0] + x.y * row_[1] + x.z * row_[2];
  }
  // Rounded.
  [[nodiscard]] Mat3<double> mid_double() const {
    Mat3<double> m = Mat3<double>::Identity();
    for (int i = 0; i < 3 && !identity_; ++i) m.row(i) = row_[static_cast<std::size_t>(i)].mid_double();
    return m;
  }

 private:
  bool identity_ = true;
  std::array<BallVec, 3> row_;
};

}  // namespace graze::oracle
