// The axis of a proof about shapes of any kind, and its claim. A factor's points may be of any feature.
#pragma once

#include "oracles/checker/tree_point.hpp"

namespace graze::oracle {

class TreeAxis {
 public:
  TreeAxis(const TreePair& pair, const Proof& proof) : pair_(pair), proof_(proof) {
    if (!proof.has_axis || !proof.symbolic) return;
    for (std::size_t i = 0; i < proof.factor.size(); ++i) {
      const AxisFactor& factor = proof.factor[i];
      if (factor.kind != AxisFactor::Kind::difference) continue;
      for (const SupportPair* s : {&factor.from, &factor.to}) {
        ways_[i].a.emplace_back(pair.a, s->a);
        ways_[i].b.emplace_back(pair.b, s->b);
      }
    }
  }

  // Does each factor's feature hold the curved points of its way?
  [[nodiscard]] bool named() const {
    for (const FactorWays& ways : ways_)
      for (const std::vector<Way>* side : {&ways.a, &ways.b})
        for (const Way& way : *side)
          if (way.curved_count() > kCurvedParts) return false;
    return true;
  }

  // n up to a positive factor.
  template <class N>
  [[nodiscard]] Triple<N> vector() const {
    if (!proof_.symbolic) return triple<N>(proof_.axis);
    const Triple<N> n = cross(edge<N>(0), edge<N>(1));
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
    const Fraction<N> h = tree_support<N>(pair_, n, target_distance, scans);
    return decide(claims, is_zero(n), approach_along(proof_, n, velocity<N>()), [&](const N& x, bool strict) {
      const Sign s = sign(h.value - weigh(h, x));
      return strict ? is_negative(s) : at_most_zero(s);
    });
  }

 private:
  struct FactorWays {
    std::vector<Way> a, b;  // from, to (empty unless the factor is a difference)
  };

  // A factor up to a positive one, as in symbolic_axis.hpp.
  template <class N>
  [[nodiscard]] Triple<N> edge(std::size_t i) const {
    const AxisFactor& factor = proof_.factor[i];
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
  std::array<FactorWays, 2> ways_;
};

}  // namespace graze::oracle
