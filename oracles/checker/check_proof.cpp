// The door (is it a proof, of a case in range?), then each claim through the three arithmetics in turn.
#include "oracles/checker/check_proof.hpp"

#include "oracles/arithmetic/default_environment.hpp"
#include "oracles/arithmetic/double_double.hpp"
#include "oracles/arithmetic/dual.hpp"
#include "oracles/arithmetic/dyadic.hpp"
#include "oracles/arithmetic/number_text.hpp"
#include "oracles/checker/ray_claim.hpp"
#include "oracles/checker/tree_axis.hpp"

namespace graze::oracle {
namespace {

// ---- the door ---------------------------------------------------------------------------------------------

// Reads a body whose shape is a polytope plus a ball. Returns false for any other shape and reads nothing.
[[nodiscard]] bool read_solid(const Body<double>& body, Solid& solid, Door& door) {
  if (!read_leaf(body.shape, solid, door)) return false;
  door.vector(body.position);
  door.vector(body.displacement);
  door.quaternion(body.orientation);
  solid.position = &body.position;
  solid.displacement = &body.displacement;
  // A ball about the body's origin looks the same in every orientation.
  solid.rotated = door.well_formed() && !body.orientation.is_identity() && !solid.core.is_origin();
  if (solid.rotated) solid.q = scaled_to_one(body.orientation);
  return true;
}

struct VertexCounts {
  std::uint64_t a, b;
};

// The fault in the form of a support pair, or nullptr if there is no fault. `counts` is given if the shapes
// are known.
[[nodiscard]] const char* fault_of(const SupportPair& pair, const VertexCounts* counts) {
  for (const Feature* f : {&pair.a, &pair.b}) {
    if (!all_finite(f->offset)) return "a NaN or an infinite offset";
    for (const Vec3<double>& x : f->curved)
      if (!all_finite(x)) return "a NaN or an infinite point of a curved part";
  }
  if (counts != nullptr && (pair.a.vertex >= counts->a || pair.b.vertex >= counts->b))
    return "an index beyond the vertices of its shape";
  return nullptr;
}

[[nodiscard]] const char* fault_of(const AxisFactor& factor, const VertexCounts* counts) {
  switch (factor.kind) {
    case AxisFactor::Kind::given:
      return all_finite(factor.given) ? nullptr : "a NaN or an infinite factor of the axis";
    case AxisFactor::Kind::motion:
      return nullptr;
    case AxisFactor::Kind::difference: {
      const char* fault = fault_of(factor.from, counts);
      return fault != nullptr ? fault : fault_of(factor.to, counts);
    }
  }
  return "a factor of the axis of no known kind";
}

// The same for a pair of points of the cores.
[[nodiscard]] const char* fault_of_cores(const SupportPair& pair, const VertexCounts* counts) {
  if (const char* fault = fault_of(pair, counts)) return fault;
  for (const Feature* f : {&pair.a, &pair.b}) {
    if (!f->offset.isZero(0)) return "a pair of cores with an offset";
    for (const Vec3<double>& x : f->curved)
      if (!x.isZero(0)) return "a pair of cores with a point of a curved part";
  }
  return nullptr;
}

[[nodiscard]] const char* fault_of(const Proof& proof, const NearestAxis& nearest,
                                   const VertexCounts* counts) {
  if (nearest.size < 0 || nearest.size + (nearest.motion ? 1 : 0) > 3)
    return "a nearest axis with more than two directions, or of a size below 0";
  if (!std::isfinite(nearest.time)) return "a NaN or an infinite time of a nearest axis";
  for (int i = 0; i < nearest.size; ++i)
    if (const char* fault = fault_of_cores(nearest.pair[static_cast<std::size_t>(i)], counts)) return fault;
  return proof.then ? fault_of(proof.factor[0], counts) : nullptr;
}

[[nodiscard]] const char* fault_of_axis(const Proof& proof, const VertexCounts* counts) {
  if (!proof.symbolic) return all_finite(proof.axis) ? nullptr : "a NaN or an infinite axis";
  if (proof.nearest.size != 0) return fault_of(proof, proof.nearest, counts);
  if (proof.axis_sign != 1 && proof.axis_sign != -1) return "an axis_sign that is neither 1 nor -1";
  for (const AxisFactor& factor : proof.factor)
    if (const char* fault = fault_of(factor, counts)) return fault;
  return nullptr;
}

// Is it a proof, about a case that the checker reads? `of_a` and `of_b` are what the bodies' doors said.
[[nodiscard]] Entry read_case(const corpus::Case& problem, const Proof& proof, const Door& of_a,
                              const Door& of_b, const VertexCounts& counts) {
  const Vec3<double>& spin_a = problem.spin_a.rotation;
  const Vec3<double>& spin_b = problem.spin_b.rotation;
  if (!all_finite(spin_a) || !all_finite(spin_b))
    return {Refusal::malformed, "a NaN or an infinite rotation"};
  if (!(problem.t_max >= 0)) return {Refusal::malformed, "t_max is NaN or below zero"};
  if (!(problem.target_distance >= 0 && problem.target_distance < kInfinity<double>))
    return {Refusal::malformed, "target_distance is NaN, infinite or below zero"};
  const Entry in_a = of_a.entry(), in_b = of_b.entry();
  if (in_a.refusal == Refusal::malformed) return in_a;
  if (in_b.refusal == Refusal::malformed) return in_b;

  if (!(proof.toi_lower >= 0)) return {Refusal::malformed, "toi_lower is NaN or below zero"};
  if (!(proof.toi_upper >= 0)) return {Refusal::malformed, "toi_upper is NaN or below zero"};
  const bool known = in_a.refusal == Refusal::none && in_b.refusal == Refusal::none;
  const VertexCounts* const bound = known ? &counts : nullptr;
  if (const char* fault = proof.has_axis ? fault_of_axis(proof, bound) : nullptr)
    return {Refusal::malformed, fault};
  if (proof.portal_size < 0 || proof.portal_size > 4)
    return {Refusal::malformed, "a portal of a size outside 0..4"};
  for (int i = 0; i < proof.portal_size; ++i) {
    const SupportPair& pair = proof.portal[static_cast<std::size_t>(i)];
    if (const char* fault = proof.of_cores ? fault_of_cores(pair, bound) : fault_of(pair, bound))
      return {Refusal::malformed, fault};
  }

  if (in_a.refusal == Refusal::unsupported) return in_a;
  if (in_b.refusal == Refusal::unsupported) return in_b;
  if (!spin_a.isZero(0) || !spin_b.isZero(0)) return {Refusal::unsupported, "a rotating motion"};
  // A lower bound above 0, which is checked as well, says that the start is not in contact: then no policy
  // applies.
  if (problem.start_policy == corpus::StartPolicy::pass_over && proof.toi_upper < kInfinity<double> &&
      !(proof.toi_lower > 0))
    return {Refusal::unsupported, "an upper bound under the policy pass_over, which a leaving start voids"};
  if (in_a.refusal != Refusal::none) return in_a;
  if (in_b.refusal != Refusal::none) return in_b;
  Door target;
  target.number(problem.target_distance);
  if (target.entry().refusal != Refusal::none)
    return {Refusal::out_of_range, "target_distance outside 1e-60 .. 1e60"};
  return {};
}

// ---- the cascade ------------------------------------------------------------------------------------------

[[nodiscard]] constexpr bool is_open(Answer found) { return found == Answer::unknown; }

class Cascade {
 public:
  Cascade(CheckCost* cost, Stages stages) : cost_(cost), doubles_(stages == Stages::all) {}

