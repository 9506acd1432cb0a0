// The cast of a point in tier exact.
//
// The clips decide what is beyond their predicate_error. For a hit of a box or a triangle the facet's corners are then
// known, and the time agrees with the exact tier (search/exact/meeting.hpp) to the last bit. The exact walk decides the
// open cases and provides every proof. The time at an ellipsoid, a cylinder or a cone is the root of a quadratic
// (search/exact/solid_ray.hpp), and the clip's misses and starts save that.
#pragma once

#include <graze/detail/casts/exact_answer_cast.hpp>
#include <graze/detail/casts/ray_cast.hpp>
#include <graze/detail/search/exact/solid_ray.hpp>
#include <graze/detail/search/exact/solid_ray_bracket.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// Three corners of the facet, around the point of the hit, with e x f along v (search/exact/facet.hpp).
struct RayFacet {
  bool known = false;
  std::array<std::uint32_t, 3> corner{};
};

// The corner of the face that is nearest to the point, and its two neighbours: the triangle holds a quarter of the face.
// The point is inside of the face by the slack of box.hpp.
[[nodiscard]] inline RayFacet facet_of_box(const Triple& h, const Ray& ray, const RayHit& hit, bool of_a) {
  const int i = hit.n.x != 0 ? 0 : hit.n.y != 0 ? 1 : 2, j = (i + 1) % 3, k = (i + 2) % 3;
  const double slack = 1.01 * ray.predicate_error * sum(magnitude(ray.w)) / std::abs(ray.w[i]);
  RayFacet out;
  out.known = h[j] - std::abs(hit.x[j]) > slack && h[k] - std::abs(hit.x[k]) > slack;
  const auto bit = [&](int axis) {
    return std::uint32_t{!std::signbit(axis == i ? hit.n[i] : hit.x[axis])} << axis;
  };
  const std::uint32_t first = bit(0) | bit(1) | bit(2);
  out.corner = {first, first ^ (1u << j), first ^ (1u << k)};
  // The steps are -2 sign_j h_j and -2 sign_k h_k: their product points along sign_j sign_k of axis i.
  const bool along = (bit(j) != 0) == (bit(k) != 0), outward = along == (bit(i) != 0);
  if (outward == of_a) std::swap(out.corner[1], out.corner[2]);
  return out;
}

// False: nothing is claimed. The bodies have passed validate().
template <Scalar S>
[[nodiscard, gnu::noinline]] bool clip_cast_exactly(const Body<S>& a, const Body<S>& b,
                                                    const CastOptions<S>& options, CastResult<S>& out) {
  const bool of_a = std::holds_alternative<Point<S>>(b.shape);
  const RayTarget<S> target(of_a ? a : b);
  const RayPath<S> path = path_of(of_a ? b : a, options);
  RayHit hit;
  clip_polytope(target, path, hit);
  RayFacet found;
  switch (hit.kind) {
    case RayHit::Kind::open:
      return false;
    case RayHit::Kind::start:
      out.outcome = Outcome::initially_overlapping;
      out.toi_lower = out.toi_upper = 0;
      return true;
    case RayHit::Kind::miss:
      out.outcome = Outcome::miss;
      out.toi_lower = out.toi_upper = kInfinity<S>;
      return true;
    case RayHit::Kind::hit:
      break;
  }
  if (const auto* box = std::get_if<Box<S>>(&target.body().shape)) {
    const Triple h = triple(box->half_extents);
    found = facet_of_box(h, target.ray(path.origin, path.displacement, sum(h), path.t_max), hit, of_a);
  } else {
    const auto& triangle = std::get<Triangle<S>>(target.body().shape);
    const Triple first = triple(triangle.a),
                 outward = cross(triple(triangle.b) - first, triple(triangle.c) - first);
    found = {true, {0, 1, 2}};
    if ((dot(outward, hit.n) > 0) == of_a) std::swap(found.corner[1], found.corner[2]);
  }
  if (!found.known) return false;
  exact::Answer answer;
  answer.passage = exact::Passage::ahead;
  std::array<exact::Vertex, 3>& c = answer.facet.corner;
  for (std::size_t i = 0; i < 3; ++i)
    c[i] = of_a ? exact::Vertex{found.corner[i], 0} : exact::Vertex{0, found.corner[i]};
  answer.facet.size = 3;
  answer.facet.c0 = c[0];
  answer.facet.f1 = exact::Term::difference(c[0], c[1]);
  answer.facet.f2 = exact::Term::difference(c[0], c[2]);
  exact::PassageSearch<S> search(a, b, out.counters);
  if (!search.scene().valid()) return false;
  exact::answer_cast(search, answer, options, out);
  return true;
}

