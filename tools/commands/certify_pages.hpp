// The output of `graze certify`, on the screen and in files.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "certify/certification.hpp"
#include "certify/engine_findings.hpp"
#include "certify/intake.hpp"
#include "certify/worst_cases.hpp"
#include "reports/text/outputs.hpp"
#include "tools/commands/certify_selection.hpp"

namespace graze::tool {

// The files that the command line names. All are opened before anything is judged, so an error in writing is reported
// at once.
class CertifyFiles {
 public:
  explicit CertifyFiles(const CertifyArguments& arguments);
  [[nodiscard]] bool has_page() const { return page_ != nullptr; }
  // `html`: the report, if one is requested.
  void write(const Certification& certification, const Settings& settings, double seconds,
             const std::string& html);

 private:
  std::string report_;
  std::FILE* screen_;
  std::unique_ptr<OutputFile> save_, json_, page_, beside_page_, junit_;
};

// The report that one looks at, as HTML.
[[nodiscard]] std::string certify_page(const CertifyArguments& arguments, const Selection& selection,
                                       const Certification& certification, const Settings& settings,
                                       const WorstCases& worst, const std::vector<EngineFinding>& findings,
                                       double seconds);

// The verdict, each breach, and the tables.
void print_certification(const CertifyArguments& arguments, const Selection& selection,
                         const Certification& certification, const Settings& settings, const Intake& intake,
                         double seconds);

// The file of known failures that are not fixed yet.
[[nodiscard]] std::filesystem::path known_failures();

}  // namespace graze::tool
