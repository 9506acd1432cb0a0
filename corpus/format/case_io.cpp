#include "corpus/format/case_io.hpp"

#include <algorithm>
#include <bit>
#include <span>

#include "corpus/format/case_json.hpp"
#include "corpus/format/names.hpp"
#include "corpus/format/shape_json.hpp"

namespace graze::corpus {
namespace {

void read_one(std::string_view text, const std::string& name, int line, Ids& ids, ReadResult& result) {
  const ParsedJson parsed = parse_json(text);
  if (parsed.error) {
    result.errors.push_back({name, line, parsed.error->path, parsed.error->what});
    return;
  }
  try {
    Case problem = case_from_json(parsed.value, "");
    const std::string place = line > 0 ? name + ":" + std::to_string(line) : name;
    if (const std::string first = ids.taken(problem.id, place); !first.empty()) {
      result.errors.push_back(
          {name, line, "id",
           json_quote(problem.id) + " was already read from " + first + "; every case has its own id"});
      return;
    }
    result.cases.push_back(std::move(problem));
  } catch (const Malformed& error) {
    result.errors.push_back({name, line, error.path, error.what});
  }
}

// A file of another format gives one line that says so, instead of an error for each line.
std::string held_by_its_first_line(std::string_view text) {
  const std::vector<TextLine> lines = split_lines(text);
  if (lines.empty()) return {};
  const ParsedJson parsed = parse_json(lines.front().text);
  return parsed.error ? std::string() : held_by_another_schema(parsed.value, kCaseSchemas);
}

// The fields of a case in the order of the schema. `starts_line` is for the pretty form.
struct Field {
  const char* key;
  std::string value;
  bool starts_line;
};

std::vector<Field> fields_of(const Case& problem) {
  std::vector<Field> fields;
  const auto add = [&](const char* key, std::string value, bool starts_line) {
    fields.push_back({key, std::move(value), starts_line});
  };
  // A case that fits the first schema is written in it.
  const bool is_second = problem.expect && problem.expect->has_measures();
  add("schema", json_quote(is_second ? kSecondCaseSchema : kCaseSchema), false);
  add("id", json_quote(problem.id), false);
  if (!problem.family.empty()) add("family", json_quote(problem.family), false);
  if (problem.hardness) add("hardness", json_number(*problem.hardness), false);
  if (!problem.comment.empty()) add("comment", json_quote(problem.comment), true);
  if (!problem.source.empty()) add("source", json_quote(problem.source), true);
  if (!problem.flags.empty()) {
    std::string flags = "[";
    for (const std::string& flag : problem.flags) flags += (flags.size() > 1 ? ", " : "") + json_quote(flag);
    add("flags", flags + "]", true);
  }
  add("a", write_body(problem.a, problem.spin_a), true);
  add("b", write_body(problem.b, problem.spin_b), true);
  bool starts_line = true;
  const auto question = [&](const char* key, std::string value) {
    add(key, std::move(value), starts_line);
    starts_line = false;
  };
  if (problem.t_max != 1) question("t_max", json_number(problem.t_max));
  if (std::bit_cast<std::uint64_t>(problem.target_distance) != 0) {
    question("target_distance", json_number(problem.target_distance));
  }
  if (problem.start_policy != StartPolicy::report)
    question("start_policy", json_quote(name_of(problem.start_policy)));
  if (problem.query != Query::cast) question("query", json_quote(name_of(problem.query)));
  if (problem.query == Query::penetration_along) question("direction", write_vec3(problem.direction));
  if (problem.expect) add("expect", write_expect(*problem.expect), true);
  return fields;
}

bool same(double l, double r) { return std::bit_cast<std::uint64_t>(l) == std::bit_cast<std::uint64_t>(r); }
bool same(const std::optional<double>& l, const std::optional<double>& r) {
  return l.has_value() == r.has_value() && (!l || same(*l, *r));
}
bool same(const Vec3<double>& l, const Vec3<double>& r) {
  return same(l[0], r[0]) && same(l[1], r[1]) && same(l[2], r[2]);
}
bool same(const Quaternion<double>& l, const Quaternion<double>& r) {
  return same(l.w, r.w) && same(l.x, r.x) && same(l.y, r.y) && same(l.z, r.z);
}

bool same(const Shape<double>& l, const Shape<double>& r);
bool same(const SharedShape<double>& l, const SharedShape<double>& r) {
  return l && r ? same(l->shape, r->shape) : l == r;
}

template <class T>
bool same(std::span<const T> l, std::span<const T> r) {
  return std::equal(l.begin(), l.end(), r.begin(), r.end(),
                    [](const T& one, const T& other) { return same(one, other); });
}
bool same(const std::vector<SharedShape<double>>& l, const std::vector<SharedShape<double>>& r) {
  return same(std::span(l), std::span(r));
}

struct SameShape {
  bool operator()(const Point<double>&, const Point<double>&) const { return true; }
  bool operator()(const Segment<double>& l, const Segment<double>& r) const {
    return same(l.a, r.a) && same(l.b, r.b);
  }
  bool operator()(const Triangle<double>& l, const Triangle<double>& r) const {
    return same(l.a, r.a) && same(l.b, r.b) && same(l.c, r.c);
  }
  bool operator()(const Sphere<double>& l, const Sphere<double>& r) const { return same(l.radius, r.radius); }
  bool operator()(const Box<double>& l, const Box<double>& r) const {
    return same(l.half_extents, r.half_extents);
  }
  bool operator()(const Ellipsoid<double>& l, const Ellipsoid<double>& r) const {
    return same(l.radii, r.radii);
  }
  bool operator()(const Hull<double>& l, const Hull<double>& r) const {
    return same(l.vertices(), r.vertices());
  }
  bool operator()(const Posed<double>& l, const Posed<double>& r) const {
    return same(l.shape, r.shape) && same(l.position, r.position) && same(l.orientation, r.orientation);
  }
  bool operator()(const Rounded<double>& l, const Rounded<double>& r) const {
    return same(l.shape, r.shape) && same(l.radius, r.radius);
  }
  // Capsule, cylinder, cone.
  template <class Round>
  requires requires(Round s) { s.half_height; }
  bool operator()(const Round& l, const Round& r) const {
    return same(l.radius, r.radius) && same(l.half_height, r.half_height);
  }
  // Sum, hull of several.
  template <class Combinator>
  requires requires(Combinator s) { s.shapes; }
  bool operator()(const Combinator& l, const Combinator& r) const { return same(l.shapes, r.shapes); }
  template <class L, class R>
  bool operator()(const L&, const R&) const {
    return false;
  }
};

bool same(const Shape<double>& l, const Shape<double>& r) { return std::visit(SameShape{}, l, r); }

bool same(const Body<double>& l, const Body<double>& r) {
  return same(l.shape, r.shape) && same(l.position, r.position) && same(l.orientation, r.orientation) &&
         same(l.displacement, r.displacement);
}
bool same(const Spin& l, const Spin& r) { return same(l.rotation, r.rotation) && same(l.pivot, r.pivot); }
bool same(const Expect& l, const Expect& r) {
  return l.by == r.by && l.outcome == r.outcome && same(l.toi_lower, r.toi_lower) &&
         same(l.toi_upper, r.toi_upper) && l.toi_exact == r.toi_exact && same(l.t_in, r.t_in) &&
         same(l.t_out, r.t_out) && same(l.distance, r.distance) && same(l.depth, r.depth) &&
         same(l.clearance, r.clearance) && same(l.path_depth, r.path_depth) && same(l.scale, r.scale) &&
         l.normal.has_value() == r.normal.has_value() && (!l.normal || same(*l.normal, *r.normal));
}

}  // namespace

std::string ReadError::text() const {
  std::string text = file;
  if (line > 0) text.append(":").append(std::to_string(line));
  text += ": ";
  if (!field.empty()) text += field + ": ";
  return text + what;
}

std::string Ids::taken(const std::string& id, const std::string& place) {
  const auto [first, inserted] = places_.emplace(id, place);
  return inserted ? "" : first->second;
}

ReadResult read_text(std::string_view text, const std::string& name, bool jsonl, Ids& ids) {
  ReadResult result;
  if (jsonl) {
    const std::string held = held_by_its_first_line(text);
    if (!held.empty()) return {{}, {{name, 0, "", held}}};
    for (const TextLine& line : split_lines(text)) read_one(line.text, name, line.number, ids, result);
  } else if (text.find_first_not_of(" \t\r\n") != std::string_view::npos) {
    read_one(text, name, 0, ids, result);
  }
  if (result.cases.empty() && result.errors.empty()) {
    result.errors.push_back({name, 0, "", "holds no case; one JSON object, or one a line in a .jsonl file"});
  }
  return result;
}

ReadResult read_file(const std::filesystem::path& path, Ids& ids) {
  FileText file = read_whole_file(path.string());
  if (!file.error.empty()) return {{}, {{path.string(), 0, "", std::move(file.error)}}};
  return read_text(file.text, path.string(), path.extension() == ".jsonl", ids);
}

ReadResult read_text(std::string_view text, const std::string& name, bool jsonl) {
  Ids ids;
  return read_text(text, name, jsonl, ids);
}

ReadResult read_file(const std::filesystem::path& path) {
  Ids ids;
  return read_file(path, ids);
}

ReadResult read_directory(const std::filesystem::path& directory) {
  Ids ids;
  return read_directory(directory, ids);
}

ReadResult read_directory(const std::filesystem::path& directory, Ids& ids) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator it(directory, error), end; !error && it != end;
       it.increment(error)) {
    const auto extension = it->path().extension();
    if (it->is_regular_file() && (extension == ".json" || extension == ".jsonl")) files.push_back(it->path());
  }
  ReadResult all;
  if (error) all.errors.push_back({directory.string(), 0, "", "cannot be read: " + error.message()});
  std::sort(files.begin(), files.end());
  for (const auto& path : files) {
    ReadResult one = read_file(path, ids);
    std::move(one.cases.begin(), one.cases.end(), std::back_inserter(all.cases));
    std::move(one.errors.begin(), one.errors.end(), std::back_inserter(all.errors));
  }
  if (all.cases.empty() && all.errors.empty()) {
    all.errors.push_back(
        {directory.string(), 0, "", "holds no case; .json or .jsonl files with one or more"});
  }
  return all;
}

