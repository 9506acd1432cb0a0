#include "bench/rotating_scenes.hpp"

#include <Eigen/Geometry>
#include <graze/rotating_cast.hpp>
#include <numbers>

#include "corpus/random.hpp"

namespace graze::bench {
namespace {

using corpus::Random;

Vec3<double> direction(Random& random) {
  while (true) {
    Vec3<double> x;
    for (int i = 0; i < 3; ++i) x[i] = random.uniform(-1, 1);
    if (x.norm() > 0.1 && x.norm() < 1) return x.normalized();
  }
}
Vec3<double> within(Random& random, double reach) {
  Vec3<double> x;
  for (int i = 0; i < 3; ++i) x[i] = random.uniform(-reach, reach);
  return x;
}
double size(Random& random) { return random.uniform(0.5, 1); }
Vec3<double> sizes(Random& random) {
  const double x = size(random), y = size(random), z = size(random);
  return {x, y, z};
}
Eigen::Quaterniond orientation(Random& random) {
  const Vec3<double> axis = direction(random);
  return Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(0, 2 * std::numbers::pi), axis));
}
Quaternion<double> plain(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

Hull<double> hull_of_16(Random& random) {
  const Vec3<double> radii = sizes(random);
  std::vector<Vec3<double>> points;
  for (int i = 0; i < 16; ++i) points.push_back(radii.cwiseProduct(direction(random)));
  return Hull<double>(std::span<const Vec3<double>>(points));
}

// Every one shows its turn.
Shape<double> solid(Random& random) {
  switch (random.below(6)) {
    case 0:
    case 1:
      return Box<double>{sizes(random)};
    case 2:
    case 3:
      return hull_of_16(random);
    case 4: {
      const double radius = size(random), half_height = size(random);
      return Cone<double>{radius, half_height};
    }
    default: {
      const Vec3<double> half = sizes(random);
      return rounded<double>(Box<double>{half}, size(random) / 4);
    }
  }
}

// Bodies that are apart at t = 0 and do not rotate. B passes A's centre at about t = 1/2, at a distance that is drawn
// between the two. The centres are apart by about `apart` at first.
MovingBodies passing(Random& random, Shape<double> a, Shape<double> b, double apart, double nearest,
                     double farthest) {
  MovingBodies out;
  out.a.body.shape = std::move(a);
  out.b.body.shape = std::move(b);
  out.a.body.position = within(random, 1);
  out.a.body.orientation = plain(orientation(random));
  out.b.body.orientation = plain(orientation(random));
  const Vec3<double> along = direction(random), across = direction(random),
                     aside = along.cross(across).normalized();
  const double beside = random.uniform(nearest, farthest), half_way = random.uniform(0.3, 0.7);
  out.a.body.displacement = within(random, 1);
  out.b.body.displacement = out.a.body.displacement + along * (apart / half_way);
  out.b.body.position = out.a.body.position - along * apart + aside * beside;
  return out;
}
void turn(Random& random, RotatingBody<double>& body, double least, double most) {
  const double angle = random.uniform(least, most);
  body.rotation = angle * direction(random);
  body.pivot = within(random, 0.5);
}

Outcome outcome_of(const MovingBodies& pair) {
  return cast(pair.a, pair.b, {.tier = Tier::certified, .request = Request::verdict}).outcome;
}
// Draws until the outcome is wanted.
template <class Make>
std::vector<MovingBodies> drawn(std::size_t pairs, Random& random, const Make& make,
                                std::initializer_list<Outcome> wanted = {Outcome::hit, Outcome::miss}) {
  std::vector<MovingBodies> out;
  while (out.size() < pairs) {
    MovingBodies pair = make(random);
    if (std::ranges::find(wanted, outcome_of(pair)) != wanted.end()) out.push_back(std::move(pair));
  }
  return out;
}

MovingBodies passing_solids(Random& random, double apart, double nearest, double farthest) {
  Shape<double> a = solid(random), b = solid(random);
  return passing(random, std::move(a), std::move(b), apart, nearest, farthest);
}

MovingBodies at_rest(Random& random) {
  MovingBodies out = passing_solids(random, 2.5, 0, 1);
  out.b.body.displacement = out.a.body.displacement;
  return out;
}
MovingBodies linear(Random& random) { return passing_solids(random, 4, 0, 2.5); }

// Their bounds meet: only the rotation can be spared.
constexpr double kNear = 1.25;
MovingBodies spinning_sphere(Random& random) {
  const double radius = size(random);
  MovingBodies out = passing(random, Sphere<double>{radius}, solid(random), 4, 0, kNear);
  const double angle = random.uniform(1, 9);
  out.a.rotation = angle * direction(random);
  return out;
}
MovingBodies about_own_axis(Random& random, bool tilted) {
  const double radius = size(random), half_height = size(random), angle = random.uniform(1, 9);
  Shape<double> wheel = random.once_in(2) ? Shape<double>(Cylinder<double>{radius, half_height})
                                          : Shape<double>(Capsule<double>{radius, half_height});
  MovingBodies out = passing(random, std::move(wheel), solid(random), 4, 0, kNear);
  if (!tilted) out.a.body.orientation = {};
  const Quaternion<double>& q = out.a.body.orientation;
  out.a.rotation = angle * (Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Vec3<double>::UnitZ());
  return out;
}
MovingBodies far_apart(Random& random) {
  MovingBodies out = passing_solids(random, 12, 0, 4);
  out.b.body.displacement = out.a.body.displacement + within(random, 2);
  turn(random, out.a, 1, 9);
  turn(random, out.b, 1, 9);
  return out;
}
MovingBodies as_one(Random& random) {
  MovingBodies out = at_rest(random);
  const Vec3<double> axis = direction(random);
  out.a.rotation = out.b.rotation = random.uniform(1, 9) * axis;
  out.b.body.position = out.a.body.position + 1.5 * axis;
  return out;
}
MovingBodies turning(Random& random, double beside, double least, double most) {
  MovingBodies out = passing_solids(random, 4, 0, beside);
  turn(random, out.a, least, most);
  turn(random, out.b, least, most);
  return out;
}
MovingBodies ordinary(Random& random) { return turning(random, 2.5, 0.5, 2); }

// A body that spins about the z axis through its origin. No point of it is farther from the origin than `reach`.
struct Spinner {
  Shape<double> shape;
  double reach = 0;
};
Spinner spinner(Random& random) {
  switch (random.below(4)) {
    case 0: {
      Hull<double> hull = hull_of_16(random);
      double reach = 0;
      for (const Vec3<double>& x : hull.vertices()) {
        reach = std::max(reach, (x + hull.center()).head<2>().norm());
      }
      return {std::move(hull), reach};
    }
    case 1: {
      // z to x.
      const double radius = size(random) / 4, half_height = size(random);
      return {posed<double>(Capsule<double>{radius, half_height}, Vec3<double>::Zero(), {1, 0, 1, 0}),
              half_height + radius};
    }
    default: {
      const Vec3<double> half = sizes(random);
      return {Box<double>{half}, half.head<2>().norm()};
    }
  }
}

// The spinner makes a full turn and a little more beside a wall or a ball. The obstacle is `clearance` away from the
// spinner's reach. If that is below 0, the spinner reaches in and touches there. The whole pair is rotated.
MovingBodies spinning_past(Random& random, double clearance) {
  Spinner spins = spinner(random);
  MovingBodies out;
  const double delta = clearance * spins.reach, height = random.uniform(-0.1, 0.1);
  const Eigen::Quaterniond whole = orientation(random);
  out.a.body.shape = std::move(spins.shape);
  out.a.body.orientation =
      plain(whole * Eigen::AngleAxisd(random.uniform(0, 2 * std::numbers::pi), Vec3<double>::UnitZ()));
  out.a.rotation = whole * Vec3<double>(0, 0, random.uniform(1, 1.2) * 2 * std::numbers::pi);
  Vec3<double> place(spins.reach + delta, height, 0);
  const double thick = size(random);
  out.b.body.shape = Box<double>{{thick, 4, 4}};
  place[0] += thick;
  out.b.body.position = whole * place;
  out.b.body.orientation = plain(whole);
  out.contact = delta < 0;
  return out;
}

// A thin body that crosses another in a fraction of the step while both rotate.
MovingBodies shot(Random& random) {
  Vec3<double> half = sizes(random);
  half[0] /= 16;
  MovingBodies out = passing(random, Box<double>{half}, solid(random), 64, 0, 1);
  turn(random, out.a, 0.5, 6);
  turn(random, out.b, 0.5, 6);
  out.contact = true;
  return out;
}
// In contact for about 2^-k of the step: the point at radius r, rotating by w, is deeper than a plane at r - d for 2
// sqrt(2 d / r) / w.
MovingBodies comes_and_goes(Random& random) {
  if (random.once_in(2)) return shot(random);
  const double part = power_of_two(-random.integer(5, 10));
  return spinning_past(random, -5 * part * part);
}

}  // namespace

