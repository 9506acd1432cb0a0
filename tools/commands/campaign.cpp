// graze campaign: millions of generated casts, each judged. docs/howto/campaign.md.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <thread>

#include "certify/campaign/campaign_run.hpp"
#include "certify/campaign/summary.hpp"
#include "corpus/families.hpp"
#include "corpus/workloads.hpp"
#include "engines/system/system.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/outputs.hpp"
#include "reports/text/stop.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/engines.hpp"
#include "tools/commands/options.hpp"

namespace graze::tool {
namespace {

// The size of the largest published benchmark of continuous collision detection (Wang et al. 2021).
constexpr std::uint64_t kCasts = 60'000'000;
// A third-party engine has no proof, so the oracle measures every answer, at some hundred per second.
constexpr std::uint64_t kCastsOfOthers = 100'000;
// An exact answer takes the oracle 4 ms, over the families, and a cast and its judgement 50 microseconds: of
// one in 2048 they are 4 % of the time.
constexpr std::uint64_t kCastOracleEvery = 2048;
// A block takes a tenth of a second, so that a run stops at once and loses little. Other answers than linear
// casts take a hundred times as long.
constexpr std::uint64_t kBlock = 4096, kSlowBlock = 256;
// For a case of rotating bodies, the oracle takes 10 ms or more. The casts and the checks of their proofs take 1 ms.
constexpr std::uint64_t kRotatingOracleEvery = 64;

// --work: the families with the questions of an ordinary simulation. For N casts of each family, there are
// kWorkloadCasts N casts of the workloads, and N / kWorkQueries of each query.
constexpr std::string_view kWorkFamilies[] = {
    "at_rest",     "coaxial", "equal_distances",     "parallel_caps", "rods_and_round", "smooth_depths",
    "level_tiles", "wheels",  "flat_plates_turning", "above_a_floor", "apexes"};
constexpr std::uint64_t kWorkloadCasts = 10, kWorkQueries = 100;

struct CampaignArguments {
  std::optional<std::uint64_t> casts, rotating, per_family, rotating_per_family, queries;
  std::optional<std::uint64_t> oracle_every, block, workloads, work;
  std::uint64_t judge_every = 1;
  std::uint64_t seed = 1;
  std::vector<std::string> families, methods;
  std::string shard = "1/1", state;
  unsigned threads = 0;  // 0: as many as the machine has
  CampaignOutputs outputs;
  EngineArguments engines;

