// The exact tier's answers for rounded polytopes, and for polytopes at a target distance: verdict, time, normal,
// witnesses.
//
// Verdict and bracket are those of casts/exact_cast.hpp, decided by round_search.hpp. The normal is within 2 u per component of
// the direction between the cores' nearest points at TOI. Witnesses are a + r_A n and b - r_B n for the cores' nearest
// points a and b: so m apart at TOI. A round walk goes first. Pairs of doubles prove most of its answers
// (round_proof.hpp).
#pragma once

#include <graze/detail/casts/degenerate_round.hpp>
#include <graze/detail/casts/exact_ends.hpp>
#include <graze/detail/casts/pair_kind.hpp>
#include <graze/detail/casts/robust_cast.hpp>
#include <graze/detail/casts/round_cast.hpp>
#include <graze/detail/numeric/rounding.hpp>
#include <graze/detail/proving/prove.hpp>
#include <graze/detail/search/exact/passage.hpp>
#include <graze/detail/search/exact/round_claims.hpp>
#include <graze/detail/search/exact/round_proof.hpp>
#include <graze/detail/search/exact/round_search.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {
namespace exact {

// For the walk of the exact polytopes: no ball about either shape, and no target distance.
template <Scalar S>
bool is_sharp(const Body<S>& a, const Body<S>& b, S target_distance) {
  return !(target_distance > 0) && is_exact(a.shape) && is_exact(b.shape);
}

// A start in contact, pass_over: does the motion leave or slide? The target distance does not count.
template <Scalar S>
bool leaves_or_slides(const Body<S>& a, const Body<S>& b, RoundSearch<S>& search, Counters& counters) {
  if (search.has_balls()) return search.ray_without_target() >= 0;
  // The cores are the bodies, and they may be apart.
  const Body<S> core_a = flat(a), core_b = flat(b);
  PassageSearch<S> cast(core_a, core_b, counters);
  const Passage passage = cast.pass().passage;
  if (passage == Passage::contact) return cast.leaves_or_slides();
  return passage != Passage::ahead || !cast.pair().moves() || cast.slides();
}

// The corners of C nearest to the path at time t, in doubles.
template <Scalar S>
RoundGuess nearest_corners(const Body<S>& a, const Body<S>& b, S target_distance, double t,
                           Counters& counters) {
  const Cso<double> cso(a, b, target_distance);
  Simplex<double> simplex;
  gjk_distance(cso, Vec3<double>(cso.to_parameter(t) * cso.direction()), simplex, 0.0, 0.0,
               CastOptions<S>{}.max_iterations, counters);
  RoundGuess out;
  out.time = t;
  out.size = std::min(simplex.size, 3);
  for (std::size_t i = 0; i < std::size_t(out.size); ++i)
    out.corner[i] = {simplex.point[i].vertex_a, simplex.point[i].vertex_b};
  return out;
}

// By the round walk or the GJK ray cast of the standard tier.
template <Scalar S>
RoundGuess guess_contact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                         Counters& counters) {
  CastOptions<S> plain;
  plain.request = Request::verdict;
  plain.t_max = options.t_max;
  plain.target_distance = options.target_distance;
  CastResult<S> found;
  if (kind_of(a, b, options.target_distance) != PairKind::round || !round_cast(a, b, plain, found))
    robust_gjk_ray(a, b, plain, found);
  counters += found.counters;
  if (found.outcome != Outcome::hit) return {};
  return nearest_corners(a, b, options.target_distance, double(found.toi_lower), counters);
}

// One body at time t: the contact's point of its core, and its ball. The corners' differences are exact, so a body far from
// the origin rounds its point once.
template <Scalar S>
Vec3<double> round_witness(const Body<S>& body, const RoundContact& contact, bool of_a, double t,
                           const Vec3<double>& n) {
  bool valid = true;
  const double radius = ratio(exact_ball<S>(body.shape, valid), Dyadic(1));
  const auto corner = [&](std::size_t i) {
    Feature feature;
    feature.vertex = of_a ? contact.corner[i].a : contact.corner[i].b;
    return exact_point(body, feature);
  };
  const Exact first = corner(0);
  Vec3<double> out = t * wide(body.displacement) + (of_a ? radius : -radius) * n;
  for (std::size_t i = 1; i < std::size_t(contact.size); ++i) {
    Exact step = corner(i);
    step.add(first, true);
    for (int k = 0; k < 3; ++k) out[k] += fl(contact.share[i] * ratio(step.x[std::size_t(k)], step.weight));
  }
  for (int k = 0; k < 3; ++k) out[k] += near_ratio(first.x[std::size_t(k)], first.weight);
  return out;
}

