// Decides: the exact posed vertices and the radius of a body. Brackets: nothing. Costs: about 5 microseconds
// a rotated vertex, as much again for every pose within the shape. Cannot be trusted: nowhere. It refuses
// shapes that it cannot represent.
#include "oracles/polytope/exact_body.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace graze::oracle {
namespace {

using Points = std::vector<RationalPoint>;
using Parts = std::vector<SharedShape<double>>;
using RationalMatrix = std::array<RationalPoint, 3>;

Rational exact(double x, const char* what) {
  if (!std::isfinite(x)) throw std::invalid_argument(std::string(what) + ": not a finite number");
  return Rational(x);
}

RationalPoint exact(const Vec3<double>& x, const char* what) {
  return {exact(x[0], what), exact(x[1], what), exact(x[2], what)};
}

Rational extent(double x, const char* what) {
  if (x < 0) throw std::invalid_argument(std::string(what) + ": it is negative");
  return exact(x, what);
}

RationalPoint plus(const RationalPoint& l, const RationalPoint& r) {
  return {l[0] + r[0], l[1] + r[1], l[2] + r[2]};
}

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

Points pose(Points points, const Vec3<double>& position, const Quaternion<double>& orientation) {
  const RationalPoint origin = exact(position, "position");
  const RationalMatrix turn = rotation(orientation);
  const bool turns = !orientation.is_identity();
  for (RationalPoint& x : points) {
    RationalPoint placed = origin;
    for (std::size_t i = 0; i < 3; ++i) {
      placed[i] += turns ? Rational(turn[i][0] * x[0] + turn[i][1] * x[1] + turn[i][2] * x[2]) : x[i];
    }
    x = std::move(placed);
  }
  return points;
}

const Shape<double>& part(const SharedShape<double>& shared) {
  if (!shared) throw std::invalid_argument("a combinator: a part has no shape");
  return shared->shape;
}

void demand_parts(const Parts& parts) {
  if (parts.empty()) throw std::invalid_argument("a combinator: it has no part");
}

// The parts of a shape, found without a vertex. Throws if the shape is not one polytope and one ball.
struct Outline {
  std::size_t vertices = 0;
  Rational radius;
};

Outline outline(const Shape<double>& shape);

struct OutlineOf {
  Outline operator()(const Point<double>&) const { return {1, 0}; }
  Outline operator()(const Segment<double>& s) const {
    exact(s.a, "segment");
    exact(s.b, "segment");
    return {2, 0};
  }
  Outline operator()(const Triangle<double>& s) const {
    exact(s.a, "triangle");
    exact(s.b, "triangle");
    exact(s.c, "triangle");
    return {3, 0};
  }
  Outline operator()(const Sphere<double>& s) const { return {1, extent(s.radius, "sphere: radius")}; }
  Outline operator()(const Capsule<double>& s) const {
    extent(s.half_height, "capsule: half height");
    return {2, extent(s.radius, "capsule: radius")};
  }
  Outline operator()(const Box<double>& s) const {
    for (const double h : {s.half_extents[0], s.half_extents[1], s.half_extents[2]})
      extent(h, "box: half extent");
    return {8, 0};
  }
  Outline operator()(const Hull<double>& s) const {
    if (s.size() == 0) throw std::invalid_argument("hull: it has no vertex");
    for (const Vec3<double>& x : s.vertices()) {
      if (!x.allFinite()) throw std::invalid_argument("hull: not a finite number");
    }
    return {s.size(), 0};
  }
  Outline operator()(const Posed<double>& s) const {
    exact(s.position, "position");
    rotation(s.orientation);
    return outline(part(s.shape));
  }
  Outline operator()(const Rounded<double>& s) const {
    Outline core = outline(part(s.shape));
    core.radius += extent(s.radius, "rounded: radius");
    return core;
  }
  Outline operator()(const Sum<double>& s) const {
    demand_parts(s.shapes);
    Outline all{1, 0};
    for (const SharedShape<double>& shared : s.shapes) {
      const Outline one = outline(part(shared));
      if (s.shapes.size() > 1 && one.vertices > kMostSumVertices / all.vertices) {
        throw std::invalid_argument("sum: more than " + std::to_string(kMostSumVertices) +
                                    " vertices; this oracle forms them all");
      }
      all.vertices *= one.vertices;
      all.radius += one.radius;
    }
    return all;
  }
  Outline operator()(const HullOf<double>& s) const {
    demand_parts(s.shapes);
    Outline all = outline(part(s.shapes[0]));
    for (std::size_t i = 1; i < s.shapes.size(); ++i) {
      const Outline one = outline(part(s.shapes[i]));
      if (one.radius != all.radius) {
        throw std::invalid_argument(
            "hull_of: its parts have different radii, so it is no polytope with one ball");
      }
      all.vertices += one.vertices;
    }
    return all;
  }
  // Ellipsoid, cylinder, cone.
  template <class Curved>
  Outline operator()(const Curved&) const {
    throw std::invalid_argument("a curved shape: this oracle decides polytopes, rounded or not");
  }
};

Outline outline(const Shape<double>& shape) { return std::visit(OutlineOf{}, shape); }

// The vertices of a shape that has an outline.
Points vertices(const Shape<double>& shape);

struct VerticesOf {
  Points operator()(const Segment<double>& s) const { return {exact(s.a, "segment"), exact(s.b, "segment")}; }
  Points operator()(const Triangle<double>& s) const {
    return {exact(s.a, "triangle"), exact(s.b, "triangle"), exact(s.c, "triangle")};
  }
  Points operator()(const Capsule<double>& s) const {
    const Rational h(s.half_height);
    return {{0, 0, -h}, {0, 0, h}};
  }
  Points operator()(const Box<double>& s) const {
    Points corners;
    for (unsigned k = 0; k < 8; ++k) {
      RationalPoint& corner = corners.emplace_back();
      for (unsigned i = 0; i < 3; ++i) {
        const Rational h(s.half_extents[i]);
        corner[i] = (k >> i & 1U) != 0 ? h : Rational(-h);
      }
    }
    return corners;
  }
  Points operator()(const Hull<double>& s) const {
    Points points;
    points.reserve(s.size());
    for (const Vec3<double>& x : s.vertices()) points.push_back(exact(x, "hull"));
    return points;
  }
  Points operator()(const Posed<double>& s) const {
    return pose(vertices(part(s.shape)), s.position, s.orientation);
  }
  Points operator()(const Rounded<double>& s) const { return vertices(part(s.shape)); }
  Points operator()(const Sum<double>& s) const {
    Points all = {{0, 0, 0}};
    for (const SharedShape<double>& shared : s.shapes) {
      const Points one = vertices(part(shared));
      Points next;
      next.reserve(all.size() * one.size());
      for (const RationalPoint& p : all) {
        for (const RationalPoint& q : one) next.push_back(plus(p, q));
      }
      all = std::move(next);
    }
    return all;
  }
  Points operator()(const HullOf<double>& s) const {
    Points all;
    for (const SharedShape<double>& shared : s.shapes) {
      Points one = vertices(part(shared));
      all.insert(all.end(), std::make_move_iterator(one.begin()), std::make_move_iterator(one.end()));
    }
    return all;
  }
  // Point, sphere: the origin. Curved shapes have no outline.
  template <class Round>
  Points operator()(const Round&) const {
    return {{0, 0, 0}};
  }
};

Points vertices(const Shape<double>& shape) { return std::visit(VerticesOf{}, shape); }

}  // namespace

bool is_exact_body(const Shape<double>& shape) {
  try {
    outline(shape);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

ExactBody exact_body(const Body<double>& body) {
  ExactBody result;
  result.radius = outline(body.shape).radius;
  result.vertices = pose(vertices(body.shape), body.position, body.orientation);
  result.displacement = exact(body.displacement, "displacement");
  return result;
}

}  // namespace graze::oracle
