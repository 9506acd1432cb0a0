#include "recall.hpp"

#include <algorithm>
#include <bit>

#include "same_body.hpp"

namespace graze::scene {
namespace {

constexpr int kMostWait = 63;

// [Steele, Lea, Flood 2014: the mix of SplitMix64]
std::size_t hash_of(std::uint32_t a, std::uint32_t b) {
  std::uint64_t z = (std::uint64_t{a} << 32 | b) + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<std::size_t>(z ^ (z >> 31));
}

// Does the answer say nothing but whether they overlap? Then it is the same whatever the horizon.
bool is_plain(const Answer& answer) {
  const RotatingResult<double>& result = answer.result;
  return result.plan.effects == Effects::at_rest &&
         (result.outcome == Outcome::miss || result.outcome == Outcome::initially_overlapping);
}

}  // namespace

Recall::Recall(const Scene& scene, const Options& options, Memory& memory)
    : scene_(scene),
      options_(options),
      memory_(memory),
      settings_{options.tier, options.request, options.target_distance, options.tolerance, options.economies},
      rests_as_it_did_(scene.bodies.size(), 0),
      limits_{options.t_max, options.target_distance, options.tolerance, 0} {
  if (!(settings_ == memory.settings_)) return;
  for (const Memory::Resting& before : memory.resting_) {
    if (before.index >= scene.bodies.size()) continue;
    const RotatingBody<double>& now = scene.bodies[before.index].body;
    rests_as_it_did_[before.index] = is_at_rest(now) && is_same(before.body, now.body) ? 1 : 0;
  }
}

Memory::Pair Recall::known(const Candidate& pair) const {
  Memory::Pair none;
  none.a = pair.a;
  none.b = pair.b;
  const std::vector<std::uint32_t>& slots = memory_.slots_;
  if (slots.empty()) return none;
  for (std::size_t at = hash_of(pair.a, pair.b);; ++at) {
    const std::uint32_t slot = slots[at & (slots.size() - 1)];
    if (slot == Memory::kNothing) return none;
    const Memory::Pair& one = memory_.pairs_[slot];
    if (one.a == pair.a && one.b == pair.b) return one;
  }
}

void Recall::prepare(std::span<const Candidate> pairs) {
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  places_.assign(scene_.bodies.size(), kNone);
  std::vector<std::uint32_t> needed;
  for (const Candidate& pair : pairs) {
    if (both_rest(pair)) continue;
    for (const std::uint32_t k : {pair.a, pair.b}) {
      if (places_[k] != kNone) continue;
      places_[k] = static_cast<std::uint32_t>(needed.size());
      needed.push_back(k);
    }
  }
  double largest = 0;
  for (const std::uint32_t k : needed) {
    const detail::Bounds bounds = detail::bounds(scene_.bodies[k].body.body.shape);
    largest = std::max(largest, bounds.half.maxCoeff() + bounds.radius);
  }
  limits_.exponent = largest > 0 ? exponent_of(largest) : 0;
  bodies_.reserve(needed.size());
  for (const std::uint32_t k : needed) bodies_.emplace_back(scene_.bodies[k].body, limits_);
}

Looked Recall::pass_over(const Candidate& pair) const {
  Looked out;
  out.next = known(pair);
  if (out.next.touching != Memory::kNothing) out.touching = memory_.touching_[out.next.touching];
  if (out.next.answer == Memory::kNothing) return out;
  if (!rests_as_it_did_[pair.a] || !rests_as_it_did_[pair.b]) {
    out.next.answer = Memory::kNothing;
  } else if (out.next.answer != Memory::kMiss) {
    out.kept = &memory_.events_[out.next.answer];
  }
  return out;
}

Looked Recall::look(const Candidate& pair, double until) const {
  Looked out = pass_over(pair);
  if (pair.begin > until) return out;
  if (out.next.answer != Memory::kNothing) {
    out.how = Looked::How::kept;
    return out;
  }
  if (!both_rest(pair) && follows(pair, out)) return out;
  out.how = Looked::How::cast;
  out.answer = answer(scene_.bodies[pair.a].body, scene_.bodies[pair.b].body, options_, until);
  learn(pair, out);
  return out;
}

// By what the step before knew, or by what is near it.
bool Recall::follows(const Candidate& pair, Looked& looked) const {
  Memory::Pair& next = looked.next;
  if (next.axis != Vec3<double>::Zero()) {
    StepPair step = step_of(pair, looked.counters);
    if (!step.is_parted_by(next.axis)) next.axis = step.find_axis(next.axis);
    looked.how = Looked::How::parted;
    if (next.axis == Vec3<double>::Zero()) next.failures = next.wait = 2;
    return next.axis != Vec3<double>::Zero();
  }
  if (looked.touching && !asks_for(options_.request, Request::proof)) {
    StepPair step = step_of(pair, looked.counters);
    if (!step.is_held_by(*looked.touching)) looked.touching = step.find_touching();
    looked.how = Looked::How::held;
    return looked.touching.has_value();
  }
  return false;
}

// For a pair that has been cast.
void Recall::learn(const Candidate& pair, Looked& looked) const {
  const Answer& found = *looked.answer;
  Memory::Pair& next = looked.next;
  looked.touching.reset();
  const bool rest = both_rest(pair);
  if (rest && is_plain(found)) next.answer = Memory::kMiss;  // of a contact keep() says which
  const Outcome outcome = found.result.outcome;
  if (rest || (outcome != Outcome::miss && outcome != Outcome::initially_overlapping)) return;
  if (next.failures > 0 && --next.wait > 0) return;
  StepPair step = step_of(pair, looked.counters);
  if (outcome == Outcome::miss) {
    next.axis = step.find_axis(Vec3<double>::Zero());
  } else {
    looked.touching = step.find_touching();
  }
  const bool is_found = next.axis != Vec3<double>::Zero() || looked.touching;
  next.failures =
      is_found ? std::uint8_t{0} : static_cast<std::uint8_t>(std::min(2 * next.failures + 1, kMostWait));
  next.wait = next.failures;
}

void Recall::keep(const Looked& looked) {
  Memory::Pair pair = looked.next;
  const bool is_axis_known = pair.axis != Vec3<double>::Zero();
  if (pair.answer == Memory::kNothing && pair.failures == 0 && !is_axis_known && !looked.touching) return;
  pair.touching = Memory::kNothing;
  if (looked.touching) {
    pair.touching = static_cast<std::uint32_t>(touching_.size());
    touching_.push_back(*looked.touching);
  }
  if (pair.answer != Memory::kNothing) {
    const bool found_contact =
        looked.answer && looked.answer->result.outcome == Outcome::initially_overlapping;
    pair.answer = Memory::kMiss;
    if (looked.kept || found_contact) {
      pair.answer = static_cast<std::uint32_t>(events_.size());
      events_.push_back(looked.kept ? *looked.kept : event_of(pair.a, pair.b, Answer(*looked.answer)));
    }
  }
  pairs_.push_back(pair);
}

void Recall::end() {
  memory_.pairs_ = std::move(pairs_);
  memory_.touching_ = std::move(touching_);
  memory_.events_ = std::move(events_);
  memory_.settings_ = settings_;
  memory_.resting_.clear();
  for (std::uint32_t k = 0; k < scene_.bodies.size(); ++k) {
    if (is_at_rest(scene_.bodies[k].body)) memory_.resting_.push_back({k, scene_.bodies[k].body.body});
  }
  index();
}

// At most half of the slots are taken, so that a search ends.
void Recall::index() {
  std::vector<std::uint32_t>& slots = memory_.slots_;
  slots.assign(std::bit_ceil(2 * memory_.pairs_.size() + 1), Memory::kNothing);
  for (std::uint32_t k = 0; k < memory_.pairs_.size(); ++k) {
    const Memory::Pair& pair = memory_.pairs_[k];
    std::size_t at = hash_of(pair.a, pair.b);
    while (slots[at & (slots.size() - 1)] != Memory::kNothing) ++at;
    slots[at & (slots.size() - 1)] = k;
  }
}

}  // namespace graze::scene
