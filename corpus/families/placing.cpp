#include "corpus/families/placing.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace graze::corpus {

std::vector<Vec3<double>> corners(const Shape<double>& shape) {
  if (const auto* segment = std::get_if<Segment<double>>(&shape)) return {segment->a, segment->b};
  if (const auto* triangle = std::get_if<Triangle<double>>(&shape)) {
    return {triangle->a, triangle->b, triangle->c};
  }
  if (const auto* hull = std::get_if<Hull<double>>(&shape)) {
    return {hull->vertices().begin(), hull->vertices().end()};
  }
  if (const auto* box = std::get_if<Box<double>>(&shape)) {
    const Vec3<double> h = box->half_extents;
    std::vector<Vec3<double>> list;
    list.reserve(8);
    for (int k = 0; k < 8; ++k) {
      list.emplace_back((k & 1) != 0 ? h[0] : -h[0], (k & 2) != 0 ? h[1] : -h[1],
                        (k & 4) != 0 ? h[2] : -h[2]);
    }
    return list;
  }
  return {Vec3<double>::Zero()};
}

void meet(Draw& draw, Case& problem, const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& beside,
          const Vec3<double>& v, double t) {
  for (int i = 0; i < 3; ++i) {
    const double x = ((problem.a.position[i] + (a[i] - b[i])) - t * v[i]) + beside[i];
    problem.b.position[i] = draw.real(x);
  }
  set_motion(draw, problem, v);
}

double meeting_time(Random& random) {
  constexpr double kTimes[] = {0, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 2};
  return kTimes[random.below(std::size(kTimes))];
}

void draw_horizon(Random& random, Case& problem) {
  switch (random.below(16)) {
    case 0:
      problem.t_max = kInfinity<double>;
      break;
    case 1:
      problem.t_max = 0.5;
      break;
    case 2:
      problem.t_max = 4;
      break;
    default:
      break;
  }
}

double small_unit(const Draw& draw, double k) {
  const double unit = power_of_ten(-static_cast<int>(k));
  return draw.coordinates == Coordinates::floats ? round_to_float(unit) : unit;
}

void turn_by_half_turn(Draw& draw, Case& problem) {
  const Quaternion<double> turns[] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  const Quaternion<double>& q = turns[draw.random.below(4)];
  for (Body<double>* body : {&problem.a, &problem.b}) {
    body->orientation = multiply(q, body->orientation);
    body->position = rotate(q, body->position);
    body->displacement = rotate(q, body->displacement);
  }
}

Vec3<double> rotate_scaled(const Quaternion<double>& q, const Vec3<double>& x) {
  const Vec3<double> r(q.x, q.y, q.z);
  const Vec3<double> twice = 2 * q.w * r.cross(x);
  return ((q.w * q.w - r.dot(r)) * x + twice) + 2 * r.dot(x) * r;
}

IntegerPassage draw_passage(Random& random, const Vec3<double>& n) {
  Vec3<double> along;
  for (int i = 0; i < 3; ++i) along[i] = random.integer(-2, 2);
  Vec3<double> v = n.cross(along);
  double t0 = std::scalbn(1.0, -random.integer(0, 2));
  switch (random.below(8)) {
    case 0:
      t0 = 0;
      break;
    case 1:
      t0 = 0;
      v += random.integer(1, 2) * n;
      break;
    case 2:
      t0 = 0;
      v = Vec3<double>::Zero();
      break;
    case 3:
    case 4:
      v -= random.integer(1, 2) * n;
      break;
    default:
      break;
  }
  return {4 * v, t0};
}

}  // namespace graze::corpus
