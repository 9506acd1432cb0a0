#include "certify/campaign/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "corpus/format/names.hpp"
#include "reports/text/counted.hpp"
#include "reports/text/inputs.hpp"
#include "reports/text/table.hpp"

namespace graze::tool {
namespace {

// The number of findings per kind in the text. The file holds more.
constexpr std::size_t kMostFindings = 10;

// The sum of the counts in the cells that `wanted` selects.
template <class Wanted>
CampaignCounts sum_of(const CampaignState& state, const Wanted& wanted) {
  CampaignCounts sum;
  for (std::size_t i = 0; i < state.cells.size(); ++i) {
    if (wanted(state.cells[i])) sum += state.tally.counts[i];
  }
  return sum;
}

CampaignCounts of_family(const CampaignState& state, const std::string& method, const std::string& family) {
  return sum_of(state, [&](const Cell& cell) { return cell.method == method && cell.family == family; });
}

// Two parts may ask one method, about other families.
bool is_of(const PartSettings& part, const Cell& cell) {
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return has(part.methods, cell.method) && has(part.families, cell.family);
}

CampaignCounts of_method(const CampaignState& state, const PartSettings& part, const std::string& method) {
  return sum_of(state, [&](const Cell& cell) { return cell.method == method && is_of(part, cell); });
}

CampaignCounts of_part(const CampaignState& state, const PartSettings& part) {
  return sum_of(state, [&](const Cell& cell) { return is_of(part, cell); });
}

bool is_rotating(const PartSettings& part) { return part.kind == part_name(engine::Kind::rotating); }

// A column and what it shows of the counts.
struct Shown {
  Column column;
  std::string (*text)(const CampaignCounts&);
};

template <std::uint64_t CampaignCounts::*kField>
std::string count_of(const CampaignCounts& counts) {
  return fmt::to_string(counts.*kField);
}

// The columns of a part: `every` kind of fault for rotating bodies, otherwise the columns that are not 0
// everywhere.
std::vector<Shown> columns_of(const PartSettings& part, const CampaignCounts& sum) {
  using C = CampaignCounts;
  std::vector<Shown> columns = {
      {{"casts"}, &count_of<&C::casts>},
      {{"hits"}, &count_of<&C::hits>},
      {{"misses"}, &count_of<&C::misses>},
      {{"in contact\nat t = 0"}, &count_of<&C::overlapping>},
      {{"not\nconverged"}, &count_of<&C::not_converged>},
      {{"proof\naccepted"}, &count_of<&C::proved>},
      {{"oracle\nneeded"}, [](const C& c) { return fmt::to_string(c.by_oracle - c.sampled); }},
      {{"oracle\nsampled"}, &count_of<&C::sampled>}};
  const auto add = [&](std::uint64_t C::*field, const char* header, std::string (*text)(const C&)) {
    if (is_rotating(part) || sum.*field > 0) columns.push_back({{header}, text});
  };
  add(&C::undecided, "oracle\nundecided", &count_of<&C::undecided>);
  columns.push_back({{"within\ntolerance"}, &count_of<&C::within_tolerance>});
  add(&C::stalls, "stalls", &count_of<&C::stalls>);
  if (sum.failed > 0) columns.push_back({{"failed"}, &count_of<&C::failed>});
  if (!part.others.empty()) columns.push_back({{"not\nasked"}, &count_of<&C::skipped>});
  add(&C::wrong, "wrong", &count_of<&C::wrong>);
  add(&C::late, "late", &count_of<&C::late>);
  add(&C::off, "bracket\noff", &count_of<&C::off>);
  add(&C::contact_off, "contact\noff", &count_of<&C::contact_off>);
  add(&C::proofs_refused, "proofs\nrefused", &count_of<&C::proofs_refused>);
  add(&C::unproved, "unproved", &count_of<&C::unproved>);
  add(&C::work, "work", &count_of<&C::work>);
  columns.push_back({{"faults"}, &count_of<&C::faults>});
  columns.push_back({{"most\nsupports"}, &count_of<&C::most_supports>});
  if (is_rotating(part))
    columns.push_back({{"widest\nof limit"}, [](const C& c) { return short_number(c.widest); }});
  return columns;
}

std::string method_table(const CampaignState& state, const PartSettings& part, const std::string& method,
                         bool levels) {
  const std::vector<Shown> shown = columns_of(part, of_part(state, part));
  std::vector<Column> columns = {{"family", Align::left}};
  for (const Shown& one : shown) columns.push_back(one.column);
  Table table(columns);
  const auto add = [&](const std::string& name, const CampaignCounts& counts) {
    std::vector<std::string> row = {name};
    for (const Shown& one : shown) row.push_back(one.text(counts));
    table.add_row(std::move(row));
  };
  for (const std::string& family : part.families) {
    add(family, of_family(state, method, family));
    for (std::size_t i = 0; levels && i < state.cells.size(); ++i) {
      const Cell& cell = state.cells[i];
      if (cell.method == method && cell.family == family)
        add(fmt::format("  h{}", cell.level), state.tally.counts[i]);
    }
  }
  table.add_gap();
  add("all", of_method(state, part, method));
  return table.text();
}

void show_findings(std::string& text, const std::vector<Finding>& findings, const char* what, bool named) {
  for (std::size_t i = 0; i < std::min(kMostFindings, findings.size()); ++i) {
    text += fmt::format("{}: {}{} (cast {}): {}\n", what, named ? findings[i].method + " " : "",
                        findings[i].id(), findings[i].index, findings[i].reason);
  }
}

std::string part_heading(const PartSettings& part, std::uint64_t seed) {
  const bool queries = part.kind == part_name(engine::Kind::query);
  std::string text = fmt::format("Campaign: {} {} by {}, seed {}; ", part.count,
                                 queries ? "answers" : "casts", fmt::join(part.methods, ", "), seed);
  if (part.judge_every > 1)
    text +=
        fmt::format("one case in {} is judged, and each answer that did not converge; ", part.judge_every);
  for (const OtherContender& one : part.others)
    text += fmt::format("{}{} is held to {}; ", one.method, one.version.empty() ? "" : " " + one.version,
                        one.held_to);
  if (!part.others.empty() && part.others.size() == part.methods.size())
    return text + "the oracle measures every answer that is judged.\n";
  text += "the oracle decides ";
  if (queries) {
    text += part.oracle_every == 1  ? "every one"
            : part.oracle_every > 1 ? fmt::format("one in {}", part.oracle_every)
                                    : "none";
    return text + ".\n";
  }
  text += "what a proof leaves open";
  return text +
         (part.oracle_every > 0 ? fmt::format(", and one in {} besides.\n", part.oracle_every) : ".\n");
}

// The kinds of fault and how many of each.
std::string kinds_of(const CampaignCounts& counts) {
  std::vector<std::string> kinds;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) kinds.push_back(fmt::format("{} {}", count, what));
  };
  add(counts.failed, "without an answer");
  add(counts.wrong, "wrong");
  add(counts.late, "late");
  add(counts.off, "with a bracket off");
  add(counts.contact_off, "with a normal or a witness off");
  add(counts.proofs_refused, "with a proof refused");
  add(counts.unproved, "without their proof");
  add(counts.work, "by more support evaluations than guaranteed");
  return fmt::format("{}", fmt::join(kinds, ", "));
}

