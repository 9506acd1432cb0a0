// Laws of the exact tier alone. Not applicable to any other method, nor to a case that the tier refuses.
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

// The first error of tier exact on this case (as the method saw it), or empty. With ask_oracle the exact oracle judges
// it whatever the proof shows. Without, it does so only if the proof shows too little.
struct ExactJudgement {
  std::string fault;
  bool by_oracle = false;
  engine::Answer answer;
};
[[nodiscard]] ExactJudgement judge_exact(const corpus::Case& seen, const engine::Method& method,
                                         bool ask_oracle);

}  // namespace graze::law
