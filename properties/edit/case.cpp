#include "properties/edit/case.hpp"

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cmath>

#include "corpus/support_value.hpp"

namespace graze::law {

using corpus::Case;

bool has_spin(const Case& problem) {
  // Written so that a NaN counts.
  for (const corpus::Spin* spin : {&problem.spin_a, &problem.spin_b}) {
    for (const Vec3<double>* given : {&spin->rotation, &spin->pivot}) {
      if (!(*given == Vec3<double>::Zero())) return true;
    }
  }
  return false;
}

std::vector<double> scalars(const Case& problem) {
  std::vector<double> all;
  visit_scalars(problem, [&](Slot, double x) { all.push_back(x); });
  return all;
}

bool in_domain(const Case& problem) { return why_invalid(problem).empty(); }

bool is_polytope(const Case& problem) {
  return problem.target_distance == 0 && is_polytope(problem.a.shape) && is_polytope(problem.b.shape);
}

// The fused error term is exact unless it falls below the subnormals. The second test excludes that.
std::optional<double> exact_product(double a, double b) {
  const double p = a * b;
  if (!std::isfinite(p) || std::fma(a, b, -p) != 0) return std::nullopt;
  if (p != 0 ? std::abs(p) < 1e-290 : (a != 0 && b != 0)) return std::nullopt;
  return p;
}

Vec3<double> velocity(const Case& problem) { return problem.b.displacement - problem.a.displacement; }

Case swapped(const Case& problem) {
  Case other = problem;
  std::swap(other.a, other.b);
  std::swap(other.spin_a, other.spin_b);
  other.expect.reset();
  return other;
}

std::optional<Case> scaled(const Case& problem, int k) {
  bool exact = true;
  Case other = map_scalars(problem, [&](Slot slot, double x) {
    if (!is_length(slot)) return x;
    const double y = std::scalbn(x, k);
    exact = exact && std::scalbn(y, -k) == x;
    return y;
  });
  other.expect.reset();
  if (!exact || !in_domain(other)) return std::nullopt;
  return other;
}

std::optional<Case> translated(const Case& problem, std::uint64_t salt) {
  // Large first: a common offset must cost no accuracy. The last ones fit cases whose positions are full
  // doubles.
  const double pool[] = {0x1p30, -0x1p24, 1048576, -65536, 4096, -1000, 37, -3, 1, 0.5, -0.125};
  constexpr std::size_t kPool = std::size(pool);
  Case other = problem;
  bool moved = false;
  for (int i = 0; i < 3; ++i) {
    const std::uint64_t pick = mix(salt + static_cast<std::uint64_t>(i));
    double &a = other.a.position[i], &b = other.b.position[i];
    const double tail[] = {-a, -b};
    for (std::size_t j = 0; j < kPool + 2; ++j) {
      const double shift = j < kPool ? pool[(j + pick % 5) % kPool] : tail[j - kPool];
      const auto to_a = exact_sum(a, shift), to_b = exact_sum(b, shift);
      if (shift == 0 || !to_a || !to_b) continue;
      a = *to_a;
      b = *to_b;
      moved = true;
      break;
    }
  }
  other.expect.reset();
  if (!moved || !in_domain(other)) return std::nullopt;
  return other;
}

Case grown(const Case& problem, std::uint64_t salt) {
  Case other = problem;
  other.expect.reset();
  const std::uint64_t pick = mix(salt ^ 0x67726f77u);
  Body<double>& body = pick & 1 ? other.a : other.b;
  body.shape = grown(body.shape, pick);
  return other;
}

std::optional<Case> ray_against_cso(const Case& problem) {
  if (!is_polytope(problem)) return std::nullopt;
  const auto sign_a = signs_of(problem.a.orientation), sign_b = signs_of(problem.b.orientation);
  // At most 400 differences: the law is about the identity, not about speed.
  constexpr std::size_t kMost = 400;
  const auto local_a = exact_vertices(problem.a.shape, kMost),
             local_b = exact_vertices(problem.b.shape, kMost);
  if (!sign_a || !sign_b || !local_a || !local_b || local_a->size() * local_b->size() > kMost) {
    return std::nullopt;
  }
  std::vector<Vec3<double>> differences;
  for (const Vec3<double>& local : *local_a) {
    const auto a = exact_sum(problem.a.position, Vec3<double>(sign_a->cwiseProduct(local)));
    if (!a) return std::nullopt;
    for (const Vec3<double>& other : *local_b) {
      const auto b = exact_sum(problem.b.position, Vec3<double>(sign_b->cwiseProduct(other)));
      if (!b) return std::nullopt;
      const auto c = exact_sum(*a, Vec3<double>(-*b));
      if (!c) return std::nullopt;
      differences.push_back(*c);
    }
  }
  const auto v = exact_sum(problem.b.displacement, Vec3<double>(-problem.a.displacement));
  if (!v) return std::nullopt;
  Case ray = problem;
  ray.expect.reset();
  ray.a = Body<double>{};
  ray.b = Body<double>{};
  ray.a.shape = Hull<double>(std::span<const Vec3<double>>(differences));
  ray.b.displacement = *v;
  if (!in_domain(ray)) return std::nullopt;
  return ray;
}

std::optional<Split> split(const Case& problem, std::uint64_t salt) {
  const double horizon = std::isinf(problem.t_max) ? 2 : problem.t_max;
  const double fractions[] = {0.5, 0.25, 0.75, 0.125, 0.875};
  const std::uint64_t first = mix(salt ^ 0x73706c69u);
  for (std::size_t j = 0; j < std::size(fractions); ++j) {
    const double fraction = fractions[(j + first) % std::size(fractions)];
    const auto s = exact_product(fraction, horizon);
    if (!s || !(*s > 0)) continue;
    const auto rest =
        std::isinf(problem.t_max) ? std::optional(problem.t_max) : exact_sum(problem.t_max, -*s);
    if (!rest) continue;
    Split parts{*s, problem, problem};
    parts.before.expect.reset();
    parts.after.expect.reset();
    parts.before.t_max = *s;
    parts.after.t_max = *rest;
    bool exact = true;
    for (Body<double>* body : {&parts.after.a, &parts.after.b}) {
      for (int i = 0; i < 3 && exact; ++i) {
        const auto step = exact_product(*s, body->displacement[i]);
        const auto there = step ? exact_sum(body->position[i], *step) : std::nullopt;
        exact = there.has_value();
        if (exact) body->position[i] = *there;
      }
    }
    if (exact && in_domain(parts.after)) return parts;
  }
  return std::nullopt;
}

namespace {

// p q, if no component rounds.
std::optional<Quaternion<double>> exact_multiple(const Quaternion<double>& p, const Quaternion<double>& q) {
  const auto sum = [](std::array<double, 4> terms) -> std::optional<double> {
    double out = 0;
    for (const double term : terms) {
      const auto next = exact_sum(out, term);
      if (!next) return std::nullopt;
      out = *next;
    }
    return out;
  };
  // Components of p are 0, 1 or -1, so the products are exact.
  const auto w = sum({p.w * q.w, -p.x * q.x, -p.y * q.y, -p.z * q.z}),
             x = sum({p.w * q.x, p.x * q.w, p.y * q.z, -p.z * q.y}),
             y = sum({p.w * q.y, -p.x * q.z, p.y * q.w, p.z * q.x}),
             z = sum({p.w * q.z, p.x * q.y, -p.y * q.x, p.z * q.w});
  if (!w || !x || !y || !z) return std::nullopt;
  return Quaternion<double>{*w, *x, *y, *z};
}

// q x conj(q) / |q|^2, for the q below exactly.
Vec3<double> permuted(const Quaternion<double>& q, const Vec3<double>& x) {
  const Vec3<double> r(q.x, q.y, q.z);
  const double norm_sq = q.w * q.w + r.squaredNorm();
  // Each row has one entry, 1 or -1. It is computed on the axes, so that no sum of coordinates is rounded.
  Vec3<double> out = Vec3<double>::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3<double> e = Vec3<double>::Unit(i);
    const Vec3<double> image = e + 2 * (q.w * r.cross(e) + r.cross(r.cross(e))) / norm_sq;
    for (int j = 0; j < 3; ++j) {
      if (image[j] != 0) out[j] = image[j] * x[i];
    }
  }
  return out;
}

}  // namespace

