#include "certify/certification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>

#include "corpus/format/case_io.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/judge.hpp"
#include "reports/text/progress.hpp"
#include "scene/src/parallel.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using engine::Kind;
using engine::Method;
using law::Judgement;

constexpr std::array<Request, 1> kEverything = {Request::everything}, kWithoutProof = {engine::kPlain};
constexpr std::array<Request, 2> kBoth = {engine::kPlain, Request::everything};

// Judged at a time, and then forgotten: a suite may have more cases than fit into memory.
std::size_t block_of(Kind kind) { return kind == Kind::linear ? 1024 : 64; }
// The number of cases per suite whose casts are timed, and the number of batches for each.
constexpr std::size_t kTimedLinear = 24, kTimedRotating = 8;
constexpr int kBatchesLinear = 5, kBatchesRotating = 3;
// The processor time of a case of this kind, relative to a linear cast. The estimate of the time left uses
// it.
std::uint64_t cost_of(Kind kind) { return kind == Kind::linear ? 1 : kind == Kind::query ? 12 : 60; }

// One method's answers to one case.
struct Judged {
  std::optional<Case> asked = {};  // empty if it is not a question for the method
  Judgement judgement = {};
  double true_backward = std::numeric_limits<double>::quiet_NaN();
  bool beyond_limits = false;  // the case exceeds a documented limit of a third-party engine
};
struct JudgedCase {
  Case problem;
  std::vector<Judged> by_method = {};
  bool oracle_made = false;
};

// An unsupported case is refused correctly. A refusal is not an answer.
bool is_refusal(const Judgement& judgement) {
  return judgement.outcome == Outcome::invalid_input && !judgement.faulty();
}

// The reason why a case is not a question for a method.
std::string why_unasked(const Method& method, const Case& asked) {
  if (std::string why = law::why_invalid(asked); !why.empty()) return "it has " + why;
  if (!method.is_ours()) return method.refuses(asked);
  if (method.is_exact() && !engine::is_exact_question(method.seen(asked)))
    return "tier exact answers no ellipsoids, cylinders or cones";
  return {};
}

// Every fault, every excuse and the larger length of two answers to one question.
Judgement worse_of(Judgement first, const Judgement& second) {
  using J = Judgement;
  for (const law::FaultKind& kind : law::kFaultKinds) {
    if ((first.*kind.why).empty()) first.*kind.why = second.*kind.why;
  }
  if (first.undecided.empty()) first.undecided = second.undecided;
  for (bool J::*flag :
       {&J::stalled, &J::within_tolerance, &J::hidden, &J::open, &J::by_oracle, &J::skipped}) {
    first.*flag = first.*flag || second.*flag;
  }
  using E = law::Errors;
  for (double E::*length : {&E::forward, &E::backward, &E::normal, &E::witness, &E::passed, &E::over_limit}) {
    first.errors.*length = std::fmax(first.errors.*length, second.errors.*length);
  }
  if (second.proof != law::ProofState::none) first.proof = second.proof;
  return first;
}

bool same_question(const Case& one, Case other) {
  other.expect = one.expect;
  return corpus::same_case(one, other);
}

// The truth about the case as it is seen: one that there is, or a new one.
law::Truth& truth_of(std::vector<std::unique_ptr<law::Truth>>& truths, Case seen) {
  for (const std::unique_ptr<law::Truth>& truth : truths) {
    if (same_question(truth->problem(), seen)) return *truth;
  }
  return *truths.emplace_back(std::make_unique<law::Truth>(std::move(seen)));
}

Judged judge_one(const Method& method, const Case& asked, std::vector<std::unique_ptr<law::Truth>>& truths,
                 bool measure) {
  Judged judged;
  engine::EngineView own;
  if (method.is_ours()) {
    own.seen = method.seen(asked);
    own.ask = [&](const engine::Ask& how) { return method.ask(asked, how); };
  } else if (law::in_domain(asked)) {
    own = method.engine_view(asked);
  } else {
    own.refused = "it is no case";
  }
  if (!own.refused.empty()) {
    judged.asked = asked;
    judged.judgement.skipped = true;
    return judged;
  }
  judged.beyond_limits = own.beyond_limits;
  const Case& seen = own.seen;
  // The scalar has made it another question.
  if (method.kind == Kind::query && !law::in_domain(seen)) return judged;
  judged.asked = asked;
  law::Truth& truth = truth_of(truths, seen);
  bool is_first = true;
  const std::span<const Request> requests = method.is_ours() ? requests_of(method.kind) : kWithoutProof;
  for (const Request request : requests) {
    const engine::Answer answer = own.ask({.request = request});
    Judgement judgement = law::judge(truth, method, answer, request, measure);
    judgement.skipped = judgement.skipped || is_refusal(judgement);
    judged.judgement = is_first ? std::move(judgement) : worse_of(std::move(judged.judgement), judgement);
    is_first = false;
    if (method.kind != Kind::linear || !(measure || !method.is_ours()) || !method.in_float() ||
        judged.judgement.skipped || !judged.judgement.failed.empty()) {
      continue;
    }
    if (law::in_domain(asked)) {
      judged.true_backward = law::errors_of(truth_of(truths, asked), answer, Request::verdict).backward;
    }
  }
  // The guarantee of work is about an answer without a proof, which a linear cast was not asked for so far.
  if (method.is_ours() && method.kind == Kind::linear)
    law::judge_work(judged.judgement, method, asked, own.ask({.request = engine::kPlain}).counters);
  return judged;
}

