#include "corpus/shape_json.hpp"

#include <algorithm>
#include <cmath>

namespace graze::corpus {
namespace {

constexpr std::string_view kVertexForm = "each vertex is an array of three numbers";

Shape<double> read_point(const JsonValue& value, const std::string& path) {
  (void)Fields(value, path, {"type"});
  return Point<double>{};
}

Shape<double> read_sphere(const JsonValue& value, const std::string& path) {
  const Fields fields(value, path, {"type", "radius"});
  const JsonValue& radius = fields.required("radius", "a sphere has a radius, zero or more");
  return Sphere<double>{read_not_negative(radius, fields.path("radius"))};
}

Shape<double> read_box(const JsonValue& value, const std::string& path) {
  constexpr std::string_view kForm = "half_extents is an array of three numbers, zero or more";
  const Fields fields(value, path, {"type", "half_extents"});
  const std::string where = fields.path("half_extents");
  const Vec3<double> half = read_vec3(fields.required("half_extents", kForm), where, kForm);
  for (int i = 0; i < 3; ++i) {
    if (half[i] < 0) {
      throw Malformed{item_path(where, i), json_number(half[i]) + " is negative; " + std::string(kForm)};
    }
  }
  return Box<double>{half};
}

// A hint for engines that want faces. The set is the hull of the vertices whatever it says, so its form and
// its indices are checked, and then it is not kept.
void check_faces(const JsonValue& value, const std::string& path, std::size_t vertices) {
  constexpr std::string_view kForm = "faces is an array of arrays of three or more vertex indices";
  const std::vector<JsonValue>& faces = read_array(value, path, kForm);
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
    }
  }
}

Shape<double> read_hull(const JsonValue& value, const std::string& path) {
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
    check_faces(*faces, fields.path("faces"), vertices.size());
  }
  return Hull<double>(std::span<const Vec3<double>>(vertices));
}

struct ShapeReader {
  std::string_view type;
  Shape<double> (*read)(const JsonValue&, const std::string&);
};
constexpr ShapeReader kReaders[] = {
    {"point", read_point}, {"sphere", read_sphere}, {"box", read_box}, {"hull", read_hull}};
// In the schema, and not yet in graze::Shape.
constexpr std::string_view kLaterShapes[] = {"segment",   "triangle", "capsule", "cylinder", "cone",
                                             "ellipsoid", "rounded",  "sum",     "hull_of"};

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

// True for a field that must be written: any bit differs from the default's, so that -0 is kept.
bool is_set(const Quaternion<double>& q) {
  return q.w != 1 || !q.is_identity() || std::signbit(q.x) || std::signbit(q.y) || std::signbit(q.z);
}

struct ShapeWriter {
  std::string operator()(const Point<double>&) const { return R"({"type": "point"})"; }
  std::string operator()(const Sphere<double>& s) const {
    return R"({"type": "sphere", "radius": )" + json_number(s.radius) + "}";
  }
  std::string operator()(const Box<double>& b) const {
    return R"({"type": "box", "half_extents": )" + write_vec3(b.half_extents) + "}";
  }
  std::string operator()(const Hull<double>& h) const {
    std::string text = R"({"type": "hull", "vertices": [)";
    for (std::size_t k = 0; k < h.size(); ++k) text += (k > 0 ? ", " : "") + write_vec3(h.vertex(k));
    return text + "]}";
  }
};

}  // namespace

Shape<double> read_shape(const JsonValue& value, const std::string& path) {
  std::vector<std::string_view> types;
  for (const ShapeReader& reader : kReaders) types.push_back(reader.type);
  const std::string supported = joined(types);
  if (value.kind != JsonValue::Kind::object) {
    throw Malformed{path, describe(value) + "; a shape is an object with a type: " + supported};
  }
  const JsonValue* type = value.find("type");
  if (type == nullptr) throw Malformed{child_path(path, "type"), "missing; one of " + supported};
  const std::string name = read_string(*type, child_path(path, "type"));
  for (const ShapeReader& reader : kReaders) {
    if (name == reader.type) return reader.read(value, path);
  }
  const bool later =
      std::find(std::begin(kLaterShapes), std::end(kLaterShapes), name) != std::end(kLaterShapes);
  throw Malformed{child_path(path, "type"),
                  later ? "shape type " + json_quote(name) +
                              " is not supported yet by this version; supported: " + supported
                        : "unknown shape type " + json_quote_short(name) + "; one of " + supported};
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
  if (const Quaternion<double>& q = body.orientation; is_set(q)) {
    text += ", \"orientation\": [" + json_number(q.w) + ", " + json_number(q.x) + ", " + json_number(q.y) +
            ", " + json_number(q.z) + "]";
  }
  vector("displacement", body.displacement);
  vector("rotation", spin.rotation);
  vector("pivot", spin.pivot);
  return text + "}";
}

}  // namespace graze::corpus
