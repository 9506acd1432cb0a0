#include "certify/suites.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "corpus/random.hpp"
#include "corpus/workloads.hpp"
#include "oracles/polytope/exact_body.hpp"
#include "oracles/polytope/integer_scene.hpp"
#include "properties/edit/case.hpp"
#include "properties/laws/queries/question.hpp"

namespace graze::tool {
namespace {

using corpus::Case;

// A vertex pair each: beyond, an exact answer takes a tenth of a second.
constexpr std::uint64_t kMostDifferences = 1u << 12;

// The number of cases of a suite, evenly spread, among which small ones are sought.
constexpr std::size_t kMostLookedAt = 10000;

std::uint64_t differences(const Case& problem) {
  return law::vertex_count(problem.a.shape) * law::vertex_count(problem.b.shape);
}
bool is_represented(const Case& problem) {
  return oracle::is_exact_body(problem.a.shape) && oracle::is_exact_body(problem.b.shape);
}

}  // namespace

std::optional<Case> question_for(const Suite& suite, std::size_t i, const Case& problem,
                                 const engine::Method& method) {
  if (method.kind != engine::Kind::query) return problem;
  std::optional<Case> asked;
  if (suite.asks_every_query) {
    asked = law::question_for(problem, method.query, i);
  } else if (method.query == problem.query) {
    asked = problem;
    asked->expect.reset();
    asked->start_policy = StartPolicy::report;
  }
  // The scalar may make it another question.
  if (asked && method.is_ours() && !law::in_domain(method.seen(*asked))) return std::nullopt;
  return asked;
}

std::vector<const corpus::Family*> wanted_families(const std::vector<std::string>& names,
                                                   bool files_are_given) {
  std::vector<const corpus::Family*> wanted;
  if (names.empty() && !files_are_given) {
    for (const auto list : {corpus::families(), corpus::rotating_families(), corpus::workloads()}) {
      for (const corpus::Family& family : list) wanted.push_back(&family);
    }
  }
  for (const std::string& name : names) {
    const corpus::Family* family = corpus::find_family(name);
    if (family == nullptr) {
      throw std::runtime_error(
          fmt::format("--family: {} is no family; `graze generate --help` lists them", name));
    }
    wanted.push_back(family);
  }
  return wanted;
}

Suite drawn_suite(const corpus::Family& family, std::span<const double> levels, std::size_t count,
                  std::uint64_t seed) {
  return {.kind = family.rotating ? engine::Kind::rotating : engine::Kind::linear,
          .family = std::string(family.name),
          .drawn = count,
          .draw = [=, &family](std::size_t i) {
            const std::size_t number = levels.size();
            std::size_t level = 0, share = 0;
            for (; i >= (share = (count + number - 1 - level) / number); ++level) i -= share;
            return family.generate(levels[level], seed + level + i * number);
          }};
}

Suite sought_suite(const corpus::Family& family, std::span<const double> levels, std::size_t count,
                   std::uint64_t seed, const std::function<bool(const Case&)>& takes) {
  struct Place {
    double hardness;
    std::uint64_t seed;
  };
  std::vector<Place> found;
  const std::size_t number = levels.size();
  for (std::size_t level = 0; level < number; ++level) {
    const std::size_t share = (count + number - 1 - level) / number;
    for (std::size_t k = 0, taken = 0; k < kSoughtSeeds * share && taken < share; ++k) {
      const Place place{.hardness = levels[level], .seed = seed + level + k * number};
      if (!takes(family.generate(place.hardness, place.seed))) continue;
      found.push_back(place);
      ++taken;
    }
  }
  const std::size_t size = found.size();
  return {.kind = family.rotating ? engine::Kind::rotating : engine::Kind::linear,
          .family = std::string(family.name),
          .drawn = size,
          .draw = [&family, found = std::move(found)](std::size_t i) {
            return family.generate(found[i].hardness, found[i].seed);
          }};
}

Suite queried_suite(const Suite& casts, std::size_t count) {
  Suite suite{.kind = engine::Kind::query, .family = casts.family, .asks_every_query = true};
  if (count == 0) return suite;
  std::vector<std::size_t> small;
  const std::size_t sparse = (casts.size() + kMostLookedAt - 1) / kMostLookedAt;
  for (std::size_t i = 0; i < casts.size(); i += sparse) {
    const Case problem = casts.at(i);
    if (law::in_domain(problem) && is_small(problem)) small.push_back(i);
  }
  const std::size_t stride = std::max<std::size_t>(1, small.size() / count);
  for (std::size_t i = 0; i < small.size() && suite.cases.size() < count; i += stride) {
    suite.cases.push_back(casts.at(small[i]));
  }
  return suite;
}

bool is_small(const Case& problem) {
  return !is_represented(problem) || differences(problem) <= kMostDifferences;
}

std::string why_unjudged(const Case& problem) {
  if (std::string why = law::why_invalid(problem); !why.empty()) return why;
  if (std::string why = engine::unsupported(engine::Kind::query, problem); !why.empty()) return why;
  if (is_represented(problem) && differences(problem) > oracle::kMostDifferences)
    return "bodies with more vertices than the exact oracles take";
  return {};
}

}  // namespace graze::tool
