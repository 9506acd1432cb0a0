// The cost of a judged cast, the unit of a campaign. One thread.
//
// Linear: a case of the families `hulls` and `hulls_rotated`, 8 to 16 vertices, is generated, cast by tier exact with
// everything requested, and judged by its proof to the last bit.
//
//   judged      the three together: casts per second of CPU time, and the share of each, by the clock. `open`
//               is the share of casts that the proof leaves to the oracle, which is not called here.
//   campaign    a block of `graze campaign`, which does the same and keeps count.
//   generate, cast, judge             each alone.
//   hulls, convert, search, accept    parts of them: the two hulls from their vertices, the case in the method's
//               scalar, core's cast, the first proof check.
//
// Rotating bodies, one benchmark per rotating family, its levels in turn:
//   turning     a block of `graze campaign --rotating`: plan and certified, in double and in float.
//   stages      the milliseconds of processor time of a case in its parts: generation, the cast by the plan and
//               by tier certified, the check of that proof, and the oracle's bracket.
//
// A benchmark of one stage alone runs over the same cases again and again, so its data is in the caches. The shares are
// measured on cases that are used once.
#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <graze/cast.hpp>
#include <iostream>
#include <limits>
#include <vector>

#include "certify/campaign/campaign_run.hpp"
#include "corpus/families.hpp"
#include "engines/convert.hpp"
#include "engines/method.hpp"
#include "oracles/checker/check_rotating_proof.hpp"
#include "oracles/truth/rotating_truth.hpp"
#include "properties/judge/exact_answer.hpp"

namespace graze::bench {
namespace {

using corpus::Case;
using corpus::Family;
using engine::Answer;

constexpr std::size_t kCases = 256;  // of the benchmarks of one stage: about the capacity of the second-level
                                     // cache

constexpr engine::Ask kEverything{.request = Request::everything};

const Family& family_of(const benchmark::State& state) {
  return *corpus::find_family(state.range(0) == 0 ? "hulls" : "hulls_rotated");
}
Case generated(const Family& family, std::uint64_t seed) {
  return family.generate(static_cast<double>(8 + seed % 9), seed);
}
const engine::Method& method() {
  static const engine::Method& exact = *engine::find_method(engine::Kind::linear, "exact/double");
  return exact;
}

struct Job {
  Case problem;
  Answer answer;
};
std::vector<Job> jobs_of(const Family& family) {
  std::vector<Job> jobs(kCases);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    jobs[i].problem = generated(family, i);
    jobs[i].answer = method().ask(jobs[i].problem, kEverything);
  }
  return jobs;
}

// A wrong answer is not a measurement.
[[noreturn]] void give_up(const std::string& why) {
  std::cerr << why << "\n";
  std::exit(1);
}
// True if nothing is left to the oracle.
bool judge(const Case& problem, const Answer& answer) {
  const law::ExactFinding finding = law::judge_exact_by_proof(problem, answer, false);
  if (!finding.fault.empty()) give_up(problem.id + ": " + finding.fault);
  return finding.settled;
}

void set_rate(benchmark::State& state, std::size_t each = 1) {
  state.counters["casts_per_second"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * static_cast<double>(each), benchmark::Counter::kIsRate);
}

void judged(benchmark::State& state) {
  const Family& family = family_of(state);
  std::uint64_t seed = 0, open = 0;
  for (auto _ : state) {
    const Case problem = generated(family, seed++);
    open += !judge(problem, method().ask(problem, kEverything));
  }
  set_rate(state);
  state.counters["open"] = static_cast<double>(open) / static_cast<double>(seed);
  // The shares, on as many cases more: reading the clock four times costs a tenth of a microsecond.
  using Clock = std::chrono::steady_clock;
  std::array<double, 3> spent{};
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const Clock::time_point start = Clock::now();
    const Case problem = generated(family, seed++);
    const Clock::time_point made = Clock::now();
    const Answer answer = method().ask(problem, kEverything);
    const Clock::time_point cast = Clock::now();
    benchmark::DoNotOptimize(judge(problem, answer));
    const Clock::time_point end = Clock::now();
    const std::array stages{made - start, cast - made, end - cast};
    for (std::size_t k = 0; k < spent.size(); ++k)
      spent[k] += std::chrono::duration<double>(stages[k]).count();
  }
  const double all = spent[0] + spent[1] + spent[2];
  state.counters["share_generate"] = spent[0] / all;
  state.counters["share_cast"] = spent[1] / all;
  state.counters["share_judge"] = spent[2] / all;
}

// Blocks of a campaign. A fault is counted and not measured by itself.
void run_blocks(benchmark::State& state, const tool::CampaignPlan& plan, std::uint64_t size) {
  const tool::CampaignJob job{.plan = &plan};
  tool::CampaignSettings settings = plan.settings(size);
  std::uint64_t block = 0, faults = 0, by_oracle = 0;
  for (auto _ : state) {
    tool::CampaignTally tally(plan.cells().size());
    tool::run_block(job, settings, block++, tally);
    faults += tally.total().faults;
    by_oracle += tally.total().by_oracle;
  }
  set_rate(state, size);
  state.counters["faults"] = static_cast<double>(faults);
  state.counters["by_oracle"] = static_cast<double>(by_oracle) / static_cast<double>(block * size);
}

constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();

void campaign(benchmark::State& state) {
  tool::CampaignPlan plan(1);
  plan.add({&family_of(state)}, {&method()}, kMost, {});
  run_blocks(state, plan, 1000);
}

const Family& rotating_family(benchmark::State& state) {
  const Family& family = corpus::rotating_families()[static_cast<std::size_t>(state.range(0))];
  state.SetLabel(std::string(family.name));
  return family;
}

void turning(benchmark::State& state) {
  tool::CampaignPlan plan(1);
  plan.add({&rotating_family(state)}, tool::chosen_contenders(engine::Kind::rotating, {}), kMost, {});
  run_blocks(state, plan, 64);
}

void stages(benchmark::State& state) {
  const Family& family = rotating_family(state);
  const engine::Method &planned = *engine::find_method(engine::Kind::rotating, "plan"),
                       &certified = *engine::find_method(engine::Kind::rotating, "certified");
  const engine::Ask everything{.request = Request::everything};
  std::array<double, 5> spent{};
  std::uint64_t seed = 0;
  for (auto _ : state) {
    std::array<std::clock_t, 6> at{};
    at[0] = std::clock();
    const Case problem = family.generate(family.levels[seed % family.levels.size()], seed);
    at[1] = std::clock();
    benchmark::DoNotOptimize(planned.ask(problem, everything));
    at[2] = std::clock();
    const engine::Answer answer = certified.ask(problem, everything);
    at[3] = std::clock();
    if (answer.rotating_proof)
      benchmark::DoNotOptimize(oracle::check_rotating_proof(problem, *answer.rotating_proof).refusal);
    at[4] = std::clock();
    benchmark::DoNotOptimize(oracle::RotatingTruth(problem).outcome());
    at[5] = std::clock();
    for (std::size_t k = 0; k < spent.size(); ++k)
      spent[k] += static_cast<double>(at[k + 1] - at[k]) / CLOCKS_PER_SEC;
    ++seed;
  }
  constexpr std::array kNames = {"ms_generate", "ms_plan", "ms_certified", "ms_check", "ms_oracle"};
  for (std::size_t k = 0; k < spent.size(); ++k)
    state.counters[kNames[k]] = 1000 * spent[k] / static_cast<double>(seed);
}

void generate(benchmark::State& state) {
  const Family& family = family_of(state);
  std::uint64_t seed = 0;
  for (auto _ : state) benchmark::DoNotOptimize(generated(family, seed++));
  set_rate(state);
}

// One stage of every case.
template <class Stage>
void measure(benchmark::State& state, const Stage& stage) {
  const std::vector<Job> jobs = jobs_of(family_of(state));
  for (auto _ : state) {
    for (const Job& job : jobs) stage(job);
  }
  set_rate(state, jobs.size());
}
void hulls(benchmark::State& state) {
  measure(state, [](const Job& job) {
    for (const Body<double>* body : {&job.problem.a, &job.problem.b})
      benchmark::DoNotOptimize(Hull<double>(std::get<Hull<double>>(body->shape).vertices()));
  });
}
void convert(benchmark::State& state) {
  measure(state, [](const Job& job) {
    benchmark::DoNotOptimize(engine::round_to<double>(job.problem.a));
    benchmark::DoNotOptimize(engine::round_to<double>(job.problem.b));
  });
}
void cast(benchmark::State& state) {
  measure(state, [](const Job& job) { benchmark::DoNotOptimize(method().ask(job.problem, kEverything)); });
}
void search(benchmark::State& state) {
  measure(state, [](const Job& job) {
    CastOptions<double> options;
    options.tier = Tier::exact;
    options.request = Request::everything;
    options.t_max = job.problem.t_max;
    benchmark::DoNotOptimize(cast_exact(job.problem.a, job.problem.b, options));
  });
}
void accept(benchmark::State& state) {
  measure(state, [](const Job& job) {
    if (job.answer.proof)
      benchmark::DoNotOptimize(oracle::check_proof(job.problem, *job.answer.proof).refusal);
  });
}
void judge_alone(benchmark::State& state) {
  measure(state, [](const Job& job) { benchmark::DoNotOptimize(judge(job.problem, job.answer)); });
}

void both(benchmark::internal::Benchmark* rows) { rows->ArgName("rotated")->Arg(0)->Arg(1); }
void each_family(benchmark::internal::Benchmark* rows) {
  rows->ArgName("family")->DenseRange(0, static_cast<int>(corpus::rotating_families().size()) - 1);
}
BENCHMARK(judged)->Apply(both);
BENCHMARK(turning)->Apply(each_family)->Unit(benchmark::kMillisecond);
BENCHMARK(stages)->Apply(each_family)->Unit(benchmark::kMillisecond);
BENCHMARK(campaign)->Apply(both);
BENCHMARK(generate)->Apply(both);
BENCHMARK(hulls)->Apply(both);
BENCHMARK(cast)->Apply(both);
BENCHMARK(convert)->Apply(both);
BENCHMARK(search)->Apply(both);
BENCHMARK(judge_alone)->Name("judge")->Apply(both);
BENCHMARK(accept)->Apply(both);

}  // namespace
}  // namespace graze::bench
