#include "certify/engine_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <nlohmann/json.hpp>

#include "corpus/format/json_value.hpp"
#include "corpus/format/names.hpp"
#include "corpus/format/xml_text.hpp"
#include "reports/text/statistics.hpp"
#include "reports/text/table.hpp"

namespace graze::tool {
namespace {

using engine::Failure;
using engine::Method;
using Json = nlohmann::ordered_json;

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
          {"not_asked", tally.skipped},
          {"declined", tally.declined},
          {"faults", faults_json(tally)},
          {"failures", failures},
          {"open", tally.left_open},
          {"stalled", tally.stalled},
          {"excused", tally.within_tolerance},
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
          {"supports",
           {{"median", number_or_null(median(tally.supports))},
            {"most", number_or_null(tally.most_supports.value)},
            {"most_by", tally.most_supports.id}}},
          {"ns_median", number_or_null(median(tally.ns))}};
}

// The failures on a family: the lines of the verdict, then the first case of each fault.
std::string why_failed(const Tally& tally, const std::vector<std::string>& lines) {
  std::string text = fmt::format("{}\n", fmt::join(lines, "\n"));
  for (std::size_t k = 0; k < law::kFaults; ++k) {
    if (tally.faults[k] > 0)
      text += fmt::format("{} ({}): {}: {}\n", law::kFaultKinds[k].name, tally.faults[k], tally.first[k].id,
                          tally.first[k].reason);
  }
  for (std::size_t k = 1; k < tally.failures.size(); ++k) {
    const Tally::Failed& failed = tally.failures[k];
    if (failed.count > 0)
      text += fmt::format("{} ({}): {}: {}\n", to_text(static_cast<Failure>(k)), failed.count,
                          failed.first.id, failed.first.reason);
  }
  return text;
}

}  // namespace

std::string limit_text(const engine::Guarantee& row) {
  if (row.is_open) return "nothing";
  std::string text;
  const auto add = [&](double x, const char* unit) {
    if (x > 0) text += fmt::format("{}{:g}{}", text.empty() ? "" : " + ", x, unit);
  };
  add(row.kappa_polytope, " u scale");
  add(row.relative_tolerance, " scale");
  add(row.tolerance, "");
  add(row.own_frames, " of own frames");
  return (text.empty() ? "0" : text) + (row.is_assumed ? " (none declared)" : "");
}

namespace {

// A limit is rounded up: 1.44 passes with 1.5, and not with 1.4. Two digits of x round by x / 20 at most.
std::string no_less_than(double x) {
  std::string text = short_number(x);
  if (std::isfinite(x) && std::strtod(text.c_str(), nullptr) < x) text = short_number(1.05 * x);
  return text;
}

// How many answers had a normal that was judged, and how many had witnesses: "812, -".
std::string contacts_text(const Tally& tally) {
  const auto judged = [](const std::vector<double>& errors) {
    return static_cast<std::size_t>(
        std::count_if(errors.begin(), errors.end(), [](double error) { return !std::isnan(error); }));
  };
  const std::size_t normals = judged(tally.normal), witnesses = judged(tally.witness);
  return normals + witnesses == 0 ? "-" : fmt::format("{}, {}", count_text(normals), count_text(witnesses));
}

// A table with a line for each total.
std::string table_of(const std::vector<Tally>& totals) {
  Table table({{"engine", Align::left},
               {"asked"},
               {"not\nasked"},
               {"declined"},
               {"wrong"},
               {"late"},
               {"early\nor off"},
               {"normals,\nwitnesses"},
               {"contact\noff"},
               {"stalls"},
               {"failed", Align::left},
               {"held to", Align::left},
               {"least\nkappa"},
               {"least, over\nscale"},
               {"least\nlength"},
               {"needed by", Align::left}});
  for (const Tally& t : totals) {
    const Method* method = t.method;
    table.add_row(
        {method->question_name(), fmt::to_string(t.cases), count_text(t.skipped), count_text(t.declined),
         count_text(faults_of(t, "wrong")), count_text(faults_of(t, "late")),
         count_text(faults_of(t, "early") + faults_of(t, "off")), contacts_text(t),
         count_text(faults_of(t, "contact off")), count_text(t.stalled), failures_text(t),
         limit_text(*method->guarantee), no_less_than(t.least_relative.value / method->unit_roundoff),
         no_less_than(t.least_relative.value), no_less_than(t.least_length.value), id_of(t.least_relative)});
  }
  return table.text();
}

}  // namespace

std::string certificates(const Certification& certification, const Settings& settings) {
  std::vector<Tally> totals, beyond;
  for (const Method* method : settings.methods) {
    if (!method->is_ours()) totals.push_back(certification.total(*method));
  }
  for (const Tally& tally : certification.beyond_limits) {
    if (tally.cases > 0) beyond.push_back(tally);
  }
  std::string out =
      table_of(totals) +
      "least: the limit with which every verdict and time would have passed, in units of u scale, over "
      "scale, and as a\n"
      "length of the cases. held to: the bound that it declares, or of the command line, or 0.001 of "
      "scale. With --measure\n"
      "only failures count as faults. not asked: questions that it does not support. declined: questions "
      "that it supports\n"
      "and answers with unsupported (docs/reference/protocol.md).\n";
  if (!beyond.empty())
    out +=
        "\nBeyond the documented limits of the engines (not part of the above, and not counted as "
        "faults):\n" +
        table_of(beyond);
  return out;
}

