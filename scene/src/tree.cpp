#include <graze/scene/tree.hpp>

#include <array>

namespace graze::scene {
namespace {

constexpr std::uint32_t kLeaf = 4;
// Splits in the middle of a range may be lopsided (bodies at 1, 1/2, 1/4, ...): so many are allowed on the way
// to a leaf, then each split halves the number.
constexpr int kMiddleSplits = 64;

using Key = std::array<double, 7>;
Key key_of(const SweptBox& box) {
  Key key;
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    key[i] = box.low0[k] / 2 + box.high0[k] / 2;
    key[i + 3] = box.low1[k] / 2 + box.high1[k] / 2;
    size = std::max(size, box.high0[k] - box.low0[k]);
  }
  key[6] = size;
  return key;
}

}  // namespace

Tree::Tree(std::vector<Item> items) : items_(std::move(items)) {
  if (items_.empty()) return;
  nodes_.reserve(items_.size());
  build(0, static_cast<std::uint32_t>(items_.size()), 0);
  nodes_.shrink_to_fit();
}

std::uint32_t Tree::build(std::uint32_t first, std::uint32_t count, int depth) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  Node node{SweptBox::nothing(), first, count, 0, 0, 0};
  Key low, high;
  low.fill(kInfinity<double>);
  high.fill(-kInfinity<double>);
  for (std::uint32_t k = first; k < first + count; ++k) {
    node.box.grow(items_[k].box);
    node.groups |= items_[k].group;
    node.masks |= items_[k].mask;
    const Key key = key_of(items_[k].box);
    for (std::size_t i = 0; i < key.size(); ++i) {
      low[i] = std::min(low[i], key[i]);
      high[i] = std::max(high[i], key[i]);
    }
  }
  nodes_.push_back(node);
  if (count <= kLeaf) return at;

  std::size_t widest = 0;
  for (std::size_t i = 1; i < low.size(); ++i) {
    if (high[i] - low[i] > high[widest] - low[widest]) widest = i;
  }
  const double middle = low[widest] / 2 + high[widest] / 2;
  const auto begin = items_.begin() + first, end = begin + count;
  auto split =
      std::partition(begin, end, [&](const Item& item) { return key_of(item.box)[widest] < middle; });
  if (depth >= kMiddleSplits || split == begin || split == end) {
    split = begin + count / 2;
    std::nth_element(begin, split, end, [&](const Item& l, const Item& r) {
      const double x = key_of(l.box)[widest], y = key_of(r.box)[widest];
      return x != y ? x < y : l.index < r.index;
    });
  }
  const auto lesser = static_cast<std::uint32_t>(split - begin);
  build(first, lesser, depth + 1);
  const std::uint32_t right = build(first + lesser, count - lesser, depth + 1);
  nodes_[at].right = right;
  return at;
}

}  // namespace graze::scene
