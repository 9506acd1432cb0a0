// The cost of querying a third-party engine: a program that reads and writes lines, a shared library by lines and by
// bytes, and one that crashes at every question. The bodies are balls, so that the engine itself costs nothing.
//
// The time covers a question and the reading of its answer (Engine::ask), by one thread or two. It does not include the
// judge. `parts/...` are its parts on our side.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <graze_adapter.hpp>

#include "certify/external/engine.hpp"
#include "certify/external/read_answer.hpp"
#include "certify/external/terms.hpp"

namespace {

using graze::corpus::Case;
using graze::external::Engine;
using graze::external::EngineOptions;

Case balls() {
  Case problem;
  problem.id = "bench/balls";
  problem.a.shape = graze::Sphere<double>{1};
  problem.b.shape = graze::Sphere<double>{0.5};
  problem.b.position = {4, 0.125, 0.25};
  problem.b.displacement = {-5, 0.5, 0};
  return problem;
}

int be_an_engine(bool crashes) {
  using namespace graze::adapter;
  graze::adapter::Engine says;
  says.name = "balls";
  says.shapes = {ShapeType::sphere};
  says.queries[Query::cast].answers = {"time"};
  return serve(says, [&](const Question& q) {
    if (crashes) std::abort();
    const double reach = q.a.shape.radius + q.b.shape.radius;
    const Vector gap = q.b.position - q.a.position, v = q.b.displacement - q.a.displacement;
    const double c = dot(gap, gap) - reach * reach, b = dot(gap, v), d = b * b - dot(v, v) * c;
    if (c <= 0) return Answer::overlapping();
    if (b >= 0 || d < 0 || c / (-b + std::sqrt(d)) > q.t_max) return Answer::miss();
    return Answer::hit(c / (-b + std::sqrt(d)));
  });
}

std::string self(const char* as) {
  return std::filesystem::read_symlink("/proc/self/exe").string() + " " + as;
}

void ask(benchmark::State& state, const EngineOptions& options) {
  static std::unique_ptr<Engine> engine;
  if (state.thread_index() == 0) engine = std::make_unique<Engine>(options);
  const Case problem = balls();
  std::size_t failed = 0;
  for (auto _ : state) {
    const graze::engine::Answer answer = engine->methods().front().ask(problem, {});
    failed += answer.failure != graze::engine::Failure::none ? 1 : 0;
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["failed"] = static_cast<double>(failed);
  if (state.thread_index() == 0) {
    state.counters["starts"] = static_cast<double>(engine->starts());
    if (engine->finish() != 0) state.SkipWithError("it left processes behind");
    engine.reset();
  }
}

void program_by_lines(benchmark::State& state) { ask(state, {.command = self("--engine")}); }
void library_by_lines(benchmark::State& state) {
  ask(state, {.command = BALL_LIBRARY, .library_host = {ENGINE_HOST}});
}
void library_by_bytes(benchmark::State& state) {
  ask(state, {.command = BALL_LIBRARY, .library_host = {ENGINE_HOST}, .host_takes_frames = true});
}
void crashes(benchmark::State& state) { ask(state, {.command = self("--crash"), .spares = 2}); }

void part_terms(benchmark::State& state) {
  Engine engine({.command = self("--engine")});
  const graze::external::Offer& offer = engine.declaration().offers.front();
  const Case problem = balls();
  for (auto _ : state)
    benchmark::DoNotOptimize(graze::external::in_terms_of(engine.declaration(), offer, problem, true));
}
void part_lines(benchmark::State& state) {
  Engine engine({.command = self("--engine")});
  const graze::external::Offer& offer = engine.declaration().offers.front();
  const graze::external::Terms terms =
      graze::external::in_terms_of(engine.declaration(), offer, balls(), true);
  const std::string line = R"({"schema": "graze.answer/1", "id": "q1", "outcome": "hit", "time": 0.5})";
  for (auto _ : state) {
    benchmark::DoNotOptimize(graze::external::write_question(offer, terms, "q1"));
    benchmark::DoNotOptimize(graze::external::read_answer(line, "q1", offer, terms));
  }
}

BENCHMARK(program_by_lines)->UseRealTime()->ThreadRange(1, 2);
BENCHMARK(library_by_lines)->UseRealTime()->ThreadRange(1, 2);
BENCHMARK(library_by_bytes)->UseRealTime()->ThreadRange(1, 2);
BENCHMARK(crashes)->UseRealTime()->ThreadRange(1, 2)->Iterations(5000);
BENCHMARK(part_terms)->Name("parts/terms");
BENCHMARK(part_lines)->Name("parts/write_and_read_lines");

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--engine") == 0) return be_an_engine(false);
  if (argc == 2 && std::strcmp(argv[1], "--crash") == 0) return be_an_engine(true);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
