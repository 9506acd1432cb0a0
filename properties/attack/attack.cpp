#include "properties/attack/attack.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include <algorithm>
#include <optional>

#include "engines/guarantees.hpp"
#include "oracles/checker/check_within.hpp"
#include "properties/attack/claim_judge.hpp"
#include "properties/attack/meaning.hpp"
#include "properties/edit/case.hpp"

namespace graze::attack {

using corpus::Case;
using corpus::ProofRecord;
using corpus::Random;

namespace {

// One case in so many is asked twice.
constexpr std::uint64_t kSecondOpinionEvery = 16;

// While it lives, subnormal numbers are zero, as operands and as results.
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

// The claim that the checker has accepted. In the standard tier a linear record's bracket holds for some set near the
// true one (stated_within).
Claim claim_of(const ProofRecord& record, bool with_statement) {
  Claim claim;
  claim.lower = record.rotating ? record.rotating->toi_lower : record.proof.toi_lower;
  claim.upper = record.rotating ? record.rotating->toi_upper : record.proof.toi_upper;
  if (!with_statement) return claim;
  claim.outcome = record.outcome;
  if (record.toi && (record.tier != Tier::standard || record.rotating) && record.outcome != Outcome::miss) {
    claim.lower = std::max(claim.lower, record.toi->lower);
    claim.upper = std::min(claim.upper, record.toi->upper);
  }
  return claim;
}

// Distance from C (a length) of the sets for which the checker accepts a bracket of the standard tier.
double stated_within(const ProofRecord& record, const Settings& settings) {
  return oracle::rounding_granted(record, std::max(settings.kappa, engine::kappa_of(record)));
}

// A random class. Classes that are rarely accepted are drawn more often.
Edit some_case_edit(Random& random) {
  constexpr std::array kWeighted = {Edit::pivot,   Edit::pivot,  Edit::resting_pivot, Edit::resting_pivot,
                                    Edit::placing, Edit::motion, Edit::extent,        Edit::horizon,
                                    Edit::shape,   Edit::shape};
  return kWeighted[random.below(kWeighted.size())];
}
Edit some_proof_edit(const ProofRecord& record, Random& random) {
  if (random.once_in(8)) return Edit::outcome;
  if (record.rotating && record.rotating->toi_upper < kInfinity<double> && random.once_in(2))
    return random.once_in(3) ? Edit::index : Edit::weights;
  if (!record.rotating) {
    constexpr std::array kLinear = {Edit::axis, Edit::index, Edit::index, Edit::bracket};
    return kLinear[random.below(kLinear.size())];
  }
  constexpr std::array kTurning = {Edit::frame,   Edit::frame, Edit::end,   Edit::end,
                                   Edit::axis,    Edit::order, Edit::order, Edit::weights,
                                   Edit::weights, Edit::index, Edit::index, Edit::bracket};
  return kTurning[random.below(kTurning.size())];
}

// Does the proof still claim what such an edit changed? A later one may have dropped that half of it.
bool is_claimed(const ProofRecord& record, Edit kind) {
  if (record.rotating) return kind == Edit::axis || record.rotating->toi_upper < kInfinity<double>;
  const bool axis = record.proof.toi_lower > 0;
  return kind == Edit::axis ? axis
                            : record.proof.toi_upper < kInfinity<double> || (axis && record.proof.symbolic);
}

class Attack {
 public:
  Attack(ProofRecord base, Random& random, const Settings& settings, Tally& tally)
      : base_(std::move(base)),
        random_(random),
        settings_(settings),
        tally_(tally),
        meanings_{meaning_of(base_, false), meaning_of(base_, true)} {}

