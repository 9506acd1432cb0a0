// read_documents KIND: reads a document a line with the readers that graze itself has, and prints of each a line: "ok", or
// what is wrong with it. KIND is case, proof, engine, scene, or, of answers, the query: cast, distance, penetration. An answer is
// one to the question "q1", of an engine that promises all that an answer to such a query holds.
#include <iostream>
#include <stdexcept>
#include <string>

#include "certify/external/declaration.hpp"
#include "certify/external/read_answer.hpp"
#include "corpus/format/case_io.hpp"
#include "corpus/format/proof_io.hpp"
#include "scene/format/scene_io.hpp"

namespace graze {
namespace {

std::string wrong_with_case(const std::string& line) {
  const corpus::ReadResult read = corpus::read_text(line, "line", false);
  return read.ok() ? "" : read.errors[0].text();
}

std::string wrong_with_proof(const std::string& line) {
  const corpus::ProofReadResult read = corpus::read_proofs_text(line, "line");
  return read.ok() ? "" : read.errors[0].text();
}

std::string wrong_with_scene(const std::string& line) {
  const scene::ReadResult read = scene::read_scene_text(line, "line");
  return read.document ? "" : read.errors[0].text();
}

std::string wrong_with_engine(const std::string& line) {
  try {
    (void)external::parse_declaration(line);
    return "";
  } catch (const std::runtime_error& bad) {
    return bad.what();
  }
}

std::string wrong_with_answer(const std::string& line, const std::string& query) {
  external::Offer offer;
  offer.question = query == "distance"      ? external::Question::distance
                   : query == "penetration" ? external::Question::penetration
                                            : external::Question::cast;
  offer.holds = {.time = true, .normal = true, .witnesses = true};
  offer.holds_distance = offer.holds_depth = offer.holds_proof = true;
  const external::Terms terms;
  const engine::Answer answer = external::read_answer(line, "q1", offer, terms);
  return answer.failure == engine::Failure::none ? "" : answer.message;
}

std::string wrong_with(const std::string& kind, const std::string& line) {
  if (kind == "case") return wrong_with_case(line);
  if (kind == "proof") return wrong_with_proof(line);
  if (kind == "scene") return wrong_with_scene(line);
  if (kind == "engine") return wrong_with_engine(line);
  return wrong_with_answer(line, kind);
}

}  // namespace
}  // namespace graze

int main(int count, char** words) {
  if (count != 2) return 2;
  std::string line;
  while (std::getline(std::cin, line)) {
    const std::string wrong = graze::wrong_with(words[1], line);
    std::cout << (wrong.empty() ? "ok" : wrong) << "\n";
  }
  return 0;
}
