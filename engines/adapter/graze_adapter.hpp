// graze::adapter connects an engine to graze's judge. It is one header that needs only the C++17 standard library.
//
//   questions in, answers out, one line of JSON each (docs/reference/protocol.md)
//
// An engine declares its properties, and answers one question at a time:
//
//   #include <graze_adapter.hpp>
//   using namespace graze::adapter;
//
//   Answer answer(const Question& q) {
//     const std::optional<double> time = my_cast(q.a, q.b, q.t_max);
//     return time ? Answer::hit(*time) : Answer::miss();
//   }
//   int main() {
//     Engine engine;
//     engine.name = "mine";
//     engine.shapes = {ShapeType::sphere, ShapeType::hull};
//     engine.queries[Query::cast].answers = {"time"};
//     return serve(engine, answer);
//   }
//
// To exclude preparation (such as building shapes) from the timing, return a callable that returns the answer:
//
//   engine.timed = true;
//   return serve(engine, [](const Question& q) { return [shape = my_shape(q.a.shape), …] { return …; }; });
//
// Frames: positions, displacements, normals and witnesses are in world axes. Shapes are in the frame of their body.
// Units: lengths are in the question's unit, angles in radians, times in the question's unit of t, `ns` in nanoseconds.
#ifndef GRAZE_ADAPTER_HPP
#define GRAZE_ADAPTER_HPP

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace graze::adapter {

// ---------------------------------------------------------------------------------------------------------------------
// What an engine reads and writes, as plain values.

using Vector = std::array<double, 3>;

struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;
};

enum class ShapeType {
  point,
  segment,
  triangle,
  sphere,
  capsule,
  cylinder,
  cone,
  box,
  ellipsoid,
  hull,
  posed,
  rounded,
  sum,
  hull_of
};

struct Shape {
  ShapeType type = ShapeType::point;
  double radius = 0;             // sphere, capsule, cylinder, cone, rounded
  double half_height = 0;        // capsule (of its core segment), cylinder and cone about the z axis
  Vector half_extents{};         // box
  Vector radii{};                // ellipsoid
  std::vector<Vector> vertices;  // hull, segment (a, b), triangle (a, b, c)
  std::vector<std::vector<std::size_t>> faces;  // hull, if it came with them: a hint
  Vector position{};                            // posed
  Quaternion orientation;                       // posed
  std::vector<Shape> parts;                     // one for posed and rounded, one or more for sum and hull_of
};

struct Body {
  Shape shape;
  Vector position{};       // the body's origin at t = 0
  Quaternion orientation;  // at t = 0
  Vector displacement{};   // over one unit of t
  Vector rotation{};       // rotation vector over one unit of t, for rotating_cast alone
  Vector pivot{};          // centre of the rotation in the body's own frame, for rotating_cast alone
};

enum class Query { cast, rotating_cast, ray, overlap, distance, penetration };

struct Question {
  std::string id;
  Query query = Query::cast;
  Body a, b;                     // ray: b is not there
  Vector origin{}, direction{};  // ray: origin + t direction
  double t_max = 1;              // casts and rays, may be infinite if the engine takes that
  double target_distance = 0;    // casts
  bool pass_over = false;        // casts: the start policy
  int repeat = 1;                // how often the call is made, to be timed
};

enum class Outcome { hit, initially_overlapping, miss, not_converged, unsupported };

// A number, or a bracket.
struct Bracket {
  double lower, upper;
  Bracket(double number) : lower(number), upper(number) {}  // NOLINT: a number is a bracket
  Bracket(double least, double most) : lower(least), upper(most) {}
};

struct Answer {
  Outcome outcome = Outcome::unsupported;
  std::optional<Bracket> time, distance, depth;
  std::optional<Vector> normal;            // unit, from A to B
  std::optional<Vector> point_a, point_b;  // witnesses
  std::optional<double> ns;  // the engine's own measure, else serve() measures a repeated question
  std::string message;

  static Answer of(Outcome outcome) {
    Answer answer;
    answer.outcome = outcome;
    return answer;
  }
  static Answer hit(Bracket time) {
    Answer answer = of(Outcome::hit);
    answer.time = time;
    return answer;
  }
  static Answer miss() { return of(Outcome::miss); }
  static Answer overlapping() { return of(Outcome::initially_overlapping); }
  static Answer unsupported(std::string why = {}) {
    Answer answer = of(Outcome::unsupported);
    answer.message = std::move(why);
    return answer;
  }
  static Answer not_converged(std::string why = {}) {
    Answer answer = of(Outcome::not_converged);
    answer.message = std::move(why);
    return answer;
  }
};