std::optional<Case> turned_about(const Case& problem, std::uint64_t salt) {
  // Quarter turns, thirds, and half turns, which never round.
  constexpr std::array<Quaternion<double>, 8> kTurns = {{{1, 1, 0, 0},
                                                         {1, 0, -1, 0},
                                                         {1, 0, 0, 1},
                                                         {1, 1, 1, 1},
                                                         {1, -1, 1, 1},
                                                         {0, 1, 0, 0},
                                                         {0, 0, 1, 0},
                                                         {0, 0, 0, 1}}};
  for (std::size_t j = 0; j < kTurns.size(); ++j) {
    const Quaternion<double>& p = kTurns[(j + mix(salt)) % kTurns.size()];
    Case other = problem;
    bool exact = true;
    for (Body<double>* body : {&other.a, &other.b}) {
      const auto q = exact_multiple(p, body->orientation);
      exact = exact && q.has_value();
      if (!exact) break;
      body->orientation = *q;
      body->position = permuted(p, body->position);
      body->displacement = permuted(p, body->displacement);
    }
    if (!exact) continue;
    other.spin_a.rotation = permuted(p, problem.spin_a.rotation);
    other.spin_b.rotation = permuted(p, problem.spin_b.rotation);
    other.expect.reset();
    if (in_domain(other)) return other;
  }
  return std::nullopt;
}

