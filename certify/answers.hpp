// Digests of the methods' answers to the cases of suites, and of the judgements. With them `graze` certifies another
// build of the same methods by judging only the answers that differ.
//
// The judgement of a case depends on the case, on the answers of all methods to it, and on whether the oracle measures
// it. If every answer of another build has the same digest, the kept judgement still holds. A guarantee breaks in two
// ways. The first is a fault, and only a case with a different answer can add one. The second is too many answers that
// did not converge. These are counted over whole suites: the kept ones of cases with the same answers, and the new
// ones. The digest of an answer holds one bit about its counters: whether the supports exceed the guarantee. No
// judgement reads more of them.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "certify/certification.hpp"

namespace graze::tool {

// Answers with equal bits have equal digests. Two different answers have the same digest with probability 2^-64.
[[nodiscard]] std::uint64_t digest_of(const engine::Answer& answer);

// A method's answers to a case, and the result of their judgement.
struct KeptAnswer {
  enum class State : char { not_judged = '-', kept = '.', stalled = 's' };
  std::uint64_t digest = 0;  // covers all requests in turn, 0 if the method is not asked
  State state = State::not_judged;
  bool operator==(const KeptAnswer&) const = default;
};

// The answers of every method on every suite of its kind.
class KeptAnswers {
 public:
  // By the place of the suite in the list and the method's name: an answer for each case.
  using Key = std::pair<std::size_t, std::string>;

  // Asks the methods, and judges nothing.
  KeptAnswers(const std::vector<Suite>& suites, const std::vector<const engine::Method*>& methods,
              unsigned threads);
  // The answers of this method to the cases of the suite with this place. Asks no other method.
  [[nodiscard]] const std::vector<KeptAnswer>& of(std::size_t suite, const engine::Method& method) const;
  [[nodiscard]] std::vector<KeptAnswer>& of(std::size_t suite, const engine::Method& method);

  // The cases of the suites, true if a method of these answers has another digest than in `kept`. Throws
  // std::runtime_error if `kept` belongs to other suites or lacks a method.
  [[nodiscard]] std::vector<std::vector<bool>> differ_from(const KeptAnswers& kept) const;

  void write(std::ostream& out) const;
  // Throws std::runtime_error for input that write() has not written.
  static KeptAnswers read(std::istream& in);

 private:
  KeptAnswers() = default;
  std::map<Key, std::vector<KeptAnswer>> answers_;
};

// Judges everything, and keeps the results in `answers`. Returns the guarantees that break.
[[nodiscard]] std::vector<std::string> judge_all(const std::vector<Suite>& suites, const Settings& settings,
                                                 KeptAnswers& answers);

// The guarantees that break, found by judging only the cases that differ from `kept`, up to the first that is certain
// to break.
[[nodiscard]] std::vector<std::string> judge_differing(const std::vector<Suite>& suites,
                                                       const Settings& settings, const KeptAnswers& kept,
                                                       const std::vector<std::vector<bool>>& differing);

}  // namespace graze::tool
