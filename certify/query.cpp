#include "certify/query.hpp"

#include <fmt/format.h>

#include <graze/support/tree.hpp>

#include "corpus/format/case_io.hpp"
#include "corpus/format/names.hpp"
#include "oracles/polytope/exact_body.hpp"
#include "oracles/polytope/integer_scene.hpp"
#include "properties/judge/curved_query.hpp"
#include "properties/judge/query.hpp"
#include "properties/laws/queries/question.hpp"
#include "report/parallel.hpp"
#include "report/progress.hpp"
#include "report/statistics.hpp"
#include "report/table.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using corpus::Query;
using law::QueryJudgement;
using law::QueryTruth;

// A vertex pair each: beyond, an exact answer takes a tenth of a second.
constexpr std::size_t kMostDifferences = 1u << 12;

// Of a suite, evenly spread, to find small ones among them.
constexpr std::size_t kMostLookedAt = 10000;

std::size_t differences(const Case& problem) {
  return graze::detail::vertex_count(problem.a.shape) * graze::detail::vertex_count(problem.b.shape);
}
bool is_represented(const Case& problem) {
  return oracle::is_exact_body(problem.a.shape) && oracle::is_exact_body(problem.b.shape);
}

// Bodies to ask about: by their own query or, the `pick`-th of a sample, by every one.
struct Question {
  Case problem;
  std::optional<std::size_t> pick;

  // As a method is asked; nothing if it is not for this query.
  [[nodiscard]] std::optional<Case> to(const engine::QueryMethod& method) const {
    if (pick) return law::question_for(problem, method.query, *pick);
    if (method.query != problem.query) return std::nullopt;
    Case asked = problem;
    asked.expect.reset();
    asked.start_policy = StartPolicy::report;
    return asked;
  }
};

using Judgements = std::vector<std::optional<QueryJudgement>>;

// By method. Nothing for a case that the scalar of a method made invalid, or that is not for tier exact.
Judgements judge_all(const Question& bodies, const QuerySettings& settings, std::vector<Case>& convicted) {
  Judgements out;
  std::unique_ptr<QueryTruth> truth;
  for (const engine::QueryMethod& method : settings.methods) {
    out.emplace_back();
    const std::optional<Case> question = bodies.to(method);
    if (!question) continue;
    const Case seen = law::seen_by(method, *question);
    if (!truth || !corpus::same_case(truth->problem(), seen)) truth = std::make_unique<QueryTruth>(seen);
    if (!why_invalid(seen).empty()) continue;
    const engine::Guarantee* row = engine::find_guarantee(settings.guarantees, method);
    const law::QueryLimits limits{
        .kappa = row != nullptr ? row->kappa(seen) : kPlainKappa,
        .unit_roundoff = method.scalar == "float" ? kUnitRoundoff<float> : kUnitRoundoff<double>,
        .contact_kappa = row != nullptr ? row->contact_kappa(seen) : kPlainKappa};
    const engine::QueryAnswer answer = method.answer(*question);
    const QueryJudgement judgement = is_represented(seen) ? law::judge_query(*truth, method, answer, limits)
                                                          : judge_curved_query(seen, method, answer, limits);
    if (judgement.not_asked && judgement.wrong.empty()) continue;
    if (judgement.faulty() || judgement.stalled) convicted.push_back(*question);
    out.back() = judgement;
  }
  return out;
}

}  // namespace

bool is_small(const Case& problem) {
  return is_represented(problem) && differences(problem) <= kMostDifferences;
}

std::string why_unjudged(const Case& problem) {
  if (std::string why = why_invalid(problem); !why.empty()) return why;
  if (std::string why = engine::unsupported_query(problem); !why.empty()) return why;
  if (is_represented(problem) && differences(problem) > oracle::kMostDifferences)
    return "bodies with more vertices than the exact oracles take";
  return {};
}

