// Core checks its own assumptions where GRAZE_ASSERTIONS is defined, and nowhere else, in one program too:
// without_assertions.cpp is compiled without, this file with them.
#include <gtest/gtest.h>

#include <graze/detail/numeric/rounding.hpp>
#include <graze/detail/search/robust/line_frame.hpp>
#include <graze/detail/search/robust/simplex.hpp>

#include "tests/core/without_assertions.hpp"

namespace graze {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(AssertionsDeathTest, ABrokenInvariantEndsTheProgramWithOneLine) {
  EXPECT_DEATH(detail::round_down<float>(kNan), "rounding[.]hpp:[0-9]+: graze relies on x == x");
  EXPECT_DEATH(detail::Frame<double>(Vec3<double>(0, 0, 0)),
               "line_frame[.]hpp:[0-9]+: graze relies on rest > 0");
  EXPECT_DEATH(detail::box_vertex(Vec3<double>(1, 1, 1), 8), "leaf[.]hpp:[0-9]+: graze relies on k < 8");
  EXPECT_DEATH(detail::hull_support(Hull<float>(), Vec3<float>(1, 0, 0)), "relies on hull.size.. > 0");
  const float flat[] = {0, 0, 0, 0, 0, 0, 0, 0}, line[] = {0, 1, 0, 1, 0, 1, 0, 1};
  EXPECT_DEATH(detail::DirectionMap(flat, line, line, 8), "relies on most.minCoeff.. >= ");
  detail::Simplex<double> simplex;
  EXPECT_DEATH(detail::closest_to_origin(simplex, Vec3<double>(0, 0, 0)),
               "simplex[.]hpp:[0-9]+: graze relies on");
  for (int k = 0; k < 4; ++k) simplex.add({});
  EXPECT_DEATH(simplex.add({}), "simplex[.]hpp:[0-9]+: graze relies on size >= 0 && size < 4");
}

TEST(Assertions, WhatHoldsIsLeftAlone) {
  EXPECT_EQ(detail::round_down<float>(0.1), std::nextafter(0.1f, 0.0f));
  EXPECT_EQ(detail::Frame<double>(Vec3<double>(0, 0, 2)).length, 2);
}

// Two settings in one program: each file has the setting that it was compiled with.
TEST(AssertionsDeathTest, AFileWithoutThemHasNone) {
  EXPECT_TRUE(std::isnan(round_down_without_assertions(kNan)));
  EXPECT_DEATH(detail::round_down<float>(kNan), "relies on");
}

}  // namespace
}  // namespace graze
