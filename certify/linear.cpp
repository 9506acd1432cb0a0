#include "certify/linear.hpp"

#include <fmt/format.h>

#include "corpus/format/case_io.hpp"
#include "report/parallel.hpp"
#include "report/progress.hpp"
#include "report/table.hpp"

namespace graze::tool {
namespace {

constexpr Request kJudged = Request::everything;
// What a caller gets by default, and what the time of a cast is about.
constexpr Request kTimed = Request::normal | Request::witnesses;
constexpr std::size_t kTimedCases = 24;  // a suite
constexpr int kTimedBatches = 5;
// Judged at a time, and then forgotten: a suite may have more cases than fit into memory.
constexpr std::size_t kBlock = 4096;
// Measured hits that are kept of a suite, for the study of tolerances.
constexpr std::size_t kKeptHits = 256;

// All methods on one case.
struct Judged {
  std::string id;
  std::vector<Judgement> judgements;  // by method
  std::vector<double> true_backward;  // by method; NaN where it was not measured
  std::unique_ptr<Truth> given;       // kept if it was made
  bool oracle_asked = false;
};

bool same_question(const corpus::Case& l, corpus::Case r) {
  r.expect = l.expect;
  return corpus::same_case(l, r);
}

Judged judge_case(const corpus::Case& problem, bool measure, const Settings& settings) {
  Judged judged;
  judged.id = problem.id;
  judged.given = std::make_unique<Truth>(problem);
  std::unique_ptr<Truth> rounded;  // the case as seen in float, if that is another
  for (const engine::EngineMethod* method : settings.methods) {
    const corpus::Case seen = method->seen(problem);
    Truth* truth = judged.given.get();
    if (!same_question(seen, problem)) {
      if (!rounded) rounded = std::make_unique<Truth>(seen);
      truth = rounded.get();
    }
    const engine::Guarantee* row = engine::find_guarantee(settings.guarantees, *method);
    const engine::Answer answer = method->cast(problem, {.request = kJudged});
    judged.judgements.push_back(judge_method(*truth, problem, *method, answer, row, measure));
    const bool against_given = measure && method->scalar != "double" && why_invalid(problem).empty() &&
                               !judged.judgements.back().not_asked;
    judged.true_backward.push_back(against_given ? errors_of(*judged.given, answer, Request::verdict).backward
                                                 : std::numeric_limits<double>::quiet_NaN());
  }
  judged.oracle_asked = judged.given->made() || (rounded && rounded->made());
  if (!judged.given->made()) judged.given.reset();
  return judged;
}

void time_suite(const Suite& suite, const Settings& settings, std::vector<Tally*>& tallies) {
  const std::size_t stride = std::max<std::size_t>(1, suite.size() / kTimedCases);
  for (std::size_t i = 0; i < suite.size(); i += stride) {
    const corpus::Case problem = suite.at(i);
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      const engine::EngineMethod& method = *settings.methods[m];
      if (method.is_exact() && !engine::is_exact_question(method.seen(problem))) continue;
      tallies[m]->ns.push_back(method.time_ns(problem, {.request = kTimed}, kTimedBatches));
    }
  }
}

// Every so many of a suite's measured cases may keep their truth.
std::size_t kept_every(const Suite& suite) {
  const std::size_t measured = (suite.size() + suite.oracle_every - 1) / suite.oracle_every;
  return (measured + kKeptHits - 1) / kKeptHits;
}

}  // namespace

