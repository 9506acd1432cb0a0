// The input of `graze certify`: the methods that the command line selects, and the cases that they are asked.
#pragma once

#include <string>
#include <vector>

#include "certify/intake.hpp"
#include "tools/commands/certify_arguments.hpp"

namespace graze::tool {

// The methods that the command line selects, each with its guarantee.
class Selection {
 public:
  explicit Selection(const JudgedArguments& arguments);
  [[nodiscard]] const Engines& engines() const { return engines_; }
  Selection(const Selection&) = delete;
  Selection& operator=(const Selection&) = delete;

  [[nodiscard]] std::vector<const engine::Method*> all() const;
  [[nodiscard]] bool has_ours() const;
  [[nodiscard]] bool has(engine::Kind kind) const;
  // True if some third-party engine is asked the cast or queries about its bodies.
  [[nodiscard]] bool takes(const corpus::Case& problem) const;
  // Why the first of the methods that it is a question for is not asked it.
  [[nodiscard]] std::string why_not(const corpus::Case& problem) const;

 private:
  void read_table(const std::string& name);

  std::vector<engine::Guarantee> table_;
  Engines engines_;
  std::vector<engine::Method> methods_;
};

// The curated corpus, the files and the families that are asked for. True if something could not be read.
bool take_all(Intake& intake, const CertifyArguments& arguments, const Selection& selection);

}  // namespace graze::tool
