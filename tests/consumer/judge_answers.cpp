// Judges the answers of a consumer's program. usage: judge_answers REFERENCE_DIRECTORY DIRECTORY
//
// Both directories hold answers.txt and proofs.jsonl of tests/consumer/project. The reference is from a
// program built with our own flags. For every line:
//   1. The scene has the same bits as the reference's.
//   2. The exact checker accepts the proof.
//   3. The verdict is the reference's, and the brackets are apart by no more than kappa u scale (a length: times are
//      multiplied by |v|). If either does not hold, the exact oracle must find no fault beyond kappa u scale with the
//      answer (properties/judge/linear_faults.hpp), kappa from the method's guarantee.
//   4. The oracle judges every kSample-th answer, whatever it is, and its normal too.
// Exit code: 0, or 1 with each fault on a line.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "corpus/format/proof_io.hpp"
#include "engines/method.hpp"
#include "oracles/checker/check_proof.hpp"
#include "properties/judge/linear_faults.hpp"

namespace {

using namespace graze;

constexpr std::size_t kSample = 10;
constexpr std::size_t kShown = 20;  // faults printed, of all that are counted

struct Line {
  corpus::ProofRecord record;
  engine::Answer answer;
};

// strtod reads the hexfloats, "inf" and "nan" that %a wrote. Streams do not.
double read_number(std::ifstream& in) {
  std::string word;
  in >> word;
  return std::strtod(word.c_str(), nullptr);
}

std::vector<Line> read(const std::filesystem::path& directory) {
  corpus::ProofReadResult proofs = corpus::read_proofs_file(directory / "proofs.jsonl");
  for (std::size_t i = 0; i < std::min(proofs.errors.size(), kShown); ++i) {
    fmt::print("{}\n", proofs.errors[i].text());
  }
  std::vector<Line> out;
  if (!proofs.ok()) return out;
  std::ifstream answers(directory / "answers.txt");
  for (corpus::ProofRecord& record : proofs.proofs) {
    Line line;
    std::string outcome;
    answers >> outcome;
    line.answer.outcome = record.outcome;
    if (outcome != law::label_of(record.outcome)) {
      fmt::print("{}: answers.txt does not go with proofs.jsonl at {}\n", directory.string(),
                 record.problem.id);
      return {};
    }
    line.answer.toi_lower = read_number(answers);
    line.answer.toi_upper = read_number(answers);
    for (Vec3<double>* v : {&line.answer.normal, &line.answer.point_a, &line.answer.point_b}) {
      for (int i = 0; i < 3; ++i) (*v)[i] = read_number(answers);
    }
    line.record = std::move(record);
    out.push_back(std::move(line));
  }
  return out;
}

bool agree(const engine::Answer& one, const engine::Answer& other, double speed, double bound) {
  if (one.outcome != other.outcome) return false;
  if (one.outcome != Outcome::hit) return true;
  return std::abs(one.toi_lower - other.toi_lower) * speed <= bound &&
         std::abs(one.toi_upper - other.toi_upper) * speed <= bound;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    fmt::print(stderr, "usage: judge_answers REFERENCE_DIRECTORY DIRECTORY\n");
    return 2;
  }
  const std::vector<Line> reference = read(arguments[1]), given = read(arguments[2]);
  if (reference.size() < 1000 || given.size() != reference.size()) {
    fmt::print("{} answers, and {} of the reference: at least 1000 of each should be\n", given.size(),
               reference.size());
    return 1;
  }
  std::size_t faults = 0;
  int same_bits = 0, verdicts = 0, apart = 0, by_oracle = 0, lower_half = 0, upper_half = 0;
  const auto fault = [&](const Line& line, const std::string& what) {
    if (faults++ < kShown)
      fmt::print("{} {}/{}: {}\n", line.record.problem.id, line.record.method, line.record.scalar, what);
  };
  for (std::size_t k = 0; k < given.size(); ++k) {
    const Line &line = given[k], &right = reference[k];
    const corpus::Case& problem = line.record.problem;
    if (corpus::write_case(problem) != corpus::write_case(right.record.problem)) {
      fault(line, "the scene differs from the reference's");
      continue;
    }
    const oracle::Verdict verdict = oracle::check_proof(problem, line.record.proof);
    if (!verdict.accepted()) {
      fault(line, fmt::format("proof refused: {}: {}", to_string(verdict.refusal), verdict.detail));
    }
    lower_half += line.record.proof.has_axis ? 1 : 0;
    upper_half += line.record.proof.portal_size > 0 ? 1 : 0;
    if (line.answer.outcome == Outcome::not_converged) fault(line, "stalls");
    const engine::Method* method =
        engine::find_method(engine::Kind::linear, line.record.method + "/" + line.record.scalar);
    if (method == nullptr) {
      fault(line, "is no method");
      continue;
    }
    const double speed = (problem.b.displacement - problem.a.displacement).norm();
    const double bound = law::bound_of(*method, problem);
    same_bits += line.answer.outcome == right.answer.outcome &&
                 (line.answer.outcome != Outcome::hit || line.answer.toi_lower == right.answer.toi_lower);
    verdicts += line.answer.outcome != right.answer.outcome;
    const bool agreed = agree(line.answer, right.answer, speed, bound);
    apart += !agreed;
    if (agreed && k % kSample != 0) continue;
    ++by_oracle;
    const std::string reason = law::any_fault(law::truth_of(problem), line.answer, bound);
    if (!reason.empty()) fault(line, reason);
    if (line.answer.outcome == Outcome::hit) {
      const std::string wrong = law::normal_fault(problem, line.answer, line.answer.normal, bound);
      if (!wrong.empty()) fault(line, wrong);
    }
  }
  fmt::print(
      "{} answers: {} the reference's to the last bit of toi_lower, {} with another verdict, {} apart by "
      "more "
      "than kappa u scale; {} judged by the oracle; {} proofs with an axis, {} with a portal; {} faults\n",
      given.size(), same_bits, verdicts, apart, by_oracle, lower_half, upper_half, faults);
  // The proofs must say something: nearly every hit has both halves, and every other contact an upper one.
  const auto hits = std::count_if(given.begin(), given.end(),
                                  [](const Line& line) { return line.answer.outcome == Outcome::hit; });
  if (2 * upper_half < hits || 2 * lower_half < hits) {
    fmt::print("too few proofs for {} hits\n", hits);
    return 1;
  }
  return faults == 0 ? 0 : 1;
}
