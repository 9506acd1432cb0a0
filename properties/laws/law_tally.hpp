// The record of a law in a run: how often it applied, to which family, with which labels, and what it lacked.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "properties/laws/law.hpp"

namespace graze::law {

class LawTally {
 public:
  explicit LawTally(const Law& law)
      : law_(law.name), kind_(law.kind), applied_to_(law.methods().size()), stalled_(law.methods().size()) {}

  // family: the family of the case, or empty if it was drawn freely.
  void add(std::size_t method, std::string_view family, const LawResult& result);
  void add(const LawTally& other);  // of the same law

  [[nodiscard]] std::size_t applied() const { return applied_; }  // pairs of a case and a method
  [[nodiscard]] std::size_t not_applicable() const { return not_applicable_; }
  [[nodiscard]] std::size_t left_open() const {
    return left_open_;
  }  // of those: an oracle called without
     // result
  [[nodiscard]] std::size_t broken() const { return broken_; }
  // By label. Answers to which the law did not apply count too, if they have a label ("undecided").
  [[nodiscard]] const std::map<std::string, std::size_t>& labels() const { return labels_; }
  [[nodiscard]] std::size_t count(const std::string& label) const;
  [[nodiscard]] bool reached(const std::string& family) const { return families_.contains(family); }

  // Each empty, or what was lacking.
  // The law never applied, or an outcome that it must see was never there.
  [[nodiscard]] std::string shortfall_of_outcomes() const;
  // A family that it must reach was never reached, or one out of its reach was.
  [[nodiscard]] std::string shortfall_of_families() const;
  // For linear casts: more answers were not_converged than the method's guarantee allows.
  [[nodiscard]] std::string excess_of_stalls() const;

  // "swapping: hit 12  miss 30"
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] bool saw(std::string_view outcome) const;

  std::string law_;
  Kind kind_;
  std::size_t applied_ = 0, not_applicable_ = 0, left_open_ = 0, broken_ = 0;
  std::map<std::string, std::size_t> labels_;
  std::set<std::string> families_;
  std::vector<std::size_t> applied_to_, stalled_;  // by method
};

}  // namespace graze::law
