#include "certify/built_in.hpp"

namespace graze::tool {

void take_families(Intake& intake, std::span<const corpus::Family* const> families, const Counts& counts,
                   std::uint64_t seed, std::size_t oracle_every) {
  for (const corpus::Family* family : families) {
    const std::size_t count = family->rotating ? counts.rotating : counts.linear;
    if (count == 0) continue;
    Suite suite = drawn_suite(*family, family->levels, count, seed);
    suite.oracle_every = oracle_every;
    intake.suites.push_back(std::move(suite));
  }
}

void take_queries(Intake& intake, const Counts& counts) {
  if (counts.queries == 0) return;
  std::vector<Suite> queried;
  for (const Suite& suite : intake.suites) {
    if (suite.kind == engine::Kind::linear) queried.push_back(queried_suite(suite, counts.queries));
  }
  for (Suite& suite : queried) {
    if (suite.size() > 0) intake.suites.push_back(std::move(suite));
  }
}

}  // namespace graze::tool