// The fields that an engine answers for one kind of question, and its promises. docs/reference/protocol.md describes
// each.
struct Promise {
  std::vector<std::string> answers;  // any of time, normal, witnesses, distance, depth
  std::optional<double> tolerance, relative_tolerance, kappa;
  std::string touching = "either";  // or contact, miss
  double early = 0;
  bool starts = true;
  double stalls = 0;
  bool target_distance = false;
  bool pass_over = false;
  std::string start_normal = "any";  // or least_penetration
  double own_frames = 0;
};

enum class Scalar { float32, float64 };

struct Engine {
  std::string name, version, about;
  Scalar scalar = Scalar::float64;
  std::vector<ShapeType> shapes;
  std::map<Query, Promise> queries;
  double margin = 0;
  std::optional<std::array<double, 2>> lengths;
  bool infinite_t_max = false;
  bool relative_motion = false;
  bool pivots = true;
  std::optional<double> most_turn, most_vertices, most_aspect;
  bool timed = false;  // takes questions with `repeat`
};

// ---------------------------------------------------------------------------------------------------------------------
// Names.

inline const std::vector<std::pair<ShapeType, std::string>>& shape_names() {
  static const std::vector<std::pair<ShapeType, std::string>> names{
      {ShapeType::point, "point"},   {ShapeType::segment, "segment"}, {ShapeType::triangle, "triangle"},
      {ShapeType::sphere, "sphere"}, {ShapeType::capsule, "capsule"}, {ShapeType::cylinder, "cylinder"},
      {ShapeType::cone, "cone"},     {ShapeType::box, "box"},         {ShapeType::ellipsoid, "ellipsoid"},
      {ShapeType::hull, "hull"},     {ShapeType::posed, "posed"},     {ShapeType::rounded, "rounded"},
      {ShapeType::sum, "sum"},       {ShapeType::hull_of, "hull_of"}};
  return names;
}
inline const std::vector<std::pair<Query, std::string>>& query_names() {
  static const std::vector<std::pair<Query, std::string>> names{
      {Query::cast, "cast"},         {Query::rotating_cast, "rotating_cast"},
      {Query::ray, "ray"},           {Query::overlap, "overlap"},
      {Query::distance, "distance"}, {Query::penetration, "penetration"}};
  return names;
}
inline const std::vector<std::pair<Outcome, std::string>>& outcome_names() {
  static const std::vector<std::pair<Outcome, std::string>> names{
      {Outcome::hit, "hit"},
      {Outcome::initially_overlapping, "initially_overlapping"},
      {Outcome::miss, "miss"},
      {Outcome::not_converged, "not_converged"},
      {Outcome::unsupported, "unsupported"}};
  return names;
}

template <class Enum>
std::string name_of(Enum value, const std::vector<std::pair<Enum, std::string>>& names) {
  for (const auto& [known, name] : names) {
    if (known == value) return name;
  }
  throw std::logic_error("a value without a name");
}
template <class Enum>
std::optional<Enum> value_of(std::string_view text, const std::vector<std::pair<Enum, std::string>>& names) {
  for (const auto& [known, name] : names) {
    if (name == text) return known;
  }
  return std::nullopt;
}

// A line that cannot be read. The text names the place and the correct form.
struct BadLine : std::runtime_error {
  using std::runtime_error::runtime_error;
};
// A well-formed value that this header does not know. The engine does not support the question.
struct Unknown : BadLine {
  using BadLine::BadLine;
};

// ---------------------------------------------------------------------------------------------------------------------
// Numbers are read as the nearest double of a decimal, and written as the shortest decimal that reads back to the same
// double. The locale has no effect.

namespace number {

// strtod, whatever the decimal point of the locale.
inline double by_strtod(std::string text) {
  const std::size_t point = text.find('.');
  if (point != std::string::npos) text.replace(point, 1, std::localeconv()->decimal_point);
  return std::strtod(text.c_str(), nullptr);
}

// Reads a decimal by JSON's grammar. Underflow gives the nearest double, overflow gives infinity.
inline double read(std::string_view text) {
#if defined(__cpp_lib_to_chars)
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size()) return value;
#endif
  return by_strtod(std::string(text));  // beyond the range of doubles, where from_chars gives no value
}

