#include "certify/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "corpus/format/case_io.hpp"
#include "properties/judge/judge.hpp"
#include "properties/judge/limits.hpp"
#include "report/parallel.hpp"
#include "report/progress.hpp"
#include "report/statistics.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using law::Judgement;
using law::Truth;

bool is_contact(Outcome outcome) {
  return outcome == Outcome::hit || outcome == Outcome::initially_overlapping;
}

// Of the first kind that there is.
std::string first_of(std::initializer_list<const std::string*> faults) {
  for (const std::string* fault : faults) {
    if (!fault->empty()) return *fault;
  }
  return {};
}

// The case as each scalar sees it, and what is true of it. Where rounding changes nothing, all share one.
class Truths {
 public:
  explicit Truths(const Case& problem) : problem_(problem) {}

  Truth& of(const std::string& scalar, const Case& seen) {
    std::shared_ptr<Truth>& truth = by_scalar_[scalar];
    if (truth) return *truth;
    const bool unchanged = corpus::same_case(seen, problem_);
    truth = unchanged && given_ ? given_ : std::make_shared<Truth>(seen);
    if (unchanged) given_ = truth;
    return *truth;
  }

 private:
  const Case& problem_;
  std::shared_ptr<Truth> given_;
  std::map<std::string, std::shared_ptr<Truth>> by_scalar_;
};

Measured begun(const Case& problem, const Judgement& judgement) {
  return {.rounded = engine::is_rounded(problem),
          .asked = !judgement.not_asked,
          .stalled = judgement.stalled,
          .late = !judgement.late.empty(),
          .fault = first_of({&judgement.wrong, &judgement.late, &judgement.early, &judgement.off})};
}

// A start in contact that is called a hit, or a hit called a start, is judged by the time.
Measured measure_linear(const Case& problem, const engine::Method& method, Truth& truth) {
  const engine::Answer answer = method.ask(problem, {.request = Request::everything});
  const Judgement judgement = judge(truth, method, answer, Request::everything, true);
  Measured measured = begun(problem, judgement);
  if (!judgement.by_oracle || answer.outcome == Outcome::not_converged) return measured;
  measured.backward = judgement.errors.backward;
  measured.forward = judgement.errors.forward;
  const oracle::CaseTruth& exact = truth.cast();
  if (answer.outcome == Outcome::miss && is_contact(exact.outcome())) {
    measured.denied = law::over(exact.depth().high, exact.scale().high);
  } else if (is_contact(answer.outcome) && exact.outcome() == Outcome::miss) {
    measured.denied = law::over(exact.clearance().high, exact.scale().high);
  }
  measured.wrong = !std::isnan(measured.denied);
  return measured;
}

// By how much a time is off at least: its distance from the bracket of the first contact, at the speed of the
// fastest points of the two bodies.
double forward_error(const oracle::RotatingTruth& truth, double time, double speed) {
  const double off = std::max({truth.toi_lower() - time, time - truth.toi_upper(), 0.0});
  return law::over(off * speed, truth.scale().high);
}

Measured measure_rotating(const Case& problem, const engine::Method& method, Truth& truth) {
  // What a caller gets by default; a normal and witnesses are judged elsewhere.
  const engine::Answer answer = method.answer(problem);
  const Judgement judgement = judge(truth, method, answer, Request::verdict, true);
  Measured measured = begun(truth.problem(), judgement);
  if (judgement.not_asked || answer.outcome == Outcome::not_converged ||
      answer.outcome == Outcome::invalid_input || !std::isfinite(truth.problem().t_max)) {
    return measured;
  }
  const oracle::RotatingTruth& bracket = truth.bracket();
  if (answer.outcome == Outcome::miss) {
    if (is_contact(bracket.outcome())) measured.denied = judgement.errors.passed;
  } else if (bracket.outcome() == Outcome::miss) {
    measured.denied = law::over(bracket.clearance().low, bracket.scale().high);
  } else if (is_contact(bracket.outcome())) {
    const double speed = law::top_speed_of(truth.problem());
    measured.forward = std::fmax(forward_error(bracket, answer.toi_lower, speed),
                                 forward_error(bracket, answer.toi_upper, speed));
  }
  measured.backward =
      std::fmax(std::fmax(judgement.errors.backward, judgement.errors.passed), measured.denied);
  measured.wrong = !std::isnan(measured.denied);
  return measured;
}

std::vector<Measured> measure_all(const Case& problem, const std::vector<const engine::Method*>& methods) {
  Truths truths(problem);
  std::vector<Measured> all;
  for (const engine::Method* method : methods) {
    Truth& truth = truths.of(method->scalar, method->seen(problem));
    all.push_back(method->kind == engine::Kind::rotating ? measure_rotating(problem, *method, truth)
                                                         : measure_linear(problem, *method, truth));
  }
  return all;
}

