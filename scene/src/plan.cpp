#include <graze/scene.hpp>

#include <algorithm>

#include "candidates.hpp"
#include "events.hpp"
#include "parallel.hpp"

namespace graze::scene {

void Counts::add(const graze::Plan& plan) {
  ++effects[static_cast<std::size_t>(plan.effects)];
  for (std::size_t k = 0; k < reasons.size(); ++k) {
    if (plan.has(static_cast<PlanReason>(k))) ++reasons[k];
  }
}

std::string to_text(const Counts& counts) {
  std::string text;
  const auto line = [&](std::uint64_t number, std::string_view what) {
    if (number > 0) text.append(std::to_string(number)).append(" ").append(what).append("\n");
  };
  line(counts.bodies, counts.bodies == 1 ? "body" : "bodies");
  line(counts.resting, "of them at rest");
  line(counts.turning, "of them rotating");
  line(counts.pairs, counts.pairs == 1 ? "pair" : "pairs");
  line(counts.filtered, "nothing: parted by their filters");
  line(counts.apart, "nothing: at rest, and their bounds are apart");
  line(counts.never_meet, "nothing: their swept bounds never meet");
  line(counts.moot, "nothing: an earlier event settles the question");
  line(counts.parted, "a test: parted along the axis of the step before");
  line(counts.held, "a test: in contact along the directions of the step before");
  line(counts.kept, "nothing: they rest as in the step before");
  for (std::size_t k = 0; k < counts.effects.size(); ++k) {
    line(counts.effects[k], std::string("simulated: ").append(to_text(static_cast<Effects>(k))));
  }
  for (std::size_t k = 0; k < counts.reasons.size(); ++k) {
    line(counts.reasons[k], std::string("because ").append(to_text(static_cast<PlanReason>(k))));
  }
  line(counts.shortened, "cast no farther than to an earlier event");
  line(counts.unfinished, "left undone: interrupted");
  line(counts.probes, "rays and casts");
  line(counts.probe_casts, "casts of them against a body");
  line(counts.probe_moot, "spared by an earlier one");
  return text;
}

Planned plan(const Scene& scene, const Options& options) {
  Planned out;
  out.wrong = why_invalid(scene, options);
  if (!out.wrong.empty()) return out;
  const Tree tree = tree_of(scene, options);
  const Candidates found = candidates(scene, options, tree);
  if (found.over_budget) {
    out.wrong = over_budget_text(options.most_pairs);
    return out;
  }
  out.counts = found.counts;
  out.pairs.resize(found.pairs.size());
  constexpr std::size_t kPart = 256;
  for_each_index((out.pairs.size() + kPart - 1) / kPart, options.threads, [&](std::size_t part) {
    for (std::size_t k = part * kPart; k < std::min(out.pairs.size(), (part + 1) * kPart); ++k) {
      const Candidate& pair = found.pairs[k];
      out.pairs[k] = {pair.a, pair.b, plan_of(scene.bodies[pair.a].body, scene.bodies[pair.b].body, options),
                      pair.begin};
    }
  });
  for (const PairPlan& pair : out.pairs) out.counts.add(pair.plan);
  std::sort(out.pairs.begin(), out.pairs.end(),
            [](const PairPlan& l, const PairPlan& r) { return l.a != r.a ? l.a < r.a : l.b < r.b; });
  return out;
}

}  // namespace graze::scene
