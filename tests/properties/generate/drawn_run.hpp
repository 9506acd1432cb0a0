// A law over cases drawn and made smaller by RapidCheck.
#pragma once

#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

#include "properties/generate/generators.hpp"
#include "tests/properties/laws/law_run.hpp"

namespace graze::law {

// Uses RC_PARAMS of the environment, or `usual`. Call it before RapidCheck first reads its configuration.
// True if the environment sets RC_PARAMS, which then gives the number of cases, too.
inline bool takes_given_parameters(const char* usual) {
  const bool given = std::getenv("RC_PARAMS") != nullptr;
  setenv("RC_PARAMS", usual, 0);
  return given;
}

// Empty if the law held for every case, else the report. cases: their number, or nullopt for that of
// RC_PARAMS.
[[nodiscard]] inline std::string fault_of_drawn(LawRun& run, const rc::Gen<Drawn>& generator,
                                                std::optional<int> cases) {
  rc::detail::TestParams parameters = rc::detail::configuration().testParams;
  if (cases) parameters.maxSuccess = *cases;
  const rc::detail::TestResult result = rc::detail::checkTestable(
      [&] {
        const Drawn drawn = *generator;
        RC_ASSERT(run.holds_for(drawn.problem));
      },
      rc::detail::TestMetadata{run.law().name, run.law().sentence}, parameters);
  run.print();
  if (result.is<rc::detail::SuccessResult>()) return "";
  // RapidCheck's own shrinking stops where another method breaks the law. From there the case shrinks by one
  // method.
  run.minimise();
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  const char* given = std::getenv("RC_PARAMS");
  return run.report("RC_PARAMS=\"" + std::string(given != nullptr ? given : "") + "\"") + text.str();
}

}  // namespace graze::law
