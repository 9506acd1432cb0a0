// Decides exactly: outcome, TOI, its two neighbouring doubles and every comparison with it, for the pairs of
//   the header.
// Brackets only: nothing.
// Costs: 0.2 milliseconds.
// Cannot be trusted: for other pairs, which it refuses. It measures no depth and no distance.
//
// Notation   x(t) = c0 + t w is the path of one body's reference point in a frame in which the other rests.
//   The set to be met is a union of pieces. Each piece of its boundary gives  a t^2 - 2 b t + c = 0  and
//   linear side conditions alpha + beta t >= 0. Their sign at a root mid +- sqrt(square) is decided in
//   rationals. Every root that passes is a time of contact, and the first contact is among them.
#include "oracles/truth/closed_form.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "oracles/arithmetic/default_environment.hpp"
#include "oracles/truth/unbounded.hpp"
namespace graze::oracle {
namespace {

Rational exact(double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("a number is not finite");
  return Rational(x);
}

Rational extent(double x) {
  if (x < 0) throw std::invalid_argument("a radius or an extent is negative");
  return exact(x);
}

RationalPoint exact(const Vec3<double>& x) { return {exact(x[0]), exact(x[1]), exact(x[2])}; }

RationalPoint operator+(const RationalPoint& l, const RationalPoint& r) {
  return {l[0] + r[0], l[1] + r[1], l[2] + r[2]};
}
RationalPoint operator-(const RationalPoint& l, const RationalPoint& r) {
  return {l[0] - r[0], l[1] - r[1], l[2] - r[2]};
}
RationalPoint operator*(const Rational& s, const RationalPoint& r) { return {s * r[0], s * r[1], s * r[2]}; }
Rational dot(const RationalPoint& l, const RationalPoint& r) {
  return l[0] * r[0] + l[1] * r[1] + l[2] * r[2];
}
RationalPoint cross(const RationalPoint& l, const RationalPoint& r) {
  return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}

// The images of the axes under x -> q x conj(q) / |q|^2: e_i + 2 (w (u x e_i) + u x (u x e_i)) / |q|^2.
std::array<RationalPoint, 3> axes_of(const Quaternion<double>& q) {
  const Rational w = exact(q.w);
  const RationalPoint u = {exact(q.x), exact(q.y), exact(q.z)};
  const Rational norm_sq = w * w + dot(u, u);
  if (sgn(norm_sq) == 0) throw std::invalid_argument("orientation: the zero quaternion is not a rotation");
  std::array<RationalPoint, 3> axes;
  for (std::size_t i = 0; i < 3; ++i) {
    RationalPoint e;
    e[i] = 1;
    const RationalPoint ue = cross(u, e);
    axes[i] = e + (2 / norm_sq) * (w * ue + cross(u, ue));
  }
  return axes;
}

struct Linear {
  Rational alpha, beta;  // alpha + beta t >= 0
};

// The set on the path: its times of contact, and whether it is in contact at t = 0.
class Path {
 public:
  Path(RationalPoint from, RationalPoint velocity, double t_max)
      : c0_(std::move(from)), w_(std::move(velocity)), bounded_(!std::isinf(t_max)) {
    if (bounded_) horizon_ = Rational(t_max);
  }
  std::vector<QuadraticRoot> times;
  bool overlapping = false;
  // How far inside of each bound of a solid, above 0 inside: d_0 + d_1 t + d_2 t^2.
  std::vector<std::array<Rational, 3>> depths;

  // Of an overlapping start in a solid: is it inside soon after, or all the time if it rests? If it is ever inside, as the
  // solid is convex.
  [[nodiscard]] bool goes_in() const {
    return std::all_of(depths.begin(), depths.end(), [](const std::array<Rational, 3>& d) {
      const auto first = std::find_if(d.begin(), d.end(), [](const Rational& x) { return sgn(x) != 0; });
      return first != d.end() && sgn(*first) > 0;
    });
  }
  void quadric(const Rational& a, const Rational& b, const Rational& c,
               const std::vector<Linear>& conditions) {
    depths.push_back({-c, 2 * b, -a});
    for (const Linear& l : conditions) depths.push_back({l.alpha, l.beta, 0});
    add(a, b, c, conditions);
  }
  [[nodiscard]] const RationalPoint& start() const { return c0_; }
  [[nodiscard]] const RationalPoint& velocity() const { return w_; }
  [[nodiscard]] Linear along(const RationalPoint& n, const Rational& constant) const {
    return {dot(n, c0_) + constant, dot(n, w_)};
  }

