#include "reports/drawing/panel.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace graze::draw {
namespace {

constexpr double kSmallText = 11;

Rectangle box_of(const std::vector<Flat>& points) {
  Flat low = points[0], high = points[0];
  for (const Flat& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {low[0], low[1], high[0] - low[0], high[1] - low[1]};
}

bool moves(const Body<double>& body, const corpus::Spin& spin) {
  return body.displacement != Vec3<double>::Zero() || spin.rotation != Vec3<double>::Zero();
}

std::string time_text(Real t) { return t == 0 ? "t = 0" : "t = " + plain_number(t); }

}  // namespace

// The times of drawn poses. Translations have as many as fit. Rotations have one per sixth of a turn, over
// one turn at most.
Timing make_timing(const Scene& scene) {
  constexpr Real kTurnShown = Real(3.2);  // radians before and after the moment
  Timing timing;
  const Real moment = scene.moment, end = scene.end;
  Real from = 0, until = end;
  if (scene.turn_rate > 0) {
    from = std::max(Real(0), moment - kTurnShown / scene.turn_rate);
    until = std::min(end, moment + kTurnShown / scene.turn_rate);
  }
  const Real size = scene.diagonal_b > 0 ? scene.diagonal_b : std::max(scene.diagonal_a, scene.scale / 4);
  const auto ghosts_over = [&](Real length_of_time) {
    const Real turned = scene.turn_rate * length_of_time, passed = scene.speed * length_of_time;
    const Real wanted = std::max(turned / Real(0.45), passed / (Real(0.9) * size));
    return static_cast<int>(std::clamp<Real>(wanted, 0, scene.turns ? 7 : 3));
  };
  const int before = ghosts_over(moment - from), after = ghosts_over(until - moment);
  for (int k = 1; k <= before; ++k) timing.ghosts.push_back(from + (moment - from) * k / (before + 1));
  for (int k = 1; k <= after; ++k) timing.ghosts.push_back(moment + (until - moment) * k / after);
  const int parts = scene.turn_rate > 0 ? 96 : 1;
  for (int k = 0; k < parts; ++k) timing.path.push_back(from + (moment - from) * k / parts);
  timing.path.push_back(moment);
  if (until > moment) {
    for (int k = 1; k <= parts; ++k) timing.path.push_back(moment + (until - moment) * k / parts);
  }
  return timing;
}

Flat Panel::to_pixels(const Flat& p) const {
  return {frame_.x + frame_.width / 2 + (p[0] - window_.middle[0]) * scale_,
          frame_.y + frame_.height / 2 - (p[1] - window_.middle[1]) * scale_};
}

// A little more than the window, so that the line along the cut stays outside.
Window Panel::clipping() const {
  constexpr Real kPixels = 6;
  Window out = window_;
  out.half_width += kPixels / scale_;
  out.half_height += kPixels / scale_;
  return out;
}

std::vector<Flat> Panel::pixel_outline(const Shape<double>& shape, const Pose& pose) const {
  constexpr Real kPixels = Real(0.15);
  const Window window = clipping();
  std::vector<Flat> points = clip_polygon(outline(shape, pose, view_, window, kPixels / scale_), window);
  for (Flat& p : points) p = to_pixels(p);
  return points;
}

void Panel::body(Canvas& canvas, bool is_b, Real t, Style style) {
  constexpr Real kDot = 3;  // anything smaller is drawn as a dot
  const Shape<double>& shape = (is_b ? scene_.problem->b : scene_.problem->a).shape;
  const Pose pose = is_b ? scene_.pose_b(t, about_) : scene_.pose_a(t, about_);
  const std::string_view colour = is_b ? kColourB : kColourA;
  const double fill = style == Style::ghost ? 0.08 : style == Style::start ? 0.22 : 0.45;
  const double line = style == Style::ghost ? 0.35 : style == Style::start ? 0.7 : 1;
  const std::vector<Flat> points = pixel_outline(shape, pose);
  if (points.empty()) return;
  const Rectangle box = box_of(points);
  if (box.width < kDot && box.height < kDot) {
    const Flat middle(box.x + box.width / 2, box.y + box.height / 2);
    canvas.circle(middle, style == Style::ghost ? 2 : 3, colour, {.colour = colour, .opacity = line});
  } else {
    canvas.polygon(points, colour, fill,
                   {.colour = colour, .width = style == Style::moment ? 1.6 : 1, .opacity = line});
    if (style != Style::ghost) {
      std::vector<std::vector<Flat>> lines;
      const Window window = clipping();
      for (const std::vector<Flat>& edge : visible_edges(shape, pose, view_)) {
        for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
          const auto part = clip_segment(edge[i], edge[i + 1], window);
          if (!part) continue;
          const Flat from = to_pixels(part->first), to = to_pixels(part->second);
          const bool joins = !lines.empty() && i > 0 && lines.back().back() == from;
          if (joins) {
            lines.back().push_back(to);
          } else {
            lines.push_back({from, to});
          }
        }
      }
      canvas.polylines(lines, {.colour = colour, .width = 0.7, .opacity = line * 0.7});
      if (style == Style::moment) listed_vertices(canvas, shape, pose, colour);
    }
  }
  if (style != Style::ghost) seen_.push_back({is_b, t, box});
}

