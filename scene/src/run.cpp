// The run of a scene: candidates in an order that spares most, in parts whose size does not depend on the
// threads. The events of one part bound the parts that follow. So every pair gets the same question with any
// number of threads.
#include <graze/scene.hpp>

#include <algorithm>
#include <chrono>

#include "candidates.hpp"
#include "events.hpp"
#include "parallel.hpp"
#include "recall.hpp"

namespace graze::scene {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// A first part is small, as its events may make the rest moot.
constexpr std::size_t kFirstPart = 16, kMostPart = 1024;

// The bound for the question so far: the latest time at which an event still counts.
class Horizon {
 public:
  Horizon(const Options& options, std::size_t bodies) : options_(options), scene_(options.t_max) {
    if (options.ask == Ask::body) body_.assign(bodies, options.t_max);
  }

  // The horizon of a pair. Nothing beyond it is needed for the pair.
  [[nodiscard]] double of(std::uint32_t a, std::uint32_t b) const {
    switch (options_.ask) {
      case Ask::pair:
        return options_.t_max;
      case Ask::body:
        return std::max(body_[a], body_[b]);
      case Ask::verdict:
      case Ask::first:
        return scene_;
    }
    return options_.t_max;
  }
  [[nodiscard]] bool settled() const { return options_.ask == Ask::verdict && any_; }

  void add(const Event& event) {
    if (!is_contact(event.outcome)) return;
    any_ = true;
    scene_ = std::min(scene_, event.toi_upper);
    if (options_.ask != Ask::body) return;
    body_[event.a] = std::min(body_[event.a], event.toi_upper);
    body_[event.b] = std::min(body_[event.b], event.toi_upper);
  }
  // Can the event be the first one requested? An open event can, if its bracket begins early enough.
  [[nodiscard]] bool counts(const Event& event) const {
    switch (options_.ask) {
      case Ask::pair:
        return true;
      case Ask::body:
        return event.toi_lower <= body_[event.a] || event.toi_lower <= body_[event.b];
      case Ask::verdict:
        return any_ ? is_contact(event.outcome) : true;
      case Ask::first:
        return event.toi_lower <= scene_;
    }
    return true;
  }

 private:
  const Options& options_;
  double scene_;
  std::vector<double> body_;
  bool any_ = false;
};

class Run {
 public:
  // Without a memory nothing is kept.
  Run(const Scene& scene, const Options& options, Memory* memory)
      : scene_(scene), options_(options), memory_(memory) {}

  Report operator()() {
    Report& out = report_;
    out.wrong = why_invalid(scene_, options_);
    if (!out.wrong.empty()) return std::move(out);
    const Clock::time_point start = Clock::now();
    const Tree tree = tree_of(scene_, options_);
    out.tree_bytes = tree.bytes();
    Candidates found = candidates(scene_, options_, tree);
    out.times.bounds = seconds_since(start);
    out.counts = found.counts;
    if (found.over_budget) {
      out.status = Status::over_budget;
      out.wrong = over_budget_text(options_.most_pairs);
      return std::move(out);
    }
    out.status = Status::complete;
    const Clock::time_point begin = Clock::now();
    work_ = found.pairs.size() + scene_.probes.size();
    if (memory_) {
      recall_.emplace(scene_, options_, *memory_);
      recall_->prepare(found.pairs);
    }
    cast_pairs(found.pairs);
    if (recall_) recall_->end();
    if (out.status == Status::complete) cast_probes(tree);
    out.times.casts = seconds_since(begin);
    return std::move(out);
  }

 private:
  [[nodiscard]] bool by_horizon() const { return options_.economies.has(Economy::horizon); }

  bool go_on(std::uint64_t done) {
    if (!options_.progress || options_.progress(done, work_)) return true;
    report_.status = Status::interrupted;
    return false;
  }

