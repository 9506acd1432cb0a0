// The axis of a proof about shapes of any kind, and its claim. A factor's points may be of any feature.
#pragma once

#include "oracles/checker/tree_point.hpp"

namespace graze::oracle {

class TreeAxis {
 public:
  TreeAxis(const TreePair& pair, const Proof& proof)
      : pair_(pair), proof_(proof), factors_(factors_of(proof)) {
    if (is_nearest(proof)) add(ways_[kFoot], proof.nearest.pair[0]);
    for (std::size_t i = 0; i < factors_.size; ++i) add_steps(i);
    if (!is_tilted(proof)) return;
    factors_.at[kThen] = proof.factor[0];
    add_steps(kThen);
  }
  TreeAxis(const TreeAxis&) = delete;
  TreeAxis& operator=(const TreeAxis&) = delete;

  // Does each factor's feature hold the curved points of its way?
  [[nodiscard]] bool named() const {
    for (const FactorWays& ways : ways_)
      for (const std::vector<Way>* side : {&ways.a, &ways.b})
        for (const Way& way : *side)
          if (way.curved_count() > kCurvedParts) return false;
    return true;
  }

  // n up to a positive factor, not tilted.
  template <class N>
  [[nodiscard]] Triple<N> vector() const {
    if (!proof_.symbolic) return triple<N>(proof_.axis);
    const auto across = [&] { return cross(edge<N>(0), edge<N>(1)); };
    if (is_nearest(proof_)) {
      const PortalPoints<N> foot = portal_points<N>(pair_, ways_[kFoot].a, ways_[kFoot].b);
      const Triple<N> path = foot.weigh(scaled(N(proof_.nearest.time), velocity<N>()));
      return less_foot(
          path - foot.at[0], factors_.size, [&] { return edge<N>(0); }, across);
    }
    const Triple<N> n = across();
    return proof_.axis_sign < 0 ? -n : n;
  }
  template <class N>
  [[nodiscard]] Triple<N> velocity() const {
    return difference<N>(pair_.body_b.displacement, pair_.body_a.displacement);
  }

  template <class N>
  [[nodiscard]] AxisFindings findings(double target_distance, const LowerClaims& claims,
                                      TreeScans& scans) const {
    const Triple<N> n = vector<N>();
    const Fraction<N> h = tree_support<N>(pair_, n, root(dot(n, n)), target_distance, scans);
    return decide(claims, is_zero(n), approach_along(proof_, n, velocity<N>()), [&](const N& x, bool strict) {
      const Sign s = sign(h.value - weigh(h, x));
      return strict ? is_negative(s) : at_most_zero(s);
    });
  }
  // The same for a nearest axis, without roots: for polytopes plus a ball.
  template <class N>
  [[nodiscard]] AxisFindings nearest_findings(double target_distance, const LowerClaims& claims,
                                              TreeScans& scans) const {
    const Triple<N> plain = vector<N>();
    const Triple<N> n = tilted(proof_, plain, velocity<N>(), [&] { return edge<N>(kThen); });
    const Fraction<N> high = tree_support<N>(pair_, n, N(0), 0, scans);
    const bool rounded = target_distance > 0 || pair_.a.has_ball() || pair_.b.has_ball();
    const auto radius = [&] {
      return weigh(high, pair_.a.template ball<N>() + pair_.b.template ball<N>() + N(target_distance));
    };
    return decide(claims, is_zero(plain), approach_along(proof_, n, velocity<N>()),
                  [&](const N& x, bool strict) {
                    return below_zero(rounded, radius, n, high.value - weigh(high, x), strict);
                  });
  }

 private:
  struct FactorWays {
    std::vector<Way> a, b;  // from, to (empty unless the factor is a difference)
  };
  // Besides the factors: the one of a tilted axis, and a nearest axis's first pair.
  static constexpr std::size_t kThen = 2, kFoot = 3;

  void add(FactorWays& ways, const SupportPair& s) {
    ways.a.emplace_back(pair_.a, s.a);
    ways.b.emplace_back(pair_.b, s.b);
  }
  void add_steps(std::size_t i) {
    if (factors_.at[i].kind != AxisFactor::Kind::difference) return;
    add(ways_[i], factors_.at[i].from);
    add(ways_[i], factors_.at[i].to);
  }

  // A factor up to a positive one, as in symbolic_axis.hpp.
  template <class N>
  [[nodiscard]] Triple<N> edge(std::size_t i) const {
    const AxisFactor& factor = factors_.at[i];
    if (factor.kind == AxisFactor::Kind::given) return triple<N>(factor.given);
    if (factor.kind == AxisFactor::Kind::motion) return velocity<N>();
    const bool moves_a = differ(factor.from.a, factor.to.a), moves_b = differ(factor.from.b, factor.to.b);
    const bool offset = has_offset(factor);
    if (!moves_b && !offset) return path(Places<N>(ways_[i].a));
    if (!moves_a && !offset) return -path(Places<N>(ways_[i].b));
    const Places<N> a(ways_[i].a), b(ways_[i].b);
    const auto weighed = [](const Places<N>& by, const Triple<N>& x) {
      return by.weighted ? scaled(by.weight, x) : x;
    };
    return weighed(a, weighed(b, offset_difference<N>(factor))) + weighed(b, path(a)) - weighed(a, path(b));
  }
  [[nodiscard]] static bool differ(const Feature& from, const Feature& to) {
    return from.vertex != to.vertex || from.curved != to.curved;
  }
  template <class N>
  [[nodiscard]] static Triple<N> path(const Places<N>& places) {
    return places.at[1] - places.at[0];
  }

  const TreePair& pair_;
  const Proof& proof_;
  Factors factors_;
  std::array<FactorWays, 4> ways_;
};

}  // namespace graze::oracle
