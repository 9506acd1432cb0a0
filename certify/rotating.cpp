#include "certify/rotating.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "corpus/format/case_io.hpp"
#include "report/parallel.hpp"
#include "report/progress.hpp"
#include "report/statistics.hpp"
#include "report/table.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using engine::RotatingEngineMethod;

// What a caller gets by default, and what the time of a cast is about; and the same with a proof, which may
// be found in another way.
constexpr Request kPlain = Request::normal | Request::witnesses;
constexpr std::array<Request, 2> kJudged = {kPlain, Request::everything};
constexpr std::size_t kTimedCases = 8;  // a suite
constexpr int kTimedBatches = 3;

// All methods on one case, each by both requests.
struct Judged {
  Case problem;
  std::vector<RotatingJudgement> judgements;  // by method
  std::vector<Counters> counters;
};

// Every fault, every excuse and the larger length of two answers to one question.
RotatingJudgement worse_of(RotatingJudgement first, const RotatingJudgement& second) {
  using J = RotatingJudgement;
  for (std::string J::*fault : {&J::wrong, &J::late, &J::early, &J::wide, &J::bad_contact, &J::undecided,
                                &J::unproved, &J::false_proof}) {
    if ((first.*fault).empty()) first.*fault = second.*fault;
  }
  for (bool J::*flag : {&J::stalled, &J::excused, &J::hidden, &J::open, &J::not_asked}) {
    first.*flag = first.*flag || second.*flag;
  }
  for (double J::*length : {&J::width, &J::passed, &J::normal, &J::witness}) {
    first.*length = std::fmax(first.*length, second.*length);
  }
  if (second.proof != ProofState::none) first.proof = second.proof;
  return first;
}

Judged judge_case(Case problem, const RotatingSettings& settings) {
  Judged judged;
  judged.problem = std::move(problem);
  std::map<std::string, TurningTruth> truths;  // by scalar: the case as seen in it
  for (const RotatingEngineMethod* method : settings.methods) {
    auto found = truths.find(method->scalar);
    if (found == truths.end()) {
      found = truths.emplace(method->scalar, TurningTruth(method->seen(judged.problem))).first;
    }
    TurningTruth& truth = found->second;
    const engine::Guarantee* row = engine::find_guarantee(settings.guarantees, *method);
    const RotatingLimits limits = limits_of(*method, row);
    std::array<RotatingJudgement, kJudged.size()> by_request;
    for (std::size_t r = 0; r < kJudged.size(); ++r) {
      const engine::RotatingAnswer answer = method->cast(judged.problem, {.request = kJudged[r]});
      by_request[r] = judge_rotating(truth, answer, limits, kJudged[r]);
      if (kJudged[r] == kPlain) judged.counters.push_back(answer.counters);
    }
    judged.judgements.push_back(worse_of(by_request[0], by_request[1]));
  }
  return judged;
}

void time_suite(const Suite& suite, const RotatingSettings& settings, std::span<RotatingTally*> tallies) {
  const std::size_t stride = std::max<std::size_t>(1, suite.size() / kTimedCases);
  for (std::size_t i = 0, timed = 0; i < suite.size() && timed < kTimedCases; i += stride, ++timed) {
    const Case problem = suite.at(i);
    if (!why_invalid(problem).empty()) continue;
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      tallies[m]->ns.push_back(settings.methods[m]->time_ns(problem, {.request = kPlain}, kTimedBatches));
    }
  }
}

std::string count_text(std::size_t count) { return count > 0 ? fmt::to_string(count) : "-"; }

std::string where_text(const RotatingTally::Worst& worst) {
  if (std::isnan(worst.length) || !worst.hardness) return "-";
  return fmt::to_string(*worst.hardness);
}

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

}  // namespace

void RotatingTally::Worst::take(double candidate, const Case& problem) {
  if (std::isnan(candidate) || candidate <= length) return;
  length = candidate;
  id = problem.id;
  hardness = problem.hardness;
}

