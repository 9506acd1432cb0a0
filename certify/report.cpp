#include "certify/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "certify/engine_report.hpp"
#include "corpus/format/names.hpp"
#include "reports/text/counted.hpp"
#include "reports/text/progress.hpp"
#include "reports/text/statistics.hpp"
#include "reports/text/table.hpp"

namespace graze::tool {
namespace {

using engine::Kind;
using engine::Method;

std::string ns_text(double ns) { return std::isnan(ns) ? "-" : fmt::format("{:.0f}", ns); }

std::string unseen_text(engine::Unseen unseen) {
  switch (unseen) {
    case engine::Unseen::nothing:
      return "nothing";
    case engine::Unseen::hidden_motion:
      return "hidden";
    case engine::Unseen::anything:
      break;
  }
  return "anything";
}

// 1,234,567
std::string grouped(std::size_t count) {
  std::string text = fmt::to_string(count);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, ",");
  return text;
}

void add_heading(Table& table, Kind kind) {
  std::vector<std::string> cells(10);
  cells.front() = kind == Kind::linear  ? "casts"
                  : kind == Kind::query ? "queries"
                                        : "casts of rotating bodies";
  table.add_row(std::move(cells));
}

std::size_t fault_count(const Tally& tally, std::string law::Judgement::*why) {
  for (std::size_t k = 0; k < law::kFaults; ++k) {
    if (law::kFaultKinds[k].why == why) return tally.faults[k];
  }
  return 0;
}

}  // namespace

std::vector<std::string> fault_lines(const Certification& certification) {
  struct Kind {
    std::size_t answers = 0;
    std::set<std::string> families = {}, methods = {};
    std::string first = {};
    void add(const Tally& tally, std::size_t count, const Tally::Example& example) {
      if (count == 0) return;
      if (answers == 0)
        first = fmt::format("{} by {}{}{}", example.id, tally.method->question_name(),
                            example.reason.empty() ? "" : ": ", example.reason);
      answers += count;
      families.insert(tally.family);
      methods.insert(tally.method->question_name());
    }
    [[nodiscard]] std::string line(std::string_view name) const {
      return fmt::format("{}: {} of {} in {}; the first is {}", name, counted(answers, "answer"),
                         counted(methods.size(), "method"),
                         families.size() == 1 ? "1 family" : fmt::format("{} families", families.size()),
                         first);
    }
  };
  std::array<Kind, law::kFaults> kinds;
  Kind open;
  std::set<std::string> of_tallies;
  for (const Tally& tally : certification.tallies) {
    const std::vector<std::string> lines = breaches(tally);
    of_tallies.insert(lines.begin(), lines.end());
    if (lines.empty()) continue;
    for (std::size_t k = 0; k < law::kFaults; ++k) kinds[k].add(tally, tally.faults[k], tally.first[k]);
    if (is_above_open_cap(tally)) {
      open.add(tally, tally.left_open, tally.first_open);
    } else if (is_above_stall_cap(tally)) {
      open.add(tally, tally.stalled, tally.first_stalled);
    }
  }
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < law::kFaults; ++k) {
    if (kinds[k].answers > 0) lines.push_back(kinds[k].line(law::kFaultKinds[k].name));
  }
  if (open.answers > 0) lines.push_back(open.line("open, above the cap"));
  for (const std::string& breach : certification.breaches) {
    if (!of_tallies.contains(breach)) lines.push_back(breach);
  }
  return lines;
}

std::string verdict_line(const Certification& certification, double seconds) {
  std::set<std::string> families;
  std::size_t faults = 0, stalls = 0;
  bool is_promised = false;
  for (const Tally& tally : certification.tallies) {
    if (tally.cases > 0) {
      families.insert(tally.family);
      is_promised = is_promised || (tally.method->guarantee != nullptr && !tally.method->guarantee->is_open);
    }
    faults += tally.at_fault;
    stalls += tally.stalled;
  }
  const char* verdict = !certification.breaches.empty()     ? "A method breaks its guarantee"
                        : !certification.unfinished.empty() ? "Stopped: no guarantee is broken so far"
                        : certification.answers == 0        ? "Nothing was judged"
                        : is_promised                       ? "Every method keeps its guarantee"
                                                            : "Nothing is promised, and no answer fails";
  const auto counted = [](std::size_t n, std::string_view what) {
    return fmt::format("{} {}{}", grouped(n), what, n == 1 ? "" : "s");
  };
  const bool is_little =
      certification.breaches.empty() && certification.answers > 0 && certification.answers < kFewAnswers;
  std::string declined;
  for (const std::string& line : certification.declined) declined += "; " + line;
  return fmt::format("{}: {} to {} of {} judged in {}, {}, {}{}{}.\n", verdict,
                     counted(certification.answers, "answer"), counted(certification.answered, "case"),
                     counted(families.size(), "suite"),
                     seconds < 1 ? "less than a second" : duration_text(seconds), counted(faults, "fault"),
                     counted(stalls, "stall"), is_little ? "; so few answers certify little" : "", declined);
}

