// A shape of any kind as a list of parts, read and checked once. Later walks therefore cannot meet a part
// without a shape, an endless cycle, or a number out of range.
//
// Part 0 is the body's own pose about its origin. A part comes before its children, which are linked as first
// child and next sibling. A part that is shared in the shape is listed each time it is met.
#pragma once

#include <vector>

#include "oracles/checker/read_shape.hpp"

namespace graze::oracle {

// Depth and size of a tree that the checker reads. A larger tree is unsupported. They bound the recursion of
// every walk (a frame holds some ten numbers), and the work: shared parts can make 2^n paths of n nodes.
inline constexpr int kDeepestPart = 64;
inline constexpr std::size_t kMostParts = 4096;

enum class PartKind { leaf, ellipsoid, cylinder, cone, posed, rounded, sum, hull_of };

struct Part {
  static constexpr std::size_t kNone = ~std::size_t{0};
  // Counts of vertices stop here: an index of a feature is always below.
  static constexpr std::uint64_t kManyVertices = std::uint64_t{1} << 32;

  PartKind kind = PartKind::leaf;
  Leaf leaf;                                     // leaf, or the radius of a rounded part
  Vec3<double> extents = Vec3<double>::Zero();   // ellipsoid: radii, others: radius, half height, 0
  Vec3<double> position = Vec3<double>::Zero();  // posed
  bool rotated = false;
  Quaternion<double> q = {};   // scaled, unused unless rotated
  std::uint64_t vertices = 1;  // at most kManyVertices
  std::size_t first_child = kNone, next = kNone;

  [[nodiscard]] bool is_curved() const {
    return kind == PartKind::ellipsoid || kind == PartKind::cylinder || kind == PartKind::cone;
  }
};

class PartTree {
 public:
  PartTree(const Body<double>& body, Door& door) {
    parts_.emplace_back();
    pose(0, Vec3<double>::Zero(), body.orientation, door);
    const std::size_t child = add(body.shape, 1, door);
    parts_[0].first_child = child;
    if (child != Part::kNone) parts_[0].vertices = parts_[child].vertices;
  }

  [[nodiscard]] const Part& operator[](std::size_t i) const { return parts_[i]; }
  [[nodiscard]] std::size_t size() const { return parts_.size(); }
  [[nodiscard]] std::uint64_t vertex_count() const { return parts_[0].vertices; }

  // Is the shape a polytope plus one ball? Hulls of other shapes do not count.
  [[nodiscard]] bool has_core() const {
    return std::none_of(parts_.begin(), parts_.end(),
                        [](const Part& part) { return part.is_curved() || part.kind == PartKind::hull_of; });
  }
  // The radius of that ball: the radii of all parts add up.
  template <class N>
  [[nodiscard]] N ball() const {
    N sum(0);
    for (const Part& part : parts_)
      if (part.leaf.radius > 0) sum = sum + N(part.leaf.radius);
    return sum;
  }
  [[nodiscard]] bool has_ball() const {
    return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.leaf.radius > 0; });
  }

 private:
  void pose(std::size_t i, const Vec3<double>& position, const Quaternion<double>& q, Door& door) {
    door.vector(position);
    door.quaternion(q);
    Part& part = parts_[i];
    part.kind = PartKind::posed;
    part.position = position;
    part.rotated = door.well_formed() && !q.is_identity();
    if (part.rotated) part.q = scaled_to_one(q);
  }

  // Returns the index of the new part, or kNone if the door already refuses.
  std::size_t add(const Shape<double>& shape, int depth, Door& door) {
    if (depth > kDeepestPart || parts_.size() >= kMostParts) {
      door.unsupported("a shape of more than 64 levels or 4096 parts");
      return Part::kNone;
    }
    const std::size_t i = parts_.size();
    parts_.emplace_back();
    if (read_leaf(shape, parts_[i].leaf, door)) {
      parts_[i].vertices = parts_[i].leaf.core.count();
    } else if (const auto* ellipsoid = std::get_if<Ellipsoid<double>>(&shape)) {
      curved(i, PartKind::ellipsoid, ellipsoid->radii, door);
    } else if (const auto* cylinder = std::get_if<Cylinder<double>>(&shape)) {
      curved(i, PartKind::cylinder, {cylinder->radius, cylinder->half_height, 0}, door);
    } else if (const auto* cone = std::get_if<Cone<double>>(&shape)) {
      curved(i, PartKind::cone, {cone->radius, cone->half_height, 0}, door);
    } else if (const auto* posed = std::get_if<Posed<double>>(&shape)) {
      pose(i, posed->position, posed->orientation, door);
      add_children(i, std::span(&posed->shape, 1), depth, door);
    } else if (const auto* rounded = std::get_if<Rounded<double>>(&shape)) {
      parts_[i].kind = PartKind::rounded;
      parts_[i].leaf.radius = rounded->radius;
      door.extent(rounded->radius, "a radius below zero");
      add_children(i, std::span(&rounded->shape, 1), depth, door);
    } else if (const auto* sum = std::get_if<Sum<double>>(&shape)) {
      parts_[i].kind = PartKind::sum;
      add_children(i, sum->shapes, depth, door);
    } else if (const auto* hull_of = std::get_if<HullOf<double>>(&shape)) {
      parts_[i].kind = PartKind::hull_of;
      add_children(i, hull_of->shapes, depth, door);
    } else {
      door.unsupported("a shape that the checker does not know");
    }
    return i;
  }

  void curved(std::size_t i, PartKind kind, const Vec3<double>& extents, Door& door) {
    parts_[i].kind = kind;
    parts_[i].extents = extents;
    for (int k = 0; k < 3; ++k) door.extent(extents[k], "a radius or a half height below zero");
  }

  void add_children(std::size_t i, std::span<const SharedShape<double>> shapes, int depth, Door& door) {
    if (shapes.empty()) door.malformed("a sum or a hull of no shapes");
    std::uint64_t vertices = parts_[i].kind == PartKind::hull_of ? 0 : 1;
    std::size_t last = Part::kNone;
    for (const SharedShape<double>& shape : shapes) {
      if (!shape) {
        door.malformed("a combinator with a part that has no shape");
        return;
      }
      const std::size_t child = add(shape->shape, depth + 1, door);
      if (child == Part::kNone) return;
      (last == Part::kNone ? parts_[i].first_child : parts_[last].next) = child;
      last = child;
      const std::uint64_t more = parts_[child].vertices;  // both factors at most 2^32: no overflow
      vertices = parts_[i].kind == PartKind::hull_of ? vertices + more
                 : more == 0                         ? 0
                                                     : std::min(vertices, Part::kManyVertices) * more;
      vertices = std::min(vertices, Part::kManyVertices);
    }
    parts_[i].vertices = vertices;
  }

  std::vector<Part> parts_;
};

}  // namespace graze::oracle
