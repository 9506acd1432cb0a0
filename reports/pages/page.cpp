#include "reports/pages/page.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "corpus/format/json_value.hpp"
#include "corpus/format/xml_text.hpp"
#include "reports/viewer/viewer_text.hpp"

namespace graze::show {
namespace {

// JSON within a script element: no "<" is left that could end it, or begin a comment.
std::string within_script(const nlohmann::ordered_json& data) {
  const std::string text = corpus::document_text(data);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

std::string replaced(const std::string& text, const std::string& mark, const std::string& by) {
  const std::size_t place = text.find(mark);
  if (place == std::string::npos) throw std::logic_error("the viewer has no " + mark);
  return text.substr(0, place) + by + text.substr(place + mark.size());
}

std::string plain_page(const std::string& title, const nlohmann::ordered_json& data,
                       const std::string& plain) {
  std::string pictures;
  if (data.contains("scenes")) {
    for (const auto& scene : data["scenes"]) {
      pictures += fmt::format("<h2>{}</h2>\n<p>{}</p>\n", corpus::xml_text(scene.value("id", "")),
                              corpus::xml_text(scene.value("result", "")));
      pictures += scene.value("still", "");
    }
  }
  return fmt::format(
      "<!doctype html>\n"
      "<html lang=\"en\">\n"
      "<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>{0}</title>\n"
      "<style>body{{font:16px/1.5 sans-serif;max-width:60rem;margin:1rem auto;padding:0 "
      "1rem}}pre{{overflow-x:auto;font-size:13px}}svg{{max-width:100%;height:auto}}</style>\n"
      "<h1>{0}</h1>\n"
      "<p>This graze was built without Node, so this page lacks the viewer: no figures to point at, no\n"
      "shapes to rotate. docs/howto/show.md says how to build it.</p>\n"
      "<pre>{1}</pre>\n"
      "{2}</html>\n",
      corpus::xml_text(title), corpus::xml_text(plain), pictures);
}

}  // namespace

bool has_viewer() { return *kViewerText != 0; }

std::string page_html(const std::string& title, const nlohmann::ordered_json& data,
                      const std::string& plain) {
  if (!has_viewer()) return plain_page(title, data, plain);
  const std::string page = replaced(kViewerText, "GRAZE_TITLE", corpus::xml_text(title));
  return replaced(page, "GRAZE_DATA", within_script(data));
}

}  // namespace graze::show
