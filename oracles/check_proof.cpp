// The door (is it a proof, of a case in range?), then each claim through the three arithmetics in turn.
//
// Where the process does not round to nearest, or flushes subnormals (a library linked with -ffast-math turns
// that on for everybody), the filters' bounds are void; they are left out, and GMP decides.
#include "oracles/check_proof.hpp"

#include <cstdio>

#include "oracles/axis_claim.hpp"
#include "oracles/double_double.hpp"
#include "oracles/dyadic.hpp"
#include "oracles/portal_claim.hpp"

namespace graze::oracle {
namespace {

// The range of magnitudes of a case (any unit); DESIGN: inputs from 1e-60 to 1e60. The proof's own numbers
// may be any finite doubles: where the filters overflow, the exact stage decides.
constexpr double kLeast = 1e-60, kLargest = 1e60;

enum class Range { inside, outside, not_finite };

[[nodiscard]] Range worse(Range l, Range r) { return l > r ? l : r; }

[[nodiscard]] Range range_of(double x) {
  const double magnitude = std::abs(x);
  if (!(magnitude <= std::numeric_limits<double>::max())) return Range::not_finite;
  return magnitude == 0 || (magnitude >= kLeast && magnitude <= kLargest) ? Range::inside : Range::outside;
}
[[nodiscard]] Range range_of(const Vec3<double>& x) {
  return worse(worse(range_of(x.x()), range_of(x.y())), range_of(x.z()));
}
[[nodiscard]] bool finite(const Vec3<double>& x) {
  return x.cwiseAbs().maxCoeff() < kInfinity<double> && x == x;
}

[[nodiscard]] bool filters_hold() {
  volatile double least = std::numeric_limits<double>::min(), half_unit = 0x1p-53, one = 1;
  const double subnormal = least / 2;
  volatile double kept = subnormal;
  return kept * 2 == least && one + half_unit == one && -one - half_unit == -one &&
         (one + 0x1p-52) + half_unit == one + 0x1p-51;
}

// ---- the door ---------------------------------------------------------------------------------------------

struct Entry {
  Refusal refusal = Refusal::none;
  const char* reason = "";
};

[[nodiscard]] Entry worst_of(Range range, const char* malformed, const char* outside) {
  if (range == Range::not_finite) return {Refusal::malformed, malformed};
  if (range == Range::outside) return {Refusal::out_of_range, outside};
  return {};
}

// Reads a body; malformed comes before out of range, so the caller sees the graver of two.
[[nodiscard]] Entry read_body(const Body<double>& body, Solid& solid) {
  Range range = worse(range_of(body.position), range_of(body.displacement));
  const Quaternion<double>& q = body.orientation;
  range = worse(range, worse(worse(range_of(q.w), range_of(q.x)), worse(range_of(q.y), range_of(q.z))));
  solid.position = &body.position;
  solid.displacement = &body.displacement;

  if (const auto* hull = std::get_if<Hull<double>>(&body.shape)) {
    solid.vertices = hull->vertices();
    if (solid.vertices.empty()) return {Refusal::malformed, "a hull without a vertex"};
    bool inside = true;
    Vec3<double> reach = Vec3<double>::Zero();
    for (const Vec3<double>& x : solid.vertices) {
      for (int i = 0; i < 3; ++i) {
        const double magnitude = std::abs(x[i]);
        inside &= (magnitude >= kLeast || magnitude == 0) && magnitude <= kLargest;  // NaN: not inside
        reach[i] = magnitude > reach[i] ? magnitude : reach[i];
      }
    }
    solid.reach = reach;
    if (!inside)
      for (const Vec3<double>& x : solid.vertices) range = worse(range, range_of(x));
  } else if (const auto* box = std::get_if<Box<double>>(&body.shape)) {
    solid.half_extents = &box->half_extents;
    range = worse(range, range_of(box->half_extents));
    if (box->half_extents.minCoeff() < 0) return {Refusal::malformed, "a half extent below zero"};
  } else if (const auto* sphere = std::get_if<Sphere<double>>(&body.shape)) {
    solid.radius = sphere->radius;
    solid.is_sphere = true;
    range = worse(range, range_of(sphere->radius));
    if (sphere->radius < 0) return {Refusal::malformed, "a radius below zero"};
  } else if (!std::holds_alternative<Point<double>>(body.shape)) {
    return {Refusal::unsupported, "a shape that the checker does not know"};
  }
  if (q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0) return {Refusal::malformed, "a zero quaternion"};
  if (range != Range::inside)
    return worst_of(range, "a NaN or an infinite number in a body",
                    "a magnitude in a body outside 1e-60 .. 1e60");

  // A point or a sphere about its own origin looks the same in every orientation.
  solid.rotated = !q.is_identity() && (solid.half_extents != nullptr || !solid.vertices.empty());
  if (solid.rotated) {
    const double largest =
        std::max(std::max(std::abs(q.w), std::abs(q.x)), std::max(std::abs(q.y), std::abs(q.z)));
    const double scale = std::scalbn(1.0, -std::ilogb(largest));
    solid.q = {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
  }
  return {};
}

[[nodiscard]] Entry read_case(const corpus::Case& problem, const Proof& proof, Solid& a, Solid& b) {
  const Vec3<double>& spin_a = problem.spin_a.rotation;
  const Vec3<double>& spin_b = problem.spin_b.rotation;
  if (!finite(spin_a) || !finite(spin_b)) return {Refusal::malformed, "a NaN or an infinite rotation"};
  if (!(problem.t_max >= 0)) return {Refusal::malformed, "t_max is NaN or below zero"};
  if (!(problem.target_distance >= 0 && problem.target_distance < kInfinity<double>))
    return {Refusal::malformed, "target_distance is NaN, infinite or below zero"};
  const Entry in_a = read_body(problem.a, a), in_b = read_body(problem.b, b);
  if (in_a.refusal == Refusal::malformed) return in_a;
  if (in_b.refusal == Refusal::malformed) return in_b;

  if (!(proof.toi_lower >= 0)) return {Refusal::malformed, "toi_lower is NaN or below zero"};
  if (!(proof.toi_upper >= 0)) return {Refusal::malformed, "toi_upper is NaN or below zero"};
  if (proof.has_axis && !finite(proof.axis)) return {Refusal::malformed, "a NaN or an infinite axis"};
  if (proof.portal_size < 0 || proof.portal_size > 4)
    return {Refusal::malformed, "a portal of a size outside 0..4"};
  for (int i = 0; i < proof.portal_size; ++i) {
    const SupportPair& s = proof.portal[static_cast<std::size_t>(i)];
    if (!finite(s.a.offset) || !finite(s.b.offset))
      return {Refusal::malformed, "a NaN or an infinite offset"};
    const bool known = in_a.refusal == Refusal::none && in_b.refusal == Refusal::none;
    if (known && (s.a.vertex >= a.vertex_count() || s.b.vertex >= b.vertex_count()))
      return {Refusal::malformed, "an index beyond the vertices of its shape"};
  }

  if (in_a.refusal == Refusal::unsupported) return in_a;
  if (in_b.refusal == Refusal::unsupported) return in_b;
  if (!spin_a.isZero(0) || !spin_b.isZero(0)) return {Refusal::unsupported, "a rotating motion"};
  if (problem.start_policy == corpus::StartPolicy::pass_over && proof.toi_upper < kInfinity<double>)
    return {Refusal::unsupported, "an upper bound under the policy pass_over, which a leaving start voids"};
  if (in_a.refusal != Refusal::none) return in_a;
  if (in_b.refusal != Refusal::none) return in_b;
  return worst_of(range_of(problem.target_distance), "", "target_distance outside 1e-60 .. 1e60");
}

// ---- the cascade ------------------------------------------------------------------------------------------

class Cascade {
 public:
  explicit Cascade(CheckCost* cost) : cost_(cost), filters_(filters_hold()) {}

  // decide.operator()<N>() tells the finding over N; `unknown` sends it on to the next arithmetic.
  template <class Decide>
  [[nodiscard]] auto run(const Decide& decide) const {
    using Finding = decltype(decide.template operator()<Dyadic>());
    if (filters_) {
      if (const auto found = decide.template operator()<Filtered>(); found != Finding::unknown) {
        if (cost_ != nullptr) ++cost_->double_decisions;
        return found;
      }
      if (const auto found = decide.template operator()<Extended>(); found != Finding::unknown) {
        if (cost_ != nullptr) ++cost_->extended_decisions;
        return found;
      }
    }
    if (cost_ != nullptr) ++cost_->exact_decisions;
    return decide.template operator()<Dyadic>();
  }

 private:
  CheckCost* cost_;
  bool filters_;
};

// |offset| <= radius
[[nodiscard]] bool offset_fits(const Cascade& cascade, const Solid& solid, const Feature& feature) {
  const Vec3<double>& x = feature.offset;
  if (!solid.is_sphere || x.isZero(0)) return x.isZero(0);
  return cascade.run([&]<class N>() {
    const N r(solid.radius);
    const Triple<N> offset = triple<N>(x);
    return at_most_zero(sign(dot(offset, offset) - r * r));
  }) == Answer::yes;
}

// ---- messages ---------------------------------------------------------------------------------------------

[[nodiscard]] std::string text(double x) {
  char buffer[80];
  std::snprintf(buffer, sizeof buffer, "%a (%.17g)", x, x);
  return buffer;
}

// About h(n), n.v and h(n) / (n.v), to some 15 digits.
struct AxisValues {
  double support, approach, bound;
};
[[nodiscard]] AxisValues axis_values(const AxisQuestion& ask) {
  Scans every_vertex;
  const Pair<Dyadic> pair(ask.a, ask.b);
  const Triple<Dyadic> n = triple<Dyadic>(ask.n);
  const double radius = ask.a.radius + ask.b.radius + ask.target_distance;
  const double support =
      Dyadic::ratio(weighted_support(ask, pair, n, every_vertex), pair.weight) + radius * ask.n.stableNorm();
  const double approach = Dyadic::ratio(dot(n, pair.velocity), Dyadic(1));
  return {support, approach, support / approach};
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
    case Refusal::portal_missing:
      return "portal_missing";
    case Refusal::portal_off_path:
      return "portal_off_path";
    case Refusal::upper_not_proved:
      return "upper_not_proved";
  }
  return "unknown refusal";
}

Verdict check_proof(const corpus::Case& problem, const Proof& proof, CheckCost* cost) {
  Solid a, b;
  if (const Entry entry = read_case(problem, proof, a, b); entry.refusal != Refusal::none)
    return {entry.refusal, entry.reason};
  const Cascade cascade(cost);

  for (int i = 0; i < proof.portal_size; ++i) {
    const SupportPair& s = proof.portal[static_cast<std::size_t>(i)];
    if (!offset_fits(cascade, a, s.a) || !offset_fits(cascade, b, s.b))
      return {Refusal::offset_too_long, "the offset of portal pair " + std::to_string(i) +
                                            " is longer than its sphere's radius (0: no sphere)"};
  }

  if (proof.toi_lower > 0) {
    if (!proof.has_axis || proof.axis.isZero(0))
      return {Refusal::axis_missing, "toi_lower " + text(proof.toi_lower) + " needs a non-zero axis"};
    const AxisQuestion ask{a, b, proof.axis, problem.target_distance};
    Scans scans;
    const bool claims_miss = proof.toi_lower == kInfinity<double>;
    const AxisFinding found = cascade.run([&]<class N>() {
      return claims_miss ? miss_claim<N>(ask, problem.t_max, scans)
                         : lower_claim<N>(ask, proof.toi_lower, scans);
    });
    if (found != AxisFinding::holds) {
      const AxisValues values = axis_values(ask);
      if (claims_miss)
        return {Refusal::miss_not_proved, "a miss needs h(n) < min(0, T n.v); h(n) is about " +
                                              text(values.support) + ", n.v about " + text(values.approach)};
      if (found == AxisFinding::not_approaching)
        return {Refusal::axis_not_approaching,
                "a finite toi_lower needs n.v < 0; n.v is about " + text(values.approach)};
      return {Refusal::lower_not_proved,
              "toi_lower " + text(proof.toi_lower) + " exceeds h(n)/(n.v), about " + text(values.bound)};
    }
  }

  if (proof.toi_upper < kInfinity<double>) {
    if (proof.portal_size == 0)
      return {Refusal::portal_missing, "toi_upper " + text(proof.toi_upper) + " needs a portal"};
    const double end = std::min(problem.t_max, proof.toi_upper);
    const PortalQuestion ask{a, b, proof, end, problem.target_distance};
    const PortalFinding found = cascade.run([&]<class N>() { return PortalClaim<N>(ask).decide(); });
    if (found == PortalFinding::off_path)
      return {
          Refusal::portal_off_path,
          "no convex combination of the portal's pairs lies on the path's line (within the target distance)"};
    if (found != PortalFinding::holds)
      return {Refusal::upper_not_proved, "the portal meets the path's line, but not for any s in [0, " +
                                             text(end) + "], the least of T and toi_upper"};
  }
  return {};
}

}  // namespace graze::oracle
