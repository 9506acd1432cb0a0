#include "reports/drawing/draw.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/drawing/panel.hpp"

namespace graze::draw {
namespace {

constexpr double kTitleText = 14, kText = 12;
constexpr Real kMargin = 10;

// Bounds in the view's plane, about a place.
class Bounds {
 public:
  void add(const Flat& p) {
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  }
  // The part of the bounds within `most` of the place. Its half widths are at least `least`.
  [[nodiscard]] Window window(Real most, Real least) const {
    const Flat edge(most, most);
    const Flat low = low_.cwiseMax(-edge), high = high_.cwiseMin(edge);
    const Flat half = ((high - low) / 2).cwiseMax(Flat(least, least));
    return {.middle = (low + high) / 2, .half_width = half[0], .half_height = half[1]};
  }

 private:
  Flat low_ = Flat::Constant(kUnbounded), high_ = Flat::Constant(-kUnbounded);
};

struct Detail {
  Real half;  // half the window's lesser side
  Vec about;  // its middle
  bool is_margin;
};

class Picture {
 public:
  Picture(const corpus::Case& problem, const DrawSettings& settings)
      : problem_(problem), settings_(settings), width_(settings.width), scene_(make_scene(problem)) {
    if (!scene_.drawable) return;
    view_ = make_view(scene_, settings.view);
    timing_ = make_timing(scene_);
  }

  std::string svg() {
    Canvas canvas;
    header(canvas);  // once to learn its height
    Real height = top_ + kMargin;
    if (scene_.drawable) height = frames();
    Canvas page;
    page.rectangle({0, 0, Real(width_), height}, "#fff", {.colour = "none"});
    header(page);
    if (scene_.drawable) panels(page);
    return page.document(width_, static_cast<int>(std::ceil(height)), problem_.id);
  }

 private:
  void header(Canvas& canvas) {
    top_ = kMargin + 14;
    canvas.text(kMargin, top_, problem_.id, kTitleText, kInk, true);
    const auto lines = [&](const std::string& words, std::string_view colour) {
      for (const std::string& line : wrapped(words, width_ - 2 * kMargin, kText)) {
        top_ += 17;
        canvas.text(kMargin, top_, line, kText, colour);
      }
    };
    std::string result = scene_.result;
    if (scene_.margin) result += fmt::format("; {}: {}", scene_.margin_name, plain_number(*scene_.margin));
    lines(result, kInk);
    for (const DrawClaim& claim : settings_.claims) lines(claim.words, claim.is_wrong ? kWrongColour : kInk);
    if (!problem_.comment.empty()) lines(problem_.comment, kPale);
    top_ += 10;
  }

  // The scene as a whole: the bodies where they meet, and the path to it, up to four bodies' sizes.
  [[nodiscard]] Window whole() const {
    constexpr Real kSizes = 4, kRoom = Real(1.12);
    const Real size = std::max(scene_.diagonal_a, scene_.diagonal_b);
    const Real apart = (scene_.touching_b - scene_.touching_a).norm();
    const Real most = size > 0 ? std::max(kSizes * size, apart / 2 + size) : kUnbounded;
    Bounds bounds;
    const auto add_body = [&](const Shape<double>& shape, const Pose& pose) {
      for (const Vec& n : {view_.right, view_.up}) {
        for (const Real sign : {Real(1), Real(-1)}) {
          const Vec local = support_point(shape, pose.rotation.transpose() * Vec(sign * n));
          bounds.add(view_.project(pose.position + pose.rotation * local));
        }
      }
    };
    std::vector<Real> times = timing_.ghosts;
    times.insert(times.end(), {scene_.moment, 0});
    for (const Real t : times) {
      add_body(problem_.a.shape, scene_.pose_a(t, scene_.focus));
      add_body(problem_.b.shape, scene_.pose_b(t, scene_.focus));
    }
    const Real least = size > 0 ? size / 20 : scene_.scale > 0 ? scene_.scale / 20 : Real(1);
    Window window = bounds.window(most, least);
    window.half_width *= kRoom;
    window.half_height *= kRoom;
    return window;
  }

