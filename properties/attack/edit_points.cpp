// Changes of the features that a proof names: vertices and points of curved parts in contacts, portals and the factors
// of a symbolic axis. Also changes of the weights and the crossing of a contact.
#include <algorithm>
#include <cmath>

#include "properties/attack/mutant.hpp"
#include "properties/edit/shape.hpp"

namespace graze::attack {

using corpus::Case;
using corpus::Random;

namespace {

double small_part(Random& random) { return std::scalbn(1.0, -random.integer(2, 40)); }

Feature any_feature(const Body<double>& body, Random& random) {
  Feature feature;
  // One beyond the last is malformed, and must be found to be.
  const std::uint64_t beyond = random.once_in(64) ? 1 : 0;
  feature.vertex = static_cast<std::uint32_t>(
      random.below(std::clamp<std::uint64_t>(law::vertex_count(body.shape), 1, 1u << 20) + beyond));
  return feature;
}
SupportPair any_pair(const Case& problem, Random& random) {
  return {any_feature(problem.a, random), any_feature(problem.b, random)};
}

void edit_feature(Feature& feature, const Body<double>& body, Random& random) {
  const bool curved = std::any_of(feature.curved.begin(), feature.curved.end(),
                                  [](const Vec3<double>& x) { return !x.isZero(0); });
  if (curved && !random.once_in(4)) {
    Vec3<double>& x = feature.curved[random.below(kCurvedParts)];
    if (random.once_in(2)) {
      x *= 1 - small_part(random);
    } else {
      double& one = x[random.integer(0, 2)];
      one = beside(one, random);
    }
  } else if (!feature.offset.isZero(0) && random.once_in(2)) {
    // Within its ball or out of it, or to another point about as far out.
    if (random.once_in(4)) {
      std::swap(feature.offset[0], feature.offset[random.integer(1, 2)]);
    } else {
      feature.offset *= random.once_in(2) ? 1 - small_part(random) : 1 + small_part(random);
    }
  } else if (random.once_in(8)) {
    for (int i = 0; i < 3; ++i) feature.offset[i] += random.integer(-1, 1) * small_part(random);
  } else {
    feature.vertex = any_feature(body, random).vertex;
  }
}

void edit_pair(SupportPair& pair, const Case& problem, Random& random) {
  if (random.once_in(2)) {
    edit_feature(pair.a, problem.a, random);
  } else {
    edit_feature(pair.b, problem.b, random);
  }
}

void edit_nearest(Proof& proof, const Case& problem, Random& random) {
  NearestAxis& nearest = proof.nearest;
  const auto size = static_cast<std::size_t>(nearest.size);
  switch (random.below(4)) {
    case 0:
      edit_pair(nearest.pair[random.below(size)], problem, random);
      break;
    case 1:
      if (size < 3) nearest.pair[static_cast<std::size_t>(nearest.size++)] = any_pair(problem, random);
      break;
    case 2:
      if (size > 1) --nearest.size;
      break;
    default:
      edit_pair(random.once_in(2) ? proof.factor[0].from : proof.factor[0].to, problem, random);
      break;
  }
}

void edit_index(Proof& proof, const Case& problem, Random& random) {
  if (proof.has_axis && proof.symbolic && proof.nearest.size > 0 && random.once_in(2)) {
    edit_nearest(proof, problem, random);
    return;
  }
  if (proof.has_axis && proof.symbolic && random.once_in(2)) {
    AxisFactor& factor = proof.factor[random.below(2)];
    if (factor.kind == AxisFactor::Kind::difference)
      edit_pair(random.once_in(2) ? factor.from : factor.to, problem, random);
    return;
  }
  const auto size = static_cast<std::size_t>(proof.portal_size);
  if (size > 0 && (size == 4 || random.once_in(2))) {
    edit_pair(proof.portal[random.below(size)], problem, random);
  } else if (size < 4) {
    proof.portal[size] = any_pair(problem, random);
    ++proof.portal_size;
  }
  if (random.once_in(16)) proof.of_cores = !proof.of_cores;
}

void edit_index(RotatingProof& proof, const Case& problem, Random& random) {
  const auto size = static_cast<std::size_t>(proof.contact_size);
  if (size > 0 && (size == kContactPairs || proof.crossing || random.once_in(2))) {
    edit_pair(proof.contact[random.below(size)], problem, random);
  } else if (size < kContactPairs) {
    // With some weight or with none, when it is not read.
    proof.contact[size] = any_pair(problem, random);
    proof.weight[size] = small_part(random) * small_part(random);
    ++proof.contact_size;
  }
}

void edit_weights(RotatingProof& proof, Random& random) {
  switch (random.below(6)) {
    case 0:
      proof.crossing = !proof.crossing;
      proof.contact_from = proof.toi_upper * random.unit();
      break;
    case 1:
      if (proof.crossing) proof.contact_from *= 1 - small_part(random);
      break;
    case 2:
      if (proof.crossing) proof.contact_from += (proof.toi_upper - proof.contact_from) * small_part(random);
      break;
    default: {
      if (proof.contact_size < 1) return;
      double& weight = proof.weight[random.below(static_cast<std::uint64_t>(proof.contact_size))];
      weight = random.once_in(8) ? 0 : weight == 0 ? small_part(random) : beside(weight, random);
      break;
    }
  }
}

}  // namespace

void edit_named_points(corpus::ProofRecord& record, Edit kind, Random& random) {
  if (record.rotating) {
    if (!(record.rotating->toi_upper < kInfinity<double>)) return;
    if (kind == Edit::weights) {
      edit_weights(*record.rotating, random);
    } else {
      edit_index(*record.rotating, record.problem, random);
    }
  } else if (kind == Edit::index) {
    edit_index(record.proof, record.problem, random);
  }
}

}  // namespace graze::attack