  [[nodiscard]] bool casts_linear() const {
    const bool other = rotating || rotating_per_family || queries || workloads;
    return casts || per_family || !other;
  }
  [[nodiscard]] bool casts_rotating() const { return rotating || rotating_per_family; }
  [[nodiscard]] bool is_slow() const { return queries || casts_rotating() || workloads || work; }
};

// The named ones, in the order of the table, so that the order of the options does not matter.
std::vector<const corpus::Family*> chosen_families(const std::vector<std::string>& names,
                                                   std::span<const corpus::Family> all) {
  std::vector<const corpus::Family*> chosen;
  for (const corpus::Family& family : all) {
    if (names.empty() || std::find(names.begin(), names.end(), family.name) != names.end())
      chosen.push_back(&family);
  }
  return chosen;
}

void check_families(const CampaignArguments& arguments) {
  for (const std::string& name : arguments.families) {
    const corpus::Family* family = corpus::find_family(name);
    if (family == nullptr) {
      throw std::runtime_error(
          fmt::format("--family: {} is no family; `graze generate --help` lists them", name));
    }
    if (family->of_run > 1 && !arguments.workloads)
      throw std::runtime_error(fmt::format("--family: {} is a workload; --workloads casts it", name));
    if (family->rotating && family->of_run == 1 && !arguments.casts_rotating())
      throw std::runtime_error(fmt::format("--family: bodies of {} rotate; --rotating casts them", name));
    if (!family->rotating && !arguments.casts_linear() && !arguments.queries)
      throw std::runtime_error(
          fmt::format("--family: no body of {} rotates; --rotating needs a family of rotating bodies", name));
  }
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
CLI::Validator count_of_casts() { return whole_number(1, 1'000'000'000'000'000); }

// Fails now rather than after hours.
void require_writable(const std::string& name) {
  if (name.empty() || name == "-") return;
  const bool existed = std::filesystem::exists(name);
  const bool writable = std::ofstream(name, std::ios::app).is_open();
  if (!writable) throw std::runtime_error(name + ": cannot be written; name a file in a folder that can");
  if (!existed) std::filesystem::remove(name);
}

// The state to begin with: the content of the file, or an empty state.
CampaignState initial_state(const CampaignArguments& arguments, const CampaignState& fresh) {
  if (arguments.state.empty() || !std::filesystem::exists(arguments.state)) return fresh;
  CampaignState kept = read_state(arguments.state);
  std::string what = difference(fresh.settings, kept.settings);
  if (what.empty() && kept.shard != fresh.shard) {
    what = fmt::format("the shard is {}/{} here and {}/{} there", fresh.shard.index, fresh.shard.count,
                       kept.shard.index, kept.shard.count);
  }
  if (what.empty() && kept.cells != fresh.cells) what = "its levels are not those of this build";
  if (!what.empty()) {
    throw std::runtime_error(
        fmt::format("--state: {} belongs to another campaign: {}; name another file", arguments.state, what));
  }
  return kept;
}

// Prints the results that depend on the machine and the hour, beside the summary.
void print_cost(std::uint64_t casts, double seconds, unsigned threads) {
  const system::Usage usage = system::own_usage();
  fmt::print(stderr,
             "{} casts in {:.1f} s: {:.0f} a second on {} thread{}; {:.1f} s of processor time; at most {} "
             "MiB of memory\n",
             casts, seconds, static_cast<double>(casts) / std::max(seconds, 1e-9), threads,
             threads == 1 ? "" : "s", usage.seconds, usage.memory / 1024);
}

int stopped_by(int signal, const CampaignState& state, const std::string& file) {
  const CampaignCounts total = state.tally.total();
  complain(fmt::format(
      "stopped at {} of {} blocks, {} failures so far; {}", state.blocks_done(),
      boost::icl::cardinality(state.share()), total.faults + total.stalls,
      file.empty() ? "nothing is kept without --state" : "the same command continues from " + file));
  return 128 + signal;
}

// --work: the same for everybody, so that one command is the test.
CampaignPlan plan_of_work(const CampaignArguments& arguments) {
  CampaignPlan plan(arguments.seed);
  const std::vector<std::string> names(std::begin(kWorkFamilies), std::end(kWorkFamilies));
  const std::uint64_t each = *arguments.work;
  const auto linear = chosen_families(names, corpus::families());
  const auto rotating = chosen_families(names, corpus::rotating_families());
  const auto workloads = chosen_families({}, corpus::workloads());
  const auto sampling = [&](std::uint64_t oracle_every) {
    return Sampling{.oracle_every = arguments.oracle_every.value_or(oracle_every),
                    .judge_every = arguments.judge_every};
  };
  const auto at_least_one = [](std::uint64_t n) { return std::max<std::uint64_t>(1, n); };
  plan.add_per_family(linear, chosen_contenders(engine::Kind::linear, {}), each, sampling(kCastOracleEvery));
  plan.add_per_family(
      linear, chosen_contenders(engine::Kind::linear, {"gjk", "mpr", "gjk/float", "mpr/float", "certified"}),
      each, sampling(kCastOracleEvery));
  plan.add_per_family(linear, chosen_contenders(engine::Kind::query, {}), at_least_one(each / kWorkQueries),
                      sampling(1));
  // Each rotating family has this number of casts, of all methods together.
  const Contenders turning = chosen_contenders(engine::Kind::rotating, {});
  plan.add_per_family(rotating, turning, at_least_one(each / turning.size()), sampling(kRotatingOracleEvery));
  plan.add(workloads, turning, kWorkloadCasts * each, sampling(kRotatingOracleEvery));
  return plan;
}

// The questions of a campaign, part by part.
CampaignPlan plan_of(const CampaignArguments& arguments, const Engines& engines) {
  const auto only_one = [](const char* one, const char* other, bool both) {
    if (both)
      throw std::runtime_error(fmt::format("{} and {}: both set the number of casts; give one", one, other));
  };
  only_one("--casts", "--per-family", arguments.casts && arguments.per_family);
  only_one("--rotating", "--rotating-per-family", arguments.rotating && arguments.rotating_per_family);
  check_families(arguments);
  if (arguments.work) return plan_of_work(arguments);
  CampaignPlan plan(arguments.seed);
  std::map<std::string, std::string> versions;
  for (const auto& engine : engines.all()) {
    for (const engine::Method& method : engine->methods())
      versions[method.question_name()] = engine->declaration().version;
  }
  plan.set_versions(std::move(versions));
  const auto add = [&](engine::Kind kind, std::optional<std::uint64_t> each, std::uint64_t count,
                       std::uint64_t oracle_every) {
    const auto all = kind == engine::Kind::rotating ? corpus::rotating_families() : corpus::families();
    const auto families = chosen_families(arguments.families, all);
    const Contenders others = engines.methods(kind);
    if (!engines.empty() && others.empty() && arguments.methods.empty())
      throw std::runtime_error(
          fmt::format("--engine: none of these engines supports {}; leave that part out, or name a --method",
                      kind == engine::Kind::linear  ? "casts"
                      : kind == engine::Kind::query ? "queries"
                                                    : "rotating casts"));
    Contenders contenders = chosen_contenders(kind, arguments.methods, others);
    const Sampling sampling{.oracle_every = arguments.oracle_every.value_or(oracle_every),
                            .judge_every = arguments.judge_every};
    if (each)
      plan.add_per_family(families, std::move(contenders), *each, sampling);
    else
      plan.add(families, std::move(contenders), count, sampling);
  };
  if (arguments.casts_linear())
    add(engine::Kind::linear, arguments.per_family,
        arguments.casts.value_or(engines.empty() ? kCasts : kCastsOfOthers), kCastOracleEvery);
  if (arguments.queries) add(engine::Kind::query, arguments.queries, 0, 1);
  if (arguments.casts_rotating())
    add(engine::Kind::rotating, arguments.rotating_per_family, arguments.rotating.value_or(0),
        kRotatingOracleEvery);
  if (arguments.workloads) {
    plan.add(
        chosen_families(arguments.families, corpus::workloads()),
        chosen_contenders(engine::Kind::rotating, arguments.methods, engines.methods(engine::Kind::rotating)),
        *arguments.workloads,
        {.oracle_every = arguments.oracle_every.value_or(kRotatingOracleEvery),
         .judge_every = arguments.judge_every});
  }
  return plan;
}

int run_campaign_command(const CampaignArguments& arguments) {
  const Shard shard = parse_shard(arguments.shard);
  for (const std::string* name : {&arguments.state, &arguments.outputs.json, &arguments.outputs.save,
                                  &arguments.outputs.save_undecided})
    require_writable(*name);
  // No two outputs are one file. A state is first written to a file beside its place.
  const auto beside = [](const std::string& name) { return name.empty() ? "" : name + ".new"; };
  require_own_files({arguments.state, beside(arguments.state), arguments.outputs.json, arguments.outputs.save,
                     arguments.outputs.save_undecided});
  const Engines engines(arguments.engines);
  const CampaignPlan plan = plan_of(arguments, engines);
  const bool slow = arguments.is_slow() || !engines.empty();
  const std::uint64_t block = arguments.block.value_or(slow ? kSlowBlock : kBlock);
  CampaignState state = initial_state(arguments, fresh_state(plan, block, shard));

  const CampaignJob job{.plan = &plan,
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
  const std::vector<std::string> orphans = engines.finish();
  for (const std::string& line : orphans) complain(line);
  if (!state.is_complete()) return stopped_by(signal, state, arguments.state);
  const int kept = hand_out(state, arguments.outputs);
  const int exit_code = kept == 0 && !orphans.empty() ? 1 : kept;
  print_cost(state.casts_done() - before, spent.count(), job.threads);
  return exit_code;
}

}  // namespace

void add_campaign_command(CLI::App& app, int& exit_code) {
  const auto arguments = std::make_shared<CampaignArguments>();
  CLI::App* command =
      app.add_subcommand("campaign", "Millions of generated casts, each judged; can be stopped and resumed.");
  command
      ->add_option(
          "--casts", arguments->casts,
          fmt::format("Linear casts (default: {}, or {} for third-party engines, unless other questions are "
                      "requested)",
                      kCasts, kCastsOfOthers))
      ->check(count_of_casts())
      ->type_name("N");
  command
      ->add_option("--per-family", arguments->per_family,
                   "N of each family, by each method, instead of --casts")
      ->check(count_of_casts())
      ->type_name("N");
  command->add_option("--rotating", arguments->rotating, "Casts of rotating bodies")
      ->check(count_of_casts())
      ->type_name("N");
  command
      ->add_option("--rotating-per-family", arguments->rotating_per_family,
                   "N of each family, by each method, instead of --rotating")
      ->check(count_of_casts())
      ->type_name("N");
  command
      ->add_option("--queries", arguments->queries,
                   "Queries other than casts: N of each, in each linear family, by each method")
      ->check(count_of_casts())
      ->type_name("N");
  command
      ->add_option("--workloads", arguments->workloads,
                   "Casts of the workloads, the steps of simulations (docs/reference/workloads.md)")
      ->check(count_of_casts())
      ->type_name("N");
  command
      ->add_option(
          "--work", arguments->work,
          fmt::format("Instead: N casts of each family of bodies at rest, equal distances and much work, by "
                      "methods of every tier, and {} N of the workloads",
                      kWorkloadCasts))
      ->check(count_of_casts())
      ->type_name("N");
  command
      ->add_option("--family", arguments->families,
                   "Use the cases of this family (may be repeated; default: all families)")
      ->type_name("NAME");
  command
      ->add_option(
          "--method,--methods", arguments->methods,
          fmt::format(
              "A method of linear casts: {} (default: exact); of rotating casts: {} (default: plan and "
              "certified, both scalars); or of queries: {} (default: each that has a guarantee). standard "
              "names every method of that tier. May be repeated",
              linear_names(), rotating_names(), query_names()))
      ->type_name("NAME");
  command->add_option("--seed", arguments->seed, "Another campaign of the same kind (1)")
      ->check(seed_number())
      ->type_name("S");
  command
      ->add_option(
          "--oracle-every", arguments->oracle_every,
          fmt::format(
              "The oracle also judges one cast in N, chosen at random ({}; {} for rotating bodies). "
              "Queries have no proofs: the oracle judges one in N of them (1), and the others are not "
              "judged. 0: none",
              kCastOracleEvery, kRotatingOracleEvery))
      ->check(whole_number())
      ->type_name("N");
  command
      ->add_option(
          "--judge-every", arguments->judge_every,
          "Judge one case in N, chosen at random (1), and every answer that did not converge, is refused "
          "or makes no sense. The outcomes of the others are only counted, to measure how often a method "
          "does not converge")
      ->check(count_of_casts())
      ->type_name("N");
  command
      ->add_option("--threads", arguments->threads, "Threads that cast; the result does not depend on them")
      ->check(whole_number(1, kMostThreads))
      ->type_name("N");
  command
      ->add_option("--state", arguments->state,
                   "Save the progress in this file, and continue from it if it exists")
      ->type_name("FILE");
  command->add_option("--shard", arguments->shard, "Only share I of N, from 1; `graze merge` joins them")
      ->type_name("I/N");
  command
      ->add_option(
          "--block", arguments->block,
          fmt::format("Casts per block, the unit of progress ({}; {} for questions other than linear casts)",
                      kBlock, kSlowBlock))
      ->check(count_of_casts())
      ->type_name("N");
  command->add_option("--save", arguments->outputs.save, "Write the cases of failures to this file")
      ->type_name("OUT.jsonl");
  command
      ->add_option("--save-undecided", arguments->outputs.save_undecided,
                   "Write the cases that the oracle left undecided to this file")
      ->type_name("OUT.jsonl");
  command->add_flag("--levels", arguments->outputs.levels, "Show every level of hardness");
  command
      ->add_option("--json", arguments->outputs.json, "Write the result to this file; - is standard output")
      ->type_name("OUT");
  add_engine_options(*command, arguments->engines);
  add_promise_options(*command, arguments->engines);
  command->footer(
      "An answer is judged by its proof. The exact oracle decides the answers that a proof leaves open, "
      "and a sample.\n"
      "The summary does not depend on threads, stops or shards. docs/howto/campaign.md says more.\n\n"
      "  graze campaign --state campaign.json\n"
      "  graze campaign --casts 100000 --family grazing_face --method mpr/float --save hard.jsonl\n"
      "  graze campaign --casts 2000000 --queries 2000 --methods standard --state standard.json\n"
      "  graze campaign --rotating 2000000 --state rotating.json\n"
      "  graze campaign --work 100000 --state work.json\n"
      "  graze campaign --state part3.json --shard 3/8      on one of eight machines; graze merge "
      "part*.json\n\n"
      "Exit code: 0 if no cast failed, 1 if one did, 2 for bad input; 130 or 143 if stopped by a signal.");
  command->callback([arguments, command, &exit_code] {
    require_engine(*command);
    exit_code = run_campaign_command(*arguments);
  });
}

}  // namespace graze::tool
