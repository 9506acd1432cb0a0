#include "corpus/format/xml_text.hpp"

#include <gtest/gtest.h>

namespace graze::corpus {
namespace {

TEST(XmlText, NamesWhatMeansSomethingAndKeepsTheRest) {
  EXPECT_EQ(xml_text("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
  EXPECT_EQ(xml_text("two\nlines\tand κ"), "two\nlines\tand κ");
}

TEST(XmlText, WhatIsNoCharacterIsReplaced) {
  EXPECT_EQ(xml_text(std::string_view("a\0b\x1b", 4)),
            "a\xEF\xBF\xBD"
            "b\xEF\xBF\xBD");
  EXPECT_EQ(xml_text("\xC3"), "\xEF\xBF\xBD");       // begun and not ended
  EXPECT_EQ(xml_text("\xC3<"), "\xEF\xBF\xBD&lt;");  // what follows counts
  EXPECT_EQ(xml_text("\xFF ok"), "\xEF\xBF\xBD ok");
}

}  // namespace
}  // namespace graze::corpus
