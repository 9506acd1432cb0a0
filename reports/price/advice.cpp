#include "reports/price/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <graze/result.hpp>
#include <graze/rotating_result.hpp>
#include <optional>
#include <utility>

#include "reports/price/overall.hpp"

namespace graze::price {
namespace {

enum class Bodies : std::uint8_t { any, in_float, exact, other_shapes, turning };

struct Rule {
  const char* user;
  const char* wants;
  const char* bodies_text;
  Bodies bodies;
  bool strict;        // neither late nor wrong, and by what its tier promises for every input
  double most_error;  // over scale
};

constexpr const char* kGame =
    "every verdict decided, and no answer off by more than a thousandth of the bodies' size; a float will do";
constexpr const char* kRobot =
    "answers that are never late, not by a bit, and miss no contact, as its tier promises of every input";
constexpr const char* kCad = "the verdict of every tie, and the time as exactly as it can be said";
constexpr Rule kRules[] = {
    {"a game", kGame, "that do not rotate", Bodies::in_float, false, 1e-3},
    {"a game", kGame, "that rotate", Bodies::turning, false, 1e-3},
    {"a robot", kRobot, "that do not rotate", Bodies::any, true, 1},
    {"a robot", kRobot, "that rotate", Bodies::turning, true, 1},
    {"a CAD tool", kCad, "that tier exact answers", Bodies::exact, true, 1e-15},
    {"a CAD tool", kCad, "of other shapes", Bodies::other_shapes, true, 1e-12},
    {"a CAD tool", kCad, "that rotate", Bodies::turning, true, 1e-9},
};

// Costs that differ by less are as good as equal: the rounds of a ratio differ by more.
constexpr double kAlike = 1.05;

bool has_float(const PriceTable& table) {
  return std::any_of(table.rows.begin(), table.rows.end(),
                     [](const Row& row) { return row.scalar == "float"; });
}

Tables tables_of(const Document& document, Bodies bodies) {
  Tables tables = families_of(document, bodies == Bodies::turning);
  std::erase_if(tables, [&](const PriceTable* table) {
    switch (bodies) {
      case Bodies::in_float:
        return !has_float(*table);
      case Bodies::exact:
        return !is_for_exact(*table);
      case Bodies::other_shapes:
        return is_for_exact(*table);
      case Bodies::any:
      case Bodies::turning:
        break;
    }
    return false;
  });
  return tables;
}

// The worst violation of the rule, or nothing if the rule is kept.
std::optional<std::string> fault(const Overall& one, const Rule& rule) {
  if (one.unsettled > 0) return fmt::format("does not answer {} of {}", one.unsettled, one.asked);
  if (one.open > 0) return fmt::format("leaves {} of {} verdicts open", one.open, one.asked);
  if (!(one.worst <= rule.most_error)) return fmt::format("is off by {} of scale", error_text(one.worst));
  if (rule.strict && one.wrong > 0) return fmt::format("is wrong in {} of {}", one.wrong, one.asked);
  if (rule.strict && one.late > 0)
    return fmt::format("is late in {} of {}, by {} of scale", one.late, one.asked, error_text(one.late_by));
  if (rule.strict && one.row->tier == "standard") return "is as right here, but its tier does not promise it";
  return {};
}

// Among equal costs: the method that cast() uses by default, and one that rounds correctly.
bool comes_first(const Row& row) { return row.method == "plan" || row.tier == "exact"; }

Advice advice_by(const Rule& rule, const Tables& tables) {
  const std::vector<Overall> all = overall(tables);
  Advice out{.user = rule.user, .wants = rule.wants, .bodies = rule.bodies_text};
  out.tables = tables.size();
  out.baseline = tables.front()->baseline;
  const Overall* taken = nullptr;
  for (const Overall& one : all) {
    if (fault(one, rule)) continue;
    if (taken == nullptr) taken = &one;
    if (one.cost > kAlike * taken->cost) break;
    if (comes_first(*one.row) && !comes_first(*taken->row)) taken = &one;
  }
  if (taken == nullptr) {
    out.because = "none of those that were timed will do";
    return out;
  }
  out.label = taken->row->label;
  out.call = call_of(*taken->row);
  out.cost = {.median = taken->cost, .low = taken->least, .high = taken->most};
  out.worst = taken->worst;
  out.asked = taken->asked;
  out.wrong = taken->wrong;
  if (taken->wrong > 0) out.denied = taken->denied;
  out.because = "no other is cheaper";
  for (const Overall& one : all) {
    if (&one == taken) break;
    if (const std::optional<std::string> what = fault(one, rule))
      out.because =
          fmt::format("the next cheaper, {} ({} times), {}", one.row->label, times_text(one.cost), *what);
  }
  return out;
}

// The name in the options of a method of tier standard. Nothing if cast() uses it by default.
std::string enumerator_of(const std::string& method) {
  if (method == "ca") return fmt::format("Method::{}", to_text(Method::conservative_advancement));
  if (method == "gjk") return fmt::format("Method::{}", to_text(Method::gjk_ray_cast));
  if (method == "mpr") return fmt::format("Method::{}", to_text(Method::mpr_sweep));
  return {};
}
std::string rotating_enumerator_of(const std::string& method) {
  using By = RotatingMethod;
  constexpr std::pair<const char*, By> kNames[] = {{"ca", By::conservative_advancement},
                                                   {"bilateral", By::bilateral_advancement},
                                                   {"bilateral_published", By::bilateral_published},
                                                   {"steps", By::time_steps},
                                                   {"spheres", By::bounding_spheres}};
  for (const auto& [name, by] : kNames) {
    if (method == name) return fmt::format("RotatingMethod::{}", to_text(by));
  }
  return {};
}

}  // namespace

std::string call_of(const Row& row) {
  const bool turning = row.question.starts_with("rotating");
  std::vector<std::string> options;
  if (row.tier != "standard") {
    options.push_back(".tier = graze::Tier::" + row.tier);
  } else {
    const std::string name = turning ? rotating_enumerator_of(row.method) : enumerator_of(row.method);
    if (!name.empty()) options.push_back(".method = graze::" + name);
  }
  if (row.tolerance > 0)
    options.push_back(fmt::format(".tolerance = {:.0e}{}", row.tolerance, row.scalar == "float" ? "f" : ""));
  return fmt::format("// {}Body<{}>\ngraze::cast(a, b{})", turning ? "Rotating" : "", row.scalar,
                     options.empty() ? "" : fmt::format(", {{{}}}", fmt::join(options, ", ")));
}

std::vector<Advice> advice_of(const Document& document) {
  std::vector<Advice> out;
  for (const Rule& rule : kRules) {
    const Tables tables = tables_of(document, rule.bodies);
    if (!tables.empty()) out.push_back(advice_by(rule, tables));
  }
  return out;
}

}  // namespace graze::price
