// graze campaign: millions of generated casts, each judged. docs/campaigns.md.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <thread>

#include "corpus/families.hpp"
#include "tools/campaign_run.hpp"
#include "tools/campaign_summary.hpp"
#include "tools/commands.hpp"
#include "tools/inputs.hpp"

namespace graze::tool {
namespace {

// The size of the largest published benchmark of continuous collision detection (Wang et al. 2021).
constexpr std::uint64_t kCasts = 60'000'000;
// An exact answer takes the oracle 4 ms, over the families, and a cast and its judgement 50 microseconds: of
// one in 2048 they are 4 % of the time.
constexpr std::uint64_t kOracleEvery = 2048;
// A block takes a tenth of a second, so that a run stops at once and loses little.
constexpr std::uint64_t kBlock = 4096;

struct Arguments {
  std::uint64_t casts = kCasts, seed = 1, oracle_every = kOracleEvery, block = kBlock;
  std::vector<std::string> families;
  std::string method = "exact", shard = "1/1", state;
  unsigned threads = 0;  // 0: as many as the machine has
  CampaignOutputs outputs;
};

// Those named, in the order of the table, so that the order of the options says nothing.
std::vector<const corpus::Family*> chosen_families(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const corpus::Family* family = corpus::find_family(name);
    if (family == nullptr) {
      throw std::runtime_error(
          fmt::format("--family: {} is no family; `graze generate --help` lists them", name));
    }
    if (family->rotating) {
      throw std::runtime_error(
          fmt::format("--family: bodies of {} turn; a campaign casts the linear families", name));
    }
  }
  std::vector<const corpus::Family*> chosen;
  for (const corpus::Family& family : corpus::families()) {
    if (names.empty() || std::find(names.begin(), names.end(), family.name) != names.end())
      chosen.push_back(&family);
  }
  return chosen;
}

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  const bool slash = index.ec == std::errc{} && index.ptr != end && *index.ptr == '/';
  const auto count = slash ? std::from_chars(index.ptr + 1, end, shard.count) : index;
  if (!slash || count.ec != std::errc{} || count.ptr != end || shard.index < 1 || shard.index > shard.count) {
    throw std::runtime_error(
        fmt::format("--shard: {} is no share; it is i/n with 1 <= i <= n, as 3/8", text));
  }
  return shard;
}

// Block numbers and the sums of counts stay far from overflow.
void require_count(const char* option, std::uint64_t count) {
  constexpr std::uint64_t kMost = 1'000'000'000'000'000;
  if (count < 1 || count > kMost) throw std::runtime_error(fmt::format("{}: must be 1 to {}", option, kMost));
}

// Fails now rather than after hours.
void require_writable(const std::string& name) {
  if (name.empty() || name == "-") return;
  const bool existed = std::filesystem::exists(name);
  const bool writable = std::ofstream(name, std::ios::app).is_open();
  if (!writable) throw std::runtime_error(name + ": cannot be written; name a file in a folder that can");
  if (!existed) std::filesystem::remove(name);
}

// The state to begin with: what the file holds, or nothing done.
CampaignState initial_state(const Arguments& arguments, const CampaignState& fresh) {
  if (arguments.state.empty() || !std::filesystem::exists(arguments.state)) return fresh;
  CampaignState kept = read_state(arguments.state);
  std::string what = difference(fresh.settings, kept.settings);
  if (what.empty() && kept.shard != fresh.shard) {
    what = fmt::format("the shard is {}/{} here and {}/{} there", fresh.shard.index, fresh.shard.count,
                       kept.shard.index, kept.shard.count);
  }
  if (what.empty() && kept.levels != fresh.levels) what = "its levels are not those of this build";
  if (!what.empty()) {
    throw std::runtime_error(
        fmt::format("--state: {} is of another campaign: {}; name another file", arguments.state, what));
  }
  return kept;
}

// What depends on the machine and the hour, beside the summary.
void print_cost(std::uint64_t casts, double seconds, unsigned threads) {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print(stderr, "{} casts in {:.1f} s: {:.0f} a second on {} thread{}; at most {} MiB of memory\n",
             casts, seconds, static_cast<double>(casts) / std::max(seconds, 1e-9), threads,
             threads == 1 ? "" : "s", usage.ru_maxrss / 1024);
}

int stopped_by(int signal, const CampaignState& state, const std::string& file) {
  const CampaignCounts total = state.tally.total();
  complain(fmt::format(
      "stopped at {} of {} blocks, {} failures so far; {}", state.blocks_done(),
      boost::icl::cardinality(state.share()), total.faults + total.stalls,
      file.empty() ? "nothing is kept without --state" : "the same command goes on from " + file));
  return 128 + signal;
}

