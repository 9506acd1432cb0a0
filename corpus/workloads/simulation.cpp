#include "corpus/workloads/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "corpus/support_value.hpp"

namespace graze::corpus {
namespace {

// A lowest point of the shape, in world axes from the body's origin. For a round shape it uses the shape's
// support function alone: x and y are those of its middle.
Vec3<double> lowest_point(const Member& one) {
  const auto lower = [&](const Vec3<double>& best, const Vec3<double>& x) {
    const Vec3<double> turned = rotate(one.orientation, x);
    return turned[2] < best[2] ? turned : best;
  };
  Vec3<double> best(0, 0, kInfinity<double>);
  if (const auto* box = std::get_if<Box<double>>(&one.shape)) {
    const Vec3<double>& h = box->half_extents;
    for (int k = 0; k < 8; ++k) {
      best = lower(best, Vec3<double>((k & 1) != 0 ? h[0] : -h[0], (k & 2) != 0 ? h[1] : -h[1],
                                      (k & 4) != 0 ? h[2] : -h[2]));
    }
    return best;
  }
  if (const auto* hull = std::get_if<Hull<double>>(&one.shape)) {
    for (const Vec3<double>& x : hull->vertices()) best = lower(best, x);
    return best;
  }
  if (const auto* capsule = std::get_if<Capsule<double>>(&one.shape)) {
    for (const double z : {-capsule->half_height, capsule->half_height})
      best = lower(best, Vec3<double>(0, 0, z));
    best[2] -= capsule->radius;
    return best;
  }
  return {0, 0, bounds(one.shape, one.orientation).low[2]};
}

double reach_about_pivot(const Member& one) { return bounding_radius(one.shape) + length(one.pivot); }

Quaternion<double> turned_on(const Quaternion<double>& q, const Vec3<double>& spin) {
  const Quaternion<double> change = multiply({0, spin[0], spin[1], spin[2]}, q);
  const double half = 0.5 * kStep;
  const Quaternion<double> next(q.w + half * change.w, q.x + half * change.x, q.y + half * change.y,
                                q.z + half * change.z);
  const double n = std::sqrt(((next.w * next.w + next.x * next.x) + next.y * next.y) + next.z * next.z);
  return {next.w / n, next.x / n, next.y / n, next.z / n};
}

struct Box3 {
  Vec3<double> low, high;
};

// All that the body may come to in a step.
Box3 swept_bounds(const Member& one) {
  const Bounds now = bounds(one.shape, one.orientation);
  const double turn = kStep * length(one.spin) * reach_about_pivot(one);
  Box3 out;
  for (int i = 0; i < 3; ++i) {
    const double way = std::abs(kStep * one.velocity[i]) + turn;
    out.low[i] = one.position[i] + now.low[i] - way;
    out.high[i] = one.position[i] + now.high[i] + way;
  }
  return out;
}

bool meet(const Box3& a, const Box3& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
  }
  return true;
}

}  // namespace

double dot(const Vec3<double>& l, const Vec3<double>& r) { return (l[0] * r[0] + l[1] * r[1]) + l[2] * r[2]; }
Vec3<double> cross(const Vec3<double>& l, const Vec3<double>& r) {
  return {l[1] * r[2] - l[2] * r[1], l[2] * r[0] - l[0] * r[2], l[0] * r[1] - l[1] * r[0]};
}
double length(const Vec3<double>& x) { return std::sqrt(dot(x, x)); }

Quaternion<double> turn_to(double c, double s) {
  if (c < -0.5) return {std::abs(s), 0, 0, s < 0 ? c - 1 : 1 - c};
  return {1 + c, 0, 0, s};
}

Simulation::Simulation(Draw& draw, const Vec3<double>& place) : draw_(draw), place_(place) {
  Random& random = draw.random;
  constexpr double kSkins[] = {0, 0, 1e-6, 1e-4, 1e-3, -1e-5};
  skin = kSkins[random.below(std::size(kSkins))];
  in_seconds_ = random.once_in(4);
  policy_ = random.once_in(2) ? StartPolicy::pass_over : StartPolicy::report;
}

