// graze scene: finds the first contacts in a scene, and shows what had to be simulated to find them.
#include <fmt/format.h>

#include <ctime>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <thread>

#include "reports/pages/page.hpp"
#include "reports/pages/play.hpp"
#include "reports/text/counted.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/progress.hpp"
#include "reports/text/stop.hpp"
#include "reports/text/table.hpp"
#include "scene/format/report_json.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/options.hpp"
#include "tools/commands/scene_steps.hpp"

namespace graze::tool {
namespace {

struct SceneSettings {
  std::vector<std::string> files, economies, without;
  std::string tier, ask, proofs, report;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::uint64_t most_pairs = scene::Options{}.most_pairs;
  bool json = false, plan = false, gains = false;
  int steps = 0;
};

// --gains runs at most this number of rounds, or until this processor time is spent.
constexpr int kMostGainRounds = 15;
constexpr double kGainsSeconds = 8;

std::string economy_names() {
  std::string text;
  for (int k = 0; k < scene::kEconomies; ++k) {
    text += (k > 0 ? ", " : "") + std::string(to_text(static_cast<scene::Economy>(k)));
  }
  return text;
}

scene::Economy economy_of(const std::string& option, const std::string& name) {
  for (int k = 0; k < scene::kEconomies; ++k) {
    if (name == to_text(static_cast<scene::Economy>(k))) return static_cast<scene::Economy>(k);
  }
  throw std::runtime_error(
      fmt::format("{}: {} is no economy; it is one of {}", option, name, economy_names()));
}

scene::Economies economies_of(const SceneSettings& settings) {
  scene::Economies out;
  if (!settings.economies.empty()) {
    out = scene::Economies::none();
    for (const std::string& name : settings.economies) {
      if (name != "none") out = out.with(economy_of("--economy", name));
    }
  }
  for (const std::string& name : settings.without) out = out.without(economy_of("--without", name));
  return out;
}

template <class Enum>
Enum choice(const std::string& option, const std::string& name, int count) {
  std::string known;
  for (int k = 0; k < count; ++k) {
    if (name == to_text(static_cast<Enum>(k))) return static_cast<Enum>(k);
    known += (k == 0 ? "" : k + 1 < count ? ", " : " or ") + std::string(to_text(static_cast<Enum>(k)));
  }
  throw std::runtime_error(fmt::format("{}: {} is not a value; it is {}", option, name, known));
}

std::string vector_text(const Vec3<double>& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v[0], v[1], v[2]);
}

class SceneRun {
 public:
  explicit SceneRun(const SceneSettings& given) : settings_(given), economies_(economies_of(given)) {
    will_read(given.files);
    if (given.plan && given.gains)
      throw std::runtime_error("--plan: nothing is cast, so --gains has no meaning beside it");
    if (given.plan && given.steps > 0)
      throw std::runtime_error("--plan: nothing is cast, so --steps has no meaning beside it");
    if (given.plan && !given.report.empty())
      throw std::runtime_error("--plan: nothing is cast, so there is nothing for --report to play");
    if (!given.report.empty()) {
      require_folder(given.report);
      require_own_file(page_file());
    }
    if (!given.tier.empty()) tier_ = choice<Tier>("--tier", given.tier, 3);
    if (!given.ask.empty()) ask_ = choice<scene::Ask>("--ask", given.ask, scene::kAsks);
    if (!given.proofs.empty()) proofs_ = std::make_unique<OutputFile>(given.proofs);
  }

  int operator()() {
    for (const std::string& file : settings_.files) {
      if (StopBySignal::received() != 0) break;
      scene::ReadResult read =
          file == "-" ? scene::read_scene_text(read_stdin(), "standard input") : scene::read_scene_file(file);
      for (const corpus::ReadError& error : read.errors) refuse(error.text());
      if (read.document) play(file, *read.document);
    }
    const int signal = StopBySignal::received();
    if (proofs_) bad_ || signal != 0 ? proofs_->close_what_is_written() : proofs_->close();
    if (!settings_.report.empty()) write_page();
    if (signal != 0) return 128 + signal;
    return bad_ ? 2 : 0;
  }

