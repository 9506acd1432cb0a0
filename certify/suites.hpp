// The suites that are certified: the cases of one family or one file, and the questions that each kind of method is
// asked about them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "corpus/families.hpp"
#include "engines/method.hpp"

namespace graze::tool {

// The given cases, or the requested number, each generated when it is needed.
struct Suite {
  engine::Kind kind = engine::Kind::linear;  // the kind of methods that are asked
  std::string family;
  std::vector<corpus::Case> cases = {};
  std::size_t drawn = 0;
  std::function<corpus::Case(std::size_t)> draw = {};
  // The exact oracle measures one in this number, in addition to those that it must decide.
  std::size_t oracle_every = 1;
  // For suites of queries: true if the suite has the bodies of linear casts, which are asked every query. Otherwise
  // each case is asked its own query.
  bool asks_every_query = false;

  [[nodiscard]] std::size_t size() const { return cases.size() + drawn; }
  [[nodiscard]] corpus::Case at(std::size_t i) const {
    return i < cases.size() ? cases[i] : draw(i - cases.size());
  }
};

// Case i of a suite as a method is asked it. Nothing if it is not a question for the method's query, or if the method's
// scalar puts a query's case outside the domain.
[[nodiscard]] std::optional<corpus::Case> question_for(const Suite& suite, std::size_t i,
                                                       const corpus::Case& problem,
                                                       const engine::Method& method);

// The families with these names. Without a name, every family, or none if files are given. Throws std::runtime_error
// with a one-line message for an unknown name.
[[nodiscard]] std::vector<const corpus::Family*> wanted_families(const std::vector<std::string>& names,
                                                                 bool files_are_given);

// `count` cases, spread over the levels of hardness: level by level, since a sample of every k-th case of
// levels that alternate would miss levels whenever k and their number have a common factor. The seeds are
// those of cases dealt to the levels in turn, from `seed` on.
[[nodiscard]] Suite drawn_suite(const corpus::Family& family, std::span<const double> levels,
                                std::size_t count, std::uint64_t seed);

// The same, for cases for which `takes` is true. Each level looks for its share of cases among kSoughtSeeds times as
// many seeds. An engine that knows few shapes is thus asked about those shapes. There are fewer cases if no more are
// found.
inline constexpr std::size_t kSoughtSeeds = 24;
[[nodiscard]] Suite sought_suite(const corpus::Family& family, std::span<const double> levels,
                                 std::size_t count, std::uint64_t seed,
                                 const std::function<bool(const corpus::Case&)>& takes);

// The bodies of up to `count` casts of a suite, evenly spread, that the exact oracles represent and answer in
// a tenth of a second: to be asked every query.
[[nodiscard]] Suite queried_suite(const Suite& casts, std::size_t count);

[[nodiscard]] bool is_small(const corpus::Case& problem);

// Why the query of a case cannot be judged. Empty if it can.
[[nodiscard]] std::string why_unjudged(const corpus::Case& problem);

}  // namespace graze::tool
