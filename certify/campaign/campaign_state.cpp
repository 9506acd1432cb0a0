#include "certify/campaign/campaign_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "corpus/format/fields.hpp"
#include "corpus/format/json_value.hpp"
#include "corpus/format/names.hpp"

namespace graze::tool {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema = "graze.campaign/2";

}  // namespace

std::uint64_t CampaignState::casts_done() const {
  const std::uint64_t casts = blocks_done() * settings.block;
  const std::uint64_t last = settings.blocks() - 1,
                      missing = settings.blocks() * settings.block - settings.casts();
  return boost::icl::contains(done, last) ? casts - missing : casts;
}

bool CampaignState::is_complete() const {
  return boost::icl::is_empty(share()) || boost::icl::contains(done, share());
}

CampaignState fresh_state(const CampaignPlan& plan, std::uint64_t block, Shard shard) {
  return {.settings = plan.settings(block),
          .shard = shard,
          .cells = plan.cells(),
          .left_out = plan.left_out(),
          .done = {},
          .tally = CampaignTally(plan.cells().size())};
}

namespace {

Json findings_json(const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"index", finding.index},
                    {"method", finding.method},
                    {"family", finding.family},
                    {"level", finding.level},
                    {"seed", finding.seed},
                    {"reason", finding.reason}});
  }
  return list;
}

using Names = std::vector<std::string_view>;

// Describes a value for the first half of a message: `the string "zz"`.
std::string described(const Json& json) {
  constexpr std::size_t kMostQuoted = 60;
  const std::string text = corpus::document_text(json);
  const std::string shown = text.size() > kMostQuoted ? text.substr(0, kMostQuoted) + "..." : text;
  return json.is_string() ? "the string " + shown : json.is_number() ? "the number " + shown : shown;
}

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw std::runtime_error(path.empty() ? what : path + ": " + what);
}

std::string child(const std::string& path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

const Json& array_at(const Json& json, const std::string& path) {
  if (!json.is_array()) refuse(path, described(json) + "; an array");
  return json;
}
std::string text_at(const Json& json, const std::string& path) {
  if (!json.is_string()) refuse(path, described(json) + "; a string");
  return json.get<std::string>();
}
double number_at(const Json& json, const std::string& path) {
  if (!json.is_number()) refuse(path, described(json) + "; a number");
  return json.get<double>();
}
// Nothing negative, no fraction.
std::uint64_t count_at(const Json& json, const std::string& path) {
  if (!json.is_number_unsigned()) refuse(path, described(json) + "; a whole number of 0 or more");
  return json.get<std::uint64_t>();
}
std::vector<std::string> texts_at(const Json& json, const std::string& path) {
  std::vector<std::string> texts;
  for (const Json& one : array_at(json, path))
    texts.push_back(text_at(one, fmt::format("{}[{}]", path, texts.size())));
  return texts;
}

// An object of the state: every field is known, and is there unless it is named as one that may not be.
class Object {
 public:
  Object(const Json& json, std::string path, const Names& known, const Names& may_be_missing = {})
      : json_(json), path_(std::move(path)) {
    if (!json.is_object())
      refuse(path_, fmt::format("{}; an object with the fields {}", described(json), corpus::joined(known)));
    for (const auto& [key, value] : json.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      refuse(path_, fmt::format("unknown field {}; known fields: {}", corpus::json_quote_short(key),
                                corpus::joined(known)));
    }
    for (const std::string_view key : known) {
      const bool may_be =
          std::find(may_be_missing.begin(), may_be_missing.end(), key) != may_be_missing.end();
      if (!may_be && !has(key)) refuse(child(path_, key), "missing");
    }
  }

  [[nodiscard]] bool has(std::string_view key) const { return json_.contains(key); }
  [[nodiscard]] const Json& at(std::string_view key) const { return json_.at(std::string(key)); }
  [[nodiscard]] std::string path(std::string_view key) const { return child(path_, key); }
  [[nodiscard]] const Json& array(std::string_view key) const { return array_at(at(key), path(key)); }
  [[nodiscard]] std::string text(std::string_view key) const { return text_at(at(key), path(key)); }
  [[nodiscard]] double number(std::string_view key) const { return number_at(at(key), path(key)); }
  [[nodiscard]] std::uint64_t count(std::string_view key) const { return count_at(at(key), path(key)); }
  [[nodiscard]] std::vector<std::string> texts(std::string_view key) const {
    return texts_at(at(key), path(key));
  }
  // read(item, its path), for every item of an array.
  template <class Read>
  void each(std::string_view key, const Read& read) const {
    std::size_t index = 0;
    for (const Json& item : array(key)) read(item, fmt::format("{}[{}]", path(key), index++));
  }

 private:
  const Json& json_;
  std::string path_;
};

std::vector<Finding> findings_of(const Object& state, std::string_view key) {
  std::vector<Finding> findings;
  state.each(key, [&](const Json& json, const std::string& path) {
    const Object finding(json, path, {"index", "method", "family", "level", "seed", "reason"});
    findings.push_back({.index = finding.count("index"),
                        .method = finding.text("method"),
                        .family = finding.text("family"),
                        .level = finding.number("level"),
                        .seed = finding.count("seed"),
                        .reason = finding.text("reason")});
  });
  return findings;
}

std::uint64_t digest_of(const Object& state) {
  constexpr std::size_t kDigits = 16;
  const std::string text = state.text("digest");
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, 16);
  if (text.size() != kDigits || error != std::errc() || stop != end)
    refuse("digest", fmt::format("{}; {} hexadecimal digits", described(state.at("digest")), kDigits));
  return value;
}