  // decide.operator()<N>() returns the finding over N. An open finding passes to the next arithmetic.
  template <class Decide>
  [[nodiscard]] auto run(const Decide& decide) const {
    if (doubles_) {
      if (const auto found = decide.template operator()<Filtered>(); !is_open(found)) {
        if (cost_ != nullptr) ++cost_->double_decisions;
        return found;
      }
    }
    return run_close(decide);
  }

  // The same for two claims about neighbouring doubles at once, which plain doubles hardly ever tell apart.
  template <class Decide>
  [[nodiscard]] auto run_close(const Decide& decide) const {
    if (doubles_) {
      if (const auto found = decide.template operator()<Extended>(); !is_open(found)) {
        if (cost_ != nullptr) ++cost_->extended_decisions;
        return found;
      }
    }
    if (cost_ != nullptr) ++cost_->exact_decisions;
    return decide.template operator()<Dyadic>();
  }

  // The same in exact numbers of the given kind only.
  template <class N, class Decide>
  [[nodiscard]] auto run_exactly(const Decide& decide) const {
    if (cost_ != nullptr) ++cost_->exact_decisions;
    return decide.template operator()<N>();
  }

  // The same for claims with square roots, whose finding may stay unknown.
  template <class Decide>
  [[nodiscard]] auto run_with_roots(bool has_roots, const Decide& decide) const {
    if (doubles_) {
      if (const auto found = decide.template operator()<Filtered>(); !is_open(found)) {
        if (cost_ != nullptr) ++cost_->double_decisions;
        return found;
      }
    }
    if (doubles_ && !has_roots) {
      if (const auto found = decide.template operator()<Extended>(); !is_open(found)) {
        if (cost_ != nullptr) ++cost_->extended_decisions;
        return found;
      }
    }
    for (long bits = kFirstBits; bits <= kMostBits; bits *= 2) {
      const WorkingPrecision working(bits);
      if (const auto found = decide.template operator()<Ball>(); !is_open(found)) {
        if (cost_ != nullptr) ++cost_->ball_decisions;
        return found;
      }
    }
    const WorkingPrecision working(ARF_PREC_EXACT);  // the roots stay at kMostBits
    if (cost_ != nullptr) ++cost_->exact_decisions;
    return decide.template operator()<Ball>();
  }