// Infinities and NaN are written as strings, since JSON has no such numbers.
inline void write(std::string& out, double value) {
  if (std::isnan(value)) {
    out += "\"nan\"";
  } else if (std::isinf(value)) {
    out += value < 0 ? "\"-inf\"" : "\"inf\"";
  } else {
    char text[64];
#if defined(__cpp_lib_to_chars)
    out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
#else
    for (int digits = 15; digits <= 17; ++digits) {
      std::snprintf(text, sizeof text, "%.*g", digits, value);
      if (std::strtod(text, nullptr) == value) break;
    }
    std::string decimal(text);
    const std::size_t point = decimal.find(std::localeconv()->decimal_point);
    if (point != std::string::npos)
      decimal.replace(point, std::string(std::localeconv()->decimal_point).size(), ".");
    out += decimal;
#endif
  }
}

}  // namespace number

// ---------------------------------------------------------------------------------------------------------------------
// JSON, read strictly: one value a text, no duplicate names, no comments, nesting up to kDeepest.

namespace json {

inline constexpr int kDeepest = 64;

struct Value {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  bool boolean = false;
  double number = 0;
  std::string string;
  std::vector<std::string> names;  // the names of an object's fields, in order
  std::vector<Value> values;       // the values of an array or an object

  [[nodiscard]] const Value* find(std::string_view name) const {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return &values[i];
    }
    return nullptr;
  }
};

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Value read_all() {
    Value value = read_value(0);
    skip_space();
    if (at_ != text_.size()) fail("more than one value");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw BadLine("column " + std::to_string(at_ + 1) + ": " + what);
  }
  void skip_space() {
    while (at_ < text_.size() &&
           (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r' || text_[at_] == '\n')) {
      ++at_;
    }
  }
  [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool take(char expected) {
    if (peek() != expected || at_ >= text_.size()) return false;
    ++at_;
    return true;
  }
  bool take(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  Value read_value(int depth) {
    if (depth > kDeepest) fail("nested too deep");
    skip_space();
    Value value;
    const char first = peek();
    if (first == '{') {
      read_object(value, depth);
    } else if (first == '[') {
      read_array(value, depth);
    } else if (first == '"') {
      value.kind = Value::Kind::string;
      value.string = read_string();
    } else if (take(std::string_view("true"))) {
      value.kind = Value::Kind::boolean;
      value.boolean = true;
    } else if (take(std::string_view("false"))) {
      value.kind = Value::Kind::boolean;
    } else if (!take(std::string_view("null"))) {
      value.kind = Value::Kind::number;
      value.number = read_number();
    }
    return value;
  }

  void read_object(Value& value, int depth) {
    value.kind = Value::Kind::object;
    ++at_;
    skip_space();
    if (take('}')) return;
    do {
      skip_space();
      if (peek() != '"') fail("a name in quotes is expected");
      std::string name = read_string();
      if (value.find(name) != nullptr) fail("the name \"" + name + "\" twice");
      skip_space();
      if (!take(':')) fail("a colon is expected");
      value.names.push_back(std::move(name));
      value.values.push_back(read_value(depth + 1));
      skip_space();
    } while (take(','));
    if (!take('}')) fail("a comma or } is expected");
  }

  void read_array(Value& value, int depth) {
    value.kind = Value::Kind::array;
    ++at_;
    skip_space();
    if (take(']')) return;
    do {
      value.values.push_back(read_value(depth + 1));
      skip_space();
    } while (take(','));
    if (!take(']')) fail("a comma or ] is expected");
  }

  unsigned read_hex4() {
    unsigned code = 0;
    for (int i = 0; i < 4; ++i) {
      const char c = peek();
      unsigned digit = 0;
      if (c >= '0' && c <= '9') {
        digit = static_cast<unsigned>(c - '0');
      } else if (c >= 'a' && c <= 'f') {
        digit = static_cast<unsigned>(c - 'a') + 10;
      } else if (c >= 'A' && c <= 'F') {
        digit = static_cast<unsigned>(c - 'A') + 10;
      } else {
        fail("four hexadecimal digits are expected");
      }
      code = 16 * code + digit;
      ++at_;
    }
    return code;
  }

  static void append_utf8(std::string& out, unsigned code) {
    const auto byte = [&out](unsigned bits) { out += static_cast<char>(static_cast<unsigned char>(bits)); };
    if (code < 0x80) {
      byte(code);
    } else if (code < 0x800) {
      byte(0xC0 | (code >> 6));
      byte(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
      byte(0xE0 | (code >> 12));
      byte(0x80 | ((code >> 6) & 0x3F));
      byte(0x80 | (code & 0x3F));
    } else {
      byte(0xF0 | (code >> 18));
      byte(0x80 | ((code >> 12) & 0x3F));
      byte(0x80 | ((code >> 6) & 0x3F));
      byte(0x80 | (code & 0x3F));
    }
  }

  void read_escape(std::string& out) {
    static constexpr std::string_view kLetters = "\"\\/bfnrt";
    static constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
    const char letter = peek();
    const std::size_t known = at_ < text_.size() ? kLetters.find(letter) : std::string_view::npos;
    if (known != std::string_view::npos) {
      ++at_;
      out += kMeanings[known];
      return;
    }
    if (!take('u')) fail("an unknown escape");
    unsigned code = read_hex4();
    if (code >= 0xD800 && code < 0xDC00) {  // the first half of a pair
      if (!take(std::string_view("\\u"))) fail("half a pair of surrogates");
      const unsigned second = read_hex4();
      if (second < 0xDC00 || second > 0xDFFF) fail("half a pair of surrogates");
      code = 0x10000 + ((code - 0xD800) << 10) + (second - 0xDC00);
    } else if (code >= 0xDC00 && code <= 0xDFFF) {
      fail("half a pair of surrogates");
    }
    append_utf8(out, code);
  }

  std::string read_string() {
    std::string out;
    ++at_;
    for (;;) {
      if (at_ >= text_.size()) fail("a string without its end");
      const char c = text_[at_];
      if (static_cast<unsigned char>(c) < 0x20) fail("a control character in a string");
      ++at_;
      if (c == '"') return out;
      if (c == '\\') {
        read_escape(out);
      } else {
        out += c;
      }
    }
  }

  std::size_t skip_digits() {
    const std::size_t from = at_;
    while (peek() >= '0' && peek() <= '9') ++at_;
    return at_ - from;
  }

  double read_number() {
    const std::size_t from = at_;
    take('-');
    if (!take('0') && skip_digits() == 0) {
      at_ = from;
      fail("a value is expected");
    }
    if (take('.') && skip_digits() == 0) fail("a digit after the point is expected");
    if (peek() == 'e' || peek() == 'E') {
      ++at_;
      if (!take('+')) take('-');
      if (skip_digits() == 0) fail("a digit of the exponent is expected");
    }
    const double value = number::read(text_.substr(from, at_ - from));
    if (std::isinf(value)) fail("a number beyond the largest double");
    return value;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

inline Value read(std::string_view text) { return Reader(text).read_all(); }

inline void write_string(std::string& out, std::string_view text) {
  static constexpr char kHex[] = "0123456789abcdef";
  out += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20) {
      out += "\\u00";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    } else {
      out += c;
    }
  }
  out += '"';
}

}  // namespace json

// ---------------------------------------------------------------------------------------------------------------------
// graze.question/1, read. Fields that this header does not know are left alone: they may come with a later version.

namespace question {

using json::Value;

inline const Value& member(const Value& object, const std::string& name, const std::string& where) {
  if (object.kind != Value::Kind::object) throw BadLine(where + ": an object is expected");
  const Value* value = object.find(name);
  if (value == nullptr) throw BadLine(where + "." + name + ": missing");
  return *value;
}
inline double number_of(const Value& value, const std::string& where) {
  if (value.kind == Value::Kind::string && value.string == "inf")
    return std::numeric_limits<double>::infinity();
  if (value.kind != Value::Kind::number) throw BadLine(where + ": a number is expected");
  return value.number;
}
template <std::size_t Size>
std::array<double, Size> numbers_of(const Value& value, const std::string& where) {
  if (value.kind != Value::Kind::array || value.values.size() != Size) {
    throw BadLine(where + ": an array of " + std::to_string(Size) + " numbers is expected");
  }
  std::array<double, Size> out{};
  for (std::size_t i = 0; i < Size; ++i) {
    if (value.values[i].kind != Value::Kind::number) throw BadLine(where + ": a number is expected");
    out[i] = value.values[i].number;
  }
  return out;
}
inline const std::string& text_of(const Value& value, const std::string& where) {
  if (value.kind != Value::Kind::string) throw BadLine(where + ": a string is expected");
  return value.string;
}
inline const std::vector<Value>& array_of(const Value& value, const std::string& where) {
  if (value.kind != Value::Kind::array || value.values.empty())
    throw BadLine(where + ": an array is expected, not empty");
  return value.values;
}
inline Vector vector_of(const Value& object, const std::string& name, const std::string& where) {
  return numbers_of<3>(member(object, name, where), where + "." + name);
}
inline Vector vector_or_zero(const Value& object, const std::string& name, const std::string& where) {
  const Value* value = object.find(name);
  return value == nullptr ? Vector{} : numbers_of<3>(*value, where + "." + name);
}
inline Quaternion quaternion_or_one(const Value& object, const std::string& name, const std::string& where) {
  const Value* value = object.find(name);
  if (value == nullptr) return {};
  const std::array<double, 4> q = numbers_of<4>(*value, where + "." + name);
  return {q[0], q[1], q[2], q[3]};
}

inline std::vector<std::vector<std::size_t>> faces_of(const Value& value, const std::string& where) {
  std::vector<std::vector<std::size_t>> faces;
  for (const Value& face : array_of(value, where)) {
    std::vector<std::size_t>& indices = faces.emplace_back();
    for (const Value& index : array_of(face, where)) {
      if (index.kind != Value::Kind::number || !(index.number >= 0 && index.number < 1e9)) {
        throw BadLine(where + ": an index is expected");
      }
      indices.push_back(static_cast<std::size_t>(index.number));
    }
  }
  return faces;
}

inline Shape shape_of(const Value& value, const std::string& where) {
  const std::string& type = text_of(member(value, "type", where), where + ".type");
  const std::optional<ShapeType> known = value_of(type, shape_names());
  if (!known) throw Unknown(where + ".type: the shape \"" + type + "\" is not known");
  Shape shape;
  shape.type = *known;
  const auto length = [&](const char* name) {
    return number_of(member(value, name, where), where + "." + name);
  };
  const auto vertex = [&](const char* name) { shape.vertices.push_back(vector_of(value, name, where)); };
  const auto parts = [&] {
    for (const Value& part : array_of(member(value, "shapes", where), where + ".shapes")) {
      shape.parts.push_back(shape_of(part, where + ".shapes[" + std::to_string(shape.parts.size()) + "]"));
    }
  };
  switch (shape.type) {
    case ShapeType::point:
      break;
    case ShapeType::triangle:
    case ShapeType::segment:
      vertex("a");
      vertex("b");
      if (shape.type == ShapeType::triangle) vertex("c");
      break;
    case ShapeType::sphere:
      shape.radius = length("radius");
      break;
    case ShapeType::capsule:
    case ShapeType::cylinder:
    case ShapeType::cone:
      shape.radius = length("radius");
      shape.half_height = length("half_height");
      break;
    case ShapeType::box:
      shape.half_extents = vector_of(value, "half_extents", where);
      break;
    case ShapeType::ellipsoid:
      shape.radii = vector_of(value, "radii", where);
      break;
    case ShapeType::hull:
      for (const Value& point : array_of(member(value, "vertices", where), where + ".vertices")) {
        shape.vertices.push_back(
            numbers_of<3>(point, where + ".vertices[" + std::to_string(shape.vertices.size()) + "]"));
      }
      if (const Value* faces = value.find("faces")) shape.faces = faces_of(*faces, where + ".faces");
      break;
    case ShapeType::posed:
      shape.position = vector_or_zero(value, "position", where);
      shape.orientation = quaternion_or_one(value, "orientation", where);
      shape.parts.push_back(shape_of(member(value, "shape", where), where + ".shape"));
      break;
    case ShapeType::rounded:
      shape.radius = length("radius");
      shape.parts.push_back(shape_of(member(value, "shape", where), where + ".shape"));
      break;
    case ShapeType::sum:
    case ShapeType::hull_of:
      parts();
      break;
  }
  return shape;
}

inline Body body_of(const Value& value, const std::string& where) {
  Body body;
  body.shape = shape_of(member(value, "shape", where), where + ".shape");
  body.position = vector_or_zero(value, "position", where);
  body.orientation = quaternion_or_one(value, "orientation", where);
  body.displacement = vector_or_zero(value, "displacement", where);
  body.rotation = vector_or_zero(value, "rotation", where);
  body.pivot = vector_or_zero(value, "pivot", where);
  return body;
}

}  // namespace question

// The id alone, if the line has one, so that a question with errors can still be answered.
inline std::optional<std::string> read_id(const json::Value& line) {
  const json::Value* id = line.find("id");
  if (id == nullptr || id->kind != json::Value::Kind::string) return std::nullopt;
  return id->string;
}

inline Question read_question(const json::Value& line) {
  using namespace question;
  if (text_of(member(line, "schema", "question"), "schema") != "graze.question/1") {
    throw BadLine("schema: \"graze.question/1\" is expected");
  }
  Question q;
  q.id = text_of(member(line, "id", "question"), "id");
  const std::string& query = text_of(member(line, "query", "question"), "query");
  const std::optional<Query> known = value_of(query, query_names());
  if (!known) throw Unknown("query: \"" + query + "\" is not known");
  q.query = *known;
  q.a = body_of(member(line, "a", "question"), "a");
  if (q.query == Query::ray) {
    q.origin = vector_of(line, "origin", "question");
    q.direction = vector_of(line, "direction", "question");
  } else {
    q.b = body_of(member(line, "b", "question"), "b");
  }
  if (q.query == Query::cast || q.query == Query::rotating_cast || q.query == Query::ray) {
    q.t_max = number_of(member(line, "t_max", "question"), "t_max");
  }
  if (const json::Value* target = line.find("target_distance")) {
    q.target_distance = number_of(*target, "target_distance");
  }
  if (const json::Value* policy = line.find("start_policy")) {
    const std::string& text = text_of(*policy, "start_policy");
    if (text != "report" && text != "pass_over") throw Unknown("start_policy: \"" + text + "\" is not known");
    q.pass_over = text == "pass_over";
  }
  if (const json::Value* repeat = line.find("repeat")) {
    const double times = number_of(*repeat, "repeat");
    if (!(times >= 1 && times <= 1e9)) throw BadLine("repeat: a count from 1 to 1e9 is expected");
    q.repeat = static_cast<int>(times);
  }
  return q;
}
inline Question read_question(std::string_view line) { return read_question(json::read(line)); }

// ---------------------------------------------------------------------------------------------------------------------
// graze.engine/1 and graze.answer/1, written: one line each, without its end.

class ObjectWriter {
 public:
  explicit ObjectWriter(std::string& out) : out_(out) { out_ += '{'; }
  ObjectWriter(const ObjectWriter&) = delete;
  ObjectWriter& operator=(const ObjectWriter&) = delete;
  ~ObjectWriter() { out_ += '}'; }

  std::string& name(std::string_view text) {
    if (!first_) out_ += ", ";
    first_ = false;
    json::write_string(out_, text);
    out_ += ": ";
    return out_;
  }
  void string(std::string_view field, std::string_view text) { json::write_string(name(field), text); }
  void number(std::string_view field, double value) { number::write(name(field), value); }
  void boolean(std::string_view field, bool value) { name(field) += value ? "true" : "false"; }
  void optional_number(std::string_view field, const std::optional<double>& value) {
    if (value) number(field, *value);
  }
  void bracket(std::string_view field, const std::optional<Bracket>& value) {
    if (!value) return;
    name(field);
    if (value->lower == value->upper || std::isnan(value->lower) || std::isnan(value->upper)) {
      number::write(out_, std::isnan(value->upper) ? value->upper : value->lower);
    } else {
      out_ += "{\"lower\": ";
      number::write(out_, value->lower);
      out_ += ", \"upper\": ";
      number::write(out_, value->upper);
      out_ += '}';
    }
  }
  template <std::size_t Size>
  void numbers(std::string_view field, const std::array<double, Size>& values) {
    name(field) += '[';
    for (std::size_t i = 0; i < Size; ++i) {
      if (i > 0) out_ += ", ";
      number::write(out_, values[i]);
    }
    out_ += ']';
  }
  void strings(std::string_view field, const std::vector<std::string>& values) {
    name(field) += '[';
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) out_ += ", ";
      json::write_string(out_, values[i]);
    }
    out_ += ']';
  }

 private:
  std::string& out_;
  bool first_ = true;
};

