// Running a law over many cases: counting what was drawn, and keeping what broke.
//
// A run fails when the law breaks, and also when an outcome (hit, miss, initially_overlapping) was never
// reached: a law that saw no hit says nothing about hits. It fails too when more answers were not_converged
// than the method's row allows.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "corpus/case_io.hpp"
#include "engines/guarantees.hpp"
#include "engines/method.hpp"
#include "properties/law.hpp"
#include "properties/shrink.hpp"

namespace graze::law {

class LawRun {
 public:
  LawRun(const Law& law, std::string source) : law_(law), source_(std::move(source)) {}

  // Asks every method; true if the law holds or does not apply.
  bool holds_for(const corpus::Case& problem) {
    for (const engine::EngineMethod& method : engine::methods()) {
      LawResult result = law_.check(problem, method);
      if (result.holding == Holding::broken) {
        reason_ = method.full_name() + ": " + result.reason;
        failing_ = problem;
        return false;
      }
      if (result.holding == Holding::not_applicable) {
        ++counts_["not applicable"];
        for (const std::string_view label : result.labels) ++counts_[std::string(label)];
        continue;
      }
      ++applied_[method.full_name()];
      for (const std::string_view label : result.labels) {
        ++counts_[std::string(label)];
        if (label == "not_converged") {
          ++stalled_[method.full_name()];
          stalled_case_ = problem;
        }
      }
    }
    return true;
  }

  // The broken case made small; what breaks it then may be another reason.
  void minimise() {
    const corpus::Case least = minimised(
        failing_, [&](const corpus::Case& c) { return !holds_for(c); }, 3000);
    (void)holds_for(least);
  }

  // What the last broken case was, saved as a file ready for `graze cast`; the last one is the smallest.
  [[nodiscard]] std::string report() const {
    std::ostringstream out;
    out << "law " << law_.name << " is broken: " << law_.sentence << "\n"
        << reason_ << "\n"
        << corpus::write_case(failing_) << "\n";
    std::error_code ignored;
    const std::filesystem::path directory = GRAZE_FINDINGS_DIR;
    std::filesystem::create_directories(directory, ignored);
    const std::filesystem::path file = directory / (std::string(law_.name) + "-" + source_ + ".json");
    corpus::Case saved = failing_;
    saved.comment = "Breaks the law " + std::string(law_.name) + ": " + reason_;
    std::ofstream(file) << corpus::write_case_pretty(saved);
    out << "saved as " << file.string();
    return out.str();
  }

  // Empty, or which outcome was never drawn, or which method stalled too often.
  [[nodiscard]] std::string shortfall() const {
    for (const char* outcome : {"hit", "miss", "initially_overlapping"}) {
      if (!counts_.contains(outcome)) return std::string("no ") + outcome + " was ever drawn";
    }
    for (const engine::EngineMethod& method : engine::methods()) {
      const auto stalled = stalled_.find(method.full_name());
      // Where tier certified may leave a verdict open is a law's business: certified_decides.
      if (stalled == stalled_.end() || method.is_certified()) continue;
      const engine::Guarantee* row = engine::find_guarantee(engine::guarantees(), method);
      // One stall is allowed to a run that is too short to hold a fraction to its cap.
      const double allowed =
          row->stall_cap > 0 ? std::max(1.0, row->stall_cap * applied_.at(method.full_name())) : 0;
      if (stalled->second > allowed) {
        return method.full_name() + " did not converge " + std::to_string(stalled->second) +
               " times; the last: " + corpus::write_case(stalled_case_);
      }
    }
    return "";
  }

  void print() const {
    std::cout << law_.name << " over " << source_ << ":";
    for (const auto& [label, count] : counts_) std::cout << "  " << label << " " << count;
    std::cout << "\n";
  }

 private:
  const Law& law_;
  std::string source_, reason_;
  corpus::Case failing_, stalled_case_;
  std::map<std::string, int> counts_, applied_, stalled_;
};

}  // namespace graze::law