// Draws the bodies at the times of wrong answers.
void Panel::claims(Canvas& canvas, bool is_detail) {
  const corpus::Case& problem = *scene_.problem;
  for (const DrawClaim& claim : claims_) {
    if (!claim.is_wrong || !claim.time) continue;
    for (const bool is_b : {false, true}) {
      if (!(is_b ? moves(problem.b, problem.spin_b) : moves(problem.a, problem.spin_a))) continue;
      const Pose pose = is_b ? scene_.pose_b(*claim.time, about_) : scene_.pose_a(*claim.time, about_);
      const std::vector<Flat> points = pixel_outline((is_b ? problem.b : problem.a).shape, pose);
      if (points.empty()) continue;
      canvas.polygon(points, "none", 0, {.colour = kWrongColour, .width = 1.6, .dashes = "5 3"});
      if (is_detail) continue;  // it is named in the picture of the whole
      place(canvas, box_of(points), std::string(is_b ? "B" : "A") + " as claimed", kWrongColour, Side::above);
    }
  }
}

void Panel::draw_axes(Canvas& canvas) {
  constexpr Real kLength = 24, kLeast = Real(0.15);
  const Flat middle(frame_.x + frame_.width - 44, frame_.y + frame_.height - 44);
  for (int i = 0; i < 3; ++i) {
    const Flat d = view_.project(Vec::Unit(i));
    if (!(d.norm() > kLeast)) continue;
    const Flat tip = middle + kLength * Flat(d[0], -d[1]);
    const Flat beyond = middle + (kLength + 9) * Flat(d[0], -d[1]);
    canvas.polyline({middle, tip}, {.colour = kPale, .width = 1.2});
    canvas.arrow_head(middle, tip, kPale);
    canvas.text(beyond[0], beyond[1] + 4, std::string(1, "xyz"[i]), kSmallText, kPale, false, "middle");
  }
  const auto part = [&](int i) { return static_cast<double>(view_.towards[i]); };
  const std::string words = fmt::format("seen from ({:.2f}, {:.2f}, {:.2f})", part(0), part(1), part(2));
  canvas.label(frame_.x + frame_.width - text_width(words, kSmallText) - 8, frame_.y + 14, words, kSmallText,
               kPale);
}

// Draws a hull's listed vertices. A vertex that is not a corner is still part of the case.
void Panel::listed_vertices(Canvas& canvas, const Shape<double>& shape, const Pose& pose,
                            std::string_view colour) {
  constexpr std::size_t kMost = 96;
  const auto* hull = std::get_if<Hull<double>>(&shape);
  if (hull == nullptr || hull->size() > kMost) return;
  for (const Vec3<double>& vertex : hull->vertices()) {
    const std::vector<Flat> point = {view_.project(pose.position + pose.rotation * vertex.cast<Real>())};
    if (!clip_polygon(point, window_).empty())
      canvas.circle(to_pixels(point[0]), 1.4, colour, {.colour = "none"});
  }
}

// Draws the surface at the target distance from A.
void Panel::target(Canvas& canvas) {
  if (!(scene_.problem->target_distance > 0)) return;
  const Shape<double> wider = rounded(scene_.problem->a.shape, scene_.problem->target_distance);
  canvas.polygon(pixel_outline(wider, scene_.pose_a(scene_.moment, about_)), "none", 0,
                 {.colour = kColourA, .width = 1, .dashes = "5 3"});
}

