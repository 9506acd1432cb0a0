// The attack on the checker of proofs, in bulk.
//
//   graze_proof_attack --mutants 200000 --state attack.json
//
// continues until that many accepted mutants of another meaning are judged, and a twentieth of them in every class.
// Ctrl-C keeps the work done, and the same command resumes. Exit codes: 0 if none is contradicted, 1 if some are (each
// a line of the findings' file), 2 for bad input, 130 if stopped.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>

#include "properties/attack/state.hpp"

namespace {

using namespace graze::attack;
using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t stopped = 0;

int refuse(const std::string& what) {
  fmt::print(stderr, "graze_proof_attack: {}\n", what);
  return 2;
}

// In the class that has the fewest.
std::uint64_t fewest(const State& state) {
  std::uint64_t least = state.tally.all.agreed;
  for (std::size_t k = 0; k < kEdits; ++k) {
    least = std::min(least, state.tally.by_class[k].agreed);
  }
  return least;
}

void show(const State& state, std::uint64_t wanted) {
  static const bool is_seen = isatty(2) != 0;
  if (!is_seen) return;
  const Count& all = state.tally.all;
  fmt::print(
      stderr,
      "\r{} of {} agreed, {} in the least class, {} contradicted, {} undecided, {} refused, {:.0f} a second ",
      all.agreed, wanted, fewest(state), all.contradicted, all.undecided, all.refused,
      static_cast<double>(all.agreed) / std::max(state.seconds, 1e-9));
}

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

struct Goal {
  std::uint64_t mutants = 200000, rounds = UINT64_MAX;
  bool first = false;  // or a finding
};

// Runs rounds until there are enough or the user stops it.
void run(State& state, const Goal& goal, const std::string& state_file, const std::string& findings_file) {
  const double before = state.seconds;
  const Clock::time_point begin = Clock::now();
  Clock::time_point saved = begin;
  const auto save = [&] {
    state.seconds = before + seconds_since(begin);
    if (!state_file.empty()) write_state(state_file, state);
    saved = Clock::now();
  };
  constexpr double kSaveEvery = 10;  // seconds
  constexpr std::uint64_t kShareOfAClass = 20;
  while (stopped == 0 && state.rounds < goal.rounds &&
         (state.tally.all.agreed < goal.mutants || fewest(state) < goal.mutants / kShareOfAClass) &&
         !(goal.first && state.tally.all.contradicted > 0)) {
    const std::vector<Finding> found = attack_round(state.seed, state.next(), state.settings, state.tally);
    ++state.rounds;
    if (!found.empty()) {
      std::ofstream out(findings_file, std::ios::app);
      for (const Finding& one : found) out << text_of(one) << "\n";
      out.close();
      if (!out) throw std::runtime_error(findings_file + ": cannot be written");
    }
    if (!found.empty() || seconds_since(saved) > kSaveEvery) {
      save();
      show(state, goal.mutants);
    }
  }
  save();
}

}  // namespace

int main(int argc, char** argv) {
  Goal goal;
  std::string state_file, findings_file = "attack_findings.jsonl", shard = "1/1";
  std::vector<std::string> tables;
  State wanted;

  CLI::App app(
      "Mutates true proofs and judges by the oracles what the checker accepts "
      "(docs/explanation/checker.md).");
  app.add_option("--mutants", goal.mutants,
                 "accepted mutants of another meaning to be judged; a twentieth in each class");
  app.add_option("--state", state_file, "a file to keep the counts in, and to go on from");
  app.add_option("--findings", findings_file, "proof records that were accepted and are false, one a line");
  app.add_option("--seed", wanted.seed, "another seed, other proofs");
  app.add_option("--shard", shard, "K/N: the K-th of N shares of the rounds");
  app.add_option("--rounds", goal.rounds, "no more rounds than these");
  app.add_flag("--first", goal.first, "no more rounds after one that finds something");
  app.add_flag("--flush-subnormals", wanted.settings.flush_subnormals,
               "the checker runs with subnormal numbers flushed to zero");
  app.add_option("--kappa", wanted.settings.kappa,
                 "accept linear proofs to within K u of scale, and judge them by as much")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--table", tables, "no run: the table of these states together");
  CLI11_PARSE(app, argc, argv);

  try {
    if (!tables.empty()) {
      State sum = read_state(tables.front());
      for (std::size_t i = 1; i < tables.size(); ++i) {
        const State other = read_state(tables[i]);
        sum.tally.add(other.tally);
        sum.rounds += other.rounds;
        sum.seconds += other.seconds;
      }
      fmt::print("{}", table_of(sum));
      return sum.tally.all.contradicted > 0 ? 1 : 0;
    }
    unsigned long long k = 0, n = 0;
    if (std::sscanf(shard.c_str(), "%llu/%llu", &k, &n) != 2 || k < 1 || k > n)
      return refuse("--shard wants K/N with 1 <= K <= N; got " + shard);
    wanted.share = {k - 1, n};
    if (wanted.settings.flush_subnormals && !can_flush_subnormals())
      return refuse("--flush-subnormals: this machine cannot be told to");
    State state = wanted;
    if (!state_file.empty() && std::filesystem::exists(state_file)) {
      state = read_state(state_file);
      if (const std::string other = difference(wanted, state); !other.empty())
        return refuse(state_file + ": " + other);
    }
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { stopped = 1; });
    run(state, goal, state_file, findings_file);
    if (isatty(2) != 0) fmt::print(stderr, "\n");
    fmt::print("{}", table_of(state));
    if (stopped != 0) return 130;
    return state.tally.all.contradicted > 0 ? 1 : 0;
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}
