// Laws of the exact tier alone. Not applicable to any other method, nor to a case that the tier refuses.
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

// The first of what tier exact gets wrong on this case (as the method saw it); empty if nothing. With
// ask_oracle the exact oracle looks at it whatever the proof says; without, only where the proof says too
// little.
struct ExactJudgement {
  std::string fault;
  bool by_oracle = false;
  engine::Answer answer;
};
[[nodiscard]] ExactJudgement judge_exact(const corpus::Case& seen, const engine::Method& method,
                                         bool ask_oracle);

}  // namespace graze::law