 private:
  CheckCost* cost_;
  bool doubles_;
};

// |offset| <= radius
[[nodiscard]] bool offset_fits(const Cascade& cascade, const Leaf& leaf, const Feature& feature) {
  const Vec3<double>& x = feature.offset;
  if (!leaf.has_ball || x.isZero(0)) return x.isZero(0);
  return cascade.run([&]<class N>() {
    const N r(leaf.radius);
    const Triple<N> offset = triple<N>(x);
    return at_most_zero(sign(dot(offset, offset) - r * r));
  }) == Answer::yes;
}

// ---- messages ---------------------------------------------------------------------------------------------

// About h(n) and n.v, to some 15 digits.
struct AxisValues {
  double support, approach;
};

[[nodiscard]] Verdict refuse_offset(int pair) {
  return {Refusal::offset_too_long, "the offset of portal pair " + std::to_string(pair) +
                                        " is longer than the radii there (0: no ball)"};
}

[[nodiscard]] Verdict refuse_axis(AxisFinding found, const LowerClaim& claim, const AxisValues& values) {
  if (found == AxisFinding::unknown)
    return {Refusal::undecided, "h(n), about " + text(values.support) +
                                    ", is closer to what the axis must prove than " +
                                    std::to_string(kMostBits) + " bits tell"};
  if (found == AxisFinding::zero_axis)
    return {Refusal::axis_missing, "toi_lower " + text(claim.toi_lower) +
                                       " needs a non-zero axis; the cross product of its factors is zero"};
  if (claim.is_miss())
    return {Refusal::miss_not_proved, "a miss needs h(n) < min(0, T n.v); h(n) is about " +
                                          text(values.support) + ", n.v about " + text(values.approach)};
  if (found == AxisFinding::not_approaching)
    return {Refusal::axis_not_approaching,
            "a finite toi_lower needs n.v < 0; n.v is about " + text(values.approach)};
  return {Refusal::lower_not_proved, "toi_lower " + text(claim.toi_lower) + " exceeds h(n)/(n.v), about " +
                                         text(values.support / values.approach)};
}

[[nodiscard]] Verdict refuse_portal(PortalFinding found, double end) {
  if (found == PortalFinding::off_path)
    return {
        Refusal::portal_off_path,
        "no convex combination of the portal's pairs lies on the path's line (within the target distance)"};
  return {Refusal::upper_not_proved, "the portal meets the path's line, but not for any s in [0, " +
                                         text(end) + "], the least of T and toi_upper"};
}

// ---- the claims, about bodies of one kind
// -------------------------------------------------------------------

// Polytopes plus balls.
class SolidBodies {
 public:
  SolidBodies(const Solid& a, const Solid& b) : a_(a), b_(b) {}

