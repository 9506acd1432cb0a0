// A campaign gives one result however its casts are divided, and no failure is overlooked.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "certify/campaign/campaign_run.hpp"
#include "certify/campaign/summary.hpp"
#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "properties/laws/queries/question.hpp"

namespace graze::tool {
namespace {

constexpr std::uint64_t kCasts = 500, kBlock = 32, kOracleEvery = 50;

const engine::Method& exact() { return *engine::find_method(engine::Kind::linear, "exact"); }

std::vector<const corpus::Family*> some_families() {
  return {corpus::find_family("random"), corpus::find_family("grazing_face"),
          corpus::find_family("touching")};
}

// A small campaign, with everything that a run of it needs.
struct Small {
  // So that the contender outlives a planted method's making.
  engine::Method method = exact();
  engine::Method turning = *engine::find_method(engine::Kind::rotating, "plan");
  CampaignPlan plan;
  CampaignJob job{.plan = &plan};

  explicit Small(const engine::Method& judged, std::uint64_t seed = 7, std::uint64_t casts = kCasts)
      : method(judged), plan(seed) {
    plan.add(some_families(), {&method}, casts, {kOracleEvery});
  }
  // Every kind of part, of a few families.
  explicit Small(std::uint64_t seed) : plan(seed) {
    plan.add(some_families(), chosen_contenders(engine::Kind::linear, {"standard"}), 126, {kOracleEvery});
    plan.add_per_family(some_families(), chosen_contenders(engine::Kind::query, {"standard"}), 2, {1});
    plan.add({corpus::find_family("slow_spin"), corpus::find_family("random_rotating")},
             chosen_contenders(engine::Kind::rotating, {}), 48, {6});
  }
  // One rotating method.
  Small(const engine::Method& judged, const char* family, std::uint64_t casts) : turning(judged), plan(7) {
    plan.add({corpus::find_family(family)}, {&turning}, casts, {0});
  }
  Small(const Small&) = delete;
  Small& operator=(const Small&) = delete;

