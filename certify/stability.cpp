#include "certify/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "certify/suites.hpp"
#include "corpus/format/case_io.hpp"
#include "properties/edit/case.hpp"
#include "properties/judge/judge.hpp"
#include "properties/judge/limits.hpp"
#include "reports/text/progress.hpp"
#include "reports/text/statistics.hpp"
#include "scene/src/parallel.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using law::Judgement;
using law::Truth;

bool is_contact(Outcome outcome) {
  return outcome == Outcome::hit || outcome == Outcome::initially_overlapping;
}

// The first fault that is not empty.
std::string first_of(std::initializer_list<const std::string*> faults) {
  for (const std::string* fault : faults) {
    if (!fault->empty()) return *fault;
  }
  return {};
}

// The case as each method sees it, and what is true of it. Those that see the same share one.
class Truths {
 public:
  Truth& of(Case seen) {
    for (const std::unique_ptr<Truth>& truth : all_) {
      if (corpus::same_case(truth->problem(), seen)) return *truth;
    }
    return *all_.emplace_back(std::make_unique<Truth>(std::move(seen)));
  }

 private:
  std::vector<std::unique_ptr<Truth>> all_;
};

Measured begun(const Case& problem, const Judgement& judgement) {
  return {.rounded = engine::is_rounded(problem),
          .asked = !judgement.skipped,
          .stalled = judgement.stalled,
          .late = !judgement.late.empty(),
          .failed = !judgement.failed.empty(),
          .fault = first_of(
              {&judgement.failed, &judgement.wrong, &judgement.late, &judgement.early, &judgement.off})};
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
  // The answer that a caller gets by default. A normal and witnesses are judged elsewhere.
  const engine::Answer answer = method.answer(problem);
  const Judgement judgement = judge(truth, method, answer, Request::verdict, true);
  Measured measured = begun(truth.problem(), judgement);
  if (judgement.skipped || answer.outcome == Outcome::not_converged ||
      answer.outcome == Outcome::invalid_input || !std::isfinite(truth.problem().t_max)) {
    return measured;
  }
  const oracle::RotatingTruth& bracket = truth.bracket();
  if (answer.outcome == Outcome::miss) {
    if (is_contact(bracket.outcome())) measured.denied = judgement.errors.passed;
  } else if (bracket.outcome() == Outcome::miss) {
    measured.denied = law::over(bracket.clearance().low, bracket.scale().high);
  } else if (is_contact(bracket.outcome()) && method.holds.time) {
    const double speed = law::top_speed_of(truth.problem());
    measured.forward = std::fmax(forward_error(bracket, answer.toi_lower, speed),
                                 forward_error(bracket, answer.toi_upper, speed));
  }
  measured.backward =
      std::fmax(std::fmax(judgement.errors.backward, judgement.errors.passed), measured.denied);
  measured.wrong = !std::isnan(measured.denied);
  return measured;
}

// True if the case is not a question for a third-party engine.
bool is_refused(const Case& problem, const engine::Method& method) {
  return !method.is_ours() && (!law::in_domain(problem) || !method.refuses(problem).empty());
}

std::vector<Measured> measure_all(const Case& problem, const std::vector<const engine::Method*>& methods) {
  Truths truths;
  std::vector<Measured> all;
  for (const engine::Method* method : methods) {
    if (is_refused(problem, *method)) {
      Measured& none = all.emplace_back();
      none.rounded = engine::is_rounded(problem);
      none.asked = false;
      continue;
    }
    Truth& truth = truths.of(method->seen(problem));
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

// A case of the family.
struct Place {
  std::size_t level = 0;
  std::uint64_t seed = 0;
};

// `count` cases of each level, from the first seed on. If only third-party engines are asked, the cases are those that
// one of them takes, found in at most kSoughtSeeds times as many seeds.
std::vector<Place> places_of(const corpus::Family& family, const std::vector<const engine::Method*>& methods,
                             std::size_t count, std::uint64_t seed) {
  const bool has_ours = std::any_of(methods.begin(), methods.end(),
                                    [](const engine::Method* method) { return method->is_ours(); });
  const auto is_question = [&](const Case& problem) {
    return std::any_of(methods.begin(), methods.end(),
                       [&](const engine::Method* method) { return !is_refused(problem, *method); });
  };
  std::vector<Place> places;
  for (std::size_t level = 0; level < family.levels.size(); ++level) {
    std::size_t taken = 0;
    for (std::size_t k = 0; taken < count && k < kSoughtSeeds * count; ++k) {
      if (!has_ours && !is_question(family.generate(family.levels[level], seed + k))) continue;
      places.push_back({.level = level, .seed = seed + k});
      ++taken;
    }
  }
  return places;
}

}  // namespace

FamilyStability measure_family(const corpus::Family& family, const StabilitySettings& settings) {
  const engine::Kind kind = family.rotating ? engine::Kind::rotating : engine::Kind::linear;
  const std::size_t count = family.rotating ? settings.rotating_count : settings.count;
  std::vector<const engine::Method*> methods = settings.methods;
  std::erase_if(methods, [&](const engine::Method* method) { return method->kind != kind; });
  const std::vector<Place> places = places_of(family, methods, count, settings.seed);
  FamilyStability result{.family = std::string(family.name),
                         .hardness_meaning = std::string(family.hardness_meaning)};
  for (const engine::Method* method : methods) add_curves(result.curves, *method, family);
  const auto drawn = [&](std::size_t i) {
    return family.generate(family.levels[places[i].level], places[i].seed);
  };
  std::vector<std::vector<Measured>> measured(places.size());  // empty: not measured, by a stop
  {
    Progress progress("stability, " + result.family, places.size());
    scene::for_each_index(places.size(), settings.threads, [&](std::size_t i) {
      if (settings.stop()) return;
      measured[i] = measure_all(drawn(i), methods);
      progress.step();
    });
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_measured = measured[i].size() == methods.size();
    result.cases += is_measured ? 1 : 0;
    result.stopped = result.stopped || !is_measured;
    if (!is_measured) continue;
    bool convicted = false;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const Measured& one = measured[i][m];
      Curve& curve = result.curves[2 * m + (one.rounded ? 1 : 0)];
      curve.levels[places[i].level].add(one);
      convicted = convicted || !one.fault.empty() || one.stalled;
      if (curve.first_fault.empty() && !one.fault.empty()) {
        curve.first_fault = fmt::format("{}: {}", drawn(i).id, one.fault);
      }
    }
    if (convicted) result.convicted.push_back(drawn(i));
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const std::size_t left_out =
        result.curves[2 * m].total().skipped + result.curves[2 * m + 1].total().skipped;
    if (!methods[m]->is_ours() && left_out > 0) result.skipped.push_back({methods[m]->full_name(), left_out});
  }
  std::erase_if(result.curves, [](const Curve& curve) { return curve.total().cases == 0; });
  return result;
}

void LevelErrors::add(const Measured& measured) {
  if (!measured.asked) {
    ++skipped;
    return;
  }
  ++cases;
  failed += measured.failed ? 1 : 0;
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
  skipped += other.skipped;
  failed += other.failed;
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
  return row && !row->is_open && row->may_miss == engine::Unseen::nothing &&
         row->may_be_late == engine::Unseen::nothing;
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
