// The cost of a rotating cast: the savings of the plan, the cost of each request, and the methods beside each other.
//
// The contestants of a scene get the same pairs in rounds, in one run. In each round they take turns in a random order.
// Each sweeps over all pairs in a new random order, and the round's time is this thread's processor time over the
// number of pairs. Shown is the median over the rounds, and a ratio is the median of the rounds' ratios. The first
// round only warms up. Bodies are built once, and casts include their validation.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <functional>
#include <graze/cast.hpp>
#include <graze/detail/rotating/moving_pair.hpp>
#include <graze/rotating_cast.hpp>
#include <numeric>

#include "bench/rotating_scenes.hpp"
#include "corpus/random.hpp"

namespace graze::bench {
namespace {

double processor_ns() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

struct Answer {
  Outcome outcome = Outcome::invalid_input;
  Effects effects = Effects::rotating;
  double lower = 0, upper = 0, hidden = 0;
  Counters counters;
  [[nodiscard]] bool contact() const {
    return outcome == Outcome::hit || outcome == Outcome::initially_overlapping;
  }
};

struct Contestant {
  std::string name;
  std::function<Answer(const MovingBodies&)> ask;
};

Contestant rotating(std::string name, RotatingOptions<double> options) {
  return {std::move(name), [options](const MovingBodies& pair) {
            const auto r = cast(pair.a, pair.b, options);
            return Answer{r.outcome, r.plan.effects, r.toi_lower, r.toi_upper, r.hidden_motion, r.counters};
          }};
}
Contestant linear(std::string name, CastOptions<double> options) {
  return {std::move(name), [options](const MovingBodies& pair) {
            const auto r = cast(pair.a.body, pair.b.body, options);
            return Answer{r.outcome, Effects::linear, r.toi_lower, r.toi_upper, 0, r.counters};
          }};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Measured {
  std::vector<double> round_ns;  // a cast, by round
  std::vector<Answer> answers;   // by pair
  [[nodiscard]] double ns() const { return median(round_ns); }
  [[nodiscard]] double mean(int Counters::*counter) const {
    double sum = 0;
    for (const Answer& a : answers) sum += a.counters.*counter;
    return sum / static_cast<double>(answers.size());
  }
};

double ratio(const Measured& top, const Measured& bottom) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < top.round_ns.size(); ++i) {
    ratios.push_back(top.round_ns[i] / bottom.round_ns[i]);
  }
  return median(std::move(ratios));
}

class Rounds {
 public:
  explicit Rounds(int rounds) : rounds_(rounds) {}

  std::vector<Measured> operator()(const std::vector<MovingBodies>& pairs,
                                   const std::vector<Contestant>& field) {
    std::vector<Measured> out(field.size());
    for (Measured& m : out) m.answers.resize(pairs.size());
    std::vector<std::size_t> order(pairs.size()), turns(field.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::iota(turns.begin(), turns.end(), std::size_t{0});
    for (int round = -1; round < rounds_; ++round) {
      shuffle(turns);
      for (const std::size_t i : turns) {
        shuffle(order);
        const double start = processor_ns();
        for (const std::size_t k : order) out[i].answers[k] = field[i].ask(pairs[k]);
        const double ns = (processor_ns() - start) / static_cast<double>(pairs.size());
        if (round >= 0) out[i].round_ns.push_back(ns);
      }
    }
    return out;
  }

 private:
  void shuffle(std::vector<std::size_t>& order) {
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random_.below(k)]);
  }
  int rounds_;
  corpus::Random random_{1};
};

// Three digits or so.
std::string number(double x) {
  return x >= 100 ? fmt::format("{:.0f}", x) : x >= 10 ? fmt::format("{:.1f}", x) : fmt::format("{:.2f}", x);
}
std::string microseconds(double ns) { return number(ns / 1000); }

void print_row(const std::vector<std::string>& cells) { fmt::print("| {} |\n", fmt::join(cells, " | ")); }
void print_head(const std::vector<std::string>& cells) {
  print_row(cells);
  print_row(std::vector<std::string>(cells.size(), "---"));
}

