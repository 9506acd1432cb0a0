// The door of the checker of rotating proofs: is it a proof, of a case that the checker reads, with a chain
// as long as its claim?
#pragma once

#include <string>
#include <utility>

#include "oracles/arithmetic/number_text.hpp"
#include "oracles/checker/check_rotating_proof.hpp"
#include "oracles/checker/part_tree.hpp"

namespace graze::oracle {

[[nodiscard]] inline RotatingVerdict malformed(std::string what) {
  return {RotatingRefusal::malformed, std::move(what)};
}

[[nodiscard]] inline RotatingVerdict read_proof(const RotatingProof& proof) {
  if (!(proof.toi_lower >= 0)) return malformed("toi_lower is NaN or below zero");
  if (!(proof.toi_upper >= 0)) return malformed("toi_upper is NaN or below zero");
  double begin = 0;
  for (std::size_t i = 0; i < proof.chain.size(); ++i) {
    const TimeSlice& slice = proof.chain[i];
    const std::string name = "slice " + std::to_string(i);
    if (!all_finite(slice.axis)) return malformed(name + " has a NaN or an infinite axis");
    if (!(slice.end < kInfinity<double>)) return malformed(name + " has an end that is NaN or infinite");
    if (!(slice.end >= begin))
      return malformed(name + " ends at " + text(slice.end) + ", before it begins, at " + text(begin));
    if (slice.frame != AxisFrame::world && slice.frame != AxisFrame::a && slice.frame != AxisFrame::b)
      return malformed(name + " has a frame of no known kind");
    begin = slice.end;
  }
  if (proof.contact_size < 0 || proof.contact_size > static_cast<int>(kContactPairs))
    return malformed("a contact_size outside 0..6");
  if (proof.crossing) {
    if (proof.contact_size != 3)
      return malformed("a crossing of " + std::to_string(proof.contact_size) +
                       " pairs, where three are needed");
    if (!(proof.contact_from >= 0)) return malformed("contact_from is NaN or below zero");
    if (!(proof.contact_from < proof.toi_upper))
      return malformed("a crossing from " + text(proof.contact_from) + ", not before toi_upper, " +
                       text(proof.toi_upper));
  }
  for (int i = 0; i < proof.contact_size; ++i) {
    const SupportPair& pair = proof.contact[static_cast<std::size_t>(i)];
    for (const Feature* f : {&pair.a, &pair.b}) {
      const std::string name = "contact pair " + std::to_string(i);
      if (!all_finite(f->offset)) return malformed(name + " has a NaN or an infinite offset");
      if (proof.crossing && !f->offset.isZero(0))
        return malformed(name + " has an offset, which a crossing's cannot have");
      for (const Vec3<double>& x : f->curved)
        if (!all_finite(x)) return malformed(name + " has a NaN or an infinite point of a curved part");
    }
  }
  return {};
}

[[nodiscard]] inline RotatingVerdict refuse_case(const Entry& entry) {
  const RotatingRefusal refusal = entry.refusal == Refusal::malformed     ? RotatingRefusal::malformed
                                  : entry.refusal == Refusal::unsupported ? RotatingRefusal::unsupported
                                                                          : RotatingRefusal::out_of_range;
  return {refusal, entry.reason};
}

// The two shapes, and what their doors say.
struct TreesOfCase {
  Door of_a, of_b;
  PartTree a, b;

  explicit TreesOfCase(const corpus::Case& problem)
      : of_a(door(problem.a, problem.spin_a)),
        of_b(door(problem.b, problem.spin_b)),
        a(problem.a, of_a),
        b(problem.b, of_b) {}

 private:
  [[nodiscard]] static Door door(const Body<double>& body, const corpus::Spin& spin) {
    Door door;
    for (const Vec3<double>& x : {body.position, body.displacement, spin.rotation, spin.pivot})
      door.vector(x);
    return door;
  }
};

// Is it a case that the checker reads, with the vertices that the proof names?
[[nodiscard]] inline RotatingVerdict read_case(const corpus::Case& problem, const TreesOfCase& trees,
                                               const RotatingProof& proof) {
  if (!(problem.t_max >= 0)) return malformed("t_max is NaN or below zero");
  if (!(problem.target_distance >= 0 && problem.target_distance < kInfinity<double>))
    return malformed("target_distance is NaN, infinite or below zero");
  const std::array<Entry, 2> entries = {trees.of_a.entry(), trees.of_b.entry()};
  for (const Refusal grave : {Refusal::malformed, Refusal::unsupported})
    for (const Entry& entry : entries)
      if (entry.refusal == grave) return refuse_case(entry);
  for (int i = 0; i < proof.contact_size; ++i) {
    const SupportPair& pair = proof.contact[static_cast<std::size_t>(i)];
    if (pair.a.vertex >= trees.a.vertex_count() || pair.b.vertex >= trees.b.vertex_count())
      return malformed("contact pair " + std::to_string(i) +
                       " has an index beyond the vertices of its shape");
  }
  // A lower bound above 0, which is checked as well, says that the start is not in contact: then no policy
  // applies.
  if (problem.start_policy == corpus::StartPolicy::pass_over && proof.toi_upper < kInfinity<double> &&
      !(proof.toi_lower > 0))
    return {RotatingRefusal::unsupported,
            "an upper bound under the policy pass_over, which a leaving start voids"};
  for (const Entry& entry : entries)
    if (entry.refusal != Refusal::none) return refuse_case(entry);
  Door target;
  target.number(problem.target_distance);
  if (target.entry().refusal != Refusal::none)
    return {RotatingRefusal::out_of_range, "target_distance outside 1e-60 .. 1e60"};
  return {};
}

[[nodiscard]] inline RotatingVerdict chain_reaches(const corpus::Case& problem, const RotatingProof& proof) {
  if (!(proof.toi_lower > 0)) return {};
  const bool miss = proof.toi_lower == kInfinity<double>;
  const double needed = miss ? problem.t_max : proof.toi_lower;
  const double reached = proof.chain.empty() ? 0 : proof.chain.back().end;
  if (!proof.chain.empty() && reached >= needed) return {};
  return {RotatingRefusal::chain_too_short, "the chain ends at " + text(reached) + ", before " +
                                                (miss ? "t_max, " : "toi_lower, ") + text(needed)};
}

}  // namespace graze::oracle
