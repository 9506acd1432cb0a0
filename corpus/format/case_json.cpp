#include "corpus/format/case_json.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "corpus/format/names.hpp"
#include "corpus/format/shape_json.hpp"

namespace graze::corpus {
namespace {

constexpr std::string_view kNormalForm = "a normal is an array of three numbers";

// The second has measures of the path beside what the first has.
enum class Schema { first, second };
Schema read_schema(const JsonValue& value, const std::string& path) {
  const std::string schema = read_string(value, path);
  if (schema == kCaseSchema) return Schema::first;
  if (schema == kSecondCaseSchema) return Schema::second;
  throw Malformed{path, describe(value) + "; this version reads " + json_quote(kCaseSchema) + " and " +
                            json_quote(kSecondCaseSchema)};
}

// Ids appear in file names, command lines and reports: letters, digits and ._/- only.
std::string read_id(const JsonValue& value, const std::string& path) {
  std::string id = read_string(value, path);
  const bool plain = std::all_of(id.begin(), id.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == '_' || c == '/' || c == '-';
  });
  if (id.empty() || !plain) {
    throw Malformed{path, describe(value) + "; an id is made of letters, digits, '.', '_', '/' and '-'"};
  }
  return id;
}

// [-] digits [/ digits]
bool is_fraction(std::string_view s) {
  if (!s.empty() && s.front() == '-') s.remove_prefix(1);
  const auto digits = [](std::string_view part) {
    return !part.empty() &&
           std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  };
  const auto slash = s.find('/');
  if (slash == std::string_view::npos) return digits(s);
  const std::string_view below = s.substr(slash + 1);
  return digits(s.substr(0, slash)) && digits(below) &&
         below.find_first_not_of('0') != std::string_view::npos;
}

// A time of impact, or "inf" for none.
double read_time(const JsonValue& value, const std::string& path) {
  const double t = read_extended(value, path);
  if (t < 0) throw Malformed{path, json_number(t) + " is negative; zero or more, or \"inf\""};
  return t;
}

void read_toi(const JsonValue& value, const std::string& path, Expect& expect) {
  const Fields fields(value, path, {"lower", "upper", "exact"});
  expect.toi_lower = read_time(fields.required("lower", "the double below the time"), fields.path("lower"));
  expect.toi_upper = read_time(fields.required("upper", "the double above the time"), fields.path("upper"));
  if (*expect.toi_lower > *expect.toi_upper) {
    throw Malformed{path, "lower is above upper; lower <= time of impact <= upper"};
  }
  if (const JsonValue* exact = fields.optional("exact")) {
    expect.toi_exact = read_string(*exact, fields.path("exact"));
    if (!is_fraction(expect.toi_exact)) {
      throw Malformed{fields.path("exact"), describe(*exact) + "; a fraction such as \"3/8\", or an integer"};
    }
  }
}

// The measures of the path are fields of the second schema alone.
void read_measures(const Fields& fields, Schema schema, Expect& expect) {
  const auto length = [&](std::string_view key, std::optional<double>& target) {
    const JsonValue* value = fields.optional(key);
    if (value == nullptr) return;
    if (schema == Schema::first) {
      throw Malformed{fields.path(key), "a field of " + json_quote(kSecondCaseSchema) +
                                            "; the case says that it is a " + json_quote(kCaseSchema)};
    }
    target = read_not_negative(*value, fields.path(key));
  };
  length("clearance", expect.clearance);
  length("path_depth", expect.path_depth);
  length("scale", expect.scale);
}

Expect read_expect(const JsonValue& value, const std::string& path, Schema schema) {
  const Fields fields(value, path,
                      {"outcome", "by", "toi", "t_in", "t_out", "distance", "depth", "normal", "clearance",
                       "path_depth", "scale"});
  Expect expect;
  const std::string by = fields.path("by");
  expect.by = read_string(fields.required("by", "the oracle that gave the answer"), by);
  if (expect.by.empty() || expect.by == "core") {
    throw Malformed{by, json_quote(expect.by) + " is no oracle; the answer's source, never core"};
  }
  if (const JsonValue* outcome = fields.optional("outcome")) {
    expect.outcome = static_cast<Outcome>(read_choice(*outcome, fields.path("outcome"), kOutcomeNames));
  }
  if (const JsonValue* toi = fields.optional("toi")) read_toi(*toi, fields.path("toi"), expect);
  if (const JsonValue* t = fields.optional("t_in")) expect.t_in = read_extended(*t, fields.path("t_in"));
  if (const JsonValue* t = fields.optional("t_out")) expect.t_out = read_extended(*t, fields.path("t_out"));
  if (const JsonValue* d = fields.optional("distance")) {
    expect.distance = read_not_negative(*d, fields.path("distance"));
  }
  if (const JsonValue* d = fields.optional("depth"))
    expect.depth = read_not_negative(*d, fields.path("depth"));
  if (const JsonValue* n = fields.optional("normal")) {
    expect.normal = read_vec3(*n, fields.path("normal"), kNormalForm);
  }
  read_measures(fields, schema, expect);
  return expect;
}

void read_labels(const Fields& fields, Case& problem) {
  const auto text = [&](std::string_view key, std::string& target) {
    if (const JsonValue* v = fields.optional(key)) target = read_string(*v, fields.path(key));
  };
  problem.id =
      read_id(fields.required("id", "every case has an id, stable and never reused"), fields.path("id"));
  text("family", problem.family);
  if (const JsonValue* v = fields.optional("hardness"))
    problem.hardness = read_number(*v, fields.path("hardness"));
  text("comment", problem.comment);
  text("source", problem.source);
  if (const JsonValue* v = fields.optional("flags")) {
    const std::string path = fields.path("flags");
    for (const JsonValue& item : read_array(*v, path, "flags is an array of strings")) {
      const std::string where = item_path(path, problem.flags.size());
      std::string flag = read_string(item, where);
      if (std::find(problem.flags.begin(), problem.flags.end(), flag) != problem.flags.end()) {
        throw Malformed{where, json_quote_short(flag) + " appears twice; each flag once"};
      }
      problem.flags.push_back(std::move(flag));
    }
  }
}

void read_question(const Fields& fields, Case& problem) {
  if (const JsonValue* v = fields.optional("t_max")) {
    problem.t_max = read_extended(*v, fields.path("t_max"));
    if (problem.t_max < 0) {
      throw Malformed{fields.path("t_max"),
                      json_number(problem.t_max) + " is negative; zero or more, or \"inf\""};
    }
  }
  if (const JsonValue* v = fields.optional("target_distance")) {
    problem.target_distance = read_not_negative(*v, fields.path("target_distance"));
  }
  if (const JsonValue* v = fields.optional("start_policy")) {
    problem.start_policy =
        static_cast<StartPolicy>(read_choice(*v, fields.path("start_policy"), kStartPolicyNames));
  }
  if (const JsonValue* v = fields.optional("query")) {
    problem.query = static_cast<Query>(read_choice(*v, fields.path("query"), kQueryNames));
  }
  constexpr std::string_view kForm = "a direction is an array of three numbers, not all zero";
  const std::string path = fields.path("direction");
  if (problem.query == Query::penetration_along) {
    problem.direction = read_vec3(fields.required("direction", kForm), path, kForm);
    if (problem.direction == Vec3<double>::Zero()) throw Malformed{path, "zero; " + std::string(kForm)};
  } else if (fields.optional("direction") != nullptr) {
    throw Malformed{path, "given without the query \"penetration_along\"; only that query has a direction"};
  }
}

}  // namespace

