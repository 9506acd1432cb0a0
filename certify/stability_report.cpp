#include "certify/stability_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "certify/engine_report.hpp"
#include "reports/text/counted.hpp"
#include "reports/text/statistics.hpp"
#include "reports/text/table.hpp"

namespace graze::tool {
namespace {

// The tier of third-party engines.
constexpr std::string_view kDeclared = "declared";

std::string shapes_text(const Curve& curve) { return curve.rounded ? "round" : "polytopes"; }

// In u scale: three digits are enough, and an integer is read at a glance up to a thousand.
std::string in_u(double error, double unit_roundoff) {
  const double u = error / unit_roundoff;
  return std::isnan(u) || !(u < 1e4) ? short_number(u) : fmt::format("{:.3g}", u);
}

double worst_backward(const Curve& curve) {
  const LevelErrors* hardest = curve.hardest();
  return hardest == nullptr ? kNotMeasured : worst(hardest->backward);
}

std::string hardness_text(const LevelErrors* level) {
  return level == nullptr ? "-" : fmt::to_string(level->hardness);
}

std::string claim_text(const Curve& curve) {
  if (!curve.row) return "no row";
  if (curve.tier == kDeclared) return limit_text(*curve.row);
  if (!curve.claims_stability()) return "none";
  if (curve.tier == "exact") return "last bit";
  if (curve.tier == "certified") return fmt::format("width {}", curve.row->width.value_or(0));
  return fmt::format("{} u", curve.rounded ? curve.row->kappa_rounded : curve.row->kappa_polytope);
}

std::string holds_text(const Curve& curve, bool holds) {
  if (!curve.row) return "-";
  return holds ? "yes" : "NO";
}

// The curves of the same method, linear or rotating: one after the other, as in the engines' tables.
bool same_method(const Curve& l, const Curve& r) { return l.method == r.method && l.rotating == r.rotating; }

// Those of the same method together, in the order in which methods first occur, the worst first.
std::vector<const Curve*> worst_first(const std::vector<Curve>& curves) {
  std::vector<const Curve*> methods, sorted;
  for (const Curve& curve : curves) {
    sorted.push_back(&curve);
    const auto same = [&](const Curve* known) { return same_method(*known, curve); };
    if (std::none_of(methods.begin(), methods.end(), same)) methods.push_back(&curve);
  }
  const auto order_of = [&](const Curve* curve) {
    const auto same = [&](const Curve* known) { return same_method(*known, *curve); };
    return std::find_if(methods.begin(), methods.end(), same) - methods.begin();
  };
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Curve* l, const Curve* r) {
    if (order_of(l) != order_of(r)) return order_of(l) < order_of(r);
    return std::fmax(worst_backward(*l), -1) > std::fmax(worst_backward(*r), -1);
  });
  return sorted;
}

// Then a method has a group of rows.
bool more_than_a_family(const std::vector<Curve>& curves) {
  return std::any_of(curves.begin(), curves.end(),
                     [&](const Curve& curve) { return curve.family != curves.front().family; });
}

// The first level at which something is so.
template <class Test>
std::string first_level(const Curve& curve, const Test& test) {
  const auto found = std::find_if(curve.levels.begin(), curve.levels.end(), test);
  return found == curve.levels.end() ? "-" : fmt::to_string(found->hardness);
}

}  // namespace

double broken_forward(double unit_roundoff) { return std::sqrt(unit_roundoff); }

std::string family_line(const FamilyStability& family) {
  const Curve* worst_curve = nullptr;
  double most = -1;
  std::size_t faults = 0, stalls = 0;
  for (const Curve& curve : family.curves) {
    const LevelErrors sum = curve.total();
    faults += sum.faulty;
    stalls += curve.claims_stability() ? sum.stalled : 0;
    const double error = worst_backward(curve) / curve.unit_roundoff;
    if (!curve.claims_stability() || curve.tier != "standard" || !(error > most)) continue;
    most = error;
    worst_curve = &curve;
  }
  std::string text = fmt::format("{}: {}", family.family, counted(family.cases, "case"));
  if (worst_curve != nullptr) {
    text += fmt::format(", {} u scale at most ({}, {}, hardness {})", in_u(most, 1), worst_curve->method,
                        shapes_text(*worst_curve), hardness_text(worst_curve->hardest()));
  }
  text += fmt::format(", {} beyond a guarantee, {}", faults, counted(stalls, "stall"));
  for (const FamilyStability::Skipped& one : family.skipped)
    text += fmt::format("; {} are not asked of {}", one.cases, one.method);
  for (const Curve& curve : family.curves) {
    if (const std::size_t failed = curve.total().failed; failed > 0)
      text += fmt::format("; {} without an answer by {}", failed, curve.method);
  }
  return text;
}

std::string level_table(const FamilyStability& family) {
  Table table({{"method", Align::left},
               {"shapes", Align::left},
               {"hardness"},
               {"cases"},
               {"backward / u\nmedian"},
               {"\nworst"},
               {"over scale\nworst"},
               {"forward\nmedian"},
               {"\nworst"},
               {"wrong"},
               {"up to"},
               {"late"},
               {"not con-\nverged"}});
  for (const Curve& curve : family.curves) {
    for (const LevelErrors& level : curve.levels) {
      if (level.cases == 0) continue;
      table.add_row({curve.method, shapes_text(curve), fmt::to_string(level.hardness),
                     fmt::to_string(level.cases), in_u(median(level.backward), curve.unit_roundoff),
                     in_u(worst(level.backward), curve.unit_roundoff), short_number(worst(level.backward)),
                     short_number(median(level.forward)), short_number(worst(level.forward)),
                     count_text(level.wrong), short_number(level.denied), count_text(level.late),
                     count_text(level.stalled)});
    }
    table.add_gap();
  }
  return fmt::format("{}, by hardness ({})\n\n{}", family.family, family.hardness_meaning, table.text());
}

