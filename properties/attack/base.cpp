#include "properties/attack/base.hpp"

#include <array>
#include <cmath>

#include "corpus/families/draw.hpp"
#include "corpus/families/turning.hpp"
#include "engines/method.hpp"
#include "properties/attack/mutant.hpp"
#include "properties/edit/case.hpp"
#include "properties/generate/case.hpp"
#include "properties/generate/rotating.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/rotating/question.hpp"

namespace graze::attack {

using corpus::Case;
using corpus::ProofRecord;
using corpus::Random;
using corpus::Spin;

namespace {

// As long a chain is cheap to check again and again.
constexpr std::size_t kMostSlices = 96;
// Radians over the step, of the laws' cases: what the oracle takes grows with them.
constexpr double kMostAngle = 64;

double eighths(Random& random, int least, int most) { return random.integer(least, most) / 8.0; }

Shape<double> small_shape(Random& random) {
  const auto extent = [&] { return eighths(random, 1, 16); };
  if (random.once_in(4)) return written_otherwise(Sphere<double>{extent()}, random);
  switch (random.below(8)) {
    case 0:
    case 1:
      return Box<double>{{extent(), extent(), extent()}};
    case 2:
      return Box<double>{{2, 0.125, 0.125}};
    case 3:
      return Point<double>{};
    case 4:
      return Segment<double>{{-extent(), 0, 0}, {extent(), extent(), 0}};
    case 5:
      return Capsule<double>{extent() / 4, extent()};
    case 6: {
      std::vector<Vec3<double>> vertices;
      vertices.reserve(5);
      for (int k = 0; k < 5; ++k)
        vertices.push_back({eighths(random, -16, 16), eighths(random, -16, 16), eighths(random, -16, 16)});
      return with_adjacency<double>(vertices);
    }
    default:
      return written_otherwise(Box<double>{{extent(), extent(), extent()}}, random);
  }
}

Vec3<double> some_direction(Random& random) {
  if (!random.once_in(3)) return (random.once_in(2) ? 1 : -1) * Vec3<double>::Unit(random.integer(0, 2));
  Vec3<double> n;
  do {
    for (int i = 0; i < 3; ++i) n[i] = random.integer(-3, 3);
  } while (n.isZero(0));
  return n / n.norm();
}

Vec3<double> some_pivot(Random& random) {
  Vec3<double> pivot;
  const int reach = std::array{0, 0, 4, 8, 64}[random.below(5)];
  for (int i = 0; i < 3; ++i) pivot[i] = random.integer(-reach, reach);
  return pivot;
}

double some_angle(Random& random) {
  switch (random.below(4)) {
    case 0:
      return random.integer(1, 8);
    case 1:
      return random.uniform(0.125, 8);
    default:
      return 2 * corpus::kPi * random.integer(1, 3);
  }
}

// B beside, or in, what A sweeps about its axis.
Case sweep(Random& random) {
  Case problem;
  problem.a.shape = small_shape(random);
  problem.b.shape = small_shape(random);
  for (Vec3<double>* x : {&problem.a.position, &problem.b.position})
    for (int i = 0; i < 3; ++i) (*x)[i] = random.integer(-4, 4);
  const Vec3<double> axis = some_direction(random);
  problem.spin_a = {some_angle(random) * axis, some_pivot(random)};
  if (random.once_in(3)) {
    problem.a.orientation = {
        static_cast<double>(random.integer(1, 3)), static_cast<double>(random.integer(-3, 3)),
        static_cast<double>(random.integer(-3, 3)), static_cast<double>(random.integer(-3, 3))};
  }
  const int manner = random.integer(0, 3);
  if (manner == 1) {
    for (int i = 0; i < 3; ++i) problem.b.displacement[i] = eighths(random, -16, 16);
  } else if (manner == 2) {
    problem.spin_b = {
        random.once_in(3) ? problem.spin_a.rotation : some_angle(random) * some_direction(random),
        some_pivot(random)};
  }
  if (manner != 2 && random.once_in(2)) problem.spin_b.pivot = some_pivot(random);
  // At some angle about A's axis, at the reach of A's middle, more or less by about their sizes.
  const Vec3<double> arm = corpus::rotate(problem.a.orientation, problem.spin_a.pivot);
  Vec3<double> out = arm - arm.dot(axis) * axis;
  const double reach = out.norm();
  Vec3<double> across = some_direction(random);
  across -= across.dot(axis) * axis;
  if (across.norm() < 0.5) return problem;
  const double sizes = corpus::bounding_radius(problem.a.shape) + corpus::bounding_radius(problem.b.shape);
  const double beside_it = sizes * random.uniform(-0.25, 1.5) * (random.once_in(4) ? -1 : 1);
  problem.b.position = problem.a.position + arm + (reach + beside_it) * across.normalized() -
                       arm.dot(axis) * axis + eighths(random, -4, 4) * axis;
  return problem;
}

Case turning_case(Random& random) {
  Case problem = random.once_in(4) ? law::draw_rotating(random, random.integer(0, 12)) : sweep(random);
  problem.start_policy = StartPolicy::report;
  if (!std::isfinite(problem.t_max)) problem.t_max = 1;
  if (random.once_in(6)) problem.target_distance = std::scalbn(1.0, -random.integer(1, 12));
  return problem;
}

double angle_of(const Case& problem) {
  return (problem.spin_a.rotation.norm() + problem.spin_b.rotation.norm()) * problem.t_max;
}

Tier tier_of(std::string_view name) {
  return name == "exact" ? Tier::exact : name == "certified" ? Tier::certified : Tier::standard;
}

}  // namespace

Case draw_case(Random& random) {
  Case problem = random.once_in(2) ? turning_case(random) : law::draw_case(random, random.integer(0, 16));
  problem.id = "attack";
  problem.query = corpus::Query::cast;
  return problem;
}

std::optional<ProofRecord> proved(const Case& problem, Random& random) {
  ProofRecord record;
  record.problem = problem;
  record.scalar = "double";
  if (law::has_spin(problem)) {
    if (!law::is_rotating_question(problem) || angle_of(problem) > kMostAngle) return std::nullopt;
    const char* const name = std::array{"certified", "certified", "bilateral", "ca"}[random.below(4)];
    engine::Answer answer =
        engine::find_method(engine::Kind::rotating, name)->ask(problem, {.request = Request::proof});
    if (!answer.rotating_proof || answer.rotating_proof->chain.size() > kMostSlices) return std::nullopt;
    record.method = name;
    record.outcome = answer.outcome;
    record.tier = tier_of(engine::find_method(engine::Kind::rotating, name)->tier);
    record.toi = {answer.toi_lower, answer.toi_upper};
    record.rotating = std::move(answer.rotating_proof);
    return record;
  }
  if (!law::is_linear_question(problem)) return std::nullopt;
  const char* const name = std::array{"certified", "exact", "mpr", "gjk", "ca"}[random.below(5)];
  const engine::Answer answer =
      engine::find_method(engine::Kind::linear, name)->ask(problem, {.request = Request::proof});
  if (!answer.proof) return std::nullopt;
  record.method = name;
  record.outcome = answer.outcome;
  record.tier = tier_of(engine::find_method(engine::Kind::linear, name)->tier);
  record.toi = {answer.toi_lower, answer.toi_upper};
  record.proof = *answer.proof;
  return record;
}

}  // namespace graze::attack