std::vector<Scene> scenes_of_the_plan(std::size_t pairs) {
  Random random(501);
  const auto upright = [](Random& r) { return about_own_axis(r, false); };
  const auto tilted = [](Random& r) { return about_own_axis(r, true); };
  const auto slow = [](Random& r) { return turning(r, kNear, 1e-8, 1e-7); };
  return {
      {"static", drawn(pairs, random, at_rest)},
      {"linear", drawn(pairs, random, linear)},
      {"spinning sphere", drawn(pairs, random, spinning_sphere)},
      {"spinning about own axis", drawn(pairs, random, upright)},
      {"the same, in any orientation", drawn(pairs, random, tilted)},
      {"far apart", drawn(pairs, random, far_apart)},
      {"moving as one", drawn(pairs, random, as_one)},
      {"slow spin, tolerance 1e-6", drawn(pairs, random, slow), 1e-6},
      {"truly rotating", drawn(pairs, random, ordinary)},
  };
}

std::vector<Scene> scenes_of_requests(std::size_t pairs) {
  Random random(502);
  return {
      {"linear hits", drawn(pairs, random, linear, {Outcome::hit})},
      {"rotating hits", drawn(pairs, random, ordinary, {Outcome::hit})},
      {"rotating misses", drawn(pairs, random, ordinary, {Outcome::miss})},
  };
}

std::vector<Scene> scenes_of_methods(std::size_t pairs) {
  Random random(503);
  std::vector<Scene> out = {{"ordinary hits", drawn(pairs, random, ordinary, {Outcome::hit})}};
  for (const int k : {10, 20, 30}) {
    Scene graze{"spins past at 2^-" + std::to_string(k), {}};
    for (std::size_t i = 0; i < pairs; ++i) {
      // One in four reaches in.
      graze.pairs.push_back(spinning_past(random, power_of_two(-k) * (i % 4 == 3 ? -1 : 1)));
    }
    out.push_back(std::move(graze));
  }
  for (const int k : {4, 8, 10}) {
    const double most = power_of_two(k);
    const auto fast = [&](Random& r) {
      MovingBodies pair = passing_solids(r, 4, 0.5, 2.5);
      turn(r, pair.a, most / 2, most);
      turn(r, pair.b, 0.5, 2);
      return pair;
    };
    out.push_back({"fast spin, 2^" + std::to_string(k) + " rad", drawn(pairs, random, fast)});
  }
  out.push_back({"enters and leaves", drawn(pairs, random, comes_and_goes, {Outcome::hit})});
  return out;
}

}  // namespace graze::bench