// The curves of one method, polytopes and round, before any case.
void add_curves(std::vector<Curve>& curves, const engine::Method& method, const corpus::Family& family) {
  for (const bool rounded : {false, true}) {
    Curve curve{.method = method.full_name(),
                .tier = method.tier,
                .unit_roundoff = method.unit_roundoff,
                .family = std::string(family.name),
                .rotating = family.rotating,
                .rounded = rounded};
    if (method.guarantee != nullptr) curve.row = *method.guarantee;
    for (const double level : family.levels) curve.levels.push_back({.hardness = level});
    curves.push_back(std::move(curve));
  }
}

}  // namespace

FamilyStability measure_family(const corpus::Family& family, const StabilitySettings& settings) {
  const engine::Kind kind = family.rotating ? engine::Kind::rotating : engine::Kind::linear;
  const std::size_t count = family.rotating ? settings.rotating_count : settings.count;
  std::vector<const engine::Method*> methods = settings.methods;
  std::erase_if(methods, [&](const engine::Method* method) { return method->kind != kind; });
  FamilyStability result{.family = std::string(family.name),
                         .hardness_meaning = std::string(family.hardness_meaning),
                         .cases = family.levels.size() * count};
  for (const engine::Method* method : methods) add_curves(result.curves, *method, family);
  const auto drawn = [&](std::size_t i) {
    return family.generate(family.levels[i / count], settings.seed + i % count);
  };
  std::vector<std::vector<Measured>> measured(result.cases);
  {
    Progress progress("stability, " + result.family, result.cases);
    for_each_index(result.cases, settings.threads, [&](std::size_t i) {
      measured[i] = measure_all(drawn(i), methods);
      progress.step();
    });
  }
  for (std::size_t i = 0; i < result.cases; ++i) {
    bool convicted = false;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const Measured& one = measured[i][m];
      Curve& curve = result.curves[2 * m + (one.rounded ? 1 : 0)];
      curve.levels[i / count].add(one);
      convicted = convicted || !one.fault.empty() || one.stalled;
      if (curve.first_fault.empty() && !one.fault.empty()) {
        curve.first_fault = fmt::format("{}: {}", drawn(i).id, one.fault);
      }
    }
    if (convicted) result.convicted.push_back(drawn(i));
  }
  std::erase_if(result.curves, [](const Curve& curve) { return curve.total().cases == 0; });
  return result;
}

void LevelErrors::add(const Measured& measured) {
  if (!measured.asked) return;
  ++cases;
  wrong += measured.wrong ? 1 : 0;
  stalled += measured.stalled ? 1 : 0;
  late += measured.late ? 1 : 0;
  faulty += measured.fault.empty() ? 0 : 1;
  if (!std::isnan(measured.backward)) backward.push_back(measured.backward);
  if (!std::isnan(measured.forward)) forward.push_back(measured.forward);
  denied = std::fmax(denied, measured.denied);
}

void LevelErrors::add(const LevelErrors& other) {
  cases += other.cases;
  wrong += other.wrong;
  stalled += other.stalled;
  late += other.late;
  faulty += other.faulty;
  backward.insert(backward.end(), other.backward.begin(), other.backward.end());
  forward.insert(forward.end(), other.forward.begin(), other.forward.end());
  denied = std::fmax(denied, other.denied);
}

LevelErrors Curve::total() const {
  LevelErrors sum;
  for (const LevelErrors& level : levels) sum.add(level);
  return sum;
}

const LevelErrors* Curve::hardest() const {
  const LevelErrors* hardest = nullptr;
  double most = -1;
  for (const LevelErrors& level : levels) {
    const double error = worst(level.backward);
    if (!(error > most)) continue;
    most = error;
    hardest = &level;
  }
  return hardest;
}

bool Curve::claims_stability() const {
  return row && row->may_miss == engine::Unseen::nothing && row->may_be_late == engine::Unseen::nothing;
}

bool Curve::holds() const {
  if (!row) return true;
  const LevelErrors sum = total();
  return sum.faulty == 0 &&
         static_cast<double>(sum.stalled) <= std::ceil(row->stall_cap * static_cast<double>(sum.cases));
}

std::vector<Curve> merged(const std::vector<Curve>& curves) {
  std::vector<Curve> result;
  for (const Curve& curve : curves) {
    const bool more =
        !result.empty() && result.back().method == curve.method && result.back().family == curve.family;
    if (!more) {
      result.push_back(curve);
      continue;
    }
    for (std::size_t l = 0; l < curve.levels.size(); ++l) result.back().levels[l].add(curve.levels[l]);
  }
  return result;
}

}  // namespace graze::tool