std::string summary_table(const Certification& certification, const Settings& settings) {
  Table table({{"method", Align::left},
               {"answers"},
               {"faults"},
               {"open"},
               {"proofs"},
               {"error /\nlimit"},
               {"worst in", Align::left},
               {"most\nsupports"},
               {"ns\ndouble"},
               {"\nfloat"}});
  const auto place_of = [](const Method& method) {
    return std::tuple(method.kind, method.query, method.name, method.tier);
  };
  std::vector<const Method*> done;
  const Method* last = nullptr;
  for (const Method* method : settings.methods) {
    const auto is_same = [&](const Method* other) { return place_of(*other) == place_of(*method); };
    if (std::any_of(done.begin(), done.end(), is_same)) continue;
    done.push_back(method);
    Tally both{.method = method, .family = "all"};
    double ns[2] = {std::nan(""), std::nan("")};
    std::string worst_family = "-";
    double most = -1;
    for (const Method* scalar : settings.methods) {
      if (!is_same(scalar)) continue;
      const Tally total = certification.total(*scalar);
      both.add(total);
      ns[scalar->in_float()] = median(total.ns);
      for (const Tally& tally : certification.tallies) {
        if (tally.method != scalar || !(tally.over_limit.value > most)) continue;
        most = tally.over_limit.value;
        worst_family = tally.family;
      }
    }
    // A method that was asked nothing has no line.
    if (both.cases == 0 && both.skipped == 0) continue;
    if (last != nullptr && last->kind != method->kind) table.add_gap();
    if (last == nullptr || last->kind != method->kind) add_heading(table, method->kind);
    last = method;
    const std::string query =
        method->kind == Kind::query ? std::string(corpus::name_of(method->query)) + " " : "";
    table.add_row({" " + query + method->name, fmt::to_string(both.cases), count_text(both.at_fault),
                   count_text(both.left_open), count_text(both.accepted), short_number(both.over_limit.value),
                   most > 0 ? worst_family : "-", ns_text(both.most_supports.value), ns_text(ns[0]),
                   ns_text(ns[1])});
  }
  return table.text();
}

std::string exact_summary(const Certification& certification, const Settings& settings) {
  std::string text;
  std::size_t casts = 0, failures = 0;
  for (const Method* method : settings.methods) {
    if (!method->is_exact() || method->kind != Kind::linear) continue;
    const Tally sum = certification.total(*method);
    const std::size_t faults = sum.at_fault;
    text += fmt::format("{}: {} to the last bit, {} wrong, {} stalled; {} not for the tier.\n",
                        method->full_name(), tool::counted(sum.cases, "cast"), faults, sum.stalled,
                        sum.skipped == 1 ? "1 case is" : fmt::format("{} cases are", sum.skipped));
    casts += sum.cases;
    failures += faults + sum.stalled;
  }
  if (casts > 0 && failures == 0) {
    text +=
        fmt::format("None of {} failed: the rate of failures on such cases is below 3/n = {:.2g} at 95 %.\n",
                    casts, 3.0 / static_cast<double>(casts));
  }
  return text;
}