void RotatingTally::add(const Case& problem, const RotatingJudgement& judgement, const Counters& counters) {
  if (judgement.not_asked) {
    ++not_asked;
    return;
  }
  ++cases;
  const auto count = [&](const std::string& fault, std::size_t& counter, Tally::Example& first) {
    if (!fault.empty() && counter++ == 0) first = {problem.id, fault};
  };
  count(judgement.wrong, wrong, first_wrong);
  count(judgement.late, late, first_late);
  count(judgement.early, early, first_early);
  count(judgement.wide, wide, first_wide);
  count(judgement.bad_contact, bad_contact, first_bad_contact);
  count(judgement.undecided, undecided, first_undecided);
  count(judgement.unproved, unproved, first_unproved);
  count(judgement.false_proof, refused, first_refused);
  if (judgement.stalled && stalled++ == 0) first_stalled = {problem.id, ""};
  excused += judgement.excused ? 1 : 0;
  hidden += judgement.hidden ? 1 : 0;
  open += judgement.open ? 1 : 0;
  accepted += judgement.proof == ProofState::accepted ? 1 : 0;
  width.take(judgement.width, problem);
  passed.take(judgement.passed, problem);
  normal.take(judgement.normal, problem);
  witness.take(judgement.witness, problem);
  supports.push_back(counters.supports);
}

std::vector<std::string> breaches(const RotatingTally& tally, const engine::Guarantee* row) {
  std::vector<std::string> lines;
  if (row == nullptr) return lines;
  const auto line = [&](std::size_t count, const std::string& what, const Tally::Example& first) {
    if (count == 0) return;
    lines.push_back(fmt::format("{}, {}: {} {} of {}; the first is {}{}{}", row->name(), tally.family, count,
                                what, tally.cases, first.id, first.reason.empty() ? "" : ": ", first.reason));
  };
  line(tally.wrong, "wrong", tally.first_wrong);
  line(tally.late, "late", tally.first_late);
  line(tally.early, "early", tally.first_early);
  line(tally.wide, "with too wide a bracket", tally.first_wide);
  line(tally.bad_contact, "with a normal or a witness off", tally.first_bad_contact);
  line(tally.undecided, "undecided beyond the width", tally.first_undecided);
  line(tally.unproved, "without its proof", tally.first_unproved);
  line(tally.refused, "with a false proof", tally.first_refused);
  if (static_cast<double>(tally.stalled) > row->stall_cap * static_cast<double>(tally.cases)) {
    line(tally.stalled, fmt::format("not converged, above the cap of {},", row->stall_cap),
         tally.first_stalled);
  }
  return lines;
}

