// scene_law SEED COUNT: the law of scenes on COUNT random scenes. Exit code 0: it holds, and every economy
// saved some work. Exit code 1: it is broken, or a kind of scene was never drawn. One line says which.
#include <cstdio>
#include <cstdlib>

#include "properties/scenes/law.hpp"

namespace {

std::uint64_t never_drawn(const graze::law::SceneTally& tally) {
  const graze::scene::Counts& spared = tally.spared;
  std::uint64_t never = 0;
  const auto need = [&](std::uint64_t number, const char* what) {
    if (number > 0) return;
    std::printf("never drawn: %s\n", what);
    ++never;
  };
  need(tally.contacts, "a contact");
  need(tally.probe_contacts, "a contact of a probe");
  need(spared.filtered, "a pair parted by filters");
  need(spared.apart, "a pair apart at rest");
  need(spared.never_meet, "a pair whose bounds never meet");
  need(spared.moot, "a pair that is moot");
  need(spared.parted, "a pair that its last axis still parts");
  need(spared.held, "a pair whose last points still touch");
  need(spared.kept, "a pair at rest whose overlap is known");
  need(spared.shortened, "a pair with a shortened horizon");
  need(spared.probe_moot, "a moot cast of a probe");
  for (std::size_t k = 0; k < spared.reasons.size(); ++k) {
    need(spared.reasons[k], to_text(static_cast<graze::PlanReason>(k)).data());
  }
  return never;
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) {
    std::fprintf(stderr, "usage: scene_law SEED COUNT\n");
    return 2;
  }
  const std::uint64_t seed = std::strtoull(words[1], nullptr, 10),
                      scenes = std::strtoull(words[2], nullptr, 10);
  const graze::law::SceneLawRun run = graze::law::try_random_scenes(seed, scenes);
  std::printf("%llu runs, %llu contacts, %llu open, %llu of probes\n",
              static_cast<unsigned long long>(run.tally.scenes),
              static_cast<unsigned long long>(run.tally.contacts),
              static_cast<unsigned long long>(run.tally.open),
              static_cast<unsigned long long>(run.tally.probe_contacts));
  std::printf("%s", graze::scene::to_text(run.tally.spared).c_str());
  if (!run.broken.empty()) {
    std::printf("broken: %s\n", run.broken.c_str());
    return 1;
  }
  return scenes >= 100 && never_drawn(run.tally) > 0 ? 1 : 0;
}