QueryCertification certify_queries(const std::vector<Case>& asked, const std::vector<Suite>& suites,
                                   const QuerySettings& settings) {
  std::vector<Question> chosen;
  chosen.reserve(asked.size());
  for (const Case& problem : asked) chosen.push_back({problem, std::nullopt});
  for (const Suite& suite : suites) {
    std::vector<std::size_t> small;
    const std::size_t sparse = (suite.size() + kMostLookedAt - 1) / kMostLookedAt;
    for (std::size_t i = 0; i < suite.size(); i += sparse) {
      const Case problem = suite.at(i);
      if (why_invalid(problem).empty() && is_small(problem)) small.push_back(i);
    }
    const std::size_t stride =
        std::max<std::size_t>(1, small.size() / std::max<std::size_t>(settings.count, 1));
    for (std::size_t i = 0, taken = 0; i < small.size() && taken < settings.count; i += stride, ++taken) {
      chosen.push_back({suite.at(small[i]), chosen.size() - asked.size()});
    }
  }
  std::vector<Judgements> judged(chosen.size());
  std::vector<std::vector<Case>> convicted(chosen.size());
  {
    Progress progress("judging queries", chosen.size());
    for_each_index(chosen.size(), settings.threads, [&](std::size_t i) {
      judged[i] = judge_all(chosen[i], settings, convicted[i]);
      progress.step();
    });
  }
  QueryCertification result;
  for (const engine::QueryMethod& method : settings.methods) result.tallies.push_back({.method = &method});
  for (std::size_t i = 0; i < judged.size(); ++i) {
    for (std::size_t m = 0; m < judged[i].size(); ++m) {
      if (!judged[i][m]) continue;
      const QueryJudgement& judgement = *judged[i][m];
      QueryTally& tally = result.tallies[m];
      ++tally.cases;
      tally.wrong += judgement.wrong.empty() ? 0 : 1;
      tally.off += judgement.off.empty() ? 0 : 1;
      tally.bad_contact += judgement.bad_contact.empty() ? 0 : 1;
      tally.stalled += judgement.stalled ? 1 : 0;
      if (judgement.stalled && tally.first_stalled.empty()) tally.first_stalled = chosen[i].problem.id;
      tally.excused += judgement.excused ? 1 : 0;
      tally.error.push_back(judgement.backward);
      tally.normal.push_back(judgement.normal);
      tally.witness.push_back(judgement.witness);
      if (judgement.faulty() && engine::find_guarantee(settings.guarantees, *tally.method) != nullptr) {
        result.breaches.push_back(fmt::format("{} {}: {}: {}{}{}", corpus::name_of(tally.method->query),
                                              tally.method->full_name(), chosen[i].problem.id,
                                              judgement.wrong, judgement.off, judgement.bad_contact));
      }
    }
    for (Case& problem : convicted[i]) result.convicted.push_back(std::move(problem));
  }
  for (const QueryTally& tally : result.tallies) {
    const engine::Guarantee* row = engine::find_guarantee(settings.guarantees, *tally.method);
    if (row == nullptr ||
        static_cast<double>(tally.stalled) <= row->stall_cap * static_cast<double>(tally.cases)) {
      continue;
    }
    result.breaches.push_back(fmt::format("{} {}: {} of {} stalled, more than {}; the first is {}",
                                          corpus::name_of(tally.method->query), tally.method->full_name(),
                                          tally.stalled, tally.cases, row->stall_cap, tally.first_stalled));
  }
  return result;
}

std::string query_table(const QueryCertification& certification,
                        std::span<const engine::Guarantee> guarantees) {
  Table table({{"query", Align::left},
               {"method", Align::left},
               {"cases"},
               {"wrong"},
               {"off"},
               {"contact\noff"},
               {"stalled"},
               {"excused"},
               {"error\nmedian"},
               {"\nworst"},
               {"normal\nworst"},
               {"witness\nworst"},
               {"kappa\npolytopes"},
               {"kappa\nrounded"},
               {"kappa\ncontact"},
               {"stalls\nat most"},
               {"mechanism", Align::left}});
  for (const QueryTally& t : certification.tallies) {
    const engine::Guarantee* row = engine::find_guarantee(guarantees, *t.method);
    table.add_row({std::string(corpus::name_of(t.method->query)), t.method->full_name(),
                   fmt::to_string(t.cases), fmt::to_string(t.wrong), fmt::to_string(t.off),
                   fmt::to_string(t.bad_contact), fmt::to_string(t.stalled), fmt::to_string(t.excused),
                   short_number(median(t.error)), short_number(worst(t.error)), short_number(worst(t.normal)),
                   short_number(worst(t.witness)), row == nullptr ? "-" : fmt::to_string(row->kappa_polytope),
                   row == nullptr ? "-" : fmt::to_string(row->kappa_rounded),
                   row == nullptr || !row->kappa_contact ? "-" : fmt::to_string(*row->kappa_contact),
                   row == nullptr ? "-" : fmt::to_string(row->stall_cap),
                   row == nullptr ? "no row" : row->mechanism});
  }
  return table.text();
}

}  // namespace graze::tool