template <Scalar S>
[[nodiscard]] RoundProof prove_plain(const PreparedPair<S>& pair, const Scene<S>& scene,
                                     const CastOptions<S>& options, const RoundWalk<S>& walk,
                                     const RoundSweep& found) {
  return RoundProver<S, false>(pair, scene, options).prove(walk, found);
}
template <Scalar S>
GRAZE_FUSED RoundProof prove_fused(const PreparedPair<S>& pair, const Scene<S>& scene,
                                   const CastOptions<S>& options, const RoundWalk<S>& walk,
                                   const RoundSweep& found) {
  return RoundProver<S, true>(pair, scene, options).prove(walk, found);
}

// The round walk's answer where doubles, or pairs of them, prove it. Contact at t = 0 is |p| <= R there. A corner of
// F is within sqrt(3) point_error of one of K. The weights are >= 0 and sum up to 1 within 4 u, and p's own sums
// round by 4 u M. The norm |p| is within 4 u of itself, R within 3 u, and |p| <= M. If it returns false, nothing is
// proved and only the counters of `out` have changed. `guess` describes a hit, and `toi` its time in doubles.
template <Scalar S>
[[nodiscard]] bool fast_round_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                   CastResult<S>& out, RoundGuess& guess, TimeBracket& toi) {
  if (!is_round(a.shape) || !is_round(b.shape) || !(options.t_max > 0)) return false;
  const PreparedPair<S> pair(a, b, double(options.target_distance));
  if (!pair.moves() || !(pair.radius() > 0)) return false;
  const double t_max = double(options.t_max);
  RoundWalk<S> walk(pair, t_max * power_of_two(pair.speed_exponent() - pair.length_exponent()), 0,
                    kRoundSteps, out.counters, kUnitRoundoff<double>);
  const RoundSweep& found = walk.run();
  const double predicate_error =
      2 * point_error(pair) + 32 * kUnitRoundoff<double> * (pair.extent() + pair.radius());
  if (found.outcome == Outcome::initially_overlapping) {
    if (options.start_policy == StartPolicy::pass_over || !(found.length + predicate_error <= pair.radius()))
      return false;
    out.outcome = found.outcome;
    out.toi_lower = out.toi_upper = 0;
    return true;
  }
  if (found.outcome == Outcome::not_converged) return false;
  RoundProof proof;
  if (found.outcome == Outcome::hit) {
    const Scene<S> scene(a, b, pair.length_exponent(), pair.speed_exponent());
    proof = fuses() ? prove_fused(pair, scene, options, walk, found)
                    : prove_plain(pair, scene, options, walk, found);
    out.counters.exact_decisions += scene.exact_decisions();
    guess.time = found.upper * power_of_two(pair.length_exponent() - pair.speed_exponent());
    guess.size = found.size;
    for (std::size_t i = 0; i < std::size_t(found.size); ++i)
      guess.corner[i] = {walk.corner(i).vertex_a, walk.corner(i).vertex_b};
    if (!proof.proved) return false;
  }
  if (found.outcome == Outcome::miss || proof.toi.upper > t_max) {
    out.outcome = Outcome::miss;
    out.toi_lower = out.toi_upper = kInfinity<S>;
    return true;
  }
  out.outcome = Outcome::hit;
  toi = proof.toi;
  out.toi_lower = round_down<S>(proof.toi.lower);
  out.toi_upper = round_up<S>(proof.toi.upper);
  const Triple& r = pair.direction();
  out.distance = static_cast<S>((double(out.toi_upper) - double(out.toi_lower)) * square_root(dot(r, r)) *
                                power_of_two(pair.speed_exponent()));
  RoundSweep then = found;
  then.n = proof.normal;
  then.length = 1;
  then.lambda = proof.lambda;
  fill_round_contact(a, b, options, pair, walk, proof.normal, then, double(out.toi_lower), out);
  return true;
}

