// The quadratic by which pairs of doubles bracket a round contact (search/exact/round_proof.hpp), beside the same polynomial
// in exact numbers.
#include <gtest/gtest.h>

#include <graze/detail/search/exact/round_proof.hpp>

#include "tests/bounds/bound_tally.hpp"
#include "tests/bounds/bound_truth.hpp"

namespace graze::test {
namespace {

using detail::exact::Dyadic;
using detail::exact::Dyadic3;
using detail::exact::Term;
using oracle::WorkingPrecision;

struct Passage {
  Body<double> a, b;
  double target = 0;
};

// A core with a ball, often small beside it, on its way to a box or a hull.
Passage draw_passage(HostileDraw& draw) {
  Passage out;
  const auto extent = [&] { return draw.chance(0.3) ? draw.power(-30, 0) : draw.plain().between(0.5, 2); };
  const auto vector = [&](double length) { return draw.plain().vector<double>(length); };
  const auto orientation = [&] {
    if (draw.chance(0.3)) return Quaternion<double>{};
    if (draw.chance(0.6)) return draw.plain().turn<double>();
    const auto whole = [&] { return double(draw.below(5)) - 2; };
    return Quaternion<double>{3, whole(), whole(), whole()};
  };
  const double ball = draw.chance(0.6) ? draw.power(-45, 0) : draw.plain().between(0.1, 2);
  switch (draw.below(4)) {
    case 0:
      out.a.shape = Sphere<double>{ball};
      break;
    case 1:
      out.a.shape = Capsule<double>{ball, extent()};
      break;
    case 2:
      out.a.shape = graze::rounded<double>(Box<double>{{extent(), extent(), extent()}}, ball);
      break;
    default:
      out.a.shape = Point<double>{};
      out.target = ball;
      break;
  }
  switch (draw.below(3)) {
    case 0:
      out.b.shape = Box<double>{{extent(), extent(), extent()}};
      break;
    case 1:
      out.b.shape = Triangle<double>{vector(2), vector(2), vector(2)};
      break;
    default:
      out.b.shape = Hull<double>({vector(1), vector(1), vector(1), vector(1), vector(1), vector(1)});
      break;
  }
  out.a.orientation = orientation();
  out.b.orientation = orientation();
  const double far = draw.chance(0.6) ? 8 : draw.power(0, 20);
  out.a.position = vector(draw.chance(0.7) ? 1 : far);
  out.b.position = out.a.position + vector(far);
  out.b.displacement = 2 * (out.a.position + vector(1) - out.b.position);
  return out;
}

// q at s, for the corners and the motion in exact numbers, the scene's units.
Ball true_value(const detail::exact::Scene<double>& scene, std::span<const detail::exact::Vertex> corners,
                const Dyadic& radius, double s) {
  std::vector<Dyadic3> c;
  Dyadic weight(1);
  for (const detail::exact::Vertex& corner : corners) {
    const detail::exact::Exact x = scene.exact(Term::point(corner));
    c.push_back(x.x);
    if (x.weighted) weight = x.weight;
  }
  const auto ball = [](const Dyadic3& x) { return BallVec{exactly(x[0]), exactly(x[1]), exactly(x[2])}; };
  const Ball w = exactly(weight), reach = exactly(radius) * w;
  const BallVec first = ball(c[0]), z = (Ball(s) * w) * ball(scene.exact(Term::motion()).x) - first;
  if (c.size() == 1) return dot(z, z) - reach * reach;
  const BallVec e = ball(c[1]) - first;
  if (c.size() == 2) {
    const BallVec across = cross(z, e);
    return dot(across, across) - reach * reach * dot(e, e);
  }
  const BallVec n = cross(e, ball(c[2]) - first);
  const Ball height = dot(z, n);
  return height * height - reach * reach * dot(n, n);
}

template <bool kFused>
void check_values(const char* name) {
  const WorkingPrecision precision(16000);
  HostileDraw draw(221);
  Tally here(std::string(name) + ", q at s"), beside(std::string(name) + ", q at a neighbour of s");
  for (int i = 0; i < rounds(4000); ++i) {
    const Passage pair = draw_passage(draw);
    const detail::PreparedPair<double> prepared(pair.a, pair.b, pair.target);
    Counters counters;
    detail::RoundWalk<double> walk(prepared, kInfinity<double>, 0, detail::kRoundSteps, counters);
    const detail::RoundSweep& found = walk.run();
    if (found.outcome != Outcome::hit) continue;
    const detail::exact::Scene<double> scene(pair.a, pair.b, prepared.length_exponent(),
                                             prepared.speed_exponent());
    detail::exact::RoundProver<double, kFused> prover(prepared, scene,
                                                      CastOptions<double>{.target_distance = pair.target});
    if (!prover.take(walk, found)) continue;
    const Dyadic radius = Dyadic(scene.unit()) *
                          (Dyadic(prepared.radius_a()) + Dyadic(prepared.radius_b()) + Dyadic(pair.target));
    const double s = found.upper, next = std::nextafter(s, draw.chance(0.5) ? 0.0 : kInfinity<double>);
    const auto with = [&] {
      std::ostringstream out;
      out << std::hexfloat << "  " << prover.corners().size() << " corners, shapes " << pair.a.shape.index()
          << " and " << pair.b.shape.index() << ", radius " << exactly(radius).mid_double() << ", s " << s
          << "\n";
      return out.str();
    };
    const auto value = prover.at(s);
    here.add(value.error + 0x1p-53 * std::abs(value.value),
             abs(Ball(value.value) - true_value(scene, prover.corners(), radius, s)), with);
    double error = 0;
    const double after = value.after(next - s, error);
    beside.add(error, abs(Ball(after) - true_value(scene, prover.corners(), radius, next)), with);
  }
  here.finish(1500);
  beside.finish(1500);
}
TEST(RoundProofBounds, ValuesBySplitProducts) { check_values<false>("round contact by split products"); }
TEST(RoundProofBounds, ValuesByFusedProducts) { check_values<true>("round contact by fused products"); }

}  // namespace
}  // namespace graze::test
