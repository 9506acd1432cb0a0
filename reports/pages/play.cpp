#include "reports/pages/play.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "corpus/format/json_value.hpp"
#include "reports/pages/mesh.hpp"
#include "reports/pages/mesh_json.hpp"
#include "scene/format/report_json.hpp"

namespace graze::show {
namespace {

using Json = nlohmann::ordered_json;
using scene::Counts;
using scene::Event;

// One of each shape: bodies name theirs by its index.
class Shapes {
 public:
  std::size_t index_of(const Json& shape, const Shape<double>& value) {
    const auto [found, is_new] = places_.emplace(corpus::document_text(shape), list_.size());
    if (is_new)
      list_.push_back({{"shape", shape}, {"mesh", mesh_json(mesh_of(value, draw::Vec::Zero(), kCoarse))}});
    return found->second;
  }
  Json take() { return std::move(list_); }

 private:
  std::map<std::string, std::size_t> places_;
  Json list_ = Json::array();
};

// The bodies of n that are drawn: first those that meet another, in the order of events, then the others.
std::vector<bool> drawn(std::size_t n, const scene::Report& report, std::size_t most) {
  std::vector<bool> out(n);
  std::size_t left = most;
  const auto take = [&](std::size_t k) {
    if (left == 0 || out[k]) return;
    out[k] = true;
    --left;
  };
  for (const Event& event : report.events) {
    take(event.a);
    take(event.b);
  }
  for (const Event& event : report.probe_events) take(event.b);
  for (std::size_t k = 0; k < n && left > 0; ++k) take(k);
  return out;
}

// A sentence that says what was cast and what was not. Its counts are the lines of to_text(Counts).
std::string spared_sentence(const Counts& counts) {
  const std::uint64_t casts = counts.effects[1] + counts.effects[2] + counts.effects[3];
  std::string text =
      fmt::format("{1} of {0} pairs were simulated: {2} by a static overlap, {3} linear, {4} rotating.",
                  counts.pairs, casts, counts.effects[1], counts.effects[2], counts.effects[3]);
  std::string why;
  const auto add = [&](std::uint64_t number, const char* words) {
    if (number > 0) why += fmt::format("{}{} {}", why.empty() ? "" : ", ", number, words);
  };
  add(counts.filtered, "were parted by their filters");
  add(counts.apart, "stay apart at rest");
  add(counts.never_meet, "have swept bounds that never meet");
  add(counts.effects[0], "have bounding spheres that never meet");
  add(counts.moot, "were made moot by an earlier event");
  add(counts.unfinished, "were left undone when the run was interrupted");
  if (!why.empty()) text += " Among the others, " + why + ".";
  if (counts.shortened > 0)
    text += fmt::format(" {} were cast no farther than to an earlier event.", counts.shortened);
  return text;
}

Json lines_of(const Counts& counts) {
  Json out = Json::array();
  std::istringstream lines(scene::to_text(counts));
  for (std::string line; std::getline(lines, line);) out.push_back(line);
  return out;
}

}  // namespace

Json play_of(const scene::Document& document, const scene::Report& report, const PlaySettings& settings) {
  Json out = Json::parse(scene::write_report(document, report));
  out["schema"] = "graze.play/1";
  out["comment"] = document.comment;
  out["command"] = settings.command;
  Shapes shapes;
  const std::vector<bool> is_drawn = drawn(document.scene.bodies.size(), report, settings.most_bodies);
  Json bodies = Json::array();
  for (std::size_t k = 0; k < is_drawn.size(); ++k) {
    if (!is_drawn[k]) continue;
    Json body = std::move(out["bodies"][k]);
    body["shape"] = shapes.index_of(body["shape"], document.scene.bodies[k].body.body.shape);
    bodies.push_back(std::move(body));
  }
  for (std::size_t k = 0; k < document.scene.probes.size(); ++k) {
    Json& probe = out["probes"][k];
    probe["shape"] = shapes.index_of(probe["shape"], document.scene.probes[k].body.body.shape);
  }
  out["left_out"] = {{"bodies", is_drawn.size() - bodies.size()}};
  out["bodies"] = std::move(bodies);
  for (const char* list : {"events", "probe_events"}) {
    Json& events = out[list];
    const std::size_t all = events.size(), kept = std::min(all, settings.most_events);
    events.erase(events.begin() + static_cast<std::ptrdiff_t>(kept), events.end());
    out["left_out"][list] = all - kept;
  }
  out["shapes"] = shapes.take();
  out["spared"] = {{"sentence", spared_sentence(report.counts)}, {"counts", lines_of(report.counts)}};
  return out;
}

}  // namespace graze::show