std::vector<OtherContender> others_of(const Object& part) {
  std::vector<OtherContender> others;
  if (!part.has("others")) return others;
  part.each("others", [&](const Json& json, const std::string& path) {
    const Object one(json, path, {"method", "query", "version", "stall_cap", "held_to"});
    others.push_back({.method = one.text("method"),
                      .query = one.text("query"),
                      .version = one.text("version"),
                      .stall_cap = one.number("stall_cap"),
                      .held_to = one.text("held_to")});
    const auto& names = corpus::kQueryNames;
    if (std::find(names.begin(), names.end(), others.back().query) == names.end())
      refuse(one.path("query"), described(one.at("query")) + "; " + corpus::joined(names));
  });
  return others;
}

CampaignSettings settings_of(const Json& json) {
  const Object settings(json, "settings", {"parts", "seed", "block", "fingerprint"});
  CampaignSettings out{.parts = {},
                       .seed = settings.count("seed"),
                       .block = settings.count("block"),
                       .fingerprint = settings.text("fingerprint")};
  settings.each("parts", [&](const Json& one, const std::string& path) {
    const Object part(one, path,
                      {"kind", "methods", "families", "count", "oracle_every", "judge_every", "others"},
                      {"others"});
    out.parts.push_back({.kind = part.text("kind"),
                         .methods = part.texts("methods"),
                         .families = part.texts("families"),
                         .count = part.count("count"),
                         .oracle_every = part.count("oracle_every"),
                         .judge_every = part.count("judge_every"),
                         .others = others_of(part)});
  });
  if (out.casts() == 0 || out.block == 0)
    throw std::runtime_error("the counts of settings.parts and settings.block must be 1 or more");
  return out;
}

// Two numbers: "shard", or a range of blocks that are done.
std::pair<std::uint64_t, std::uint64_t> pair_at(const Json& json, const std::string& path) {
  if (!json.is_array() || json.size() != 2) refuse(path, described(json) + "; an array of two whole numbers");
  return {count_at(json[0], path + "[0]"), count_at(json[1], path + "[1]")};
}

void read_levels(const Object& json, CampaignState& state) {
  Names known = {"method", "family", "level", "widest", "most_supports"};
  for (const CountField& field : kCountFields) known.emplace_back(field.name);
  json.each("levels", [&](const Json& one, const std::string& path) {
    // Fields that older states lack: failures of third-party engines, and work.
    const Object level(one, path, known, {"failed", "work", "most_supports"});
    state.cells.push_back(
        {.method = level.text("method"), .family = level.text("family"), .level = level.number("level")});
    CampaignCounts counts;
    counts.widest = level.number("widest");
    if (level.has("most_supports")) counts.most_supports = level.count("most_supports");
    for (const CountField& field : kCountFields)
      counts.*field.value = level.has(field.name) ? level.count(field.name) : 0;
    state.tally.counts.push_back(counts);
  });
}

// The schema is checked first, because the fields of another document are not the ones expected here.
void require_schema(const Json& json) {
  if (!json.is_object() || !json.contains("schema") || json.at("schema") == kSchema) return;
  throw std::runtime_error(
      fmt::format("schema is {}, not \"{}\"", corpus::document_text(json.at("schema")), kSchema));
}

CampaignState state_of(const Json& json) {
  require_schema(json);
  const Object all(json, "",
                   {"schema", "settings", "shard", "left_out", "done", "digest", "levels", "faults", "stalls",
                    "undecided"});
  CampaignState state;
  state.settings = settings_of(all.at("settings"));
  const auto [index, count] = pair_at(all.at("shard"), "shard");
  state.shard = {.index = index, .count = count};
  if (index < 1 || index > count) refuse("shard", described(all.at("shard")) + "; [i, n] with 1 <= i <= n");
  state.left_out = all.texts("left_out");
  all.each("done", [&](const Json& range, const std::string& path) {
    const auto [first, end] = pair_at(range, path);
    const BlockRange blocks(first, end);
    if (boost::icl::is_empty(blocks) || !boost::icl::within(blocks, state.share()))
      refuse(path, described(range) + " is no range of the shard's blocks");
    state.done += blocks;
  });
  state.tally.digest = digest_of(all);
  read_levels(all, state);
  state.tally.faults = findings_of(all, "faults");
  state.tally.stalls = findings_of(all, "stalls");
  state.tally.undecided = findings_of(all, "undecided");
  const CampaignCounts total = state.tally.total();
  if (total.casts + total.skipped != state.casts_done()) {
    throw std::runtime_error(fmt::format("the levels count {} casts, the blocks that are done have {}",
                                         total.casts + total.skipped, state.casts_done()));
  }
  return state;
}

}  // namespace