  [[nodiscard]] CampaignState fresh(Shard shard = {}) const { return fresh_state(plan, kBlock, shard); }
  [[nodiscard]] CampaignState run(unsigned threads = 1, Shard shard = {}) const {
    CampaignState state = fresh(shard);
    go_on(state, threads);
    return state;
  }
  void go_on(CampaignState& state, unsigned threads) const {
    CampaignJob with = job;
    with.threads = threads;
    run_campaign(with, state);
  }
  // Ends after so many blocks, give or take those that the other threads have begun.
  void go_on_for(CampaignState& state, unsigned threads, int blocks) const {
    CampaignJob with = job;
    with.threads = threads;
    std::atomic<int> begun = 0;
    with.stop = [&] { return begun++ >= blocks; };
    run_campaign(with, state);
  }
};

TEST(Campaign, EveryCastIsAskedOnceAndNoExactOneFails) {
  const Small small(exact());
  const CampaignState state = small.run();
  const CampaignCounts total = state.tally.total();
  EXPECT_EQ(total.casts, kCasts);
  EXPECT_EQ(total.hits + total.misses + total.overlapping, kCasts);
  EXPECT_EQ(total.faults + total.stalls + total.skipped, 0U);
  // Families in turn, and each one's levels: the shares differ by one at most.
  for (std::size_t cell = 0; cell < state.cells.size(); ++cell) {
    EXPECT_GT(state.tally.counts[cell].casts, 0U) << state.cells[cell].family << state.cells[cell].level;
  }
  // Every outcome is reached, by a proof for the most part, and the oracle had its sample.
  EXPECT_GT(total.hits, kCasts / 10);
  EXPECT_GT(total.misses, kCasts / 10);
  EXPECT_GT(total.overlapping, 0U);
  EXPECT_GT(total.proved, kCasts / 2);
  EXPECT_GT(total.sampled, 0U);
  EXPECT_LT(total.sampled, kCasts / 10);
  EXPECT_TRUE(campaign_failures(state).empty());
}

TEST(Campaign, ACaseIsAFunctionOfSeedAndIndexAndAQuestionForTheTier) {
  const Contenders asked = {&exact()};
  const CampaignCases one(some_families(), asked, 7, {kOracleEvery}),
      again(some_families(), asked, 7, {kOracleEvery}), other(some_families(), asked, 8, {kOracleEvery});
  for (std::uint64_t index = 0; index < 100; ++index) {
    const DrawnCase drawn = one.draw(index);
    EXPECT_TRUE(drawn.is_question);
    EXPECT_TRUE(engine::is_exact_question(drawn.problem));
    EXPECT_TRUE(corpus::same_case(drawn.problem, again.draw(index).problem));
    EXPECT_NE(drawn.problem.id, other.draw(index).problem.id);
    const Slot& slot = one.slots()[drawn.slot];
    EXPECT_TRUE(corpus::same_case(drawn.problem, slot.family->generate(slot.level, drawn.seed)));
  }
}

TEST(Campaign, LevelsWithHardlyAQuestionAreLeftOutByName) {
  const std::vector<const corpus::Family*> families = {corpus::find_family("rods_and_round"),
                                                       corpus::find_family("grazing_face")};
  const CampaignCases to_the_bit(families, {&exact()}, 1, {});
  EXPECT_EQ(to_the_bit.left_out(), std::vector<std::string>{"rods_and_round"});
  for (const Slot& slot : to_the_bit.slots()) EXPECT_EQ(slot.family->name, "grazing_face");
  // The standard tier gets every case.
  const CampaignCases standard(families, {engine::find_method(engine::Kind::linear, "mpr")}, 1, {});
  EXPECT_TRUE(standard.left_out().empty());
  EXPECT_FALSE(standard.draw(0).sampled);
}

TEST(Campaign, ThreadsDoNotChangeAByte) {
  const Small small(exact());
  const std::string one = state_text(small.run(1));
  EXPECT_EQ(state_text(small.run(2)), one);
  EXPECT_EQ(state_text(small.run(4)), one);
  // Another seed is another campaign.
  const Small other(exact(), 8);
  EXPECT_NE(other.run(2).tally.digest, small.run(2).tally.digest);
}

TEST(Campaign, StoppedAndResumedIsAsInOneGo) {
  const Small small(exact());
  CampaignState state = small.fresh();
  small.go_on_for(state, 2, 5);
  EXPECT_GT(state.casts_done(), 0U);
  EXPECT_LT(state.casts_done(), kCasts);
  EXPECT_FALSE(state.is_complete());
  CampaignState read = parse_state(state_text(state), "kept.json");
  EXPECT_EQ(state_text(read), state_text(state));
  small.go_on_for(read, 1, 3);
  EXPECT_FALSE(read.is_complete());
  small.go_on(read, 4);
  EXPECT_TRUE(read.is_complete());
  EXPECT_EQ(state_text(read), state_text(small.run(1)));
}

TEST(Campaign, AStateIsKeptWhileItRuns) {
  const Small small(exact(), 7, 4000);
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("graze-campaign-" + std::to_string(getpid()) + ".json");
  CampaignJob job = small.job;
  job.state_file = file;
  job.save_every = std::chrono::seconds(0);
  // Goes on until a state was written beside the run.
  std::atomic<bool> kept = false;
  job.stop = [&] { return kept || (kept = std::filesystem::exists(file)); };
  CampaignState state = small.fresh();
  run_campaign(job, state);
  if (!std::filesystem::exists(file)) write_state(state, file);  // a machine that ran it all in no time
  CampaignState read = read_state(file);
  std::filesystem::remove(file);
  EXPECT_LE(read.casts_done(), state.casts_done());
  small.go_on(read, 2);
  EXPECT_EQ(read.tally.total().casts, 4000U);
}

TEST(Merge, ShardsInAnyOrderAreTheCampaignInOnePiece) {
  const Small small(exact());
  const CampaignState whole = small.run(2);
  std::vector<NamedState> parts;
  for (const std::uint64_t index : {3U, 1U, 2U}) {
    CampaignState part = small.run(2, {.index = index, .count = 3});
    EXPECT_TRUE(part.is_complete());
    EXPECT_LT(part.casts_done(), kCasts);
    parts.push_back({"part" + std::to_string(index), parse_state(state_text(part), "part")});
  }
  const CampaignState merged = merge_states(parts, false);
  EXPECT_EQ(state_text(merged), state_text(whole));
  EXPECT_EQ(campaign_summary(merged), campaign_summary(whole));
}

TEST(Merge, WhatIsMissingCanBeCastAfterwards) {
  const Small small(exact());
  CampaignState merged = merge_states(
      {{"a", small.run(1, {.index = 1, .count = 4})}, {"b", small.run(1, {.index = 3, .count = 4})}}, true);
  EXPECT_FALSE(merged.is_complete());
  small.go_on(merged, 2);
  EXPECT_EQ(state_text(merged), state_text(small.run()));
}

std::string complaint(const std::vector<NamedState>& parts) {
  try {
    static_cast<void>(merge_states(parts, false));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(Merge, OverlapsGapsAndOtherSettingsAreRefusedByName) {
  const Small small(exact());
  const CampaignState half = small.run(1, {.index = 1, .count = 2});
  const CampaignState third = small.run(1, {.index = 2, .count = 3});
  EXPECT_NE(complaint({{"half", half}, {"third", third}}).find("half and third both hold block"),
            std::string::npos);
  EXPECT_NE(complaint({{"half", half}}).find("are in no file"), std::string::npos);
  const Small other(exact(), 8);
  EXPECT_NE(complaint({{"half", half}, {"other", other.run(1, {.index = 2, .count = 2})}}).find("seed"),
            std::string::npos);
  CampaignState newer = small.run(1, {.index = 2, .count = 2});
  newer.settings.fingerprint = "of another build";
  EXPECT_NE(complaint({{"half", half}, {"newer", newer}}).find("builds"), std::string::npos);
}

TEST(Merge, ShardsShareOutEveryBlockOnce) {
  for (const std::uint64_t blocks : {1U, 5U, 16U, 1000U}) {
    for (const std::uint64_t count : {1U, 3U, 7U, 40U}) {
      std::uint64_t end = 0, least = blocks, most = 0;
      for (std::uint64_t i = 1; i <= count; ++i) {
        const Shard shard{.index = i, .count = count};
        EXPECT_EQ(shard.first(blocks), end);
        end = shard.end(blocks);
        least = std::min(least, end - shard.first(blocks));
        most = std::max(most, end - shard.first(blocks));
      }
      EXPECT_EQ(end, blocks);
      EXPECT_LE(most - least, 1U);
    }
  }
}

// --- Methods that are wrong in a known way.

// A hit is reported one double late.
engine::Answer late_by_a_double(const corpus::Case& problem, const engine::Ask& ask) {
  engine::Answer answer = exact().ask(problem, ask);
  if (answer.outcome == Outcome::hit)
    answer.toi_lower = answer.toi_upper = std::nextafter(answer.toi_upper, kInfinity<double>);
  return answer;
}

// A false miss without a proof: the oracle is called.
engine::Answer denies_contact(const corpus::Case& problem, const engine::Ask& ask) {
  engine::Answer answer = exact().ask(problem, ask);
  if (answer.outcome == Outcome::hit) {
    answer.outcome = Outcome::miss;
    answer.toi_lower = answer.toi_upper = kInfinity<double>;
    answer.proof.reset();
  }
  return answer;
}

engine::Answer gives_up(const corpus::Case& problem, const engine::Ask& ask) {
  engine::Answer answer = engine::find_method(engine::Kind::linear, "mpr")->ask(problem, ask);
  if (answer.outcome != Outcome::hit) return answer;
  answer.outcome = Outcome::not_converged;
  answer.toi_lower = 0;
  answer.toi_upper = kInfinity<double>;
  answer.proof.reset();
  return answer;
}

engine::Method planted(const char* name, engine::Answer (*cast)(const corpus::Case&, const engine::Ask&)) {
  engine::Method method = *engine::find_method(engine::Kind::linear, name);
  method.ask = cast;
  return method;
}

TEST(Planted, EveryWrongAnswerIsCountedAndItsCaseIsKept) {
  const CampaignCounts honest = Small(exact()).run().tally.total();
  for (const auto cast : {&late_by_a_double, &denies_contact}) {
    const Small small(planted("exact", cast));
    const CampaignState state = small.run(2);
    EXPECT_EQ(state.tally.total().faults, honest.hits);
    ASSERT_FALSE(state.tally.faults.empty());
    EXPECT_FALSE(campaign_failures(state).empty());
    EXPECT_NE(campaign_summary(state).find("FAILED"), std::string::npos);
    for (const corpus::Case& problem : found_cases(state)) {
      EXPECT_EQ(exact().ask(problem, {}).outcome, Outcome::hit) << problem.id;
      const corpus::ReadResult read = corpus::read_text(corpus::write_case(problem), "found", true);
      ASSERT_TRUE(read.ok());
      EXPECT_TRUE(corpus::same_case(read.cases[0], problem));
    }
  }
}

TEST(Planted, TheFindingsKeptAreThoseOfLeastIndexWhateverTheOrder) {
  const auto denies = planted("exact", &denies_contact);
  Small small(denies, 7, 1);
  small.plan = CampaignPlan(7);
  small.plan.add({corpus::find_family("random")}, {&small.method}, 400, {kOracleEvery});
  const CampaignState one = small.run(1);
  const CampaignState shared = merge_states(
      {{"second", small.run(2, {.index = 2, .count = 2})}, {"first", small.run(3, {.index = 1, .count = 2})}},
      false);
  EXPECT_EQ(state_text(shared), state_text(one));
  ASSERT_EQ(one.tally.faults.size(), CampaignTally::kFindings);
  EXPECT_GT(one.tally.total().faults, CampaignTally::kFindings);
  EXPECT_TRUE(std::is_sorted(one.tally.faults.begin(), one.tally.faults.end(),
                             [](const Finding& l, const Finding& r) { return l.index < r.index; }));
  // None is skipped: as many casts hit up to the last of them.
  const std::uint64_t last = one.tally.faults.back().index;
  std::size_t hits = 0;
  for (std::uint64_t index = 0; index <= last; ++index) {
    if (exact().ask(small.plan.parts()[0].cases.draw(index).problem, {}).outcome == Outcome::hit) ++hits;
  }
  EXPECT_EQ(hits, CampaignTally::kFindings);
}

TEST(Planted, StallsBeyondTheCapOfTheRowFail) {
  const Small honest(*engine::find_method(engine::Kind::linear, "mpr"), 7, 120),
      stalling(planted("mpr", &gives_up), 7, 120);
  EXPECT_TRUE(campaign_failures(honest.run(2)).empty());
  const CampaignState state = stalling.run(2);
  EXPECT_GT(state.tally.total().stalls, 10U);
  EXPECT_FALSE(campaign_failures(state).empty());
  EXPECT_EQ(state.tally.stalls.size(), state.tally.total().stalls);
}

// --- Parts: several methods, other queries, rotating bodies.

TEST(Parts, StopsShardsAndThreadsDoNotChangeAByte) {
  const Small small(7);
  const CampaignState whole = small.run(1);
  EXPECT_EQ(whole.tally.total().casts + whole.tally.total().skipped, whole.settings.casts());
  CampaignState stopped = small.fresh();
  small.go_on_for(stopped, 2, 5);
  EXPECT_FALSE(stopped.is_complete());
  CampaignState read = parse_state(state_text(stopped), "kept.json");
  small.go_on(read, 3);
  EXPECT_EQ(state_text(read), state_text(whole));
  const CampaignState merged = merge_states(
      {{"second", small.run(2, {.index = 2, .count = 2})}, {"first", small.run(1, {.index = 1, .count = 2})}},
      false);
  EXPECT_EQ(state_text(merged), state_text(whole));
  EXPECT_EQ(campaign_summary(merged, true), campaign_summary(whole, true));
}

TEST(Parts, EveryContenderIsAskedItsShareOfEveryFamily) {
  const Small small(7);
  const CampaignState state = small.run(2);
  ASSERT_EQ(state.settings.parts.size(), 3U);
  EXPECT_EQ(state.settings.parts[0].methods.size(), 6U);
  for (const PartSettings& part : state.settings.parts) {
    for (const std::string& method : part.methods) {
      for (const std::string& family : part.families) {
        std::uint64_t asked = 0;
        for (std::size_t i = 0; i < state.cells.size(); ++i) {
          if (state.cells[i].method == method && state.cells[i].family == family)
            asked += state.tally.counts[i].casts + state.tally.counts[i].skipped;
        }
        EXPECT_EQ(asked, part.count / part.methods.size() / part.families.size()) << method << family;
      }
    }
  }
  EXPECT_EQ(state.settings.parts[1].count, 2 * 3 * state.settings.parts[1].methods.size());
  EXPECT_EQ(state.settings.parts[2].families, (std::vector<std::string>{"slow_spin", "random_rotating"}));
}

TEST(Parts, TurningCastsAreJudgedByProofsAndTheOracleSeesASample) {
  CampaignPlan plan(3);
  plan.add({corpus::find_family("random_rotating")}, chosen_contenders(engine::Kind::rotating, {"certified"}),
           40, {8});
  CampaignState state = fresh_state(plan, kBlock, {});
  run_campaign({.plan = &plan}, state);
  const CampaignCounts total = state.tally.total();
  EXPECT_EQ(total.faults + total.stalls, 0U) << campaign_summary(state);
  EXPECT_GT(total.hits, 5U);
  EXPECT_GT(total.misses, 5U);
  EXPECT_GT(total.sampled, 0U);
  EXPECT_LT(total.by_oracle, 20U);
  // Every other case requests a proof.
  EXPECT_GT(total.proved, 10U);
  EXPECT_LT(total.proved, 30U);
}

// The same casts give the same answers. For the casts that are not judged, the outcomes are counted.
TEST(Parts, OneCaseInSoManyIsJudged) {
  const auto run = [](const Sampling& sampling) {
    CampaignPlan plan(3);
    plan.add(some_families(), chosen_contenders(engine::Kind::linear, {"standard"}), 1200, sampling);
    CampaignState state = fresh_state(plan, kBlock, {});
    run_campaign({.plan = &plan}, state);
    return state;
  };
  const CampaignState all = run({.oracle_every = kOracleEvery}),
                      few = run({.oracle_every = kOracleEvery, .judge_every = 10});
  const CampaignCounts of_all = all.tally.total(), of_few = few.tally.total();
  EXPECT_EQ(of_few.casts, of_all.casts);
  EXPECT_EQ(of_few.hits, of_all.hits);
  EXPECT_EQ(of_few.misses, of_all.misses);
  EXPECT_EQ(of_few.not_converged, of_all.not_converged);
  EXPECT_EQ(few.tally.digest, all.tally.digest);
  EXPECT_GT(of_few.proved, 0U);
  EXPECT_LT(of_few.proved, of_all.proved / 4);
  EXPECT_EQ(difference(few.settings, all.settings), "judge-every is 10 here and 1 there");
  EXPECT_NE(campaign_summary(few).find("one case in 10 is judged"), std::string::npos);
}

// --- Turning methods and queries that are wrong in a known way.

const engine::Method& turning(const char* name) { return *engine::find_method(engine::Kind::rotating, name); }

template <int kOff>  // in millionths of the step
engine::Answer moved_in_time(const corpus::Case& problem, const engine::Ask& ask) {
  engine::Answer answer = turning("plan").ask(problem, ask);
  if (answer.outcome != Outcome::hit || answer.toi_lower < 1e-3) return answer;
  answer.toi_lower += kOff * 1e-6 * problem.t_max;
  answer.toi_upper += kOff * 1e-6 * problem.t_max;
  answer.rotating_proof.reset();
  return answer;
}

// True, never late, and the bodies are still apart at toi_lower: measured beside the proof's bracket.
engine::Answer widened_in_time(const corpus::Case& problem, const engine::Ask& ask) {
  engine::Answer answer = turning("plan").ask(problem, ask);
  if (answer.outcome == Outcome::hit && answer.toi_lower > 1e-3) answer.toi_lower -= 1e-4 * problem.t_max;
  return answer;
}

engine::Answer turning_denies_contact(const corpus::Case& problem, const engine::Ask& ask) {
  engine::Answer answer = turning("certified").ask(problem, ask);
  if (answer.outcome != Outcome::hit) return answer;
  answer.outcome = Outcome::miss;
  answer.toi_lower = answer.toi_upper = kInfinity<double>;
  answer.rotating_proof.reset();
  return answer;
}

// The chain claims more than its slices show.
engine::Answer forges_its_proof(const corpus::Case& problem, const engine::Ask& ask) {
  engine::Answer answer = turning("certified").ask(problem, ask);
  if (answer.rotating_proof && answer.outcome == Outcome::hit)
    answer.rotating_proof->toi_lower = 0.5 * (1 + problem.t_max) + answer.toi_upper;
  return answer;
}

engine::Method planted_turning(const char* name,
                               engine::Answer (*cast)(const corpus::Case&, const engine::Ask&)) {
  engine::Method method = turning(name);
  method.ask = cast;
  return method;
}

TEST(PlantedTurning, EveryWrongAnswerIsCountedByItsKindAndItsCaseIsKept) {
  struct Planted {
    engine::Method method;
    std::uint64_t CampaignCounts::*kind;
    bool with_proof;  // set only where a proof was requested
  };
  const std::uint64_t honest = Small(turning("certified"), "random_rotating", 48).run(2).tally.total().hits;
  EXPECT_GT(honest, 10U);
  for (const Planted& planted :
       {Planted{planted_turning("plan", &moved_in_time<100>), &CampaignCounts::late, false},
        Planted{planted_turning("plan", &moved_in_time<-100>), &CampaignCounts::off, false},
        Planted{planted_turning("plan", &widened_in_time), &CampaignCounts::off, false},
        Planted{planted_turning("certified", &turning_denies_contact), &CampaignCounts::wrong, false},
        Planted{planted_turning("certified", &forges_its_proof), &CampaignCounts::proofs_refused, true}}) {
    const Small small(planted.method, "random_rotating", 48);
    const CampaignState state = small.run(2);
    const CampaignCounts total = state.tally.total();
    EXPECT_GT(total.*planted.kind, honest / (planted.with_proof ? 4 : 2)) << campaign_summary(state);
    EXPECT_FALSE(campaign_failures(state).empty());
    EXPECT_EQ(state.tally.faults.size(), total.faults);
    const std::vector<corpus::Case> found = found_cases(state);
    EXPECT_EQ(found.size(), total.faults);
    for (const corpus::Case& problem : found) {
      EXPECT_EQ(turning("certified").ask(problem, {}).outcome, Outcome::hit) << problem.id;
    }
  }
}

// A distance query whose answer is off by a hundredth of itself.
engine::Answer stretched_distance(const corpus::Case& problem, const engine::Ask& asked) {
  engine::Answer answer = law::default_method(corpus::Query::distance, "double").ask(problem, asked);
  if (answer.separation)
    answer.separation = engine::Interval{1.01 * answer.separation->lower, 1.01 * answer.separation->upper};
  return answer;
}

TEST(PlantedQuery, WhatIsOffIsCountedAndItsCaseAsksTheQuery) {
  engine::Method method = law::default_method(corpus::Query::distance, "double");
  for (const bool honest : {true, false}) {
    if (!honest) method.ask = &stretched_distance;
    CampaignPlan plan(7);
    plan.add_per_family(some_families(), {&method}, 20, {1});
    CampaignState state = fresh_state(plan, kBlock, {});
    run_campaign({.plan = &plan, .threads = 2}, state);
    const CampaignCounts total = state.tally.total();
    EXPECT_EQ(total.casts, 60U);
    EXPECT_EQ(total.by_oracle, 60U);
    EXPECT_EQ(campaign_failures(state).empty(), honest) << campaign_summary(state);
    if (honest) continue;
    EXPECT_GT(total.off, 5U);
    ASSERT_FALSE(found_cases(state).empty());
    for (const corpus::Case& problem : found_cases(state)) {
      EXPECT_EQ(problem.query, corpus::Query::distance);
      EXPECT_GT(method.answer(problem).separation->lower, 0) << problem.id;
    }
  }
}

TEST(Undecided, TheyAreListedWithTheirCasesAndAgreeWithNothing) {
  const Small small(turning("certified"), "pure_spin", 32);
  CampaignState state = small.run(2);
  ASSERT_EQ(state.tally.total().undecided, 0U);
  CampaignCast open{.answer = {.outcome = Outcome::miss}};
  open.judgement.by_oracle = true;
  open.undecided = "clearance and depth are below the width";
  const DrawnCase drawn = small.plan.parts()[0].cases.draw(3), other = small.plan.parts()[0].cases.draw(4);
  state.tally.add(1000, 0, small.turning, drawn, open);
  EXPECT_EQ(state.tally.total().undecided, 1U);
  EXPECT_EQ(state.tally.total().faults, 0U);
  EXPECT_NE(campaign_summary(state).find("undecided: " + drawn.problem.id), std::string::npos);
  const std::vector<corpus::Case> cases = undecided_cases(state);
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_TRUE(corpus::same_case(cases.back(), drawn.problem));
  // 1 in 1,000, rounded up: one of 33 is allowed, and two are not.
  EXPECT_TRUE(campaign_failures(state).empty());
  state.tally.add(1001, 0, small.turning, other, open);
  ASSERT_EQ(campaign_failures(state).size(), 1U);
  EXPECT_NE(campaign_failures(state)[0].find("undecided"), std::string::npos);
}

TEST(Stalls, ALevelMayHaveTheShareOfItsRowRoundedUp) {
  CampaignPlan plan(7);
  plan.add({corpus::find_family("grazing_edge")}, chosen_contenders(engine::Kind::linear, {"ca/double"}),
           2000, {0});
  CampaignState state = fresh_state(plan, kBlock, {});
  for (CampaignCounts& counts : state.tally.counts) counts.casts = 800;
  EXPECT_TRUE(campaign_failures(state).empty());
  // The row of ca allows 1 in 1,000: 1 of 800 in a level, and of the family's casts by their number.
  state.tally.counts[0].stalls = 1;
  EXPECT_TRUE(campaign_failures(state).empty());
  state.tally.counts[0].stalls = 2;
  ASSERT_EQ(campaign_failures(state).size(), 1U);
  EXPECT_NE(campaign_failures(state)[0].find("grazing_edge h"), std::string::npos);
  for (CampaignCounts& counts : state.tally.counts) counts.stalls = 1;
  ASSERT_EQ(campaign_failures(state).size(), 1U);
  EXPECT_EQ(campaign_failures(state)[0].find("grazing_edge: "), 0U);
}

TEST(Digest, OneBitOfOneAnswerChangesItAndTheOrderDoesNot) {
  const Small small(exact());
  const DrawnCase drawn = small.plan.parts()[0].cases.draw(0);
  const AnswerWords answer = words_of(exact().ask(drawn.problem, {}));
  AnswerWords other = answer;
  other.numbers[0] = std::nextafter(other.numbers[0], -1.0);
  EXPECT_NE(answer_hash(0, answer), answer_hash(0, other));
  EXPECT_NE(answer_hash(0, answer), answer_hash(1, answer));
  CampaignTally first(small.plan.cells().size()), second = first, both = first, turned = first;
  first.add(0, 0, exact(), drawn, {.answer = answer});
  second.add(1, 0, exact(), drawn, {.answer = other});
  both.merge(first);
  both.merge(second);
  turned.merge(second);
  turned.merge(first);
  EXPECT_EQ(both, turned);
  EXPECT_NE(both.digest, first.digest);
}

TEST(State, WhatIsWrongInAFileIsNamed) {
  const Small small(exact(), 7, 64);
  const std::string good = state_text(small.run());
  const auto complaint_of = [](const std::string& text) -> std::string {
    try {
      static_cast<void>(parse_state(text, "kept.json"));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return complaint_of(text);
  };
  EXPECT_EQ(complaint_of(good), "");
  EXPECT_EQ(complaint_of("{").find("kept.json: is no state of a campaign: "), 0U);
  EXPECT_NE(with("graze.campaign/2", "graze.campaign/1").find("schema"), std::string::npos);
  EXPECT_NE(with("graze.campaign/2", "graze.case/1").find("schema"), std::string::npos);
  EXPECT_NE(with("\"widest\"", "\"narrowest\"").find("widest"), std::string::npos);
  EXPECT_NE(with("\"seed\": 7", "\"seed\": -7").find("-7"), std::string::npos);
  EXPECT_NE(with("\"block\": 32", "\"block\": 16").find("the levels count"), std::string::npos);
  EXPECT_NE(with("\"block\"", "\"blocks\"").find("block"), std::string::npos);
  const std::string place = "kept.json: is no state of a campaign: ";
  const std::string digest = good.substr(good.find("\"digest\": \"") + 11, 16);
  EXPECT_EQ(with(digest, "zz"), place + "digest: the string \"zz\"; 16 hexadecimal digits");
  EXPECT_EQ(with("\"left_out\"", "\"left_in\"").find(place + "unknown field \"left_in\"; known fields: "),
            0U);
  EXPECT_EQ(with("\"widest\": ", "\"widest\": \"x\", \"w\": ").find(place + "levels[0]: unknown field \"w\""),
            0U);
  EXPECT_EQ(complaint_of(R"({"schema": "graze.campaign/2"})"), place + "settings: missing");
  EXPECT_EQ(with("\"seed\": 7", "\"seed\": \"7\""),
            place + "settings.seed: the string \"7\"; a whole number of 0 or more");
  EXPECT_EQ(with("\"count\": ", "\"count\": [1], \"count_of\": ").find("json.exception"), std::string::npos);
}

}  // namespace
}  // namespace graze::tool