// A contender by its name: one of ours, or a third-party method as the state records it.
struct Known {
  engine::Kind kind = engine::Kind::linear;
  corpus::Query query = corpus::Query::cast;
  double stall_cap = 0;
};
std::optional<Known> known_contender(const CampaignState& state, const std::string& name) {
  for (const PartSettings& part : state.settings.parts) {
    for (const OtherContender& one : part.others) {
      if (one.method != name) continue;
      const auto query = std::find(corpus::kQueryNames.begin(), corpus::kQueryNames.end(), one.query);
      return Known{.kind = is_rotating(part)                             ? engine::Kind::rotating
                           : part.kind == part_name(engine::Kind::query) ? engine::Kind::query
                                                                         : engine::Kind::linear,
                   .query = static_cast<corpus::Query>(query - corpus::kQueryNames.begin()),
                   .stall_cap = one.stall_cap};
    }
  }
  const engine::Method* method = find_contender(name);
  if (method == nullptr) return std::nullopt;
  return Known{.kind = method->kind,
               .query = method->query,
               .stall_cap = method->guarantee != nullptr ? method->guarantee->stall_cap : 0};
}

void family_failures(std::vector<std::string>& lines, const CampaignState& state, const std::string& method,
                     const std::string& family, const std::string& where) {
  const std::optional<Known> contender = known_contender(state, method);
  const double cap = contender ? contender->stall_cap : 0;
  const CampaignCounts counts = of_family(state, method, family);
  if (counts.faults > 0) {
    lines.push_back(fmt::format("{}: {} of {} casts are at fault: {}", where, counts.faults, counts.casts,
                                kinds_of(counts)));
  }
  if (static_cast<double>(counts.stalls) > cap * static_cast<double>(counts.casts)) {
    lines.push_back(fmt::format("{}: {} of {} casts did not converge, and the guarantee allows {}", where,
                                counts.stalls, counts.casts, cap));
    return;
  }
  // A mechanism that needs a greater cap affects single levels, while the guarantee is about the family.
  if (cap > engine::kPlainStallCap) return;
  for (std::size_t i = 0; i < state.cells.size(); ++i) {
    const Cell& cell = state.cells[i];
    const CampaignCounts& level = state.tally.counts[i];
    if (cell.method != method || cell.family != family) continue;
    if (static_cast<double>(level.stalls) <= std::ceil(cap * static_cast<double>(level.casts))) continue;
    lines.push_back(fmt::format("{} h{}: {} of {} casts did not converge, and the guarantee allows {}", where,
                                cell.level, level.stalls, level.casts, cap));
  }
}

