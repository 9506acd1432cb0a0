// A price list, graze.price/1, as a page to look at: work-precision diagrams, growth, what each request adds, and the
// cases behind the points.
#pragma once

#include <string>
#include <string_view>

#include "reports/pages/page_scene.hpp"

namespace graze::show {

struct PricePageSettings {
  std::string command = {};      // command that made the list, empty for none
  std::string plain = {};        // the same in words, for a page without the viewer
  std::size_t most_scenes = 40;  // cases that can be looked at
};

// The whole page. Throws std::runtime_error that says which field of the document is wrong.
[[nodiscard]] std::string price_page(const Json& document, const PricePageSettings& settings = {});

// Parses the document. Throws std::runtime_error if the text is not JSON.
[[nodiscard]] Json read_price(std::string_view text);

}  // namespace graze::show
