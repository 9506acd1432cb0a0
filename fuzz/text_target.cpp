// The counterpart of target.cpp for the fuzzers of texts. A text needs neither codec nor oracle, so the fuzzers of
// readers are built without them. There are no known failures for texts (properties/laws/reach.hpp names methods).
#include "fuzz/target.hpp"

namespace graze::fuzz {

Judged judge(std::span<const std::uint8_t> bytes) { return kTarget.judge_text(bytes); }

std::string report(const Finding& finding) { return heading(finding) + finding.sides; }

}  // namespace graze::fuzz