// Draws the path of the point of a body that touches, or comes nearest.
void Panel::path(Canvas& canvas, bool is_b) {
  const auto pose_at_time = [&](Real t) {
    return is_b ? scene_.pose_b(t, about_) : scene_.pose_a(t, about_);
  };
  const Pose then = pose_at_time(scene_.moment);
  const Vec touching = (is_b ? scene_.touching_b : scene_.touching_a) - about_;
  const Vec on_body = then.rotation.transpose() * (touching - then.position);
  const Window window = clipping();
  std::vector<std::vector<Flat>> parts;
  for (std::size_t i = 0; i + 1 < timing_.path.size(); ++i) {
    const auto at = [&](Real t) {
      const Pose pose = pose_at_time(t);
      return view_.project(pose.position + pose.rotation * on_body);
    };
    const auto part = clip_segment(at(timing_.path[i]), at(timing_.path[i + 1]), window);
    if (!part) continue;
    const Flat from = to_pixels(part->first), to = to_pixels(part->second);
    if (!parts.empty() && (parts.back().back() - from).norm() < Real(0.01)) {
      parts.back().push_back(to);
    } else {
      parts.push_back({from, to});
    }
  }
  if (parts.empty()) return;
  const std::string_view colour = is_b ? kPathColourB : kPathColourA;
  canvas.polylines(parts, {.colour = colour, .width = 1.3});
  const std::vector<Flat>& last = parts.back();
  const Flat from = last[last.size() - 2], tip = last.back();
  if (last.size() > 2 || (tip - from).norm() > 12) canvas.arrow_head(from, tip, colour);
}

void Panel::contact(Canvas& canvas, bool is_detail) {
  constexpr Real kArrow = 42;
  const Flat spot = to_pixels(view_.project(scene_.focus - about_));
  if (!scene_.has_contact) return;
  canvas.circle(spot, is_detail ? 3.5 : 3, kContactColour, {.colour = "#fff", .width = 0.8});
  taken_.push_back({spot[0] - 6, spot[1] - 6, 12, 12});
  const Flat n = view_.project(scene_.normal);
  if (!(n.norm() > Real(0.2))) return;
  const Flat tip = spot + kArrow * Flat(n[0], -n[1]);
  canvas.polyline({spot, tip}, {.colour = kContactColour, .width = 1.6});
  canvas.arrow_head(spot, tip, kContactColour);
  place(canvas, {tip[0] - 5, tip[1] - 5, 10, 10}, "n", kContactColour, Side::above);
}

// A clearance: what is between the two, with a bar at either end.
void Panel::margin(Canvas& canvas) {
  constexpr Real kBar = 6;
  if (!scene_.margin || scene_.has_contact) return;
  const Flat n = view_.project(scene_.normal);
  const Flat along(n[0], -n[1]), across(n[1], n[0]);
  const Real half = *scene_.margin * scale_ / 2;
  if (half < 5 || half > frame_.height / 2 || n.norm() < Real(0.5)) return;
  const Flat spot = to_pixels(view_.project(scene_.focus - about_));
  const Flat low = spot - half * along, high = spot + half * along;
  canvas.polylines(
      {{low, high}, {low - kBar * across, low + kBar * across}, {high - kBar * across, high + kBar * across}},
      {.colour = kContactColour, .width = 1.6});
  place(canvas, {spot[0] - kBar, std::min(low[1], high[1]), 2 * kBar, 2 * half}, plain_number(*scene_.margin),
        kContactColour, Side::right);
}

void Panel::place(Canvas& canvas, const Rectangle& box, const std::string& words, std::string_view colour,
                  Side first) {
  constexpr Real kGap = 3, kHeight = 13;
  const Real width = text_width(words, kSmallText) + 2;
  const Real left = std::max(box.x, frame_.x), right = std::min(box.x + box.width, frame_.x + frame_.width);
  const Real top = std::max(box.y, frame_.y), bottom = std::min(box.y + box.height, frame_.y + frame_.height);
  const Real middle_x = (left + right) / 2 - width / 2, middle_y = (top + bottom) / 2 - kHeight / 2;
  std::vector<Flat> corners;
  if (right - left > width + 8 && bottom - top > kHeight + 8) {
    for (const Real up : {Real(0), Real(0.25), Real(-0.25), Real(0.38), Real(-0.38)}) {
      for (const Real aside : {Real(0), Real(0.25), Real(-0.25)})
        corners.push_back({middle_x + aside * (right - left), middle_y - up * (bottom - top)});
    }
  }
  const Flat above(middle_x, top - kHeight - kGap), below(middle_x, bottom + kGap),
      beside(right + kGap, middle_y);
  corners.push_back(first == Side::above ? above : first == Side::below ? below : beside);
  corners.insert(corners.end(), {above,
                                 beside,
                                 {left - width - kGap, middle_y},
                                 below,
                                 {right + kGap, top - kHeight - kGap},
                                 {left - width - kGap, bottom + kGap}});
  for (const Flat& corner : corners) {
    const Rectangle words_box{corner[0], corner[1], width, kHeight};
    const bool is_free = std::none_of(taken_.begin(), taken_.end(),
                                      [&](const Rectangle& other) { return other.meets(words_box); });
    if (!is_free || !frame_.holds(words_box)) continue;
    taken_.push_back(words_box);
    canvas.label(corner[0] + 1, corner[1] + kHeight - 3, words, kSmallText, colour);
    return;
  }
}

