#include "properties/attack/mutant.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "corpus/families/draw.hpp"
#include "properties/attack/meaning.hpp"

namespace graze::attack {

using corpus::ProofRecord;
using corpus::Random;

namespace {

double& lower_of(ProofRecord& record) {
  return record.rotating ? record.rotating->toi_lower : record.proof.toi_lower;
}
double& upper_of(ProofRecord& record) {
  return record.rotating ? record.rotating->toi_upper : record.proof.toi_upper;
}

// x made smaller by one part in 2^2 .. 2^40.
double less(double x, Random& random) { return x * (1 - std::scalbn(1.0, -random.integer(2, 40))); }
double more(double x, Random& random) { return x * (1 + std::scalbn(1.0, -random.integer(2, 40))); }

double steps(double x, int count) {
  for (; count > 0; --count) x = std::nextafter(x, kInfinity<double>);
  for (; count < 0; ++count) x = std::nextafter(x, -kInfinity<double>);
  return x;
}

void edit_bracket(ProofRecord& record, Random& random) {
  double &lower = lower_of(record), &upper = upper_of(record);
  const double t_max = std::isfinite(record.problem.t_max) ? record.problem.t_max : 1;
  const double from = std::isfinite(lower) ? lower : t_max;
  switch (random.below(12)) {
    case 0:
      lower = steps(from, random.integer(1, 4));
      break;
    case 1:
      lower = more(from, random);
      break;
    case 2:
      lower = kInfinity<double>;
      break;
    case 3:
      if (std::isfinite(upper)) lower = upper;
      break;
    case 4:
      lower = t_max * random.unit();
      break;
    case 5:
      if (std::isfinite(upper)) upper = std::max(0.0, steps(upper, -random.integer(1, 4)));
      break;
    case 6:
      if (std::isfinite(upper)) upper = less(upper, random);
      break;
    case 7:
      upper = random.once_in(3) ? 0 : t_max * random.unit();
      break;
    case 8:
      // The least numbers, which a machine may flush to zero.
      lower = std::scalbn(static_cast<double>(random.integer(1, 4)), -1074 + random.integer(0, 60));
      break;
    default:
      lower = less(from, random);
      if (random.once_in(2) && std::isfinite(upper)) upper = std::min(more(upper, random), t_max);
      break;
  }
}

// A true proof of less, and a time between its bounds that it does not prove.
void state_beyond_a_weaker_proof(ProofRecord& record, Random& random) {
  double &lower = lower_of(record), &upper = upper_of(record);
  const double t_max = record.problem.t_max;
  if (!(lower < kInfinity<double> && upper < kInfinity<double>)) return;
  lower *= random.unit();
  if (std::isfinite(t_max)) upper += (t_max - upper) * random.unit();
  record.tier = Tier::standard;
  record.toi->lower = record.toi->upper = lower + (upper - lower) * random.unit();
}

// The statement of the record beside its proof.
void edit_outcome(ProofRecord& record, Random& random) {
  constexpr std::array kOutcomes = {Outcome::initially_overlapping, Outcome::hit, Outcome::miss,
                                    Outcome::not_converged};
  if (!record.toi || random.once_in(3)) {
    record.outcome = kOutcomes[random.below(kOutcomes.size())];
    return;
  }
  double &lower = record.toi->lower, &upper = record.toi->upper;
  const double from = std::isfinite(lower) ? lower : 1, to = std::isfinite(upper) ? upper : from;
  switch (random.below(9)) {
    case 0:
      record.tier = static_cast<Tier>(random.below(3));
      break;
    case 1:
      record.toi.reset();
      break;
    case 2:
      lower = random.once_in(2) ? steps(from, random.integer(1, 4)) : more(from, random);
      upper = std::max(lower, upper);
      break;
    case 3:
      upper = random.once_in(2) ? std::max(0.0, steps(to, -random.integer(1, 4))) : less(to, random);
      lower = std::min(lower, upper);
      break;
    case 4:
      // All of it earlier, or later.
      if (random.once_in(2)) {
        upper = less(from, random);
        lower = less(upper, random);
      } else {
        lower = more(to, random);
        upper = more(lower, random);
      }
      break;
    case 5:
      state_beyond_a_weaker_proof(record, random);
      break;
    default:
      // Less than it was.
      lower = random.once_in(4) ? 0 : less(from, random);
      if (random.once_in(2)) upper = random.once_in(4) ? kInfinity<double> : more(to, random);
      break;
  }
}

}  // namespace

double beside(double x, Random& random) {
  const double sign = random.once_in(2) ? 1 : -1;
  switch (random.below(8)) {
    case 0:
      return steps(x, random.integer(1, 3) * (sign > 0 ? 1 : -1));
    case 1:
      return x * (random.once_in(2) ? 2 : 0.5);
    case 2:
      return x + sign * std::scalbn(1.0, -random.integer(0, 12));
    case 3:
      return -x;
    default:
      return x * (1 + sign * std::scalbn(1.0, -random.integer(3, 36)));
  }
}

void edit(Mutant& mutant, Edit kind, Random& random) {
  ProofRecord& record = mutant.record;
  const auto k = static_cast<std::size_t>(kind);
  if (kind == Edit::resting_pivot) {
    const Vec3<double> a = record.problem.spin_a.pivot, b = record.problem.spin_b.pivot;
    edit_case(record, kind, random);
    if (record.problem.spin_a.pivot != a || record.problem.spin_b.pivot != b) mutant.edits.set(k);
    return;
  }
  const bool with_statement = kind == Edit::outcome;
  const Meaning before = meaning_of(record, with_statement);
  if (kind == Edit::bracket) {
    edit_bracket(record, random);
  } else if (kind == Edit::outcome) {
    edit_outcome(record, random);
  } else if (k < kCaseEdits) {
    edit_case(record, kind, random);
  } else if (kind == Edit::index || kind == Edit::weights) {
    edit_named_points(record, kind, random);
  } else {
    edit_chain(record, kind, random);
  }
  if (!same(before, meaning_of(record, with_statement))) mutant.edits.set(k);
}

void loosen(Mutant& mutant, Random& random) {
  double &lower = lower_of(mutant.record), &upper = upper_of(mutant.record);
  const double lower_was = lower, upper_was = upper;
  if (std::isfinite(lower) && !random.once_in(3)) lower = random.once_in(8) ? 0 : less(lower, random);
  if (std::isfinite(upper)) {
    const double later = more(upper, random);
    // In a changed case, a contact rarely stays where it was. In the same case it does.
    const bool same_case = (mutant.edits.to_ullong() & ((1u << kCaseEdits) - 1)) == 0;
    if (random.once_in(same_case ? 8 : 2) || !(later <= mutant.record.problem.t_max)) {
      upper = kInfinity<double>;
    } else if (!mutant.record.rotating) {
      upper = later;
    }
  }
  if (lower != lower_was || upper != upper_was) mutant.edits.set(static_cast<std::size_t>(Edit::bracket));
}

void claim_a_miss_by_one_slice(Mutant& mutant, Random& random) {
  if (!mutant.record.rotating) return;
  const corpus::Case& problem = mutant.record.problem;
  RotatingProof& proof = *mutant.record.rotating;
  TimeSlice slice;
  if (proof.chain.empty() || random.once_in(2)) {
    // From A, or from its centre of rotation, to B or to B's.
    const auto arm = [](const Body<double>& body, const corpus::Spin& spin) {
      return corpus::rotate(body.orientation, spin.pivot);
    };
    slice.axis = problem.b.position - problem.a.position;
    if (!random.once_in(3)) slice.axis -= arm(problem.a, problem.spin_a);
    if (random.once_in(3)) slice.axis += arm(problem.b, problem.spin_b);
  } else {
    slice = proof.chain[random.below(proof.chain.size())];
  }
  const AxisFrame was = slice.frame;
  slice.frame = static_cast<AxisFrame>(random.below(3));
  slice.end = problem.t_max;
  proof = {};
  proof.toi_lower = kInfinity<double>;
  proof.chain = {slice};
  if (slice.frame != was) mutant.edits.set(static_cast<std::size_t>(Edit::frame));
  for (const Edit kind : {Edit::end, Edit::bracket}) mutant.edits.set(static_cast<std::size_t>(kind));
}

void claim_what_the_chain_reaches(Mutant& mutant, Random& random) {
  if (!mutant.record.rotating || mutant.record.rotating->chain.empty()) return;
  RotatingProof& proof = *mutant.record.rotating;
  const double was = proof.toi_lower, upper_was = proof.toi_upper;
  const double end = proof.chain.back().end;
  proof.toi_lower = end >= mutant.record.problem.t_max && !random.once_in(4) ? kInfinity<double> : end;
  if (std::isinf(proof.toi_lower)) proof.toi_upper = kInfinity<double>;
  if (proof.toi_lower != was || proof.toi_upper != upper_was)
    mutant.edits.set(static_cast<std::size_t>(Edit::bracket));
}

}  // namespace graze::attack
