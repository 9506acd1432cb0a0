#include "certify/engine_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <tuple>

#include "corpus/format/case_io.hpp"
#include "properties/edit/case.hpp"
#include "properties/edit/solid.hpp"
#include "properties/generate/shrink.hpp"
#include "properties/judge/judge.hpp"
#include "reports/text/outputs.hpp"
#include "reports/text/progress.hpp"

namespace graze::tool {

using corpus::Case;
using engine::Method;
using law::Judgement;

namespace {

using Clock = std::chrono::steady_clock;

// The judgement of the answer to a case. Nothing if the case is not a question for the method.
std::optional<Judgement> judged(const Method& method, const Case& problem) {
  if (!law::in_domain(problem) || engine::turns(problem) != (method.kind == engine::Kind::rotating))
    return {};
  engine::EngineView own = method.engine_view(problem);
  // A finding within the documented limits stays within them.
  if (!own.refused.empty() || own.beyond_limits) return {};
  law::Truth truth(std::move(own.seen));
  const engine::Answer answer = own.ask({.request = engine::kPlain});
  try {
    return law::judge(truth, method, answer, engine::kPlain, true);
  } catch (const std::invalid_argument&) {  // no oracle takes the case
    return {};
  }
}

// A kind of fault. For answers that failed, it includes the kind of failure.
struct DetailedFault {
  std::size_t kind = 0;  // index into law::kFaultKinds
  engine::Failure failure = engine::Failure::none;
  auto operator<=>(const DetailedFault&) const = default;
};

std::string name_of(const DetailedFault& fault) {
  const std::string name = law::kFaultKinds[fault.kind].name;
  return fault.failure == engine::Failure::none ? name : fmt::format("{}: {}", name, to_text(fault.failure));
}

// The reason for which an answer has this fault, or nothing.
std::string why_of(const DetailedFault& fault, const Judgement& judgement) {
  return judgement.failure == fault.failure ? judgement.*law::kFaultKinds[fault.kind].why : "";
}

// For each method and fault, the family in which it is most frequent.
struct Met {
  const Tally* tally = nullptr;
  const Tally::Example* first = nullptr;
  std::size_t times = 0;
};
using AllMet = std::map<std::pair<const Method*, DetailedFault>, Met>;

void note(AllMet& met, const Tally& tally, const DetailedFault& fault, std::size_t times,
          const Tally::Example& first) {
  Met& most = met[{tally.method, fault}];
  if (times > most.times) most = {.tally = &tally, .first = &first, .times = times};
}

AllMet all_met(const Certification& certification) {
  AllMet met;
  for (const Tally& tally : certification.tallies) {
    if (tally.method->is_ours()) continue;
    for (std::size_t k = 0; k < law::kFaults; ++k) {
      if (law::kFaultKinds[k].why == &Judgement::failed) {
        for (std::size_t f = 1; f < engine::kFailures; ++f) {
          const Tally::Failed& failed = tally.failures[f];
          if (failed.count > 0)
            note(met, tally, {k, static_cast<engine::Failure>(f)}, failed.count, failed.first);
        }
      } else if (tally.faults[k] > 0) {
        note(met, tally, {.kind = k}, tally.faults[k], tally.first[k]);
      }
    }
  }
  return met;
}

void make_small(EngineFinding& finding, const DetailedFault& fault, int budget, double seconds) {
  const auto stop = Clock::now() + std::chrono::duration<double>(seconds);
  const auto why = [&](const Case& problem) -> std::string {
    const std::optional<Judgement> judgement = judged(*finding.method, problem);
    return judgement ? why_of(fault, *judgement) : "";
  };
  // A body with an inside keeps one. A finding between solids is thus shown between solids.
  const bool solid_a = law::is_solid(finding.problem.a.shape),
             solid_b = law::is_solid(finding.problem.b.shape);
  const auto keeps_solids = [&](const Case& c) {
    return (!solid_a || law::is_solid(c.a.shape)) && (!solid_b || law::is_solid(c.b.shape));
  };
  finding.problem = law::minimised(
      finding.problem,
      [&](const Case& c) { return Clock::now() < stop && keeps_solids(c) && !why(c).empty(); }, budget);
  if (std::string reason = why(finding.problem); !reason.empty()) finding.reason = std::move(reason);
}

std::string file_name(const EngineFinding& finding) {
  std::string name = fmt::format("{}-{}", finding.method->question_name(), finding.fault);
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '.' && c != '_'; }, '-');
  return name;
}

}  // namespace

std::vector<EngineFinding> engine_findings(const Certification& certification, int budget, double seconds) {
  const AllMet met = all_met(certification);
  std::vector<EngineFinding> findings;
  Progress progress("making findings small", met.size());
  for (const auto& [key, most] : met) {
    const auto& [method, fault] = key;
    EngineFinding& finding = findings.emplace_back(EngineFinding{.method = method,
                                                                 .fault = name_of(fault),
                                                                 .reason = most.first->reason,
                                                                 .family = most.tally->family,
                                                                 .first = most.first->id,
                                                                 .times = most.times,
                                                                 .problem = most.first->problem});
    make_small(finding, fault, budget, seconds);
    progress.step();
  }
  return findings;
}

std::string save_findings(const std::vector<EngineFinding>& findings,
                          const std::filesystem::path& directory) {
  require_folder(directory.string());
  std::string text;
  for (const EngineFinding& finding : findings) {
    Case problem = finding.problem;
    const std::string name = file_name(finding);
    problem.id = "finding/" + name;
    problem.family = finding.family;
    problem.hardness.reset();
    problem.comment = finding.reason;
    problem.source = finding.first;
    problem.expect.reset();
    const std::filesystem::path path = directory / (name + ".json");
    OutputFile file(path.string());
    std::string lines = corpus::write_case_pretty(problem);
    while (!lines.empty() && lines.back() == '\n') lines.pop_back();
    file.write_line(lines);
    file.close();
    text +=
        fmt::format("{}: {} {}, {} of its family {}: {}\n", path.string(), finding.method->question_name(),
                    finding.fault, finding.times, finding.family, finding.reason);
  }
  return text;
}

}  // namespace graze::tool
