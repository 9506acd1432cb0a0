#include "properties/attack/attack.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include <optional>

#include "oracles/check_proof.hpp"
#include "oracles/check_rotating_proof.hpp"
#include "properties/attack/claim_judge.hpp"
#include "properties/attack/meaning.hpp"
#include "properties/case_edit.hpp"

namespace graze::attack {

using corpus::Case;
using corpus::ProofRecord;
using corpus::Random;

namespace {

// One case in so many is asked twice.
constexpr std::uint64_t kSecondOpinionEvery = 16;

// While it lives, what is subnormal is zero, as an operand and as a result.
class Flushing {
 public:
#if defined(__SSE2__)
  explicit Flushing(bool wanted) : before_(_mm_getcsr()) {
    if (wanted) _mm_setcsr(before_ | 0x8040u);
  }
  ~Flushing() { _mm_setcsr(before_); }

 private:
  unsigned before_;
#else
  explicit Flushing(bool) {}
#endif
  Flushing(const Flushing&) = delete;
  Flushing& operator=(const Flushing&) = delete;
};

Claim claim_of(const ProofRecord& record, const Settings& settings) {
  Claim claim;
  claim.lower = record.rotating ? record.rotating->toi_lower : record.proof.toi_lower;
  claim.upper = record.rotating ? record.rotating->toi_upper : record.proof.toi_upper;
  if (settings.outcomes) claim.outcome = record.outcome;
  return claim;
}

// The classes, those more often that are seldom accepted.
Edit some_case_edit(Random& random) {
  constexpr std::array kWeighted = {Edit::pivot,   Edit::pivot,  Edit::resting_pivot, Edit::resting_pivot,
                                    Edit::placing, Edit::motion, Edit::extent,        Edit::horizon,
                                    Edit::shape,   Edit::shape};
  return kWeighted[random.below(kWeighted.size())];
}
Edit some_proof_edit(const ProofRecord& record, const Settings& settings, Random& random) {
  if (settings.outcomes && random.once_in(10)) return Edit::outcome;
  if (!record.rotating) {
    constexpr std::array kLinear = {Edit::axis, Edit::index, Edit::index, Edit::bracket};
    return kLinear[random.below(kLinear.size())];
  }
  constexpr std::array kTurning = {Edit::frame,   Edit::frame, Edit::end,   Edit::end,
                                   Edit::axis,    Edit::order, Edit::order, Edit::weights,
                                   Edit::weights, Edit::index, Edit::index, Edit::bracket};
  return kTurning[random.below(kTurning.size())];
}

class Attack {
 public:
  Attack(ProofRecord base, Random& random, const Settings& settings, Tally& tally)
      : base_(std::move(base)),
        random_(random),
        settings_(settings),
        tally_(tally),
        meaning_(meaning_of(base_, settings.outcomes)) {}

  std::vector<Finding> run() {
    if (!accepts(base_, {})) {
      ++tally_.refused_bases;
      return {};
    }
    ++tally_.bases;
    {
      judge_.emplace(base_.problem, random_.once_in(kSecondOpinionEvery));
      Judgement said = judge_->judge(claim_of(base_, settings_));
      if (said.kind == Judgement::Kind::contradicted) {
        found_.push_back({base_, {}, std::move(said.fault)});
        return std::move(found_);
      }
    }
    for (int i = 0; i < 2 * settings_.mutants_each; ++i) shoot({base_, {}});
    for (int k = 0; k < settings_.edited_cases; ++k) {
      Mutant edited{base_, {}};
      for (int edits = random_.integer(1, 3); edits > 0; --edits)
        edit(edited, some_case_edit(random_), random_);
      judge_.reset();
      for (int i = 0; i < settings_.mutants_each; ++i) shoot(edited);
    }
    return std::move(found_);
  }