std::string state_text(const CampaignState& state) {
  const CampaignSettings& settings = state.settings;
  Json json = {{"schema", kSchema},
               {"settings",
                {{"parts", Json::array()},
                 {"seed", settings.seed},
                 {"block", settings.block},
                 {"fingerprint", settings.fingerprint}}},
               {"shard", {state.shard.index, state.shard.count}},
               {"left_out", state.left_out},
               {"done", Json::array()},
               {"digest", fmt::format("{:016x}", state.tally.digest)},
               {"levels", Json::array()},
               {"faults", findings_json(state.tally.faults)},
               {"stalls", findings_json(state.tally.stalls)},
               {"undecided", findings_json(state.tally.undecided)}};
  for (const PartSettings& part : settings.parts) {
    json["settings"]["parts"].push_back({{"kind", part.kind},
                                         {"methods", part.methods},
                                         {"families", part.families},
                                         {"count", part.count},
                                         {"oracle_every", part.oracle_every},
                                         {"judge_every", part.judge_every}});
    for (const OtherContender& one : part.others) {
      json["settings"]["parts"].back()["others"].push_back({{"method", one.method},
                                                            {"query", one.query},
                                                            {"version", one.version},
                                                            {"stall_cap", one.stall_cap},
                                                            {"held_to", one.held_to}});
    }
  }
  for (const BlockRange& range : state.done) json["done"].push_back({range.lower(), range.upper()});
  for (std::size_t i = 0; i < state.cells.size(); ++i) {
    const Cell& cell = state.cells[i];
    Json level = {{"method", cell.method}, {"family", cell.family}, {"level", cell.level}};
    for (const CountField& field : kCountFields) level[field.name] = state.tally.counts[i].*field.value;
    level["widest"] = state.tally.counts[i].widest;
    level["most_supports"] = state.tally.counts[i].most_supports;
    json["levels"].push_back(std::move(level));
  }
  return corpus::document_text(json, 1) + "\n";
}

CampaignState parse_state(std::string_view text, const std::string& name) {
  try {
    return state_of(corpus::parse_document(text));
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: is no state of a campaign: {}", name, error.what()));
  }
}

CampaignState read_state(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw std::runtime_error(fmt::format("{}: cannot be read{}{}", file.string(), errno != 0 ? ": " : "",
                                         errno != 0 ? std::strerror(errno) : ""));
  }
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  return parse_state(text, file.string());
}

void write_state(const CampaignState& state, const std::filesystem::path& file) {
  std::filesystem::path beside = file;
  beside += ".new";
  std::ofstream out(beside, std::ios::binary | std::ios::trunc);
  out << state_text(state);
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(beside, file, error);
  if (!out || error) {
    throw std::runtime_error(file.string() + ": cannot be written; name a file in a folder that can");
  }
}

CampaignState merge_states(const std::vector<NamedState>& parts, bool partial) {
  const NamedState& first = parts.at(0);
  CampaignState whole = first.state;
  whole.shard = {};
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const CampaignState& part = parts[i].state;
    if (const std::string what = difference(part.settings, first.state.settings); !what.empty()) {
      throw std::runtime_error(
          fmt::format("{} and {} are of two campaigns: {}", parts[i].name, first.name, what));
    }
    for (std::size_t j = 0; j < i; ++j) {
      const BlockSet both = part.done & parts[j].state.done;
      if (both.empty()) continue;
      throw std::runtime_error(fmt::format("{} and {} both hold block {}; give each shard once",
                                           parts[j].name, parts[i].name, both.begin()->lower()));
    }
    if (part.cells != whole.cells) {
      throw std::runtime_error(fmt::format("{} and {} count other levels", parts[i].name, first.name));
    }
    whole.done += part.done;
    whole.tally.merge(part.tally);
  }
  if (!whole.is_complete() && !partial) {
    const BlockSet missing = BlockSet(whole.share()) - whole.done;
    throw std::runtime_error(
        fmt::format("{} of {} blocks are in no file, the first of them {}; give every shard, finished, or "
                    "--partial",
                    boost::icl::cardinality(missing), whole.settings.blocks(), missing.begin()->lower()));
  }
  return whole;
}

}  // namespace graze::tool
