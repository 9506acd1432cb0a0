// The function that libFuzzer and replay_main.cpp call. On a finding it prints the report and aborts.
//
// At the end it prints how many executions reached a law, and how many asked the oracle; an input that
// reaches none is time lost.
#include <cstdio>
#include <cstdlib>

#include "fuzz/target.hpp"

namespace {

struct Share {
  long long executions = 0, reached = 0, by_oracle = 0;
};
Share& share() {
  static Share kept;
  return kept;
}

void print_share() {
  const Share& s = share();
  std::fprintf(stderr, "%lld of %lld executions reached a law\n%lld asked the oracle\n", s.reached,
               s.executions, s.by_oracle);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool kPrints = std::atexit(&print_share) == 0;
  const graze::fuzz::Judged judged = graze::fuzz::judge({data, size});
  if (kPrints) ++share().executions;
  share().reached += judged.reached;
  share().by_oracle += judged.by_oracle;
  if (judged.finding) {
    std::fputs(graze::fuzz::report(*judged.finding).c_str(), stderr);
    std::abort();
  }
  return 0;
}