  void add(const Rational& a, const Rational& b, const Rational& c, const std::vector<Linear>& conditions) {
    if (sgn(a) == 0) {
      if (sgn(b) != 0) keep({c / (2 * b), 0, 0}, conditions);
      return;
    }
    const Rational square = (b * b - a * c) / (a * a);
    if (sgn(square) < 0) return;
    keep({b / a, square, -1}, conditions);
    keep({b / a, square, 1}, conditions);
  }
  // The distance of x(t) from p is r.
  void sphere(const RationalPoint& p, const Rational& r) {
    const RationalPoint d = c0_ - p;
    const Rational c = dot(d, d) - r * r;
    if (sgn(c) <= 0) overlapping = true;
    add(dot(w_, w_), -dot(d, w_), c, {});
  }
  // Around the segment from p to p + e.
  void tube(const RationalPoint& p, const RationalPoint& e, const Rational& r) {
    const Rational length_sq = dot(e, e);
    const RationalPoint d = cross(c0_ - p, e), rate = cross(w_, e);
    const Linear after = along(e, -dot(e, p)), before = {length_sq - after.alpha, -after.beta};
    const Rational c = dot(d, d) - r * r * length_sq;
    if (sgn(c) <= 0 && sgn(after.alpha) >= 0 && sgn(before.alpha) >= 0) overlapping = true;
    add(dot(rate, rate), -dot(d, rate), c, {after, before});
  }
  // On either side of the parallelogram p + s e + u f. Flat ones are left to their edges.
  void plate(const RationalPoint& p, const RationalPoint& e, const RationalPoint& f, const Rational& r) {
    const RationalPoint n = cross(e, f);
    const Rational n_sq = dot(n, n);
    if (sgn(n_sq) == 0) return;
    const RationalPoint fn = cross(f, n), ne = cross(n, e);  // s = fn.x / |n|^2, u = ne.x / |n|^2
    const Linear height = along(n, -dot(n, p)), s = along(fn, -dot(fn, p)), u = along(ne, -dot(ne, p));
    const std::vector<Linear> inside = {s, {n_sq - s.alpha, -s.beta}, u, {n_sq - u.alpha, -u.beta}};
    const Rational c = height.alpha * height.alpha - r * r * n_sq;
    const bool above =
        std::all_of(inside.begin(), inside.end(), [](const Linear& l) { return sgn(l.alpha) >= 0; });
    if (sgn(c) <= 0 && above) overlapping = true;
    add(height.beta * height.beta, -height.alpha * height.beta, c, inside);
  }
  // The times with alpha + beta t = 0 and |x|^2 + |y|^2 <= r^2 for the coordinates 0 and 1.
  void disk(const Linear& height, const Rational& r) {
    if (sgn(height.beta) == 0) return;
    const Rational t = -height.alpha / height.beta, x = c0_[0] + t * w_[0], y = c0_[1] + t * w_[1];
    if (x * x + y * y <= r * r) keep({t, 0, 0}, {});
  }

 private:
  void keep(const QuadraticRoot& root, const std::vector<Linear>& conditions) {
    if (root.sign_of(0, 1) < 0 || (bounded_ && root.sign_of(horizon_, -1) < 0)) return;
    for (const Linear& l : conditions) {
      if (root.sign_of(l.alpha, l.beta) < 0) return;
    }
    times.push_back(root);
  }