  [[nodiscard]] Verdict points_fit(const Cascade& cascade, const Proof& proof) const {
    for (int i = 0; i < proof.portal_size; ++i) {
      const SupportPair& s = proof.portal[static_cast<std::size_t>(i)];
      if (!offset_fits(cascade, a_, s.a) || !offset_fits(cascade, b_, s.b)) return refuse_offset(i);
    }
    return {};
  }

  [[nodiscard]] AxisFindings axis(const Cascade& cascade, const Proof& proof, double target_distance,
                                  const LowerClaims& claims) const {
    const AxisQuestion ask{a_, b_, proof, target_distance};
    Scans scans;
    const auto decide = [&]<class N>() { return axis_claims<N>(ask, claims, scans); };
    return is_tilted(proof) ? cascade.run_exactly<Dual<Dyadic>>(decide) : cascade.run(decide);
  }
  [[nodiscard]] AxisValues axis_values(const Proof& proof, double target_distance) const {
    const AxisQuestion ask{a_, b_, proof, target_distance};
    Scans every_vertex;
    const Pair<Dyadic> pair(a_, b_);
    const Triple<Dyadic> n = axis_vector(a_, b_, pair, proof);
    const auto value = [](const Dyadic& x) { return Dyadic::ratio(x, Dyadic(1)); };
    const double radius = a_.radius + b_.radius + target_distance;
    return {Dyadic::ratio(weighted_support(ask, pair, n, every_vertex), pair.weight) +
                radius * Vec3<double>(value(n.x), value(n.y), value(n.z)).stableNorm(),
            value(approach_along(proof, n, pair.velocity).value)};
  }

  template <class N>
  [[nodiscard]] PortalPoints<N> points(const Proof& proof) const {
    return portal_points<N>(a_, b_, proof);
  }

 private:
  const Solid& a_;
  const Solid& b_;
};

// Shapes of any kind.
class TreeBodies {
 public:
  TreeBodies(const TreePair& pair, const Proof& proof) : pair_(pair), axis_(pair, proof) {
    for (int i = 0; i < proof.portal_size; ++i) {
      const SupportPair& s = proof.portal[static_cast<std::size_t>(i)];
      ways_a_.emplace_back(pair.a, s.a);
      ways_b_.emplace_back(pair.b, s.b);
    }
  }

  [[nodiscard]] Verdict points_fit(const Cascade& cascade, const Proof& proof) const {
    if ((is_nearest(proof) || (proof.of_cores && proof.portal_size > 0)) &&
        !(pair_.a.has_core() && pair_.b.has_core()))
      return {Refusal::unsupported, "the cores of curved shapes, or of a hull of shapes"};
    bool named = axis_.named();
    for (const std::vector<Way>* ways : {&ways_a_, &ways_b_})
      for (const Way& way : *ways) named &= way.curved_count() <= kCurvedParts;
    if (!named)
      return {Refusal::malformed, "a point on a way with more than " + std::to_string(kCurvedParts) +
                                      " curved parts, which a feature cannot name"};
    for (std::size_t i = 0; i < ways_a_.size(); ++i) {
      for (const Way* way : {&ways_a_[i], &ways_b_[i]}) {
        const bool fits = way->feature().offset.isZero(0) ||
                          cascade.run([&]<class N>() { return way->offset_fits<N>(); }) == Answer::yes;
        if (!fits) return refuse_offset(static_cast<int>(i));
        for (std::size_t k = 0; k < way->curved_count(); ++k) {
          const Vec3<double>& x = way->feature().curved[k];
          if (cascade.run([&]<class N>() { return inside_curved<N>(way->curved(k), x); }) != Answer::yes)
            return {Refusal::point_outside, "portal pair " + std::to_string(i) + " of body " +
                                                (way == &ways_a_[i] ? "a" : "b") + ": curved point " +
                                                std::to_string(k) + " lies outside its shape"};
        }
      }
    }
    return {};
  }

