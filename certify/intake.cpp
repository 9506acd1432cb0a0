#include "certify/intake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "corpus/format/case_io.hpp"
#include "corpus/format/names.hpp"

namespace graze::tool {
namespace {

using corpus::Case;
using corpus::Query;

// The cast of the same bodies answers it.
bool is_answered_by_a_cast(Query query, bool turns) {
  if (query == Query::swept_overlap) return true;
  return !turns && (query == Query::overlap || query == Query::distance);
}

bool is_asked_at_rest(Query query) { return query != Query::line && query != Query::swept_overlap; }

// The cases that a reason keeps out: how many, and the first.
struct Kept {
  std::size_t count = 0;
  std::string first;
};

}  // namespace

void Intake::take(const std::string& name, const std::vector<Case>& cases, bool ours) {
  Suite straight{.family = name}, turning{.kind = engine::Kind::rotating, .family = name},
      asked{.kind = engine::Kind::query, .family = name};
  std::map<std::string, Kept> kept_out;
  for (const Case& problem : cases) {
    const bool turns = engine::turns(problem);
    if (problem.query == Query::cast) {
      (turns ? turning : straight).cases.push_back(problem);
      continue;
    }
    Case question = problem;
    if (is_asked_at_rest(problem.query)) question.spin_a = question.spin_b = {};
    const std::string unjudged = why_unjudged(question);
    if (unjudged.empty()) asked.cases.push_back(std::move(question));
    if (is_answered_by_a_cast(problem.query, turns)) {
      ++recast;
      Case cast = problem;
      cast.query = Query::cast;
      cast.start_policy = StartPolicy::report;
      (turns ? turning : straight).cases.push_back(std::move(cast));
    } else if (!unjudged.empty()) {
      ++left_out;
      Kept& kept =
          kept_out[fmt::format("asks the query {} and has {}", corpus::name_of(problem.query), unjudged)];
      if (kept.count++ == 0) kept.first = problem.id;
    }
  }
  questions += asked.size();
  for (Suite* suite : {&straight, &asked, &turning}) {
    if (suite->size() > 0) suites.push_back(std::move(*suite));
  }
  if (ours) return;
  for (const auto& [reason, kept] : kept_out) {
    why.push_back(fmt::format("{}: case {} {}, and is not judged{}", name, kept.first, reason,
                              kept.count > 1 ? fmt::format("; nor are {} more", kept.count - 1) : ""));
  }
}

void Intake::leave_out(std::span<const engine::Method* const> methods,
                       const std::vector<std::string>& files) {
  const auto has_method = [&](const Suite& suite, const Case& problem) {
    return std::any_of(methods.begin(), methods.end(), [&](const engine::Method* method) {
      const bool is_query = suite.kind == engine::Kind::query && !suite.asks_every_query;
      return method->kind == suite.kind && (!is_query || method->query == problem.query);
    });
  };
  for (Suite& suite : suites) {
    const std::size_t before = suite.size();
    std::erase_if(suite.cases, [&](const Case& problem) { return !has_method(suite, problem); });
    if (suite.drawn > 0 && !has_method(suite, {})) suite.drawn = 0;
    const std::size_t without = before - suite.size();
    const bool is_given = std::find(files.begin(), files.end(), suite.family) != files.end();
    if (without == 0 || !is_given || suite.asks_every_query) continue;
    left_out += without;
    const bool is_query = suite.kind == engine::Kind::query;
    if (is_query) questions -= without;
    why.push_back(fmt::format("{}: {} {} are not judged{}: the command line leaves no method for them",
                              suite.family, without, is_query ? "questions" : "casts",
                              is_query ? ""
                                       : fmt::format(", in which {} body turns",
                                                     suite.kind == engine::Kind::rotating ? "a" : "no")));
  }
  std::erase_if(suites, [](const Suite& suite) { return suite.size() == 0; });
}

std::vector<Case> with_own_ids(const std::vector<Case>& found) {
  std::vector<Case> own;
  std::map<std::string, Case> by_id;
  for (Case problem : found) {
    const std::string id = problem.id;
    for (int attempt = 0;; ++attempt) {
      if (attempt > 0) problem.id = fmt::format("{}/{}", id, corpus::name_of(problem.query));
      if (attempt > 1) problem.id += fmt::format("-{}", attempt);
      const auto [known, is_new] = by_id.emplace(problem.id, problem);
      if (!is_new && !corpus::same_case(known->second, problem)) continue;
      if (is_new) own.push_back(problem);
      break;
    }
  }
  return own;
}

}  // namespace graze::tool