inline std::string write_engine(const Engine& engine) {
  std::string line;
  {
    ObjectWriter object(line);
    object.string("schema", "graze.engine/1");
    object.string("name", engine.name);
    if (!engine.version.empty()) object.string("version", engine.version);
    if (!engine.about.empty()) object.string("about", engine.about);
    object.string("scalar", engine.scalar == Scalar::float32 ? "float" : "double");
    std::vector<std::string> shapes;
    for (const ShapeType type : engine.shapes) shapes.push_back(name_of(type, shape_names()));
    object.strings("shapes", shapes);
    object.name("queries");
    {
      ObjectWriter queries(line);
      for (const auto& [query, promise] : engine.queries) {
        queries.name(name_of(query, query_names()));
        ObjectWriter row(line);
        row.strings("answers", promise.answers);
        row.optional_number("tolerance", promise.tolerance);
        row.optional_number("relative_tolerance", promise.relative_tolerance);
        row.optional_number("kappa", promise.kappa);
        if (promise.touching != "either") row.string("touching", promise.touching);
        if (promise.early != 0) row.number("early", promise.early);
        if (!promise.starts) row.boolean("starts", false);
        if (promise.stalls != 0) row.number("stalls", promise.stalls);
        if (promise.target_distance) row.boolean("target_distance", true);
        if (promise.pass_over) row.boolean("pass_over", true);
        if (promise.start_normal != "any") row.string("start_normal", promise.start_normal);
        if (promise.own_frames != 0) row.number("own_frames", promise.own_frames);
      }
    }
    if (engine.margin != 0) object.number("margin", engine.margin);
    if (engine.lengths) object.numbers("lengths", *engine.lengths);
    if (engine.infinite_t_max) object.boolean("infinite_t_max", true);
    if (engine.relative_motion) object.string("motion", "relative");
    if (!engine.pivots) object.boolean("pivots", false);
    object.optional_number("most_turn", engine.most_turn);
    object.optional_number("most_vertices", engine.most_vertices);
    object.optional_number("most_aspect", engine.most_aspect);
    if (engine.timed) object.boolean("timed", true);
  }
  return line;
}

