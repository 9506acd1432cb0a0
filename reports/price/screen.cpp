#include "reports/price/screen.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "reports/price/overall.hpp"
#include "reports/text/table.hpp"

namespace graze::price {
namespace {

using tool::Align;
using tool::short_number;
using tool::Table;

std::string count_text(std::size_t count) { return count > 0 ? fmt::to_string(count) : "-"; }
std::string mean_text(double x) { return std::isnan(x) ? "-" : fmt::format("{:.1f}", x); }
std::string ns(double x) { return std::isnan(x) ? "-" : fmt::format("{:.0f}", x); }

std::string ratio_text(const std::optional<Spread>& ratio) {
  return ratio ? fmt::format("{:.2f} ({:.2f}-{:.2f})", ratio->median, ratio->low, ratio->high) : "-";
}

// A few rows are enough to read a sweep over tolerances.
bool is_telling(const Row& row) {
  const double t = row.tolerance;
  return t == 0 || std::abs(t - 1e-1) < 1e-9 || std::abs(t - 1e-3) < 1e-9 || std::abs(t - 1e-6) < 1e-12;
}

std::string table_text(const PriceTable& table, bool full) {
  const bool measured = table.truth.exact + table.truth.bracket + table.truth.proof > 0;
  std::vector<tool::Column> columns = {{"", Align::left}, {"cases"}, {"ns median"},
                                       {"p95"},           {"p99"},   {"ratio (of rounds)"}};
  if (measured) {
    for (const char* name : {"backward\nmedian", "\np99", "\nworst", "forward\nmedian", "\nworst", "wrong",
                             "by", "late", "by", "no time", "front"})
      columns.push_back({name});
  }
  for (const char* name : {"not con-\nverged", "steps", "supports"}) columns.push_back({name});
  Table text(columns);
  for (const Row& row : table.rows) {
    if (!full && !is_telling(row)) continue;
    const Times time = row.time.value_or(Times{kNone, kNone, kNone, kNone, kNone});
    std::vector<std::string> cells = {row.label,    fmt::to_string(row.asked), ns(time.median), ns(time.p95),
                                      ns(time.p99), ratio_text(row.ratio)};
    if (measured) {
      for (const double x :
           {row.backward.median, row.backward.p99, row.backward.worst, row.forward.median, row.forward.worst})
        cells.push_back(short_number(x));
      cells.push_back(count_text(row.wrong));
      cells.push_back(short_number(row.denied));
      cells.push_back(count_text(row.late));
      cells.push_back(short_number(row.late_by));
      cells.push_back(count_text(row.failures.no_time + row.failures.refused));
      cells.push_back(row.on_front ? "*" : "");
    }
    cells.push_back(count_text(row.failures.not_converged));
    cells.push_back(mean_text(row.iterations.mean));
    cells.push_back(mean_text(row.supports.mean));
    text.add_row(std::move(cells));
  }
  return text.text();
}

std::string truth_text(const TruthCounts& truth) {
  std::vector<std::string> parts;
  if (truth.exact > 0) parts.push_back(fmt::format("the exact oracle of {}", truth.exact));
  if (truth.bracket > 0) parts.push_back(fmt::format("the bracket oracle of {}", truth.bracket));
  if (truth.proof > 0)
    parts.push_back(fmt::format("a proof of tier certified that the checker accepted of {}", truth.proof));
  if (truth.open > 0) parts.push_back(fmt::format("nobody of {}", truth.open));
  return parts.empty() ? "" : fmt::format("The truth is said by {}.\n", fmt::join(parts, ", "));
}

// A curve: a line a point, a column a contender, times.
std::string curves_text(const Document& document, Part part) {
  std::string out;
  std::vector<std::string> done;
  for (const PriceTable& first : document.tables) {
    if (first.part != part || std::isnan(first.x)) continue;
    if (std::find(done.begin(), done.end(), first.series) != done.end()) continue;
    done.push_back(first.series);
    std::vector<tool::Column> columns = {{first.x_name}};
    for (const Row& row : first.rows) columns.push_back({row.label + "\nns (supports)"});
    Table text(columns);
    for (const PriceTable& table : document.tables) {
      if (table.part != part || table.series != first.series) continue;
      std::vector<std::string> cells = {fmt::format("{:g}", table.x)};
      for (const Row& named : first.rows) {
        const Row* row = table.find(named.label);
        cells.push_back(row == nullptr || !row->time
                            ? "-"
                            : fmt::format("{:.0f} ({:.1f})", row->time->median, row->supports.mean));
      }
      text.add_row(std::move(cells));
    }
    out += fmt::format("{}\n{}\n", first.series, text.text());
  }
  return out;
}

// A line a user, and one a kind of bodies below it.
std::string advice_text(const Document& document) {
  std::string out, user;
  for (const Advice& one : document.advice) {
    if (user.empty()) out += "Recommended methods\n";
    if (one.user != user) out += fmt::format("  for {}: {}\n", one.user, one.wants);
    user = one.user;
    if (one.label.empty()) {
      out += fmt::format("    bodies {}: {}\n", one.bodies, one.because);
      continue;
    }
    out += fmt::format("    bodies {}: {}, {} times the time of {}, off by {} of scale at most ({})\n",
                       one.bodies, one.label, times_text(one.cost.median), one.baseline,
                       error_text(one.worst), one.because);
  }
  return out;
}

}  // namespace

std::string screen_of(const Document& document, bool full) {
  std::string out;
  for (const PriceTable& table : document.tables) {
    const bool alone = table.part == Part::family || (table.part == Part::query && std::isnan(table.x));
    if (!alone && !(full && table.part == Part::request)) continue;
    out += fmt::format("{}: {}\n{}{}{}\n", table.name, table.title,
                       table.sentence.empty() ? "" : table.sentence + "\n", truth_text(table.truth),
                       table_text(table, full));
  }
  out += curves_text(document, Part::growth);
  out += curves_text(document, Part::query);
  out += "The results in words. Ratios are of times. A cast requests the time alone, with warm caches.\n";
  for (const Sentence& one : document.sentences) out += fmt::format("  {}\n", one.text);
  out += advice_text(document);
  return out;
}

}  // namespace graze::price
