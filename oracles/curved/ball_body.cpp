// Decides exactly: nothing.
// Brackets only: support values, to the working precision. The points that it names are in the shape without
//   condition.
// Costs: 2 to 5 microseconds a leaf at 330 bits, turned. A hull is scanned in double with a proved error
//   bound, and only the vertices within the bound are evaluated in balls.
// Cannot be trusted: it can. If a direction vanishes, the point is some point of the shape, and the value
//   still holds h.
//
// A direction arrives as a ball (the entries of a rotation are rationals that are not dyadic). The value is
// evaluated on the whole ball, so it holds h(n) for the true n. The point is the support point of the ball's
// midpoint.
#include "oracles/curved/ball_body.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "oracles/curved/ball_rotation.hpp"

namespace graze::oracle {
namespace {

double finite(double x, const char* what) {
  if (!std::isfinite(x)) throw std::invalid_argument(std::string(what) + ": not a finite number");
  return x;
}

BallVec finite(const Vec3<double>& x, const char* what) {
  return {finite(x[0], what), finite(x[1], what), finite(x[2], what)};
}

const Quaternion<double>& finite(const Quaternion<double>& q, const char* what) {
  for (const double x : {q.w, q.x, q.y, q.z}) finite(x, what);
  return q;
}

double extent(double x, const char* what) {
  if (finite(x, what) < 0) throw std::invalid_argument(std::string(what) + ": negative");
  return x;
}

Ball signed_extent(const Ball& direction, double half) { return direction.mid_sign() < 0 ? -half : half; }

// The midpoint of the direction, scaled to a unit: a vector along it, or zero.
BallVec unit_or_zero(const BallVec& n) {
  const BallVec d = n.mid();
  const Ball length = norm(d);
  if (!length.is_positive()) return {};
  return {d.x / length, d.y / length, d.z / length};
}

// n.x over the vertices: in double first, relative to vertex 0, then in balls where that leaves it open.
class VertexScan {
 public:
  explicit VertexScan(std::vector<Vec3<double>> vertices) : vertices_(std::move(vertices)) {
    if (vertices_.empty()) throw std::invalid_argument("hull: it has no vertex");
    for (const Vec3<double>& x : vertices_) {
      from_first_.push_back(x - vertices_[0]);
      reach_ = std::max(reach_, from_first_.back().cwiseAbs().maxCoeff());
      points_.emplace_back(x);
    }
  }
  [[nodiscard]] BallSupport support(const BallVec& n) const {
    // The direction times a power of two, rounded to double: an error of u in each coordinate, relative to the
    // largest, 1. The differences have relative error u, and the dot product less than 3.1 u of 3 reach_. The
    // bound 16 u reach_ covers all, twice for the two ends of a comparison. A direction in a ball wider than
    // rounding would void this. Then every vertex is evaluated.
    Vec3<double> d;
    const bool open = !to_double(n, d);
    const double band = 40 * kUnitRoundoff<double> * reach_;
    double best = -std::numeric_limits<double>::infinity();
    for (const Vec3<double>& x : from_first_) best = std::max(best, d.dot(x));
    BallSupport result;
    bool first = true;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!open && d.dot(from_first_[i]) < best - band) continue;
      const Ball value = dot(n, points_[i]);
      const bool further = first || mid_less(result.reach, value);
      if (further) result.point = points_[i];
      result.reach = first ? value : max(result.reach, value);
      first = false;
    }
    return result;
  }

 private:
  static bool to_double(const BallVec& n, Vec3<double>& d) {
    Ball largest = max(max(abs(n.x), abs(n.y)), abs(n.z));
    if (!largest.is_positive() || !largest.is_finite()) return false;
    const slong exponent = arf_abs_bound_lt_2exp_si(arb_midref(largest.get()));
    const std::array<const Ball*, 3> from = {&n.x, &n.y, &n.z};
    for (int i = 0; i < 3; ++i) {
      Ball scaled;
      arb_mul_2exp_si(scaled.get(), from[static_cast<std::size_t>(i)]->get(), -exponent);
      if (mag_cmp_2exp_si(arb_radref(scaled.get()), -60) > 0) return false;
      d[i] = scaled.mid_double();
    }
    return true;
  }

  std::vector<Vec3<double>> vertices_, from_first_;
  std::vector<BallVec> points_;
  double reach_ = 0;
};

}  // namespace

