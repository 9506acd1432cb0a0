// A tree over swept boxes: which bodies may meet, in about n log n for n bodies with few contacts.
//
// A bounding volume hierarchy whose nodes move with their contents: a node is a box at either end of the step
// (swept_box.hpp), as in ray tracing with motion blur. [Glassner 1988, and Hou et al. 2010 for nodes at both ends] A
// body that flies across the scene is a small box at every time. Its swept bounds at rest would hold the whole scene.
// The tree is built from the top by halves. A box has seven numbers: its centre at either end and its size. The
// number that differs most is split in the middle of its range. So bodies of very different speed or size part early,
// and a large one does not swell the nodes of small ones.
//
// Nothing rounds here that may drop a pair: nodes take least and greatest ends, and the meeting of two boxes is
// decided as swept_box.hpp proves.
#pragma once

#include <cstdint>
#include <graze/scene/swept_box.hpp>
#include <vector>

namespace graze::scene {

class Tree {
 public:
  struct Node {
    SweptBox box;
    std::uint32_t first = 0, count = 0;   // of order
    std::uint32_t right = 0;              // the right child, 0 for a leaf. The left one is the next node
    std::uint32_t groups = 0, masks = 0;  // of any body in it
  };
  struct Item {
    SweptBox box;
    std::uint32_t index = 0;  // of the body
    std::uint32_t group = 1, mask = ~std::uint32_t{0};
  };

  Tree() = default;
  explicit Tree(std::vector<Item> items);

  // In the tree's own order: neighbours in it are neighbours in space.
  [[nodiscard]] const std::vector<Item>& items() const { return items_; }
  [[nodiscard]] std::size_t bytes() const {
    return items_.capacity() * sizeof(Item) + nodes_.capacity() * sizeof(Node);
  }
  [[nodiscard]] const SweptBox& whole() const { return nodes_.front().box; }

  // visit(item, begin) for every item from place `from` on whose box may meet `with` in time, its group and
  // mask willing. False from visit: stop.
  template <class Visit>
  bool for_each_meeting(const Item& with, std::size_t from, const Visit& visit) const {
    return walk(
        with, from, [](const SweptBox& p, const SweptBox& q) { return meeting(p, q); }, visit);
  }
  // The same, of the items as they stand at s = 0.
  template <class Visit>
  bool for_each_at_rest(const Item& with, const Visit& visit) const {
    return walk(
        with, 0, [](const SweptBox& p, const SweptBox& q) { return meeting_at_rest(p, q); }, visit);
  }

 private:
  template <class Meet, class Visit>
  bool walk(const Item& with, std::size_t from, const Meet& meet, const Visit& visit) const;
  std::uint32_t build(std::uint32_t first, std::uint32_t count, int depth);

  std::vector<Item> items_;
  std::vector<Node> nodes_;
};

[[nodiscard]] inline bool may_meet(const Tree::Item& a, std::uint32_t group, std::uint32_t mask) {
  return (a.group & mask) != 0 && (group & a.mask) != 0;
}

template <class Meet, class Visit>
bool Tree::walk(const Item& with, std::size_t from, const Meet& meet, const Visit& visit) const {
  if (nodes_.empty()) return true;
  // Depth is bounded by build(): 64 halves in the middle of a range, then halves of the number.
  std::uint32_t waiting[128];
  int left = 0;
  waiting[left++] = 0;
  while (left > 0) {
    const std::uint32_t at = waiting[--left];
    const Node& node = nodes_[at];
    if (node.first + node.count <= from) continue;
    if ((node.groups & with.mask) == 0 || (with.group & node.masks) == 0) continue;
    if (!meet(with.box, node.box).possible()) continue;
    if (node.right != 0) {
      waiting[left++] = node.right;
      waiting[left++] = at + 1;
      continue;
    }
    for (std::size_t k = std::max<std::size_t>(from, node.first); k < node.first + node.count; ++k) {
      const Item& item = items_[k];
      if (!may_meet(item, with.group, with.mask)) continue;
      const Meeting when = meet(with.box, item.box);
      if (when.possible() && !visit(item, when.begin)) return false;
    }
  }
  return true;
}

}  // namespace graze::scene
