// Declared, with what it promises, in graze/penetration.hpp.
#pragma once

#include <graze/detail/pairs/prepared_body.hpp>
#include <graze/detail/proving/witness.hpp>
#include <graze/detail/queries/line_query.hpp>
#include <graze/detail/search/fast/fast_epa.hpp>
#include <graze/detail/search/fast/fast_gjk.hpp>
#include <graze/detail/search/robust/epa.hpp>
#include <graze/detail/search/robust/mpr.hpp>
#include <graze/detail/search/robust/refine_axis.hpp>
#include <graze/detail/search/smooth/round_depth.hpp>
#include <graze/detail/shapes/validation.hpp>
#include <graze/distance.hpp>
#include <graze/penetration.hpp>

namespace graze { inline namespace GRAZE_LINKAGE {

namespace detail {

template <Scalar S>
CastOptions<S> checked(const PenetrationOptions<S>& options) {
  CastOptions<S> out;
  out.tolerance = options.tolerance;
  out.max_iterations = options.max_iterations;
  return out;
}

// The bracket and the normal. S is the scalar of the search.
template <Scalar Given, Scalar S>
void fill_depth(PenetrationResult<Given>& out, const PenetrationOptions<Given>& options, const Cso<S>& cso,
                S lower, S upper, const Vec3<S>& n) {
  out.outcome = Outcome::initially_overlapping;
  // A depth below zero, or a bound above the other, is rounding.
  upper = std::max(upper, S(0));
  out.upper = static_cast<Given>(cso.to_length(upper));
  out.lower = static_cast<Given>(cso.to_length(std::min(std::max(lower, S(0)), upper)));
  if (asks_for(options.request, Request::normal)) out.normal = n.template cast<Given>();
}
// radial: unit, where the points of the radii lie.
template <Scalar Given, Scalar S>
void fill_penetration(PenetrationResult<Given>& out, const Body<Given>& a, const Body<Given>& b,
                      const PenetrationOptions<Given>& options, const Cso<S>& cso, S lower, S upper,
                      const Vec3<S>& n, const Simplex<S>& contact, const Vec3<S>& radial) {
  fill_depth(out, options, cso, lower, upper, n);
  if (asks_for(options.request, Request::witnesses)) {
    out.point_a = witness(a, cso.side_a(), cso, contact, radial, true, S(0)).template cast<Given>();
    out.point_b = witness(b, cso.side_b(), cso, contact, radial, false, S(0)).template cast<Given>();
  }
}

// GJK stops where it comes no nearer. There the distance is known to u, but an axis only to the root of it,
// as the distance is a square near its minimum: so on, while the axes still get better.
template <Scalar S>
void refine_axis(const Cso<S>& cso, Simplex<S>& simplex, Distance<S>& d, S gap, Counters& counters) {
  // The distance halves no more: a few points around the nearest one are all there is to learn.
  constexpr int kSteps = 16;
  for (int i = 0; i < kSteps && d.upper - d.lower > gap; ++i) {
    const Closest<S> closest = closest_to_origin(simplex, Vec3<S>(Vec3<S>::Zero()));
    if (closest.size == 4 || closest.n == Vec3<S>::Zero() || !(closest.dist_sq > 0)) return;
    reduce(simplex, closest);
    ++counters.supports;
    const CsoPoint<S> next = cso.support(closest.n);
    if (const S lower = -dot(closest.n, next.w); lower > d.lower) {
      d.lower = lower;
      d.n = closest.n;
    }
    if (simplex.holds(next)) return;
    Simplex<S> wider = simplex;
    wider.add(next);
    // The origin must not move away by more than rounding, or the step is discarded.
    const Closest<S> then = closest_to_origin(wider, Vec3<S>(Vec3<S>::Zero()));
    if (!(square_root(then.dist_sq) <= d.upper + gap)) return;
    simplex = wider;
  }
  const Closest<S> closest = closest_to_origin(simplex, Vec3<S>(Vec3<S>::Zero()));
  reduce(simplex, closest);
}

template <Scalar S>
PenetrationResult<S>& no_contact(PenetrationResult<S>& out, const Vec3<double>& n) {
  out.outcome = Outcome::miss;
  out.upper = 0;
  out.normal = n.template cast<S>();
  return out;
}

// Answers for two polytopes. False: nothing is claimed, and of `out` only the counters have changed.
template <Scalar S>
[[nodiscard]] bool fast_penetration(const PreparedPair<S>& pair, const PenetrationOptions<S>& options,
                                    PenetrationResult<S>& out) {
  PairSupport<S> support(pair, out.counters);
  FastGjk<S> gjk(support, out.counters);
  const FastState state = gjk.run({}, 0, true, options.max_iterations);
  out.counters.iterations = out.counters.gjk_iterations;
  if (state == FastState::apart && gjk.separated()) {
    no_contact(out, unit(gjk.axis().vector()));
    return true;
  }
  const int k = pair.length_exponent();
  const auto fill = [&](double lower, double upper, const Triple& n, const std::array<std::uint32_t, 4>& of_a,
                        const std::array<std::uint32_t, 4>& of_b, const std::array<double, 4>& lambda,
                        int size) {
    out.outcome = Outcome::initially_overlapping;
    // A depth below zero, or a bound above the other, is rounding.
    upper = std::max(upper, 0.0);
    out.upper = static_cast<S>(upper * power_of_two(k)) + S(0);  // never -0
    out.lower = static_cast<S>(std::min(std::max(lower, 0.0), upper) * power_of_two(k)) + S(0);
    if (asks_for(options.request, Request::normal)) out.normal = n.vector().template cast<S>();
    if (asks_for(options.request, Request::witnesses)) {
      out.point_a = pair_witness<S>(pair.a(), of_a, lambda, size, k);
      out.point_b = pair_witness<S>(pair.b(), of_b, lambda, size, k);
    }
    return true;
  };
  FastEpa<S> epa(support, out.counters);
  std::array<PairVertex, 4> corner;
  const auto expand = [&] {
    if (!epa.run(corner, support.fine(), pair.tolerated(double(options.tolerance)),
                 options.max_iterations - out.counters.supports))
      return false;
    const PairVertex &a = epa.point(0), &b = epa.point(1), &c = epa.point(2);
    return fill(epa.lower(), epa.upper(), epa.normal(), {a.vertex_a, b.vertex_a, c.vertex_a},
                {a.vertex_b, b.vertex_b, c.vertex_b}, {epa.lambda()[0], epa.lambda()[1], epa.lambda()[2]}, 3);
  };
  const auto touches = [&](double h, const Triple& n) {
    return fill(0, h, n, gjk.vertices(true), gjk.vertices(false), gjk.lambda(), gjk.size());
  };
  int size = gjk.size();
  for (int i = 0; i < size; ++i) corner[static_cast<std::size_t>(i)] = gjk.point(i);
  if (state == FastState::enclosed) return expand();
  if (state == FastState::apart) {
    // The depth is less than rounding can tell from contact, so the axis gets depth 0.
    if (gjk.upper() <= support.noise() && !(gjk.lower() > support.fine()))
      return touches(-gjk.lower(), gjk.axis());
    if (!(gjk.lower() > 0)) return false;
    no_contact(out, gjk.axis().vector());
    return true;
  }
  if (state != FastState::touching) return false;
  // The origin on the simplex. C on one side of it: a depth of nothing. The axis before may show it.
  if (const Triple& last = gjk.axis_before(); !is_small_direction(last)) {
    const Triple n = (1 / square_root(dot(last, last))) * last;
    PairVertex farthest;
    support.sure(n, farthest);
    if (const double h = dot(n, farthest.w); h <= support.fine()) return touches(h, n);
  }
  // Else a tetrahedron with the simplex in it.
  const auto widen = [&](const Triple& n) {
    support.sure(n, corner[static_cast<std::size_t>(size)]);
    ++size;
  };
  const auto across = [](const Triple& e) {
    const Triple x = magnitude(e);
    return cross(e, x.x <= x.y && x.x <= x.z ? Triple{1, 0, 0}
                    : x.y <= x.z             ? Triple{0, 1, 0}
                                             : Triple{0, 0, 1});
  };
  if (size == 1) widen({1, 0, 0});
  if (size == 2) {
    const Triple n = across(corner[1].w - corner[0].w);
    if (is_small_direction(n)) return false;
    widen(n);
  }
  const Triple &a = corner[0].w, &b = corner[1].w, &c = corner[2].w;
  const Triple n = triple(unit(face_normal<double>(a.vector(), b.vector(), c.vector())));
  for (const Triple& side : {n, -n}) {
    if (is_small_direction(side)) return false;
    support.sure(side, corner[3]);
    if (const double h = dot(side, corner[3].w); h <= support.fine() && dot(side, a) >= -support.fine())
      return touches(h, side);
  }
  return expand();
}

// GJK's support evaluations before Newton's method is tried, and the least budget with which it is: it looks at all seams and
// poles of a pair.
inline constexpr int kFirstSteps = 6, kNewtonSupports = 128;

// For every pair of shapes, validated. In double whatever S is, as widening is exact: what a float would round at every
// step is more than the depth of a crumb in a wall. Contact is judged with the rounding of S, as in the other
// queries.
template <Scalar S>
PenetrationResult<S>& robust_penetration(const Body<S>& a, const Body<S>& b,
                                         const PenetrationOptions<S>& options, PenetrationResult<S>& out) {
  using Vec = Vec3<double>;
  const Cso<double> cso(a, b);
  SweepLimits<double> limits;
  limits.noise = kContact * double(kUnitRoundoff<S>) * cso.scale();
  limits.target = std::max(limits.noise, double(options.tolerance) * cso.scale());
  limits.budget = options.max_iterations;
  const double R = cso.radius(), fine = limits.fine(), gap = options.tolerance > 0 ? limits.target : fine;
  Simplex<double> simplex;
  const auto search = [&](int budget) {
    return gjk_distance(cso, Vec(Vec::Zero()), simplex, fine, fine, budget, out.counters);
  };
  // GJK's steps towards a smooth core get ever shorter: soon Newton's method takes over.
  RoundDepth round;
  const bool is_smooth = options.max_iterations >= kNewtonSupports && round.set(cso, a.shape, b.shape);
  Distance<double> d = search(is_smooth ? kFirstSteps : options.max_iterations);
  bool is_near = false;
  if (is_smooth && d.stalled) {
    is_near = d.lower > fine && round.approach(d.n, gap, out.counters);
    if (is_near) {
      d.lower = -round.upper();
      d.upper = std::max(-round.lower(), d.lower);
      d.n = round.normal();
      d.stalled = false;
    } else {
      d = search(options.max_iterations);
    }
  }
  if (d.stalled && d.upper - d.lower > limits.noise) steady_axis(d, cso, simplex, limits, out.counters);
  const double apart = d.upper - R;
  const bool contact = apart <= fine || (apart <= limits.noise && !(d.lower - R > fine));
  if (!contact && d.lower - R > 0) return no_contact(out, d.n);
  // radial: unit, where the points of the radii lie.
  const auto fill_round = [&](double lower, double upper, const Vec& radial) {
    fill_depth(out, options, cso, lower, upper, round.normal());
    if (!asks_for(options.request, Request::witnesses)) return;
    const std::array<Vec, 2> x = round.points();
    const Vec ball_a = cso.side_a().radius * radial, ball_b = cso.side_b().radius * radial;
    out.point_a = world_point(a, cso.side_a(), cso, Vec(x[0] + ball_a), 0.0).template cast<S>();
    out.point_b = world_point(b, cso.side_b(), cso, Vec(x[1] - ball_b), 0.0).template cast<S>();
  };
  if (contact && d.lower > 0 && (d.upper > fine || d.upper - d.lower <= fine)) {
    // The origin outside the core: its distance, seen from inside.
    if (is_near) {
      const bool is_shallow = R - d.upper < d.upper;
      fill_round(R - d.upper, R - d.lower, is_shallow ? unit(Vec(-round.difference())) : d.n);
      return out;
    }
    refine_axis(cso, simplex, d, gap, out.counters);
    if (d.upper - d.lower > std::max(gap, limits.noise)) {
      steady_axis(d, cso, simplex, limits, out.counters);
    }
    out.stalled = !(d.upper - d.lower <= std::max(gap, limits.noise));
    // The axis is known to the root of the rounding only. An angular error moves radii along it by the cores'
    // distance times that angle, and radii along the line between the cores' points by the depth times that angle.
    const Vec joining = combination(simplex);
    const bool shallow = R - d.upper < d.upper && joining != Vec::Zero();
    fill_penetration(out, a, b, options, cso, R - d.upper, R - d.lower, d.n, simplex,
                     shallow ? unit(Vec(-joining)) : d.n);
    return out;
  }
  if (is_smooth) {
    // Nearly all that it takes is to show that no other minimum is lower, which a tolerance makes no shorter.
    round.run(fine, std::max(gap, limits.noise),
              std::min(options.max_iterations - out.counters.supports, kMostRoundDepthSupports),
              out.counters);
    if (round.upper() - round.lower() <= std::max(gap, limits.noise) &&
        (contact || round.upper() + R > limits.noise)) {
      fill_round(round.lower() + R, round.upper() + R, round.normal());
      return out;
    }
  }
  // If the depth belongs to a face other than the contact's, that search ends with a bracket of twice its gap. On a
  // curved C there is always a point a little farther out: near the noise it adds rounding, not room, to its faces as
  // to their neighbours.
  const double epa_gap = cso.curved() ? 2 * limits.noise : fine;
  const Epa<double> least =
      epa<double>([&cso](const Vec& n) { return cso.support(n); }, simplex, d.upper, epa_gap,
                  options.tolerance > 0 ? gap : 0.0, limits.noise, cso.scale(),
                  options.max_iterations - out.counters.supports,
                  cso.curved() ? kMostCurvedVertices : std::numeric_limits<std::size_t>::max(), out.counters);
  if (!contact && !least.enclosed) {
    // GJK could not tell, and this search neither, unless it met an axis that separates: MPR may.
    if (least.upper + R < -limits.noise) return no_contact(out, least.n);
    const Sweep<double> overlap = mpr_overlap(cso, limits, out.counters);
    if (overlap.outcome == Outcome::miss) return no_contact(out, overlap.n);
    if (overlap.outcome != Outcome::initially_overlapping) {
      out.outcome = Outcome::not_converged;
      out.stalled = true;
      return out;
    }
  }
  // In contact no depth is below zero.
  out.stalled = !(least.upper - std::max(least.lower, -R) <= std::max({gap, 2 * epa_gap, limits.noise}));
  // If the search ended without a polytope around the origin, the depth is 0: the bodies touch there.
  const bool touching = least.contact.size == 0 ||
                        !(norm(combination(least.contact)) <= std::max(least.upper, 0.0) + limits.noise);
  fill_penetration(out, a, b, options, cso, least.lower + R, least.upper + R, least.n,
                   touching ? simplex : least.contact, least.n);
  return out;
}

}  // namespace detail

template <Scalar S>
PenetrationResult<S> penetration(const Body<S>& a, const Body<S>& b, const PenetrationOptions<S>& options) {
  PenetrationResult<S> out;
  const CastOptions<S> checked = detail::checked(options);
  out.invalid = validate(a, b, checked);
  if (detail::refused(out, a, b, checked)) return out;
  if (detail::has_fast_search(a.shape) && detail::has_fast_search(b.shape) &&
      detail::fast_penetration(detail::PreparedPair<S>(a, b), options, out))
    return out;
  return detail::robust_penetration(a, b, options, out);
}

template <Scalar S>
PenetrationResult<S> penetration(const Prepared<S>& a, const Prepared<S>& b,
                                 const PenetrationOptions<S>& options) {
  PenetrationResult<S> out;
  const CastOptions<S> checked = detail::checked(options);
  out.invalid = detail::validate_prepared(a, b, checked);
  if (detail::refused(out, a.body(), b.body(), checked)) return out;
  if (detail::both_prepared(a, b) &&
      detail::fast_penetration(detail::PreparedPair<S>(*a.inner().core, *b.inner().core), options, out))
    return out;
  return detail::robust_penetration(a.body(), b.body(), options, out);
}

template <Scalar S>
PenetrationResult<S> penetration_along(const Body<S>& a, const Body<S>& b, const Vec3<S>& direction,
                                       const PenetrationOptions<S>& options) {
  using State = typename detail::PortalSearch<S>::State;
  PenetrationResult<S> out;
  const CastOptions<S> checked = detail::checked(options);
  out.invalid = validate(a, b, checked);
  if (out.invalid == Invalid::none) out.invalid = detail::check_vector(direction);
  if (out.invalid == Invalid::none && direction == Vec3<S>::Zero()) out.invalid = Invalid::out_of_range;
  if (detail::refused(out, a, b, checked, &direction)) return out;
  const detail::Cso<S> cso(a, b);
  const detail::SweepLimits<S> limits = detail::sweep_limits(cso, checked);
  const detail::Frame<S> frame(unit(direction));
  // Is the origin on the part of the line that is in C? First its end, which is the answer.
  const detail::LineEnd<S> end = detail::line_end(cso, frame, S(-1), limits, out.counters, limits.noise);
  out.counters.iterations = out.counters.portal_steps;
  if (end.state == State::missed || end.lower > limits.noise)
    return detail::no_contact(out, detail::wide(end.n));
  const detail::PortalView<S> view{cso, frame, S(1), out.counters};
  detail::PortalSearch<S> begin = detail::find_portal(view, limits.budget);
  if (begin.state == State::entered) {
    detail::refine_portal(view, begin, detail::PortalLimits<S>{S(0), limits.noise, limits.noise / 2},
                          limits.budget);
  }
  out.counters.iterations = out.counters.portal_steps;
  const bool undecided =
      begin.state == State::entered && begin.lower <= limits.noise && begin.upper > limits.noise;
  if (undecided && !detail::holds_origin(begin, limits.noise))
    return detail::no_contact(out, detail::wide(begin.facing));
  const bool in_contact =
      begin.state == State::accepted ||
      (begin.state == State::entered && std::min(begin.lower, begin.upper) <= limits.noise);
  if (begin.state == State::rejected || begin.state == State::missed ||
      (begin.state == State::entered && !in_contact)) {
    return detail::no_contact(out, detail::wide(begin.n));
  }
  // If the budget left an end open, only its point in C is known.
  if (!in_contact || (end.state != State::entered && end.upper > limits.noise)) {
    out.outcome = Outcome::not_converged;
    out.stalled = true;
    return out;
  }
  out.stalled = end.state != State::entered;
  detail::fill_penetration(out, a, b, options, cso, -end.upper, -end.lower, end.n, end.contact, end.n);
  return out;
}

}}  // namespace graze::GRAZE_LINKAGE