struct BallBody::Node {
  enum class Kind { vertices, ball, box, ellipsoid, cylinder, cone, posed, sum, hull_of } kind = Kind::ball;
  std::optional<VertexScan> vertices;
  double radius = 0, half_height = 0;
  Vec3<double> extents = Vec3<double>::Zero();
  std::optional<BallRotation> rotation;
  BallVec position;
  std::vector<std::unique_ptr<Node>> parts;

  [[nodiscard]] BallSupport support(const BallVec& n) const;
};

namespace {

BallSupport ball_support(const BallVec& n, double radius) {
  return {radius == 0 ? Ball(0) : radius * norm(n), radius == 0 ? BallVec() : radius * unit_or_zero(n)};
}

BallSupport box_support(const BallVec& n, const Vec3<double>& e) {
  return {e[0] * abs(n.x) + e[1] * abs(n.y) + e[2] * abs(n.z),
          {signed_extent(n.x, e[0]), signed_extent(n.y, e[1]), signed_extent(n.z, e[2])}};
}

// h = |M n|, point M M n / |M n|, M = diag(radii).
BallSupport ellipsoid_support(const BallVec& n, const Vec3<double>& r) {
  const BallVec scaled{r[0] * n.x, r[1] * n.y, r[2] * n.z};
  const BallVec unit = unit_or_zero({scaled.x.mid(), scaled.y.mid(), scaled.z.mid()});
  return {norm(scaled), {r[0] * unit.x, r[1] * unit.y, r[2] * unit.z}};
}

BallSupport disk_support(const BallVec& n, double radius, const Ball& height) {
  const BallVec flat{n.x, n.y, 0};
  BallSupport s = ball_support(flat, radius);
  s.point.z = height;
  s.reach += height * n.z;
  return s;
}

BallSupport cone_support(const BallVec& n, double radius, double half_height) {
  BallSupport base = disk_support(n, radius, -half_height);
  const Ball apex = half_height * n.z;
  if (mid_less(base.reach, apex)) base.point = {0, 0, half_height};
  base.reach = max(base.reach, apex);
  return base;
}

}  // namespace

BallSupport BallBody::Node::support(const BallVec& n) const {
  switch (kind) {
    case Kind::vertices:
      return vertices->support(n);
    case Kind::ball:
      return ball_support(n, radius);
    case Kind::box:
      return box_support(n, extents);
    case Kind::ellipsoid:
      return ellipsoid_support(n, extents);
    case Kind::cylinder: {
      BallSupport s = disk_support(n, radius, 0);
      s.point.z = signed_extent(n.z, half_height);
      s.reach += half_height * abs(n.z);
      return s;
    }
    case Kind::cone:
      return cone_support(n, radius, half_height);
    case Kind::posed: {
      const BallSupport s = parts[0]->support(rotation->apply_inverse(n));
      return {s.reach + dot(n, position), rotation->apply(s.point) + position};
    }
    case Kind::sum: {
      BallSupport s = parts[0]->support(n);
      for (std::size_t i = 1; i < parts.size(); ++i) {
        const BallSupport part = parts[i]->support(n);
        s.reach += part.reach;
        s.point = s.point + part.point;
      }
      return s;
    }
    case Kind::hull_of: {
      BallSupport s = parts[0]->support(n);
      for (std::size_t i = 1; i < parts.size(); ++i) {
        const BallSupport part = parts[i]->support(n);
        if (mid_less(s.reach, part.reach)) s.point = part.point;
        s.reach = max(s.reach, part.reach);
      }
      return s;
    }
  }
  return {};
}

// A shape as a node. `magnitude` becomes at least the largest coordinate of the shape, in its own frame.
struct BallBody::Builder {
  using Kind = Node::Kind;
  double magnitude = 0;