std::string stability_table(const std::vector<Curve>& curves) {
  Table table({{"method", Align::left},
               {"family", Align::left},
               {"shapes", Align::left},
               {"hardness\nat worst"},
               {"cases"},
               {"backward / u\nworst"},
               {"\nmedian"},
               {"over scale\nworst"},
               {"forward\nworst"},
               {"wrong"},
               {"up to"},
               {"late"},
               {"not con-\nverged"},
               {"row"},
               {"within", Align::left}});
  const Curve* last = nullptr;
  const bool gaps = more_than_a_family(curves);
  for (const Curve* curve : worst_first(curves)) {
    if (last != nullptr && gaps && !same_method(*last, *curve)) table.add_gap();
    last = curve;
    const LevelErrors sum = curve->total();
    table.add_row({curve->method, curve->family, shapes_text(*curve), hardness_text(curve->hardest()),
                   fmt::to_string(sum.cases), in_u(worst(sum.backward), curve->unit_roundoff),
                   in_u(median(sum.backward), curve->unit_roundoff), short_number(worst(sum.backward)),
                   short_number(worst(sum.forward)), count_text(sum.wrong), short_number(sum.denied),
                   count_text(sum.late), count_text(sum.stalled), claim_text(*curve),
                   holds_text(*curve, curve->holds())});
  }
  return table.text();
}

std::string break_table(const std::vector<Curve>& curves) {
  Table table({{"method", Align::left},
               {"family", Align::left},
               {"shapes", Align::left},
               {"beyond its\nrow from"},
               {"forward > sqrt(u)\nmedian, from"},
               {"\nworst, from"},
               {"verdicts\nwrong from"},
               {"\nup to"},
               {"not con-\nverged from"}});
  const Curve* last = nullptr;
  const bool gaps = more_than_a_family(curves);
  for (const Curve* curve : worst_first(curves)) {
    const double limit = broken_forward(curve->unit_roundoff);
    const std::vector<std::string> from = {
        first_level(*curve, [](const LevelErrors& level) { return level.faulty > 0; }),
        first_level(*curve, [&](const LevelErrors& level) { return median(level.forward) > limit; }),
        first_level(*curve, [&](const LevelErrors& level) { return worst(level.forward) > limit; }),
        first_level(*curve, [](const LevelErrors& level) { return level.wrong > 0; }),
        first_level(*curve, [](const LevelErrors& level) { return level.stalled > 0; })};
    if (std::all_of(from.begin(), from.end(), [](const std::string& level) { return level == "-"; })) {
      continue;
    }
    if (last != nullptr && gaps && !same_method(*last, *curve)) table.add_gap();
    last = curve;
    table.add_row({curve->method, curve->family, shapes_text(*curve), from[0], from[1], from[2], from[3],
                   short_number(curve->total().denied), from[4]});
  }
  return last == nullptr ? "" : table.text();
}

std::string summary_table(const std::vector<Curve>& curves) {
  Table table({{"method", Align::left},
               {"casts", Align::left},
               {"tier", Align::left},
               {"shapes", Align::left},
               {"cases"},
               {"claims"},
               {"backward / u\nworst"},
               {"over scale\nworst"},
               {"in family", Align::left},
               {"at\nhardness"},
               {"wrong"},
               {"up to"},
               {"late"},
               {"not con-\nverged"},
               {"holds", Align::left}});
  // The first curve of each method and kind of shapes is its worst.
  std::vector<const Curve*> firsts;
  const std::vector<const Curve*> sorted = worst_first(curves);
  for (const bool rounded : {false, true}) {
    for (const Curve* curve : sorted) {
      const auto same = [&](const Curve* known) {
        return same_method(*known, *curve) && known->rounded == curve->rounded;
      };
      if (curve->rounded == rounded && std::none_of(firsts.begin(), firsts.end(), same)) {
        firsts.push_back(curve);
      }
    }
  }
  bool rounded = false;
  for (const Curve* first : firsts) {
    if (first->rounded != rounded) table.add_gap();
    rounded = first->rounded;
    LevelErrors sum;
    bool holds = true;
    for (const Curve& curve : curves) {
      if (!same_method(*first, curve) || first->rounded != curve.rounded) continue;
      sum.add(curve.total());
      holds = holds && curve.holds();
    }
    table.add_row({first->method, first->rotating ? "rotating" : "linear", first->tier, shapes_text(*first),
                   fmt::to_string(sum.cases), claim_text(*first),
                   in_u(worst(sum.backward), first->unit_roundoff), short_number(worst(sum.backward)),
                   first->family, hardness_text(first->hardest()), count_text(sum.wrong),
                   short_number(sum.denied), count_text(sum.late), count_text(sum.stalled),
                   holds_text(*first, holds)});
  }
  return table.text();
}

std::vector<std::string> breaches(const std::vector<Curve>& curves) {
  std::vector<std::string> lines;
  for (const Curve* curve : worst_first(curves)) {
    if (curve->holds()) continue;
    const LevelErrors sum = curve->total();
    const std::string where =
        fmt::format("{} in {}, {}", curve->row->name(), curve->family, shapes_text(*curve));
    if (sum.faulty > 0) {
      lines.push_back(fmt::format("{}: {} of {} beyond the guarantee; the first is {}", where, sum.faulty,
                                  sum.cases, curve->first_fault));
    } else {
      lines.push_back(fmt::format("{}: {} of {} not converged, above the cap of {}", where, sum.stalled,
                                  sum.cases, curve->row->stall_cap));
    }
  }
  return lines;
}

}  // namespace graze::tool