 private:
  // A mutant of the proof on that case.
  void shoot(Mutant mutant) {
    const bool edited = mutant.edits.any();
    int edits = edited ? random_.integer(0, 2) : random_.integer(1, 3);
    for (; edits > 0; --edits) edit(mutant, some_proof_edit(mutant.record, settings_, random_), random_);
    if (random_.once_in(8)) {
      claim_a_miss_by_one_slice(mutant, random_);
    } else if (random_.once_in(4)) {
      claim_what_the_chain_reaches(mutant, random_);
    }
    if (random_.once_in(4) || (edited && random_.once_in(2))) loosen(mutant, random_);
    weigh(mutant);
  }

  void weigh(const Mutant& mutant) {
    const bool differs = !same(meaning_, meaning_of(mutant.record, settings_.outcomes));
    const auto count = [&](std::uint64_t Count::*kind) {
      if (!differs) return;
      ++(tally_.all.*kind);
      for (std::size_t k = 0; k < kEdits; ++k)
        if (mutant.edits[k]) ++(tally_.by_class[k].*kind);
    };
    if (!accepts(mutant.record, settings_)) return count(&Count::refused);
    if (!differs) ++tally_.same;
    if (!judge_) judge_.emplace(mutant.record.problem, random_.once_in(kSecondOpinionEvery));
    Judgement said = judge_->judge(claim_of(mutant.record, settings_));
    switch (said.kind) {
      case Judgement::Kind::agreed:
        return count(&Count::agreed);
      case Judgement::Kind::undecided:
        return count(&Count::undecided);
      case Judgement::Kind::contradicted:
        // A rest's pivot alone changes nothing, and still may not be believed.
        ++tally_.all.contradicted;
        for (std::size_t k = 0; k < kEdits; ++k)
          if (mutant.edits[k]) ++tally_.by_class[k].contradicted;
        found_.push_back({mutant.record, mutant.edits, std::move(said.fault)});
    }
  }

  ProofRecord base_;
  Random& random_;
  const Settings& settings_;
  Tally& tally_;
  Meaning meaning_;
  std::optional<ClaimJudge> judge_;  // of the case at hand
  std::vector<Finding> found_;
};

}  // namespace

bool can_flush_subnormals() {
#if defined(__SSE2__)
  return true;
#else
  return false;
#endif
}

void Tally::add(const Tally& other) {
  bases += other.bases;
  refused_bases += other.refused_bases;
  same += other.same;
  const auto add_count = [](Count& to, const Count& from) {
    to.refused += from.refused;
    to.agreed += from.agreed;
    to.undecided += from.undecided;
    to.contradicted += from.contradicted;
  };
  add_count(all, other.all);
  for (std::size_t k = 0; k < kEdits; ++k) add_count(by_class[k], other.by_class[k]);
}

std::string text_of(const Finding& finding) {
  ProofRecord record = finding.record;
  std::string classes;
  for (std::size_t k = 0; k < kEdits; ++k)
    if (finding.edits[k]) classes += (classes.empty() ? "" : ", ") + std::string(kEditNames[k]);
  record.problem.comment =
      (classes.empty() ? "as it was proved" : "changed: " + classes) + "; accepted: " + finding.fault;
  return corpus::write_proof(record);
}

bool accepts(const ProofRecord& record, const Settings& settings) {
  const Flushing flushing(settings.flush_subnormals);
  if (record.rotating) return oracle::check_rotating_proof(record.problem, *record.rotating).accepted();
  return oracle::check_proof(record.problem, record.proof).accepted();
}

std::vector<Finding> attack(const Case& problem, Random& random, const Settings& settings, Tally& tally) {
  std::optional<ProofRecord> base = proved(problem, random);
  if (!base) return {};
  return Attack(std::move(*base), random, settings, tally).run();
}

std::vector<Finding> attack_round(std::uint64_t seed, std::uint64_t number, const Settings& settings,
                                  Tally& tally) {
  Random random(law::mix(law::mix(seed) + number));
  Case problem = draw_case(random);
  problem.id = "attack/s" + std::to_string(seed) + "/" + std::to_string(number);
  return attack(problem, random, settings, tally);
}

}  // namespace graze::attack