  std::vector<Finding> run() {
    const Accepted believed = accepted(base_, {});
    if (!believed.proof) {
      ++tally_.refused_bases;
      return {};
    }
    ++tally_.bases;
    judge_.emplace(base_.problem, random_.once_in(kSecondOpinionEvery));
    Judgement said = judged(base_, believed);
    if (said.kind == Judgement::Kind::contradicted) {
      found_.push_back({base_, {}, std::move(said.fault)});
      return std::move(found_);
    }
    for (int i = 0; i < 2 * settings_.mutants_each; ++i) shoot({base_, {}});
    // Few proofs have a contact of rotating bodies, and a changed case rarely leaves it where it was.
    if (base_.rotating && base_.rotating->toi_upper < kInfinity<double>)
      for (int i = 0; i < 2 * settings_.mutants_each; ++i) shoot({base_, {}}, Edit::weights);
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
  // A mutant of the proof on that case, `first` among what is changed.
  void shoot(Mutant mutant, std::optional<Edit> first = {}) {
    const bool edited = mutant.edits.any();
    int edits = edited ? random_.integer(0, 2) : random_.integer(1, 3);
    if (first) edit(mutant, *first, random_);
    for (edits -= first ? 1 : 0; edits > 0; --edits)
      edit(mutant, some_proof_edit(mutant.record, random_), random_);
    if (random_.once_in(8)) {
      claim_a_miss_by_one_slice(mutant, random_);
    } else if (random_.once_in(4)) {
      claim_what_the_chain_reaches(mutant, random_);
    }
    if (random_.once_in(4) || (edited && random_.once_in(2))) loosen(mutant, random_);
    weigh(mutant);
  }

  // The oracles' judgement of the claim. They are not called for a claim that is impossible.
  Judgement judged(const ProofRecord& record, const Accepted& believed) {
    if (believed.stands && !has_a_time(record))
      return {Judgement::Kind::contradicted, "what it states beside a proof that rules it out"};
    const Claim claim = claim_of(record, believed.statement);
    Judgement said =
        believed.within > 0 ? judge_->judge_within(claim, believed.within) : judge_->judge(claim);
    if (said.kind != Judgement::Kind::agreed || !believed.statement || record.tier != Tier::standard ||
        record.rotating || !record.toi || record.outcome == Outcome::miss) {
      return said;
    }
    return judge_->judge_within({.lower = record.toi->lower, .upper = record.toi->upper, .outcome = {}},
                                stated_within(record, settings_));
  }

  void weigh(Mutant mutant) {
    constexpr auto kOutcome = static_cast<std::size_t>(Edit::outcome);
    for (const Edit kind : {Edit::axis, Edit::index, Edit::weights})
      if (!is_claimed(mutant.record, kind)) mutant.edits.reset(static_cast<std::size_t>(kind));
    const Accepted believed = accepted(mutant.record, settings_);
    const auto [proof, statement, stands, within] = believed;
    const bool differs = !same(meanings_[statement], meaning_of(mutant.record, statement || !proof));
    const auto count_in = [&](const Edits& classes, std::uint64_t Count::*kind) {
      for (std::size_t k = 0; k < kEdits; ++k)
        if (classes[k]) ++(tally_.by_class[k].*kind);
    };
    if (!proof) {
      ++tally_.all.refused;
      return count_in(mutant.edits, &Count::refused);
    }
    if (mutant.edits[kOutcome] && !statement && (!stands || has_a_time(mutant.record))) {
      // The proof itself stands: only the statement is refused.
      count_in(Edits().set(kOutcome), &Count::refused);
      mutant.edits.reset(kOutcome);
    }
    if (!judge_) judge_.emplace(mutant.record.problem, random_.once_in(kSecondOpinionEvery));
    Judgement said = judged(mutant.record, believed);
    // A record with the same meaning is not a mutant. If it is contradicted all the same, the checker is
    // wrong anyway.
    const bool contradicted = said.kind == Judgement::Kind::contradicted;
    if (contradicted) found_.push_back({mutant.record, mutant.edits, std::move(said.fault)});
    if (!differs && !contradicted) {
      ++tally_.same;
      return;
    }
    const auto kind = contradicted                           ? &Count::contradicted
                      : said.kind == Judgement::Kind::agreed ? &Count::agreed
                                                             : &Count::undecided;
    ++(tally_.all.*kind);
    count_in(mutant.edits, kind);
  }

  ProofRecord base_;
  Random& random_;
  const Settings& settings_;
  Tally& tally_;
  std::array<Meaning, 2> meanings_;  // without what the record states beside the proof, and with it
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

Accepted accepted(const ProofRecord& record, const Settings& settings) {
  const Flushing flushing(settings.flush_subnormals);
  bool exactly = true;
  const oracle::RecordVerdict verdict = oracle::check_record_within(
      record, {.of_proof = settings.kappa, .of_bracket = engine::kappa_of(record)}, &exactly);
  const double within = exactly ? 0 : oracle::rounding_granted(record, settings.kappa);
  if (verdict.finding != oracle::RecordFinding::refused)
    return {true, verdict.finding == oracle::RecordFinding::accepted, true, within};
  // The checker also gives these two reasons for a proof that is true.
  return {verdict.reason == "contradicted" || verdict.reason == "unproved", false, false, within};
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
