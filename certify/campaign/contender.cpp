#include "certify/campaign/contender.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "certify/query.hpp"
#include "corpus/format/names.hpp"
#include "properties/judge/answer.hpp"
#include "report/inputs.hpp"

namespace graze::tool {
namespace {

constexpr std::string_view kStandard = "standard";

template <class Methods>
std::vector<Contender> each_of(const Methods& methods) {
  std::vector<Contender> all;
  for (const auto& method : methods) all.push_back(contender_of(method));
  return all;
}

struct Names {
  std::string plain, full, scalar, tier;
};
Names names_of(const Contender& contender) {
  return std::visit(
      [](const auto* method) {
        return Names{method->name, method->full_name(), method->scalar, method->tier};
      },
      contender.method);
}

// Asked for where nothing is named.
bool is_default(const Contender& contender) {
  const Names names = names_of(contender);
  switch (contender.kind()) {
    case PartKind::casts:
      return names.full == "exact/double";
    case PartKind::queries:
      return contender.row != nullptr;
    case PartKind::rotating:
      return names.plain == "certified" || names.plain == "plan";
  }
  return false;
}

bool is_named(const Contender& contender, const std::string& name) {
  const Names names = names_of(contender);
  if (name == kStandard) return names.tier == kStandard && contender.row != nullptr;
  return name == names.full || (name == names.plain && names.scalar == "double");
}

std::string no_method(PartKind kind, const std::string& name, const std::vector<Contender>& all) {
  std::vector<std::string> known;
  for (const Contender& contender : all) {
    const std::string plain = names_of(contender).plain;
    if (std::find(known.begin(), known.end(), plain) == known.end()) known.push_back(plain);
  }
  const char* what = kind == PartKind::casts     ? "linear casts"
                     : kind == PartKind::queries ? "queries"
                                                 : "casts of turning bodies";
  return fmt::format(
      "--method: {} is no method for {}; it is {}, one of them with its scalar (mpr/float), or standard",
      name, what, fmt::join(known, ", "));
}

bool is_asked_of(const Contender& contender, const corpus::Case& problem) {
  switch (contender.kind()) {
    case PartKind::casts: {
      const engine::EngineMethod& method = *std::get<0>(contender.method);
      if (!method.is_exact()) return engine::unsupported(problem).empty();
      // In double a case is seen as it is.
      return engine::is_exact_question(method.scalar == "double" ? problem : method.seen(problem));
    }
    case PartKind::queries:
      return why_invalid(problem).empty() && is_small(problem);
    case PartKind::rotating:
      return engine::unsupported_rotating(problem).empty() && problem.t_max < kInfinity<double> &&
             problem.start_policy == StartPolicy::report;
  }
  return false;
}

}  // namespace

const char* name_of(PartKind kind) {
  switch (kind) {
    case PartKind::casts:
      return "casts";
    case PartKind::queries:
      return "queries";
    case PartKind::rotating:
      break;
  }
  return "rotating";
}

std::string Contender::name() const {
  switch (kind()) {
    case PartKind::casts:
      return std::get<0>(method)->full_name();
    case PartKind::queries:
      return fmt::format("{} {}", corpus::name_of(std::get<1>(method)->query),
                         std::get<1>(method)->full_name());
    case PartKind::rotating:
      break;
  }
  return "rotating " + std::get<2>(method)->full_name();
}

Contender contender_of(const engine::EngineMethod& method) {
  return {&method, engine::find_guarantee(engine::guarantees(), method)};
}
Contender contender_of(const engine::QueryMethod& method) {
  return {&method, engine::find_guarantee(engine::guarantees(), method)};
}
Contender contender_of(const engine::RotatingEngineMethod& method) {
  return {&method, engine::find_guarantee(engine::guarantees(), method)};
}

std::vector<Contender> all_contenders(PartKind kind) {
  switch (kind) {
    case PartKind::casts:
      return each_of(engine::methods());
    case PartKind::queries:
      return each_of(engine::query_methods());
    case PartKind::rotating:
      break;
  }
  return each_of(engine::rotating_methods());
}

std::vector<Contender> chosen_contenders(PartKind kind, const std::vector<std::string>& names) {
  const std::vector<Contender> all = all_contenders(kind);
  std::vector<Contender> chosen;
  for (const std::string& name : names) {
    const auto selects = [&](const Contender& one) { return is_named(one, name); };
    if (std::none_of(all.begin(), all.end(), selects)) throw std::runtime_error(no_method(kind, name, all));
  }
  for (const Contender& contender : all) {
    const bool wanted = std::any_of(names.begin(), names.end(),
                                    [&](const std::string& name) { return is_named(contender, name); });
    if (names.empty() ? is_default(contender) : wanted) chosen.push_back(contender);
  }
  return chosen;
}

std::optional<Contender> find_contender(std::string_view name) {
  for (const PartKind kind : kPartKinds) {
    for (const Contender& contender : all_contenders(kind)) {
      if (contender.name() == name) return contender;
    }
  }
  return std::nullopt;
}

bool is_question(const std::vector<Contender>& contenders, const corpus::Case& problem) {
  return std::all_of(contenders.begin(), contenders.end(),
                     [&](const Contender& contender) { return is_asked_of(contender, problem); });
}

}  // namespace graze::tool