  [[nodiscard]] AxisFindings axis(const Cascade& cascade, const Proof& proof, double target_distance,
                                  const LowerClaims& claims) const {
    TreeScans scans(pair_);
    if (is_nearest(proof)) {
      const auto decide = [&]<class N>() {
        return axis_.nearest_findings<N>(target_distance, claims, scans);
      };
      return is_tilted(proof) ? cascade.run_exactly<Dual<Dyadic>>(decide) : cascade.run(decide);
    }
    return cascade.run_with_roots(target_distance > 0 || pair_.has_roots(), [&]<class N>() {
      return axis_.findings<N>(target_distance, claims, scans);
    });
  }
  [[nodiscard]] AxisValues axis_values(const Proof& proof, double target_distance) const {
    const WorkingPrecision working(kFirstBits);
    TreeScans every_vertex(pair_);
    const Triple<Ball> n = axis_.vector<Ball>();
    const Fraction<Ball> h = tree_support<Ball>(pair_, n, root(dot(n, n)), target_distance, every_vertex);
    return {(h.value / h.weight).mid_double(),
            approach_along(proof, n, axis_.velocity<Ball>()).value.mid_double()};
  }

  template <class N>
  [[nodiscard]] PortalPoints<N> points(const Proof& proof) const {
    PortalPoints<N> points = portal_points<N>(pair_, ways_a_, ways_b_);
    if (proof.of_cores) {
      points.balls = pair_.a.template ball<N>() + pair_.b.template ball<N>();
      points.has_balls = pair_.a.has_ball() || pair_.b.has_ball();
    }
    return points;
  }