 private:
  // Standard output has one document. If proofs go there, the events go to stderr.
  [[nodiscard]] std::FILE* screen() const { return settings_.proofs == "-" ? stderr : stdout; }
  void refuse(const std::string& why) {
    complain(why);
    bad_ = true;
  }

  void play(const std::string& file, scene::Document& document) {
    scene::Options& options = document.options;
    if (tier_) options.tier = *tier_;
    if (ask_) options.ask = *ask_;
    if (proofs_) options.request = options.request | Request::proof;
    options.economies = economies_;
    options.threads = settings_.threads;
    options.most_pairs = settings_.most_pairs;
    if (settings_.plan) return show_plan(file, document);
    const scene::Report report = run(document);
    if (!report.wrong.empty()) return refuse(fmt::format("{}: {}", file, report.wrong));
    if (settings_.json) {
      fmt::print(screen(), "{}\n", scene::write_report(document, report));
    } else {
      show(document, report);
    }
    if (report.status == scene::Status::interrupted) {
      complain(fmt::format("{}: interrupted with {} left; the results so far are shown", file,
                           counted(report.counts.unfinished, "pair")));
    }
    if (proofs_) write_proofs(document, report);
    if (!settings_.report.empty()) {
      plays_.push_back(show::play_of(document, report, {.command = command_for(file)}));
      plain_ += fmt::format("{}\n{}\n", document.id, scene::to_text(report.counts));
    }
    if (report.status != scene::Status::complete) return;
    if (settings_.gains) show_gains(document);
    if (settings_.steps > 0) {
      SceneSteps steps(document, settings_.steps);
      if (steps.run()) fmt::print(screen(), "{}", steps.table().text());
    }
  }

  // With progress on stderr, and a stop by signal between two parts.
  scene::Report run(const scene::Document& document) const {
    scene::Options options = document.options;
    std::unique_ptr<Progress> progress;
    options.progress = [&](std::uint64_t done, std::uint64_t total) {
      if (!progress && total > 0) progress = std::make_unique<Progress>(document.id, total);
      if (progress) progress->reach(done);
      return StopBySignal::received() == 0;
    };
    return scene::run(document.scene, options);
  }

  [[nodiscard]] std::string page_file() const {
    return (std::filesystem::path(settings_.report) / "index.html").string();
  }
  // The command that plays the file again.
  [[nodiscard]] std::string command_for(const std::string& file) const {
    std::string text = "graze scene " + shell_word(file == "-" ? "scene.json" : file);
    for (const std::string& name : settings_.economies) text += " --economy " + name;
    for (const std::string& name : settings_.without) text += " --without " + name;
    if (!settings_.tier.empty()) text += " --tier " + settings_.tier;
    if (!settings_.ask.empty()) text += " --ask " + settings_.ask;
    return text + " --report report";
  }

  // There is no page without a scene. The error in reading it was already reported.
  void write_page() {
    if (plays_.empty()) return;
    const std::string title = plays_.size() == 1 ? "graze: " + plays_[0].value("id", "")
                                                 : fmt::format("graze: {} scenes", plays_.size());
    const std::string html = show::page_html(
        title,
        {{"schema", "graze.page/1"}, {"kind", "play"}, {"title", title}, {"scenes", std::move(plays_)}},
        plain_);
    OutputFile out(page_file());
    out.write_line(html.substr(0, html.size() - 1));
    out.close();
    if (!show::has_viewer())
      complain("this graze was built without Node: the page lacks the player (docs/howto/show.md)");
  }

  void show_plan(const std::string& file, const scene::Document& document) {
    const scene::Planned planned = scene::plan(document.scene, document.options);
    if (!planned.wrong.empty()) return refuse(fmt::format("{}: {}", file, planned.wrong));
    if (settings_.json) {
      fmt::print(screen(), "{}\n", scene::write_plan(document, planned));
      return;
    }
    fmt::print(screen(), "{}\n{}", document.id, scene::to_text(planned.counts));
    for (const scene::PairPlan& pair : planned.pairs) {
      fmt::print(screen(), "  {} - {}: {}, not before t = {:.6g}\n", document.scene.bodies[pair.a].name,
                 document.scene.bodies[pair.b].name, to_text(pair.plan.effects), pair.begin);
    }
  }

