// Positions of the points that a proof names, rounded for a picture. They are not used to judge anything.
#pragma once

#include <graze/proof.hpp>

#include "reports/drawing/geometry.hpp"

namespace graze::show {

// A point of the shape in the body's frame, without the feature's offset, which is in world axes.
[[nodiscard]] draw::Vec feature_point(const Shape<double>& shape, const Feature& feature);

// a - b of a support pair of the bodies as they stand, offsets included.
[[nodiscard]] draw::Vec difference_of(const SupportPair& pair, const Shape<double>& a, const draw::Pose& at_a,
                                      const Shape<double>& b, const draw::Pose& at_b);

// The axis of a linear proof, symbolic or not, of unit length. Zero if the proof has no axis, or if its factors are
// parallel to within rounding.
[[nodiscard]] draw::Vec axis_of(const Proof& proof, const Shape<double>& a, const draw::Pose& at_a,
                                const Shape<double>& b, const draw::Pose& at_b, const draw::Vec& velocity);

}  // namespace graze::show
