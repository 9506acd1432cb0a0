#include "reports/price/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "reports/price/overall.hpp"
#include "reports/price/price_statistics.hpp"

namespace graze::price {
namespace {

double ratio_of(const Row* row) { return row != nullptr && row->ratio ? row->ratio->median : kNone; }

std::string ns_text(double ns) {
  if (ns >= 999'500) return fmt::format("{:.1f} ms", ns / 1e6);
  return ns >= 9'995 ? fmt::format("{:.0f} us", ns / 1e3) : fmt::format("{:.0f} ns", ns);
}

// A ratio that many tables give: the geometric mean, and its ends with where they are.
class Range {
 public:
  void add(double ratio, const std::string& where) {
    if (std::isnan(ratio)) return;
    all_.push_back(ratio);
    if (!(ratio >= low_)) low_ = ratio, low_at_ = where;
    if (!(ratio <= high_)) high_ = ratio, high_at_ = where;
  }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] std::string text() const {
    const std::string middle = times_text(geometric_mean(all_));
    if (all_.size() < 2) return fmt::format("{} times", middle);
    return fmt::format("{} times in the mean, from {} ({}) to {} ({})", middle, times_text(low_), low_at_,
                       times_text(high_), high_at_);
  }

 private:
  std::vector<double> all_;
  double low_ = kNone, high_ = kNone;
  std::string low_at_, high_at_;
};

// Methods that are not compared by their tolerance. Steps have a number of steps. The published bilateral
// advancement may pass a contact by any depth.
bool has_other_measure(const Row& row) {
  return row.method == "steps" || row.method == "spheres" || row.method == "bilateral_published";
}

class Words {
 public:
  explicit Words(const Document& document) : document_(document) {}

  std::vector<Sentence> all() && {
    for (const bool turning : {false, true}) {
      cheapest(turning);
      within(turning);
    }
    digits();
    requests();
    certainty();
    exactness();
    scalars();
    queries();
    advancement();
    growth();
    return std::move(out_);
  }

 private:
  void say(const char* topic, std::string text) { out_.push_back({topic, std::move(text)}); }

  [[nodiscard]] Tables where(const std::function<bool(const PriceTable&)>& holds) const {
    Tables found;
    for (const PriceTable& table : document_.tables) {
      if (holds(table)) found.push_back(&table);
    }
    return found;
  }
  [[nodiscard]] static std::string families_text(const Tables& tables, bool turning) {
    return fmt::format("{} {} of {}", tables.size(), tables.size() == 1 ? "family" : "families",
                       turning ? "rotating bodies" : "linear casts");
  }

  void cheapest(bool turning) {
    const Tables tables = families_of(document_, turning);
    const std::vector<Overall> all = overall(tables);
    if (all.empty()) return;
    const std::string& baseline = tables.front()->baseline;
    const auto first = [&](const char* topic, const char* what, auto holds) {
      const auto found = std::find_if(all.begin(), all.end(), holds);
      if (found == all.end()) {
        say(topic, fmt::format("No method is {} on all {}.", what, families_text(tables, turning)));
        return;
      }
      say(topic,
          fmt::format(
              "The cheapest method that is {} on {}: {}, at {} times the time of {}, with a worst error of "
              "{} of scale.",
              what, families_text(tables, turning), found->row->label, times_text(found->cost), baseline,
              error_text(found->worst)));
    };
    // A contact that is missed is as late as can be.
    first("never_late", "never late, not by a bit, and misses no contact",
          [](const Overall& one) { return one.late == 0 && one.wrong == 0 && one.open == 0; });
    first("never_late", "never late by more than 1e-12 of scale, and misses no contact that deep,",
          [](const Overall& one) { return one.late_by <= 1e-12 && one.denied <= 1e-12 && one.open == 0; });
    first("never_wrong", "never wrong of the verdict, however near the tie,",
          [](const Overall& one) { return one.wrong == 0 && one.open == 0; });
    if (turning) return;
    // Of other shapes tier exact is not asked.
    const Tables for_exact =
        where([](const PriceTable& table) { return table.part == Part::family && is_for_exact(table); });
    const std::vector<Overall> of_exact = overall(for_exact);
    const auto found = std::find_if(of_exact.begin(), of_exact.end(),
                                    [](const Overall& one) { return one.wrong == 0 && one.late == 0; });
    if (found != of_exact.end()) {
      say("never_wrong",
          fmt::format(
              "On what tier exact answers, the cheapest that is neither wrong nor late: {}, at {} times the "
              "time of {}.",
              found->row->label, times_text(found->cost), baseline));
    }
  }

