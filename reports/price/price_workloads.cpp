#include "reports/price/price_workloads.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "corpus/workloads.hpp"
#include "reports/text/progress.hpp"
#include "reports/text/table.hpp"

namespace graze::price {
namespace {

constexpr const char* kMethods[] = {"plan/float", "plan/double", "certified/double"};
constexpr int kRepeats = 3;  // of each cast, since other load on the machine falls on one of them

std::string place_of(double level) { return level > 0 ? "1 km out" : "origin"; }

double quantile(std::vector<double>& values, double q) {
  if (values.empty()) return kNone;
  const auto rank = static_cast<std::size_t>(q * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::min(rank, values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void count(WorkloadRow& row, Outcome outcome) {
  switch (outcome) {
    case Outcome::hit:
      ++row.hits;
      break;
    case Outcome::miss:
      ++row.misses;
      break;
    case Outcome::initially_overlapping:
      ++row.overlapping;
      break;
    case Outcome::not_converged:
      ++row.not_converged;
      break;
    case Outcome::invalid_input:
      ++row.refused;
      break;
  }
}

// Empty if it is stopped.
std::optional<WorkloadRow> measure(const corpus::Family& workload, double level, const engine::Method& method,
                                   const WorkloadSettings& settings, tool::Progress& progress) {
  WorkloadRow row{
      .workload = std::string(workload.name), .place = place_of(level), .method = method.full_name()};
  std::vector<double> times;
  for (std::uint64_t i = 0; i < settings.casts; ++i) {
    if (settings.stop()) return std::nullopt;
    const corpus::Case problem = workload.generate(level, settings.seed + i);
    const engine::Ask ask{.request = engine::kPlain};
    const engine::Answer answer = method.ask(problem, ask);
    count(row, answer.outcome);
    progress.advance(1, row.workload);
    if (answer.outcome == Outcome::invalid_input) continue;
    if (answer.counters.supports > row.most_supports) {
      row.most_supports = answer.counters.supports;
      row.worst = problem.id;
    }
    double least = kInfinity<double>;
    for (int repeat = 0; repeat < kRepeats; ++repeat)
      least = std::min(least, method.time_ns(problem, ask, 1));
    times.push_back(least);
  }
  row.median_ns = quantile(times, 0.5);
  row.p99_ns = quantile(times, 0.99);
  row.p999_ns = quantile(times, 0.999);
  return row;
}

std::string microseconds(double ns) { return std::isnan(ns) ? "-" : fmt::format("{:.1f}", ns / 1e3); }

std::vector<std::string> cells_of(const WorkloadRow& row) {
  return {row.workload,
          row.place,
          row.method,
          fmt::format("{}", row.casts()),
          fmt::format("{}", row.hits),
          fmt::format("{}", row.misses),
          fmt::format("{}", row.overlapping),
          fmt::format("{}", row.not_converged),
          fmt::format("{}", row.refused),
          microseconds(row.median_ns),
          microseconds(row.p99_ns),
          microseconds(row.p999_ns),
          fmt::format("{}", row.most_supports)};
}

// A row for each method, over all workloads and places.
std::vector<WorkloadRow> totals(const std::vector<WorkloadRow>& rows) {
  std::vector<WorkloadRow> out;
  for (const char* method : kMethods) {
    WorkloadRow sum{.workload = "all", .place = "both", .method = method};
    for (const WorkloadRow& row : rows) {
      if (row.method != method) continue;
      sum.hits += row.hits;
      sum.misses += row.misses;
      sum.overlapping += row.overlapping;
      sum.not_converged += row.not_converged;
      sum.refused += row.refused;
      // The largest of the rows': no quantile of all, and never less than one.
      sum.median_ns = std::fmax(sum.median_ns, row.median_ns);
      sum.p99_ns = std::fmax(sum.p99_ns, row.p99_ns);
      sum.p999_ns = std::fmax(sum.p999_ns, row.p999_ns);
      if (row.most_supports > sum.most_supports) {
        sum.most_supports = row.most_supports;
        sum.worst = row.worst;
      }
    }
    if (sum.casts() > 0) out.push_back(std::move(sum));
  }
  return out;
}

constexpr const char* kHeaders[] = {"workload", "place",      "method",        "casts",   "hits",
                                    "misses",   "in contact", "not converged", "refused", "median µs",
                                    "p99 µs",   "p99.9 µs",   "most supports"};

}  // namespace

std::vector<WorkloadRow> measure_workloads(const WorkloadSettings& settings) {
  std::vector<WorkloadRow> rows;
  std::vector<const corpus::Family*> wanted;
  for (const corpus::Family& workload : corpus::workloads()) {
    const auto& only = settings.only;
    if (only.empty() || std::find(only.begin(), only.end(), workload.name) != only.end())
      wanted.push_back(&workload);
  }
  std::uint64_t total = 0;
  for (const corpus::Family* workload : wanted)
    total += settings.casts * workload->levels.size() * std::size(kMethods);
  tool::Progress progress("workloads, casts", total, 0, tool::Progress::Show::percent);
  for (const corpus::Family* workload : wanted) {
    for (const double level : workload->levels) {
      for (const char* name : kMethods) {
        const engine::Method& method = *engine::find_method(engine::Kind::rotating, name);
        std::optional<WorkloadRow> row = measure(*workload, level, method, settings, progress);
        if (!row) return rows;
        rows.push_back(std::move(*row));
      }
    }
  }
  return rows;
}

std::string workload_table(const std::vector<WorkloadRow>& rows) {
  std::vector<tool::Column> columns;
  for (const char* header : kHeaders) {
    const bool is_word = columns.size() < 3;
    columns.push_back({header, is_word ? tool::Align::left : tool::Align::right});
  }
  tool::Table table(std::move(columns));
  for (const WorkloadRow& row : rows) table.add_row(cells_of(row));
  table.add_gap();
  for (const WorkloadRow& row : totals(rows)) table.add_row(cells_of(row));
  return table.text();
}

std::string workload_page(const std::vector<WorkloadRow>& rows, const WorkloadSettings& settings,
                          const Machine& machine) {
  const std::time_t now = std::time(nullptr);
  std::string text = fmt::format(
      "# Workloads: what the steps of simulations cost\n\n"
      "A report for users of simulators and planners, written by\n\n"
      "    graze price --workloads {} --page docs/reports/workloads.md\n\n"
      "on {:%Y-%m-%d}, on {} ({} cores, load {:.1f}), {}, {}. [workloads.md](../reference/workloads.md) says "
      "what "
      "each\n"
      "workload is. Standard tier: `plan` in float and in double, tolerance 0. Certified tier: `certified` "
      "in\n"
      "double. Times are of one cast with normal and witnesses, processor time, the least of {}. `all` has "
      "the\n"
      "largest of each column. *Refused* counts questions that a tier does not take (the start policy\n"
      "`pass_over`).\n\n",
      settings.casts, fmt::gmtime(now), machine.processor, machine.cores, machine.load, machine.compiler,
      machine.build, kRepeats);
  const auto line = [&](const std::vector<std::string>& cells) {
    text += fmt::format("| {} |\n", fmt::join(cells, " | "));
  };
  line(std::vector<std::string>(std::begin(kHeaders), std::end(kHeaders)));
  text += "|---|---|---";
  for (std::size_t i = 3; i < std::size(kHeaders); ++i) text += "|--:";
  text += "|\n";
  for (const WorkloadRow& row : rows) line(cells_of(row));
  for (const WorkloadRow& row : totals(rows)) line(cells_of(row));
  text += "\nThe cast with the most supports of each method:\n\n";
  for (const WorkloadRow& row : totals(rows))
    text += fmt::format("- `{}`: `{}`, {} supports\n", row.method, row.worst, row.most_supports);
  return text;
}

}  // namespace graze::price
