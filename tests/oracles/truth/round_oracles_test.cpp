// Rounded polytopes and target distances: the exact oracle (a hull of differences), the closed forms (pieces of the
// boundary) and a third way (every triple of differences is taken for a face, tests/core/casts/round_truth.hpp) agree on
// every curated case that they all take, and on drawn ties.
#include <gtest/gtest.h>

#include <cstdio>

#include "corpus/curate/location.hpp"
#include "corpus/families.hpp"
#include "corpus/format/case_io.hpp"
#include "oracles/polytope/exact_body.hpp"
#include "oracles/truth/closed_form.hpp"
#include "oracles/truth/linear_truth.hpp"
#include "tests/core/casts/round_truth.hpp"

namespace graze::oracle {
namespace {

using corpus::Case;
using test::RoundTruth;

// The third way looks at every triple of differences.
constexpr std::size_t kMostDifferences = 64;

std::size_t vertices(const Shape<double>& shape) { return test::core_of<double>(shape).vertex.size(); }
bool has_hull_of(const Shape<double>& shape) {
  return std::visit(
      [](const auto& one) {
        if constexpr (requires { one.shapes; }) {
          if constexpr (std::same_as<std::remove_cvref_t<decltype(one)>, HullOf<double>>) return true;
          return std::any_of(one.shapes.begin(), one.shapes.end(),
                             [](const auto& part) { return has_hull_of(part->shape); });
        } else if constexpr (requires { one.shape; }) {
          return has_hull_of(one.shape->shape);
        } else {
          return false;
        }
      },
      shape);
}

// Empty, or what differs.
std::string third_says(const Case& problem, const LinearTruth& truth) {
  const RoundTruth third(problem.a, problem.b, problem.target_distance);
  if (third.starts_in_contact() != (truth.outcome() == Outcome::initially_overlapping))
    return "another start";
  if (truth.outcome() == Outcome::initially_overlapping) return {};
  std::optional<Rational> end;
  if (problem.t_max < kInfinity<double>) end = Rational(problem.t_max);
  if (truth.outcome() == Outcome::miss)
    return third.moves() && third.contact_until(end) ? "contact, of a miss" : "";
  const Rational lower(truth.toi_lower()), upper(truth.toi_upper());
  if (third.contact_until(lower, true)) return "contact before toi_lower";
  if (!third.contact_until(upper)) return "no contact by toi_upper";
  if (lower == upper) return {};
  if (third.contact_until(lower)) return "contact at toi_lower";
  return third.contact_until(upper, true) ? "" : "no contact before toi_upper";
}

struct Count {
  int cases = 0, closed = 0;
};

void compare(Case problem, Count& count) {
  if (!problem.spin_a.rotation.isZero(0) || !problem.spin_b.rotation.isZero(0)) return;
  if (!is_exact_body(problem.a.shape) || !is_exact_body(problem.b.shape)) return;
  if (has_hull_of(problem.a.shape) || has_hull_of(problem.b.shape)) return;
  if (vertices(problem.a.shape) * vertices(problem.b.shape) > kMostDifferences) return;
  problem.query = corpus::Query::cast;
  problem.start_policy = StartPolicy::report;
  const RoundTruth third(problem.a, problem.b, problem.target_distance);
  if (third.radius() == 0) return;
  const LinearTruth truth(problem);
  ++count.cases;
  EXPECT_EQ(third_says(problem, truth), "") << corpus::write_case(problem);
  const auto closed = ClosedForm::of(problem);
  if (!closed) return;
  ++count.closed;
  EXPECT_EQ(closed->outcome(), truth.outcome()) << problem.id;
  if (truth.outcome() != Outcome::hit) return;
  EXPECT_EQ(closed->toi_lower(), truth.toi_lower()) << problem.id;
  EXPECT_EQ(closed->toi_upper(), truth.toi_upper()) << problem.id;
}

TEST(RoundOracles, AgreeOnEveryCuratedCase) {
  Count count;
  for (const Case& problem : corpus::read_directory(corpus::corpus_directory() / "cases").cases)
    compare(problem, count);
  std::printf("%d cases, %d of them with closed forms\n", count.cases, count.closed);
  EXPECT_GE(count.cases, 100);
  EXPECT_GE(count.closed, 60);
}

TEST(RoundOracles, AgreeOnTies) {
  Count count;
  const corpus::Family& ties = *corpus::find_family("round_ties");
  for (const double level : {-1.0, 0.0})
    for (std::uint64_t seed = 0; seed < 12; ++seed) compare(ties.generate(level, seed), count);
  EXPECT_GE(count.cases, 12);
  EXPECT_GE(count.closed, 3);
}

}  // namespace
}  // namespace graze::oracle
