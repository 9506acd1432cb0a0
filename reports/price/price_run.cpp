#include "reports/price/price_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>

#include "corpus/format/case_io.hpp"
#include "reports/price/measure.hpp"
#include "reports/price/price_statistics.hpp"
#include "reports/text/progress.hpp"
#include "scene/src/parallel.hpp"

namespace graze::price {
namespace {

using corpus::Case;

// A case is written into the report up to this size.
constexpr std::size_t kMostWritten = 20'000;
// A call that takes longer is timed in the first rounds alone: it spreads less, and would take the run's
// time.
constexpr double kLongCall = 2e6;  // ns
constexpr int kLongRounds = 2;

struct Answers {
  std::vector<std::vector<Measured>> measured;  // [case][contender]
  std::vector<Shown> shown;
  std::vector<TruthBy> by;
};

Answers ask_all(const Topic& topic, const std::vector<Case>& cases, const std::vector<Contender>& contenders,
                const RunSettings& settings) {
  Answers out;
  out.measured.resize(cases.size());
  out.shown.resize(cases.size());
  out.by.assign(cases.size(), TruthBy::open);
  scene::for_each_index(cases.size(), settings.threads, [&](std::size_t i) {
    if (settings.stop()) return;
    std::unique_ptr<Judge> judge;
    if (topic.measures) judge = std::make_unique<Judge>(cases[i], topic.kind);
    for (const Contender& contender : contenders) {
      const engine::Method& method = *contender.method;
      Case asked = cases[i];
      asked.query = method.query;
      Measured measured{.asked = takes(method, asked)};
      if (measured.asked) {
        const engine::Answer answer = method.ask(asked, contender.ask);
        measured = begun(asked, method, answer, contender.ask.request);
        if (judge) judge->judge(measured, method, answer);
      }
      out.measured[i].push_back(measured);
    }
    out.shown[i] = judge ? judge->shown() : Shown{.id = cases[i].id, .outcome = {}};
    if (judge) out.by[i] = judge->by();
  });
  return out;
}

// ns[round][contender][case], NaN if not timed.
using Clocked = std::vector<std::vector<std::vector<double>>>;

Clocked time_all(const std::vector<Case>& cases, const std::vector<Contender>& contenders,
                 const Answers& answers, const RunSettings& settings) {
  Clocked ns(static_cast<std::size_t>(settings.rounds),
             std::vector(contenders.size(), std::vector<double>(cases.size(), kNone)));
  corpus::Random random(settings.seed);
  std::vector<std::size_t> order(cases.size() * contenders.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<char> is_long(order.size(), 0);
  for (std::size_t round = 0; round < ns.size(); ++round) {
    // Case by case, so that a ratio's two times are taken within a moment of one another.
    std::vector<std::size_t> by_case(cases.size()), by_contender(contenders.size());
    std::iota(by_case.begin(), by_case.end(), 0);
    std::iota(by_contender.begin(), by_contender.end(), 0);
    const auto shuffle = [&](std::vector<std::size_t>& list) {
      for (std::size_t k = list.size(); k > 1; --k) std::swap(list[k - 1], list[random.below(k)]);
    };
    shuffle(by_case);
    for (const std::size_t i : by_case) {
      shuffle(by_contender);
      for (const std::size_t c : by_contender) {
        const engine::Method& method = *contenders[c].method;
        const std::size_t which = i * contenders.size() + c;
        if (!answers.measured[i][c].asked || answers.measured[i][c].refused || method.time_ns == nullptr)
          continue;
        if (is_long[which] != 0 && round >= kLongRounds) continue;
        if (settings.stop()) return ns;
        Case asked = cases[i];
        asked.query = method.query;
        const double time = method.time_ns(asked, contenders[c].ask, 1);
        ns[round][c][i] = time;
        if (time > kLongCall) is_long[which] = 1;
      }
    }
  }
  return ns;
}

// For each case, the median over the rounds.
std::vector<double> medians(const Clocked& ns, std::size_t contender) {
  std::vector<double> out(ns.front()[contender].size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::vector<double> rounds;
    for (const auto& round : ns) rounds.push_back(round[contender][i]);
    out[i] = quantile(std::move(rounds), 0.5);
  }
  return out;
}

std::vector<double> ratios(const Clocked& ns, std::size_t contender, std::size_t baseline) {
  std::vector<double> out;
  for (const auto& round : ns) {
    std::vector<double> of_cases;
    for (std::size_t i = 0; i < round[contender].size(); ++i)
      of_cases.push_back(round[contender][i] / round[baseline][i]);
    out.push_back(geometric_mean(of_cases));
  }
  return out;
}

Row row_of(const Contender& contender, const std::vector<Case>& cases, const Answers& answers,
           const Clocked& ns, std::size_t c, std::optional<std::size_t> baseline) {
  Row row = contender.head;
  std::vector<double> backward, forward, width, iterations, supports;
  double worst = -1;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Measured& one = answers.measured[i][c];
    if (!one.asked) continue;
    ++row.asked;
    row.failures.not_converged += one.not_converged ? 1 : 0;
    row.failures.no_time += one.no_time ? 1 : 0;
    row.failures.refused += one.refused ? 1 : 0;
    row.wrong += one.wrong ? 1 : 0;
    row.late += one.late ? 1 : 0;
    row.proved += one.proved ? 1 : 0;
    row.denied = std::fmax(row.denied, one.denied);
    row.late_by = std::fmax(row.late_by, one.late_by);
    backward.push_back(one.backward);
    forward.push_back(one.forward);
    width.push_back(one.width);
    iterations.push_back(one.iterations);
    supports.push_back(one.supports);
    const double error = std::fmax(one.backward, one.denied);
    if (error > worst) {
      worst = error;
      row.worst_case = cases[i].id;
    }
  }
  row.backward = errors_of(backward);
  row.forward = errors_of(forward);
  row.width = errors_of(width);
  row.iterations = work_of(iterations);
  row.supports = work_of(supports);
  const std::vector<double> times = medians(ns, c);
  row.time = times_of(times);
  if (row.time) {
    for (std::size_t i = 0; i < times.size(); ++i) {
      if (times[i] == row.time->worst) row.slowest_case = cases[i].id;
    }
    if (baseline) row.ratio = spread_of(ratios(ns, c, *baseline));
  }
  return row;
}

void mark_front(PriceTable& table) {
  std::vector<Point> points;
  for (const Row& row : table.rows)
    points.push_back({.cost = row.time ? row.time->median : kNone, .error = row.backward.median});
  const std::vector<bool> front = pareto_front(points);
  for (std::size_t r = 0; r < front.size(); ++r) table.rows[r].on_front = front[r];
}

// Those that a row names.
void keep_shown(PriceTable& table, const std::vector<Case>& cases, const Answers& answers) {
  std::set<std::string> named;
  for (const Row& row : table.rows) {
    named.insert(row.worst_case);
    named.insert(row.slowest_case);
  }
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (named.count(cases[i].id) == 0) continue;
    Shown shown = answers.shown[i];
    std::string text = corpus::write_case(cases[i]);
    if (text.size() <= kMostWritten) shown.written = std::move(text);
    table.shown.push_back(std::move(shown));
  }
}

bool is_wanted(const PriceTable& head, const std::vector<std::string>& only) {
  return only.empty() || std::any_of(only.begin(), only.end(), [&](const std::string& name) {
           return name == head.name || name == head.group || (!head.series.empty() && name == head.series);
         });
}

}  // namespace

