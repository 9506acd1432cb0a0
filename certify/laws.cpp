#include "certify/laws.hpp"

#include <fmt/format.h>

#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "properties/generate/shrink.hpp"
#include "report/parallel.hpp"
#include "report/progress.hpp"
#include "report/table.hpp"

namespace graze::tool {
namespace {

using engine::Kind;
using law::Holding;
using law::Law;
using law::LawResult;

// (law, method): what breaks, until now the first of its cases.
using Breaches = std::map<std::pair<std::size_t, std::size_t>, LawBreach>;

// Adds a broken answer; the first in the order of suites and cases stays, whichever thread came first.
void add_breach(Breaches& breaches, LawBreach one) {
  LawBreach& kept = breaches.try_emplace({one.law, one.method}).first->second;
  const std::size_t times = kept.times + one.times;
  const bool is_first = kept.times == 0 || std::tie(one.suite, one.index) < std::tie(kept.suite, kept.index);
  if (is_first) kept = std::move(one);
  kept.times = times;
}

void make_small(LawBreach& breach, const LawSettings& settings) {
  const Law& law = settings.laws[breach.law];
  corpus::Case& problem = breach.finding.problem;
  const auto is_broken = [&](const corpus::Case& c) {
    return law.check(c, law.methods()[breach.method]).holding == Holding::broken;
  };
  problem = law::minimised(problem, is_broken,
                           law.kind == Kind::rotating ? settings.shrinking / 10 : settings.shrinking);
  breach.finding.reason = law.check(problem, law.methods()[breach.method]).reason;
}

}  // namespace

LawCertification certify_laws(std::span<const LawSuite> suites, const LawSettings& settings) {
  LawCertification result;
  for (const Law& law : settings.laws) result.tallies.emplace_back(law);
  Breaches breaches;
  std::mutex mutex;
  for (std::size_t s = 0; s < suites.size(); ++s) {
    const LawSuite& one = suites[s];
    result.cases += one.suite.size();
    Progress progress("laws on " + one.suite.family, one.suite.size());
    for_each_index(one.suite.size(), settings.threads, [&](std::size_t i) {
      const corpus::Case problem = one.suite.at(i);
      // All laws on one case, then the next: they share what the oracle said about it.
      for (std::size_t l = 0; l < settings.laws.size(); ++l) {
        const Law& law = settings.laws[l];
        if ((law.kind == Kind::rotating) != (one.suite.kind == Kind::rotating)) continue;
        law::LawTally tally(law);
        for (std::size_t m = 0; m < law.methods().size(); ++m) {
          if (!settings.is_asked(law.methods()[m])) continue;
          const LawResult answer = law.check(problem, law.methods()[m]);
          tally.add(m, one.suite.family, answer);
          if (answer.holding != Holding::broken) continue;
          LawBreach breach{
              .law = l, .method = m, .suite = s, .index = i, .times = 1, .finding = {}, .first = problem.id};
          breach.finding = {.law = law.name,
                            .sentence = law.sentence,
                            .method = law.methods()[m].question_name(),
                            .reason = answer.reason,
                            .seed = one.seed && i >= one.suite.cases.size() ? one.seed(i) : problem.id,
                            .problem = problem};
          const std::lock_guard lock(mutex);
          add_breach(breaches, std::move(breach));
        }
        const std::lock_guard lock(mutex);
        result.tallies[l].add(tally);
      }
      progress.step();
    });
  }
  for (auto& [key, breach] : breaches) result.breaches.push_back(std::move(breach));
  Progress progress("making broken cases small", result.breaches.size());
  for_each_index(result.breaches.size(), settings.threads, [&](std::size_t i) {
    make_small(result.breaches[i], settings);
    progress.step();
  });
  return result;
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