namespace {

// The mirror image of a rotation in the frame of a shape: M R(q) M = R(w, x, -y, -z) for M = diag(-1, 1, 1).
Quaternion<double> mirrored(const Quaternion<double>& q) { return {q.w, q.x, -q.y, -q.z}; }
Vec3<double> mirrored(const Vec3<double>& x) { return {-x[0], x[1], x[2]}; }

Shape<double> mirrored(const Shape<double>& shape) {
  std::vector<SharedShape<double>> parts = parts_of(shape);
  if (!parts.empty()) {
    for (SharedShape<double>& part : parts) {
      if (part) part = share(mirrored(part->shape));
    }
    Shape<double> out = with_parts(shape, std::move(parts));
    if (auto* posed = std::get_if<Posed<double>>(&out)) {
      posed->position = mirrored(posed->position);
      posed->orientation = mirrored(posed->orientation);
    }
    return out;
  }
  // Vertices come as x, y, z. The solids are their own images.
  int at = 0;
  auto flip = [&](Slot slot, double x) { return slot == Slot::vertex && at++ % 3 == 0 ? -x : x; };
  return map_shape(shape, flip);
}

}  // namespace

Case mirrored(const Case& problem) {
  Case other = problem;
  for (Body<double>* body : {&other.a, &other.b}) {
    body->shape = mirrored(body->shape);
    body->position = mirrored(body->position);
    body->displacement = mirrored(body->displacement);
    body->orientation = mirrored(body->orientation);
  }
  for (corpus::Spin* spin : {&other.spin_a, &other.spin_b}) {
    spin->pivot = mirrored(spin->pivot);
    spin->rotation = -mirrored(spin->rotation);  // an axis of rotation is a pseudovector
  }
  other.expect.reset();
  return other;
}

std::optional<Case> stretched(const Case& problem, int k) {
  bool exact = true;
  Case other = map_scalars(problem, [&](Slot slot, double x) {
    const bool velocity = slot == Slot::displacement || slot == Slot::rotation;
    if (!velocity && slot != Slot::horizon) return x;
    const int power = velocity ? -k : k;
    const double y = std::scalbn(x, power);
    exact = exact && std::scalbn(y, -power) == x;
    return y;
  });
  other.expect.reset();
  if (!exact || !in_domain(other)) return std::nullopt;
  return other;
}

Case without_turns(const Case& problem) {
  Case other = problem;
  other.spin_a = other.spin_b = {};
  other.expect.reset();
  return other;
}

namespace {

// The axis of revolution in the shape's own frame: 0, 1 or 2, 3 for a ball, -1 for none.
int own_axis(const Shape<double>& shape) {
  if (std::holds_alternative<Sphere<double>>(shape) || std::holds_alternative<Point<double>>(shape)) return 3;
  if (std::holds_alternative<Capsule<double>>(shape) || std::holds_alternative<Cylinder<double>>(shape) ||
      std::holds_alternative<Cone<double>>(shape))
    return 2;
  if (const auto* ellipsoid = std::get_if<Ellipsoid<double>>(&shape)) {
    const Vec3<double>& r = ellipsoid->radii;
    if (r[0] == r[1] && r[1] == r[2]) return 3;
    for (int i = 0; i < 3; ++i) {
      if (r[(i + 1) % 3] == r[(i + 2) % 3]) return i;
    }
  }
  return -1;
}

}  // namespace

