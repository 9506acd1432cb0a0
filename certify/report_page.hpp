// A certification as a page (reports/pages/page.hpp): the verdict, the methods with their guarantees and times, and the
// worst cases.
#pragma once

#include <string>

#include "certify/certification.hpp"
#include "certify/engine_findings.hpp"
#include "certify/worst_cases.hpp"

namespace graze::tool {

struct ReportInput {
  const Certification& certification;
  const Settings& settings;
  const WorstCases& worst;
  const std::vector<EngineFinding>& findings;
  double seconds = 0;
  std::string command;           // the command that made the report
  std::string plain;             // the tables as text, for a page without the viewer
  std::size_t most_scenes = 40;  // named cases that can be viewed, the worst first
};

// The whole of index.html.
[[nodiscard]] std::string report_page(const ReportInput& input);

}  // namespace graze::tool
