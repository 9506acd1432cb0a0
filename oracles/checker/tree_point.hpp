// The points that a proof names on shapes of any kind: whether they exist, and where they are, computed
// without division.
//
// The index of a vertex is read as core/graze/shape.hpp writes it. For a sum it is in mixed radix, the last
// part fastest. For a hull, the parts' vertices follow one after the other. The way to a vertex goes through
// all parts of a sum and one of a hull. A point of the way's curved parts is taken from the feature, in their
// order.
#pragma once

#include "oracles/checker/portal_claim.hpp"
#include "oracles/checker/tree_support.hpp"

namespace graze::oracle {

// Is x in the ellipsoid, cylinder or cone?
//   ellipsoid  sum (x_i / r_i)^2 <= 1 over r_i > 0, times the product of the r_i^2, and x_i = 0 where r_i = 0
//   cylinder   x^2 + y^2 <= r^2, |z| <= h
//   cone       the same, and (x^2 + y^2) (2 h)^2 <= r^2 (h - z)^2
template <class N>
[[nodiscard]] Answer inside_curved(const Part& part, const Vec3<double>& point) {
  const Vec3<double>& e = part.extents;
  if (part.kind == PartKind::ellipsoid) {
    N sum(0), product(1);
    for (int i = 0; i < 3; ++i) {
      const N x(point[i]), r(e[i]);
      if (e[i] == 0) {
        if (point[i] != 0) return Answer::no;
        continue;
      }
      sum = sum * (r * r) + x * x * product;
      product = product * (r * r);
    }
    return at_most_zero(sign(sum - product));
  }
  const N x(point.x()), y(point.y()), r(e.x());
  const N across_sq = x * x + y * y, r_sq = r * r;
  if (std::abs(point.z()) > e.y()) return Answer::no;
  const Answer in_cylinder = at_most_zero(sign(across_sq - r_sq));
  if (part.kind == PartKind::cylinder || in_cylinder == Answer::no) return in_cylinder;
  const N h(e.y()), height = h + h, below = h - N(point.z());
  return both(in_cylinder, at_most_zero(sign(across_sq * (height * height) - r_sq * (below * below))));
}

// A feature's way through a tree.
class Way {
 public:
  Way(const PartTree& tree, const Feature& feature) : tree_(tree), feature_(feature) {
    go(0, feature.vertex);
  }

  // The number of curved parts on the way. The feature has points for kCurvedParts of them.
  [[nodiscard]] std::size_t curved_count() const { return curved_.size(); }
  [[nodiscard]] const Part& curved(std::size_t k) const { return *curved_[k]; }
  [[nodiscard]] const Feature& feature() const { return feature_; }
  // The radii of the spheres, capsules and roundings on the way.
  [[nodiscard]] const std::vector<double>& radii() const { return radii_; }

  // |offset| <= the sum of the radii met
  template <class N>
  [[nodiscard]] Answer offset_fits() const {
    N room(0);
    for (const double radius : radii_) room = room + N(radius);
    const Triple<N> offset = triple<N>(feature_.offset);
    return at_most_zero(sign(dot(offset, offset) - room * room));
  }

  // The same rotations in the same order, so that the weights of the two points are equal.
  [[nodiscard]] bool turns_like(const Way& other) const { return turns_ == other.turns_; }

  // w (x - position of the body), without the offset, and w.
  template <class N>
  struct Place {
    Triple<N> at;
    bool weighted = false;
    N weight = N(1);
  };
  template <class N>
  [[nodiscard]] Place<N> place() const {
    std::size_t curved = 0;
    return place_at<N>(0, feature_.vertex, curved);
  }

 private:
  // The children on the way, each with its own index: visit(child, index).
  template <class Visit>
  void branch(const Part& part, std::uint64_t index, const Visit& visit) const {
    if (part.kind == PartKind::hull_of) {
      for (std::size_t k = part.first_child; k != Part::kNone; k = tree_[k].next) {
        if (index < tree_[k].vertices) return visit(k, index);
        index -= tree_[k].vertices;
      }
      return;
    }
    // Mixed radix from the first part on: the product of the counts after it is what it counts in.
    for (std::size_t k = part.first_child; k != Part::kNone; k = tree_[k].next) {
      std::uint64_t after = 1;
      for (std::size_t l = tree_[k].next; l != Part::kNone; l = tree_[l].next)
        after = std::min(after * tree_[l].vertices, Part::kManyVertices);
      visit(k, index / after);
      index %= after;
    }
  }

