// The cost of checking a full proof: an axis with its tightest lower bound, and a three-point portal with its tightest
// upper one. The bodies are two hulls of 8 to 16 vertices, and every other kind against such a hull, in identity and
// rotated poses, with 256 random cases each. Symbolic axes are checked on the same cases. One is the exact normal of
// the facet of C through which the path enters, whose bound is the time of impact itself. The other is n = v x edge,
// which proves a miss.
//
// The tight bounds are made with the checker itself, by bisection over the doubles: the last bound that it accepts is
// the tightest one. The correctness of the checker is tested in tests/oracles/checker/check_proof_test.cpp and
// check_shapes_test.cpp.
#include "oracles/checker/check_proof.hpp"

#include <benchmark/benchmark.h>

#include <bit>
#include <chrono>

#include "tests/oracles/checker/symbolic_axes.hpp"

namespace graze::test {
namespace {

using oracle::check_proof;
using oracle::CheckCost;
using oracle::Refusal;

// The doubles >= 0 are ordered as their bits are.
template <class Accepts>
double last_accepted(double accepted, double refused, const Accepts& accepts) {
  auto low = std::bit_cast<std::int64_t>(accepted), high = std::bit_cast<std::int64_t>(refused);
  while (high - low > 1 || low - high > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (accepts(std::bit_cast<double>(middle)) ? low : high) = middle;
  }
  return std::bit_cast<double>(low);
}

struct Job {
  corpus::Case problem;
  Proof proof;
};

enum class Axis { centers, facet };

// Sets the axis of a job whose case is set. Returns false if this case has none.
bool set_axis(Job& job, Axis axis) {
  job.proof.has_axis = true;
  job.proof.axis = job.problem.b.position - job.problem.a.position;
  if (axis == Axis::centers) return true;
  const std::optional<Proof> facet = entering_facet(job.problem);
  if (!facet) return false;
  job.proof.symbolic = true;
  job.proof.axis_sign = facet->axis_sign;
  job.proof.factor = facet->factor;
  return true;
}

template <class DrawA, class DrawB>
std::vector<Job> jobs(Pose pose, Axis axis, const DrawA& draw_a, const DrawB& draw_b) {
  std::vector<Job> made;
  Draw draw(7);
  while (made.size() < 256) {
    Job job;
    corpus::Case& c = job.problem;
    Shape<double> a = draw_a(draw), b = draw_b(draw);
    c = approaching(draw, Numbers::doubles, pose, std::move(a), std::move(b));
    c.t_max = kInfinity<double>;
    Proof& proof = job.proof;
    proof.portal_size = 3;
    const auto of_a = named_vertices(c.a.shape), of_b = named_vertices(c.b.shape);
    Vec3<double> middle = Vec3<double>::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      SupportPair& s = proof.portal[k];
      s.a = draw_feature(draw, of_a);
      s.b = draw_feature(draw, of_b);
      const RationalVec p = world_point(c.a, of_a, s.a) - world_point(c.b, of_b, s.b);
      middle += Vec3<double>(p[0].get_d(), p[1].get_d(), p[2].get_d()) / 3;
    }
    c.b.displacement = c.a.displacement + middle;
    if (!set_axis(job, axis)) continue;
    proof.toi_lower = 0x1p-60;
    proof.toi_upper = 1e6;
    if (!check_proof(c, proof).accepted()) continue;
    Proof trial = proof;
    proof.toi_lower = last_accepted(proof.toi_lower, 1e6, [&](double t) {
      trial.toi_lower = t;
      return check_proof(c, trial).accepted();
    });
    trial = proof;
    proof.toi_upper = last_accepted(1e6, 0.0, [&](double t) {
      trial.toi_upper = t;
      return check_proof(c, trial).accepted();
    });
    made.push_back(job);
  }
  return made;
}

void measure(benchmark::State& state, const std::vector<Job>& made) {
  CheckCost cost;
  std::vector<double> each;
  for (auto _ : state) {
    for (const Job& job : made) {
      const auto start = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(check_proof(job.problem, job.proof, &cost).refusal);
      const auto end = std::chrono::steady_clock::now();
      each.push_back(std::chrono::duration<double, std::nano>(end - start).count());
    }
  }
  const auto middle = each.begin() + static_cast<std::ptrdiff_t>(each.size() / 2);
  std::nth_element(each.begin(), middle, each.end());
  state.counters["median_ns"] = *middle;
  const double all = static_cast<double>(cost.double_decisions + cost.extended_decisions +
                                         cost.ball_decisions + cost.exact_decisions);
  state.counters["double"] = static_cast<double>(cost.double_decisions) / all;
  state.counters["extended"] = static_cast<double>(cost.extended_decisions) / all;
  state.counters["balls"] = static_cast<double>(cost.ball_decisions) / all;
  state.counters["exact"] = static_cast<double>(cost.exact_decisions) / all;
}

void check_full_proof(benchmark::State& state) {
  const auto hull = [&](Draw& draw) -> Shape<double> {
    return draw.hull(Numbers::doubles, static_cast<int>(state.range(1)), static_cast<int>(state.range(2)));
  };
  const auto axis = static_cast<Axis>(state.range(3));
  state.SetLabel(axis == Axis::facet ? "facet of C" : "triple of doubles");
  measure(state, jobs(static_cast<Pose>(state.range(0)), axis, hull, hull));
}
BENCHMARK(check_full_proof)
    ->ArgNames({"pose", "fewest", "most", "axis"})
    ->Apply([](benchmark::internal::Benchmark* rows) {
      for (const Axis axis : {Axis::centers, Axis::facet})
        for (const auto& [fewest, most] : {std::pair{8, 16}, std::pair{64, 64}})
          for (const Pose pose : {Pose::identity, Pose::rotated})
            rows->Args({static_cast<int>(pose), fewest, most, static_cast<int>(axis)});
    });

// Proof that a ray misses: n = v x edge of A, two hulls.
void check_miss(benchmark::State& state) {
  std::vector<Job> made;
  Draw draw(8);
  const auto pose = static_cast<Pose>(state.range(0));
  while (made.size() < 256) {
    Job job;
    corpus::Case& c = job.problem;
    const Hull<double> a = draw.hull(Numbers::doubles, 8, 16), b = draw.hull(Numbers::doubles, 8, 16);
    c = approaching(draw, Numbers::doubles, pose, a, b);
    c.t_max = kInfinity<double>;
    c.b.displacement = draw.vector(Numbers::doubles, 4);
    const std::size_t to = 1 + draw.random.below(a.size() - 1);
    const int axis_sign = draw.random.once_in(2) ? 1 : -1;
    job.proof = lower_proof(kInfinity<double>, motion(), edge_of_a(0, to), axis_sign);
    if (check_proof(c, job.proof).accepted()) made.push_back(job);
  }
  measure(state, made);
}
BENCHMARK(check_miss)
    ->ArgName("pose")
    ->Arg(static_cast<int>(Pose::identity))
    ->Arg(static_cast<int>(Pose::rotated));

// Proof by the symbolic axis of the entering facet, a hull swept along a segment against a hull.
void check_swept(benchmark::State& state) {
  const auto swept_hull = [](Draw& draw) -> Shape<double> {
    const Vec3<double> along = draw.vector(Numbers::doubles, 3);
    return swept<double>(draw.hull(Numbers::doubles, 8, 16), along);
  };
  const auto hull = [](Draw& draw) -> Shape<double> { return draw.hull(Numbers::doubles, 8, 16); };
  measure(state, jobs(static_cast<Pose>(state.range(0)), Axis::facet, swept_hull, hull));
}
BENCHMARK(check_swept)
    ->ArgName("pose")
    ->Arg(static_cast<int>(Pose::identity))
    ->Arg(static_cast<int>(Pose::rotated));

// A of the named kind, as the tests draw it, B a hull of 8 to 16 vertices.
void check_kind(benchmark::State& state) {
  const auto kind = static_cast<Kind>(state.range(1));
  const auto pose = static_cast<Pose>(state.range(0));
  state.SetLabel(kKindNames[state.range(1)]);
  measure(state,
          jobs(
              pose, Axis::centers, [&](Draw& draw) { return draw_kind(draw, kind, Numbers::doubles, pose); },
              [](Draw& draw) -> Shape<double> { return draw.hull(Numbers::doubles, 8, 16); }));
}
BENCHMARK(check_kind)
    ->ArgNames({"pose", "kind"})
    ->ArgsProduct({{static_cast<int>(Pose::identity), static_cast<int>(Pose::rotated)},
                   benchmark::CreateDenseRange(static_cast<int>(Kind::segment),
                                               static_cast<int>(Kind::nested), 1)});

}  // namespace
}  // namespace graze::test
