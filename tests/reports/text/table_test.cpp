#include "reports/text/table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace graze::tool {
namespace {

TEST(Table, WordsStandLeftNumbersRightAndHeadersOnTheirRows) {
  Table table({{"name", Align::left}, {"two\nlines"}});
  table.add_row({"a", "1"});
  table.add_gap();
  table.add_row({"longer", "123456"});
  EXPECT_EQ(table.text(),
            "           two\n"
            "name     lines\n"
            "------  ------\n"
            "a            1\n"
            "\n"
            "longer  123456\n");
}

TEST(ShortNumber, TellsZeroInfinityAndAbsenceApart) {
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(short_number(INFINITY), "inf");
  EXPECT_EQ(short_number(std::nan("")), "-");
  EXPECT_EQ(short_number(3.21e-16), "3.2e-16");
}

}  // namespace
}  // namespace graze::tool
