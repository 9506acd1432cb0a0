#include "reports/text/stop.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

namespace graze::tool {
namespace {

using std::chrono::milliseconds;

// A program that runs until it is asked to stop, and then takes a while: what it says on stderr, and how it ended.
struct Program {
  int status = 0;
  std::string said;
};
template <class Ask>
Program asked(milliseconds while_stopping, const Ask& ask) {
  int ends[2], ready[2];
  if (pipe(ends) != 0 || pipe(ready) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    dup2(ends[1], STDERR_FILENO);
    const StopBySignal stop;
    (void)!write(ready[1], "!", 1);
    while (StopBySignal::received() == 0) std::this_thread::sleep_for(milliseconds(1));
    const auto end = std::chrono::steady_clock::now() + while_stopping;
    while (std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(milliseconds(1));
    _exit(128 + StopBySignal::received());
  }
  close(ends[1]);
  char text[512];
  (void)!read(ready[0], text, 1);
  ask(child);
  Program program;
  waitpid(child, &program.status, 0);
  for (ssize_t size; (size = read(ends[0], text, sizeof text)) > 0;)
    program.said.append(text, static_cast<std::size_t>(size));
  for (const int end : {ends[0], ready[0], ready[1]}) close(end);
  return program;
}

TEST(StopBySignal, SignalsThatComeAtOnceAreOneRequestAndSaidOnce) {
  const Program program = asked(milliseconds(200), [](pid_t child) {
    for (const int number : {SIGINT, SIGINT, SIGTERM}) {
      kill(child, number);
      std::this_thread::sleep_for(milliseconds(20));
    }
  });
  ASSERT_TRUE(WIFEXITED(program.status));
  EXPECT_EQ(WEXITSTATUS(program.status), 130);
  EXPECT_EQ(program.said,
            "graze: stopping; what is being judged is finished first. Once more ends at once.\n");
}

TEST(StopBySignal, ALaterOneEndsTheProgramAtOnce) {
  const Program program = asked(milliseconds(20000), [](pid_t child) {
    kill(child, SIGTERM);
    std::this_thread::sleep_for(milliseconds(1100));
    kill(child, SIGINT);
  });
  ASSERT_TRUE(WIFSIGNALED(program.status));
  EXPECT_EQ(WTERMSIG(program.status), SIGINT);
}

}  // namespace
}  // namespace graze::tool