int run(const Arguments& arguments) {
  require_count("--casts", arguments.casts);
  require_count("--block", arguments.block);
  const Shard shard = parse_shard(arguments.shard);
  const engine::EngineMethod* method = engine::find_method(arguments.method);
  if (method == nullptr) {
    throw std::runtime_error(fmt::format(
        "--method: {} is no method for linear casts; it is {}, or one of them with its scalar (mpr/float)",
        arguments.method, linear_names()));
  }
  for (const std::string* name : {&arguments.state, &arguments.outputs.json, &arguments.outputs.save})
    require_writable(*name);

  const CampaignCases cases(chosen_families(arguments.families), *method, arguments.seed,
                            arguments.oracle_every);
  if (cases.slots().empty()) {
    throw std::runtime_error(
        fmt::format("--family: hardly a case of these is a question for {}; name another family, or a method "
                    "of another tier",
                    method->full_name()));
  }
  CampaignSettings settings{.method = method->full_name(),
                            .families = {},
                            .casts = arguments.casts,
                            .seed = arguments.seed,
                            .oracle_every = arguments.oracle_every,
                            .block = arguments.block,
                            .fingerprint = fingerprint(cases, *method)};
  for (const Slot& slot : cases.slots()) {
    if (settings.families.empty() || settings.families.back() != slot.family->name)
      settings.families.emplace_back(slot.family->name);
  }
  CampaignState state = initial_state(arguments, fresh_state(std::move(settings), shard, cases));

  const CampaignJob job{.cases = &cases,
                        .method = method,
                        .row = engine::find_guarantee(engine::guarantees(), *method),
                        .threads = arguments.threads > 0 ? arguments.threads
                                                         : std::max(1U, std::thread::hardware_concurrency()),
                        .state_file = arguments.state,
                        .stop = [] { return StopBySignal::received() != 0; }};
  const std::uint64_t before = state.casts_done();
  const auto start = std::chrono::steady_clock::now();
  int signal = 0;
  {
    const StopBySignal guard;
    run_campaign(job, state);
    if (!arguments.state.empty()) write_state(state, arguments.state);
    signal = StopBySignal::received();
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  if (!state.is_complete()) return stopped_by(signal, state, arguments.state);
  const int exit_code = hand_out(state, arguments.outputs);
  print_cost(state.casts_done() - before, spent.count(), job.threads);
  return exit_code;
}

}  // namespace

void add_campaign_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("campaign", "Millions of generated casts, each judged; can be stopped and resumed.");
  command->add_option("--casts", arguments->casts, "How many (60000000)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  command
      ->add_option("--family", arguments->families,
                   "Cast cases of this family (may be repeated); without it, all linear ones")
      ->type_name("NAME");
  command->add_option("--method", arguments->method, fmt::format("{} (exact)", linear_names()))
      ->type_name("NAME");
  command->add_option("--seed", arguments->seed, "Another campaign of the same kind (1)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("S");
  command
      ->add_option(
          "--oracle-every", arguments->oracle_every,
          fmt::format("The exact oracle judges one cast in N besides, chosen at random ({}); 0: none",
                      kOracleEvery))
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  command
      ->add_option("--threads", arguments->threads, "Threads that cast; the result does not depend on them")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  command
      ->add_option("--state", arguments->state,
                   "Keep what is done in this file, and go on from it if it is there")
      ->type_name("FILE");
  command->add_option("--shard", arguments->shard, "Only share I of N, from 1; `graze merge` joins them")
      ->type_name("I/N");
  command
      ->add_option("--block", arguments->block, fmt::format("Casts that are done or not at all ({})", kBlock))
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  command->add_option("--save", arguments->outputs.save, "Write the cases of failures to this file")
      ->type_name("OUT.jsonl");
  command
      ->add_option("--json", arguments->outputs.json, "Write the result to this file; - is standard output")
      ->type_name("OUT");
  command->footer(
      "An answer is judged by its proof; the exact oracle decides what a proof leaves open, and a sample.\n"
      "The summary does not depend on threads, stops or shards. docs/campaigns.md says more.\n\n"
      "  graze campaign --state campaign.json\n"
      "  graze campaign --casts 100000 --family grazing_face --method mpr/float --save hard.jsonl\n"
      "  graze campaign --state part3.json --shard 3/8      on one of eight machines; graze merge "
      "part*.json\n\n"
      "Exit code: 0 if no cast failed, 1 if one did, 2 for bad input; 130 or 143 if stopped by a signal.");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace graze::tool
