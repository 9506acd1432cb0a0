// Laws for third-party engines: which laws apply to such an engine, and how it is asked.
//
// A law asks a method about a case as the method sees it, and about edits of that case. A third-party engine sees a
// case in its own terms (certify/external/terms.hpp) and may not take the edit. The law does not apply then. If the
// engine crashes or hangs on a question of the law, the law is broken.
#pragma once

#include <string>
#include <string_view>

#include "engines/method.hpp"
#include "properties/laws/law.hpp"

namespace graze::tool {

// Why a law does not apply to third-party engines: the protocol cannot express it, or it is about our tiers, or about
// bits that nobody promised. Empty if it applies.
[[nodiscard]] std::string_view why_not_for_others(std::string_view law);

// The same for this method, whose answers may lack a time, a normal or witnesses.
[[nodiscard]] std::string_view why_not_for(const law::Law& law, const engine::Method& method);

// A third-party method as the laws ask it. It sees its own view of a case unchanged, and a target distance includes its
// margin. `method` must outlive it and must not move while laws use it.
[[nodiscard]] engine::Method as_laws_ask(const engine::Method& method);

// The verdict of a law. If the engine does not take a question of the law, it is not applicable, with the label
// kSkipped.
inline constexpr std::string_view kSkipped = "not asked";
inline constexpr std::string_view kFailed = "failed";
[[nodiscard]] law::LawResult check_other(const law::Law& law, const corpus::Case& problem,
                                         const engine::Method& as_laws_ask_it);

}  // namespace graze::tool
