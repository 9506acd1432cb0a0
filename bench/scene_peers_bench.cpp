// Whole scenes beside Bullet's and FCL's broad phases with their casts: their times and the contacts that they miss.
//
//   scene_peers_bench FILE...     scenes, graze.scene/1, and always 1,000 and 10,000 boxes in flight
//
// One thread. The time is processor time of a step with bounds, broad phase and casts, each engine in turn, the best of
// seven. Answers are compared with tier certified:
//
//   - missed: the other engine denies a contact that certified proves
//   - late: a contact more than a thousandth of the step after its bracket
//   - false: a contact that certified disproves
//
// The counts in brackets are those with a margin. A missed contact remains when both bodies are a hundredth smaller. A
// false one is still a miss when both are a hundredth larger. Runs that abort or take more than a minute in a process
// of their own are not timed.
#include <fmt/format.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <functional>
#include <map>

#include "bench/scene_peers.hpp"
#include "scene/format/scene_io.hpp"

namespace graze::bench {
namespace {

constexpr int kRounds = 7;

struct Contender {
  std::string name;
  std::function<PeerAnswer()> run;
  PeerAnswer answer = {};
  double seconds = kInfinity<double>;
};

scene::Options options_of(const scene::Options& given, Tier tier) {
  scene::Options out = given;
  out.tier = tier;
  out.ask = scene::Ask::pair;
  out.request = Request::verdict;
  out.threads = 1;
  return out;
}

PeerAnswer answer_of(const scene::Report& report) {
  PeerAnswer out;
  out.pairs = report.counts.simulated();
  for (const scene::Event& event : report.events) {
    if (event.outcome != Outcome::not_converged) out.contacts.push_back({event.a, event.b, event.toi_lower});
  }
  return out;
}

using Truth = std::map<std::pair<std::uint32_t, std::uint32_t>, scene::Event>;

Shape<double> scaled(const Shape<double>& shape, double by) {
  Shape<double> out = shape;
  if (auto* box = std::get_if<Box<double>>(&out)) box->half_extents *= by;
  if (auto* sphere = std::get_if<Sphere<double>>(&out)) sphere->radius *= by;
  const auto rod = [&](auto* one) {
    if (!one) return;
    one->radius *= by;
    one->half_height *= by;
  };
  rod(std::get_if<Capsule<double>>(&out));
  rod(std::get_if<Cylinder<double>>(&out));
  return out;
}
bool is_contact(Outcome outcome) {
  return outcome == Outcome::hit || outcome == Outcome::initially_overlapping;
}
bool touch(const scene::Scene& all, std::pair<std::uint32_t, std::uint32_t> pair, double t_max, double size) {
  RotatingBody<double> a = all.bodies[pair.first].body, b = all.bodies[pair.second].body;
  a.body.shape = scaled(a.body.shape, size);
  b.body.shape = scaled(b.body.shape, size);
  RotatingOptions<double> options;
  options.tier = Tier::certified;
  options.t_max = t_max;
  return is_contact(cast(a, b, options).outcome);
}

void judge(const Contender& one, const Truth& truth, const scene::Scene& all, double t_max, double base) {
  std::size_t late = 0, wrong = 0, clearly_wrong = 0, missed = 0, clearly_missed = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> said;
  for (const PeerContact& contact : one.answer.contacts) said[{contact.a, contact.b}] = contact.time;
  for (const auto& [pair, time] : said) {
    const auto known = truth.find(pair);
    if (known == truth.end()) {
      ++wrong;
      clearly_wrong += touch(all, pair, t_max, 1.01) ? 0u : 1u;
    } else {
      late += is_contact(known->second.outcome) && time > known->second.toi_upper + 1e-3 * t_max ? 1u : 0u;
    }
  }
  for (const auto& [pair, event] : truth) {
    if (!is_contact(event.outcome) || said.contains(pair)) continue;
    ++missed;
    clearly_missed += touch(all, pair, t_max, 0.99) ? 1u : 0u;
  }
  fmt::print(" {} | {:.3g} | {:.2f} | {} | {} ({}) | {} | {} ({}) |\n", one.name, 1e3 * one.seconds,
             one.seconds / base, one.answer.pairs, missed, clearly_missed, late, wrong, clearly_wrong);
}

// In a process of its own, because an assertion in the other engine ends it.
bool survives(const PeerScene& peer) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    std::freopen("/dev/null", "w", stderr);
    alarm(60);
    const PeerAnswer answer = peer.run();
    _exit(answer.pairs < answer.contacts.size() ? 1 : 0);
  }
  int status = 0;
  return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void compare(const std::string& id, const scene::Scene& all, const scene::Options& given) {
  Truth truth;
  for (const scene::Event& event : scene::run(all, options_of(given, Tier::certified)).events)
    truth[{event.a, event.b}] = event;
  std::vector<Contender> contenders;
  for (const Tier tier : {Tier::standard, Tier::certified}) {
    contenders.push_back({fmt::format("graze, {}", to_text(tier)), [&all, options = options_of(given, tier)] {
                            return answer_of(scene::run(all, options));
                          }});
  }
  std::vector<std::unique_ptr<PeerScene>> peers;
  const auto add = [&](const char* name, std::unique_ptr<PeerScene> peer) {
    if (!peer) {
      fmt::print("| {} | {} | - | - | cannot be asked | | | |\n", id, name);
      return;
    }
    if (!survives(*peer)) {
      fmt::print("| {} | {} | - | - | aborts | | | |\n", id, name);
      return;
    }
    contenders.push_back({name, [scene = peer.get()] { return scene->run(); }});
    peers.push_back(std::move(peer));
  };
#ifdef GRAZE_BENCH_BULLET
  add("Bullet", bullet_scene(all, given.t_max));
#endif
#ifdef GRAZE_BENCH_FCL
  add("FCL", fcl_scene(all, given.t_max));
#endif
  for (int round = 0; round < kRounds; ++round) {
    for (Contender& one : contenders) {
      const std::clock_t start = std::clock();
      one.answer = one.run();
      one.seconds = std::min(one.seconds, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
  }
  for (const Contender& one : contenders) {
    fmt::print("| {} ({}) |", id, truth.size());
    judge(one, truth, all, given.t_max, contenders.front().seconds);
  }
  std::fflush(stdout);
}

// One box in eight cubes of its size, each of which flies up to two sizes along each axis.
scene::Scene boxes_in_flight(std::size_t n) {
  std::uint64_t state = 22;
  const auto between = [&](double low, double high) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + static_cast<double>(state >> 11) * 0x1p-53 * (high - low);
  };
  const double half = std::cbrt(static_cast<double>(n));
  const auto vector = [&](double most) -> Vec3<double> {
    return {between(-most, most), between(-most, most), between(-most, most)};
  };
  scene::Scene out;
  for (std::size_t k = 0; k < n; ++k) {
    scene::Member member;
    member.body.body.shape = Box<double>{Vec3<double>::Constant(0.5)};
    member.body.body.position = vector(half);
    member.body.body.displacement = vector(2);
    const Vec3<double> axis = vector(1);
    member.body.body.orientation = {1, axis[0], axis[1], axis[2]};
    out.bodies.push_back(std::move(member));
  }
  return out;
}

}  // namespace
}  // namespace graze::bench

int main(int count, char** words) {
  fmt::print("| scene (contacts) | | ms | times | pairs cast | missed | late | false |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (int k = 1; k < count; ++k) {
    const graze::scene::ReadResult read = graze::scene::read_scene_file(words[k]);
    if (!read.document) {
      fmt::print(stderr, "{}: no scene; graze scene says what is wrong with it\n", words[k]);
      return 2;
    }
    graze::bench::compare(read.document->id, read.document->scene, read.document->options);
  }
  for (const std::size_t n : {std::size_t{1000}, std::size_t{10'000}})
    graze::bench::compare(fmt::format("{} boxes", n), graze::bench::boxes_in_flight(n), {});
  return 0;
}
