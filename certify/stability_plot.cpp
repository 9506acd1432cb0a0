#include "certify/stability_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "engines/system/system.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/statistics.hpp"

namespace graze::tool {
namespace {

namespace fs = std::filesystem;

// A value of 0, or one too small to matter, is drawn on the lowest line. A value above the highest line is
// drawn on that.
constexpr const char* kShown = "f(x) = x != x ? NaN : x < 1e-20 ? 1e-20 : x > 10 ? 10 : x";

// Okabe and Ito's colours, which colour-blind readers can tell apart. Marks are filled for double and hollow
// for float.
struct Look {
  const char* color;
  int filled, hollow;
};
constexpr Look kLooks[] = {{"#0072b2", 7, 6},   {"#d55e00", 5, 4},   {"#009e73", 9, 8}, {"#000000", 13, 12},
                           {"#cc79a7", 11, 10}, {"#e69f00", 15, 14}, {"#56b4e9", 3, 2}};

// A name ("mpr" of "mpr/float") keeps its look in both scalars.
std::vector<std::string> style_of(const std::vector<Curve>& curves) {
  std::map<std::string, std::size_t> order;
  std::vector<std::string> styles;
  for (const Curve& curve : curves) {
    const std::size_t slash = curve.method.find('/');
    const std::size_t place = order.emplace(curve.method.substr(0, slash), order.size()).first->second;
    const Look& look = kLooks[place % std::size(kLooks)];
    const bool in_float = slash != std::string::npos && curve.method.substr(slash + 1) == "float";
    styles.push_back(fmt::format("lc rgb '{}' pt {} ps 0.6 lw 1.5 dt {}", look.color,
                                 in_float ? look.hollow : look.filled, in_float ? 2 : 1));
  }
  return styles;
}

// The places of the methods for a legend that is filled column by column: each name's scalars together.
std::vector<std::size_t> legend_order(const std::vector<Curve>& curves) {
  const auto name_of = [&](std::size_t m) { return curves[m].method.substr(0, curves[m].method.find('/')); };
  std::vector<std::size_t> order;
  for (std::size_t m = 0; m < curves.size(); ++m) {
    for (std::size_t n = m; n < curves.size(); ++n) {
      const bool placed = std::find(order.begin(), order.end(), n) != order.end();
      if (!placed && name_of(n) == name_of(m)) order.push_back(n);
    }
  }
  return order;
}

// Long names need fewer columns.
std::string key_shape(const std::vector<Curve>& curves) {
  return fmt::format("vertical maxrows {} Left reverse samplen 3 width -1 noenhanced",
                     curves.size() > 10 ? 6 : 2);
}

// A string of gnuplot's in single quotes.
std::string in_quotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

std::string run_gnuplot(const std::string& directory, const std::string& name) {
  const fs::path stem = fs::path(directory) / name;
  if (system::run_in(directory, fmt::format("gnuplot {}.gp", name))) return stem.string() + ".svg is drawn";
  return fmt::format("{0}.dat and {0}.gp are written; gnuplot, which would draw them, did not run",
                     stem.string());
}

OutputFile opened(const std::string& directory, const std::string& file) {
  require_folder(directory);
  return OutputFile((fs::path(directory) / file).string());
}

// One of the four panels: a column of the data, lines of all methods.
struct Panel {
  const char* title;
  int column;
  bool left, top;
  bool kappa_shown = false;  // 64 u scale, the error bound of a standard tier
};
constexpr Panel kPanels[] = {{"backward error, worst", 4, true, true},
                             {"backward error, median", 5, false, true},
                             {"forward error, worst", 6, true, false},
                             {"forward error, median", 7, false, false}};

void write_panel(OutputFile& script, const Panel& panel, const std::string& data,
                 const std::vector<std::string>& styles) {
  script.write_line(panel.left ? "set lmargin at screen 0.09; set rmargin at screen 0.525"
                               : "set lmargin at screen 0.55; set rmargin at screen 0.985");
  script.write_line(panel.top ? "set tmargin at screen 0.91; set bmargin at screen 0.62"
                              : "set tmargin at screen 0.55; set bmargin at screen 0.26");
  script.write_line(panel.left ? "set ylabel 'over scale' offset 1; set format y '10^{%L}'"
                               : "unset ylabel; set format y ''");
  script.write_line(panel.top ? "unset xlabel" : "set xlabel 'hardness' offset 0,0.5");
  script.write_line(fmt::format("set title '{}' offset 0,-0.7", panel.title));
  script.write_line("unset arrow; unset label");
  if (panel.kappa_shown) {
    for (const auto& [u, scalar] :
         {std::pair{kUnitRoundoff<double>, "double"}, {kUnitRoundoff<float>, "float"}}) {
      script.write_line(fmt::format(
          "set arrow from graph 0, first {0:g} to graph 1, first {0:g} nohead lc rgb '#888888' dt 3",
          64 * u));
      if (!panel.left) continue;
      script.write_line(
          fmt::format("set label '64 u, {}' at graph 1, first {:g} right offset 0,0.45 tc rgb '#666666' font "
                      "'sans-serif,10'",
                      scalar, 64 * u));
    }
  }
  std::string plots;
  for (std::size_t m = 0; m < styles.size(); ++m) {
    plots +=
        fmt::format("{}{} index {} using 1:(f(${})):xtic(2) with linespoints {} notitle",
                    m == 0 ? "plot " : ", ", m == 0 ? in_quotes(data) : "''", m, panel.column, styles[m]);
  }
  script.write_line(plots);
}

// Writes the title and the legend, which has a strip of its own below the panels.
void write_legend(OutputFile& script, const std::vector<Curve>& curves,
                  const std::vector<std::string>& styles, const FamilyStability& family) {
  script.write_line("unset title; unset xlabel; unset ylabel; unset tics; unset border; unset grid");
  script.write_line("unset arrow; unset logscale");
  script.write_line("set lmargin at screen 0; set rmargin at screen 1");
  script.write_line("set tmargin at screen 0.16; set bmargin at screen 0.0");
  script.write_line("unset label");
  script.write_line(fmt::format("set label {} at screen 0.5,0.965 center noenhanced font 'sans-serif,15'",
                                in_quotes("Error against hardness: " + family.family)));
  script.write_line(fmt::format("set label {} at screen 0.5,0.18 center noenhanced",
                                in_quotes("hardness: " + family.hardness_meaning)));
  script.write_line("set key at screen 0.5,0.155 center top " + key_shape(curves));
  std::string plots;
  for (const std::size_t m : legend_order(curves)) {
    plots += fmt::format("{}NaN with linespoints {} title '{}'", plots.empty() ? "plot [0:1] [0:1] " : ", ",
                         styles[m], curves[m].method);
  }
  script.write_line(plots);
}

}  // namespace

std::string draw_family(const FamilyStability& family, const std::string& directory) {
  const std::vector<Curve> curves = merged(family.curves);
  const std::string name = "stability_" + family.family;
  OutputFile data = opened(directory, name + ".dat");
  data.write_line(
      "# a block a method: place, hardness, cases, backward error worst and median, forward error worst and "
      "median,\n# wrong verdicts, the largest clearance or depth that one denies, not converged; lengths "
      "over "
      "scale");
  for (std::size_t m = 0; m < curves.size(); ++m) {
    data.write_line((m == 0 ? "# " : "\n\n# ") + curves[m].method);
    for (std::size_t l = 0; l < curves[m].levels.size(); ++l) {
      const LevelErrors& level = curves[m].levels[l];
      data.write_line(fmt::format("{} {} {} {} {} {} {} {} {} {}", l, level.hardness, level.cases,
                                  worst(level.backward), median(level.backward), worst(level.forward),
                                  median(level.forward), level.wrong, level.denied, level.stalled));
    }
  }
  data.close();
  if (curves.empty()) return {};

  const std::vector<std::string> styles = style_of(curves);
  const std::size_t levels = curves.front().levels.size();
  OutputFile script = opened(directory, name + ".gp");
  script.write_line(fmt::format("# gnuplot {0}.gp draws {0}.svg", name));
  script.write_line("set terminal svg size 900,720 font 'sans-serif,13' background 'white'");
  script.write_line(fmt::format("set output '{}.svg'", name));
  script.write_line(kShown);
  script.write_line("set multiplot");
  script.write_line(
      "set logscale y; set yrange [1e-20:10]; set grid xtics ytics lt 1 lw 0.5 lc rgb '#cccccc'");
  script.write_line("set ytics ('0' 1e-20, 1e-17, 1e-14, 1e-11, 1e-8, 1e-5, 1e-2, 10); set tics nomirror");
  script.write_line(
      fmt::format("set xrange [-0.4:{}]; set border 3; unset key", static_cast<double>(levels) - 1 + 0.4));
  for (Panel panel : kPanels) {
    panel.kappa_shown = panel.top && !curves.front().rotating;
    write_panel(script, panel, name + ".dat", styles);
  }
  write_legend(script, curves, styles, family);
  script.write_line("unset multiplot");
  script.close();
  return run_gnuplot(directory, name);
}

std::string draw_overview(const std::vector<Curve>& curves, bool rotating, const std::string& directory) {
  // By method, in the order in which they first occur: the worst of each family.
  std::vector<Curve> methods;
  std::vector<std::string> families;
  std::map<std::string, std::map<std::string, double>> worst_of;  // by method and family, in u scale
  for (const Curve& curve : merged(curves)) {
    if (curve.rotating != rotating) continue;
    const auto same = [&](const Curve& known) { return known.method == curve.method; };
    if (std::none_of(methods.begin(), methods.end(), same)) methods.push_back(curve);
    if (std::find(families.begin(), families.end(), curve.family) == families.end()) {
      families.push_back(curve.family);
    }
    worst_of[curve.method][curve.family] = worst(curve.total().backward) / curve.unit_roundoff;
  }
  if (families.size() < 2) return {};
  const std::string name = rotating ? "stability_overview_rotating" : "stability_overview";
  OutputFile data = opened(directory, name + ".dat");
  data.write_line(
      "# a block a method: place, family, worst backward error in u scale of the method's scalar");
  for (std::size_t m = 0; m < methods.size(); ++m) {
    data.write_line((m == 0 ? "# " : "\n\n# ") + methods[m].method);
    for (std::size_t f = 0; f < families.size(); ++f) {
      const auto& by_family = worst_of[methods[m].method];
      const auto found = by_family.find(families[f]);
      data.write_line(
          fmt::format("{} {} {}", f, families[f], found == by_family.end() ? kNotMeasured : found->second));
    }
  }
  data.close();

  const std::vector<std::string> styles = style_of(methods);
  const double most = static_cast<double>(families.size()) - 0.5;
  OutputFile script = opened(directory, name + ".gp");
  script.write_line(fmt::format("# gnuplot {0}.gp draws {0}.svg", name));
  script.write_line(fmt::format("set terminal svg size {},560 font 'sans-serif,13' background 'white'",
                                std::max<std::size_t>(900, 160 + 40 * families.size())));
  script.write_line(fmt::format("set output '{}.svg'", name));
  script.write_line("f(x) = x != x ? NaN : x < 1e-3 ? 1e-3 : x > 1e16 ? 1e16 : x");
  script.write_line("set logscale y; set yrange [1e-3:*]; set border 3; set tics nomirror");
  script.write_line(
      "set ytics ('0' 1e-3, '10^{-2}' 1e-2, '10^{-1}' 1e-1, '1' 1); set for [k = 1:16] ytics add "
      "(sprintf('10^{%d}', k) 10**k)");
  script.write_line("set grid ytics lt 1 lw 0.5 lc rgb '#cccccc'; unset xtics");
  script.write_line(fmt::format("set xrange [-0.5:{}]", most));
  script.write_line("set ylabel 'worst backward error, in u scale of its scalar'");
  script.write_line(rotating ? "set title 'Rotating casts: each method at its worst, by family'"
                             : "set title 'Linear casts: each method at its worst, by family'");
  script.write_line("set key outside bottom center " + key_shape(methods));
  for (const int kappa : {64, 1024}) {
    script.write_line(
        fmt::format("set arrow from -0.5,{0} to {1},{0} nohead lc rgb '#888888' dt 3", kappa, most));
    script.write_line(
        fmt::format("set label '{0} u' at {1},{0} right offset 0,0.5 tc rgb '#888888'", kappa, most));
  }
  std::string tics;
  for (std::size_t f = 0; f < families.size(); ++f) {
    tics += fmt::format("{}{} {}", f == 0 ? "" : ", ", in_quotes(families[f]), f);
    if (f > 0) {
      script.write_line(fmt::format(
          "set arrow from {0}.5, graph 0 to {0}.5, graph 1 nohead lc rgb '#cccccc' lw 0.5", f - 1));
    }
  }
  script.write_line(fmt::format("set xtics rotate by 40 right noenhanced scale 0 ({})", tics));
  // Side by side, so that none hides another.
  std::string plots;
  for (const std::size_t m : legend_order(methods)) {
    const double shift = 0.8 * ((static_cast<double>(m) + 0.5) / static_cast<double>(methods.size()) - 0.5);
    plots += fmt::format("{}'{}.dat' index {} using ($1+({:.3f})):(f($3)) with points {} title '{}'",
                         plots.empty() ? "plot " : ", ", name, m, shift, styles[m], methods[m].method);
  }
  script.write_line(plots);
  script.close();
  return run_gnuplot(directory, name);
}

}  // namespace graze::tool
