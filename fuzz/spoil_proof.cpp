#include "fuzz/spoil_proof.hpp"

#include <cmath>

#include "properties/edit/shape.hpp"

namespace graze::fuzz {

namespace {

using corpus::Case;
using corpus::Random;

class Spoiler {
 public:
  Spoiler(const Case& problem, Random& random) : problem_(problem), random_(random) {}

  void spoil(Proof& proof) {
    switch (random_.below(8)) {
      case 0:
        proof.toi_lower = bound(proof.toi_lower, proof.toi_upper, kInfinity<double>);
        break;
      case 1:
        proof.toi_upper = bound(proof.toi_upper, proof.toi_lower, 0);
        break;
      case 2:
        proof.has_axis = true;
        proof.symbolic = false;
        proof.axis = direction(proof.axis);
        break;
      case 3:
        symbolic(proof);
        break;
      case 4:
        if (proof.portal_size > 0)
          pair(proof.portal[random_.below(static_cast<std::size_t>(proof.portal_size))]);
        break;
      case 5:
        if (random_.once_in(3)) {
          proof.of_cores = !proof.of_cores;
        } else {
          proof.portal_size = random_.integer(0, 4);
        }
        break;
      case 6:
        if (proof.portal_size < 4) {
          proof.portal[static_cast<std::size_t>(proof.portal_size)] = any_pair();
          ++proof.portal_size;
        }
        break;
      default:
        // Both at once: a bracket on the other side of the truth.
        proof.toi_lower = number(proof.toi_lower);
        proof.toi_upper = number(proof.toi_lower);
        break;
    }
  }

  void spoil(RotatingProof& proof) {
    const bool chained = !proof.chain.empty();
    switch (random_.below(9)) {
      case 0:
        proof.toi_lower = bound(proof.toi_lower, proof.toi_upper, kInfinity<double>);
        break;
      case 1:
        proof.toi_upper = bound(proof.toi_upper, proof.toi_lower, 0);
        break;
      case 2:
        // The chain and its claim, a little longer.
        if (chained) {
          proof.chain.back().end = number(proof.chain.back().end);
          if (!random_.once_in(3)) proof.toi_lower = proof.chain.back().end;
        }
        break;
      case 3:
        if (chained) slice(proof).axis = direction(slice(proof).axis);
        break;
      case 4:
        if (chained) slice(proof).frame = static_cast<AxisFrame>(random_.below(3));
        break;
      case 5:
        if (chained)
          proof.chain.erase(proof.chain.begin() +
                            static_cast<std::ptrdiff_t>(random_.below(proof.chain.size())));
        break;
      case 6:
        proof.contact_size = random_.integer(0, kContactPairs);
        for (double& w : proof.weight) w = random_.once_in(2) ? w : random_.integer(-1, 3);
        break;
      case 7:
        pair(proof.contact[random_.below(kContactPairs)]);
        break;
      default:
        proof.crossing = !proof.crossing;
        proof.contact_from = number(proof.toi_lower);
        break;
    }
    if (proof.chain.empty() && random_.once_in(2)) {
      proof.chain.push_back(
          {.end = number(problem_.t_max), .axis = direction(Vec3<double>::Zero()), .frame = {}});
      proof.toi_lower = random_.once_in(2) ? kInfinity<double> : proof.chain.back().end;
    }
  }

 private:
  TimeSlice& slice(RotatingProof& proof) { return proof.chain[random_.below(proof.chain.size())]; }

  // Near x, or not.
  double number(double x) {
    switch (random_.below(6)) {
      case 0:
        return std::nextafter(x, kInfinity<double>);
      case 1:
        return std::nextafter(x, -kInfinity<double>);
      case 2:
        return x + std::scalbn(static_cast<double>(random_.integer(-8, 8)), -random_.integer(0, 52));
      case 3:
        return std::scalbn(static_cast<double>(random_.integer(0, 16)), -4) *
               (std::isfinite(problem_.t_max) ? problem_.t_max : 1);
      case 4:
        return x * (1 + std::scalbn(static_cast<double>(random_.integer(-8, 8)), -random_.integer(4, 52)));
      default:
        return std::scalbn(x, random_.integer(-2, 2));
    }
  }
  // A time that claims more or less than x, by little or by a lot. It is never below 0, which is malformed.
  double bound(double x, double other, double extreme) {
    if (random_.once_in(6)) return extreme;
    if (random_.once_in(6)) return other;
    return std::abs(number(std::isfinite(x) ? x : random_.unit()));
  }

