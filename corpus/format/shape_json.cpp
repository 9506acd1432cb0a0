#include "corpus/format/shape_json.hpp"

#include <cmath>
#include <graze/hull.hpp>

namespace graze::corpus {
namespace {

constexpr std::string_view kVertexForm = "each vertex is an array of three numbers";

Shape<double> read_nested(const JsonValue& value, const std::string& path, int depth);

Shape<double> read_point(const JsonValue& value, const std::string& path, int) {
  (void)Fields(value, path, {"type"});
  return Point<double>{};
}

Vec3<double> read_corner(const Fields& fields, std::string_view key) {
  constexpr std::string_view kForm = "each corner is an array of three numbers";
  return read_vec3(fields.required(key, kForm), fields.path(key), kForm);
}

Shape<double> read_segment(const JsonValue& value, const std::string& path, int) {
  const Fields fields(value, path, {"type", "a", "b"});
  return Segment<double>{read_corner(fields, "a"), read_corner(fields, "b")};
}

Shape<double> read_triangle(const JsonValue& value, const std::string& path, int) {
  const Fields fields(value, path, {"type", "a", "b", "c"});
  return Triangle<double>{read_corner(fields, "a"), read_corner(fields, "b"), read_corner(fields, "c")};
}

double read_length(const Fields& fields, std::string_view key) {
  return read_not_negative(fields.required(key, "a length, zero or more"), fields.path(key));
}

Shape<double> read_sphere(const JsonValue& value, const std::string& path, int) {
  const Fields fields(value, path, {"type", "radius"});
  const JsonValue& radius = fields.required("radius", "a sphere has a radius, zero or more");
  return Sphere<double>{read_not_negative(radius, fields.path("radius"))};
}

// A capsule, a cylinder or a cone, along z.
template <class Round>
Shape<double> read_round(const JsonValue& value, const std::string& path, int) {
  const Fields fields(value, path, {"type", "radius", "half_height"});
  return Round{read_length(fields, "radius"), read_length(fields, "half_height")};
}

Vec3<double> read_lengths(const Fields& fields, std::string_view key) {
  const std::string form = std::string(key) + " is an array of three numbers, zero or more";
  const std::string where = fields.path(key);
  Vec3<double> lengths = read_vec3(fields.required(key, form), where, form);
  for (int i = 0; i < 3; ++i) {
    if (lengths[i] < 0) {
      throw Malformed{item_path(where, static_cast<std::size_t>(i)),
                      json_number(lengths[i]) + " is negative; " + form};
    }
  }
  return lengths;
}

Shape<double> read_box(const JsonValue& value, const std::string& path, int) {
  const Fields fields(value, path, {"type", "half_extents"});
  return Box<double>{read_lengths(fields, "half_extents")};
}

Shape<double> read_ellipsoid(const JsonValue& value, const std::string& path, int) {
  const Fields fields(value, path, {"type", "radii"});
  return Ellipsoid<double>{read_lengths(fields, "radii")};
}

// A hint for engines that need faces. Its form and its indices are checked here, and with_faces checks
// whether it is true. The set is the hull of the vertices whatever the hint says. The writer omits faces.
std::vector<std::vector<std::uint32_t>> read_faces(const JsonValue& value, const std::string& path,
                                                   std::size_t vertices) {
  constexpr std::string_view kForm = "faces is an array of arrays of three or more vertex indices";
  const std::vector<JsonValue>& faces = read_array(value, path, kForm);
  std::vector<std::vector<std::uint32_t>> out(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::string where = item_path(path, f);
    const std::vector<JsonValue>& face = read_array(faces[f], where, kForm);
    if (face.size() < 3) throw Malformed{where, describe(faces[f]) + "; " + std::string(kForm)};
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t index = read_index(face[i], item_path(where, i));
      if (index >= vertices) {
        throw Malformed{item_path(where, i), "no vertex " + std::to_string(index) + "; the hull has " +
                                                 std::to_string(vertices) + ", numbered from 0"};
      }
      out[f].push_back(index);
    }
  }
  return out;
}

Shape<double> read_hull(const JsonValue& value, const std::string& path, int) {
  constexpr std::string_view kForm = "vertices is an array of one or more arrays of three numbers";
  const Fields fields(value, path, {"type", "vertices", "faces"});
  const std::string where = fields.path("vertices");
  const std::vector<JsonValue>& given = read_array(fields.required("vertices", kForm), where, kForm);
  if (given.empty()) throw Malformed{where, "an empty hull; " + std::string(kForm)};
  std::vector<Vec3<double>> vertices;
  vertices.reserve(given.size());
  for (std::size_t k = 0; k < given.size(); ++k) {
    vertices.push_back(read_vec3(given[k], item_path(where, k), kVertexForm));
  }
  if (const JsonValue* faces = fields.optional("faces")) {
    return with_faces<double>(vertices, read_faces(*faces, fields.path("faces"), vertices.size()));
  }
  return Hull<double>(std::span<const Vec3<double>>(vertices));
}

SharedShape<double> read_part(const Fields& fields, const std::string& right, int depth) {
  return share(read_nested(fields.required("shape", right), fields.path("shape"), depth + 1));
}

std::vector<SharedShape<double>> read_parts(const Fields& fields, int depth) {
  constexpr std::string_view kForm = "shapes is an array of one or more shapes";
  const std::string where = fields.path("shapes");
  const std::vector<JsonValue>& given = read_array(fields.required("shapes", kForm), where, kForm);
  if (given.empty()) throw Malformed{where, "an empty array; " + std::string(kForm)};
  std::vector<SharedShape<double>> parts;
  for (std::size_t i = 0; i < given.size(); ++i) {
    parts.push_back(share(read_nested(given[i], item_path(where, i), depth + 1)));
  }
  return parts;
}

Shape<double> read_posed(const JsonValue& value, const std::string& path, int depth) {
  const Fields fields(value, path, {"type", "shape", "position", "orientation"});
  Posed<double> posed{read_part(fields, "posed has the shape that it poses", depth)};
  if (const JsonValue* x = fields.optional("position")) {
    posed.position = read_vec3(*x, fields.path("position"), "a position is an array of three numbers");
  }
  if (const JsonValue* q = fields.optional("orientation")) {
    posed.orientation = read_orientation(*q, fields.path("orientation"));
  }
  return posed;
}

Shape<double> read_rounded(const JsonValue& value, const std::string& path, int depth) {
  const Fields fields(value, path, {"type", "shape", "radius"});
  return Rounded<double>{read_part(fields, "rounded has the shape that it rounds", depth),
                         read_length(fields, "radius")};
}

template <class Combinator>
Shape<double> read_combined(const JsonValue& value, const std::string& path, int depth) {
  const Fields fields(value, path, {"type", "shapes"});
  return Combinator{read_parts(fields, depth)};
}

struct ShapeReader {
  std::string_view type;
  Shape<double> (*read)(const JsonValue&, const std::string&, int depth);
};
constexpr ShapeReader kReaders[] = {{"point", read_point},
                                    {"segment", read_segment},
                                    {"triangle", read_triangle},
                                    {"sphere", read_sphere},
                                    {"capsule", read_round<Capsule<double>>},
                                    {"box", read_box},
                                    {"ellipsoid", read_ellipsoid},
                                    {"cylinder", read_round<Cylinder<double>>},
                                    {"cone", read_round<Cone<double>>},
                                    {"hull", read_hull},
                                    {"posed", read_posed},
                                    {"rounded", read_rounded},
                                    {"sum", read_combined<Sum<double>>},
                                    {"hull_of", read_combined<HullOf<double>>}};

Shape<double> read_nested(const JsonValue& value, const std::string& path, int depth) {
  std::vector<std::string_view> types;
  for (const ShapeReader& reader : kReaders) types.push_back(reader.type);
  if (value.kind != JsonValue::Kind::object) {
    throw Malformed{path, describe(value) + "; a shape is an object with a type: " + joined(types)};
  }
  if (depth > kMaxShapeDepth) {
    throw Malformed{path, "nested deeper than " + std::to_string(kMaxShapeDepth) +
                              " combinators; a shape that is less deep"};
  }
  const JsonValue* type = value.find("type");
  if (type == nullptr) throw Malformed{child_path(path, "type"), "missing; one of " + joined(types)};
  const std::string name = read_string(*type, child_path(path, "type"));
  for (const ShapeReader& reader : kReaders) {
    if (name == reader.type) return reader.read(value, path, depth);
  }
  throw Malformed{child_path(path, "type"),
                  "unknown shape type " + json_quote_short(name) + "; one of " + joined(types)};
}

// True for a field that must be written: any bit differs from the default's, so that -0 is kept.
bool is_turned(const Quaternion<double>& q) {
  return q.w != 1 || !q.is_identity() || std::signbit(q.x) || std::signbit(q.y) || std::signbit(q.z);
}

std::string write_orientation(const Quaternion<double>& q) {
  return "[" + json_number(q.w) + ", " + json_number(q.x) + ", " + json_number(q.y) + ", " +
         json_number(q.z) + "]";
}

// A part that is missing is written as null, which no reader takes.
std::string write_part(const SharedShape<double>& part) { return part ? write_shape(part->shape) : "null"; }

struct ShapeWriter {
  std::string operator()(const Point<double>&) const { return type("point") + "}"; }
  std::string operator()(const Segment<double>& s) const {
    return type("segment") + field("a", write_vec3(s.a)) + field("b", write_vec3(s.b)) + "}";
  }
  std::string operator()(const Triangle<double>& t) const {
    return type("triangle") + field("a", write_vec3(t.a)) + field("b", write_vec3(t.b)) +
           field("c", write_vec3(t.c)) + "}";
  }
  std::string operator()(const Sphere<double>& s) const {
    return type("sphere") + field("radius", json_number(s.radius)) + "}";
  }
  std::string operator()(const Capsule<double>& c) const { return round("capsule", c); }
  std::string operator()(const Box<double>& b) const {
    return type("box") + field("half_extents", write_vec3(b.half_extents)) + "}";
  }
  std::string operator()(const Ellipsoid<double>& e) const {
    return type("ellipsoid") + field("radii", write_vec3(e.radii)) + "}";
  }
  std::string operator()(const Cylinder<double>& c) const { return round("cylinder", c); }
  std::string operator()(const Cone<double>& c) const { return round("cone", c); }
  std::string operator()(const Hull<double>& h) const {
    std::string list;
    for (std::size_t k = 0; k < h.size(); ++k) list += (k > 0 ? ", " : "") + write_vec3(h.vertex(k));
    return type("hull") + field("vertices", "[" + list + "]") + "}";
  }
  std::string operator()(const Posed<double>& p) const {
    return type("posed") + field("shape", write_part(p.shape)) +
           (is_set(p.position) ? field("position", write_vec3(p.position)) : "") +
           (is_turned(p.orientation) ? field("orientation", write_orientation(p.orientation)) : "") + "}";
  }
  std::string operator()(const Rounded<double>& r) const {
    return type("rounded") + field("shape", write_part(r.shape)) + field("radius", json_number(r.radius)) +
           "}";
  }
  std::string operator()(const Sum<double>& s) const { return combined("sum", s.shapes); }
  std::string operator()(const HullOf<double>& h) const { return combined("hull_of", h.shapes); }