  void show_event(const scene::Event& event, const std::string& a, const std::string& b,
                  Request request) const {
    std::string text = fmt::format("  t = {:<12.9g} {} - {}", event.toi_lower, a, b);
    if (event.outcome == Outcome::initially_overlapping) text += ", in contact at the start";
    if (event.outcome == Outcome::not_converged) text += fmt::format(", open up to {:.9g}", event.toi_upper);
    if (event.outcome == Outcome::hit && asks_for(request, Request::normal)) {
      text += ", normal " + vector_text(event.normal);
    }
    fmt::print(screen(), "{}  [{}]\n", text, to_text(event.effects));
  }

  void show(const scene::Document& document, const scene::Report& report) const {
    const scene::Scene& all = document.scene;
    const Request request = document.options.request;
    fmt::print(screen(), "{}: {}, {}\n", document.id, to_text(document.options.tier),
               counted(report.events.size(), "event"));
    for (const scene::Event& event : report.events) {
      show_event(event, all.bodies[event.a].name, all.bodies[event.b].name, request);
    }
    if (!all.probes.empty())
      fmt::print(screen(), "rays and casts: {}\n", counted(report.probe_events.size(), "event"));
    for (const scene::Event& event : report.probe_events) {
      show_event(event, all.probes[event.a].name, all.bodies[event.b].name, request);
    }
    fmt::print(screen(), "{}bounds {:.3g} ms, casts {:.3g} ms\n", scene::to_text(report.counts),
               1e3 * report.times.bounds, 1e3 * report.times.casts);
  }

  void write_proofs(const scene::Document& document, const scene::Report& report) {
    for (const auto* events : {&report.events, &report.probe_events}) {
      for (const scene::Event& event : *events) {
        if (event.proof)
          proofs_->write_line(scene::write_event_proof(document, event, events != &report.events));
      }
    }
  }

  struct Variant {
    std::string name;
    scene::Economies economies;
    scene::Report report = {};
    double seconds = kInfinity<double>;
  };

  // Prints the savings of each economy, with each turned off alone and with all turned off. One thread,
  // processor time. The variants take turns, so that other load on the machine is spread over them, and each
  // variant's best run counts.
  void show_gains(scene::Document document) {
    std::vector<Variant> variants = {{"-", economies_}};
    for (int k = 0; k < scene::kEconomies; ++k) {
      const auto one = static_cast<scene::Economy>(k);
      if (economies_.has(one)) variants.push_back({std::string(to_text(one)), economies_.without(one)});
    }
    variants.push_back({"all of them", scene::Economies::none()});
    document.options.threads = 1;
    double spent = 0;
    for (int round = 0; round < kMostGainRounds && spent < kGainsSeconds; ++round) {
      for (Variant& variant : variants) {
        if (StopBySignal::received() != 0) return;
        document.options.economies = variant.economies;
        const std::clock_t start = std::clock();
        variant.report = scene::run(document.scene, document.options);
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        variant.seconds = std::min(variant.seconds, seconds);
        spent += seconds;
      }
    }
    Table table({{"without", Align::left},
                 {"casts"},
                 {"static"},
                 {"linear"},
                 {"rotating"},
                 {"supports"},
                 {"ms"},
                 {"times"},
                 {"events"}});
    for (const Variant& variant : variants) table.add_row(row_of(variant, variants.front().seconds));
    fmt::print(screen(), "{}", table.text());
  }
  static std::vector<std::string> row_of(const Variant& variant, double base) {
    const scene::Report& report = variant.report;
    if (!report.wrong.empty()) return {variant.name, "over the budget", "", "", "", "", "", "", ""};
    const scene::Counts& counts = report.counts;
    return {variant.name,
            fmt::to_string(counts.simulated() - counts.effects[0] + counts.probe_casts),
            fmt::to_string(counts.effects[1]),
            fmt::to_string(counts.effects[2]),
            fmt::to_string(counts.effects[3]),
            fmt::to_string(report.counters.supports),
            fmt::format("{:.3g}", 1e3 * variant.seconds),
            fmt::format("{:.2f}", variant.seconds / base),
            fmt::to_string(report.events.size() + report.probe_events.size())};
  }

