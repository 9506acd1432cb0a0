#include "recall.hpp"

#include <algorithm>
#include <bit>

#include "same_body.hpp"

namespace graze::scene {
namespace {

constexpr std::uint8_t kMostWait = 63;

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
      rests_as_it_did_(scene.bodies.size(), 0) {
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

Looked Recall::pass_over(const Candidate& pair) const {
  Looked out;
  out.next = known(pair);
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
  Memory::Pair& next = out.next;
  if (next.answer != Memory::kNothing) {
    out.how = Looked::How::kept;
    return out;
  }
  const RotatingBody<double>&a = scene_.bodies[pair.a].body, &b = scene_.bodies[pair.b].body;
  PartingAxis hint{next.axis, next.frame};
  if (hint.is_known() || (next.failures > 0 && --next.wait == 0)) {
    if (stays_apart(a, b, limits(until), hint, out.counters)) {
      out.how = Looked::How::parted;
      next.axis = hint.axis;
      next.frame = hint.frame;
      next.failures = next.wait = 0;
      return out;
    }
    next.axis = Vec3<double>::Zero();
    next.failures = static_cast<std::uint8_t>(std::min<int>(2 * next.failures + 1, kMostWait));
    next.wait = next.failures;
  }
  out.how = Looked::How::cast;
  out.answer = answer(a, b, options_, until);
  learn(pair, until, out);
  return out;
}

// Of what has been cast.
void Recall::learn(const Candidate& pair, double until, Looked& looked) const {
  const RotatingBody<double>&a = scene_.bodies[pair.a].body, &b = scene_.bodies[pair.b].body;
  const Answer& found = *looked.answer;
  Memory::Pair& next = looked.next;
  if (is_at_rest(a) && is_at_rest(b) && is_plain(found)) {
    next.answer = Memory::kMiss;  // of a contact keep() says which
    return;
  }
  if (found.result.outcome != Outcome::miss) {
    next.failures = next.wait = 0;
    return;
  }
  // A miss by bounds alone costs no more than an axis.
  if (next.failures > 0 || found.result.plan.effects == Effects::nothing) return;
  PartingAxis axis;
  if (stays_apart(a, b, limits(until), axis, looked.counters)) {
    next.axis = axis.axis;
    next.frame = axis.frame;
  } else {
    next.failures = next.wait = 1;
  }
}

void Recall::keep(const Looked& looked) {
  Memory::Pair pair = looked.next;
  if (pair.answer == Memory::kNothing && pair.failures == 0 && pair.axis == Vec3<double>::Zero()) return;
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