  void go(std::size_t i, std::uint64_t index) {
    const Part& part = tree_[i];
    if (part.is_curved()) curved_.push_back(&part);
    if (part.leaf.radius > 0) radii_.push_back(part.leaf.radius);
    if (part.rotated) turns_.push_back(&part);
    branch(part, index, [this](std::size_t k, std::uint64_t below) { go(k, below); });
  }

  template <class N>
  [[nodiscard]] Place<N> place_at(std::size_t i, std::uint64_t index, std::size_t& curved) const {
    const Part& part = tree_[i];
    if (part.kind == PartKind::leaf) return {triple<N>(part.leaf.core.vertex(index))};
    if (part.is_curved()) return {triple<N>(feature_.curved[curved++])};
    Place<N> sum;
    bool first = true;
    branch(part, index, [&](std::size_t k, std::uint64_t below) {
      const Place<N> more = place_at<N>(k, below, curved);
      if (first) {
        sum = more;
      } else {
        sum.at = weighed(more, sum.at) + weighed(sum, more.at);
        if (more.weighted) sum.weight = sum.weighted ? sum.weight * more.weight : more.weight;
        sum.weighted |= more.weighted;
      }
      first = false;
    });
    if (part.kind != PartKind::posed) return sum;
    if (part.rotated) {
      const Frame<N> frame(true, part.q);
      sum.at = {dot(frame.row_x, sum.at), dot(frame.row_y, sum.at), dot(frame.row_z, sum.at)};
      sum.weight = sum.weighted ? sum.weight * frame.weight : frame.weight;
      sum.weighted = true;
    }
    if (!part.position.isZero(0)) sum.at = sum.at + weighed(sum, triple<N>(part.position));
    return sum;
  }

 public:
  template <class N>
  [[nodiscard]] static Triple<N> weighed(const Place<N>& by, const Triple<N>& x) {
    return by.weighted ? scaled(by.weight, x) : x;
  }

 private:
  const PartTree& tree_;
  const Feature& feature_;
  std::vector<const Part*> curved_, turns_;
  std::vector<double> radii_;
};

// The places of a body's features, brought to one weight.
template <class N>
struct Places {
  std::vector<Triple<N>> at;
  bool weighted = false;
  N weight = N(1);

  explicit Places(const std::vector<Way>& ways) {
    std::vector<Way::Place<N>> places;
    for (const Way& way : ways) places.push_back(way.place<N>());
    const auto first_of_its_weight = [&](std::size_t k) {
      for (std::size_t l = 0; l < k; ++l)
        if (ways[l].turns_like(ways[k])) return false;
      return places[k].weighted;
    };
    for (std::size_t k = 0; k < ways.size(); ++k) {
      if (!first_of_its_weight(k)) continue;
      weight = weighted ? weight * places[k].weight : places[k].weight;
      weighted = true;
    }
    for (std::size_t i = 0; i < ways.size(); ++i) {
      Triple<N> x = places[i].at;
      for (std::size_t k = 0; k < ways.size(); ++k)
        if (first_of_its_weight(k) && !ways[k].turns_like(ways[i])) x = scaled(places[k].weight, x);
      at.push_back(x);
    }
  }
};

template <class N>
[[nodiscard]] PortalPoints<N> portal_points(const TreePair& pair, const std::vector<Way>& ways_a,
                                            const std::vector<Way>& ways_b) {
  const Places<N> a(ways_a), b(ways_b);
  PortalPoints<N> points;
  points.size = static_cast<int>(ways_a.size());
  points.weighted = a.weighted || b.weighted;
  if (points.weighted) points.weight = a.weight * b.weight;
  const Triple<N> between = difference<N>(pair.body_a.position, pair.body_b.position);
  for (std::size_t i = 0; i < ways_a.size(); ++i) {
    const Triple<N> offset = between + difference<N>(ways_a[i].feature().offset, ways_b[i].feature().offset);
    points.at[i] = points.weigh(offset) + (b.weighted ? scaled(b.weight, a.at[i]) : a.at[i]) -
                   (a.weighted ? scaled(a.weight, b.at[i]) : b.at[i]);
  }
  return points;
}

}  // namespace graze::oracle