  // The cheapest contender whose worst error is within this limit.
  void within(bool turning) {
    const Tables tables = families_of(document_, turning);
    std::vector<std::string> parts;
    const std::vector<Overall> all = overall(tables);
    for (const double error : {1e-2, 1e-4, 1e-6, 1e-9, 1e-12}) {
      const auto found = std::find_if(all.begin(), all.end(), [&](const Overall& one) {
        return one.worst <= error && one.unsettled == 0 && one.open == 0;
      });
      if (found != all.end())
        parts.push_back(
            fmt::format("{:.0e}: {} ({} times)", error, found->row->label, times_text(found->cost)));
    }
    if (parts.empty()) return;
    say("choose", fmt::format("The cheapest that leaves no verdict open and whose worst answer is within so "
                              "much of scale on {}: {}.",
                              families_text(tables, turning), fmt::join(parts, "; ")));
  }

  void digits() {
    for (const PriceTable& table : document_.tables) {
      std::map<std::string, std::vector<Point>> points;
      std::map<std::string, std::vector<double>> tolerances;
      for (const Row& row : table.rows) {
        if (table.part != Part::family && table.part != Part::query) continue;
        if (row.tier != "standard" || row.scalar != "double" || !row.ratio) continue;
        if (has_other_measure(row)) continue;
        points[row.method].push_back({.cost = row.ratio->median, .error = row.backward.median});
        tolerances[row.method].push_back(row.tolerance);
      }
      std::vector<std::string> parts;
      for (const auto& [method, of_method] : points) {
        if (of_method.size() < 2) continue;
        const std::optional<DigitPrice> price = price_of_a_digit(of_method);
        // The least tolerance is the last row of a sweep.
        const Point& least = of_method.back();
        const Point& dearest =
            *std::max_element(of_method.begin(), of_method.end(),
                              [](const Point& l, const Point& r) { return l.cost < r.cost; });
        std::string text =
            price ? fmt::format("{} {:+.0f} % ({:.0f} digits for {} times the time)", method,
                                100 * (price->factor - 1), price->digits, times_text(price->to / price->from))
                  : fmt::format(
                        "{} nothing (its least tolerance, a median error of {}, takes no longer than any "
                        "coarser one)",
                        method, error_text(least.error));
        // For a polytope the last step is exact, so beyond some tolerance no accuracy is left to gain.
        std::size_t first = of_method.size();
        while (first > 0 && of_method[first - 1].error <= std::max(4 * least.error, kFinest)) --first;
        if (price && first < of_method.size() && tolerances[method][first] > 1e-10)
          text += fmt::format(", all of them there from a tolerance of {:.0e} on", tolerances[method][first]);
        // Looser and dearer: what a tolerance asks for has to be shown, at both ends of the bracket.
        if (dearest.cost > 1.2 * least.cost && dearest.error > least.error) {
          text += fmt::format(
              ", though with a tolerance that leaves {} it takes {} times its least tolerance's time",
              error_text(dearest.error), times_text(dearest.cost / least.cost));
        }
        parts.push_back(std::move(text));
      }
      if (!parts.empty())
        say("digit", fmt::format("One more digit costs, on {}: {}.", table.name, fmt::join(parts, "; ")));
    }
  }

