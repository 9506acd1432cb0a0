// The exact tier on many generated casts, judged to the last bit: each by its proof, one in a hundred by the
// exact oracle, some by CGAL's linear program. GRAZE_EXACT_CASTS=N in the environment judges N of each
// source.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <map>

#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "oracles/polytope/linear_program.hpp"
#include "properties/edit/case.hpp"
#include "properties/generate/case.hpp"
#include "properties/generate/near_degenerate.hpp"
#include "properties/judge/linear_faults.hpp"
#include "properties/laws/linear/exact.hpp"

namespace graze::law {
namespace {

using corpus::Case;

int casts_wanted() {
  const char* given = std::getenv("GRAZE_EXACT_CASTS");
  return given != nullptr ? std::atoi(given) : 200000;
}

bool is_turned(const Case& problem) {
  return !problem.a.orientation.is_identity() || !problem.b.orientation.is_identity();
}

// Integers up to 4, floats, or doubles, by the finest number of the case.
const char* coordinates_of(const Case& problem) {
  bool integers = true, floats = true;
  for (const double x : scalars(problem)) {
    integers = integers && (x == std::floor(x) && std::abs(x) <= 8);
    floats = floats && static_cast<double>(static_cast<float>(x)) == x;
  }
  return integers ? "integers" : floats ? "floats" : "doubles";
}

class Judging {
 public:
  // Casts the case in both scalars if it is a question for the tier. False once one answer is wrong.
  [[nodiscard]] bool judge(const Case& problem) {
    for (const char* name : {"exact/double", "exact/float"}) {
      const engine::Method& method = *engine::find_method(engine::Kind::linear, name);
      const Case seen = method.seen(problem);
      if (!is_question_for(method, seen)) continue;
      const bool sampled = casts_ % 100 == 0;
      const ExactJudgement judgement = judge_exact(seen, method, sampled);
      ++casts_;
      ++counts_[std::string(label_of(judgement.answer.outcome))];
      ++counts_[coordinates_of(seen)];
      if (is_turned(seen)) ++counts_["turned"];
      if (judgement.by_oracle) ++counts_["by oracle"];
      if (judgement.answer.counters.exact_decisions > 0) ++counts_["near a tie"];
      std::string fault = judgement.fault;
      if (fault.empty() && casts_ % 500 == 1) fault = fault_by_program(seen, judgement.answer);
      if (!fault.empty()) {
        ADD_FAILURE() << name << ": " << fault << "\n"
                      << describe(judgement.answer) << "\n"
                      << corpus::write_case(seen);
        return false;
      }
    }
    return true;
  }
  [[nodiscard]] int casts() const { return casts_; }
  [[nodiscard]] int count(const char* label) const {
    const auto found = counts_.find(label);
    return found == counts_.end() ? 0 : found->second;
  }
  void print() const {
    std::cout << casts_ << " casts:";
    for (const auto& [label, count] : counts_) std::cout << "  " << label << " " << count;
    std::cout << "\n";
  }

 private:
  // CGAL: the least t of a program over the vertices as they are given.
  std::string fault_by_program(const Case& seen, const engine::Answer& answer) {
    if (!engine::is_sharp_question(seen)) return {};  // rounded, or at a target distance
    if (vertex_count(seen.a.shape) * vertex_count(seen.b.shape) > 4096) return {};
    ++counts_["by linear program"];
    if (seen.start_policy != StartPolicy::report) return {};
    const std::optional<oracle::Rational> toi = oracle::toi_by_linear_program(seen);
    if (!toi) return answer.outcome == Outcome::miss ? "" : "the linear program has no contact";
    if (sgn(*toi) == 0) {
      return answer.outcome == Outcome::initially_overlapping ? "" : "the linear program starts in contact";
    }
    if (answer.outcome != Outcome::hit) return "the linear program has a contact";
    const bool holds =
        oracle::Rational(answer.toi_lower) <= *toi && *toi <= oracle::Rational(answer.toi_upper);
    return holds ? "" : "the linear program's time is not in the bracket";
  }

  int casts_ = 0;
  std::map<std::string, int> counts_;
};

TEST(ExactTier, EqualsTheOracleOnEveryFamilyAtEveryHardness) {
  Judging judging;
  std::map<std::string, int> by_family;
  bool sound = true;
  for (std::uint64_t seed = 1; sound && judging.casts() < casts_wanted(); ++seed) {
    for (const corpus::Family& family : corpus::families()) {
      for (const double hardness : family.levels) {
        const int before = judging.casts();
        // Few of its cases are polytopes.
        const std::uint64_t draws = family.name == "combinators" ? 16 : 1;
        for (std::uint64_t i = 0; i < draws; ++i) {
          sound = sound && judging.judge(family.generate(hardness, draws * seed + i));
        }
        by_family[std::string(family.name)] += judging.casts() - before;
      }
    }
  }
  judging.print();
  for (const char* name : {"random", "aligned_boxes", "grazing_vertex", "grazing_edge", "grazing_face",
                           "size_ratio", "far_from_origin", "touching", "combinators", "needles", "plates",
                           "parallel_faces", "parallel_edges", "perpendicular", "noisy_copy", "slivers"}) {
    EXPECT_GT(by_family[name], judging.casts() / 1000) << name;
  }
  for (const char* label : {"hit", "miss", "initially_overlapping", "floats", "doubles", "turned"})
    EXPECT_GT(judging.count(label), judging.casts() / 100) << label;
  EXPECT_GE(judging.count("by oracle"), judging.casts() / 100);
  EXPECT_GT(judging.count("by linear program"), judging.casts() / 2000);
}

// Half of these are on small integers, where nearly everything is a tie.
TEST(ExactTier, EqualsTheOracleOnDrawnCasts) {
  Judging judging;
  corpus::Random random(20261121);
  for (int i = 0; judging.casts() < casts_wanted(); ++i) {
    Case problem = draw_case(random, i % 100);
    problem.target_distance = 0;
    if (i % 4 == 0) problem.start_policy = StartPolicy::pass_over;
    if (!judging.judge(problem)) break;
  }
  judging.print();
  for (const char* label :
       {"hit", "miss", "initially_overlapping", "integers", "floats", "doubles", "turned"})
    EXPECT_GT(judging.count(label), judging.casts() / 50) << label;
  EXPECT_GE(judging.count("by oracle"), judging.casts() / 100);
  EXPECT_GT(judging.count("by linear program"), judging.casts() / 2000);
}

// Cases that the filters leave undecided, and supports that differ by the last bits of their coordinates.
TEST(ExactTier, EqualsTheOracleOnNearTies) {
  Judging judging;
  corpus::Random random(20261122);
  while (judging.casts() < casts_wanted() && judging.judge(draw_near_tie(random))) {
  }
  judging.print();
  for (const char* label : {"hit", "miss", "doubles", "turned"})
    EXPECT_GT(judging.count(label), judging.casts() / 10) << label;
  // Those that pairs of doubles leave open, too.
  EXPECT_GT(judging.count("near a tie"), 0);
}

}  // namespace
}  // namespace graze::law
