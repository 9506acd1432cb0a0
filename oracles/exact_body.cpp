// Decides: the exact posed vertices of a body. Brackets: nothing. Costs: about 5 microseconds a rotated
// vertex. Cannot be trusted: nowhere; what it cannot represent it refuses.
#include "oracles/exact_body.hpp"

#include <cmath>
#include <stdexcept>

namespace graze::oracle {
namespace {

Rational exact(double x, const char* what) {
  if (!std::isfinite(x)) throw std::invalid_argument(std::string(what) + ": not a finite number");
  return Rational(x);
}

RationalPoint exact(const Vec3<double>& x, const char* what) {
  return {exact(x[0], what), exact(x[1], what), exact(x[2], what)};
}

using RationalMatrix = std::array<RationalPoint, 3>;

// The matrix of x -> q x conj(q) / |q|^2, from the products of q's components:
//   R = (1/|q|^2) [ww+xx-yy-zz  2(xy-wz)  2(xz+wy); 2(xy+wz)  ww-xx+yy-zz  2(yz-wx); 2(xz-wy)  2(yz+wx)
//   ww-xx-yy+zz].
RationalMatrix rotation(const Quaternion<double>& q) {
  const Rational w = exact(q.w, "orientation"), x = exact(q.x, "orientation");
  const Rational y = exact(q.y, "orientation"), z = exact(q.z, "orientation");
  const Rational ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const Rational norm_sq = ww + xx + yy + zz;
  if (sgn(norm_sq) == 0) throw std::invalid_argument("orientation: the zero quaternion is not a rotation");
  const Rational inverse = 1 / norm_sq, twice = 2 / norm_sq;
  const Rational xy = x * y, xz = x * z, yz = y * z, wx = w * x, wy = w * y, wz = w * z;
  return {RationalPoint{(ww + xx - yy - zz) * inverse, (xy - wz) * twice, (xz + wy) * twice},
          RationalPoint{(xy + wz) * twice, (ww - xx + yy - zz) * inverse, (yz - wx) * twice},
          RationalPoint{(xz - wy) * twice, (yz + wx) * twice, (ww - xx - yy + zz) * inverse}};
}

std::vector<Vec3<double>> local_vertices(const Shape<double>& shape) {
  if (const auto* box = std::get_if<Box<double>>(&shape)) {
    std::vector<Vec3<double>> corners;
    for (unsigned k = 0; k < 8; ++k) {
      Vec3<double> corner;
      for (unsigned i = 0; i < 3; ++i) {
        if (box->half_extents[i] < 0) throw std::invalid_argument("box: a half extent is negative");
        corner[i] = (k >> i & 1U) != 0 ? box->half_extents[i] : -box->half_extents[i];
      }
      corners.push_back(corner);
    }
    return corners;
  }
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) {
    if (hull->size() == 0) throw std::invalid_argument("hull: it has no vertex");
    return {hull->vertices().begin(), hull->vertices().end()};
  }
  if (std::holds_alternative<Point<double>>(shape) || std::holds_alternative<Sphere<double>>(shape)) {
    return {Vec3<double>::Zero()};
  }
  throw std::invalid_argument("a shape that this oracle does not know");
}

}  // namespace

ExactBody exact_body(const Body<double>& body) {
  ExactBody result;
  const RationalPoint position = exact(body.position, "position");
  const RationalMatrix turn = rotation(body.orientation);
  const bool turns = !body.orientation.is_identity();
  for (const Vec3<double>& local : local_vertices(body.shape)) {
    const RationalPoint x = exact(local, "shape");
    RationalPoint& world = result.vertices.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      world[i] =
          position[i] + (turns ? Rational(turn[i][0] * x[0] + turn[i][1] * x[1] + turn[i][2] * x[2]) : x[i]);
    }
  }
  if (const auto* sphere = std::get_if<Sphere<double>>(&body.shape)) {
    result.radius = exact(sphere->radius, "radius");
    if (sgn(result.radius) < 0) throw std::invalid_argument("sphere: the radius is negative");
  }
  result.displacement = exact(body.displacement, "displacement");
  return result;
}

}  // namespace graze::oracle