RotatingCertification certify_rotating(const std::vector<Suite>& suites, const RotatingSettings& settings) {
  RotatingCertification result;
  for (const RotatingEngineMethod* method : settings.methods) {
    for (const Suite& suite : suites) result.tallies.push_back({.method = method, .family = suite.family});
  }
  for (std::size_t s = 0; s < suites.size(); ++s) {
    const Suite& suite = suites[s];
    std::vector<RotatingTally*> tallies;
    for (std::size_t m = 0; m < settings.methods.size(); ++m) {
      tallies.push_back(&result.tallies[m * suites.size() + s]);
    }
    std::vector<Judged> judged(suite.size());
    {
      Progress progress("judging rotating " + suite.family, suite.size());
      for_each_index(suite.size(), settings.threads, [&](std::size_t i) {
        judged[i] = judge_case(suite.at(i), settings);
        progress.step();
      });
    }
    for (Judged& one : judged) {
      bool convicted = false;
      for (std::size_t m = 0; m < settings.methods.size(); ++m) {
        tallies[m]->add(one.problem, one.judgements[m], one.counters[m]);
        convicted = convicted || one.judgements[m].faulty() || one.judgements[m].stalled;
      }
      if (convicted) result.convicted.push_back(std::move(one.problem));
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

std::string rotating_table(const RotatingCertification& certification) {
  Table table({{"method", Align::left},
               {"family", Align::left},
               {"cases"},
               {"not\nasked"},
               {"wrong"},
               {"late"},
               {"early"},
               {"wide"},
               {"contact\noff"},
               {"un-\ndecided"},
               {"not con-\nverged"},
               {"excused"},
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
               {"\nworst"},
               {"median\nns"}});
  const RotatingEngineMethod* last = nullptr;
  for (const RotatingTally& t : certification.tallies) {
    if (last != nullptr && last != t.method) table.add_gap();
    last = t.method;
    const double ns = median(t.ns);
    table.add_row({t.method->full_name(),
                   t.family,
                   fmt::to_string(t.cases),
                   count_text(t.not_asked),
                   fmt::to_string(t.wrong),
                   fmt::to_string(t.late),
                   fmt::to_string(t.early),
                   fmt::to_string(t.wide),
                   fmt::to_string(t.bad_contact),
                   fmt::to_string(t.undecided),
                   fmt::to_string(t.stalled),
                   fmt::to_string(t.excused),
                   count_text(t.hidden),
                   count_text(t.open),
                   fmt::to_string(t.accepted),
                   fmt::to_string(t.refused),
                   short_number(t.width.length),
                   where_text(t.width),
                   short_number(t.passed.length),
                   where_text(t.passed),
                   short_number(t.normal.length),
                   short_number(t.witness.length),
                   t.supports.empty() ? "-" : fmt::format("{:.0f}", median(t.supports)),
                   t.supports.empty() ? "-" : fmt::format("{:.0f}", worst(t.supports)),
                   std::isnan(ns) ? "-" : fmt::format("{:.0f}", ns)});
  }
  return table.text();
}

std::string rotating_guarantee_table(const RotatingCertification& certification,
                                     const RotatingSettings& settings) {
  Table table({{"method", Align::left},
               {"tier", Align::left},
               {"kappa\npolytopes"},
               {"kappa\nrounded"},
               {"may\nmiss", Align::left},
               {"may be\nlate", Align::left},
               {"width\nat most"},
               {"stalls\nat most"},
               {"held", Align::left},
               {"worst width", Align::left},
               {"deepest passed", Align::left},
               {"mechanism", Align::left}});
  for (std::size_t m = 0; m < settings.methods.size(); ++m) {
    const RotatingEngineMethod& method = *settings.methods[m];
    RotatingTally::Worst width, passed;
    for (const RotatingTally& tally : certification.tallies) {
      if (tally.method != &method) continue;
      if (!(tally.width.length <= width.length)) width = std::isnan(tally.width.length) ? width : tally.width;
      if (!(tally.passed.length <= passed.length))
        passed = std::isnan(tally.passed.length) ? passed : tally.passed;
    }
    const auto worst_text = [](const RotatingTally::Worst& worst) {
      return std::isnan(worst.length) ? "-" : fmt::format("{} {}", short_number(worst.length), worst.id);
    };
    const engine::Guarantee* row = engine::find_guarantee(settings.guarantees, method);
    if (row == nullptr) {
      table.add_row({method.full_name(), method.tier, "-", "-", "-", "-", "-", "-", "no row",
                     worst_text(width), worst_text(passed), ""});
      continue;
    }
    table.add_row({method.full_name(), method.tier, fmt::to_string(row->kappa_polytope),
                   fmt::to_string(row->kappa_rounded), unseen_text(row->may_miss),
                   unseen_text(row->may_be_late), row->width ? fmt::to_string(*row->width) : "-",
                   fmt::to_string(row->stall_cap), certification.kept[m] ? "yes" : "NO", worst_text(width),
                   worst_text(passed), row->mechanism});
  }
  return table.text();
}

}  // namespace graze::tool