template <Scalar S>
void answer_contact(const Body<S>& a, const Body<S>& b, const RoundContact& contact,
                    const CastOptions<S>& options, CastResult<S>& out) {
  out.toi_lower = round_down<S>(contact.toi.lower);
  out.toi_upper = round_up<S>(contact.toi.upper);
  const Vec3<double> v = wide(b.displacement) - wide(a.displacement);
  out.distance = static_cast<S>((double(out.toi_upper) - double(out.toi_lower)) * norm(v));
  const Vec3<double> n = unit_of(contact.normal);
  if (asks_for(options.request, Request::normal)) out.normal = n.template cast<S>();
  if (!asks_for(options.request, Request::witnesses)) return;
  const double t = double(out.toi_lower);
  out.point_a = round_witness(a, contact, true, t, n).template cast<S>();
  out.point_b = round_witness(b, contact, false, t, n).template cast<S>();
}

// For a start that is passed over, no proof. Under that policy, no claim about a start in contact either.
template <Scalar S>
void prove_round(RoundSearch<S>& search, const CastOptions<S>& options, const TimeBracket& toi,
                 CastResult<S>& out) {
  if (out.passed_over) return;
  Proof proof;
  RoundClaims<S> claims(search);
  if (out.outcome == Outcome::miss) claims.claim_miss(double(options.t_max), proof);
  if (out.outcome == Outcome::initially_overlapping) claims.claim_start(proof);
  if (out.outcome == Outcome::hit) {
    claims.claim_lower(toi.lower, proof);
    claims.claim_upper(toi, proof);
  }
  // A number of the proof alone that outgrew its room leaves the answer, and claims nothing.
  out.proof = search.valid() ? under_policy(proof, options.start_policy) : Proof{};
}

template <Scalar S>
void search_round_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                       RoundSearch<S>& search, RoundGuess guess, TimeBracket& toi, CastResult<S>& out) {
  ++out.counters.exact_decisions;
  std::optional<RoundContact> contact;
  if (!(guess.time > 0)) guess = guess_contact(a, b, options, out.counters);
  if (guess.time > 0 && guess.time < kInfinity<double>) contact = search.contact_near(guess);
  const bool is_sure = contact.has_value();
  if (!is_sure && search.start() <= 0) {
    out.passed_over =
        options.start_policy == StartPolicy::pass_over && leaves_or_slides(a, b, search, out.counters);
    out.outcome = out.passed_over ? Outcome::miss : Outcome::initially_overlapping;
    out.toi_lower = out.toi_upper = out.passed_over ? kInfinity<S> : S(0);
  } else {
    if (!is_sure && search.moves() && options.t_max > 0) {
      const auto path = search.path({}, search.end(double(options.t_max)));
      if (path != RoundSearch<S>::Path::misses) contact = search.first_contact(path, guess.time);
    }
    // A time that is no double is above t_max iff the next double is.
    if (contact && !(contact->toi.upper <= double(options.t_max))) contact.reset();
    out.outcome = contact ? Outcome::hit : Outcome::miss;
    out.toi_lower = out.toi_upper = kInfinity<S>;
    if (!contact) return;
    toi = contact->toi;
    answer_contact(a, b, *contact, options, out);
  }
}

// The bodies have passed refusal(), and are not sharp. `out`: of the method that says it.
template <Scalar S>
void answer_round_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                       CastResult<S>& out) {
  const bool wants_proof = asks_for(options.request, Request::proof);
  RoundGuess guess;
  TimeBracket toi;
  const bool is_fast = fast_round_cast(a, b, options, out, guess, toi);
  if (is_fast && !wants_proof) return;
  RoundSearch<S> search(a, b, double(options.target_distance));
  if (!search.is_rounded()) {
    exact_walk_if_flat(a, b, options, out);
    return;
  }
  if (is_fast) {
    search.begin_at(guess);
  } else {
    search_round_cast(a, b, options, search, guess, toi, out);
  }
  if (!search.valid()) {
    const Method method = out.method;
    out = {};
    out.method = method;
    refuse_as_too_complex(out);
  } else {
    if (wants_proof) prove_round(search, options, toi, out);
    out.counters.supports += search.supports();
  }
}

}  // namespace exact

// The exact tier's rungs beside exact_walk: for rounded polytopes, and for pairs of any kind, which it may refuse.
template <Scalar S>
bool exact_round_cast(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  out.method = Method::exact_portal;
  exact::answer_round_cast(a, b, options, out);
  return true;
}
template <Scalar S>
bool exact_or_refused(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  if (exact::refused(out, a, b)) return true;
  return exact::is_sharp(a, b, options.target_distance) ? exact_walk(a, b, options, out)
                                                        : exact_round_cast(a, b, options, out);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