  void requests() {
    for (const PriceTable& table : document_.tables) {
      if (table.part != Part::request) continue;
      std::vector<std::string> methods;
      for (const Row& row : table.rows) {
        const std::string label = row.method + "/" + row.scalar;
        if (row.question.find("cast") == std::string::npos) continue;
        if (std::find(methods.begin(), methods.end(), label) == methods.end()) methods.push_back(label);
      }
      for (const std::string& method : methods) {
        const auto cost = [&](const std::string& label) { return ratio_of(table.find(label)); };
        const double time = cost(method + " time");
        if (std::isnan(time)) continue;
        std::vector<std::string> parts;
        const double verdict = cost("swept_overlap " + method + " verdict");
        if (!std::isnan(verdict))
          parts.push_back(fmt::format("the verdict alone takes {} of it", times_text(verdict / time)));
        for (const char* request : {"normal", "witnesses", "normal, witnesses", "proof", "everything"}) {
          const double more = cost(method + " " + request);
          if (!std::isnan(more))
            parts.push_back(fmt::format("{} {:+.0f} %", request, 100 * (more / time - 1)));
        }
        const Row* proved = table.find(method + " proof");
        say("request", fmt::format("On {}, over the time alone, {} pays: {}{}.", table.name, method,
                                   fmt::join(parts, "; "),
                                   proved == nullptr
                                       ? ""
                                       : fmt::format(" ({} of {} proofs are accepted and prove the verdict)",
                                                     proved->proved, proved->asked)));
      }
      // The cheapest method that proves all its answers, and its total time.
      const Row* cheapest = nullptr;
      for (const Row& row : table.rows) {
        if (row.request != "proof" || row.proved < row.asked || !row.ratio) continue;
        if (cheapest == nullptr || row.ratio->median < cheapest->ratio->median) cheapest = &row;
      }
      if (cheapest != nullptr) {
        say("proof", fmt::format("The cheapest proof on {}: {}, at {} times the time of {}.", table.name,
                                 cheapest->label, times_text(cheapest->ratio->median), table.baseline));
      }
    }
  }

  // The cheapest of tier standard at the least tolerance, in double.
  static const Row* best_standard(const PriceTable& table) {
    const Row* best = nullptr;
    for (const Row& row : table.rows) {
      if (row.tier != "standard" || row.scalar != "double" || row.tolerance > 0 || !row.ratio) continue;
      if (has_other_measure(row)) continue;
      if (best == nullptr || row.ratio->median < best->ratio->median) best = &row;
    }
    return best;
  }

  void certainty() {
    for (const bool turning : {false, true}) {
      Range range;
      for (const PriceTable* table : families_of(document_, turning)) {
        const Row* best = best_standard(*table);
        range.add(ratio_of(table->find("certified/double")) / ratio_of(best), table->name);
      }
      if (!range.empty()) {
        say("certainty",
            fmt::format("Certainty, {}: tier certified takes {} the time of the quickest standard "
                        "method at its least tolerance.",
                        turning ? "rotating bodies" : "linear casts", range.text()));
      }
    }
  }

  void exactness() {
    Range over_mpr, over_certified;
    for (const PriceTable* table : families_of(document_, false)) {
      if (!is_for_exact(*table)) continue;
      const Row* exact = table->find("exact/double");
      over_mpr.add(ratio_of(exact) / ratio_of(table->find("mpr/double")), table->name);
      over_certified.add(ratio_of(exact) / ratio_of(table->find("certified/double")), table->name);
    }
    if (over_mpr.empty()) return;
    say("exactness", fmt::format("Exactness: tier exact takes {} the time of mpr/double, and {} that of "
                                 "certified/double.",
                                 over_mpr.text(), over_certified.text()));
  }

  void scalars() {
    for (const char* method : {"ca", "gjk", "mpr", "certified", "exact"}) {
      Range range;
      double in_float = 0, in_double = 0;
      for (const PriceTable* table : families_of(document_, false)) {
        const Row* f = table->find(std::string(method) + "/float");
        const Row* d = table->find(std::string(method) + "/double");
        if (f == nullptr || d == nullptr) continue;
        range.add(ratio_of(f) / ratio_of(d), table->name);
        in_float = std::fmax(in_float, f->backward.worst);
        in_double = std::fmax(in_double, d->backward.worst);
      }
      if (range.empty()) continue;
      say("scalar",
          fmt::format("Float against double, {}: {} the time; its worst backward error {} of scale, and "
                      "{} in double.",
                      method, range.text(), error_text(in_float), error_text(in_double)));
    }
  }

  void queries() {
    Range shallow, deep, before_after, mpr;
    for (const PriceTable& table : document_.tables) {
      if (table.part != Part::query) continue;
      const std::string at = std::isnan(table.x) ? "" : fmt::format("{:g} vertices", table.x);
      const double epa = ratio_of(table.find("penetration epa/double")) /
                         ratio_of(table.find("penetration_along mpr/double"));
      if (table.series == "penetration, shallow") shallow.add(epa, at);
      if (table.series == "penetration, deep") deep.add(epa, at);
      if (table.series != "swept") continue;
      const double sum = ratio_of(table.find("swept_overlap gjk/double"));
      before_after.add(ratio_of(table.find("swept_overlap before_after/double")) / sum, at);
      mpr.add(ratio_of(table.find("swept_overlap mpr/double")) / sum, at);
    }
    if (!shallow.empty()) {
      say("epa_mpr",
          fmt::format(
              "EPA, which finds the least depth, against MPR, which is given the direction, on hulls: "
              "shallow {} the time, deep {}.",
              shallow.text(), deep.text()));
    }
    if (!before_after.empty()) {
      say("swept",
          fmt::format(
              "Before-and-after points against the swept sum, both by GJK, on hulls: {} the time, and MPR "
              "on the sum {}.",
              before_after.text(), mpr.text()));
    }
  }

