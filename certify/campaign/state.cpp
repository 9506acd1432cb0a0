#include "certify/campaign/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

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

// A count: nothing negative, no fraction.
std::uint64_t whole_number(const Json& json) {
  if (!json.is_number_unsigned())
    throw std::runtime_error(corpus::document_text(json) + " is no whole number");
  return json.get<std::uint64_t>();
}

std::vector<Finding> findings_of(const Json& list) {
  std::vector<Finding> findings;
  for (const Json& finding : list) {
    findings.push_back({.index = whole_number(finding.at("index")),
                        .method = finding.at("method"),
                        .family = finding.at("family"),
                        .level = finding.at("level"),
                        .seed = whole_number(finding.at("seed")),
                        .reason = finding.at("reason")});
  }
  return findings;
}

std::uint64_t hex_of(const std::string& text) {
  std::size_t used = 0;
  const std::uint64_t value = std::stoull(text, &used, 16);
  if (used != text.size()) throw std::invalid_argument("no hexadecimal number");
  return value;
}

std::vector<OtherContender> others_of(const Json& part) {
  std::vector<OtherContender> others;
  if (!part.contains("others")) return others;
  for (const Json& one : part.at("others")) {
    others.push_back({.method = one.at("method"),
                      .query = one.at("query"),
                      .version = one.at("version"),
                      .stall_cap = one.at("stall_cap"),
                      .held_to = one.at("held_to")});
    const auto& names = corpus::kQueryNames;
    if (std::find(names.begin(), names.end(), others.back().query) == names.end())
      throw std::runtime_error(fmt::format("others: {} is no query", others.back().query));
  }
  return others;
}

CampaignState state_of(const Json& json) {
  if (json.at("schema") != kSchema) {
    throw std::runtime_error(
        fmt::format("schema is {}, not \"{}\"", corpus::document_text(json.at("schema")), kSchema));
  }
  CampaignState state;
  const Json& settings = json.at("settings");
  state.settings = {.parts = {},
                    .seed = whole_number(settings.at("seed")),
                    .block = whole_number(settings.at("block")),
                    .fingerprint = settings.at("fingerprint")};
  for (const Json& part : settings.at("parts")) {
    state.settings.parts.push_back({.kind = part.at("kind"),
                                    .methods = part.at("methods"),
                                    .families = part.at("families"),
                                    .count = whole_number(part.at("count")),
                                    .oracle_every = whole_number(part.at("oracle_every")),
                                    .judge_every = whole_number(part.at("judge_every")),
                                    .others = others_of(part)});
  }
  if (state.settings.casts() == 0 || state.settings.block == 0) {
    throw std::runtime_error("the counts of settings.parts and settings.block must be 1 or more");
  }
  state.shard = {.index = whole_number(json.at("shard").at(0)),
                 .count = whole_number(json.at("shard").at(1))};
  if (state.shard.index < 1 || state.shard.index > state.shard.count) {
    throw std::runtime_error("shard must be [i, n] with 1 <= i <= n");
  }
  state.left_out = json.at("left_out");
  for (const Json& range : json.at("done")) {
    const BlockRange blocks(whole_number(range.at(0)), whole_number(range.at(1)));
    if (boost::icl::is_empty(blocks) || !boost::icl::within(blocks, state.share())) {
      throw std::runtime_error(
          fmt::format("done: {} is no range of the shard's blocks", corpus::document_text(range)));
    }
    state.done += blocks;
  }
  state.tally.digest = hex_of(json.at("digest"));
  for (const Json& level : json.at("levels")) {
    state.cells.push_back(
        {.method = level.at("method"), .family = level.at("family"), .level = level.at("level")});
    CampaignCounts counts;
    counts.widest = level.at("widest");
    for (const CountField& field : kCountFields) {
      // A state of before engines of others were asked has no count of their failures.
      const bool is_new = field.value == &CampaignCounts::failed;
      counts.*field.value = is_new && !level.contains(field.name) ? 0 : whole_number(level.at(field.name));
    }
    state.tally.counts.push_back(counts);
  }
  state.tally.faults = findings_of(json.at("faults"));
  state.tally.stalls = findings_of(json.at("stalls"));
  state.tally.undecided = findings_of(json.at("undecided"));
  const CampaignCounts total = state.tally.total();
  if (total.casts + total.not_asked != state.casts_done()) {
    throw std::runtime_error(fmt::format("the levels count {} casts, the blocks that are done have {}",
                                         total.casts + total.not_asked, state.casts_done()));
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
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
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
