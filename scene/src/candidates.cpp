#include "candidates.hpp"

#include <map>
#include <tuple>

#include "parallel.hpp"

namespace graze::scene {
namespace {

// More filters than these are not told apart in the counts: pairs that they part then count as never_meet.
constexpr std::size_t kMostFilters = 2048;

std::uint64_t pairs_of(std::uint64_t n) { return n * (n - 1) / 2; }

// Pairs that the filters let meet: of bodies at rest, and of all others.
struct Allowed {
  std::uint64_t resting = 0, moving = 0;
};

Allowed allowed_pairs(const Scene& scene, const Counts& counts) {
  std::map<std::tuple<std::uint32_t, std::uint32_t, bool>, std::uint64_t> kinds;
  for (const Member& member : scene.bodies) {
    ++kinds[{member.filter.group, member.filter.mask, is_at_rest(member.body)}];
    if (kinds.size() > kMostFilters) {
      const std::uint64_t resting = counts.resting > 0 ? pairs_of(counts.resting) : 0;
      return {resting, counts.pairs - resting};
    }
  }
  Allowed out;
  for (auto one = kinds.begin(); one != kinds.end(); ++one) {
    const auto& [group, mask, rests] = one->first;
    for (auto other = one; other != kinds.end(); ++other) {
      const auto& [other_group, other_mask, other_rests] = other->first;
      if (!Filter{group, mask}.meets({other_group, other_mask})) continue;
      const std::uint64_t number = one == other ? pairs_of(one->second) : one->second * other->second;
      (rests && other_rests ? out.resting : out.moving) += number;
    }
  }
  return out;
}

class Search {
 public:
  Search(const Scene& scene, const Options& options, const Tree& tree)
      : scene_(scene), options_(options), tree_(tree) {}

  Candidates operator()() {
    Counts& counts = out_.counts;
    counts.bodies = scene_.bodies.size();
    counts.probes = scene_.probes.size();
    counts.pairs = counts.bodies > 0 ? pairs_of(counts.bodies) : 0;
    for (const Member& member : scene_.bodies) {
      counts.resting += is_at_rest(member.body) ? 1 : 0;
      counts.turning += member.body.rotation != Vec3<double>::Zero() ? 1 : 0;
    }
    const bool by_tree = options_.economies.has(Economy::rest) && options_.economies.has(Economy::bounds);
    if (by_tree) {
      ask_tree();
    } else {
      ask_all();
    }
    if (out_.over_budget) {
      out_.pairs.clear();
      return std::move(out_);
    }
    const Allowed allowed = allowed_pairs(scene_, counts);
    std::uint64_t resting = 0;
    for (const Candidate& pair : out_.pairs) resting += both_rest(pair.a, pair.b) ? 1 : 0;
    counts.filtered = counts.pairs - allowed.resting - allowed.moving;
    counts.apart = allowed.resting - resting;
    counts.never_meet = allowed.moving - (out_.pairs.size() - resting);
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool both_rest(std::uint32_t a, std::uint32_t b) const {
    return is_at_rest(scene_.bodies[a].body) && is_at_rest(scene_.bodies[b].body);
  }
  [[nodiscard]] Candidate candidate(std::uint32_t a, std::uint32_t b, double begin) const {
    // Rounded down: a product is within u of itself.
    return {std::min(a, b), std::max(a, b), begin * options_.t_max * (1 - 4 * kUnitRoundoff<double>)};
  }

  // Each item asks for those behind it in the tree's order. A part has its own list, so that the lists, one
  // after the other, are the same whatever the threads.
  void ask_tree() {
    constexpr std::size_t kPart = 1024;
    const std::vector<Tree::Item>& items = tree_.items();
    const std::size_t parts = (items.size() + kPart - 1) / kPart;
    std::vector<std::vector<Candidate>> found(parts);
    std::atomic<std::uint64_t> total = 0;
    for_each_index(parts, options_.threads, [&](std::size_t part) {
      std::vector<Candidate>& mine = found[part];
      std::size_t counted = 0;
      const auto within_budget = [&] {
        total += mine.size() - counted;
        counted = mine.size();
        return total <= options_.most_pairs;
      };
      for (std::size_t k = part * kPart; k < std::min(items.size(), (part + 1) * kPart); ++k) {
        const bool all = tree_.for_each_meeting(items[k], k + 1, [&](const Tree::Item& other, double begin) {
          mine.push_back(candidate(items[k].index, other.index, begin));
          return mine.size() - counted < kPart || within_budget();
        });
        if (!all || !within_budget()) return;
      }
    });
    out_.over_budget = total > options_.most_pairs;
    if (out_.over_budget) return;
    out_.pairs.reserve(total);
    for (std::vector<Candidate>& part : found) {
      out_.pairs.insert(out_.pairs.end(), part.begin(), part.end());
      std::vector<Candidate>().swap(part);
    }
  }

  // With an economy off: every pair that it would have spared is looked at too.
  void ask_all() {
    const std::vector<Tree::Item>& items = tree_.items();
    for (std::size_t k = 0; k < items.size(); ++k) {
      for (std::size_t l = k + 1; l < items.size(); ++l) {
        if (!may_meet(items[k], items[l].group, items[l].mask)) continue;
        const Meeting when = meeting(items[k].box, items[l].box);
        const Economy sparing = both_rest(items[k].index, items[l].index) ? Economy::rest : Economy::bounds;
        if (!when.possible() && options_.economies.has(sparing)) continue;
        out_.pairs.push_back(candidate(items[k].index, items[l].index, when.possible() ? when.begin : 0.0));
        out_.over_budget = out_.pairs.size() > options_.most_pairs;
        if (out_.over_budget) return;
      }
    }
  }

  const Scene& scene_;
  const Options& options_;
  const Tree& tree_;
  Candidates out_;
};

}  // namespace

bool is_at_rest(const RotatingBody<double>& body) {
  return body.rotation == Vec3<double>::Zero() && body.body.displacement == Vec3<double>::Zero();
}

Tree tree_of(const Scene& scene, const Options& options) {
  std::vector<Tree::Item> items(scene.bodies.size());
  for_each_index((items.size() + 1023) / 1024, options.threads, [&](std::size_t part) {
    for (std::size_t k = part * 1024; k < std::min(items.size(), (part + 1) * 1024); ++k) {
      const Member& member = scene.bodies[k];
      items[k] = {contact_box(member.body, options.t_max, options.target_distance),
                  static_cast<std::uint32_t>(k), member.filter.group, member.filter.mask};
    }
  });
  return Tree(std::move(items));
}

Candidates candidates(const Scene& scene, const Options& options, const Tree& tree) {
  return Search(scene, options, tree)();
}

}  // namespace graze::scene
