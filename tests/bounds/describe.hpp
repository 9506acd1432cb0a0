// A scene as text, every number a hexfloat: what a failure prints comes back bit by bit.
#pragma once

#include <graze/detail/shapes/shape_tree.hpp>
#include <sstream>

#include "tests/bounds/hostile.hpp"

namespace graze::test {

inline std::ostream& operator<<(std::ostream& out, const Quaternion<double>& q) {
  return out << "{" << q.w << ", " << q.x << ", " << q.y << ", " << q.z << "}";
}
inline void write(std::ostream& out, const Vec3<double>& x) {
  out << "{" << x[0] << ", " << x[1] << ", " << x[2] << "}";
}
inline void write(std::ostream& out, const Shape<double>& shape);
inline void write(std::ostream& out, const std::vector<SharedShape<double>>& parts) {
  for (const auto& part : parts) {
    out << " ";
    write(out, part->shape);
  }
}
inline void write(std::ostream& out, const Shape<double>& shape) {
  std::visit(
      detail::Overloaded{
          [&](const Point<double>&) { out << "Point{}"; },
          [&](const Segment<double>& s) {
            out << "Segment{";
            for (const Vec3<double>& x : {s.a, s.b}) write(out, x);
            out << "}";
          },
          [&](const Triangle<double>& s) {
            out << "Triangle{";
            for (const Vec3<double>& x : {s.a, s.b, s.c}) write(out, x);
            out << "}";
          },
          [&](const Sphere<double>& s) { out << "Sphere{" << s.radius << "}"; },
          [&](const Capsule<double>& s) { out << "Capsule{" << s.radius << ", " << s.half_height << "}"; },
          [&](const Box<double>& s) {
            out << "Box{";
            write(out, s.half_extents);
            out << "}";
          },
          [&](const Ellipsoid<double>& s) {
            out << "Ellipsoid{";
            write(out, s.radii);
            out << "}";
          },
          [&](const Cylinder<double>& s) { out << "Cylinder{" << s.radius << ", " << s.half_height << "}"; },
          [&](const Cone<double>& s) { out << "Cone{" << s.radius << ", " << s.half_height << "}"; },
          [&](const Hull<double>& s) {
            out << "Hull{";
            for (const Vec3<double>& x : s.vertices()) write(out, x);
            out << "}";
          },
          [&](const Posed<double>& s) {
            out << "Posed{";
            write(out, s.shape->shape);
            out << " position ";
            write(out, s.position);
            out << " orientation " << s.orientation << "}";
          },
          [&](const Rounded<double>& s) {
            out << "Rounded{";
            write(out, s.shape->shape);
            out << " radius " << s.radius << "}";
          },
          [&](const Sum<double>& s) {
            out << "Sum{";
            write(out, s.shapes);
            out << "}";
          },
          [&](const HullOf<double>& s) {
            out << "HullOf{";
            write(out, s.shapes);
            out << "}";
          }},
      shape);
}
inline void write(std::ostream& out, const RotatingBody<double>& body) {
  out << "shape ";
  write(out, body.body.shape);
  out << "\n    position ";
  write(out, body.body.position);
  out << " orientation " << body.body.orientation << " displacement ";
  write(out, body.body.displacement);
  out << "\n    rotation ";
  write(out, body.rotation);
  out << " pivot ";
  write(out, body.pivot);
}
inline std::string describe(const HostileScene& scene) {
  std::ostringstream out;
  out << std::hexfloat << "  A: ";
  write(out, scene.a);
  out << "\n  B: ";
  write(out, scene.b);
  out << "\n  target " << scene.target << " t_end " << scene.t_end << "\n  classes:";
  for (unsigned i = 0; i < kHostileClasses; ++i) {
    if (scene.is(static_cast<Hostile>(i))) out << " " << kHostileNames[i] << ",";
  }
  out << "\n";
  return out.str();
}
inline std::string describe(const Vec3<double>& x) {
  std::ostringstream out;
  out << std::hexfloat;
  write(out, x);
  return out.str();
}
inline std::string describe(const HostileScene& scene, const Vec3<double>& n, double t) {
  std::ostringstream out;
  out << std::hexfloat << describe(scene) << "  n ";
  write(out, n);
  out << " t " << t << "\n";
  return out.str();
}

}  // namespace graze::test
