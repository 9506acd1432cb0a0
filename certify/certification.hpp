// Certification runs every method on every suite of its kind, judges each answer, and counts it against the method's
// guarantee. The result depends on the inputs and the clock, and not on the number of threads.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "certify/suites.hpp"
#include "certify/tally.hpp"

namespace graze::tool {

struct Settings {
  std::vector<const engine::Method*> methods;  // of any kind
  unsigned threads = 1;
  // Called between cases: true ends the run. The judgements made until then are kept.
  std::function<bool()> stop = [] { return false; };
  bool fail_fast = false;  // stops at the first fault
  // True for a case i of a suite to skip: it is neither asked nor judged, and is in no tally. Empty: every case is
  // judged.
  std::function<bool(const Suite&, std::size_t i)> leaves_out = {};
  // Called with each method's judgement of case i, in the order of cases, by one thread at a time.
  std::function<void(const Suite&, std::size_t i, const engine::Method&, const law::Judgement&)> judged = {};
  bool times_casts = true;
  bool allow_declined = false;  // an engine may decline more than kMostDeclined of its questions
};

// The requests to the methods of a kind: everything that they can return. Rotating casts are also requested without the
// proof, because the answer may be found in another way then.
[[nodiscard]] std::span<const Request> requests_of(engine::Kind kind);

struct Certification {
  std::vector<Tally> tallies;  // by method, in the order of the settings, then by suite
  // Answers of third-party engines to cases beyond their documented limits, by method, in the order of the settings.
  // They are not part of the tallies by suite and do not affect the verdict.
  std::vector<Tally> beyond_limits = {};
  std::vector<std::string> breaches = {};  // empty if every method keeps its guarantee
  std::vector<std::string> declined = {};  // engines that decline more than kMostDeclined of their questions
  std::vector<corpus::Case> convicted = {};  // as asked, each once, if a method is at fault or did not
                                             // converge
  std::size_t answers = 0, answered = 0;     // judged answers, and the number of cases they belong to
  std::size_t questions = 0;                 // cases of suites that some method was to be asked about
  std::string unasked = {};                  // the first that a method was not asked, or refused, and why
  std::size_t oracle_cases = 0;              // linear casts for which an exact answer was made
  std::vector<std::string> unfinished = {};  // suites that a stop left in part or out

  [[nodiscard]] bool has_kept(const engine::Method& method) const;
  // The tally of one method over all its suites.
  [[nodiscard]] Tally total(const engine::Method& method) const;
};

[[nodiscard]] Certification certify(const std::vector<Suite>& suites, const Settings& settings);

}  // namespace graze::tool