inline std::string write_answer(const std::string& id, const Answer& answer) {
  std::string line;
  {
    ObjectWriter object(line);
    object.string("schema", "graze.answer/1");
    object.string("id", id);
    object.string("outcome", name_of(answer.outcome, outcome_names()));
    object.bracket("time", answer.time);
    object.bracket("distance", answer.distance);
    object.bracket("depth", answer.depth);
    if (answer.normal) object.numbers("normal", *answer.normal);
    if (answer.point_a) object.numbers("point_a", *answer.point_a);
    if (answer.point_b) object.numbers("point_b", *answer.point_b);
    if (answer.ns) {
      object.number("ns", *answer.ns);
      object.boolean("native", true);
    }
    if (!answer.message.empty()) object.string("message", answer.message);
  }
  return line;
}

// ---------------------------------------------------------------------------------------------------------------------
// The loop.

// Makes the requested number of calls and returns the time of one: the median over batches of calls, so that the
// clock's own time does not count.
template <class Call>
Answer call_repeatedly(Call&& call, int repeat) {
  static constexpr int kBatches = 15;
  if (repeat <= 1) return call();
  using Clock = std::chrono::steady_clock;
  const int batches = std::min(repeat, kBatches);
  std::vector<double> ns;
  Answer answer;
  int done = 0;
  for (int i = 1; i <= batches; ++i) {
    const int until = static_cast<int>(static_cast<std::int64_t>(repeat) * i / batches);
    const int calls = until - done;
    const Clock::time_point start = Clock::now();
    for (; done < until; ++done) answer = call();
    ns.push_back(std::chrono::duration<double, std::nano>(Clock::now() - start).count() / calls);
  }
  std::nth_element(ns.begin(), ns.begin() + batches / 2, ns.end());
  if (!answer.ns) answer.ns = ns[static_cast<std::size_t>(batches / 2)];
  return answer;
}

