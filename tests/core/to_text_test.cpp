// Every enumeration of graze says its words: to_text.
#include <gtest/gtest.h>

#include <graze/rotating_result.hpp>
#include <graze/swept_overlap.hpp>
#include <set>
#include <vector>

namespace graze {
namespace {

using Words = std::vector<std::string_view>;

// The texts of the enumerators 0, 1, ..., up to the first value that is not an enumerator.
template <class Enum>
Words words_of() {
  Words out;
  for (unsigned k = 0; k < 256 && !to_text(static_cast<Enum>(k)).empty(); ++k)
    out.push_back(to_text(static_cast<Enum>(k)));
  return out;
}

TEST(ToText, EnumeratorsHaveTheirNames) {
  EXPECT_EQ(words_of<Outcome>(),
            Words({"initially_overlapping", "hit", "miss", "not_converged", "invalid_input"}));
  EXPECT_EQ(words_of<Method>(), Words({"conservative_advancement", "gjk_ray_cast", "mpr_sweep",
                                       "exact_portal", "certified_portal"}));
  EXPECT_EQ(words_of<Tier>(), Words({"standard", "certified", "exact"}));
  EXPECT_EQ(words_of<StartPolicy>(), Words({"report", "pass_over"}));
  EXPECT_EQ(words_of<AxisFactor::Kind>(), Words({"given", "motion", "difference"}));
  EXPECT_EQ(words_of<AxisFrame>(), Words({"world", "a", "b"}));
  EXPECT_EQ(words_of<RotatingMethod>(), Words({"time_steps", "bounding_spheres", "conservative_advancement",
                                               "bilateral_advancement", "bilateral_published"}));
  EXPECT_EQ(words_of<SweptMethod>(), Words({"gjk", "mpr", "before_after"}));
  EXPECT_EQ(words_of<Effects>(), Words({"nothing", "static", "linear", "rotating"}));
}

TEST(ToText, RequestsNameAllThatTheyAskFor) {
  EXPECT_EQ(words_of<Request>(), Words({"verdict", "normal", "witnesses", "normal, witnesses", "proof",
                                        "normal, proof", "witnesses, proof", "everything"}));
  EXPECT_EQ(to_text(CastOptions<double>{}.request), "normal, witnesses");
}

// Reasons are sentences' parts: each another, and as many as there are enumerators.
template <class Enum>
std::size_t distinct() {
  const Words words = words_of<Enum>();
  return std::set<std::string_view>(words.begin(), words.end()).size();
}
TEST(ToText, EveryReasonHasWordsOfItsOwn) {
  EXPECT_EQ(distinct<Invalid>(), 16u);
  EXPECT_EQ(words_of<Invalid>().size(), 16u);
  EXPECT_EQ(to_text(Invalid::negative_extent), "a radius or a half extent below zero");
  EXPECT_EQ(distinct<PlanReason>(), std::size_t{kPlanReasons});
  EXPECT_EQ(words_of<PlanReason>().size(), std::size_t{kPlanReasons});
}

static_assert(to_text(Outcome::hit) == "hit", "known when it is compiled");

}  // namespace
}  // namespace graze
