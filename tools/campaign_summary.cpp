#include "tools/campaign_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "corpus/case_io.hpp"
#include "corpus/families.hpp"
#include "tools/inputs.hpp"
#include "tools/table.hpp"

namespace graze::tool {
namespace {

// Findings that the text shows; the file holds more.
constexpr std::size_t kShown = 10;

CampaignCounts of_family(const CampaignState& state, const std::string& family) {
  CampaignCounts sum;
  for (std::size_t slot = 0; slot < state.levels.size(); ++slot) {
    if (state.levels[slot].first == family) sum += state.tally.counts[slot];
  }
  return sum;
}

bool stalls_too_often(const CampaignCounts& counts, const engine::Guarantee* row) {
  const double cap = row != nullptr ? row->stall_cap : 0;
  return static_cast<double>(counts.stalls) > cap * static_cast<double>(counts.casts);
}

std::string family_table(const CampaignState& state) {
  Table table({{"family", Align::left},
               {"casts"},
               {"hits"},
               {"misses"},
               {"in contact\nat t = 0"},
               {"not\nconverged"},
               {"proof\naccepted"},
               {"oracle\nneeded"},
               {"oracle\nsampled"},
               {"excused"},
               {"faults"}});
  const auto add = [&](const std::string& name, const CampaignCounts& c) {
    table.add_row({name, fmt::to_string(c.casts), fmt::to_string(c.hits), fmt::to_string(c.misses),
                   fmt::to_string(c.overlapping), fmt::to_string(c.not_converged), fmt::to_string(c.proved),
                   fmt::to_string(c.by_oracle - c.sampled), fmt::to_string(c.sampled),
                   fmt::to_string(c.excused), fmt::to_string(c.faults)});
  };
  for (const std::string& family : state.settings.families) add(family, of_family(state, family));
  table.add_gap();
  add("all", state.tally.total());
  return table.text();
}

void show_findings(std::string& text, const std::vector<Finding>& findings, const char* what) {
  for (std::size_t i = 0; i < std::min(kShown, findings.size()); ++i) {
    text +=
        fmt::format("{}: {} (cast {}): {}\n", what, findings[i].id(), findings[i].index, findings[i].reason);
  }
}

}  // namespace

std::vector<std::string> campaign_failures(const CampaignState& state, const engine::Guarantee* row) {
  std::vector<std::string> lines;
  for (const std::string& family : state.settings.families) {
    const CampaignCounts counts = of_family(state, family);
    if (counts.faults > 0)
      lines.push_back(fmt::format("{}: {} of {} casts are at fault", family, counts.faults, counts.casts));
    if (stalls_too_often(counts, row)) {
      lines.push_back(fmt::format("{}: {} of {} casts stall, and the row allows {}", family, counts.stalls,
                                  counts.casts, row != nullptr ? row->stall_cap : 0));
    }
  }
  return lines;
}

std::string campaign_summary(const CampaignState& state, const engine::Guarantee* row) {
  const CampaignSettings& settings = state.settings;
  const CampaignCounts total = state.tally.total();
  std::string text =
      fmt::format("Campaign: {} casts by {}, seed {}; the oracle decides what a proof leaves open",
                  settings.casts, settings.method, settings.seed);
  text +=
      settings.oracle_every > 0 ? fmt::format(", and one in {} besides.\n", settings.oracle_every) : ".\n";
  if (state.blocks_done() < settings.blocks()) {
    text += fmt::format("Shard {}/{}: {} of {} blocks, {} casts.\n", state.shard.index, state.shard.count,
                        state.blocks_done(), settings.blocks(), state.casts_done());
  }
  text += "\n" + family_table(state) + "\n";
  if (!state.left_out.empty()) {
    text +=
        fmt::format("Left out, with hardly a question for the tier: {}.\n", fmt::join(state.left_out, ", "));
  }
  if (total.not_asked > 0) text += fmt::format("{} cases were no question.\n", total.not_asked);
  text += fmt::format("Digest of the answers: {:016x}; of the families: {}.\n", state.tally.digest,
                      settings.fingerprint);
  show_findings(text, state.tally.faults, "fault");
  show_findings(text, state.tally.stalls, "stall");
  const std::vector<std::string> failures = campaign_failures(state, row);
  for (const std::string& line : failures) text += "FAILED: " + line + "\n";
  if (total.faults == 0 && total.stalls == 0 && total.casts > 0) {
    text +=
        fmt::format("None of {} failed: the rate of failures on such cases is below 3/n = {:.2g} at 95 %.\n",
                    total.casts, 3.0 / static_cast<double>(total.casts));
  } else if (failures.empty()) {
    text += fmt::format("The method keeps its row: {} stalls in {} casts.\n", total.stalls, total.casts);
  }
  return text;
}

std::vector<corpus::Case> found_cases(const CampaignState& state) {
  std::vector<Finding> findings = state.tally.faults;
  findings.insert(findings.end(), state.tally.stalls.begin(), state.tally.stalls.end());
  std::sort(findings.begin(), findings.end(),
            [](const Finding& l, const Finding& r) { return l.index < r.index; });
  std::vector<corpus::Case> cases;
  for (const Finding& finding : findings) {
    const corpus::Family* family = corpus::find_family(finding.family);
    if (family == nullptr) throw std::runtime_error(finding.family + " is no family of this build");
    cases.push_back(family->generate(finding.level, finding.seed));
  }
  return cases;
}

int hand_out(const CampaignState& state, const CampaignOutputs& outputs) {
  const engine::EngineMethod* method = engine::find_method(state.settings.method);
  const engine::Guarantee* row =
      method != nullptr ? engine::find_guarantee(engine::guarantees(), *method) : nullptr;
  if (outputs.json != "-") fmt::print("{}", campaign_summary(state, row));
  if (outputs.json == "-") {
    fmt::print("{}", state_text(state));
  } else if (!outputs.json.empty()) {
    write_state(state, outputs.json);
  }
  if (!outputs.save.empty()) {
    OutputFile save(outputs.save);
    for (const corpus::Case& problem : found_cases(state)) save.write_line(corpus::write_case(problem));
    save.close();
  }
  return campaign_failures(state, row).empty() ? 0 : 1;
}

}  // namespace graze::tool