std::optional<Case> with_unseen_turn(const Case& problem, bool first, std::uint64_t salt) {
  Case other = problem;
  other.expect.reset();
  const Body<double>& body = first ? problem.a : problem.b;
  corpus::Spin& spin = first ? other.spin_a : other.spin_b;
  const int axis = own_axis(body.shape);
  const auto signs = signs_of(body.orientation);
  const std::uint64_t pick = mix(salt ^ 0x756e7365u);
  constexpr double kAngles[] = {1, -3, 0.125, 6.5, -20, 513};
  const double angle = kAngles[pick % std::size(kAngles)] / (problem.t_max > 1 ? 64 : 1);
  if (axis < 0) return std::nullopt;
  if (axis == 3 && ((pick & 64) != 0 || !signs)) {
    // Any axis, through the centre.
    spin = {Vec3<double>(angle, angle / 2, -angle / 4), Vec3<double>::Zero()};
  } else {
    if (!signs) return std::nullopt;
    // A pivot anywhere on the axis.
    const int i = axis == 3 ? static_cast<int>(pick >> 8 & 3) % 3 : axis;
    spin = {};
    spin.rotation[i] = (*signs)[i] * angle;
    if ((pick & 128) != 0) spin.pivot[i] = 2.5;
  }
  if (!in_domain(other)) return std::nullopt;
  return other;
}

std::optional<Case> moved_as_one(const Case& problem) {
  Case other = problem;
  other.expect.reset();
  const auto sign_a = signs_of(problem.a.orientation), sign_b = signs_of(problem.b.orientation);
  if (!sign_a || !sign_b) return std::nullopt;
  const auto center = exact_sum(problem.a.position, Vec3<double>(sign_a->cwiseProduct(problem.spin_a.pivot)));
  if (!center) return std::nullopt;
  const auto arm = exact_sum(*center, Vec3<double>(-problem.b.position));
  if (!arm) return std::nullopt;
  other.spin_b.rotation = problem.spin_a.rotation;
  other.spin_b.pivot = sign_b->cwiseProduct(*arm);
  other.b.displacement = problem.a.displacement;
  if (!in_domain(other)) return std::nullopt;
  return other;
}

// Errors: the half angle is |w| s/2 within 4 u of itself, sine and cosine within another u, the product of the
// quaternions 8 u. A point at the arm r from the pivot moves by twice the error of the unit quaternion, 2 r (4 u |w| s
// + 12 u). The pivot is rotated twice, in 16 u each, and sums add 8 u of the lengths in them.
std::optional<Restart> restarted(const Case& problem, double fraction) {
  const auto s = exact_product(fraction, problem.t_max);
  if (!s || !(*s > 0)) return std::nullopt;
  const auto rest = exact_sum(problem.t_max, -*s);
  if (!rest) return std::nullopt;
  constexpr double u = kUnitRoundoff<double>;
  Restart out{*s, 0, problem};
  out.after.expect.reset();
  out.after.t_max = *rest;
  const auto move = [&](Body<double>& body, const corpus::Spin& spin) {
    const Vec3<double> r(body.orientation.x, body.orientation.y, body.orientation.z);
    const double w = body.orientation.w, norm_sq = w * w + r.squaredNorm();
    const auto turn = [](double scalar, const Vec3<double>& v, const Vec3<double>& x) {
      return Vec3<double>(x + 2 * (scalar * v.cross(x) + v.cross(v.cross(x))));
    };
    const Vec3<double> arm = turn(w / std::sqrt(norm_sq), r / std::sqrt(norm_sq), spin.pivot);
    const double rate = spin.rotation.norm(), half = rate * *s / 2;
    const Vec3<double> axis = rate > 0 ? Vec3<double>(spin.rotation / rate) : Vec3<double>::Zero();
    const double c = std::cos(half);
    const Vec3<double> v = std::sin(half) * axis;
    const corpus::Bounds box = corpus::bounds(body.shape);
    const double reach = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).norm() + spin.pivot.norm();
    const Vec3<double> step = *s * body.displacement;
    out.error += 2 * reach * u * (4 * rate * *s + 12) + 32 * u * spin.pivot.norm() +
                 8 * u * (body.position.norm() + spin.pivot.norm() + step.norm());
    // x - pivot rotates, and the origin of the body is at -arm from it.
    body.position = (body.position + step) + (arm - turn(c, v, arm));
    if (rate > 0) {
      const Vec3<double> both = c * r + w * v + v.cross(r);
      body.orientation = {c * w - v.dot(r), both[0], both[1], both[2]};
    }
  };
  move(out.after.a, problem.spin_a);
  move(out.after.b, problem.spin_b);
  // At s. From there the error of the arm rotates on and that of the pivot does not: three times as much.
  out.error *= 3;
  if (!in_domain(out.after)) return std::nullopt;
  return out;
}

std::uint64_t hash_of(const Case& problem) {
  std::uint64_t h = 0;
  for (const Body<double>* body : {&problem.a, &problem.b}) {
    for (const std::uint32_t word : outline(body->shape)) h = mix(h ^ word);
  }
  for (const double x : scalars(problem)) h = mix(h ^ std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x));
  return h;
}

}  // namespace graze::law
