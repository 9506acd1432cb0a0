// Witnesses: from a simplex of CSO points and its weights to a world point of either body.
#pragma once

#include <graze/detail/search/robust/simplex.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail {

// A point of the body at time t, in world coordinates: x is about the side's centre, world axes, internal units.
template <Scalar Given, Scalar S>
Vec3<S> world_point(const Body<Given>& body, const Side<S>& side, const Cso<S>& cso, const Vec3<S>& x, S t) {
  Vec3<S> out = t * body.displacement.template cast<S>();
  // In double where positions are large beside the body: a combinator's centre is no number of S, either.
  if (!side.rotated) {
    out += Vec3<double>(body.position.template cast<double>() + side.center).template cast<S>();
  } else if (side.center.cwiseAbs().maxCoeff() > cso.to_length(side.reach)) {
    out += placed_center(body.position.template cast<double>(), as_double(body.orientation), side.center)
               .template cast<S>();
  } else {
    out += body.position.template cast<S>() + side.to_world(Vec3<S>(side.center.template cast<S>()));
  }
  for (int i = 0; i < 3; ++i) out[i] += cso.to_length(x[i]);
  return out;
}

// sum lambda_i (x_i of the body's core + radius e_i) at time t, in world coordinates.
template <Scalar Given, Scalar S>
Vec3<S> witness(const Body<Given>& body, const Side<S>& side, const Cso<S>& cso, const Simplex<S>& contact,
                const Vec3<S>& n, bool of_a, S t) {
  Vec3<S> own = Vec3<S>::Zero(), out = Vec3<S>::Zero();
  for (int i = 0; i < contact.size; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const CsoPoint<S>& p = contact.point[k];
    GRAZE_ASSERT(contact.lambda[k] >= 0 && contact.lambda[k] <= S(1.001));
    const Vec3<S> d = side.to_own(of_a ? p.n : Vec3<S>(-p.n));
    own += contact.lambda[k] * side.support(side, d, of_a ? &p.vertex_a : &p.vertex_b).x;
    const Vec3<S>& e = p.e == Vec3<S>::Zero() ? n : p.e;
    out += contact.lambda[k] * (of_a ? side.radius : -side.radius) * e;
  }
  return world_point(body, side, cso, Vec3<S>(out + side.to_world(own)), t);
}

}}}  // namespace graze::GRAZE_LINKAGE::detail