Certification certify(const std::vector<Suite>& suites, const Settings& settings) {
  Certification result;
  for (const engine::EngineMethod* method : settings.methods) {
    for (const Suite& suite : suites) {
      result.tallies.push_back({.method = method->name, .scalar = method->scalar, .family = suite.family});
    }
  }
  for (std::size_t s = 0; s < suites.size(); ++s) {
    const Suite& suite = suites[s];
    std::vector<Tally*> tallies;
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      tallies.push_back(&result.tallies[m * suites.size() + s]);
    }
    const std::size_t kept = kept_every(suite);
    Progress progress("judging " + suite.family, suite.size());
    for (std::size_t first = 0; first < suite.size(); first += kBlock) {
      std::vector<Judged> judged(std::min(kBlock, suite.size() - first));
      for_each_index(judged.size(), settings.threads, [&](std::size_t i) {
        judged[i] = judge_case(suite.at(first + i), (first + i) % suite.oracle_every == 0, settings);
        progress.step();
      });
      for (std::size_t i = 0; i < judged.size(); ++i) {
        bool convicted = false;
        for (std::size_t m = 0; m < settings.methods.size(); ++m) {
          const Judgement& judgement = judged[i].judgements[m];
          tallies[m]->add(judged[i].id, judgement);
          tallies[m]->true_backward.push_back(judged[i].true_backward[m]);
          convicted = convicted || judgement.faulty() || judgement.stalled;
        }
        if (convicted) result.convicted.push_back(suite.at(first + i));
        result.oracle_cases += judged[i].oracle_asked ? 1 : 0;
        const bool measured = (first + i) % suite.oracle_every == 0;
        if (measured && (first + i) / suite.oracle_every % kept != 0) continue;
        if (judged[i].given && judged[i].given->exact().outcome() == Outcome::hit) {
          result.hits.push_back(std::move(judged[i].given));
        }
      }
    }
    time_suite(suite, settings, tallies);
  }
  for (std::size_t m = 0; m < settings.methods.size(); ++m) {
    const engine::Guarantee* row = engine::find_guarantee(settings.guarantees, *settings.methods[m]);
    const std::size_t before = result.breaches.size();
    for (std::size_t s = 0; s < suites.size(); ++s) {
      for (std::string& line : breaches(result.tallies[m * suites.size() + s], row)) {
        result.breaches.push_back(std::move(line));
      }
    }
    result.kept.push_back(result.breaches.size() == before);
  }
  return result;
}

std::string exact_summary(const Certification& certification, const Settings& settings) {
  std::string text;
  std::size_t casts = 0, failures = 0;
  for (const engine::EngineMethod* method : settings.methods) {
    if (!method->is_exact()) continue;
    std::size_t cases = 0, faults = 0, stalls = 0, not_asked = 0;
    for (const Tally& tally : certification.tallies) {
      if (tally.method != method->name || tally.scalar != method->scalar) continue;
      cases += tally.cases;
      faults += tally.wrong + tally.refused;
      stalls += tally.stalled;
      not_asked += tally.not_asked;
    }
    text +=
        fmt::format("{}: {} casts to the last bit, {} wrong, {} stalled; {} cases are not for the tier.\n",
                    method->full_name(), cases, faults, stalls, not_asked);
    casts += cases;
    failures += faults + stalls;
  }
  if (casts > 0 && failures == 0) {
    text +=
        fmt::format("None of {} failed: the rate of failures on such cases is below 3/n = {:.2g} at 95 %.\n",
                    casts, 3.0 / static_cast<double>(casts));
  }
  return text;
}

std::string guarantee_table(const Certification& certification, const Settings& settings) {
  Table table({{"method", Align::left},
               {"tier", Align::left},
               {"kappa\npolytopes"},
               {"kappa\nrounded"},
               {"kappa\ncontact"},
               {"stalls\nat most"},
               {"held", Align::left},
               {"mechanism", Align::left}});
  for (std::size_t m = 0; m < settings.methods.size(); ++m) {
    const engine::EngineMethod& method = *settings.methods[m];
    const engine::Guarantee* row = engine::find_guarantee(settings.guarantees, method);
    if (row == nullptr) {
      table.add_row({method.full_name(), method.tier, "-", "-", "-", "-", "no row", ""});
      continue;
    }
    table.add_row({method.full_name(), method.tier, fmt::to_string(row->kappa_polytope),
                   fmt::to_string(row->kappa_rounded),
                   row->kappa_contact ? fmt::to_string(*row->kappa_contact) : "-",
                   fmt::to_string(row->stall_cap), certification.kept[m] ? "yes" : "NO", row->mechanism});
  }
  return table.text();
}

}  // namespace graze::tool
