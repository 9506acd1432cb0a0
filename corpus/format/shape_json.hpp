// Shapes and bodies to and from JSON. A new shape is one more row of each table in shape_json.cpp.
#pragma once

#include "corpus/format/fields.hpp"

namespace graze::corpus {

struct MovingBody {
  Body<double> body;
  Spin spin;
};

// The greatest number of combinators (posed, rounded, sum, hull_of) on the way from a shape to a leaf that is
// read. Together with the body's own and the JSON arrays around them it stays below kMaxJsonDepth.
inline constexpr int kMaxShapeDepth = 16;

// Throw Malformed.
[[nodiscard]] Shape<double> read_shape(const JsonValue& value, const std::string& path);
[[nodiscard]] Quaternion<double> read_orientation(const JsonValue& value, const std::string& path);
[[nodiscard]] MovingBody read_body(const JsonValue& value, const std::string& path);

// True unless every component is +0: what a writer may leave out without losing a bit.
[[nodiscard]] bool is_set(const Vec3<double>& v);
[[nodiscard]] std::string write_vec3(const Vec3<double>& v);
[[nodiscard]] std::string write_shape(const Shape<double>& shape);
[[nodiscard]] std::string write_body(const Body<double>& body, const Spin& spin);

}  // namespace graze::corpus
