// What methods answered to the cases of suites, and what was judged of it, kept as digests: to certify another
// build of the same methods by judging only what it answers differently.
//
// A judgement of a case is a function of the case, of the answers of all methods to it, and of whether the
// oracle measures it. Where every answer of another build has the same digest, its judgement is the one that is
// kept. A row breaks by a fault, which only a case with another answer can bring, or by too many stalls, and
// stalls are counted over whole suites: the kept ones of cases with the same answers, and the new ones.
// Of an answer's counters its digest holds whether the supports exceed the guarantee: no judgement reads more of them.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "certify/certification.hpp"

namespace graze::tool {

// Equal bits have equal digests; two answers that differ have the same one of 2^64 by chance alone.
[[nodiscard]] std::uint64_t digest_of(const engine::Answer& answer);

// A method's answers to a case, and what came of them.
struct KeptAnswer {
  enum class State : char { not_judged = '-', kept = '.', stalled = 's' };
  std::uint64_t digest = 0;  // of all requests in turn; 0: it is not asked
  State state = State::not_judged;
  bool operator==(const KeptAnswer&) const = default;
};

// Of every method on every suite of its kind.
class KeptAnswers {
 public:
  // By the place of the suite in the list and the method's name: an answer for each case.
  using Key = std::pair<std::size_t, std::string>;

  // What the methods answer, without a judgement.
  KeptAnswers(const std::vector<Suite>& suites, const std::vector<const engine::Method*>& methods,
              unsigned threads);
  // Of the one method that is asked here: the answers to a case of the suite with this place.
  [[nodiscard]] const std::vector<KeptAnswer>& of(std::size_t suite, const engine::Method& method) const;
  [[nodiscard]] std::vector<KeptAnswer>& of(std::size_t suite, const engine::Method& method);

  // The cases of the suites, true where a method of these answers has another digest than it has in `kept`.
  // Throws std::runtime_error where `kept` is not of these suites or lacks a method.
  [[nodiscard]] std::vector<std::vector<bool>> differ_from(const KeptAnswers& kept) const;

  void write(std::ostream& out) const;
  // Throws std::runtime_error for what write() has not written.
  static KeptAnswers read(std::istream& in);

 private:
  KeptAnswers() = default;
  std::map<Key, std::vector<KeptAnswer>> answers_;
};

// Judges everything, and keeps what came of it in `answers`. Returns the rows that break.
[[nodiscard]] std::vector<std::string> judge_all(const std::vector<Suite>& suites, const Settings& settings,
                                                 KeptAnswers& answers);

// The rows that break, found by judging the cases that differ from `kept` alone, up to the first that is sure to
// break.
[[nodiscard]] std::vector<std::string> judge_differing(const std::vector<Suite>& suites,
                                                       const Settings& settings, const KeptAnswers& kept,
                                                       const std::vector<std::vector<bool>>& differing);

}  // namespace graze::tool
