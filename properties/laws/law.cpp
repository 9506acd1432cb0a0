#include "properties/laws/law.hpp"

#include <algorithm>

#include "properties/laws/tables.hpp"

namespace graze::law {

std::span<const Law> laws() {
  static const std::vector<Law> kLaws = [] {
    std::vector<Law> all;
    for (const LawTable& table : kLawTables) {
      for (Law& law : table.laws()) {
        law.kind = table.kind;
        all.push_back(std::move(law));
      }
    }
    return all;
  }();
  return kLaws;
}

std::span<const Law> laws(Kind kind) {
  const auto is_of_kind = [&](const Law& law) { return law.kind == kind; };
  const std::span<const Law> all = laws();
  const auto first = std::find_if(all.begin(), all.end(), is_of_kind);
  return {first, std::find_if_not(first, all.end(), is_of_kind)};
}

const Law* find_law(std::string_view name) {
  for (const Law& law : laws()) {
    if (law.name == name) return &law;
  }
  return nullptr;
}

std::string_view to_text(Needs needs) {
  switch (needs) {
    case Needs::metamorphic:
      return "metamorphic";
    case Needs::proof:
      return "proof";
    case Needs::oracle:
      return "oracle";
  }
  return "";
}

}  // namespace graze::law