std::vector<corpus::Case> cases_of(const CampaignState& state, std::vector<Finding> findings) {
  std::sort(findings.begin(), findings.end(),
            [](const Finding& l, const Finding& r) { return l.index < r.index; });
  std::vector<corpus::Case> cases;
  std::set<std::string> ids;
  for (const Finding& finding : findings) {
    const corpus::Family* family = corpus::find_family(finding.family);
    if (family == nullptr) throw std::runtime_error(finding.family + " is no family of this build");
    const std::optional<Known> contender = known_contender(state, finding.method);
    if (!contender) throw std::runtime_error(finding.method + " is no method of this build");
    corpus::Case problem =
        question_of(contender->kind, contender->query,
                    {.problem = family->generate(finding.level, finding.seed), .seed = finding.seed});
    if (ids.insert(problem.id).second) cases.push_back(std::move(problem));
  }
  return cases;
}

void save_cases(const std::string& name, const std::vector<corpus::Case>& cases) {
  if (name.empty()) return;
  OutputFile save(name);
  for (const corpus::Case& problem : cases) save.write_line(corpus::write_case(problem));
  save.close();
}

}  // namespace

std::vector<std::string> campaign_failures(const CampaignState& state) {
  std::vector<std::string> lines;
  const bool named = state.settings.parts.size() > 1 || state.settings.parts.at(0).methods.size() > 1;
  for (const PartSettings& part : state.settings.parts) {
    for (const std::string& method : part.methods) {
      for (const std::string& family : part.families)
        family_failures(lines, state, method, family, named ? method + ", " + family : family);
    }
    const CampaignCounts counts = of_part(state, part);
    // Each method is asked each case, so a case that is left undecided counts once for each.
    const auto methods = static_cast<double>(part.methods.size());
    const double most = methods * std::ceil(kMostUndecided * static_cast<double>(counts.casts) / methods);
    if (static_cast<double>(counts.undecided) > most) {
      lines.push_back(fmt::format("{}: the oracle leaves {} of {} answers undecided, more than {}", part.kind,
                                  counts.undecided, counts.casts, most));
    }
  }
  return lines;
}

