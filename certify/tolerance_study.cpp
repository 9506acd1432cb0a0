#include "certify/tolerance_study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "properties/judge/judgement.hpp"
#include "properties/judge/truth.hpp"
#include "report/inputs.hpp"
#include "report/parallel.hpp"
#include "report/progress.hpp"
#include "report/statistics.hpp"
#include "report/table.hpp"

namespace graze::tool {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<double> studied_tolerances() { return {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}; }

std::vector<ToleranceRow> study_tolerances(const std::vector<const engine::Method*>& methods,
                                           std::span<const corpus::Case> hits, unsigned threads) {
  std::vector<ToleranceRow> rows;
  for (const engine::Method* method : methods) {
    for (const double tolerance : studied_tolerances()) {
      ToleranceRow row{.method = method->full_name(), .tolerance = tolerance, .cases = hits.size()};
      row.lower.resize(hits.size());
      row.upper.resize(hits.size());
      row.width.resize(hits.size());
      row.denied.resize(hits.size());
      rows.push_back(std::move(row));
    }
  }
  std::vector<std::vector<char>> stalled(rows.size(), std::vector<char>(hits.size(), 0));
  const std::size_t per_method = studied_tolerances().size();
  {
    Progress progress("error against time", hits.size());
    for_each_index(hits.size(), threads, [&](std::size_t i) {
      law::Truth truth(hits[i]);
      const oracle::CaseTruth& exact = truth.cast();
      const double scale = exact.scale().high;
      for (std::size_t r = 0; r < rows.size(); ++r) {
        const engine::Answer answer = methods[r / per_method]->ask(hits[i], {.tolerance = rows[r].tolerance});
        const auto error = [&](double t) {
          return t < kInf ? law::over(exact.backward_error(t).high, scale) : kNone;
        };
        stalled[r][i] = answer.outcome == Outcome::not_converged ? 1 : 0;
        rows[r].denied[i] = answer.outcome == Outcome::miss ? law::over(exact.depth().high, scale) : kNone;
        rows[r].lower[i] = error(answer.toi_lower);
        rows[r].upper[i] = answer.toi_upper == answer.toi_lower ? rows[r].lower[i] : error(answer.toi_upper);
        rows[r].width[i] = std::fmax(rows[r].lower[i], rows[r].upper[i]);
      }
      progress.step();
    });
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
      rows[r].not_converged += static_cast<std::size_t>(stalled[r][i]);
      rows[r].missed += std::isnan(rows[r].denied[i]) ? 0 : 1;
      rows[r].ns.push_back(methods[r / per_method]->time_ns(hits[i], {.tolerance = rows[r].tolerance}, 3));
    }
  }
  return rows;
}

std::string tolerance_table(const std::vector<ToleranceRow>& rows) {
  Table table({{"method", Align::left},
               {"tolerance"},
               {"cases"},
               {"not con-\nverged"},
               {"missed"},
               {"\nup to"},
               {"lower end\nmedian"},
               {"\nworst"},
               {"upper end\nmedian"},
               {"\nworst"},
               {"width\nmedian"},
               {"\nworst"},
               {"median\nns"}});
  const ToleranceRow* last = nullptr;
  for (const ToleranceRow& row : rows) {
    if (last != nullptr && last->method != row.method) table.add_gap();
    last = &row;
    const double fraction =
        row.cases > 0 ? static_cast<double>(row.not_converged) / static_cast<double>(row.cases) : 0;
    table.add_row({row.method, fmt::format("{:.0e}", row.tolerance), fmt::to_string(row.cases),
                   fmt::format("{:.1f} %", 100 * fraction), row.missed > 0 ? fmt::to_string(row.missed) : "-",
                   short_number(worst(row.denied)), short_number(median(row.lower)),
                   short_number(worst(row.lower)), short_number(median(row.upper)),
                   short_number(worst(row.upper)), short_number(median(row.width)),
                   short_number(worst(row.width)), fmt::format("{:.0f}", median(row.ns))});
  }
  return table.text();
}

std::string draw_tolerances(const std::vector<ToleranceRow>& rows, const std::string& directory) {
  namespace fs = std::filesystem;
  require_folder(directory);
  const fs::path stem = fs::path(directory) / "error_against_time";
  OutputFile data(stem.string() + ".dat"), script(stem.string() + ".gp");
  data.write_line(
      "# a block a method: tolerance, median ns, median and worst backward error of the lower end over "
      "scale, hits\n# that are said to miss and the greatest depth that one denies; NaN: there is none");
  script.write_line("f(x) = x != x ? NaN : x > 0 ? x : 1e-18");
  script.write_line("set terminal svg size 800,520 font 'sans-serif,13'");
  script.write_line("set output 'error_against_time.svg'");
  script.write_line("set logscale y; set format y '10^{%L}'; set grid; set key top right");
  script.write_line("set xlabel 'median time of a cast (ns)'");
  script.write_line("set ylabel 'backward error of the lower end, over scale'");
  script.write_line("set title 'What accuracy costs: tolerances 1e-2 to 1e-14'");
  std::string plots;
  std::size_t block = 0;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const ToleranceRow& row = rows[r];
    if (r == 0 || rows[r - 1].method != row.method) {
      if (r > 0) data.write_line("\n");
      data.write_line("# " + row.method);
      plots += fmt::format(
          "{}'error_against_time.dat' index {} using 2:(f($3)) with linespoints lw 2 title "
          "'{} median', '' index {} using 2:(f($4)) with points title '{} worst'",
          plots.empty() ? "plot " : ", ", block, row.method, block, row.method);
      ++block;
    }
    data.write_line(fmt::format("{} {} {} {} {} {}", row.tolerance, median(row.ns), median(row.lower),
                                worst(row.lower), row.missed, worst(row.denied)));
  }
  script.write_line(plots);
  data.close();
  script.close();
  const std::string command = fmt::format("cd '{}' && gnuplot error_against_time.gp 2>/dev/null", directory);
  const bool quotable = directory.find('\'') == std::string::npos;
  if (quotable && std::system(command.c_str()) == 0) return stem.string() + ".svg is drawn";
  return fmt::format("{0}.dat and {0}.gp are written; gnuplot, which would draw them, did not run",
                     stem.string());
}

}  // namespace graze::tool