JudgedCase judge_case(const Suite& suite, std::size_t i, std::span<const Method* const> methods) {
  JudgedCase all{.problem = suite.at(i)};
  const bool measure = suite.kind != Kind::linear || i % suite.oracle_every == 0;
  std::vector<std::unique_ptr<law::Truth>> truths;
  for (const Method* method : methods) {
    const std::optional<Case> asked = question_for(suite, i, all.problem, *method);
    all.by_method.push_back(asked ? judge_one(*method, *asked, truths, measure) : Judged{});
  }
  for (const std::unique_ptr<law::Truth>& truth : truths) {
    if (!truth->has_cast()) continue;
    all.oracle_made = true;
  }
  return all;
}

void time_suite(const Suite& suite, std::span<Tally* const> tallies) {
  const bool turning = suite.kind == Kind::rotating;
  const std::size_t most = turning ? kTimedRotating : kTimedLinear;
  const std::size_t stride = std::max<std::size_t>(1, suite.size() / most);
  for (std::size_t i = 0, timed = 0; i < suite.size() && timed < most; i += stride, ++timed) {
    const Case problem = suite.at(i);
    if (!law::in_domain(problem)) continue;
    for (Tally* tally : tallies) {
      const Method& method = *tally->method;
      if (method.time_ns == nullptr) continue;
      if (method.is_exact() && !engine::is_exact_question(method.seen(problem))) continue;
      tally->ns.push_back(
          method.time_ns(problem, {.request = engine::kPlain}, turning ? kBatchesRotating : kBatchesLinear));
    }
  }
}

// One run, suite by suite.
class CertificationRun {
 public:
  CertificationRun(const std::vector<Suite>& suites, const Settings& settings)
      : settings_(settings), progress_("certify", total_cost(suites), 0, Progress::Show::percent) {
    for (const Method* method : settings.methods) {
      for (const Suite& suite : suites) {
        if (suite.kind == method->kind)
          result_.tallies.push_back({.method = method, .family = suite.family, .is_drawn = suite.drawn > 0});
      }
      if (!method->is_ours())
        result_.beyond_limits.push_back({.method = method, .family = "beyond its documented limits"});
    }
  }

  Certification operator()(const std::vector<Suite>& suites) {
    std::array<std::size_t, 3> nth = {};  // suites of a kind so far
    for (const Suite& suite : suites) {
      judge_suite(suite, nth[static_cast<std::size_t>(suite.kind)]++);
    }
    for (const Tally& tally : result_.tallies) {
      for (std::string& line : breaches(tally)) result_.breaches.push_back(std::move(line));
    }
    for (const Method* method : settings_.methods) {
      std::string line = declines(result_.total(*method));
      if (line.empty()) continue;
      if (!settings_.allow_declined)
        result_.breaches.push_back(
            fmt::format("{}, above {:g} %; --allow-declined accepts that", line, 100 * kMostDeclined));
      result_.declined.push_back(std::move(line));
    }
    return std::move(result_);
  }

 private:
  static std::uint64_t total_cost(const std::vector<Suite>& suites) {
    return std::accumulate(suites.begin(), suites.end(), std::uint64_t{0}, [](auto sum, const Suite& suite) {
      return sum + cost_of(suite.kind) * suite.size();
    });
  }

  // The tallies of a suite, the nth of its kind, by method.
  std::vector<Tally*> tallies_of(Kind kind, std::size_t nth) {
    std::vector<Tally*> found;
    const Method* last = nullptr;
    std::size_t i = 0;
    for (Tally& tally : result_.tallies) {
      if (tally.method->kind != kind) continue;
      i = tally.method == last ? i + 1 : 0;
      last = tally.method;
      if (i == nth) found.push_back(&tally);
    }
    return found;
  }

