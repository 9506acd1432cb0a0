// Runs laws over suites of cases, on a few threads, and counts where they broke. The result does not depend on the
// number of threads.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "certify/law_finding.hpp"
#include "certify/suites.hpp"
#include "corpus/case.hpp"
#include "properties/laws/law.hpp"
#include "properties/laws/law_tally.hpp"

namespace graze::tool {

// A rotating case is judged by the rotating laws, any other by the linear ones and those of the queries.
struct LawSuite {
  Suite suite;
  // The command that generates case i again. Empty for given cases, which are identified by their id.
  std::function<std::string(std::size_t)> seed = {};
};

struct LawSettings {
  std::vector<law::Law> laws;
  std::function<bool(const engine::Method&)> is_asked = [](const engine::Method&) { return true; };
  // Third-party engines, as `as_laws_ask` wraps them (laws_of_others.hpp). The span must outlive the run.
  std::span<const engine::Method> others = {};
  unsigned threads = 1;
  // Called between cases: true ends the run. The results until then are kept.
  std::function<bool()> stop = [] { return false; };
  int shrinking = 1000;  // calls of a law to reduce its first broken case, a tenth for rotating bodies
};

// A law broken by a method: the first case that broke it, and the number of such cases. Third-party methods are
// numbered after ours.
struct LawBreach {
  std::size_t law = 0, method = 0;
  std::size_t suite = 0, index = 0;  // place of that case
  std::size_t times = 0;
  law::Finding finding;  // the case made small
  std::string first;     // its id before
};

// The results of a law for a third-party engine.
struct OtherLawTally {
  std::size_t law = 0, other = 0;  // indices into the settings
  std::string_view why_not = {};   // it is not asked this law at all
  std::size_t answers = 0, broken = 0, failed = 0;
  std::size_t skipped = 0;  // the engine does not take a question of the law
  std::size_t open = 0;     // the law does not speak of the case, or its oracle leaves it open
};

struct LawCertification {
  std::size_t cases = 0;                // cases that the laws were asked about
  std::vector<law::LawTally> tallies;   // by law
  std::vector<OtherLawTally> others;    // by law, then by third-party method, for laws of its kind
  std::vector<LawBreach> breaches;      // by law, then by method
  std::vector<std::string> unfinished;  // suites that a stop left in part or out
};

[[nodiscard]] LawCertification certify_laws(std::span<const LawSuite> suites, const LawSettings& settings);

// The same for third-party engines, with the numbers of questions that they are not asked.
[[nodiscard]] std::string other_law_table(const LawCertification& certification, const LawSettings& settings);

// Law by law: what it needs, and how many answers of which outcome it was asked about.
[[nodiscard]] std::string law_table(const LawCertification& certification, const LawSettings& settings);

}  // namespace graze::tool
