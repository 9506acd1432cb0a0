// The function that libFuzzer and replay_main.cpp call. On a finding it prints the report and aborts.
//
// At the end it prints how many executions reached a law, called the oracle, and met a known failure. An input that
// reaches no law is time lost.
#include <cstdio>
#include <cstdlib>

#include "fuzz/target.hpp"

namespace {

struct Share {
  long long executions = 0, reached = 0, by_oracle = 0, known = 0;
};
Share& share() {
  static Share kept;
  return kept;
}

void print_share() {
  const Share& s = share();
  std::fprintf(stderr,
               "%lld of %lld executions reached a law\n%lld asked the oracle\n%lld met a known failure\n",
               s.reached, s.executions, s.by_oracle, s.known);
}

}  // namespace

// The defaults of address sanitizer, unless ASAN_OPTIONS overrides them. It keeps the stack of every allocation. Stacks
// through GMP, which has no frame pointers, are junk and all different: half of the time of an oracle's execution went
// into storing them. A campaign replays failures with all frames.
extern "C" const char* __asan_default_options() { return "malloc_context_size=1"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool kPrints = std::atexit(&print_share) == 0;
  const graze::fuzz::Judged judged = graze::fuzz::judge({data, size});
  if (kPrints) ++share().executions;
  share().reached += judged.reached;
  share().by_oracle += judged.by_oracle;
  share().known += judged.known;
  if (judged.finding) {
    std::fputs(graze::fuzz::report(*judged.finding).c_str(), stderr);
    std::abort();
  }
  return 0;
}
