// Decimals mean the nearest double, and what is written reads back to the same bits, shortest first.
#include <gtest/gtest.h>
#include <graze_adapter.hpp>

#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>

namespace graze::adapter {
namespace {

std::string written(double value) {
  std::string out;
  number::write(out, value);
  return out;
}

std::uint64_t bits_of(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

void expect_round_trip(double value) {
  const std::string text = written(value);
  EXPECT_EQ(bits_of(json::read(text).number), bits_of(value)) << text;
}

TEST(Number, EveryKindOfDoubleComesBack) {
  using Limits = std::numeric_limits<double>;
  for (const double x :
       {0.0, -0.0, 1.0, 0.1, 1.0 / 3, 1e23, 5e-324, 2.2250738585072011e-308, 9007199254740993.0,
        Limits::min(), Limits::denorm_min(), Limits::max(), Limits::lowest(), Limits::epsilon()}) {
    expect_round_trip(x);
  }
  std::mt19937_64 random(18);
  int finite = 0;
  for (int i = 0; i < 100000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    expect_round_trip(value);
    ++finite;
  }
  EXPECT_GT(finite, 90000);
}

TEST(Number, FloatsComeBackAsFloats) {
  std::mt19937 random(18);
  for (int i = 0; i < 100000; ++i) {
    const auto bits = static_cast<std::uint32_t>(random());
    float value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    const double read = json::read(written(double(value))).number;
    EXPECT_EQ(double(float(read)), read);
    EXPECT_EQ(float(read), value);
  }
}

TEST(Number, ShortestIsWritten) {
  EXPECT_EQ(written(0.1), "0.1");
  EXPECT_EQ(written(2), "2");
  EXPECT_EQ(written(-0.5), "-0.5");
  EXPECT_EQ(written(1e300), "1e+300");
}

TEST(Number, WhatIsNoneIsAString) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(written(std::numeric_limits<double>::quiet_NaN()), "\"nan\"");
  EXPECT_EQ(written(infinity), "\"inf\"");
  EXPECT_EQ(written(-infinity), "\"-inf\"");
}

TEST(Number, HalfwayDecimalsAreRoundedToNearestEven) {
  EXPECT_EQ(json::read("9007199254740993").number, 9007199254740992.0);
  EXPECT_EQ(json::read("9007199254740995").number, 9007199254740996.0);
  EXPECT_EQ(json::read("9007199254740993." + std::string(700, '0') + "1").number, 9007199254740994.0);
  EXPECT_EQ(json::read("1.7976931348623157e308").number, std::numeric_limits<double>::max());
}

TEST(Number, UnderflowIsTheNearestDoubleAndOverflowIsRefused) {
  EXPECT_EQ(json::read("1e-400").number, 0.0);
  EXPECT_EQ(json::read("3e-324").number, 5e-324);
  EXPECT_TRUE(std::signbit(json::read("-1e-99999").number));
  EXPECT_EQ(json::read("0." + std::string(400, '0') + "1").number, 0.0);
  EXPECT_THROW(json::read("1e309"), BadLine);
  EXPECT_THROW(json::read("1" + std::string(400, '0')), BadLine);
  EXPECT_EQ(json::read("1" + std::string(400, '0') + "e-400").number, 1.0);
}

TEST(Number, TheLocaleDoesNotMatter) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  // Not every machine has a locale with a comma. If there is no such locale, the plain one is tried again.
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"}) {
    if (std::setlocale(LC_NUMERIC, name) == nullptr) continue;
    expect_round_trip(0.1);
    EXPECT_EQ(number::by_strtod("2.5e-1"), 0.25);
  }
  std::setlocale(LC_NUMERIC, before.c_str());
}

}  // namespace
}  // namespace graze::adapter