// `function` takes a question and gives an answer, or something to call which gives it.
template <class Function>
Answer ask(Function&& function, const Question& q) {
  if constexpr (std::is_convertible_v<std::invoke_result_t<Function, const Question&>, Answer>) {
    return call_repeatedly([&]() -> Answer { return function(q); }, q.repeat);
  } else {
    auto prepared = function(q);
    return call_repeatedly([&]() -> Answer { return prepared(); }, q.repeat);
  }
}

// One line in, one out. Throws BadLine for an invalid question.
template <class Function>
std::string answer_line(Function&& function, std::string_view line) {
  const json::Value read = json::read(line);
  try {
    const Question q = read_question(read);
    return write_answer(q.id, ask(function, q));
  } catch (const Unknown& unknown) {
    const std::optional<std::string> id = read_id(read);
    if (!id) throw;
    return write_answer(*id, Answer::unsupported(unknown.what()));
  }
}

// Declares the engine, and answers until the input ends. `put` writes one line and returns false if it could not.
// Returns the program's exit code: 2 if a line was not a question.
template <class Function, class Put>
int serve_lines(const std::string& says, Function&& function, std::istream& in, Put&& put) {
  if (!put(says)) return 2;
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty()) continue;
    std::string answer;
    try {
      answer = answer_line(function, line);
    } catch (const BadLine& bad) {
      std::fprintf(stderr, "%s\n", bad.what());
      return 2;
    }
    if (!put(answer)) return 2;
  }
  return 0;
}

