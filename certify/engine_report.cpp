#include "certify/engine_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "corpus/format/names.hpp"
#include "report/statistics.hpp"
#include "report/table.hpp"

namespace graze::tool {
namespace {

using engine::Failure;
using engine::Method;
using Json = nlohmann::ordered_json;

std::string count_text(std::size_t count) { return count > 0 ? fmt::to_string(count) : "-"; }

std::size_t faults_of(const Tally& tally, std::string_view name) {
  for (std::size_t k = 0; k < law::kFaults; ++k) {
    if (law::kFaultKinds[k].name == name) return tally.faults[k];
  }
  return 0;
}

// "crashed 3, hung 1"
std::string failures_text(const Tally& tally) {
  std::string text;
  for (std::size_t k = 0; k < tally.failures.size(); ++k) {
    if (tally.failures[k].count == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", to_text(static_cast<Failure>(k)),
                        tally.failures[k].count);
  }
  return text.empty() ? "-" : text;
}

// What the engine is held to, in words.
std::string limit_text(const Method& method) {
  const engine::Guarantee& row = *method.guarantee;
  if (row.is_open) return "nothing";
  std::string text;
  const auto add = [&](double x, const char* unit) {
    if (x > 0) text += fmt::format("{}{:g}{}", text.empty() ? "" : " + ", x, unit);
  };
  add(row.kappa_polytope, " u scale");
  add(row.relative_tolerance, " scale");
  add(row.tolerance, "");
  return text.empty() ? "0" : text;
}

std::string id_of(const Tally::Worst& worst) { return worst.id.empty() ? "-" : worst.id; }

Json number_or_null(double x) { return std::isfinite(x) ? Json(x) : Json(); }

// The first of each kind, kept by method.
Json faults_json(const Tally& tally) {
  Json all = Json::object();
  for (std::size_t k = 0; k < law::kFaults; ++k) {
    if (tally.faults[k] == 0) continue;
    all[law::kFaultKinds[k].name] = {
        {"count", tally.faults[k]}, {"first", tally.first[k].id}, {"because", tally.first[k].reason}};
  }
  return all;
}

Json tally_json(const Tally& tally) {
  Json failures = Json::object();
  for (std::size_t k = 0; k < tally.failures.size(); ++k) {
    if (tally.failures[k].count > 0)
      failures[std::string(to_text(static_cast<Failure>(k)))] = tally.failures[k].count;
  }
  return {{"family", tally.family},
          {"cases", tally.cases},
          {"not_asked", tally.not_asked},
          {"faults", faults_json(tally)},
          {"failures", failures},
          {"stalled", tally.stalled},
          {"excused", tally.excused},
          {"by_oracle", tally.by_oracle},
          {"backward",
           {{"median", number_or_null(median(tally.backward))},
            {"worst", number_or_null(worst(tally.backward))}}},
          {"true_backward_worst", number_or_null(worst(tally.true_backward))},
          {"normal_worst", number_or_null(worst(tally.normal))},
          {"witness_worst", number_or_null(worst(tally.witness))},
          {"least_kappa", number_or_null(tally.least_relative.value / tally.method->unit_roundoff)},
          {"least_over_scale", number_or_null(tally.least_relative.value)},
          {"least_tolerance", number_or_null(tally.least_length.value)},
          {"least_by", tally.least_relative.id},
          {"ns_median", number_or_null(median(tally.ns))}};
}

}  // namespace

std::string certificates(const Certification& certification, const Settings& settings) {
  Table table({{"engine", Align::left},
               {"asked"},
               {"not\nasked"},
               {"wrong"},
               {"late"},
               {"early\nor off"},
               {"contact\noff"},
               {"stalls"},
               {"failed", Align::left},
               {"held to", Align::left},
               {"least\nkappa"},
               {"least, over\nscale"},
               {"least\nlength"},
               {"needed by", Align::left}});
  for (const Method* method : settings.methods) {
    if (method->is_ours()) continue;
    const Tally t = certification.total(*method);
    table.add_row({method->question_name(), fmt::to_string(t.cases), count_text(t.not_asked),
                   count_text(faults_of(t, "wrong")), count_text(faults_of(t, "late")),
                   count_text(faults_of(t, "early") + faults_of(t, "off")),
                   count_text(faults_of(t, "contact off")), count_text(t.stalled), failures_text(t),
                   limit_text(*method), short_number(t.least_relative.value / method->unit_roundoff),
                   short_number(t.least_relative.value), short_number(t.least_length.value),
                   id_of(t.least_relative)});
  }
  return table.text() +
         "least: the limit with which every verdict and time would have passed, in units of u scale, over "
         "scale, and "
         "as a\nlength of the cases. held to: what it declares, or the command line says; of one that "
         "declares nothing "
         "only failures\ncount as faults. not asked: what it does not take (docs/engines.md).\n";
}

std::string comparison(const Certification& certification, const Settings& settings) {
  std::vector<const Method*> methods;
  for (const Method* method : settings.methods) {
    if (std::any_of(certification.tallies.begin(), certification.tallies.end(),
                    [&](const Tally& tally) { return tally.method == method && tally.cases > 0; }))
      methods.push_back(method);
  }
  std::string text;
  for (const engine::Kind kind : {engine::Kind::linear, engine::Kind::rotating, engine::Kind::query}) {
    for (const Method* method : methods) {
      if (method->kind != kind) continue;
      if (text.empty())
        text =
            "| engine | family | asked | wrong | late | failed | least over scale "
            "|\n|---|---|---|---|---|---|---|\n";
      for (const Tally& t : certification.tallies) {
        if (t.method != method || t.cases == 0) continue;
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", method->question_name(), t.family,
                            t.cases, count_text(faults_of(t, "wrong")), count_text(faults_of(t, "late")),
                            failures_text(t), short_number(t.least_relative.value));
      }
    }
  }
  return text;
}

std::string certification_json(const Certification& certification, const Settings& settings, double seconds) {
  Json all = {{"schema", "graze.certification/1"},      {"seconds", seconds},
              {"answers", certification.answers},       {"cases", certification.questions},
              {"held", certification.breaches.empty()}, {"breaches", certification.breaches},
              {"unfinished", certification.unfinished}, {"methods", Json::array()}};
  for (const Method* method : settings.methods) {
    Json families = Json::array();
    for (const Tally& tally : certification.tallies) {
      if (tally.method == method && (tally.cases > 0 || tally.not_asked > 0))
        families.push_back(tally_json(tally));
    }
    Json total = tally_json(certification.total(*method));
    total.erase("family");
    all["methods"].push_back(
        {{"name", method->name},
         {"question",
          method->kind == engine::Kind::rotating ? "rotating_cast" : corpus::name_of(method->query)},
         {"scalar", method->scalar},
         {"tier", method->tier},
         {"ours", method->is_ours()},
         {"held_to", method->guarantee == nullptr ? "nothing" : limit_text(*method)},
         {"held", certification.has_kept(*method)},
         {"total", std::move(total)},
         {"families", std::move(families)}});
  }
  return all.dump();
}

}  // namespace graze::tool