// A point against an ellipsoid, a cylinder or a cone, without a target distance.
template <Scalar S>
[[nodiscard]] bool is_solid_ray(const Body<S>& a, const Body<S>& b, S target_distance) {
  const auto is_point = [](const Body<S>& body) { return std::holds_alternative<Point<S>>(body.shape); };
  return !(target_distance > 0) &&
         ((is_point(b) && exact::is_quadric(a.shape)) || (is_point(a) && exact::is_quadric(b.shape)));
}

template <Scalar S>
void fill_solid_contact(const Body<S>& a, const Body<S>& b, const exact::SolidContact& contact,
                        const CastOptions<S>& options, CastResult<S>& out) {
  const bool point_is_b = std::holds_alternative<Point<S>>(b.shape);
  out.outcome = Outcome::hit;
  out.toi_lower = round_down<S>(contact.toi.lower);
  out.toi_upper = round_up<S>(contact.toi.upper);
  const Vec3<double> v = wide(b.displacement) - wide(a.displacement);
  out.distance = static_cast<S>((double(out.toi_upper) - double(out.toi_lower)) * norm(v));
  if (asks_for(options.request, Request::normal)) {
    const Vec3<double>& n = contact.normal;
    out.normal = (point_is_b ? n : Vec3<double>(-n)).template cast<S>();
  }
  if (!asks_for(options.request, Request::witnesses)) return;
  const Body<S>&solid = point_is_b ? a : b, &point = point_is_b ? b : a;
  const double t = double(out.toi_lower);
  (point_is_b ? out.point_a : out.point_b) =
      RayTarget<S>(solid).placed(triple(contact.point), t).vector().template cast<S>();
  (point_is_b ? out.point_b : out.point_a) =
      (triple(point.position) + t * triple(point.displacement)).vector().template cast<S>();
}

// What the answer claims. Neither claim needs an axis or a portal (proof.hpp).
template <Scalar S>
void prove_solid_ray(const CastOptions<S>& options, const exact::TimeBracket& toi, CastResult<S>& out) {
  if (!asks_for(options.request, Request::proof) || out.passed_over) return;
  Proof proof;
  if (out.outcome == Outcome::miss) proof.toi_lower = kInfinity<double>;
  if (out.outcome == Outcome::initially_overlapping) proof.toi_upper = 0;
  if (out.outcome == Outcome::hit) {
    proof.toi_lower = toi.lower;
    proof.toi_upper = toi.upper;
  }
  out.proof = under_policy(proof, options.start_policy);
}

template <Scalar S>
[[gnu::noinline]] void cast_solid_ray(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options,
                                      CastResult<S>& out) {
  const bool point_is_b = std::holds_alternative<Point<S>>(b.shape);
  const Body<S>&solid = point_is_b ? a : b, &point = point_is_b ? b : a;
  const auto set = [&](bool starts) {
    out.outcome = starts ? Outcome::initially_overlapping : Outcome::miss;
    out.toi_lower = out.toi_upper = starts ? S(0) : kInfinity<S>;
  };
  RayHit hit;
  clip_solid(RayTarget<S>(solid), path_of(point, options), hit);
  set(hit.kind == RayHit::Kind::start);
  exact::SolidContact contact;
  if (hit.kind == RayHit::Kind::hit) contact = exact::SolidRayBracket(solid, point).prove(hit.t);
  if (contact.proved && contact.toi.upper <= double(options.t_max)) {
    fill_solid_contact(a, b, contact, options, out);
  } else if (hit.kind == RayHit::Kind::hit || hit.kind == RayHit::Kind::open) {
    ++out.counters.exact_decisions;
    exact::SolidRay ray(solid, point);
    if (ray.touches_at_start()) {
      out.passed_over = options.start_policy == StartPolicy::pass_over && ray.leaves_or_slides();
      set(!out.passed_over);
    } else if (ray.first_contact(double(options.t_max), contact)) {
      fill_solid_contact(a, b, contact, options, out);
    }
    if (!ray.valid()) {
      out = {};
      exact::refuse_as_too_complex(out);
      return;
    }
  }
  prove_solid_ray(options, contact.toi, out);
}

// The rung. A proof of a box or a triangle is left to the exact walk.
template <Scalar S>
bool ray_exact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  if (is_solid_ray(a, b, options.target_distance)) {
    cast_solid_ray(a, b, options, out);
  } else if (asks_for(options.request, Request::proof) || !clip_cast_exactly(a, b, options, out)) {
    return false;
  }
  out.method = Method::exact_portal;
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