  void cast_pairs(std::vector<Candidate>& pairs) {
    const bool ordered = options_.ask != Ask::pair && by_horizon();
    if (ordered) {
      std::sort(pairs.begin(), pairs.end(),
                [](const Candidate& l, const Candidate& r) { return l.before(r); });
    }
    Horizon horizon(options_, scene_.bodies.size());
    std::vector<Looked> looked(std::min(kMostPart, pairs.size()));
    std::size_t done = 0, size = ordered ? kFirstPart : kMostPart;
    while (done < pairs.size() && go_on(done)) {
      const std::size_t count = std::min(size, pairs.size() - done);
      const std::span<const Candidate> part = std::span<const Candidate>(pairs).subspan(done, count);
      if (horizon.settled() && ordered) {
        report_.counts.moot += pairs.size() - done;
        for (const Candidate& pair : std::span<const Candidate>(pairs).subspan(done)) {
          if (recall_) recall_->keep(recall_->pass_over(pair));
        }
        done = pairs.size();
        break;
      }
      for_each_index(count, options_.threads, [&](std::size_t k) {
        looked[k] = look(part[k], ordered ? horizon.of(part[k].a, part[k].b) : options_.t_max);
      });
      for (std::size_t k = 0; k < count; ++k) {
        if (ordered && looked[k].answer && horizon.of(part[k].a, part[k].b) < options_.t_max)
          ++report_.counts.shortened;
      }
      for (std::size_t k = 0; k < count; ++k) take(part[k], looked[k], horizon);
      done += count;
      size = std::min(2 * size, kMostPart);
    }
    report_.counts.unfinished = pairs.size() - done;
    done_ = done;
    for (std::size_t k = done; recall_ && k < pairs.size(); ++k) recall_->keep(recall_->pass_over(pairs[k]));
    std::erase_if(report_.events, [&](const Event& event) { return !horizon.counts(event); });
    sort(report_.events);
  }

  // Over [0, until].
  [[nodiscard]] Looked look(const Candidate& pair, double until) const {
    if (recall_) return recall_->look(pair, until);
    Looked out;
    if (pair.begin > until) return out;
    out.how = Looked::How::cast;
    out.answer = answer(scene_.bodies[pair.a].body, scene_.bodies[pair.b].body, options_, until);
    return out;
  }

  void take(const Candidate& pair, Looked& looked, Horizon& horizon) {
    Counts& counts = report_.counts;
    if (recall_) recall_->keep(looked);
    report_.counters += looked.counters;
    switch (looked.how) {
      case Looked::How::moot:
        ++counts.moot;
        return;
      case Looked::How::parted:
        ++counts.parted;
        return;
      case Looked::How::held: {
        ++counts.held;
        Event event;
        event.a = pair.a;
        event.b = pair.b;
        event.outcome = Outcome::initially_overlapping;
        event.effects = Effects::nothing;
        add(std::move(event), horizon);
        return;
      }
      case Looked::How::kept:
        ++counts.kept;
        if (looked.kept) add(Event(*looked.kept), horizon);
        return;
      case Looked::How::cast:
        counts.add(looked.answer->result.plan);
        report_.counters += looked.answer->result.counters;
        if (is_event(looked.answer->result.outcome))
          add(event_of(pair.a, pair.b, std::move(*looked.answer)), horizon);
        return;
    }
  }
  void add(Event&& event, Horizon& horizon) {
    horizon.add(event);
    if (horizon.counts(event)) report_.events.push_back(std::move(event));
  }

  struct Seen {
    std::vector<Event> events;
    std::uint64_t casts = 0, moot = 0;
    Counters counters;
  };

  void cast_probes(const Tree& tree) {
    const std::vector<Probe>& probes = scene_.probes;
    constexpr std::size_t kPart = 256;
    std::vector<Seen> seen(std::min(kPart, probes.size()));
    for (std::size_t done = 0; done < probes.size(); done += kPart) {
      if (!go_on(done_ + done)) return;
      const std::size_t count = std::min(kPart, probes.size() - done);
      for_each_index(count, options_.threads,
                     [&](std::size_t k) { seen[k] = look(tree, static_cast<std::uint32_t>(done + k)); });
      for (std::size_t k = 0; k < count; ++k) {
        std::move(seen[k].events.begin(), seen[k].events.end(), std::back_inserter(report_.probe_events));
        report_.counts.probe_casts += seen[k].casts;
        report_.counts.probe_moot += seen[k].moot;
        report_.counters += seen[k].counters;
      }
    }
  }

