// Names the axis and the portal that prove an exact answer about rounded polytopes (proof.hpp). Use it after the answer
// is known: it depends on the times alone, and not on the search that found them.
//
//   lower     t = toi_lower: w(t).v < 0 and f(t) >= R^2. The axis is w(t), from the feature of K nearest to t v.
//   graze     the same with w(t).v = 0, f(t) = R^2: TOI is t. The axis is w(t), tilted in the plane of K's face by the
//             normal n_2 of the edge that the path meets first. If the whole face is on the path, n_2 is -v.
//   upper     the feature of K nearest to t v at toi_upper. If f > R^2 there, the one nearest to the path in between.
//   miss      w* of the path, which is across v unless it is met at an end of the path.
//   start     the feature of K nearest to the origin.
// Frame and units: those of round_search.hpp.
#pragma once

#include <graze/detail/search/exact/round_search.hpp>

namespace graze { inline namespace GRAZE_LINKAGE { namespace detail { namespace exact {

template <Scalar S>
class RoundClaims {
 public:
  explicit RoundClaims(RoundSearch<S>& search) : search_(search) {}

  void claim_start(Proof& out) {
    out.toi_upper = 0;
    take_portal(search_.nearest(Dyadic(), Dyadic()), out);
  }
  // For [0, t_max], or for the start alone if the bodies rest.
  void claim_miss(double t_max, Proof& out) {
    const Dyadic end = search_.moves() && t_max > 0 ? search_.end(t_max) : Dyadic();
    const std::span<const Id> corners = search_.nearest(Dyadic(), end);
    out.toi_lower = kInfinity<double>;
    take_axis(corners, corners.front().late ? near_quotient(end, Dyadic(1)) : 0, out);
  }
  // For a time of 0, nothing is claimed.
  void claim_lower(double t, Proof& out) {
    if (!(t > 0)) return;
    const std::span<const Id> corners = search_.nearest(Dyadic(t), Dyadic(t));
    out.toi_lower = t;
    take_axis(corners, t, out);
    if (search_.sign_of_rate() != 0) return;
    out.then = true;
    const std::array<Vertex, 2> edge = search_.edge_of_graze();
    out.factor[0].kind = edge[0] == edge[1] ? AxisFactor::Kind::motion : AxisFactor::Kind::difference;
    out.factor[0].from = name(edge[0]);
    out.factor[0].to = name(edge[1]);
  }
  void claim_upper(const TimeBracket& toi, Proof& out) {
    out.toi_upper = toi.upper;
    const std::span<const Id> corners = search_.nearest(Dyadic(toi.upper), Dyadic(toi.upper));
    take_portal(search_.sign_of_f() <= 0 ? corners : search_.nearest(Dyadic(toi.lower), Dyadic(toi.upper)),
                out);
  }

 private:
  using Id = typename RoundSearch<S>::Id;
  static SupportPair name_of(const Id& id) { return name(Vertex{id.a, id.b}); }

  // w has every edge of the feature across it. If v is as well, w is the foot's offset from one edge and v, or from v
  // alone, and does not depend on the time.
  void take_axis(std::span<const Id> corners, double t, Proof& out) {
    NearestAxis& axis = out.nearest;
    out.has_axis = out.symbolic = true;
    axis.pair[0] = name_of(corners[0]);
    axis.size = 1;
    axis.motion = search_.moves() && search_.sign_of_rate() == 0;
    axis.time = axis.motion ? 0 : t;
    for (const Id& id : corners.subspan(1)) {
      if (axis.motion && (axis.size == 2 || search_.is_along_motion(corners[0], id))) continue;
      axis.pair[static_cast<std::size_t>(axis.size++)] = name_of(id);
    }
  }
  // Vertices at both times are one pair.
  void take_portal(std::span<const Id> corners, Proof& out) {
    out.of_cores = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto same = [&](const Id& id) { return id.a == corners[i].a && id.b == corners[i].b; };
      if (std::none_of(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(i), same))
        out.portal[static_cast<std::size_t>(out.portal_size++)] = name_of(corners[i]);
    }
  }

  RoundSearch<S>& search_;
};

}}}}  // namespace graze::GRAZE_LINKAGE::detail::exact