  // The tables, families and growth, in which one call of a method evaluated the most supports.
  [[nodiscard]] std::string crawl_of(const std::string& label, bool turning) const {
    const Row* most = nullptr;
    const PriceTable* at = nullptr;
    for (const PriceTable& table : document_.tables) {
      if ((table.kind == "rotating") != turning || table.kind == "query") continue;
      const Row* row = table.find(label);
      if (row == nullptr || std::isnan(row->supports.worst)) continue;
      if (most == nullptr || row->supports.worst > most->supports.worst) {
        most = row;
        at = &table;
      }
    }
    if (most == nullptr) return {};
    return fmt::format("{} at most {:.0f} supports ({}, where the mean is {:.0f})", label,
                       most->supports.worst, at->name, most->supports.mean);
  }

  void advancement() {
    Range linear, turning;
    for (const PriceTable* table : families_of(document_, false))
      linear.add(ratio_of(table->find("ca/double")) / ratio_of(table->find("gjk/double")), table->name);
    for (const PriceTable* table : families_of(document_, true))
      turning.add(ratio_of(table->find("ca/double")) / ratio_of(table->find("bilateral/double")),
                  table->name);
    if (!linear.empty())
      say("advancement",
          fmt::format("Conservative advancement against the GJK ray cast: {} the time.", linear.text()));
    if (!turning.empty()) {
      say("advancement", fmt::format("Conservative advancement against bilateral advancement: {} the time.",
                                     turning.text()));
    }
    for (const bool turns : {false, true}) {
      std::vector<std::string> parts;
      const std::vector<std::string> labels =
          turns ? std::vector<std::string>{"ca/double", "bilateral/double", "certified/double"}
                : std::vector<std::string>{"ca/double", "gjk/double", "mpr/double", "certified/double",
                                           "exact/double"};
      for (const std::string& label : labels) {
        std::string text = crawl_of(label, turns);
        if (!text.empty()) parts.push_back(std::move(text));
      }
      if (!parts.empty())
        say("crawls", fmt::format("The slowest search of each method, {}: {}.",
                                  turns ? "rotating bodies" : "linear casts", fmt::join(parts, "; ")));
    }
  }

  void growth() {
    std::vector<std::string> series;
    for (const PriceTable& table : document_.tables) {
      if (table.part == Part::growth && std::find(series.begin(), series.end(), table.series) == series.end())
        series.push_back(table.series);
    }
    for (const std::string& name : series) {
      const Tables tables =
          where([&](const PriceTable& t) { return t.part == Part::growth && t.series == name; });
      if (tables.size() < 2) continue;
      const bool by_power = tables.front()->x_name.find("vertices") != std::string::npos;
      std::vector<std::string> parts;
      for (const Row& first : tables.front()->rows) {
        const Row* last = tables.back()->find(first.label);
        if (last == nullptr || !first.time || !last->time) continue;
        std::vector<Point> points;
        for (const PriceTable* table : tables) {
          const Row* row = table->find(first.label);
          if (row != nullptr && row->time) points.push_back({.cost = table->x, .error = row->time->median});
        }
        std::string text = fmt::format("{} from {} to {}, {:.0f} to {:.0f} supports", first.label,
                                       ns_text(first.time->median), ns_text(last->time->median),
                                       first.supports.mean, last->supports.mean);
        if (by_power) text += fmt::format(", as the power {:.2f}", power_of_growth(points));
        parts.push_back(std::move(text));
      }
      say("growth", fmt::format("{}, {} = {:g} to {:g}: {}.", name, tables.front()->x_name, tables.front()->x,
                                tables.back()->x, fmt::join(parts, "; ")));
    }
  }

  const Document& document_;
  std::vector<Sentence> out_;
};

}  // namespace

std::vector<Sentence> sentences_of(const Document& document) { return Words(document).all(); }

}  // namespace graze::price
