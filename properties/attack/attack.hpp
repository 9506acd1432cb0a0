// An attack on the checker of proofs by meaning: mutants of true proofs, and their results.
//
// A mutant that the checker refuses is only counted. The oracles judge an accepted one (claim_judge.hpp), however it
// was made: an accepted proof whose claim they contradict is a finding. It counts as an accepted mutant only if it
// differs in meaning from the proof that it was made from (meaning.hpp) and the oracles agree. Mutants that they leave
// open are counted apart.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "properties/attack/base.hpp"
#include "properties/attack/mutant.hpp"

namespace graze::attack {

struct Settings {
  // The checker runs with subnormal numbers flushed to zero, as in a program linked with -ffast-math.
  bool flush_subnormals = false;
  // Linear proofs are accepted to within kappa u scale, too (check_within.hpp). Proofs accepted only by this
  // tolerance are judged by the same tolerance.
  double kappa = 0;
  // Counts for one base: cases that are made of its case, and mutants of the proof on each of these. The
  // proof on the case itself gets twice as many.
  int edited_cases = 6, mutants_each = 8;
};
// Can this machine be told to flush?
[[nodiscard]] bool can_flush_subnormals();

// Results of mutants. In the counts by class, a mutant counts in each of its classes.
struct Count {
  std::uint64_t refused = 0, agreed = 0, undecided = 0, contradicted = 0;
};
struct Tally {
  std::uint64_t bases = 0;          // true proofs that were mutated
  std::uint64_t refused_bases = 0;  // proofs that the checker refused, so there was nothing to mutate
  std::uint64_t same = 0;           // accepted, and of the same meaning
  Count all;                        // of another meaning
  std::array<Count, kEdits> by_class{};

  void add(const Tally& other);
};

struct Finding {
  corpus::ProofRecord record;  // the accepted mutant
  Edits edits;                 // empty: no mutant, but what a method proved
  std::string fault;
};
// One line of graze.proof/1. The fault is the comment of its case.
[[nodiscard]] std::string text_of(const Finding& finding);

// Answers of the checker. Does it accept the proof? Does it confirm that the proof proves the record's own statement?
// If not, does it at least accept that statement as proved in part?
struct Accepted {
  bool proof = false, statement = false, stands = false;
  double within = 0;  // the proof is true of shapes so near, a length, and not exactly
};
[[nodiscard]] Accepted accepted(const corpus::ProofRecord& record, const Settings& settings);

// Mutants of the proof that a method has for this case: some of the proof alone, the others on some edited
// cases, a few each.
[[nodiscard]] std::vector<Finding> attack(const corpus::Case& problem, corpus::Random& random,
                                          const Settings& settings, Tally& tally);

// The round of that number: a case that the seed and the number draw, and its mutants.
[[nodiscard]] std::vector<Finding> attack_round(std::uint64_t seed, std::uint64_t number,
                                                const Settings& settings, Tally& tally);

}  // namespace graze::attack
