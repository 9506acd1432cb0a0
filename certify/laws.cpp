#include "certify/laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "certify/laws_of_others.hpp"
#include "properties/generate/shrink.hpp"
#include "reports/text/progress.hpp"
#include "reports/text/table.hpp"
#include "scene/src/parallel.hpp"

namespace graze::tool {
namespace {

using engine::Kind;
using law::Holding;
using law::Law;
using law::LawResult;

// (law, method): what breaks, until now the first of its cases.
using Breaches = std::map<std::pair<std::size_t, std::size_t>, LawBreach>;

// Adds a broken answer. The first in the order of suites and cases is kept, independent of the order of
// threads.
void add_breach(Breaches& breaches, LawBreach one) {
  LawBreach& kept = breaches.try_emplace({one.law, one.method}).first->second;
  const std::size_t times = kept.times + one.times;
  const bool is_first = kept.times == 0 || std::tie(one.suite, one.index) < std::tie(kept.suite, kept.index);
  if (is_first) kept = std::move(one);
  kept.times = times;
}

// A method of ours, or of a third party. The latter are numbered after ours.
const engine::Method& method_of(const Law& law, std::size_t number, const LawSettings& settings) {
  const std::size_t ours = law.methods().size();
  return number < ours ? law.methods()[number] : settings.others[number - ours];
}

LawResult check(const Law& law, const corpus::Case& problem, const engine::Method& method) {
  return method.is_ours() ? law.check(problem, method) : check_other(law, problem, method);
}

// A third-party engine may use up its time limit for every answer.
constexpr std::chrono::seconds kMostOfAnother{20};

void make_small(LawBreach& breach, const LawSettings& settings) {
  const Law& law = settings.laws[breach.law];
  corpus::Case& problem = breach.finding.problem;
  const engine::Method& method = method_of(law, breach.method, settings);
  const auto stop = std::chrono::steady_clock::now() + kMostOfAnother;
  const auto is_broken = [&](const corpus::Case& c) {
    if (settings.stop() || (!method.is_ours() && std::chrono::steady_clock::now() > stop)) return false;
    return check(law, c, method).holding == Holding::broken;
  };
  problem = law::minimised(problem, is_broken,
                           law.kind == Kind::rotating ? settings.shrinking / 10 : settings.shrinking);
  // One that fails now and then may answer this time.
  if (const LawResult again = check(law, problem, method); again.holding == Holding::broken)
    breach.finding.reason = again.reason;
}

bool is_about(const Law& law, const LawSuite& suite) {
  return (law.kind == Kind::rotating) == (suite.suite.kind == Kind::rotating);
}

LawBreach breach_of(const Law& law, std::size_t l, std::size_t m, std::size_t s, std::size_t i,
                    const LawSuite& one, const corpus::Case& problem, const engine::Method& method,
                    std::string reason) {
  LawBreach breach{
      .law = l, .method = m, .suite = s, .index = i, .times = 1, .finding = {}, .first = problem.id};
  breach.finding = {.law = law.name,
                    .sentence = law.sentence,
                    .method = method.question_name(),
                    .reason = std::move(reason),
                    .seed = one.seed && i >= one.suite.cases.size() ? one.seed(i) : problem.id,
                    .problem = problem};
  return breach;
}

void add(OtherLawTally& tally, const LawResult& result) {
  const auto has = [&](std::string_view label) {
    return std::find(result.labels.begin(), result.labels.end(), label) != result.labels.end();
  };
  if (result.holding == Holding::not_applicable) {
    ++(has(kSkipped) ? tally.skipped : tally.open);
    return;
  }
  ++tally.answers;
  if (result.holding == Holding::broken) ++tally.broken;
  if (has(kFailed)) ++tally.failed;
}

std::vector<OtherLawTally> other_tallies(const LawSettings& settings) {
  std::vector<OtherLawTally> all;
  for (std::size_t l = 0; l < settings.laws.size(); ++l) {
    for (std::size_t k = 0; k < settings.others.size(); ++k) {
      if (settings.others[k].kind != settings.laws[l].kind) continue;
      all.push_back({.law = l, .other = k, .why_not = why_not_for(settings.laws[l], settings.others[k])});
    }
  }
  return all;
}

}  // namespace

LawCertification certify_laws(std::span<const LawSuite> suites, const LawSettings& settings) {
  LawCertification result;
  for (const Law& law : settings.laws) result.tallies.emplace_back(law);
  result.others = other_tallies(settings);
  Breaches breaches;
  std::mutex mutex;
  for (std::size_t s = 0; s < suites.size(); ++s) {
    const LawSuite& one = suites[s];
    std::atomic<std::size_t> seen_cases = 0;
    Progress progress("laws on " + one.suite.family, one.suite.size());
    scene::for_each_index(one.suite.size(), settings.threads, [&](std::size_t i) {
      if (settings.stop()) return;
      ++seen_cases;
      const corpus::Case problem = one.suite.at(i);
      // Runs all laws on one case, then the next, so that they share the oracle's results.
      for (std::size_t l = 0; l < settings.laws.size(); ++l) {
        const Law& law = settings.laws[l];
        if (!is_about(law, one)) continue;
        law::LawTally tally(law);
        for (std::size_t m = 0; m < law.methods().size(); ++m) {
          if (!settings.is_asked(law.methods()[m])) continue;
          const LawResult answer = law.check(problem, law.methods()[m]);
          tally.add(m, one.suite.family, answer);
          if (answer.holding != Holding::broken) continue;
          LawBreach breach = breach_of(law, l, m, s, i, one, problem, law.methods()[m], answer.reason);
          const std::lock_guard lock(mutex);
          add_breach(breaches, std::move(breach));
        }
        const std::lock_guard lock(mutex);
        result.tallies[l].add(tally);
      }
      // One that failed is not asked the other laws about this case.
      std::vector<char> has_failed(settings.others.size());
      for (std::size_t t = 0; t < result.others.size(); ++t) {
        const auto [l, k] = std::pair(result.others[t].law, result.others[t].other);
        const Law& law = settings.laws[l];
        if (!is_about(law, one) || !result.others[t].why_not.empty()) continue;
        OtherLawTally seen;
        LawResult answer{.holding = Holding::not_applicable, .reason = {}, .labels = {kSkipped}};
        if (has_failed[k] == 0) answer = check_other(law, problem, settings.others[k]);
        add(seen, answer);
        has_failed[k] = static_cast<char>(has_failed[k] != 0 || seen.failed > 0);
        const std::lock_guard lock(mutex);
        OtherLawTally& tally = result.others[t];
        tally.answers += seen.answers;
        tally.broken += seen.broken;
        tally.failed += seen.failed;
        tally.skipped += seen.skipped;
        tally.open += seen.open;
        if (answer.holding == Holding::broken)
          add_breach(breaches, breach_of(law, l, law.methods().size() + k, s, i, one, problem,
                                         settings.others[k], answer.reason));
      }
      progress.step();
    });
    result.cases += seen_cases;
    if (seen_cases < one.suite.size()) result.unfinished.push_back(one.suite.family);
  }
  for (auto& [key, breach] : breaches) result.breaches.push_back(std::move(breach));
  Progress progress("making broken cases small", result.breaches.size());
  scene::for_each_index(result.breaches.size(), settings.threads, [&](std::size_t i) {
    make_small(result.breaches[i], settings);
    progress.step();
  });
  return result;
}

std::string other_law_table(const LawCertification& certification, const LawSettings& settings) {
  Table table({{"law", Align::left},
               {"engine", Align::left},
               {"needs", Align::left},
               {"answers"},
               {"not\nasked"},
               {"not for\nthe law"},
               {"failed"},
               {"broken"}});
  std::map<std::string, std::vector<std::string>> left_out;  // by reason
  std::size_t last = settings.laws.size(), count = 0;
  for (const OtherLawTally& tally : certification.others) {
    const Law& law = settings.laws[tally.law];
    if (!tally.why_not.empty()) {
      std::vector<std::string>& names = left_out[std::string(tally.why_not)];
      if (std::find(names.begin(), names.end(), law.name) == names.end()) names.push_back(law.name), ++count;
      continue;
    }
    if (last < settings.laws.size() && settings.laws[last].kind != law.kind) table.add_gap();
    last = tally.law;
    table.add_row({law.name, settings.others[tally.other].question_name(),
                   std::string(law::to_text(law.needs)), fmt::to_string(tally.answers),
                   fmt::to_string(tally.skipped), fmt::to_string(tally.open), fmt::to_string(tally.failed),
                   fmt::to_string(tally.broken)});
  }
  std::string text =
      table.text() +
      "not asked: the engine does not support a question of the law, or failed on this case before. not "
      "for the law:\n"
      "the law does not apply to the case, or its oracle leaves it open. failed: crashed, hung, or wrote "
      "no valid answer.\n";
  if (count > 0) text += fmt::format("{} laws do not apply to third-party engines:\n", count);
  for (const auto& [why, names] : left_out) text += fmt::format("  {}: {}\n", why, fmt::join(names, ", "));
  return text;
}

std::string law_table(const LawCertification& certification, const LawSettings& settings) {
  Table table({{"law", Align::left},
               {"kind", Align::left},
               {"needs", Align::left},
               {"answers"},
               {"hit"},
               {"miss"},
               {"start in\ncontact"},
               {"not\nconverged"},
               {"left\nopen"},
               {"not for\nthe law"},
               {"broken"}});
  for (std::size_t l = 0; l < settings.laws.size(); ++l) {
    const Law& law = settings.laws[l];
    const law::LawTally& tally = certification.tallies[l];
    if (l > 0 && settings.laws[l - 1].kind != law.kind) table.add_gap();
    table.add_row({law.name, std::string(engine::to_text(law.kind)), std::string(law::to_text(law.needs)),
                   fmt::to_string(tally.applied()), fmt::to_string(tally.count("hit")),
                   fmt::to_string(tally.count("miss")), fmt::to_string(tally.count("initially_overlapping")),
                   fmt::to_string(tally.count("not_converged")), fmt::to_string(tally.left_open()),
                   fmt::to_string(tally.not_applicable() - tally.left_open()),
                   fmt::to_string(tally.broken())});
  }
  return table.text();
}

}  // namespace graze::tool
