// Laws that compare one answer with what an oracle knows, each within the method's row.
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

LawResult verdict_is_right(const corpus::Case&, const engine::Method&);
LawResult never_late(const corpus::Case&, const engine::Method&);
LawResult bracket_holds_toi(const corpus::Case&, const engine::Method&);
LawResult time_is_stable(const corpus::Case&, const engine::Method&);
LawResult normal_supports(const corpus::Case&, const engine::Method&);
LawResult witnesses_touch(const corpus::Case&, const engine::Method&);
LawResult certified_decides(const corpus::Case&, const engine::Method&);
LawResult proof_is_tight(const corpus::Case&, const engine::Method&);

}  // namespace graze::law
