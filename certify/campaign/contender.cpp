#include "certify/campaign/contender.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "certify/suites.hpp"
#include "properties/edit/case.hpp"

namespace graze::tool {
namespace {

using engine::Kind;
using engine::Method;

constexpr std::string_view kStandard = "standard";

// The default if no contender is named.
bool is_default(const Method& method) {
  switch (method.kind) {
    case Kind::linear:
      return method.full_name() == "exact/double";
    case Kind::query:
      return method.guarantee != nullptr;
    case Kind::rotating:
      return method.name == "certified" || method.name == "plan";
  }
  return false;
}

bool is_named(const Method& method, const std::string& name) {
  if (name == kStandard) return method.tier == kStandard && method.guarantee != nullptr;
  return name == method.full_name() || (name == method.name && !method.in_float());
}

std::string no_method(Kind kind, const std::string& name) {
  std::vector<std::string> known;
  for (const Method& method : engine::methods(kind)) {
    if (std::find(known.begin(), known.end(), method.name) == known.end()) known.push_back(method.name);
  }
  const char* what = kind == Kind::linear  ? "linear casts"
                     : kind == Kind::query ? "queries"
                                           : "casts of rotating bodies";
  return fmt::format(
      "--method: {} is no method for {}; it is {}, one of them with its scalar (mpr/float), or standard",
      name, what, fmt::join(known, ", "));
}

bool is_asked_of(const Method& method, const corpus::Case& problem) {
  if (!method.is_ours() && (!law::in_domain(problem) || !method.refuses(problem).empty())) return false;
  switch (method.kind) {
    case Kind::linear:
      if (!method.is_exact()) return engine::unsupported(Kind::linear, problem).empty();
      // In double a case is seen as it is.
      return engine::is_exact_question(method.in_float() ? method.seen(problem) : problem);
    case Kind::query:
      return law::in_domain(problem) && is_small(problem);
    case Kind::rotating:
      return engine::unsupported(Kind::rotating, problem).empty() && problem.t_max < kInfinity<double>;
  }
  return false;
}

}  // namespace

const char* part_name(Kind kind) {
  switch (kind) {
    case Kind::linear:
      return "casts";
    case Kind::query:
      return "queries";
    case Kind::rotating:
      break;
  }
  return "rotating";
}

Contenders chosen_contenders(Kind kind, const std::vector<std::string>& names, const Contenders& others) {
  const std::span<const Method> all = engine::methods(kind);
  for (const std::string& name : names) {
    const auto selects = [&](const Method& one) { return is_named(one, name); };
    if (std::none_of(all.begin(), all.end(), selects)) throw std::runtime_error(no_method(kind, name));
  }
  Contenders chosen;
  for (const Method& method : all) {
    const bool wanted = std::any_of(names.begin(), names.end(),
                                    [&](const std::string& name) { return is_named(method, name); });
    if (names.empty() ? others.empty() && is_default(method) : wanted) chosen.push_back(&method);
  }
  chosen.insert(chosen.end(), others.begin(), others.end());
  return chosen;
}

const Method* find_contender(std::string_view name) {
  for (const Method& method : engine::methods()) {
    if (method.question_name() == name) return &method;
  }
  return nullptr;
}

bool is_question(const Contenders& contenders, const corpus::Case& problem) {
  return std::all_of(contenders.begin(), contenders.end(),
                     [&](const Method* method) { return is_asked_of(*method, problem); });
}

}  // namespace graze::tool