namespace {

std::string linear_table(const Certification& certification) {
  Table table({{"method", Align::left},
               {"family", Align::left},
               {"cases"},
               {"not\nasked"},
               {"wrong"},
               {"late"},
               {"early"},
               {"off"},
               {"contact\noff"},
               {"open"},
               {"not con-\nverged"},
               {"within\ntolerance"},
               {"proofs\naccepted"},
               {"\nrefused"},
               {"\nnone"},
               {"by\noracle"},
               {"forward\nmedian"},
               {"error\nworst"},
               {"backward\nmedian"},
               {"error\nworst"},
               {"true in.\nworst"},
               {"normal\nworst"},
               {"witness\nworst"},
               {"supports\nmedian"},
               {"\nmost"},
               {"median\nns"}});
  const Method* last = nullptr;
  using J = law::Judgement;
  for (const Tally& t : certification.tallies) {
    if (t.method->kind != Kind::linear) continue;
    if (last != nullptr && last != t.method) table.add_gap();
    last = t.method;
    table.add_row({t.method->full_name(),
                   t.family,
                   fmt::to_string(t.cases),
                   count_text(t.skipped),
                   fmt::to_string(fault_count(t, &J::wrong)),
                   fmt::to_string(fault_count(t, &J::late)),
                   fmt::to_string(fault_count(t, &J::early)),
                   fmt::to_string(fault_count(t, &J::off)),
                   fmt::to_string(fault_count(t, &J::bad_contact)),
                   fmt::to_string(t.left_open),
                   fmt::to_string(t.stalled),
                   fmt::to_string(t.within_tolerance),
                   fmt::to_string(t.accepted),
                   fmt::to_string(t.refused),
                   fmt::to_string(t.unproved),
                   fmt::to_string(t.by_oracle),
                   short_number(median(t.forward)),
                   short_number(worst(t.forward)),
                   short_number(median(t.backward)),
                   short_number(worst(t.backward)),
                   short_number(worst(t.true_backward)),
                   short_number(worst(t.normal)),
                   short_number(worst(t.witness)),
                   ns_text(median(t.supports)),
                   ns_text(t.most_supports.value),
                   ns_text(median(t.ns))});
  }
  return table.text();
}

std::string where_text(const Tally::Worst& worst) {
  if (std::isnan(worst.value) || !worst.hardness) return "-";
  return fmt::to_string(*worst.hardness);
}

std::string rotating_table(const Certification& certification) {
  Table table({{"method", Align::left},
               {"family", Align::left},
               {"cases"},
               {"not\nasked"},
               {"wrong"},
               {"late"},
               {"early"},
               {"off"},
               {"contact\noff"},
               {"unproved"},
               {"open"},
               {"not con-\nverged"},
               {"within\ntolerance"},
               {"hidden"},
               {"oracle\nopen"},
               {"proofs\naccepted"},
               {"\nrefused"},
               {"width\nworst"},
               {"\nhardness"},
               {"passed\nworst"},
               {"\nhardness"},
               {"normal\nworst"},
               {"witness\nworst"},
               {"supports\nmedian"},
               {"\nmost"},
               {"median\nns"}});
  const Method* last = nullptr;
  using J = law::Judgement;
  for (const Tally& t : certification.tallies) {
    if (t.method->kind != Kind::rotating) continue;
    if (last != nullptr && last != t.method) table.add_gap();
    last = t.method;
    table.add_row({t.method->full_name(),
                   t.family,
                   fmt::to_string(t.cases),
                   count_text(t.skipped),
                   fmt::to_string(fault_count(t, &J::wrong)),
                   fmt::to_string(fault_count(t, &J::late)),
                   fmt::to_string(fault_count(t, &J::early)),
                   fmt::to_string(fault_count(t, &J::off)),
                   fmt::to_string(fault_count(t, &J::bad_contact)),
                   fmt::to_string(fault_count(t, &J::unproved)),
                   fmt::to_string(t.left_open),
                   fmt::to_string(t.stalled),
                   fmt::to_string(t.within_tolerance),
                   count_text(t.hidden),
                   count_text(t.open),
                   fmt::to_string(t.accepted),
                   fmt::to_string(t.refused),
                   short_number(t.width.value),
                   where_text(t.width),
                   short_number(t.passed.value),
                   where_text(t.passed),
                   short_number(worst(t.normal)),
                   short_number(worst(t.witness)),
                   ns_text(median(t.supports)),
                   ns_text(t.most_supports.value),
                   ns_text(median(t.ns))});
  }
  return table.text();
}

constexpr const char* kLinearWords =
    "wrong, late, early, off, contact off: by more than the limit of the method's guarantee, in the case "
    "as the\n"
    "method's scalar sees it. within tolerance: a wrong verdict within that limit. Errors are those of the "
    "bracket's\n"
    "worse end, over scale, on the cases by oracle. true in.: the backward error of a float answer against "
    "the input\n"
    "before rounding to float.\n"
    "Tier certified: a verdict that is not the true one and a bracket that does not hold the TOI are "
    "wrong, late\n"
    "or early, however small the error. off: an end farther from contact than the width. not converged: "
    "left open\n"
    "although clearance or depth exceeds that width. within tolerance: left open below it.\n"
    "Tier exact (kappa 0): a verdict or a bound that differs from the exact one in its last bit is wrong. "
    "not asked:\n"
    "cases that the tier does not support, and refuses.\n"
    "median ns: one cast with normal and witnesses, shapes built beforehand.\n";

constexpr const char* kRotatingWords =
    "wrong, late, early (contact claimed where there is none yet), off: by more than kappa u scale of the "
    "method's\n"
    "guarantee. In tier certified, wrong, late and early count however small the error, and off and not "
    "converged count\n"
    "beyond the guaranteed width. within tolerance: decided by less than that. hidden: a contact missed or "
    "passed that\n"
    "the guarantee allows to be. oracle open: the oracle decides no verdict, since clearance and depth are "
    "below its own\n"
    "width. width: for a hit, the larger of the distance at toi_lower and the depth before toi_upper. "
    "passed: the depth\n"
    "of a contact that a miss denied or toi_lower had passed. Both are over scale.\n";

bool has_kind(const Settings& settings, const Certification& certification, Kind kind) {
  return std::any_of(settings.methods.begin(), settings.methods.end(),
                     [&](const Method* method) { return method->kind == kind; }) &&
         std::any_of(certification.tallies.begin(), certification.tallies.end(),
                     [&](const Tally& tally) { return tally.method->kind == kind; });
}

}  // namespace

