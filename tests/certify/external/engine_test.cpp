// Each fault of the bad engine is found and called what docs/reference/protocol.md calls it, the next question is asked of a new
// process, and nothing is left behind.
#include "certify/external/engine.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "balls.hpp"
#include "processes.hpp"

namespace graze::external {
namespace {

using engine::Answer;
using engine::Failure;
using test::bad_engine;

struct Found {
  const char* fault;
  Failure failure;
  const char* words;  // of its reason
};
std::ostream& operator<<(std::ostream& out, const Found& found) { return out << found.fault; }

class Sins : public testing::TestWithParam<Found> {};

TEST_P(Sins, AreFoundAndNamed) {
  const Found& expected = GetParam();
  {
    EngineOptions options = bad_engine(expected.fault, 2);
    // Memory, or a line without an end, takes its time to fill on a busy machine, and is to end before the time does.
    if (expected.failure == Failure::out_of_memory || std::string_view(expected.fault) == "endless_line")
      options.limits.time = std::chrono::seconds(30);
    Engine engine(options);
    const engine::Method& cast = engine.methods().front();
    // Rightly answered, then the fault, then, of a new process, rightly again.
    const Answer before = cast.answer(test::hit());
    EXPECT_EQ(before.failure, Failure::none) << before.message;
    EXPECT_EQ(before.outcome, Outcome::hit);
    EXPECT_EQ(before.toi_lower, 0.5);
    const Answer fault = cast.answer(test::hit());
    EXPECT_EQ(fault.failure, expected.failure) << fault.message;
    EXPECT_NE(fault.message.find(expected.words), std::string::npos) << fault.message;
    if (expected.failure != Failure::non_finite && expected.failure != Failure::out_of_range) {
      const Answer after = cast.answer(test::hit());
      EXPECT_EQ(after.failure, Failure::none) << after.message;
      EXPECT_EQ(after.toi_lower, 0.5);
    }
    EXPECT_EQ(engine.finish(), 0);
  }
  EXPECT_EQ(test::bad_engines(), 0U);
  EXPECT_EQ(test::zombies(), 0U);
}

INSTANTIATE_TEST_SUITE_P(
    Every, Sins,
    testing::Values(Found{"segfault", Failure::crashed, "SIGSEGV; it wrote: about to fall"},
                    Found{"traceback", Failure::crashed, "it wrote:\nTraceback:\n  line 1\n  line 2"},
                    Found{"abort", Failure::crashed, "SIGABRT"}, Found{"exit_3", Failure::crashed, "exit 3"},
                    Found{"exit_0", Failure::silent, "it ended, and said nothing"},
                    Found{"hang", Failure::hung, "no answer within 0.5 s (is every line flushed?)"},
                    Found{"spin", Failure::hung, "no answer within 0.5 s (is every line flushed?)"},
                    Found{"nan_string", Failure::non_finite, "time is NaN"},
                    Found{"nan_token", Failure::non_finite, "time is NaN"},
                    Found{"minus_nan", Failure::non_finite, "time is NaN"},
                    Found{"infinite", Failure::non_finite, "time is infinite"},
                    Found{"nan_normal", Failure::non_finite,
                          "normal[1] is NaN: \"...\\\"normal\\\": [0, NaN"},
                    Found{"before_0", Failure::out_of_range, "the time -0.25 is not between 0 and t_max 1"},
                    Found{"after_the_end", Failure::out_of_range, "is not between 0 and t_max 1"},
                    Found{"upside_down", Failure::out_of_range, "time is a bracket upside down"},
                    Found{"long_normal", Failure::out_of_range, "the normal has length 2"},
                    Found{"leaks", Failure::out_of_memory, "of 256"},
                    Found{"wrong_id", Failure::wrong_id, "it answers \"q999999\", and was asked"},
                    Found{"garbage", Failure::garbage, "hit at 0.5, I think"},
                    Found{"binary_garbage", Failure::garbage, ""},
                    Found{"half_a_line", Failure::half_a_line, "its output ended within a line"},
                    Found{"closes_output", Failure::silent, "it closed its output, and went on"},
                    Found{"endless_line", Failure::garbage, "a line of more than 16 MiB"}),
    [](const testing::TestParamInfo<Found>& found) { return std::string(found.param.fault); });

// It does not err until another process is needed: what its output cannot take is read, and what it writes on standard
// error does not stop it.
TEST(Engine, IsNotHeldUpByWhatItWritesOnStandardError) {
  Engine engine(bad_engine("floods_errors"));
  const Answer answer = engine.methods().front().answer(test::hit());
  EXPECT_EQ(answer.failure, Failure::none) << answer.message;
  EXPECT_EQ(answer.toi_lower, 0.5);
}

// A question that does not fit into a pipe without a reader.
TEST(Engine, ThatSaysSomethingElseOfItselfWhenStartedAgainIsFound) {
  Engine engine(bad_engine("declares_otherwise", 2));
  const engine::Method& cast = engine.methods().front();
  EXPECT_EQ(cast.answer(test::hit()).failure, Failure::none);
  EXPECT_EQ(cast.answer(test::hit()).failure, Failure::crashed);
  const Answer other = cast.answer(test::hit());
  EXPECT_EQ(other.failure, Failure::wrong_id) << other.message;
  EXPECT_NE(other.message.find("it says something else of itself"), std::string::npos) << other.message;
  EXPECT_EQ(engine.finish(), 0);
}

TEST(Engine, ThatDoesNotReadHangs) {
  Engine engine(bad_engine("does_not_read"));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(engine.methods().front().answer(test::hit()).failure, Failure::hung);
}

TEST(Engine, ThatAnswersTwiceAnswersAnothersQuestionNext) {
  Engine engine(bad_engine("two_answers", 2));
  const engine::Method& cast = engine.methods().front();
  EXPECT_EQ(cast.answer(test::hit()).failure, Failure::none);
  EXPECT_EQ(cast.answer(test::hit()).failure, Failure::none);
  EXPECT_EQ(cast.answer(test::hit()).failure, Failure::wrong_id);
  EXPECT_EQ(cast.answer(test::hit()).failure, Failure::none);
}

class Forks : public testing::TestWithParam<const char*> {};

// The answers are right. Processes that the engine forked are found when it ends, in its group or outside of
// it.
TEST_P(Forks, AreFoundWhenItEnds) {
  Engine engine(bad_engine(GetParam(), 1));
  EXPECT_EQ(engine.methods().front().answer(test::hit()).failure, Failure::none);
  EXPECT_EQ(engine.finish(), 1);
  EXPECT_EQ(test::bad_engines(), 0U);
  EXPECT_EQ(test::zombies(), 0U);
}
INSTANTIATE_TEST_SUITE_P(Every, Forks, testing::Values("forks", "forks_session", "forks_twice"));

// A crash is told at once, though what was left behind holds the output open.
TEST(Engine, ThatCrashesAndLeavesAProcessBehindHasCrashed) {
  Engine engine(bad_engine("forks_and_crashes"));
  for (int i = 0; i < 2; ++i) {
    const Answer answer = engine.methods().front().answer(test::hit());
    EXPECT_EQ(answer.failure, Failure::crashed) << answer.message;
    EXPECT_NE(answer.message.find("exit 3"), std::string::npos) << answer.message;
  }
  EXPECT_EQ(engine.finish(), 2);
  EXPECT_EQ(test::bad_engines(), 0U);
}

class BadStarts : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(BadStarts, AreRefusedWithALine) {
  const auto& [fault, words] = GetParam();
  try {
    const Engine engine(bad_engine(fault));
    FAIL() << "it was taken";
  } catch (const std::runtime_error& error) {
    const std::string line = error.what();
    EXPECT_NE(line.find(words), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
  EXPECT_EQ(test::bad_engines(), 0U);
}
INSTANTIATE_TEST_SUITE_P(Every, BadStarts,
                         testing::Values(std::pair{"silent_start",
                                                   "hung: no answer within 2 s (is every line flushed?)"},
                                         std::pair{"ends_at_start", "silent: it ended, and said nothing"},
                                         std::pair{"fails_at_start", "crashed: exit 7"},
                                         std::pair{"declares_nonsense", "scalar: "},
                                         std::pair{"declares_no_json", "no graze.engine/1"}));

TEST(Engine, ThatIsNoProgramIsRefused) {
  EXPECT_THROW(Engine({.command = "/nowhere/at/all"}), std::runtime_error);
  EXPECT_THROW(Engine({.command = ""}), std::runtime_error);
  EXPECT_THROW(Engine({.command = "library.so"}), std::runtime_error);
}

// Programs are looked for in PATH, and who forgets that has a file of that name before them.
TEST(Engine, ThatStandsHereIsNamedWithItsFolder) {
  const std::string here = "an_engine_that_stands_here";
  std::ofstream(here) << "#!/bin/sh\n";
  try {
    const Engine engine({.command = here});
    ADD_FAILURE() << "it was run";
  } catch (const std::runtime_error& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("the file of that name here is ./" + here), std::string::npos)
        << refusal.what();
  }
  std::filesystem::remove(here);
}

// Restarts cost a bounded time each, and leave neither descriptors nor processes. The rate is printed, not tested: a
// machine may be busy.
TEST(Engine, MayCrashAThousandTimes) {
  constexpr int kCrashes = 1000;
  Engine engine(bad_engine("exit_3"));
  const engine::Method& cast = engine.methods().front();
  const Answer first = cast.answer(test::hit());
  EXPECT_EQ(first.failure, Failure::crashed);
  const std::size_t open = test::entries_of("/proc/self/fd");
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kCrashes; ++i) EXPECT_EQ(cast.answer(test::hit()).failure, Failure::crashed);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::printf("%.0f crashes a second\n", kCrashes / took.count());
  EXPECT_EQ(test::entries_of("/proc/self/fd"), open);
  EXPECT_EQ(engine.finish(), 0);
  EXPECT_EQ(test::bad_engines(), 0U);
  EXPECT_EQ(test::zombies(), 0U);
}

TEST(Engine, IsAskedFromManyThreads) {
  Engine engine(bad_engine("exit_3", 4));
  const engine::Method& cast = engine.methods().front();
  std::atomic<int> right = 0, crashed = 0, other = 0;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&, k] {
      for (int i = 0; i < 25; ++i) {
        const double step = -(3.0 + k + 0.125 * i);  // the balls touch at x = 1.5
        const Answer answer = cast.answer(test::balls(step));
        if (answer.failure == Failure::crashed) {
          ++crashed;
        } else if (answer.failure == Failure::none && std::abs(answer.toi_lower + 2.5 / step) < 1e-12) {
          ++right;
        } else {
          ++other;
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(other, 0);
  EXPECT_GT(crashed, 0);
  // A process crashes at its fourth question, and not before.
  EXPECT_GE(right, 3 * crashed);
  EXPECT_EQ(engine.finish(), 0);
  EXPECT_EQ(test::bad_engines(), 0U);
}

TEST(Words, AreApartByBlanksAndHeldByQuotes) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(words_of("a"), (Words{"a"}));
  EXPECT_EQ(words_of("  a\t b  "), (Words{"a", "b"}));
  EXPECT_EQ(words_of("'a b' c"), (Words{"a b", "c"}));
  EXPECT_EQ(words_of("a\"b c\"d"), (Words{"ab cd"}));
  EXPECT_EQ(words_of("a '' b"), (Words{"a", "", "b"}));
  EXPECT_EQ(words_of("'\"' \"'\""), (Words{"\"", "'"}));
  EXPECT_EQ(words_of("a $HOME ; b"), (Words{"a", "$HOME", ";", "b"}));
  EXPECT_THROW((void)words_of(""), std::runtime_error);
  EXPECT_THROW((void)words_of(" \t"), std::runtime_error);
  EXPECT_THROW((void)words_of("a 'b"), std::runtime_error);
  EXPECT_THROW((void)words_of("a \"b'"), std::runtime_error);
}

}  // namespace
}  // namespace graze::external