std::string campaign_summary(const CampaignState& state, bool levels) {
  const CampaignSettings& settings = state.settings;
  const CampaignCounts total = state.tally.total();
  const bool named = settings.parts.size() > 1 || settings.parts.at(0).methods.size() > 1;
  const bool has_others = std::any_of(settings.parts.begin(), settings.parts.end(),
                                      [](const PartSettings& part) { return !part.others.empty(); });
  std::string text;
  for (const PartSettings& part : settings.parts) text += part_heading(part, settings.seed);
  if (state.blocks_done() < settings.blocks()) {
    text += fmt::format("Shard {}/{}: {} of {} blocks, {} casts.\n", state.shard.index, state.shard.count,
                        state.blocks_done(), settings.blocks(), state.casts_done());
  }
  text += "\n";
  for (const PartSettings& part : settings.parts) {
    for (const std::string& method : part.methods) {
      if (named) text += method + "\n\n";
      text += method_table(state, part, method, levels) + "\n";
    }
  }
  if (!state.left_out.empty()) {
    text += fmt::format("Left out, with hardly a question for {}: {}.\n",
                        has_others ? "all of these methods" : "the tier", fmt::join(state.left_out, ", "));
  }
  if (total.skipped > 0)
    text += fmt::format("{} {} no question.\n", counted(total.skipped, "case"),
                        total.skipped == 1 ? "was" : "were");
  text += fmt::format("Digest of the answers: {:016x}; of the families: {}.\n", state.tally.digest,
                      settings.fingerprint);
  show_findings(text, state.tally.faults, "fault", named);
  show_findings(text, state.tally.stalls, "stall", named);
  show_findings(text, state.tally.undecided, "undecided", named);
  const std::vector<std::string> failures = campaign_failures(state);
  for (const std::string& line : failures) text += "FAILED: " + line + "\n";
  if (total.undecided > 0) {
    text += fmt::format("The oracle judged {} answers and left {} undecided: these agree with nothing.\n",
                        total.by_oracle, total.undecided);
  }
  if (total.faults == 0 && total.stalls == 0 && total.casts > total.undecided) {
    text +=
        fmt::format("None of {} failed: the rate of failures on such cases is below 3/n = {:.2g} at 95 %.\n",
                    total.casts - total.undecided, 3.0 / static_cast<double>(total.casts - total.undecided));
  } else if (failures.empty()) {
    text += fmt::format("{}: {} of {} casts did not converge.\n",
                        named ? "Every method keeps its guarantee" : "The method keeps its guarantee",
                        total.stalls, total.casts);
  }
  return text;
}

std::vector<corpus::Case> found_cases(const CampaignState& state) {
  std::vector<Finding> findings = state.tally.faults;
  findings.insert(findings.end(), state.tally.stalls.begin(), state.tally.stalls.end());
  return cases_of(state, std::move(findings));
}

std::vector<corpus::Case> undecided_cases(const CampaignState& state) {
  return cases_of(state, state.tally.undecided);
}

int hand_out(const CampaignState& state, const CampaignOutputs& outputs) {
  if (outputs.json != "-") fmt::print("{}", campaign_summary(state, outputs.levels));
  if (outputs.json == "-") {
    fmt::print("{}", state_text(state));
  } else if (!outputs.json.empty()) {
    write_state(state, outputs.json);
  }
  save_cases(outputs.save, found_cases(state));
  save_cases(outputs.save_undecided, undecided_cases(state));
  return campaign_failures(state).empty() ? 0 : 1;
}

}  // namespace graze::tool