  static std::unique_ptr<Node> make(Kind kind) {
    auto node = std::make_unique<Node>();
    node->kind = kind;
    return node;
  }
  std::unique_ptr<Node> vertices(std::vector<Vec3<double>> points) {
    for (const Vec3<double>& x : points) {
      for (int i = 0; i < 3; ++i) magnitude = std::max(magnitude, std::abs(finite(x[i], "vertex")));
    }
    auto node = make(Kind::vertices);
    node->vertices.emplace(std::move(points));
    return node;
  }
  std::unique_ptr<Node> ball(double radius) {
    auto node = make(Kind::ball);
    node->radius = magnitude = extent(radius, "radius");
    return node;
  }
  std::unique_ptr<Node> extents(Kind kind, const Vec3<double>& e, const char* what) {
    auto node = make(kind);
    node->extents = e;
    for (int i = 0; i < 3; ++i) magnitude = std::max(magnitude, extent(e[i], what));
    return node;
  }
  std::unique_ptr<Node> round(Kind kind, double radius, double half_height) {
    auto node = make(kind);
    node->radius = extent(radius, "radius");
    node->half_height = extent(half_height, "half_height");
    magnitude = radius + half_height;
    return node;
  }
  std::unique_ptr<Node> part(const SharedShape<double>& shape) {
    if (!shape) throw std::invalid_argument("a combinator has a part without a shape");
    Builder inner;
    auto node = std::visit(inner, shape->shape);
    magnitude = std::max(magnitude, inner.magnitude);
    return node;
  }
  std::unique_ptr<Node> parts(Kind kind, const std::vector<SharedShape<double>>& shapes) {
    if (shapes.empty()) throw std::invalid_argument("a combinator has no part");
    auto node = make(kind);
    double total = 0;
    for (const SharedShape<double>& shape : shapes) {
      magnitude = 0;
      node->parts.push_back(part(shape));
      total = kind == Kind::sum ? total + magnitude : std::max(total, magnitude);
    }
    magnitude = total;
    return node;
  }
  std::unique_ptr<Node> pose(std::unique_ptr<Node> child, const Vec3<double>& position,
                             const Quaternion<double>& orientation) {
    auto node = make(Kind::posed);
    node->position = finite(position, "position");
    node->rotation.emplace(finite(orientation, "orientation"));
    node->parts.push_back(std::move(child));
    magnitude = 2 * magnitude + position.cwiseAbs().maxCoeff();
    return node;
  }

  std::unique_ptr<Node> operator()(const Point<double>&) { return ball(0); }
  std::unique_ptr<Node> operator()(const Segment<double>& s) { return vertices({s.a, s.b}); }
  std::unique_ptr<Node> operator()(const Triangle<double>& s) { return vertices({s.a, s.b, s.c}); }
  std::unique_ptr<Node> operator()(const Sphere<double>& s) { return ball(s.radius); }
  std::unique_ptr<Node> operator()(const Capsule<double>& s) {
    auto node = make(Kind::sum);
    node->parts.push_back(ball(s.radius));
    const double h = extent(s.half_height, "half_height");
    node->parts.push_back(vertices({Vec3<double>(0, 0, -h), Vec3<double>(0, 0, h)}));
    magnitude = s.radius + h;
    return node;
  }
  std::unique_ptr<Node> operator()(const Box<double>& s) {
    return extents(Kind::box, s.half_extents, "half_extents");
  }
  std::unique_ptr<Node> operator()(const Ellipsoid<double>& s) {
    return extents(Kind::ellipsoid, s.radii, "radii");
  }
  std::unique_ptr<Node> operator()(const Cylinder<double>& s) {
    return round(Kind::cylinder, s.radius, s.half_height);
  }
  std::unique_ptr<Node> operator()(const Cone<double>& s) {
    return round(Kind::cone, s.radius, s.half_height);
  }
  std::unique_ptr<Node> operator()(const Hull<double>& s) {
    return vertices({s.vertices().begin(), s.vertices().end()});
  }
  std::unique_ptr<Node> operator()(const Posed<double>& s) {
    return pose(part(s.shape), s.position, s.orientation);
  }
  std::unique_ptr<Node> operator()(const Rounded<double>& s) {
    auto node = make(Kind::sum);
    node->parts.push_back(part(s.shape));
    const double inner = magnitude;
    node->parts.push_back(ball(s.radius));
    magnitude = inner + s.radius;
    return node;
  }
  std::unique_ptr<Node> operator()(const Sum<double>& s) { return parts(Kind::sum, s.shapes); }
  std::unique_ptr<Node> operator()(const HullOf<double>& s) { return parts(Kind::hull_of, s.shapes); }
};

BallBody::BallBody(const Body<double>& body)
    : position_(finite(body.position, "position")), displacement_(finite(body.displacement, "displacement")) {
  Builder builder;
  auto shape = std::visit(builder, body.shape);
  root_ = builder.pose(std::move(shape), Vec3<double>::Zero(), body.orientation);
  magnitude_ = builder.magnitude;
}

BallBody::~BallBody() = default;
BallBody::BallBody(BallBody&&) noexcept = default;
BallBody& BallBody::operator=(BallBody&&) noexcept = default;
BallSupport BallBody::support(const BallVec& n) const { return root_->support(n); }

}  // namespace graze::oracle