  // Details that a picture of `half` would not show: a small body, its thickness, the margin. From large to
  // small.
  [[nodiscard]] std::vector<Detail> details(Real half) const {
    constexpr Real kUnseen = 25, kApart = 8;
    const Real rounding = std::numeric_limits<double>::epsilon() * scene_.scale;
    std::vector<Detail> wanted;
    const auto want = [&](Real length, Real room, const Vec& about, bool is_margin) {
      if (length > 0 && half > kUnseen * length && room * length > rounding)
        wanted.push_back({room * length, about, is_margin});
    };
    for (const bool is_b : {false, true}) {
      const Shape<double>& shape = (is_b ? problem_.b : problem_.a).shape;
      const Pose pose =
          is_b ? scene_.pose_b(scene_.moment, scene_.focus) : scene_.pose_a(scene_.moment, scene_.focus);
      const Vec& about = is_b ? scene_.touching_b : scene_.touching_a;
      want(is_b ? scene_.diagonal_b : scene_.diagonal_a, 2, about, false);
      want(height(shape, pose, view_.up) + height(shape, pose, Vec(-view_.up)), 3, about, false);
    }
    for (const DrawClaim& claim : settings_.claims) {
      if (claim.is_wrong && claim.time)
        want(std::abs(Real(*claim.time) - scene_.moment) * scene_.speed, 3, scene_.focus, true);
    }
    if (scene_.margin) want(*scene_.margin, 3, scene_.focus, true);
    if (settings_.is_for_others && wanted.empty()) wanted.push_back({half / 12, scene_.focus, true});
    std::sort(wanted.begin(), wanted.end(), [](const Detail& l, const Detail& r) { return l.half > r.half; });
    std::vector<Detail> chosen;
    for (const Detail& detail : wanted) {
      const bool is_alike = !chosen.empty() && chosen.back().half < kApart * detail.half &&
                            (chosen.back().about - detail.about).norm() < chosen.back().half;
      if (!is_alike) {
        chosen.push_back(detail);
      } else if (detail.is_margin) {
        chosen.back() = detail;
      }
    }
    // Two at most: the first, and the smallest.
    if (chosen.size() > 2) chosen.erase(chosen.begin() + 1, chosen.end() - 1);
    return chosen;
  }

  // Places the frames, and returns the picture's height.
  Real frames() {
    Window window = whole();
    details_ = details(std::max(window.half_width, window.half_height));
    const Real inside = width_ - 2 * kMargin;
    const Real detail_width = details_.empty() ? 0 : Real(0.36) * inside;
    const Real main_width = inside - (details_.empty() ? 0 : detail_width + kMargin);
    const Real least = details_.size() == 2   ? Real(0.62) * inside
                       : details_.size() == 1 ? Real(0.36) * inside
                                              : Real(0.25) * inside;
    const Real wanted = main_width * window.half_height / window.half_width;
    const Real main_height = std::clamp(wanted, least, std::max(least, Real(0.55) * inside));
    main_frame_ = {kMargin, top_, main_width, main_height};
    // The window takes the frame's form.
    if (window.half_width / window.half_height < main_width / main_height) {
      window.half_width = window.half_height * main_width / main_height;
    } else {
      window.half_height = window.half_width * main_height / main_width;
    }
    window_ = window;
    const auto count = static_cast<Real>(details_.size());
    for (std::size_t k = 0; k < details_.size(); ++k) {
      const Real height = (main_height - (count - 1) * kMargin) / count;
      detail_frames_.push_back(
          {kMargin * 2 + main_width, top_ + static_cast<Real>(k) * (height + kMargin), detail_width, height});
    }
    return top_ + main_height + kMargin;
  }

  void panels(Canvas& page) {
    Panel main(scene_, view_, timing_, main_frame_, scene_.focus, window_);
    main.set_claims(settings_.claims);
    main.draw(page, "", false);
    if (settings_.is_for_others) main.draw_axes(page);
    for (std::size_t k = 0; k < details_.size(); ++k) {
      const Rectangle& frame = detail_frames_[k];
      const Flat place = main.to_pixels(view_.project(details_[k].about - scene_.focus));
      // Magnified by a power of ten, against the main frame.
      const Real wanted = std::min(frame.width, frame.height) / (2 * details_[k].half) / main.scale();
      const int power = std::max(1, static_cast<int>(std::floor(std::log10(wanted) + Real(0.35))));
      const Real scale = main.scale() * std::pow(Real(10), power);
      const Window window{.middle = Flat::Zero(),
                          .half_width = frame.width / (2 * scale),
                          .half_height = frame.height / (2 * scale)};
      page.circle(place, 9 - 3 * static_cast<double>(k), "none", {.colour = kPale, .width = 0.8});
      page.polyline({place + Flat(9, 0), Flat(frame.x, frame.y + frame.height / 2)},
                    {.colour = kPale, .width = 0.7, .dashes = "2 3"});
      Panel detail(scene_, view_, timing_, frame, details_[k].about, window);
      detail.set_claims(settings_.claims);
      detail.draw(page, "× " + (power == 1 ? std::string("10") : power_text(power)), true);
    }
  }

  const corpus::Case& problem_;
  const DrawSettings& settings_;
  int width_;
  Scene scene_;
  View view_;
  Timing timing_;
  Real top_ = 0;
  Window window_;
  Rectangle main_frame_;
  std::vector<Detail> details_;
  std::vector<Rectangle> detail_frames_;
};

}  // namespace

std::string draw_svg(const corpus::Case& problem, const DrawSettings& settings) {
  return Picture(problem, settings).svg();
}

}  // namespace graze::draw