  Seen look(const Tree& tree, std::uint32_t index) const {
    const Probe& probe = scene_.probes[index];
    Seen out;
    if (scene_.bodies.empty()) return out;
    std::vector<Candidate> found;
    if (options_.economies.has(Economy::bounds)) {
      // At rest it is where it starts, however long: an overlap question.
      double end = is_at_rest(probe.body) ? 0 : probe.t_max;
      if (!(end < kInfinity<double>)) {
        const SweptBox start = contact_box(probe.body, 0, options_.target_distance);
        end = last_exit(probe.body.body.displacement, start, tree.whole());
      }
      if (end < 0) return out;
      const Tree::Item item{contact_box(probe.body, end, options_.target_distance), index, probe.filter.group,
                            probe.filter.mask};
      tree.for_each_at_rest(item, [&](const Tree::Item& body, double begin) {
        found.push_back({index, body.index, begin * end * (1 - 4 * kUnitRoundoff<double>)});
        return true;
      });
    } else {
      for (std::uint32_t k = 0; k < scene_.bodies.size(); ++k) {
        if (scene_.bodies[k].filter.meets(probe.filter)) found.push_back({index, k, 0});
      }
    }
    std::sort(found.begin(), found.end(), [](const Candidate& l, const Candidate& r) { return l.before(r); });
    double until = probe.t_max;
    for (const Candidate& pair : found) {
      if (pair.begin > until) {
        ++out.moot;
        continue;
      }
      RotatingBody<double> body = scene_.bodies[pair.b].body;
      body.rotation = body.body.displacement = Vec3<double>::Zero();
      Answer found_here = answer(probe.body, body, options_, until);
      ++out.casts;
      out.counters += found_here.result.counters;
      if (!is_event(found_here.result.outcome)) continue;
      out.events.push_back(event_of(index, pair.b, std::move(found_here)));
      if (probe.first_only && by_horizon() && is_contact(out.events.back().outcome)) {
        until = std::min(until, out.events.back().toi_upper);
      }
    }
    if (probe.first_only) {
      double first = kInfinity<double>;
      for (const Event& event : out.events) {
        if (is_contact(event.outcome)) first = std::min(first, event.toi_upper);
      }
      std::erase_if(out.events, [&](const Event& event) { return event.toi_lower > first; });
    }
    sort_probe(out.events);
    return out;
  }

  template <class NameOfA>
  void sort_by(std::vector<Event>& events, const NameOfA& name_of_a) const {
    std::sort(events.begin(), events.end(), [&](const Event& l, const Event& r) {
      if (l.toi_lower != r.toi_lower) return l.toi_lower < r.toi_lower;
      if (l.toi_upper != r.toi_upper) return l.toi_upper < r.toi_upper;
      if (const int order = name_of_a(l).compare(name_of_a(r)); order != 0) return order < 0;
      if (const int order = scene_.bodies[l.b].name.compare(scene_.bodies[r.b].name); order != 0)
        return order < 0;
      return l.a != r.a ? l.a < r.a : l.b < r.b;
    });
  }
  void sort(std::vector<Event>& events) const {
    sort_by(events, [&](const Event& event) -> const std::string& { return scene_.bodies[event.a].name; });
  }
  void sort_probe(std::vector<Event>& events) const {
    sort_by(events, [&](const Event& event) -> const std::string& { return scene_.probes[event.a].name; });
  }

  const Scene& scene_;
  const Options& options_;
  Memory* memory_;
  std::optional<Recall> recall_;
  Report report_;
  std::uint64_t work_ = 0, done_ = 0;
};

}  // namespace

std::string over_budget_text(std::uint64_t most_pairs) {
  return "more than " + std::to_string(most_pairs) +
         " pairs of bodies may meet, which is the budget; part them by groups and masks, or raise the budget";
}

Probe ray(std::string name, const Vec3<double>& origin, const Vec3<double>& displacement, double t_max) {
  Probe out;
  out.name = std::move(name);
  out.body.body = {.shape = Point<double>{}, .position = origin, .displacement = displacement};
  out.t_max = t_max;
  return out;
}

Report run(const Scene& scene, const Options& options) { return Run(scene, options, nullptr)(); }

Report run(const Scene& scene, const Options& options, Memory& memory) {
  return Run(scene, options, &memory)();
}

}  // namespace graze::scene
