#include "reports/pages/price_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <map>
#include <stdexcept>
#include <vector>

#include "corpus/format/case_io.hpp"
#include "corpus/format/json_value.hpp"
#include "engines/guarantees.hpp"
#include "reports/pages/page.hpp"

namespace graze::show {
namespace {

using corpus::Case;
using engine::Method;

// Checks that the fields which the page reads are present. The schema checks their values.
void require(const Json& object, const std::string& where, std::initializer_list<const char*> fields) {
  if (!object.is_object()) throw std::runtime_error(where + ": is an object");
  for (const char* field : fields) {
    if (!object.contains(field)) throw std::runtime_error(fmt::format("{}: has no {}", where, field));
  }
}

void require_price(const Json& document) {
  if (!document.is_object() || document.value("schema", Json()) != "graze.price/1")
    throw std::runtime_error("schema: is not graze.price/1, which graze price --json writes");
  require(document, "the document",
          {"version", "seed", "rounds", "finished", "machine", "tables", "sentences"});
  require(document["machine"], "machine", {"processor", "cores", "compiler", "build", "load"});
  for (std::size_t i = 0; i < document["sentences"].size(); ++i)
    require(document["sentences"][i], fmt::format("sentences[{}]", i), {"topic", "text"});
  for (std::size_t i = 0; i < document["tables"].size(); ++i) {
    const Json& table = document["tables"][i];
    const std::string at = fmt::format("tables[{}]", i);
    require(table, at,
            {"part", "series", "x", "x_name", "name", "group", "kind", "title", "sentence", "cases", "rows",
             "shown"});
    for (std::size_t k = 0; k < table["rows"].size(); ++k) {
      const Json& row = table["rows"][k];
      const std::string of_row = fmt::format("{}.rows[{}]", at, k);
      require(row, of_row,
              {"label", "method", "scalar", "tier", "tolerance", "ours", "time", "ratio", "backward",
               "forward", "failures", "wrong", "late", "supports", "on_front", "worst_case", "slowest_case"});
      if (!row["time"].is_null()) require(row["time"], of_row + ".time", {"median", "p95", "p99"});
      for (const char* errors : {"backward", "forward"})
        require(row[errors], fmt::format("{}.{}", of_row, errors), {"median", "p99", "worst"});
      require(row["failures"], of_row + ".failures", {"not_converged", "no_time", "refused"});
      require(row["supports"], of_row + ".supports", {"mean"});
    }
  }
}

// One of ours, asked for a tolerance and held to it as well.
struct Asked {
  Method method;
  engine::Guarantee guarantee;
};

class Scenes {
 public:
  explicit Scenes(const PricePageSettings& settings) : settings_(settings) {}

  // The cases that a table's rows name, those of rows at fault first.
  void take(const Json& table) {
    std::vector<const Json*> rows;
    for (const Json& row : table["rows"]) rows.push_back(&row);
    std::stable_partition(rows.begin(), rows.end(),
                          [](const Json* row) { return (*row)["wrong"] != 0 || (*row)["late"] != 0; });
    for (const Json* row : rows) {
      for (const char* which : {"worst_case", "slowest_case"}) take_case(table, *row, (*row)[which]);
    }
  }

  Json operator()() const {
    Json out = Json::object();
    for (const auto& [id, held] : cases_) {
      std::vector<const Method*> methods;
      for (const Asked* asked : held.second) methods.push_back(&asked->method);
      out[id] = scene_of(held.first, methods, {.has_still = !has_viewer()});
    }
    return out;
  }

 private:
  void take_case(const Json& table, const Json& row, const std::string& id) {
    if (id.empty()) return;
    auto found = cases_.find(id);
    if (found == cases_.end()) {
      if (cases_.size() >= settings_.most_scenes) return;
      const auto shown = std::find_if(table["shown"].begin(), table["shown"].end(),
                                      [&](const Json& one) { return one.value("id", "") == id; });
      if (shown == table["shown"].end() || !shown->contains("case") || (*shown)["case"].is_null()) return;
      corpus::ReadResult read = corpus::read_text(corpus::document_text((*shown)["case"]), id, false);
      if (!read.ok() || read.cases.size() != 1) return;
      found = cases_.emplace(id, std::pair(std::move(read.cases.front()), std::vector<const Asked*>{})).first;
    }
    constexpr std::size_t kMostAnswers = 6;
    const Asked* asked = method_of(row, found->second.first);
    auto& answers = found->second.second;
    const bool is_new = std::find(answers.begin(), answers.end(), asked) == answers.end();
    if (asked != nullptr && is_new && answers.size() < kMostAnswers) answers.push_back(asked);
  }

  const Asked* method_of(const Json& row, const Case& problem) {
    if (!row["ours"].get<bool>()) return nullptr;
    const std::string label = row["label"];
    if (const auto known = by_label_.find(label); known != by_label_.end()) return known->second;
    const std::string name = row["method"].get<std::string>() + "/" + row["scalar"].get<std::string>();
    const Method* method = problem.query != corpus::Query::cast ? engine::find_method(problem.query, name)
                           : engine::turns(problem) ? engine::find_method(engine::Kind::rotating, name)
                                                    : engine::find_method(engine::Kind::linear, name);
    if (method == nullptr) return nullptr;
    Asked& asked = asked_.emplace_back(Asked{.method = *method, .guarantee = {}});
    if (const double tolerance = row["tolerance"]; tolerance > 0) {
      asked.method.name += fmt::format(" to {:g}", tolerance);
      asked.method.ask = [ask = method->ask, tolerance](const Case& one, engine::Ask how) {
        how.tolerance = tolerance;
        return ask(one, how);
      };
      if (method->guarantee != nullptr) {
        asked.guarantee = *method->guarantee;
        asked.guarantee.relative_tolerance = std::max(asked.guarantee.relative_tolerance, tolerance);
        asked.method.guarantee = &asked.guarantee;
      }
    }
    by_label_.emplace(label, &asked);
    return &asked;
  }

  const PricePageSettings& settings_;
  std::list<Asked> asked_;  // a list, so that addresses do not change
  std::map<std::string, const Asked*> by_label_;
  std::map<std::string, std::pair<Case, std::vector<const Asked*>>> cases_;
};

}  // namespace

Json read_price(std::string_view text) { return corpus::parse_document(text); }

std::string price_page(const Json& document, const PricePageSettings& settings) {
  try {
    require_price(document);
    Scenes scenes(settings);
    for (const Json& table : document["tables"]) scenes.take(table);
    Json price = document;
    for (Json& table : price["tables"]) table.erase("shown");
    const std::string title = "graze price: what accuracy costs in time";
    const Json data = {{"schema", "graze.page/1"},    {"kind", "price"},           {"title", title},
                       {"command", settings.command}, {"price", std::move(price)}, {"scenes", scenes()}};
    std::string plain = settings.plain;
    if (plain.empty()) {
      for (const Json& sentence : document["sentences"]) plain += sentence["text"].get<std::string>() + "\n";
    }
    return page_html(title, data, plain);
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("is no graze.price/1: ") + error.what());
  }
}

}  // namespace graze::show
