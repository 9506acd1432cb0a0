// Does any text break the reader of scenes, and does any scene break its plan?
//
//   1. Eight bytes that begin no object are the seed of a random scene, on which the law of scenes is checked.
//   2. Otherwise the bytes are a scene: the reader gives a scene, or one error of one line that names the file.
//   3. The scene is written and read again: the same line.
//   4. Plan and run, within a budget of pairs, report the same about it, and count every pair once.
#include <algorithm>

#include "corpus/format/json_value.hpp"
#include "fuzz/target.hpp"
#include "properties/scenes/generate.hpp"
#include "properties/scenes/law.hpp"
#include "scene/format/report_json.hpp"

namespace graze::fuzz {

namespace {

constexpr const char* kName = "file";
// Rotating casts of hostile numbers take a millisecond each.
constexpr std::uint64_t kMostPairs = 64;

std::string read_fault(const scene::ReadResult& read) {
  if (read.document.has_value() == !read.errors.empty()) return "both a scene and an error, or neither";
  for (const corpus::ReadError& error : read.errors) {
    const std::string text = error.text();
    if (text.find('\n') != std::string::npos) return "an error of several lines: " + text;
    if (text.rfind(std::string(kName) + ":", 0) != 0 || error.what.empty())
      return "an error without a name: " + text;
  }
  return {};
}

std::string run_fault(scene::Document document) {
  document.options.most_pairs = kMostPairs;
  const scene::Planned planned = plan(document.scene, document.options);
  const scene::Report report = run(document.scene, document.options);
  if (planned.wrong != report.wrong)
    return "the plan says \"" + planned.wrong + "\", the run \"" + report.wrong + "\"";
  if (!report.wrong.empty()) return {};
  const scene::Counts& counts = report.counts;
  const std::uint64_t sum =
      counts.filtered + counts.apart + counts.never_meet + counts.moot + counts.simulated();
  if (sum != counts.pairs) return "a pair is counted twice, or never:\n" + to_text(counts);
  if (const auto json = corpus::parse_json(write_report(document, report)); json.error)
    return json.error->what;
  return {};
}

std::string text_fault(std::string_view text) {
  const scene::ReadResult read = scene::read_scene_text(text, kName);
  if (std::string fault = read_fault(read); !fault.empty() || !read.document) return fault;
  const std::string written = write_scene(*read.document);
  const scene::ReadResult again = scene::read_scene_text(written, kName);
  if (!again.document || write_scene(*again.document) != written) {
    return "another scene is read from what was written: " + written;
  }
  return read.document->scene.probes.size() <= kMostPairs ? run_fault(*read.document) : std::string();
}

std::string random_fault(std::span<const std::uint8_t> bytes) {
  std::uint64_t seed = 0;
  for (const std::uint8_t byte : bytes) seed = seed << 8 | byte;
  return law::try_random_scenes(seed, 1).broken;
}

Judged judge_text(std::span<const std::uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const bool seed = bytes.size() == 8 && text.front() != '{';
  Judged judged{.reached = true, .by_oracle = false, .finding = {}};
  if (const std::string fault = seed ? random_fault(bytes) : text_fault(text); !fault.empty()) {
    judged.finding = Finding{
        seed ? "a_scene_spares_nothing_that_counts" : "a_scene_is_read_right", "scene", fault, {}, {}};
  }
  return judged;
}

}  // namespace

const Target kTarget = {.name = "scene_files", .judge = nullptr, .judge_text = &judge_text};

}  // namespace graze::fuzz