std::string tally_table(Kind kind, const Certification& certification) {
  return kind == Kind::rotating ? rotating_table(certification) : linear_table(certification);
}

namespace {

std::string number(const std::optional<double>& x) { return x ? fmt::to_string(*x) : "-"; }

std::string most_supports_text(const Tally& total) {
  return std::isnan(total.most_supports.value)
             ? "-"
             : fmt::format("{:.0f} {}", total.most_supports.value, total.most_supports.id);
}

std::string query_table(const Certification& certification, const Settings& settings) {
  Table table({{"query", Align::left},
               {"method", Align::left},
               {"cases"},
               {"wrong"},
               {"off"},
               {"contact\noff"},
               {"stalled"},
               {"within\ntolerance"},
               {"error\nmedian"},
               {"\nworst"},
               {"normal\nworst"},
               {"witness\nworst"},
               {"kappa\npolytopes"},
               {"kappa\nrounded"},
               {"kappa\ncontact"},
               {"stalls\nat most"},
               {"supports\nat most"},
               {"most supports", Align::left},
               {"held", Align::left},
               {"mechanism", Align::left}});
  using J = law::Judgement;
  for (const Method* method : settings.methods) {
    if (method->kind != Kind::query) continue;
    const Tally t = certification.total(*method);
    const engine::Guarantee* row = method->guarantee;
    table.add_row({std::string(corpus::name_of(method->query)),
                   method->full_name(),
                   fmt::to_string(t.cases),
                   fmt::to_string(fault_count(t, &J::wrong)),
                   fmt::to_string(fault_count(t, &J::off)),
                   fmt::to_string(fault_count(t, &J::bad_contact)),
                   fmt::to_string(t.stalled),
                   fmt::to_string(t.within_tolerance),
                   short_number(median(t.backward)),
                   short_number(worst(t.backward)),
                   short_number(worst(t.normal)),
                   short_number(worst(t.witness)),
                   row == nullptr ? "-" : fmt::to_string(row->kappa_polytope),
                   row == nullptr ? "-" : fmt::to_string(row->kappa_rounded),
                   row == nullptr ? "-" : number(row->kappa_contact),
                   row == nullptr ? "-" : fmt::to_string(row->stall_cap),
                   row == nullptr || !row->most_supports ? "-" : fmt::to_string(*row->most_supports),
                   most_supports_text(t),
                   row == nullptr                    ? "no row"
                   : certification.has_kept(*method) ? "yes"
                                                     : "NO",
                   row == nullptr ? "" : row->mechanism});
  }
  return table.text();
}

}  // namespace

