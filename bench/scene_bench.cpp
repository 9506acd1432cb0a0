// The cost of finding the bodies of a scene that may meet. The tree of moving boxes is measured beside Boost's R-tree
// and a flat sweep, both over boxes at rest about the bodies' whole paths.
//
//   scene_bench [N...]     scenes of N bodies (100 to 1000000 by default), processor time, one thread
#include <fmt/format.h>
#include <graze/scene/tree.hpp>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <vector>

namespace {

using graze::RotatingBody;
using graze::Vec3;
using graze::scene::SweptBox;
using graze::scene::Tree;

// A contestant that takes longer is stopped.
constexpr double kMostSeconds = 60;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class Random {
 public:
  double between(double low, double high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return low + static_cast<double>(state_ >> 11) * 0x1p-53 * (high - low);
  }
  Vec3<double> vector(double most) {
    return {between(-most, most), between(-most, most), between(-most, most)};
  }

 private:
  std::uint64_t state_ = 22;
};

// One body in eight cubes of its own size, whatever n. Mixed: one in a thousand is 30 times as large, and one in ten
// flies 200 sizes far.
std::vector<Tree::Item> scene_of(std::size_t n, bool mixed) {
  Random random;
  const double half = std::cbrt(static_cast<double>(n)) * 2;
  std::vector<Tree::Item> items;
  items.reserve(n);
  for (std::size_t k = 0; k < n; ++k) {
    RotatingBody<double> body;
    const double size = mixed && k % 1000 == 0 ? 30 : 1;
    body.body.shape = graze::Box<double>{Vec3<double>::Constant(size / 2)};
    body.body.position = random.vector(half);
    body.body.displacement = random.vector(mixed && k % 10 == 0 ? 200 : 0.5);
    items.push_back({graze::scene::swept_box(body, 1, 0), static_cast<std::uint32_t>(k), 1, ~0u});
  }
  return items;
}

struct Measured {
  double build = 0, search = 0;  // seconds
  std::size_t pairs = 0;
  double bytes = 0;  // a body
};

Measured by_tree(const std::vector<Tree::Item>& items) {
  Measured out;
  const double start = processor_seconds();
  const Tree tree(items);
  out.build = processor_seconds() - start;
  for (std::size_t k = 0; k < items.size(); ++k) {
    tree.for_each_meeting(tree.items()[k], k + 1, [&](const Tree::Item&, double) {
      ++out.pairs;
      return true;
    });
  }
  out.search = processor_seconds() - start - out.build;
  out.bytes = static_cast<double>(tree.bytes()) / static_cast<double>(items.size());
  return out;
}

struct Still {
  Vec3<double> low, high;
};
Still around_the_way(const SweptBox& box) {
  return {box.low0.cwiseMin(box.low1), box.high0.cwiseMax(box.high1)};
}

std::optional<Measured> by_r_tree(const std::vector<Tree::Item>& items) {
  namespace geometry = boost::geometry;
  using Point = geometry::model::point<double, 3, geometry::cs::cartesian>;
  using Box = geometry::model::box<Point>;
  using Value = std::pair<Box, std::uint32_t>;
  const auto point = [](const Vec3<double>& x) { return Point(x[0], x[1], x[2]); };
  Measured out;
  const double start = processor_seconds();
  std::vector<Value> values;
  values.reserve(items.size());
  for (const Tree::Item& item : items) {
    const Still still = around_the_way(item.box);
    values.emplace_back(Box(point(still.low), point(still.high)), item.index);
  }
  const geometry::index::rtree<Value, geometry::index::quadratic<16>> tree(values);
  out.build = processor_seconds() - start;
  for (const Value& value : values) {
    for (auto it = tree.qbegin(geometry::index::intersects(value.first)); it != tree.qend(); ++it) {
      out.pairs += it->second > value.second ? 1 : 0;
    }
    if (processor_seconds() - start > kMostSeconds) return {};
  }
  out.search = processor_seconds() - start - out.build;
  out.bytes = sizeof(Value) * 16.0 / 15;  // leaves that are full, and a fifteenth of them above
  return out;
}

// Sorted by the lower end along x.
std::optional<Measured> by_sweep(const std::vector<Tree::Item>& items) {
  Measured out;
  const double start = processor_seconds();
  std::vector<Still> boxes;
  boxes.reserve(items.size());
  for (const Tree::Item& item : items) boxes.push_back(around_the_way(item.box));
  std::sort(boxes.begin(), boxes.end(), [](const Still& l, const Still& r) { return l.low[0] < r.low[0]; });
  out.build = processor_seconds() - start;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const Still& one = boxes[k];
    for (std::size_t l = k + 1; l < boxes.size() && boxes[l].low[0] <= one.high[0]; ++l) {
      const bool apart = boxes[l].low[1] > one.high[1] || one.low[1] > boxes[l].high[1] ||
                         boxes[l].low[2] > one.high[2] || one.low[2] > boxes[l].high[2];
      out.pairs += apart ? 0 : 1;
    }
    if (k % 1024 == 0 && processor_seconds() - start > kMostSeconds) return {};
  }
  out.search = processor_seconds() - start - out.build;
  out.bytes = sizeof(Still);
  return out;
}

std::string cell(const std::optional<Measured>& one, std::size_t n) {
  if (!one) return fmt::format("over {} s", kMostSeconds);
  return fmt::format("{:.2f} + {:.2f}", 1e6 * one->build / static_cast<double>(n),
                     1e6 * one->search / static_cast<double>(n));
}
std::string pairs_text(const std::optional<Measured>& one) { return one ? fmt::to_string(one->pairs) : "-"; }

}  // namespace

int main(int count, char** words) {
  std::vector<std::size_t> sizes;
  for (int k = 1; k < count; ++k) sizes.push_back(std::strtoull(words[k], nullptr, 10));
  if (sizes.empty()) sizes = {100, 1000, 10'000, 100'000, 1'000'000};
  fmt::print("us of processor time a body, to build + to search; pairs that may meet; bytes a body\n\n");
  fmt::print(
      "| bodies | | tree of moving boxes | pairs | bytes | Boost's R-tree | pairs | flat sweep | pairs |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const bool mixed : {false, true}) {
    for (const std::size_t n : sizes) {
      const std::vector<Tree::Item> items = scene_of(n, mixed);
      const std::optional<Measured> ours = by_tree(items), boost = by_r_tree(items), sweep = by_sweep(items);
      fmt::print("| {} | {} | {} | {} | {:.0f} | {} | {} | {} | {} |\n", n, mixed ? "mixed" : "alike",
                 cell(ours, n), ours->pairs, ours->bytes, cell(boost, n), pairs_text(boost), cell(sweep, n),
                 pairs_text(sweep));
      std::fflush(stdout);
    }
  }
  return 0;
}