std::string write_expect(const Expect& expect) {
  std::string text = "{";
  const auto field = [&](const char* key, const std::string& value) {
    text += (text.size() > 1 ? ", \"" : "\"") + std::string(key) + "\": " + value;
  };
  if (expect.outcome) field("outcome", json_quote(name_of(*expect.outcome)));
  field("by", json_quote(expect.by));
  if (expect.toi_lower && expect.toi_upper) {
    std::string toi =
        "{\"lower\": " + json_number(*expect.toi_lower) + ", \"upper\": " + json_number(*expect.toi_upper);
    if (!expect.toi_exact.empty()) toi += ", \"exact\": " + json_quote(expect.toi_exact);
    field("toi", toi + "}");
  }
  if (expect.t_in) field("t_in", json_number(*expect.t_in));
  if (expect.t_out) field("t_out", json_number(*expect.t_out));
  if (expect.distance) field("distance", json_number(*expect.distance));
  if (expect.depth) field("depth", json_number(*expect.depth));
  if (expect.normal) field("normal", write_vec3(*expect.normal));
  if (expect.clearance) field("clearance", json_number(*expect.clearance));
  if (expect.path_depth) field("path_depth", json_number(*expect.path_depth));
  if (expect.scale) field("scale", json_number(*expect.scale));
  return text + "}";
}

std::string write_case(const Case& problem) {
  std::string text;
  for (const Field& field : fields_of(problem)) {
    text += (text.empty() ? "{\"" : ", \"") + std::string(field.key) + "\": " + field.value;
  }
  return text + "}";
}

std::string write_case_pretty(const Case& problem) {
  std::string text;
  for (const Field& field : fields_of(problem)) {
    text += text.empty() ? "{\"" : field.starts_line ? ",\n \"" : ", \"";
    text += std::string(field.key) + "\": " + field.value;
  }
  return text + "}\n";
}

bool same_case(const Case& l, const Case& r) {
  return l.id == r.id && l.family == r.family && same(l.hardness, r.hardness) && l.comment == r.comment &&
         l.source == r.source && l.flags == r.flags && same(l.a, r.a) && same(l.b, r.b) &&
         same(l.spin_a, r.spin_a) && same(l.spin_b, r.spin_b) && same(l.t_max, r.t_max) &&
         same(l.target_distance, r.target_distance) && l.start_policy == r.start_policy &&
         l.query == r.query && same(l.direction, r.direction) &&
         l.expect.has_value() == r.expect.has_value() && (!l.expect || same(*l.expect, *r.expect));
}

}  // namespace graze::corpus