void Panel::labels(Canvas& canvas) {
  // The last thing drawn is on top, and it is named first.
  for (auto seen = seen_.rbegin(); seen != seen_.rend(); ++seen) {
    // A body that ends as it began, or nearly, is named once.
    const auto covers = [&](const Seen& other) {
      constexpr Real kSame = 4;
      return other.is_b == seen->is_b && other.t > seen->t && std::abs(other.box.x - seen->box.x) < kSame &&
             std::abs(other.box.y - seen->box.y) < kSame &&
             std::abs(other.box.width - seen->box.width) < kSame &&
             std::abs(other.box.height - seen->box.height) < kSame;
    };
    if (std::any_of(seen_.begin(), seen_.end(), covers)) continue;
    const bool still = !moves(seen->is_b ? scene_.problem->b : scene_.problem->a,
                              seen->is_b ? scene_.problem->spin_b : scene_.problem->spin_a);
    const std::string name = seen->is_b ? "B" : "A";
    place(canvas, seen->box, still ? name : name + ", " + time_text(seen->t),
          seen->is_b ? kColourB : kColourA, seen->is_b ? Side::above : Side::below);
  }
}

// The longest of 1, 2, 5 times a power of ten that takes a third of the frame at most.
void Panel::scale_bar(Canvas& canvas) {
  const Real most = std::min(frame_.width / 3, Real(120)) / scale_;
  const auto power = static_cast<int>(std::floor(std::log10(most)));
  const Real unit = std::pow(Real(10), power);
  const int times = most >= 5 * unit ? 5 : most >= 2 * unit ? 2 : 1;
  const Real x = frame_.x + 10, y = frame_.y + frame_.height - 10, length = times * unit * scale_;
  canvas.polylines(
      {{{x, y - 4}, {x, y + 2}}, {{x, y}, {x + length, y}}, {{x + length, y - 4}, {x + length, y + 2}}},
      {.colour = kInk, .width = 1.2});
  canvas.label(x + 3, y - 6, plain_number(times * unit), kSmallText, kInk);
}

void Panel::draw(Canvas& canvas, const std::string& note, bool is_detail) {
  const corpus::Case& problem = *scene_.problem;
  const bool a_moves = moves(problem.a, problem.spin_a), b_moves = moves(problem.b, problem.spin_b);
  canvas.rectangle(frame_, "#fcfcfc", {.colour = "#bbb"});
  taken_.push_back({frame_.x, frame_.y + frame_.height - 30, std::min(frame_.width / 3, Real(120)) + 24, 30});
  taken_.push_back(
      {frame_.x, frame_.y, text_width(note, kSmallText) + 10, note.empty() ? Real(0) : Real(20)});
  canvas.begin_clip(frame_);
  for (const Real t : timing_.ghosts) {
    if (a_moves) body(canvas, false, t, Style::ghost);
    if (b_moves) body(canvas, true, t, Style::ghost);
  }
  if (scene_.moment > 0) {
    if (a_moves) body(canvas, false, 0, Style::start);
    if (b_moves) body(canvas, true, 0, Style::start);
  }
  body(canvas, false, scene_.moment, Style::moment);
  body(canvas, true, scene_.moment, Style::moment);
  claims(canvas, is_detail);
  target(canvas);
  if (a_moves) path(canvas, false);
  if (b_moves) path(canvas, true);
  margin(canvas);
  contact(canvas, is_detail);
  labels(canvas);
  scale_bar(canvas);
  canvas.end_clip();
  if (!note.empty()) canvas.label(frame_.x + 6, frame_.y + 14, note, kSmallText, kInk);
}

}  // namespace graze::draw