  RationalPoint c0_, w_;
  bool bounded_;
  Rational horizon_;
};

// p, p + e, rounded by radius. For a point e = 0.
struct RoundedSegment {
  RationalPoint p, e;
  Rational radius;
};

std::optional<RoundedSegment> rounded_segment(const Body<double>& body) {
  const std::array<RationalPoint, 3> axes = axes_of(body.orientation);
  const RationalPoint position = exact(body.position);
  const auto world = [&](const RationalPoint& x) {
    return position + (x[0] * axes[0] + x[1] * axes[1] + x[2] * axes[2]);
  };
  if (std::holds_alternative<Point<double>>(body.shape)) return RoundedSegment{position, {}, 0};
  if (const auto* s = std::get_if<Sphere<double>>(&body.shape)) {
    return RoundedSegment{position, {}, extent(s->radius)};
  }
  if (const auto* s = std::get_if<Segment<double>>(&body.shape)) {
    const RationalPoint a = world(exact(s->a)), b = world(exact(s->b));
    return RoundedSegment{a, b - a, 0};
  }
  if (const auto* s = std::get_if<Capsule<double>>(&body.shape)) {
    const Rational h = extent(s->half_height);
    return RoundedSegment{position - h * axes[2], 2 * h * axes[2], extent(s->radius)};
  }
  return {};
}

bool is_zero(const RationalPoint& x) { return sgn(x[0]) == 0 && sgn(x[1]) == 0 && sgn(x[2]) == 0; }

// The core of A - B is the parallelogram p_A - p_B + s e_A - u e_B.
void meet_segments(Path& path, const RoundedSegment& a, const RoundedSegment& b, const Rational& target) {
  const Rational r = a.radius + b.radius + target;
  const RationalPoint corner = a.p - b.p, f = Rational(-1) * b.e;
  for (const RationalPoint& p : {corner, corner + a.e, corner + f, corner + a.e + f}) path.sphere(p, r);
  if (!is_zero(a.e)) {
    path.tube(corner, a.e, r);
    path.tube(corner + f, a.e, r);
  }
  if (!is_zero(f)) {
    path.tube(corner, f, r);
    path.tube(corner + a.e, f, r);
  }
  path.plate(corner, a.e, f, r);
}

// The path is in the box's own frame.
void meet_box(Path& path, const std::array<Rational, 3>& half, const Rational& r) {
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) inside = inside && abs(path.start()[i]) <= half[i];
  if (inside) path.overlapping = true;
  std::array<RationalPoint, 8> corner;
  std::array<RationalPoint, 3> edge;
  for (std::size_t k = 0; k < 8; ++k) {
    for (std::size_t i = 0; i < 3; ++i) corner[k][i] = (k >> i & 1U) != 0 ? half[i] : Rational(-half[i]);
    path.sphere(corner[k], r);
  }
  for (std::size_t i = 0; i < 3; ++i) edge[i][i] = 2 * half[i];
  for (std::size_t k = 0; k < 8; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((k >> i & 1U) != 0) continue;
      if (sgn(half[i]) > 0) path.tube(corner[k], edge[i], r);
      if ((k >> j & 1U) == 0) path.plate(corner[k], edge[i], edge[j], r);
    }
  }
}

// sum (x_i / r_i)^2 = 1, times the product of the radii squared.
void meet_ellipsoid(Path& path, const std::array<Rational, 3>& r) {
  Rational a, b, c = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational weight = 1 / (r[i] * r[i]);
    a += weight * path.velocity()[i] * path.velocity()[i];
    b -= weight * path.velocity()[i] * path.start()[i];
    c += weight * path.start()[i] * path.start()[i];
  }
  if (sgn(c) <= 0) path.overlapping = true;
  path.quadric(a, b, c, {});
}

void meet_cylinder(Path& path, const Rational& radius, const Rational& half) {
  const RationalPoint &x = path.start(), &w = path.velocity();
  const Linear above = {half + x[2], w[2]}, below = {half - x[2], -w[2]};
  const Rational c = x[0] * x[0] + x[1] * x[1] - radius * radius;
  if (sgn(c) <= 0 && sgn(above.alpha) >= 0 && sgn(below.alpha) >= 0) path.overlapping = true;
  path.quadric(w[0] * w[0] + w[1] * w[1], -(w[0] * x[0] + w[1] * x[1]), c, {above, below});
  path.disk(above, radius);
  path.disk(below, radius);
}

// 4 half^2 (x^2 + y^2) = radius^2 (half - z)^2 for |z| <= half. Without height it is a disk.
void meet_cone(Path& path, const Rational& radius, const Rational& half) {
  if (sgn(half) == 0) return meet_cylinder(path, radius, half);
  const RationalPoint &x = path.start(), &w = path.velocity();
  const Linear above = {half + x[2], w[2]}, below = {half - x[2], -w[2]};
  const Rational k = 4 * half * half, r_sq = radius * radius;
  const Rational c = k * (x[0] * x[0] + x[1] * x[1]) - r_sq * below.alpha * below.alpha;
  if (sgn(above.alpha) >= 0 && sgn(below.alpha) >= 0 && sgn(c) <= 0) path.overlapping = true;
  path.quadric(k * (w[0] * w[0] + w[1] * w[1]) - r_sq * w[2] * w[2],
               -(k * (w[0] * x[0] + w[1] * x[1]) + r_sq * below.alpha * w[2]), c, {above, below});
  path.disk(below, 0);  // the apex, met along a generator
  path.disk(above, radius);
}

bool meet_curved(Path& path, const Shape<double>& shape, const Rational& r) {
  if (const auto* s = std::get_if<Box<double>>(&shape)) {
    meet_box(path, {extent(s->half_extents[0]), extent(s->half_extents[1]), extent(s->half_extents[2])}, r);
    return true;
  }
  if (sgn(r) > 0) return false;
  if (const auto* s = std::get_if<Ellipsoid<double>>(&shape)) {
    const std::array<Rational, 3> radii = {extent(s->radii[0]), extent(s->radii[1]), extent(s->radii[2])};
    if (sgn(radii[0]) == 0 || sgn(radii[1]) == 0 || sgn(radii[2]) == 0) return false;
    meet_ellipsoid(path, radii);
    return true;
  }
  if (const auto* s = std::get_if<Cylinder<double>>(&shape)) {
    meet_cylinder(path, extent(s->radius), extent(s->half_height));
    return true;
  }
  if (const auto* s = std::get_if<Cone<double>>(&shape)) {
    meet_cone(path, extent(s->radius), extent(s->half_height));
    return true;
  }
  return false;
}