  Tally& beyond_limits_of(const Method& method) {
    return *std::find_if(result_.beyond_limits.begin(), result_.beyond_limits.end(),
                         [&](const Tally& tally) { return tally.method == &method; });
  }

  [[nodiscard]] bool stops() const { return settings_.stop() || (settings_.fail_fast && failed_); }

  void judge_suite(const Suite& suite, std::size_t nth) {
    const std::vector<Tally*> tallies = tallies_of(suite.kind, nth);
    if (tallies.empty()) return;
    std::vector<const Method*> methods;
    methods.reserve(tallies.size());
    for (const Tally* tally : tallies) methods.push_back(tally->method);
    const std::size_t block = block_of(suite.kind);
    for (std::size_t first = 0; first < suite.size() && !stops(); first += block) {
      std::vector<JudgedCase> judged(std::min(block, suite.size() - first));
      scene::for_each_index(judged.size(), settings_.threads, [&](std::size_t i) {
        if (settings_.stop()) return;
        const bool left_out = settings_.leaves_out && settings_.leaves_out(suite, first + i);
        if (!left_out) judged[i] = judge_case(suite, first + i, methods);
        progress_.advance(cost_of(suite.kind), suite.family);
      });
      for (std::size_t i = 0; i < judged.size(); ++i) count(suite, first + i, judged[i], tallies);
    }
    if (stops()) {
      result_.unfinished.push_back(suite.family);
      return;
    }
    if (suite.kind != Kind::query && settings_.times_casts) time_suite(suite, tallies);
  }

  void count(const Suite& suite, std::size_t i, JudgedCase& one, std::span<Tally* const> tallies) {
    if (one.by_method.empty()) return;  // left out, or by a stop
    bool convicted = false, asked = false, answered = false;
    for (std::size_t m = 0; m < tallies.size(); ++m) {
      const Judged& judged = one.by_method[m];
      if (!judged.asked) continue;
      asked = true;
      Tally& tally = judged.beyond_limits ? beyond_limits_of(*tallies[m]->method) : *tallies[m];
      // A finding of a third-party engine shows the case as that engine was asked it.
      tally.add(tally.method->is_ours() ? one.problem : *judged.asked, judged.judgement);
      if (settings_.judged) settings_.judged(suite, i, *tally.method, judged.judgement);
      tally.true_backward.push_back(judged.true_backward);
      if (judged.judgement.skipped && judged.judgement.wrong.empty()) {
        note_unasked(*tallies[m]->method, *judged.asked);
        continue;
      }
      answered = true;
      result_.answers += tallies[m]->method->is_ours() ? requests_of(tallies[m]->method->kind).size() : 1;
      failed_ = failed_ || (judged.judgement.faulty() && !judged.beyond_limits);
      if (!judged.judgement.faulty() && !judged.judgement.stalled) continue;
      const bool is_query = tallies[m]->method->kind == Kind::query;
      if (is_query || !convicted) result_.convicted.push_back(*judged.asked);
      convicted = true;
    }
    result_.questions += asked ? 1 : 0;
    result_.answered += answered ? 1 : 0;
    result_.oracle_cases += one.oracle_made ? 1 : 0;
  }

  void note_unasked(const Method& method, const Case& asked) {
    if (!result_.unasked.empty()) return;
    if (const std::string why = why_unasked(method, asked); !why.empty())
      result_.unasked = fmt::format("{} of {}: {}", method.question_name(), asked.id, why);
  }

  const Settings& settings_;
  Progress progress_;
  Certification result_;
  bool failed_ = false;  // some answer is at fault
};

}  // namespace

std::span<const Request> requests_of(Kind kind) {
  if (kind == Kind::query) return kWithoutProof;
  return kind == Kind::linear ? std::span<const Request>(kEverything) : kBoth;
}

bool Certification::has_kept(const Method& method) const {
  return std::none_of(tallies.begin(), tallies.end(), [&](const Tally& tally) {
    return tally.method == &method && !tool::breaches(tally).empty();
  });
}

Tally Certification::total(const Method& method) const {
  Tally sum{.method = &method, .family = "all"};
  for (const Tally& tally : tallies) {
    if (tally.method == &method) sum.add(tally);
  }
  return sum;
}

Certification certify(const std::vector<Suite>& suites, const Settings& settings) {
  return CertificationRun(suites, settings)(suites);
}

}  // namespace graze::tool