std::string time_table(const Certification& certification, const Settings& settings) {
  // Not finite: it was WASM, or gave no time.
  const auto times_of = [](const Tally& tally) {
    std::vector<double> ns;
    std::copy_if(tally.ns.begin(), tally.ns.end(), std::back_inserter(ns),
                 [](double x) { return std::isfinite(x); });
    return ns;
  };
  std::vector<const Method*> timed;
  bool has_others = false;
  std::vector<std::string> without;
  for (const Method* method : settings.methods) {
    if (method->kind == engine::Kind::query) continue;
    const bool is_timed = !times_of(certification.total(*method)).empty();
    if (is_timed) timed.push_back(method);
    if (!is_timed && !method->is_ours()) without.push_back(method->question_name());
    has_others = has_others || (is_timed && !method->is_ours());
  }
  if (!has_others) return "";
  std::vector<Column> columns = {{"family", Align::left}};
  for (const Method* method : timed) columns.push_back({method->question_name()});
  Table table(columns);
  std::vector<std::string> families;
  for (const Tally& tally : certification.tallies) {
    if (std::find(families.begin(), families.end(), tally.family) == families.end())
      families.push_back(tally.family);
  }
  for (const std::string& family : families) {
    std::vector<std::string> row = {family};
    bool is_any = false;
    for (const Method* method : timed) {
      std::vector<double> ns;
      for (const Tally& tally : certification.tallies) {
        if (tally.method == method && tally.family == family) ns = times_of(tally);
      }
      is_any = is_any || !ns.empty();
      row.push_back(ns.empty() ? "-" : fmt::format("{:.0f}", median(ns)));
    }
    if (is_any) table.add_row(std::move(row));
  }
  return fmt::format(
      "Time of a call (ns, the median over a sample of the cases that it takes), by its own repeated calls "
      "in its own "
      "loop:\n\n{}{}A pipe's time is in none of them.\n",
      table.text(),
      without.empty()
          ? ""
          : fmt::format("Not in the table, since their answers hold no time of machine code: {}.\n",
                        fmt::join(without, ", ")));
}

std::string certification_json(const Certification& certification, const Settings& settings, double seconds) {
  Json all = {{"schema", "graze.certification/1"},
              {"seconds", seconds},
              {"answers", certification.answers},
              {"cases", certification.questions},
              {"held", certification.breaches.empty()},
              {"breaches", certification.breaches},
              {"declined", certification.declined},
              {"unfinished", certification.unfinished},
              {"methods", Json::array()}};
  for (const Method* method : settings.methods) {
    Json families = Json::array();
    for (const Tally& tally : certification.tallies) {
      if (tally.method == method && (tally.cases > 0 || tally.skipped > 0))
        families.push_back(tally_json(tally));
    }
    Json total = tally_json(certification.total(*method));
    total.erase("family");
    Json beyond;
    for (const Tally& tally : certification.beyond_limits) {
      if (tally.method != method || tally.cases == 0) continue;
      beyond = tally_json(tally);
      beyond.erase("family");
    }
    all["methods"].push_back(
        {{"name", method->name},
         {"question",
          method->kind == engine::Kind::rotating ? "rotating_cast" : corpus::name_of(method->query)},
         {"scalar", method->scalar},
         {"tier", method->tier},
         {"ours", method->is_ours()},
         {"held_to", method->guarantee == nullptr ? "nothing" : limit_text(*method->guarantee)},
         {"held", certification.has_kept(*method)},
         {"total", std::move(total)},
         {"beyond_limits", std::move(beyond)},
         {"families", std::move(families)}});
  }
  return corpus::document_text(all);
}

std::string certification_junit(const Certification& certification, const Settings& settings,
                                double seconds) {
  std::string suites;
  std::size_t all_tests = 0, all_failed = 0;
  std::vector<std::string> told;  // breaches that a family has
  for (const Method* method : settings.methods) {
    std::string tests;
    std::size_t count = 0, failed = 0, skipped = 0;
    for (const Tally& tally : certification.tallies) {
      if (tally.method != method || (tally.cases == 0 && tally.skipped == 0)) continue;
      ++count;
      tests += fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                           corpus::xml_text(method->question_name()), corpus::xml_text(tally.family));
      if (const std::vector<std::string> lines = breaches(tally); !lines.empty()) {
        ++failed;
        told.insert(told.end(), lines.begin(), lines.end());
        tests += fmt::format(">\n      <failure message=\"{}\">{}</failure>\n    </testcase>\n",
                             corpus::xml_text(lines.front()), corpus::xml_text(why_failed(tally, lines)));
      } else if (tally.cases == 0) {
        ++skipped;
        tests += fmt::format(
            ">\n      <skipped message=\"{} cases, none that it takes\"/>\n    </testcase>\n", tally.skipped);
      } else {
        tests += "/>\n";
      }
    }
    if (count == 0) continue;
    all_tests += count;
    all_failed += failed;
    suites += fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\">\n{}  </testsuite>\n",
        corpus::xml_text(method->question_name()), count, failed, skipped, tests);
  }
  std::vector<std::string> others;
  for (const std::string& breach : certification.breaches) {
    if (std::find(told.begin(), told.end(), breach) == told.end()) others.push_back(breach);
  }
  if (!others.empty()) {
    ++all_tests;
    ++all_failed;
    suites += fmt::format(
        "  <testsuite name=\"run\" tests=\"1\" failures=\"1\">\n    <testcase classname=\"run\" "
        "name=\"ends\">\n      "
        "<failure message=\"{}\">{}</failure>\n    </testcase>\n  </testsuite>\n",
        corpus::xml_text(others.front()), corpus::xml_text(fmt::format("{}\n", fmt::join(others, "\n"))));
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"graze certify\" tests=\"{}\" "
      "failures=\"{}\" "
      "time=\"{:.3f}\">\n{}</testsuites>",
      all_tests, all_failed, seconds, suites);
}

}  // namespace graze::tool