 private:
  static std::string type(const char* name) { return std::string("{\"type\": \"") + name + "\""; }
  static std::string field(const char* key, const std::string& value) {
    return std::string(", \"") + key + "\": " + value;
  }
  template <class Round>
  static std::string round(const char* name, const Round& shape) {
    return type(name) + field("radius", json_number(shape.radius)) +
           field("half_height", json_number(shape.half_height)) + "}";
  }
  static std::string combined(const char* name, const std::vector<SharedShape<double>>& parts) {
    std::string list;
    for (std::size_t i = 0; i < parts.size(); ++i) list += (i > 0 ? ", " : "") + write_part(parts[i]);
    return type(name) + field("shapes", "[" + list + "]") + "}";
  }
};

}  // namespace

Quaternion<double> read_orientation(const JsonValue& value, const std::string& path) {
  constexpr std::string_view kForm = "an orientation is an array of four numbers w, x, y, z, not all zero";
  if (value.kind != JsonValue::Kind::array || value.items.size() != 4) {
    throw Malformed{path, describe(value) + "; " + std::string(kForm)};
  }
  double q[4];
  for (std::size_t i = 0; i < 4; ++i) q[i] = read_number(value.items[i], item_path(path, i));
  if (q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0) {
    throw Malformed{path, "a zero quaternion; " + std::string(kForm)};
  }
  return {q[0], q[1], q[2], q[3]};
}

