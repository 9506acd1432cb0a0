#include "tests/properties/laws/law_run.hpp"

#include <algorithm>
#include <iostream>
#include <sstream>

#include "certify/law_finding.hpp"
#include "corpus/format/case_io.hpp"
#include "properties/generate/shrink.hpp"
#include "properties/laws/reach.hpp"

namespace graze::law {

bool LawRun::holds_for(const corpus::Case& problem, std::string_view family) {
  for (std::size_t method = 0; method < law_.methods().size(); ++method) {
    LawResult result = law_.check(problem, law_.methods()[method]);
    if (result.holding == Holding::broken &&
        is_known_breach(law_.name, law_.methods()[method].question_name())) {
      ++known_breaches_;
      continue;
    }
    tally_.add(method, family, result);
    if (result.holding == Holding::broken) {
      reason_ = std::move(result.reason);
      failing_ = problem;
      broken_method_ = method;
      return false;
    }
    const auto& labels = result.labels;
    if (std::find(labels.begin(), labels.end(), "not_converged") != labels.end()) stalled_ = problem;
  }
  return true;
}

void LawRun::minimise(int budget) {
  const auto broken = [&](const corpus::Case& c) {
    return law_.check(c, law_.methods()[broken_method_]).holding == Holding::broken;
  };
  failing_ = minimised(failing_, broken, budget);
  reason_ = law_.check(failing_, law_.methods()[broken_method_]).reason;
}

std::string LawRun::report(std::string_view seed) const {
  const Finding finding{.law = law_.name,
                        .sentence = law_.sentence,
                        .method = law_.methods()[broken_method_].question_name(),
                        .reason = reason_,
                        .seed = std::string(seed),
                        .problem = failing_};
  return text_of(finding, save_finding(finding, findings_directory(GRAZE_FINDINGS_DIR)));
}

std::string LawRun::shortfall() const {
  if (std::string lacking = tally_.shortfall_of_outcomes(); !lacking.empty()) return lacking;
  const std::string stalls = tally_.excess_of_stalls();
  return stalls.empty() ? "" : stalls + "; the last: " + corpus::write_case(stalled_);
}

std::string LawRun::shortfall_over_families() const {
  const std::span<const Method> methods = law_.methods();
  const bool expected = std::any_of(methods.begin(), methods.end(), [&](const Method& method) {
    return is_known_breach(law_.name, method.question_name());
  });
  if (expected && known_breaches_ == 0) {
    return std::string(law_.name) +
           " is broken no more: take it out of the known breaches of "
           "properties/laws/reach.cpp";
  }
  const std::string lacking = shortfall();
  return lacking.empty() ? tally_.shortfall_of_families() : lacking;
}

void LawRun::print() const {
  std::cout << source_ << ": " << tally_.text();
  if (known_breaches_ > 0) std::cout << "  known breaches " << known_breaches_;
  std::cout << "\n";
}

std::string seed_of(std::string_view family, double hardness, std::uint64_t seed) {
  std::ostringstream text;
  text << "graze generate " << family << " --hardness " << hardness << " --seed " << seed << " --count 1";
  return text.str();
}

}  // namespace graze::law
