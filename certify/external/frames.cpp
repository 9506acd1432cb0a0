#include "certify/external/frames.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <variant>

#include "engines/adapter/host_frames.hpp"

namespace graze::external {

namespace frames = adapter::frames;
using corpus::Case;

namespace {

static_assert(static_cast<int>(Question::cast) == GRAZE_ENGINE_CAST);
static_assert(static_cast<int>(Question::ray) == GRAZE_ENGINE_RAY);
static_assert(static_cast<int>(Question::penetration) == GRAZE_ENGINE_PENETRATION);

template <class Pod>
void append(std::string& out, const Pod& pod) {
  static_assert(std::is_trivially_copyable_v<Pod>);
  out.append(reinterpret_cast<const char*>(&pod), sizeof pod);
}

void put(double (&out)[3], const Vec3<double>& x) { std::copy(x.data(), x.data() + 3, out); }
void put(double (&out)[4], const Quaternion<double>& q) {
  out[0] = q.w;
  out[1] = q.x;
  out[2] = q.y;
  out[3] = q.z;
}

void write_shape(std::string& out, const Shape<double>& shape);

struct ShapeFrame {
  std::string& out;

  void operator()(const Point<double>&) const { append(out, head(GRAZE_ENGINE_POINT)); }
  void operator()(const Segment<double>& s) const { vertices(GRAZE_ENGINE_SEGMENT, {s.a, s.b}); }
  void operator()(const Triangle<double>& t) const { vertices(GRAZE_ENGINE_TRIANGLE, {t.a, t.b, t.c}); }
  void operator()(const Sphere<double>& s) const {
    frames::ShapeHead h = head(GRAZE_ENGINE_SPHERE);
    h.radius = s.radius;
    append(out, h);
  }
  void operator()(const Capsule<double>& c) const { along_z(GRAZE_ENGINE_CAPSULE, c); }
  void operator()(const Cylinder<double>& c) const { along_z(GRAZE_ENGINE_CYLINDER, c); }
  void operator()(const Cone<double>& c) const { along_z(GRAZE_ENGINE_CONE, c); }
  void operator()(const Box<double>& b) const {
    frames::ShapeHead h = head(GRAZE_ENGINE_BOX);
    put(h.half_extents, b.half_extents);
    append(out, h);
  }
  void operator()(const Ellipsoid<double>& e) const {
    frames::ShapeHead h = head(GRAZE_ENGINE_ELLIPSOID);
    put(h.radii, e.radii);
    append(out, h);
  }
  void operator()(const Hull<double>& h) const {
    vertices(GRAZE_ENGINE_HULL, {h.vertices().begin(), h.vertices().end()});
  }
  void operator()(const Posed<double>& p) const {
    frames::ShapeHead h = head(GRAZE_ENGINE_POSED);
    put(h.position, p.position);
    put(h.orientation, p.orientation);
    parts(h, {p.shape});
  }
  void operator()(const Rounded<double>& r) const {
    frames::ShapeHead h = head(GRAZE_ENGINE_ROUNDED);
    h.radius = r.radius;
    parts(h, {r.shape});
  }
  void operator()(const Sum<double>& s) const { parts(head(GRAZE_ENGINE_SUM), s.shapes); }
  void operator()(const HullOf<double>& h) const { parts(head(GRAZE_ENGINE_HULL_OF), h.shapes); }

 private:
  // No rotation, like a line that omits it.
  static frames::ShapeHead head(graze_engine_shape_type type) {
    frames::ShapeHead h;
    h.type = type;
    h.orientation[0] = 1;
    return h;
  }
  void vertices(graze_engine_shape_type type, const std::vector<Vec3<double>>& all) const {
    frames::ShapeHead h = head(type);
    h.vertex_count = all.size();
    append(out, h);
    for (const Vec3<double>& x : all) out.append(reinterpret_cast<const char*>(x.data()), 3 * sizeof(double));
  }
  template <class Round>
  void along_z(graze_engine_shape_type type, const Round& shape) const {
    frames::ShapeHead h = head(type);
    h.radius = shape.radius;
    h.half_height = shape.half_height;
    append(out, h);
  }
  void parts(frames::ShapeHead h, const std::vector<SharedShape<double>>& all) const {
    h.part_count = all.size();
    append(out, h);
    for (const SharedShape<double>& part : all) write_shape(out, part->shape);
  }
};

void write_shape(std::string& out, const Shape<double>& shape) { std::visit(ShapeFrame{out}, shape); }

void write_body(std::string& out, const Body<double>& body, const corpus::Spin& spin, bool turns) {
  frames::BodyHead head;
  put(head.position, body.position);
  put(head.orientation, body.orientation);
  put(head.displacement, body.displacement);
  if (turns) {
    put(head.rotation, spin.rotation);
    put(head.pivot, spin.pivot);
  }
  append(out, head);
  write_shape(out, body.shape);
}

}  // namespace

std::string write_question_frame(const Offer& offer, const Terms& terms, std::uint64_t id, int repeat) {
  const Case& asked = terms.asked;
  const bool turns = offer.question == Question::rotating_cast, is_ray = offer.question == Question::ray;
  frames::QuestionHead head;
  head.id = id;
  head.query = static_cast<std::uint32_t>(offer.question);
  head.repeat = repeat;
  // As in a line, fields that a query does not use are omitted.
  head.t_max = is_cast(offer.question) ? asked.t_max : 1;
  if (offer.question == Question::cast || turns) {
    head.target_distance = asked.target_distance;
    head.pass_over = asked.start_policy == StartPolicy::pass_over ? 1 : 0;
  }
  if (is_ray) {
    put(head.origin, asked.b.position);
    put(head.direction, asked.b.displacement);
  }
  std::string out;
  append(out, head);
  write_body(out, asked.a, asked.spin_a, turns);
  // A ray has no body B.
  write_body(out, is_ray ? Body<double>{.shape = Point<double>{}} : asked.b,
             is_ray ? corpus::Spin{} : asked.spin_b, turns);
  head.size = out.size();
  std::memcpy(out.data(), &head, sizeof head);
  return out;
}

std::size_t answer_frame_size() { return sizeof(frames::AnswerFrame); }

}  // namespace graze::external
