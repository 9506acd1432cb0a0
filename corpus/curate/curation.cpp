#include "corpus/curate/curation.hpp"

#include "corpus/format/case_io.hpp"

namespace graze::corpus {

std::vector<std::string> curation_faults(const Case& problem, Shelf shelf) {
  std::vector<std::string> faults;
  const std::size_t slash = problem.id.find('/');
  if (slash == std::string::npos || slash == 0 || slash + 1 == problem.id.size()) {
    faults.push_back("the id is not of the form family/name");
  } else if (problem.id.substr(0, slash) != problem.family) {
    faults.push_back("the id does not begin with its family, " + problem.family);
  }
  if (problem.comment.size() < kShortestComment) {
    faults.push_back("the comment does not say why the case is hard; a sentence would");
  }
  if (shelf == Shelf::cases && problem.flags.empty()) {
    faults.push_back("no flag says what the case breaks; corpus/flags.json lists them");
  }
  if (problem.family == "reported" && problem.source.substr(0, 8) != "https://") {
    faults.push_back("the source of what was reported is not an address that begins with https://");
  }
  return faults;
}

std::string question_of(const Case& problem) {
  Case bare = problem;
  bare.id = "question";
  bare.family.clear();
  bare.hardness.reset();
  bare.comment.clear();
  bare.source.clear();
  bare.flags.clear();
  bare.expect.reset();
  return write_case(bare);
}

}  // namespace graze::corpus
