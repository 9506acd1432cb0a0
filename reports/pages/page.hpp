// The page that is looked at: one HTML file, the viewer within it, its data within it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace graze::show {

// True if the viewer was built into this program. Building it takes Node (docs/howto/show.md).
[[nodiscard]] bool has_viewer();

// The whole page. `data` is graze.page/1 (docs/reference/page-format.md), the content. Without the viewer the page
// holds the words `plain` and the still pictures of the scenes, and a note that the viewer is missing.
[[nodiscard]] std::string page_html(const std::string& title, const nlohmann::ordered_json& data,
                                    const std::string& plain);

}  // namespace graze::show