  Vec3<double> direction(Vec3<double> n) {
    if (n.isZero(0) || random_.once_in(8)) {
      for (int i = 0; i < 3; ++i) n[i] = random_.integer(-4, 4);
      return n;
    }
    switch (random_.below(4)) {
      case 0:
        return -n;
      case 1:
        return Vec3<double>(n[1], n[2], n[0]);
      default: {
        double& x = n[static_cast<int>(random_.below(3))];
        x = number(x);
        return n;
      }
    }
  }

  void symbolic(Proof& proof) {
    if (proof.symbolic && random_.once_in(2)) {
      proof.axis_sign = -proof.axis_sign;
      return;
    }
    proof.has_axis = proof.symbolic = true;
    if (random_.once_in(proof.nearest.size > 0 ? 2 : 8)) {
      nearest(proof);
      return;
    }
    AxisFactor& factor = proof.factor[random_.below(2)];
    factor.kind = static_cast<AxisFactor::Kind>(random_.below(3));
    factor.given = direction(factor.given);
    if (random_.once_in(2)) factor.from = any_pair();
    if (random_.once_in(2)) factor.to = any_pair();
  }
  void nearest(Proof& proof) {
    NearestAxis& axis = proof.nearest;
    switch (random_.below(5)) {
      case 0:
        axis.time = number(axis.time);
        break;
      case 1:
        axis.motion = !axis.motion;
        break;
      case 2:
        proof.then = !proof.then;
        break;
      case 3:
        // Size 0 makes it a cross product. One beyond the room is malformed, and must be found to be.
        axis.size = random_.integer(0, random_.once_in(8) ? 4 : 3);
        break;
      default:
        axis.pair[random_.below(3)] = any_pair();
        axis.size = std::max(axis.size, 1);
        break;
    }
  }

  Feature any_feature(const Body<double>& body) {
    const std::uint64_t vertices = std::max<std::uint64_t>(law::vertex_count(body.shape), 1);
    // One beyond the last is malformed, and must be found to be.
    Feature feature;
    feature.vertex = static_cast<std::uint32_t>(
        random_.below(std::min<std::uint64_t>(vertices + (random_.once_in(16) ? 1 : 0), 0xffffffffu)));
    return feature;
  }
  SupportPair any_pair() { return {any_feature(problem_.a), any_feature(problem_.b)}; }

  void pair(SupportPair& pair) {
    Feature& feature = random_.once_in(2) ? pair.a : pair.b;
    const Body<double>& body = &feature == &pair.a ? problem_.a : problem_.b;
    switch (random_.below(3)) {
      case 0:
        feature.vertex = any_feature(body).vertex;
        break;
      case 1: {
        double& x = feature.offset[static_cast<int>(random_.below(3))];
        x = number(x);
        break;
      }
      default: {
        double& x = feature.curved[random_.below(kCurvedParts)][static_cast<int>(random_.below(3))];
        x = number(x);
        break;
      }
    }
  }

  const Case& problem_;
  Random& random_;
};

template <class AnyProof>
void spoil_some(AnyProof& proof, const Case& problem, Random& random) {
  Spoiler spoiler(problem, random);
  int changes = random.once_in(2) ? 1 : random.integer(2, 3);
  for (; changes > 0; --changes) spoiler.spoil(proof);
}

}  // namespace

void spoil(Proof& proof, const Case& problem, Random& random) { spoil_some(proof, problem, random); }
void spoil(RotatingProof& proof, const Case& problem, Random& random) { spoil_some(proof, problem, random); }

Proof claiming_less(Proof proof, const Case& problem, Random& random) {
  // A miss is another kind of claim than a time, and its axis need not approach.
  const double lower = proof.toi_lower;
  if (std::isfinite(lower)) {
    proof.toi_lower = random.once_in(4)   ? 0
                      : random.once_in(2) ? lower * random.unit()
                                          : std::max(0.0, std::nextafter(lower, 0));
  }
  if (std::isfinite(proof.toi_upper)) {
    const double later =
        random.once_in(2) ? std::nextafter(proof.toi_upper, kInfinity<double>) : 2 * proof.toi_upper;
    proof.toi_upper = random.once_in(4) || !(later <= problem.t_max) ? kInfinity<double> : later;
  }
  // Without a lower bound a start that leaves would void the upper one.
  const bool needs_lower = problem.start_policy == StartPolicy::pass_over && std::isfinite(proof.toi_upper);
  if (needs_lower && !(proof.toi_lower > 0)) proof.toi_lower = lower;
  return proof;
}

}  // namespace graze::fuzz