Shape<double> read_shape(const JsonValue& value, const std::string& path) {
  return read_nested(value, path, 0);
}

MovingBody read_body(const JsonValue& value, const std::string& path) {
  const Fields fields(value, path, {"shape", "position", "orientation", "displacement", "rotation", "pivot"});
  MovingBody result;
  result.body.shape = read_shape(fields.required("shape", "a body has a shape"), fields.path("shape"));
  const auto vector = [&](std::string_view key, Vec3<double>& target) {
    if (const JsonValue* v = fields.optional(key)) {
      target = read_vec3(*v, fields.path(key), "a " + std::string(key) + " is an array of three numbers");
    }
  };
  vector("position", result.body.position);
  if (const JsonValue* q = fields.optional("orientation")) {
    result.body.orientation = read_orientation(*q, fields.path("orientation"));
  }
  vector("displacement", result.body.displacement);
  vector("rotation", result.spin.rotation);
  vector("pivot", result.spin.pivot);
  return result;
}

bool is_set(const Vec3<double>& v) {
  return v != Vec3<double>::Zero() || std::signbit(v[0]) || std::signbit(v[1]) || std::signbit(v[2]);
}

std::string write_vec3(const Vec3<double>& v) {
  return "[" + json_number(v[0]) + ", " + json_number(v[1]) + ", " + json_number(v[2]) + "]";
}

std::string write_shape(const Shape<double>& shape) { return std::visit(ShapeWriter{}, shape); }

std::string write_body(const Body<double>& body, const Spin& spin) {
  std::string text = "{\"shape\": " + write_shape(body.shape);
  const auto vector = [&](const char* key, const Vec3<double>& v) {
    if (is_set(v)) text += std::string(", \"") + key + "\": " + write_vec3(v);
  };
  vector("position", body.position);
  if (const Quaternion<double>& q = body.orientation; is_turned(q)) {
    text += ", \"orientation\": " + write_orientation(q);
  }
  vector("displacement", body.displacement);
  vector("rotation", spin.rotation);
  vector("pivot", spin.pivot);
  return text + "}";
}

}  // namespace graze::corpus
