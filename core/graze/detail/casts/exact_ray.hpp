// The cast of a point at a box or a triangle in tier exact, where doubles know the facet that is met.
//
// The clips decide what is beyond their predicate_error. For a hit the facet's corners are then known, and the time
// agrees with the exact tier (search/exact/meeting.hpp) to the last bit. The exact walk decides the open cases and
// provides every proof.
#pragma once

#include <graze/detail/casts/exact_answer_cast.hpp>
#include <graze/detail/casts/ray_cast.hpp>

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

// The rung: for boxes and triangles, unless a proof is requested.
template <Scalar S>
bool ray_exact(const Body<S>& a, const Body<S>& b, const CastOptions<S>& options, CastResult<S>& out) {
  if (!is_ray(a, b) || asks_for(options.request, Request::proof) || !clip_cast_exactly(a, b, options, out))
    return false;
  out.method = Method::exact_portal;
  return true;
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
