#include "corpus/format/xml_text.hpp"

namespace graze::corpus {

std::string xml_text(std::string_view text) {
  constexpr std::string_view kNone = "\xEF\xBF\xBD";
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t length = c < 0x80                ? 1
                               : c >= 0xC2 && c < 0xE0 ? 2
                               : c >= 0xE0 && c < 0xF0 ? 3
                               : c >= 0xF0 && c < 0xF5 ? 4
                                                       : 0;
    bool is_whole = length > 0 && i + length <= text.size();
    for (std::size_t k = 1; is_whole && k < length; ++k)
      is_whole = (static_cast<unsigned char>(text[i + k]) & 0xC0U) == 0x80U;
    if (!is_whole) {
      out += kNone;
      ++i;
      continue;
    }
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        if (c < 0x20 && c != '\t' && c != '\n') {
          out += kNone;
        } else {
          out += text.substr(i, length);
        }
    }
    i += length;
  }
  return out;
}

}  // namespace graze::corpus
