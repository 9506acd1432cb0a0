#include "properties/scenes/law.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include "properties/scenes/generate.hpp"

namespace graze::law {
namespace {

using scene::Ask;
using scene::Event;
using scene::Options;
using scene::Report;
using scene::Scene;

bool is_contact(const Event& event) {
  return event.outcome == Outcome::hit || event.outcome == Outcome::initially_overlapping;
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Events = std::map<Pair, Event>;
Events by_pair(const std::vector<Event>& events) {
  Events out;
  for (const Event& event : events) out[{event.a, event.b}] = event;
  return out;
}

// The first contact among events: no earlier than lower, if there is one, and by upper, if any is proved.
struct First {
  double lower = kInfinity<double>, upper = kInfinity<double>;
  std::size_t open = 0, contacts = 0;

  void add(const Event& event) {
    lower = std::min(lower, event.toi_lower);
    if (is_contact(event)) {
      upper = std::min(upper, event.toi_upper);
      ++contacts;
    } else {
      ++open;
    }
  }
};

void add(scene::Counts& sum, const scene::Counts& more) {
  sum.pairs += more.pairs;
  sum.filtered += more.filtered;
  sum.apart += more.apart;
  sum.never_meet += more.never_meet;
  sum.parted += more.parted;
  sum.held += more.held;
  sum.kept += more.kept;
  sum.moot += more.moot;
  sum.shortened += more.shortened;
  for (std::size_t k = 0; k < sum.effects.size(); ++k) sum.effects[k] += more.effects[k];
  for (std::size_t k = 0; k < sum.reasons.size(); ++k) sum.reasons[k] += more.reasons[k];
  sum.probe_casts += more.probe_casts;
  sum.probe_moot += more.probe_moot;
}

std::string text(const Event& event) {
  return std::to_string(event.a) + " - " + std::to_string(event.b) + " " +
         std::string(to_text(event.outcome)) + " [" + std::to_string(event.toi_lower) + ", " +
         std::to_string(event.toi_upper) + "]";
}

// Every pair is counted once.
std::string counted(const scene::Counts& counts) {
  const std::uint64_t sum = counts.filtered + counts.apart + counts.never_meet + counts.moot + counts.parted +
                            counts.held + counts.kept + counts.unfinished + counts.simulated();
  return sum == counts.pairs
             ? std::string()
             : std::to_string(sum) + " of " + std::to_string(counts.pairs) + " pairs are counted";
}

class Comparison {
 public:
  Comparison(const Scene& scene, const Options& options)
      : scene_(scene), options_(options), slack_(options.tier == Tier::standard ? kStandardSlack : 0) {}

  std::string operator()(SceneTally& tally) {
    const Report spared = scene::run(scene_, options_);
    if (!spared.wrong.empty()) return "the run says: " + spared.wrong;
    ++tally.scenes;
    const std::vector<Event> every = every_pair(), every_probe = probe_with_every_body();
    for (const Event& event : every) ++(is_contact(event) ? tally.contacts : tally.open);
    tally.probe_contacts += every_probe.size();
    add(tally.spared, spared.counts);

    const Events other = by_pair(every);
    std::string broken = ordered(spared.events);
    if (broken.empty()) broken = each_meets(spared.events, other, "bodies ");
    if (broken.empty()) broken = pairs(spared.events, other);
    if (broken.empty()) broken = counted(spared.counts);
    for (std::uint32_t k = 0; k < scene_.probes.size() && broken.empty(); ++k) {
      const std::vector<Event> mine = of_probe(spared.probe_events, k), theirs = of_probe(every_probe, k);
      broken = each_meets(mine, by_pair(theirs), "probe ");
      if (!broken.empty()) break;
      broken = scene_.probes[k].first_only ? firsts(mine, theirs) : none_missing(mine, by_pair(theirs));
      if (!broken.empty()) broken = "probe " + scene_.probes[k].name + ": " + broken;
    }
    return broken;
  }

 private:
  // The other side, without a line of scene's: every pair by itself, as it moves and rotates.
  [[nodiscard]] std::optional<Event> ask(const RotatingBody<double>& a, const RotatingBody<double>& b,
                                         double t_max) const {
    Event out;
    const auto take = [&](const auto& answer) {
      out.outcome = answer.outcome;
      out.toi_lower = answer.toi_lower;
      out.toi_upper = answer.toi_upper;
    };
    if (a.rotation == Vec3<double>::Zero() && b.rotation == Vec3<double>::Zero()) {
      CastOptions<double> linear;
      linear.tier = options_.tier;
      linear.t_max = t_max;
      linear.target_distance = options_.target_distance;
      take(graze::cast(a.body, b.body, linear));
    } else {
      RotatingOptions<double> turning;
      turning.tier = options_.tier;
      turning.method = RotatingMethod::bilateral_advancement;
      turning.t_max = t_max;
      turning.target_distance = options_.target_distance;
      // In tier standard a start nearer than a part of the tolerance counts as contact at once.
      if (options_.tier == Tier::standard) turning.tolerance = options_.tolerance;
      take(graze::cast(a, b, turning));
    }
    if (out.outcome == Outcome::miss || out.outcome == Outcome::invalid_input) return {};
    return out;
  }
  [[nodiscard]] std::vector<Event> every_pair() const {
    std::vector<Event> out;
    for (std::uint32_t a = 0; a < scene_.bodies.size(); ++a) {
      for (std::uint32_t b = a + 1; b < scene_.bodies.size(); ++b) {
        if (!scene_.bodies[a].filter.meets(scene_.bodies[b].filter)) continue;
        std::optional<Event> event = ask(scene_.bodies[a].body, scene_.bodies[b].body, options_.t_max);
        if (!event) continue;
        event->a = a;
        event->b = b;
        out.push_back(*event);
      }
    }
    return out;
  }
  [[nodiscard]] std::vector<Event> probe_with_every_body() const {
    std::vector<Event> out;
    for (std::uint32_t a = 0; a < scene_.probes.size(); ++a) {
      for (std::uint32_t b = 0; b < scene_.bodies.size(); ++b) {
        if (!scene_.probes[a].filter.meets(scene_.bodies[b].filter)) continue;
        RotatingBody<double> still = scene_.bodies[b].body;
        still.rotation = still.body.displacement = Vec3<double>::Zero();
        std::optional<Event> event = ask(scene_.probes[a].body, still, scene_.probes[a].t_max);
        if (!event) continue;
        event->a = a;
        event->b = b;
        out.push_back(*event);
      }
    }
    return out;
  }

  static std::vector<Event> of_probe(const std::vector<Event>& events, std::uint32_t probe) {
    std::vector<Event> out;
    for (const Event& event : events) {
      if (event.a == probe) out.push_back(event);
    }
    return out;
  }

  [[nodiscard]] bool meet(double lower, double upper, double other_lower, double other_upper) const {
    return std::max(lower, other_lower) <= std::min(upper, other_upper) + slack_;
  }
  [[nodiscard]] bool meet(const Event& l, const Event& r) const {
    return meet(l.toi_lower, l.toi_upper, r.toi_lower, r.toi_upper);
  }

  // Every event has one on the other side whose bracket meets its own. An open one may have none.
  [[nodiscard]] std::string each_meets(const std::vector<Event>& mine, const Events& theirs,
                                       const char* what) const {
    for (const Event& event : mine) {
      const auto other = theirs.find({event.a, event.b});
      if (other == theirs.end()) {
        if (is_contact(event)) return what + text(event) + " is a miss without economies";
      } else if (!meet(event, other->second)) {
        return what + text(event) + " does not meet " + text(other->second) + " without economies";
      }
    }
    return {};
  }

  [[nodiscard]] std::string none_missing(const std::vector<Event>& mine, const Events& theirs) const {
    const Events known = by_pair(mine);
    for (const auto& [pair, event] : theirs) {
      if (is_contact(event) && !known.contains(pair))
        return text(event) + " without economies is a miss with them";
    }
    return {};
  }

  [[nodiscard]] std::string pairs(const std::vector<Event>& mine, const Events& theirs) const {
    std::vector<Event> all;
    for (const auto& [pair, event] : theirs) all.push_back(event);
    switch (options_.ask) {
      case Ask::pair:
        return none_missing(mine, theirs);
      case Ask::first:
        return firsts(mine, all);
      case Ask::verdict: {
        First l, r;
        for (const Event& event : mine) l.add(event);
        for (const Event& event : all) r.add(event);
        const bool differ = (l.contacts > 0) != (r.contacts > 0) && l.open == 0 && r.open == 0;
        return differ ? "contact with economies: " + std::to_string(l.contacts) +
                            ", without: " + std::to_string(r.contacts)
                      : std::string();
      }
      case Ask::body:
        for (std::uint32_t k = 0; k < scene_.bodies.size(); ++k) {
          std::string broken = firsts(of_body(mine, k), of_body(all, k));
          if (!broken.empty()) return "body " + std::to_string(k) + ": " + broken;
        }
        return {};
    }
    return {};
  }
  static std::vector<Event> of_body(const std::vector<Event>& events, std::uint32_t body) {
    std::vector<Event> out;
    for (const Event& event : events) {
      if (event.a == body || event.b == body) out.push_back(event);
    }
    return out;
  }

  // `mine` holds only events that may be the first of `all`. For a body, some of the other body's events
  // among them may be later.
  [[nodiscard]] std::string firsts(const std::vector<Event>& mine, const std::vector<Event>& all) const {
    First l, r;
    for (const Event& event : mine) l.add(event);
    for (const Event& event : all) r.add(event);
    if (l.contacts == 0 && r.contacts > 0 && l.open == 0)
      return "no event, and without economies there is one";
    if (!meet(l.lower, l.upper, r.lower, r.upper) && l.contacts + r.contacts > 0) {
      return "the first events, from " + std::to_string(l.lower) + " and from " + std::to_string(r.lower) +
             ", do not meet";
    }
    const Events known = by_pair(mine);
    for (const Event& event : all) {
      if (!is_contact(event) || known.contains({event.a, event.b})) continue;
      bool surely_first = true;
      for (const Event& other : all) {
        const bool same = other.a == event.a && other.b == event.b;
        surely_first = surely_first && (same || event.toi_upper + slack_ < other.toi_lower);
      }
      if (surely_first) return text(event) + " is the first without economies, and is not told with them";
    }
    return {};
  }

  // By time, and by the names at one time.
  [[nodiscard]] std::string ordered(const std::vector<Event>& events) const {
    for (std::size_t k = 1; k < events.size(); ++k) {
      const auto key = [&](const Event& event) {
        return std::tuple(event.toi_lower, event.toi_upper, scene_.bodies[event.a].name,
                          scene_.bodies[event.b].name);
      };
      if (!(key(events[k - 1]) < key(events[k])))
        return text(events[k - 1]) + " stands before " + text(events[k]);
    }
    return {};
  }

  const Scene& scene_;
  const Options& options_;
  double slack_;
};

bool same_bits(const Vec3<double>& l, const Vec3<double>& r) {
  return std::memcmp(l.data(), r.data(), 3 * sizeof(double)) == 0;
}
// An event's source may differ if it was known from the memory alone.
bool same_bits(const Event& l, const Event& r) {
  const bool by_memory = l.effects == Effects::nothing;
  return l.a == r.a && l.b == r.b && l.outcome == r.outcome &&
         std::bit_cast<std::uint64_t>(l.toi_lower) == std::bit_cast<std::uint64_t>(r.toi_lower) &&
         std::bit_cast<std::uint64_t>(l.toi_upper) == std::bit_cast<std::uint64_t>(r.toi_upper) &&
         std::bit_cast<std::uint64_t>(l.distance) == std::bit_cast<std::uint64_t>(r.distance) &&
         (by_memory || (l.effects == r.effects && l.reasons == r.reasons)) && same_bits(l.normal, r.normal) &&
         same_bits(l.point_a, r.point_a) && same_bits(l.point_b, r.point_b) && !l.proof == !r.proof;
}
std::string same_events(const std::vector<Event>& with, const std::vector<Event>& without) {
  for (std::size_t k = 0; k < std::max(with.size(), without.size()); ++k) {
    if (k >= with.size()) return text(without[k]) + " is a miss with a memory";
    if (k >= without.size()) return text(with[k]) + " is a miss without a memory";
    if (!same_bits(with[k], without[k]))
      return text(with[k]) + " with a memory is " + text(without[k]) + " without";
  }
  return {};
}

}  // namespace

std::string memory_law(const Scene& scene, const Options& options, scene::Memory& memory, SceneTally& tally) {
  constexpr int kSteps = 4;
  Options step = options;
  step.t_max = options.t_max / kSteps;
  Scene now = scene;
  for (int k = 0; k < kSteps; ++k) {
    if (k > 0) now = scene::at_time(now, step.t_max);
    if (k == 2) now.bodies[scene.bodies.size() / 2].body.body.position[0] += 0.125;
    if (k == 3) step.target_distance += 0.125;
    const Report with = scene::run(now, step, memory), without = scene::run(now, step);
    std::string broken =
        with.wrong.empty() ? same_events(with.events, without.events) : "says: " + with.wrong;
    if (broken.empty()) broken = same_events(with.probe_events, without.probe_events);
    if (broken.empty()) broken = counted(with.counts);
    if (!broken.empty()) return "step " + std::to_string(k) + ": " + broken;
    ++tally.scenes;
    add(tally.spared, with.counts);
  }
  return {};
}

std::string scene_law(const Scene& scene, const Options& options, SceneTally& tally) {
  return Comparison(scene, options)(tally);
}

SceneLawRun try_random_scenes(std::uint64_t first_seed, std::uint64_t count) {
  SceneLawRun out;
  scene::Memory memory;  // from one scene to the next, also if it belongs to other bodies
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    const RandomScene drawn = random_scene(seed);
    Options options = drawn.options;
    for (const bool all : {true, false}) {
      const auto one = static_cast<scene::Economy>(seed % scene::kEconomies);
      options.economies = all ? scene::Economies() : scene::Economies().without(one);
      std::string broken = scene_law(drawn.scene, options, out.tally);
      if (broken.empty()) continue;
      out.broken = "scene " + std::to_string(seed) + " in tier " + std::string(to_text(options.tier)) +
                   (all ? "" : " without " + std::string(to_text(one))) + ": " + broken;
      return out;
    }
    options.economies = {};
    const std::string broken = memory_law(drawn.scene, options, memory, out.tally);
    if (broken.empty()) continue;
    out.broken = "scene " + std::to_string(seed) + " in tier " + std::string(to_text(options.tier)) +
                 ", in steps: " + broken;
    return out;
  }
  return out;
}

}  // namespace graze::law
