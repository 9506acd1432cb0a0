// Text within XML 1.0 and within HTML, also within quotes: pages, pictures, reports for other programs.
#pragma once

#include <string>
#include <string_view>

namespace graze::corpus {

// The four characters that mean something there are named. Bytes that are no character of XML, other than a line's end
// and a tab, become U+FFFD, whatever a shape's or a family's name was made of.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace graze::corpus
