// One frame of a picture: a part of the scene, at one magnification.
#pragma once

#include <span>
#include <vector>

#include "reports/drawing/canvas.hpp"
#include "reports/drawing/draw.hpp"
#include "reports/drawing/drawn_scene.hpp"

namespace graze::draw {

// The times of the drawn poses, in addition to the start and the moment, and the times of the path.
struct Timing {
  std::vector<Real> ghosts;
  std::vector<Real> path;  // enough of them to be joined by lines
};
[[nodiscard]] Timing make_timing(const Scene& scene);

class Panel {
 public:
  // `about`: the place, from the scene's origin, that the window's coordinates are measured from.
  Panel(const Scene& scene, const View& view, const Timing& timing, const Rectangle& frame, const Vec& about,
        const Window& window)
      : scene_(scene),
        view_(view),
        timing_(timing),
        frame_(frame),
        about_(about),
        window_(window),
        scale_(frame.width / (2 * window.half_width)) {}

  // The wrong ones with a time are drawn, dashed.
  void set_claims(std::span<const DrawClaim> claims) { claims_ = claims; }
  // The world's axes, in the lower right corner, and the viewing direction.
  void draw_axes(Canvas& canvas);

  // Pixels of one unit of length.
  [[nodiscard]] Real scale() const { return scale_; }
  [[nodiscard]] Flat to_pixels(const Flat& p) const;

  // Draws the bodies, the path and the contact, with `note` in the upper left corner.
  void draw(Canvas& canvas, const std::string& note, bool is_detail);

 private:
  enum class Style { ghost, start, moment };
  void claims(Canvas& canvas, bool is_detail);

  [[nodiscard]] Window clipping() const;
  [[nodiscard]] std::vector<Flat> pixel_outline(const Shape<double>& shape, const Pose& pose) const;
  void body(Canvas& canvas, bool is_b, Real t, Style style);
  void listed_vertices(Canvas& canvas, const Shape<double>& shape, const Pose& pose, std::string_view colour);
  void target(Canvas& canvas);
  void path(Canvas& canvas, bool is_b);
  void contact(Canvas& canvas, bool is_detail);
  void margin(Canvas& canvas);
  void labels(Canvas& canvas);
  void scale_bar(Canvas& canvas);
  enum class Side { above, below, right };
  // Puts the words where they have room by the box, within it or beside it, on side `first` first. Their area
  // is marked as occupied.
  void place(Canvas& canvas, const Rectangle& box, const std::string& words, std::string_view colour,
             Side first);

  const Scene& scene_;
  const View& view_;
  const Timing& timing_;
  Rectangle frame_;
  Vec about_;
  Window window_;
  Real scale_;
  std::span<const DrawClaim> claims_;
  std::vector<Rectangle> taken_;
  struct Seen {
    bool is_b;
    Real t;
    Rectangle box;
  };
  std::vector<Seen> seen_;
};

}  // namespace graze::draw
