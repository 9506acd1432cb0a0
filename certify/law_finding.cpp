#include "certify/law_finding.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "corpus/format/case_io.hpp"
#include "properties/edit/case.hpp"
#include "reports/drawing/draw.hpp"

namespace graze::law {

namespace {

std::string name_of(const Finding& finding) {
  return fmt::format("{}-{:016x}", finding.law, hash_of(finding.problem));
}

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::trunc);
  file << text;
  file.close();
  if (!file)
    throw std::runtime_error(path.string() +
                             ": cannot be written; GRAZE_FINDINGS_DIR names a folder that can");
}

}  // namespace

corpus::Case as_case(const Finding& finding) {
  corpus::Case problem = finding.problem;
  problem.family = "law";
  problem.id = "law/" + name_of(finding);
  problem.hardness.reset();
  problem.expect.reset();
  problem.comment = fmt::format("Breaks the law {} of {}: {}", finding.law, finding.method, finding.reason);
  return problem;
}

SavedFinding save_finding(const Finding& finding, const std::filesystem::path& directory) {
  std::error_code failed;
  std::filesystem::create_directories(directory, failed);
  if (failed)
    throw std::runtime_error(directory.string() +
                             ": cannot be made a folder; GRAZE_FINDINGS_DIR names another");
  const std::string name = name_of(finding);
  const corpus::Case problem = as_case(finding);
  SavedFinding saved{.file = directory / (name + ".jsonl"), .picture = directory / (name + ".svg")};
  write_file(saved.file, corpus::write_case(problem) + "\n");
  write_file(saved.picture, draw::draw_svg(problem));
  return saved;
}

std::string text_of(const Finding& finding, const SavedFinding& saved) {
  const std::string file = saved.file.string();
  return fmt::format(
      "law {} is broken: {}\n"
      "  method   {}\n"
      "  reason   {}\n"
      "  seed     {}\n"
      "  case     graze cast {}\n"
      "  picture  {}\n"
      "  to keep  graze corpus add {} --known\n"
      "{}\n",
      finding.law, finding.sentence, finding.method, finding.reason, finding.seed, file,
      saved.picture.string(), file, corpus::write_case(as_case(finding)));
}

std::filesystem::path findings_directory(const std::filesystem::path& usual) {
  const char* set = std::getenv("GRAZE_FINDINGS_DIR");
  return set != nullptr && *set != '\0' ? std::filesystem::path(set) : usual;
}

}  // namespace graze::law