 private:
  const TreePair& pair_;
  TreeAxis axis_;
  std::vector<Way> ways_a_, ways_b_;
};

// The claims in their order, and, if `moved` is not null, what would be accepted with either bound moved to
// the other: for 0 < toi_lower < toi_upper < infinity and no ball about the portal. The case and the form of the
// proof are sound.
template <class Bodies>
[[nodiscard]] Verdict check_claims(const corpus::Case& problem, const Proof& proof, const Bodies& bodies,
                                   const Cascade& cascade, MovedBounds* moved) {
  if (Verdict points = bodies.points_fit(cascade, proof); !points.accepted()) return points;

  if (proof.toi_lower > 0) {
    if (!proof.has_axis || (!proof.symbolic && proof.axis.isZero(0)))
      return {Refusal::axis_missing, "toi_lower " + text(proof.toi_lower) + " needs a non-zero axis"};
    LowerClaims claims{{proof.toi_lower, problem.t_max}};
    if (moved != nullptr) claims.raised = proof.toi_upper;
    const AxisFindings found = bodies.axis(cascade, proof, problem.target_distance, claims);
    if (found.claim != AxisFinding::holds)
      return refuse_axis(found.claim, claims.claim, bodies.axis_values(proof, problem.target_distance));
    if (moved != nullptr) moved->lower_accepted = found.raised == AxisFinding::holds;
  }

  if (proof.toi_upper < kInfinity<double>) {
    if (proof.portal_size == 0)
      return {Refusal::portal_missing, "toi_upper " + text(proof.toi_upper) + " needs a portal"};
    PathQuestion ask{problem.a.displacement, problem.b.displacement, std::min(problem.t_max, proof.toi_upper),
                     problem.target_distance};
    if (moved != nullptr) ask.lowered = std::min(problem.t_max, proof.toi_lower);
    const auto decide = [&]<class N>() {
      return PortalClaim<N>(ask, bodies.template points<N>(proof)).decide();
    };
    const PortalFindings found = moved != nullptr ? cascade.run_close(decide) : cascade.run(decide);
    if (found.claim != PortalFinding::holds) return refuse_portal(found.claim, ask.horizon);
    if (moved != nullptr) moved->upper_accepted = found.lowered == PortalFinding::holds;
  }
  return {};
}

// The claims of a ray that name neither axis nor portal are decided here, and taken from `proof`.
[[nodiscard]] Verdict check_ray(const corpus::Case& problem, Proof& proof) {
  const std::optional<RayClaim> ray = RayClaim::of(problem);
  if (!ray) return {};
  if (proof.toi_lower > 0 && !proof.has_axis) {
    const bool is_miss = !(proof.toi_lower <= problem.t_max) || proof.toi_lower == kInfinity<double>;
    if (is_miss ? ray->touches_by(problem.t_max) : !ray->is_free_before(proof.toi_lower))
      return {is_miss ? Refusal::miss_not_proved : Refusal::lower_not_proved,
              "the point is in the solid before toi_lower " + text(proof.toi_lower)};
    proof.toi_lower = 0;
  }
  if (proof.toi_upper < kInfinity<double> && proof.portal_size == 0) {
    if (!ray->touches_by(std::min(problem.t_max, proof.toi_upper)))
      return {Refusal::upper_not_proved,
              "the point is not in the solid up to toi_upper " + text(proof.toi_upper)};
    proof.toi_upper = kInfinity<double>;
  }
  return {};
}

// Apart, so that the polytopes' way stays small.
[[gnu::noinline]] Verdict check_trees(const corpus::Case& problem, const Proof& proof, const Cascade& cascade,
                                      MovedBounds* moved) {
  Door of_a, of_b;
  of_a.vector(problem.a.displacement);
  of_a.vector(problem.a.position);
  of_b.vector(problem.b.displacement);
  of_b.vector(problem.b.position);
  const PartTree a(problem.a, of_a), b(problem.b, of_b);
  if (const Entry entry = read_case(problem, proof, of_a, of_b, {a.vertex_count(), b.vertex_count()});
      entry.refusal != Refusal::none)
    return {entry.refusal, entry.reason};
  Proof rest = proof;
  if (Verdict verdict = check_ray(problem, rest); !verdict.accepted()) return verdict;
  const TreePair pair{a, b, problem.a, problem.b};
  return check_claims(problem, rest, TreeBodies(pair, rest), cascade, moved);
}

[[nodiscard]] Verdict check(const corpus::Case& problem, const Proof& proof, const Cascade& cascade,
                            MovedBounds* moved) {
  Solid a, b;
  Door of_a, of_b;
  if (!read_solid(problem.a, a, of_a) || !read_solid(problem.b, b, of_b))
    return check_trees(problem, proof, cascade, moved);
  if (const Entry entry = read_case(problem, proof, of_a, of_b, {a.core.count(), b.core.count()});
      entry.refusal != Refusal::none)
    return {entry.refusal, entry.reason};
  return check_claims(problem, proof, SolidBodies(a, b), cascade, moved);
}

}  // namespace

const char* to_string(Refusal refusal) {
  switch (refusal) {
    case Refusal::none:
      return "accepted";
    case Refusal::malformed:
      return "malformed";
    case Refusal::unsupported:
      return "unsupported";
    case Refusal::out_of_range:
      return "out_of_range";
    case Refusal::offset_too_long:
      return "offset_too_long";
    case Refusal::axis_missing:
      return "axis_missing";
    case Refusal::axis_not_approaching:
      return "axis_not_approaching";
    case Refusal::lower_not_proved:
      return "lower_not_proved";
    case Refusal::miss_not_proved:
      return "miss_not_proved";
    case Refusal::point_outside:
      return "point_outside";
    case Refusal::undecided:
      return "undecided";
    case Refusal::portal_missing:
      return "portal_missing";
    case Refusal::portal_off_path:
      return "portal_off_path";
    case Refusal::upper_not_proved:
      return "upper_not_proved";
  }
  return "unknown refusal";
}

Verdict check_proof(const corpus::Case& problem, const Proof& proof, CheckCost* cost, Stages stages) {
  const DefaultEnvironment environment;
  return check(problem, proof, Cascade(cost, stages), nullptr);
}

Verdict check_bracket(const corpus::Case& problem, const Proof& proof, MovedBounds& moved, CheckCost* cost) {
  const DefaultEnvironment environment;
  const Cascade cascade(cost, Stages::all);
  moved = {};
  if (!(proof.toi_lower < proof.toi_upper && proof.toi_upper < kInfinity<double>))
    return check(problem, proof, cascade, nullptr);
  // The door and the points ask nothing that a moved bound would change, once the lower one is above 0.
  if (proof.toi_lower > 0 && problem.target_distance == 0 && !proof.of_cores && proof.has_axis &&
      proof.portal_size > 0)
    return check(problem, proof, cascade, &moved);
  Verdict verdict = check(problem, proof, cascade, nullptr);
  if (!verdict.accepted()) return verdict;
  Proof raised = proof, lowered = proof;
  raised.toi_lower = proof.toi_upper;
  lowered.toi_upper = proof.toi_lower;
  moved.lower_accepted = check(problem, raised, cascade, nullptr).accepted();
  moved.upper_accepted = check(problem, lowered, cascade, nullptr).accepted();
  return verdict;
}

}  // namespace graze::oracle
