#include "reports/drawing/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "corpus/format/xml_text.hpp"

namespace graze::draw {
namespace {

// Rounds to a tenth of a pixel, and drops "-0" and ".0".
std::string pixel(Real x) {
  std::string text = fmt::format("{:.1f}", static_cast<double>(x));
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text == "-0" ? "0" : text;
}

std::string points_text(const std::vector<Flat>& points) {
  std::string text, last;
  for (const Flat& p : points) {
    const std::string next = pixel(p[0]) + "," + pixel(p[1]);
    if (next == last) continue;
    text += (text.empty() ? "" : " ") + next;
    last = next;
  }
  return text;
}

std::string stroke_text(const Stroke& stroke) {
  std::string text = fmt::format(R"( stroke="{}" stroke-width="{}")", stroke.colour, stroke.width);
  if (!stroke.dashes.empty()) text += fmt::format(R"( stroke-dasharray="{}")", stroke.dashes);
  if (stroke.opacity < 1) text += fmt::format(R"( stroke-opacity="{}")", stroke.opacity);
  return text;
}

// Characters, not bytes, of UTF-8.
std::size_t length_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

}  // namespace

Real text_width(std::string_view text, double size) { return Real(0.56) * size * length_of(text); }

std::vector<std::string> wrapped(const std::string& text, Real width, double size) {
  std::vector<std::string> lines(1);
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    if (!lines.back().empty() && text_width(lines.back() + " " + word, size) > width) lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
    at = end + 1;
  }
  return lines;
}

std::string power_text(int exponent) {
  static constexpr std::string_view kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = "10";
  for (const char c : std::to_string(exponent)) {
    text += c == '-' ? std::string_view("⁻") : kDigits[static_cast<std::size_t>(c - '0')];
  }
  return text;
}

std::string plain_number(Real x) {
  const auto value = static_cast<double>(x);
  if (std::isnan(value)) return "unknown";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  const double magnitude = std::abs(value);
  if (magnitude >= 100 && magnitude < 1e4) return fmt::format("{:.0f}", value);
  if (magnitude == 0 || (magnitude >= 1e-3 && magnitude < 100)) return fmt::format("{:.2g}", value);
  const std::string text = fmt::format("{:.1e}", value);
  const std::size_t e = text.find('e');
  std::string digits = text.substr(0, e);
  if (digits.ends_with(".0")) digits.resize(digits.size() - 2);
  const std::string power = power_text(std::stoi(text.substr(e + 1)));
  return digits == "1" ? power : digits + "·" + power;
}

void Canvas::text(Real x, Real y, const std::string& words, double size, std::string_view colour, bool bold,
                  std::string_view anchor) {
  body_ += fmt::format(R"(<text x="{}" y="{}" font-size="{}" fill="{}")", pixel(x), pixel(y), size, colour);
  if (bold) body_ += R"( font-weight="bold")";
  if (anchor != "start") body_ += fmt::format(R"( text-anchor="{}")", anchor);
  body_ += ">" + corpus::xml_text(words) + "</text>\n";
}

void Canvas::label(Real x, Real y, const std::string& words, double size, std::string_view colour) {
  body_ += fmt::format(
      R"(<text x="{}" y="{}" font-size="{}" fill="{}" stroke="#fff" stroke-width="3" stroke-opacity="0.8" )"
      R"(stroke-linejoin="round" paint-order="stroke">{}</text>)"
      "\n",
      pixel(x), pixel(y), size, colour, corpus::xml_text(words));
}

void Canvas::polygon(const std::vector<Flat>& points, std::string_view fill, double fill_opacity,
                     const Stroke& stroke) {
  if (points.size() < 2) return;
  body_ += fmt::format(R"(<polygon points="{}" fill="{}" fill-opacity="{}" stroke-linejoin="round"{}/>)"
                       "\n",
                       points_text(points), fill, fill_opacity, stroke_text(stroke));
}

void Canvas::polyline(const std::vector<Flat>& points, const Stroke& stroke) {
  if (points.size() < 2) return;
  body_ += fmt::format(R"(<polyline points="{}" fill="none"{}/>)"
                       "\n",
                       points_text(points), stroke_text(stroke));
}

void Canvas::polylines(const std::vector<std::vector<Flat>>& lines, const Stroke& stroke) {
  std::string path;
  for (const std::vector<Flat>& line : lines) {
    if (line.size() >= 2) path += "M" + points_text(line);
  }
  if (path.empty()) return;
  body_ += fmt::format(R"(<path d="{}" fill="none"{}/>)"
                       "\n",
                       path, stroke_text(stroke));
}

void Canvas::circle(const Flat& middle, double radius, std::string_view fill, const Stroke& stroke) {
  body_ += fmt::format(R"(<circle cx="{}" cy="{}" r="{}" fill="{}"{}/>)"
                       "\n",
                       pixel(middle[0]), pixel(middle[1]), radius, fill, stroke_text(stroke));
}

void Canvas::arrow_head(const Flat& from, const Flat& tip, std::string_view colour) {
  constexpr Real kLength = 9, kHalfWidth = Real(3.5);
  const Flat way = tip - from;
  if (!(way.norm() > 0)) return;
  const Flat back = tip - kLength * way.normalized();
  const Flat side = kHalfWidth * Flat(-way[1], way[0]).normalized();
  body_ += fmt::format(R"(<polygon points="{}" fill="{}"/>)"
                       "\n",
                       points_text({tip, back + side, back - side}), colour);
}

void Canvas::rectangle(const Rectangle& r, std::string_view fill, const Stroke& stroke) {
  body_ += fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}" fill="{}"{}/>)"
                       "\n",
                       pixel(r.x), pixel(r.y), pixel(r.width), pixel(r.height), fill, stroke_text(stroke));
}

void Canvas::begin_clip(const Rectangle& r) {
  ++clips_;
  body_ += fmt::format(
      R"svg(<clipPath id="clip{0}"><rect x="{1}" y="{2}" width="{3}" height="{4}"/></clipPath><g clip-path="url(#clip{0})">)svg"
      "\n",
      clips_, pixel(r.x), pixel(r.y), pixel(r.width), pixel(r.height));
}

void Canvas::end_clip() { body_ += "</g>\n"; }

std::string Canvas::document(int width, int height, const std::string& title) const {
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}" )"
      R"(font-family="Helvetica, Arial, 'DejaVu Sans', sans-serif">)"
      "\n<title>{2}</title>\n{3}</svg>\n",
      width, height, corpus::xml_text(title), body_);
}

}  // namespace graze::draw
