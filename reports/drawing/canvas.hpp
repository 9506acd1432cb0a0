// Writes SVG text in pixels, x to the right, y down. The colours and sizes of all pictures are defined here.
#pragma once

#include <string>
#include <string_view>

#include "reports/drawing/geometry.hpp"

namespace graze::draw {

inline constexpr std::string_view kColourA = "#2f6db3", kColourB = "#d9702b", kInk = "#222", kPale = "#777",
                                  kContactColour = "#0a7d32", kWrongColour = "#c4162a",
                                  kPathColourA = "#12365e", kPathColourB = "#7a3608";

struct Rectangle {
  Real x = 0, y = 0, width = 0, height = 0;

  [[nodiscard]] bool meets(const Rectangle& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
           other.y < y + height;
  }
  [[nodiscard]] bool holds(const Rectangle& other) const {
    return other.x >= x && other.y >= y && other.x + other.width <= x + width &&
           other.y + other.height <= y + height;
  }
};

struct Stroke {
  std::string_view colour = kInk;
  double width = 1;
  std::string_view dashes = "";  // as in SVG, empty for solid
  double opacity = 1;
};

// An estimate of the width in a font of this size. No font is measured.
[[nodiscard]] Real text_width(std::string_view text, double size);
// Lines of at most `width` pixels, broken at spaces.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, Real width, double size);
// A number in plain notation: 3.2e-7 as 3.2·10⁻⁷, with two digits or more, as a decimal from 0.001 to 9999.
[[nodiscard]] std::string plain_number(Real x);
[[nodiscard]] std::string power_text(int exponent);  // 10⁻⁷

class Canvas {
 public:
  void text(Real x, Real y, const std::string& words, double size, std::string_view colour = kInk,
            bool bold = false, std::string_view anchor = "start");
  // On a pale ground, so that lines behind it do not cross it.
  void label(Real x, Real y, const std::string& words, double size, std::string_view colour);
  void polygon(const std::vector<Flat>& points, std::string_view fill, double fill_opacity,
               const Stroke& stroke);
  void polyline(const std::vector<Flat>& points, const Stroke& stroke);
  // All in one element.
  void polylines(const std::vector<std::vector<Flat>>& lines, const Stroke& stroke);
  void circle(const Flat& middle, double radius, std::string_view fill, const Stroke& stroke);
  // A head at `tip`, as an arrow from `from` has it.
  void arrow_head(const Flat& from, const Flat& tip, std::string_view colour);
  void rectangle(const Rectangle& r, std::string_view fill, const Stroke& stroke);
  // Clips the following elements to r, until end_clip.
  void begin_clip(const Rectangle& r);
  void end_clip();

  [[nodiscard]] std::string document(int width, int height, const std::string& title) const;

 private:
  std::string body_;
  int clips_ = 0;
};

}  // namespace graze::draw
