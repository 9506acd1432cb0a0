// A law of any kind together with the methods that it judges, behind one face: for whatever lists laws, runs
// them or counts what they saw.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "properties/laws/law.hpp"
#include "properties/laws/queries/queries.hpp"
#include "properties/laws/rotating/rotating.hpp"

namespace graze::law {

// What a law speaks about. The queries beside the cast are asked about the bodies of a linear case.
enum class Kind { linear, query, rotating };

struct AnyLaw {
  Kind kind;
  std::string name, sentence;
  Needs needs;
  std::vector<std::string> methods;  // by full name; of a query with the query before it
  std::function<LawResult(const corpus::Case&, std::size_t method)> check;
};

[[nodiscard]] AnyLaw any(const Law& law);
[[nodiscard]] AnyLaw any(const QueryLaw& law);
[[nodiscard]] AnyLaw any(const RotatingLaw& law);

// Of every kind, in the order of the tables: linear, query, rotating.
[[nodiscard]] std::vector<AnyLaw> all_laws();

[[nodiscard]] std::string_view name_of(Kind kind);
[[nodiscard]] std::string_view name_of(Needs needs);

}  // namespace graze::law
