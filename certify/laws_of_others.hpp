// Laws about engines of others: which of them such an engine can be asked at all, and how.
//
// A law asks a method about a case as the method sees it, and about edits of that. An engine of others sees a case in
// its own terms (certify/external/terms.hpp), which need not take the edit: then the law says nothing of it. Where the engine
// fails on a question of the law, crashed or hung, the law is broken by that.
#pragma once

#include <string>
#include <string_view>

#include "engines/method.hpp"
#include "properties/laws/law.hpp"

namespace graze::tool {

// Why no engine of others is asked a law: it is about what the protocol has no words for, about our tiers, or about bits
// that nobody promised. Empty if one is.
[[nodiscard]] std::string_view why_not_for_others(std::string_view law);

// The same for one that answers as this one does: whose answers hold no time, no normal, no witnesses.
[[nodiscard]] std::string_view why_not_for(const law::Law& law, const engine::Method& method);

// A method of others as the laws ask it: what it sees it sees again, and a target distance holds its margin. `method`
// outlives it, and it stays where it is while laws ask it.
[[nodiscard]] engine::Method as_laws_ask(const engine::Method& method);

// What a law says of it. Not applicable, with the label kSkipped, where the engine does not take a question of the law.
inline constexpr std::string_view kSkipped = "not asked";
inline constexpr std::string_view kFailed = "failed";
[[nodiscard]] law::LawResult check_other(const law::Law& law, const corpus::Case& problem,
                                         const engine::Method& as_laws_ask_it);

}  // namespace graze::tool
