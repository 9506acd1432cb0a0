// Certification: every method on every suite of its kind, each answer judged, and counted against the
// method's guarantee. Pure but for the clock; the result does not depend on the number of threads.
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
  // Asked between cases: whether to stop. What is judged then is kept.
  std::function<bool()> stop = [] { return false; };
  bool fail_fast = false;  // stops at the first fault
  // Case i of a suite is neither asked nor judged, and in no tally; nothing: every one is judged.
  std::function<bool(const Suite&, std::size_t i)> leaves_out = {};
  // Told of each method's judgement of case i, in the order of cases; one thread at a time.
  std::function<void(const Suite&, std::size_t i, const engine::Method&, const law::Judgement&)> judged = {};
  bool times_casts = true;
  bool allow_declined = false;  // an engine may decline more than kMostDeclined of its questions
};

// What the methods of a kind are asked for: all that they can say. Of bodies that turn also without the
// proof, which may be found in another way.
[[nodiscard]] std::span<const Request> requests_of(engine::Kind kind);

struct Certification {
  std::vector<Tally> tallies;  // by method, in the order of the settings, then by suite
  // Of engines of others, by method, in the order of the settings: answers to what lies beyond the limits that they
  // document. No part of the tallies by suite, and held against no row.
  std::vector<Tally> beyond_limits = {};
  std::vector<std::string> breaches = {};  // empty: every method keeps its row
  std::vector<std::string> declined = {};  // engines that decline more than kMostDeclined of their questions
  std::vector<corpus::Case> convicted = {};  // as asked, each once, where some method is at fault or stalls
  std::size_t answers = 0, answered = 0;     // judged; and of how many cases
  std::size_t questions = 0;                 // cases of suites that some method was to be asked about
  std::string unasked = {};                  // the first that a method was not asked, or refused, and why
  std::size_t oracle_cases = 0;              // of casts without a turn, for which an exact answer was made
  std::vector<std::string> unfinished = {};  // suites that a stop left in part or out

  [[nodiscard]] bool has_kept(const engine::Method& method) const;
  // Of one method on all its suites.
  [[nodiscard]] Tally total(const engine::Method& method) const;
};

[[nodiscard]] Certification certify(const std::vector<Suite>& suites, const Settings& settings);

}  // namespace graze::tool