template <class Function>
int serve(const Engine& engine, Function&& function, std::istream& in, std::ostream& out) {
  return serve_lines(write_engine(engine), function, in, [&out](const std::string& line) {
    out << line << '\n' << std::flush;
    return out.good();
  });
}

// Reserves standard output for the protocol. All other output of the program and its libraries then goes to standard
// error.
class Output {
 public:
  Output() {
#if defined(__unix__) || defined(__APPLE__)
    std::fflush(stdout);
    const int copy = ::dup(1);
    if (copy >= 0 && ::dup2(2, 1) >= 0) file_ = ::fdopen(copy, "w");
#endif
    if (file_ == nullptr) file_ = stdout;
  }
  bool operator()(const std::string& line) {
    std::fwrite(line.data(), 1, line.size(), file_);
    std::fputc('\n', file_);
    return std::fflush(file_) == 0 && std::ferror(file_) == 0;
  }
  bool bytes(const void* from, std::size_t size) {
    std::fwrite(from, 1, size, file_);
    return std::fflush(file_) == 0 && std::ferror(file_) == 0;
  }

 private:
  std::FILE* file_ = nullptr;
};

template <class Function>
int serve(const Engine& engine, Function&& function) {
  std::ios::sync_with_stdio(false);
  return serve_lines(write_engine(engine), function, std::cin, Output());
}

