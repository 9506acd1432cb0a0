#include "engines/guarantees.hpp"

#include <algorithm>
#include <cmath>
#include <graze/detail/shapes/shape_tree.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "corpus/format/json_value.hpp"
#include "corpus/format/names.hpp"
#include "corpus/format/proof_io.hpp"
#include "engines/guarantees_text.hpp"

namespace graze::engine {
namespace {

using Json = nlohmann::ordered_json;

// A guarantee above these must name the mechanism.
constexpr double kPlainKappa = 1024;

constexpr std::string_view kRotating = "rotating";

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw std::runtime_error(where + ": " + what);
}

const Json& field(const Json& row, const std::string& where, const char* name) {
  const auto found = row.find(name);
  if (found == row.end()) refuse(where, std::string("the field \"") + name + "\" is missing");
  return *found;
}

std::string text_field(const Json& row, const std::string& where, const char* name) {
  const Json& value = field(row, where, name);
  if (!value.is_string()) refuse(where + "." + name, "must be a string");
  return value.get<std::string>();
}

double number_field(const Json& row, const std::string& where, const char* name) {
  const Json& value = field(row, where, name);
  if (!value.is_number() || !(value.get<double>() >= 0)) refuse(where + "." + name, "must be a number >= 0");
  return value.get<double>();
}

std::optional<int> count_field(const Json& row, const std::string& where, const char* name) {
  if (!row.contains(name)) return {};
  const Json& value = row[name];
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() == 0 ||
      value.get<std::uint64_t>() > std::uint64_t{std::numeric_limits<int>::max()}) {
    refuse(where + "." + name, "must be a whole number from 1 to 2147483647");
  }
  return value.get<int>();
}

Unseen unseen_field(const Json& row, const std::string& where, const char* name) {
  if (!row.contains(name)) return Unseen::nothing;
  const std::string text = text_field(row, where, name);
  if (text == "nothing") return Unseen::nothing;
  if (text == "hidden_motion") return Unseen::hidden_motion;
  if (text == "anything") return Unseen::anything;
  refuse(where + "." + name, "must be nothing, hidden_motion or anything");
}

Guarantee parse_row(const Json& row, const std::string& where) {
  static const std::set<std::string> kFields = {
      "query",     "method",    "scalar",   "tier",        "kappa_polytope", "kappa_rounded", "kappa_contact",
      "stall_cap", "mechanism", "may_miss", "may_be_late", "width",          "most_supports", "open_cap"};
  if (!row.is_object()) refuse(where, "must be an object");
  for (const auto& [key, value] : row.items()) {
    if (!kFields.contains(key)) refuse(where + "." + key, "is not a field of a row");
  }
  // Default: a guarantee about casts.
  const std::string query = row.contains("query") ? text_field(row, where, "query") : "cast";
  const bool rotating = query == kRotating;
  if (!rotating &&
      std::find(corpus::kQueryNames.begin(), corpus::kQueryNames.end(), query) == corpus::kQueryNames.end()) {
    refuse(where + ".query", "is no query; it is rotating, or one that docs/reference/case-format.md lists");
  }
  Guarantee g{
      .query = query,
      .method = text_field(row, where, "method"),
      .scalar = text_field(row, where, "scalar"),
      .tier = text_field(row, where, "tier"),
      .kappa_polytope = number_field(row, where, "kappa_polytope"),
      .kappa_rounded = number_field(row, where, "kappa_rounded"),
      .kappa_contact = row.contains("kappa_contact")
                           ? std::optional(number_field(row, where, "kappa_contact"))
                           : std::nullopt,
      .stall_cap = number_field(row, where, "stall_cap"),
      .most_supports = count_field(row, where, "most_supports"),
      .open_cap =
          row.contains("open_cap") ? std::optional(number_field(row, where, "open_cap")) : std::nullopt,
      .mechanism = text_field(row, where, "mechanism"),
      .may_miss = unseen_field(row, where, "may_miss"),
      .may_be_late = unseen_field(row, where, "may_be_late"),
      .width = row.contains("width") ? std::optional(number_field(row, where, "width")) : std::nullopt};
  const bool beyond =
      std::max({g.kappa_polytope, g.kappa_rounded, g.kappa_contact.value_or(0)}) > kPlainKappa ||
      g.stall_cap > kPlainStallCap || g.may_miss != Unseen::nothing || g.may_be_late != Unseen::nothing;
  if (beyond && g.mechanism.empty()) {
    refuse(where + ".mechanism",
           "must name what needs a kappa above 1024, a stall cap above 0.001, or something unseen");
  }
  if (!rotating && (g.may_miss != Unseen::nothing || g.may_be_late != Unseen::nothing)) {
    refuse(where, "may_miss and may_be_late are fields of rows of rotating");
  }
  return g;
}

}  // namespace

bool is_rounded(const corpus::Case& problem) {
  const auto is_round = [](const Body<double>& body) {
    return detail::is_curved(body.shape) || detail::common_radius(body.shape) > 0;
  };
  return is_round(problem.a) || is_round(problem.b) || problem.target_distance > 0;
}

double Guarantee::kappa(const corpus::Case& problem) const {
  return is_rounded(problem) ? kappa_rounded : kappa_polytope;
}

std::vector<Guarantee> parse_guarantees(std::string_view text) {
  const Json document = corpus::parse_document(text);
  if (!document.is_object()) refuse("guarantees", "must be one JSON object");
  if (text_field(document, "guarantees", "schema") != "graze.guarantees/1") {
    refuse("guarantees.schema", "must be \"graze.guarantees/1\"");
  }
  const Json& rows = field(document, "guarantees", "rows");
  if (!rows.is_array() || rows.empty()) refuse("guarantees.rows", "must be an array with a row or more");
  std::vector<Guarantee> table;
  std::set<std::string> names;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string where = "guarantees.rows[" + std::to_string(i) + "]";
    table.push_back(parse_row(rows[i], where));
    if (!names.insert(table.back().name()).second) refuse(where, "repeats the row of " + table.back().name());
  }
  return table;
}

std::span<const Guarantee> guarantees() {
  static const std::vector<Guarantee> kTable = parse_guarantees(kGuaranteesText);
  return kTable;
}

const Guarantee* find_guarantee(std::span<const Guarantee> table, std::string_view query,
                                std::string_view method, std::string_view scalar, std::string_view tier) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Guarantee& row) {
    return row.query == query && row.method == method && row.scalar == scalar && row.tier == tier;
  });
  return found == table.end() ? nullptr : &*found;
}

const Guarantee* find_guarantee(std::span<const Guarantee> table, const Method& method) {
  const std::string_view query = method.kind == Kind::rotating ? kRotating : corpus::name_of(method.query);
  return find_guarantee(table, query, method.name, method.scalar, method.tier);
}

double kappa_of(const corpus::ProofRecord& record) {
  if (!record.tier) return 0;
  const std::string_view query = record.rotating ? kRotating : corpus::name_of(corpus::Query::cast);
  const Guarantee* row =
      find_guarantee(guarantees(), query, record.method, record.scalar, to_text(*record.tier));
  return row == nullptr ? 0 : row->kappa(record.problem);
}

}  // namespace graze::engine