// The plan's effects. If the pairs differ, the number of pairs for each effect.
std::string simulated(const Measured& m) {
  std::array<std::size_t, 4> counts{};
  for (const Answer& a : m.answers) ++counts[static_cast<std::size_t>(a.effects)];
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::string_view name = to_text(static_cast<Effects>(i));
    if (counts[i] == m.answers.size()) return std::string(name);
    if (counts[i] > 0) parts.push_back(fmt::format("{} {}", name, counts[i]));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

// Pairs whose verdicts differ, or whose brackets do not meet by more than the slack.
std::size_t disagreements(const Measured& l, const Measured& r) {
  constexpr double kSlack = 1e-6;  // of t: where a path grazes, the root of the rounding of a length
  std::size_t out = 0;
  for (std::size_t k = 0; k < l.answers.size(); ++k) {
    const Answer &x = l.answers[k], &y = r.answers[k];
    const bool same = x.contact() == y.contact() &&
                      (!x.contact() || (x.lower <= y.upper + kSlack && y.lower <= x.upper + kSlack));
    out += same ? 0 : 1;
  }
  return out;
}

void print_plan_table(std::size_t pairs, Rounds& rounds) {
  fmt::print("\n### What the plan saves\n\n");
  print_head({"pairs", "simulated", "with the plan, us", "without economies, us", "bilateral by name, us",
              "without : with", "by name : with", "supports, with / by name", "poses, with / by name",
              "verdicts that differ"});
  for (const Scene& scene : scenes_of_the_plan(pairs)) {
    RotatingOptions<double> options;
    options.request = Request::verdict;
    options.tolerance = scene.tolerance;
    std::vector<Contestant> field = {rotating("plan", options)};
    options.economies = Economies::none();
    field.push_back(rotating("none", options));
    options.method = RotatingMethod::bilateral_advancement;
    field.push_back(rotating("bilateral", options));
    const std::vector<Measured> m = rounds(scene.pairs, field);
    print_row(
        {scene.name, simulated(m[0]), microseconds(m[0].ns()), microseconds(m[1].ns()),
         microseconds(m[2].ns()), number(ratio(m[1], m[0])), number(ratio(m[2], m[0])),
         fmt::format("{} / {}", number(m[0].mean(&Counters::supports)),
                     number(m[2].mean(&Counters::supports))),
         fmt::format("{} / {}", number(m[0].mean(&Counters::poses)), number(m[2].mean(&Counters::poses))),
         fmt::format("{}", disagreements(m[0], m[1]) + disagreements(m[0], m[2]))});
  }
}

void print_request_table(std::size_t pairs, Rounds& rounds) {
  fmt::print("\n### Cost of each request\n\n");
  print_head({"pairs", "cast", "verdict, us", "+ normal", "+ witnesses", "+ both", "+ proof", "all"});
  constexpr Request kRequests[] = {Request::verdict,   Request::normal,
                                   Request::witnesses, Request::normal | Request::witnesses,
                                   Request::proof,     Request::everything};
  for (const Scene& scene : scenes_of_requests(pairs)) {
    const bool turns = scene.pairs.front().a.rotation != Vec3<double>::Zero();
    for (const bool by_plan : {false, true}) {
      if (turns && !by_plan) continue;
      std::vector<Contestant> field;
      for (const Request request : kRequests) {
        field.push_back(by_plan ? rotating("", {.request = request}) : linear("", {.request = request}));
      }
      const std::vector<Measured> m = rounds(scene.pairs, field);
      std::vector<std::string> row = {scene.name, by_plan ? "rotating" : "linear", microseconds(m[0].ns())};
      for (std::size_t i = 1; i < m.size(); ++i) row.push_back(number(ratio(m[i], m[0])));
      print_row(row);
    }
  }
}

RotatingOptions<double> with(std::optional<RotatingMethod> method, int steps = 64) {
  RotatingOptions<double> out;
  out.request = Request::verdict;
  out.method = method;
  out.time_steps = steps;
  return out;
}

std::vector<Contestant> methods() {
  RotatingOptions<double> certified = with({});
  certified.tier = Tier::certified;
  return {
      rotating("64 steps", with(RotatingMethod::time_steps)),
      rotating("512 steps", with(RotatingMethod::time_steps, 512)),
      rotating("spheres, 64", with(RotatingMethod::bounding_spheres)),
      rotating("conservative", with(RotatingMethod::conservative_advancement)),
      rotating("bilateral", with(RotatingMethod::bilateral_advancement)),
      rotating("as published", with(RotatingMethod::bilateral_published)),
      rotating("certified", certified),
  };
}
constexpr std::size_t kBilateral = 4, kCertified = 6;

struct Mistakes {
  std::size_t missed = 0, invented = 0, open = 0;  // contacts denied, contacts claimed, no verdict
  double late = 0;                                 // the worst, of t
};

// Compared with the answer that the construction knows, or else with certified.
Mistakes mistakes(const Scene& scene, const Measured& m, const Measured& certified) {
  Mistakes out;
  for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
    const Answer &given = m.answers[k], &best = certified.answers[k];
    const bool contact = scene.pairs[k].contact.value_or(best.contact());
    if (given.outcome == Outcome::not_converged) {
      ++out.open;
    } else if (given.contact() != contact) {
      ++(contact ? out.missed : out.invented);
    }
    if (given.contact() && best.contact()) out.late = std::max(out.late, given.lower - best.upper);
  }
  return out;
}

std::string text_of(const Mistakes& m) {
  std::vector<std::string> parts;
  if (m.missed > 0) parts.push_back(fmt::format("{} missed", m.missed));
  if (m.invented > 0) parts.push_back(fmt::format("{} invented", m.invented));
  if (m.open > 0) parts.push_back(fmt::format("{} open", m.open));
  if (m.late > 1e-9) parts.push_back(fmt::format("late by {:.2g}", m.late));
  return parts.empty() ? "-" : fmt::format("{}", fmt::join(parts, ", "));
}