// ---------------------------------------------------------------------------------------------------------------------
// What most adapters need beside: vectors, and where a body is at time t.

inline Vector operator+(const Vector& x, const Vector& y) { return {x[0] + y[0], x[1] + y[1], x[2] + y[2]}; }
inline Vector operator-(const Vector& x, const Vector& y) { return {x[0] - y[0], x[1] - y[1], x[2] - y[2]}; }
inline Vector operator*(double s, const Vector& x) { return {s * x[0], s * x[1], s * x[2]}; }
inline Vector operator-(const Vector& x) { return {-x[0], -x[1], -x[2]}; }
inline double dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
inline Vector cross(const Vector& x, const Vector& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
inline double length(const Vector& x) { return std::sqrt(dot(x, x)); }
inline Vector normalized(const Vector& x) { return (1 / length(x)) * x; }

inline Quaternion operator*(const Quaternion& p, const Quaternion& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}
inline Quaternion normalized(const Quaternion& q) {
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / norm, q.x / norm, q.y / norm, q.z / norm};
}
// The rotation of a rotation vector, radians along its axis.
inline Quaternion rotation_of(const Vector& vector) {
  const double angle = length(vector);
  const double scale = angle > 0 ? std::sin(angle / 2) / angle : 0.5;
  return {std::cos(angle / 2), scale * vector[0], scale * vector[1], scale * vector[2]};
}
inline Vector rotate(const Quaternion& q, const Vector& x) {
  const Vector axis{q.x, q.y, q.z};
  const Vector twice = 2.0 * cross(axis, x);
  return x + q.w * twice + cross(axis, twice);
}

struct Pose {
  Vector position{};
  Quaternion orientation;
};
// The pivot moves at constant velocity, and the body rotates about it.
inline Pose pose_at(const Body& body, double t) {
  const Vector arm = rotate(body.orientation, body.pivot);
  const Quaternion turn = rotation_of(t * body.rotation);
  return {(body.position + arm) - rotate(turn, arm) + t * body.displacement, turn * body.orientation};
}

// The vertices of a polytope (point, segment, triangle, box, hull) in the body's frame. Empty for any other shape.
inline std::vector<Vector> vertices_of(const Shape& shape) {
  switch (shape.type) {
    case ShapeType::point:
      return {Vector{}};
    case ShapeType::segment:
    case ShapeType::triangle:
    case ShapeType::hull:
      return shape.vertices;
    case ShapeType::box: {
      std::vector<Vector> out;
      const Vector& h = shape.half_extents;
      for (const double x : {-h[0], h[0]}) {
        for (const double y : {-h[1], h[1]}) {
          for (const double z : {-h[2], h[2]}) out.push_back({x, y, z});
        }
      }
      return out;
    }
    default:
      return {};
  }
}

}  // namespace graze::adapter

#endif
