// Poses of bodies and their outlines in parallel projection.
//
// Everything is in Real. Its unit roundoff is 2^-64 if the machine has it (x86) and at most 2^-53. A detail
// at 10^15 magnification then still has significant digits. Used for pictures only: no answer is judged by
// it.
#pragma once

#include <optional>
#include <vector>

#include "corpus/case.hpp"

namespace graze::draw {

using Real = long double;
using Vec = Eigen::Matrix<Real, 3, 1>;
using Mat = Eigen::Matrix<Real, 3, 3>;
inline constexpr Real kUnbounded = std::numeric_limits<Real>::infinity();
inline Vec wide(const Vec3<double>& x) { return x.cast<Real>(); }
using Flat = Eigen::Matrix<Real, 2, 1>;  // in the plane of a view: (along right, along up)

// x -> rotation x + position.
struct Pose {
  Mat rotation = Mat::Identity();
  Vec position = Vec::Zero();
};

// The axes of a picture, unit and right-handed. `towards` points to the viewer.
struct View {
  Vec right = Vec::UnitX(), up = Vec::UnitY(), towards = Vec::UnitZ();

  [[nodiscard]] Flat project(const Vec& x) const { return {right.dot(x), up.dot(x)}; }
};

// The part of the view's plane that a picture shows.
struct Window {
  Flat middle = Flat::Zero();
  Real half_width = 1, half_height = 1;
};

// A body of a case at time t, the world's origin moved to `origin`.
[[nodiscard]] Pose pose_at(const Body<double>& body, const corpus::Spin& spin, Real t, const Vec& origin);
// R(w): by |w| radians about w.
[[nodiscard]] Mat turn_by(const Vec& w);

// A point of the shape that is farthest along n, in the shape's frame. Every part must be present.
[[nodiscard]] Vec support_point(const Shape<double>& shape, const Vec& n);
// max n.x over the posed shape.
[[nodiscard]] Real height(const Shape<double>& shape, const Pose& pose, const Vec& n);
// The middle of the shape's bounding box, in its frame, and the box's diagonal.
struct Extent {
  Vec middle;
  Real diagonal;
};
[[nodiscard]] Extent extent(const Shape<double>& shape);

// The vertices whose hull is the shape. Nothing for a curved shape or one with more than 4096 vertices.
[[nodiscard]] std::optional<std::vector<Vec>> polytope_vertices(const Shape<double>& shape);

// The outline of the posed shape's projection, anticlockwise. For a polytope it is the hull of the projected
// vertices. For a curved shape it is a polygon within `tolerance` of the outline inside the window.
[[nodiscard]] std::vector<Flat> outline(const Shape<double>& shape, const Pose& pose, const View& view,
                                        const Window& window, Real tolerance);

// The edges of a polytope, the rims of a cylinder and a cone: what lies on the viewer's side, as polylines.
[[nodiscard]] std::vector<std::vector<Flat>> visible_edges(const Shape<double>& shape, const Pose& pose,
                                                           const View& view);

// The part of a convex polygon, of two points too, that lies in the window.
[[nodiscard]] std::vector<Flat> clip_polygon(std::vector<Flat> polygon, const Window& window);
// The part of a segment inside the window. Nothing if it lies outside.
[[nodiscard]] std::optional<std::pair<Flat, Flat>> clip_segment(Flat from, Flat to, const Window& window);

}  // namespace graze::draw