  SceneSettings settings_;
  scene::Economies economies_;
  std::optional<Tier> tier_;
  std::optional<scene::Ask> ask_;
  std::unique_ptr<OutputFile> proofs_;
  nlohmann::ordered_json plays_ = nlohmann::ordered_json::array();
  std::string plain_;
  const StopBySignal signals_;
  bool bad_ = false;
};

}  // namespace

void add_scene_command(CLI::App& app, int& exit_code) {
  const auto settings = std::make_shared<SceneSettings>();
  CLI::App* command =
      app.add_subcommand("scene", "Finds the first contacts in a scene of many bodies, rays and casts.");
  command->add_option("files", settings->files, "Scenes, graze.scene/1, one a file; - is standard input")
      ->required()
      ->type_name("FILE");
  command->add_flag(
      "--json", settings->json,
      "One JSON object per scene, graze.events/1: bodies, motions, events and the plan's counts. Its bits "
      "do not depend on the threads");
  command->add_flag("--plan", settings->plan, "Only say what would be simulated, pair by pair, and why");
  command->add_flag(
      "--gains", settings->gains,
      "Also run with each economy off, alone and together: shows what each saves, in casts and in time");
  command
      ->add_option("--steps", settings->steps,
                   "Also cut the scene's step into so many, each after the one before, with a memory and "
                   "without: shows what a memory saves, in casts and in time")
      ->check(whole_number(1, 100'000))
      ->type_name("N");
  command->add_option("--economy", settings->economies, "Only these economies, or none; see below")
      ->type_name("NAME...");
  command->add_option("--without", settings->without, "All economies but these")->type_name("NAME...");
  command->add_option("--tier", settings->tier, "standard, certified or exact, whatever the scene says")
      ->type_name("NAME");
  command
      ->add_option(
          "--ask", settings->ask,
          "Replaces the scene's own: pair (each pair's first contact), body (each body's), first (the "
          "scene's) or verdict (does anything touch?)")
      ->type_name("NAME");
  command
      ->add_option("--proof,--proofs", settings->proofs, "Also write the events' proofs, for `graze check`")
      ->type_name("OUT.jsonl");
  command
      ->add_option("--report", settings->report,
                   "Write a page that plays the scenes, with their events: index.html in this folder")
      ->type_name("DIR");
  command->add_option("--threads", settings->threads, "By default as many as the machine runs at once")
      ->check(whole_number(1, kMostThreads))
      ->type_name("N");
  command
      ->add_option("--most-pairs", settings->most_pairs,
                   "A scene in which more pairs than these may meet is refused (by default 16000000)")
      ->check(whole_number(1))
      ->type_name("N");
  command->footer(
      "An event is the first contact of two bodies. Events are sorted by time, and by name at equal "
      "times.\n"
      "Rays and casts see the bodies where they are at t = 0.\n\n"
      "Economies: " +
      economy_names() +
      ".\n"
      "All are on by default, and none changes a verdict: the default needs no change. "
      "docs/reports/scenes.md says what\n"
      "each saves.\n\n"
      "  graze scene examples/scenes/*.json\n"
      "  graze scene --plan examples/scenes/fan.json\n"
      "  graze scene --ask first --gains examples/scenes/bullets.json\n"
      "  graze scene --steps 100 examples/scenes/fan.json\n"
      "  graze scene examples/scenes/*.json --report played     a page to look at: played/index.html\n\n"
      "Exit code: 0, or 2 if a scene could not be read or run; after an interruption, which shows what is "
      "known, 128\n"
      "and the signal's number.");
  command->callback([settings, &exit_code] { exit_code = SceneRun(*settings)(); });
}

}  // namespace graze::tool
