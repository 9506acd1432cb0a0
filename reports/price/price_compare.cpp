#include "reports/price/price_compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "reports/price/price_statistics.hpp"

namespace graze::price {
namespace {

// Below this an error is the rounding of its scalar, of which compilers may choose another.
double noise_of(const Row& row) { return row.scalar == "float" ? 1e-6 : 1e-14; }

class Rows {
 public:
  Rows(const std::string& where, const Row& before, const Row& after, const CompareSettings& settings,
       Comparison& out)
      : where_(where + ", " + after.label), before_(before), after_(after), settings_(settings), out_(out) {}

  void operator()() {
    ++out_.rows;
    ratio();
    work("supports", before_.supports.mean, after_.supports.mean);
    work("iterations", before_.iterations.mean, after_.iterations.mean);
    error("median backward error", before_.backward.median, after_.backward.median);
    error("99th percentile of the backward error", before_.backward.p99, after_.backward.p99);
    error("worst backward error", before_.backward.worst, after_.backward.worst);
    error("greatest lateness", before_.late_by, after_.late_by);
    error("greatest length denied by a wrong verdict", before_.denied, after_.denied);
    count("wrong verdicts", before_.wrong, after_.wrong);
    count("late answers", before_.late, after_.late);
    count("answers that do not converge", before_.failures.not_converged, after_.failures.not_converged);
    count("answers without a time", before_.failures.no_time, after_.failures.no_time);
    count("refusals", before_.failures.refused, after_.failures.refused);
    // Fewer proofs are worse.
    if (after_.proved != before_.proved)
      say(after_.proved < before_.proved, fmt::format("proofs {} -> {}", before_.proved, after_.proved));
  }

 private:
  void say(bool is_worse, const std::string& what) {
    (is_worse ? out_.worse : out_.better).push_back(where_ + ": " + what);
  }

  void ratio() {
    if (!before_.ratio || !after_.ratio || overlap(*before_.ratio, *after_.ratio)) return;
    const double change = after_.ratio->median / before_.ratio->median;
    if (change < 1 + settings_.threshold && change > 1 / (1 + settings_.threshold)) return;
    say(change > 1,
        fmt::format("time over the baseline's {:.2f} ({:.2f} to {:.2f}) -> {:.2f} ({:.2f} to {:.2f})",
                    before_.ratio->median, before_.ratio->low, before_.ratio->high, after_.ratio->median,
                    after_.ratio->low, after_.ratio->high));
  }
  void work(const char* what, double before, double after) {
    if (std::isnan(before) || std::isnan(after)) return;
    const double change = (after + 1e-9) / (before + 1e-9);
    if (change < 1 + settings_.threshold && change > 1 / (1 + settings_.threshold)) return;
    say(change > 1, fmt::format("{} a call {:.2f} -> {:.2f}", what, before, after));
  }
  void error(const char* what, double before, double after) {
    // None is no error of that kind at all.
    before = std::isnan(before) ? 0 : before;
    after = std::isnan(after) ? 0 : after;
    const double noise = noise_of(after_);
    if (after > std::max(settings_.error_factor * before, noise))
      say(true, fmt::format("{} {:.1e} -> {:.1e} of scale", what, before, after));
    if (before > std::max(settings_.error_factor * after, noise))
      say(false, fmt::format("{} {:.1e} -> {:.1e} of scale", what, before, after));
  }
  // Answers that are late or wrong only by rounding may change with the compiler. They are reported if there
  // are more.
  void count(const char* what, std::size_t before, std::size_t after) {
    if (before == after) return;
    const bool by_rounding =
        (std::string_view(what) == "late answers" && !(after_.late_by > noise_of(after_))) ||
        (std::string_view(what) == "wrong verdicts" && !(after_.denied > noise_of(after_)));
    // Tiers certified and exact guarantee that there are no such answers.
    const bool promised = after_.tier == "certified" || after_.tier == "exact";
    if (after > before && by_rounding && !promised) return;
    say(after > before, fmt::format("{} {} -> {}", what, before, after));
  }

  std::string where_;
  const Row& before_;
  const Row& after_;
  const CompareSettings& settings_;
  Comparison& out_;
};

// The median of the changes of all ratios but the baseline's own: well below 1, it is the baseline that
// changed.
double common_change(const PriceTable& before, const PriceTable& after) {
  std::vector<double> changes;
  for (const Row& row : after.rows) {
    const Row* old = before.find(row.label);
    if (row.label == after.baseline || old == nullptr || !old->ratio || !row.ratio) continue;
    if (overlap(*old->ratio, *row.ratio)) {
      changes.push_back(1);
    } else {
      changes.push_back(row.ratio->median / old->ratio->median);
    }
  }
  return quantile(changes, 0.5);
}

}  // namespace

Comparison compare(const Document& old_run, const Document& new_run, const CompareSettings& settings) {
  if (old_run.effort != new_run.effort || old_run.seed != new_run.seed) {
    throw std::runtime_error(
        fmt::format("the runs are of other cases: one is {} with seed {}, the other {} with seed {}",
                    old_run.effort, old_run.seed, new_run.effort, new_run.seed));
  }
  Comparison out;
  for (const PriceTable& after : new_run.tables) {
    const PriceTable* before = old_run.find(after.name);
    if (before == nullptr) {
      out.not_compared.push_back(after.name + ": the old run has no such table");
      continue;
    }
    if (before->baseline != after.baseline || before->cases != after.cases) {
      out.not_compared.push_back(fmt::format("{}: {} cases over {} in the old run, {} over {} in the new one",
                                             after.name, before->cases, before->baseline, after.cases,
                                             after.baseline));
      continue;
    }
    if (const double change = common_change(*before, after); change < 1 / (1 + settings.threshold)) {
      out.worse.push_back(
          fmt::format("{}: the baseline {} is slower, or all others are quicker: their ratios to "
                      "it fell to {:.2f} of what they were",
                      after.name, after.baseline, change));
    }
    for (const Row& row : after.rows) {
      const Row* old = before->find(row.label);
      if (old == nullptr || old->asked != row.asked) {
        out.not_compared.push_back(after.name + ", " + row.label + ": the old run did not ask it the same");
        continue;
      }
      Rows(after.name, *old, row, settings, out)();
    }
    for (const Row& row : before->rows) {
      if (after.find(row.label) == nullptr)
        out.not_compared.push_back(after.name + ", " + row.label + ": the new run does not have it");
    }
  }
  for (const PriceTable& before : old_run.tables) {
    if (new_run.find(before.name) == nullptr)
      out.not_compared.push_back(before.name + ": the new run has no such table");
  }
  if (out.rows == 0) throw std::runtime_error("the runs have nothing in common that could be compared");
  return out;
}

}  // namespace graze::price