Case case_from_json(const JsonValue& value, const std::string& path) {
  if (std::string held = held_by_another_schema(value, kCaseSchemas); !held.empty())
    throw Malformed{path, std::move(held)};
  const Fields fields(value, path,
                      {"schema", "id", "family", "hardness", "comment", "source", "flags", "a", "b", "t_max",
                       "target_distance", "start_policy", "query", "direction", "expect"});
  const Schema schema =
      read_schema(fields.required("schema", json_quote(kCaseSchema)), fields.path("schema"));
  Case problem;
  read_labels(fields, problem);
  MovingBody a = read_body(fields.required("a", "a case has two bodies, a and b"), fields.path("a"));
  MovingBody b = read_body(fields.required("b", "a case has two bodies, a and b"), fields.path("b"));
  problem.a = std::move(a.body);
  problem.b = std::move(b.body);
  problem.spin_a = a.spin;
  problem.spin_b = b.spin;
  read_question(fields, problem);
  if (const JsonValue* expect = fields.optional("expect")) {
    problem.expect = read_expect(*expect, fields.path("expect"), schema);
  }
  return problem;
}

std::vector<TextLine> split_lines(std::string_view text) {
  std::vector<TextLine> lines;
  for (int number = 1; !text.empty(); ++number) {
    const auto end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.find_first_not_of(" \t\r") != std::string_view::npos) lines.push_back({number, line});
  }
  return lines;
}

FileText read_whole_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return {"", "a directory; a .json or .jsonl file"};
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    const std::string why = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
    return {"", "cannot be opened" + why + "; a readable .json or .jsonl file"};
  }
  std::ostringstream content;
  content << stream.rdbuf();
  if (stream.bad()) return {"", "cannot be read to its end; a readable .json or .jsonl file"};
  return {std::move(content).str(), ""};
}

}  // namespace graze::corpus
