// Certification of the queries beside the cast: each method on the families' bodies, by the exact oracles.
#pragma once

#include "engines/guarantees.hpp"
#include "tools/certification.hpp"

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
  std::vector<corpus::Case> convicted;  // each case on which a method is at fault, as it was asked
};

// The bodies of up to `count` cases of each suite, those that the exact oracles represent, are asked every
// query: those at rest with B at rest somewhere along its path.
[[nodiscard]] QueryCertification certify_queries(const std::vector<Suite>& suites, std::size_t count,
                                                 std::span<const engine::Guarantee> guarantees,
                                                 unsigned threads);

[[nodiscard]] std::string query_table(const QueryCertification& certification,
                                      std::span<const engine::Guarantee> guarantees);

}  // namespace graze::tool
