// Laws that compare one answer with what an oracle knows, each within the method's row.
#pragma once

#include "properties/laws/law.hpp"

namespace graze::law {

LawResult verdict_is_right(const corpus::Case&, const engine::EngineMethod&);
LawResult never_late(const corpus::Case&, const engine::EngineMethod&);
LawResult bracket_holds_toi(const corpus::Case&, const engine::EngineMethod&);
LawResult time_is_stable(const corpus::Case&, const engine::EngineMethod&);
LawResult normal_supports(const corpus::Case&, const engine::EngineMethod&);
LawResult witnesses_touch(const corpus::Case&, const engine::EngineMethod&);
LawResult certified_decides(const corpus::Case&, const engine::EngineMethod&);
LawResult proof_is_tight(const corpus::Case&, const engine::EngineMethod&);

}  // namespace graze::law