// The path of the ball's centre in the frame of the other body.
Path in_frame_of(const Body<double>& frame, const Body<double>& ball, double t_max) {
  const std::array<RationalPoint, 3> axes = axes_of(frame.orientation);
  const auto local = [&](const RationalPoint& x) {
    return RationalPoint{dot(axes[0], x), dot(axes[1], x), dot(axes[2], x)};
  };
  return {local(exact(ball.position) - exact(frame.position)),
          local(exact(ball.displacement) - exact(frame.displacement)), t_max};
}

std::optional<Path> path_of(const corpus::Case& problem) {
  const auto a = rounded_segment(problem.a), b = rounded_segment(problem.b);
  const Rational target = extent(problem.target_distance);
  if (a && b) {
    Path path({}, exact(problem.b.displacement) - exact(problem.a.displacement), problem.t_max);
    meet_segments(path, *a, *b, target);
    return path;
  }
  if (!a && !b) return {};
  const RoundedSegment& ball = a ? *a : *b;
  const Body<double>&moving = a ? problem.a : problem.b, &frame = a ? problem.b : problem.a;
  if (!is_zero(ball.e) || std::holds_alternative<Segment<double>>(moving.shape)) return {};
  Path path = in_frame_of(frame, moving, problem.t_max);
  if (!meet_curved(path, frame.shape, ball.radius + target)) return {};
  return path;
}

// The root itself, where it is rational.
std::optional<Rational> rational_value(const QuadraticRoot& root) {
  if (root.side == 0) return root.mid;
  if (mpz_perfect_square_p(root.square.get_num_mpz_t()) == 0 ||
      mpz_perfect_square_p(root.square.get_den_mpz_t()) == 0) {
    return {};
  }
  return root.mid + root.side * fraction(sqrt(root.square.get_num()), sqrt(root.square.get_den()));
}

Enclosure enclose(const QuadraticRoot& root) {
  if (const auto value = rational_value(root)) return graze::oracle::enclose(*value);
  if (sgn(root.mid) >= 0) return enclose_radius_and_sqrt(root.mid, root.side, root.square);
  const Enclosure negative = enclose_radius_and_sqrt(-root.mid, -root.side, root.square);
  return {-negative.high, -negative.low};
}

}  // namespace

// (alpha + beta mid) + side beta sqrt(square): the sign of p + q sqrt(s) is that of the larger of p^2, q^2 s.
int QuadraticRoot::sign_of(const Rational& alpha, const Rational& beta) const {
  const Rational p = alpha + beta * mid;
  const int sign_q = side * sgn(beta) * sgn(square);
  if (sign_q == 0 || sgn(p) == sign_q) return sgn(p) != 0 ? sgn(p) : sign_q;
  const int larger = cmp(p * p, beta * beta * square);
  return larger > 0 ? sgn(p) : (larger < 0 ? sign_q : 0);
}

std::optional<ClosedForm> ClosedForm::of(const corpus::Case& problem) {
  const DefaultEnvironment environment;
  if (!problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0)) return {};
  if (!(problem.t_max >= 0)) throw std::invalid_argument("t_max: it is below 0 or NaN");
  const auto path = path_of(problem);
  if (!path) return {};
  ClosedForm form;
  if (path->overlapping) {
    if (problem.start_policy == corpus::StartPolicy::pass_over) {
      if (path->depths.empty()) return {};
      form.lower_ = form.upper_ = kInf;
      if (!path->goes_in()) return form;
      form.lower_ = form.upper_ = 0;
    }
    form.outcome_ = Outcome::initially_overlapping;
    form.exact_ = "0";
    form.times_.push_back({0, 0, 0});
    return form;
  }
  form.times_ = path->times;
  form.lower_ = form.upper_ = kInf;
  if (form.times_.empty()) return form;
  form.outcome_ = Outcome::hit;
  for (const QuadraticRoot& root : form.times_) {
    const Enclosure time = enclose(root);
    form.lower_ = std::min(form.lower_, time.low);
    form.upper_ = std::min(form.upper_, time.high);
  }
  for (const QuadraticRoot& root : form.times_) {
    const auto value = rational_value(root);
    if (value && form.compare(*value) == 0) form.exact_ = value->get_str();
  }
  return form;
}

int ClosedForm::compare(const Rational& t) const {
  int order = -1;
  for (const QuadraticRoot& root : times_) order = std::max(order, root.sign_of(t, -1));
  return order;
}

}  // namespace graze::oracle