void print_method_tables(std::size_t pairs, Rounds& rounds) {
  const std::vector<Contestant> field = methods();
  const std::vector<Scene> scenes = scenes_of_methods(pairs);
  std::vector<std::vector<Measured>> measured;
  measured.reserve(scenes.size());
  for (const Scene& scene : scenes) measured.push_back(rounds(scene.pairs, field));

  const auto print_table = [&](const char* title, const auto& cell) {
    fmt::print("\n{}\n\n", title);
    std::vector<std::string> row = {"pairs"};
    for (const Contestant& c : field) row.push_back(c.name);
    print_head(row);
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      row.assign(1, scenes[s].name);
      for (std::size_t i = 0; i < field.size(); ++i) row.push_back(cell(s, i));
      print_row(row);
    }
  };
  fmt::print("\n### Methods\n");
  print_table("Microseconds a cast; in brackets, times bilateral's.", [&](std::size_t s, std::size_t i) {
    const Measured& m = measured[s][i];
    const std::string us = microseconds(m.ns());
    return i == kBilateral ? us : fmt::format("{} ({})", us, number(ratio(m, measured[s][kBilateral])));
  });
  print_table("Supports / poses, means.", [&](std::size_t s, std::size_t i) {
    const Measured& m = measured[s][i];
    return fmt::format("{} / {}", number(m.mean(&Counters::supports)), number(m.mean(&Counters::poses)));
  });
  print_table(
      fmt::format(
          "Among {} pairs: verdicts that are wrong, or open, and how late the latest hit was, as a part of "
          "the step.",
          pairs)
          .c_str(),
      [&](std::size_t s, std::size_t i) {
        return text_of(mistakes(scenes[s], measured[s][i], measured[s][kCertified]));
      });
}

// Data for bench/plot_rotating.sh: curve, share left open over scale, microseconds.
void print_accuracy(std::size_t pairs, Rounds& rounds) {
  fmt::print("\n### Time against accuracy\n\n");
  print_head({"curve", "open, over scale", "us"});
  for (const Scene& scene : scenes_of_methods(pairs)) {
    if (scene.name != "ordinary hits" && scene.name != "fast spin, 2^8 rad") continue;
    const std::string kind = scene.name == "ordinary hits" ? "ordinary" : "fast";
    std::vector<Contestant> field;
    std::vector<double> open;
    for (const RotatingMethod method :
         {RotatingMethod::conservative_advancement, RotatingMethod::bilateral_advancement}) {
      for (int k = 3; k <= 12; ++k) {
        RotatingOptions<double> options = with(method);
        options.tolerance = std::pow(10, -k);
        const bool chord = method == RotatingMethod::bilateral_advancement;
        field.push_back(rotating(kind + (chord ? "/bilateral" : "/conservative"), options));
        open.push_back(options.tolerance);
      }
    }
    for (int steps = 16; steps <= 4096; steps *= 4) {
      field.push_back(rotating(kind + "/steps", with(RotatingMethod::time_steps, steps)));
      open.push_back(0);
    }
    const std::vector<Measured> m = rounds(scene.pairs, field);
    for (std::size_t i = 0; i < m.size(); ++i) {
      double left = open[i];
      if (left == 0) {  // for steps: the median of the contacts that they report as possibly missed
        std::vector<double> hidden;
        for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
          const detail::MovingPair pair(scene.pairs[k].a, scene.pairs[k].b, 0);
          hidden.push_back(m[i].answers[k].hidden / pair.cso().to_length(pair.scale()));
        }
        left = median(std::move(hidden));
      }
      print_row({field[i].name, fmt::format("{:.2e}", left), microseconds(m[i].ns())});
    }
  }
}

int run(int argc, char** argv) {
  CLI::App app("Measures what a rotating cast costs: tables in markdown.");
  int rounds = 15;
  std::size_t pairs = 32;
  std::string only;
  app.add_option("--pairs", pairs, "pairs of each scene (four times as many for the plan and the requests)")
      ->check(CLI::Range(4, 1 << 20));
  app.add_option("--rounds", rounds, "rounds that the median is taken over")->check(CLI::PositiveNumber);
  app.add_option("--only", only, "one part of the report")
      ->check(CLI::IsMember({"plan", "requests", "methods", "accuracy"}));
  CLI11_PARSE(app, argc, argv);

  Rounds measure(rounds);
  const auto wanted = [&](const char* part) { return only.empty() || only == part; };
  if (wanted("plan")) print_plan_table(4 * pairs, measure);
  if (wanted("requests")) print_request_table(4 * pairs, measure);
  if (wanted("methods")) print_method_tables(pairs, measure);
  if (wanted("accuracy")) print_accuracy(pairs, measure);
  return 0;
}

}  // namespace
}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
