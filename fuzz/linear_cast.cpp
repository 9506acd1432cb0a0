// Does any linear cast answer wrongly?
//
//   1  decode the bytes to a case, whatever they are;
//   2  ask every method in double for everything;
//   3  judge them by their proofs, and by the exact oracle where proofs leave a question open, and on one
//   case
//      in 256, chosen by a hash of its numbers (judge_cast.hpp lists the steps);
//   4  on a fault, print the case as JSON, its numbers as hexfloats and every side's answer, then abort.
#include <cstdio>
#include <cstdlib>

#include "fuzz/codec.hpp"
#include "properties/case_edit.hpp"
#include "properties/judge_cast.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const graze::corpus::Case problem = graze::fuzz::decode({data, size});
  const bool sampled = graze::law::hash_of(problem) % 256 == 0;
  const graze::law::CastJudgement judgement = graze::law::judge_cast(problem, sampled);
  if (!judgement.fault.empty()) {
    std::fputs(graze::law::report(problem, judgement).c_str(), stderr);
    std::abort();
  }
  return 0;
}
