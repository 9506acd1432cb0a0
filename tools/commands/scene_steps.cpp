#include "tools/commands/scene_steps.hpp"

#include <fmt/format.h>
#include <graze/scene/memory.hpp>

#include <ctime>

#include "reports/text/stop.hpp"

namespace graze::tool {
namespace {

// So many rounds, or until so much processor time is spent.
constexpr int kMostStepRounds = 7;
constexpr double kMostSeconds = 8;

}  // namespace

SceneSteps::SceneSteps(const scene::Document& document, int steps) : options_(document.options) {
  options_.threads = 1;
  options_.t_max = document.options.t_max / steps;
  scenes_.reserve(static_cast<std::size_t>(steps));
  for (int k = 0; k < steps; ++k)
    scenes_.push_back(scene::at_time(document.scene, document.options.t_max * k / steps));
}

bool SceneSteps::run() {
  double spent = 0;
  for (int round = 0; round < kMostStepRounds && spent < kMostSeconds; ++round) {
    const std::clock_t start = std::clock();
    if (!go_through(false, without_) || !go_through(true, with_)) return false;
    spent += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }
  return true;
}

bool SceneSteps::go_through(bool with_memory, Sum& best) const {
  Sum sum;
  scene::Memory memory;
  const std::clock_t start = std::clock();
  for (const scene::Scene& scene : scenes_) {
    if (StopBySignal::received() != 0) return false;
    const scene::Report report =
        with_memory ? scene::run(scene, options_, memory) : scene::run(scene, options_);
    for (std::size_t k = 0; k < sum.counts.effects.size(); ++k)
      sum.counts.effects[k] += report.counts.effects[k];
    sum.counts.probe_casts += report.counts.probe_casts;
    sum.counts.parted += report.counts.parted;
    sum.counts.held += report.counts.held;
    sum.counts.kept += report.counts.kept;
    sum.supports += static_cast<std::uint64_t>(report.counters.supports);
    sum.events += report.events.size() + report.probe_events.size();
  }
  sum.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  sum.bytes = memory.bytes();
  if (sum.seconds < best.seconds) best = sum;
  return true;
}

Table SceneSteps::table() const {
  Table out({{fmt::format("{} steps", scenes_.size()), Align::left},
             {"casts"},
             {"of turning"},
             {"by an axis"},
             {"by points"},
             {"at rest, kept"},
             {"supports"},
             {"ms"},
             {"times"},
             {"events"},
             {"bytes kept"}});
  for (const Sum* sum : {&without_, &with_}) {
    const scene::Counts& counts = sum->counts;
    out.add_row({sum == &with_ ? "with a memory" : "each by itself",
                 fmt::to_string(counts.simulated() - counts.effects[0] + counts.probe_casts),
                 fmt::to_string(counts.effects[3]), fmt::to_string(counts.parted),
                 fmt::to_string(counts.held), fmt::to_string(counts.kept), fmt::to_string(sum->supports),
                 fmt::format("{:.3g}", 1e3 * sum->seconds),
                 fmt::format("{:.2f}", sum->seconds / without_.seconds), fmt::to_string(sum->events),
                 fmt::to_string(sum->bytes)});
  }
  return out;
}

}  // namespace graze::tool