PriceTable measure_table(const Topic& topic, const std::vector<Contender>& contenders,
                         const RunSettings& settings) {
  PriceTable table = topic.head;
  const std::vector<Case> cases = cases_of(topic, settings.seed);
  table.cases = cases.size();
  const Answers answers = ask_all(topic, cases, contenders, settings);
  if (settings.stop()) return table;
  for (const TruthBy by : answers.by) {
    if (!topic.measures) continue;
    ++(by == TruthBy::exact     ? table.truth.exact
       : by == TruthBy::bracket ? table.truth.bracket
       : by == TruthBy::proof   ? table.truth.proof
                                : table.truth.open);
  }
  const Clocked ns = time_all(cases, contenders, answers, settings);
  std::optional<std::size_t> baseline;
  for (std::size_t c = 0; c < contenders.size(); ++c) {
    const std::string& label = contenders[c].head.label;
    if (label == table.baseline || label == table.baseline + " time") {
      baseline = c;
      table.baseline = label;
    }
  }
  for (std::size_t c = 0; c < contenders.size(); ++c) {
    Row row = row_of(contenders[c], cases, answers, ns, c, baseline);
    if (row.asked > 0) table.rows.push_back(std::move(row));
  }
  if (topic.measures) mark_front(table);
  keep_shown(table, cases, answers);
  return table;
}

bool is_known(const std::string& name, bool thorough) {
  const std::vector<Topic> all = topics(thorough);
  return std::any_of(all.begin(), all.end(),
                     [&](const Topic& topic) { return is_wanted(topic.head, {name}); });
}

Document run(const RunSettings& settings, Document document) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const double before = document.seconds;
  document.effort = settings.thorough ? "thorough" : "quick";
  document.seed = settings.seed;
  document.rounds = settings.rounds;
  document.finished = false;
  std::vector<Topic> wanted = topics(settings.thorough);
  std::erase_if(wanted, [&](const Topic& topic) { return !is_wanted(topic.head, settings.only); });
  {
    tool::Progress progress("price", wanted.size(), document.tables.size());
    for (const Topic& topic : wanted) {
      if (document.find(topic.head.name) != nullptr) continue;
      if (settings.stop()) return document;
      progress.advance(0, topic.head.name);
      PriceTable table =
          measure_table(topic, contenders_of(topic, settings.others, settings.thorough), settings);
      if (settings.stop()) return document;
      document.tables.push_back(std::move(table));
      document.seconds = before + std::chrono::duration<double>(Clock::now() - start).count();
      settings.keep(document);
      progress.advance(1, topic.head.name);
    }
  }
  document.finished = true;
  return document;
}

}  // namespace graze::price
