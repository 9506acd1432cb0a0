// Certification of the queries beside the cast: each method on the families' bodies and on the cases that ask
// one: by the exact oracles, and of shapes that those do not represent by proved brackets.
#pragma once

#include <span>

#include "certify/linear.hpp"
#include "engines/guarantees.hpp"
#include "engines/queries.hpp"

namespace graze::tool {

struct QueryTally {
  const engine::QueryMethod* method = nullptr;
  std::size_t cases = 0, wrong = 0, off = 0, bad_contact = 0, stalled = 0, excused = 0;
  std::vector<double> error = {}, normal = {}, witness = {};  // over scale
  std::string first_stalled = {};
};

struct QueryCertification {
  std::vector<QueryTally> tallies;  // by method
  std::vector<std::string> breaches;
  std::vector<corpus::Case> convicted;  // as asked, where a method is at fault or stalls: for each method
};

// Bodies that the exact oracles represent, and small enough for them to answer in a tenth of a second.
[[nodiscard]] bool is_small(const corpus::Case& problem);

// Why the query of a case cannot be judged; empty if it can.
[[nodiscard]] std::string why_unjudged(const corpus::Case& problem);

struct QuerySettings {
  std::span<const engine::QueryMethod> methods = engine::query_methods();
  std::size_t count = 0;  // of the bodies of a suite
  std::span<const engine::Guarantee> guarantees = {};
  unsigned threads = 1;  // the result does not depend on them
};

// The cases `asked` are asked their own query, as they are. The bodies of up to `count` cases of each suite,
// those that the exact oracles represent, are asked every query: those at rest with B at rest somewhere along
// its path.
[[nodiscard]] QueryCertification certify_queries(const std::vector<corpus::Case>& asked,
                                                 const std::vector<Suite>& suites,
                                                 const QuerySettings& settings);

[[nodiscard]] std::string query_table(const QueryCertification& certification,
                                      std::span<const engine::Guarantee> guarantees);

}  // namespace graze::tool