void Simulation::accelerate() {
  for (Member& one : members) {
    if (one.falls) one.velocity[2] -= kGravity * kStep;
  }
}

void Simulation::meet_floor(Member& one) const {
  const Vec3<double> arm = lowest_point(one);
  const double deep = (one.floor + skin) - (one.position[2] + arm[2]);
  if (!(deep > 0)) return;
  one.position[2] += deep;
  const Vec3<double> speed = one.velocity + cross(one.spin, arm);
  if (speed[2] >= 0) return;
  // A ball's moment of inertia, 2/5 m r^2: the mass cancels.
  const double radius = bounding_radius(one.shape), lightness = 2.5 / (radius * radius);
  const auto push = [&](const Vec3<double>& impulse) {
    one.velocity += impulse;
    one.spin += lightness * cross(arm, impulse);
  };
  const double side = arm[0] * arm[0] + arm[1] * arm[1];
  // A body that comes down slowly does not bounce.
  const double restitution = speed[2] < -0.5 ? bounce : 0;
  const double normal = -(1 + restitution) * speed[2] / (1 + lightness * side);
  push(Vec3<double>(0, 0, normal));
  const double sliding = std::sqrt(speed[0] * speed[0] + speed[1] * speed[1]);
  if (sliding > 0) {
    const double rub = std::min(friction * normal, sliding / (1 + lightness * arm[2] * arm[2])) / sliding;
    push(Vec3<double>(-rub * speed[0], -rub * speed[1], 0));
  }
  if (restitution == 0) one.spin *= 0.96;
}

void Simulation::move() {
  for (Member& one : members) {
    if (!one.moves) continue;
    const Vec3<double> pivot = one.position + rotate(one.orientation, one.pivot);
    if (length(one.spin) > 0) one.orientation = turned_on(one.orientation, one.spin);
    one.position = (pivot + kStep * one.velocity) - rotate(one.orientation, one.pivot);
    if (one.falls) meet_floor(one);
    one.position = draw_.real(one.position);
    one.velocity = draw_.real(one.velocity);
    one.spin = draw_.real(one.spin);
    Quaternion<double>& q = one.orientation;
    q = {draw_.real(q.w), draw_.real(q.x), draw_.real(q.y), draw_.real(q.z)};
  }
}

std::vector<Case> Simulation::questions() const {
  std::vector<Case> out;
  std::vector<Box3> swept;
  swept.reserve(members.size());
  for (const Member& one : members) swept.push_back(swept_bounds(one));
  const auto ask = [&](const Member& one, Body<double>& body, Spin& spin) {
    const double unit = in_seconds_ ? 1 : kStep;
    body.shape = one.shape;
    body.orientation = one.orientation;
    for (int i = 0; i < 3; ++i) {
      // No -0.
      body.position[i] = draw_.real(0 + (place_[i] + one.position[i]));
      body.displacement[i] = draw_.real(0 + (one.moves ? unit * one.velocity[i] : 0));
      spin.rotation[i] = draw_.real(0 + (one.moves ? unit * one.spin[i] : 0));
    }
    spin.pivot = one.pivot;
  };
  for (std::size_t i = 0; i < members.size(); ++i) {
    for (std::size_t j = i + 1; j < members.size(); ++j) {
      const Member &a = members[i], &b = members[j];
      if (!a.moves && !b.moves) continue;
      if (a.group != 0 && a.group == b.group) continue;
      if (!meet(swept[i], swept[j])) continue;
      Case& problem = out.emplace_back();
      ask(a, problem.a, problem.spin_a);
      ask(b, problem.b, problem.spin_b);
      if (in_seconds_) problem.t_max = draw_.real(kStep);
      problem.start_policy = policy_;
    }
  }
  return out;
}

}  // namespace graze::corpus