std::string guarantee_table(Kind kind, const Certification& certification, const Settings& settings) {
  if (kind == Kind::query) return query_table(certification, settings);
  const bool turning = kind == Kind::rotating;
  std::vector<Column> columns = {{"method", Align::left}, {"tier", Align::left}, {"kappa\npolytopes"},
                                 {"kappa\nrounded"},      {"kappa\ncontact"},    {"width\nat most"}};
  if (turning) {
    columns.push_back({"may\nmiss", Align::left});
    columns.push_back({"may be\nlate", Align::left});
  }
  columns.push_back({"stalls\nat most"});
  columns.push_back({"supports\nat most"});
  columns.push_back({"most supports", Align::left});
  columns.push_back({"held", Align::left});
  if (turning) {
    columns.push_back({"worst width", Align::left});
    columns.push_back({"deepest passed", Align::left});
  }
  columns.push_back({"mechanism", Align::left});
  const std::size_t width = columns.size();
  Table table(std::move(columns));
  const auto worst_text = [](const Tally::Worst& worst) {
    return std::isnan(worst.value) ? "-" : fmt::format("{} {}", short_number(worst.value), worst.id);
  };
  for (const Method* method : settings.methods) {
    if (method->kind != kind) continue;
    const engine::Guarantee* row = method->guarantee;
    std::vector<std::string> cells = {method->full_name(), method->tier};
    if (row == nullptr) {
      cells.resize(width, "-");
      cells[turning ? 11 : 9] = "no row";
      table.add_row(std::move(cells));
      continue;
    }
    if (method->is_ours()) {
      cells.insert(cells.end(), {fmt::to_string(row->kappa_polytope), fmt::to_string(row->kappa_rounded),
                                 number(row->kappa_contact), number(row->width)});
    } else {  // a third-party guarantee need not have a kappa
      cells.insert(cells.end(), 4, "-");
    }
    if (turning) {
      cells.push_back(unseen_text(row->may_miss));
      cells.push_back(unseen_text(row->may_be_late));
    }
    cells.push_back(fmt::to_string(row->stall_cap));
    cells.push_back(row->most_supports ? fmt::to_string(*row->most_supports) : "-");
    cells.push_back(most_supports_text(certification.total(*method)));
    cells.push_back(certification.has_kept(*method) ? "yes" : "NO");
    if (turning) {
      const Tally total = certification.total(*method);
      cells.push_back(worst_text(total.width));
      cells.push_back(worst_text(total.passed));
    }
    cells.push_back(method->is_ours() ? row->mechanism : fmt::format("held to {}", limit_text(*row)));
    table.add_row(std::move(cells));
  }
  return table.text();
}

std::string full_tables(const Certification& certification, const Settings& settings) {
  std::string text;
  if (has_kind(settings, certification, Kind::linear)) {
    std::size_t judged = 0;
    for (const Tally& tally : certification.tallies) {
      judged += tally.method->kind == Kind::linear ? tally.cases : 0;
    }
    text += fmt::format(
        "Casts: {} judged, by proof first; {} answered by the exact oracle as well.\n\n{}\n{}\n", judged,
        tool::counted(certification.oracle_cases, "case"), linear_table(certification), kLinearWords);
    if (const std::string exact = exact_summary(certification, settings); !exact.empty()) {
      text += fmt::format("Tier exact\n\n{}\n", exact);
    }
    text += fmt::format("Guarantees\n\n{}\n", guarantee_table(Kind::linear, certification, settings));
  }
  if (has_kind(settings, certification, Kind::query)) {
    text += fmt::format(
        "Queries beside the cast: as they are asked, and on the bodies of the casts where the exact "
        "oracles know them, and their guarantees\n\n"
        "{}\n",
        query_table(certification, settings));
  }
  if (has_kind(settings, certification, Kind::rotating)) {
    text +=
        fmt::format("Rotating casts, judged by brackets of the first contact and by proofs\n\n{}\n{}\n{}\n",
                    rotating_table(certification), kRotatingWords,
                    guarantee_table(Kind::rotating, certification, settings));
  }
  return text;
}

}  // namespace graze::tool
